"""Samples of a result for drawing: signals by name, in print units; which samples a drawing needs."""

from __future__ import annotations

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.errors import ResultError
from contourlab.result import Result
from contourlab.thinning import KEPT, extremes_of


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


def times(result: Result, samples: Index) -> Array:
    """Return the times of some samples [s]."""
    return np.asarray((samples + int(result.start)) * float(result.servo_period), dtype=np.float64)


def largest_magnitude(values: Array) -> float:
    """Return the largest finite magnitude, 0 if there is none."""
    finite = values[np.isfinite(values)]
    return float(np.max(np.abs(finite))) if finite.size else 0.0


def extremes(result: Result, name: str, budget: int, axis: int | None = None, order: int = 0) -> Index:
    """Return the samples that a drawing of a signal, of one axis, or of its differences of an order, needs: see `keep_extremes`."""

    def values(start: int, stop: int) -> Array:
        part = signal(result.window(start, stop + order), name)
        return np.diff(part if axis is None else part[:, axis], order)[:, np.newaxis]

    return extremes_of(values, max(result.n_sample - order, 0), 1, budget)


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


def share(total: int, n_curve: int, most: int) -> int:
    """Return the points that each of `n_curve` curves may have: at most `total` together and `most` each.

    >>> share(300_000, 200, 4000)
    1500
    """
    return max(2 * KEPT, min(most, total // max(n_curve, 1)))
