"""Straight lines."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Index
from contourlab.errors import GeometryError
from contourlab.geometry.curve import Curve, CurveBatch, of_each, rows, vector


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

    digest_parts = ("line", "start", "end")

    def __init__(self, start: ArrayLike, end: ArrayLike) -> None:
        self.start, self.end = vector(start, "start"), vector(end, "end")
        if self.start.shape != self.end.shape:
            raise GeometryError(f"start has {self.start.size} coordinates, end has {self.end.size}")
        self.n_axis = self.start.size
        self.length = float(np.linalg.norm(self.end - self.start))
        if not self.length > 0.0:
            raise GeometryError(f"line of zero length at {self.start.tolist()}")
        self.direction = (self.end - self.start) / self.length

    @classmethod
    def many(cls, start: ArrayLike, end: ArrayLike) -> list[Line]:
        """Return the lines between points (n, n_axis) [m]; much faster than one by one.

        Raises
        ------
        GeometryError
            If the two points of a line coincide, or a coordinate is not finite.
        """
        a, b = np.array(start, dtype=float), np.array(end, dtype=float)
        if a.ndim != 2 or a.shape != b.shape:
            raise GeometryError(f"start of shape {a.shape}, end of shape {b.shape}: both must be (n, n_axis)")
        length = np.sqrt(((b - a) ** 2).sum(axis=1))
        good = (length > 0.0) & np.isfinite(length)
        if not good.all():
            bad = int(np.argmin(good))
            return [cls(a[bad], b[bad])]  # raises with the reason
        direction = (b - a) / length[:, None]
        lines = []
        for row in zip(a, b, direction, length.tolist(), strict=True):
            line = cls.__new__(cls)
            line.start, line.end, line.direction, line.length = row
            line.n_axis = a.shape[1]
            lines.append(line)
        return lines

    @classmethod
    def batch(cls, curves: Sequence[Line]) -> Lines:
        return Lines(curves)

    def derivatives(self, s: ArrayLike, order: int = 3) -> Array:
        along = np.atleast_1d(np.asarray(s, dtype=float))
        result = np.zeros((order + 1, along.size, self.n_axis))
        result[0] = self.start + along[:, None] * self.direction
        result[1:2] = self.direction
        return result

    def smallest_radius(self) -> float:
        return float("inf")


class Lines(CurveBatch):
    """Many lines at once."""

    def __init__(self, curves: Sequence[Line]) -> None:
        super().__init__(curves)
        self.start, self.direction = rows(curves, "start"), rows(curves, "direction")
        self.sixth = np.zeros(len(curves))
        self.direct = np.ones(len(curves), dtype=bool)

    def derivatives(self, slot: Index, along: Array, order: int) -> Array:
        result = np.zeros((order + 1, self.n_axis, along.size))
        for j, (start, direction) in enumerate(zip(of_each(self.start, slot), of_each(self.direction, slot), strict=True)):
            result[0, j] = start + along * direction
            result[1:2, j] = direction
        return result

    def closest(self, slot: Index, points: Array, low: Array, high: Array, middle: Array) -> Array:
        start, direction = self.start.T[slot], self.direction.T[slot]
        return np.asarray(np.clip(np.einsum("ij,ij->i", points - start, direction), low, high))

    def smallest_radii(self) -> Array:
        return np.full(self.length.size, np.inf)
