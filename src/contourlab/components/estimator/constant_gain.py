"""The contour error of a straight move whose direction is known beforehand."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

from contourlab.components.contract import param
from contourlab.components.estimator.local import LocalEstimator, local_step
from contourlab.errors import ParameterError
from contourlab.primitives import copysign, dot, lincomb, scale, sub


class ConstantGain(LocalEstimator):
    """Distance to a line of fixed direction through the reference: in the plane eps = -e_x sin th + e_y cos th with constant gains.

    The path's own direction is not asked for, except for which way it is travelled. It is exact on lines of this direction, and what is
    left of it on others, L sin(angle between them), is what a variable gain is for. Any number of axes: (I - d d')(r - p).

    References
    ----------
    Koren, "Cross-coupled biaxial computer control for manufacturing systems", ASME J. Dynamic Systems 102 (1980).
    """

    kind = "constant-gain"
    reference = "Koren 1980"
    example = {"direction": (4.0, 3.0), "angle": 0.2}
    unbounded = ("direction",)
    derived = ("turn_cosine", "turn_sine")

    direction: tuple[float, ...] = param(vector=True, doc="direction of the line, one number an axis; of any length but zero")
    angle: float = param(
        default=0.0,
        unit="rad",
        minimum=-2.0 * math.pi,
        maximum=2.0 * math.pi,
        display="deg",
        doc="turns the direction counter-clockwise; two axes only",
    )

    def __init__(self, **values: Any) -> None:
        super().__init__(**values)
        length = math.hypot(*self.direction)
        if not (length > 0.0 and math.isfinite(length)):
            raise ParameterError(f"{self.kind}.direction", list(self.direction), "a vector that has a direction")
        if self.angle != 0.0 and len(self.direction) != 2:
            raise ParameterError(f"{self.kind}.angle", f"{self.angle:g}", f"0 with a direction of {len(self.direction)} axes", "rad")

    def check_axes(self, n_axis: int) -> None:
        if len(self.direction) != n_axis:
            raise ParameterError(f"{self.kind}.direction", list(self.direction), f"a list of {n_axis} numbers, one for each axis")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return np.cos(par.angle), np.sin(par.angle)

    def make_function(self, evaluate: Callable[..., Any], n_axis: int) -> Any:
        length = math.hypot(*self.direction)
        return local_step(_on_line(tuple(number / length for number in self.direction)), evaluate, n_axis)


@cache
def _on_line(direction: tuple[float, ...]) -> Callable[..., Any]:
    def turned(par: Any) -> Any:
        c, s = par.turn_cosine, par.turn_sine
        return c * direction[0] - s * direction[1], s * direction[0] + c * direction[1]

    def straight(par: Any) -> Any:
        return direction

    line = turned if len(direction) == 2 else straight

    def nearest(par: Any, r: Any, tangent: Any, bend: Any, position: Any) -> Any:
        along = line(par)
        along = scale(copysign(1.0, dot(along, tangent)), along)
        lag = sub(r, position)
        return lincomb(1.0, lag, -dot(along, lag), along), along

    return nearest
