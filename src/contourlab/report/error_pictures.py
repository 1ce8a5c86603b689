"""The error over time and along the path, and round each circle."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from contourlab.report.charts import Chart, Curve, Panel, PolarChart, Tick
from contourlab.report.data import CircleRun, ReportData
from contourlab.report.decimate import keep_extremes
from contourlab.report.read import error_signal, has, reach, signal, times
from contourlab.report.style import scheme_style
from contourlab.report.text import nominal, number, quantity, round_down

__all__ = ["error_charts", "polar_charts"]

UM = 1e6
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
    label = f"{name.replace('_', ' ')} [µm]"
    caption = _caption(data, name, signed)
    panel = _panel(data, "time [s]", label, tuple(over_time), signed, _moments(data))
    charts = [Chart("error-time", "Error over time", caption, (panel,))]
    if len(over_arc) == len(data.schemes):
        places = np.asarray(data.planned.corners, dtype=np.float64).ravel() * 1e3
        corners = tuple(Tick(float(s), "corner", "corner") for s in (places if places.size <= CORNERS else ()))
        panel = _panel(data, "arc length [mm]", label, tuple(over_arc), signed, corners)
        caption = "The same error over the progress along the path."
        charts.append(Chart("error-arc", "Error along the path", caption, (panel,)))
    return tuple(charts)


CORNERS = 400  # marks beyond this many would be a grey wall


def _moments(data: ReportData) -> tuple[Tick, ...]:
    """Return the reversals and corners of the last scheme as marks on the time axis."""
    marks = sorted(data.schemes[-1].spikes, key=lambda mark: mark.time)
    marked = marks if len(marks) <= CORNERS else sorted(marks, key=lambda mark: -np.nan_to_num(mark.height))[:CORNERS]
    heights = (f", spike {quantity(m.height, 'µm', UM)}" if np.isfinite(m.height) else "" for m in marked)
    return tuple(Tick(m.time, m.label + text, m.kind) for m, text in zip(marked, heights, strict=True))


def _panel(
    data: ReportData, x_label: str, y_label: str, curves: tuple[Curve, ...], signed: bool, ticks: tuple[Tick, ...]
) -> Panel:
    """Return one panel of errors with its tolerance band; a band far beyond the errors is left out."""
    band, text, y_range = None, "", None
    if data.tolerance is not None:
        edge = data.tolerance * UM
        band = (-edge, edge) if signed else (0.0, edge)
        text = f"tolerance {'±' if signed else ''}{nominal(edge, 'µm')}"
        top = max(reach(curve.y) for curve in curves)
        if 0.0 < top < edge / 4:
            y_range = (-1.15 * top if signed else 0.0, 1.15 * top)
    return Panel(x_label, y_label, curves, band=band, band_label=text, ticks=ticks, y_range=y_range)


def _caption(data: ReportData, name: str, signed: bool) -> str:
    """Say what the error is and how its sign is meant."""
    what = {
        "part_error": "Part error: shortest distance from the tool to the programmed path.",
        "contour_error": "Contour error: shortest distance from the machine's position to the planned path.",
    }[name]
    sign = " Positive to the left of the direction of travel." if signed else ""
    marks = " Marks below: triangles where an axis reverses, diamonds at corners." if data.schemes[-1].spikes else ""
    return what + sign + marks


def polar_charts(data: ReportData, points: int) -> tuple[PolarChart, ...]:
    """Return one ball-bar plot for each circle that any scheme went round."""
    names = dict.fromkeys(run.name for scheme in data.schemes for run in scheme.circles)
    return tuple(_polar(data, name, number, points) for number, name in enumerate(names))


def _polar(data: ReportData, name: str, index: int, points: int) -> PolarChart:
    """Return the plot of one circle: all schemes, both directions."""
    curves, radius, top = [], 0.0, 0.0
    for place, scheme in enumerate(data.schemes):
        colour, _ = scheme_style(place, len(data.schemes))
        for run in (run for run in scheme.circles if run.name == name):
            kept = keep_extremes(run.deviation, points)
            way, dash = ("clockwise", "dash") if run.clockwise else ("counter-clockwise", "solid")
            angle = np.degrees(np.unwrap(run.angle))[kept]
            curves.append(Curve(angle, run.deviation[kept] * UM, f"{scheme.name}, {way}", colour, dash))
            radius, top = run.radius, max(top, reach(run.deviation) * UM)
    division, span = _division(top)
    caption = (
        f"Nominal radius {nominal(radius, 'mm', 1e3)}; one ring is {nominal(division, 'µm')} of radial deviation, "
        f"magnified {number(radius * 1e6 / (2.0 * span))} times. Solid counter-clockwise, dashed clockwise."
    )
    return PolarChart(f"circle-{index}", name, caption, tuple(curves), division, (-2.0 * span, span), radius)


def _division(top: float) -> tuple[float, float]:
    """Return ring spacing and reach [um]: the deviations fill the outer part of the picture."""
    if top <= 0.0:
        return 1.0, 3.0
    division = round_down(top / 2.0)
    return division, division * float(np.ceil(1.05 * top / division))


def circle_figures(data: ReportData) -> tuple[tuple[str, str, str, str], ...]:
    """Return rows (circle, run, figure, value) of the ISO 230-4 figures."""
    return tuple(
        (run.name, _run_name(scheme.name, run), figure, quantity(value, "µm", UM))
        for scheme in data.schemes
        for run in scheme.circles
        for figure, value in run.figures.items()
    )


def _run_name(scheme: str, run: CircleRun) -> str:
    """Name one run of a scheme."""
    return f"{scheme}, {'clockwise' if run.clockwise else 'counter-clockwise'}"
