"""Figures of the papers drawn again: convergence over trials, a turn from close by, a figure over a parameter."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from contourlab.report.charts import Chart, Curve, Level, Panel, PolarChart
from contourlab.report.error_pictures import division_of
from contourlab.report.study_charts import Multiples, Tile
from contourlab.report.style import REFERENCE, scheme_style

Array = NDArray[np.float64]


def course_chart(key: str, title: str, courses: Mapping[str, Array]) -> Chart:
    """Return the contour rms [m] of each trial, for some settings."""
    count = len(courses)
    curves = tuple(
        Curve(np.arange(len(rms), dtype=float), rms * 1e9, name, *scheme_style(i, count)) for i, (name, rms) in enumerate(courses.items())
    )
    return Chart(key, title, "Trial 0 has learned nothing.", (Panel("trial", "contour rms [nm]", curves, log_y=True),))


def turn_chart(key: str, title: str, time: Array, errors: Mapping[str, Array]) -> Chart:
    """Return contour errors [m] around a turn at time 0 [s]."""
    count = len(errors)
    curves = tuple(Curve(time, error * 1e9, name, *scheme_style(i, count)) for i, (name, error) in enumerate(errors.items()))
    panel = Panel("time from the turn [s]", "contour error [nm]", curves, (Level(0.0, ""),))
    return Chart(key, title, "Positive to the left of the direction of travel.", (panel,))


def sweep_chart(key: str, title: str, label: str, values: Sequence[float], curves: Mapping[str, Sequence[float]], paper: float) -> Chart:
    """Return figures over a parameter, with the paper's as a level."""
    x, count = np.array(values), len(curves)
    drawn = tuple(Curve(x, np.array(y), name, *scheme_style(i, max(count, 2))) for i, (name, y) in enumerate(curves.items()))
    level = Curve(x[[0, -1]], np.full(2, paper), f"paper: {paper:.3g}", REFERENCE, "dot")
    return Chart(key, title, "", (Panel(label, "ratio", (*drawn, level), log_x=True),))


Overlaid = tuple[str, Mapping[str, tuple[Array, Array, float, tuple[float, float] | None]]]
"""Label of x, and by name of the curve: x, y, the x that is in force, the place of the minimum."""


def overlaid_chart(key: str, title: str, y_label: str, tiles: Mapping[str, Overlaid]) -> Multiples:
    """Return small pictures of several curves each, with their minima and present values in the colour of the curve."""
    made = []
    for name, (label, curves) in tiles.items():
        # Curves that lie on one another are both seen where one is dashed.
        style = {curve: (scheme_style(i, len(curves))[0], ("solid", "dash", "dot")[i % 3]) for i, curve in enumerate(curves)}
        made.append(
            Tile(
                name,
                label,
                tuple(Curve(x, y, curve, *style[curve]) for curve, (x, y, _, _) in curves.items()),
                tuple((*lowest, style[curve][0]) for curve, (_, _, _, lowest) in curves.items() if lowest is not None),
                tuple((here, style[curve][0]) for curve, (_, _, here, _) in curves.items()),
                log_x=True,
            )
        )
    return Multiples(key, title, "", y_label, tuple(made))


def traces_chart(
    key: str,
    title: str,
    labels: tuple[str, str],
    traces: Mapping[str, tuple[Array, Array]],
    level: float = 0.0,
    span: tuple[float, float] | None = None,
    span_label: str = "",
) -> Chart:
    """Return curves (x, y), each in the units of its label, on one pair of axes, with a level, and a shaded span of x if there is one."""
    count = len(traces)
    curves = tuple(Curve(x, y, name, *scheme_style(i, count)) for i, (name, (x, y)) in enumerate(traces.items()))
    return Chart(key, title, "", (Panel(*labels, curves, (Level(level, ""),), span=span, span_label=span_label),))


def circle_chart(key: str, title: str, radius: float, runs: Mapping[str, tuple[Array, Array]]) -> PolarChart:
    """Return radial deviations [m] over the angle [rad] around a circle of a radius [m]."""
    count, top = len(runs), max(float(np.abs(deviation).max()) for _, deviation in runs.values())
    division, span = division_of(top * 1e6)
    curves = tuple(
        Curve(np.degrees(np.unwrap(angle)), deviation * 1e6, name, *scheme_style(i, count))
        for i, (name, (angle, deviation)) in enumerate(runs.items())
    )
    return PolarChart(key, title, f"One ring is {division:g} um of radial deviation.", curves, division, (-2.0 * span, span), radius)
