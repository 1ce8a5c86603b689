"""The searches of a calibration: placed poles, one parameter at a time (Ghaffari & Ulsoy), and all at once."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from contourlab.app.json_values import HIDDEN
from contourlab.arrays import Array
from contourlab.errors import ParameterError, refuse
from contourlab.features.tune.objective import Goal, Objective, Problem
from contourlab.loop import Controller, Machine, parameters_of
from contourlab.scenario.build import model_of
from contourlab.study import DesignVariable, Found, Runner, search
from contourlab.study.guards import Bounds, designed, fastest_speed
from contourlab.study.search import drawn_starts
from contourlab.study.space import axes_of

Progress = Callable[[int, int], None]
"""Called with the amount that is done, and the whole."""
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
    looped = [axis for axis in machine.axes if not axis.plant.takes_position]
    speeds = {axis.name: fastest_speed(machine, axis, controller.axes[axis.name], bounds) for axis in looped}
    candidates = [made for fraction in FRACTIONS.tolist() if (made := _placed(machine, controller, speeds, fraction)) is not None]
    refuse(not candidates, ParameterError, "start", "placed", "scenario: no common fraction of the fastest poles gives gains on every axis")
    parameters = [parameters_of(machine, candidate) for candidate in candidates]
    names = [name for name in parameters[-1] if ".controller." in name]
    gains = {name: np.array([getattr(*known[name]) for known in parameters], dtype=float) for name in names}
    columns = {name: values for name, values in gains.items() if np.isfinite(values).all()}
    placed = replace(runner, setting=replace(setting, controller=candidates[-1]))
    runs = Objective(placed, Goal(goal.weights[:1]), {name: float(values[-1]) for name, values in columns.items()})(columns)
    good = (runs.limited <= bounds.limited) & (runs.largest <= bounds.command)
    ranked = np.where(good, runs.value, np.inf)
    if not np.isfinite(ranked).any():
        raise ParameterError("start", "placed", "scenario: with placed poles every run fails or exceeds the drive limits")
    return candidates[int(np.argmin(ranked))]


def _placed(machine: Machine, controller: Controller, speeds: Mapping[str, float], fraction: float) -> Controller | None:
    """Return the controller with poles at a fraction of the speeds; None if a plant's own damping is too large for such slow poles."""
    axes = dict(controller.axes)
    try:
        for name, speed in speeds.items():
            slots, axis = axes[name], machine.axis(name)
            gains = designed(slots.controller, fraction * speed, model_of(machine, axis, slots.observer), name)
            axes[name] = replace(slots, controller=slots.controller.replace(**gains))
    except ParameterError:
        return None
    return replace(controller, axes=axes)


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
    lanes : int
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
    problem: Problem,
    values: Mapping[str, float],
    rule: LineRule,
    *,
    passes: int = 1,
    progress: Progress = lambda done, total: None,
) -> SearchPath:
    """Calibrate the parameters of a space one at a time, in its order, innermost loop first; Ctrl-C ends with the steps so far.

    Parameters
    ----------
    problem : Problem
        Its space is in the order of the procedure, see `contourlab.study.calibration_order`.
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
    for turn in range(1, passes + 1):
        begun = steps[-1].objective_after if steps else math.inf
        for variable in problem.space.numbers:
            try:
                step = line_search(problem, variable, now, rule, f"pass {turn}")
            except KeyboardInterrupt:
                if not steps:
                    raise
                return SearchPath(now, tuple(steps), interrupted=True)
            now[variable.name] = step.after
            steps.append(step)
            progress(len(steps), passes * len(problem.space.numbers))
        if steps[-1].objective_after > begun * (1.0 - SETTLED):
            break
    return SearchPath(now, tuple(steps))


def line_search(problem: Problem, variable: DesignVariable, values: Mapping[str, float], rule: LineRule, stage: str = "pass 1") -> Step:
    """Find the best value of one parameter, all others as in `values` [SI].

    Notes
    -----
    The present value is among those tried, so the objective never rises. If the present values break a bound, a new value may not break it
    further.
    """
    line = _Line(problem, variable, values)
    line.add(np.append(variable.physical(np.linspace(0.0, 1.0, rule.lanes - 1)), line.own))
    for _ in range(REFINEMENTS):
        low, high = variable.normalise(line.neighbours(line.best())).tolist()
        if not high > low:
            break
        line.add(variable.physical(np.linspace(low, high, rule.lanes + 2)[1:-1]))
    best = line.best()
    chosen = line.chosen(best, rule)
    return line.step(stage, chosen, line.barrier(best), "" if chosen == best else "flat optimum")


class _Line:
    """All values of one parameter tried so far, with their runs and margins."""

    def __init__(self, problem: Problem, variable: DesignVariable, values: Mapping[str, float], axes: Sequence[str] = ()) -> None:
        self.problem, self.variable, self.given, self.own = problem, variable, values, float(values[variable.name])
        self.axes = axes or axes_of(variable.name, problem.guards.machine)
        self.objective: dict[float, float] = {}
        self.limits: dict[float, tuple[float, float]] = {}
        self.margins: dict[float, tuple[float, float]] = {}
        """The shortfall of the margins at a value, and the distance of the loops from -1."""

    def add(self, values: Array) -> None:
        """Run values."""
        tried = np.setdiff1d(values, list(self.objective))
        if not tried.size:
            return
        columns = {name: np.full(tried.size, value) for name, value in self.given.items()} | {self.variable.name: tried}
        runs, guards, keys = self.problem.objective(columns), self.problem.guards, tried.tolist()
        self.margins |= _rows(keys, *guards.missing(guards.lanes(columns, self.axes), tried.size))
        self.limits |= _rows(keys, runs.limited, runs.largest)
        self.objective = dict(sorted((self.objective | dict(zip(keys, runs.value.tolist(), strict=True))).items()))

    def within_limits(self, value: float) -> bool:
        """Return whether a run succeeded and keeps the drive limits, or breaks them no further than the present value does."""
        bounds = self.problem.guards.bounds
        here = [limit if math.isfinite(limit) else 0.0 for limit in self.limits[self.own]]
        limited, largest = self.limits[value]
        kept = limited <= max(bounds.limited, here[0]) and largest <= max(bounds.command, here[1])
        return kept and math.isfinite(self.objective[value])

    def allowed(self, value: float) -> bool:
        """Return whether a value keeps the bounds, or breaks them no further than the present value does."""
        return self.within_limits(value) and self.margins[value][0] <= self.margins[self.own][0]

    def best(self) -> float:
        """Return the best allowed value; the present value if none is allowed."""
        return next(filter(self.allowed, sorted(self.objective, key=self.objective.__getitem__)), self.own)

    def neighbours(self, value: float) -> list[float]:
        """Return the values on both sides of a value, itself at an end."""
        values = list(self.objective)
        i = values.index(value)
        return [values[max(i - 1, 0)], values[min(i + 1, len(values) - 1)]]

    def chosen(self, best: float, rule: LineRule) -> float:
        """Return the value that the rule takes among those about as good as the best."""
        reached = self.objective[best]
        if rule.plateau == "best" or not math.isfinite(reached):
            return best
        limit = min(reached * (1.0 + rule.within), max(reached, self.objective[self.own]))
        good = [value for value, objective in self.objective.items() if objective <= limit and self.allowed(value)]
        if rule.plateau == "largest" or not good:
            return max(good, default=best)
        # Feedforward moves no pole: all values are then equally robust, so take the best.
        farthest = max(self.margins[value][1] for value in good)
        robust = [value for value in good if self.margins[value][1] >= farthest * (1.0 - 1e-6)]
        return min(robust, key=self.objective.__getitem__)

    def barrier(self, best: float) -> str:
        """Return the bound that the value with the smallest objective breaks; empty if that value is allowed."""
        lowest = min(self.objective, key=self.objective.__getitem__)
        if not self.objective[lowest] < self.objective[best]:
            return ""
        if not self.within_limits(lowest):
            return "limit of a drive"
        return "stability" if math.isinf(self.margins[lowest][0]) else "margins"

    def step(self, stage: str, after: float, barrier: str, otherwise: str = "") -> Step:
        """Return the step to a value."""
        bound = "; ".join(filter(None, (barrier, self.variable.end(after)))) or otherwise
        values, objectives = (np.array(list(each)) for each in (self.objective, self.objective.values()))
        return Step(stage, self.variable, self.own, after, self.objective[self.own], self.objective[after], bound, values, objectives)


def _rows(keys: list[float], *columns: Array) -> dict[float, tuple[float, float]]:
    """Return the rows of two columns by key."""
    return dict(zip(keys, zip(*(column.tolist() for column in columns), strict=True), strict=True))


def restore_margins(problem: Problem, values: Mapping[str, float]) -> SearchPath:
    """Change parameters axis by axis until the margins are kept; an axis that keeps them needs no step.

    Parameters
    ----------
    problem : Problem
    values : mapping of str to float [SI]

    Notes
    -----
    On each axis, the parameter that restores the margins with the smallest objective changes. If none restores them, the one that comes
    nearest changes, and then the next. If the ranges are too narrow, margins stay broken.
    """
    guards, now, steps = problem.guards, dict(values), list[Step]()
    for axis in guards.machine.axis_names:
        variables = [variable for variable in problem.space.numbers if axis in axes_of(variable.name, guards.machine)]
        for _ in variables:
            columns = {name: np.array([value]) for name, value in now.items()}
            missing = float(guards.missing(guards.lanes(columns, (axis,)), 1)[0][0])
            if missing <= 0.0:
                break
            repairs = [_repair(problem, axis, variable, now) for variable in variables]
            missing_after, _, _, step = min(repairs, key=lambda repair: repair[:3])
            if not missing_after < missing:
                break
            now[step.variable.name] = step.after
            steps.append(step)
    return SearchPath(now, tuple(steps))


def _repair(problem: Problem, axis: str, variable: DesignVariable, now: Mapping[str, float]) -> tuple[float, float, float, Step]:
    """Return for the best value of one parameter: shortfall of the margins, objective, distance moved, and step."""
    line = _Line(problem, variable, now, (axis,))
    line.add(np.append(variable.physical(np.linspace(0.0, 1.0, REPAIR_VALUES - 1)), line.own))
    # While another axis still diverges, all runs fail: take the smallest change that restores the margins.
    usable = [value for value, objective in line.objective.items() if math.isfinite(objective)] or list(line.objective)
    least = min(line.margins[value][0] for value in usable)
    place = variable.normalise(line.own)

    def rank(value: float) -> tuple[float, float]:
        return line.objective[value], abs(float(variable.normalise(value) - place))

    after = min((value for value in usable if line.margins[value][0] <= least), key=rank)
    reached, distance = rank(after)
    fell = any(line.objective[value] < reached and line.margins[value][0] > least for value in usable)
    return least, reached, distance, line.step("repair", after, "margins" if fell else "")


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
    problem: Problem,
    given: Sequence[Mapping[str, float]],
    *,
    starts: int = 5,
    budget: int = 6000,
    seed: int = 0,
    progress: Progress = lambda done, total: None,
) -> GlobalResult:
    """Search all parameters at once.

    Parameters
    ----------
    problem : Problem
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
    Each generation checks the margins of its best points in turn until `KEPT` of them keep the bounds. A point that breaks a bound is
    ranked behind all others of its generation. The exact analysis checks the result. Ctrl-C ends the search with the best values so far.
    """
    found = search(
        lambda points: _ranked(problem, points),
        drawn_starts([problem.space.points(values)[0] for values in given], starts, len(problem.space.numbers), seed),
        budget=budget,
        seed=seed,
        population=POPULATION,
        progress=lambda done: progress(done, budget),
        stoppable=True,
    )
    for i in np.argsort(found.per_start, kind="stable"):
        if not np.isfinite(found.per_start[i]):
            break
        values = problem.space.values(found.points[i])
        run = problem.objective.at(values)
        if not run.violations(values, problem.guards):
            return GlobalResult(values, float(run.value[0]), found)
    return GlobalResult(None, float("nan"), found)


def _ranked(problem: Problem, points: Array) -> Array:
    """Return the objective of points, a generation of each start; points that break a bound rank behind the others of their generation."""
    columns, guards = problem.space.columns(points), problem.guards
    runs = problem.objective(columns)
    excess = np.maximum(runs.limited - guards.bounds.limited, 0.0)
    if np.isfinite(guards.bounds.command):
        excess = excess + np.maximum(runs.largest / guards.bounds.command - 1.0, 0.0)
    ranked, worst, turns = runs.value.copy(), np.zeros(len(points)), []
    usable = np.isfinite(ranked) & (excess <= 0.0)
    for first in range(0, len(points), POPULATION):
        part = np.arange(first, min(first + POPULATION, len(points)))
        finite = ranked[part][np.isfinite(ranked[part])]
        if finite.size:
            worst[part] = finite.max()
            ranked[part] = np.where(excess[part] > 0.0, worst[part] * (2.0 + excess[part]), ranked[part])
        order = part[np.argsort(ranked[part], kind="stable")]
        turns.append((order[usable[order]], KEPT))
    axes = {axis for name in problem.space.names for axis in axes_of(name, guards.machine)}
    lanes, missing = guards.lanes(columns, axes), np.zeros(len(points))
    while turns := [(order, left) for order, left in turns if order.size and left > 0]:
        now = np.concatenate([order[:left] for order, left in turns])
        missing[now], _ = guards.missing([loops[now] for loops in lanes], now.size)
        turns = [(order[left:], left - int((missing[order[:left]] <= 0.0).sum())) for order, left in turns]
    broken = missing > 0.0
    ranked[broken] = worst[broken] * (2.0 + missing[broken])
    return ranked
