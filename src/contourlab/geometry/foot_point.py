"""The exact foot point: the closest point of a path, searched independently for each sample.

In a window around the progress of a sample, each curve in reach gives its closest point: lines and flat arcs in closed form, other curves
by sampling and a bracketed Newton iteration. The foot point is the nearest of these; ties go to the one nearest to the progress, which
selects the right branch where the path crosses itself.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Index
from contourlab.errors import GeometryError
from contourlab.geometry.bracketing import Bends, brackets
from contourlab.geometry.broad_phase import curves_in_reach
from contourlab.geometry.curve_sequence import CurveSequence
from contourlab.geometry.table import PathTable, path_table
from contourlab.threads import in_threads

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
    if not (np.isfinite(p).all() and np.isfinite(s).all()):
        raise GeometryError("points and progress must be finite")
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
    row = np.arange(curve.size)
    pair, s = np.concatenate([row, row, pair]), np.concatenate([low, high, fine])
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
    side = tangent[:, 0] * gap[:, 1] - tangent[:, 1] * gap[:, 0]
    return FootPoint(progress, feet, distance, np.copysign(distance, side))
