"""Reverse curves, and move their ends slightly."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array
from contourlab.errors import GeometryError
from contourlab.geometry.curve import Curve, vector
from contourlab.geometry.line_and_arc import Arc, Line
from contourlab.geometry.nurbs import BSpline, Nurbs
from contourlab.geometry.parametric import EllipticalArc


class _Backwards(Curve):
    """Any curve from its end to its start."""

    def __init__(self, forwards: Curve) -> None:
        self.forwards, self.n_axis, self.length = forwards, forwards.n_axis, forwards.length

    def derivatives(self, s: ArrayLike, order: int = 3) -> Array:
        result = np.array(self.forwards.derivatives(self.length - np.atleast_1d(np.asarray(s, dtype=float)), order))
        result[1::2] *= -1.0
        return result

    def smallest_radius(self) -> float:
        return self.forwards.smallest_radius()

    def describe(self) -> bytes:
        return b"backwards" + self.forwards.describe()


def backwards(curve: Curve) -> Curve:
    """Return the curve from its end to its start; lines, arcs, elliptical arcs and splines keep their kind.

    >>> backwards(Line((0, 0), (3, 4))).start.tolist()
    [3.0, 4.0]
    """
    match curve:
        case _Backwards():
            return curve.forwards
        case Line():
            return Line(curve.end, curve.start)
        case Arc():
            end_angle = curve.start_angle + curve.sweep
            return Arc(curve.centre + curve.rise, curve.radius, end_angle, -curve.sweep, curve.u, curve.v, -curve.rise)
        case EllipticalArc():
            return EllipticalArc(curve.centre, curve.p, -curve.q, -curve.last, -curve.first)
        case BSpline():
            return BSpline(curve.degree, curve.points[::-1], -curve.knots[::-1])
        case Nurbs():
            return Nurbs(curve.degree, curve.points[::-1], -curve.knots[::-1], curve.weights[::-1])
    return _Backwards(curve)


def with_ends(curve: Curve, start: ArrayLike, end: ArrayLike) -> Curve:
    """Return the nearest curve of the same kind between slightly moved ends: a circle stays a circle, an ellipse an ellipse.

    Parameters
    ----------
    curve : Line, Arc, EllipticalArc, BSpline or Nurbs
    start, end : array_like (n_axis,) [m]

    Raises
    ------
    GeometryError
        If there is no such curve, or a part of it would move more than three times as far as the ends.
    """
    a, b = vector(start, "start"), vector(end, "end")
    old = curve.derivatives([0.0, curve.length], 0)[0]
    moved = _moved(curve, a, b, np.array([a, b]) - old)
    asked = max(float(np.linalg.norm(a - old[0])), float(np.linalg.norm(b - old[1])))
    if not isinstance(curve, Line):
        along = np.linspace(0.0, 1.0, 9)
        shift = moved.position(along * moved.length) - curve.position(along * curve.length)
        if float(np.linalg.norm(shift, axis=1).max()) > 3.0 * asked + 1e-12:
            raise GeometryError(f"the ends of this {type(curve).__name__} cannot be moved by {asked:.3g} m without the rest moving further")
    return moved


def _moved(curve: Curve, start: Array, end: Array, move: Array) -> Curve:
    """Return the curve between new ends, which move by `move` (2, n_axis)."""
    match curve:
        case Line():
            return Line(start, end)
        case Arc():
            return Arc.through(start, end, curve.centre + move.mean(axis=0), curve.sweep, curve.u, curve.v)
        case EllipticalArc():
            # r(t) is linear in centre, p and q: take the smallest change that moves the ends.
            t = np.array([curve.first, curve.last])
            centre, p, q = np.linalg.lstsq(np.column_stack([np.ones(2), np.cos(t), np.sin(t)]), move, rcond=None)[0]
            return EllipticalArc(curve.centre + centre, curve.p + p, curve.q + q, curve.first, curve.last)
        case BSpline():
            return BSpline(curve.degree, _sheared(curve, curve.points, move), curve.knots)
        case Nurbs():
            moved = curve
            for _ in range(12):  # exact at once if the ends are control points; else weights leave a small error, which falls quickly
                moved = Nurbs(curve.degree, _sheared(curve, moved.points, move), curve.knots, curve.weights)
                move = np.array([start, end]) - moved.raw(np.array([moved.first, moved.last]), 0)[0]
                if float(np.abs(move).max()) < 1e-12:
                    break
            return moved
    raise GeometryError(f"the ends of a {type(curve).__name__} cannot be moved")


def _sheared(curve: BSpline | Nurbs, points: Array, move: Array) -> Array:
    """Return control points moved by a linear function of their parameters (Greville abscissae), which moves the curve in the same way."""
    sums = np.cumsum(np.concatenate([[0.0], curve.knots[1:-1]]))
    middle = (sums[curve.degree :] - sums[: -curve.degree]) / curve.degree
    at = np.asarray((middle - curve.first) / (curve.last - curve.first))[:, None]
    return np.asarray(points + move[0] * (1.0 - at) + move[1] * at)
