"""The path of a measured run: through the samples of its reference, its last lap, and how far along it the tool was."""

from __future__ import annotations

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.errors import ResultError
from contourlab.geometry import Line, Path
from contourlab.geometry.thinning import polygon_corners

PLACES = 200_000
"""Places at which a path is looked at, at most."""
FINEST = 20e-6
"""Metres between them, at least."""
FARTHEST = 0.05
"""Part of the path's size that the tool may be off it before the two are said not to belong together."""
OUTSIDE = 1e-4
"""Metres that it may be off however small the path is."""
STARTS = 12
"""Places that the tool may have begun at, at most: a path may close, cross itself or go several laps."""
LAPS = 1.5
"""Ratio of the tool's way to the path's length from which laps are thought of."""
ALIKE = 1.05
"""Ratio of squared distances up to which two beginnings are as good: then the tool was on its first way past."""


def size_of(path: Path) -> float:
    """Return the largest side of the box around a path [m]."""
    return float(np.ptp(path.position(np.linspace(0.0, path.length, 1001)), axis=0).max())


def farthest(size: float) -> float:
    """Return how far [m] a tool may be off a path of a size [m] before the two are said not to belong together."""
    return FARTHEST * size + OUTSIDE


def progress_along(path: Path, positions: Array) -> tuple[Array, float]:
    """Return the arc length [m] of the place on the path that each position belongs to, and how far [m] the first is from its own.

    Parameters
    ----------
    path : Path
    positions : ndarray (n, n_axis) [m]
        From anywhere on the path onwards, as far as the tool came.

    Raises
    ------
    ResultError
        If the positions are nowhere near the path.

    Notes
    -----
    Progress follows the tool, and never goes back: from each sample to the next the place is the nearest one ahead within twice the way
    that the tool has gone since, so that where a path meets itself or goes back over itself it stays on its own branch. Each place near
    the first sample is tried as a beginning; the one from which the tool stays closest is taken. Between those places the foot point is
    exact anyway.
    """
    n = int(min(max(path.length / FINEST, 1000.0), PLACES)) + 1
    grid = np.linspace(0.0, path.length, n)
    places = path.position(grid)
    spacing = path.length / (n - 1)
    size = float(np.ptp(places, axis=0).max())
    # What is small beside the path is not on it because it is near one place of it: a path in inches, read in millimetres.
    limit = farthest(min(size, float(np.ptp(positions, axis=0).max())))
    way = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(positions, axis=0), axis=1)))
    # As many samples as there are steps of the path, each a step further than the one before.
    picked = np.unique(np.searchsorted(way, np.arange(0.0, way[-1] + spacing, 2.0 * spacing)).clip(0, len(way) - 1))
    tool, ahead = positions[picked], (2.0 * np.diff(way[picked], prepend=0.0) / spacing).astype(int) + 3
    first = np.linalg.norm(places - positions[0], axis=1)
    ways: list[tuple[float, Index]] = []
    strays, most = np.inf, np.inf
    for start in _starts(first, limit):
        found, total, far = _followed(places, tool, ahead, start, limit, most)
        strays = min(strays, far)
        if far <= limit and total <= most:
            ways.append((total, found))
            most = min(most, ALIKE * total + len(tool) * spacing**2)
    if not ways:
        raise ResultError(
            f"the tool strays {strays * 1e3:.4g} mm or more from a path of {size * 1e3:.4g} mm in size, and moves by "
            f"{float(np.ptp(positions, axis=0).max()) * 1e3:.4g} mm: are both in the same coordinates and units?{_on_laps(path, way[-1])}"
        )
    found = min((found for total, found in ways if total <= most), key=lambda found: int(found[0]))
    return np.interp(way, way[picked], grid[found]), float(first[found[0]])


def _on_laps(path: Path, way: float) -> str:
    """Return what is to be said of a tool that goes further than a path that does not close."""
    if path.closed or way < LAPS * path.length:
        return ""
    ratio = f"{way / path.length:.3g} times the path's length"
    return f" The tool goes {ratio}, and laps are followed only of a path that closes: cut the log to one"


def _starts(distance: Array, limit: float) -> list[int]:
    """Return the places (indices, the nearest first) that the tool may have begun at: those nearer than their neighbours."""
    padded = np.concatenate([[np.inf], distance, [np.inf]])
    local = np.flatnonzero((distance <= padded[:-2]) & (distance < padded[2:]))
    near = local[np.argsort(distance[local], kind="stable")][:STARTS]
    near = near[distance[near] <= max(limit, float(distance[near[0]]))]
    return list(dict.fromkeys([*near.tolist(), *([0] if distance[0] <= limit else [])]))


def _followed(
    places: Array, tool: Array, ahead: Index, start: int, limit: float, most: float
) -> tuple[Index, float, float]:
    """Return the place (index) of each position from a beginning on, the sum of their squared distances [m^2] and the largest distance [m].

    It gives up where one is beyond the limit, or the sum beyond what is the most.
    """
    found = np.empty(len(tool), dtype=int)
    at, total, worst = start, 0.0, 0.0
    for i, (position, reach) in enumerate(zip(tool, ahead, strict=True)):
        square = ((places[at : at + reach + 1] - position) ** 2).sum(axis=1)
        nearest = int(np.argmin(square))
        at += nearest
        found[i] = at
        total += float(square[nearest])
        worst = max(worst, float(square[nearest]))
        if worst > limit**2 or total > most:
            break
    return found, total, worst**0.5


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
