"""Thin samples for drawing without changing the picture.

Samples are cut into intervals of equal length; the first, last, lowest and highest sample of each are kept. A line through them
covers the same pixels as a line through all samples if an interval is no wider than a pixel (M4 aggregation).

References
----------
U. Jugel, Z. Jerzak, G. Hackenbroich, V. Markl, "M4: A Visualization-Oriented Time Series Data Aggregation", Proc.
VLDB Endowment 7 (10), 2014.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import BLOCK, Array, Index
from contourlab.errors import ParameterError, refuse

KEPT = 4
"""Samples kept of an interval: first, lowest, highest, last."""


def keep_extremes(values: ArrayLike, budget: int) -> Index:
    """Choose the samples that a drawing of `values` needs; linear in their number.

    Parameters
    ----------
    values : array_like (n_sample,) or (n_sample, n_column)
        Any unit; nan is a gap and never an extreme. Several columns share the budget; the extremes of each are kept.
    budget : int, >= 4 per column
        Most samples to keep.

    Returns
    -------
    ndarray of int (n_kept,)
        Ascending indices, at most `budget`, with the first and last sample and every column's minimum and maximum.

    Raises
    ------
    ParameterError
        If the budget is too small.

    >>> keep_extremes([0.0, 1.0, 9.0, 2.0, 3.0, -7.0, 4.0, 5.0], 4)
    array([0, 2, 5, 7])
    """
    columns = np.asarray(values, dtype=np.float64)
    columns = columns[:, np.newaxis] if columns.ndim == 1 else columns
    return extremes_of(lambda start, stop: columns[start:stop], columns.shape[0], columns.shape[1], budget)


def extremes_of(read: Callable[[int, int], Array], n_sample: int, n_column: int, budget: int) -> Index:
    """Choose samples as `keep_extremes` does; `read` returns the values (n, n_column) of samples [start, stop)."""
    refuse(budget < KEPT * n_column, ParameterError, "budget", budget, f"at least {KEPT} per column, {KEPT * n_column} here", "points")
    if n_sample <= budget:
        return np.arange(n_sample, dtype=np.int64)
    # All columns share the first and last sample of an interval; each has its own lowest and highest.
    width = -(-n_sample // (budget // (2 + 2 * n_column)))
    kept, most = list[Index](), width * max(BLOCK // width, 1)
    for first in range(0, n_sample, most):
        values = read(first, min(first + most, n_sample))
        whole = len(values) // width * width
        for column in np.ascontiguousarray(values.T):
            kept.append(_of_rows(column[:whole].reshape(-1, width), first))
            if whole < len(values):  # the last interval is shorter than the others
                kept.append(_of_rows(column[np.newaxis, whole:], first + whole))
    return np.unique(np.concatenate(kept))


def _of_rows(rows: Array, offset: int) -> Index:
    """Return first, last, lowest and highest of each row; the first row starts at sample `offset`."""
    start = offset + np.arange(rows.shape[0], dtype=np.int64) * rows.shape[1]
    low, high = start + _place(rows, np.argmin, np.inf), start + _place(rows, np.argmax, -np.inf)
    return np.concatenate([start, low, high, start + rows.shape[1] - 1])


def _place(rows: Array, pick: Callable[..., Any], filler: float) -> Index:
    """Return the index of each row's extreme, ignoring nan."""
    place: Index = pick(rows, axis=1)
    # numpy returns the index of nan in a row that has one: redo only those rows.
    spoilt = np.flatnonzero(np.isnan(rows[np.arange(rows.shape[0]), place]))
    if spoilt.size:
        part = rows[spoilt]
        place[spoilt] = pick(np.where(np.isnan(part), filler, part), axis=1)
    return place.astype(np.int64, copy=False)
