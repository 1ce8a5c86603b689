"""Pictures of studies drawn by matplotlib."""

from __future__ import annotations

from textwrap import fill
from typing import TYPE_CHECKING, Any

import numpy as np

from contourlab.report.matplotlib_view import WIDTH, curve_look, logarithmic, plain, plain_numbers
from contourlab.report.study_charts import Bars, Matrix, Multiples, Tile
from contourlab.report.style import INK, LIMIT, MUTED

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

NUMBERED = 16
"""A matrix of more names than this has no numbers in its cells."""
SMALLEST, LETTERS = 3.4, 38
"""Height of a matrix of few names [in], which has room for lines of so many letters beside it."""


def _figure(width: float, height: float) -> Figure:
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), layout="constrained")


def multiples_drawing(chart: Multiples) -> Figure:
    """Return small pictures side by side, all with one y axis."""
    columns = min(chart.columns, len(chart.tiles))
    rows = -(-len(chart.tiles) // columns)
    figure = _figure(WIDTH, 0.9 + 1.75 * rows)
    axes = figure.subplots(rows, columns, sharey=True, squeeze=False)
    for place, tile in zip(axes.ravel(), chart.tiles, strict=False):
        _tile(place, tile)
    for place in axes.ravel()[len(chart.tiles) :]:
        place.set_visible(False)
    if chart.log_y:
        logarithmic(axes[0, 0])
    figure.suptitle(plain(chart.title), fontsize=9.5, fontweight="bold", x=0.01, ha="left")
    figure.supylabel(plain(chart.y_label), fontsize=8.5)
    entries: dict[str, Any] = {}
    for place in axes.ravel():
        for handle, name in zip(*place.get_legend_handles_labels(), strict=True):
            entries.setdefault(name, handle)
    if entries:
        figure.legend(list(entries.values()), list(entries), loc="outside lower left", ncols=min(len(entries), 5))
    return figure


def _tile(place: Axes, tile: Tile) -> None:
    for low, high in tile.shaded:
        place.axvspan(low, high, color=LIMIT, alpha=0.18, linewidth=0, label="runs fail")
    for x, colour in tile.here:
        place.axvline(x, color=colour, linewidth=0.8, linestyle=":", label="present value")
    for curve in tile.curves:
        place.plot(curve.x, curve.y, label=plain(curve.name), **curve_look(curve))
    for x, y, colour in tile.marks:
        ring: dict[str, Any] = {"marker": "o", "markersize": 4.5, "markerfacecolor": "none", "linestyle": "none", "color": colour}
        place.plot([x], [y], label="minimum", **ring)
    if tile.log_x:
        place.set_xscale("log")
        plain_numbers(place.xaxis)
    place.margins(x=0.02)
    place.tick_params(labelsize=7)
    place.set_title(plain(tile.title), fontsize=8, fontweight="normal")
    place.set_xlabel(plain(tile.x_label), fontsize=7)


def bars_drawing(chart: Bars) -> Figure:
    """Return bars beside their names, with their intervals."""
    n, m = len(chart.names), len(chart.series)
    figure = _figure(WIDTH, 1.2 + 0.28 * n)
    place = figure.add_subplot()
    height = 0.8 / m
    for i, series in enumerate(chart.series):
        at = np.arange(n) - 0.4 + height * (i + 0.5)
        style: dict[str, Any] = {"error_kw": {"ecolor": INK, "elinewidth": 0.8}, "capsize": 2}
        place.barh(at, series.values, height=0.92 * height, xerr=series.intervals, color=series.colour, label=plain(series.name), **style)
    place.set_yticks(np.arange(n), [plain(name) for name in chart.names])
    place.invert_yaxis()
    place.axvline(0.0, color=MUTED, linewidth=0.8)
    place.grid(visible=False, axis="y")
    place.set_xlabel(plain(chart.x_label))
    place.set_title(plain(chart.title), pad=6)
    figure.legend(loc="outside lower left", ncols=m)
    return figure


def matrix_drawing(chart: Matrix) -> Figure:
    """Return a matrix in colours, with its numbers where they have room."""
    n = len(chart.names)
    figure = _figure(WIDTH, max(SMALLEST, 1.6 + 0.36 * n))
    place = figure.add_subplot()
    # One or two numbers far above the others would leave these without colour.
    top = float(np.nanpercentile(np.abs(chart.values), 95.0)) if np.isfinite(chart.values).any() else 1.0
    image = place.imshow(chart.values, cmap="RdBu_r", vmin=-(top or 1.0), vmax=top or 1.0, aspect="auto")
    place.set_xticks(np.arange(n), [plain(name) for name in chart.names], rotation=60, ha="right", rotation_mode="anchor")
    place.set_yticks(np.arange(n), [plain(name) for name in chart.names])
    place.grid(visible=False)
    for (row, column), value in np.ndenumerate(chart.values):
        said = f"{value:.2g}" if n <= NUMBERED else ""
        said += "?" if chart.doubtful[row, column] else ""
        if np.isfinite(value) and said:
            dark = abs(value) > 0.6 * top
            place.text(column, row, said, ha="center", va="center", size=6, color="white" if dark else INK)
    bar = figure.colorbar(image, ax=place, extend="both")
    bar.set_label(plain(fill(chart.label, LETTERS)))
    place.set_title(plain(chart.title), pad=6)
    return figure
