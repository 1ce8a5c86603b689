"""Thin a long polygon within a tolerance."""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.errors import GeometryError, refuse
from contourlab.native.kernel import kernel


def polygon_corners(points: Array, tolerance: float) -> Index:
    """Return the rising numbers (m,) of the points to keep; all others lie within the tolerance of the polygon, in order along it.

    Parameters
    ----------
    points : ndarray (n, n_axis) [m]
        In the order of travel, n >= 1; neighbours differ.
    tolerance : float [m], >= 0

    Raises
    ------
    GeometryError
        If there is no point, or two neighbours are equal.

    Notes
    -----
    Each line is found by doubling the number of its points, then by bisection: the time grows as n log(points of a line).
    """
    refuse(points.ndim != 2 or not len(points), GeometryError, f"points of shape {points.shape}: must be (n, n_axis), n >= 1")
    refuse(not (np.diff(points, axis=0) != 0.0).any(axis=1).all(), GeometryError, "two neighbouring points are equal")
    kept, count = np.empty(len(points), dtype=np.int64), np.empty(1, dtype=np.int64)
    corners(np.ascontiguousarray(points), float(tolerance), kept, count)
    return kept[: count[0]].copy()


def _is_line(points, first, last, tolerance):
    """Return whether points lie on the line from the first to the last, in their order."""
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


@kernel("f8[:,:] f8 i8[:] i8[:]")
def corners(points, tolerance, kept, count):
    """Write the numbers of the corners into `kept` (n,), and their count into `count` (1,)."""
    at, span, n_kept, end = 0, 1, 1, points.shape[0] - 1
    kept[0] = 0
    while at < end:
        # Double the length, then bisect; start with the length of the line before.
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
        kept[n_kept] = at
        n_kept += 1
    count[0] = n_kept
