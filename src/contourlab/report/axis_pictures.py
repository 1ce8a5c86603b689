"""What each axis did, against its limits, and how its loop answers each frequency."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.figures import number, shown_unit
from contourlab.report.charts import Chart, Curve, Level, Panel
from contourlab.report.data import AxisBounds, ReportData
from contourlab.report.decimate import keep_extremes
from contourlab.report.read import axis_column, has, reach, times
from contourlab.report.style import REFERENCE, scheme_style

Array = NDArray[np.float64]
OFF_SCALE = 4.0  # a peak this many times beyond the limit is told, not drawn, or it would flatten all else
DEEPEST = 120.0  # dB below the largest: what is deeper is rounding
FAR = 0.08  # curves below this part of the limit are drawn without it, or they would be flat


def axis_charts(data: ReportData, points: int) -> tuple[Chart, ...]:
    """Return one chart per axis: tracking error, velocity, acceleration, jerk, command.

    Parameters
    ----------
    data : ReportData
    points : int
        Most points of a curve.
    """
    return tuple(_axis_chart(data, axis, name, points) for axis, name in enumerate(data.axes))


def _axis_chart(data: ReportData, axis: int, name: str, points: int) -> Chart:
    """Return the chart of one axis; a signal that no scheme holds has no panel."""
    panels = (
        _runs(data, axis, points, "tracking_error", "tracking error", 1e6, "um"),
        _velocity(data, axis, points),
        _planned(data, axis, points, "acceleration"),
        _planned(data, axis, points, "jerk"),
        _command(data, axis, points),
    )
    drawn = tuple(panel for panel in panels if panel is not None)
    told = [text for panel in drawn if (text := _off_scale(panel))]
    bounded = ["Dashed lines are the limits."] if any(panel.levels for panel in drawn) else []
    planned = ["Acceleration and jerk are those of the reference."] if _reference_of(data, "reference_acceleration") is not None else []
    caption = " ".join([*bounded, *planned, *told])
    return Chart(f"axis-{axis}", f"Axis {name}", caption, drawn)


def _curve(result: Any, values: Array, points: int, factor: float, look: tuple[str, str, str]) -> Curve:
    """Return a thinned curve over time; `look` is name, colour and dash."""
    kept = keep_extremes(values, points)
    return Curve(times(result, kept), values[kept] * factor, *look)


def _runs(data: ReportData, axis: int, points: int, signal: str, label: str, factor: float, unit: str) -> Panel | None:
    """Return a panel with one signal of every scheme."""
    curves = tuple(
        _curve(scheme.result, axis_column(scheme.result, signal, axis), points, factor, (scheme.name, *style))
        for index, scheme in enumerate(data.schemes)
        if has(scheme.result, signal)
        for style in (scheme_style(index, len(data.schemes)),)
    )
    return Panel("time [s]", f"{label} [{unit}]", curves) if curves else None


def _limited(panel: Panel, bounds: AxisBounds | None, name: str, axis: int, factor: float, unit: str) -> Panel:
    """Return the panel with its two limit lines and a range that flattens neither them nor the curves."""
    limit = bounds.of(name, axis) * factor if bounds is not None else float("inf")
    if not np.isfinite(limit):
        return panel
    text = f"limit ±{number(limit, 6)} {unit}"
    top = max(reach(curve.y) for curve in panel.curves)
    far = 0.0 < top < FAR * limit
    edge = 1.25 * (top if far else limit if top > OFF_SCALE * limit else max(limit, top))
    return replace(panel, levels=(Level(limit, text), Level(-limit, "")), y_range=(-edge, edge), far=far)


def _off_scale(panel: Panel) -> str:
    """Say which peak lies outside a panel, if any."""
    if panel.y_range is None or max(reach(curve.y) for curve in panel.curves) <= panel.y_range[1]:
        return ""
    what, _, unit = panel.y_label.partition(" [")
    worst = max(panel.curves, key=lambda curve: reach(curve.y))
    at = int(np.nanargmax(np.abs(worst.y)))
    peak = f"{number(float(worst.y[at]))} {unit.rstrip(']')}"
    return f"{what.capitalize()} peaks at {peak} at {number(float(worst.x[at]), 4)} s, outside the picture."


def _bounds(data: ReportData) -> AxisBounds | None:
    """Return the limits that the schemes share: those of the first that has any."""
    return next((scheme.bounds for scheme in data.schemes if scheme.bounds is not None), None)


def _reference_of(data: ReportData, signal: str) -> Any:
    """Return the first result that holds a signal of the reference; the schemes follow one reference."""
    return next((scheme.result for scheme in data.schemes if has(scheme.result, signal)), None)


def _velocity(data: ReportData, axis: int, points: int) -> Panel | None:
    """Return the velocity of every scheme over that of the reference."""
    factor, unit = shown_unit("m/s")
    panel = _runs(data, axis, points, "velocity", "velocity", factor, unit)
    source = _reference_of(data, "reference_velocity")
    if source is not None:
        wanted = axis_column(source, "reference_velocity", axis)
        curve = _curve(source, wanted, points, factor, ("reference", REFERENCE, "dot"))
        panel = Panel("time [s]", f"velocity [{unit}]", (curve, *(panel.curves if panel else ())))
    return _limited(panel, _bounds(data), "velocity", axis, factor, unit) if panel is not None else None


def _planned(data: ReportData, axis: int, points: int, name: str) -> Panel | None:
    """Return acceleration or jerk of the reference; jerk is its difference over a servo period."""
    source = _reference_of(data, "reference_acceleration")
    if source is None:
        return None
    values = axis_column(source, "reference_acceleration", axis)
    if name == "jerk":
        if values.size < 2:
            return None
        values = np.diff(values) / float(source.servo_period)
    unit = "m/s^2" if name == "acceleration" else "m/s^3"
    curve = _curve(source, values, points, 1.0, ("reference", REFERENCE, "solid"))
    return _limited(Panel("time [s]", f"{name} [{unit}]", (curve,)), _bounds(data), name, axis, 1.0, unit)


def _command(data: ReportData, axis: int, points: int) -> Panel | None:
    """Return the command of every scheme against saturation."""
    source = _reference_of(data, "command")
    if source is None:
        return None
    factor, unit = shown_unit(str(source.signals["command"].unit))
    panel = _runs(data, axis, points, "command", "command", factor, unit or "1")
    return _limited(panel, _bounds(data), "command", axis, factor, unit) if panel is not None else None


def bode_charts(data: ReportData, points: int) -> tuple[Chart, ...]:
    """Return the frequency response of the closed loop of each axis that any scheme has one for."""
    charts = []
    for index, axis in enumerate(data.axes):
        with_axis = [(i, scheme) for i, scheme in enumerate(data.schemes) if axis in scheme.bode]
        if not with_axis:
            continue
        gains, phases, notes = [], [], []
        for i, scheme in with_axis:
            answer, look = scheme.bode[axis], (scheme.name, *scheme_style(i, len(data.schemes)))
            with np.errstate(divide="ignore"):
                gain = 20.0 * np.log10(np.abs(answer.response))
            phase = np.degrees(np.unwrap(np.angle(answer.response)))
            kept = keep_extremes(gain, points)
            gains.append(Curve(answer.frequency[kept], gain[kept], *look))
            phases.append(Curve(answer.frequency[kept], phase[kept], *look))
            figures = ", ".join(f"{name} {value}" for name, value in answer.notes.items())
            said = ", ".join(text for text in (answer.meant, figures) if text)
            notes += [f"{scheme.name}: {said}."] * bool(said)
        magnitude = Panel("frequency [Hz]", "magnitude [dB]", tuple(gains), (Level(-3.0, "−3 dB"),), log_x=True, y_range=_decibels(gains))
        phase_panel = Panel("frequency [Hz]", "phase [deg]", tuple(phases), log_x=True)
        caption = " ".join(["Reference to position, closed loop.", *notes])
        charts.append(Chart(f"bode-{index}", f"Axis {axis}", caption, (magnitude, phase_panel)))
    return tuple(charts)


def _decibels(gains: list[Curve]) -> tuple[float, float] | None:
    """Return the range of magnitudes that is drawn where a zero at the Nyquist frequency would leave nothing of the rest to be seen."""
    values = np.concatenate([gain.y[np.isfinite(gain.y)] for gain in gains])
    if not values.size or np.ptp(values) <= DEEPEST:
        return None
    return float(values.max()) - DEEPEST, float(values.max()) + 0.05 * DEEPEST
