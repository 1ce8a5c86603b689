"""Estimators without memory: they use the path at the reference only."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any, ClassVar

import numpy as np

from contourlab.components.contract import Component, param
from contourlab.engine.step import Step
from contourlab.errors import ParameterError
from contourlab.geometry.view import PathView
from contourlab.primitives import add, copysign, dot, lincomb, maximum, scale, select, sqrt, sub


class LocalEstimator(Component):
    """Base of estimators without memory: they use only point, tangent and curvature of the path at the reference.

    A subclass defines `nearest`; this class turns it into a step.

    Class attributes
    ----------------
    fewest_axes, most_axes : int
        Numbers of axes for which it is valid.
    """

    family = "estimator"

    fewest_axes: ClassVar[int] = 1
    most_axes: ClassVar[int] = 1_000_000

    def check_axes(self, n_axis: int) -> None:
        """Raise ParameterError unless the estimator is valid for this number of axes."""
        if not self.fewest_axes <= n_axis <= self.most_axes:
            number = f"{self.fewest_axes}" if self.fewest_axes == self.most_axes else f"{self.fewest_axes} or more"
            bound = f"used with {number}; tangent, taylor and newton take any number"
            raise ParameterError("controller.estimator", f"{self.kind} for {n_axis} axes", bound)

    @staticmethod
    def nearest(par: Any, r: Any, tangent: Any, bend: Any, position: Any) -> Any:
        """Return the error vector from `position` to the path, and the tangent at the foot.

        r, tangent and bend are the path's point, unit tangent and curvature vector at the reference.
        """
        raise NotImplementedError

    def make_function(self, evaluate: Callable[..., Any], n_axis: int) -> Any:
        """Return the step function on a path that `evaluate` describes."""
        return local_step(type(self).nearest, evaluate, n_axis)

    def path_step(self, view: PathView, n_axis: int) -> Step:
        """Return the step on a given path; raise ParameterError if it is not valid for this number of axes."""
        self.check_axes(n_axis)
        states, inputs, outputs = self.ports(n_axis)
        parameters = (*self.numeric(), *self.derived, *view.parameters)
        function = self.make_function(view.evaluate, n_axis)
        return Step(f"estimator/{self.kind}", function, parameters, tuple(view.tables), "", states, inputs, outputs)


@cache
def local_step(nearest: Callable[..., Any], evaluate: Callable[..., Any], n_axis: int) -> Any:
    """Return the step function of a law `nearest`; see `LocalEstimator.nearest`."""
    frame, signed = frame_of(evaluate), sided(n_axis)

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        r, tangent, bend = frame(par, inp.arc_length)
        error, along = nearest(par, r, tangent, bend, inp.position)
        return (), (add(inp.position, error), error, signed(along, error), along)

    return step


@cache
def frame_of(evaluate: Callable[..., Any]) -> Any:
    """Return ``frame(par, s)``, which gives point, unit tangent and curvature vector [1/m] of the path at arc length s.

    The curvature vector points to the centre of curvature and has length 1/rho. The path's parameter need not be its arc length.
    """

    def frame(par: Any, s: float) -> Any:
        r, r1, r2 = evaluate(par, s)
        square = dot(r1, r1)
        tangent = scale(1.0 / sqrt(square), r1)
        bend = lincomb(1.0 / square, r2, -dot(tangent, r2) / square, tangent)
        return r, tangent, bend

    return frame


@cache
def sided(n_axis: int) -> Any:
    """Return ``signed(tangent, error)``: the contour error from unit tangent and error vector (tool to path).

    In the plane it is positive if the tool is to the left of the direction of travel; otherwise it is the vector's length.
    """

    def in_the_plane(tangent: Any, error: Any) -> Any:
        return tangent[1] * error[0] - tangent[0] * error[1]

    def in_space(tangent: Any, error: Any) -> Any:
        return sqrt(dot(error, error))

    return in_the_plane if n_axis == 2 else in_space


class Tangent(LocalEstimator):
    """Distance to the tangent at the reference: the tracking error without its part along the path, (I - t t')(r - p).

    Exact on lines. With a lag L the leading error is L^2/(2 rho): use it where the lag is small, or where only the direction matters. The
    foot point is the tool's projection on the tangent. Any number of axes.

    References
    ----------
    Yeh & Hsu, "Theory and applications of the robust cross-coupled control design", ASME J. Dynamic Systems 121 (1999), and "Estimation of
    the contouring error vector for the cross-coupled control design", IEEE/ASME Trans. Mechatronics 7 (2002); Gecer Ulu, Ulu & Cakmakci,
    section 3.2.
    """

    kind = "tangent"
    reference = "Yeh & Hsu 2002; Gecer Ulu, Ulu & Cakmakci 2016, section 3.2"

    @staticmethod
    def nearest(par: Any, r: Any, tangent: Any, bend: Any, position: Any) -> Any:
        lag = sub(r, position)
        return lincomb(1.0, lag, -dot(tangent, lag), tangent), tangent


class Taylor(LocalEstimator):
    """Second-order Taylor expansion of the path, the parabola r + a t + a^2 k/2, at the tool's abscissa a = t.(p - r).

    The vector from the tool to the parabola is projected on the parabola's normal. Without the projection it would be eps L^2/(2 rho^2) too
    long, eps the contour error. No equation is solved. Exact on lines. With a lag L the leading error is L^3 k'/6 - L^4/(8 rho^3), k' the
    change of curvature with arc length. Any number of axes.

    References
    ----------
    Compare Zhu, Zhao & Ding, "Real-time contouring error estimation for multi-axis motion systems using the second-order approximation",
    Int. J. Machine Tools and Manufacture 68 (2013).
    """

    kind = "taylor"
    reference = "second-order expansion of the path at the reference"

    @staticmethod
    def nearest(par: Any, r: Any, tangent: Any, bend: Any, position: Any) -> Any:
        away = sub(position, r)
        a = dot(away, tangent)
        gap = add(lincomb(-1.0, away, a, tangent), scale(0.5 * a * a, bend))
        slope = lincomb(1.0, tangent, a, bend)
        along = scale(1.0 / sqrt(dot(slope, slope)), slope)
        return lincomb(1.0, gap, -dot(along, gap), along), along


STRAIGHT = 1e-12
"""Curvature [1/m] below which the direction to the centre is not needed: over a metre such an arc leaves its tangent by 0.5 pm."""
CENTRE = 1e-9
"""Distance from the centre, over the radius, below which no point of the circle is nearest."""


class OsculatingCircle(LocalEstimator):
    """Exact distance to the osculating circle at the reference.

    In the plane of the circle, p - r = a t + b c with c towards the centre and k = 1/rho. The distance from the centre over the radius is
    q = sqrt(1 - 2 k b + k^2 (a^2 + b^2)). The distance to the circle, (q - 1)/k = (k (a^2 + b^2) - 2 b)/(q + 1), has no cancellation and
    holds for k = 0, where the circle is its tangent; no branch is needed. The part off the plane is added.

    Exact on lines and circles. Elsewhere, with a lag L, the leading error is L^3 k'/6, k' the change of curvature with arc length; in space
    torsion adds L^3 k tau/6 off the plane. Any number of axes.

    References
    ----------
    Koren & Lo 1991 use an expansion of this distance; here it is exact, and extended to space.
    """

    kind = "osculating-circle"
    reference = "Koren & Lo 1991, without their expansion"

    @staticmethod
    def nearest(par: Any, r: Any, tangent: Any, bend: Any, position: Any) -> Any:
        away = sub(position, r)
        a = dot(away, tangent)
        across = lincomb(1.0, away, -a, tangent)
        k = sqrt(dot(bend, bend))
        inward = dot(away, bend)
        b = inward / maximum(k, STRAIGHT)
        square = a * a + b * b
        # h/(1 + q) is the distance to the circle, positive outwards; divisions by the curvature are multiplied out.
        h = k * square - 2.0 * b
        start = 1.0 - inward
        q = sqrt(start * start + k * k * a * a)
        safe = maximum(q, CENTRE)
        way = h / (1.0 + q)
        inwards = (square + b * way) / (safe * (1.0 + q))
        error = add(lincomb(-1.0, across, inwards, bend), scale(-way * a * k / safe, tangent))
        lost = q < CENTRE
        return error, lincomb(select(lost, 1.0, start / safe), tangent, select(lost, 0.0, a / safe), bend)


NOWHERE = 1e-9
"""Length of the gain vector below which it has no direction: the tool is a diameter off the path."""


class KorenLo(LocalEstimator):
    """Contour error of a plane path by variable gains: eps = -C_x e_x + C_y e_y, C_x = sin th - e_x/(2 rho), C_y = cos th + e_y/(2 rho).

    With e = r - p, the left normal n and the curvature k = 1/rho (positive where the path turns left), the gains are the vector
    C = (-C_x, C_y) = n + k e/2, and eps = C.e: the distance to the osculating circle without its term -eps^2/(2 rho). The leading errors
    are therefore eps^2/(2 rho) and, with a lag L, L^3 k'/6, k' the change of curvature with arc length. Exact on lines; on circles to
    second order in the error. Two axes.

    The output error vector is eps C: a coupling with gain k gives k eps C, exactly Koren and Lo's correction (-C_x k eps, C_y k eps). Its
    length is |eps| |C| with |C| = 1 + O(e/rho); the states of a dynamic coupling contain this factor. Output `tangent` is normal to C: the
    tangent halfway to the foot point. The contour error estimate is -eps, because its sign is positive to the left of the direction of
    travel.

    References
    ----------
    Koren & Lo, "Variable-gain cross-coupling controller for contouring", CIRP Annals 40 (1991).
    """

    kind = "koren-lo"
    reference = "Koren & Lo 1991"
    fewest_axes = 2
    most_axes = 2

    def make_function(self, evaluate: Callable[..., Any], n_axis: int) -> Any:
        return _koren_lo_step(evaluate)


@cache
def _koren_lo_step(evaluate: Callable[..., Any]) -> Any:
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


class ConstantGain(LocalEstimator):
    """Distance to a line of fixed direction through the reference: in the plane eps = -e_x sin th + e_y cos th with constant gains.

    Of the path it uses only the sense of travel. Exact on lines of this direction; on other lines the error is L sin(angle between them),
    which a variable gain avoids. For any number of axes: (I - d d')(r - p).

    References
    ----------
    Koren, "Cross-coupled biaxial computer control for manufacturing systems", ASME J. Dynamic Systems 102 (1980).
    """

    kind = "constant-gain"
    reference = "Koren 1980"
    example = {"direction": (4.0, 3.0), "angle": 0.2}
    unbounded = ("direction",)
    derived = ("turn_cosine", "turn_sine")

    direction: tuple[float, ...] = param(vector=True, doc="direction of the line, one number per axis; any length but zero")
    angle: float = param(
        default=0.0,
        unit="rad",
        minimum=-2.0 * math.pi,
        maximum=2.0 * math.pi,
        display="deg",
        doc="angle by which to turn the direction counter-clockwise; two axes only",
    )

    def check_values(self) -> None:
        length = math.hypot(*self.direction)
        if not (length > 0.0 and math.isfinite(length)):
            raise ParameterError(f"{self.kind}.direction", list(self.direction), "a finite vector, not all 0")
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
