"""Samples of a result for drawing: signals by name, in print units, thinned without changing the picture.

Thinning cuts the samples into intervals of equal length and keeps the first, last, lowest and highest sample of each. A line through them
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

from contourlab.arrays import Array, Index
from contourlab.errors import ParameterError, ResultError
from contourlab.rendering.data import ReportData
from contourlab.result import Result

KEPT = 4
"""Samples kept of an interval: first, lowest, highest, last."""


def signal(result: Result, name: str) -> Array:
    """Return a signal's data.

    Raises
    ------
    ResultError
        If the result lacks it.
    """
    if name not in result:
        held = ", ".join(result.signals) or "none"
        raise ResultError(f"scheme {result.scheme!r} lacks the signal {name!r}: judge it first; it holds {held}")
    return np.asarray(result[name], dtype=np.float64)


def axis_column(result: Result, name: str, axis: int) -> Array:
    """Return one axis of a signal as a contiguous vector (n_sample,)."""
    return np.ascontiguousarray(signal(result, name)[:, axis])


def error_signal(data: ReportData) -> str:
    """Return the signal that the tolerance applies to; without blending the two errors are equal."""
    return "part_error" if data.is_blended else "contour_error"


def times(result: Result, samples: Index) -> Array:
    """Return the times of some samples [s]."""
    return np.asarray((samples + int(result.start)) * float(result.servo_period), dtype=np.float64)


def largest_magnitude(values: Array) -> float:
    """Return the largest finite magnitude, 0 if there is none."""
    finite = values[np.isfinite(values)]
    return float(np.max(np.abs(finite))) if finite.size else 0.0


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
    n_sample, n_column = columns.shape
    if budget < KEPT * n_column:
        raise ParameterError("budget", budget, f"at least {KEPT} per column, {KEPT * n_column} here", "points")
    if n_sample <= budget:
        return np.arange(n_sample, dtype=np.int64)
    # All columns share the first and last sample; each has its own lowest and highest.
    n_interval = budget // (2 + 2 * n_column)
    return np.unique(np.concatenate([_of_column(columns[:, i], n_interval) for i in range(n_column)]))


def keep_changes(values: Array, budget: int) -> Index:
    """Choose half of the samples evenly, and half where a signal changes quickly, so that a short spike keeps its shape.

    Parameters
    ----------
    values : ndarray (n_sample,)
        Finite.
    budget : int, >= 2
        Most samples to keep, besides the first, the last and the largest.

    Returns
    -------
    ndarray of int (n_kept,)
        Ascending.

    >>> keep_changes(np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 5.0, 0.0]), 4)
    array([0, 5, 6, 7])
    """
    if values.size <= budget:
        return np.arange(values.size, dtype=np.int64)
    # Squares of changes over a few samples: noise changes little, but at every sample.
    every = np.arange(0, values.size, max(values.size // (8 * budget), 1))
    change = np.diff(values[every], prepend=values[0]) ** 2
    weight = np.cumsum(change / max(float(change.sum()), 1e-300) + 1.0 / every.size)
    places = np.searchsorted(weight, np.linspace(0.0, weight[-1], budget)).clip(max=every.size - 1)
    return np.unique([*every[places], 0, int(np.argmax(values)), values.size - 1])


def _of_column(column: Array, n_interval: int) -> Index:
    """Return first, last, lowest and highest of each interval, unsorted."""
    column = np.ascontiguousarray(column)
    width = -(-column.size // n_interval)
    n_full = column.size // width
    kept = [_of_rows(column[: n_full * width].reshape(n_full, width), 0)]
    if n_full * width < column.size:  # the last interval is shorter than the others
        kept.append(_of_rows(column[np.newaxis, n_full * width :], n_full * width))
    return np.concatenate(kept)


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


def share(total: int, n_curve: int, most: int) -> int:
    """Return the points that each of `n_curve` curves may have: at most `total` together and `most` each.

    >>> share(300_000, 200, 4000)
    1500
    """
    return max(2 * KEPT, min(most, total // max(n_curve, 1)))
