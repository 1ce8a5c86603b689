"""Newton's method on the distance to the path, warm-started at each tick."""

from __future__ import annotations

from functools import cache
from typing import Any

from contourlab.components.contract import Component, param, text_param
from contourlab.engine.step import Port, Step, ports
from contourlab.geometry.view import PathView, newton_of
from contourlab.primitives import clip, dot, lincomb, scale, select, sqrt, sub


class Newton(Component):
    """Foot point on the path by Newton steps on |r(s) - p|^2/2, warm-started from the last tick.

    Each iteration is s -= g/max(h, |r'|^2/10), g = r'.(r - p), h = |r'|^2 + r''.(r - p); s stays within `window` on both sides of the
    reference: a tool that overshoots is ahead of it. The result is the projection of the error on the normal at s. Its error is of second
    order in the error of s; that of the distance to r(s) would be of first order.

    With ``start = "both"`` the iteration also starts at the reference, and the nearer result counts: after a corner the warm start alone
    may stay on the old side.

    With a lag L and a radius of curvature rho, the foot point error after one iteration is L^3/(3 rho^2); each further iteration squares
    it. Valid for errors small against the radius: beyond the centre of curvature another point is nearest.

    References
    ----------
    Ghaffari & Ulsoy, "Dynamic contour error estimation and feedback modification for high-precision contouring", IEEE/ASME Transactions on
    Mechatronics 21 (2016); here in discrete time.
    """

    family = "estimator"
    kind = "newton"
    reference = "Ghaffari & Ulsoy 2016, in discrete time"
    states = (Port("foot"),)
    outputs = (*ports("foot_position", "error_vector", size=-1), *ports("contour_error_estimate", "foot_arc_length"), Port("tangent", -1))

    window: float = param(default=5e-3, unit="m", minimum=0.0, exclusive=True, display="mm", doc="search range around the reference")
    iterations: float = param(default=2.0, minimum=1.0, maximum=8.0, whole=True, structural=True, doc="Newton steps per tick")
    start: str = text_param(default="both", choices=("both", "warm"), doc="warm: from the last foot point; both: also from the reference")

    def path_step(self, view: PathView, n_axis: int) -> Step:
        """Return the step on a given path."""
        states, inputs, outputs = self.ports(n_axis)
        parameters = (*self.numeric(), *view.parameters)
        # The view of a table gives `path_wrap`; it is 0 for an open path, where no foot point lies beyond the ends.
        ends = view.parameters.get("path_wrap") == 0.0
        function = _make(view.evaluate, n_axis, int(self.iterations), self.start == "both", ends)
        return Step("estimator/newton", function, parameters, tuple(view.tables), "", states, inputs, outputs)


@cache
def _make(evaluate: Any, n_axis: int, iterations: int, both: bool, ends: bool) -> Any:
    planar = n_axis == 2
    improve, distance = newton_of(evaluate)

    def seek(par: Any, s: float, position: Any, centre: float) -> float:
        for _ in range(iterations):
            s = improve(par, s, position, centre)
            s = clip(s, 0.0, par.path_length) if ends else s
        return s

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        position, centre = inp.position, inp.arc_length
        s = seek(par, x.foot, position, centre)
        if both:
            other = seek(par, centre, position, centre)
            s = select(distance(par, other, position) < distance(par, s, position), other, s)
        q, q1, _ = evaluate(par, s)
        gap = sub(q, position)
        # One root and one division: in lanes they cost more than all the rest.
        tangent = scale(1.0 / sqrt(dot(q1, q1)), q1)
        normal = lincomb(1.0, gap, -dot(tangent, gap), tangent)
        # In the plane, positive to the left of the direction of travel.
        estimate = tangent[1] * gap[0] - tangent[0] * gap[1] if planar else sqrt(dot(normal, normal))
        return (s,), (q, normal, estimate, s, tangent)

    return step
