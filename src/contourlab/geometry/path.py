"""A path: curves one after another, by arc length."""

from __future__ import annotations

import hashlib
import struct
from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import GeometryError
from contourlab.geometry.arc import Arcs
from contourlab.geometry.curve import Array, Curve, Index
from contourlab.geometry.curve_sequence import CurveSequence
from contourlab.geometry.foot_point import FootPoint, foot_point
from contourlab.geometry.line import Lines
from contourlab.geometry.table import PathTable, path_table

JOIN_TOLERANCE = 1e-9
"""Largest gap [m] between the end of a curve and the start of the next."""
CORNER_ANGLE = 1e-6
"""Smallest jump of the tangent [rad] that is a corner."""


class Path(CurveSequence):
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

    >>> from contourlab.geometry.line import Line
    >>> square = Path([Line((0, 0), (1, 0)), Line((1, 0), (1, 1))])
    >>> square.length, square.corners.tolist()
    (2.0, [1.0])
    """

    def __init__(self, curves: Sequence[Curve], closed: bool = False) -> None:
        super().__init__(curves, closed)
        gap = np.linalg.norm(self.ends[0][:-1] - self.starts[0][1:], axis=1)
        if gap.size and gap.max() > JOIN_TOLERANCE:
            i = int(np.argmax(gap > JOIN_TOLERANCE))
            raise GeometryError(f"curve {i + 2} begins {gap[i]:.3g} m away from the end of curve {i + 1}, at {self.ends[0][i].tolist()}")
        if self.closed and np.linalg.norm(self.ends[0][-1] - self.starts[0][0]) > JOIN_TOLERANCE:
            raise GeometryError("a closed path must end where it begins")

    @cached_property
    def corners(self) -> Array:
        """Arc lengths at which the tangent jumps, rising; on a closed path 0 is the closing point."""
        turn = np.linalg.norm(self.ends[1][:-1] - self.starts[1][1:], axis=1)
        found = self.breaks[1:-1][turn > CORNER_ANGLE]
        if self.closed and np.linalg.norm(self.ends[1][-1] - self.starts[1][0]) > CORNER_ANGLE:
            found = np.concatenate([[0.0], found])
        return np.asarray(found)

    def coefficients(self, index: Index) -> tuple[Array, NDArray[np.bool_]]:
        """Return the common form of lines and arcs, for the engine: position = base + d s + u cos(a + b s) + v sin(a + b s).

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
        """Return the closest points of the path; see `contourlab.geometry.foot_point`."""
        return foot_point(self, points, around, window)

    def table(self, tolerance: float = 1e-10, *, pieces: int = 1) -> PathTable:
        """Return the path as quintic pieces for the engine; see `contourlab.geometry.table`."""
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
