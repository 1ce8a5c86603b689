"""Pictures of studies before they are drawn: small multiples, bars with intervals, a matrix in colours."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.report.charts import Curve

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Tile:
    """One of many small pictures with an x axis of its own.

    Parameters
    ----------
    title, x_label : str
    curves : tuple of Curve
    marks : tuple of (x, y, colour)
        Rings: where a curve is lowest.
    here : tuple of (x, colour)
        Upright lines: present values.
    shaded : tuple of (low, high)
        Stretches of x in which runs fail.
    log_x : bool
    """

    title: str
    x_label: str
    curves: tuple[Curve, ...]
    marks: tuple[tuple[float, float, str], ...] = ()
    here: tuple[tuple[float, str], ...] = ()
    shaded: tuple[tuple[float, float], ...] = ()
    log_x: bool = False


@dataclass(frozen=True, eq=False)
class Multiples:
    """Small pictures side by side with one scale of y.

    Parameters
    ----------
    key, title, caption, y_label : str
    tiles : tuple of Tile
    columns : int
    log_y : bool
    """

    key: str
    title: str
    caption: str
    y_label: str
    tiles: tuple[Tile, ...]
    columns: int = 3
    log_y: bool = True


@dataclass(frozen=True, eq=False)
class Series:
    """Bars of one colour: values (n,) with half the widths of their intervals (n,)."""

    name: str
    values: Array
    intervals: Array
    colour: str


@dataclass(frozen=True, eq=False)
class Bars:
    """Bars lying beside their names, from the top down."""

    key: str
    title: str
    caption: str
    x_label: str
    names: tuple[str, ...]
    series: tuple[Series, ...]


@dataclass(frozen=True, eq=False)
class Matrix:
    """A matrix (n, n) in colours, red above 0 and blue below; NaN is left blank, what is doubtful has a question mark."""

    key: str
    title: str
    caption: str
    label: str
    names: tuple[str, ...]
    values: Array
    doubtful: NDArray[np.bool_]
