"""Motor less load over the load's place: the loop that backlash makes, with its flanks."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.figures import figure
from contourlab.report.charts import Chart, Curve, Panel
from contourlab.report.data import ReportData, SchemeReport
from contourlab.report.decimate import keep_extremes
from contourlab.report.read import axis_column, has, reach
from contourlab.report.style import LIMIT, scheme_style

Array = NDArray[np.float64]
UM = 1e6
FINER = 4  # as many points as a curve over time: a loop is passed many times


def hysteresis_charts(data: ReportData, points: int) -> tuple[Chart, ...]:
    """Return one chart for each axis with a motor and a load, with a panel for each scheme.

    Parameters
    ----------
    data : ReportData
    points : int
        Most points of a curve over time.
    """
    return tuple(chart for i, axis in enumerate(data.axes) if (chart := _chart(data, i, axis, points)) is not None)


def _chart(data: ReportData, axis: int, name: str, points: int) -> Chart | None:
    shown = [(i, scheme) for i, scheme in enumerate(data.schemes) if name in scheme.gaps and has(scheme.result, "motor_position")]
    if not shown:
        return None
    panels, notes = [], []
    for i, scheme in shown:
        x, y = _loop(scheme.result, axis, FINER * points)
        panels.append((Curve(x, y, scheme.name, *scheme_style(i, len(data.schemes)), 1.0), *_flanks(scheme, name, x)))
        notes.append(_note(scheme, name, x, y))
    edge = 1.15 * max(reach(curve.y) for curves in panels for curve in curves) or 1.0
    drawn = tuple(Panel("load position [mm]", "motor − load [um]", curves, y_range=(-edge, edge)) for curves in panels)
    caption = f"Between the dashed flanks the motor turns without the load; beyond, the shaft is wound up. {' '.join(notes)}"
    return Chart(f"backlash-{axis}", f"Axis {name}: motor less load over the load's position", caption, drawn, loops=True)


def _loop(result: Any, axis: int, points: int) -> tuple[Array, Array]:
    """Return load position [mm] and motor less load [um], thinned in the order of time."""
    load = axis_column(result, "axis_position", axis)
    apart = axis_column(result, "motor_position", axis) - load
    kept = keep_extremes(np.column_stack([load, apart]), points)
    return load[kept] * 1e3, apart[kept] * UM


def _flanks(scheme: SchemeReport, axis: str, x: Array) -> tuple[Curve, Curve]:
    """Return the two flanks of the gap [um] over the part of the travel that was used."""
    place, width = scheme.gaps[axis]
    low, high = float(np.nanmin(x)), float(np.nanmax(x))
    inside = place[(place * 1e3 > low) & (place * 1e3 < high)] * 1e3
    at = np.concatenate([[low], inside, [high]])
    half = 0.5 * np.interp(at * 1e-3, place, width) * UM
    return Curve(at, half, "flanks of the gap", LIMIT, "dash"), Curve(at, -half, "flanks of the gap", LIMIT, "dash")


def _note(scheme: SchemeReport, axis: str, x: Array, y: Array) -> str:
    """Say how wide the gap is, and by how much the shaft was wound up at most."""
    place, width = scheme.gaps[axis]
    wide, narrow = float(width.max()), float(width.min())
    gap = figure(wide, "um", 6) if wide == narrow else f"{figure(narrow, 'um', 6)} to {figure(wide, 'um', 6)}"
    twist = np.abs(y) / UM - 0.5 * np.interp(x * 1e-3, place, width)
    return f"{scheme.name}: free travel {gap}, wind-up at most {figure(max(float(np.nanmax(twist)), 0.0), 'um')}."
