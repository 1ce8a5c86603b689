"""Figs 6 and 7 of Ghaffari & Ulsoy."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from contourlab.features.sensitivity.curves import Curve as Study
from contourlab.papers.ghaffari.sensitivity import axis_curves
from contourlab.papers.ghaffari.setup import AXES
from contourlab.rendering.charts import Curve, Multiples, Tile
from contourlab.rendering.plots import write_charts
from contourlab.rendering.style import scheme_style

FIGURES = {
    "fig-6a": ("Fig 6(a): observer, around Table III", ("a_hat", "b_hat")),
    "fig-6b": ("Fig 6(b): feedforward, around Table III", ("a'", "b'")),
    "fig-7": ("Fig 7: position control, around Table III", ("K_V", "K_P", "K_I")),
}


def draw(folder: str | Path, formats: Sequence[str]) -> tuple[Path, ...]:
    """Write the figures into a folder; return the files."""
    studies = {f"axis {number}": axis_curves(number) for number in AXES}
    charts = []
    for key, (title, symbols) in FIGURES.items():
        tiles = tuple(_tile(symbol, {axis: curves[symbol] for axis, curves in studies.items()}) for symbol in symbols)
        charts.append(Multiples(key, title, "", "contour error integral [um s]", tiles))
    return write_charts(charts, folder, formats)


def _tile(symbol: str, studies: Mapping[str, Study]) -> Tile:
    """Return the curves of a parameter, with minima and current values in the colour of the curve."""
    curves, marks, present = [], [], []
    for i, (axis, study) in enumerate(studies.items()):
        # Different dashes keep coinciding curves visible.
        colour, dash = scheme_style(i, len(studies))[0], ("solid", "dash", "dot")[i]
        values = np.array([study.variable.display_value(value) for value in study.values])
        curves.append(Curve(values, study.figures * 1e6, axis, colour, dash))
        present.append((study.variable.display_value(study.variable.value), colour))
        if study.minimum is not None:
            marks.append((study.variable.display_value(study.minimum.value), study.minimum.figure * 1e6, colour))
    label = f"{symbol} [{next(iter(studies.values())).variable.display}]"
    return Tile(symbol, label, tuple(curves), tuple(marks), tuple(present), log_x=True)
