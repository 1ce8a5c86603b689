"""Figs 6 to 9 of Ghaffari & Ulsoy, with what the paper says of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import numpy as np

from contourlab.arrays import Array, Complex
from contourlab.features.sensitivity.curves import Curve as Study
from contourlab.papers.ghaffari.linear import BASE, closed_loop, fig_8
from contourlab.papers.ghaffari.runs import PRINTED, run
from contourlab.papers.ghaffari.sensitivity import axis_curves
from contourlab.papers.ghaffari.setup import AXES, TABLE_3, Reading
from contourlab.rendering.charts import Chart, Curve, Level, Multiples, Panel, Tile
from contourlab.rendering.plots import write_charts
from contourlab.rendering.style import MUTED, scheme_style

FIGURES = {
    "fig-6a": ("Fig 6(a): observer, around Table III", ("a_hat", "b_hat")),
    "fig-6b": ("Fig 6(b): feedforward, around Table III", ("a'", "b'")),
    "fig-7": ("Fig 7: position control, around Table III", ("K_V", "K_P", "K_I")),
}


def draw(folder: str | Path, formats: Sequence[str]) -> tuple[Path, ...]:
    """Write the figures into a folder; return the files."""
    studies = {f"axis {number}": axis_curves(number) for number in AXES}
    charts: list[Chart | Multiples] = []
    for key, (title, symbols) in FIGURES.items():
        tiles = tuple(_tile(symbol, {axis: curves[symbol] for axis, curves in studies.items()}) for symbol in symbols)
        charts.append(Multiples(f"ghaffari-{key}", title, "", "contour error integral [um s]", tiles))
    return write_charts((*charts, _fig_8(), _fig_9()), folder, formats)


def _fig_8() -> Chart:
    """Return the closed loop with a' and b' varied; the paper calls the variation negligible."""
    w = np.geomspace(0.5, 200.0, 300)
    looks = [(f"a' {a:g}, b' {b:g}", response, (a, b) == BASE) for (a, b), response in fig_8(w, closed_loop).items()]
    sides: dict[str, Callable[[Complex], Array]] = {
        "magnitude [dB]": lambda x: 20.0 * np.log10(np.abs(x)),
        "phase [deg]": lambda x: np.degrees(np.unwrap(np.angle(x))),
    }
    blue, grey = scheme_style(0, 1)[0], MUTED
    panels = []
    for label, side in sides.items():
        varied = [Curve(w, side(x), "a' and b' varied by 25 %", grey, width=0.8) for _, x, base in looks if not base]
        (middle,) = (Curve(w, side(x), name, blue, width=1.8) for name, x, base in looks if base)
        low, high = (float(pick(middle.y)) for pick in (np.min, np.max))
        circle = Curve(np.full(2, np.pi), np.array([low, high]), "the circle of Fig 9, 0.5 Hz", grey, "dot")
        panels.append(Panel("angular frequency [rad/s]", label, (*varied, middle, circle), log_x=True))
    title = "Fig 8: closed loop, K_V 0.1, K_P 4, K_I 11.8. The paper: the variation is negligible"
    return Chart("ghaffari-fig-8", title, "", tuple(panels))


def _fig_9() -> Chart:
    """Return the contour error of the second lap, with the printed times of the spikes and the means of the printed integrals."""
    panels = []
    for i, first in enumerate((1, 2)):
        judged, reference, _ = run(first, TABLE_3, Reading())
        start, stop = reference.laps[-1]
        error = judged["contour_error"][start:stop] * 1e6
        time = judged.time[start:stop]
        curve = Curve(time, error, f"A3-A{first}", *scheme_style(i, 2))
        marks = [_mark(at, error, "paper: spikes at 2, 2.5, 3 and 3.5 s") for at in (2.0, 2.5, 3.0, 3.5)]
        level = Level(PRINTED[first] / 2.0, f"paper: {PRINTED[first]} um s, a mean of {PRINTED[first] / 2.0:.2f} um")
        panels.append(Panel("time [s]", "contour error [um]", (*marks, curve), (level,)))
    return Chart("ghaffari-fig-9", "Fig 9: the circle under Table III", "", tuple(panels))


def _mark(at: float, error: Array, name: str) -> Curve:
    return Curve(np.full(2, at), np.array([error.min(), error.max()]), name, MUTED, "dot")


def _tile(symbol: str, studies: Mapping[str, Study]) -> Tile:
    """Return the curves of a parameter, with minima and current values in the colour of the curve."""
    curves, marks, present = [], [], []
    for i, (axis, study) in enumerate(studies.items()):
        # Different dashes keep coinciding curves visible.
        colour, dash = scheme_style(i, len(studies))[0], ("solid", "dash", "dot")[i]
        values = np.array([study.variable.display_value(value) for value in study.values])
        figures = study.figures * 1e6
        present.append((study.variable.display_value(study.variable.value), colour))
        if study.minimum is not None:
            marks.append((study.variable.display_value(study.minimum.value), study.minimum.figure * 1e6, colour))
            at = int(np.searchsorted(values, marks[-1][0]))  # between two values of the curve
            values, figures = (np.insert(curve, at, mark) for curve, mark in ((values, marks[-1][0]), (figures, marks[-1][1])))
        curves.append(Curve(values, figures, axis, colour, dash))
    label = f"{symbol} [{next(iter(studies.values())).variable.display}]"
    return Tile(symbol, label, tuple(curves), tuple(marks), tuple(present), log_x=True)
