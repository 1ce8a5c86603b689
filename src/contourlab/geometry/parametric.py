"""Curves given by a parameter other than arc length."""

from __future__ import annotations

import math
from abc import abstractmethod
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Flags, Index
from contourlab.errors import GeometryError
from contourlab.geometry.curve import Curve, by_arc_length, clenshaw

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(12)
_TERMS = 12
_CHEBYSHEV = np.cos(np.pi * (np.arange(_TERMS) + 0.5) / _TERMS)
_TO_CHEBYSHEV = (2.0 / _TERMS) * np.cos(np.arange(_TERMS)[:, None] * np.arccos(_CHEBYSHEV)[None, :])
_TO_CHEBYSHEV[0] *= 0.5
_RISE = 16
"""Terms of the series of the speed on an interval; the series of the length has one more."""
_RISE_NODES = np.cos(np.pi * (np.arange(_RISE) + 0.5) / _RISE)
_TO_SPEED = np.linalg.inv(np.polynomial.chebyshev.chebvander(_RISE_NODES, _RISE - 1))
_TO_RISE = np.polynomial.chebyshev.chebint(_TO_SPEED, lbnd=-1)
_PROBES = np.array([-0.93, -0.61, 0.07, 0.52, 0.96])
_CHUNK = 4096
"""Pieces inverted at a time."""


def _unit(vectors: Array) -> Array:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))


class Parametric(Curve):
    """A curve r(u), u from `first` to `last`, evaluated by arc length.

    Gauss-Legendre rules of 12 points give the length, on intervals halved until both halves agree with the whole to 1e-14 of the length.
    Newton steps within an interval give the parameter of an arc length, to the last digit.
    """

    first: float = 0.0
    last: float = 2.0 * math.pi
    n_joint: int = 2

    @abstractmethod
    def raw(self, u: Array, order: int) -> Array:
        """Return r and its derivatives by u: (order + 1, n, n_axis)."""

    def joints(self) -> Array:
        """Return the parameters at which higher derivatives may jump, ends included."""
        return np.linspace(self.first, self.last, self.n_joint)

    def measure(self) -> None:
        """Compute the length; subclasses call this after setting their data."""
        left, right = self.joints()[:-1], self.joints()[1:]
        done: list[tuple[Array, Array, Array]] = []
        whole = self._lengths(left, right)
        rough = float(whole.sum())
        if not (np.isfinite(rough) and rough > 0.0):
            raise GeometryError(f"{type(self).__name__} of zero length, or with coordinates that are not finite")
        for _ in range(40):
            middle = 0.5 * (left + right)
            a, b = self._lengths(left, middle), self._lengths(middle, right)
            good = np.abs(a + b - whole) <= 1e-14 * rough
            done.append((left[good], right[good], (a + b)[good]))
            left, right = np.concatenate([left[~good], middle[~good]]), np.concatenate([middle[~good], right[~good]])
            whole = np.concatenate([a[~good], b[~good]])
            if left.size == 0:
                break
        else:
            raise GeometryError(f"{type(self).__name__}: its length does not converge: the curve has a cusp")
        starts, stops, lengths = (np.concatenate(column) for column in zip(*done, strict=True))
        order = np.argsort(starts)
        self._knots = np.append(starts[order], stops[order[-1]])
        self.marks = np.concatenate([[0.0], np.cumsum(lengths[order])])
        self.length = float(self.marks[-1])
        self._check_smooth()

    def _check_smooth(self) -> None:
        """Raise an error for corners, gaps and stationary points inside the curve, which would be hidden jumps by arc length."""
        name, slow = type(self).__name__, self._speed(self._knots) <= 1e-6 * self.length / (self.last - self.first)
        if slow.any():
            raise GeometryError(
                f"{name} is stationary at parameter {self._knots[int(np.argmax(slow))]:.9g}: a cusp, or points that coincide"
            )
        inner = self.joints()[1:-1]
        before, after = self.raw(np.nextafter(inner, -np.inf), 1), self.raw(inner, 1)
        for what, jump in (
            ("gap", np.linalg.norm(after[0] - before[0], axis=1) > 1e-9 * self.length),
            ("corner", np.linalg.norm(_unit(after[1]) - _unit(before[1]), axis=1) > 1e-6),
        ):
            if jump.any():
                raise GeometryError(
                    f"{name} has a {what} inside, at parameter {inner[int(np.argmax(jump))]:.9g}: divide it into two curves of a path"
                )

    def _speed(self, u: Array) -> Array:
        return np.asarray(np.linalg.norm(self.raw(u.ravel(), 1)[1], axis=1).reshape(u.shape))

    def _lengths(self, left: Array, right: Array) -> Array:
        half = 0.5 * (right - left)
        points = (0.5 * (left + right))[:, None] + half[:, None] * _NODES
        return np.asarray(half * (self._speed(points) @ _WEIGHTS))

    def _solve(self, i: Index, wanted: Array) -> Array:
        """Return the parameters of lengths (n, k) from the start of knot intervals (n,), by Newton steps."""
        left, right = self._knots[i], self._knots[i + 1]
        middle, half = 0.5 * (left + right), 0.5 * (right - left)
        speed, rise, holds = self._rise(left, right)
        x = 2.0 * wanted / np.diff(self.marks)[i, None] - 1.0
        for _ in range(12):
            step = (clenshaw(rise.T[:, :, None], x) - wanted) / np.maximum(clenshaw(speed.T[:, :, None], x) * half[:, None], 1e-300)
            x = np.clip(x - step, -1.0, 1.0)
            if np.abs(step).max(initial=0.0) <= 4e-16:
                break
        u = middle[:, None] + half[:, None] * x
        rough = np.flatnonzero(~holds)
        places = np.full(rough.size, wanted.shape[1])
        u[rough] = self._solve_by_quadrature(np.repeat(left[rough], places), np.repeat(right[rough], places), wanted[rough], u[rough])
        return np.asarray(u)

    def _rise(self, left: Array, right: Array) -> tuple[Array, Array, Flags]:
        """Return Chebyshev series of speed and length over intervals of the parameter, and whether they are accurate.

        With these series, the curve is evaluated at a few places per interval instead of a dozen per Newton step.
        """
        middle, half = 0.5 * (left + right), 0.5 * (right - left)
        speed = self._speed(middle[:, None] + half[:, None] * _RISE_NODES)
        rise = half[:, None] * (speed @ _TO_RISE.T)
        probes = middle[:, None] + half[:, None] * _PROBES
        exact = self._lengths(np.repeat(left, _PROBES.size), probes.ravel()).reshape(probes.shape)
        gap = np.abs(clenshaw(rise.T[:, :, None], np.broadcast_to(_PROBES, probes.shape)) - exact)
        return speed @ _TO_SPEED.T, rise, np.asarray((gap <= 1e-15 * self.length).all(axis=1))

    def _solve_by_quadrature(self, left: Array, right: Array, wanted: Array, start: Array) -> Array:
        """Return the parameters where no series converges: near a cusp."""
        u, lengths = start.ravel(), wanted.ravel()
        for _ in range(12):
            step = (self._lengths(left, u) - lengths) / np.maximum(self._speed(u), 1e-300)
            u = np.clip(u - step, left, right)
            if np.abs(step).max(initial=0.0) <= 4e-16 * max(abs(self.first), abs(self.last)):
                break
        return np.asarray(u.reshape(wanted.shape))

    @cached_property
    def _inverse(self) -> tuple[Array, Array]:
        """Chebyshev coefficients of the parameter over arc length, on pieces halved until they are accurate to 1e-14 of the length."""
        pieces: list[tuple[Array, Array]] = []
        for first in range(0, len(self.marks) - 1, _CHUNK):
            marks = self.marks[first : first + _CHUNK + 1]
            pieces += self._inverted(marks[:-1], marks[1:])
        begin, rows = (np.concatenate(column) for column in zip(*pieces, strict=True))
        order = np.argsort(begin)
        return np.append(begin[order], self.length), rows[order]

    def _inverted(self, left: Array, right: Array) -> list[tuple[Array, Array]]:
        """Return starts and coefficients of the inverse on intervals of the arc length, each within one knot interval."""
        pieces = []
        # Parameters far from 0 are rounded themselves.
        rounding = 16.0 * np.finfo(float).eps * max(abs(self.first), abs(self.last))
        at = np.concatenate([_CHEBYSHEV, _PROBES])
        for _ in range(30):
            middle, half = 0.5 * (left + right), 0.5 * (right - left)
            i = np.clip(np.searchsorted(self.marks, middle, side="right") - 1, 0, len(self.marks) - 2)
            parameters = self._solve(i, middle[:, None] + half[:, None] * at - self.marks[i, None])
            coefficients, exact = parameters[:, :_TERMS] @ _TO_CHEBYSHEV.T, parameters[:, _TERMS:]
            gap = np.abs(clenshaw(coefficients.T[:, :, None], np.broadcast_to(_PROBES, exact.shape)) - exact)
            speed = self._speed(exact)
            good = (gap * speed <= np.maximum(1e-14 * self.length, rounding * speed)).all(axis=1) | (half <= 1e-9 * self.length)
            pieces.append((left[good], coefficients[good]))
            bad = ~good
            left, right = np.concatenate([left[bad], middle[bad]]), np.concatenate([middle[bad], right[bad]])
            if left.size == 0:
                break
        return pieces

    def parameter(self, s: ArrayLike) -> Array:
        """Return the parameters (n,) of arc lengths (n,), accurate to 1e-13 of the length."""
        along = np.clip(np.atleast_1d(np.asarray(s, dtype=float)), 0.0, self.length)
        if along.size <= 2 and np.all((along == 0.0) | (along == self.length)):
            # The ends, needed to join curves, require no inverse.
            return np.where(along == 0.0, self.first, self.last)
        begin, rows = self._inverse
        i = np.clip(np.searchsorted(begin, along, side="right") - 1, 0, len(rows) - 1)
        low, high = begin[i], begin[i + 1]
        x = np.clip((2.0 * along - low - high) / (high - low), -1.0, 1.0)
        return np.asarray(np.clip(clenshaw(rows[i].T, x), self.first, self.last))

    def smallest_radius(self) -> float:
        # Intervals are short where the curve turns sharply; evenly spread samples would miss a cusp-like tail.
        u = (self._knots[:-1, None] + np.diff(self._knots)[:, None] * np.linspace(0.0, 1.0, 17)).ravel()
        bend = float(np.linalg.norm(by_arc_length(self.raw(u, 2), 2)[2], axis=1).max())
        return 1.0 / bend if bend > 0.0 else float("inf")

    def derivatives(self, s: ArrayLike, order: int = 3) -> Array:
        return by_arc_length(self.raw(self.parameter(s), max(order, 1)), order)
