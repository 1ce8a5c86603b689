"""Path of a measured run: the polygon through the samples of its reference, its last lap, and the progress of the tool along it."""

from __future__ import annotations

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.errors import ResultError
from contourlab.geometry import Line, Path
from contourlab.geometry.thinning import polygon_corners

PLACES = 200_000
"""Largest number of grid points on a path."""
FINEST = 20e-6
"""Smallest distance [m] between grid points."""
FARTHEST = 0.05
"""Share of the path's size by which the tool may be off the path; beyond it, tool and path do not match."""
OUTSIDE = 1e-4
"""Distance [m] by which the tool may be off a path of any size."""
STARTS = 12
"""Largest number of starting points to try: a path may close, cross itself or have several laps."""
LAPS = 1.5
"""Ratio of the tool's travel to the path's length from which the tool may have made laps."""
ALIKE = 1.05
"""Ratio of squared distances up to which two starting points are equally good; then the first one along the path counts."""


def size_of(path: Path) -> float:
    """Return the largest side of the box around a path [m]."""
    return float(np.ptp(path.position(np.linspace(0.0, path.length, 1001)), axis=0).max())


def farthest(size: float) -> float:
    """Return how far [m] a tool may be off a path of a given size [m]; beyond it, tool and path do not match."""
    return FARTHEST * size + OUTSIDE


def progress_along(path: Path, positions: Array) -> tuple[Array, float]:
    """Return the arc length [m] of each position along the path, and the distance [m] of the first position from the path.

    Parameters
    ----------
    positions : ndarray (n, n_axis) [m]
        Of the tool; they may start and end anywhere on the path.

    Raises
    ------
    ResultError
        If the positions are too far from the path.

    Notes
    -----
    Progress never goes back. Each step takes the nearest grid point ahead, within twice the travel of the tool since the last step. So
    progress stays on its own branch where a path crosses or retraces itself. Each grid point near the first sample is tried as a start;
    the one from which the tool stays closest counts.
    """
    n = int(min(max(path.length / FINEST, 1000.0), PLACES)) + 1
    grid = np.linspace(0.0, path.length, n)
    places = path.position(grid)
    spacing = path.length / (n - 1)
    size = float(np.ptp(places, axis=0).max())
    # A motion much smaller than the path may lie near one point of it by chance: a path in inches, read in millimetres.
    limit = farthest(min(size, float(np.ptp(positions, axis=0).max())))
    way = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(positions, axis=0), axis=1)))
    # Pick samples two grid steps of travel apart.
    picked = np.unique(np.searchsorted(way, np.arange(0.0, way[-1] + spacing, 2.0 * spacing)).clip(0, len(way) - 1))
    tool, ahead = positions[picked], (2.0 * np.diff(way[picked], prepend=0.0) / spacing).astype(int) + 3
    first = np.linalg.norm(places - positions[0], axis=1)
    ways: list[tuple[float, Index]] = []
    strays, most = np.inf, np.inf
    for start in _starts(first, limit):
        found, total, far = _followed(places, spacing, tool, ahead, start, limit, most)
        strays = min(strays, far)
        if far <= limit and total <= most:
            ways.append((total, found))
            most = min(most, ALIKE * total + len(tool) * spacing**2)
    if not ways:
        raise ResultError(
            f"the tool is {strays * 1e3:.4g} mm or more off a path of {size * 1e3:.4g} mm in size, and moves by "
            f"{float(np.ptp(positions, axis=0).max()) * 1e3:.4g} mm: are both in the same coordinates and units?{_on_laps(path, way[-1])}"
        )
    found = min((found for total, found in ways if total <= most), key=lambda found: int(found[0]))
    return np.interp(way, way[picked], grid[found]), float(first[found[0]])


def _on_laps(path: Path, way: float) -> str:
    """Return a hint if the tool travels further than an open path is long; else an empty text."""
    if path.closed or way < LAPS * path.length:
        return ""
    ratio = f"{way / path.length:.3g} times the path's length"
    return f" The tool travels {ratio}, but only a closed path can have laps: cut the log to one pass"


def _starts(distance: Array, limit: float) -> list[int]:
    """Return the grid points (indices, nearest first) at which the tool may have started: local minima of the distance."""
    padded = np.concatenate([[np.inf], distance, [np.inf]])
    local = np.flatnonzero((distance <= padded[:-2]) & (distance < padded[2:]))
    near = local[np.argsort(distance[local], kind="stable")][:STARTS]
    near = near[distance[near] <= max(limit, float(distance[near[0]]))]
    return list(dict.fromkeys([*near.tolist(), *([0] if distance[0] <= limit else [])]))


def _followed(
    places: Array, spacing: float, tool: Array, ahead: Index, start: int, limit: float, most: float
) -> tuple[Index, float, float]:
    """Follow the tool from a starting point.

    Return the grid point (index) of each position, the sum of squared distances [m^2], and the largest distance [m]. Stop when a distance
    exceeds `limit`, or the sum exceeds `most`.
    """
    found = np.empty(len(tool), dtype=int)
    at, total, worst, distance = start, 0.0, 0.0, 0.0
    for i, (position, reach) in enumerate(zip(tool, ahead.tolist(), strict=True)):
        # A tool that turned before the end of a spike is off the path until it is found further ahead, on the way back.
        far = at + reach + int(4.0 * max(distance - OUTSIDE, 0.0) / spacing) + 1
        square = ((places[at:far] - position) ** 2).sum(axis=1)
        nearest = int(np.argmin(square))
        at += nearest
        found[i] = at
        distance = float(square[nearest]) ** 0.5
        total += float(square[nearest])
        worst = max(worst, float(square[nearest]))
        if worst > limit**2 or total > most:
            break
    return found, total, worst**0.5


LAP_PLACES = 8000
"""Number of points at which a path is compared with itself."""
APART = 2.0
"""Largest distance between the same point on two laps, in distances between neighbouring points."""
LARGE = 0.2
"""Smallest size of a lap as a share of the path's size: any path resembles itself after a small shift."""


def last_lap(path: Path, along: Array) -> int | None:
    """Return the sample at which the last of several laps begins; None if the end of the path does not repeat what is before it.

    Parameters
    ----------
    path : Path
        All laps one after another.
    along : ndarray (n,) [m]
        Arc length of each sample; never decreases.
    """
    places = path.position(np.linspace(0.0, path.length, LAP_PLACES + 1))
    near = APART * path.length / LAP_PLACES
    size = float(np.ptp(places, axis=0).max())
    steps = np.arange(1, LAP_PLACES // 2 + 1)
    for lap in steps[np.linalg.norm(places[-1 - steps] - places[-1], axis=1) < near].tolist():
        this, before = places[-lap:], places[-2 * lap : -lap]
        if np.ptp(this, axis=0).max() > LARGE * size and np.linalg.norm(this - before, axis=1).max() < near:
            return int(np.searchsorted(along, (1.0 - lap / LAP_PLACES) * path.length))
    return None


NEXT = 1.5
"""Longest way from the last sample to the first of a closed path, in steps between samples."""
STRAIGHT = 10e-9
"""Largest distance [m] of a sample from the path, far below any encoder's resolution."""


def moving(reference: Array) -> tuple[int, int]:
    """Return the samples [start, stop) from the first to the last change of positions (n, n_axis).

    Raises
    ------
    ResultError
        If the positions never change.
    """
    changes = np.flatnonzero((np.diff(reference, axis=0) != 0.0).any(axis=1))
    if not changes.size:
        raise ResultError("the reference does not move: it is the same at all samples")
    return int(changes[0]), int(changes[-1]) + 1


def path_of_samples(positions: Array) -> tuple[Path, Array]:
    """Return the polygon through positions (n, n_axis) [m], and the arc length [m] of each sample.

    Samples within ten nanometres of a line between others are dropped. The path is closed where the motion begins and ends in motion and
    the first sample could follow the last: what leads or lags is then on the path, beyond the samples.

    Raises
    ------
    ResultError
        If the positions never change, or one is not finite.
    """
    if not np.isfinite(positions).all():
        raise ResultError(f"the reference is not finite at sample {int(np.argmin(np.isfinite(positions).all(axis=1)))}")
    moving(positions)
    new = np.append(True, (np.diff(positions, axis=0) != 0.0).any(axis=1))
    points = positions[new]
    arc = _arc_length(points)
    kept = polygon_corners(points, STRAIGHT)
    gap, first, last = np.linalg.norm(positions[[0, 1, -1]] - positions[[-1, 0, -2]], axis=1)
    closed = bool(0.0 < gap <= NEXT * min(first, last))
    corners = points[np.append(kept, 0) if closed else kept]
    path = Path(Line.many(corners[:-1], corners[1:]), closed=closed)
    # Chords are a little shorter than the samples between them: use the arc length of the path.
    along = np.interp(arc, arc[kept], _arc_length(points[kept]))
    return path, along[np.cumsum(new) - 1]


def _arc_length(points: Array) -> Array:
    return np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
