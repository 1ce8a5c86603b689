"""Curves known by a parameter that is not their arc length."""

from __future__ import annotations

from abc import abstractmethod

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import GeometryError
from contourlab.geometry.curve import Curve, by_arc_length

__all__ = ["Parametric"]

Array = NDArray[np.float64]
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(12)


class Parametric(Curve):
    """A curve r(u), u from `first` to `last`, made to run by its arc length.

    The length is integrated by Gauss-Legendre rules of 12 points on intervals that are halved until two halves agree with the whole to
    1e-14 of the curve; the parameter of an arc length is found by Newton steps inside its interval, to the last digit.
    """

    first: float
    last: float

    @abstractmethod
    def raw(self, u: Array, order: int) -> Array:
        """Return r and its derivatives by u: (order + 1, n, n_axis)."""

    def joints(self) -> Array:
        """Return parameters at which higher derivatives may jump, ends included."""
        return np.array([self.first, self.last])

    def measure(self) -> None:
        """Work out the length; a subclass calls it once its data stand."""
        left, right = self.joints()[:-1], self.joints()[1:]
        done: list[tuple[float, float, float]] = []
        rough = float(self._lengths(left, right).sum())
        if not (np.isfinite(rough) and rough > 0.0):
            raise GeometryError(f"{type(self).__name__} of zero length, or with coordinates that are not finite")
        for _ in range(40):
            middle = 0.5 * (left + right)
            whole, a, b = self._lengths(left, right), self._lengths(left, middle), self._lengths(middle, right)
            good = np.abs(a + b - whole) <= 1e-14 * rough
            done += [(float(x), float(y), float(z)) for x, y, z in zip(left[good], right[good], (a + b)[good], strict=True)]
            left, right = np.concatenate([left[~good], middle[~good]]), np.concatenate([middle[~good], right[~good]])
            if left.size == 0:
                break
        else:
            raise GeometryError(f"{type(self).__name__}: its length does not converge; the curve has a point where it stands still")
        done.sort()
        self._knots = np.array([d[0] for d in done] + [done[-1][1]])
        self._marks = np.concatenate([[0.0], np.cumsum([d[2] for d in done])])
        self.length = float(self._marks[-1])

    def _speed(self, u: Array) -> Array:
        return np.asarray(np.linalg.norm(self.raw(u.ravel(), 1)[1], axis=1).reshape(u.shape))

    def _lengths(self, left: Array, right: Array) -> Array:
        half = 0.5 * (right - left)
        points = (0.5 * (left + right))[:, None] + half[:, None] * _NODES
        return np.asarray(half * (self._speed(points) @ _WEIGHTS))

    def parameter(self, s: ArrayLike) -> Array:
        """Return the parameters (n,) of arc lengths (n,)."""
        along = np.clip(np.atleast_1d(np.asarray(s, dtype=float)), 0.0, self.length)
        i = np.clip(np.searchsorted(self._marks, along, side="right") - 1, 0, len(self._marks) - 2)
        left, right = self._knots[i], self._knots[i + 1]
        wanted = along - self._marks[i]
        u = left + (right - left) * wanted / (self._marks[i + 1] - self._marks[i])
        for _ in range(12):
            step = (self._lengths(left, u) - wanted) / np.maximum(self._speed(u), 1e-300)
            u = np.clip(u - step, left, right)
            if np.abs(step).max(initial=0.0) <= 4e-16 * max(abs(self.first), abs(self.last)):
                break
        return np.asarray(u)

    def derivatives(self, s: ArrayLike, order: int = 3) -> Array:
        return by_arc_length(self.raw(self.parameter(s), max(order, 1)), order)
