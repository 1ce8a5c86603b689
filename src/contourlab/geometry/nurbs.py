"""B-splines and NURBS, and cuts where their curvature jumps.

At a knot of multiplicity m a spline of degree p has p - m continuous derivatives: for m >= p - 1 its curvature may jump. A planner must
know these places, so they become junctions of the path.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Index
from contourlab.errors import GeometryError, refuse
from contourlab.geometry.curve import Curve, by_arc_length
from contourlab.geometry.parametric import Parametric

JUMP = 1e-7
"""Smaller jumps, relative to the curvature or to 1/length, are rounding."""


class _Spline:
    """A polynomial spline in any number of dimensions and its derivatives, by de Boor's recursion."""

    def __init__(self, degree: int, points: Array, knots: Array) -> None:
        self.layers = [(degree, points, knots)]
        for _ in range(3):
            p, c, t = self.layers[-1]
            if p == 0:
                self.layers.append((0, np.zeros_like(c), t))
                continue
            gap = t[p + 1 : -1] - t[1 : -p - 1]
            slope = np.divide(p * np.diff(c, axis=0), gap[:, None], out=np.zeros_like(c[1:]), where=gap[:, None] > 0.0)
            self.layers.append((p - 1, slope, t[1:-1]))

    def __call__(self, u: Array, order: int) -> Array:
        degree, points, knots = self.layers[order]
        first = np.clip(np.searchsorted(knots, u, side="right") - 1, degree, len(points) - 1) - degree
        rows = np.ascontiguousarray(points.T)  # each coordinate runs along memory
        d = [rows.take(first + j, axis=1) for j in range(degree + 1)]
        t = [knots.take(first + j) for j in range(1, 2 * degree + 1)]
        for r in range(1, degree + 1):
            for j in range(degree, r - 1, -1):
                alpha = (u - t[j - 1]) / (t[degree + j - r] - t[j - 1])
                d[j] = (1.0 - alpha) * d[j - 1] + alpha * d[j]
        return np.asarray(d[degree].T)


class _Knotted(Parametric):
    """A curve over knots: its control points, its ends and the places where it is less smooth."""

    def _lay(self, degree: int, points: ArrayLike, knots: ArrayLike) -> None:
        self.degree = degree = int(degree)
        try:
            self.points, self.knots = c, t = np.array(points, dtype=float), np.array(knots, dtype=float)
        except (TypeError, ValueError):
            c, t = np.empty(0), np.empty(0)
        if c.ndim != 2 or not (np.isfinite(c).all() and np.isfinite(t).all()):
            raise GeometryError("control points must be finite, of shape (n, n_axis), and knots finite")
        if degree < 1 or len(c) <= degree or t.shape != (len(c) + degree + 1,):
            raise GeometryError(f"degree {degree} with {len(c)} control points needs {len(c) + degree + 1} knots, not {t.size}")
        self.n_axis, self.first, self.last = c.shape[1], float(t[degree]), float(t[len(c)])
        refuse(np.any(np.diff(t) < 0.0) or not self.last > self.first, GeometryError, "knots must not decrease, and must span an interval")

    def joints(self) -> Array:
        return np.unique(self.knots[(self.knots >= self.first) & (self.knots <= self.last)])


class BSpline(_Knotted):
    """A polynomial B-spline.

    Parameters
    ----------
    degree : int, >= 1
    points : array_like (n, n_axis) [m]
    knots : array_like (n + degree + 1,)
        Non-decreasing.
    """

    digest_parts = ("bspline", "degree", "points", "knots")

    def __init__(self, degree: int, points: ArrayLike, knots: ArrayLike) -> None:
        self._lay(degree, points, knots)
        self._spline = _Spline(self.degree, self.points, self.knots)
        self.measure()

    def raw(self, u: Array, order: int) -> Array:
        return np.array([self._spline(u, k) for k in range(order + 1)])

    def _speed(self, u: Array) -> Array:
        # Overridden because the length needs no positions.
        return np.asarray(np.linalg.norm(self._spline(u.ravel(), 1), axis=1).reshape(u.shape))


class Nurbs(_Knotted):
    """A rational B-spline.

    Parameters
    ----------
    degree : int, >= 1
    points : array_like (n, n_axis) [m]
    knots : array_like (n + degree + 1,) [1]
        Non-decreasing.
    weights : array_like (n,) [1], > 0

    Raises
    ------
    GeometryError
        If the numbers of points, knots and weights do not fit, or one is out of range.

    References
    ----------
    Piegl & Tiller, "The NURBS Book", 2nd ed., eqs (4.1) and (4.8).
    """

    digest_parts = ("nurbs", "degree", "points", "knots", "weights")

    def __init__(self, degree: int, points: ArrayLike, knots: ArrayLike, weights: ArrayLike) -> None:
        self._lay(degree, points, knots)
        self.weights = np.array(weights, dtype=float)
        if self.weights.shape != (len(self.points),) or not (np.isfinite(self.weights).all() and (self.weights > 0.0).all()):
            raise GeometryError("give one weight > 0 for each control point")
        # Relative to the first point, which keeps the digits of a small curve far from the origin.
        lifted = np.column_stack([(self.points - self.points[0]) * self.weights[:, None], self.weights])
        self._spline = _Spline(self.degree, lifted, self.knots)
        self.measure()

    def raw(self, u: Array, order: int) -> Array:
        lifted = [self._spline(u, k) for k in range(order + 1)]
        a, w = [x[:, :-1] for x in lifted], [x[:, -1:] for x in lifted]
        result: list[Array] = []
        for k in range(order + 1):
            result.append((a[k] - sum((math.comb(k, i) * w[i] * result[k - i] for i in range(1, k + 1)), np.zeros_like(a[k]))) / w[0])
        result[0] = result[0] + self.points[0]
        return np.array(result)


def inner_knots(degree: int, t: Array) -> tuple[Array, Index]:
    """Return the knots inside the curve, and their multiplicities."""
    return np.unique(t[(t > t[degree]) & (t < t[-degree - 1])], return_counts=True)


def cut_where_curvature_jumps(curve: BSpline | Nurbs) -> list[Curve]:
    """Cut a spline into pieces of continuous curvature; return them in order."""
    degree, t = curve.degree, curve.knots
    inner, count = inner_knots(degree, t)
    inner = inner[count >= max(degree - 1, 1)]
    if not inner.size:
        return [curve]
    before, after = (by_arc_length(curve.raw(u, 2), 2)[2] for u in (np.nextafter(inner, -np.inf), inner))
    size = np.maximum(np.maximum(np.linalg.norm(before, axis=1), np.linalg.norm(after, axis=1)), 1.0 / curve.length)
    places = inner[np.linalg.norm(after - before, axis=1) > JUMP * size]
    if not places.size:
        return [curve]
    if isinstance(curve, BSpline):
        return [BSpline(degree, points, knots) for points, knots in split_at(degree, curve.points, t, places)]
    pieces = split_at(degree, np.column_stack([curve.points * curve.weights[:, None], curve.weights]), t, places)
    return [Nurbs(degree, points[:, :-1] / points[:, -1:], knots, points[:, -1]) for points, knots in pieces]


def _insert(degree: int, points: Array, t: Array, u: float) -> tuple[Array, Array]:
    """Insert a knot once by Boehm's algorithm; The NURBS Book, 2nd ed., eq. (5.15)."""
    k, count = int(np.searchsorted(t, u, side="right")) - 1, int(np.count_nonzero(t == u))
    i = np.arange(k - degree + 1, k - count + 1)
    alpha = ((u - t[i]) / (t[i + degree] - t[i]))[:, None]
    between = alpha * points[i] + (1.0 - alpha) * points[i - 1]
    return np.concatenate([points[: k - degree + 1], between, points[k - count :]]), np.concatenate([t[: k + 1], [u], t[k + 1 :]])


def split_at(degree: int, points: Array, t: Array, places: Array) -> list[tuple[Array, Array]]:
    """Cut a spline at parameters inside it.

    Parameters
    ----------
    points : ndarray (n, m)
        Control points; for a rational spline, multiplied by their weights, with the weights in the last column.
    t : ndarray (n + degree + 1,)
    places : ndarray of float
        Rising.

    Returns
    -------
    list of (points, knots)
    """
    pieces: list[tuple[Array, Array]] = []
    for u in places:
        while np.count_nonzero(t == u) < degree:
            points, t = _insert(degree, points, t, float(u))
        k = int(np.searchsorted(t, u))  # the first of `degree` equal knots; the curve passes through point k - 1
        pieces.append((points[:k], np.append(t[: k + degree], u)))
        points, t = points[k - 1 :], np.concatenate([[u], t[k:]])
    return [*pieces, (points, t)]
