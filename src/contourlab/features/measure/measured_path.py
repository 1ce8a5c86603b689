"""Path of a measured run: the polygon through the samples of its reference, its last lap, the progress of the tool along it, its zero."""

from __future__ import annotations

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.errors import ResultError, refuse
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
    size, moved = float(np.ptp(places, axis=0).max()), float(np.ptp(positions, axis=0).max())
    # A motion much smaller than the path may lie near one point of it by chance: a path in inches, read in millimetres.
    limit = farthest(min(size, moved))
    way = _arc_length(positions)
    # Pick samples two grid steps of travel apart.
    picked = np.unique(np.searchsorted(way, np.arange(0.0, way[-1] + spacing, 2.0 * spacing)).clip(0, len(way) - 1))
    tool, ahead = positions[picked], (2.0 * np.diff(way[picked], prepend=0.0) / spacing).astype(int) + 3
    first = np.linalg.norm(places - positions[0], axis=1)
    ways: list[tuple[float, Index]] = []
    strays, most = np.inf, np.inf
    for start in _starts(first, limit):
        followed, total, far = _followed(places, spacing, tool, ahead, start, limit, most)
        strays = min(strays, far)
        if far <= limit and total <= most:
            ways.append((total, followed))
            most = min(most, ALIKE * total + len(tool) * spacing**2)
    if not ways:
        hint = f" The tool travels {way[-1] / path.length:.3g} times the path's length, but only a closed path can have laps"
        hint = "" if path.closed or way[-1] < LAPS * path.length else f"{hint}: cut the log to one pass"
        raise ResultError(
            f"the tool is {strays * 1e3:.4g} mm or more off a path of {size * 1e3:.4g} mm in size, and moves by "
            f"{moved * 1e3:.4g} mm: are both in the same coordinates and units?{hint}"
        )
    followed = min((indices for total, indices in ways if total <= most), key=lambda indices: int(indices[0]))
    return np.interp(way, way[picked], grid[followed]), float(first[followed[0]])


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
    followed = np.empty(len(tool), dtype=int)
    at, total, worst, distance = start, 0.0, 0.0, 0.0
    for i, (position, reach) in enumerate(zip(tool, ahead.tolist(), strict=True)):
        # A tool that turned before the end of a spike is off the path until it is found further ahead, on the way back.
        far = at + reach + int(4.0 * max(distance - OUTSIDE, 0.0) / spacing) + 1
        square = ((places[at:far] - position) ** 2).sum(axis=1)
        nearest = int(np.argmin(square))
        at += nearest
        followed[i] = at
        distance = float(square[nearest]) ** 0.5
        total += float(square[nearest])
        worst = max(worst, float(square[nearest]))
        if worst > limit**2 or total > most:
            break
    return followed, total, worst**0.5


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
    refuse(not changes.size, ResultError, "the reference does not move: it is the same at all samples")
    return int(changes[0]), int(changes[-1]) + 1


def path_of_samples(positions: Array, lines: Index | None = None) -> tuple[Path, Array]:
    """Return the polygon through positions (n, n_axis) [m], and the arc length [m] of each sample; `lines` (n,) divide its curves.

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
    if lines is not None:
        kept = np.union1d(kept, 1 + np.flatnonzero(np.diff(lines[new])))
    gap, first, last = np.linalg.norm(positions[[0, 1, -1]] - positions[[-1, 0, -2]], axis=1)
    closed = bool(0.0 < gap <= NEXT * min(first, last))
    corners = points[np.append(kept, 0) if closed else kept]
    path = Path(Line.many(corners[:-1], corners[1:]), closed=closed)
    # Chords are a little shorter than the samples between them: use the arc length of the path.
    along = np.interp(arc, arc[kept], _arc_length(points[kept]))
    return path, along[np.cumsum(new) - 1]


def _arc_length(points: Array) -> Array:
    return np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))


# --- programs count from the part, encoders from the machine -------------------------------------------------------------------------

SAMPLES, ITERATIONS = 5000, 50
"""Samples used, evenly spaced along the tool's travel, and largest number of steps."""
EXACT = 1e-8
"""Distance [m] from the path up to which a commanded position is on it: logs round to a nanometre or so."""
SETTLED = 1e-9
"""Length [m] of the last step."""
ALONG = 1e-6
"""Share of the normals in a direction below which the path does not determine the shift in it."""


def fitted_shift(path: Path, positions: Array, *, is_commanded: bool = False, cut: float = 0.0) -> Array:
    """Fit the shift (n_axis,) [m] that brings a path closest to positions (least squares).

    Parameters
    ----------
    positions : ndarray (n, n_axis) [m]
        From the start of the path to its end, or to where the tool stopped.
    is_commanded : bool
        Whether they lie on the path but at rounded corners, which then count less the farther they are off.
    cut : float [m]
        Arc length at which the first cut begins: the tool may not have moved before.

    Raises
    ------
    ResultError
        If the path does not determine the shift, such as a straight line in its own direction, or the positions do not follow the path.

    Notes
    -----
    The fit starts with the bounding boxes centred on each other, and with the first position on the start of the path; and so with the path
    from its first cut. The closest result counts. Each step finds the foot points, then solves for the shift that removes the normal
    distances. Samples are spaced evenly along the travel, so a resting tool has no weight. A constant offset of the tool counts as shift
    and disappears from the error.
    """
    travel = _arc_length(positions)
    tool = positions[np.unique(np.searchsorted(travel, np.linspace(0.0, travel[-1], SAMPLES)))]
    boxes = [path.position(np.linspace(begin, path.length, SAMPLES)) for begin in dict.fromkeys((0.0, cut))]
    centres = [(tool.max(axis=0) + tool.min(axis=0) - box.max(axis=0) - box.min(axis=0)) / 2.0 for box in boxes]
    fits: list[tuple[float, Array]] = []
    errors = []
    for start in (*centres, *(tool[0] - box[0] for box in boxes)):
        try:
            fits.append(_fit_from(path, tool, np.asarray(start), is_commanded))
        except ResultError as error:
            errors.append(error)
    if not fits:
        raise errors[-1]
    return min(fits, key=lambda fit: fit[0])[1]


def _fit_from(path: Path, tool: Array, shift: Array, is_commanded: bool) -> tuple[float, Array]:
    """Iterate from one start; return the mean squared normal distance [m^2] and the shift [m]."""
    for _ in range(ITERATIONS):
        here = tool - shift
        along, _ = progress_along(path, here)
        window = 4.0 * float(np.linalg.norm(path.position(along) - here, axis=1).max()) + 1e-6
        foot = path.foot_point(here, along, min(window, 0.25 * path.length))
        tangent = path.tangent(foot.arc_length)
        # At corners and ends the distance to the foot point has a tangential part.
        off = here - foot.position
        off -= (off * tangent).sum(axis=1, keepdims=True) * tangent
        square = (off**2).sum(axis=1)
        weight = 1.0 / (1.0 + square / max(float(np.median(square)), EXACT**2)) if is_commanded else np.ones(len(off))
        normal = weight.mean() * np.eye(path.n_axis) - np.einsum("k,ki,kj->ij", weight, tangent, tangent) / len(tangent)
        if np.linalg.eigvalsh(normal)[0] < ALONG * weight.mean():
            raise ResultError("a straight path does not determine the shift along itself: give the shift as lengths")
        step = np.linalg.solve(normal, weight @ off / len(off))
        shift = shift + step
        if np.abs(step).max() < SETTLED:
            return float(square.mean()), shift
    raise ResultError(f"the shift between path and log has not converged after {ITERATIONS} steps: give it as lengths")
