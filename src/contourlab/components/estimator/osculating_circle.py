"""The distance to the circle that fits the path best at the reference."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from contourlab.components.estimator.local import LocalEstimator, frame_of, sided
from contourlab.primitives import add, dot, lincomb, maximum, scale, select, sqrt, sub

STRAIGHT = 1e-12
"""Curvature [1/m] below which the direction to the centre is not asked for: over a metre such an arc strays 0.5 pm from its tangent."""
CENTRE = 1e-9
"""Distance from the centre over the radius below which no place of the circle is nearest."""


class OsculatingCircle(LocalEstimator):
    """Distance to the osculating circle at the reference, exactly, for any number of axes.

    In the circle's plane with p - r = a t + b c (c towards the centre, k = 1/rho): q = sqrt(1 - 2 k b + k^2 (a^2 + b^2)) is the distance
    from the centre over the radius, and the way to the circle is (q - 1)/k = (k (a^2 + b^2) - 2 b)/(q + 1), which has no difference of
    large numbers and holds for k = 0, where the circle is its tangent; no branch is needed. What lies off the plane is added. Exact on
    lines and circles; else the leading error is L^3 k'/6 behind by a lag L, k' the change of curvature with arc length, and in space the
    torsion's L^3 k tau/6 off the plane.

    References
    ----------
    The distance whose expansion Koren & Lo 1991 use; exact here, and in space.
    """

    kind = "osculating-circle"
    reference = "Koren & Lo 1991, without their expansion"

    def make_function(self, evaluate: Callable[..., Any], n_axis: int) -> Any:
        return _make(evaluate, n_axis)


@cache
def _make(evaluate: Callable[..., Any], n_axis: int) -> Any:
    frame, signed = frame_of(evaluate), sided(n_axis)

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        r, tangent, bend = frame(par, inp.arc_length)
        away = sub(inp.position, r)
        a = dot(away, tangent)
        across = lincomb(1.0, away, -a, tangent)
        k = sqrt(dot(bend, bend))
        inward = dot(away, bend)
        b = inward / maximum(k, STRAIGHT)
        square = a * a + b * b
        # h/(1 + q) is the way to the circle, outwards positive; all that would be divided by the curvature is multiplied out.
        h = k * square - 2.0 * b
        start = 1.0 - inward
        q = sqrt(start * start + k * k * a * a)
        safe = maximum(q, CENTRE)
        way = h / (1.0 + q)
        inwards = (square + b * way) / (safe * (1.0 + q))
        error = add(lincomb(-1.0, across, inwards, bend), scale(-way * a * k / safe, tangent))
        lost = q < CENTRE
        at_foot = lincomb(select(lost, 1.0, start / safe), tangent, select(lost, 0.0, a / safe), bend)
        return (), (add(inp.position, error), error, signed(at_foot, error), at_foot)

    return step
