"""How far along a path a measured tool was, sample by sample, where no reference says so."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import ResultError
from contourlab.geometry import Path

__all__ = ["progress_along"]

Array = NDArray[np.float64]
PLACES = 200_000
"""Places at which a path is looked at, at most."""
FINEST = 20e-6
"""Metres between them, at least."""
FARTHEST = 0.05
"""Part of the path's size that the tool may be off it before the two are said not to belong together."""


def progress_along(path: Path, positions: Array) -> tuple[Array, float]:
    """Return the arc length [m] of the place on the path that each position belongs to, and how far [m] the first is from its own.

    Parameters
    ----------
    path : Path
    positions : ndarray (n, n_axis) [m]

    Raises
    ------
    ResultError
        If the positions are nowhere near the path.

    Notes
    -----
    Progress follows the tool: from each sample to the next the place is the nearest one within twice the way that the tool has gone since,
    so that where a path meets itself it stays on its own branch. Between those places the foot point is exact anyway.
    """
    n = int(min(max(path.length / FINEST, 1000.0), PLACES)) + 1
    grid = np.linspace(0.0, path.length, n)
    places = path.position(grid)
    spacing = path.length / (n - 1)
    size = float(np.ptp(places, axis=0).max())
    way = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(positions, axis=0), axis=1)))
    # As many samples as there are steps of the path, each a step further than the one before.
    picked = np.unique(np.searchsorted(way, np.arange(0.0, way[-1] + spacing, 2.0 * spacing)).clip(0, len(way) - 1))
    first = np.linalg.norm(places - positions[0], axis=1)
    at = int(np.argmin(first))
    off = float(first[at])
    found = np.empty(picked.size)
    far = off
    last = 0.0
    for i, k in enumerate(picked):
        reach = int(2.0 * (way[k] - last) / spacing) + 3
        low, high = max(at - 3, 0), min(at + reach + 1, n)
        distance = ((places[low:high] - positions[k]) ** 2).sum(axis=1)
        at = low + int(np.argmin(distance))
        far = max(far, float(distance.min()) ** 0.5)
        found[i], last = grid[at], way[k]
    if far > FARTHEST * size + 1e-4:
        raise ResultError(
            f"the tool is up to {far * 1e3:.4g} mm from a path of {size * 1e3:.4g} mm in size: are both in the same coordinates and units?"
        )
    return np.interp(way, way[picked], np.maximum.accumulate(found)), off
