"""The error over time and along the path, and round each circle."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.figures import figure, number
from contourlab.report.charts import Chart, Curve, Panel, PolarChart, Tick
from contourlab.report.data import ReportData
from contourlab.report.decimate import keep_extremes
from contourlab.report.read import error_signal, has, reach, signal, times
from contourlab.report.style import round_down, scheme_style

UM = 1e6
MARKS = 400  # more marks than this would be a grey wall
Array = NDArray[np.float64]


def error_charts(data: ReportData, points: int) -> tuple[Chart, ...]:
    """Return the error over time, and over arc length where every scheme tells its progress.

    Parameters
    ----------
    data : ReportData
    points : int
        Most points of a curve.
    """
    name = error_signal(data)
    over_time, over_arc = [], []
    signed = False
    for index, scheme in enumerate(data.schemes):
        error = signal(scheme.result, name)
        kept = keep_extremes(error, points)
        height = error[kept] * UM
        signed = signed or bool(np.any(height < 0.0))
        colour, dash = scheme_style(index, len(data.schemes))
        over_time.append(Curve(times(scheme.result, kept), height, scheme.name, colour, dash))
        if has(scheme.result, "arc_length"):
            over_arc.append(Curve(signal(scheme.result, "arc_length")[kept] * 1e3, height, scheme.name, colour, dash))
    label = f"{name.replace('_', ' ')} [um]"
    caption = _caption(data, name, signed)
    panel = _panel(data, "time [s]", label, tuple(over_time), signed, _moments(data))
    charts = [Chart("error-time", "Error over time", caption, (panel,))]
    if len(over_arc) == len(data.schemes):
        last = max(float(curve.x[-1]) for curve in over_arc)
        corners = tuple(Tick(float(s) * 1e3, "corner", "corner") for s in _corners(data, last * 1e-3))
        panel = _panel(data, "arc length [mm]", label, tuple(over_arc), signed, corners)
        caption = "The same error over the progress along the path."
        charts.append(Chart("error-arc", "Error along the path", caption, (panel,)))
    return tuple(charts)


def _moments(data: ReportData) -> tuple[Tick, ...]:
    """Return the reversals and corners of the last scheme as marks on the time axis."""
    scheme = data.schemes[-1]
    # Of too many the highest are shown; one whose height is not known counts as low.
    marks = sorted(scheme.marks, key=lambda mark: -mark.height if math.isfinite(mark.height) else 0.0)[:MARKS]
    heights = (f", spike {figure(m.height, 'um')}" if math.isfinite(m.height) else "" for m in marks)
    ticks = [Tick(m.time, m.label + text, m.kind) for m, text in zip(marks, heights, strict=True)]
    if has(scheme.result, "arc_length"):
        along = signal(scheme.result, "arc_length")
        passed = np.searchsorted(along, _corners(data, float(along[-1])))
        ticks += [Tick(float(t), "corner", "corner") for t in times(scheme.result, passed[passed < along.size])]
    return tuple(sorted(ticks, key=lambda tick: tick.x))


def _corners(data: ReportData, last: float) -> Array:
    """Return the progress at each corner up to `last` [m], laps included; none where they are too many."""
    corners = np.asarray(data.planned.corners, dtype=np.float64).ravel()
    laps = 1 + int(last // data.planned.length) if data.planned.closed else 1
    if corners.size * laps > MARKS:
        return np.zeros(0)
    found = (corners + data.planned.length * np.arange(laps)[:, np.newaxis]).ravel()
    return np.asarray(found[found <= last], dtype=np.float64)


def _panel(data: ReportData, x_label: str, y_label: str, curves: tuple[Curve, ...], signed: bool, ticks: tuple[Tick, ...]) -> Panel:
    """Return one panel of errors with its tolerance band; a band far beyond the errors is left out."""
    band, text, y_range = None, "", None
    if data.tolerance is not None:
        edge = data.tolerance * UM
        band = (-edge, edge) if signed else (0.0, edge)
        text = f"tolerance {'±' if signed else ''}{figure(data.tolerance, 'um', 6)}"
        top = max(reach(curve.y) for curve in curves)
        if 0.0 < top < edge / 4:
            y_range = (-1.15 * top if signed else 0.0, 1.15 * top)
    return Panel(x_label, y_label, curves, band=band, band_label=text, ticks=ticks, y_range=y_range)


def _caption(data: ReportData, name: str, signed: bool) -> str:
    """Say what the error is and how its sign is meant."""
    path = "programmed" if name == "part_error" else "planned"
    what = f"{name.replace('_', ' ').capitalize()}: shortest distance from the tool to the {path} path."
    sign = " Positive to the left of the direction of travel." if signed else ""
    marked = data.schemes[-1].spikes or np.size(data.planned.corners)
    marks = " Marks below: triangles where an axis reverses, diamonds at corners." if marked else ""
    return what + sign + marks


def polar_charts(data: ReportData, points: int) -> tuple[PolarChart, ...]:
    """Return one ball-bar plot for each circle that any scheme went round."""
    names = dict.fromkeys(run.name for scheme in data.schemes for run in scheme.runs)
    return tuple(_polar(data, name, number, points) for number, name in enumerate(names))


def _polar(data: ReportData, name: str, index: int, points: int) -> PolarChart:
    """Return the plot of one circle: all schemes, both directions."""
    curves, marks, radius, top = [], [], 0.0, 0.0
    for place, scheme in enumerate(data.schemes):
        colour, _ = scheme_style(place, len(data.schemes))
        for run in (run for run in scheme.runs if run.name == name):
            kept = keep_extremes(run.deviation, points)
            way, dash = ("clockwise", "dash") if run.clockwise else ("counter-clockwise", "solid")
            angle = np.degrees(np.unwrap(run.angle))[kept]
            curves.append(Curve(angle, run.deviation[kept] * UM, f"{scheme.name}, {way}", colour, dash))
            at = np.asarray(run.spikes, dtype=np.int64)
            if at.size:
                marks.append(Curve(np.degrees(run.angle[at]), run.deviation[at] * UM, f"{scheme.name}, {way}", colour))
            radius, top = run.radius, max(top, reach(run.deviation) * UM)
    division, span = division_of(top)
    caption = (
        f"Nominal radius {figure(radius, 'mm', 6)}; one ring is {number(division, 6)} um of radial deviation, "
        f"magnified {number(radius * 1e6 / (2.0 * span))} times. Solid counter-clockwise, dashed clockwise."
        + (" Rings: the spikes where an axis turns, each at its highest." if marks else "")
    )
    return PolarChart(f"circle-{index}", name, caption, tuple(curves), division, (-2.0 * span, span), radius, tuple(marks))


def division_of(top: float) -> tuple[float, float]:
    """Return ring spacing and reach [um]: the deviations fill the outer part of the picture."""
    if top <= 0.0:
        return 1.0, 3.0
    division = round_down(top / 2.0)
    return division, division * float(np.ceil(1.05 * top / division))


@dataclass(frozen=True)
class CircleTable:
    """ISO 230-4 figures of one circle: a column per run, a row per figure."""

    name: str
    heads: tuple[str, ...]
    rows: tuple[tuple[str, tuple[str, ...]], ...]


def circle_tables(data: ReportData) -> tuple[CircleTable, ...]:
    """Return the ISO 230-4 figures, one table per circle."""
    found: dict[str, dict[str, dict[str, float]]] = {}
    for scheme in data.schemes:
        for run in scheme.runs:
            way = "clockwise" if run.clockwise else "counter-clockwise"
            found.setdefault(run.name, {})[f"{scheme.name}, {way}"] = dict(run.figures)
        for name, both in scheme.bidirectional.items():
            found.setdefault(name, {})[f"{scheme.name}, both"] = {
                "bi-directional circular deviation G(b)": both.circular_deviation,
                "mean bi-directional radial deviation D": both.mean_radial,
                "hysteresis H": both.hysteresis,
            }
    return tuple(_table(name, runs) for name, runs in found.items())


def _table(name: str, runs: dict[str, dict[str, float]]) -> CircleTable:
    """Return one table; a figure that a run does not have is a dash."""
    labels = dict.fromkeys(label for figures in runs.values() for label in figures)
    rows = tuple((label, tuple(figure(figures.get(label, math.nan), "um") for figures in runs.values())) for label in labels)
    return CircleTable(name, tuple(runs), rows)
