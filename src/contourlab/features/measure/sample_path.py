"""The path that a log's own reference describes: lines through its samples."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import ResultError
from contourlab.geometry import Line, Path
from contourlab.geometry.thinning import polygon_corners

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
    kept = polygon_corners(points, STRAIGHT)
    path = Path(Line.many(points[kept][:-1], points[kept][1:]))
    # The chords that were left out are shorter than the polygon by next to nothing: arc length is that of the path.
    own = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points[kept], axis=0), axis=1)))
    along = np.interp(arc, arc[kept], own)
    return path, along[np.cumsum(new) - 1]
