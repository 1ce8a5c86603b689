"""Pictures of a sensitivity study."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.report.charts import Bars, Curve, Matrix, Multiples, Series, Tile
from contourlab.report.style import MUTED, scheme_style

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class DrawnCurve:
    """A figure over one number, in the units of print.

    Parameters
    ----------
    name, label : str
        Of the number, and with its unit.
    x, y : ndarray (n,)
        NaN where runs fail.
    here : float
        The number's present value.
    lowest : (x, y) or None
    failed : tuple of (low, high)
    log_x : bool
    """

    name: str
    label: str
    x: Array
    y: Array
    here: float
    lowest: tuple[float, float] | None
    failed: tuple[tuple[float, float], ...]
    log_x: bool


def curves_chart(title: str, y_label: str, drawn: Sequence[DrawnCurve]) -> Multiples:
    """Return one small picture for each number."""
    colour, dash = scheme_style(0, 1)
    tiles = tuple(
        Tile(
            one.name,
            one.label,
            (Curve(one.x, one.y, "with the others as they are", colour, dash),),
            () if one.lowest is None else ((*one.lowest, scheme_style(0, 2)[0]),),
            ((one.here, MUTED),),
            one.failed,
            one.log_x,
        )
        for one in drawn
    )
    return Multiples("curves", title, "", y_label, tiles)


def indices_chart(key: str, title: str, x_label: str, names: Sequence[str], series: Sequence[tuple[str, Array, Array]]) -> Bars:
    """Return bars of indices with their intervals, the largest of the last series first."""
    order = np.argsort(-series[-1][1], kind="stable")
    made = tuple(Series(name, v[order], half[order], scheme_style(i, 2)[0]) for i, (name, v, half) in enumerate(series))
    return Bars(key, title, "", x_label, tuple(names[j] for j in order), made)


def interactions_chart(title: str, names: Sequence[str], values: Array, doubtful: NDArray[np.bool_]) -> Matrix:
    """Return the matrix of interactions; what is on its diagonal is left out, what hangs on the step has a question mark."""
    shown = values.copy()
    np.fill_diagonal(shown, np.nan)
    label = "second difference, in parts of the figure" + ("; ? half off with half the step" if doubtful.any() else "")
    return Matrix("interactions", title, "", label, tuple(names), shown, doubtful)
