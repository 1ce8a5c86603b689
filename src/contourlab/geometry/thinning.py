"""Thin a long polygon: keep the fewest points found that leave no other further away than a tolerance."""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import GeometryError


def polygon_corners(points: NDArray[np.float64], tolerance: float) -> NDArray[np.int64]:
    """Return the points that a polygon needs so that no other is further away than a tolerance; each line is as long as the search finds.

    Parameters
    ----------
    points : ndarray (n, n_axis) [m]
        In the order in which they are passed, n >= 1; neighbours are not the same.
    tolerance : float [m], >= 0

    Returns
    -------
    ndarray (m,)
        Rising, the first and the last point among them. Between two of them all points lie along the line, one behind the other.

    Raises
    ------
    GeometryError
        If there is no point, or neighbours are the same.

    Notes
    -----
    Time is that of n log(points of a line): a line is looked for among twice as many points as long as it is one, then by halving.
    """
    if points.ndim != 2 or not len(points):
        raise GeometryError(f"points of shape {points.shape}: must be (n, n_axis), n >= 1")
    if not (np.diff(points, axis=0) != 0.0).any(axis=1).all():
        raise GeometryError("two points in a row are the same")
    kept, count = np.empty(len(points), dtype=np.int64), np.empty(1, dtype=np.int64)
    _kernel()(np.ascontiguousarray(points), float(tolerance), kept, count)
    return kept[: count[0]].copy()


@cache
def _kernel() -> Any:
    from contourlab.native.compile import kernel  # the compiler is loaded when a log is measured

    return kernel(corners, "f8[:,:] f8 i8[:] i8[:]")


def _is_line(points, first, last, tolerance):
    """Tell whether points lie on the line from the first to the last, one behind the other."""
    n_axis = points.shape[1]
    square = 0.0
    for j in range(n_axis):
        square += (points[last, j] - points[first, j]) ** 2
    length = square**0.5
    if length == 0.0:
        return False
    before = 0.0
    for k in range(first + 1, last + 1):
        along = 0.0
        for j in range(n_axis):
            along += (points[k, j] - points[first, j]) * ((points[last, j] - points[first, j]) / length)
        if along < before:
            return False
        before = along
        off = 0.0
        for j in range(n_axis):
            off += (points[k, j] - points[first, j] - along * ((points[last, j] - points[first, j]) / length)) ** 2
        if off > tolerance * tolerance:
            return False
    return True


def corners(points, tolerance, kept, count):
    """Write the numbers of the corners into `kept` (n,), and how many there are into `count` (1,)."""
    at, span, found, end = 0, 1, 1, points.shape[0] - 1
    kept[0] = 0
    while at < end:
        # Twice as far as long as it goes, then halving what is between; lines are about as long as the one before.
        good, bad = 1, end - at + 1
        while good < bad - 1:
            if span > good:
                trial = min(span, bad - 1)
            elif bad <= end - at:
                trial = (good + bad) // 2
            else:
                trial = min(2 * good, bad - 1)
            if _is_line(points, at, at + trial, tolerance):
                good, span = trial, 2 * trial
            else:
                bad, span = trial, 0
        at += good
        span = good
        kept[found] = at
        found += 1
    count[0] = found
