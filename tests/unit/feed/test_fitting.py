"""Curves behind chopped lines: circles in closed form, corners and slots, invariances, and what is left as it is."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from chopped import excess
from numpy.typing import NDArray

from contourlab.feed import AxisLimits, Route, blended, plan
from contourlab.feed.fitting import Quintics, fitted, replaced
from contourlab.feed.planner import plan_profile
from contourlab.geometry import Arc, Line, Path
from contourlab.geometry.blend import Blend, quintic_bezier

Array = NDArray[np.float64]
LIMITS = AxisLimits(0.2, 1.5, 40.0)
P = 2e-5
TANGENT = Path([Line((0, 0), (1, 0)), Arc((1, 1), 1.0, -math.pi / 2, math.pi), Line((1, 2), (0, 2))])


def route(points: Array, tolerance: float = P, **more: Any) -> Route:
    """Return a route along lines between points, with equal tolerances for corners and merging."""
    settings = {"feedrate": 0.15, "rapid": False, "dwell": 0.0, "source_line": np.arange(1, len(points)), "merge_tolerance": tolerance}
    return Route(Path(Line.many(points[:-1], points[1:])), corner_tolerance=tolerance, **(settings | more))


def circle(n: int, radius: float = 5e-3, sweep: float = 2.0 * math.pi) -> Array:
    """Return points on a circle with coordinates of four decimals [mm]."""
    angle = np.linspace(0.0, sweep, n + 1)
    return np.round(radius * np.column_stack([np.cos(angle), np.sin(angle)]), 7)


def wave(n: int = 300, n_axis: int = 2) -> Array:
    x = np.linspace(0.0, 0.04, n + 1)
    return np.column_stack([x, 3e-3 * np.sin(300.0 * x), 2e-3 * np.cos(170.0 * x)])[:, :n_axis]


def duration(given: Route) -> float:
    return float(plan_profile(blended(given, LIMITS), LIMITS).duration)


@pytest.mark.parametrize("tolerance", [2e-5, 1e-4])
def test_a_chopped_circle_takes_the_time_of_the_arc_and_denser_is_not_slower(tolerance: float) -> None:
    arc = Route(Path([Arc((0.0, 0.0), 5e-3, 0.0, 2.0 * math.pi)]), 0.15, False, 0.0, 1)
    times = np.array([duration(route(circle(n), tolerance)) for n in (36, 72, 360, 720, 3600)]) / duration(arc)
    assert (times < 1.05).all()
    # The motion takes a whole number of time steps: A/J/4 is 2 % of the arc's time.
    assert (times[1:] <= times[:-1] + 0.02).all()


@pytest.mark.parametrize("n", [36, 300])
def test_a_chopped_circle_becomes_a_circle_between_vertices_and_chords(n: int) -> None:
    found = blended(route(circle(n)))
    assert {type(curve) for curve in found.path.curves} == {Blend}
    radius = np.linalg.norm(found.path.position(np.linspace(0.0, found.path.length, 2001)), axis=1)
    sagitta = 5e-3 * (1.0 - math.cos(math.pi / n))
    assert np.abs(radius - 5e-3).max() < max(sagitta, 0.5 * P)
    bend = np.linalg.norm(found.path.derivatives(np.linspace(0.1, 0.9, 2001) * found.path.length, 2)[2], axis=1)
    np.testing.assert_allclose(bend, 1.0 / 5e-3, rtol=0.02)


def test_where_p_forbids_the_arc_the_lines_stay() -> None:
    # The arc through the ends of a chord bulges by 76 um, a curve between chords and vertices by half of it.
    given = route(circle(18))
    assert fitted(given) is given


def test_position_direction_and_curvature_do_not_jump() -> None:
    found = fitted(route(wave(n_axis=3)))
    path, n = found.path, found.n_curve
    before, after = path.at(np.arange(n - 1), np.diff(path.breaks)[:-1], 2), path.at(np.arange(1, n), np.zeros(n - 1), 2)
    np.testing.assert_allclose(before[:2], after[:2], rtol=0.0, atol=1e-12)
    np.testing.assert_allclose(before[2], after[2], rtol=0.0, atol=1e-6 * np.abs(before[2]).max())


def test_the_ends_of_cuts_are_exact_and_stops_stay_where_they_are() -> None:
    points = wave()
    given = route(points, dwell=np.where(np.arange(300) == 120, 0.5, 0.0), exact_stop=np.arange(300) == 210)
    found = blended(given)
    for k in (np.flatnonzero(found.dwell == 0.5), np.flatnonzero(found.exact_stop)):
        assert k.size == 1
    at = np.flatnonzero((found.dwell > 0.0) | found.exact_stop)
    np.testing.assert_allclose(found.path.ends[0][at], points[[121, 211]], rtol=0.0, atol=1e-15)
    np.testing.assert_allclose(found.path.position([0.0, found.path.length]), points[[0, -1]], rtol=0.0, atol=1e-15)
    assert found.dwell.sum() == 0.5


def test_real_corners_are_blended_between_lines() -> None:
    # Two waves that meet at 90 degrees, in chords so long that an arc over the corner would leave the tolerance.
    first = wave(150)
    points = np.concatenate([first, first[-1] + (first[1:] - first[0]) @ np.array([[0.0, 1.0], [-1.0, 0.0]])])
    found = blended(route(points))
    near = np.linalg.norm(found.path.starts[0] - first[-1], axis=1) < 2e-4
    kinds = [type(curve) for curve, here in zip(found.path.curves, near, strict=True) if here]
    assert kinds[:3] == [Line, Blend, Line] or kinds[:2] == [Blend, Line]
    assert not found.path.corners.size
    assert excess(found.path, route(points).path, P) <= 1.0 + 1e-6


def test_merging_leaves_no_corner_beside_a_fitted_curve() -> None:
    first = wave()
    along = (first[-1] - first[-2]) / np.linalg.norm(first[-1] - first[-2])
    line = first[-1] + 1.2e-2 * np.arange(1, 5)[:, None] * along
    aside = line[-1] + 3e-4 * (along + 0.1 * np.array([-along[1], along[0]]))
    found = blended(route(np.vstack([first, line, aside]), 1e-4))
    assert not found.path.corners.size


@pytest.mark.parametrize("width", [5e-6, 1.5e-5, 6e-5])
def test_a_narrow_slot_is_cut_to_its_end(width: float) -> None:
    x = np.linspace(0.0, 1e-3, 51)
    slot = np.concatenate([np.column_stack([x, 0.0 * x]), np.column_stack([x[::-1], 0.0 * x + width])])
    points = np.concatenate([slot - [1e-3, 0.0], [[-1e-3, 1e-3 + width]]])
    found = blended(route(points))
    assert excess(found.path, route(points).path, P) <= 1.0 + 1e-6
    assert found.path.position(np.linspace(0.0, found.path.length, 4001))[:, 0].max() > -P


def test_moved_turned_and_reversed_the_plan_is_the_same() -> None:
    points = wave(n_axis=3)
    given = duration(route(points))
    assert duration(route(points + np.array([0.3, -0.2, 0.1]))) == pytest.approx(given, rel=1e-6)
    assert duration(route(points[:, [1, 2, 0]] * [1.0, -1.0, 1.0])) == pytest.approx(given, rel=1e-9)
    assert duration(route(points[::-1])) == pytest.approx(given, rel=0.01)


def test_lines_split_in_halves_take_no_longer() -> None:
    points = wave()
    halves = np.empty((601, 2))
    halves[::2], halves[1::2] = points, 0.5 * (points[1:] + points[:-1])
    assert duration(route(halves)) < 1.01 * duration(route(points))


def test_a_change_of_feed_stays_at_its_line() -> None:
    points = wave()
    found = blended(route(points, feedrate=np.where(np.arange(300) < 100, 0.02, 0.01)))
    change = np.flatnonzero(np.diff(found.feedrate))
    assert change.size == 1
    np.testing.assert_allclose(found.path.ends[0][change], points[100][None], rtol=0.0, atol=P)


def test_short_arcs_are_fitted_too() -> None:
    points, curves = circle(60), []
    for k in range(60):
        a, b = points[k], points[k + 1]
        curves.append(
            Line(a, b) if k % 2 else Arc.through(a, b, 0.5 * (a + b) + 8.0 * np.array([a[1] - b[1], b[0] - a[0]]), 0.125, *np.eye(2))
        )
    given = replace(route(points), path=Path(curves), programmed=Path(curves))
    found = blended(given)
    assert {type(curve) for curve in found.path.curves} == {Blend}
    assert excess(found.path, given.path, P) <= 1.0 + 1e-6


@pytest.mark.parametrize(
    "given",
    [
        route(circle(72), merge_tolerance=0.0),
        route(circle(72), 0.0),
        route(circle(72), rapid=True, feedrate=math.inf),
        route(circle(72), exact_stop=True),
        route(np.array([(0.0, 0.0), (0.01, 0.0), (0.01, 0.01), (0.02, 0.01)])),
        route(np.column_stack([np.arange(50.0), np.zeros(50)])),
        replace(
            route(wave(3)),
            path=Path([Line((0, 0), (1, 0)), Arc((1, 1), 1.0, -math.pi / 2, math.pi), Line((1, 2), (0, 2))]),
            programmed=None,
        ),
    ],
    ids=["Q0", "P0", "rapid", "exact stop", "corners", "straight", "tangent"],
)
def test_what_is_no_chopped_curve_stays(given: Route) -> None:
    assert fitted(given) is given


def test_the_map_to_the_programmed_path_rises_from_end_to_end() -> None:
    found = fitted(route(wave(n_axis=3)))
    assert found.correspondence is not None
    assert (np.diff(found.correspondence.programmed) > 0.0).all()
    s = np.linspace(0.0, found.path.length, 4001)
    away = np.linalg.norm(found.path.position(s) - found.programmed.position(found.programmed_arc_length(s)), axis=1)
    assert away.max() < 1.5 * P


def test_a_stop_is_at_the_end_of_a_divided_quintic() -> None:
    given = route(np.array([(0.0, 0.0), (0.01, 0.0), (0.02, 0.001)]), dwell=[0.0, 0.5], exact_stop=[False, True])
    # So uneven that its arc length needs several parts.
    points = np.array([[(0.005, 0.0), (0.00501, 0.0), (0.00502, 0.0), (0.0199, 0.001), (0.01999, 0.001), (0.02, 0.001)]])
    start, end = given.path.starts[0], given.path.ends[0].copy()
    end[0] = points[0, 0]
    pieces = Quintics(quintic_bezier(points), np.array([0.005]), given.path.breaks[2:], np.array([0]), np.array([1]))
    found = replaced(given, pieces, np.zeros(2), np.array([0.005, 0.0]), start, end)
    assert found.n_curve > 2
    assert found.dwell.tolist() == [*[0.0] * (found.n_curve - 1), 0.5]
    assert np.flatnonzero(found.exact_stop).tolist() == [found.n_curve - 1]


def test_samples_have_the_line_of_their_place_on_the_programmed_path() -> None:
    # A wave with a dwell, a corner, short lines that merge, a rapid, and a wave again.
    first, jog = wave(), np.column_stack([np.linspace(0.0, -0.02, 41), np.linspace(0.0, 0.001, 41)])
    points = np.concatenate([first, first[-1] + jog[1:], first[-1] + jog[-1] + [[-0.01, 0.02]], first + np.array([0.0, 0.03])])
    n = len(points) - 1
    rapid, dwell = (np.arange(n) == k for k in (340, 120))
    lines = 10 + 3 * np.arange(n)
    given = route(points, rapid=rapid, feedrate=np.where(rapid, math.inf, 0.15), dwell=0.1 * dwell, source_line=lines)
    found = blended(given, LIMITS)
    assert {type(curve) for curve in found.path.curves} == {Blend, Line}
    reference = plan(found, LIMITS, 1e-3)
    block = reference.block(0, reference.n_sample)
    at = reference.programmed_arc_length(block.arc_length)
    got = np.searchsorted(lines, reference.source_line(block.arc_length))
    # Every programmed curve, from its start to its end by arc length, rounding aside.
    begin, end = given.path.breaks[got], given.path.breaks[got + 1]
    assert ((begin - 1e-12 <= at) & (at <= end + 1e-12)).all()
    assert set(got.tolist()) >= set(range(0, 300, 10)) | {339, 340, 641}
    # At rest, the line that comes next.
    resting = np.flatnonzero(block.feedrate == 0.0)[1:-1]
    assert np.count_nonzero(got[resting] == 121) >= 99
