"""One case after another: simulate, or learn from trial to trial, judge, sum up, give a verdict."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

from contourlab.analysis.learning.learning_analysis import LearningAnalysis, learning_analysis
from contourlab.analysis.linear.contour_transfer import internal_stability
from contourlab.analysis.linear.margins import Margins
from contourlab.analysis.linear.sampled_loop import AxisResponse, sampled_loop
from contourlab.components.learning.law import LearningLaw
from contourlab.errors import ComponentError, ResultError
from contourlab.features.learn import LearnedTable, LearningRun, Stopping, learn
from contourlab.features.run.cost import tick_cost
from contourlab.features.run.interval import Interval, contour_interval
from contourlab.features.run.remarks import remarks
from contourlab.features.run.verdict import Verdict, verdict
from contourlab.feed import AxisLimits, LimitReport, Reference, Route, limit_report
from contourlab.loop import Change, Controller, Machine, simulate
from contourlab.loop.switches import Switches, switches_of
from contourlab.metrics import CircleFigures, Metrics, Spike, circles_of, judge, reversal_spikes, summarise
from contourlab.result import Result

KEPT_REPORTS = 16
_REPORTS: dict[tuple[str, bytes, bytes, bytes], LimitReport] = {}
"""The latest reports by motion and limits: the schemes of a file mostly share both, and each report reads the whole motion."""


class Learning(Protocol):
    """How a case learns from trial to trial."""

    @property
    def law(self) -> LearningLaw:
        """What is learned from a trial."""

    @property
    def trials(self) -> int:
        """Largest number of trials after the first."""

    @property
    def improvement(self) -> float:
        """Part of the error that `patience` trials have to take off, for learning to go on."""

    @property
    def patience(self) -> int:
        """Number of those trials."""

    @property
    def table(self) -> Path | None:
        """A learned table to start with."""


class Case(Protocol):
    """What a case is: a machine under a controller along a reference, and what it is held against."""

    @property
    def name(self) -> str:
        """Name of the scheme."""

    @property
    def machine(self) -> Machine:
        """The machine."""

    @property
    def controller(self) -> Controller:
        """Its controller."""

    @property
    def changes(self) -> tuple[Change, ...]:
        """Controllers that take over on the way."""

    @property
    def moving(self) -> bool:
        """Whether the axes have the velocity of the reference at the first sample."""

    @property
    def curvature_step(self) -> float:
        """By how much of its limit the acceleration of an axis may step where the curvature jumps."""

    @property
    def tolerance(self) -> float | None:
        """Largest part error that passes [m]; None for no verdict."""

    @property
    def seed(self) -> int:
        """Of all noise."""

    @property
    def signals(self) -> tuple[str, ...]:
        """Signals to write; empty for all."""

    @property
    def lines(self) -> tuple[str, ...]:
        """Source text of the program; empty for a contour."""

    @property
    def notes(self) -> tuple[str, ...]:
        """What is to be known of the motion, such as that it was scaled."""

    @property
    def limits(self) -> AxisLimits:
        """Limits of the axes that the motion was planned with."""

    @property
    def learning(self) -> Learning | None:
        """How it learns from trial to trial; None where it is driven once."""

    def route(self) -> Route | None:
        """The path with its feedrates; None where the motion was not planned."""

    def reference(self, feed_scale: float = 1.0) -> Reference:
        """Return the sampled reference, at a part of the programmed feed."""

    def closer(self, tolerance: float) -> Mapping[str, Callable[[], Reference]]:
        """Return ways, in words, of planning closer to the programmed path, such as within a tolerance [m]."""


@dataclass(frozen=True, eq=False)
class AxisBode:
    """Closed loop and margins of one axis, sampled as it runs."""

    response: AxisResponse
    margins: Margins


@dataclass(frozen=True, eq=False)
class Outcome:
    """A judged case: of a case that learns, its best trial.

    `limits` is None where the motion was not planned within limits, `learning` where nothing was learned. `foretold` is what an
    analysis said of learning beforehand, `unstable` what it says of an unstable coupling; `tick` [s] is what a tick of the servo loop
    costs, where it was asked for. `switches` is None where no axis has several controllers, `interval`
    where the deviations of the machine's numbers were not asked for.
    """

    name: str
    case: Case
    reference: Reference
    result: Result
    metrics: Metrics
    verdict: Verdict | None
    circles: tuple[CircleFigures, ...]
    spikes: tuple[Spike, ...]
    bode: dict[str, AxisBode]
    limits: LimitReport | None
    learning: LearningRun | None = None
    foretold: LearningAnalysis | None = None
    tick: float | None = None
    unstable: str = ""
    switches: Switches | None = None
    interval: Interval | None = None

    def loop_meant(self, axis: str) -> str:
        """Say which loop of an axis a linear analysis is of; nothing where it has just one."""
        several = self.case.controller.axes[axis].supervisor is not None
        contact = self.case.machine.axis(axis).plant.two_sided
        return ", ".join(["first controller"] * several + ["in contact"] * contact)

    @property
    def warnings(self) -> tuple[str, ...]:
        """What analysis warns of: an unstable coupling, and learning that grows."""
        asked = remarks(self.case.machine, self.case.controller, self.reference, self.case.changes)
        return (*filter(None, (self.unstable,)), *(one.text for one in asked), *(() if self.foretold is None else self.foretold.warnings))


def run_case(
    case: Case,
    *,
    explain: bool = True,
    progress: Callable[[int, int], None] | None = None,
    stage: Callable[[str], None] | None = None,
    costs: bool = False,
    foretell: bool = False,
    interval: bool | None = False,
) -> Outcome:
    """Run one case and judge it.

    Parameters
    ----------
    case : Case
    explain : bool
        Whether causes and advice of a failed verdict are worked out; a passed one needs none.
    progress : callable, optional
        Told samples done and samples in all, while simulating.
    stage : callable, optional
        Told in words what is begun: planning, simulating or learning, judging, and looking for the causes of a verdict that failed. What
        was learned belongs to the machine as it is, so that the causes of a case that learns are not looked for.
    costs : bool
        Whether the servo tick is timed.
    foretell : bool
        Whether an analysis says beforehand how learning will go.
    interval : bool or None
        Whether machines are drawn from the stated deviations, for the interval of the contour error; None where it does not take long.

    Raises
    ------
    DivergenceError
        If the loop runs away.
    """
    begin = stage or (lambda words: None)
    begin(f"planning {case.name}")
    reference = case.reference()

    def told(done: int) -> None:
        if progress is not None:
            progress(done, reference.n_sample * (1 if case.learning is None else case.learning.trials + 1))

    expected = learned = None
    if case.learning is not None and foretell:
        begin(f"analysing how {case.name} learns")
        expected = _foretold(case, case.learning)
    if case.learning is not None:
        begin(f"learning, {case.name}")
        learned = _learned(case, case.learning, reference, told)
    begin(f"simulating {case.name}" + ("" if learned is None else f", trial {learned.best}"))
    result = _simulated(case, reference, learned, told)
    begin(f"judging {case.name}")
    judged = judge(result, reference)
    figures = summarise(judged, reference)
    explain = explain and case.tolerance is not None and figures.part_error.max > case.tolerance and learned is None
    if explain:
        begin(f"looking for the causes of the error of {case.name}")
    spread = None if interval is False else _interval(case, reference, learned, begin, progress, bool(interval))
    return Outcome(
        name=case.name,
        case=case,
        reference=reference,
        result=judged,
        metrics=figures,
        verdict=_verdict(case, reference, judged, explain),
        circles=circles_of(judged, reference),
        spikes=reversal_spikes(judged, (max(figures.window[0] - 5, 0), figures.window[1]), reference=reference),
        bode=bode_of(case.machine, case.controller),
        limits=limits_of(case, reference),
        learning=learned,
        foretold=expected,
        tick=tick_cost(case.machine, case.controller, reference) if costs else None,
        unstable=_unstable(case) if costs or foretell else "",
        switches=switches_of(judged, case.controller, reference, case.changes),
        interval=spread,
    )


def _interval(
    case: Case,
    reference: Reference,
    learned: LearningRun | None,
    begin: Callable[[str], None],
    progress: Callable[[int, int], None] | None,
    patient: bool,
) -> Interval:
    """Return what the stated deviations make of the contour error of a case."""
    begin(f"drawing machines from the deviations, {case.name}")
    given: dict[str, Any] = {"seed": case.seed, "tolerance": case.tolerance, "moving": case.moving, "changes": case.changes}
    table = None if learned is None else learned.table.learned
    return contour_interval(case.machine, case.controller, reference, **given, learned=table, progress=progress, patient=patient)


def _unstable(case: Case) -> str:
    """Return in words that the coupling is unstable; empty where it is not, where there is none, or none that is linear."""
    if case.controller.coupling is None:
        return ""
    try:
        found = internal_stability(case.machine, case.controller)
    except ComponentError:
        return ""
    return "" if found.stable else found.verdict


def _simulated(case: Case, reference: Reference, learned: LearningRun | None, told: Callable[[int], None]) -> Result:
    """Run a case with what was learned, as its best trial ran."""
    table, trial = (None, 0) if learned is None else (learned.table.learned, learned.best)
    given: dict[str, Any] = {"scheme": case.name, "seed": case.seed, "learned": table, "trial": trial}
    given |= {"moving": case.moving, "changes": case.changes}
    return simulate(case.machine, case.controller, reference, **given, progress=told if learned is None else None)


def _verdict(case: Case, reference: Reference, judged: Result, explain: bool) -> Verdict | None:
    if case.tolerance is None:
        return None
    given: dict[str, Any] = {"lines": case.lines, "slower": case.reference, "closer": case.closer, "explain": explain, "seed": case.seed}
    return verdict(case.machine, case.controller, reference, judged, case.tolerance, **given)


def _start(case: Case, file: Path, reference: Reference) -> LearnedTable:
    """Return the learned table of a file, which has to belong to the case."""
    table = LearnedTable.load(file)
    try:
        table.check(case.machine, case.controller, reference)
    except ResultError as error:
        raise ResultError(f"{file}: {error}") from error
    return table


def _foretold(case: Case, learning: Learning) -> LearningAnalysis | None:
    """Return what an analysis says of learning, before it begins; None where there is no linear model to analyse."""
    try:
        return learning_analysis(case.machine, case.controller, learning.law)
    except ComponentError:
        return None


def _learned(case: Case, learning: Learning, reference: Reference, told: Callable[[int], None]) -> LearningRun:
    """Run the trials of a case; the first one starts with the table that the case names."""
    stopping = Stopping(improvement=learning.improvement, patience=learning.patience)
    start = None if learning.table is None else _start(case, learning.table, reference)
    return learn(
        case.machine,
        case.controller,
        reference,
        learning.law,
        trials=learning.trials,
        seed=case.seed,
        start=start,
        stopping=stopping,
        progress=told,
    )


def limits_of(case: Case, reference: Reference) -> LimitReport | None:
    """Hold the reference of a case against the limits of its axes; None where it was not planned within them."""
    if case.route() is None:
        return None
    limits = case.limits
    key = (reference.digest, limits.velocity.tobytes(), limits.acceleration.tobytes(), limits.jerk.tobytes())
    if key not in _REPORTS:
        while len(_REPORTS) >= KEPT_REPORTS:
            del _REPORTS[next(iter(_REPORTS))]
        _REPORTS[key] = limit_report(reference, limits)
    return _REPORTS[key]


def bode_of(machine: Machine, controller: Controller) -> dict[str, AxisBode]:
    """Return the closed loop of each axis whose components are linear but for friction, counts and limits."""
    found = {}
    for axis in machine.axes:
        try:
            loop = sampled_loop(axis, controller.axes[axis.name], machine.servo_period, machine.carried_mass(axis.name))
        except ComponentError:
            continue
        found[axis.name] = AxisBode(loop.response(loop.frequencies()), loop.margins())
    return found
