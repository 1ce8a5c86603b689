"""Splines as files have them, to curves that a path can hold: knots in order, cut at corners, straight ones as lines."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import GeometryError
from contourlab.geometry import BSpline, Curve, Line, Nurbs
from contourlab.geometry.nurbs import cut_where_curvature_jumps, inner_knots, split_at

Array = NDArray[np.float64]
SAME_KNOT = 1e-10
"""Knots closer than this part of their range are one knot that was rounded in writing."""
CORNER = 1e-6
"""Jump of the tangent [rad] that a single curve cannot have."""
STRAIGHT = 1e-10
"""A spline whose control points stray less than this part of its length from a line is a line."""
NUDGE = 1e-6
"""How far [m], at most, a control point is moved that lies on the end of its curve."""


def spline_curves(degree: int, points: Array, knots: Array, weights: Array | None) -> list[Curve]:
    """Return the curves of a spline, end to end.

    Parameters
    ----------
    degree : int, >= 1
    points : ndarray (n, n_axis) [m]
    knots : ndarray (n + degree + 1,)
    weights : ndarray (n,) or None
        None, or all alike, for a polynomial spline.

    Raises
    ------
    GeometryError
        If the data do not fit together, or the curve has a gap or a point where it stands still.
    """
    if len(knots) != len(points) + degree + 1 or len(points) <= degree:
        raise GeometryError(f"degree {degree} with {len(points)} control points wants {len(points) + degree + 1} knots, {len(knots)} given")
    if weights is not None and (len(weights) != len(points) or not (weights > 0.0).all()):
        raise GeometryError("one weight > 0 for each control point is wanted")
    if weights is not None and np.ptp(weights) <= 1e-14 * weights.max():
        weights = None
    t = _settled(knots)
    if _is_straight(points):
        return [Line(points[0], points[-1])] if _starts_and_ends_at_points(degree, t) else [_line(degree, points, t, weights)]
    lifted = points if weights is None else np.column_stack([points * weights[:, None], weights])
    lifted, t = _without_gaps(degree, lifted, t)
    inner, count = inner_knots(degree, t)
    # Where a knot stands `degree` times or as often as a tangent may jump there.
    pieces = split_at(degree, lifted, t, inner[count >= degree])
    found = [_curve(degree, c, k, weights is not None) for c, k in _smoothly_joined(degree, pieces, weights is not None)]
    return [piece for curve in found for piece in (cut_where_curvature_jumps(curve) if isinstance(curve, BSpline | Nurbs) else [curve])]


def _settled(knots: Array) -> Array:
    """Return the knots with those made equal that differ by rounding alone."""
    t = np.array(knots, dtype=float)
    if not np.isfinite(t).all() or np.any(np.diff(t) < -SAME_KNOT * max(np.ptp(t), 1e-300)):
        raise GeometryError("knots must be finite and must not fall")
    for i in range(1, t.size):
        if t[i] - t[i - 1] <= SAME_KNOT * (t[-1] - t[0]):
            t[i] = t[i - 1]
    return t


def _without_gaps(degree: int, points: Array, t: Array) -> tuple[Array, Array]:
    """Make one control point of two that coincide at a knot which stands more often than the degree."""
    inner, count = inner_knots(degree, t)
    for u in inner[count > degree]:
        k = int(np.searchsorted(t, u))
        if np.count_nonzero(t == u) > degree + 1 or np.abs(points[k] - points[k - 1]).max() > 1e-9 * np.ptp(points, axis=0).max():
            raise GeometryError(f"the spline has a gap at parameter {u:.9g}")
        points, t = np.delete(points, k, axis=0), np.delete(t, k)
    return points, t


def _is_straight(points: Array) -> bool:
    """Tell whether all control points lie on one line, in order."""
    chord = points[-1] - points[0]
    size = float(np.linalg.norm(chord))
    if size == 0.0:
        return False
    along = (points - points[0]) @ (chord / size)
    away = np.linalg.norm(points - points[0] - along[:, None] * (chord / size), axis=1)
    return bool(away.max() <= STRAIGHT * size and np.all(np.diff(along) >= -STRAIGHT * size))


def _starts_and_ends_at_points(degree: int, t: Array) -> bool:
    return bool(t[0] == t[degree] and t[-1] == t[-degree - 1])


def _line(degree: int, points: Array, t: Array, weights: Array | None) -> Line:
    whole = BSpline(degree, points, t) if weights is None else Nurbs(degree, points, t, weights)
    ends = whole.raw(np.array([whole.first, whole.last]), 0)[0]
    return Line(ends[0], ends[1])


def _smoothly_joined(degree: int, pieces: list[tuple[Array, Array]], rational: bool) -> list[tuple[Array, Array]]:
    """Put pieces together again that meet without a corner."""
    found = pieces[:1]
    for points, t in pieces[1:]:
        before, knots = found[-1]
        turn = _direction(points[:2], rational) - _direction(before[-2:], rational)
        if np.linalg.norm(turn) > CORNER:
            found.append((points, t))
        else:
            found[-1] = np.concatenate([before, points[1:]]), np.concatenate([knots[:-1], t[degree + 1 :]])
    return found


def _direction(pair: Array, rational: bool) -> Array:
    a, b = (pair[:, :-1] / pair[:, -1:]) if rational else pair
    size = float(np.linalg.norm(b - a))
    return np.asarray((b - a) / size) if size > 0.0 else np.full(a.shape, np.nan)


def _curve(degree: int, points: Array, t: Array, rational: bool) -> Curve:
    plain, weights = (points[:, :-1] / points[:, -1:], points[:, -1]) if rational else (points, None)
    if _is_straight(plain) and _starts_and_ends_at_points(degree, t):
        return Line(plain[0], plain[-1])
    if degree > 1 and _starts_and_ends_at_points(degree, t):
        plain = _moving(_moving(plain)[::-1])[::-1]
    return BSpline(degree, plain, t) if weights is None else Nurbs(degree, plain, t, weights)


def _moving(points: Array) -> Array:
    """Return control points of which the second does not lie on the first, where the curve would stand still.

    It is moved towards the third by up to a micrometre, which moves the curve by less than half of that; drawing programs leave such
    points where a handle was not pulled out.
    """
    size = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    if len(points) < 3 or float(np.linalg.norm(points[1] - points[0])) > 1e-6 * size:
        return points
    way = points[2] - points[0]
    reach = float(np.linalg.norm(way))
    if reach == 0.0:
        return points
    moved = points.copy()
    moved[1] = points[0] + way * (min(NUDGE, 0.5 * reach) / reach)
    return moved
