"""The run over trials, and its stopping rule: simulate, judge and learn until learning converges, diverges or has used all trials."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, fields, replace
from itertools import pairwise
from typing import Any, ClassVar, Literal

import numpy as np

from contourlab.analysis.linear.margins import doubling
from contourlab.app.json_values import HIDDEN
from contourlab.arrays import Array
from contourlab.components.feedforward.laws import InverseDynamics
from contourlab.components.learning.law import BasisFunctions, LearningLaw, LearningProblem
from contourlab.errors import ParameterError, ResultError, refuse
from contourlab.features.learn.split import Growth, Memory, Split, growth_of
from contourlab.features.learn.table import LearnedTable
from contourlab.features.learn.trial import TrialFigures, figures_of, learning_problem, part_error, record_of
from contourlab.feed import Reference
from contourlab.findings import Finding, finding
from contourlab.geometry.view import PathView
from contourlab.loop import Controller, Machine
from contourlab.loop.trials import Trial, Trials, feedforward_command
from contourlab.rendering.data import TrialCourse
from contourlab.scenario.build import parameters_of
from contourlab.thinning import keep_extremes

Part = Literal["ends", "all", "none"]
EXPLAINED_GAIN = 0.05
"""Largest improvement that chance can explain, even if the trials differ widely."""
RESOLUTION = 1e-12
"""Errors [m] below this differ only by rounding."""
DRAWN = 1000
"""Most points of the drawn error of a trial."""


@dataclass(frozen=True)
class Stopping:
    """When to stop, judged by the contour rms; with one axis, by the tracking rms.

    Learning does not count as diverged while the tracking error falls or the trials differ less and less.

    Attributes
    ----------
    improvement : float, 0 to 1
        Converged if `patience` trials improve neither the best contour error nor the best tracking error by more than this share, and the
        error does not rise steadily; 0 continues to the last trial.
    patience : int, >= 2
    explained : bool
        Whether learning has also converged if chance explains the change of the errors over the last `patience` trials.
    divergence : float, > 1
        Diverged if the last two trials are worse than the best by more than this factor.
    growth : int, >= 2
        Diverged also if each of this many trials is worse than the one before, and the last is worse than the best by `growth_margin`.
    growth_margin : float, > 0
        As a share of the best.

    Raises
    ------
    ParameterError
        If a number is out of range.
    """

    improvement: float = 0.01
    patience: int = 10
    explained: bool = True
    divergence: float = 2.0
    growth: int = 5
    growth_margin: float = 0.05

    def __post_init__(self) -> None:
        for name, low, high, words in (
            ("improvement", 0.0, 1.0, "from 0 to 1"),
            ("patience", 2, math.inf, "2 or more"),
            ("divergence", math.nextafter(1.0, 2.0), math.inf, "> 1"),
            ("growth", 2, math.inf, "2 or more"),
            ("growth_margin", math.nextafter(0.0, 1.0), math.inf, "> 0"),
        ):
            if not low <= getattr(self, name) <= high:
                raise ParameterError(name, f"{getattr(self, name):g}", words)


@dataclass(frozen=True)
class Stop:
    """How learning ended (converged, diverged or interrupted), and why."""

    status: str
    finding: Finding


def best_of(figures: list[TrialFigures]) -> int:
    """Return the number of the best trial: the first of equal ones, 0 if all stopped early."""
    merits = [math.inf if math.isnan(trial.merit) else trial.merit for trial in figures]
    return merits.index(min(merits))


def verdict(figures: list[TrialFigures], stopping: Stopping, explained: bool) -> Stop | None:
    """Return why learning stops after these trials, or None if it continues.

    Parameters
    ----------
    figures : list of TrialFigures
        Figures of all trials so far.
    explained : bool
        Whether chance explains the latest change of the errors.
    """
    last = figures[-1]
    if last.failed:
        return Stop("diverged", finding("CL303", trial=last.trial, reason=last.failed))
    merits = [max(trial.merit, RESOLUTION) for trial in figures]
    grows = _grows(figures, merits, stopping)
    if grows is not None or stopping.improvement == 0.0 or len(figures) <= stopping.patience:
        return grows
    tracking = [max(trial.tracking, RESOLUTION) for trial in figures]
    before = [min(errors[: -stopping.patience]) for errors in (merits, tracking)]
    latest = [min(errors[-stopping.patience :]) for errors in (merits, tracking)]
    gain = max(max(old - new, 0.0) / old for old, new in zip(before, latest, strict=True))
    if gain <= stopping.improvement:
        return _settled(figures, merits, stopping, explained)
    if stopping.explained and explained and gain <= EXPLAINED_GAIN:
        return Stop("converged", finding("CL302", trials=stopping.patience))
    return None


def _settled(figures: list[TrialFigures], merits: list[float], stopping: Stopping, explained: bool) -> Stop | None:
    """Return how learning ends when neither error falls any more; None if more trials are needed to decide."""
    best = merits.index(min(merits))
    risen = merits[-1] / merits[best] - 1.0
    values: dict[str, Any] = {"trials": stopping.patience, "best": best, "above": risen}
    if explained:
        return Stop("converged", finding("CL302", **values))
    beyond = risen > stopping.growth_margin
    if beyond and (best == 0 or _swells(figures, stopping)):
        return Stop("diverged", finding("CL306", **values))
    if not beyond and _rises(merits, stopping) and _swells(figures, stopping):
        return None
    return Stop("converged", finding("CL301", **values))


def _grows(figures: list[TrialFigures], merits: list[float], stopping: Stopping) -> Stop | None:
    last, best = figures[-1], min(merits)
    # While tracking improves, the contour error may rise for some trials, because one axis learns faster than another.
    # Trials that differ less and less approach a limit, even if an earlier trial was better.
    if last.tracking <= min(trial.tracking for trial in figures) or not _swells(figures, stopping):
        return None
    # One bad trial may be chance, for example an axis that stuck once; two are not.
    if len(merits) > 1 and min(merits[-2:]) > stopping.divergence * best:
        return Stop("diverged", finding("CL304", trial=last.trial, factor=merits[-1] / best))
    if _rises(merits, stopping) and merits[-1] > (1.0 + stopping.growth_margin) * best:
        return Stop("diverged", finding("CL305", trials=stopping.growth))
    return None


def _rises(merits: list[float], stopping: Stopping) -> bool:
    """Return whether each of the last trials was worse than the one before."""
    run = merits[-stopping.growth - 1 :]
    return len(run) > stopping.growth and all(b > a for a, b in pairwise(run))


def _swells(figures: list[TrialFigures], stopping: Stopping) -> bool:
    """Return whether the change from trial to trial has not fallen over the last trials."""
    changes = [trial.change for trial in figures[1:]][-stopping.growth :]
    return len(changes) < 2 or changes[-1] >= min(changes[0], changes[-2])


@dataclass(frozen=True, eq=False)
class LearningRun:
    """The result of learning.

    Attributes
    ----------
    status : str
        ``"converged"``, ``"trials used up"``, ``"diverged, rolled back to trial k"``, ``"diverged, no trial came to its end"``, or
        ``"interrupted, trial k kept"`` after Ctrl-C.
    findings : tuple of Finding
        Why learning ended, saturation, and where the error grew.
    trials : tuple of TrialFigures
    best : int
        The trial with the smallest error.
    table : LearnedTable
        The table that the best trial used.
    split : Split or None
        Repeatable and non-repeatable parts over the last trials; None with fewer than four.
    growth : Growth or None
        Band in which the error grew; only if learning diverged.
    drawn : tuple of (ndarray (n,) [s], ndarray (n,) [m])
        Times and contour errors of each trial, thinned.
    seconds, engine_seconds, judge_seconds : float [s]
        Computing time in all, of the machine runs, and of the judge.
    """

    json_derived: ClassVar = ("reason", "gain")

    status: str
    findings: tuple[Finding, ...] = field(metadata=HIDDEN)
    trials: tuple[TrialFigures, ...]
    best: int = field(metadata={"json": "best_trial"})
    table: LearnedTable = field(metadata=HIDDEN)
    split: Split | None
    growth: Growth | None = field(metadata=HIDDEN)
    drawn: tuple[tuple[Array, Array], ...] = field(metadata=HIDDEN)
    seconds: float = field(default=0.0, metadata=HIDDEN)
    engine_seconds: float = field(default=0.0, metadata=HIDDEN)
    judge_seconds: float = field(default=0.0, metadata=HIDDEN)

    @property
    def reason(self) -> str:
        """The findings, as one text."""
        return " ".join(finding.text for finding in self.findings)

    @property
    def diverged(self) -> bool:
        """Whether learning diverged."""
        return self.status.startswith("diverged")

    @property
    def course(self) -> TrialCourse:
        """The errors of the trials, for tables and pictures."""
        contour, tracking = (np.array([getattr(trial, name) for trial in self.trials]) for name in ("contour_rms", "tracking_rms"))
        return TrialCourse(contour, tracking, self.best, self.status, self.drawn)

    @property
    def gain(self) -> float:
        """Error of the first trial divided by that of the best; NaN if the first stopped early."""
        first, best = self.trials[0].merit, self.trials[self.best].merit
        return float("inf") if best == 0.0 else first / best


@dataclass(eq=False)
class _Course:
    """State of learning while the trials run; `kept` has table and tool positions of the first and of the best trial."""

    runner: Trials
    law: LearningLaw
    part: Part
    memory: Memory
    figures: list[TrialFigures] = field(default_factory=list)
    kept: dict[int, tuple[Array, Array]] = field(default_factory=dict)
    drawn: list[tuple[Array, Array]] = field(default_factory=list)

    def note(self, run: Trial, i: int, table: Array) -> None:
        """Add a trial."""
        figures = figures_of(i, run, self.runner)
        if run.status.ok and self.part == "all" and math.isnan(figures.part_max):
            figures = replace(figures, part_max=part_error(run.tool, self.runner))
        self.figures.append(figures)
        at = keep_extremes(run.contour_error, DRAWN)
        self.drawn.append((self.runner.machine.servo_period * at.astype(float), run.contour_error[at]))
        if i == 0 or (run.status.ok and best_of(self.figures) == i):
            now = (table, run.tool)
            self.kept = {0: self.kept.get(0, now), i: now}

    def ended(self, stop: Stop, problem: LearningProblem, began: float) -> LearningRun:
        """Return the result."""
        runner, figures, best = self.runner, self.figures, best_of(self.figures)
        learned, _ = self.kept[best]
        if self.part == "ends":
            for i in {0, best}:
                if not figures[i].failed and math.isnan(figures[i].part_max):
                    figures[i] = replace(figures[i], part_max=part_error(self.kept[i][1], runner))
        status, growth, findings = stop.status, None, [stop.finding]
        if figures[-1].saturated:
            findings.append(finding("CL307", samples=figures[-1].saturated))
        if status == "diverged":
            status += ", no trial came to its end" if figures[best].failed else f", rolled back to trial {best}"
            growth = growth_of(self.memory.tracking, runner.machine.servo_period, runner.machine.axis_names)
        elif status == "interrupted":
            status += f", trial {best} kept"
        if growth is not None:
            band = {"low": growth.low, "high": growth.high, "peak": growth.peak, "growth": growth.factor - 1.0}
            findings.append(finding("CL309", place=f"axis {growth.axis}", doubling=doubling(growth.factor), **band))
        if isinstance(self.law, BasisFunctions) and self.law.target == "command":
            findings += _feedforwards(self.law.gains(learned, problem), runner.machine, runner.controller)
        names = [part.name for part in fields(TrialFigures) if part.name not in ("trial", "failed")]
        columns = {name: np.array([getattr(trial, name) for trial in figures], dtype=float) for name in names}
        table = LearnedTable.of(learned.copy(), runner.machine, runner.controller, runner.reference, self.law, columns)
        times = (time.perf_counter() - began, runner.engine_seconds, runner.judge_seconds)
        split = self.memory.split(self.law, problem)
        return LearningRun(status, tuple(findings), tuple(figures), best, table, split, growth, tuple(self.drawn), *times)


def learn(
    machine: Machine,
    controller: Controller,
    reference: Reference,
    law: LearningLaw,
    *,
    trials: int = 30,
    seed: int = 0,
    start: LearnedTable | None = None,
    stopping: Stopping | None = None,
    part: Part = "ends",
    jit: bool | None = None,
    view: PathView | None = None,
    progress: Callable[[int], None] | None = None,
    on_trial: Callable[[TrialFigures], None] | None = None,
) -> LearningRun:
    """Repeat a motion and learn from trial to trial.

    Parameters
    ----------
    machine : Machine
    controller : Controller
    reference : Reference
    law : LearningLaw
    trials : int, >= 0
        Largest number of trials after the first.
    seed : int
        Seed of all noise, which differs from trial to trial.
    start : LearnedTable, optional
        Table of the first trial; none by default.
    stopping : Stopping, optional
    part : {"ends", "all", "none"}
        Trials to compute the distance to the programmed path for: the first and the best, all, or none.
    jit : bool, optional
        Compiled, or plain Python.
    view : PathView, optional
        View of the path for the estimator.
    progress : callable, optional
        Called with the total number of samples done.
    on_trial : callable, optional
        Called with the figures of each trial.

    Returns
    -------
    LearningRun

    Raises
    ------
    ParameterError
        If the number of trials is negative, a controller has no port for the learned signal, or the law reaches further than a trial.
    ResultError
        If the given table belongs to another program, machine or controller, or has another target than the law.
    ComponentError
        If the law needs a linear model and there is none.
    """
    refuse(trials < 0, ParameterError, "trials", f"{trials}", "0 or more")
    if start is not None:
        start.check(machine, controller, reference)
        if start.target != law.target:
            raise ResultError(f'the learned table is for the {start.target}: set target = "{start.target}" in the law, not "{law.target}"')
    # A law that reaches further than a trial would learn almost nothing and converge at once.
    reach, n, period = law.values(), reference.n_sample, reference.servo_period
    if 2.0 * reach.get("half_width", 0.0) >= n:
        raise ParameterError("half_width", f"{reach['half_width']:g}", f"less than half of the {n} samples of a trial")
    if reach.get("lead", 0.0) >= n * period:
        raise ParameterError("lead", f"{reach['lead']:g} s", f"less than the {n * period:.4g} s that a trial takes")
    began = time.perf_counter()
    settings = stopping or Stopping()
    given = {"target": law.target, "vector": law.needs_contour_error, "seed": seed, "jit": jit, "view": view}
    runner = Trials(machine, controller, reference, **given)  # type: ignore[arg-type]
    problem = learning_problem(machine, controller, reference, law.target, runner.arc_length)
    beforehand = feedforward_command(machine, controller, reference, jit=jit)
    nothing = np.zeros((reference.n_sample, reference.n_axis))
    course = _Course(runner, law, part, Memory(settings.patience))

    def run_all(table: Array) -> Stop:
        for i in range(trials + 1):
            run = runner.run(table, i, None if progress is None else lambda done: progress(i * reference.n_sample + done))  # noqa: B023
            record = record_of(run, runner, table if law.target == "command" else nothing, beforehand)
            course.note(run, i, table)
            if run.status.ok:
                course.figures[-1] = replace(course.figures[-1], change=course.memory.change(record.tracking_error, runner.judged))
                course.memory.add(record.feedback_command, record.tracking_error, run.contour_error)
            if on_trial is not None:
                on_trial(course.figures[-1])
            stop = verdict(course.figures, settings, settings.explained and course.memory.explained())
            if stop is not None:
                return stop
            if i < trials:
                table = law.update(table, record, problem)
        return Stop("trials used up", finding("CL300", trials=trials))

    try:
        stop = run_all(nothing if start is None else start.values)
    except KeyboardInterrupt:
        if not course.kept:
            raise
        stop = Stop("interrupted", finding("CL308", trial=len(course.figures) - 1))
    return course.ended(stop, problem, began)


def _feedforwards(gains: list[dict[str, float]], machine: Machine, controller: Controller) -> Iterator[Finding]:
    """Yield the learned gains of each axis as its feedforward, with those that it has already."""
    for axis, learned in zip(machine.axes, gains, strict=True):
        units = parameters_of(InverseDynamics, (axis.plant.command_unit, axis.plant.force_unit))
        present = controller.axes[axis.name].feedforward
        if isinstance(present, InverseDynamics):
            learned = {name: value + (present.values()[name] if name in present.unbounded else 0.0) for name, value in learned.items()}
        shown = "".join(f', {name} = "{value:.4g} {units[name].unit}"' for name, value in learned.items())
        yield finding("CL316", place=f"axis {axis.name}", feedforward=f'{{kind = "{InverseDynamics.kind}"{shown}}}')
