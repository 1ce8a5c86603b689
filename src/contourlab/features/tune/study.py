"""Calibration from end to end: start, sequential procedure, global search, and a check of the result."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace

from contourlab.app.json_values import HIDDEN
from contourlab.errors import ParameterError
from contourlab.features.tune.drive_terms import DriveTerms, drive_terms, linuxcnc_findings
from contourlab.features.tune.objective import Evaluation, Goal, Objective, evaluate
from contourlab.features.tune.search import (
    FRACTIONS,
    SETTLED,
    GlobalResult,
    LineRule,
    SearchPath,
    global_search,
    placed_start,
    restore_margins,
    sequential,
)
from contourlab.findings import Finding, finding
from contourlab.loop import Controller, Machine, parameters_of
from contourlab.loop.parameters import with_values
from contourlab.metrics.run_figures import FIGURES
from contourlab.study import Runner, Setting, Space, calibration_order
from contourlab.study.executors import Executor, Workers
from contourlab.study.guards import Bounds, Guards

METHODS = ("sequential", "global", "both")
STARTS = ("scenario", "placed")
Candidate = tuple[float, str, dict[str, float]]
"""Objective, method, and values [SI]."""
Problem = tuple[Objective, Guards, Space]


@dataclass(frozen=True)
class TuneSettings:
    """Settings of a calibration.

    Attributes
    ----------
    method : str
        One of `METHODS`.
    start : str
        One of `STARTS`: the gains of the scenario, or placed poles.
    parameters : tuple of str
        Parameters and their ranges, see `contourlab.study.Space.chosen`; empty for all calibrated parameters.
    width : float, > 1
        Factor by which a parameter without a range may become smaller or larger.
    passes : int, >= 1
        Largest number of passes of the sequential procedure.
    budget : int, > 0
        Runs of the global search.
    starts : int, >= 1
        Starts of the global search.
    seed : int
        Seed of the global search.
    executor : Executor
    """

    goal: Goal = field(default_factory=Goal)
    bounds: Bounds = field(default_factory=Bounds)
    rule: LineRule = field(default_factory=LineRule)
    method: str = "both"
    start: str = "scenario"
    parameters: tuple[str, ...] = ()
    width: float = 4.0
    passes: int = 1
    budget: int = 6000
    starts: int = 5
    seed: int = 0
    executor: Executor = field(default_factory=Executor)

    def __post_init__(self) -> None:
        for name, value, known in (("method", self.method, METHODS), ("start", self.start, STARTS)):
            if value not in known:
                raise ParameterError(name, repr(value), f"one of {', '.join(known)}")
        if not 1.0 < self.width <= 1000.0:
            raise ParameterError("width", f"{self.width:g}", "> 1 and <= 1000")
        for name, low, high in (("passes", 1, 100), ("budget", 32, 10_000_000), ("starts", 1, 100), ("seed", 0, 2**63 - 1)):
            if not low <= getattr(self, name) <= high:
                raise ParameterError(name, f"{getattr(self, name)}", f"{low} to {high}")


@dataclass(frozen=True, eq=False)
class Tuned:
    """A calibrated controller.

    Attributes
    ----------
    space : Space
        The varied parameters, with their values at the start.
    values : dict of str to float [SI]
        Their calibrated values.
    method : str
        Method of the result: "sequential" or "global"; "none" if the given controller is better, or nothing found keeps the bounds.
    before, after : Evaluation
        Evaluations of the given and the calibrated controller.
    start_objective : float
        Objective at the start of the search: the placed start if there is one.
    path : SearchPath
        Steps of the repair and of the sequential procedure.
    runs : int
        Total number of runs.
    interrupted : bool
        Whether Ctrl-C ended the search; the result is the best so far.
    """

    controller: Controller = field(metadata=HIDDEN)
    space: Space
    values: dict[str, float]
    method: str
    before: Evaluation
    after: Evaluation
    start_objective: float
    path: SearchPath
    global_result: GlobalResult | None
    drive_terms: tuple[DriveTerms, ...]
    runs: int
    interrupted: bool = field(metadata=HIDDEN)
    findings: tuple[Finding, ...] = field(metadata=HIDDEN)


def tune(
    setting: Setting,
    settings: TuneSettings | None = None,
    *,
    pool: Workers | None = None,
    begin: Callable[[str], None] = lambda stage: None,
    progress: Callable[[int, int], None] | None = None,
) -> Tuned:
    """Calibrate a controller.

    Parameters
    ----------
    setting : Setting
    settings : TuneSettings, optional
    pool : Workers, optional
        Workers of the executor of the settings.
    begin : callable, optional
        Called with the name of each stage.
    progress : callable, optional
        Called with the amount of the stage that is done, and the whole.

    Raises
    ------
    ParameterError
        If a parameter is unknown or belongs to the machine, there is nothing to calibrate, or pole placement finds no start.

    Notes
    -----
    A parameter outside its range starts at the nearer end. If nothing keeps the bounds, the search of all gains starts again from placed
    poles.
    """
    settings = settings or TuneSettings()
    tuned = _tuned(setting, settings, pool, begin, progress)
    if tuned.interrupted:
        return tuned
    if tuned.after.violations and not settings.parameters and settings.start == "scenario" and settings.method != "sequential":
        with suppress(ParameterError):
            placed = _tuned(setting, replace(settings, start="placed"), pool, begin, progress)
            if not placed.after.violations:
                return placed
    return tuned


def _tuned(
    setting: Setting,
    settings: TuneSettings,
    pool: Workers | None,
    begin: Callable[[str], None],
    progress: Callable[[int, int], None] | None,
) -> Tuned:
    """Calibrate a controller from one start."""
    machine, controller = setting.machine, setting.controller
    _check(machine, controller, settings)
    begin("first run")
    before = evaluate(setting, settings.bounds)
    executor = settings.executor
    runner = Runner(setting, threads=executor.workers, gpu=executor.gpu, pool=pool)
    if settings.start == "placed":
        begin("placing poles")
        runner.setting = replace(setting, controller=placed_start(runner, settings.goal, settings.bounds))
    start = runner.setting.controller
    space = Space.chosen(machine, start, settings.parameters, settings.width)
    values = {variable.name: variable.nearest for variable in space.numbers}
    objective, guards = Objective(runner, settings.goal, values), Guards([(machine, start)], settings.bounds)
    start_objective = float(objective.at(values).value[0])
    placed = _placed_values(runner, settings, space, begin)
    path, global_result, candidates, interrupted = _candidates((objective, guards, space), values, placed, settings, begin, progress)
    method, best, rejected = _chosen(objective, guards, values, candidates)
    begin("checking the result")
    left: list[Finding] = []
    if method == "global" or settings.rule.plateau != "largest":
        best, left = _left((objective, guards, space), values, best, settings.rule)
    best = {variable.name: float(variable.written(best[variable.name])) for variable in space.numbers}
    tuned = with_values(machine, start, best)[1]
    after = evaluate(replace(setting, controller=tuned), settings.bounds)
    inside = all(variable.nearest == variable.value for variable in space.numbers)
    if inside and not before.violations and after.worse_than(before, settings.goal.figure):
        known = parameters_of(machine, controller)
        best = {variable.name: float(getattr(*known[variable.name])) for variable in space.numbers}
        method, tuned, after = "none", controller, before
    terms = drive_terms(machine, tuned, after.run)
    runs = runner.runs + (len(FRACTIONS) if settings.start == "placed" else 0) + 2
    findings = [*_range_findings(space, best, guards), *rejected, *(left if method != "none" else [])]
    if global_result is not None and global_result.values is None:
        findings.append(finding("CL603"))
    findings += [*linuxcnc_findings(terms), *_conclusions(settings.goal, before, after)]
    findings += [finding("CL610")] if interrupted else []
    return Tuned(tuned, space, best, method, before, after, start_objective, path, global_result, terms, runs, interrupted, tuple(findings))


def _left(
    problem: Problem, start: Mapping[str, float], best: Mapping[str, float], rule: LineRule
) -> tuple[Mapping[str, float], list[Finding]]:
    """Put parameters back to their start, axis by axis, where all bounds hold and the objective hardly rises.

    Returns
    -------
    tuple
        The values, and a finding that names the parameters put back.
    """
    objective, guards, space = problem
    moved = [variable for variable in space.numbers if best[variable.name] != start[variable.name]]
    share = SETTLED if rule.plateau == "best" else rule.within
    reached, began = (float(objective.at(values).value[0]) for values in (best, start))
    limit, kept = min(reached * (1.0 + share), max(reached, began)), list[str]()
    for axes in dict.fromkeys(guards.concerned(variable.name) for variable in moved):
        back = [variable for variable in moved if guards.concerned(variable.name) == axes]
        rise = {variable: float(objective.at({**best, variable.name: start[variable.name]}).value[0]) for variable in back}
        while back:
            trial = {**best, **{variable.name: start[variable.name] for variable in back}}
            run = objective.at(trial)
            if run.value[0] <= limit and not run.violations(trial, guards):
                best, kept = trial, [*kept, *(variable.short for variable in back)]
                break
            back.remove(max(back, key=lambda variable: rise[variable]))
    return best, [finding("CL611", parameters=tuple(kept), share=share)] if kept else []


def _check(machine: Machine, controller: Controller, settings: TuneSettings) -> None:
    """Refuse parameters of the machine, and a controller with nothing to calibrate."""
    if not settings.parameters:
        known = parameters_of(machine, controller)
        order = calibration_order(machine, controller)
        if not any(getattr(*known[name]) not in (0.0, math.inf) for name in order):
            kinds = ", ".join(sorted({part.controller.kind for part in controller.axes.values()}))
            raise ParameterError("parameters", f"none: {kinds} has no nonzero parameter to calibrate", "given, each with its bounds")
    for variable in Space.chosen(machine, controller, settings.parameters, settings.width).numbers:
        if variable.name.startswith("axes."):
            raise ParameterError("parameter", variable.short, "a parameter of the controller; the machine is not calibrated")


def _range_findings(space: Space, values: Mapping[str, float], guards: Guards) -> Iterator[Finding]:
    for axis, reason in guards.unknown.items():
        yield finding("CL600", f"axis {axis}", reason=reason)
    for variable in space.numbers:
        if variable.nearest != variable.value:
            yield finding("CL601", variable.short, value=variable.value, start=variable.nearest)
    ended = tuple(variable.short for variable in space.numbers if variable.cramped(values[variable.name]))
    if ended:
        yield finding("CL602", parameters=ended)


def _conclusions(goal: Goal, before: Evaluation, after: Evaluation) -> Iterator[Finding]:
    """Yield the changes of the chosen figure and of the integral of the contour error."""
    for key in dict.fromkeys((goal.figure or "contour_error_integral", "contour_error_integral")):
        if math.isfinite(before.figures[key]) and before.figures[key]:
            yield finding("CL609", FIGURES[key].label, ratio=after.figures[key] / before.figures[key])


def _placed_values(runner: Runner, settings: TuneSettings, space: Space, begin: Callable[[str], None]) -> list[dict[str, float]]:
    """Return placed poles as a further start of the global search, within the ranges; nothing where the controller has none."""
    if settings.method == "sequential" or settings.start == "placed":
        return []
    begin("placing poles")
    with suppress(ParameterError):
        known = parameters_of(runner.setting.machine, placed_start(runner, settings.goal, settings.bounds))
        return [{one.name: min(max(float(getattr(*known[one.name])), one.low), one.high) for one in space.numbers}]
    return []


def _candidates(
    problem: Problem,
    values: Mapping[str, float],
    placed: Sequence[dict[str, float]],
    settings: TuneSettings,
    begin: Callable[[str], None],
    progress: Callable[[int, int], None] | None,
) -> tuple[SearchPath, GlobalResult | None, list[Candidate], bool]:
    """Search from a start with the chosen methods.

    Returns
    -------
    tuple
        The steps, the result of the global search, the candidates, and whether Ctrl-C ended the search.
    """
    objective = problem[0]
    candidates: list[Candidate] = []
    begin("restoring the margins")
    path = restore_margins(*problem, values)
    starts = [path.values]
    if settings.method != "global":
        begin("one parameter at a time")
        line = sequential(*problem, path.values, settings.rule, passes=settings.passes, progress=progress)
        path = SearchPath(line.values, (*path.steps, *line.steps), line.interrupted)
        candidates.append((float(objective.at(line.values).value[0]), "sequential", line.values))
        starts.append(line.values)
    if settings.method == "sequential" or path.interrupted:
        return path, None, candidates, path.interrupted
    begin("all parameters at once")
    starts += placed
    try:
        result = global_search(*problem, starts, starts=settings.starts, budget=settings.budget, seed=settings.seed, progress=progress)
    except ParameterError:  # every run fails
        if settings.method == "global":
            raise
        return path, None, candidates, False
    except KeyboardInterrupt:  # before its first generation
        if not candidates:
            raise
        return path, None, candidates, True
    if result.values is not None:
        candidates.append((result.objective, "global", result.values))
    return path, result, candidates, result.search.interrupted


def _chosen(
    objective: Objective, guards: Guards, values: Mapping[str, float], candidates: list[Candidate]
) -> tuple[str, Mapping[str, float], list[Finding]]:
    """Return method and values of the best candidate that keeps the bounds, with a finding for each better candidate that breaks one.

    If every candidate breaks a bound, return the best; its evaluation lists the broken bounds.
    """
    findings: list[Finding] = []
    ranked = sorted(candidates, key=lambda candidate: candidate[0])
    for _, method, found in ranked:
        violations = objective.at(found).violations(found, guards)
        if not violations:
            return method, found, findings
        findings.append(finding("CL604", method=method, bounds=violations))
    return (*ranked[0][1:], findings[1:]) if ranked else ("none", values, findings)
