"""The distance to the parabola that fits the path best at the reference."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from contourlab.components.estimator.local import LocalEstimator, frame_of, sided
from contourlab.primitives import add, dot, lincomb, scale, sqrt, sub


class Taylor(LocalEstimator):
    """Second-order Taylor expansion: the parabola r + a t + a^2 k/2 at the tool's own abscissa a = t.(p - r), for any number of axes.

    The vector from the tool to the parabola at that abscissa is projected on the parabola's normal there, as a foot point's would be: left
    as it is it would be too long by eps L^2/(2 rho^2), eps the contour error. No equation is solved. Exact on lines; the leading error
    behind by a lag L is L^3 k'/6 - L^4/(8 rho^3), k' the change of curvature with arc length.

    References
    ----------
    Compare Zhu, Zhao & Ding, "Real-time contouring error estimation for multi-axis motion systems using the second-order approximation",
    Int. J. Machine Tools and Manufacture 68 (2013).
    """

    kind = "taylor"
    reference = "second-order expansion of the path at the reference"

    def make_function(self, evaluate: Callable[..., Any], n_axis: int) -> Any:
        return _make(evaluate, n_axis)


@cache
def _make(evaluate: Callable[..., Any], n_axis: int) -> Any:
    frame, signed = frame_of(evaluate), sided(n_axis)

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        r, tangent, bend = frame(par, inp.arc_length)
        away = sub(inp.position, r)
        a = dot(away, tangent)
        gap = add(lincomb(-1.0, away, a, tangent), scale(0.5 * a * a, bend))
        slope = lincomb(1.0, tangent, a, bend)
        along = scale(1.0 / sqrt(dot(slope, slope)), slope)
        error = lincomb(1.0, gap, -dot(along, gap), along)
        return (), (add(inp.position, error), error, signed(along, error), along)

    return step
