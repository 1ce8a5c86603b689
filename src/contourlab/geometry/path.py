"""A path: curves one after another, by arc length."""

from __future__ import annotations

import hashlib
import struct
from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import GeometryError
from contourlab.geometry.arc import Arc
from contourlab.geometry.curve import Curve
from contourlab.geometry.line import Line

if TYPE_CHECKING:
    from contourlab.geometry.foot import FootPoint
    from contourlab.geometry.table import PathTable

__all__ = ["CORNER_ANGLE", "JOIN_TOLERANCE", "Path"]

Array = NDArray[np.float64]
JOIN_TOLERANCE = 1e-9
"""Largest gap [m] between the end of a curve and the start of the next."""
CORNER_ANGLE = 1e-6
"""Smallest jump of the tangent [rad] that is a corner."""


class Path:
    """Curves joined end to end, by arc length from 0 to `length`.

    Parameters
    ----------
    curves : sequence of Curve
        Each begins where the one before ends, within 1 nm.
    closed : bool
        Whether the path returns to its start and goes on in laps: arc length may then be any number.

    Raises
    ------
    GeometryError
        If there is no curve, dimensions differ, or there is a gap; the message names the place.

    Notes
    -----
    Lines and arcs are held in arrays, so that evaluating n samples over m of them costs n + m.

    >>> square = Path([Line((0, 0), (1, 0)), Line((1, 0), (1, 1))])
    >>> square.length, square.corners.tolist()
    (2.0, [1.0])
    """

    def __init__(self, curves: Sequence[Curve], closed: bool = False) -> None:
        self.curves = tuple(curves)
        if not self.curves:
            raise GeometryError("a path of no curves")
        self.n_axis = self.curves[0].n_axis
        self.closed = closed
        if any(curve.n_axis != self.n_axis for curve in self.curves):
            raise GeometryError("the curves of a path must all have the same number of coordinates")
        self.breaks = np.concatenate([[0.0], np.cumsum([curve.length for curve in self.curves])])
        self.length = float(self.breaks[-1])
        self._gather()
        self._ends = self._at(np.arange(len(self.curves)), np.array([c.length for c in self.curves]), 1)
        self._starts = self._at(np.arange(len(self.curves)), np.zeros(len(self.curves)), 1)
        self._check_joints()

    @property
    def is_planar(self) -> bool:
        """Whether the path has two coordinates, so that its errors have a side."""
        return self.n_axis == 2

    def _gather(self) -> None:
        kinds = np.array([0 if type(c) is Line else 1 if type(c) is Arc else 2 for c in self.curves])
        self._kind = kinds
        self._kinds = np.unique(kinds).tolist()
        self._slot = np.zeros(len(kinds), dtype=np.int64)
        for kind in (0, 1, 2):
            self._slot[kinds == kind] = np.arange(np.count_nonzero(kinds == kind))
        lines: list[Any] = [c for c in self.curves if type(c) is Line]
        arcs: list[Any] = [c for c in self.curves if type(c) is Arc]
        self._others = [c for c in self.curves if type(c) not in (Line, Arc)]

        def rows(curves: list[Any], name: str) -> Array:
            # Coordinates first, so that each is one contiguous row: evaluation is then a few passes over plain arrays.
            return np.array([getattr(c, name) for c in curves]).reshape(len(curves), self.n_axis).T

        self._line = {name: rows(lines, name) for name in ("start", "direction")}
        self._arc = {name: rows(arcs, name) for name in ("centre", "u", "v", "rise")}
        self._arc |= {name: np.array([getattr(c, name) for c in arcs]) for name in ("radius", "start_angle", "rate", "length")}

    def _check_joints(self) -> None:
        gap = np.linalg.norm(self._ends[0][:-1] - self._starts[0][1:], axis=1)
        if gap.size and gap.max() > JOIN_TOLERANCE:
            i = int(np.argmax(gap > JOIN_TOLERANCE))
            raise GeometryError(f"curve {i + 2} begins {gap[i]:.3g} m away from the end of curve {i + 1}, at {self._ends[0][i].tolist()}")
        if self.closed and np.linalg.norm(self._ends[0][-1] - self._starts[0][0]) > JOIN_TOLERANCE:
            raise GeometryError("a closed path must end where it begins")

    @cached_property
    def corners(self) -> Array:
        """Arc lengths at which the tangent jumps, rising; on a closed path 0 stands for the closing point."""
        turn = np.linalg.norm(self._ends[1][:-1] - self._starts[1][1:], axis=1)
        found = self.breaks[1:-1][turn > CORNER_ANGLE]
        if self.closed and np.linalg.norm(self._ends[1][-1] - self._starts[1][0]) > CORNER_ANGLE:
            found = np.concatenate([[0.0], found])
        return np.asarray(found)

    def local(self, s: ArrayLike) -> tuple[NDArray[np.int64], Array]:
        """Return, for arc lengths (n,), the curve each lies on and the arc length along that curve."""
        along = np.atleast_1d(np.asarray(s, dtype=float))
        along = along - self.length * np.floor(along / self.length) if self.closed else np.clip(along, 0.0, self.length)
        index = np.clip(np.searchsorted(self.breaks, along, side="right") - 1, 0, len(self.curves) - 1)
        return index, along - self.breaks[index]

    def curve_index(self, s: ArrayLike) -> NDArray[np.int64]:
        """Return on which curve each arc length (n,) lies; a joint belongs to the curve that begins there."""
        return self.local(s)[0]

    def derivatives(self, s: ArrayLike, order: int = 3) -> Array:
        """Return position and derivatives by arc length: ndarray (order + 1, n, n_axis), order 0 to 3.

        On a closed path `s` wraps around; on an open one it is held to the ends.
        """
        index, along = self.local(s)
        return self._at(index, along, order)

    def _at(self, index: NDArray[np.int64], along: Array, order: int) -> Array:
        """Evaluate at places `along` the curves `index`: a view (order + 1, n, n_axis) of memory that holds each coordinate in one row."""
        evaluate = (self._on_lines, self._on_arcs, self._on_others)
        if len(self._kinds) == 1:
            return evaluate[self._kinds[0]](self._slot[index], along, order).transpose(0, 2, 1)
        found = np.zeros((order + 1, self.n_axis, along.size))
        kind, slot = self._kind[index], self._slot[index]
        for k in self._kinds:
            on = np.flatnonzero(kind == k)
            if on.size:
                found[:, :, on] = evaluate[k](slot[on], along[on], order)
        return found.transpose(0, 2, 1)

    def _on_lines(self, slot: NDArray[np.int64], along: Array, order: int) -> Array:
        found = np.zeros((order + 1, self.n_axis, along.size))
        for j, (start, direction) in enumerate(zip(*_of_each(self._line, slot, "start", "direction"), strict=True)):
            found[0, j] = start + along * direction
            if order:
                found[1, j] = direction
        return found

    def _on_arcs(self, slot: NDArray[np.int64], along: Array, order: int) -> Array:
        radius, angle, rate, length = _of_each(self._arc, slot, "radius", "start_angle", "rate", "length")
        angle = angle + rate * along
        c, d = radius * np.cos(angle), radius * np.sin(angle)
        found = np.empty((order + 1, self.n_axis, along.size))
        for j, (centre, u, v, rise) in enumerate(zip(*_of_each(self._arc, slot, "centre", "u", "v", "rise"), strict=True)):
            spoke = c * u + d * v
            found[0, j] = spoke + (centre + along / length * rise)
            if order:
                swing = rate * (c * v - d * u)
                found[1, j] = swing + rise / length
            if order > 1:
                found[2, j] = -(rate**2) * spoke
            if order > 2:
                found[3, j] = -(rate**2) * swing
        return found

    def _on_others(self, slot: NDArray[np.int64], along: Array, order: int) -> Array:
        found = np.empty((order + 1, self.n_axis, along.size))
        for i in np.unique(slot):
            mine = slot == i
            found[:, :, mine] = self._others[i].derivatives(along[mine], order).transpose(0, 2, 1)
        return found

    def coefficients(self, index: NDArray[np.int64]) -> tuple[Array, NDArray[np.bool_]]:
        """Return what lines and arcs have in common, for the engine: position = base + d s + u cos(a + b s) + v sin(a + b s).

        Parameters
        ----------
        index : ndarray (n,) of int
            Curves.

        Returns
        -------
        ndarray (n, 2 + 4 n_axis)
            a, b; then base, d, u, v for each axis. Zero for other curves.
        ndarray (n,) of bool
            Whether the curve is a line or an arc.
        """
        found = np.zeros((index.size, 2 + 4 * self.n_axis))
        kind, slot = self._kind[index], self._slot[index]
        parts = found[:, 2:].reshape(index.size, self.n_axis, 4)
        on = np.flatnonzero(kind == 0)
        parts[on, :, 0], parts[on, :, 1] = self._line["start"].T[slot[on]], self._line["direction"].T[slot[on]]
        on = np.flatnonzero(kind == 1)
        arc = {name: values.T[slot[on]] for name, values in self._arc.items()}
        found[on, 0], found[on, 1] = arc["start_angle"], arc["rate"]
        columns = (
            arc["centre"],
            arc["rise"] / arc["length"][:, None],
            arc["radius"][:, None] * arc["u"],
            arc["radius"][:, None] * arc["v"],
        )
        for i, column in enumerate(columns):
            parts[on, :, i] = column
        return found, kind < 2

    def position(self, s: ArrayLike) -> Array:
        """Return positions (n, n_axis) [m]."""
        return np.asarray(self.derivatives(s, 0)[0])

    def tangent(self, s: ArrayLike) -> Array:
        """Return unit tangents (n, n_axis)."""
        return np.asarray(self.derivatives(s, 1)[1])

    def normal(self, s: ArrayLike) -> Array:
        """Return unit normals (n, n_axis): to the left in the plane.

        In space they point to the centre of curvature, and are zero where the path is straight.
        """
        found = self.derivatives(s, 2)
        if self.is_planar:
            return np.column_stack([-found[1, :, 1], found[1, :, 0]])
        size = np.linalg.norm(found[2], axis=1, keepdims=True)
        return np.asarray(np.divide(found[2], size, out=np.zeros_like(found[2]), where=size > 0.0))

    def curvature(self, s: ArrayLike) -> Array:
        """Return curvatures (n,) [1/m]: signed in the plane, positive to the left; a magnitude in space."""
        _, first, second = self.derivatives(s, 2)
        if self.is_planar:
            return np.asarray(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])
        return np.asarray(np.linalg.norm(second, axis=1))

    def curvature_derivative(self, s: ArrayLike) -> Array:
        """Return the change of curvature by arc length (n,) [1/m^2], 0 in space where the path is straight."""
        _, first, second, third = self.derivatives(s, 3)
        if self.is_planar:
            return np.asarray(first[:, 0] * third[:, 1] - first[:, 1] * third[:, 0])
        size = np.linalg.norm(second, axis=1)
        return np.asarray(np.divide(np.einsum("ij,ij->i", second, third), size, out=np.zeros_like(size), where=size > 0.0))

    def foot_point(self, points: ArrayLike, around: ArrayLike, window: float) -> FootPoint:
        """Return the closest points of the path; see `contourlab.geometry.foot`."""
        from contourlab.geometry.foot import foot_point

        return foot_point(self, points, around, window)

    def table(self, tolerance: float = 1e-10, *, pieces: int = 1) -> PathTable:
        """Return the path as quintic pieces for the engine; see `contourlab.geometry.table`."""
        from contourlab.geometry.table import path_table

        return path_table(self, tolerance, pieces)

    @cached_property
    def digest(self) -> str:
        """A hash of the geometry: equal for equal curves, on any machine."""
        sha = hashlib.sha256(b"closed" if self.closed else b"open")
        for curve in self.curves:
            for item in curve.describe():
                sha.update(struct.pack("<d", item) if isinstance(item, float | int) else str(item).encode())
        return sha.hexdigest()


def _of_each(curves: dict[str, Array], slot: NDArray[np.int64], *names: str) -> list[Array]:
    """Return numbers of the curves in `slot`; those of a single curve are broadcast, not gathered: circles are evaluated often."""
    return [values if values.shape[-1] == 1 else values[..., slot] for values in (curves[name] for name in names)]
