"""A swap in two matrices: what each variant loses by choice of local numbers, and what numbers found for one are worth on another."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from contourlab.report.style import INK, MUTED

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class LossMatrix:
    """Losses as coloured cells.

    Parameters
    ----------
    title : str
    rows, columns : tuple of str
    losses : ndarray (n_row, n_column)
        Of 1; not finite where nothing holds.
    texts : tuple of tuple of str
        What stands in the cells.
    untold : ndarray (n_row, n_column) of bool, optional
        Losses that are only known to be as large at least: these cells are hatched in place of a colour that would tell.
    """

    title: str
    rows: tuple[str, ...]
    columns: tuple[str, ...]
    losses: Array
    texts: tuple[tuple[str, ...], ...]
    untold: NDArray[np.bool_] | None = None


def write_matrices(
    matrices: Sequence[LossMatrix], limit: float, title: str, folder: str | Path, formats: Sequence[str]
) -> tuple[Path, ...]:
    """Write matrices under one another as one picture, ``swap``.

    Parameters
    ----------
    matrices : sequence of LossMatrix
    limit : float
        Loss of full modularity: up to it cells are green.
    title : str
    folder : str or Path
    formats : sequence of str
        Of ``"png"``, ``"svg"``, ``"pdf"``.

    Raises
    ------
    ParameterError
        If a format is unknown.
    OutputError
        If a file cannot be written.
    """
    from contourlab.report.plots import write_figures

    return write_figures({"swap": lambda: _drawing(matrices, limit, title)}, folder, formats)


def _drawing(matrices: Sequence[LossMatrix], limit: float, title: str) -> Any:
    from matplotlib.figure import Figure

    # Inches: a row is as high as its longest name has lines, a column as wide as the text of a cell, and the columns as a title.
    heights = [0.75 + max(0.27, 0.14 * max(name.count("\n") + 1 for name in one.rows)) * len(one.rows) for one in matrices]
    names = 0.065 * max(len(line) for one in matrices for name in one.rows for line in name.split("\n"))
    cells = max(3.8, 1.6 * max(len(one.columns) for one in matrices))
    figure = Figure(figsize=(max(7.2, names + cells + 0.9), 0.9 + sum(heights)), layout="constrained")
    figure.suptitle(title, fontsize=9.5, fontweight="bold")
    if any(one.untold is not None and one.untold.any() for one in matrices):
        figure.supxlabel("hatched: not told, as J* may lie lower and the loss be larger", fontsize=7.5, color=MUTED)
    places = figure.subplots(len(matrices), 1, squeeze=False, height_ratios=heights)[:, 0]
    for place, one in zip(places, matrices, strict=True):
        shown = _matrix(place, one, limit)
    bar = figure.colorbar(shown, ax=list(places), location="right", fraction=0.035, pad=0.02)
    bar.set_label(f"loss [%]; green up to {100.0 * limit:g} %", size=7.5)
    bar.outline.set_visible(False)
    marks = [1.0, 3.0, 10.0, 30.0, 100.0]
    bar.set_ticks([mark / 100.0 for mark in marks], labels=[f"{mark:g}" for mark in marks])
    bar.ax.minorticks_off()
    return figure


def _matrix(place: Axes, one: LossMatrix, limit: float) -> Any:
    from matplotlib.colors import LinearSegmentedColormap, LogNorm
    from matplotlib.patches import Rectangle

    low, high = limit / 6.0, 1.0
    at = np.log(limit / low) / np.log(high / low)
    # Blue-green up to the limit, from there over yellow to vermilion: told apart by colour-blind readers too.
    colours = [(0.0, "#8fd3bd"), (at, "#cdeee2"), (at, "#fdf3cf"), (0.5 + 0.5 * at, "#f4b266"), (1.0, "#d9663a")]
    scale = LinearSegmentedColormap.from_list("loss", colours).with_extremes(bad="#c9ced4")
    untold = np.zeros(one.losses.shape, dtype=bool) if one.untold is None else one.untold
    values = np.ma.masked_invalid(np.where(np.isfinite(one.losses) & ~untold, np.clip(one.losses, low, high), np.nan))
    shown = place.imshow(values, cmap=scale, norm=LogNorm(low, high), aspect="auto")
    place.set_title(one.title, loc="left", fontsize=8.5, color=INK)
    place.set_xticks(range(len(one.columns)), one.columns, fontsize=7.5)
    place.set_yticks(range(len(one.rows)), one.rows, fontsize=7.5)
    place.tick_params(length=0, colors=MUTED)
    place.grid(visible=False)
    for side in place.spines.values():
        side.set_visible(False)
    place.set_xticks(np.arange(0.5, len(one.columns) - 1), minor=True)
    place.set_yticks(np.arange(0.5, len(one.rows) - 1), minor=True)
    place.grid(visible=True, which="minor", color="white", linewidth=2.0)
    place.tick_params(which="minor", length=0)
    for i, j in zip(*np.nonzero(untold), strict=True):
        # Above the image, below the lines between cells.
        cell = Rectangle((j - 0.5, i - 0.5), 1.0, 1.0, facecolor="#f3f4f6", edgecolor="#d9dde2", hatch="///", linewidth=0.0, zorder=0.2)
        place.add_patch(cell)
    for i, row in enumerate(one.texts):
        for j, text in enumerate(row):
            place.text(j, i, text, ha="center", va="center", fontsize=7.5, color=INK)
    return shown
