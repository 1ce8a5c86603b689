"""The contour-error vector to the tangent at the reference."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from contourlab.components.estimator.local import LocalEstimator, frame_of, sided
from contourlab.primitives import add, dot, lincomb, sub


class Tangent(LocalEstimator):
    """Distance to the tangent at the reference: the tracking error without its part along the path, (I - t t')(r - p), for any axes.

    Exact on lines. Behind the reference by a lag L the path has left its tangent by L^2/(2 rho), which is its leading error: use it where
    the lag is small, or where only its direction matters. Its foot is the tool's projection on the tangent.

    References
    ----------
    Yeh & Hsu, "Theory and applications of the robust cross-coupled control design", ASME J. Dynamic Systems 121 (1999), and "Estimation of
    the contouring error vector for the cross-coupled control design", IEEE/ASME Trans. Mechatronics 7 (2002); Gecer Ulu, Ulu & Cakmakci,
    section 3.2.
    """

    kind = "tangent"
    reference = "Yeh & Hsu 2002; Gecer Ulu, Ulu & Cakmakci, section 3.2"

    def make_function(self, evaluate: Callable[..., Any], n_axis: int) -> Any:
        return _make(evaluate, n_axis)


@cache
def _make(evaluate: Callable[..., Any], n_axis: int) -> Any:
    frame, signed = frame_of(evaluate), sided(n_axis)

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        r, tangent, _ = frame(par, inp.arc_length)
        lag = sub(r, inp.position)
        error = lincomb(1.0, lag, -dot(tangent, lag), tangent)
        return (), (add(inp.position, error), error, signed(tangent, error), tangent)

    return step
