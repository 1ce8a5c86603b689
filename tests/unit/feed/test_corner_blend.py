"""A corner is rounded only if that is faster than a stop."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from contourlab.feed import AxisLimits, Route, blended, route_from_path
from contourlab.feed.planner import plan_profile
from contourlab.geometry import Line, Path

FEED = 0.05


def route(points: np.ndarray, tolerance: float, feedrate: float = FEED) -> Route:
    exact = route_from_path(Path(Line.many(points[:-1], points[1:])), feedrate)
    return dataclasses.replace(exact, corner_tolerance=np.full(exact.n_curve, tolerance))


def times(given: Route, limits: AxisLimits) -> tuple[float, float, float]:
    """Return the times with a stop at every corner, with the chosen corners rounded, and with all corners rounded [s]."""
    return (
        plan_profile(given, limits).duration,
        plan_profile(blended(given, limits), limits).duration,
        plan_profile(blended(given), limits).duration,
    )


def square(side: float) -> np.ndarray:
    return side * np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]])


@pytest.mark.parametrize("side", [1e-3, 5e-3, 20e-3, 100e-3])
@pytest.mark.parametrize("tolerance", [1e-6, 10e-6, 50e-6, 200e-6, 500e-6])
def test_a_tolerance_never_costs_time_on_a_square(side: float, tolerance: float) -> None:
    limits = AxisLimits(0.2, 1.5, 40.0)
    exact, chosen, rounded = times(route(square(side), tolerance), limits)
    assert chosen <= min(exact, rounded) * (1.0 + 1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("turn", [90.0, 120.0, 150.0, 170.0])
@pytest.mark.parametrize("jerk", [40.0, 1000.0, np.inf])
@pytest.mark.parametrize("tolerance", [10e-6, 100e-6])
def test_the_faster_option_is_taken_along_a_zigzag(turn: float, jerk: float, tolerance: float) -> None:
    half, i = np.radians(turn / 2.0), np.arange(21)
    points = 2e-3 * np.column_stack([i * np.cos(half), (i % 2) * np.sin(half)])
    exact, chosen, rounded = times(route(points, tolerance), AxisLimits(0.2, 2.0, jerk))
    assert chosen <= min(exact, rounded) * 1.005


def test_both_options_occur() -> None:
    """With 40 m/s^3, moving slowly around 10 um takes longer than a stop; with 40 000 m/s^3 it does not."""
    given = route(square(20e-3), 10e-6)
    slow, quick = AxisLimits(0.2, 1.5, 40.0), AxisLimits(0.2, 1.5, 40e3)
    assert blended(given, slow).n_curve == 4 and blended(given, quick).n_curve == 7
    exact, _, rounded = times(given, slow)
    assert rounded > 1.02 * exact
    exact, _, rounded = times(given, quick)
    assert rounded < exact


def test_each_corner_is_decided_separately() -> None:
    """A blunt corner and a right one, at one tolerance."""
    points = 0.02 * np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 0.02], [2.0, 1.0]])
    found = blended(route(points, 30e-6), AxisLimits(0.2, 1.5, 40.0))
    assert found.n_curve == 4
    np.testing.assert_allclose(found.path.corners, [found.path.breaks[3]], rtol=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(30))
def test_random_polylines_lose_almost_nothing_by_their_tolerance(seed: int) -> None:
    """The choice assumes that a corner's neighbours are like it, so it may be slightly wrong."""
    rng = np.random.default_rng(seed)
    n = int(rng.integers(2, 30))
    steps = rng.normal(size=(n + 1, 2)) * 10.0 ** rng.uniform(-5.0, -1.0) * 10.0 ** rng.uniform(0.0, 1.0, size=(n + 1, 1))
    limits = AxisLimits(0.2, 10.0 ** rng.uniform(-0.3, 1.0), 10.0 ** rng.uniform(1.3, 4.0))
    exact, chosen, rounded = times(
        route(np.cumsum(steps, axis=0), 10.0 ** rng.uniform(-6.0, -3.5), 10.0 ** rng.uniform(-2.5, -0.5)), limits
    )
    assert chosen <= 1.02 * exact
    assert chosen <= 1.1 * rounded  # 1.06 is the worst found


def test_absent_limits() -> None:
    """An axis without jerk or acceleration limit, or one that a curve does not move, sets no limit."""
    given = route(square(20e-3), 10e-6)
    assert blended(given, AxisLimits(0.2, 1.5)).n_curve == 7
    assert blended(given, AxisLimits(0.2, np.inf, 40.0)).n_curve == 4
    assert blended(given, AxisLimits(0.2, np.inf, np.inf)).n_curve in (4, 7)
