"""What the estimators have in common that look at the path at the reference's own place only."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any, ClassVar

from contourlab.components.contract import Component
from contourlab.engine.step import Port, Step
from contourlab.errors import ParameterError
from contourlab.geometry.view import PathView
from contourlab.primitives import dot, lincomb, scale, sqrt


class LocalEstimator(Component):
    """An estimator without memory: it knows tangent and curvature of the path at the reference, and nothing else of it.

    Class attributes
    ----------------
    fewest_axes, most_axes : int
        For how many axes it is valid.
    """

    family = "estimator"
    inputs = (Port("position", -1), Port("arc_length"))
    outputs = (Port("foot_position", -1), Port("error_vector", -1), Port("contour_error_estimate"), Port("tangent", -1))

    fewest_axes: ClassVar[int] = 1
    most_axes: ClassVar[int] = 1_000_000

    def check_axes(self, n_axis: int) -> None:
        """Refuse a machine with a number of axes for which the estimator makes no sense.

        Raises
        ------
        ParameterError
            Naming the estimator, the number and the range.
        """
        if not self.fewest_axes <= n_axis <= self.most_axes:
            wanted = f"used with {self.fewest_axes}" if self.fewest_axes == self.most_axes else f"used with {self.fewest_axes} or more"
            raise ParameterError("controller.estimator", f"{self.kind} for {n_axis} axes", f"{wanted}; tangent, taylor and newton take any")

    def make_function(self, evaluate: Callable[..., Any], n_axis: int) -> Any:
        """Return the step function on a path seen through `evaluate`."""
        # What tells one local estimator from another.
        raise NotImplementedError

    def path_step(self, view: PathView, n_axis: int) -> Step:
        """Return the step on a given path.

        Raises
        ------
        ParameterError
            If it is not valid for so many axes.
        """
        self.check_axes(n_axis)
        states, inputs, outputs = self.ports(n_axis)
        parameters = (*self.numeric(), *self.derived, *view.parameters)
        function = self.make_function(view.evaluate, n_axis)
        return Step(f"estimator/{self.kind}", function, parameters, tuple(view.tables), "", states, inputs, outputs)


@cache
def frame_of(evaluate: Callable[..., Any]) -> Any:
    """Return a function of `par` and arc length that gives the path's point, unit tangent and curvature vector [1/m] there.

    The curvature vector points to the centre of curvature and has the length 1/rho; a path's parameter need not be its arc length.
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
    """Return a function of unit tangent and error vector (from the tool to the path) that gives the signed error.

    In the plane it is positive when the tool is to the left of the direction of travel; elsewhere it is the vector's length.
    """

    def in_the_plane(tangent: Any, error: Any) -> Any:
        return tangent[1] * error[0] - tangent[0] * error[1]

    def in_space(tangent: Any, error: Any) -> Any:
        return sqrt(dot(error, error))

    return in_the_plane if n_axis == 2 else in_space
