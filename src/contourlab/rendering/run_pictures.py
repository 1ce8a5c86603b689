"""A run in pictures: errors over time, path and circles; feed, axes against their limits, backlash and frequency response."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.figures import figure, number, shown_unit
from contourlab.metrics.circles import CircleFigures
from contourlab.rendering.charts import Chart, Curve, Level, Panel, PolarChart, Tick
from contourlab.rendering.data import FeedRun, JudgedRun, ReportData
from contourlab.rendering.samples import axis_column, extremes, largest_magnitude, signal, times
from contourlab.rendering.style import LIMIT, REFERENCE
from contourlab.result import Result
from contourlab.thinning import keep_extremes

UM = 1e6
MARKS = 400
"""Most marks of a picture."""
MARKED = {"reversal": ("Triangles", "axis reversals"), "corner": ("Diamonds", "corners")}
"""Marks in words."""


def error_charts(data: ReportData, points: int) -> tuple[Chart, ...]:
    """Return the error over time, and over arc length if every scheme has it; curves have at most `points` points."""
    # The tolerance applies to the part error; without blending the two errors are equal.
    name = "part_error" if data.is_blended else "contour_error"
    over_time, over_arc = [], []
    signed = False
    for scheme in data.schemes:
        kept = extremes(scheme.result, name, points)
        height = scheme.result.at(name, kept) * UM
        signed = signed or bool(np.any(height < 0.0))
        over_time.append(Curve(times(scheme.result, kept), height, *data.looks[scheme.name]))
        if "arc_length" in scheme.result:
            over_arc.append(Curve(scheme.result.at("arc_length", kept) * 1e3, height, *data.looks[scheme.name]))
    label = f"{name.replace('_', ' ')} [um]"
    moments = _moments(data)
    caption = _caption(name, signed, {tick.mark for tick in moments})
    panel = _panel(data, "time [s]", label, tuple(over_time), signed, moments)
    charts = [Chart("error-time", "Error over time", caption, (panel,))]
    if len(over_arc) == len(data.schemes):
        last = max(float(curve.x[-1]) for curve in over_arc)
        corners = tuple(Tick(float(s) * 1e3, "corner", "corner") for s in _corners(data, last * 1e-3))
        panel = _panel(data, "arc length [mm]", label, tuple(over_arc), signed, corners)
        caption = "The same error over the arc length travelled."
        charts.append(Chart("error-arc", "Error along the path", caption, (panel,)))
    return tuple(charts)


def _moments(data: ReportData) -> tuple[Tick, ...]:
    """Return the reversals and corners of the last scheme as marks on the time axis."""
    scheme = data.schemes[-1]
    highest = sorted(scheme.spikes, key=lambda spike: -abs(spike.height))[:MARKS]
    ticks = [Tick(s.time, f"{s.axis} reverses, spike {figure(abs(s.height), 'um')}", "reversal") for s in highest]
    if "arc_length" in scheme.result:
        n = scheme.result.n_sample
        corners = _corners(data, float(scheme.result["arc_length"][-1]))
        passed = np.sum([np.searchsorted(signal(part, "arc_length"), corners) for part in scheme.result.blocks()], axis=0)
        ticks += [Tick(float(t), "corner", "corner") for t in times(scheme.result, passed[passed < n])]
    return tuple(sorted(ticks, key=lambda tick: tick.x))


def _corners(data: ReportData, last: float) -> Array:
    """Return the arc length of each corner up to `last` [m], laps included; none if there are too many."""
    corners = np.asarray(data.planned.corners, dtype=np.float64).ravel()
    laps = 1 + int(last // data.planned.length) if data.planned.closed else 1
    if corners.size * laps > MARKS:
        return np.zeros(0)
    places = (corners + data.planned.length * np.arange(laps)[:, np.newaxis]).ravel()
    return np.asarray(places[places <= last], dtype=np.float64)


def _panel(data: ReportData, x_label: str, y_label: str, curves: tuple[Curve, ...], signed: bool, ticks: tuple[Tick, ...]) -> Panel:
    """Return one panel of errors with its tolerance band, unless that is far beyond the errors."""
    band, text, y_range = None, "", None
    if data.tolerance is not None:
        edge = data.tolerance * UM
        band = (-edge, edge) if signed else (0.0, edge)
        text = f"tolerance {'±' if signed else ''}{figure(data.tolerance, 'um', 6)}"
        top = max(largest_magnitude(curve.y) for curve in curves)
        if 0.0 < top < edge / 4:
            y_range = (-1.15 * top if signed else 0.0, 1.15 * top)
    return Panel(x_label, y_label, curves, band=band, band_label=text, ticks=ticks, y_range=y_range)


def _caption(name: str, signed: bool, marked: set[str]) -> str:
    """Describe the error, its sign and the marks."""
    path = "programmed" if name == "part_error" else "planned"
    caption = f"{name.replace('_', ' ').capitalize()}: shortest distance from the tool to the {path} path."
    caption += " Positive to the left of the direction of travel." if signed else ""
    return caption + "".join(f" {symbol} mark {what}." for kind, (symbol, what) in MARKED.items() if kind in marked)


def polar_charts(data: ReportData, points: int) -> tuple[PolarChart, ...]:
    """Return one ball-bar plot for each circle."""
    names = dict.fromkeys(circle.name for scheme in data.schemes for circle in scheme.circles)
    return tuple(_polar(data, name, number, points) for number, name in enumerate(names))


def _polar(data: ReportData, name: str, index: int, points: int) -> PolarChart:
    """Return the plot of one circle: all schemes, both directions."""
    curves, marks, radius = [], [], 0.0
    for scheme in data.schemes:
        colour = data.looks[scheme.name][1]
        for circle in (circle for circle in scheme.circles if circle.name == name):
            kept = keep_extremes(circle.deviation, points)
            way, dash = ("clockwise", "dash") if circle.clockwise else ("counter-clockwise", "solid")
            angle = np.degrees(np.unwrap(circle.angle))[kept]
            curves.append(Curve(angle, circle.deviation[kept] * UM, f"{scheme.name}, {way}", colour, dash))
            at = _peaks(scheme, circle)
            if at.size:
                marks.append(Curve(np.degrees(circle.angle[at]), circle.deviation[at] * UM, f"{scheme.name}, {way}", colour))
            radius = circle.radius
    chart = PolarChart(f"circle-{index}", name, "", tuple(curves), radius, tuple(marks))
    division, span = chart.spacing
    caption = (
        f"Nominal radius {figure(radius, 'mm', 6)}. Ring spacing {number(division, 6)} um of radial deviation, "
        f"magnified {number(radius * 1e6 / (2.0 * span))} times. Solid: counter-clockwise; dashed: clockwise."
        + (" Small circles mark the peaks of reversal spikes." if marks else "")
    )
    return replace(chart, caption=caption)


def _peaks(scheme: JudgedRun, circle: CircleFigures) -> Index:
    """Return the points of a circle at which reversal spikes are highest."""
    period, start = scheme.result.servo_period, scheme.result.start
    highest = [round(spike.peak_time / period) - start for spike in scheme.spikes if math.isfinite(spike.angle)]
    return np.flatnonzero(np.isin(circle.samples, highest))


OFF_SCALE = 4.0
"""Peaks above this multiple of the limit are cut off, because they would flatten the rest."""
FAR = 0.08
"""Curves below this share of the limit are drawn without it, because they would look flat."""
UNITS = {"velocity": "m/s", "acceleration": "m/s^2", "jerk": "m/s^3"}
STEP = "curvature step"
"""Kind of the marks at steps of curvature."""
DEEPEST = 120.0
"""Drawn range of magnitude [dB]; smaller values are rounding."""
FEED_COLOURS = ("#8a949e", "#0072b2", "#009e73", "#d55e00", "#cc79a7", "#e69f00", "#56b4e9")
EXPLAINED = {
    "curvature step": "Curvature step: the acceleration jumps where a line meets an arc. The jump keeps the acceleration limits;"
    " no jerk limit can hold there without a stop.",
    "near a slow section": "Near a slow section: the planner slows down for a slower section nearby.",
}
"""Explanations of what limits the feed."""
FEED_POINTS = 10_000
FINER = 4
"""A loop gets this many times the points of a curve over time, since it repeats."""


def feed_charts(run: FeedRun | None) -> tuple[Chart, ...]:
    """Return the planned feed over arc length, coloured by what limits it; nothing without limits."""
    if run is None:
        return ()
    kept = keep_extremes(run.feedrate, FEED_POINTS)
    x, feed, programmed = run.arc_length[kept] * 1e3, run.feedrate[kept] * 6e4, run.programmed[kept] * 6e4
    asked = np.where(programmed <= 1.5 * float(feed.max()), programmed, np.nan)
    curves = [Curve(x, asked, "programmed", REFERENCE, "dot")] if np.isfinite(asked).any() else []
    for code, name in enumerate(run.names):
        held = run.binding[kept] == code
        # A segment extends to the start of the next, so that the line has no gaps.
        drawn = held | np.append(False, held[:-1])
        if held.any():
            curves.append(Curve(x, np.where(drawn, feed, np.nan), name, FEED_COLOURS[code % len(FEED_COLOURS)], "solid", 2.2))
    shares = run.shares()
    longest = ", ".join(f"{name} {number(100.0 * part)} %" for name, part in shares.items() if part >= 5e-4)
    caption = f"Planned feedrate. The colour shows what limits it. Share of time: {longest}. Cycle time {figure(float(run.time[-1]), 's')}."
    caption = " ".join([caption, *(text for name, text in EXPLAINED.items() if name in shares)])
    return (Chart("feed", "Feed along the path", caption, (Panel("arc length [mm]", "feedrate [mm/min]", tuple(curves)),)),)


def axis_charts(data: ReportData, points: int) -> tuple[Chart, ...]:
    """Return one chart per axis: tracking error, velocity, acceleration, jerk, command; curves have at most `points` points."""
    return tuple(_axis_chart(data, axis, name, points) for axis, name in enumerate(data.axes))


def _axis_chart(data: ReportData, axis: int, name: str, points: int) -> Chart:
    """Return the chart of one axis, without panels of signals that no scheme has."""
    tracking = _runs(data, axis, points, "tracking_error", UM)
    panels = [Panel("time [s]", "tracking error [um]", tracking) if tracking else None]
    panels += [_limited_panel(data, axis, points, name) for name in ("velocity", "acceleration", "jerk", "command")]
    drawn = tuple(filter(None, panels))
    bounded = "Dashed lines are the limits." if any(panel.levels for panel in drawn) else ""
    planned = "Acceleration and jerk are those of the reference." if _reference_of(data, "reference_acceleration") is not None else ""
    marked = any(tick.mark == STEP for panel in drawn for tick in panel.ticks)
    steps = "Triangles mark curvature steps; their jerk over a servo period exceeds the limit, see the table above." if marked else ""
    caption = " ".join(filter(None, [bounded, planned, *map(_off_scale, drawn), steps]))
    return Chart(f"axis-{axis}", f"Axis {name}", caption, drawn)


def _curve(result: Result, name: str, axis: int, points: int, factor: float, look: tuple[str, str, str], order: int = 0) -> Curve:
    """Return a thinned curve over time of one axis of a signal, or of its differences of an order; `look` is name, colour and dash."""
    kept = extremes(result, name, points, axis, order)
    height = result.at(name, kept)[:, axis]
    if order:
        height = result.at(name, kept + 1)[:, axis] - height
    return Curve(times(result, kept), height * factor, *look)


def _runs(data: ReportData, axis: int, points: int, signal: str, factor: float) -> tuple[Curve, ...]:
    """Return one signal of every scheme that has it."""
    return tuple(
        _curve(scheme.result, signal, axis, points, factor, data.looks[scheme.name]) for scheme in data.schemes if signal in scheme.result
    )


def _limited_panel(data: ReportData, axis: int, points: int, name: str) -> Panel | None:
    """Return a quantity of the reference and of every scheme, with its limit; of acceleration and jerk only that of the reference.

    The jerk is the difference of the acceleration over a servo period.
    """
    wanted = {"velocity": "reference_velocity", "command": "command"}.get(name, "reference_acceleration")
    source = _reference_of(data, wanted)
    curves: tuple[Curve, ...] = ()
    factor, unit = shown_unit(UNITS.get(name) or ("" if source is None else str(source.signals[wanted].unit)))
    if source is not None and name != "command":
        look, order = ("reference", REFERENCE, "dot" if name == "velocity" else "solid"), int(name == "jerk")
        scale = factor / float(source.servo_period) if order else factor
        curves = (_curve(source, wanted, axis, points, scale, look, order),) if source.n_sample > order else ()
    if name in ("velocity", "command"):
        curves += _runs(data, axis, points, name, factor)
    if not curves:
        return None
    ticks = _curvature_steps(data, axis) if name == "jerk" else ()
    return _limited(data, Panel("time [s]", f"{name} [{unit or '1'}]", curves, ticks=ticks), name, axis, factor, unit)


def _limited(data: ReportData, panel: Panel, name: str, axis: int, factor: float, unit: str) -> Panel:
    """Return the panel with the two limits of the first machine, and a range that flattens neither them nor the curves."""
    machine = next((scheme.machine for scheme in data.schemes if scheme.machine is not None), None)
    if machine is None or data.axes[axis] not in machine.axis_names:
        return panel
    part = machine.axis(data.axes[axis])
    limit = factor * float(getattr(part.drive, "limit", np.inf) if name == "command" else getattr(part.limits, name))
    if not np.isfinite(limit):
        return panel
    text = f"limit ±{number(limit, 6)} {unit}"
    top = max(largest_magnitude(curve.y) for curve in panel.curves)
    far = 0.0 < top < FAR * limit
    cut = top > OFF_SCALE * limit
    text += f"; peaks of {number(top)} {unit} off scale" if cut else ""
    edge = 1.25 * (top if far else limit if cut else max(limit, top))
    return replace(panel, levels=(Level(limit, text), Level(-limit, "")), y_range=(-edge, edge), far=far)


def _off_scale(panel: Panel) -> str:
    """Describe the peak outside a panel, if any."""
    if panel.y_range is None or max(largest_magnitude(curve.y) for curve in panel.curves) <= panel.y_range[1]:
        return ""
    what, _, unit = panel.y_label.partition(" [")
    worst = max(panel.curves, key=lambda curve: largest_magnitude(curve.y))
    at = int(np.nanargmax(np.abs(worst.y)))
    peak = f"{number(float(worst.y[at]))} {unit.rstrip(']')}"
    return f"{what.capitalize()} peaks at {peak} at {number(float(worst.x[at]), 4)} s, outside the drawn range."


def _reference_of(data: ReportData, signal: str) -> Result | None:
    """Return the first result with a signal of the common reference."""
    return next((scheme.result for scheme in data.schemes if signal in scheme.result), None)


def _curvature_steps(data: ReportData, axis: int) -> tuple[Tick, ...]:
    """Return marks at the curvature steps whose jerk over a servo period exceeds the limit; the largest ones if there are many."""
    scheme = next(scheme for scheme in data.schemes if "reference_acceleration" in scheme.result)
    if scheme.limits is None:
        return ()
    period, start = float(scheme.result.servo_period), int(scheme.result.start)
    steps = scheme.limits.jerk_peaks(axis, period)
    shown = [i for i in np.argsort(-steps.size)[:MARKS] if 0 <= steps.sample[i] - start < scheme.result.n_sample - 1]
    return tuple(
        Tick(float(steps.sample[i] * period), f"step of {figure(steps.size[i], 'm/s^2')}: {figure(steps.size[i] / period, 'm/s^3')}", STEP)
        for i in sorted(shown, key=lambda i: int(steps.sample[i]))
    )


def bode_charts(data: ReportData, points: int) -> tuple[Chart, ...]:
    """Return the frequency response of the closed loop of each axis that has one."""
    charts = []
    for index, axis in enumerate(data.axes):
        gains, phases, notes = [], [], ["Closed loop, reference to position."]
        for scheme in (scheme for scheme in data.schemes if axis in scheme.bode):
            answer, look = scheme.bode[axis], data.looks[scheme.name]
            with np.errstate(divide="ignore"):
                gain = 20.0 * np.log10(np.abs(answer.response))
            kept = keep_extremes(gain, points)
            gains.append(Curve(answer.frequency[kept], gain[kept], *look))
            phases.append(Curve(answer.frequency[kept], np.degrees(np.unwrap(np.angle(answer.response)))[kept], *look))
            figures = [f"{what} {value}" for what, value in answer.notes.items()]
            notes.append(f"{scheme.name}: {', '.join(filter(None, (answer.meant, *figures)))}.")
        if gains:
            edge = (Level(-3.0, "−3 dB"),)
            magnitude = Panel("frequency [Hz]", "magnitude [dB]", tuple(gains), edge, log_x=True, y_range=_decibels(gains))
            phase = Panel("frequency [Hz]", "phase [deg]", tuple(phases), log_x=True)
            charts.append(Chart(f"bode-{index}", f"Axis {axis}", " ".join(notes), (magnitude, phase)))
    return tuple(charts)


def _decibels(gains: list[Curve]) -> tuple[float, float] | None:
    """Return the drawn range of magnitude if a zero at the Nyquist frequency would compress the rest."""
    values = np.concatenate([gain.y[np.isfinite(gain.y)] for gain in gains])
    if not values.size or np.ptp(values) <= DEEPEST:
        return None
    return float(values.max()) - DEEPEST, float(values.max()) + 0.05 * DEEPEST


def hysteresis_charts(data: ReportData, points: int) -> tuple[Chart, ...]:
    """Return motor less load over load position: a chart for each axis that has both, a panel for each scheme."""
    charts = []
    for axis, name in enumerate(data.axes):
        panels, notes = [], ["Between the dashed lines the motor moves without the load; beyond them the shaft winds up."]
        for scheme in data.schemes:
            if name in scheme.gaps and "motor_position" in scheme.result:
                curves, note = _hysteresis(scheme, axis, name, FINER * points, data.looks[scheme.name])
                panels.append(curves)
                notes.append(note)
        if panels:
            edge = 1.15 * max(largest_magnitude(curve.y) for curves in panels for curve in curves) or 1.0
            drawn = tuple(Panel("load position [mm]", "motor − load [um]", curves, y_range=(-edge, edge)) for curves in panels)
            charts.append(Chart(f"backlash-{axis}", f"Axis {name}: motor minus load position", " ".join(notes), drawn, loops=True))
    return tuple(charts)


def _hysteresis(scheme: JudgedRun, axis: int, name: str, points: int, look: tuple[str, str, str]) -> tuple[tuple[Curve, ...], str]:
    """Return motor less load [um] over load position [mm], thinned, between the flanks of the gap; and the gap and wind-up in words."""
    load = axis_column(scheme.result, "axis_position", axis)
    apart = axis_column(scheme.result, "motor_position", axis) - load
    kept = keep_extremes(np.column_stack([load, apart]), points)
    x, y = load[kept] * 1e3, apart[kept] * UM
    place, width = scheme.gaps[name]
    low, high = float(np.nanmin(x)), float(np.nanmax(x))
    at = np.concatenate([[low], place[(place * 1e3 > low) & (place * 1e3 < high)] * 1e3, [high]])
    half = 0.5 * np.interp(at * 1e-3, place, width) * UM
    flanks = (Curve(at, side * half, "edge of the gap", LIMIT, "dash") for side in (1.0, -1.0))
    wide, narrow = float(width.max()) * UM, float(width.min()) * UM
    gap = f"{number(wide, 6)} um" if wide == narrow else f"{number(narrow, 6)} um to {number(wide, 6)} um"
    twist = np.abs(y) - 0.5 * np.interp(x * 1e-3, place, width) * UM
    note = f"{scheme.name}: backlash gap {gap}, wind-up at most {number(max(float(np.nanmax(twist)), 0.0))} um."
    return (Curve(x, y, *look, 1.0), *flanks), note
