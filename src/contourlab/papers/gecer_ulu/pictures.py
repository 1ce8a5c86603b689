"""Figs 9 and 10 of Gecer Ulu et al., and the benefit of coupling over kappa."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.papers.gecer_ulu.convergence import convergence, turn
from contourlab.papers.gecer_ulu.learning import RATIO
from contourlab.papers.gecer_ulu.setup import EXPERIMENT, SIMULATION, TABLE_2
from contourlab.rendering.charts import traces_chart
from contourlab.rendering.plots import write_charts


def draw(rows: Sequence[Mapping[str, Any]], folder: str | Path, formats: Sequence[str]) -> tuple[Path, ...]:
    """Write the figures into a folder; `rows` are those of the reproduction. Return the files."""
    courses: dict[str, tuple[Array, Array]] = {}
    for setting in (SIMULATION, EXPERIMENT):
        rms = convergence(setting)
        courses[setting] = np.arange(len(rms), dtype=float), rms * 1e9
    title = "Fig 9: contour rms over trials, FB CCC ILC"
    labels, caption = ("trial", "contour rms [nm]"), "Before trial 0 nothing is learned."
    charts = [traces_chart("fig-9", title, labels, courses, caption=caption, level=None, log_y=True)]
    labels, caption = ("time from the turn [s]", "contour error [nm]"), "Positive to the left of the direction of travel."
    for setting in (SIMULATION, EXPERIMENT):
        seen = turn(setting)
        errors = {"FB": (seen.time, seen.feedback_contour * 1e9), "FB CCC ILC": (seen.time, seen.learned_contour * 1e9)}
        charts.append(traces_chart(f"fig-10-{setting}", f"Fig 10: around the tight turn, {setting}", labels, errors, caption=caption))
    ratios = {float(row["case"].rpartition(" ")[2]): row["here"] for row in rows if row["name"] == RATIO}
    kappa, paper = np.array(list(ratios)), TABLE_2["FB CCC ILC"][2] / TABLE_2["FB ILC"][2]
    curves = {"here, 30 trials": (kappa, np.array(list(ratios.values()))), f"paper: {paper:.3g}": (kappa[[0, -1]], np.full(2, paper))}
    charts.append(
        traces_chart("kappa", "Contour rms of FB CCC ILC / FB ILC", ("kappa", "ratio"), curves, level=None, log_x=True)
    )
    return write_charts(charts, folder, formats)
