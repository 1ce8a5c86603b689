"""The limits that bind the speed, on motions with known phases."""

from __future__ import annotations

import numpy as np
import pytest

from contourlab.errors import FeedError
from contourlab.feed import AxisLimits, plan, route_from_path, route_from_program
from contourlab.feed.planner import Binding, limiting
from contourlab.geometry import Line, Path, contour
from contourlab.program import parse_program

LIMITS = AxisLimits([0.5, 0.5], [1.0, 1.0], [50.0, 50.0])


def codes(route, limits, time, **options):
    profile = plan(route, limits, 1e-3, **options).profile
    return limiting(route, limits, profile, profile.motion(np.asarray(time, float)).arc_length, **options).tolist()


def test_the_phases_of_a_move_are_named():
    # 200 mm at 0.2 m/s: jerk for 20 ms, acceleration to 200 ms, jerk to 220 ms, then the feed.
    route = route_from_path(Path((Line((0.0, 0.0), (0.2, 0.0)),)), 0.2)
    found = codes(route, LIMITS, [0.0, 0.01, 0.1, 0.19, 0.21, 0.5])
    assert found[0] == Binding.REST
    assert found[1:4] == [Binding.JERK, Binding.ACCELERATION, Binding.ACCELERATION]
    assert found[5] == Binding.FEEDRATE


def test_the_slower_axis_limits_a_rapid():
    route = route_from_program(parse_program("G21\nG0 X400 Y100\nM2\n"), axes=("x", "y"))
    profile = plan(route, LIMITS, 1e-3).profile
    assert limiting(route, LIMITS, profile, 0.5 * route.path.length).tolist() == [Binding.VELOCITY]


def test_centripetal_acceleration_limits_a_fast_circle():
    route = route_from_path(contour("circle", radius=0.05), 0.4)
    limits = AxisLimits([0.5, 0.5], [1.0, 1.0], [1e4, 1e4])
    profile = plan(route, limits, 1e-3).profile
    # At the end of an axis's travel all of its acceleration is centripetal.
    quarter = route.path.length / 4.0
    assert set(limiting(route, limits, profile, [quarter, 2.0 * quarter, 3.0 * quarter]).tolist()) == {Binding.ACCELERATION}


def test_stops_and_jumps_of_curvature_are_named():
    text = "G21 G90 F12000\nG1 X50\nG3 X50 Y20 I0 J10\nG1 X0\nG1 X0 Y5\nM2\n"
    route = route_from_program(parse_program(text), axes=("x", "y"))
    limits = AxisLimits([0.5, 0.5], [2.0, 2.0], [400.0, 400.0])
    profile = plan(route, limits, 1e-3, curvature_step=0.02).profile
    found = limiting(route, limits, profile, route.path.breaks, curvature_step=0.02).tolist()
    assert found == [Binding.REST, Binding.CURVATURE_STEP, Binding.CURVATURE_STEP, Binding.REST, Binding.REST]


def test_laps_are_counted_continuously():
    route = route_from_path(contour("circle", radius=0.02), 0.05)
    profile = plan(route, LIMITS, 1e-3, laps=3).profile
    assert limiting(route, LIMITS, profile, [1.5 * route.path.length, 2.25 * route.path.length]).tolist() == [Binding.FEEDRATE] * 2


def test_limits_with_other_axes_are_refused():
    route = route_from_path(contour("circle"), 0.05)
    profile = plan(route, LIMITS, 1e-3).profile
    with pytest.raises(FeedError, match="3 axes"):
        limiting(route, AxisLimits([1.0] * 3, 1.0), profile, [0.0])
    with pytest.raises(FeedError, match="curvature_step"):
        limiting(route, LIMITS, profile, [0.0], curvature_step=-1.0)
