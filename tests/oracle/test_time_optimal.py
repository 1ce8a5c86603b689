"""Our feed against toppra's time-optimal motion along the same path, under limits of velocity and acceleration."""

from __future__ import annotations

import logging
from typing import Any

import numpy as np
import pytest

from contourlab.feed import AxisLimits, Route, limit_report, plan, route_from_path, route_from_program
from contourlab.geometry import Path, contour
from contourlab.program import parse_program

pytestmark = pytest.mark.oracle
SLOT = "G21 G90 F12000\nG1 X50\nG3 X50 Y20 I0 J10\nG1 X0\nG3 X0 Y0 I0 J-10\nM2\n"
ACCELERATION = 2.0
SHARP = ACCELERATION / 1e-3
"""A jerk limit that reaches the acceleration limit in 1 ms, in which 100 mm/s covers 0.1 mm."""
INSIDE = 1e-12


class _AsToppra:
    """A path by arc length, with toppra's interface."""

    def __init__(self, path: Path) -> None:
        self.path, self.dof = path, path.n_axis
        self.path_interval = np.array([0.0, path.length])
        self.waypoints = None

    def __call__(self, s: Any, order: int = 0) -> Any:
        at = np.clip(np.atleast_1d(s), 0.0, self.path.length * (1.0 - INSIDE))
        found = np.ascontiguousarray(self.path.derivatives(at, max(order, 1))[order])
        return found[0] if np.ndim(s) == 0 else found


def least_time(route: Route, limits: AxisLimits, n: int) -> float:
    """Return toppra's time from rest to rest along a route of one feedrate [s], on n intervals of equal length."""
    toppra = pytest.importorskip("toppra", reason="toppra is not installed")
    logging.getLogger("toppra").setLevel(logging.ERROR)
    path, feed = _AsToppra(route.path), float(route.feedrate[0])

    class PathSpeed(toppra.constraint.LinearConstraint):  # type: ignore[misc]
        """Limit the path speed to the programmed feed: toppra limits axis speeds only."""

        def compute_constraint_params(self, _: Any, gridpoints: Any) -> Any:
            bound = np.column_stack([np.zeros(gridpoints.size), np.full(gridpoints.size, feed**2)])
            return None, None, None, None, None, None, bound

    scheme = toppra.constraint.DiscretizationType.Interpolation
    constraints = [
        PathSpeed(),
        toppra.constraint.JointVelocityConstraint(np.column_stack([-limits.velocity, limits.velocity])),
        toppra.constraint.JointAccelerationConstraint(np.column_stack([-limits.acceleration, limits.acceleration]), scheme),
    ]
    grid = np.linspace(0.0, route.path.length, n + 1)
    solver = toppra.algorithm.TOPPRA(constraints, path, gridpoints=grid, solver_wrapper="seidel", parametrizer="ParametrizeConstAccel")
    _, speed, _ = solver.compute_parameterization(0.0, 0.0)
    assert speed is not None
    return float(np.sum(2.0 * np.diff(grid) / (speed[1:] + speed[:-1])))


def demanded(route: Route, limits: AxisLimits) -> float:
    """Return our time [s]; assert that no limit is broken."""
    reference = plan(route, limits, 2.5e-4)
    assert limit_report(reference, limits).ok()
    return reference.duration


CASES = {
    "circle-5": lambda: contour("circle", radius=0.005),
    "circle-20": lambda: contour("circle", radius=0.02),
    "circle-50": lambda: contour("circle", radius=0.05),
    "butterfly": lambda: contour("butterfly"),
    "lemniscate": lambda: contour("lemniscate"),
}


@pytest.mark.slow
@pytest.mark.parametrize("feed", [0.1, 10.0])
@pytest.mark.parametrize("name", CASES)
def test_with_plentiful_jerk_the_time_is_near_the_least(name: str, feed: float) -> None:
    route = route_from_path(CASES[name](), feed)
    limits = AxisLimits([0.5, 0.5], ACCELERATION, SHARP)
    least = least_time(route, limits, 2000)
    ours = demanded(route, limits)
    # Rising to the acceleration and falling from it cannot take less than A/J at either end.
    assert least < ours < 1.08 * least


@pytest.mark.parametrize("name", CASES)
@pytest.mark.slow
def test_without_a_jerk_limit_both_find_the_same_time(name: str) -> None:
    route = route_from_path(CASES[name](), 10.0)
    limits = AxisLimits([0.5, 0.5], ACCELERATION, np.inf)
    # Both approach the least time from above with the grid's fineness.
    assert demanded(route, limits) == pytest.approx(least_time(route, limits, 4000), rel=0.01)


def test_curvature_jumps_cost_no_more_than_their_own_limit() -> None:
    route = route_from_program(parse_program(SLOT, "slot"), axes=("x", "y"))
    limits = AxisLimits([0.5, 0.5], ACCELERATION, SHARP)
    least = least_time(route, limits, 4000)
    assert 0.999 * least < demanded(route, limits) < 1.08 * least
