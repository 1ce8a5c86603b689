"""Planned references: limits, stops, ends, cycle times."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from contourlab.errors import FeedError
from contourlab.feed import AxisLimits, Reference, limit_report, plan, route_from_path, route_from_program
from contourlab.feed.route import KINK_TIME, MOST_KINK
from contourlab.geometry import Arc, Line, Path, contour
from contourlab.program import parse_program

LIMITS = AxisLimits([0.5, 0.5], [1.0, 1.5], [30.0, 60.0])

SLOT = "G21 G90 F12000\nG1 X50\nG3 X50 Y20 I0 J10\nG1 X0\nG3 X0 Y0 I0 J-10\nM2\n"
CORNERS = "G21 G90 F6000\nG1 X30\nG1 X30 Y30\nG1 X0 Y0\nG0 X-20 Y5\nG2 X-10 Y15 I10\nM2\n"
WAVE = "G21 G90 F6000\nG2 X20 Y0 I10 J0\nG3 X40 Y0 I10 J0\nG2 X50 I5 J0\nM2\n"


def route_of(name):
    programs = {"slot": SLOT, "corners": CORNERS, "wave": WAVE}
    if name in programs:
        return route_from_program(parse_program(programs[name], name), axes=("x", "y"))
    return route_from_path(contour(name), 0.15)


PROGRAMS = ["slot", "corners", "wave"]
NAMES = [*PROGRAMS, "circle", "ellipse", "lemniscate", "star", "butterfly", "diamond", "line-line-circle"]


@pytest.mark.parametrize("velocity", [1.0, 1e6])
@pytest.mark.parametrize("acceleration", [1.0, 1e9])
@pytest.mark.parametrize("jerk", [1e-6, 1e12])
def test_extreme_limits_are_planned(velocity, acceleration, jerk):
    """The limits of the other axis, the feed or both hold."""
    extreme = AxisLimits([velocity, 0.2], [acceleration, 1.0], [jerk, 40.0])
    for path in (Path([Line((0.0, 0.0), (0.01, 0.0)), Line((0.01, 0.0), (0.01, 0.01))]), contour("circle", radius=0.01)):
        reference = plan(route_from_path(path, 0.1), extreme, 1e-2)
        assert limit_report(reference, extreme).ok()


@pytest.mark.parametrize("name", NAMES)
def test_limits_hold_everywhere(name, demand):
    reference = plan(route_of(name), LIMITS, 1e-3)
    report = limit_report(reference, LIMITS)
    assert report.ok(), report
    assert max(demand(reference, LIMITS)) <= 1.003


@pytest.mark.parametrize("name", NAMES)
def test_a_plan_begins_and_ends_at_rest_and_never_goes_back(name):
    reference = plan(route_of(name), LIMITS, 1e-3)
    block = reference.block(0, reference.n_sample)
    path = reference.path
    assert np.all(np.diff(block.arc_length) >= 0.0)
    assert block.arc_length[0] == 0.0
    assert block.arc_length[-1] == path.length
    np.testing.assert_allclose(block.position[-1], path.derivatives(np.array([path.length]), 0)[0, 0], atol=1e-15)
    np.testing.assert_allclose(block.velocity[[0, -1]], 0.0, atol=1e-15)
    assert (reference.n_sample - 2) * 1e-3 < reference.duration <= (reference.n_sample - 1) * 1e-3


@pytest.mark.parametrize("name", NAMES)
def test_position_velocity_and_acceleration_are_consistent(name):
    period = 2e-4
    reference = plan(route_of(name), LIMITS, period)
    block = reference.block(0, min(reference.n_sample, 20000))
    # Simpson's rule is exact for a cubic motion; curvature adds little in such a short time.
    step = np.diff(block.position, axis=0)
    mean = 0.5 * (block.velocity[1:] + block.velocity[:-1])
    largest = float(np.max(LIMITS.acceleration))
    assert np.max(np.abs(step - period * mean)) < largest * period**2 / 4
    assert np.max(np.abs(np.diff(block.velocity, axis=0))) <= 1.005 * largest * period


@pytest.mark.parametrize("name", NAMES)
def test_spans_add_up_to_the_path(name):
    reference = plan(route_of(name), LIMITS, 1e-3)
    profile = reference.profile
    lasting = np.diff(np.append(profile.t0, profile.duration))
    gone = lasting * (profile.v0 + lasting * (profile.a0 / 2 + lasting * profile.j / 6))
    assert gone.sum() == pytest.approx(reference.path.length, rel=1e-12)
    ends = np.append(profile.s0[1:], profile.length)
    np.testing.assert_allclose(profile.s0 + gone, ends, atol=1e-14)
    speed = profile.v0 + lasting * (profile.a0 + lasting * profile.j / 2)
    acceleration = profile.a0 + lasting * profile.j
    np.testing.assert_allclose(speed[:-1], profile.v0[1:], atol=1e-12)
    np.testing.assert_allclose(acceleration[:-1], profile.a0[1:], atol=1e-9)


def test_the_time_of_a_line_follows_the_formula():
    program = parse_program("G21 G90 F12000\nG1 X100\nM2\n")
    limits = AxisLimits([1.0], [1.0], [30.0])
    reference = plan(route_from_program(program, axes=("x",)), limits, 1e-3)
    assert reference.duration == pytest.approx(0.1 / 0.2 + 0.2 / 1.0 + 1.0 / 30.0, rel=1e-12)


def test_the_slower_axis_limits_an_oblique_line():
    program = parse_program("G21 G90 F60000\nG1 X80 Y60\nM2\n")
    limits = AxisLimits([0.1, 0.05], [10.0, 10.0], [1e4, 1e4])
    report = limit_report(plan(route_from_program(program, axes=("x", "y")), limits, 1e-3), limits)
    assert report.velocity[1].ratio == pytest.approx(1.0, rel=1e-9)
    assert report.velocity[0].ratio == pytest.approx(0.05 / 0.06 * 0.08 / 0.1, rel=1e-9)


def test_lines_with_one_direction_and_feedrate_are_driven_as_one():
    one = parse_program("G21 G90 F6000\nG1 X100 Y50\nM2\n")
    many = parse_program("G21 G90 F6000\n" + "".join(f"G1 X{2 * k} Y{k}\n" for k in range(1, 51)) + "M2\n")
    times = [plan(route_from_program(p, axes=("x", "y")), LIMITS, 1e-3).duration for p in (one, many)]
    assert times[1] == pytest.approx(times[0], rel=1e-12)


def test_feedrate_changes_along_a_straight_line_respect_the_jerk(demand):
    program = parse_program("G21 G90\nG1 X50 F12000\nG1 X80 F3000\nG1 X140 F12000\nM2\n")
    reference = plan(route_from_program(program, axes=("x",)), AxisLimits([1.0], [1.0], [30.0]), 1e-3)
    assert max(demand(reference, AxisLimits([1.0], [1.0], [30.0]))) <= 1.0 + 1e-9
    feedrate = reference.block(0, reference.n_sample).feedrate
    arc_length = reference.block(0, reference.n_sample).arc_length
    slow = (arc_length > 0.05) & (arc_length < 0.08)
    assert np.max(feedrate[slow]) == pytest.approx(0.05, rel=1e-12)
    assert np.min(feedrate[slow]) == pytest.approx(0.05, rel=1e-12)
    assert np.max(feedrate) > 0.19


def test_tangent_joints_need_no_stop():
    reference = plan(route_of("slot"), LIMITS, 1e-3)
    feedrate = reference.block(0, reference.n_sample).feedrate
    moving = (reference.block(0, reference.n_sample).arc_length > 0.02) & (
        reference.block(0, reference.n_sample).arc_length < reference.path.length - 0.02
    )
    assert np.min(feedrate[moving]) > 0.05


def test_curvature_steps_are_limited_and_reported():
    route = route_of("slot")
    free = limit_report(plan(route, LIMITS, 1e-3), LIMITS)
    assert free.steps.sample.size == 3
    assert 0.5 < max(worst.value / worst.limit for worst in free.curvature_step) <= 1.05
    tight_plan = plan(route, LIMITS, 1e-3, curvature_step=0.1)
    tight = limit_report(tight_plan, LIMITS)
    slack = 3e-3 * 60.0  # three periods of permitted jerk
    assert all(worst.value <= 0.1 * worst.limit + slack for worst in tight.curvature_step)
    assert tight.ok()
    stopping = plan(route, LIMITS, 1e-3, curvature_step=0.0)
    inner = np.searchsorted(stopping.profile.s0, route.path.breaks[1:-1] - 1e-12)
    np.testing.assert_array_equal(stopping.profile.v0[inner], 0.0)


def test_an_s_bend_steps_by_no_more_than_the_acceleration_limit():
    route = route_of("wave")
    reference = plan(route, LIMITS, 1e-3)
    inner = np.searchsorted(reference.profile.s0, route.path.breaks[1:-1] - 1e-12)
    speed = reference.profile.v0[inner]
    # There both arcs accelerate y, in opposite senses: the step is (1/R1 + 1/R2) v^2.
    assert np.all(speed**2 * np.array([200.0, 300.0]) <= LIMITS.acceleration[1] * (1 + 1e-6))
    assert np.all(speed > 0.0)


def test_circle_from_rest_to_rest_is_near_the_time_optimum():
    # Radius 20 mm, 200 mm/s, 1 m/s^2: the time optimum with a limit on the vector's norm is 1.04 s.
    route = route_from_path(contour("circle", radius=0.02), 0.2)
    assert 1.01 < plan(route, AxisLimits([1.0, 1.0], [1.0, 1.0]), 1e-4).duration < 1.08
    assert plan(route, AxisLimits([1.0, 1.0], [1.0, 1.0], [1e3, 1e3]), 1e-4).duration < 1.10


def test_smooth_closed_contours_have_no_stop(demand):
    route = route_from_path(contour("circle", radius=0.02), 0.1)
    limits = AxisLimits([1.0, 1.0], [1.0, 1.0], [50.0, 50.0])
    once, thrice = plan(route, limits, 1e-3), plan(route, limits, 1e-3, laps=3)
    assert once.laps == ()
    assert thrice.duration - once.duration == pytest.approx(2 * 2 * np.pi * 0.02 / 0.1, rel=1e-3)
    assert [start for start, _ in thrice.laps[1:]] == [stop for _, stop in thrice.laps[:-1]]
    assert thrice.laps[0][0] == 0
    assert thrice.laps[-1][1] == thrice.n_sample
    for lap, (start, stop) in enumerate(thrice.laps):
        arc_length = thrice.block(start, stop).arc_length
        assert lap * route.path.length <= arc_length[0] < arc_length[-1] <= (lap + 1) * route.path.length * (1 + 1e-15)
    assert max(demand(thrice, limits)) <= 1.003


def test_time_scales_with_the_limits():
    # Limits v, a, j times f, f^2, f^3 give the same motion f times as fast.
    factor = 1.7
    for name in ("corners", "slot", "ellipse"):
        route = route_of(name)
        fast = type(route)(route.path, route.feedrate * factor, route.rapid, route.dwell, route.source_line, route.programmed)
        limits = AxisLimits(LIMITS.velocity * factor, LIMITS.acceleration * factor**2, LIMITS.jerk * factor**3)
        slow, quick = plan(route, LIMITS, 1e-3).duration, plan(fast, limits, 1e-3).duration
        assert quick * factor == pytest.approx(slow, rel=1e-6)


def test_ten_thousand_lines_stop_at_every_corner():
    generator = np.random.default_rng(1)
    points = np.cumsum(generator.normal(0.0, 1e-3, (10_001, 3)), axis=0)
    path = Path(tuple(Line(a, b) for a, b in pairwise(points)))
    reference = plan(route_from_path(path, 0.1), AxisLimits([0.5] * 3, 2.0, 50.0), 1e-3)
    assert reference.duration > 600.0
    along = np.diff(points, axis=0) / np.linalg.norm(np.diff(points, axis=0), axis=1)[:, None]
    sharp = np.append(True, np.einsum("ij,ij->i", along[1:], along[:-1]) < np.cos(MOST_KINK))
    assert 9_900 < sharp.sum() < 10_000
    speed = reference.profile.v0[np.searchsorted(reference.profile.s0, path.breaks[:-1] - 1e-12)]
    assert np.all(speed[sharp] == 0.0)


def test_a_small_kink_with_a_small_velocity_jump_needs_no_stop():
    # At 100 mm/s and 0.1 mrad the velocity of y jumps by 10 um/s, which 1 m/s^2 compensates in 10 us.
    angle, limits = 1e-4, AxisLimits([1.0] * 2, [5.0, 1.0], [1e4] * 2)
    points = [(0.0, 0.0), (0.1, 0.0), (0.1 + 0.1 * np.cos(angle), 0.1 * np.sin(angle))]
    path = Path([Line(a, b) for a, b in pairwise(points)])
    for feed, wanted in ((0.03, 0.03), (0.15, 1.0 * KINK_TIME / np.sin(angle))):
        reference = plan(route_from_path(path, feed), limits, 1e-4)
        block = reference.block(0, reference.n_sample)
        at = np.interp(0.1, block.arc_length, block.feedrate)
        assert at == pytest.approx(wanted, rel=0.02)
        report = limit_report(reference, limits)
        assert report.ok()
        assert report.n_kink == 1
        assert report.kink[1].value == pytest.approx(at * np.sin(angle), rel=0.02)
    # If the permitted speed is below half the feedrate, it becomes a stop.
    assert plan(route_from_path(path, 0.3), limits, 1e-3).profile.v0[1:].min() == 0.0
    # The verifier detects a kink that is passed too fast: here 20 mrad at 200 mm/s.
    bent = Path([Line((0.0, 0.0), (0.1, 0.0)), Line((0.1, 0.0), (0.1 + 0.1 * np.cos(0.02), 0.1 * np.sin(0.02)))])
    fast = Reference.from_samples(bent.position(np.linspace(0.0, 0.2, 10_001)), 1e-4, bent)
    assert limit_report(fast, limits).kink[1].value == pytest.approx(0.2 * np.sin(0.02), rel=2e-3)
    assert not limit_report(fast, limits).ok()
    # It also detects 0.1 mrad at twice the permitted speed, even with samples too far apart to show it in their differences.
    twice = Reference.from_samples(path.position(np.arange(0.0, 0.2, 0.2 * 1e-3)), 1e-3, path)
    assert limit_report(twice, limits).kink[1].ratio == pytest.approx(2.0, rel=0.02)
    assert not limit_report(twice, limits).ok()
    # A corner is no kink.
    square = Path([Line((0.0, 0.0), (0.1, 0.0)), Line((0.1, 0.0), (0.1 + 0.1 * np.cos(0.2), 0.1 * np.sin(0.2)))])
    assert plan(route_from_path(square, 0.2), limits, 1e-3).profile.v0[1:].min() == 0.0


def test_limits_without_a_ramp_are_refused():
    with pytest.raises(FeedError, match=r"\b0\b.*acceleration.*jerk"):
        plan(route_of("slot"), AxisLimits(1.0, np.inf, np.inf), 1e-3)


def test_a_path_too_long_to_plan_is_refused():
    """A drawing in the wrong unit, of 100,000 km with an arc."""
    path = Path([Line(np.array([0.0, 0.0]), np.array([1e8, 0.0])), Arc([1e8, 0.01], 0.01, -np.pi / 2.0, np.pi)])
    with pytest.raises(FeedError):
        plan(route_from_path(path, 0.1), AxisLimits([0.5, 0.5], [2.0, 2.0], [50.0, 50.0]), 1e-3)


def test_bad_arguments_are_refused():
    route = route_of("slot")
    with pytest.raises(FeedError, match="servo_period"):
        plan(route, LIMITS, 0.0)
    with pytest.raises(FeedError, match="laps"):
        plan(route, LIMITS, 1e-3, laps=2)
    with pytest.raises(FeedError, match="curvature_step"):
        plan(route, LIMITS, 1e-3, curvature_step=-0.1)
    with pytest.raises(FeedError, match=r"\b3 axes.*\b2\b"):
        plan(route, AxisLimits([1.0] * 3, 1.0, 1.0), 1e-3)
