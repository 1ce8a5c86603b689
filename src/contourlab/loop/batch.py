"""Many variants of one machine and controller at once: in lanes, over threads, judged while they run; and their figures."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import nullcontext, suppress
from dataclasses import dataclass
from functools import partial
from itertools import accumulate, pairwise
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Index, aligned
from contourlab.components.contract import Component
from contourlab.components.plant.plant import Plant
from contourlab.engine.gpu import gpu_of_process, lanes_of
from contourlab.engine.runner import ALONE, Group, groups_of, make_group, memory_rows
from contourlab.engine.step import Node, Step
from contourlab.engine.translate.outer import Reads
from contourlab.engine.translate.step_graph import graph_of
from contourlab.engine.translate.tick_loop import VECTOR
from contourlab.errors import ParameterError, refuse
from contourlab.feed import Reference
from contourlab.figures import number
from contourlab.geometry.view import PathView, check_view, view_of
from contourlab.loop.builder import Signals, with_arrays
from contourlab.loop.feeding import Feed, Learned
from contourlab.loop.judging import (
    CUT,
    JUDGE,
    PART,
    UNSURE,
    WATCH,
    DoubtfulSamples,
    effort_node,
    error_figures,
    judge_node,
    part_nodes,
    sums_of,
    wider,
)
from contourlab.loop.machine import Controller, Machine
from contourlab.loop.parameters import declared, matching, parameters_of
from contourlab.loop.simulate import check_kinds, jit_enabled, sampler
from contourlab.loop.template import Wiring, build
from contourlab.metrics.judge import stands_still
from contourlab.metrics.run_figures import EFFORT, FIGURES
from contourlab.metrics.run_figures import PART as OF_PART
from contourlab.notebook import Figure, Frame, curves, facts_line, facts_table, frame, grid, svg


@dataclass(frozen=True, eq=False, repr=False)
class BatchResult:
    """Figures of each variant, arrays (n_variant,).

    Attributes
    ----------
    figures : mapping of str to ndarray (n_variant,)
        ``contour_error_rms``, ``contour_error_mean``, ``contour_error_max`` and ``contour_error_signed_mean`` [m] (in space the last is the
        mean magnitude), ``contour_error_integral`` [m s], ``contour_error_max_time`` [s], ``tracking_error_rms`` and ``tracking_error_max``
        [m]. With `part`, ``part_error_max`` and ``part_error_rms`` [m]. With `effort`, ``command_energy`` [s], the integral of the squared
        accepted commands, and ``command_largest``, both relative to each drive's limit (in command units if it has none), and
        ``limited_share``, the share of time at which a drive did not accept the whole command. NaN for a variant that failed.
    failed_at : ndarray (n_variant,) of int
        Sample at which the variant left its following-error limit, or produced a non-finite command; the last one if its tool hardly left
        the start (`contourlab.metrics.judge.stands_still`); -1 for none of these.
    unsure : ndarray (n_variant,)
        Samples of a variant that failed whose foot point is in doubt; 0 for all others, whose figures are those of `judge`.
    signals : mapping of str to ndarray (n_sample, n, n_variant)
        The requested signals: views of `log`.
    log : ndarray (n_sample, n_row, n_lane) [SI]
        Memory of the signals, in the layout of the lanes.
    variants : mapping of str to ndarray (n_variant,)
        The parameters that differ [SI].
    units : mapping of str to str
        SI unit of each parameter and figure; "" for none.
    """

    figures: Mapping[str, Array]
    failed_at: Index
    unsure: Array
    signals: Mapping[str, Array]
    log: Array
    variants: Mapping[str, Array]
    units: Mapping[str, str]

    def to_pandas(self) -> Frame:
        """Return a row for each variant: the parameters that differ, the figures, and `failed_at`; all in SI. Printed, it shows `units`.

        >>> import contourlab as cl
        >>> case = cl.load_scenario("builtin:ghaffari/demo-stage").base
        >>> circle = cl.uniform(cl.contour("circle", radius=5e-3), 1.0, 1, case.machine.servo_period)
        >>> table = cl.simulate_batch(case.machine, case.controller, circle, {"axes.1.plant.gain": [1.0, 1.1]}).to_pandas()
        >>> table[["axes.1.plant.gain", "contour_error_max"]].shape
        (2, 2)
        """
        return frame({**self.variants, **self.figures, "failed_at": self.failed_at}, units=self.units)

    def plot(self, figure: str = "contour_error_max") -> Figure:
        """Draw a figure over the first parameter that differs; as points where others differ independently, or of one variant.

        Parameters
        ----------
        figure : str
            One of `figures`.

        Returns
        -------
        matplotlib.figure.Figure

        Raises
        ------
        ParameterError
            If there is no such figure.
        """
        refuse(figure not in self.figures, ParameterError, "figure", repr(figure), "one of " + ", ".join(self.figures))
        name, values = next(iter(self.variants.items()))
        order = np.argsort(values, kind="stable")
        factor, unit = self._shown(figure)
        labels = _labelled(name, self._shown(name)[1]), _labelled(figure.replace("_", " "), unit)
        picture = curves([(*labels, [("", values[order], factor * self.figures[figure][order])])])
        if len(values) == 1 or not all(np.array_equal(values, others) for others in self.variants.values()):
            picture.axes[0].lines[0].set(linestyle="", marker=".")
        return picture

    def _shown(self, name: str) -> tuple[float, str]:
        """Return factor and unit in which people read a figure; parameters are in SI."""
        return (FIGURES[name].factor, FIGURES[name].display) if name in self.figures else (1.0, self.units[name])

    def _facts(self) -> dict[str, object]:
        """Return how many variants there are, of which parameters, and how many failed."""
        return {"variants": len(self.failed_at), "parameters": ", ".join(self.variants), "failed": int((self.failed_at >= 0).sum())}

    def __repr__(self) -> str:
        return facts_line("BatchResult", {**self._facts(), "figures": ", ".join(self.figures)})

    def _repr_html_(self) -> str:
        rows = {}
        for name, values in {**self.variants, **self.figures}.items():
            factor, unit = self._shown(name)
            known = values[np.isfinite(values)] * factor
            spread = (known.min(), np.median(known), known.max()) if known.size else (np.nan,) * 3
            rows[_labelled(name, unit)] = [number(value, 4) for value in spread]
        picture = svg(self.plot()) if "contour_error_max" in self.figures else ""
        return facts_table(self._facts()) + grid(("", "smallest", "median", "largest"), rows) + picture


def _labelled(name: str, unit: str) -> str:
    return f"{name} [{unit}]" if unit else name


LANES = 32


def lanes_each(n: int, workers: int) -> int:
    """Return how many of n variants each worker takes, in whole groups of lanes."""
    return VECTOR * -(-n // (VECTOR * workers))


def simulate_batch(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    variants: Mapping[str, ArrayLike],
    *,
    keep: Sequence[str] = (),
    threads: int | None = None,
    judge: bool = True,
    part: bool = False,
    effort: bool = False,
    view: PathView | None = None,
    seed: int | Sequence[int] | Index = 0,
    jit: bool | None = None,
    progress: Callable[[int], None] | None = None,
    reuse: BatchResult | None = None,
    learned: Learned | None = None,
    moving: bool = False,
    gpu: bool = False,
) -> BatchResult:
    """Simulate variants that differ in parameters only, and judge each.

    Parameters
    ----------
    machine : Machine
    controller : Controller
    reference : Reference
        All three common to all variants.
    variants : mapping of str to array_like (n_variant,)
        Parameters that differ [SI], by dotted name (`contourlab.loop.parameter_names` lists them), or by the end of one; ``*`` stands for
        anything, as in ``axes.*.plant.mass``. All parameters that a text means get the same values. Empty if only the seeds differ.
    keep : sequence of str
        Signals to keep; none by default.
    threads : int, optional
        Threads over groups of 16 lanes; by default one for each processor.
    judge : bool
        Whether the contour error is computed.
    part : bool
        Whether the part error is computed too.
    effort : bool
        Whether to sum up the commands to the drives.
    view : PathView, optional
        View of the path for estimator and judge; see `contourlab.geometry.view.view_of`.
    seed : int or array_like of int (n_variant,)
        Of all noise: one seed, or one for each variant.
    jit : bool, optional
        Compiled, or plain Python.
    progress : callable, optional
        Called with the number of samples done; after a GPU from the beginning again, if the processor runs variants in doubt.
    reuse : BatchResult, optional
        An earlier result that is no longer needed: its `log` is overwritten if it fits, which saves allocating memory.
    learned : Learned, optional
        What earlier trials have learned, the same for all variants.
    moving : bool
        Whether the axes start with the velocity of the reference instead of at rest.
    gpu : bool
        Whether an NVIDIA GPU runs the variants.

    Returns
    -------
    BatchResult
        The numbers do not depend on threads or GPU, nor on the order or number of variants.

    Raises
    ------
    ParameterError
        If a name is unknown, a value out of range, the arrays differ in length, or the view is that of another path.
    EngineError
        If there is no GPU, or its memory is full.

    Notes
    -----
    The judge sees the axes' true positions; the machine's error map (lead error, squareness) is not in it.

    Lanes compute ``exp`` and its like by polynomials, to the last digits only. Encoder counts amplify the difference: the largest contour
    errors of `simulate` and of a variant may differ by 0.1 um.
    """
    check_kinds(machine, controller, reference)
    seeds = tuple(seed) if isinstance(seed, Iterable) else seed
    columns, n = checked_variants(machine, controller, variants, seeds)
    check_view(view, reference.path)
    view = view or view_of(reference.path)
    compiled = jit_enabled(jit)
    feed = Feed(machine, controller, reference, learned, sampler(compiled))
    loop = judged_loop(machine, controller, feed, columns, view, seeds, judge=judge, part=part, effort=effort, moving=moving)
    workers, device = threads or os.cpu_count() or 1, gpu_of_process() if gpu else None
    blended = part and blends(reference)
    judged = (JUDGE,) * judge + (PART,) * blended
    exactly = partial(DoubtfulSamples, positions=loop.signals["axis_position"], reference=reference)
    if device is not None:
        lanes = lanes_of(n, sum(memory_rows(loop.schedule)))
        groups = [make_group(loop.schedule, lanes, slice(i, i + lanes), compiled, device) for i in range(0, n, lanes)]
    else:
        groups = groups_of(loop.schedule, np.arange(n), compiled)
    doubts = [exactly(group) for group in groups] if judged and device is None else []
    for name in keep:
        refuse(name not in loop.signals, ParameterError, "keep", name, "one of " + ", ".join(loop.signals))
    rows = [loop.schedule.row(signal) for name in keep for signal in loop.signals[name]]
    width = sum(group.width for group in groups)
    width += -width % 8 if width > ALONE else 0  # vectors are stored in whole cache lines
    shape = (reference.n_sample, len(rows), width)
    log = reuse.log if reuse is not None and reuse.log.shape == shape else aligned(shape)
    failed = _advance_all(groups, feed, rows, log, 1 if gpu else workers, progress, doubts)[:n]
    sums = {name: sums_of(groups, name, n) for name in judged}
    if judge:
        failed = np.where((failed < 0) & stands_still(reference, np.sqrt(sums[JUDGE][-1])), reference.n_sample - 1, failed)
    unsure = sum((total[UNSURE] for total in sums.values()), np.zeros(n))
    left_over = np.concatenate([one.left_over for one in doubts]) if doubts else unsure > 0.0
    # A GPU keeps no doubtful samples: the processor runs these variants as it runs all others.
    for wide in (False, True) if gpu else (True,):
        chosen = np.flatnonzero(left_over & (unsure > 0.0) & (failed < 0))
        if not chosen.size:
            break
        again = groups_of(wider(loop.schedule, machine, reference) if wide else loop.schedule, chosen, compiled)
        doubts = [exactly(group, reach={name: sums[name][-1, group.lanes] for name in judged} if wide else None) for group in again]
        _advance_all(again, feed, [], aligned((len(again), 0, 0, 0)), workers, None if wide else progress, doubts)
        for name, total in sums.items():
            total[:, chosen] = sums_of(again, name, chosen.size)
        left_over[chosen] = np.concatenate([one.left_over for one in doubts])
        assert not (wide and left_over[chosen].any())  # samples that nobody judged must not become a figure
    unsure = np.where(failed < 0, 0.0, unsure)
    figures = error_figures(sums[JUDGE], failed, machine.servo_period) if judge else {}
    if part:
        figures |= error_figures(sums[PART if blended else JUDGE], failed, machine.servo_period, OF_PART)
    if effort:
        figures |= error_figures(sums_of(groups, "effort", n), failed, machine.servo_period, EFFORT)
    known = parameters_of(machine, controller)
    units = {name: declared(machine, name, *known[name]).unit for name in columns} | {name: FIGURES[name].unit for name in figures}
    return BatchResult(figures, failed, unsure, _split(log, n, keep, loop), log, columns, units)


def blends(reference: Reference) -> bool:
    """Return whether the part error differs from the contour error."""
    return reference.programmed is not reference.path


def judged_loop(
    machine: Machine,
    controller: Controller,
    feed: Feed,
    columns: Mapping[str, Any],
    view: PathView,
    seed: int | tuple[int, ...],
    *,
    judge: bool = True,
    part: bool = True,
    effort: bool = True,
    moving: bool = False,
) -> Wiring:
    """Return the schedule of a machine under its controller, with the nodes that judge it; arguments as in `simulate_batch`."""
    reference = feed.reference
    extra: tuple[Node | Callable[[Signals], Node], ...] = (judge_node(machine, reference, view),) if judge else ()
    if part and blends(reference):
        extra += part_nodes(machine, reference)
    if effort:
        extra += (lambda signals: effort_node(machine, reference, signals["command"], columns),)
    begin = feed.first(moving=moving)
    return build(machine, controller, reference.path, **begin, overrides=columns, view=view, extra=extra, seed=seed, fed=feed.names)


def _advance_all(
    groups: list[Group],
    feed: Feed,
    rows: list[int],
    log: Array,
    threads: int,
    progress: Callable[[int], None] | None,
    doubts: Sequence[DoubtfulSamples] = (),
) -> Index:
    """Run every group through the reference, block by block; return the sample at which each lane failed, or -1.

    The doubtful samples of each group are judged after every cut.
    """
    broken = [np.full(group.width, -1.0) for group in groups]
    lanes = [slice(*edges) for edges in pairwise(accumulate((group.width for group in groups), initial=0))]

    def advance(g: int, external: Array, arc_length: Array, k: int) -> None:
        here = log[k : k + len(external), :, lanes[g]] if rows else None
        if doubts:
            every = [*rows, *doubts[g].rows]
            seen = aligned((min(CUT, len(external)), len(every), groups[g].width))
            for first in range(0, len(external), CUT):
                cut = slice(first, first + CUT)
                part = groups[g].run(external[cut], every, seen[: len(external[cut])])
                if here is not None:
                    here[cut] = part[:, : len(rows)]
                doubts[g].take(part[:, len(rows) :], k + first, arc_length[cut])
        else:
            groups[g].run(external, rows, here)
        # The watch node checks positions and commands; this checks all other states.
        broken[g] = np.where((broken[g] < 0) & ~groups[g].finite(), k + len(external) - 1, broken[g])

    workers = min(threads, len(groups))
    with ThreadPoolExecutor(workers) if workers > 1 else nullcontext() as pool:
        for k, stop in feed.reference.blocks():
            asked, external = feed.block(k, stop)
            work = partial(advance, external=external, arc_length=asked.arc_length, k=k)
            for done, _ in enumerate((pool.map if pool is not None else map)(work, range(len(groups))), 1):
                if progress is not None:
                    progress(k + len(external) * done // len(groups))
    for one in doubts:
        one.end()
    seen = np.concatenate([group.state_of(WATCH)[0] for group in groups])
    return np.where(seen >= 0, seen, np.concatenate(broken)).astype(np.int64)


def checked_variants(
    machine: Machine, controller: Controller, variants: Mapping[str, ArrayLike], seeds: int | tuple[int, ...] = 0
) -> tuple[dict[str, Array], int]:
    """Return the columns of all parameters that differ, and the number of variants, as `simulate_batch` checks them first.

    Raises
    ------
    ParameterError
        If a name is unknown, a value or a combination of values out of range, or the arrays differ in length.
    """
    if not isinstance(variants, Mapping):
        raise ParameterError("variants", f"{variants!r:.60}", "a mapping from names of parameters to numbers")
    known = parameters_of(machine, controller)
    columns: dict[str, Array] = {}
    named = [(name, values) for wanted, values in variants.items() for name in matching(str(wanted), known, "variants")]
    for name, values in named:
        part, parameter = known[name]
        refuse(name in columns, ParameterError, "variants", name, "given once")
        try:
            columns[name] = np.atleast_1d(np.asarray(values)).astype(float, casting="same_kind")
            if columns[name].ndim != 1:
                raise ValueError
            # Minimum and maximum suffice, NaN is both; and what is not whole.
            broken = columns[name][columns[name] != np.rint(columns[name])] if part.parameters[parameter].whole else columns[name][:0]
            for value in (columns[name].min(), columns[name].max(), *broken[:1]) if columns[name].size else ():
                part.parameters[parameter].check(float(value))
        except ParameterError as error:
            error.add_note(f"In the variants of {name}.")
            raise
        except (TypeError, ValueError) as error:
            raise ParameterError("variants", f"{name} = {values!r:.60}", "numbers, one for each variant") from error
    lengths = {len(values) for values in columns.values()} | ({len(seeds)} if isinstance(seeds, tuple) else set())
    if len(lengths) != 1 or 0 in lengths:
        raise ParameterError("variants", f"arrays of lengths {sorted(lengths)}", "given, all of the same length, 1 or more, seeds too")
    check_together(known, columns)
    check_steps(known, columns, len(machine.axes))
    check_substeps(machine, columns)
    return columns, lengths.pop()


def check_together(known: Mapping[str, tuple[Component, str]], columns: Mapping[str, Array]) -> None:
    """Raise if a component refuses its combination of parameters in a variant."""
    heads = {name.rpartition(".")[0] for name in columns}
    for head in sorted(heads):
        of_part = {name: values for name, values in columns.items() if name.rpartition(".")[0] == head}
        part = known[next(iter(of_part))][0]
        if type(part).__init__ is Component.__init__ and type(part).check_values is Component.check_values:
            continue
        changed = {known[name][1]: values for name, values in of_part.items()}
        if _takes_arrays(part):
            with suppress(ParameterError, TypeError, ValueError):
                with_arrays(part, changed).check_values()
                continue
        for row in _rows(changed):
            try:
                part.replace(**row)
            except ParameterError as error:
                error.add_note(f"In the variants of {head}.")
                raise


def _takes_arrays(part: Component) -> bool:
    """Return whether the checks of a component take arrays of all variants: those of plug-ins may not."""
    return type(part).__module__.startswith("contourlab.") and type(part).__init__ is Component.__init__


def _rows(changed: Mapping[str, Array]) -> list[dict[str, float]]:
    """Return the different sets of values in some variants."""
    rows = sorted(set(zip(*(values.tolist() for values in changed.values()), strict=True)))
    return [dict(zip(changed, row, strict=True)) for row in rows]


def check_steps(known: Mapping[str, tuple[Component, str]], columns: Mapping[str, Array], n_axis: int) -> None:
    """Raise if a parameter that differs between variants changes the step itself, which all variants share."""
    for name, values in columns.items():
        part, parameter = known[name]
        others = [with_arrays(part, {parameter: float(value)}) for value in (values.min(), values.max())]
        steps = {one.make_step(n_axis) for one in (part, *others)}
        if len(steps) > 1 and len({_read_by(step) for step in steps}) > 1:
            raise ParameterError(name, "different in each variant", "the same in all: the step does not read it from par")


def _read_by(step: Step) -> str:
    reads = Reads(step.functions)
    graph_of(step, reads=reads)
    return repr(reads.words)


def check_substeps(machine: Machine, columns: Mapping[str, Array]) -> None:
    """Raise if a variant of a plant needs more sub-steps than its axis has."""
    for axis in machine.axes:
        head = f"axes.{axis.name}.plant."
        changed = {name.removeprefix(head): values for name, values in columns.items() if name.startswith(head)}
        if not changed or type(axis.plant).fewest_substeps is Plant.fewest_substeps:
            continue
        plant = machine.loaded_plant(axis.name)
        for values in (changed,) if _takes_arrays(plant) else _rows(changed):
            wanted, why = with_arrays(plant, values).fewest_substeps(machine.servo_period)
            if axis.substeps < wanted:
                bound = f"at least {wanted} for {why}, in one of the variants"
                raise ParameterError(f"axes.{axis.name}.substeps", f"{axis.substeps}", bound)


def _split(kept: Array, n: int, keep: Sequence[str], loop: Wiring) -> dict[str, Array]:
    edges = accumulate((len(loop.signals[name]) for name in keep), initial=0)
    return {name: kept[:, first:last, :n] for name, (first, last) in zip(keep, pairwise(edges), strict=True)}
