"""B-splines and their rational form, NURBS."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import GeometryError
from contourlab.geometry.parametric import Parametric

Array = NDArray[np.float64]


class _Spline:
    """A polynomial spline in any number of dimensions, with its derivatives, by de Boor's recursion."""

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
        n = len(points)
        span = np.clip(np.searchsorted(knots, u, side="right") - 1, degree, n - 1)
        d = [points[span - degree + j] for j in range(degree + 1)]
        for r in range(1, degree + 1):
            for j in range(degree, r - 1, -1):
                low, high = knots[span - degree + j], knots[span + 1 + j - r]
                alpha = ((u - low) / (high - low))[:, None]
                d[j] = (1.0 - alpha) * d[j - 1] + alpha * d[j]
        return np.asarray(d[degree])


def _checked(degree: int, points: ArrayLike, knots: ArrayLike) -> tuple[Array, Array]:
    try:
        c, t = np.array(points, dtype=float), np.array(knots, dtype=float)
    except (TypeError, ValueError):
        c, t = np.empty(0), np.empty(0)
    if c.ndim != 2 or not (np.isfinite(c).all() and np.isfinite(t).all()):
        raise GeometryError("control points must be finite and of the shape (n, n_axis), knots finite")
    if degree < 1 or len(c) <= degree or t.shape != (len(c) + degree + 1,):
        raise GeometryError(f"degree {degree} with {len(c)} control points wants {len(c) + degree + 1} knots, {t.size} given")
    inner = t[degree : len(c) + 1]
    if np.any(np.diff(t) < 0.0) or not inner[-1] > inner[0]:
        raise GeometryError("knots must not fall, and must span an interval")
    return c, t


class BSpline(Parametric):
    """A polynomial B-spline.

    Parameters
    ----------
    degree : int, >= 1
    points : array_like (n, n_axis) [m]
    knots : array_like (n + degree + 1,)
        Not falling.
    """

    def __init__(self, degree: int, points: ArrayLike, knots: ArrayLike) -> None:
        self.degree = int(degree)
        self.points, self.knots = _checked(self.degree, points, knots)
        self.n_axis = self.points.shape[1]
        self._spline = _Spline(self.degree, self.points, self.knots)
        self.first, self.last = float(self.knots[self.degree]), float(self.knots[len(self.points)])
        self.measure()

    def joints(self) -> Array:
        inside = (self.knots >= self.first) & (self.knots <= self.last)
        return np.unique(self.knots[inside])

    def raw(self, u: Array, order: int) -> Array:
        return np.array([self._spline(u, k) for k in range(order + 1)])

    def _speed(self, u: Array) -> Array:
        # The length is integrated from this alone: positions need not be worked out for it.
        return np.asarray(np.linalg.norm(self._spline(u.ravel(), 1), axis=1).reshape(u.shape))

    def describe(self) -> tuple[object, ...]:
        return ("bspline", self.degree, *self.points.ravel().tolist(), *self.knots.tolist())


class Nurbs(Parametric):
    """A rational B-spline: weights draw it to its control points.

    Parameters
    ----------
    degree : int, >= 1
    points : array_like (n, n_axis) [m]
    knots : array_like (n + degree + 1,)
    weights : array_like (n,), > 0

    References
    ----------
    Piegl & Tiller, "The NURBS Book", 2nd ed., eqs (4.1) and (4.8).
    """

    def __init__(self, degree: int, points: ArrayLike, knots: ArrayLike, weights: ArrayLike) -> None:
        self.degree = int(degree)
        self.points, self.knots = _checked(self.degree, points, knots)
        self.weights = np.array(weights, dtype=float)
        if self.weights.shape != (len(self.points),) or not (np.isfinite(self.weights).all() and (self.weights > 0.0).all()):
            raise GeometryError("one weight > 0 for each control point is wanted")
        self.n_axis = self.points.shape[1]
        # Held from the first point, so that a small curve far from the origin keeps its digits.
        lifted = np.column_stack([(self.points - self.points[0]) * self.weights[:, None], self.weights])
        self._spline = _Spline(self.degree, lifted, self.knots)
        self.first, self.last = float(self.knots[self.degree]), float(self.knots[len(self.points)])
        self.measure()

    def joints(self) -> Array:
        inside = (self.knots >= self.first) & (self.knots <= self.last)
        return np.unique(self.knots[inside])

    def raw(self, u: Array, order: int) -> Array:
        lifted = [self._spline(u, k) for k in range(order + 1)]
        a, w = [x[:, :-1] for x in lifted], [x[:, -1:] for x in lifted]
        binomial = [[1.0], [1.0, 1.0], [1.0, 2.0, 1.0], [1.0, 3.0, 3.0, 1.0]]
        found: list[Array] = []
        for k in range(order + 1):
            rest = a[k] - sum((binomial[k][i] * w[i] * found[k - i] for i in range(1, k + 1)), np.zeros_like(a[k]))
            found.append(rest / w[0])
        found[0] = found[0] + self.points[0]
        return np.array(found)

    def describe(self) -> tuple[object, ...]:
        return ("nurbs", self.degree, *self.points.ravel().tolist(), *self.knots.tolist(), *self.weights.tolist())
