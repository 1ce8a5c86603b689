"""One case: simulate, or learn from trial to trial; judge; sum up; give a verdict. Its outcome, as in summary.json."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from functools import partial
from time import perf_counter
from typing import Any, ClassVar

import numpy as np

from contourlab.analysis.learning.learning_analysis import LearningAnalysis, learning_analysis
from contourlab.analysis.linear.contour_transfer import internal_stability
from contourlab.analysis.linear.margins import Margins
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.arrays import Array
from contourlab.components.supervisor.switching import PreRouted
from contourlab.engine.runner import make_group
from contourlab.errors import ComponentError, ResultError
from contourlab.features.check.program_check import PathModes, about_machine
from contourlab.features.learn import LearnedTable, LearningRun, Stopping, learn
from contourlab.features.run.causes import Place
from contourlab.features.run.lost_steps import lost_steps
from contourlab.features.run.record import simulate_stored
from contourlab.features.run.trust import about_guesses, part_interval
from contourlab.features.run.verdict import verdict
from contourlab.feed import LimitReport, Reference, limit_report
from contourlab.feed.planner import NEAR_FEED
from contourlab.feed.verify import KINDS, Worst
from contourlab.findings import Finding, finding
from contourlab.loop import Controller, Machine
from contourlab.loop.feeding import Feed
from contourlab.loop.simulate import diverged, sampler
from contourlab.loop.switches import Switch, switches_of
from contourlab.loop.template import build
from contourlab.metrics.circles import Bidirectional, circles_of, pairs
from contourlab.metrics.figures import judged_part, range_of, summarise
from contourlab.metrics.judge import check_follows, judge
from contourlab.metrics.reversals import Spike, reversal_spikes
from contourlab.rendering.data import ClosedLoop, JudgedRun
from contourlab.rendering.judgement import Trust
from contourlab.rendering.origins import numbers_of, stated
from contourlab.rendering.page_tables import nearest
from contourlab.rendering.stages import Stages
from contourlab.result import Result
from contourlab.scenario import Case, PartProgram
from contourlab.study import Setting

KEPT_REPORTS = 16
_REPORTS: dict[tuple[str, bytes, bytes, bytes], LimitReport] = {}
"""The latest reports by motion and limits: schemes of a file mostly share both, and a report reads the whole motion."""
TICKS, SECONDS, FEWEST = 20_000, 0.3, 7
"""For the cost of a tick: most ticks of a run, total time of the runs, fewest runs."""
GAP_POINTS = 201
"""Places at which a picture evaluates the free travel of an axis."""


LISTED = 100
"""Switches that are listed one by one."""


@dataclass(frozen=True)
class SwitchCount:
    """Switches of one kind: controllers before and after, reason, and how many."""

    before: str = field(metadata={"json": "from"})
    after: str = field(metadata={"json": "to"})
    reason: str
    count: int


@dataclass(frozen=True)
class AxisSwitches:
    """The switches of one axis.

    Attributes
    ----------
    count : int
    first : str
        The controller that was active at the start.
    active : mapping of str to float [s]
        Time for which each controller was active.
    kinds : tuple of SwitchCount
        The most frequent first.
    """

    count: int
    first: str
    active: Mapping[str, float]
    kinds: tuple[SwitchCount, ...]


@dataclass(frozen=True)
class SwitchSummary:
    """Switches between the controllers of an axis.

    Attributes
    ----------
    axes : mapping of str to AxisSwitches
    listed : tuple of Switch
        The first 100.
    left_out : int
        Switches that are not listed; ``switches/NAME.csv`` has them all.
    """

    axes: Mapping[str, AxisSwitches]
    listed: tuple[Switch, ...]
    left_out: int


@dataclass(frozen=True)
class NearestLimit:
    """The axis nearest to its limit, or furthest beyond.

    Attributes
    ----------
    value, limit : float [m/s, m/s^2 or m/s^3]
        The limit is null if there is none.
    ratio : float
        Value over limit, without what rounding explains; above 1 the limit is violated.
    time : float [s]
    line : int
        Program line; 0 for none.
    """

    json_form: ClassVar = (
        {"axis": "axis"} | {name: f"worst.{name}" for name in ("value", "limit", "ratio", "time")} | {"line": "worst.source_line"}
    )

    axis: str
    worst: Worst


@dataclass(frozen=True)
class LimitSummary:
    """The planned motion against the limits of the axes, checked from its samples alone; null for a kind that does not occur.

    Attributes
    ----------
    curvature_step : NearestLimit or None
        Steps of acceleration where the curvature jumps; `jerk` leaves them out.
    kink : NearestLimit or None
        Steps of velocity where the direction jumps slightly.
    """

    velocity: NearestLimit | None
    acceleration: NearestLimit | None
    jerk: NearestLimit | None
    curvature_step: NearestLimit | None
    kink: NearestLimit | None


@dataclass(frozen=True, eq=False, kw_only=True)
class Outcome(JudgedRun):
    """A judged case; of a case that learns, its best trial.

    Listed are the keys of its JSON, see `json_form`; its Python attributes are those of `JudgedRun`.

    Attributes
    ----------
    machine : str
    servo_period : float [s]
    path_digest : str
        Hash of the planned path's geometry.
    verdict : Verdict or None
        Null without a tolerance.
    circles : tuple of CircleFigures
        Each full circle of the path, with the figures of ISO 230-4.
    circles_both_ways : mapping of str to Bidirectional
        Circles that run in both directions.
    switches : SwitchSummary or None
        Null if no axis has several controllers.
    margins : mapping of str to Margins
        Of the sampled loop of each axis; all but `stable` are null if it is unstable.
    limits : LimitSummary or None
        The planned motion against the limits of the axes, checked from its samples alone: velocity, acceleration (without kinks), jerk
        (without curvature steps), curvature_step (of the acceleration, where the curvature jumps) and kink (of the velocity, where the
        direction jumps slightly); null for a kind that does not occur. Null under the uniform law.
    learning : LearningRun or None
        All other figures are those of its best trial.
    warnings : tuple of str
        Texts of the findings of severity "warning".
    tick : float or None [s]
        Time that one servo tick takes to compute, under `compare`.
    trust : Trust or None
        Sources of the numbers, and the interval of the part error, where asked for.
    """

    json_form: ClassVar = {
        "machine": "case.machine.name",
        "axes": "result.axes",
        "servo_period": "result.servo_period",
        "seed": "case.run.seed",
        "n_sample": "result.n_sample",
        "path_digest": "path_digest",
        "status": "result.status",
        "metrics": "metrics",
        "verdict": "verdict",
        "circles": "circles",
        "circles_both_ways": "circles_both_ways",
        "reversals": "spikes",
        "reversal_figures": "reversal_figures",
        "switches": "switch_summary",
        "margins": "margins",
        "limits": "limit_summary",
        "learning": "learning",
        "warnings": "warnings",
        "findings": "findings",
        "tick": "tick",
        "trust": "trust",
    }

    case: Case
    learning: LearningRun | None

    @property
    def circles_both_ways(self) -> dict[str, Bidirectional]:
        """Circles that run in both directions."""
        return pairs(self.circles)

    @property
    def margins(self) -> dict[str, Margins]:
        """Margins of the sampled loop of each axis."""
        return {axis: loop.margins for axis, loop in self.bode.items()}

    @property
    def switch_summary(self) -> SwitchSummary | None:
        """How often and why controllers were switched."""
        if self.switches is None:
            return None
        switches, kinds = self.switches, self.switches.counts().items()
        axes = {}
        for axis, held in switches.active.items():
            counts = tuple(SwitchCount(kind.before, kind.after, kind.reason, count) for kind, count in kinds if kind.axis == axis)
            active = {name: samples * switches.servo_period for name, samples in held.items()}
            axes[axis] = AxisSwitches(sum(kind.count for kind in counts), switches.first[axis], active, counts)
        return SwitchSummary(axes, tuple(switches.rows(LISTED)), max(len(switches) - LISTED, 0))

    @property
    def limit_summary(self) -> LimitSummary | None:
        """The axis nearest to each kind of limit."""
        if self.limits is None:
            return None
        worsts = [nearest(entries) for entries in self.limits.kinds]  # in the order of its fields
        return LimitSummary(*(None if worst is None else NearestLimit(self.result.axes[worst.axis], worst) for worst in worsts))

    @property
    def warnings(self) -> tuple[str, ...]:
        """Texts of the findings of severity "warning"."""
        return tuple(finding.text for finding in self.findings if finding.entry.severity == "warning")


def run_case(
    case: Case,
    stages: Stages | None = None,
    *,
    explain: bool = True,
    costs: bool = False,
    foretell: bool = False,
    interval: bool | None = False,
) -> Outcome:
    """Run one case and judge it.

    Parameters
    ----------
    case : Case
    stages : Stages, optional
        Where to show the work.
    explain : bool
        Whether to find causes, and advice where the verdict fails. A case that learns gets none: what it learned belongs to its machine;
        nor does one that changes controllers on the way.
    costs : bool
        Whether to time the servo tick.
    foretell : bool
        Whether to analyse learning and coupling beforehand.
    interval : bool or None
        Whether to draw machines from the stated deviations, for the interval of the part error; None does too.

    Raises
    ------
    DivergenceError
        If the loop diverges.
    OutputError
        With the first samples, if all signals do not fit into the space that is free for temporary files.
    """
    shown, machine, controller = stages or Stages(), case.machine, case.controller
    begin, numbers = shown.begin, numbers_of(machine, controller)
    begin(f"planning {case.name}")
    reference = case.reference()

    def report_progress(done: int) -> None:
        shown.advance(done, reference.n_sample * (1 if case.learning is None else case.learning.trials + 1))

    foretold = learned = None
    if case.learning is not None:
        if foretell:
            begin(f"analysing how {case.name} learns")
            with suppress(ComponentError):  # no linear model
                foretold = learning_analysis(machine, controller, case.learning.law)
        begin(f"learning, {case.name}")
        learned = _learned(case, reference, report_progress)
    begin(f"simulating {case.name}" + ("" if learned is None else f", trial {learned.best}"))
    noise: dict[str, Any] = {"seed": case.run.seed, "moving": case.moving}
    given: dict[str, Any] = {"learned": None if learned is None else learned.table.learned, "changes": case.changes}
    given |= {"progress": report_progress} if learned is None else {"trial": learned.best}
    result = simulate_stored(machine, controller, reference, scheme=case.name, **noise, **given)
    if not result.status.ok:
        raise diverged(result, [lost.text for lost in lost_steps(machine, reference, result)])
    reference = result.motion or reference  # where the loop decides the progress, what it has followed
    begin(f"judging {case.name}")
    judged = judge(result, reference)
    check_follows(judged)
    figures = summarise(judged, reference)
    answer = sampled = None
    if case.tolerance is not None:
        explain = explain and learned is None and not case.changes
        if explain:
            begin(f"looking for the causes of the error of {case.name}")
        ways: dict[str, Any] = {"slower": case.reference, "closer": case.closer, "rerun": partial(simulate_stored, **noise)}
        answer = verdict(machine, controller, reference, judged, case.tolerance, lines=case.lines, explain=explain, **ways)
    if interval is not False:
        if any(number.drawn for number in numbers):
            begin(f"drawing machines from the deviations, {case.name}")
        setting = Setting(machine, controller, reference, **noise)
        sampled = part_interval(setting, tolerance=case.tolerance, changes=case.changes, learned=given["learned"], progress=shown.advance)
    begin(f"checking limits and margins of {case.name}")
    bode = bode_of(machine, controller)
    findings = [*_remarks(case, reference, foretold, costs or foretell)]
    findings += [finding("CL205", place=f"axis {axis}") for axis, loop in bode.items() if not loop.margins.stable]
    if answer is None:
        findings += lost_steps(machine, reference, judged)
    else:
        off = Place(reference, judged, answer.worst.sample).off
        findings += about_guesses(answer.causes, numbers, dict(zip(machine.axis_names, off.tolist(), strict=True)))
    findings += [noted for part in (learned, answer, sampled) if part is not None for noted in part.findings]
    of_run = (case.name, reference, judged, figures, answer, circles_of(judged, reference), judged_spikes(judged, reference))
    return Outcome(
        *of_run, tuple(findings), machine, bode, limits_of(case, reference),
        case=case,
        learning=learned,
        trials=None if learned is None else learned.course,
        foretold=foretold,
        tick=tick_cost(machine, controller, reference) if costs else None,
        switches=switches_of(judged, controller, reference, case.changes),
        gaps=_gaps(machine, judged),
        trust=Trust(stated(numbers), tuple(number.name for number in numbers if not number.is_stated), sampled),
    )  # fmt: skip


def _gaps(machine: Machine, result: Result) -> dict[str, tuple[Array, Array]]:
    """Return the free travel of each axis with a motor and a load, over the part of its travel that was used."""
    gaps = {}
    for i, axis in enumerate(machine.axes):
        free_travel = getattr(axis.plant, "gap_at", None)
        if axis.plant.two_sided and free_travel is not None and "axis_position" in result:
            ends = [(used.min(), used.max()) for used in (part["axis_position"][:, i] for part in result.blocks())]
            places = np.linspace(float(np.min(ends)), float(np.max(ends)), GAP_POINTS)
            gaps[axis.name] = places, np.array([free_travel(float(place)) for place in places])
    return gaps


def judged_spikes(judged: Result, reference: Reference) -> tuple[Spike, ...]:
    """Return the reversal spikes on the judged moves."""
    part = judged_part(judged, reference)
    spikes = reversal_spikes(judged, (max(part.ranges[0][0] - 5, 0), part.ranges[-1][1]), reference=reference)
    inside = range_of(part, np.array([spike.sample - judged.start for spike in spikes], dtype=np.int64))
    return tuple(spike for spike, number in zip(spikes, inside, strict=True) if number)


def _remarks(case: Case, reference: Reference, foretold: LearningAnalysis | None, coupling: bool) -> Iterator[Finding]:
    """Yield what a person should know before trusting a run; with `coupling` its stability too."""
    if coupling and case.controller.coupling is not None:
        with suppress(ComponentError):  # not linear
            yield from internal_stability(case.machine, case.controller).findings
    for axis in case.machine.axes:
        loop = case.controller.axes[axis.name]
        shifts = loop.compensation is not None and any(port.name == "reference_shift" for port in loop.compensation.outputs)
        if shifts and loop.feedback == "load" and axis.plant.two_sided:
            yield finding("CL101", place=f"axis {axis.name}")
        supervisor = loop.supervisor
        if isinstance(supervisor, PreRouted):
            if supervisor.by == "line" and not reference.source_lines.any():
                yield finding("CL102", place=f"axis {axis.name}")
            end = float(reference.block(reference.n_sample - 1, reference.n_sample).arc_length[0])
            beyond = [place for place in supervisor.places if place > end] if supervisor.by == "arc-length" else []
            if beyond:
                yield finding("CL103", place=f"axis {axis.name}", place_at=beyond[0], end=end)
    profile, route = reference.profile, case.route()
    if profile is not None and route is not None:
        curve = reference.path.curve_index(profile.s0)
        used = np.where(route.rapid[curve], 0.0, profile.v0 / route.feedrate[curve])
        best = int(np.argmax(used))
        if 0.0 < used[best] < NEAR_FEED:
            yield finding("CL105", feed=float(route.feedrate[curve[best]]), reached=float(profile.v0[best]))
    if case.motion.file is not None or case.machine.control:
        yield from about_machine(case.machine, case.motion.reading if isinstance(case.motion, PartProgram) else None)
    if isinstance(case.motion, PartProgram) and case.feed.path_control == "program" and case.machine.own_planner is None:
        modes = PathModes()
        modes.add(case.motion.program.moves)
        yield from modes.findings(case.feed.default_tolerance(case.machine.own_planner))
    if reference.decided:
        yield finding("CL231", time=reference.duration, planned=case.reference().duration)
        if (report := limits_of(case, reference)) is not None and not report.ok():
            kind, worst = max(((k, w) for k, of in zip(KINDS, report.kinds, strict=True) for w in of), key=lambda found: found[1].ratio)
            yield finding("CL232", kind=kind, axis=case.machine.axis_names[worst.axis], use=worst.ratio, time=worst.time)
    last = reference.n_sample * reference.servo_period
    for change in case.changes:
        if change.sample(reference.servo_period) >= reference.n_sample:
            yield finding("CL104", time=change.time, end=last)
    if foretold is not None:
        yield from foretold.findings


def _learned(case: Case, reference: Reference, report_progress: Callable[[int], None]) -> LearningRun:
    """Run the trials of a case; the first starts with the table that the case names."""
    learning, start = case.learning, None
    assert learning is not None
    if learning.table is not None:
        start = LearnedTable.load(learning.table)
        try:
            start.check(case.machine, case.controller, reference)
        except ResultError as error:
            raise ResultError(f"{learning.table}: {error}") from error
    stopping = Stopping(improvement=learning.improvement, patience=learning.patience)
    return learn(
        case.machine, case.controller, reference, learning.law,
        trials=learning.trials, seed=case.run.seed, start=start, stopping=stopping, progress=report_progress,
    )  # fmt: skip


def limits_of(case: Case, reference: Reference) -> LimitReport | None:
    """Check the reference against the limits of the axes; None where it was not planned within them."""
    if case.route() is None:
        return None
    limits = case.machine.planner_limits()
    key = (reference.digest, limits.velocity.tobytes(), limits.acceleration.tobytes(), limits.jerk.tobytes())
    if key not in _REPORTS:
        while len(_REPORTS) >= KEPT_REPORTS:
            del _REPORTS[next(iter(_REPORTS))]
        _REPORTS[key] = limit_report(reference, limits)
    return _REPORTS[key]


def bode_of(machine: Machine, controller: Controller) -> dict[str, ClosedLoop]:
    """Return the closed loop of each axis whose components are linear but for friction, counts and limits."""
    loops = {}
    for axis in machine.axes:
        parts = controller.axes[axis.name]
        with suppress(ComponentError):
            loop = sampled_loop(axis, parts, machine.servo_period, machine.carried_mass(axis.name))
            response = loop.response(loop.frequencies())
            contact = axis.plant.linear() != axis.plant
            meant = ", ".join(["first controller"] * (parts.supervisor is not None) + ["in contact"] * contact)
            loops[axis.name] = ClosedLoop(response.frequency / (2.0 * math.pi), response.closed_loop, loop.margins(), meant)
    return loops


def tick_cost(machine: Machine, controller: Controller, reference: Reference) -> float:
    """Return the time of one tick of the compiled loop [s], the simulated machine included: the shortest of several runs."""
    feed = Feed(machine, controller, reference, None, sampler(True))
    first, fed = feed.block(0, min(TICKS, reference.n_sample))
    loop = build(machine, controller, reference.path, first.position[0], float(first.arc_length[0]), fed=feed.names)
    group = make_group(loop.schedule, 1, slice(0, 1), True)
    start = group.snapshot()
    times: list[float] = []
    while len(times) < FEWEST or sum(times) * len(fed) < SECONDS:
        group.restore(start)
        begun = perf_counter()
        group.run(fed, [])
        times.append((perf_counter() - begun) / len(fed))
    return min(times)
