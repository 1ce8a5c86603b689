"""Puts a contour on a machine: moved, and with coordinates that stay where they are for the axes that it does not move."""

from __future__ import annotations

from collections.abc import Sequence
from functools import singledispatch

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.geometry import Path
from contourlab.geometry.arc import Arc
from contourlab.geometry.conics import EllipticalArc
from contourlab.geometry.curve import Curve
from contourlab.geometry.line import Line
from contourlab.geometry.nurbs import BSpline, Nurbs

Array = NDArray[np.float64]


def placed(path: Path, offset: Sequence[float]) -> Path:
    """Return a path moved by an offset, in as many coordinates as the offset has.

    Parameters
    ----------
    path : Path
    offset : sequence of float [m]
        At least as many as the path has coordinates; the path stands still in those beyond.

    Returns
    -------
    Path
        The path itself where there is nothing to do. Lines, arcs, elliptical arcs and splines stay what they are.

    >>> from contourlab.geometry import contour
    >>> placed(contour("circle", radius=0.01), (0.1, 0.0, 0.002)).position([0.0]).round(9).tolist()
    [[0.11, 0.0, 0.002]]
    """
    move = np.array(offset, dtype=float)
    if move.size == path.n_axis and not move.any():
        return path
    return Path([_moved(curve, move) for curve in path.curves], path.closed)


def _wide(vectors: Array, n: int) -> Array:
    """Return vectors (..., m) as (..., n), with zeros behind."""
    return np.concatenate([vectors, np.zeros((*vectors.shape[:-1], n - vectors.shape[-1]))], axis=-1)


class _Moved(Curve):
    """Any curve, moved, with further coordinates that stand still."""

    def __init__(self, curve: Curve, move: Array) -> None:
        self.curve, self.move = curve, move
        self.n_axis, self.length = move.size, curve.length
        self._marks = tuple(getattr(curve, "_marks", (0.0, curve.length)))

    def derivatives(self, s: ArrayLike, order: int = 3) -> Array:
        found = _wide(self.curve.derivatives(s, order), self.n_axis)
        found[0] += self.move
        return found

    def smallest_radius(self) -> float:
        return self.curve.smallest_radius()

    def describe(self) -> tuple[object, ...]:
        return ("moved", *self.move.tolist(), *self.curve.describe())


@singledispatch
def _moved(curve: Curve, move: Array) -> Curve:
    return _Moved(curve, move)


@_moved.register
def _(curve: Line, move: Array) -> Curve:
    return Line(_wide(curve.start, move.size) + move, _wide(curve.end, move.size) + move)


@_moved.register
def _(curve: Arc, move: Array) -> Curve:
    centre, u, v, rise = (_wide(vector, move.size) for vector in (curve.centre, curve.u, curve.v, curve.rise))
    return Arc(centre + move, curve.radius, curve.start_angle, curve.sweep, u, v, rise)


@_moved.register
def _(curve: EllipticalArc, move: Array) -> Curve:
    centre, p, q = (_wide(vector, move.size) for vector in (curve.centre, curve.p, curve.q))
    return EllipticalArc(centre + move, p, q, curve.first, curve.last)


@_moved.register
def _(curve: BSpline, move: Array) -> Curve:
    return BSpline(curve.degree, _wide(curve.points, move.size) + move, curve.knots)


@_moved.register
def _(curve: Nurbs, move: Array) -> Curve:
    return Nurbs(curve.degree, _wide(curve.points, move.size) + move, curve.knots, curve.weights)
