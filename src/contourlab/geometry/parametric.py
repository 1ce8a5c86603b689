"""Curves by a parameter other than arc length; ellipse, elliptical arc, lemniscate, Lissajous figure, star, spiral."""

from __future__ import annotations

import math
from abc import abstractmethod
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Flags, Index
from contourlab.errors import GeometryError, refuse
from contourlab.geometry.curve import Curve, by_arc_length, clenshaw, positive, vector

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


def _quarter_turns(u: Array) -> list[tuple[Array, Array]]:
    """Return (cos u, sin u) and its three derivatives."""
    c, s = np.cos(u), np.sin(u)
    return [(c, s), (-s, c), (-c, -s), (s, -c)]


class Ellipse(Parametric):
    """x = a cos u, y = b sin u: one turn, counter-clockwise from (a, 0).

    Parameters
    ----------
    a, b : float [m], > 0
        Semi-axes.
    """

    digest_parts = ("ellipse", "a", "b")
    n_axis = 2
    n_joint = 9

    def __init__(self, a: float, b: float) -> None:
        positive(a=a, b=b)
        self.a, self.b = float(a), float(b)
        self.measure()

    def raw(self, u: Array, order: int) -> Array:
        return np.array([np.column_stack([self.a * x, self.b * y]) for x, y in _quarter_turns(u)[: order + 1]])


class EllipticalArc(Parametric):
    """r = c + p cos t + q sin t: a part of any ellipse, in the plane or in space.

    Parameters
    ----------
    centre : array_like (n_axis,) [m]
    p, q : array_like (n_axis,) [m]
        Two conjugate half-diameters; the semi-axes if they are at right angles.
    start, end : float [rad]
        Range of t; a full ellipse by default.

    Raises
    ------
    GeometryError
        If p and q are parallel, the parameter does not rise, or a number is not finite.

    >>> round(EllipticalArc((0, 0), (2, 0), (0, 2), 0.0, math.pi).length, 6)
    6.283185
    """

    digest_parts = ("elliptical-arc", "first", "last", "centre", "p", "q")

    def __init__(self, centre: ArrayLike, p: ArrayLike, q: ArrayLike, start: float = 0.0, end: float = 2.0 * math.pi) -> None:
        self.centre, self.p, self.q = vector(centre, "centre"), vector(p, "p"), vector(q, "q")
        n = self.n_axis = self.centre.size
        if n < 2 or self.p.size != n or self.q.size != n:
            raise GeometryError(f"centre, p and q have {n}, {self.p.size} and {self.q.size} coordinates: two or more, the same for all")
        size = np.linalg.norm([self.p, self.q], axis=1)
        # The area of the parallelogram; a thinner ellipse cannot be distinguished from a line.
        area = math.sqrt(max(0.0, float((size[0] * size[1]) ** 2 - (self.p @ self.q) ** 2)))
        if not area > 1e-7 * float(size.max()) ** 2:
            raise GeometryError(f"an ellipse with the half-diameters {self.p.tolist()} and {self.q.tolist()} has no width")
        self.first, self.last = float(start), float(end)
        if not (math.isfinite(self.first) and math.isfinite(self.last) and self.last > self.first):
            raise GeometryError(f"an elliptical arc from {start!r} to {end!r} rad: the parameter must rise, between finite numbers")
        self.n_joint = max(1, math.ceil((self.last - self.first) / (0.25 * math.pi) - 1e-9)) + 1
        self.measure()

    def raw(self, u: Array, order: int) -> Array:
        c, s = np.cos(u)[:, None], np.sin(u)[:, None]
        spoke, swing = c * self.p + s * self.q, c * self.q - s * self.p
        result = np.array([spoke, swing, -spoke, -swing][: order + 1])
        result[0] += self.centre
        return result


class Lemniscate(Parametric):
    """x = a sin u, y = a sin u cos u: a figure of eight that starts and crosses itself at the origin.

    Parameters
    ----------
    a : float [m], > 0
        Half its width.
    """

    digest_parts = ("lemniscate", "a")
    n_axis = 2
    n_joint = 9

    def __init__(self, a: float) -> None:
        positive(a=a)
        self.a = float(a)
        self.measure()

    def raw(self, u: Array, order: int) -> Array:
        c, s, c2, s2 = np.cos(u), np.sin(u), np.cos(2.0 * u), np.sin(2.0 * u)
        rows = [(s, 0.5 * s2), (c, c2), (-s, -2.0 * s2), (-c, -4.0 * c2)]
        return np.array([self.a * np.column_stack(row) for row in rows[: order + 1]])


class Lissajous(Parametric):
    """A sine in each axis, x_j = A sin((k + j) u + j phase), j = 0, 1, ...: one period, in any number of axes.

    All axes stop at once, in a cusp, only if k phase is 90 degrees plus a multiple of 180 degrees.

    Parameters
    ----------
    axes : int, 2 to 9
    amplitude : float [m], > 0
        A, of each axis.
    lowest : int, 1 to 20
        k: periods of the first axis in a lap; each further axis has one period more.
    phase : float [rad]
        Between one axis and the next.

    Raises
    ------
    GeometryError
        If a number is out of range, or the phase is within six degrees of a cusp.

    Notes
    -----
    Two axes give the usual Lissajous figure; the form for more axes is our own.
    """

    digest_parts = ("lissajous", "n_axis", "amplitude", "lowest", "phase")

    def __init__(self, axes: float, amplitude: float, lowest: float, phase: float) -> None:
        for name, value, low, high in (("axes", axes, 2, 9), ("lowest", lowest, 1, 20)):
            if not (low <= value <= high and float(value).is_integer()):
                raise GeometryError(f"{name} = {value!r}: must be a whole number from {low} to {high}")
        positive(amplitude=amplitude)
        self.n_axis, self.amplitude, self.lowest, self.phase = int(axes), float(amplitude), int(lowest), float(phase)
        refuse(not math.isfinite(self.phase), GeometryError, f"phase = {phase!r} rad: must be finite")
        if abs(math.cos(self.lowest * self.phase)) < 0.1:
            raise GeometryError(
                f"phase = {phase!r} rad: with lowest = {self.lowest} all axes reverse at once, in a cusp; "
                "keep lowest times phase six degrees away from 90 and 270 degrees"
            )
        self._turns = float(self.lowest) + np.arange(self.n_axis)
        self.n_joint = 4 * int(self._turns[-1]) + 1
        self.measure()

    def raw(self, u: Array, order: int) -> Array:
        k = self._turns
        angle = u[:, None] * k + self.phase * np.arange(self.n_axis)
        s, c = self.amplitude * np.sin(angle), self.amplitude * np.cos(angle)
        return np.array([s, k * c, -(k**2) * s, -(k**3) * c][: order + 1])


class Star(Parametric):
    """A star with rounded lobes: radius R (1 + depth cos n u) at angle u.

    Parameters
    ----------
    radius : float [m], > 0
    lobes : int, >= 2
    depth : float, 0 to 1 exclusive
    """

    digest_parts = ("star", "radius", "lobes", "depth")
    n_axis = 2

    def __init__(self, radius: float, lobes: float, depth: float) -> None:
        positive(radius=radius)
        self.radius, self.depth = float(radius), float(depth)
        if not float(lobes).is_integer() or lobes < 2 or not 0.0 <= self.depth < 1.0:
            raise GeometryError(f"star of {lobes} lobes, depth {depth}: lobes must be a whole number >= 2, depth from 0 to below 1")
        self.lobes = int(lobes)
        self.n_joint = 4 * self.lobes + 1
        self.measure()

    def raw(self, u: Array, order: int) -> Array:
        n, k = self.lobes, self.depth
        c, s = np.cos(n * u), np.sin(n * u)
        rho = self.radius * np.array([1.0 + k * c, -k * n * s, -k * n**2 * c, k * n**3 * s])
        turn = [np.column_stack(pair) for pair in _quarter_turns(u)]
        # Leibniz: the m-th derivative of rho times (cos, sin).
        return np.array([sum(math.comb(m, j) * rho[m - j][:, None] * turn[j] for j in range(m + 1)) for m in range(order + 1)])


class Spiral(Parametric):
    """Archimedean spiral around the origin, outwards and counter-clockwise: r = inner + pitch t / 2 pi at the angle t.

    Parameters
    ----------
    inner_radius : float [m], >= 0
    pitch : float [m], > 0
        Growth of the radius per turn.
    turns : float, > 0, at most 1000
    """

    digest_parts = ("spiral", "inner_radius", "pitch", "turns")
    n_axis = 2

    def __init__(self, inner_radius: float, pitch: float, turns: float) -> None:
        positive(pitch=pitch, turns=turns)
        self.pitch, self.turns, self.inner_radius = float(pitch), float(turns), float(inner_radius)
        if not (self.inner_radius >= 0.0 and math.isfinite(self.inner_radius)):
            raise GeometryError(f"inner_radius = {inner_radius!r}: must be >= 0 and finite")
        refuse(self.turns > 1000.0, GeometryError, f"turns = {turns!r}: must be at most 1000")
        self.first, self.last = 0.0, 2.0 * math.pi * self.turns
        self.n_joint = max(1, math.ceil(4.0 * self.turns)) + 1
        self.measure()

    def raw(self, u: Array, order: int) -> Array:
        growth = self.pitch / (2.0 * math.pi)
        rho, turn = (self.inner_radius + growth * u)[:, None], np.column_stack([np.cos(u), np.sin(u)])
        left = np.column_stack([-turn[:, 1], turn[:, 0]])
        rows = (
            rho * turn,
            growth * turn + rho * left,
            2.0 * growth * left - rho * turn,
            -3.0 * growth * turn - rho * left,
        )
        return np.array(rows[: order + 1])
