"""Curves in closed form: ellipse, lemniscate, star."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import GeometryError
from contourlab.geometry.parametric import Parametric

__all__ = ["Ellipse", "Lemniscate", "Star"]

Array = NDArray[np.float64]


def _positive(name: str, value: float) -> float:
    if not (value > 0.0 and math.isfinite(value)):
        raise GeometryError(f"{name} = {value!r}: must be > 0 and finite")
    return float(value)


class Ellipse(Parametric):
    """x = a cos u, y = b sin u, once round, counter-clockwise from (a, 0).

    Parameters
    ----------
    a, b : float [m], > 0
        Semi-axes.
    """

    n_axis = 2

    def __init__(self, a: float, b: float) -> None:
        self.a, self.b = _positive("a", a), _positive("b", b)
        self.first, self.last = 0.0, 2.0 * math.pi
        self.measure()

    def joints(self) -> Array:
        return np.linspace(self.first, self.last, 9)

    def raw(self, u: Array, order: int) -> Array:
        c, s = np.cos(u), np.sin(u)
        turns = [(c, s), (-s, c), (-c, -s), (s, -c)]
        return np.array([np.column_stack([self.a * x, self.b * y]) for x, y in turns[: order + 1]])

    def describe(self) -> tuple[object, ...]:
        return ("ellipse", self.a, self.b)


class Lemniscate(Parametric):
    """x = a sin u, y = a sin u cos u: a figure of eight that crosses itself at the origin, where it starts.

    Parameters
    ----------
    a : float [m], > 0
        Half its width.
    """

    n_axis = 2

    def __init__(self, a: float) -> None:
        self.a = _positive("a", a)
        self.first, self.last = 0.0, 2.0 * math.pi
        self.measure()

    def joints(self) -> Array:
        return np.linspace(self.first, self.last, 9)

    def raw(self, u: Array, order: int) -> Array:
        c, s, c2, s2 = np.cos(u), np.sin(u), np.cos(2.0 * u), np.sin(2.0 * u)
        rows = [(s, 0.5 * s2), (c, c2), (-s, -2.0 * s2), (-c, -4.0 * c2)]
        return np.array([self.a * np.column_stack(row) for row in rows[: order + 1]])

    def describe(self) -> tuple[object, ...]:
        return ("lemniscate", self.a)


class Star(Parametric):
    """A star with rounded lobes: radius R (1 + depth cos n u) at angle u.

    Parameters
    ----------
    radius : float [m], > 0
    lobes : int, >= 2
    depth : float, 0 to 1 exclusive
    """

    n_axis = 2

    def __init__(self, radius: float, lobes: float, depth: float) -> None:
        self.radius, self.depth = _positive("radius", radius), float(depth)
        if not float(lobes).is_integer() or lobes < 2 or not 0.0 <= self.depth < 1.0:
            raise GeometryError(
                f"star of {lobes} lobes, depth {depth}: a whole number >= 2 of lobes and a depth from 0 to below 1 are wanted"
            )
        self.lobes = int(lobes)
        self.first, self.last = 0.0, 2.0 * math.pi
        self.measure()

    def joints(self) -> Array:
        return np.linspace(self.first, self.last, 4 * self.lobes + 1)

    def raw(self, u: Array, order: int) -> Array:
        n, k = self.lobes, self.depth
        c, s = np.cos(n * u), np.sin(n * u)
        rho = self.radius * np.array([1.0 + k * c, -k * n * s, -k * n**2 * c, k * n**3 * s])
        turn = [(np.cos(u), np.sin(u)), (-np.sin(u), np.cos(u)), (-np.cos(u), -np.sin(u)), (np.sin(u), -np.cos(u))]
        binomial = [[1.0], [1.0, 1.0], [1.0, 2.0, 1.0], [1.0, 3.0, 3.0, 1.0]]
        rows = []
        for m in range(order + 1):
            # Leibniz: the m-th derivative of rho times (cos, sin).
            rows.append(sum(binomial[m][j] * rho[m - j][:, None] * np.column_stack(turn[j]) for j in range(m + 1)))
        return np.array(rows)

    def describe(self) -> tuple[object, ...]:
        return ("star", self.radius, self.lobes, self.depth)
