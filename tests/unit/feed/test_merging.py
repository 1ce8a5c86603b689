"""Short lines merged: every merged line against brute force over its points, and the conditions that keep lines apart."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from contourlab.feed import Route, blended
from contourlab.feed.blending import merged
from contourlab.geometry import Arc, Curve, Line, Path

Array = NDArray[np.float64]
Q = 1e-5


def route(points: Array, tolerance: Any = Q, **more: Any) -> Route:
    p = np.asarray(points, dtype=float)
    says = {"feedrate": 0.05, "rapid": False, "dwell": 0.0, "source_line": np.arange(1, len(p))} | more
    return Route(Path(Line.many(p[:-1], p[1:])), merge_tolerance=tolerance, **says)


def holds(points: Array, tolerance: float) -> bool:
    """Return whether the line from the first to the last point passes all between within the tolerance and in order; from scratch."""
    chord = points[-1] - points[0]
    length = float(np.linalg.norm(chord))
    if length == 0.0:
        return False
    along = (points - points[0]) @ chord / length
    off = np.linalg.norm(points - points[0] - along[:, None] * chord / length, axis=1)
    return bool(off.max() <= tolerance and (np.diff(along) > 0.0).all())


def runs(points: Array, found: Route) -> list[Array]:
    """Return the points that each line of a merged route replaces, from its ends alone."""
    ends = [0, *(int(np.flatnonzero((points == c.end).all(axis=1))[0]) for c in found.path.curves if isinstance(c, Line))]
    return [points[a : b + 1] for a, b in pairwise(ends)]


def greedy(points: Array, tolerance: float) -> int:
    """Return the number of lines of the simple method: extend while the line to the next point holds. Quadratic cost."""
    n, first, count = len(points) - 1, 0, 0
    while first < n:
        last = first + 1
        while last < n and holds(points[first : last + 2], tolerance):
            last += 1
        first, count = last, count + 1
    return count


def circle(n: int, radius: float = 0.02, n_axis: int = 2) -> Array:
    turn = np.linspace(0.0, 2.0 * math.pi, n + 1)
    return np.column_stack([radius * np.cos(turn), radius * np.sin(turn), 0.01 * turn][:n_axis])


def noisy(n: int, n_axis: int, size: float, seed: int = 3) -> Array:
    x = np.linspace(0.0, 0.1, n + 1)
    sway = size * np.random.default_rng(seed).uniform(-1.0, 1.0, (n + 1, n_axis - 1))
    return np.column_stack([x, sway + 0.01 * np.sin(30.0 * x)[:, None]])


@pytest.mark.parametrize("points", [circle(1500), circle(1500, n_axis=3), noisy(1000, 2, 3e-6), noisy(1000, 3, 3e-6)])
def test_every_omitted_point_is_within_the_tolerance_and_in_order(points: Array) -> None:
    found = merged(route(points))
    replaced = runs(points, found)
    assert len(replaced) == found.n_curve < 0.2 * len(points)
    for run in replaced:
        assert len(run) == 2 or holds(run, Q)


@pytest.mark.parametrize("points", [circle(900), noisy(700, 2, 3e-6), noisy(700, 2, 2e-5)])
def test_in_the_plane_merging_is_as_good_as_the_simple_method(points: Array) -> None:
    # The cones of a plane are sectors, and so is their intersection: the method equals the simple one at less cost.
    assert merged(route(points)).n_curve == greedy(points, Q)


@pytest.mark.parametrize("points", [circle(900, n_axis=3), noisy(700, 3, 3e-6), noisy(700, 3, 2e-5)])
def test_in_space_merging_needs_few_more_lines(points: Array) -> None:
    plain = greedy(points, Q)
    assert plain <= merged(route(points)).n_curve <= 1.6 * plain + 1


def test_a_fine_polygon_becomes_the_coarsest_within_its_sagitta() -> None:
    # A chord of angle a lies r (1 - cos(a/2)) off its circle; the tolerance permits a = 2 acos(1 - Q/r).
    n, radius = 2000, 0.02
    steps = math.floor(2.0 * math.acos(1.0 - Q / radius) / (2.0 * math.pi / n))
    assert merged(route(circle(n))).n_curve == math.ceil(n / steps)


def test_points_on_a_line_become_one_line() -> None:
    x = np.array([0.0, 1.0, 1.5, 2.0, 7.0, 7.25])
    found = merged(route(np.column_stack([x, 2.0 * x]), 1e-9))
    assert found.n_curve == 1
    assert found.path.curves[0].describe() == Line((0.0, 0.0), (7.25, 14.5)).describe()
    np.testing.assert_allclose(found.programmed_arc_length([0.0, found.path.length]), [0.0, found.programmed.length], rtol=1e-15)


def test_a_line_that_turns_back_is_kept_even_if_near() -> None:
    # All points are within the tolerance of one line, but their order along it changes.
    points = np.array([(0.0, 0.0), (1.0, 0.0), (0.999, 1e-6), (2.0, 0.0)])
    found = merged(route(points, 1e-3))
    np.testing.assert_allclose(found.path.breaks, np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))]))


@pytest.mark.parametrize(
    ("more", "lines"),
    [
        ({}, [1]),
        ({"feedrate": [0.1, 0.1, 0.2, 0.2, 0.2, 0.2]}, [1, 3]),
        ({"dwell": [0, 0, 0, 0.5, 0, 0]}, [1, 5]),
        ({"exact_stop": [0, 1, 0, 0, 0, 0]}, [1, 3]),
        ({"corner_tolerance": [0, 0, 0, 0, 1e-5, 1e-5]}, [1, 5]),
        ({"rapid": [0, 0, 1, 1, 0, 0]}, [1, 3, 4, 5]),
        ({"tolerance": [Q, Q, Q, 0, 0, Q]}, [1, 4, 5, 6]),
        ({"tolerance": 0.0}, [1, 2, 3, 4, 5, 6]),
    ],
)
def test_lines_with_different_settings_are_kept_apart(more: Any, lines: list[int]) -> None:
    points = np.column_stack([np.arange(7.0), np.zeros(7)])
    found = merged(route(points, **more))
    np.testing.assert_allclose(found.programmed_arc_length(found.path.breaks[:-1]), np.subtract(lines, 1.0))
    given = route(points, **more)
    assert found.dwell.sum() == given.dwell.sum()
    for i, line in enumerate(lines):
        assert found.feedrate[i] == given.feedrate[line - 1]
        assert found.rapid[i] == given.rapid[line - 1]


def test_an_arc_is_kept_and_the_lines_on_either_side_merge() -> None:
    curves: list[Curve] = [Line((0, 0), (1, 0)), Line((1, 0), (2, 0)), Arc((2, 1), 1.0, -math.pi / 2, math.pi)]
    curves += [Line((2, 2), (1, 2)), Line((1, 2), (0, 2))]
    given = Route(Path(curves), 0.05, False, 0.0, np.arange(1, 6), merge_tolerance=Q)
    found = merged(given)
    assert [type(c) for c in found.path.curves] == [Line, Arc, Line]
    assert found.path.curves[1].describe() == curves[2].describe()
    assert found.line_breaks.tolist() == given.path.breaks.tolist()
    np.testing.assert_allclose(found.programmed_arc_length([0.5, 2.5, found.path.length]), [0.5, 2.5, given.path.length])


@pytest.mark.parametrize("n_axis", [2, 3])
def test_merging_and_rounding_stay_within_the_sum_of_their_tolerances(n_axis: int) -> None:
    points = noisy(600, n_axis, 4e-6)
    points[300:] += np.linspace(0.0, 0.03, 301)[:, None] ** 1.0 * np.eye(n_axis)[1]
    given = route(points, 1e-5, corner_tolerance=2e-5)
    found = blended(given)
    assert found.path.corners.size == 0
    assert found.n_curve < 0.5 * given.n_curve
    s = np.linspace(0.0, found.path.length, 20_001)
    places = found.path.position(s)
    # By brute force over the lines nearby in the order of travel.
    at = given.path.curve_index(found.programmed_arc_length(s))
    away = np.full(len(s), np.inf)
    for k in range(-3, 4):
        i = np.clip(at + k, 0, 599)
        along = points[i + 1] - points[i]
        share = np.clip(((places - points[i]) * along).sum(axis=1) / (along**2).sum(axis=1), 0.0, 1.0)
        away = np.minimum(away, np.linalg.norm(places - points[i] - share[:, None] * along, axis=1))
    assert 1e-5 < away.max() <= 3e-5
    assert (np.diff(found.programmed_arc_length(s)) > 0.0).all()
    np.testing.assert_array_equal(found.programmed.breaks, given.path.breaks)


@pytest.mark.parametrize(("corner", "merge", "most"), [(2e-5, 2e-5, 2e-5), (2e-5, 5e-6, 2e-5), (2e-5, 6e-5, 7e-5)])
@pytest.mark.parametrize("n_axis", [2, 3])
def test_merging_and_rounding_share_one_tolerance(corner: float, merge: float, most: float, n_axis: int) -> None:
    rng = np.random.default_rng(n_axis)
    # Short lines along a curve with corners, and noise of the size of the tolerances.
    smooth = circle(800, 0.01, n_axis)[:, :n_axis] * np.where(np.arange(801)[:, None] // 100 % 2, 1.0, 1.05)
    points = smooth + rng.normal(0.0, 0.4 * corner, smooth.shape)
    given = route(points, merge, corner_tolerance=corner)
    found = blended(given)
    assert merged(given).n_curve < given.n_curve
    s = np.linspace(0.0, found.path.length, 40_001)
    place = found.path.position(s)
    foot = given.path.foot_point(place, found.programmed_arc_length(s), 20.0 * merge + 1e-3)
    assert foot.distance.max() <= most * (1.0 + 1e-9)
    # The tolerance is actually used.
    assert foot.distance.max() > 0.4 * corner
