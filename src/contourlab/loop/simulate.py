"""One machine, one controller, one reference: the run that keeps its signals."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Container, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any, Literal

import numpy as np

from contourlab.arrays import BLOCK, Array
from contourlab.engine.runner import Group, make_group
from contourlab.engine.step import Late
from contourlab.errors import DivergenceError, ParameterError, refuse
from contourlab.feed import Reference, ReferenceBlock
from contourlab.geometry.view import PathView, check_view
from contourlab.loop.builder import check_seed, stream_of
from contourlab.loop.feeding import ALONG, DECIDED, PLANNED_TIME, RATE, Feed, Learned
from contourlab.loop.judging import all_finite, watched
from contourlab.loop.machine import Controller, Machine
from contourlab.loop.parameters import with_values
from contourlab.loop.progress import MOST_SLOWER, followed, most_samples, motion_node
from contourlab.loop.switches import Change, prepared, taken_over
from contourlab.loop.template import Wiring, build
from contourlab.primitives import normal
from contourlab.result import Result, Signal, Status

LONG_BLOCK = 1 << 20
"""Samples of a block where all signals stay in memory anyway: a run of one block is not copied."""


_OF_UNIT = {
    "m": (
        *("reference", "arc_length", "position", "axis_position", "tool_position", "motor_position", "modified_reference"),
        *("contour_error_estimate", "gap_estimate", "gap_deviation", "load_position_estimate"),
    ),
    "m/s": ("reference_velocity", "feedrate", "velocity", "axis_velocity", "motor_velocity", "load_velocity_estimate"),
    "m/s^2": ("reference_acceleration",),
    "command": ("command", "applied_command", "unfiltered_command", "coupling_command", "disturbance_estimate"),
    "N": ("shaft_force",),
    "s": ("planned_time",),
    "": ("gap_state", "active_controller", "switch_reason", "gap_state_estimate", "gap_confidence"),
}
UNITS = {name: unit for unit, names in _OF_UNIT.items() for name in names}
"""Unit of each signal; "command" is the unit of the plants' commands."""


def jit_enabled(jit: bool | None = None) -> bool:
    """Return whether steps are compiled: as given, or unless ``CONTOURLAB_JIT`` is 0."""
    refuse(jit is not None and not isinstance(jit, bool | np.bool_), ParameterError, "jit", repr(jit), "True, False or None")
    return os.environ.get("CONTOURLAB_JIT", "1") != "0" if jit is None else bool(jit)


def sampler(compiled: bool) -> Any:
    """Return the function that samples references for the engine; None for plain Python."""
    if not compiled:
        return None
    from contourlab.loop.sampling import sample_compiled  # brings the compiler with it

    return sample_compiled


def simulate(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    values: Mapping[str, float] | None = None,
    *,
    scheme: str = "base",
    seed: int = 0,
    on_failure: Literal["raise", "return"] = "raise",
    jit: bool | None = None,
    view: PathView | None = None,
    signals: Sequence[str] | None = None,
    progress: Callable[[int], None] | None = None,
    learned: Learned | None = None,
    trial: int = 0,
    moving: bool = False,
    changes: Sequence[Change] = (),
) -> Result:
    """Run a machine along a reference and return every signal.

    Parameters
    ----------
    machine : Machine
    controller : Controller
    reference : Reference
        Sampled at the machine's servo period.
    values : mapping of str to float, optional
        Parameters to set first [SI], by dotted name; see `contourlab.with_values`.
    scheme : str
        Name of the result.
    seed : int
        Of all noise; the same seed gives the same run.
    on_failure : {"raise", "return"}
        What to do when the loop runs away.
    jit : bool, optional
        Compiled, or plain Python; by default `jit_enabled`.
    view : PathView, optional
        View of the path for the estimator; see `contourlab.geometry.view.view_of`.
    signals : sequence of str, optional
        Which signals to keep; all by default.
    progress : callable, optional
        Called with the number of samples done.
    learned : Learned, optional
        What earlier trials have learned, sample by sample.
    trial : int
        Number of the trial: each has its own noise.
    moving : bool
        Whether the axes start with the velocity of the reference instead of at rest: a steady motion without run-in.
    changes : sequence of Change
        Controllers that take over during the run.

    Returns
    -------
    Result
        Signals of the samples up to the failure, if there was one. Where the coupling decides the progress, `motion` is what the run has
        followed, to judge it with, and ``planned_time`` [s] the time of the plan at each sample.

    Raises
    ------
    DivergenceError
        If a state is not finite, or a tracking error passes the axis' following-error limit, and `on_failure` is "raise".
    ParameterError
        If an argument is out of its range, or the view is that of another path.
    """
    check_kinds(machine, controller, reference)
    if values:
        machine, controller = with_values(machine, controller, values)
    refuse(on_failure not in ("raise", "return"), ParameterError, "on_failure", repr(on_failure), "'raise' or 'return'")
    parts, done = list[dict[str, Array]](), 0
    for block, status in simulate_blocks(  # noqa: B007  # the last one counts
        machine, controller, reference, seed=seed, jit=jit, view=view, signals=signals, block=LONG_BLOCK, learned=learned, trial=trial,
        moving=moving, changes=changes,
    ):  # fmt: skip
        parts.append(block)
        done += len(next(iter(block.values())))
        if progress is not None:
            progress(done)
    # Each signal is joined and freed in turn.
    kept = parts[0] if len(parts) == 1 else {name: np.concatenate([part.pop(name) for part in parts]) for name in list(parts[0])}
    if PLANNED_TIME in kept:
        reference = followed(reference, kept)
        kept = {name: data for name, data in kept.items() if signals is None or name in signals}
    result = replace(result_of(machine, reference, kept, status, scheme=scheme, seed=seed), made_by=(machine, controller))
    if not status.ok and on_failure == "raise":
        raise diverged(result)
    return result


def diverged(result: Result, also: Sequence[str] = ()) -> DivergenceError:
    """Return the error of a run that failed; `also` are further reasons."""
    status, scheme = result.status, "" if result.scheme == "base" else f"{result.scheme}: "
    reason = scheme + "; ".join((status.reason, *also))
    return DivergenceError(reason, sample=status.sample, time=status.sample * result.servo_period, axis=status.axis)


def check_kinds(machine: Machine, controller: Controller, reference: Reference) -> None:
    """Raise `ParameterError` if an argument is another thing, such as two in exchanged places."""
    for name, value, kind in (("machine", machine, Machine), ("controller", controller, Controller), ("reference", reference, Reference)):
        refuse(not isinstance(value, kind), ParameterError, name, f"a {type(value).__name__}", f"a {kind.__name__}")
    machine.check_modelled()


def result_of(
    machine: Machine,
    reference: Reference,
    signals: dict[str, Array],
    status: Status,
    *,
    scheme: str = "base",
    seed: int = 0,
    start: int = 0,
) -> Result:
    """Return the arrays of a run, or of a block that begins at sample `start`, as a labelled result."""
    commands = [axis.plant.command_unit for axis in machine.axes]
    units = {unit: unit for unit in _OF_UNIT} | {"command": commands[0] if len(set(commands)) == 1 else ", ".join(commands)}
    return Result(
        scheme=scheme,
        axes=machine.axis_names,
        servo_period=machine.servo_period,
        signals={name: Signal(data, ("sample", "axis")[: data.ndim], units[UNITS[name]]) for name, data in signals.items()},
        status=status,
        attributes={
            "machine": machine.name,
            "seed": seed,
            "reference_digest": reference.digest,
            **{f"command_limit_{axis.name}": float(getattr(axis.drive, "limit", math.inf)) for axis in machine.axes},
        },
        start=start,
        motion=reference,
    )


class ToolPosition:
    """Convert blocks of true axis positions, in order, to tool positions; the direction of motion is kept between blocks."""

    def __init__(self, machine: Machine, seed: int, trial: int = 0) -> None:
        check_seed(trial, "trial")
        self.machine = machine
        self._streams = [stream_of(seed, axis.name, "repeatability", *((trial,) if trial else ())) for axis in machine.axes]
        self._direction = np.zeros(len(machine.axes))
        self._reversals = np.zeros(len(machine.axes), dtype=int)
        names = machine.axis_names
        self._shear = [(names.index(a), names.index(b), angle) for (a, b), angle in machine.squareness.items() if angle]

    @property
    def exact(self) -> bool:
        """Whether the tool position equals the axis positions."""
        return not self._shear and not any(axis.error.position.size or axis.error.repeatability for axis in self.machine.axes)

    def of(self, position: Array, velocity: Array) -> Array:
        """Return tool positions (n_sample, n_axis) [m] from axis positions and velocities."""
        if self.exact:
            return position
        tool = position.copy()
        for j, axis in enumerate(self.machine.axes):
            if axis.error.position.size:
                tool[:, j] += np.interp(position[:, j], axis.error.position, axis.error.lead_error)
            if axis.error.repeatability:
                tool[:, j] += self._approach_offset(j, velocity[:, j], axis.error.repeatability / 4.0)
        for j, i, angle in self._shear:
            tool[:, j] += angle * position[:, i]
        return tool

    def _approach_offset(self, j: int, velocity: Array, deviation: float) -> Array:
        direction = np.sign(velocity)
        # At rest the last direction of motion holds.
        last = np.maximum.accumulate(np.where(direction != 0.0, np.arange(1, len(direction) + 1), 0))
        direction = np.where(last > 0, direction[np.maximum(last - 1, 0)], self._direction[j])
        before = np.concatenate([[self._direction[j]], direction[:-1]])
        count = self._reversals[j] + np.cumsum((direction != before) & (before != 0.0))
        self._direction[j], self._reversals[j] = direction[-1], count[-1]
        numbers, index = np.unique(count, return_inverse=True)
        drawn = np.array([normal(self._streams[j], float(n)) for n in numbers])
        return np.asarray(deviation * drawn[index])


def simulate_blocks(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    *,
    seed: int = 0,
    jit: bool | None = None,
    view: PathView | None = None,
    signals: Sequence[str] | None = None,
    block: int = BLOCK,
    learned: Learned | None = None,
    trial: int = 0,
    moving: bool = False,
    changes: Sequence[Change] = (),
    stop: int | None = None,
) -> Iterator[tuple[dict[str, Array], Status]]:
    """Run block by block, so that memory does not grow with the run; yield signals and the status so far.

    After a failure the last block ends with the failing sample; a block also ends where a controller takes over. Arguments as in
    `simulate`; `block` is the number of samples of a block, `stop` the number of samples to run, all by default.
    """
    check_view(view, reference.path)
    compiled = jit_enabled(jit)
    feed = Feed(machine, controller, reference, learned, sampler(compiled), deciding=True)
    given: dict[str, Any] = {"view": view, "seed": seed, "trial": trial, "fed": feed.names}
    if feed.decides:  # it ends long before the most samples
        given["motion"], block = motion_node(feed, Late(f"coupling.{RATE}")), min(block, BLOCK // 8)
    loop = build(machine, controller, reference.path, **feed.first(block, moving=moving), **given)
    group = make_group(loop.schedule, 1, slice(0, 1), compiled)
    due = prepared(changes, machine, controller, reference, given, compiled)
    tool = ToolPosition(machine, seed, trial)
    wanted = _wanted([loop, *(change.loop for change in due)], signals)
    most = most_samples(controller, reference)
    last = most if stop is None else min(stop, most)
    edges = sorted({*range(0, last, block), *(change.sample for change in due if change.sample < last), last})
    for start, end in pairwise(edges):
        if due and due[0].sample == start:
            loop, group = taken_over(due.pop(0), machine, reference, given, group, compiled)
        asked, fed = feed.block(start, end) if not feed.decides else (None, np.empty((end - start, 0)))
        saved = group.snapshot()
        recorded = _run(group, loop, asked, fed, wanted)
        status = watched(group, machine)
        if status.ok and not group.finite().all():
            status = first_non_finite(group, saved, fed, start)
        if feed.decides:
            recorded, status = _to_the_end(recorded, status, reference, start, most)
        if not status.ok:
            recorded = {name: data[: status.sample - start + 1] for name, data in recorded.items()}
        if "tool_position" in wanted:
            recorded["tool_position"] = tool.of(recorded["axis_position"], recorded["axis_velocity"])
        yield {name: data for name, data in recorded.items() if name in wanted}, status
        if not status.ok or (feed.decides and recorded[PLANNED_TIME][-1] >= planned_end(reference)):
            return


def planned_end(reference: Reference) -> float:
    """Return the planned time [s] of the last sample."""
    return (reference.n_sample - 1) * reference.servo_period


def _to_the_end(recorded: dict[str, Array], status: Status, reference: Reference, start: int, most: int) -> tuple[dict[str, Array], Status]:
    """Cut a block at the sample at which the whole motion is done; a run that does not get there has failed."""
    done = np.flatnonzero(recorded[PLANNED_TIME] >= planned_end(reference))
    if done.size and (status.ok or done[0] + start <= status.sample):
        return {name: data[: done[0] + 1] for name, data in recorded.items()}, Status(ok=True)
    n = start + len(recorded[PLANNED_TIME])
    if status.ok and n == most:
        share = 100.0 * float(recorded[PLANNED_TIME][-1]) / planned_end(reference)
        status = Status(ok=False, sample=n - 1, reason=f"{MOST_SLOWER} times the planned time, and {share:.3g} % of the motion is done")
    return recorded, status


_SINGLE = ("contour_error_estimate", *ALONG, PLANNED_TIME)
"""Signals with one number; all others have one for each axis."""
_SUPERVISED = ("active_controller", "switch_reason")
_GIVEN = {"reference": 0, "reference_velocity": 1, "reference_acceleration": 2, "arc_length": 3, "feedrate": 4}


def _wanted(loops: Sequence[Wiring], signals: Sequence[str] | None) -> frozenset[str]:
    """Return the signals to keep: those common to all controllers, and those of supervisors."""
    decided = set(DECIDED) if PLANNED_TIME in loops[0].signals else set()
    known = {*_GIVEN, "tool_position", *frozenset.intersection(*(frozenset(loop.signals) for loop in loops))}
    known |= {name for loop in loops for name in loop.signals if name in _SUPERVISED}
    refuse(signals is not None and not signals, ParameterError, "signals", "()", "at least one name, or None for all signals")
    for name in signals or ():
        refuse(name not in known, ParameterError, "signals", repr(name), "one of " + ", ".join(sorted(known)))
    return frozenset(signals if signals is not None else known) | decided


def _run(group: Group, loop: Wiring, asked: ReferenceBlock | None, fed: Array, wanted: frozenset[str]) -> dict[str, Array]:
    """Run one block; return the signals to keep, and those needed for the tool's position."""
    needed = wanted | {"axis_position", "axis_velocity"} if "tool_position" in wanted else wanted
    rows, places = logged(loop, needed)
    log = group.run(fed, rows)[:, :, 0]
    recorded: dict[str, Array] = {name: asked[field] for name, field in _GIVEN.items() if asked is not None and name in wanted}
    recorded |= {name: log[:, place] for name, place in places.items()}
    # Without a supervisor the only controller is active, number 0.
    n_axis = len(loop.signals["command"])
    return recorded | {name: np.zeros((len(log), n_axis)) for name in _SUPERVISED if name in wanted and name not in recorded}


def logged(loop: Wiring, wanted: Container[str]) -> tuple[list[int], dict[str, Any]]:
    """Return the rows to log for some signals of a result, and where in the log each of these signals is: an index of its columns."""
    # What several signals share (an ideal sensor's position is the axis') is logged once; evenly spaced columns are a view.
    names = dict.fromkeys(signal for name, signals in loop.signals.items() if name in wanted for signal in signals)
    column, places = {name: i for i, name in enumerate(names)}, dict[str, Any]()
    for name, signals in loop.signals.items():
        if name in wanted:
            columns = [column[signal] for signal in signals]
            step = columns[1] - columns[0] if len(columns) > 1 else 1
            even = columns == list(range(columns[0], columns[0] + step * len(columns), step)) if step > 0 else False
            several = slice(columns[0], columns[-1] + 1, step) if even else columns
            places[name] = columns[0] if name in _SINGLE else several
    return [loop.schedule.row(name) for name in names], places


def first_non_finite(group: Group, saved: Any, fed: Array, start: int) -> Status:
    """Run the block again tick by tick to find where a state stopped being finite."""
    group.restore(saved)
    for k, row in enumerate(fed):
        group.run(row[None, :], [])
        if not (status := all_finite(group, start + k)).ok:
            return status
    return Status(ok=True)
