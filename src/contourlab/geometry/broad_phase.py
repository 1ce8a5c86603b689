"""Find the curves of a path that may hold the closest point, from distances to junctions alone.

A part of the path with length L, whose ends lie d and e from the point, is nowhere closer than (d + e - L) / 2. It is excluded if a
junction is closer. The search halves parts, the better half first, until single curves remain: a few out of thousands, after some tens of
distances.
"""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.geometry.curve_sequence import CurveSequence
from contourlab.native.kernel import kernel

_FEW = 4
"""Up to this mean number of curves per sample, all curves are candidates."""
_DEPTH = 128
_SLACK = 1e-9
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
    begin, end = _numbers(path, first), _numbers(path, last)
    count = end - begin + 1
    if count.sum() > _FEW * count.size:
        sample, number = _searched(path, points, begin, end)
    else:
        sample = np.repeat(np.arange(around.size), count)
        number = np.repeat(begin, count) + np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    m = len(path.curves)
    lap = np.floor_divide(number, m)
    curve = number - lap * m
    offset = lap * path.length + path.breaks[curve]
    span = np.diff(path.breaks)[curve]
    low = np.clip(first[sample] - offset, 0.0, span)
    high = np.clip(last[sample] - offset, 0.0, span)
    return sample, curve, lap.astype(float), low, high


def _numbers(path: CurveSequence, s: Array) -> Index:
    """Return the curve of each arc length, counted over laps."""
    m = len(path.curves)
    lap = np.floor(s / path.length) if path.closed else np.zeros(s.size)
    curve = np.searchsorted(path.breaks, s - lap * path.length, side="right") - 1
    return np.clip(curve, 0, m - 1) + (lap * m).astype(np.int64)


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
    if closed:
        return (k // m) * along[m] + along[k % m]
    return along[k]


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
            best = min(best, away + _SLACK)
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
