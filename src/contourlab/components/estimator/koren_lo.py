"""The circular contour approximation with variable gains."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from contourlab.components.estimator.local import LocalEstimator, frame_of
from contourlab.primitives import add, dot, lincomb, maximum, scale, select, sqrt, sub

NOWHERE = 1e-9
"""Length of the gain vector below which it has no direction: the tool stands a diameter off, where the scheme has lost the path."""


class KorenLo(LocalEstimator):
    """Contour error of a plane path by variable gains: eps = -C_x e_x + C_y e_y, C_x = sin th - e_x/(2 rho), C_y = cos th + e_y/(2 rho).

    With e = r - p, the left normal n and the curvature k = 1/rho (positive where the path turns left), the gains are the vector
    C = (-C_x, C_y) = n + k e/2, and eps = C.e: the distance to the osculating circle without its term -eps^2/(2 rho). The leading error is
    therefore eps^2/(2 rho), and L^3 k'/6 behind by a lag L, k' the change of curvature with arc length. Exact on lines; on circles to
    second order in the error itself. Two axes.

    The error vector handed on is eps C, so that a coupling with a gain k gives k eps C, Koren and Lo's correction (-C_x k eps, C_y k eps)
    to the last digit. Its length is |eps| |C|, and |C| is 1 + O(e/rho): states of a dynamic coupling carry this factor inside rather than
    outside of them. The `tangent` is at right angles to C: that of the place halfway to the foot. The contour error estimate is -eps, since
    the sign here is positive to the left of the direction of travel.

    References
    ----------
    Koren & Lo, "Variable-gain cross-coupling controller for contouring", CIRP Annals 40 (1991).
    """

    kind = "koren-lo"
    reference = "Koren & Lo 1991"
    fewest_axes = 2
    most_axes = 2

    def make_function(self, evaluate: Callable[..., Any], n_axis: int) -> Any:
        return _make(evaluate)


@cache
def _make(evaluate: Callable[..., Any]) -> Any:
    frame = frame_of(evaluate)

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        r, tangent, bend = frame(par, inp.arc_length)
        lag = sub(r, inp.position)
        normal = (-tangent[1], tangent[0])
        gains = lincomb(1.0, normal, 0.5 * dot(normal, bend), lag)
        eps = dot(gains, lag)
        error = scale(eps, gains)
        length = sqrt(dot(gains, gains))
        lost = length < NOWHERE
        along = scale(1.0 / maximum(length, NOWHERE), (gains[1], -gains[0]))
        along = (select(lost, tangent[0], along[0]), select(lost, tangent[1], along[1]))
        return (), (add(inp.position, error), error, -eps, along)

    return step
