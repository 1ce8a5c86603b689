"""Reverse curves, and move their ends by a little."""

from __future__ import annotations

from functools import singledispatch

import numpy as np
from numpy.typing import ArrayLike

from contourlab.errors import GeometryError
from contourlab.geometry.arc import Arc
from contourlab.geometry.conics import EllipticalArc
from contourlab.geometry.curve import Array, Curve, vector
from contourlab.geometry.line import Line
from contourlab.geometry.nurbs import BSpline, Nurbs


class _Backwards(Curve):
    """Any curve from its end to its start."""

    def __init__(self, forwards: Curve) -> None:
        self.forwards, self.n_axis, self.length = forwards, forwards.n_axis, forwards.length

    def derivatives(self, s: ArrayLike, order: int = 3) -> Array:
        found = np.array(self.forwards.derivatives(self.length - np.atleast_1d(np.asarray(s, dtype=float)), order))
        found[1::2] *= -1.0
        return found

    def smallest_radius(self) -> float:
        return self.forwards.smallest_radius()

    def describe(self) -> tuple[object, ...]:
        return ("backwards", *self.forwards.describe())


@singledispatch
def backwards(curve: Curve) -> Curve:
    """Return the same curve from its end to its start; lines, arcs, elliptical arcs and splines stay what they are.

    >>> backwards(Line((0, 0), (3, 4))).start.tolist()
    [3.0, 4.0]
    """
    return _Backwards(curve)


@backwards.register
def _(curve: _Backwards) -> Curve:
    return curve.forwards


@backwards.register
def _(curve: Line) -> Curve:
    return Line(curve.end, curve.start)


@backwards.register
def _(curve: Arc) -> Curve:
    return Arc(curve.centre + curve.rise, curve.radius, curve.start_angle + curve.sweep, -curve.sweep, curve.u, curve.v, -curve.rise)


@backwards.register
def _(curve: EllipticalArc) -> Curve:
    return EllipticalArc(curve.centre, curve.p, -curve.q, -curve.last, -curve.first)


@backwards.register
def _(curve: BSpline) -> Curve:
    return BSpline(curve.degree, curve.points[::-1], -curve.knots[::-1])


@backwards.register
def _(curve: Nurbs) -> Curve:
    return Nurbs(curve.degree, curve.points[::-1], -curve.knots[::-1], curve.weights[::-1])


def with_ends(curve: Curve, start: ArrayLike, end: ArrayLike) -> Curve:
    """Return the curve of the same kind that is nearest, with ends moved by a little: a circle stays a circle, an ellipse an ellipse.

    Parameters
    ----------
    curve : Line, Arc, EllipticalArc, BSpline or Nurbs
    start, end : array_like (n_axis,) [m]

    Raises
    ------
    GeometryError
        If there is no such curve, or some of it would move more than three times as far as the ends do.
    """
    a, b = vector(start, "start"), vector(end, "end")
    old = curve.derivatives([0.0, curve.length], 0)[0]
    found = _moved(curve, a, b, np.array([a, b]) - old)
    asked = max(float(np.linalg.norm(a - old[0])), float(np.linalg.norm(b - old[1])))
    if not isinstance(curve, Line):
        along = np.linspace(0.0, 1.0, 9)
        moved = found.position(along * found.length) - curve.position(along * curve.length)
        if float(np.linalg.norm(moved, axis=1).max()) > 3.0 * asked + 1e-12:
            raise GeometryError(f"the ends of this {type(curve).__name__} cannot be moved by {asked:.3g} m without the rest moving further")
    return found


@singledispatch
def _moved(curve: Curve, start: Array, end: Array, move: Array) -> Curve:
    raise GeometryError(f"the ends of a {type(curve).__name__} cannot be moved")


@_moved.register
def _(curve: Line, start: Array, end: Array, move: Array) -> Curve:
    return Line(start, end)


@_moved.register
def _(curve: Arc, start: Array, end: Array, move: Array) -> Curve:
    return Arc.through(start, end, curve.centre + move.mean(axis=0), curve.sweep, curve.u, curve.v)


@_moved.register
def _(curve: EllipticalArc, start: Array, end: Array, move: Array) -> Curve:
    # r(t) is linear in centre, p and q: of all changes that put the ends where they are wanted, the smallest.
    t = np.array([curve.first, curve.last])
    rows = np.column_stack([np.ones(2), np.cos(t), np.sin(t)])
    centre, p, q = np.linalg.lstsq(rows, move, rcond=None)[0]
    return EllipticalArc(curve.centre + centre, curve.p + p, curve.q + q, curve.first, curve.last)


def _greville(curve: BSpline | Nurbs) -> Array:
    """Return the relative parameter of each control point (Greville abscissa), 0 at the start, 1 at the end of the curve."""
    sums = np.cumsum(np.concatenate([[0.0], curve.knots[1:-1]]))
    middle = (sums[curve.degree :] - sums[: -curve.degree]) / curve.degree
    return np.asarray((middle - curve.first) / (curve.last - curve.first))[:, None]


@_moved.register
def _(curve: BSpline, start: Array, end: Array, move: Array) -> Curve:
    # A linear function over the control points' parameters is the same linear function over the curve.
    at = _greville(curve)
    return BSpline(curve.degree, curve.points + move[0] * (1.0 - at) + move[1] * at, curve.knots)


@_moved.register
def _(curve: Nurbs, start: Array, end: Array, move: Array) -> Curve:
    at, found = _greville(curve), curve
    for _ in range(12):  # exact at once where the ends are control points; else what weights leave is small, and goes fast
        points = found.points + move[0] * (1.0 - at) + move[1] * at
        found = Nurbs(curve.degree, points, curve.knots, curve.weights)
        move = np.array([start, end]) - found.raw(np.array([found.first, found.last]), 0)[0]
        if float(np.abs(move).max()) < 1e-12:
            break
    return found
