"""A path: curves in succession, by arc length; its corners, its foot points, its bounding box."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.arrays import Array, Flags, Index
from contourlab.errors import GeometryError
from contourlab.geometry.blend import Blends, by_length
from contourlab.geometry.curve import Curve, CurveSequence
from contourlab.geometry.foot_point import FootPoint, foot_point
from contourlab.geometry.line_and_arc import Arcs, Lines
from contourlab.geometry.table import PathTable, path_table
from contourlab.native.kernel import kernel

JOIN_TOLERANCE = 1e-9
"""Largest gap [m] between the end of a curve and the start of the next."""
CORNER_ANGLE = 1e-6
"""Smallest jump of the tangent [rad] that is a corner."""


class Path(CurveSequence):
    """Curves joined end to end, by arc length from 0 to `length`.

    Parameters
    ----------
    curves : sequence of Curve
        Each starts at the end of the one before, within 1 nm.
    closed : bool
        Whether the path returns to its start and repeats: arc length may then be any number.

    Raises
    ------
    GeometryError
        If there is no curve, dimensions differ, or there is a gap; the error names the place.

    >>> from contourlab.geometry.line_and_arc import Line
    >>> square = Path([Line((0, 0), (1, 0)), Line((1, 0), (1, 1))])
    >>> square.length, square.corners.tolist()
    (2.0, [1.0])
    """

    def __init__(self, curves: Sequence[Curve], closed: bool = False) -> None:
        super().__init__(curves, closed)
        gap = np.linalg.norm(self.ends[0][:-1] - self.starts[0][1:], axis=1)
        if gap.size and gap.max() > JOIN_TOLERANCE:
            i = int(np.argmax(gap > JOIN_TOLERANCE))
            raise GeometryError(f"curve {i + 2} starts {gap[i]:.3g} m away from the end of curve {i + 1}, at {self.ends[0][i].tolist()}")
        if self.closed and np.linalg.norm(self.ends[0][-1] - self.starts[0][0]) > JOIN_TOLERANCE:
            raise GeometryError("a closed path must end where it starts")

    @cached_property
    def _plain(self) -> tuple[NDArray[Any], ...]:
        """Kind of each curve (0 for a line, 1 for a blend, 2 for others), its number in the kind, and what defines lines and blends."""
        axes, kind = self.n_axis, np.full(len(self.curves), 2)
        lines, shape = [np.empty((axes, 0))] * 2, [np.empty((0, 6, axes)), np.empty((0, 5)), np.empty((0, 4, 0))]
        for batch, numbers in self.kinds:
            if isinstance(batch, Lines):
                kind[numbers], lines = 0, [batch.start, batch.direction]
            elif isinstance(batch, Blends):
                kind[numbers], shape = 1, list(batch.shape)
        return kind, self._slot, *lines, *shape

    def at(self, index: Index, along: Array, order: int) -> Array:
        """Evaluate curves at arc lengths along them, lines and blends in one pass.

        Parameters
        ----------
        index : ndarray (n,) of int
            Numbers of curves.
        along : ndarray (n,) [m]
            Arc lengths on them.
        order : int, 0 to 3

        Returns
        -------
        ndarray (order + 1, n, n_axis)
            Position and derivatives by arc length; a view of memory with each coordinate in one row.
        """
        if len(self._sets) == 1:
            return super().at(index, along, order)
        found, plain = np.empty((order + 1, self.n_axis, along.size)), self._plain
        _evaluate(np.ascontiguousarray(index, dtype=np.int64), np.ascontiguousarray(along, dtype=np.float64), order, *plain, found)
        others = np.flatnonzero(plain[0][index] == 2) if any(not isinstance(batch, Lines | Blends) for batch in self._sets) else ()
        if len(others):
            found[:, :, others] = super().at(index[others], along[others], order).transpose(0, 2, 1)
        return found.transpose(0, 2, 1)

    @cached_property
    def corners(self) -> Array:
        """Arc lengths (n,) [m] at which the tangent jumps, rising; on a closed path 0 is the closing point."""
        corners = self.breaks[1:-1][np.linalg.norm(self.ends[1][:-1] - self.starts[1][1:], axis=1) > CORNER_ANGLE]
        if self.closed and np.linalg.norm(self.ends[1][-1] - self.starts[1][0]) > CORNER_ANGLE:
            corners = np.concatenate([[0.0], corners])
        return np.asarray(corners)

    def coefficients(self, index: Index) -> tuple[Array, Flags]:
        """Return lines and arcs in a common form for the engine: position = base + d s + u cos(a + b s) + v sin(a + b s).

        Parameters
        ----------
        index : ndarray (n,) of int
            Numbers of curves.

        Returns
        -------
        ndarray (n, 2 + 4 n_axis)
            a, b; then base, d, u, v for each axis. Zero for other curves.
        ndarray (n,) of bool
            Whether the curve is a line or an arc.
        """
        table = np.zeros((index.size, 2 + 4 * self.n_axis))
        plain = np.zeros(index.size, dtype=bool)
        vectors = table[:, 2:].reshape(index.size, self.n_axis, 4)
        for batch, on, slot in self.kind_of(index):
            if isinstance(batch, Lines):
                vectors[on, :, :2] = np.stack([batch.start.T[slot], batch.direction.T[slot]], axis=2)
            elif isinstance(batch, Arcs):
                table[on, 0], table[on, 1] = batch.start_angle[slot], batch.rate[slot]
                radius, length = batch.radius[slot, None], batch.length[slot, None]
                columns = (batch.centre.T[slot], batch.rise.T[slot] / length, radius * batch.u.T[slot], radius * batch.v.T[slot])
                vectors[on] = np.stack(columns, axis=2)
            plain[on] = isinstance(batch, Lines | Arcs)
        return table, plain

    def tangent(self, s: ArrayLike) -> Array:
        """Return unit tangents (n, n_axis)."""
        return np.asarray(self.derivatives(s, 1)[1])

    def normal(self, s: ArrayLike) -> Array:
        """Return unit normals (n, n_axis): in the plane to the left, in space to the centre of curvature, 0 on straight parts."""
        _, first, second = self.derivatives(s, 2)
        if self.is_planar:
            return np.column_stack([-first[:, 1], first[:, 0]])
        size = np.linalg.norm(second, axis=1, keepdims=True)
        return np.asarray(np.divide(second, size, out=np.zeros_like(second), where=size > 0.0))

    def curvature(self, s: ArrayLike) -> Array:
        """Return curvatures (n,) [1/m]: signed in the plane, positive to the left; a magnitude in space."""
        _, first, second = self.derivatives(s, 2)
        if self.is_planar:
            return np.asarray(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])
        return np.asarray(np.linalg.norm(second, axis=1))

    def curvature_derivative(self, s: ArrayLike) -> Array:
        """Return the derivative of the curvature by arc length (n,) [1/m^2]; in space 0 where the path is straight."""
        _, first, second, third = self.derivatives(s, 3)
        if self.is_planar:
            return np.asarray(first[:, 0] * third[:, 1] - first[:, 1] * third[:, 0])
        size = np.linalg.norm(second, axis=1)
        return np.asarray(np.divide(np.einsum("ij,ij->i", second, third), size, out=np.zeros_like(size), where=size > 0.0))

    def foot_point(self, points: ArrayLike, around: ArrayLike, window: ArrayLike) -> FootPoint:
        """Return the points closest to `points` (n, n_axis) [m], within `window` (n,) [m] of the arc lengths `around` (n,) [m]."""
        return foot_point(self, points, around, window)

    def table(self, tolerance: float = 1e-10, *, pieces: int = 1) -> PathTable:
        """Return the path as quintic pieces for the engine; see `contourlab.geometry.table`."""
        return path_table(self, tolerance, pieces)

    @cached_property
    def digest(self) -> str:
        """A hash of the geometry: equal for equal curves, on any machine."""
        sha = hashlib.sha256(b"closed" if self.closed else b"open")
        for curve in self.curves:
            sha.update(curve.describe())
        return sha.hexdigest()


@kernel("i8[:] f8[:] i8 i8[:] i8[:] f8[:,:] f8[:,:] f8[:,:,:] f8[:,:] f8[:,:,:] f8[:,:,:]")
def _evaluate(index, along, order, kind, slot, start, direction, coefficients, borders, inverse, found):  # type: ignore[no-untyped-def]
    """Write position and derivatives by arc length of lines and blends to `found` (order + 1, n_axis, n)."""
    for i in range(index.size):
        k = slot[index[i]]
        if kind[index[i]] == 1:
            by_length(k, along[i], order, coefficients, borders, inverse, found, i)  # type: ignore[no-untyped-call]
        elif kind[index[i]] == 0:
            for j in range(direction.shape[0]):
                found[0, j, i] = start[j, k] + along[i] * direction[j, k]
                for power in range(1, order + 1):
                    found[power, j, i] = direction[j, k] if power == 1 else 0.0


_SAMPLES, _HALVINGS = 513, 45


def boxes(path: Path) -> tuple[Array, Array]:
    """Return the lowest and the highest coordinates of each curve of a path (n_curve, n_axis), (n_curve, n_axis) [m].

    Lines, arcs and helices have a closed form; bisection between samples finds the extremes of other curves.
    """
    low, high = np.minimum(path.starts[0], path.ends[0]), np.maximum(path.starts[0], path.ends[0])
    for batch, numbers in path.kinds:
        extremes = _arc_extremes if isinstance(batch, Arcs) else _turning_points
        for i in () if isinstance(batch, Lines) else numbers.tolist():
            points = extremes(path.curves[i])
            low[i], high[i] = np.minimum(low[i], points.min(axis=0)), np.maximum(high[i], points.max(axis=0))
    return low, high


def _arc_extremes(arc: Any) -> Array:
    """Return the points (n, n_axis) of an arc or helix where a coordinate may be extreme, ends included."""
    slope = arc.rise / arc.length / (arc.radius * arc.rate)
    # Each coordinate, radius (u cos + v sin) + pitch * angle, is extreme where v cos - u sin = -slope.
    size = np.hypot(arc.u, arc.v)
    with np.errstate(divide="ignore", invalid="ignore"):
        lean = np.arccos(np.clip(-slope / size, -1.0, 1.0))
    base = np.arctan2(-arc.u, arc.v)
    places = [0.0, arc.length]
    turn = 2.0 * np.pi * np.sign(arc.rate)
    for angle in np.concatenate([base + lean, base - lean])[np.tile(size > 0.0, 2)]:
        first = (angle - arc.start_angle) % turn
        # The first and last turns of a helix hold the extremes.
        last = first + turn * np.floor((arc.rate * arc.length - first) / turn)
        places += [value / arc.rate for value in (first, last)]
    return np.asarray(arc.position(np.array([s for s in places if 0.0 <= s <= arc.length])))


def _turning_points(curve: Curve) -> Array:
    """Return the points (n, n_axis) of a curve where a coordinate is extreme, ends included."""
    samples = np.linspace(0.0, curve.length, _SAMPLES)
    tangent = curve.derivatives(samples, 1)[1]
    points = [curve.position([0.0, curve.length])]
    for axis in range(curve.n_axis):
        t = tangent[:, axis]
        at = np.flatnonzero(np.sign(t[1:]) != np.sign(t[:-1]))
        low, high, rising = samples[at], samples[at + 1], t[at + 1] > t[at]
        for _ in range(_HALVINGS):
            middle = 0.5 * (low + high)
            above = (curve.derivatives(middle, 1)[1][:, axis] > 0.0) == rising
            low, high = np.where(above, low, middle), np.where(above, middle, high)
        points.append(curve.position(0.5 * (low + high)))
    return np.vstack(points)
