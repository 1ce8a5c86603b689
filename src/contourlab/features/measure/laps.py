"""The last lap of a measured run, where its path goes round and round."""

from __future__ import annotations

import numpy as np

from contourlab.arrays import Array
from contourlab.geometry import Path

PLACES = 8000
"""Places that a path is compared with itself at."""
APART = 2.0
"""Distances between two such places that the same place on two laps may be apart."""
LARGE = 0.2
"""Part of the path's size that a lap has at least: any path looks like itself a little further on."""


def last_lap(path: Path, along: Array) -> int | None:
    """Return the sample at which the last of two laps or more begins; None where the path does not repeat itself to its end.

    Parameters
    ----------
    path : Path
        All laps one after another.
    along : ndarray (n,) [m]
        Place of each sample on it, which never goes back.
    """
    places = path.position(np.linspace(0.0, path.length, PLACES + 1))
    near = APART * path.length / PLACES
    size = float(np.ptp(places, axis=0).max())
    steps = np.arange(1, PLACES // 2 + 1)
    for lap in steps[np.linalg.norm(places[-1 - steps] - places[-1], axis=1) < near].tolist():
        this, before = places[-lap:], places[-2 * lap : -lap]
        if np.ptp(this, axis=0).max() > LARGE * size and np.linalg.norm(this - before, axis=1).max() < near:
            return int(np.searchsorted(along, (1.0 - lap / PLACES) * path.length))
    return None
