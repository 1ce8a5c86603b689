"""Turn the outcomes of a session into the data of a report."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from contourlab.arrays import Array
from contourlab.features.run.margin_words import gain_words, phase_words
from contourlab.features.run.outcome import AxisBode, Outcome
from contourlab.feed.planner import Binding, limiting
from contourlab.figures import listing
from contourlab.metrics.circles import CircleFigures
from contourlab.rendering.data import Provenance, ReportData, SchemeReport
from contourlab.rendering.run_data import AxisBounds, FeedRun, FrequencyResponse, TrialCourse

FEED_POINTS = 4000
PER_SPAN = 3
GAP_POINTS = 201
MOST_POINTS = 200_000
"""Above, only the start of each span is evaluated."""
_HELD_BY = {
    Binding.REST: "at rest",
    Binding.FEEDRATE: "programmed feed",
    Binding.VELOCITY: "axis velocity",
    Binding.ACCELERATION: "axis acceleration",
    Binding.JERK: "axis jerk",
    Binding.CURVATURE_STEP: "curvature step",
    Binding.PLANNER: "near a slow section",
}


def report_data(title: str, outcomes: Sequence[Outcome], *, scenario: str, command: str) -> ReportData:
    """Return the data of a report on outcomes (at least one) along one path; `scenario` is TOML, `command` as typed."""
    first = outcomes[0]
    reference = first.reference
    programmed = None if reference.programmed is reference.path else reference.programmed
    again = "save the scenario below as scenario.toml, then: contourlab run scenario.toml"
    provenance = Provenance(command, again, scenario, first.case.seed)
    schemes = [_scheme(outcome) for outcome in outcomes]
    notes = [*first.case.notes]
    others = [outcome.name for outcome in outcomes if outcome.reference.digest != reference.digest]
    if others:
        notes.append(f"The planned feed shown is that of {first.name}. {listing(others)}: planned differently.")
    return ReportData(title, schemes, reference.path, provenance, programmed, first.case.lines, first.case.tolerance, notes, _feed(first))


def _feed(outcome: Outcome) -> FeedRun | None:
    """Return the planned motion at even times and within each of its spans; None where it was not planned within limits."""
    reference, profile, route = outcome.reference, outcome.reference.profile, outcome.case.route()
    if profile is None or route is None:
        return None
    # Evenly over time, and within the ramps, which a rapid passes between two even places.
    ends = np.append(profile.t0[1:], profile.duration)
    per_span = PER_SPAN if PER_SPAN * ends.size <= MOST_POINTS else 1
    ramps = np.linspace(profile.t0, ends, per_span, endpoint=False).ravel()
    time = np.unique(np.concatenate([np.linspace(0.0, profile.duration, FEED_POINTS), ramps]))
    motion = profile.motion(time)
    codes = limiting(route, outcome.case.limits, profile, motion.arc_length, curvature_step=outcome.case.curvature_step)
    asked = route.feedrate[reference.path.curve_index(motion.arc_length)]
    return FeedRun(motion.arc_length, motion.speed, asked, time, codes, [_HELD_BY[code] for code in Binding])


def _scheme(outcome: Outcome) -> SchemeReport:
    axes = outcome.case.machine.axes
    bounds = AxisBounds(
        velocity=np.array([a.limits.velocity for a in axes]),
        acceleration=np.array([a.limits.acceleration for a in axes]),
        jerk=np.array([a.limits.jerk for a in axes]),
        command=np.array([float(getattr(a.drive, "limit", math.inf)) for a in axes]),
    )
    return SchemeReport(
        name=outcome.name,
        result=outcome.result,
        metrics=outcome.metrics,
        bounds=bounds,
        verdict=outcome.verdict,
        bode={axis: _response(bode, outcome.loop_meant(axis)) for axis, bode in outcome.bode.items()},
        circles=outcome.circles,
        spikes=outcome.spikes,
        circle_spikes=[_marked(circle, outcome) for circle in outcome.circles],
        limits=outcome.limits,
        trials=_course(outcome),
        foretold=outcome.foretold,
        tick=outcome.tick,
        switches=outcome.switches,
        gaps=_gaps(outcome),
        trust=outcome.trust,
        findings=outcome.findings,
        lines=outcome.reference.source_line(outcome.result["arc_length"]) if outcome.case.lines else None,
    )


def _marked(circle: CircleFigures, outcome: Outcome) -> list[int]:
    """Return the points of a circle at which reversal spikes are highest."""
    period, start = outcome.result.servo_period, outcome.result.start
    highest = [round(spike.peak_time / period) - start for spike in outcome.spikes if math.isfinite(spike.angle)]
    return [int(i) for i in np.flatnonzero(np.isin(circle.samples, highest))]


def _gaps(outcome: Outcome) -> dict[str, tuple[Array, Array]]:
    """Return the free travel of each axis with a motor and a load, over the part of its travel that was used."""
    gaps = {}
    for i, axis in enumerate(outcome.case.machine.axes):
        free_travel = getattr(axis.plant, "gap_at", None)
        if axis.plant.two_sided and free_travel is not None and "axis_position" in outcome.result:
            used = outcome.result["axis_position"][:, i]
            places = np.linspace(float(used.min()), float(used.max()), GAP_POINTS)
            gaps[axis.name] = places, np.array([free_travel(float(place)) for place in places])
    return gaps


def _course(outcome: Outcome) -> TrialCourse | None:
    run = outcome.learning
    if run is None:
        return None
    contour = np.array([trial.contour_rms for trial in run.trials])
    tracking = np.array([trial.tracking_rms for trial in run.trials])
    return TrialCourse(contour, tracking, run.best, run.status)


def _response(bode: AxisBode, meant: str) -> FrequencyResponse:
    hertz = bode.response.frequency / (2.0 * math.pi)
    m = bode.margins
    if not m.stable:
        notes = {"loop": "unstable: no margins; the curve is not a real response"}
        return FrequencyResponse(hertz, bode.response.closed_loop, notes, stable=False, meant=meant)
    size = np.abs(bode.response.closed_loop)
    below = np.flatnonzero(size < math.sqrt(0.5))
    notes = {"bandwidth (-3 dB)": f"{hertz[below[0]]:.3g} Hz" if below.size else f"above {hertz[-1]:.3g} Hz"}
    if math.isfinite(m.phase):
        notes["phase margin"] = f"{phase_words(m.phase)} at {m.crossover / (2.0 * math.pi):.3g} Hz"
    if math.isfinite(m.gain):
        notes["gain margin"] = f"{gain_words(m.gain)} at {m.phase_crossover / (2.0 * math.pi):.3g} Hz"
    notes["modulus margin"] = f"{m.modulus:.3g}"
    return FrequencyResponse(hertz, bode.response.closed_loop, notes, meant=meant)
