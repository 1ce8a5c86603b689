"""Figs 9 and 10 of Gecer Ulu et al., with the printed figures."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from contourlab.papers.gecer_ulu.convergence import convergence, turn
from contourlab.papers.gecer_ulu.tables import TABLES
from contourlab.rendering.charts import Chart, Level, traces_chart
from contourlab.rendering.plots import write_charts


def draw(folder: str | Path, formats: Sequence[str]) -> tuple[Path, ...]:
    """Write the figures into a folder and return the files."""
    return write_charts([made(setting) for setting in TABLES for made in (_fig_9, _fig_10)], folder, formats)


def _fig_9(setting: str) -> Chart:
    rms = 1e9 * convergence(setting)
    labels, caption = ("trial", "contour rms by eq (10) [nm]"), "Before trial 0 nothing is learned."
    title, curves = f"Fig 9: learning over trials, {setting}", {"FB CCC ILC": (np.arange(len(rms), dtype=float), rms)}
    chart = traces_chart(f"gecer-ulu-fig-9-{setting}", title, labels, curves, caption=caption, log_y=True)
    printed = (TABLES[setting][scheme][2] for scheme in ("FB CCC", "FB CCC ILC"))
    levels = tuple(Level(value, text) for value, text in zip(printed, ("printed before and after learning", ""), strict=True))
    return replace(chart, panels=(replace(chart.panels[0], levels=levels),))


def _fig_10(setting: str) -> Chart:
    seen, title = turn(setting), f"Fig 10: around the tight turn, {setting}"
    errors = {"FB": (seen.time, seen.feedback_contour * 1e9), "FB CCC ILC": (seen.time, seen.learned_contour * 1e9)}
    caption = "Exact, positive to the left. The paper finds the largest errors just after the turn."
    return traces_chart(f"gecer-ulu-fig-10-{setting}", title, ("time from the turn [s]", "contour error [nm]"), errors, caption=caption)
