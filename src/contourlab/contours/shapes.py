"""What drawings are made of, before it becomes curves: any affine map of a shape is a shape of the same kind."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from contourlab.contours.splines import spline_curves
from contourlab.geometry import Arc, Curve, EllipticalArc, Line

Array = NDArray[np.float64]
ROUND = 1e-12
"""Half-diameters that differ by less than this part of themselves are those of a circle."""


@dataclass(frozen=True, eq=False)
class LineShape:
    """From one point to another, each (n_axis,)."""

    start: Array
    end: Array

    def mapped(self, matrix: Array, offset: Array) -> LineShape:
        """Return the image under p -> matrix p + offset; a matrix (2, 3) projects."""
        return LineShape(matrix @ self.start + offset, matrix @ self.end + offset)

    def extent(self) -> tuple[Array, Array]:
        """Return lower and upper bounds of the coordinates."""
        return np.minimum(self.start, self.end), np.maximum(self.start, self.end)

    def curves(self) -> list[Curve]:
        """Return the curves, end to end."""
        return [Line(self.start, self.end)]


@dataclass(frozen=True, eq=False)
class ConicShape:
    """c + p cos t + q sin t, t from `start` to `end`, which may fall."""

    centre: Array
    p: Array
    q: Array
    start: float
    end: float

    def mapped(self, matrix: Array, offset: Array) -> ConicShape:
        """Return the image under p -> matrix p + offset."""
        return replace(self, centre=matrix @ self.centre + offset, p=matrix @ self.p, q=matrix @ self.q)

    def extent(self) -> tuple[Array, Array]:
        """Return bounds of the coordinates, those of the full ellipse."""
        reach = np.hypot(self.p, self.q)
        return self.centre - reach, self.centre + reach

    def curves(self) -> list[Curve]:
        """Return the curve: an arc where the shape is circular."""
        a, b = float(np.linalg.norm(self.p)), float(np.linalg.norm(self.q))
        if abs(a - b) <= ROUND * a and abs(float(self.p @ self.q)) <= ROUND * a * b:
            return [self._arc(0.5 * (a + b))]
        if self.end > self.start:
            return [EllipticalArc(self.centre, self.p, self.q, self.start, self.end)]
        return [EllipticalArc(self.centre, self.p, -self.q, -self.start, -self.end)]

    def _arc(self, radius: float) -> Arc:
        sweep = self.end - self.start
        if self.centre.size == 2:  # in the axes of the plane, as everyone writes it
            spoke = self.p * math.cos(self.start) + self.q * math.sin(self.start)
            sense = math.copysign(1.0, self.p[0] * self.q[1] - self.p[1] * self.q[0])
            return Arc(self.centre, radius, math.atan2(spoke[1], spoke[0]), sense * sweep)
        return Arc(self.centre, radius, self.start, sweep, self.p / radius, self.q / radius)


@dataclass(frozen=True, eq=False)
class SplineShape:
    """A B-spline: control points (n, n_axis), knots (n + degree + 1,), and weights (n,) where it is rational."""

    degree: int
    points: Array
    knots: Array
    weights: Array | None = None

    @classmethod
    def bezier(cls, *points: Array) -> SplineShape:
        """Return a Bezier curve of two control points or more."""
        n = len(points)
        return cls(n - 1, np.array(points), np.repeat([0.0, 1.0], n))

    def mapped(self, matrix: Array, offset: Array) -> SplineShape:
        """Return the image under p -> matrix p + offset."""
        return replace(self, points=self.points @ matrix.T + offset)

    def extent(self) -> tuple[Array, Array]:
        """Return bounds of the coordinates, those of the control points."""
        return self.points.min(axis=0), self.points.max(axis=0)

    def curves(self) -> list[Curve]:
        """Return the curves, end to end: the spline is cut where it has corners."""
        return spline_curves(self.degree, self.points, self.knots, self.weights)


Shape: TypeAlias = LineShape | ConicShape | SplineShape
