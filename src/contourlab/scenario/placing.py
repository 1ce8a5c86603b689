"""Move a contour on a machine; scale and move a part program into the travel on request."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array
from contourlab.feed import route_from_program
from contourlab.geometry import Path
from contourlab.geometry.curve import Curve
from contourlab.geometry.line_and_arc import Arc, Line
from contourlab.geometry.nurbs import BSpline, Nurbs
from contourlab.geometry.parametric import EllipticalArc
from contourlab.geometry.path import boxes
from contourlab.loop import Machine
from contourlab.program import Arc as ProgramArc
from contourlab.program import Dwell, Move, Point, Program, Spline

MARGIN = 0.01
"""Share of the travel left free at either end of a fitted program."""


def placed(path: Path, offset: Sequence[float]) -> Path:
    """Return a path moved by an offset.

    Parameters
    ----------
    offset : sequence of float [m]
        One value per coordinate of the result; coordinates beyond the path's own stay constant.

    Returns
    -------
    Path
        Lines, arcs, elliptical arcs and splines keep their type.

    >>> from contourlab.geometry import contour
    >>> placed(contour("circle", radius=0.01), (0.1, 0.0, 0.002)).position([0.0]).round(9).tolist()
    [[0.11, 0.0, 0.002]]
    """
    move = np.array(offset, dtype=float)
    if move.size == path.n_axis and not move.any():
        return path
    return Path([_moved(curve, move) for curve in path.curves], path.closed)


def _wide(vectors: Array, n: int) -> Array:
    """Pad vectors (..., m) with zeros to (..., n)."""
    return np.concatenate([vectors, np.zeros((*vectors.shape[:-1], n - vectors.shape[-1]))], axis=-1)


class _Moved(Curve):
    """A moved curve, with further constant coordinates."""

    def __init__(self, curve: Curve, move: Array) -> None:
        self.curve, self.move = curve, move
        self.n_axis, self.length = move.size, curve.length
        self._marks = tuple(getattr(curve, "_marks", (0.0, curve.length)))

    def derivatives(self, s: ArrayLike, order: int = 3) -> Array:
        derivatives = _wide(self.curve.derivatives(s, order), self.n_axis)
        derivatives[0] += self.move
        return derivatives

    def smallest_radius(self) -> float:
        return self.curve.smallest_radius()

    def describe(self) -> bytes:
        return b"moved" + self.move.astype("<f8").tobytes() + self.curve.describe()


def _moved(curve: Curve, move: Array) -> Curve:
    def wide(*vectors: Array) -> list[Array]:
        return [_wide(vector, move.size) for vector in vectors]

    match curve:
        case Line():
            start, end = wide(curve.start, curve.end)
            return Line(start + move, end + move)
        case Arc():
            centre, *frame = wide(curve.centre, curve.u, curve.v, curve.rise)
            return Arc(centre + move, curve.radius, curve.start_angle, curve.sweep, *frame)
        case EllipticalArc():
            centre, p, q = wide(curve.centre, curve.p, curve.q)
            return EllipticalArc(centre + move, p, q, curve.first, curve.last)
        case BSpline():
            return BSpline(curve.degree, _wide(curve.points, move.size) + move, curve.knots)
        case Nurbs():
            return Nurbs(curve.degree, _wide(curve.points, move.size) + move, curve.knots, curve.weights)
    return _Moved(curve, move)


def fitted(program: Program, letters: Sequence[str], machine: Machine) -> tuple[Program, str]:
    """Return a program fitted into the travel of a machine, and a note on the change.

    Parameters
    ----------
    letters : sequence of str
        The address that each axis of the machine obeys.

    Returns
    -------
    program : Program
        Scaled down by one factor for all axes if it is too large, and moved no further than needed. Feedrates stay.
    note : str
        Empty if it is unchanged.

    Raises
    ------
    ProgramError
        If the program moves an axis that the machine lacks.
    """
    route = route_from_program(program, letters)
    lows, highs = boxes(route.path)
    low, high = lows.min(axis=0), highs.max(axis=0)
    length = highs.max(axis=0, initial=-np.inf, where=~route.rapid[:, None]) - lows.min(axis=0, initial=np.inf, where=~route.rapid[:, None])
    travel = np.array([axis.limits.ends for axis in machine.axes], dtype=np.float64)
    extent = np.array([axis.limits.extent for axis in machine.axes])
    room = travel[:, 1] - travel[:, 0]
    least, most = travel[:, 0], travel[:, 1]
    if np.all(low >= least) and np.all(high <= most) and np.all(length <= extent):
        return program, ""
    margin = np.where(np.isfinite(room), MARGIN * room, 0.0)
    least, most = least + margin, most - margin
    wanted, size = np.array([most - least, (1.0 - 2.0 * MARGIN) * extent]), np.array([high - low, length])
    ratios = np.divide(wanted, size, out=np.full(size.shape, np.inf), where=size > 0.0)
    scale = float(min(1.0, ratios.min()))
    moved = np.maximum(least - scale * low, 0.0) + np.minimum(most - scale * high, 0.0)
    shift = dict(zip(letters, moved.tolist(), strict=True))
    x, y, z = (shift.get(letter, 0.0) for letter in "xyz")
    moved_by = ", ".join(f"{value * 1e3:+.6g}" for value in (x, y, z))
    scaled = "" if scale == 1.0 else f"scaled by {scale:.6g}, then "
    return _scaled(program, scale, (x, y, z)), f"fitted into the machine's travel: {scaled}moved by ({moved_by}) mm"


def _scaled(program: Program, scale: float, shift: Point) -> Program:
    """Return a program with every point p of its moves at ``scale * p + shift`` [m]."""

    def scaled(point: Point) -> Point:
        x, y, z = (scale * value + offset for value, offset in zip(point, shift, strict=True))
        return (x, y, z)

    def moved(move: Move) -> Move:
        if isinstance(move, Dwell):
            return move
        if isinstance(move, Spline):
            return replace(move, points=tuple(map(scaled, move.points)))
        if isinstance(move, ProgramArc):
            move = replace(move, centre=scaled(move.centre))
        return replace(move, start=scaled(move.start), end=scaled(move.end))

    return replace(program, moves=tuple(moved(move) for move in program.moves))
