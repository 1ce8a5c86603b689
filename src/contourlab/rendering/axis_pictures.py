"""Axes in pictures: planned feed, signals against their limits, backlash, and frequency response."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from contourlab.arrays import Array
from contourlab.figures import figure, number, shown_unit
from contourlab.rendering.charts import Chart, Curve, Level, Panel, Tick
from contourlab.rendering.data import FeedRun, JudgedRun, ReportData
from contourlab.rendering.error_pictures import MARKS
from contourlab.rendering.samples import axis_column, largest_magnitude, times
from contourlab.rendering.style import LIMIT, REFERENCE
from contourlab.result import Result
from contourlab.thinning import keep_extremes

UM = 1e6
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
    marked = any(tick.kind == STEP for panel in drawn for tick in panel.ticks)
    steps = "Triangles mark curvature steps; their jerk over a servo period exceeds the limit, see the table above." if marked else ""
    caption = " ".join(filter(None, [bounded, planned, *map(_off_scale, drawn), steps]))
    return Chart(f"axis-{axis}", f"Axis {name}", caption, drawn)


def _curve(result: Result, values: Array, points: int, factor: float, look: tuple[str, str, str]) -> Curve:
    """Return a thinned curve over time; `look` is name, colour and dash."""
    kept = keep_extremes(values, points)
    return Curve(times(result, kept), values[kept] * factor, *look)


def _runs(data: ReportData, axis: int, points: int, signal: str, factor: float) -> tuple[Curve, ...]:
    """Return one signal of every scheme that has it."""
    return tuple(
        _curve(scheme.result, axis_column(scheme.result, signal, axis), points, factor, data.looks[scheme.name])
        for scheme in data.schemes
        if signal in scheme.result
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
        values = axis_column(source, wanted, axis)
        values = np.diff(values) / float(source.servo_period) if name == "jerk" else values
        look = ("reference", REFERENCE, "dot" if name == "velocity" else "solid")
        curves = (_curve(source, values, points, factor, look),) if values.size else ()
    if name in ("velocity", "command"):
        curves += _runs(data, axis, points, name, factor)
    if not curves:
        return None
    ticks = _curvature_steps(data, axis) if name == "jerk" else ()
    return _limited(data, Panel("time [s]", f"{name} [{unit or '1'}]", curves, ticks=ticks), name, axis, factor, unit)


def _limited(data: ReportData, panel: Panel, name: str, axis: int, factor: float, unit: str) -> Panel:
    """Return the panel with the two limits of the first machine, and a range that flattens neither them nor the curves."""
    machine = next((scheme.machine for scheme in data.schemes if scheme.machine is not None), None)
    if machine is None:
        return panel
    part = machine.axes[axis]
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
