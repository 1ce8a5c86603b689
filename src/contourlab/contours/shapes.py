"""Shapes of drawings: an affine map keeps the kind of a shape; then the shapes become curves."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TypeAlias

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import GeometryError
from contourlab.geometry import Arc, BSpline, Curve, EllipticalArc, Line, Nurbs
from contourlab.geometry.nurbs import cut_where_curvature_jumps, inner_knots, split_at

ROUND = 1e-12
"""Largest relative difference of the half-diameters of a circle."""
SAME_KNOT = 1e-10
"""Knots closer than this, relative to their range, are one rounded knot."""
CORNER = 1e-6
"""Jump of the tangent [rad] that divides a curve."""
STRAIGHT = 1e-10
"""Largest distance of the control points of a line from it, relative to its length."""
NUDGE = 1e-6
"""Largest shift [m] of a control point that coincides with the end of its curve."""


@dataclass(frozen=True, eq=False)
class LineShape:
    """From one point to another, each (n_axis,)."""

    start: Array
    end: Array

    def mapped(self, matrix: Array, offset: Array) -> LineShape:
        """Return the image under p -> matrix p + offset; a matrix (2, 3) projects."""
        return LineShape(matrix @ self.start + offset, matrix @ self.end + offset)

    def extent(self) -> tuple[Array, Array]:
        """Return lower and upper bounds of the coordinates."""
        return np.minimum(self.start, self.end), np.maximum(self.start, self.end)

    def curves(self) -> list[Curve]:
        """Return the curves, end to end."""
        return [Line(self.start, self.end)]


@dataclass(frozen=True, eq=False)
class ConicShape:
    """c + p cos t + q sin t, t from `start` to `end`, which may fall."""

    centre: Array
    p: Array
    q: Array
    start: float
    end: float

    def mapped(self, matrix: Array, offset: Array) -> ConicShape:
        """Return the image under p -> matrix p + offset."""
        return replace(self, centre=matrix @ self.centre + offset, p=matrix @ self.p, q=matrix @ self.q)

    def extent(self) -> tuple[Array, Array]:
        """Return bounds of the coordinates, those of the full ellipse."""
        reach = np.hypot(self.p, self.q)
        return self.centre - reach, self.centre + reach

    def curves(self) -> list[Curve]:
        """Return the curve: an arc where the shape is circular."""
        a, b = float(np.linalg.norm(self.p)), float(np.linalg.norm(self.q))
        if abs(a - b) <= ROUND * a and abs(float(self.p @ self.q)) <= ROUND * a * b:
            return [self._arc(0.5 * (a + b))]
        if self.end > self.start:
            return [EllipticalArc(self.centre, self.p, self.q, self.start, self.end)]
        return [EllipticalArc(self.centre, self.p, -self.q, -self.start, -self.end)]

    def _arc(self, radius: float) -> Arc:
        sweep = self.end - self.start
        if self.centre.size == 2:  # in the axes of the plane
            spoke = self.p * math.cos(self.start) + self.q * math.sin(self.start)
            sense = math.copysign(1.0, self.p[0] * self.q[1] - self.p[1] * self.q[0])
            return Arc(self.centre, radius, math.atan2(spoke[1], spoke[0]), sense * sweep)
        return Arc(self.centre, radius, self.start, sweep, self.p / radius, self.q / radius)


@dataclass(frozen=True, eq=False)
class SplineShape:
    """A B-spline: control points (n, n_axis), knots (n + degree + 1,), and weights (n,) if it is rational."""

    degree: int
    points: Array
    knots: Array
    weights: Array | None = None

    @classmethod
    def bezier(cls, *points: Array) -> SplineShape:
        """Return a Bezier curve from two or more control points."""
        n = len(points)
        return cls(n - 1, np.array(points), np.repeat([0.0, 1.0], n))

    def mapped(self, matrix: Array, offset: Array) -> SplineShape:
        """Return the image under p -> matrix p + offset."""
        return replace(self, points=self.points @ matrix.T + offset)

    def extent(self) -> tuple[Array, Array]:
        """Return bounds of the coordinates, those of the control points."""
        return self.points.min(axis=0), self.points.max(axis=0)

    def curves(self) -> list[Curve]:
        """Return the curves, cut at corners."""
        return spline_curves(self.degree, self.points, self.knots, self.weights)


Shape: TypeAlias = LineShape | ConicShape | SplineShape


# --- splines of files: merge rounded knots, cut at corners, replace straight ones by lines ---------------------------------------------


def spline_curves(degree: int, points: Array, knots: Array, weights: Array | None) -> list[Curve]:
    """Return the curves of a spline, end to end.

    Parameters
    ----------
    degree : int, >= 1
    points : ndarray (n, n_axis) [m]
    knots : ndarray (n + degree + 1,)
    weights : ndarray (n,) or None
        None, or all equal, for a polynomial spline.

    Raises
    ------
    GeometryError
        If the data do not fit together, or the curve has a gap or a cusp.
    """
    if len(knots) != len(points) + degree + 1 or len(points) <= degree:
        raise GeometryError(f"degree {degree} with {len(points)} control points needs {len(points) + degree + 1} knots, not {len(knots)}")
    if weights is not None and (len(weights) != len(points) or not (weights > 0.0).all()):
        raise GeometryError("give one weight > 0 for each control point")
    if weights is not None and np.ptp(weights) <= 1e-14 * weights.max():
        weights = None
    t = _settled(knots)
    if _is_straight(points):
        ends = points[[0, -1]]
        if not _starts_and_ends_at_points(degree, t):
            whole = BSpline(degree, points, t) if weights is None else Nurbs(degree, points, t, weights)
            ends = whole.raw(np.array([whole.first, whole.last]), 0)[0]
        return [Line(*ends)]
    lifted = points if weights is None else np.column_stack([points * weights[:, None], weights])
    lifted, t = _without_gaps(degree, lifted, t)
    inner, count = inner_knots(degree, t)
    # At a knot of multiplicity `degree` or more the tangent may jump.
    pieces = split_at(degree, lifted, t, inner[count >= degree])
    curves = [_curve(degree, c, k, weights is not None) for c, k in _smoothly_joined(degree, pieces, weights is not None)]
    return [piece for curve in curves for piece in (cut_where_curvature_jumps(curve) if isinstance(curve, BSpline | Nurbs) else [curve])]


def _settled(knots: Array) -> Array:
    """Return the knots; make those equal that differ only by rounding."""
    t = np.array(knots, dtype=float)
    if not np.isfinite(t).all() or np.any(np.diff(t) < -SAME_KNOT * max(np.ptp(t), 1e-300)):
        raise GeometryError("knots must be finite and must not decrease")
    for i in range(1, t.size):
        if t[i] - t[i - 1] <= SAME_KNOT * (t[-1] - t[0]):
            t[i] = t[i - 1]
    return t


def _without_gaps(degree: int, points: Array, t: Array) -> tuple[Array, Array]:
    """Merge control points that coincide at a knot whose multiplicity exceeds the degree."""
    inner, count = inner_knots(degree, t)
    for u in inner[count > degree]:
        k = int(np.searchsorted(t, u))
        if np.count_nonzero(t == u) > degree + 1 or np.abs(points[k] - points[k - 1]).max() > 1e-9 * np.ptp(points, axis=0).max():
            raise GeometryError(f"the spline has a gap at parameter {u:.9g}")
        points, t = np.delete(points, k, axis=0), np.delete(t, k)
    return points, t


def _is_straight(points: Array) -> bool:
    """Return whether all control points lie on one line, in order."""
    chord = points[-1] - points[0]
    size = float(np.linalg.norm(chord))
    if size == 0.0:
        return False
    along = (points - points[0]) @ (chord / size)
    away = np.linalg.norm(points - points[0] - along[:, None] * (chord / size), axis=1)
    return bool(away.max() <= STRAIGHT * size and np.all(np.diff(along) >= -STRAIGHT * size))


def _starts_and_ends_at_points(degree: int, t: Array) -> bool:
    return bool(t[0] == t[degree] and t[-1] == t[-degree - 1])


def _smoothly_joined(degree: int, pieces: list[tuple[Array, Array]], rational: bool) -> list[tuple[Array, Array]]:
    """Rejoin pieces that meet without a corner."""
    joined = pieces[:1]
    for points, t in pieces[1:]:
        before, knots = joined[-1]
        turn = _direction(points[:2], rational) - _direction(before[-2:], rational)
        if np.linalg.norm(turn) > CORNER:
            joined.append((points, t))
        else:
            joined[-1] = np.concatenate([before, points[1:]]), np.concatenate([knots[:-1], t[degree + 1 :]])
    return joined


def _direction(pair: Array, rational: bool) -> Array:
    a, b = (pair[:, :-1] / pair[:, -1:]) if rational else pair
    size = float(np.linalg.norm(b - a))
    return np.asarray((b - a) / size) if size > 0.0 else np.full(a.shape, np.nan)


def _curve(degree: int, points: Array, t: Array, rational: bool) -> Curve:
    plain, weights = (points[:, :-1] / points[:, -1:], points[:, -1]) if rational else (points, None)
    if _is_straight(plain) and _starts_and_ends_at_points(degree, t):
        return Line(plain[0], plain[-1])
    if degree > 1 and _starts_and_ends_at_points(degree, t):
        plain = _without_cusp(_without_cusp(plain)[::-1])[::-1]
    return BSpline(degree, plain, t) if weights is None else Nurbs(degree, plain, t, weights)


def _without_cusp(points: Array) -> Array:
    """Move a second control point that coincides with the first towards the third, by up to a micrometre.

    The curve moves by less than half of that. Drawing programs write such points for unused handles.
    """
    size = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    leg = points[2] - points[0] if len(points) > 2 else np.zeros(1)
    length = float(np.linalg.norm(leg))
    if length == 0.0 or float(np.linalg.norm(points[1] - points[0])) > 1e-6 * size:
        return points
    moved = points.copy()
    moved[1] = points[0] + leg * (min(NUDGE, 0.5 * length) / length)
    return moved
