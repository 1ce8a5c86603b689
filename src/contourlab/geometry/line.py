"""Straight lines."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import GeometryError
from contourlab.geometry.curve import Curve, vector

__all__ = ["Line"]


class Line(Curve):
    """The straight line between two points.

    Parameters
    ----------
    start, end : array_like (n_axis,) [m]

    Raises
    ------
    GeometryError
        If they coincide, or a coordinate is not finite.

    >>> Line((0, 0), (3, 4)).length
    5.0
    """

    def __init__(self, start: ArrayLike, end: ArrayLike) -> None:
        self.start, self.end = vector(start, "start"), vector(end, "end")
        if self.start.shape != self.end.shape:
            raise GeometryError(f"start has {self.start.size} coordinates, end has {self.end.size}")
        self.n_axis = self.start.size
        self.length = float(np.linalg.norm(self.end - self.start))
        if not self.length > 0.0:
            raise GeometryError(f"line of zero length at {self.start.tolist()}")
        self.direction = (self.end - self.start) / self.length

    def derivatives(self, s: ArrayLike, order: int = 3) -> NDArray[np.float64]:
        along = np.atleast_1d(np.asarray(s, dtype=float))
        found = np.zeros((order + 1, along.size, self.n_axis))
        found[0] = self.start + along[:, None] * self.direction
        if order > 0:
            found[1] = self.direction
        return found

    def smallest_radius(self) -> float:
        return float("inf")

    def describe(self) -> tuple[object, ...]:
        return ("line", *self.start.tolist(), *self.end.tolist())
