"""Properties of planned references on random polylines with random limits."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from contourlab.feed import AxisLimits, Reference, Route, limit_report, plan, route_from_path
from contourlab.feed.bounds import ramp_distance, reachable_speed
from contourlab.feed.route import MOST_KINK, junctions
from contourlab.geometry import Arc, Line, Path

PERIOD = 1e-3
few = settings(max_examples=40, deadline=None)


@st.composite
def routes(draw: st.DrawFn) -> tuple[Route, AxisLimits]:
    n_axis, n_line = draw(st.integers(1, 3)), draw(st.integers(1, 8))
    step = st.tuples(*[st.floats(-0.05, 0.05).map(lambda x: round(x, 5)) for _ in range(n_axis)])
    steps = np.array(draw(st.lists(step.filter(lambda d: np.linalg.norm(d) > 1e-4), min_size=n_line, max_size=n_line)))
    points = np.concatenate([np.zeros((1, n_axis)), np.cumsum(steps, axis=0)])
    path = Path(tuple(Line(a, b) for a, b in pairwise(points)))
    feeds = draw(st.lists(st.floats(0.005, 0.5), min_size=n_line, max_size=n_line))
    vector = st.lists
    velocity = draw(vector(st.floats(0.01, 1.0), min_size=n_axis, max_size=n_axis))
    acceleration = draw(vector(st.floats(0.1, 10.0), min_size=n_axis, max_size=n_axis))
    jerk = draw(vector(st.floats(1.0, 1000.0), min_size=n_axis, max_size=n_axis))
    lines = np.arange(1, n_line + 1)
    return Route(path, feeds, np.zeros(n_line, bool), np.zeros(n_line), lines), AxisLimits(velocity, acceleration, jerk)


def durations(reference: Reference) -> np.ndarray:
    profile = reference.profile
    assert profile is not None
    return np.diff(np.append(profile.t0, profile.duration))


@few
@given(routes())
def test_no_limit_is_broken(case: tuple[Route, AxisLimits]) -> None:
    route, limits = case
    reference = plan(route, limits, PERIOD)
    report = limit_report(reference, limits)
    assert report.ok(1e-6), report
    # Along each line the axes' share of the path's derivatives is constant: look inside every span.
    profile, last = reference.profile, durations(reference)
    assert profile is not None
    middle = 0.5 * (profile.s0 + np.append(profile.s0[1:], profile.length))
    tangent = np.abs(reference.path.derivatives(middle, 1)[1])
    speed = np.maximum(profile.v0, profile.v0 + last * (profile.a0 + last * profile.j / 2))
    acceleration = np.maximum(np.abs(profile.a0), np.abs(profile.a0 + last * profile.j))
    assert np.all(tangent * speed[:, None] <= limits.velocity * (1 + 1e-9))
    assert np.all(tangent * acceleration[:, None] <= limits.acceleration * (1 + 1e-9))
    assert np.all(tangent * np.abs(profile.j)[:, None] <= limits.jerk * (1 + 1e-9))


@few
@given(routes())
def test_spans_cover_the_path_and_stop_at_corners(case: tuple[Route, AxisLimits]) -> None:
    route, limits = case
    reference = plan(route, limits, PERIOD)
    profile, last = reference.profile, durations(reference)
    assert profile is not None
    gone = last * (profile.v0 + last * (profile.a0 / 2 + last * profile.j / 6))
    np.testing.assert_allclose(gone.sum(), route.path.length, rtol=1e-12)
    before, after = (route.path.tangent(route.path.corners + step) for step in (-1e-9, 1e-9))
    sharp = np.linalg.norm(after - before, axis=1) > 1.01 * MOST_KINK
    for corner in route.path.corners[sharp]:
        at = int(np.argmin(np.abs(profile.s0 - corner)))
        assert abs(profile.s0[at] - corner) < 1e-15
        assert profile.v0[at] == 0.0
    feedrate = route.feedrate[route.path.curve_index(profile.s0 + 0.5 * gone)]
    assert np.all(profile.v0 <= feedrate * (1 + 1e-12) + 1e-15)


@few
@given(routes(), st.floats(0.2, 5.0))
def test_a_faster_machine_drives_the_same_motion_in_less_time(case: tuple[Route, AxisLimits], factor: float) -> None:
    route, limits = case
    # The speed at a kink follows from a fixed time, which does not scale.
    assume(not junctions(route).kink.any())
    fast = Route(route.path, route.feedrate * factor, route.rapid, route.dwell, route.source_line)
    scaled = AxisLimits(limits.velocity * factor, limits.acceleration * factor**2, limits.jerk * factor**3)
    slow, quick = plan(route, limits, PERIOD), plan(fast, scaled, PERIOD)
    np.testing.assert_allclose(quick.duration * factor, slow.duration, rtol=1e-9)


@few
@given(routes(), st.floats(1.0, 4.0))
def test_more_jerk_never_takes_longer(case: tuple[Route, AxisLimits], factor: float) -> None:
    route, limits = case
    more = AxisLimits(limits.velocity, limits.acceleration, limits.jerk * factor)
    assert plan(route, more, PERIOD).duration <= plan(route, limits, PERIOD).duration * (1 + 1e-12)


@few
@given(routes(), st.data())
def test_blocks_are_slices_of_the_whole(case: tuple[Route, AxisLimits], data: st.DataObject) -> None:
    reference = plan(*case, PERIOD)
    start = data.draw(st.integers(0, reference.n_sample))
    stop = data.draw(st.integers(start, reference.n_sample))
    for part, whole in zip(reference.block(start, stop), reference.block(0, reference.n_sample), strict=True):
        np.testing.assert_array_equal(part, whole[start:stop])


@st.composite
def tangent_chains(draw: st.DrawFn) -> Path:
    """Lines and arcs that meet without a corner."""
    place, heading = np.zeros(2), draw(st.floats(0.0, 2 * np.pi))
    curves: list[Line | Arc] = []
    turns = st.one_of(st.just(0.0), st.floats(-3.0, 3.0).filter(lambda x: abs(x) > 0.05))
    for turn in draw(st.lists(turns, min_size=1, max_size=6)):
        size = draw(st.floats(1e-3, 0.05))
        along, left = np.array([np.cos(heading), np.sin(heading)]), np.array([-np.sin(heading), np.cos(heading)])
        if turn == 0.0:
            curves.append(Line(place, place + size * along))
            place = place + size * along
            continue
        side = np.sign(turn)
        centre = place + side * size * left
        start = np.arctan2(*(place - centre)[::-1])
        curves.append(Arc(centre, size, float(start), turn))
        heading += turn
        place = centre + size * np.array([np.cos(start + turn), np.sin(start + turn)])
    return Path(tuple(curves))


two = st.lists(st.floats(0.2, 5.0), min_size=2, max_size=2)


@few
@given(tangent_chains(), st.floats(0.01, 0.5), two, two, st.floats(10.0, 1000.0))
def test_chains_of_lines_and_arcs_break_no_limit(
    path: Path, feedrate: float, velocity: list[float], acceleration: list[float], jerk: float
) -> None:
    limits = AxisLimits(velocity, acceleration, [jerk, jerk])
    reference = plan(route_from_path(path, feedrate), limits, PERIOD)
    profile, last = reference.profile, durations(reference)
    assert profile is not None
    time = (profile.t0[:, None] + last[:, None] * np.linspace(1e-4, 1 - 1e-4, 15)).ravel()
    motion = profile.motion(time)
    _, t, k, c = path.derivatives(motion.arc_length, 3)
    v, a, j = (part[:, None] for part in motion[1:])
    assert np.max(v) <= feedrate * (1 + 1e-12)
    assert np.all(np.abs(t * v) <= limits.velocity * 1.001)
    assert np.all(np.abs(t * a + k * v**2) <= limits.acceleration * 1.001)
    assert np.all(np.abs(t * j + 3 * k * v * a + c * v**3) <= limits.jerk * 1.001)
    # Never at rest on the way: every joint is smooth.
    assert np.all(profile.v0[1:] > 0.0)
    assert limit_report(reference, limits).ok()


shapes = st.tuples(st.floats(0.1, 50.0), st.floats(1.0, 1e4), st.floats(0.05, 1.0))


@few
@given(st.floats(0.0, 1.0), st.floats(0.0, 1.0), st.floats(1e-6, 1.0), shapes)
def test_a_ramp_to_the_reachable_speed_fits(low: float, more: float, room: float, shape: tuple[float, float, float]) -> None:
    acceleration, rise, part = shape
    high = reachable_speed(low, low + more, room, acceleration, rise, rise * part)
    assert low <= high <= low + more
    assert ramp_distance(low, high, acceleration, rise, rise * part) <= room
