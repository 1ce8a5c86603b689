"""Quintic curves by arc length that round the corners of a path, created and evaluated in bulk."""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Flags, Index
from contourlab.errors import GeometryError, refuse
from contourlab.geometry.curve import Curve, CurveBatch, Curves
from contourlab.native.kernel import kernel

ACCURACY = 1e-12
"""Largest error of an arc length, relative to the length of the blend; a less accurate blend is divided."""
DEPTH = 12
"""Most halvings of a blend; a blend that is still inaccurate has a cusp."""
# Each quarter of the parameter has its own series: several short series are more accurate than a long one.
_SPEED_TERMS, _TERMS = 20, 16
_GAUSS, _GAUSS_WEIGHTS = np.polynomial.legendre.leggauss(20)
_PROBES = np.array([-0.985, -0.91, -0.57, -0.23, 0.11, 0.42, 0.78, 0.96])
_STEP = 1e-8
"""Last Newton step of a place in its quarter, -1 to 1: what is left is about its square."""


def _chebyshev(n: int) -> tuple[Array, Array]:
    """Return the Chebyshev extreme points, ends included, and the matrix from values there to a Chebyshev series."""
    k = np.arange(n)
    angle = np.pi * k / (n - 1)
    matrix = (2.0 / (n - 1)) * np.cos(k[:, None] * angle)
    matrix[:, [0, -1]] *= 0.5
    matrix[[0, -1]] *= 0.5
    return np.cos(angle), matrix


def _to_arc(matrix: Array) -> Array:
    """Return the matrix from speeds to the series of the arc length, from that to the series of the speed."""
    # The integral of T_k is T_{k+1}/(2k + 2) - T_{k-1}/(2k - 2); the parameter runs over half the interval of x.
    padded, k = np.concatenate([2.0 * matrix[:1], matrix[1:], np.zeros((2, len(matrix)))]), np.arange(1, len(matrix) + 1)[:, None]
    arc = 0.25 * (padded[:-2] - padded[2:]) / k
    return np.concatenate([-(arc * np.where(k % 2, -1.0, 1.0)).sum(axis=0, keepdims=True), arc])


_SPEED_NODES, _SPEED_MATRIX = _chebyshev(_SPEED_TERMS)
_NODES, _MATRIX = _chebyshev(_TERMS)
_TO_ARC, _TO_INVERSE = _to_arc(_SPEED_MATRIX).T.copy(), _MATRIX.T.copy()


def quintic_bezier(points: ArrayLike) -> Array:
    """Return the coefficients (n, 6, n_axis) of powers of u, 0 to 1, of Bezier curves with control points (n, 6, n_axis) [m].

    Differences from the first point keep the digits of a small curve far from the origin.
    """
    difference = np.asarray(points, dtype=float)
    coefficients = np.empty_like(difference)
    for power in range(6):
        coefficients[:, power] = math.comb(5, power) * difference[:, 0]
        difference = np.diff(difference, axis=1)
    return coefficients


def shapes(coefficients: Array, u: Array) -> tuple[Array, Array]:
    """Evaluate quintics at parameters, without creating curves.

    Parameters
    ----------
    coefficients : ndarray (n, 6, n_axis) [m]
    u : ndarray (m,), 0 to 1

    Returns
    -------
    derivatives : ndarray (4, n, m, n_axis) [m, 1, 1/m, 1/m^2]
        By arc length.
    speed : ndarray (n, m) [m]
        |dr/du|.
    """
    n, m, n_axis = len(coefficients), u.size, coefficients.shape[2]
    found, speed = np.empty((4, n_axis, n * m)), np.empty((n, m))
    _shapes(np.ascontiguousarray(coefficients), u, found, speed)
    return found.transpose(0, 2, 1).reshape(4, n, m, n_axis), speed


def _speeds(c, x, speed):
    """Fill |dr/du| of a quintic c (6, n_axis) at the places x (m,), -1 to 1."""
    for i in range(x.size):
        speed[i] = 0.0
    for j in range(c.shape[1]):
        c1, c2, c3, c4, c5 = c[1, j], 2.0 * c[2, j], 3.0 * c[3, j], 4.0 * c[4, j], 5.0 * c[5, j]
        for i in range(x.size):
            u = 0.5 * (1.0 + x[i])
            first = c1 + u * (c2 + u * (c3 + u * (c4 + u * c5)))
            speed[i] += first * first
    for i in range(x.size):
        speed[i] = math.sqrt(speed[i])


def _product(columns, factors, found):
    """Fill the product of a matrix, given by its columns (m, n), with a vector."""
    for i in range(found.size):
        found[i] = 0.0
    for k in range(columns.shape[0]):
        for i in range(found.size):
            found[i] += columns[k, i] * factors[k]


def _clenshaw(terms, x, b1, b2, found):
    """Fill a Chebyshev series at places x (m,); b1 and b2 are working memory."""
    for i in range(x.size):
        b1[i], b2[i] = 0.0, 0.0
    for k in range(terms.size - 1, 0, -1):
        for i in range(x.size):
            b1[i], b2[i] = 2.0 * x[i] * b1[i] - b2[i] + terms[k], b1[i]
    for i in range(x.size):
        found[i] = x[i] * b1[i] - b2[i] + terms[0]


@kernel("f8[:,:,:] f8[:] f8[:] f8[:] f8[:] f8[:] f8[:,:] f8[:,:] f8[:,:] f8[:,:] f8[:,:] f8[:,:,:] f8[:,:,:] i8[:]")
def _invert(c, speed_nodes, gauss, weights, nodes, probes, to_arc, to_inverse, part, memory, borders, arc, inverse, good):
    """Measure and invert the quarters of quintics, for `_inverted`.

    The Chebyshev series of the speed is integrated term by term; Newton steps find the parameters of the Chebyshev points of arc length. A
    Gauss rule checks the length; points in between check the inverse.
    """
    speed, b1, b2, found, x, probed = memory[0], memory[1], memory[2], memory[3], memory[4, : nodes.size], memory[5, : probes.size]
    for n in range(c.shape[0]):
        good[n], borders[n, 0] = 1, 0.0
        for quarter in range(4):
            terms, back, check = arc[n, quarter], inverse[n, quarter], 0.0
            for j in range(c.shape[2]):
                scale = 1.0
                for k in range(6 if quarter == 0 else 0):
                    part[k, j], scale = scale * c[n, k, j], 0.25 * scale
                for shift in range(5 if quarter > 0 else 0):  # Taylor's, by one quarter
                    for k in range(4, shift - 1, -1):
                        part[k, j] += part[k + 1, j]
            _speeds(part, speed_nodes, speed)
            _product(to_arc, speed, terms)
            length = terms.sum()
            _speeds(part, gauss, speed)
            for k in range(gauss.size):
                check += 0.5 * weights[k] * speed[k]
            sound = 0.0 < length < math.inf and abs(check - length) <= 0.1 * ACCURACY * length
            for i in range(nodes.size):
                x[i] = nodes[i]
            for _ in range(7 if sound else 0):
                _clenshaw(terms, x, b1, b2, found)
                _speeds(part, x, speed)
                most = 0.0
                for i in range(1, nodes.size - 1):
                    step = (found[i] - 0.5 * (1.0 + nodes[i]) * length) / max(0.5 * speed[i], 1e-3 * length)
                    x[i], most = min(max(x[i] - step, -1.0), 1.0), max(most, abs(step))
                if most <= _STEP:
                    break
            _product(to_inverse, x, back)
            _clenshaw(back, probes, b1, b2, probed)
            for i in range(probes.size):
                probed[i] = min(max(probed[i], -1.0), 1.0)
            _clenshaw(terms, probed, b1, b2, found)
            for i in range(probes.size):
                sound = sound and abs(found[i] - 0.5 * (1.0 + probes[i]) * length) <= ACCURACY * length
            borders[n, quarter + 1] = borders[n, quarter] + length
            good[n] = good[n] if sound else 0


def halves(c: Array) -> Array:
    """Return the halves of quintics c (n, 6, n_axis), in order: (2 n, 6, n_axis)."""
    scale = 0.5 ** np.arange(6.0)
    # (1 + u)^k in powers of u.
    pascal = np.array([[math.comb(power, i) for power in range(6)] for i in range(6)], dtype=float)
    left = c * scale[:, None]
    return np.stack([left, np.einsum("ij,njk->nik", pascal, left)], axis=1).reshape(-1, *c.shape[1:])


def _inverted(c: Array) -> tuple[Array, Array, Array, Flags]:
    """Return of quintics c (n, 6, n_axis) the borders (n, 5) [m] of the quarters, the series (n, 4, terms) of arc length over the parameter
    and its inverse, and which are accurate.
    """
    borders, *series = (np.empty((len(c), *shape)) for shape in ((5,), (4, _SPEED_TERMS + 1), (4, _TERMS)))
    good, memory = np.empty(len(c), dtype=np.int64), (np.empty((6, c.shape[2])), np.empty((6, _SPEED_TERMS)))
    constants = _SPEED_NODES, _GAUSS, _GAUSS_WEIGHTS, _NODES, _PROBES, _TO_ARC, _TO_INVERSE
    _invert(np.ascontiguousarray(c), *constants, *memory, borders, *series, good)
    return borders, *series, good != 0


def series(terms: Array, quarter: int, x: float) -> float:
    """Return the Chebyshev series of a quarter at x."""
    b1, b2 = 0.0, 0.0  # Clenshaw's recursion
    for term in range(terms.shape[1] - 1, 0, -1):
        b1, b2 = 2.0 * x * b1 + (terms[quarter, term] - b2), b1
    return float(x * b1 - b2 + terms[quarter, 0])


def parameter(s: float, borders: Array, inverse: Array) -> float:
    """Return the parameter u of an arc length on one blend."""
    quarter = 3 if s >= borders[3] else 2 if s >= borders[2] else 1 if s >= borders[1] else 0
    low, high = borders[quarter], borders[quarter + 1]
    x = min(max((2.0 * s - low - high) / (high - low), -1.0), 1.0)
    return float(0.25 * (quarter + min(max(0.5 * (1.0 + series(inverse, quarter, x)), 0.0), 1.0)))


def by_length(k, s, order, coefficients, borders, inverse, found, i):
    """Write position and derivatives by arc length of blend `k` at the arc length s into column i of `found` (order + 1, n_axis, n)."""
    _by_parameter(k, parameter(s, borders[k], inverse[k]), order, coefficients, found, i)


def _by_parameter(k, u, order, coefficients, found, i):
    """Write as `by_length` at a parameter; return |dr/du|."""
    square, turn, change = 0.0, 0.0, 0.0  # products of the derivatives by u, for the chain rule
    axes = coefficients.shape[2]
    for j in range(axes):
        c2, c3, c4, c5 = coefficients[k, 2, j], coefficients[k, 3, j], coefficients[k, 4, j], coefficients[k, 5, j]
        first = coefficients[k, 1, j] + u * (2.0 * c2 + u * (3.0 * c3 + u * (4.0 * c4 + u * (5.0 * c5))))
        second = 2.0 * c2 + u * (6.0 * c3 + u * (12.0 * c4 + u * (20.0 * c5)))
        third = 6.0 * c3 + u * (24.0 * c4 + u * (60.0 * c5))
        found[0, j, i] = coefficients[k, 0, j] + u * (coefficients[k, 1, j] + u * (c2 + u * (c3 + u * (c4 + u * c5))))
        square, turn, change = square + first * first, turn + first * second, change + second * second + first * third
        if order > 0:
            found[1, j, i] = first
        if order > 1:
            found[2, j, i] = second
        if order > 2:
            found[3, j, i] = third
    p = 1.0 / math.sqrt(square)  # du/ds
    q = -turn / (square * square)  # d2u/ds2
    w = (4.0 * turn * turn / (square * square * square) - change / (square * square)) * p  # d3u/ds3
    for j in range(axes if order > 0 else 0):
        first = found[1, j, i]
        found[1, j, i] = first * p
        if order > 1:
            second = found[2, j, i]
            found[2, j, i] = second * (p * p) + first * q
            if order > 2:
                found[3, j, i] = found[3, j, i] * (p * p * p) + 3.0 * second * p * q + first * w
    return math.sqrt(square)


@kernel("f8[:,:,:] f8[:] f8[:,:,:] f8[:,:]")
def _shapes(coefficients, u, found, speed):
    """Evaluate for `shapes`."""
    for k in range(coefficients.shape[0]):
        for m in range(u.size):
            speed[k, m] = _by_parameter(k, u[m], 3, coefficients, found, k * u.size + m)


@kernel("i8[:] f8[:] i8 f8[:,:,:] f8[:,:] f8[:,:,:] f8[:,:,:]")
def evaluate(slot, along, order, coefficients, borders, inverse, found):
    """Evaluate blends `slot` (n,) at arc lengths `along` (n,): derivatives by arc length into `found` (order + 1, n_axis, n)."""
    for i in range(slot.size):
        by_length(slot[i], along[i], order, coefficients, borders, inverse, found, i)


class Blends(CurveBatch):
    """Many blends at once."""

    columns, axis = ("coefficients", "borders", "inverse"), 0

    def __init__(self, curves: Sequence[Blend]) -> None:
        self._fill(*(np.array([getattr(curve, name) for curve in curves]) for name in self.columns))

    def _fill(self, *arrays: Any) -> None:
        self.coefficients, self.borders, self.inverse = self.shape = arrays
        self.n_axis, self.length = self.coefficients.shape[2], self.borders[:, -1]

    def curve(self, slot: int) -> Blend:
        blend = Blend.__new__(Blend)
        blend._fill(self.coefficients[slot], self.borders[slot], self.inverse[slot], float(self.length[slot]))
        return blend

    @cached_property
    def arc(self) -> Array:
        """Series (n, 4, terms) of the arc length over the parameter, for the search of foot points only."""
        return _inverted(self.shape[0])[1]

    def derivatives(self, slot: Index, along: Array, order: int) -> Array:
        found = np.empty((order + 1, self.n_axis, along.size))
        evaluate(np.ascontiguousarray(slot), np.ascontiguousarray(along), order, *self.shape, found)
        return found

    def smallest_radii(self) -> Array:
        bend = np.zeros(self.length.size)
        for u in np.linspace(0.0, 1.0, 65):
            bend = np.maximum(bend, np.linalg.norm(shapes(self.coefficients, np.array([u]))[0][2, :, 0], axis=1))
        return np.asarray(np.divide(1.0, bend, out=np.full(bend.size, np.inf), where=bend > 0.0))


class Blend(Curve):
    """A quintic curve r(u) = sum of c_k u^k, u from 0 to 1, by arc length.

    Parameters
    ----------
    coefficients : array_like (6, n_axis) [m]
        Of the powers of u.

    Raises
    ------
    GeometryError
        If it has no length, or its speed is so uneven that u over arc length is not accurate to 1e-12; `blends` divides such curves.

    Notes
    -----
    u over arc length is a Chebyshev series of 16 terms on each quarter of u.

    >>> straight = Blend(quintic_bezier([[(0, 0), (1, 0), (2, 0), (3, 0), (4, 0), (5, 0)]])[0])
    >>> round(straight.length, 12)
    5.0
    """

    digest_parts = ("blend", "coefficients")
    _batch = Blends

    def __init__(self, coefficients: ArrayLike) -> None:
        c = np.array(coefficients, dtype=float)
        if c.ndim != 2 or c.shape[0] != 6 or c.shape[1] < 1 or not np.isfinite(c).all():
            raise GeometryError(f"coefficients of shape {c.shape}: must be finite, (6, n_axis)")
        borders, _, inverse, good = _inverted(c[None])
        refuse(not good[0], GeometryError, "a blend without length, or too uneven for its series: use blends(), which divides it")
        self._fill(c, borders[0], inverse[0], float(borders[0, -1]))

    def _fill(self, coefficients: Array, borders: Array, inverse: Array, length: float) -> None:
        self.coefficients, self.borders, self.inverse, self.length = coefficients, borders, inverse, length
        self.n_axis = coefficients.shape[1]


def blends(coefficients: ArrayLike) -> tuple[Sequence[Any], Index]:
    """Create blends from many quintic curves at once.

    Parameters
    ----------
    coefficients : array_like (n, 6, n_axis) [m]
        Of the powers of u, 0 to 1; see `quintic_bezier`.

    Returns
    -------
    sequence of Blend
        In order. A curve too uneven for its series is halved until each part is accurate to 1e-12 of its length.
    ndarray of int
        Number of the curve that each blend belongs to.

    Raises
    ------
    GeometryError
        If a curve has no length, a cusp, or a non-finite coordinate; the error names the curve.
    """
    c = np.array(coefficients, dtype=float)
    refuse(c.ndim != 3 or c.shape[1] != 6 or c.shape[2] < 1, GeometryError, f"coefficients of shape {c.shape}: must be (n, 6, n_axis)")
    usable = np.isfinite(c).all(axis=(1, 2)) & (c[:, 1:] != 0.0).any(axis=(1, 2))
    if not usable.all():
        raise GeometryError(f"blend {int(np.argmin(usable))} has no length, or coordinates that are not finite")
    owner, begin = np.arange(len(c), dtype=np.int64), np.zeros(len(c))
    made: list[tuple[Index, Array, Array, Array, Array]] = []
    for depth in range(DEPTH + 1):
        if not len(c):
            break
        borders, _, inverse, good = _inverted(c)
        made.append((owner[good], begin[good], c[good], borders[good], inverse[good]))
        c, owner, begin = halves(c[~good]), np.repeat(owner[~good], 2), np.repeat(begin[~good], 2)
        begin[1::2] += 0.5 ** (depth + 1)
    if len(c):
        raise GeometryError(f"blend {int(owner[0])} has a cusp, where arc length is undefined")
    if not made:
        return [], owner
    owner, begin, c, borders, inverse = (np.concatenate(column) for column in zip(*made, strict=True))
    order = np.lexsort([begin, owner])
    return Curves([(Blends.made(c[order], borders[order], inverse[order]), np.arange(order.size))]), owner[order]
