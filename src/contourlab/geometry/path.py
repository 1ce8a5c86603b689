"""A path: curves one after another, by arc length."""

from __future__ import annotations

import hashlib
import struct
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import GeometryError
from contourlab.geometry.arc import Arcs
from contourlab.geometry.curve import Curve, Together
from contourlab.geometry.line import Lines

if TYPE_CHECKING:
    from contourlab.geometry.foot import FootPoint
    from contourlab.geometry.table import PathTable

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
    Curves of one kind are held together (`Curve.together`), so that evaluating n samples over m of them costs n + m.

    >>> from contourlab.geometry.line import Line
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
        """Put the curves of each kind together: a curve is then a kind and a slot."""
        kinds: dict[type[Curve], list[int]] = {}
        for i, curve in enumerate(self.curves):
            kinds.setdefault(type(curve), []).append(i)
        self._kind = np.zeros(len(self.curves), dtype=np.int64)
        self._slot = np.zeros(len(self.curves), dtype=np.int64)
        self._sets: list[Together] = []
        for number, (kind, members) in enumerate(kinds.items()):
            self._kind[members], self._slot[members] = number, np.arange(len(members))
            self._sets.append(kind.together([self.curves[i] for i in members]))

    @property
    def kinds(self) -> list[tuple[Together, NDArray[np.int64]]]:
        """The curves by kind: what evaluates them at once, and their numbers along the path in its order."""
        return [(each, np.flatnonzero(self._kind == k)) for k, each in enumerate(self._sets)]

    def kind_of(self, curve: NDArray[np.int64]) -> Iterator[tuple[Together, NDArray[np.int64], NDArray[np.int64]]]:
        """Yield, for numbers of curves (n,), by kind: what evaluates them, which of the n are meant, and their slots."""
        if len(self._sets) == 1:
            yield self._sets[0], np.arange(curve.size), self._slot[curve]
            return
        kind, slot = self._kind[curve], self._slot[curve]
        for k, each in enumerate(self._sets):
            on = np.flatnonzero(kind == k)
            if on.size:
                yield each, on, slot[on]

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
        if len(self._sets) == 1:
            return self._sets[0].derivatives(self._slot[index], along, order).transpose(0, 2, 1)
        found = np.empty((order + 1, self.n_axis, along.size))
        for each, on, slot in self.kind_of(index):
            found[:, :, on] = each.derivatives(slot, along[on], order)
        return found.transpose(0, 2, 1)

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
        plain = np.zeros(index.size, dtype=bool)
        parts = found[:, 2:].reshape(index.size, self.n_axis, 4)
        for each, on, slot in self.kind_of(index):
            if isinstance(each, Lines):
                parts[on, :, 0], parts[on, :, 1] = each.start.T[slot], each.direction.T[slot]
            elif isinstance(each, Arcs):
                found[on, 0], found[on, 1] = each.start_angle[slot], each.rate[slot]
                radius, length = each.radius[slot, None], each.length[slot, None]
                columns = (each.centre.T[slot], each.rise.T[slot] / length, radius * each.u.T[slot], radius * each.v.T[slot])
                for i, column in enumerate(columns):
                    parts[on, :, i] = column
            else:
                continue
            plain[on] = True
        return found, plain

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

    def foot_point(self, points: ArrayLike, around: ArrayLike, window: ArrayLike) -> FootPoint:
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
            sha.update(
                b"".join(struct.pack("<d", item) if isinstance(item, float | int) else str(item).encode() for item in curve.describe())
            )
        return sha.hexdigest()
