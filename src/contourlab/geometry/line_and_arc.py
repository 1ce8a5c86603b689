"""Straight lines, circular arcs and helices."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Index
from contourlab.errors import GeometryError
from contourlab.geometry.curve import Curve, CurveBatch, of_each, positive, rows, vector


class Lines(CurveBatch):
    """Many lines at once.

    Parameters
    ----------
    curves : sequence of Line
    """

    columns, axis = ("start", "end", "direction", "length"), -1

    def __init__(self, curves: Sequence[Line]) -> None:
        self._fill(*(rows(curves, name) for name in self.columns[:3]), np.array([line.length for line in curves]))

    def _fill(self, *arrays: Any) -> None:
        self.start, self.end, self.direction, self.length = arrays
        self.n_axis, self.sixth = len(self.start), np.zeros(self.length.size)

    @classmethod
    def between(cls, start: ArrayLike, end: ArrayLike) -> Lines:
        """Return the lines between points (n, n_axis) [m].

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
            Line(a[np.argmin(good)], b[np.argmin(good)])  # raises with the reason
        return cls.made(*(np.ascontiguousarray(part.T) for part in (a, b, (b - a) / length[:, None])), length)

    def curve(self, slot: int) -> Line:
        line = Line.__new__(Line)
        line.start, line.end, line.direction = (part[:, slot].copy() for part in (self.start, self.end, self.direction))
        line.length, line.n_axis = float(self.length[slot]), self.n_axis
        return line

    def derivatives(self, slot: Index, along: Array, order: int) -> Array:
        result = np.zeros((order + 1, self.n_axis, along.size))
        for j, (start, direction) in enumerate(zip(of_each(self.start, slot), of_each(self.direction, slot), strict=True)):
            result[0, j] = start + along * direction
            result[1:2, j] = direction
        return result

    def smallest_radii(self) -> Array:
        return np.full(self.length.size, np.inf)


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
    _batch = Lines

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
        """Return the lines between points (n, n_axis) [m], as `Lines.between`."""
        batch = Lines.between(start, end)
        return [batch.curve(i) for i in range(batch.length.size)]


class Arcs(CurveBatch):
    """Many arcs and helices at once.

    Parameters
    ----------
    curves : sequence of Arc
    """

    def _fill(self, *arrays: Any) -> None:
        super()._fill(*arrays)
        curves = self.curves
        self.centre, self.u, self.v, self.rise = (rows(curves, name) for name in ("centre", "u", "v", "rise"))
        self.radius, self.start_angle, self.rate = (
            np.array([getattr(curve, name) for curve in curves]) for name in ("radius", "start_angle", "rate")
        )
        self.sixth = self.radius * np.abs(self.rate) ** 6
        self.direct = ~np.any(self.rise != 0.0, axis=0)

    def derivatives(self, slot: Index, along: Array, order: int) -> Array:
        radius, angle, rate, length = (of_each(part, slot) for part in (self.radius, self.start_angle, self.rate, self.length))
        angle = angle + rate * along
        c, d = radius * np.cos(angle), radius * np.sin(angle)
        result = np.empty((order + 1, self.n_axis, along.size))
        parts = (of_each(part, slot) for part in (self.centre, self.u, self.v, self.rise))
        for j, (centre, u, v, rise) in enumerate(zip(*parts, strict=True)):
            spoke = c * u + d * v
            result[0, j] = spoke + (centre + along / length * rise)
            if order:
                swing = rate * (c * v - d * u)
                result[1, j] = swing + rise / length
            if order > 1:
                result[2, j] = -(rate**2) * spoke
            if order > 2:
                result[3, j] = -(rate**2) * swing
        return result

    def smallest_radii(self) -> Array:
        return np.asarray(1.0 / (self.radius * self.rate**2))


class Arc(Curve):
    """Circular arc, or helix: c + R (cos a u + sin a v) + rise (a - a0)/sweep.

    Parameters
    ----------
    centre : array_like (n_axis,) [m]
    radius : float [m], > 0
    start_angle : float [rad]
        a0, from u towards v.
    sweep : float [rad], not 0
        Signed angle; may be more than a turn.
    u, v : array_like (n_axis,) [1], optional
        Orthonormal axes of the plane; the first two coordinates by default.
    rise : array_like (n_axis,) [m], optional
        Travel at right angles to u and v over the whole sweep.

    Raises
    ------
    GeometryError
        If the radius is not positive, the sweep is zero, or the axes are not orthonormal.

    >>> round(Arc((0, 0), 2.0, 0.0, math.pi).length, 6)
    6.283185
    """

    digest_parts = ("arc", "radius", "start_angle", "sweep", "centre", "u", "v", "rise")
    _batch = Arcs

    def __init__(
        self,
        centre: ArrayLike,
        radius: float,
        start_angle: float,
        sweep: float,
        u: ArrayLike | None = None,
        v: ArrayLike | None = None,
        rise: ArrayLike | None = None,
    ) -> None:
        self.centre = vector(centre, "centre")
        n = self.n_axis = self.centre.size
        if n < 2:
            raise GeometryError(f"centre = {centre!r}: an arc needs two coordinates or more")
        self.u = vector(u, "u") if u is not None else np.eye(n)[0]
        self.v = vector(v, "v") if v is not None else np.eye(n)[1]
        self.rise = vector(rise, "rise") if rise is not None else np.zeros(n)
        for name, axis in (("u", self.u), ("v", self.v), ("rise", self.rise)):
            if axis.size != n:
                raise GeometryError(f"{name} has {axis.size} coordinates, the centre has {n}")
        self.radius, self.start_angle, self.sweep = float(radius), float(start_angle), float(sweep)
        positive(radius=radius)
        if not math.isfinite(self.start_angle):
            raise GeometryError(f"start_angle = {start_angle!r}: must be finite")
        if self.sweep == 0.0 or not math.isfinite(self.sweep):
            raise GeometryError(f"sweep = {sweep!r}: must be finite and not zero")
        frame = np.array([self.u, self.v])
        if not np.abs(frame @ frame.T - np.eye(2)).max() <= 1e-9 or np.abs(frame @ self.rise).max() > 1e-9 * max(1.0, self.radius):
            raise GeometryError("u and v must be orthonormal, and rise at right angles to both")
        self.length = math.hypot(self.radius * self.sweep, float(np.linalg.norm(self.rise)))
        self.rate = self.sweep / self.length

    @classmethod
    def through(
        cls,
        start: ArrayLike,
        end: ArrayLike,
        centre: ArrayLike,
        sweep: float,
        u: ArrayLike | None = None,
        v: ArrayLike | None = None,
    ) -> Arc:
        """Return the arc from `start` to `end`; a rounded centre is moved until it is equally far from both.

        Parameters
        ----------
        start, end, centre : array_like (n_axis,) [m]
            End points, joined exactly; the centre is projected to the height of the start.
        sweep : float [rad]
            Signed angle; adjusted to the moved centre.
        u, v : array_like (n_axis,), optional
            Axes of the plane.

        Raises
        ------
        GeometryError
            If there is no such arc, or if it nearly closes on itself and the centre would move by more than ten times the difference of the
            radii and 2.54 um, to which programs in inches are rounded.
        """
        a, b, c = vector(start, "start"), vector(end, "end"), vector(centre, "centre")
        e1 = vector(u, "u") if u is not None else np.eye(a.size)[0]
        e2 = vector(v, "v") if v is not None else np.eye(a.size)[1]
        flat = np.array([e1, e2])
        pa, pb, pc = flat @ a, flat @ b, flat @ c
        chord = pb - pa
        square = float(chord @ chord)
        if square > 0.0:
            # Move the centre along the chord until both ends are equally far.
            move = float((pc - 0.5 * (pa + pb)) @ chord) / math.sqrt(square)
            gap = abs(float(np.linalg.norm(pa - pc)) - float(np.linalg.norm(pb - pc)))
            if abs(sweep) > math.pi and abs(move) > 10.0 * gap + 2.54e-6:
                raise GeometryError(
                    f"an arc of {math.degrees(sweep):.6g} degrees from {a.tolist()} to {b.tolist()}: its ends are "
                    f"{math.sqrt(square):.3g} m apart and their radii differ by {gap:.3g} m, so no circle near the centre joins them: "
                    "end a full circle where it starts"
                )
            pc = pc - chord * (move / math.sqrt(square))
        radius = float(np.linalg.norm(pa - pc))
        first = math.atan2(pa[1] - pc[1], pa[0] - pc[0])
        last = math.atan2(pb[1] - pc[1], pb[0] - pc[0])
        turned = first - last if square == 0.0 else last - first
        exact = turned + 2.0 * math.pi * round((sweep - turned) / (2.0 * math.pi))
        plane = e1 * pc[0] + e2 * pc[1]
        height = a - (e1 * pa[0] + e2 * pa[1])
        return cls(plane + height, radius, first, exact, e1, e2, (b - a) - (e1 * chord[0] + e2 * chord[1]))

    def part(self, low: float, high: float) -> Arc:
        """Return the arc from arc length `low` to `high` [m] along this one, 0 <= low < high <= length."""
        share, rise = (high - low) / self.length, self.rise / self.length
        return Arc(
            self.centre + low * rise, self.radius, self.start_angle + self.rate * low, self.sweep * share, self.u, self.v, self.rise * share
        )
