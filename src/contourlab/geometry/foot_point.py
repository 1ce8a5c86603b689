"""The exact foot point: the closest point of a path, searched independently for each sample.

In a window around the progress of a sample, each curve in reach gives its closest point: lines and flat arcs in closed form, other curves
by sampling and a bracketed Newton iteration. The foot point is the nearest of these; ties go to the one nearest to the progress, which
selects the right branch where the path crosses itself.

Distances to junctions alone find the curves in reach. A part of the path with length L, whose ends lie d and e from the point, is nowhere
closer than (d + e - L) / 2. It is excluded if a junction is closer. The search halves parts, the better half first, until single curves
remain: a few out of thousands, after some tens of distances.
"""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Index, ranges
from contourlab.errors import GeometryError, refuse
from contourlab.geometry.curve import CurveSequence
from contourlab.geometry.table import PathTable, path_table
from contourlab.native.kernel import kernel
from contourlab.threads import in_threads

_FEW = 4
"""Up to this mean number of curves per sample, all curves are candidates."""
_DEPTH = 128
_JUNCTION_SLACK = 1e-9
"""Error of arc lengths and distances [m]."""


def curves_in_reach(path: CurveSequence, points: Array, around: Array, window: Array) -> tuple[Index, Index, Array, Array, Array]:
    """Return pairs of a sample and a curve in its window that may hold the closest point.

    Parameters
    ----------
    points : ndarray (n, n_axis) [m]
    around, window : ndarray (n,) [m]
        Progress along the path, and largest distance from it.

    Returns
    -------
    sample, curve : ndarray (k,)
        Sorted by sample, then by curve.
    lap : ndarray (k,)
    low, high : ndarray (k,) [m]
        Range of arc length along the curve that lies in the window.
    """
    first, last = around - window, around + window
    if path.closed:
        # Half a lap on either side is the whole path.
        first, last = np.maximum(first, around - 0.5 * path.length), np.minimum(last, around + 0.5 * path.length)
    else:
        first, last = np.clip(first, 0.0, path.length), np.clip(last, 0.0, path.length)
    begin, final = _numbers(path, first), _numbers(path, last)
    count = final - begin + 1
    if count.sum() > _FEW * count.size:
        sample, number = _searched(path, points, begin, final)
    else:
        sample, number = np.repeat(np.arange(around.size), count), ranges(begin, count)
    lap, curve = np.divmod(number, len(path.curves))
    offset = lap * path.length + path.breaks[curve]
    span = np.diff(path.breaks)[curve]
    low, high = (np.clip(end[sample] - offset, 0.0, span) for end in (first, last))
    return sample, curve, lap.astype(float), low, high


def _numbers(path: CurveSequence, s: Array) -> Index:
    """Return the curve of each arc length, counted over laps."""
    m, lap = len(path.curves), np.floor(s / path.length) if path.closed else np.zeros(s.size)
    return np.clip(np.searchsorted(path.breaks, s - lap * path.length, side="right") - 1, 0, m - 1) + (lap * m).astype(np.int64)


def _searched(path: CurveSequence, points: Array, begin: Index, end: Index) -> tuple[Index, Index]:
    junctions, along = path.junctions
    n, samples, numbers = len(points), [], []
    room, state = 4 * n + 64, np.zeros(2, dtype=np.int64)
    ends, depths = np.empty((_DEPTH, 2), dtype=np.int64), np.empty((_DEPTH, 3))
    points = np.ascontiguousarray(points)
    while state[0] < n:
        before, pairs, bound = int(state[0]), np.empty((room, 2), dtype=np.int64), np.empty(room)
        search(junctions, along, int(path.closed), points, begin, end, pairs, bound, state, ends, depths)
        samples.append(pairs[: state[1], 0])
        numbers.append(pairs[: state[1], 1])
        # A sample may have more curves at the same distance than `pairs` holds.
        room = 2 * room if state[0] == before else room
    return np.concatenate(samples), np.concatenate(numbers)


def _away(junctions, closed, points, i, k):
    """Return the distance of a point from the start of curve k."""
    m = junctions.shape[0] - 1
    at = k % m if closed else k
    square = 0.0
    for j in range(points.shape[1]):
        square += (points[i, j] - junctions[at, j]) ** 2
    return square**0.5


def _up_to(along, closed, k):
    """Return the length of the path up to the start of curve k, laps included."""
    m = along.shape[0] - 1
    return (k // m) * along[m] + along[k % m] if closed else along[k]


def _least(along, closed, a, b, from_a, from_b):
    """Return a lower bound of the distance of curves a to b - 1 from a point, given its distances to their ends."""
    return 0.5 * (from_a + from_b - (_up_to(along, closed, b) - _up_to(along, closed, a)))


def _keep(i, pairs, bound, start, count, best):
    """Keep the curves of a sample that may be the nearest, in the order of the path; return the number of pairs."""
    kept = start
    for k in range(start, count):
        if bound[k] > best:
            continue
        number, least, at = pairs[k, 1], bound[k], kept
        while at > start and pairs[at - 1, 1] > number:
            pairs[at, 0], pairs[at, 1], bound[at] = i, pairs[at - 1, 1], bound[at - 1]
            at -= 1
        pairs[at, 0], pairs[at, 1], bound[at] = i, number, least
        kept += 1
    return kept


@kernel("f8[:,:] f8[:] i8 f8[:,:] i8[:] i8[:] i8[:,:] f8[:] i8[:] i8[:,:] f8[:,:]")
def search(junctions, along, closed, points, begin, end, pairs, bound, state, ends, depths):
    """Fill `pairs` with pairs of sample and curve, from sample state[0] on; set `state` to the next sample and the number of pairs."""
    count, i = 0, state[0]
    while i < points.shape[0]:
        start, best, top = count, np.inf, 1
        ends[0, 0], ends[0, 1] = begin[i], end[i] + 1
        depths[0, 0] = _away(junctions, closed, points, i, begin[i])
        depths[0, 1] = _away(junctions, closed, points, i, end[i] + 1)
        depths[0, 2] = _least(along, closed, begin[i], end[i] + 1, depths[0, 0], depths[0, 1])
        while top:
            top -= 1
            a, b = ends[top, 0], ends[top, 1]
            from_a, from_b, least = depths[top, 0], depths[top, 1], depths[top, 2]
            if least > best:
                continue
            if b - a == 1:
                if count == pairs.shape[0]:
                    state[0], state[1] = i, start
                    return
                pairs[count, 0], pairs[count, 1], bound[count] = i, a, least
                count += 1
                continue
            middle = (a + b) // 2
            away = _away(junctions, closed, points, i, middle)
            # A junction in the window lies on the path: the closest point is not further away.
            best = min(best, away + _JUNCTION_SLACK)
            left = _least(along, closed, a, middle, from_a, away)
            right = _least(along, closed, middle, b, away, from_b)
            later = top if left > right else top + 1
            ends[later, 0], ends[later, 1] = a, middle
            depths[later, 0], depths[later, 1], depths[later, 2] = from_a, away, left
            later = top + 1 if left > right else top
            ends[later, 0], ends[later, 1] = middle, b
            depths[later, 0], depths[later, 1], depths[later, 2] = away, from_b, right
            top += 2
        count = _keep(i, pairs, bound, start, count, best)
        i += 1
    state[0], state[1] = i, count


Near = Callable[[Index, Array, int], Array]
Width = Callable[[Index, Array, Array], Array]
_MOST_CELLS = 1 << 21
_TABLE_SLACK = 1e-8  # [m] larger than the error of the table


class Bends:
    """Largest curvature of a path between two arc lengths, from its table.

    Level k holds the maximum over 2^k successive pieces; two entries cover any range.
    """

    def __init__(self, table: PathTable) -> None:
        self.table = table
        h = np.diff(table.start)[:, None, None] * np.linspace(0.0, 1.0, 5)[:, None]
        c = np.moveaxis(table.coefficients, 2, 0)[:, :, None, :]
        levels = [np.linalg.norm(2.0 * c[2] + h * (6.0 * c[3] + h * (12.0 * c[4] + h * 20.0 * c[5])), axis=2).max(axis=1)]
        while len(levels[-1]) > (step := 1 << (len(levels) - 1)):
            levels.append(np.maximum(levels[-1][:-step], levels[-1][step:]))
        self._levels = np.array([np.pad(level, (0, len(levels[0]) - len(level))) for level in levels])

    def largest(self, low: Array, high: Array) -> Array:
        """Return the largest curvature [1/m] in each range (n,) of arc lengths along the path."""
        last = self._levels.shape[1] - 1
        i = np.clip(np.searchsorted(self.table.start, low, side="right") - 1, 0, last)
        j = np.clip(np.searchsorted(self.table.start, high, side="left") - 1, i, last)
        k = np.frexp((j - i + 1).astype(float))[1] - 1
        return np.asarray(np.maximum(self._levels[k, i], self._levels[k, j + 1 - (1 << k)]))


def brackets(points: Array, near: Near, width: Width, low: Array, high: Array, middle: Array) -> tuple[Index, Array, Array, Array]:
    """Return brackets of the closest points: pair, first guess, and both ends.

    A cell of width `step` whose ends lie d and e from the point is nowhere closer than (d + e - step) / 2. It is excluded if a sample is
    closer.

    Parameters
    ----------
    points : ndarray (n, n_axis) [m]
        One for each pair of a sample and a curve.
    near : callable
        (pair, s, order) -> derivatives at local arc lengths.
    width : callable
        (pair, a, b) -> largest width of a cell between a and b with a single closest point.
    low, high : ndarray (n,) [m]
        Local arc lengths to search between.
    middle : ndarray (n,) [m]
        The progress; ties go to the sample nearest to it.
    """
    row = np.arange(low.size)
    enough = width(row, low, high)
    # Take few samples of all curves; where these do not suffice, divide only the relevant cells.
    ratio = (high - low) / np.maximum(enough, 1e-12)
    n = int(np.clip(np.ceil(np.median(ratio)), 4, 64)) if row.size else 4
    grid = low[:, None] + (high - low)[:, None] * np.linspace(0.0, 1.0, n + 1)
    at = near(np.repeat(row, n + 1), grid.ravel(), 0)[0].reshape(*grid.shape, -1)
    away = np.sqrt(((at - points[:, None, :]) ** 2).sum(axis=2))
    step, best = (high - low) / n, away.min(axis=1)
    hope = away[:, :-1] + away[:, 1:] - step[:, None] <= 2.0 * best[:, None] + _TABLE_SLACK
    fine = row[step <= enough * (1.0 + 1e-9)]
    k = np.argmin(away**2 + 1e-18 * np.abs(grid - middle[:, None]), axis=1)[fine]
    left, right = np.maximum(k - 1, 0), np.minimum(k + 1, n)
    hope[fine, left] = hope[fine, right - 1] = False
    pair, cell = np.nonzero(hope)
    pair, a, b = _refine(points, near, width, pair, grid[pair, cell], grid[pair, cell + 1], best)
    return (
        np.concatenate([fine, pair]),
        np.concatenate([grid[fine, k], 0.5 * (a + b)]),
        np.concatenate([grid[fine, left], a]),
        np.concatenate([grid[fine, right], b]),
    )


def _refine(points: Array, near: Near, width: Width, pair: Index, a: Array, b: Array, best: Array) -> tuple[Index, Array, Array]:
    """Divide cells until each holds at most one closest point; return those with a minimum of the distance."""
    while pair.size and pair.size < _MOST_CELLS:
        split = b - a > width(pair, a, b) * (1.0 + 1e-9)
        if not split.any():
            break
        owner, keep = pair[split], ~split
        ends = a[split, None] + (b - a)[split, None] * np.linspace(0.0, 1.0, 5)
        owners = np.repeat(owner, 5)
        away = np.sqrt(((near(owners, ends.ravel(), 0)[0] - points[owners]) ** 2).sum(axis=1)).reshape(-1, 5)
        np.minimum.at(best, owner, away.min(axis=1))
        i, j = np.nonzero(away[:, :-1] + away[:, 1:] - np.diff(ends, axis=1) <= 2.0 * best[owner, None] + _TABLE_SLACK)
        pair = np.concatenate([pair[keep], owner[i]])
        a, b = np.concatenate([a[keep], ends[i, j]]), np.concatenate([b[keep], ends[i, j + 1]])
    slope = []
    for s in (a, b):
        r, first = near(pair, s, 1)
        slope.append(np.einsum("ij,ij->i", first, r - points[pair]))
    turns = (slope[0] <= 0.0) & (slope[1] >= 0.0)
    return pair[turns], a[turns], b[turns]


_CHUNK = 1 << 17


class FootPoint(NamedTuple):
    """Closest points of a path.

    Attributes
    ----------
    arc_length : ndarray (n,) [m]
        In the lap of the given progress.
    position : ndarray (n, n_axis) [m]
    distance : ndarray (n,) [m]
    signed : ndarray (n,) [m]
        Positive to the left of the direction of travel; NaN unless the path is planar. At a corner the bisector decides the side.
    """

    arc_length: Array
    position: Array
    distance: Array
    signed: Array


def foot_point(path: CurveSequence, points: ArrayLike, around: ArrayLike, window: ArrayLike) -> FootPoint:
    """Return the closest point of the path to each point, within `window` of a given progress.

    Parameters
    ----------
    points : array_like (n, n_axis) [m]
    around : array_like (n,) [m]
        Progress along the path; on a closed path it may count laps.
    window : float or array_like (n,) [m], > 0
        Largest distance of the foot point from the progress.

    Returns
    -------
    FootPoint
        Arc lengths accurate to 1e-12 of the path's length.

    Raises
    ------
    GeometryError
        If shapes do not fit, the window is not positive, or a point is not finite.
    """
    p, s = np.atleast_2d(np.asarray(points, dtype=float)), np.atleast_1d(np.asarray(around, dtype=float))
    if p.shape != (s.size, path.n_axis):
        raise GeometryError(f"points of shape {p.shape} with {s.size} values of progress: must be ({s.size}, {path.n_axis})")
    reach = np.asarray(window, dtype=float)
    if reach.shape not in ((), s.shape) or not (reach > 0.0).all():
        raise GeometryError(f"window = {window!r}: must be > 0 m, one for all points or one for each")
    reach = np.broadcast_to(reach, s.shape)
    refuse(not (np.isfinite(p).all() and np.isfinite(s).all()), GeometryError, "points and progress must be finite")
    chunks = [slice(i, i + _CHUNK) for i in range(0, max(s.size, 1), _CHUNK)]
    parts = in_threads(lambda some: _chunk(path, p[some], s[some], reach[some]), chunks)
    return FootPoint(*(np.concatenate(columns) for columns in zip(*parts, strict=True)))


def _chunk(path: CurveSequence, points: Array, around: Array, window: Array) -> FootPoint:
    sample, curve, lap, low, high = curves_in_reach(path, points, around, window)
    local = np.empty(sample.size)
    middle = np.clip(around[sample] - lap * path.length - path.breaks[curve], low, high)
    searched = [np.zeros(0, dtype=np.int64)]
    for batch, on, slot in path.kind_of(curve):
        direct = batch.direct[slot]
        if direct.any():
            here, at = on[direct], slot[direct]
            local[here] = batch.closest(at, points[sample[here]], low[here], high[here], middle[here])
        searched.append(on[~direct])
    on = np.concatenate(searched)
    if on.size:
        local[on] = _on_curves(path, points[sample[on]], curve[on], low[on], high[on], middle[on])
    feet = path.at(curve, local, 0)[0]
    square = ((points[sample] - feet) ** 2).sum(axis=1)
    progress = lap * path.length + path.breaks[curve] + local
    best = _nearest(sample, square, np.abs(progress - around[sample]), around.size)
    return _result(path, points, progress[best], curve[best], local[best], feet[best], np.sqrt(square[best]))


def _on_curves(path: CurveSequence, points: Array, curve: Index, low: Array, high: Array, middle: Array) -> Array:
    """Return closest points: find brackets, then apply Newton's method to r'.(r - p), with bisection as a safeguard.

    All but the last steps use the table of the path, which is much cheaper than a spline by arc length and differs by a nanometre.
    """
    offset = path.breaks[curve]
    table, bends = _near(path)
    # At a junction the table has the direction of the curve that starts there.
    last = path.breaks[curve + 1] * (1.0 - 1e-15)

    def near(pair: Index, s: Array, order: int) -> Array:
        return np.asarray(
            table.evaluate(np.minimum(s + offset[pair], last[pair]), order) if table is not None else path.at(curve[pair], s, order)
        )

    def exact(pair: Index, s: Array, order: int) -> Array:
        return path.at(curve[pair], s, order)

    def width(pair: Index, a: Array, b: Array) -> Array:
        start = offset[pair]
        bend = bends.largest(a + start, b + start) if bends is not None else 1.0 / path.smallest_radii[curve[pair]]
        return 0.35 / np.maximum(bend, 1e-300)

    pair, s, a, b = brackets(points, near, width, low, high, middle)
    s = _newton(points, near, pair, s, a, b, 60, 1e-12 * path.length)
    reach = 1e-7 * path.length
    fine = _newton(points, exact, pair, s, np.maximum(s - reach, low[pair]), np.minimum(s + reach, high[pair]), 3, 1e-15 * path.length)
    # Near a centre of curvature, a nanometre in the table moves the foot point by more.
    off = np.flatnonzero(np.abs(fine - s) > 0.5 * reach)
    if off.size:
        fine[off] = _newton(points, exact, pair[off], s[off], a[off], b[off], 60, 1e-15 * path.length)
    pair, s = np.concatenate([np.tile(np.arange(curve.size), 2), pair]), np.concatenate([low, high, fine])
    square = ((exact(pair, s, 0)[0] - points[pair]) ** 2).sum(axis=1)
    return np.asarray(s[_nearest(pair, square, np.abs(s - middle[pair]), curve.size)])


def _newton(points: Array, at: Any, pair: Index, s: Array, a: Array, b: Array, most: int, enough: float) -> Array:
    """Refine foot points on their curves, each within its bracket."""
    target = points[pair]
    for _ in range(most):
        r, first, second = at(pair, s, 2)
        gap = r - target
        g = np.einsum("ij,ij->i", first, gap)
        h = np.einsum("ij,ij->i", first, first) + np.einsum("ij,ij->i", second, gap)
        a, b = np.where(g < 0.0, s, a), np.where(g > 0.0, s, b)
        newton = s - np.divide(g, h, out=np.full_like(g, np.inf), where=h > 0.0)
        after = np.where((newton >= a) & (newton <= b), newton, 0.5 * (a + b))
        moved = np.abs(after - s).max(initial=0.0)
        s = after
        if moved <= enough:
            break
    return s


def _near(path: CurveSequence) -> tuple[PathTable | None, Bends | None]:
    """Return the table of the path and its curvatures, cached on the path; None if all curves have a closed form by arc length."""
    if all(batch.sixth is not None for batch, _ in path.kinds):
        return None, None
    cached: Any = path.__dict__.get("_near")
    if cached is None:
        table = path_table(path, 1e-9 * min(path.length, 1.0))
        cached = path.__dict__["_near"] = (table, Bends(table))
    return cached  # type: ignore[no-any-return]


def _nearest(sample: Index, square: Array, away: Array, n: int) -> Index:
    """Return the pair of least distance for each sample; ties (within 1e-12) go to the least `away`."""
    least = np.full(n, np.inf)
    np.minimum.at(least, sample, square)
    tied = square <= least[sample] * (1.0 + 1e-12) + 1e-30
    nearest = np.full(n, np.inf)
    np.minimum.at(nearest, sample[tied], away[tied])
    winner = np.flatnonzero(tied & (away <= nearest[sample]))
    pair = np.empty(n, dtype=np.int64)
    pair[sample[winner][::-1]] = winner[::-1]
    return pair


def _result(path: CurveSequence, points: Array, progress: Array, curve: Index, local: Array, feet: Array, distance: Array) -> FootPoint:
    if not path.is_planar:
        return FootPoint(progress, feet, distance, np.full(distance.size, np.nan))
    tangent = path.at(curve, local, 1)[1]
    span = np.diff(path.breaks)[curve]
    m = len(path.curves)
    for at_end, shift, edge in ((local >= span, 1, path.starts), (local <= 0.0, -1, path.ends)):
        other = curve + shift
        usable = at_end & (path.closed | ((other >= 0) & (other < m)))
        tangent = np.where(usable[:, None], tangent + edge[1][np.mod(other, m)], tangent)
    gap = points - feet
    return FootPoint(progress, feet, distance, np.copysign(distance, tangent[:, 0] * gap[:, 1] - tangent[:, 1] * gap[:, 0]))
