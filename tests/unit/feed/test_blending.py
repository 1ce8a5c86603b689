"""Corners rounded within a tolerance: closed forms, continuity, independently measured deviations, and unchanged parts."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial import KDTree

from contourlab.errors import FeedError
from contourlab.feed import AxisLimits, Reference, Route, blended, plan
from contourlab.feed.blending import shape
from contourlab.feed.route import Correspondence
from contourlab.geometry import Arc, Curve, Line, Path, contour
from contourlab.geometry.blend import Blend, blends, quintic_bezier
from contourlab.geometry.curve import CurveBatch
from contourlab.metrics.judge import judge
from contourlab.result import Result, Signal

Array = NDArray[np.float64]
P = 1e-5


def route(points: Any, tolerance: Any = P, closed: bool = False, **more: Any) -> Route:
    """Return a route along a polyline."""
    p = np.asarray(points, dtype=float)
    return on([Line(a, b) for a, b in pairwise(p)], tolerance, closed, **more)


def on(curves: list[Curve], tolerance: Any = P, closed: bool = False, **more: Any) -> Route:
    says = {"feedrate": 0.05, "rapid": False, "dwell": 0.0, "source_line": np.arange(1, len(curves) + 1)} | more
    return Route(Path(curves, closed), corner_tolerance=tolerance, **says)


def bend(turn: float, size: float = 0.01) -> Array:
    """Return two equal legs with a corner at the origin."""
    return np.array([(-size, 0.0), (0.0, 0.0), (size * math.cos(turn), size * math.sin(turn))])


def mixed(n_axis: int, n: int, seed: int, scale: float = 1e-3) -> list[Curve]:
    """Return lines, arcs and (in space) helices that meet at random corners."""
    rng = np.random.default_rng(seed)
    curves: list[Curve] = []
    at = np.zeros(n_axis)
    for k in range(n):
        frame = np.linalg.qr(rng.normal(size=(n_axis, n_axis)))[0].T
        if k % 2:
            radius, first = scale * rng.uniform(0.5, 3.0), rng.uniform(0.0, 6.0)
            centre = at - radius * (math.cos(first) * frame[0] + math.sin(first) * frame[1])
            rise = scale * rng.uniform(-1.0, 1.0) * frame[2] if n_axis == 3 and k % 4 == 3 else None
            curves.append(Arc(centre, radius, first, rng.uniform(0.4, 3.0) * rng.choice([-1.0, 1.0]), frame[0], frame[1], rise))
        else:
            curves.append(Line(at, at + scale * rng.uniform(0.5, 3.0) * frame[0]))
        at = curves[-1].position(curves[-1].length)[0]
    return curves


def deviation(planned: Path, programmed: Path, step: float, tolerance: float) -> float:
    """Return the largest distance of the planned from the programmed path, by the nearest of dense samples.

    Independent of foot points and arc lengths. The nearest sample is off by at most half a step along the path, removed by Pythagoras.
    """
    s = np.linspace(0.0, programmed.length, int(programmed.length / step) + 2)
    s = np.sort(np.concatenate([s, programmed.breaks]))
    tree = KDTree(programmed.position(s))
    each = (planned.breaks[:-1, None] + np.diff(planned.breaks)[:, None] * np.linspace(0.0, 1.0, 1001)).ravel()
    away, _ = tree.query(planned.position(each), distance_upper_bound=10.0 * tolerance)
    return float(np.sqrt(np.maximum(away**2 - (0.5 * step) ** 2, 0.0)).max())


@pytest.mark.parametrize("degrees", [5, 30, 60, 90, 120, 150, 170])
def test_the_corner_of_two_lines_in_closed_form(degrees: float) -> None:
    turn = math.radians(degrees)
    found = blended(route(bend(turn)))
    line, blend, other = found.path.curves
    assert isinstance(blend, Blend)
    b, c = (float(x[0]) for x in shape(np.array([turn])))
    reach = 16.0 * P / ((1.0 + 5.0 * b + 10.0 * c) * math.sin(0.5 * turn))
    assert 0.01 - line.length == pytest.approx(reach, rel=1e-8)
    assert 0.01 - other.length == pytest.approx(reach, rel=1e-8)
    # The middle of the blend is the tolerance away from the corner, and no point of the blend is nearer.
    away = np.linalg.norm(blend.position(np.linspace(0.0, blend.length, 2001)), axis=1)
    assert np.argmin(away) == 1000
    assert P * (1.0 - 1e-6) < away[1000] <= P
    # The middle's distance from the lines is that times the sine of half the interior angle.
    assert deviation(found.path, found.programmed, 1e-7, P) == pytest.approx(P * math.cos(0.5 * turn), rel=2e-3)


@pytest.mark.parametrize(("degrees", "most"), [(30, 1.14), (60, 1.14), (90, 1.13), (120, 1.09), (150, 1.08)])
def test_the_curvature_of_a_blend_is_near_the_minimum_for_its_deviation(degrees: float, most: float) -> None:
    turn = math.radians(degrees)
    blend = blended(route(bend(turn))).path.curves[1]
    # No curve that rounds the corner within d bends less than the circle: its radius is d/(1/cos(turn/2) - 1).
    circle = (1.0 / math.cos(0.5 * turn) - 1.0) / P
    at = blend.derivatives(np.linspace(0.0, blend.length, 4001))
    peak = np.linalg.norm(at[2], axis=1).max()
    assert 1.0 < peak / circle < most
    # Jerk: a curvature that rises from zero to its peak and falls again needs at least the slope of a tent over the length.
    assert np.linalg.norm(at[3], axis=1).max() < 2.6 * peak / (0.5 * blend.length)


@pytest.mark.parametrize("degrees", [20.0, 75.0, 90.0, 135.0])
def test_no_other_blend_shape_is_faster_for_both_limits(degrees: float) -> None:
    """The speed losses against the best shapes for acceleration and for jerk are equal: any other shape loses more in one."""
    turn = math.radians(degrees)
    t, u = np.array([1.0, 0.0]), np.array([math.cos(turn), math.sin(turn)])
    b, c = (float(x[0]) for x in shape(np.array([turn])))

    def speeds(b: float, c: float) -> tuple[float, float]:
        size = 16.0 / ((1.0 + 5.0 * b + 10.0 * c) * math.sin(0.5 * turn))
        curve = Path(blends(quintic_bezier([size * np.array([-t, -b * t, -c * t, c * u, b * u, u])]))[0])
        at = curve.derivatives(np.linspace(0.0, curve.length, 801))
        return float(np.linalg.norm(at[2], axis=1).max() ** -0.5), float(np.linalg.norm(at[3], axis=1).max() ** (-1.0 / 3.0))

    mine = speeds(b, c)
    for db, dc in [(0.03, 0.0), (-0.03, 0.0), (0.0, 0.03), (0.0, -0.03), (0.03, 0.03), (-0.03, -0.03), (0.03, -0.03), (-0.03, 0.03)]:
        other = speeds(b + db, c + dc)
        assert min(other[0] / mine[0], other[1] / mine[1]) < 1.004


@pytest.mark.parametrize("n_axis", [2, 3])
@pytest.mark.parametrize("tolerance", [2e-6, 1e-4])
def test_the_deviation_is_within_the_tolerance(n_axis: int, tolerance: float) -> None:
    given = on(mixed(n_axis, 24, 11), tolerance)
    found = blended(given)
    assert sum(isinstance(c, Blend) for c in found.path.curves) > 18
    assert deviation(found.path, given.path, 5e-7, tolerance) <= tolerance
    # No corner is further from the path, and with enough room each corner uses its whole tolerance.
    near, _ = KDTree(found.path.position(np.linspace(0.0, found.path.length, 400_001))).query(given.path.position(given.path.breaks[1:-1]))
    assert near.max() <= tolerance * 1.001
    if tolerance < 1e-5:
        assert np.median(near) > 0.9 * tolerance


def test_the_ends_of_the_path_are_exact() -> None:
    given = on(mixed(3, 20, 5), 1e-4)
    found = blended(given)
    for at in (0, -1):
        ends = [path.position([0.0, path.length])[at] for path in (given.path, found.path)]
        np.testing.assert_allclose(ends[1], ends[0], rtol=0, atol=1e-17 if at == 0 else 1e-15)
    lines = blended(route(np.random.default_rng(1).normal(size=(9, 3)), 0.1))
    first, last = lines.path.curves[0], lines.path.curves[-1]
    assert isinstance(first, Line)
    assert isinstance(last, Line)
    np.testing.assert_array_equal([first.start, last.end], np.random.default_rng(1).normal(size=(9, 3))[[0, -1]])


def test_two_blends_share_a_short_line_and_a_single_one_takes_nearly_all() -> None:
    points = [(0.0, 0.0), (1.0, 0.0), (1.0, 1e-3), (2.0, 1e-3)]
    found = blended(route(points, 1.0))
    # The two blends use up the short middle line, half each.
    assert [type(c) for c in found.path.curves] == [Line, Blend, Blend, Line]
    np.testing.assert_allclose(found.path.curves[1].position([found.path.curves[1].length])[0], (1.0, 5e-4), rtol=0, atol=1e-15)
    alone = blended(route(points[:3], 1.0))
    assert alone.path.curves[2].length == pytest.approx(1e-5, rel=1e-6)
    # A blend that almost reaches the middle leaves no sliver there.
    b, c = (float(x[0]) for x in shape(np.array([0.5 * math.pi])))
    just = 0.4999e-3 * (1.0 + 5.0 * b + 10.0 * c) * math.sin(0.25 * math.pi) / 16.0
    assert blended(route(points, just)).path.curves[2].length >= 0.999e-5


def test_corners_without_tolerance_are_kept() -> None:
    zigzag = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (2.0, 1.0), (2.0, 2.0)]) * 1e-2
    assert len(blended(route(zigzag)).path.corners) == 0
    for keep in (
        {"tolerance": [P, 0.0, P, P]},
        {"dwell": [0.0, 0.5, 0.0, 0.0]},
        {"exact_stop": [False, True, False, False]},
    ):
        found = blended(route(zigzag, **({"tolerance": P} | keep)))
        np.testing.assert_allclose(found.programmed_arc_length(found.path.corners), [0.02], rtol=1e-12)
        assert found.n_curve == 6
        (at,) = np.flatnonzero(np.isclose(found.path.breaks[1:], found.path.corners[0]))
        assert found.dwell[at] == np.max(keep.get("dwell", 0.0))
        assert found.exact_stop.sum() == ("exact_stop" in keep)
    back = route([(0.0, 0.0), (0.01, 0.0), (0.002, 0.0), (0.002, 0.01)])
    assert blended(back).path.corners.tolist() == [0.01]
    nothing = route(zigzag, 0.0)
    assert blended(nothing) is nothing
    straight = route([(0.0, 0.0), (0.01, 0.0), (0.02, 0.0)])
    assert blended(straight) is straight


def test_feedrates_rapids_and_lines_of_the_program() -> None:
    zigzag = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (2.0, 1.0), (2.0, 2.0), (3.0, 2.0)]) * 1e-2
    found = blended(
        route(zigzag, feedrate=[0.1, 0.05, np.inf, np.inf, 0.2], rapid=[False, False, True, True, False], source_line=[3, 4, 6, 7, 9])
    )
    # Each half of a blend has the feedrate of its side of the corner; between two rapids there is no feedrate to split.
    # Between a rapid and a feed move the corner is kept.
    np.testing.assert_array_equal(found.feedrate, [0.1, 0.1, 0.05, 0.05, np.inf, np.inf, np.inf, 0.2])
    np.testing.assert_array_equal(found.rapid, [False] * 4 + [True] * 3 + [False])
    np.testing.assert_array_equal(found.source_line, [3, 4, 6, 7, 9])
    np.testing.assert_allclose(found.programmed_arc_length(found.line_breaks[1:-1]), found.programmed.breaks[1:-1], rtol=1e-15)
    np.testing.assert_allclose(found.programmed_arc_length(found.path.corners), [0.02, 0.04], rtol=1e-12)
    assert (found.corner_tolerance == P).all()
    assert not found.dwell.any()
    # The two halves are one curve: place, direction and curvature are continuous in the middle of the blend.
    ends, starts = (found.path.derivatives(found.path.breaks[2] + step, 2)[:, 0] for step in (-1e-13, 1e-13))
    np.testing.assert_allclose(ends[1], starts[1], atol=1e-7)
    np.testing.assert_allclose(ends[2], starts[2], rtol=1e-4)
    assert found.path.curves[1].length == pytest.approx(found.path.curves[2].length, rel=1e-9)


def test_a_closed_path_is_rounded_where_it_closes_and_in_every_lap() -> None:
    given = replace_tolerance(contour("diamond"), 1e-4)
    found = blended(given)
    assert found.path.closed
    assert found.path.corners.size == 0
    assert found.n_curve == 2 * given.n_curve
    lap, programmed = found.path.length, given.path.length
    s = np.linspace(-lap, 2.0 * lap, 5001)
    at = found.programmed_arc_length(s)
    np.testing.assert_allclose(found.programmed_arc_length(s + lap), at + programmed, rtol=0, atol=1e-14)
    off = np.linalg.norm(found.path.position(s) - given.path.position(at), axis=1)
    assert off.max() <= 1.5e-4
    assert (np.diff(at) > 0.0).all()


def replace_tolerance(path: Path, tolerance: float) -> Route:
    n = len(path.curves)
    return Route(path, 0.05, False, 0.0, np.arange(1, n + 1), corner_tolerance=tolerance)


def test_the_judge_finds_the_planning_deviation_and_the_part_error() -> None:
    points = np.cumsum(np.random.default_rng(6).normal(size=(400, 2)), axis=0) * 1e-3
    given = route(points, 4e-5)
    found = blended(given)
    s = np.linspace(0.0, found.path.length, 30_001)
    reference = Reference.from_samples(
        found.path.position(s), 1e-3, found.path, arc_length=s, programmed=found.programmed, correspondence=found.correspondence
    )
    two, one = ("sample", "axis"), ("sample",)
    off = 3e-6 * found.path.normal(s)
    signals = {"reference": reference.block(0, 30_001).position, "tool_position": reference.block(0, 30_001).position + off}
    run = Result("made", ("x", "y"), 1e-3, {**{k: Signal(v, two, "m") for k, v in signals.items()}, "arc_length": Signal(s, one, "m")})
    judged = judge(run, reference)
    plan = np.abs(judged["planning_deviation"])
    # By brute force: the distance from every programmed line nearby in the order of travel.
    at = given.path.curve_index(found.programmed_arc_length(s))
    brute = np.min([to_line(points, np.clip(at + k, 0, 398), found.path.position(s)) for k in (-1, 0, 1)], axis=0)
    # Where short lines fold back, a later one may be nearer: the judge considers the lines replaced by the blend, brute force three lines.
    assert np.mean(np.abs(plan - brute) > 1e-12) < 2e-3
    assert 3.5e-5 < plan.max() <= 4e-5
    contour_error = judged["contour_error"]
    assert (np.abs(contour_error) <= 3e-6 + 1e-15).all()
    assert np.median(contour_error) == pytest.approx(3e-6, rel=1e-9)
    assert (np.abs(judged["part_error"]) <= plan + 3e-6 + 1e-12).all()
    without = replace(reference, correspondence=None)
    assert without.digest != reference.digest


def to_line(points: Array, i: NDArray[np.int64], at: Array) -> Array:
    """Return the distance of points from the lines between points i and i + 1."""
    along = points[i + 1] - points[i]
    share = np.clip(((at - points[i]) * along).sum(axis=1) / (along**2).sum(axis=1), 0.0, 1.0)
    return np.asarray(np.linalg.norm(at - points[i] - share[:, None] * along, axis=1))


def test_the_cost_is_proportional_to_the_corners(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = [0]
    for kind in (*CurveBatch.__subclasses__(), CurveBatch):
        whole = kind.derivatives

        def counted(self: Any, slot: Any, along: Any, order: int, whole: Any = whole) -> Any:
            asked[-1] += along.size
            return whole(self, slot, along, order)

        monkeypatch.setattr(kind, "derivatives", counted)
    for n in (200, 400, 800):
        given = on(mixed(2, n, 9), P)
        asked.append(0)
        blended(given)
    assert asked[2] <= 2.3 * asked[1]
    assert asked[3] <= 2.3 * asked[2]


@pytest.mark.parametrize(("planned", "programmed"), [([0.0], [0.0]), ([0.0, 1.0, 1.0], [0.0, 1.0, 2.0]), ([0.0, 1.0], [0.0, 1.0, 2.0])])
def test_a_decreasing_map_is_refused(planned: list[float], programmed: list[float]) -> None:
    with pytest.raises(FeedError, match=r"rising|same"):
        Correspondence(np.array(planned), np.array(programmed))


def test_composition_of_two_maps() -> None:
    first = Correspondence(np.array([0.0, 1.0, 3.0]), np.array([0.5, 2.0, 4.5]))
    second = Correspondence(np.array([0.0, 1.0, 4.0]), np.array([0.0, 2.0, 3.0]))
    both = second.after(first)
    s = np.linspace(-3.0, 6.0, 901)
    np.testing.assert_allclose(both(s), second(first(s)), rtol=0, atol=1e-14)


def test_a_divided_blend_is_mapped_by_the_length_of_its_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    import contourlab.geometry.blend as room

    plain = room._inverted

    def too_strict(c: Array) -> Any:
        borders, *series, good = plain(c)
        return borders, *series, good & (borders[:, -1] < 2e-5)  # divides longer ones

    monkeypatch.setattr(room, "_inverted", too_strict)
    corner = 0.01
    found = blended(route(bend(1.0)))
    parts = [i for i, c in enumerate(found.path.curves) if isinstance(c, Blend)]
    assert len(parts) > 2
    places = found.programmed_arc_length(found.path.breaks[parts[0] : parts[-1] + 2])
    done = found.path.breaks[parts[0] : parts[-1] + 2] - found.path.breaks[parts[0]]
    np.testing.assert_allclose((places - places[0]) / (places[-1] - places[0]), done / done[-1], rtol=1e-12, atol=1e-15)
    assert 0.5 * (places[0] + places[-1]) == pytest.approx(corner, rel=1e-12)
    assert found.path.corners.size == 0


def test_lines_of_a_closed_path_repeat_lap_by_lap() -> None:
    square = np.array([(0.0, 0.0), (0.02, 0.0), (0.02, 0.02), (0.0, 0.02), (0.0, 0.0)])
    path = Path(Line.many(square[:-1], square[1:]), closed=True)
    limits = AxisLimits(0.5, 5.0, 500.0)
    found = blended(Route(path, 0.05, False, 0.0, [3, 4, 6, 7], corner_tolerance=1e-3), limits)
    assert found.n_curve == 8
    reference = plan(found, limits, 1e-3, laps=2)
    along = reference.block(0, reference.n_sample).arc_length
    side = np.floor(reference.programmed_arc_length(along) / 0.02 + 1e-9).astype(int)
    np.testing.assert_array_equal(reference.source_line(along), np.array([3, 4, 6, 7])[side % 4])
