"""Calibration from end to end: start, sequential procedure, global search, and a check of the result."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from typing import ClassVar

import numpy as np

from contourlab.analysis.identification.relay import RelayTest, relay_findings
from contourlab.app.json_values import HIDDEN
from contourlab.errors import ParameterError, refuse
from contourlab.features.tune.drive_terms import DriveTerms, drive_terms, linuxcnc_findings
from contourlab.features.tune.objective import Evaluation, Goal, Problem, evaluate
from contourlab.features.tune.options import Tune
from contourlab.features.tune.relay import relay_tests, rule_values
from contourlab.features.tune.search import (
    FRACTIONS,
    REFINEMENTS,
    SETTLED,
    GlobalResult,
    LineRule,
    Progress,
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
from contourlab.study.space import axes_of

Candidate = tuple[float, str, Mapping[str, float]]
"""Objective, method, and values [SI]."""
WIDEST = 1000.0
"""Largest width of a range: a rule may set gains far from the start."""
Begin = Callable[[str], None]
"""Called with the name of each stage."""


class TuneSettings(Tune):
    """The options of a calibration as the study takes them."""

    json_form: ClassVar = {
        **{name: name for name in ("goal", "bounds", "rule", "method", "start")},
        "parameters": "parameter",
        **{name: name for name in ("width", "passes", "budget", "starts", "seed")},
        "executor": "pool",
    }

    def __post_init__(self) -> None:
        super().__post_init__()
        refuse(not 1.0 < self.width <= WIDEST, ParameterError, "width", f"{self.width:g}", "> 1 and <= 1000")
        refuse(not 0 <= self.seed < 2**63, ParameterError, "seed", f"{self.seed}", f"0 to {2**63 - 1}")
        refuse(not self.within < 1.0, ParameterError, "within", f"{self.within:g}", ">= 0 and < 1")
        _ = self.goal, self.bounds  # refuse what is wrong before any work

    @property
    def goal(self) -> Goal:
        """The figures to minimise."""
        return Goal.parse(self.objective)

    @property
    def bounds(self) -> Bounds:
        """The bounds to keep."""
        return replace(self.margins, limited=self.limited, command=math.inf if self.command is None else self.command)

    @property
    def rule(self) -> LineRule:
        """How a line is searched."""
        return LineRule(self.lanes, self.plateau, self.within)

    def line_rule(self, lines: int) -> LineRule:
        """Return how each of so many lines is searched; before a global search, all together take no more runs than that,
        but 8 values per line at the least."""
        fitting = self.lanes if self.method == "sequential" else self.budget // (self.passes * lines * (1 + REFINEMENTS))
        return replace(self.rule, lanes=max(min(self.lanes, fitting), min(self.lanes, 8)))

    @property
    def pool(self) -> Executor:
        """Where the work is done."""
        return super().pool


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
        Method of the result: "sequential", "global" or the rule after a relay experiment; "none" if the given controller is better, or
        nothing found keeps the bounds.
    before, after : Evaluation
        Evaluations of the given and the calibrated controller.
    start_objective : float
        Objective at the start of the search: the placed start if there is one.
    path : SearchPath
        Steps of the repair and of the sequential procedure.
    runs : int
        Total number of runs.
    relay : dict of str to RelayTest
        The relay experiment by axis, with that method.
    rules : dict of str to Evaluation
        What each rule gives.
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
    findings: tuple[Finding, ...] = field(metadata=HIDDEN)
    relay: dict[str, RelayTest] = field(default_factory=dict)
    rules: dict[str, Evaluation] = field(default_factory=dict)

    @property
    def interrupted(self) -> bool:
        """Whether Ctrl-C ended the search; the result is the best so far."""
        return self.path.interrupted


def tune(
    setting: Setting,
    settings: TuneSettings | None = None,
    *,
    pool: Workers | None = None,
    begin: Begin = lambda stage: None,
    progress: Progress = lambda done, total: None,
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
    again = not settings.parameter and settings.start == "scenario" and settings.method in ("global", "both")
    if tuned.after.violations and again and not tuned.interrupted:
        with suppress(ParameterError):
            placed = _tuned(setting, replace(settings, start="placed"), pool, begin, progress)
            if not placed.after.violations:
                return placed
    return tuned


def _tuned(setting: Setting, settings: TuneSettings, pool: Workers | None, begin: Begin, progress: Progress) -> Tuned:
    """Calibrate a controller from one start."""
    machine, controller, executor = setting.machine, setting.controller, settings.pool
    _check(machine, controller, settings)
    begin("first run")
    before = evaluate(setting, settings.bounds)
    runner = Runner(setting, threads=executor.workers, gpu=executor.gpu, pool=pool)
    if settings.start == "placed":
        begin("placing poles")
        runner.setting = replace(setting, controller=placed_start(runner, settings.goal, settings.bounds))
    start = runner.setting.controller
    relay, tests, rules = settings.method == "relay", dict[str, RelayTest](), dict[str, Evaluation]()
    space = Space.chosen(machine, start, settings.parameter, WIDEST if relay else settings.width)
    problem = Problem.of(runner, settings.goal, settings.bounds, space)
    values, guards = problem.objective.start, problem.guards
    start_objective = float(problem.objective.at(values).value[0])
    if relay:
        begin("relay experiment")
        tests, path, global_result = relay_tests(runner.setting), SearchPath(dict(values)), None
        candidates = list[Candidate]()
        for rule, exact in rule_values(runner.setting, space, tests).items():
            one = {variable.name: float(variable.written(exact[variable.name])) for variable in space.numbers}
            candidates.append((float(problem.objective.at(one).value[0]), rule, one))
            rules[rule] = evaluate(replace(setting, controller=with_values(machine, start, one)[1]), settings.bounds)
    else:
        path, global_result, candidates = _candidates(problem, settings, begin, progress)
    method, best, rejected = _chosen(problem, candidates)
    begin("checking the result")
    left: list[Finding] = []
    if not relay and (method == "global" or settings.rule.plateau != "largest"):
        best, left = _left(problem, best, settings.rule)
    best = {variable.name: float(variable.written(best[variable.name])) for variable in space.numbers}
    tuned = with_values(machine, start, best)[1]
    after = evaluate(replace(setting, controller=tuned), settings.bounds)
    inside = all(variable.nearest == variable.value for variable in space.numbers)
    if inside and not relay and not before.violations and after.worse_than(before, settings.goal.figure):
        known = parameters_of(machine, controller)
        best = {variable.name: float(getattr(*known[variable.name])) for variable in space.numbers}
        method, tuned, after, left = "none", controller, before, []
    terms = drive_terms(machine, tuned, after.run)
    runs = runner.runs + (len(FRACTIONS) if settings.start == "placed" else 0) + 2
    units = {axis.name: axis.plant.command_unit for axis in machine.axes}
    findings = [*_range_findings(space, best, guards), *(relay_findings(tests, units) if relay else rejected), *left]
    if global_result is not None and global_result.values is None:
        findings.append(finding("CL603"))
    findings += [*linuxcnc_findings(terms), *_conclusions(settings.goal, before, after), *([finding("CL610")] if path.interrupted else [])]
    return Tuned(
        tuned, space, best, method, before, after, start_objective, path, global_result, terms, runs, tuple(findings), tests, rules
    )


def _left(problem: Problem, best: Mapping[str, float], rule: LineRule) -> tuple[Mapping[str, float], list[Finding]]:
    """Put parameters back to their start, axis by axis, where all bounds hold and the objective hardly rises.

    Returns
    -------
    tuple
        The values, and a finding that names the parameters put back.
    """
    objective, guards, start = problem.objective, problem.guards, problem.objective.start
    moved = [variable for variable in problem.space.numbers if best[variable.name] != start[variable.name]]
    share = SETTLED if rule.plateau == "best" else rule.within
    reached, began = (float(objective.at(values).value[0]) for values in (best, start))
    limit, kept = min(reached * (1.0 + share), max(reached, began)), list[str]()
    owners = {variable: axes_of(variable.name, guards.machine) for variable in moved}
    for axes in dict.fromkeys(owners.values()):
        back = [variable for variable in moved if owners[variable] == axes]
        trials = {name: np.full(len(back), value) for name, value in best.items()}
        for i, variable in enumerate(back):
            trials[variable.name][i] = start[variable.name]
        rise = dict(zip(back, objective(trials).value.tolist(), strict=True))
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
    if not settings.parameter:
        known = parameters_of(machine, controller)
        order = calibration_order(machine, controller)
        if not any(getattr(*known[name]) not in (0.0, math.inf) for name in order):
            kinds = ", ".join(sorted({part.controller.kind for part in controller.axes.values()}))
            raise ParameterError("parameters", f"none: {kinds} has no nonzero parameter to calibrate", "given, each with its bounds")
    for variable in Space.chosen(machine, controller, settings.parameter, settings.width).numbers:
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


def _candidates(
    problem: Problem, settings: TuneSettings, begin: Begin, progress: Progress
) -> tuple[SearchPath, GlobalResult | None, list[Candidate]]:
    """Search with the chosen methods; return the steps, the result of the global search, and the candidates."""
    candidates: list[Candidate] = []
    placed = _placed_values(problem, settings, begin)
    begin("restoring the margins")
    path = restore_margins(problem, problem.objective.start)
    starts = [path.values]
    if settings.method != "global":
        begin("one parameter at a time")
        rule = settings.line_rule(len(problem.space.numbers))
        line = sequential(problem, path.values, rule, passes=settings.passes, progress=progress)
        path = replace(line, steps=(*path.steps, *line.steps))
        candidates.append((float(problem.objective.at(line.values).value[0]), "sequential", line.values))
        starts.append(line.values)
    if settings.method == "sequential" or path.interrupted:
        return path, None, candidates
    begin("all parameters at once")
    limits = {"starts": settings.starts, "budget": settings.budget, "seed": settings.seed}
    try:
        result = global_search(problem, [*starts, *placed], **limits, progress=progress)
    except ParameterError:  # every run fails
        if settings.method == "global":
            raise
        return path, None, candidates
    except KeyboardInterrupt:  # before its first generation
        if not candidates:
            raise
        return replace(path, interrupted=True), None, candidates
    if result.values is not None:
        candidates.append((result.objective, "global", result.values))
    return replace(path, interrupted=result.search.interrupted), result, candidates


def _placed_values(problem: Problem, settings: TuneSettings, begin: Begin) -> list[dict[str, float]]:
    """Return placed poles as a further start of the global search, within the ranges; nothing where the controller has none."""
    if settings.method != "sequential" and settings.start != "placed":
        begin("placing poles")
        runner = problem.objective.runner
        with suppress(ParameterError):
            known = parameters_of(runner.setting.machine, placed_start(runner, settings.goal, settings.bounds))
            return [{one.name: min(max(float(getattr(*known[one.name])), one.low), one.high) for one in problem.space.numbers}]
    return []


def _chosen(problem: Problem, candidates: list[Candidate]) -> tuple[str, Mapping[str, float], list[Finding]]:
    """Return method and values of the best candidate that keeps the bounds, with a finding for each better candidate that breaks one.

    If every candidate breaks a bound, return the best; its evaluation lists the broken bounds.
    """
    findings: list[Finding] = []
    ranked = sorted(candidates, key=lambda candidate: candidate[0])
    for _, method, values in ranked:
        violations = problem.objective.at(values).violations(values, problem.guards)
        if not violations:
            return method, values, findings
        findings.append(finding("CL604", method=method, bounds=violations))
    return (*ranked[0][1:], findings[1:]) if ranked else ("none", problem.objective.start, findings)
