"""The path of a log's own reference: lines through its samples."""

from __future__ import annotations

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ResultError
from contourlab.geometry import Line, Path
from contourlab.geometry.thinning import polygon_corners

STRAIGHT = 10e-9
"""Largest distance [m] of a sample from the path: far below any encoder's resolution."""


def moving(reference: Array) -> tuple[int, int]:
    """Return the samples [start, stop) from the first to the last change of positions (n, n_axis).

    Raises
    ------
    ResultError
        If they never change.
    """
    changes = np.flatnonzero((np.diff(reference, axis=0) != 0.0).any(axis=1))
    if not changes.size:
        raise ResultError("nothing is asked to move: the reference is the same at all samples")
    return int(changes[0]), int(changes[-1]) + 1


def path_of_samples(positions: Array) -> tuple[Path, Array]:
    """Return the polygon through positions (n, n_axis) [m], and the arc length [m] of each sample.

    Samples within ten nanometres of a line between others are dropped.

    Raises
    ------
    ResultError
        If all positions are equal, or one is not finite.
    """
    if not np.isfinite(positions).all():
        raise ResultError(f"the reference is not finite at sample {int(np.argmin(np.isfinite(positions).all(axis=1)))}")
    moving(positions)
    new = np.append(True, (np.diff(positions, axis=0) != 0.0).any(axis=1))
    points = positions[new]
    arc = _arc_length(points)
    kept = polygon_corners(points, STRAIGHT)
    path = Path(Line.many(points[kept][:-1], points[kept][1:]))
    # Chords are a little shorter than the samples between them: use the arc length of the path.
    along = np.interp(arc, arc[kept], _arc_length(points[kept]))
    return path, along[np.cumsum(new) - 1]


def _arc_length(points: Array) -> Array:
    return np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
