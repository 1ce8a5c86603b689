"""The variants of a machine, one for every combination of axis modules, and J of a controller on each."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations, product

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Flags
from contourlab.errors import ParameterError, refuse
from contourlab.loop import Axis, Controller, Machine
from contourlab.loop.batch import checked_variants
from contourlab.loop.machine import AXIS_SLOTS
from contourlab.loop.parameters import parameters_of, with_values
from contourlab.metrics.run_figures import GOALS, goal_named
from contourlab.study import Runner, Setting, Space
from contourlab.study.executors import Workers
from contourlab.study.guards import Bounds, Guards
from contourlab.threads import in_threads

BROKEN = 1e6
"""Value of a design that breaks a guard or fails to run: above that of any design that keeps the guards."""


@dataclass(frozen=True)
class Variant:
    """A machine with some of its axes exchanged.

    Attributes
    ----------
    name : str
        Swapped axes and their modules, as ``"1 = axis2"``.
    machine : Machine
    modules : tuple of (str, str)
        Each swapped axis and its module.
    """

    name: str
    machine: Machine
    modules: tuple[tuple[str, str], ...] = ()

    def module(self, name: str) -> str:
        """Return the module of a parameter, by its dotted name; empty if its axis is not swapped."""
        return next((module for axis, module in self.modules if name.startswith(f"controller.axes.{axis}.")), "")


def losses(values: ArrayLike, best: ArrayLike, floor: float) -> Array:
    """Return the loss of each variant, (J - J*) / max(J*, J_tol).

    Parameters
    ----------
    values, best : array_like (..., n_variant)
        J under a shared design, and J*.
    floor : float, > 0
        J_tol: a smaller J* is no meaningful denominator.

    >>> losses([3.0, 12.0], [1.0, 10.0], 2.0).tolist()
    [1.0, 0.2]
    """
    known = np.asarray(best, dtype=float)
    return np.asarray((np.asarray(values, dtype=float) - known) / np.maximum(known, floor))


@dataclass(eq=False)
class Variants:
    """All variants under candidates of one controller, run in lanes; keeps the best design found for each variant.

    Attributes
    ----------
    members : tuple of Variant
    setting : Setting
        Of the first variant.
    space : Space
        Parameters of the controller to search. Values are rounded as in a file before a run, so that the file holds the judged values.
    objective : str
        One of `contourlab.metrics.run_figures.GOALS`.
    floor : float [SI]
        J_tol.
    bounds : Bounds
    threads, gpu
        See `contourlab.study.Runner`.
    progress : callable, optional
        Called with the number of candidates tried so far, including those that are not run because they break a margin.
    best : ndarray (n_variant,)
        J* so far; infinite until a design keeps the guards.
    best_points : ndarray (n_variant, n_parameter)
    """

    members: tuple[Variant, ...]
    setting: Setting
    space: Space
    objective: str = "contour_error_integral"
    floor: float = 2e-6
    bounds: Bounds = field(default_factory=Bounds)
    threads: int | None = None
    gpu: bool = False
    progress: Callable[[int], None] = lambda tried: None
    best: Array = field(init=False)
    best_points: Array = field(init=False)
    tried: int = field(init=False, default=0)
    _asked: dict[bytes, Array] = field(init=False, repr=False, default_factory=dict)
    _lock: threading.Lock = field(init=False, repr=False, default_factory=threading.Lock)

    def __post_init__(self) -> None:
        if not self.floor > 0.0:
            raise ParameterError("floor", f"{self.floor:g}", "> 0", goal_named(self.objective, "objective").unit)
        outside = [name for name in self.space.names if not name.startswith("controller.")]
        if outside:
            raise ParameterError("parameters", outside[0], "a parameter of the controller: those of the machine differ between variants")
        self.space = replace(self.space, written=True)
        figures = (self.objective, "limited_share")
        self.runners = tuple(Runner(replace(self.setting, machine=v.machine), figures, self.threads, self.gpu) for v in self)
        self.guards = tuple(Guards(v.machine, self.setting.controller, self.bounds) for v in self)
        self.numbers = numbers_of([v.machine for v in self], self.setting.controller)
        self.best = np.full(len(self), np.inf)
        self.best_points = self.everywhere(self.space.start)

    def __iter__(self) -> Iterator[Variant]:
        return iter(self.members)

    def __len__(self) -> int:
        return len(self.members)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the variants."""
        return tuple(variant.name for variant in self)

    @property
    def runs(self) -> int:
        """Runs so far."""
        return sum(runner.runs for runner in self.runners)

    def run_in(self, pool: Workers | None) -> None:
        """Run in the workers of a pool from now on; in threads of this process if there is none."""
        for runner in self.runners:
            runner.pool = pool
        self.threads = self.threads if pool is None else pool.count

    @property
    def unit(self) -> str:
        """The display unit of the objective."""
        return GOALS[self.objective].display

    def losses(self, values: Array) -> Array:
        """Return the loss of each variant against the present J*."""
        return losses(values, self.best, self.floor)

    def everywhere(self, point: Array) -> Array:
        """Return a point for each variant (n_variant, n_parameter)."""
        return np.tile(point, (len(self), 1))

    def short(self, names: Collection[str]) -> list[str]:
        """Return the short names of parameters, in the order of the space."""
        return [number.short for number in self.space.numbers if number.name in names]

    def kept(self, points: Array) -> Array:
        """Return J as `values` does; infinite where a guard is broken. Points that were asked before do not run again."""
        rows = np.moveaxis(points, 1, 0).reshape(points.shape[1], -1)
        keys = [row.tobytes() for row in rows]
        new = [at for at, key in enumerate(keys) if key not in self._asked and key not in keys[:at]]
        if new:
            values, broken = self.values(points[:, new])
            self._asked |= zip((keys[at] for at in new), np.where(broken > 0.0, np.inf, values).T, strict=True)
        return np.array([self._asked[key] for key in keys]).T

    def controller_at(self, point: Array, local: Iterable[str] = ()) -> Controller:
        """Return the controller of a point; `local` are the parameters, by dotted name, that move with their axis."""
        _, controller = with_values(self.setting.machine, self.setting.controller, self.space.values(point))
        axes = {}
        for name, axis in controller.axes.items():
            head = f"controller.axes.{name}."
            axes[name] = replace(axis, local=tuple(dotted.removeprefix(head) for dotted in sorted(local) if dotted.startswith(head)))
        return replace(controller, axes=axes)

    def values(self, points: Array, only: Sequence[int] | None = None, *, whole: bool = False) -> tuple[Array, Array]:
        """Return J of points on each variant, and how far they break the guards (0 if they keep them).

        Parameters
        ----------
        points : ndarray (n_variant, n, n_parameter)
            Points of the variants in `only`, or of all.
        only : sequence of int, optional
            Indices of variants.
        whole : bool
            Whether to run also points that break a margin.

        Returns
        -------
        values, broken : ndarray (n_variant, n)
            J is infinite if the run failed or was skipped.
        """
        which = range(len(self)) if only is None else only
        known: dict[tuple[object, ...], Array] = {}
        first = self.space.columns(points[0])
        columns = [first if np.array_equal(rows, points[0]) else self.space.columns(rows) for rows in points]
        excess = [self.guards[i].excess(column, known) for column, i in zip(columns, which, strict=True)]
        run = [np.full(len(over), True) if whole else over < 0.0 for over in excess]
        chosen = [{name: values[r] for name, values in column.items()} for column, r in zip(columns, run, strict=True)]
        judged = [self._judged(*args) for args in zip(which, points, excess, run, self._figures(which, chosen), strict=True)]
        with self._lock:
            self.tried += sum(map(len, points))
        self.progress(self.tried)
        return np.array([values for values, _ in judged]), np.array([broken for _, broken in judged])

    def _figures(self, which: Sequence[int], columns: Sequence[dict[str, Array]]) -> list[dict[str, Array]]:
        """Return the figures of runs on each variant: as one batch if only numbers differ, else the variants in parallel."""
        threads, sizes = self.threads or os.cpu_count() or 1, [next(iter(column.values())).size for column in columns]
        if self.numbers:
            every = {name: np.concatenate([column[name] for column in columns]) for name in columns[0]}
            every |= {name: np.repeat([self.numbers[i][name] for i in which], sizes) for name in self.numbers[0]}
            figures = self.runners[which[0]](every, threads=threads) if sum(sizes) else {}  # each search of one variant has its own
            parts = {name: np.split(values, np.cumsum(sizes)[:-1]) for name, values in figures.items()}
            return [{name: part[at] for name, part in parts.items()} for at in range(len(which))]
        sides = min(threads, len(which))  # one variant has too few lanes for all processors

        def run(at: int, own: int) -> dict[str, Array]:
            return self.runners[which[at]](columns[at], threads=own) if sizes[at] else {}

        # The first runs of a machine compile its components, one after another.
        if sides < 2 or any(self.runners[i].runs == 0 for i in which):
            return [run(at, threads) for at in range(len(which))]
        return in_threads(lambda at: run(at, -(-threads // sides)), range(len(which)), sides)

    def _judged(self, i: int, points: Array, excess: Array, run: Flags, figures: dict[str, Array]) -> tuple[Array, Array]:
        """Return J of the points of a variant and how far they break the guards; keep the best."""
        values, limited = np.full(len(points), np.inf), np.zeros(len(points))
        if figures:
            values[run] = np.where(np.isfinite(figures[self.objective]), figures[self.objective], np.inf)
            limited[run] = np.nan_to_num(figures["limited_share"] - self.bounds.limited, nan=1.0)
        good = (excess < 0.0) & (limited <= 0.0) & np.isfinite(values)
        at = int(np.argmin(np.where(good, values, np.inf)))
        if good[at] and values[at] < self.best[i]:
            self.best[i], self.best_points[i] = values[at], points[at]
        # A failed run is worse than a broken margin, which is worse than a drive at its limit.
        failed = 10.0 * (run & ~np.isfinite(values))
        return values, np.where(good, 0.0, np.clip(excess, 0.0, 10.0) + np.maximum(limited, 0.0) + failed + 1e-9)

    def state(self) -> dict[str, Array]:
        """Return the state that searches change."""
        counts = np.array([self.tried, *(runner.runs for runner in self.runners)])
        asked = np.frombuffer(b"".join(self._asked)).reshape(-1, self.best_points.size)
        answers = np.array([*self._asked.values()]).reshape(-1, len(self))
        return {"best": self.best.copy(), "best_points": self.best_points.copy(), "counts": counts, "asked": asked, "answers": answers}

    def restore(self, state: Mapping[str, Array]) -> None:
        """Restore a state."""
        self.best, self.best_points = state["best"], state["best_points"]
        self._asked = {row.tobytes(): answer for row, answer in zip(state["asked"], state["answers"], strict=True)}
        self.tried, *runs = state["counts"].tolist()
        for runner, count in zip(self.runners, runs, strict=True):
            runner.runs = count

    def in_si(self, reached: Array) -> Array:
        """Return J of values of `objective_of`; infinite where a guard is broken."""
        return np.where(reached < BROKEN, reached * self.floor, np.inf)

    def objective_of(self, i: int) -> Callable[[Array], Array]:
        """Return the function to minimise for J* of variant `i`: J over J_tol of points (n, n_parameter)."""

        def objective(points: Array) -> Array:
            values, broken = self.values(points[None], (i,))
            return np.asarray(np.where(broken[0] > 0.0, BROKEN * (1.0 + broken[0]), values[0] / self.floor))

        return objective


def numbers_of(machines: Sequence[Machine], controller: Controller) -> tuple[dict[str, float], ...]:
    """Return the parameters [SI] of each machine that differ between them, by dotted names; empty if they differ in other things too."""
    known = [parameters_of(machine, controller).items() for machine in machines]
    tables = [{name: float(getattr(*place)) for name, place in one if name.startswith("axes.")} for one in known]
    if any(table.keys() != tables[0].keys() for table in tables):
        return ()
    differ = [name for name in tables[0] if len({table[name] for table in tables}) > 1]
    numbers = tuple({name: table[name] for name in differ} for table in tables)
    try:
        made = [with_values(machines[0], controller, own)[0] for own in numbers]
        checked_variants(machines[0], controller, {name: [own[name] for own in numbers] for name in differ})
    except ParameterError:
        return ()
    pairs = [pair for one, other in zip(made, machines, strict=True) for pair in zip(one.axes, other.axes, strict=True)]
    return numbers if all(_alike(one, other) for one, other in pairs) else ()


# --- making the variants -----------------------------------------------------------------------------------------------------------------


def variants_of(machine: Machine, swaps: Mapping[str, Sequence[tuple[str, Axis]]]) -> tuple[Variant, ...]:
    """Return every combination of modules, the machine's own first.

    Parameters
    ----------
    machine : Machine
    swaps : mapping of str to sequence of (str, Axis)
        Named modules that may replace each swapped axis.

    Raises
    ------
    ParameterError
        If the machine has no such axis, no module differs from that axis, two modules are identical or have the same name, or a module
        does not fit: another command unit, or a motor side where the axis has none (or the reverse).
    """
    refuse(not swaps, ParameterError, "axis", "none", f"at least one axis to swap, of {', '.join(machine.axis_names)}")
    variants = []
    for picked in product(*(_choices(machine, name, others) for name, others in swaps.items())):
        made = machine
        for name, _, module in picked:
            made = made if module is None else made.swapped(name, module)
        modules = tuple((name, called) for name, called, _ in picked)
        variants.append(Variant(", ".join(f"{name} = {called}" for name, called in modules), made, modules))
    return tuple(variants)


def _choices(machine: Machine, name: str, others: Sequence[tuple[str, Axis]]) -> list[tuple[str, str, Axis | None]]:
    """Return the choices for an axis, first the axis itself; a module that is a copy of it provides its name."""
    if name not in machine.axis_names:
        raise ParameterError("axis", repr(name), f"one of {', '.join(machine.axis_names)}, the axes of {machine.name}")
    refuse(not others, ParameterError, "with", "nothing", f"at least one module for axis {name}")
    own = machine.axis(name)
    for (first, one), (second, other) in combinations(others, 2):
        if _alike(one, other):
            raise ParameterError("with", f"{first}, {second}", f"modules of axis {name} that differ: these two are identical")
    copies, modules = ([pair for pair in others if _alike(own, pair[1]) is alike] for alike in (True, False))
    if not modules:
        wanted = f"a module that differs from axis {name} of the machine: a copy loses nothing"
        raise ParameterError("with", ", ".join(called for called, _ in others), wanted)
    itself = copies[0][0] if copies else "as it is"
    names = [itself, *(called for called, _ in modules)]
    refuse(len(set(names)) != len(names), ParameterError, "with", ", ".join(names), "modules with different names")
    unit, sides = own.plant.command_unit, ("without a separate motor side", "with a motor and a load side")
    for called, other in modules:
        if other.plant.command_unit != unit:
            wanted = f"a module whose drive takes its command in {unit}, like axis {name}, not in {other.plant.command_unit}"
            raise ParameterError("with", called, wanted)
        if other.plant.two_sided != own.plant.two_sided:
            raise ParameterError("with", called, f"a module {sides[own.plant.two_sided]}, like axis {name}")
    return [(name, itself, None), *((name, called, other) for called, other in modules)]


def _alike(one: Axis, other: Axis) -> bool:
    return all(getattr(one, slot) == getattr(other, slot) for slot in (*AXIS_SLOTS, "substeps", "stage_mass", "limits"))
