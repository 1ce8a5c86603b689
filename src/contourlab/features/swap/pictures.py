"""The picture of a swap, two matrices: the loss of each variant for each choice of local parameters, and with the designs of others."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from textwrap import wrap
from typing import TYPE_CHECKING, Any

import numpy as np

from contourlab.arrays import Array, Flags
from contourlab.features.swap.study import Choice, SwapStudy
from contourlab.figures import figure
from contourlab.rendering.style import INK, MUTED

if TYPE_CHECKING:
    from matplotlib.axes import Axes

ROW_WIDTH = 44
"""Line width of row names [characters]."""


@dataclass(frozen=True, eq=False)
class LossMatrix:
    """Losses as coloured cells.

    Parameters
    ----------
    title : str
    rows, columns : tuple of str
    losses : ndarray (n_row, n_column)
        Not finite where a guard is broken.
    texts : tuple of tuple of str
    uncertain : ndarray (n_row, n_column) of bool
        Losses below the limit whose J* may be lower: hatched instead of coloured.
    """

    title: str
    rows: tuple[str, ...]
    columns: tuple[str, ...]
    losses: Array
    texts: tuple[tuple[str, ...], ...]
    uncertain: Flags


def matrices(study: SwapStudy) -> list[LossMatrix]:
    """Return the two matrices: the best choice of each size, and the designs of J* on each variant."""
    best: dict[int, Choice] = {}
    for choice in sorted(study.choices, key=lambda choice: (len(choice.local), choice.swap_loss)):
        best.setdefault(len(choice.local), choice)
    rows = tuple("\n".join(wrap(choice.name if choice.local else "nothing local", ROW_WIDTH)) for choice in best.values())
    others = (*(f"best for {name}" for name in study.variants.names), "design of the scenario")
    return [
        _loss_matrix(study, "loss of each variant, by local parameters", rows, np.array([choice.values for choice in best.values()])),
        _loss_matrix(study, "best design of each variant, run on every variant", others, np.vstack([study.crossed, study.given.values])),
    ]


def _loss_matrix(study: SwapStudy, title: str, rows: tuple[str, ...], values: Array) -> LossMatrix:
    names = study.variants.names
    losses = study.variants.losses(np.where(np.isfinite(values), values, np.nan))
    unsure = np.array([name in study.inconclusive for name in names])

    def text(lost: float, value: float, at_least: bool) -> str:
        if not math.isfinite(lost):
            return "breaks a guard"
        return f"{'at least ' if at_least else ''}{figure(lost, '%')}  ({figure(value, study.variants.unit)})"

    texts = tuple(tuple(map(text, *row, unsure.tolist())) for row in zip(losses.tolist(), values.tolist(), strict=True))
    return LossMatrix(title, rows, names, losses, texts, unsure & (losses < study.settings.full))


def write_matrices(
    matrices: Sequence[LossMatrix], limit: float, title: str, folder: str | Path, formats: Sequence[str]
) -> tuple[Path, ...]:
    """Write matrices, one below the other, as the picture ``swap``.

    Parameters
    ----------
    matrices : sequence of LossMatrix
    limit : float
        Loss limit of full modularity: cells up to it are green.
    title : str
    folder : str or Path
    formats : sequence of str
        From ``"png"``, ``"svg"``, ``"pdf"``.

    Raises
    ------
    ParameterError
        If a format is unknown.
    OutputError
        If a file cannot be written.
    """
    from contourlab.rendering.plots import write_figures

    return write_figures({"swap": lambda: drawing(matrices, limit, title)}, folder, formats)


def drawing(matrices: Sequence[LossMatrix], limit: float, title: str) -> Any:
    """Draw matrices into one figure."""
    from matplotlib.figure import Figure

    # In inches: row height from the lines of its name, column width from the text of a cell.
    heights = [0.75 + max(0.27, 0.14 * max(name.count("\n") + 1 for name in matrix.rows)) * len(matrix.rows) for matrix in matrices]
    names = 0.065 * max(len(line) for matrix in matrices for name in matrix.rows for line in name.split("\n"))
    cells = max(3.8, 1.6 * max(len(matrix.columns) for matrix in matrices))
    page = Figure(figsize=(max(7.2, names + cells + 0.9), 0.9 + sum(heights)), layout="constrained")
    page.suptitle(title, fontsize=9.5, fontweight="bold")
    if any(matrix.uncertain.any() for matrix in matrices):
        page.supxlabel("hatched: inconclusive; J* may be lower, and then the loss is larger", fontsize=7.5, color=MUTED)
    places = page.subplots(len(matrices), 1, squeeze=False, height_ratios=heights)[:, 0]
    for place, matrix in zip(places, matrices, strict=True):
        shown = _draw(place, matrix, limit)
    bar = page.colorbar(shown, ax=list(places), location="right", fraction=0.035, pad=0.02)
    bar.set_label(f"loss [%]; green up to {100.0 * limit:g} %", size=7.5)
    bar.outline.set_visible(False)
    marks = [1.0, 3.0, 10.0, 30.0, 100.0]
    bar.set_ticks([mark / 100.0 for mark in marks], labels=[f"{mark:g}" for mark in marks])
    bar.ax.minorticks_off()
    return page


def _draw(place: Axes, matrix: LossMatrix, limit: float) -> Any:
    from matplotlib.colors import LinearSegmentedColormap, LogNorm
    from matplotlib.patches import Rectangle

    low, high = limit / 6.0, 1.0
    at = np.log(limit / low) / np.log(high / low)
    # Blue-green up to the limit, then yellow to vermilion: distinct for colour-blind readers too.
    colours = [(0.0, "#8fd3bd"), (at, "#cdeee2"), (at, "#fdf3cf"), (0.5 + 0.5 * at, "#f4b266"), (1.0, "#d9663a")]
    scale = LinearSegmentedColormap.from_list("loss", colours).with_extremes(bad="#c9ced4")
    values = np.ma.masked_invalid(np.where(matrix.uncertain, np.nan, np.clip(matrix.losses, low, high)))
    shown = place.imshow(values, cmap=scale, norm=LogNorm(low, high), aspect="auto")
    place.set_title(matrix.title, loc="left", fontsize=8.5, color=INK)
    place.set_xticks(range(len(matrix.columns)), matrix.columns, fontsize=7.5)
    place.set_yticks(range(len(matrix.rows)), matrix.rows, fontsize=7.5)
    place.tick_params(length=0, colors=MUTED)
    place.grid(visible=False)
    for side in place.spines.values():
        side.set_visible(False)
    place.set_xticks(np.arange(0.5, len(matrix.columns) - 1), minor=True)
    place.set_yticks(np.arange(0.5, len(matrix.rows) - 1), minor=True)
    place.grid(visible=True, which="minor", color="white", linewidth=2.0)
    place.tick_params(which="minor", length=0)
    style: dict[str, Any] = {"facecolor": "#f3f4f6", "edgecolor": "#d9dde2", "hatch": "///", "linewidth": 0.0, "zorder": 0.2}
    for i, j in zip(*np.nonzero(matrix.uncertain), strict=True):
        place.add_patch(Rectangle((j - 0.5, i - 0.5), 1.0, 1.0, **style))
    for i, row in enumerate(matrix.texts):
        for j, text in enumerate(row):
            place.text(j, i, text, ha="center", va="center", fontsize=7.5, color=INK)
    return shown
