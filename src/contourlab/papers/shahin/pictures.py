"""Figs 7 to 13 of Shahin, ElMaraghy & ElBeheiry."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from contourlab.arrays import Array
from contourlab.papers.shahin import setup
from contourlab.papers.shahin.runs import third_lap
from contourlab.papers.shahin.setup import Setting
from contourlab.rendering.charts import Chart, Curve, Level, PolarChart, traces_chart
from contourlab.rendering.plots import write_charts
from contourlab.rendering.style import scheme_style


def draw(folder: str | Path, formats: Sequence[str]) -> tuple[Path, ...]:
    """Write the figures into a folder; return the files."""
    gap, none = Setting(), Setting(gap=0.0)
    baselines = {
        "motor feedback, no backlash": third_lap("PI", none),
        "motor feedback, 25 um backlash": third_lap("PI", gap),
        "load feedback, 25 um backlash": third_lap("PI on the load", gap),
    }
    charts: list[Chart | PolarChart] = [_circle("shahin-fig-7-8", "Figs 7, 8: PI on the circle at 8000 mm/min", baselines)]
    schemes = {name: third_lap(name, gap) for name in setup.SCHEMES}
    feeds = {
        f"scheme {name}": (run["time"], (run["reference_velocity"] - run["axis_velocity"])[:, 0] * 60.0) for name, run in schemes.items()
    }
    charts.append(traces_chart("shahin-fig-9", "Fig 9: feedrate error of x", ("time [s]", "feedrate error [m/min]"), feeds))
    errors = {
        f"scheme {name}, {axis}": (run["time"], (run["reference"] - run["axis_position"])[:, j] * 1e6)
        for name, run in list(schemes.items())[1:]
        for j, axis in enumerate(setup.AXES)
    }
    charts.append(traces_chart("shahin-fig-10", "Fig 10: axis errors of schemes II and III", ("time [s]", "axis error [um]"), errors))
    for number, (name, run) in zip((11, 12, 13), schemes.items(), strict=True):
        rate = {f"scheme {name}": (run["time"], np.hypot(*run["axis_velocity"].T) * 60.0)}
        title = f"Fig {number}: overall feedrate, scheme {name}"
        charts.append(traces_chart(f"shahin-fig-{number}", title, ("time [s]", "feedrate [m/min]"), rate, level=Level(8.0, "")))
    return write_charts(charts, folder, formats)


def _circle(key: str, title: str, runs: Mapping[str, Mapping[str, Array]]) -> PolarChart:
    """Return the radial deviations around the circle."""
    curves = []
    for i, (name, run) in enumerate(runs.items()):
        x, y = run["axis_position"].T
        deviation = (np.hypot(x, y) - setup.RADIUS) * 1e6
        curves.append(Curve(np.degrees(np.unwrap(np.arctan2(y, x))), deviation, name, *scheme_style(i, len(runs))))
    chart = PolarChart(key, title, "", tuple(curves), setup.RADIUS)
    return replace(chart, caption=f"Ring spacing {chart.spacing[0]:g} um of radial deviation.")
