"""Curved segments, short and long: limits, stops, time, and cost independent of the rest of the program."""

from __future__ import annotations

import dataclasses
import time
import tracemalloc
from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest

from contourlab.feed import AxisLimits, Reference, Route, blended, limit_report, plan, route_from_path
from contourlab.feed.planner import plan_profile
from contourlab.geometry import Arc, Line, Path, contour

Demand = Callable[..., tuple[float, float, float]]
LIMITS = AxisLimits([0.5, 0.5], 2.0, 40.0)


def fillets(n: int, seed: int = 1, segment: float = 5e-4) -> Path:
    """Return lines at random angles, joined by small arcs."""
    generator = np.random.default_rng(seed)
    place, heading, curves = np.zeros(2), 0.0, []
    for _ in range(n):
        along = np.array([np.cos(heading), np.sin(heading)])
        end = place + segment * generator.uniform(0.3, 1.7) * along
        turn = float(generator.uniform(0.1, 1.0) * generator.choice([-1.0, 1.0]))
        radius = 0.3 * segment / np.tan(abs(turn) / 2.0)
        centre = end + np.sign(turn) * radius * np.array([-along[1], along[0]])
        start = float(np.arctan2(*(end - centre)[::-1]))
        curves += [Line(place, end), Arc(centre, radius, start, turn)]
        heading += turn
        place = centre + radius * np.array([np.cos(start + turn), np.sin(start + turn)])
    return Path(tuple(curves))


def lines_with_blends(n: int, seed: int = 1) -> Route:
    """Return a route of n short lines in space at random angles; each corner may be cut by 10 um."""
    generator = np.random.default_rng(seed)
    heading = np.cumsum(generator.uniform(-1.0, 1.0, n))
    step = 5e-4 * generator.uniform(0.3, 1.7, n)
    moves = np.stack([step * np.cos(heading), step * np.sin(heading), 1e-5 * generator.normal(size=n)], axis=1)
    points = np.concatenate([np.zeros((1, 3)), np.cumsum(moves, axis=0)])
    route = route_from_path(Path(tuple(Line(a, b) for a, b in pairwise(points))), 0.1)
    return blended(dataclasses.replace(route, corner_tolerance=np.full(n, 1e-5)))


def moving(reference: Reference) -> np.ndarray:
    profile = reference.profile
    assert profile is not None
    return profile.v0[1:]


@pytest.mark.parametrize("jerk", [np.inf, 1e5, 2e3, 40.0, 4.0])
@pytest.mark.parametrize("seed", [1, pytest.param(2, marks=pytest.mark.slow)])
def test_any_jerk_limit_is_respected_without_a_stop(jerk: float, seed: int, demand: Demand) -> None:
    limits = AxisLimits([0.5, 0.5], [2.0, 1.5], jerk)
    reference = plan(route_from_path(fillets(10, seed), 0.1), limits, 1e-3)
    assert max(demand(reference, limits)) <= 1.001
    assert limit_report(reference, limits).ok()
    assert np.all(moving(reference) > 0.0)


def test_more_jerk_takes_less_time() -> None:
    route = route_from_path(fillets(60), 0.1)
    times = [plan(route, AxisLimits([0.5, 0.5], 2.0, jerk), 1e-3).duration for jerk in (10.0, 40.0, 160.0, 640.0, 2560.0, np.inf)]
    assert all(slow > quick for slow, quick in pairwise(times))


def test_the_cusp_of_the_butterfly_is_respected(demand: Demand) -> None:
    limits = AxisLimits([0.5, 0.5], 1.0, 30.0)
    reference = plan(route_from_path(contour("butterfly"), 0.1), limits, 1e-3)
    assert limit_report(reference, limits).ok()
    assert max(demand(reference, limits)) <= 1.001
    block = reference.block(0, reference.n_sample)
    sharpest = float(reference.path.length) * np.linspace(0.0, 1.0, 200_001)
    bend = np.linalg.norm(reference.path.derivatives(sharpest, 2)[2], axis=1)
    at = int(np.argmin(np.abs(block.arc_length - sharpest[np.argmax(bend)])))
    # Turning alone takes at most the acceleration of both axes together.
    assert block.feedrate[at] <= np.sqrt(np.sqrt(2.0) * 1.0 / bend.max()) * 1.01
    assert block.feedrate.max() == pytest.approx(0.1, rel=1e-3)


def test_blended_corners_need_no_stop(demand: Demand) -> None:
    route, limits = lines_with_blends(150), AxisLimits([0.5] * 3, 2.0, 40.0)
    reference = plan(route, limits, 1e-3)
    assert max(demand(reference, limits)) <= 1.001
    assert limit_report(reference, limits).ok()
    stops = np.count_nonzero(reference.profile.v0 == 0.0) - 1
    assert stops <= len(route.path.corners)


def test_an_exact_stop_is_made_where_the_path_is_smooth() -> None:
    path = fillets(5)
    stop = np.zeros(len(path.curves), bool)
    stop[[2, 5]] = True
    reference = plan(dataclasses.replace(route_from_path(path, 0.1), exact_stop=stop), LIMITS, 1e-3)
    profile = reference.profile
    assert profile is not None
    for place in np.asarray(path.breaks)[[3, 6]]:
        at = int(np.argmin(np.abs(profile.s0 - place)))
        assert profile.s0[at] == pytest.approx(place, abs=1e-15)
        assert (profile.v0[at], profile.a0[at]) == (0.0, 0.0)
    assert np.count_nonzero(profile.v0 == 0.0) == 3


def test_later_curves_do_not_slow_earlier_ones() -> None:
    # Long segments are planned in parts: the first part of a long one is as fast as the same lines alone.
    long, short = fillets(2000), fillets(200)
    limits = LIMITS
    whole, part = (plan(route_from_path(path, 0.1), limits, 1e-3) for path in (long, short))
    end = 0.9 * short.length
    times = [int(np.searchsorted(r.block(0, r.n_sample).arc_length, end)) for r in (whole, part)]
    assert times[0] == pytest.approx(times[1], rel=0.05)


def test_several_segments_are_planned_as_if_alone() -> None:
    # Two routes in a row with a stop in between take the sum of their separate times.
    path = fillets(20)
    other = fillets(20, seed=7)
    shift = np.asarray(path.derivatives(np.array([path.length]), 0))[0, 0]
    moved = tuple(
        Line(c.start + shift, c.position([c.length])[0] + shift)
        if isinstance(c, Line)
        else Arc(c.centre + shift, c.radius, c.start_angle, c.sweep)
        for c in other.curves
    )
    both = Path((*path.curves, *moved))
    stop = np.zeros(len(both.curves), bool)
    stop[len(path.curves) - 1] = True
    alone = [plan(route_from_path(p, 0.1), LIMITS, 1e-3).duration for p in (path, other)]
    together = plan(dataclasses.replace(route_from_path(both, 0.1), exact_stop=stop), LIMITS, 1e-3).duration
    assert together == pytest.approx(sum(alone), rel=1e-6)


@pytest.mark.slow
def test_forty_thousand_lines_are_planned_and_sampled_in_seconds() -> None:
    limits, times = AxisLimits([0.5] * 3, 2.0, 40.0), []
    plan(lines_with_blends(200), limits, 1e-3)  # first run: loads and compiles
    for n in (5_000, 40_000):
        route, started = lines_with_blends(n), time.process_time()
        reference = plan(route, limits, 1e-3)
        times.append(time.process_time() - started)
    assert times[1] < 12.0 * times[0]  # the work grows with the number of lines
    for start in range(0, reference.n_sample, 65_536):
        reference.block(start, min(start + 65_536, reference.n_sample))
    assert time.process_time() - started < 20.0
    assert limit_report(reference, limits).ok()


def planning_memory(n_line: int) -> int:
    """Return the peak memory [bytes] for planning a route of short lines with rounded corners, without the route itself."""
    route, limits = lines_with_blends(n_line), AxisLimits([0.5] * 3, 2.0, 40.0)
    tracemalloc.start()
    try:
        plan_profile(route, limits)
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


@pytest.mark.slow
def test_a_long_program_takes_a_few_kilobytes_a_line() -> None:
    # About 22 samples per line with some 200 bytes each: three derivatives by three axes, limits, and the state of the recursions.
    planning_memory(200)  # first run: loads and compiles
    assert planning_memory(14_000) - planning_memory(10_000) < 4000 * 7000
