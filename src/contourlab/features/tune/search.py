"""The searches of a calibration: placed poles, one parameter at a time (Ghaffari & Ulsoy), and all at once."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from contourlab.analysis.linear.sampled_loop import SampledLoop
from contourlab.app.json_values import HIDDEN
from contourlab.arrays import Array, Flags
from contourlab.errors import ParameterError
from contourlab.features.tune.objective import Goal, Objective
from contourlab.loop import Controller, Machine, parameters_of
from contourlab.study import DesignVariable, Found, Runner, Space, search
from contourlab.study.guards import Bounds, Guards, designed, fastest_speed, model_of

FRACTIONS = np.geomspace(0.1, 1.0, 32)
"""Fractions of the fastest poles, tried for all axes together."""


def placed_start(runner: Runner, goal: Goal, bounds: Bounds) -> Controller:
    """Return the controller with poles at the fraction of the fastest speed that gives the smallest objective.

    Parameters
    ----------
    runner : Runner
    goal : Goal
        Only its first figure counts.

    Raises
    ------
    ParameterError
        If a controller cannot be designed from poles, its loop has no linear model or is stable at no speed, or every run fails or exceeds
        the drive limits.
    """
    setting = runner.setting
    machine, controller = setting.machine, setting.controller
    speeds = {axis.name: fastest_speed(machine, axis, controller.axes[axis.name], bounds) for axis in machine.axes}
    candidates = [made for fraction in FRACTIONS.tolist() if (made := _placed(machine, controller, speeds, fraction)) is not None]
    if not candidates:
        raise ParameterError("start", "placed", "scenario: no common fraction of the fastest poles gives gains on every axis")
    parameters = [parameters_of(machine, candidate) for candidate in candidates]
    columns: dict[str, np.ndarray] = {}
    for name in parameters[-1]:
        if ".controller." in name:
            values = np.array([getattr(*known[name]) for known in parameters], dtype=float)
            if np.isfinite(values).all():
                columns[name] = values
    last = {name: float(values[-1]) for name, values in columns.items()}
    placed = replace(runner, setting=replace(setting, controller=candidates[-1]))
    runs = Objective(placed, Goal(goal.weights[:1]), last)(columns)
    good = (runs.limited <= bounds.limited) & (runs.largest <= bounds.command)
    ranked = np.where(good, runs.value, np.inf)
    if not np.isfinite(ranked).any():
        raise ParameterError("start", "placed", "scenario: with placed poles every run fails or exceeds the drive limits")
    return candidates[int(np.argmin(ranked))]


def _placed(machine: Machine, controller: Controller, speeds: Mapping[str, float], fraction: float) -> Controller | None:
    """Return the controller with poles at a fraction of the speeds; None if a plant's own damping is too large for such slow poles."""
    axes = dict(controller.axes)
    try:
        for axis in machine.axes:
            slots = axes[axis.name]
            gains = designed(slots.controller, fraction * speeds[axis.name], model_of(machine, axis, slots), axis.name)
            axes[axis.name] = replace(slots, controller=slots.controller.replace(**gains))
    except ParameterError:
        return None
    return replace(controller, axes=axes)


PLATEAUS = ("robust", "best", "largest")
SETTLED = 1e-3
"""The sequential procedure ends after a pass that lowers the objective by less than this share."""
REFINEMENTS = 2
"""Number of finer lines, each between the neighbours of the best value so far."""
REPAIR_VALUES = 64


@dataclass(frozen=True)
class LineRule:
    """Settings of a line search.

    Attributes
    ----------
    lanes : int, 8 to 1024
        Number of values of a line; 32 fill the lanes of one thread.
    plateau : str
        Which of the values within `within` of the best to take: "robust" takes that whose loop stays farthest from -1, "largest" the
        largest ("as large as feasible"), "best" the best.
    within : float, >= 0, < 1
        Share by which a value may be worse than the best.
    """

    lanes: int = 32
    plateau: str = "robust"
    within: float = 0.01

    def __post_init__(self) -> None:
        if self.plateau not in PLATEAUS:
            raise ParameterError("plateau", repr(self.plateau), f"one of {', '.join(PLATEAUS)}")
        if not 8 <= self.lanes <= 1024:
            raise ParameterError("lanes", f"{self.lanes}", "8 to 1024")
        if not 0.0 <= self.within < 1.0:
            raise ParameterError("within", f"{self.within:g}", ">= 0 and < 1")


@dataclass(frozen=True, eq=False)
class Step:
    """One parameter changed, all others fixed.

    Attributes
    ----------
    stage : str
        "repair", "pass 1", "pass 2" and so on.
    before, after : float [SI]
    bound : str
        The bound that prevents a smaller objective, and the end of the range that the value lies on; empty if neither applies.
    values, objectives : ndarray (k,)
        All values tried, increasing, and their objectives.
    """

    stage: str
    variable: DesignVariable
    before: float
    after: float
    objective_before: float
    objective_after: float
    bound: str
    values: Array = field(metadata=HIDDEN)
    objectives: Array = field(metadata=HIDDEN)


@dataclass(frozen=True)
class SearchPath:
    """Steps in order, the resulting values [SI], and whether Ctrl-C ended them."""

    values: dict[str, float]
    steps: tuple[Step, ...] = ()
    interrupted: bool = field(default=False, metadata=HIDDEN)


def sequential(
    objective: Objective,
    guards: Guards,
    space: Space,
    values: Mapping[str, float],
    rule: LineRule,
    *,
    passes: int = 1,
    progress: Callable[[int, int], None] | None = None,
) -> SearchPath:
    """Calibrate the parameters of a space one at a time, in its order, innermost loop first; Ctrl-C ends with the steps so far.

    Parameters
    ----------
    space : Space
        In the order of the procedure, see `contourlab.study.calibration_order`.
    values : mapping of str to float [SI]
    passes : int, >= 1
        Largest number of passes; the procedure ends after one that hardly lowers the objective.
    progress : callable, optional
        Called with the number of steps done and the largest number of steps.

    References
    ----------
    Ghaffari & Ulsoy, "Component swapping modularity for distributed precision contouring", section IV.
    """
    now, steps = dict(values), list[Step]()
    total = passes * len(space.numbers)
    for turn in range(1, passes + 1):
        begun = steps[-1].objective_after if steps else math.inf
        for variable in space.numbers:
            try:
                step = line_search(objective, guards, variable, now, rule, f"pass {turn}")
            except KeyboardInterrupt:
                if not steps:
                    raise
                return SearchPath(now, tuple(steps), interrupted=True)
            now[variable.name] = step.after
            steps.append(step)
            if progress is not None:
                progress(len(steps), total)
        if steps[-1].objective_after > begun * (1.0 - SETTLED):
            break
    return SearchPath(now, tuple(steps))


def line_search(
    objective: Objective, guards: Guards, variable: DesignVariable, values: Mapping[str, float], rule: LineRule, stage: str = "pass 1"
) -> Step:
    """Find the best value of one parameter, all others as in `values` [SI].

    Notes
    -----
    The present value is among those tried, so the objective never rises. If the present values break a bound, a new value may not break it
    further.
    """
    line = _Line(objective, guards, variable, values)
    line.add(np.append(np.linspace(0.0, 1.0, rule.lanes - 1), variable.normalise(line.own)), keep_present=True)
    for _ in range(REFINEMENTS):
        low, high = line.neighbours(line.best())
        if not high > low:
            break
        line.add(np.linspace(low, high, rule.lanes + 2)[1:-1])
    best = line.best()
    chosen = line.chosen(best, rule)
    objectives = float(line.value[line.present]), float(line.value[chosen])
    return Step(stage, variable, line.own, float(line.values[chosen]), *objectives, line.bound(best, chosen), line.values, line.value)


class _Line:
    """All values of one parameter tried so far, increasing, with their runs and loops."""

    def __init__(self, objective: Objective, guards: Guards, variable: DesignVariable, values: Mapping[str, float]) -> None:
        self.objective, self.guards, self.variable, self.given = objective, guards, variable, dict(values)
        self.axes = guards.concerned(variable.name)
        self.values = self.value = self.limited = self.largest = np.zeros(0)
        self.own = float(values[variable.name])
        self.known_margins: dict[float, tuple[float, float]] = {}
        self.loops: dict[float, list[SampledLoop]] = {}
        self.allowance = 0.0

    @property
    def present(self) -> int:
        """Index of the present value."""
        return int(np.flatnonzero(self.values == self.own)[0])

    def add(self, places: Array, keep_present: bool = False) -> None:
        """Run the values at normalised positions 0 to 1; with `keep_present` the last is exactly the present value."""
        tried = np.asarray(self.variable.physical(places))
        if keep_present:
            tried[-1] = self.own
        tried = np.setdiff1d(np.unique(tried), self.values)
        if not tried.size:
            return
        columns = {name: np.full(tried.size, value) for name, value in self.given.items()} | {self.variable.name: tried}
        runs = self.objective(columns)
        self.loops |= dict(zip(tried.tolist(), self.guards.loops(columns, self.axes), strict=True))
        order = np.argsort(np.concatenate([self.values, tried]), kind="stable")
        for name in ("value", "limited", "largest"):
            setattr(self, name, np.concatenate([getattr(self, name), getattr(runs, name)])[order])
        self.values = np.concatenate([self.values, tried])[order]
        if not self.known_margins:
            self.allowance = self.margins(self.present)[0]

    def margins(self, i: int) -> tuple[float, float]:
        """Return the shortfall of the margins, and the distance of the loops from -1."""
        value = float(self.values[i])
        if value not in self.known_margins:
            self.known_margins[value] = self.guards.missing(self.loops[value])
        return self.known_margins[value]

    def within_limits(self) -> Flags:
        """Return which runs succeeded and keep the drive limits, or break them no further than the present value does."""
        bounds, here = self.guards.bounds, self.present
        limited = self.limited <= max(bounds.limited, self.limited[here] if np.isfinite(self.limited[here]) else 0.0)
        largest = self.largest <= max(bounds.command, self.largest[here] if np.isfinite(self.largest[here]) else 0.0)
        return np.asarray(np.isfinite(self.value) & limited & largest)

    def best(self) -> int:
        """Return the index of the best allowed value; that of the present value if none is allowed."""
        return next((i for i in np.argsort(self.value, kind="stable").tolist() if self._allowed(i)), self.present)

    def _allowed(self, i: int) -> bool:
        return bool(self.within_limits()[i]) and self.margins(i)[0] <= self.allowance

    def neighbours(self, i: int) -> tuple[float, float]:
        """Return the normalised neighbours of a value."""
        place = self.variable.normalise(self.values)
        return float(place[max(i - 1, 0)]), float(place[min(i + 1, len(place) - 1)])

    def chosen(self, best: int, rule: LineRule) -> int:
        """Return the index of the value that the rule takes among those about as good as the best."""
        if rule.plateau == "best" or not np.isfinite(self.value[best]):
            return best
        limit = min(self.value[best] * (1.0 + rule.within), max(self.value[best], self.value[self.present]))
        good = [i for i in np.flatnonzero(self.value <= limit).tolist() if self._allowed(i)]
        if not good:
            return best
        if rule.plateau == "largest":
            return int(max(good))
        # Feedforward moves no pole: all values are then equally robust, so take the best.
        farthest = max(self.margins(i)[1] for i in good)
        robust = [i for i in good if self.margins(i)[1] >= farthest * (1.0 - 1e-6)]
        return int(min(robust, key=lambda i: self.value[i]))

    def bound(self, best: int, chosen: int) -> str:
        """Return what prevents a smaller objective: a bound, an end of the range, or nothing."""
        reasons = list(filter(None, (self._barrier(best), self.variable.end(float(self.values[chosen])))))
        return "; ".join(reasons) or ("" if chosen == best else "flat optimum")

    def _barrier(self, best: int) -> str:
        """Return the bound that the value with the smallest objective breaks; empty if that value is allowed."""
        lowest = int(np.argmin(self.value))
        if not self.value[lowest] < self.value[best]:
            return ""
        if not self.within_limits()[lowest]:
            return "limit of a drive"
        return "stability" if math.isinf(self.margins(lowest)[0]) else "margins"


def restore_margins(objective: Objective, guards: Guards, space: Space, values: Mapping[str, float]) -> SearchPath:
    """Change parameters axis by axis until the margins are kept; an axis that keeps them needs no step.

    Parameters
    ----------
    space : Space
        Parameters that may change, each within its range.
    values : mapping of str to float [SI]

    Notes
    -----
    On each axis, the parameter that restores the margins with the smallest objective changes. If none restores them, the one that comes
    nearest changes, and then the next. If the ranges are too narrow, margins stay broken.
    """
    now, steps = dict(values), list[Step]()
    for axis in guards.axes:
        variables = [variable for variable in space.numbers if axis in guards.concerned(variable.name)]
        for _ in variables:
            columns = {name: np.array([value]) for name, value in now.items()}
            missing = guards.missing(guards.loops(columns, (axis,))[0])[0]
            if missing <= 0.0:
                break
            repairs = [_repair(objective, guards, axis, variable, now) for variable in variables]
            missing_after, _, _, step = min(repairs, key=lambda repair: repair[:3])
            if not missing_after < missing:
                break
            now[step.variable.name] = step.after
            steps.append(step)
    return SearchPath(now, tuple(steps))


def _repair(
    objective: Objective, guards: Guards, axis: str, variable: DesignVariable, now: Mapping[str, float]
) -> tuple[float, float, float, Step]:
    """Return for the best value of one parameter: shortfall of the margins, objective, distance moved, and step."""
    own = now[variable.name]
    values = np.unique(np.append(variable.physical(np.linspace(0.0, 1.0, REPAIR_VALUES - 1)), own))
    columns = {name: np.full(values.size, value) for name, value in now.items()} | {variable.name: values}
    objectives = objective(columns).value
    missing = np.array([guards.missing(loops)[0] for loops in guards.loops(columns, (axis,))])
    # While another axis still diverges, all runs fail: take the smallest change that restores the margins.
    finite = np.isfinite(objectives)
    usable = finite if finite.any() else np.ones(values.size, dtype=bool)
    least = float(missing[usable].min(initial=math.inf))
    distance = np.abs(variable.normalise(values) - variable.normalise(own))
    at = int(np.lexsort((distance, objectives, ~(usable & (missing <= least))))[0])
    present, reached = int(np.flatnonzero(values == own)[0]), float(objectives[at])
    barrier = "margins" if bool((objectives[usable & (missing > least)] < reached).any()) else ""
    bound = "; ".join(filter(None, (barrier, variable.end(float(values[at])))))
    step = Step("repair", variable, own, float(values[at]), float(objectives[present]), reached, bound, values, objectives)
    return least, reached, float(distance[at]), step


POPULATION = 32
KEPT = 8
"""Number of points per generation that must keep the margins: the best points are checked in turn until it is reached."""


@dataclass(frozen=True, eq=False)
class GlobalResult:
    """The result of the global search.

    Attributes
    ----------
    values : dict of str to float [SI] or None
        The best values that keep all bounds in the exact analysis; None if no start led to any.
    objective : float
        nan if `values` is None.
    """

    values: dict[str, float] | None
    objective: float
    search: Found


def global_search(
    objective: Objective,
    guards: Guards,
    space: Space,
    given: Sequence[Mapping[str, float]],
    *,
    starts: int = 5,
    budget: int = 6000,
    seed: int = 0,
    progress: Callable[[int, int], None] | None = None,
) -> GlobalResult:
    """Search all parameters at once.

    Parameters
    ----------
    given : sequence of mapping of str to float [SI]
        Known starts; the others are drawn from the middle half of the box.
    starts : int, >= 1
        Total number of starts.
    budget : int
        Total number of runs.
    seed : int
        Seed of the drawn starts and the search; the same seed gives the same result.
    progress : callable, optional
        Called with the number of runs done and in all.

    Notes
    -----
    Margins take longer to compute than a run. Each generation therefore checks its best points in turn until `KEPT` of them keep the
    bounds. A point that breaks a bound is ranked behind all others of its generation. The exact analysis checks the result. Ctrl-C ends
    the search with the best values so far.
    """
    generator = np.random.default_rng(seed)
    known = [space.points(values)[0] for values in given][:starts]
    drawn = 0.25 + 0.5 * generator.random((starts - len(known), len(space.numbers)))
    fixed = {name: value for name, value in given[0].items() if name not in space.names}
    found = search(
        _Ranked(objective, guards, space, fixed),
        np.vstack([*known, drawn]) if known else drawn,
        budget=budget,
        seed=seed,
        population=POPULATION,
        progress=None if progress is None else lambda done: progress(done, budget),
        stoppable=True,
    )
    for i in np.argsort(found.per_start, kind="stable"):
        if not np.isfinite(found.per_start[i]):
            break
        values = fixed | space.values(found.points[i])
        run = objective.at(values)
        if not run.violations(values, guards):
            return GlobalResult(values, float(run.value[0]), found)
    return GlobalResult(None, float("nan"), found)


class _Ranked:
    """The objective of points; points that break a bound rank behind the others."""

    def __init__(self, objective: Objective, guards: Guards, space: Space, fixed: Mapping[str, float]) -> None:
        self.objective, self.guards, self.space, self.fixed = objective, guards, space, fixed
        self.axes = tuple(dict.fromkeys(axis for name in space.names for axis in guards.concerned(name)))

    def __call__(self, points: Array) -> Array:
        columns = self.space.columns(points)
        columns |= {name: np.full(len(points), value) for name, value in self.fixed.items()}
        runs = self.objective(columns)
        bounds = self.guards.bounds
        excess = np.maximum(runs.limited - bounds.limited, 0.0)
        if np.isfinite(bounds.command):
            excess = excess + np.maximum(runs.largest / bounds.command - 1.0, 0.0)
        excess = np.where(np.isfinite(excess), excess, np.inf)
        ranked = runs.value.copy()
        for first in range(0, len(points), POPULATION):
            part = slice(first, first + POPULATION)
            ranked[part] = self._generation(ranked[part], excess[part], {name: column[part] for name, column in columns.items()})
        return ranked

    def _generation(self, values: Array, excess: Array, columns: Mapping[str, Array]) -> Array:
        """Return the ranked values of one generation of one start; points that break a bound rank behind the others."""
        good = np.isfinite(values)
        if not good.any():
            return values
        worst = float(values[good].max())
        ranked = np.where(excess > 0.0, worst * (2.0 + excess), values)
        order = [i for i in np.argsort(ranked, kind="stable").tolist() if good[i] and excess[i] <= 0.0]
        loops = self.guards.loops(columns, self.axes)
        kept = 0
        for i in order:
            missing, _ = self.guards.missing(loops[i])
            if missing > 0.0:
                ranked[i] = worst * (2.0 + missing)
            else:
                kept += 1
                if kept == KEPT:
                    break
        return ranked
