"""Figs 7 to 13 of Shahin, ElMaraghy & ElBeheiry."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from contourlab.papers.shahin import setup
from contourlab.papers.shahin.runs import trace
from contourlab.papers.shahin.setup import Setting
from contourlab.report.charts import Chart, Curve, PolarChart, ring_spacing, traces_chart
from contourlab.report.plots import write_charts
from contourlab.report.style import scheme_style

Array = NDArray[np.float64]


def draw(folder: str | Path, formats: Sequence[str]) -> tuple[Path, ...]:
    """Write the figures into a folder; return the files."""
    gap, none = Setting(), Setting(gap=0.0)
    baselines = {
        "on the motors, no backlash": trace("PI", none),
        "on the motors, 25 µm": trace("PI", gap),
        "closed over the loads, 25 µm": trace("PI on the load", gap),
    }
    deviations = {name: (run.angle, run.radial) for name, run in baselines.items()}
    charts: list[Chart | PolarChart] = [_circle("fig-7-8", "Figs 7, 8: PI on the circle at 8000 mm/min", deviations)]
    schemes = {name: trace(name, gap) for name in setup.SCHEMES}
    feeds = {f"scheme {name}": (run.time, run.axis_feed_error[:, 0] * 60.0) for name, run in schemes.items()}
    charts.append(traces_chart("fig-9", "Fig 9: feedrate error of x", ("time [s]", "feedrate error [m/min]"), feeds))
    errors = {
        f"scheme {name}, {axis}": (schemes[name].time, schemes[name].axis_error[:, j] * 1e6)
        for name in ("II", "III")
        for j, axis in enumerate(setup.AXES)
    }
    charts.append(traces_chart("fig-10", "Fig 10: axis errors of schemes II and III", ("time [s]", "axis error [µm]"), errors))
    for number, (name, run) in zip((11, 12, 13), schemes.items(), strict=True):
        rate = {f"scheme {name}": (run.time, run.feedrate * 60.0)}
        title = f"Fig {number}: overall feedrate, scheme {name}"
        charts.append(traces_chart(f"fig-{number}", title, ("time [s]", "feedrate [m/min]"), rate, level=8.0))
    return write_charts(charts, folder, formats)


def _circle(key: str, title: str, runs: Mapping[str, tuple[Array, Array]]) -> PolarChart:
    """Return radial deviations [m] over the angle [rad] round the circle."""
    division, span = ring_spacing(1e6 * max(float(np.abs(deviation).max()) for _, deviation in runs.values()))
    curves = tuple(
        Curve(np.degrees(np.unwrap(angle)), deviation * 1e6, name, *scheme_style(i, len(runs)))
        for i, (name, (angle, deviation)) in enumerate(runs.items())
    )
    caption = f"One ring is {division:g} µm of radial deviation."
    return PolarChart(key, title, caption, curves, division, (-2.0 * span, span), setup.RADIUS)
