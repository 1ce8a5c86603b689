"""One case: simulate, or learn from trial to trial; judge; sum up; give a verdict."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import partial
from time import perf_counter

import numpy as np

from contourlab.analysis.learning.learning_analysis import LearningAnalysis, learning_analysis
from contourlab.analysis.linear.contour_transfer import InternalStability, internal_stability
from contourlab.analysis.linear.margins import doubling
from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.arrays import Array, free_memory
from contourlab.components.supervisor.switching import PreRouted
from contourlab.engine.runner import make_group
from contourlab.errors import ComponentError, ResultError
from contourlab.features.check.remarks import path_mode_assumed, travel_unknown
from contourlab.features.learn import LearnedTable, LearningRun, Stopping, learn
from contourlab.features.learn.foretold import learning_findings
from contourlab.features.run.summary import Outcome
from contourlab.features.run.trust.interval import part_interval
from contourlab.features.run.trust.provenance import numbers_of, trust_of
from contourlab.features.run.verdict import verdict
from contourlab.feed import LimitReport, Reference, limit_report
from contourlab.feed.planner import NEAR_FEED
from contourlab.findings import Finding, finding
from contourlab.loop import Controller, Machine, simulate
from contourlab.loop.feeding import Feed
from contourlab.loop.simulate import sampler
from contourlab.loop.switches import switches_of
from contourlab.loop.template import build
from contourlab.metrics import Spike, circles_of, judge, judged_part, reversal_spikes, summarise
from contourlab.metrics.judge import check_follows
from contourlab.rendering.data import ClosedLoop
from contourlab.result import Result
from contourlab.scenario import Case, PartProgram
from contourlab.scenario.values import DEFAULT_CORNER_TOLERANCE
from contourlab.study import Setting

KEPT_REPORTS = 16
_REPORTS: dict[tuple[str, bytes, bytes, bytes], LimitReport] = {}
"""The latest reports by motion and limits: schemes of a file mostly share both, and a report reads the whole motion."""
BYTES, BYTES_PER_AXIS = 80, 110
"""Memory of a sample, measured at its peak (while it is judged): in all, and for each axis."""
TICKS, SECONDS, FEWEST = 20_000, 0.3, 7
"""For the cost of a tick: most ticks of a run, total time of the runs, fewest runs."""
GAP_POINTS = 201
"""Places at which a picture evaluates the free travel of an axis."""


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
        Whether to find causes and advice of a failed verdict. A case that learns gets none: what it learned belongs to its own machine.
    progress : callable, optional
        Called with samples done and samples in all, while simulating.
    stage : callable, optional
        Called with the name of each stage.
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
    MemoryError
        Before the run, if its signals do not fit into the memory that is free.
    """
    begin = stage or (lambda name: None)
    begin(f"planning {case.name}")
    reference = case.reference()
    machine, controller = case.machine, case.controller
    _check_memory(reference)

    def report_progress(done: int) -> None:
        if progress is not None:
            progress(done, reference.n_sample * (1 if case.learning is None else case.learning.trials + 1))

    foretold = learned = None
    if case.learning is not None:
        if foretell:
            begin(f"analysing how {case.name} learns")
            with suppress(ComponentError):  # no linear model
                foretold = learning_analysis(machine, controller, case.learning.law)
        begin(f"learning, {case.name}")
        learned = _learned(case, reference, report_progress)
    begin(f"simulating {case.name}" + ("" if learned is None else f", trial {learned.best}"))
    table, trial = (None, 0) if learned is None else (learned.table.learned, learned.best)
    given = {"seed": case.seed, "learned": table, "moving": case.moving, "changes": case.changes}
    shown = report_progress if learned is None else None
    result = simulate(machine, controller, reference, scheme=case.name, trial=trial, progress=shown, **given)  # type: ignore[arg-type]
    begin(f"judging {case.name}")
    judged = judge(result, reference)
    check_follows(judged, reference)
    figures = summarise(judged, reference)
    explain = explain and case.tolerance is not None and figures.part_error.max > case.tolerance and learned is None
    if explain:
        begin(f"looking for the causes of the error of {case.name}")
    answer = None if case.tolerance is None else verdict(
        machine, controller, reference, judged, case.tolerance,
        lines=case.lines, slower=case.reference, closer=case.closer, explain=explain,
        rerun=partial(simulate, seed=case.seed, moving=case.moving),
    )  # fmt: skip
    sampled = None
    if interval is not False:
        if any(number.drawn for number in numbers_of(machine, controller)):
            begin(f"drawing machines from the deviations, {case.name}")
        setting, others = Setting(machine, controller, reference, case.seed, case.moving), {"changes": case.changes, "learned": table}
        sampled = part_interval(setting, tolerance=case.tolerance, progress=progress, **others)  # type: ignore[arg-type]
    begin(f"checking limits and margins of {case.name}")
    bode = bode_of(machine, controller)
    findings = [*_remarks(case, reference, foretold, costs or foretell)]
    findings += [finding("CL205", place=f"axis {axis}") for axis, loop in bode.items() if not loop.margins.stable]
    findings += [noted for part in (learned, answer, sampled) if part is not None for noted in part.findings]
    return Outcome(
        name=case.name,
        case=case,
        reference=reference,
        result=judged,
        metrics=figures,
        verdict=answer,
        circles=circles_of(judged, reference),
        spikes=judged_spikes(judged, reference),
        findings=tuple(findings),
        machine=machine,
        bode=bode,
        limits=limits_of(case, reference),
        learning=learned,
        trials=None if learned is None else learned.course,
        foretold=foretold,
        tick=tick_cost(machine, controller, reference) if costs else None,
        switches=switches_of(judged, controller, reference, case.changes),
        gaps=_gaps(machine, judged),
        trust=trust_of(machine, controller, sampled),
        lines=reference.source_line(judged["arc_length"]) if case.lines else None,
    )


def _gaps(machine: Machine, result: Result) -> dict[str, tuple[Array, Array]]:
    """Return the free travel of each axis with a motor and a load, over the part of its travel that was used."""
    gaps = {}
    for i, axis in enumerate(machine.axes):
        free_travel = getattr(axis.plant, "gap_at", None)
        if axis.plant.two_sided and free_travel is not None and "axis_position" in result:
            used = result["axis_position"][:, i]
            places = np.linspace(float(used.min()), float(used.max()), GAP_POINTS)
            gaps[axis.name] = places, np.array([free_travel(float(place)) for place in places])
    return gaps


def judged_spikes(judged: Result, reference: Reference) -> tuple[Spike, ...]:
    """Return the reversal spikes on the judged moves."""
    part = judged_part(judged, reference)
    counts = part.mask(judged.n_sample)
    spikes = reversal_spikes(judged, (max(part.ranges[0][0] - 5, 0), part.ranges[-1][1]), reference=reference)
    return tuple(spike for spike in spikes if counts[spike.sample])


def _check_memory(reference: Reference) -> None:
    """Refuse a run that the system would end for want of memory."""
    free = free_memory()
    needed = reference.n_sample * (BYTES + BYTES_PER_AXIS * reference.n_axis)
    if needed > free:
        need, have = f"{needed / 1e9:.3g} GB", f"{free / 1e9:.3g} GB"
        raise MemoryError(f"{reference.n_sample} samples of {reference.n_axis} axes need about {need}, {have} are free")


def _remarks(case: Case, reference: Reference, foretold: LearningAnalysis | None, coupling: bool) -> Iterator[Finding]:
    """Yield what a person should know before trusting a run; with `coupling` its stability too."""
    if coupling and case.controller.coupling is not None:
        with suppress(ComponentError):  # not linear
            yield from coupling_findings(internal_stability(case.machine, case.controller))
    for axis in case.machine.axes:
        loop = case.controller.axes[axis.name]
        shifts = loop.compensation is not None and any(port.name == "reference_shift" for port in loop.compensation.outputs)
        if shifts and loop.feedback == "load" and axis.plant.two_sided:
            yield finding("CL101", place=f"axis {axis.name}")
        if isinstance(loop.supervisor, PreRouted):
            yield from _unreached(axis.name, loop.supervisor, reference)
    yield from _feed_never_reached(case, reference)
    if case.motion.file is not None:
        yield from travel_unknown(case.machine)
    if isinstance(case.motion, PartProgram) and case.feed.path_control == "program":
        yield from path_mode_assumed(case.motion.program.moves, case.feed.corner_tolerance or DEFAULT_CORNER_TOLERANCE)
    last = reference.n_sample * reference.servo_period
    for change in case.changes:
        if change.sample(reference.servo_period) >= reference.n_sample:
            yield finding("CL104", time=change.time, end=last)
    if foretold is not None:
        yield from learning_findings(foretold)


def _feed_never_reached(case: Case, reference: Reference) -> Iterator[Finding]:
    """Yield a finding where the programmed feed is nowhere reached on a feed move."""
    profile, route = reference.profile, case.route()
    if profile is None or route is None:
        return
    curve = reference.path.curve_index(profile.s0)
    used = np.where(route.rapid[curve], 0.0, profile.v0 / route.feedrate[curve])
    best = int(np.argmax(used))
    if 0.0 < used[best] < NEAR_FEED:
        yield finding("CL105", feed=float(route.feedrate[curve[best]]), reached=float(profile.v0[best]))


def coupling_findings(stability: InternalStability) -> Iterator[Finding]:
    """Yield why a coupling of stable axes is unstable; nothing where it is stable."""
    if not all(stability.axes.values()) or stability.directions is None:
        return
    if not stability.directions.stable:
        parts = zip(stability.axes, stability.directions.modulus_direction, strict=True)
        direction = [f"{axis} {part:.2f}" for axis, part in parts]
        hertz, time = stability.directions.modulus_frequency / (2.0 * math.pi), stability.directions.doubling
        yield finding("CL206", frequency=hertz, direction=direction, doubling=time)
    elif stability.lap >= 1.0:
        yield finding("CL207", growth=stability.lap - 1.0, doubling=doubling(stability.lap))


def _unreached(name: str, supervisor: PreRouted, reference: Reference) -> Iterator[Finding]:
    if supervisor.by == "line" and not reference.source_lines.any():
        yield finding("CL102", place=f"axis {name}")
    end = float(reference.block(reference.n_sample - 1, reference.n_sample).arc_length[0])
    beyond = [place for place in supervisor.places if place > end] if supervisor.by == "arc-length" else []
    if beyond:
        yield finding("CL103", place=f"axis {name}", place_at=beyond[0], end=end)


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
        trials=learning.trials, seed=case.seed, start=start, stopping=stopping, progress=report_progress,
    )  # fmt: skip


def limits_of(case: Case, reference: Reference) -> LimitReport | None:
    """Check the reference against the limits of the axes; None where it was not planned within them."""
    if case.route() is None:
        return None
    limits = case.limits
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
