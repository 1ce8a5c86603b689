"""The error over time, along the path, and around each circle."""

from __future__ import annotations

import math

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.figures import figure, number
from contourlab.metrics import CircleFigures
from contourlab.rendering.charts import Chart, Curve, Panel, PolarChart, Tick, ring_spacing
from contourlab.rendering.data import JudgedRun, ReportData
from contourlab.rendering.samples import largest_magnitude, signal, times
from contourlab.thinning import keep_extremes

UM = 1e6
MARKS = 400
"""Most marks of a picture."""
EXPLAINED = {"reversal": ("Triangles", "axis reversals"), "corner": ("Diamonds", "corners")}
"""Marks in words."""


def error_charts(data: ReportData, points: int) -> tuple[Chart, ...]:
    """Return the error over time, and over arc length if every scheme has it; curves have at most `points` points."""
    # The tolerance applies to the part error; without blending the two errors are equal.
    name = "part_error" if data.is_blended else "contour_error"
    over_time, over_arc = [], []
    signed = False
    for scheme in data.schemes:
        error = signal(scheme.result, name)
        kept = keep_extremes(error, points)
        height = error[kept] * UM
        signed = signed or bool(np.any(height < 0.0))
        over_time.append(Curve(times(scheme.result, kept), height, *data.looks[scheme.name]))
        if "arc_length" in scheme.result:
            over_arc.append(Curve(signal(scheme.result, "arc_length")[kept] * 1e3, height, *data.looks[scheme.name]))
    label = f"{name.replace('_', ' ')} [um]"
    moments = _moments(data)
    caption = _caption(name, signed, {tick.kind for tick in moments})
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
        along = signal(scheme.result, "arc_length")
        passed = np.searchsorted(along, _corners(data, float(along[-1])))
        ticks += [Tick(float(t), "corner", "corner") for t in times(scheme.result, passed[passed < along.size])]
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
    return caption + "".join(f" {symbol} mark {what}." for kind, (symbol, what) in EXPLAINED.items() if kind in marked)


def polar_charts(data: ReportData, points: int) -> tuple[PolarChart, ...]:
    """Return one ball-bar plot for each circle."""
    names = dict.fromkeys(circle.name for scheme in data.schemes for circle in scheme.circles)
    return tuple(_polar(data, name, number, points) for number, name in enumerate(names))


def _polar(data: ReportData, name: str, index: int, points: int) -> PolarChart:
    """Return the plot of one circle: all schemes, both directions."""
    curves, marks, radius, top = [], [], 0.0, 0.0
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
            radius, top = circle.radius, max(top, largest_magnitude(circle.deviation) * UM)
    division, span = ring_spacing(top)
    caption = (
        f"Nominal radius {figure(radius, 'mm', 6)}. Ring spacing {number(division, 6)} um of radial deviation, "
        f"magnified {number(radius * 1e6 / (2.0 * span))} times. Solid: counter-clockwise; dashed: clockwise."
        + (" Small circles mark the peaks of reversal spikes." if marks else "")
    )
    return PolarChart(f"circle-{index}", name, caption, tuple(curves), division, (-2.0 * span, span), radius, tuple(marks))


def _peaks(scheme: JudgedRun, circle: CircleFigures) -> Index:
    """Return the points of a circle at which reversal spikes are highest."""
    period, start = scheme.result.servo_period, scheme.result.start
    highest = [round(spike.peak_time / period) - start for spike in scheme.spikes if math.isfinite(spike.angle)]
    return np.flatnonzero(np.isin(circle.samples, highest))
