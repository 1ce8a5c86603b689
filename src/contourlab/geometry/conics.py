"""Curves in closed form: ellipse, elliptical arc, lemniscate, Lissajous figure, spiral, star."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array
from contourlab.errors import GeometryError
from contourlab.geometry.curve import positive, vector
from contourlab.geometry.parametric import Parametric


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
        if not math.isfinite(self.phase):
            raise GeometryError(f"phase = {phase!r} rad: must be finite")
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
        if self.turns > 1000.0:
            raise GeometryError(f"turns = {turns!r}: must be at most 1000")
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
