"""The path that a log's own reference describes: lines through its samples."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import ResultError
from contourlab.geometry import Line, Path

__all__ = ["moving", "path_of_samples"]

Array = NDArray[np.float64]
STRAIGHT = 10e-9
"""Metres by which a sample of the reference may be off the path that is laid through them: far below any encoder."""


def moving(wanted: Array) -> tuple[int, int]:
    """Return the samples [start, stop) from the first to the last at which positions (n, n_axis) change.

    Raises
    ------
    ResultError
        If they never do.
    """
    changes = np.flatnonzero((np.diff(wanted, axis=0) != 0.0).any(axis=1))
    if not changes.size:
        raise ResultError("nothing is asked to move: the reference is the same at all samples")
    return int(changes[0]), int(changes[-1]) + 1


def path_of_samples(positions: Array) -> tuple[Path, Array]:
    """Return the path through positions (n, n_axis) [m], lines from each to the next, and the arc length [m] of each along it.

    Samples within ten nanometres of a line between others are left out of the path.

    Raises
    ------
    ResultError
        If they are all the same, or not finite.
    """
    if not np.isfinite(positions).all():
        raise ResultError(f"the reference is not finite at sample {int(np.argmin(np.isfinite(positions).all(axis=1)))}")
    moving(positions)
    new = np.append(True, (np.diff(positions, axis=0) != 0.0).any(axis=1))
    points = positions[new]
    arc = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
    kept = _corners(points)
    path = Path([Line(a, b) for a, b in zip(points[kept][:-1], points[kept][1:], strict=True)])
    # The chords that were left out are shorter than the polygon by next to nothing: arc length is that of the path.
    own = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points[kept], axis=0), axis=1)))
    along = np.interp(arc, arc[kept], own)
    return path, along[np.cumsum(new) - 1]


def _corners(points: Array) -> NDArray[np.int64]:
    """Return the points that a polygon needs so that no other is further than `STRAIGHT` from it, each line as long as it can be."""
    kept, at, span, last = [0], 0, 1, len(points) - 1
    while at < last:
        # Twice as far as long as it goes, then halving what is between; lines are about as long as the one before.
        good, bad = 1, last - at + 1
        while good < bad - 1:
            trial = min(span, bad - 1) if span > good else (good + bad) // 2 if bad <= last - at else min(2 * good, bad - 1)
            if _is_line(points[at : at + trial + 1]):
                good, span = trial, 2 * trial
            else:
                bad, span = trial, 0
        at += good
        span = good
        kept.append(at)
    return np.array(kept)


def _is_line(points: Array) -> bool:
    """Tell whether points lie on the line from the first to the last, one behind the other."""
    way = points[-1] - points[0]
    length = float(np.linalg.norm(way))
    if length == 0.0:
        return False
    off = points - points[0]
    along = off @ (way / length)
    if np.any(np.diff(along) < 0.0):
        return False
    return float(((off - np.outer(along, way / length)) ** 2).sum(axis=1).max()) <= STRAIGHT**2
