"""The exact foot point, against closed forms and a search that shares only the curve with it."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import brentq

from contourlab.errors import GeometryError
from contourlab.geometry import Arc, BSpline, Line, Nurbs, Path, contour, contour_names
from contourlab.geometry.blend import blends, quintic_bezier

Array = NDArray[np.float64]
SMOOTH = ["circle", "ellipse", "lemniscate", "star", "butterfly"]
HELIX = Path([Arc((0.0, 0.0, 0.0), 0.02, 0.3, 6.0 * math.pi, rise=(0.0, 0.0, 0.015))])
SPATIAL = Path(
    [Nurbs(3, np.array([(0, 0, 0), (1, 2, 1), (3, 1, -1), (4, -1, 0), (5, 0, 2)]) * 0.01, [0, 0, 0, 0, 0.6, 1, 1, 1, 1], [1, 2, 0.5, 3, 1])]
)


def search(path: Path, point: Array, low: float, high: float, n: int = 20000) -> tuple[float, float]:
    """Return arc length and distance of the closest point between two arc lengths: dense samples, refined by Brent's root of r'.(r - p)."""
    s = np.linspace(low, high, n + 1)
    away = np.linalg.norm(path.position(s) - point, axis=1)
    dips = np.flatnonzero(away <= away.min() + (high - low) / n)

    def slope(x: float) -> float:
        r, t = path.derivatives(x, 1)[:, 0]
        return float(t @ (r - point))

    found = [(float(away[k]), float(s[k])) for k in dips]
    for k in dips:
        a, b = s[max(k - 1, 0)], s[min(k + 1, n)]
        if slope(a) < 0.0 < slope(b):
            x = brentq(slope, a, b, xtol=1e-16 * path.length, rtol=8.9e-16)
            found.append((float(np.linalg.norm(path.position(x)[0] - point)), x))
    distance, where = min(found)
    return where, distance


@pytest.mark.parametrize("name", SMOOTH)
@pytest.mark.parametrize("part", [-0.9, -1e-3, 1e-6, 0.5, 0.95])
def test_a_point_on_a_normal_has_its_foot_there(name: str, part: float) -> None:
    path = contour(name)
    s = np.linspace(0.0, path.length, 400, endpoint=False) + 1e-4 * path.length
    # Up to a fraction of the smallest radius of curvature, inside a window without other branches.
    bend = np.max([np.abs(path.curvature(s + d)) for d in np.linspace(-5e-5, 5e-5, 21)], axis=0)
    offset = part / np.maximum(bend, 1e3)
    points = path.position(s) + offset[:, None] * path.normal(s)
    found = path.foot_point(points, s + 1e-5, 3e-5)
    np.testing.assert_allclose(found.arc_length, s, rtol=0, atol=1e-12 * path.length)
    np.testing.assert_allclose(found.signed, offset, rtol=0, atol=1e-14)
    np.testing.assert_array_equal(np.abs(found.signed), found.distance)
    np.testing.assert_allclose(found.position, path.position(s), rtol=0, atol=1e-12 * path.length)


@pytest.mark.parametrize("path", [HELIX, SPATIAL], ids=["helix", "nurbs"])
def test_in_space_the_foot_of_a_point_in_the_normal_plane(path: Path) -> None:
    s = np.linspace(0.01, 0.99, 200) * path.length
    tangent, normal = path.tangent(s), path.normal(s)
    turn = np.linspace(0.0, 20.0, 200)[:, None]
    points = path.position(s) + 2e-4 * (np.cos(turn) * normal + np.sin(turn) * np.cross(tangent, normal))
    found = path.foot_point(points, s, 3e-3)
    np.testing.assert_allclose(found.arc_length, s, rtol=0, atol=1e-12 * path.length)
    np.testing.assert_allclose(found.distance, 2e-4, rtol=1e-11)
    assert np.isnan(found.signed).all()


@pytest.mark.slow
@pytest.mark.parametrize("name", contour_names())
@pytest.mark.parametrize("reach", [1e-5, 2e-3, 2e-2])
def test_a_wide_window_covers_the_whole_path(name: str, reach: float) -> None:
    path, rng = contour(name), np.random.default_rng(11)
    around = rng.uniform(0.0, path.length, 12)
    angle = rng.uniform(0.0, 2.0 * math.pi, 12)
    # In space the point is off in the first two coordinates.
    off = np.column_stack([np.cos(angle), np.sin(angle), 0.0 * angle])[:, : path.n_axis]
    points = path.position(around) + reach * off
    found = path.foot_point(points, around, path.length)
    for i, point in enumerate(points):
        where, distance = search(path, point, 0.0, path.length)
        assert found.distance[i] == pytest.approx(distance, rel=0, abs=1e-15 + 1e-13 * distance)
        # At corners and at equal distances there are two answers; the distance above decides which are right.
        other = path.position(where)[0]
        if np.linalg.norm(found.position[i] - other) < 1e-6:
            assert np.linalg.norm(found.position[i] - other) < 1e-12 * path.length


def test_a_hairpin_in_a_wide_window_is_not_missed() -> None:
    # The butterfly's tail turns within 23 um; its two legs run side by side.
    path = contour("butterfly")
    s = 0.2855 + np.linspace(-6e-4, 6e-4, 241)
    points = path.position(s) + 1e-6 * path.normal(s)
    for window in (3e-4, 0.01, path.length):
        np.testing.assert_allclose(path.foot_point(points, s, window).signed, 1e-6, rtol=0, atol=1e-14)


@pytest.mark.parametrize("name", ["lemniscate", "star", "butterfly", "line-line-circle"])
def test_within_its_window_the_foot_is_the_closest(name: str) -> None:
    path, rng, window = contour(name), np.random.default_rng(3), 4e-3
    around = rng.uniform(window, path.length - window, 12)
    points = path.position(around) + rng.uniform(-3e-3, 3e-3, (12, 2))
    found = path.foot_point(points, around, window)
    for i, point in enumerate(points):
        where, distance = search(path, point, around[i] - window, around[i] + window, 4000)
        assert found.distance[i] == pytest.approx(distance, rel=1e-12)
        assert found.arc_length[i] == pytest.approx(where, rel=0, abs=1e-12 * path.length)


def test_at_a_crossing_progress_decides_the_branch() -> None:
    path = contour("lemniscate")
    half = 0.5 * path.length
    for middle in (0.0, half, path.length):
        s = middle + np.linspace(-2e-3, 2e-3, 41)
        points = path.position(s) + 1e-5 * path.normal(s)
        found = path.foot_point(points, s + 3e-5, 2e-3)
        np.testing.assert_allclose(found.arc_length, s, rtol=0, atol=1e-12 * path.length)
        np.testing.assert_allclose(found.signed, 1e-5, rtol=0, atol=1e-14)
    # At the crossing itself both branches are equally far, for any window.
    for around, expected in ((1e-3, 0.0), (-1e-3, 0.0), (half + 1e-3, half), (half - 1e-3, half)):
        found = path.foot_point([(0.0, 0.0)], [around], path.length)
        assert found.arc_length[0] == pytest.approx(expected, abs=1e-12 * path.length)


def test_progress_distinguishes_crossing_lines() -> None:
    points = [(-1.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, -1.0)]
    path = Path([Line(a, b) for a, b in pairwise(points)])
    found = path.foot_point([(0.0, 0.0), (0.0, 0.0), (0.01, 0.02)], [0.9, 4.8, 0.9], 10.0)
    np.testing.assert_allclose(found.arc_length, [1.0, 5.0, 5.0 - 0.02], atol=1e-15)
    assert path.foot_point([(0.01, 0.02)], [0.9], 0.5).arc_length[0] == pytest.approx(1.01, abs=1e-15)


def test_at_a_corner() -> None:
    path = Path([Line((0.0, 0.0), (1.0, 0.0)), Line((1.0, 0.0), (1.0, 1.0))])
    outside = [(1.1, -0.1), (1.2, -1e-6), (1.0 + 1e-9, -0.3)]
    found = path.foot_point(outside, [0.9, 1.0, 1.1], 0.5)
    np.testing.assert_array_equal(found.arc_length, 1.0)
    np.testing.assert_allclose(found.position, [(1.0, 0.0)] * 3)
    np.testing.assert_allclose(found.signed, [-math.hypot(*(np.array(p) - (1.0, 0.0))) for p in outside], rtol=1e-14)
    # On the inner bisector both legs are equally far: progress decides.
    for around, expected in ((0.8, 0.9), (1.2, 1.1)):
        inside = path.foot_point([(0.9, 0.1)], [around], 0.5)
        assert inside.arc_length[0] == pytest.approx(expected, rel=1e-15)
        assert inside.signed[0] == pytest.approx(0.1, rel=1e-14)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_the_side_at_an_acute_corner_follows_the_bisector(side: float) -> None:
    # Beyond the tip of a 20 degree corner the two legs disagree on the side; the point is outside the turn.
    leg = (1.0 - math.cos(math.radians(20)), side * math.sin(math.radians(20)))
    path = Path([Line((0.0, 0.0), (1.0, 0.0)), Line((1.0, 0.0), leg)])
    for angle in np.radians([-50, -10, 0.0, 30, 70]):
        point = (1.0 + 0.1 * math.cos(angle), 0.1 * math.sin(angle))
        found = path.foot_point([point], [1.0], 0.5)
        assert found.arc_length[0] == 1.0
        # The bisector has the direction of the sum of the tangents.
        along = np.array([1.0, 0.0]) + (np.array(leg) - (1.0, 0.0))
        expected = math.copysign(0.1, along[0] * (point[1]) - along[1] * (point[0] - 1.0))
        assert found.signed[0] == pytest.approx(expected, rel=1e-14)


def test_the_closing_corner_is_like_the_others() -> None:
    path = contour("diamond", side=0.04)
    tips = path.position(path.corners)
    for lap in (0.0, 3.0 * path.length):
        found = path.foot_point(1.1 * tips, path.corners + lap, 0.01)
        np.testing.assert_allclose(found.arc_length, path.corners + lap, atol=1e-14)
        np.testing.assert_allclose(found.signed, -0.1 * np.linalg.norm(tips, axis=1), rtol=1e-13)


def test_beyond_the_ends_of_an_open_path_the_foot_is_the_end() -> None:
    spline = BSpline(3, [(0.0, 0.0), (0.01, 0.0), (0.02, 0.01), (0.03, 0.01)], [0, 0, 0, 0, 1, 1, 1, 1])
    for path in (Path([Line((0.0, 0.0), (0.03, 0.01))]), Path([spline]), Path([Arc((0.0, 0.03), 0.03, -math.pi / 2, 1.0)])):
        first, last = path.position([0.0, path.length])
        out = np.array([first - 1e-3 * path.tangent(0.0)[0], last + 1e-3 * path.tangent(path.length)[0]])
        out[1] += 1e-4 * path.normal(path.length)[0]
        found = path.foot_point(out, [0.0, path.length], 0.01)
        np.testing.assert_array_equal(found.arc_length, [0.0, path.length])
        np.testing.assert_allclose(found.distance, [1e-3, math.hypot(1e-3, 1e-4)], rtol=1e-12)
        assert found.signed[1] > 0.0


def test_progress_counts_laps_and_crosses_the_seam() -> None:
    path = contour("ellipse")
    for lap in (-3, 0, 1, 250):
        s = lap * path.length + np.linspace(-1e-3, 1e-3, 21)
        points = path.position(s) - 2e-5 * path.normal(s)
        found = path.foot_point(points, s + 1e-4 * np.sign(s), 5e-4)
        np.testing.assert_allclose(found.arc_length, s, rtol=0, atol=1e-12 * path.length * (1 + abs(lap)))
        np.testing.assert_allclose(found.signed, -2e-5, rtol=0, atol=1e-13)


def test_an_arc_of_several_turns_keeps_the_turn_of_the_progress() -> None:
    path = Path([Arc((0.0, 0.0), 0.02, 0.0, 7.0 * math.pi)])
    turn = 2.0 * math.pi * 0.02
    s = np.array([0.01, 0.01 + turn, 0.01 + 2 * turn, 0.03 + 3 * turn])
    found = path.foot_point(1.1 * path.position(s), s + 0.02, 0.1)
    np.testing.assert_allclose(found.arc_length, s, rtol=1e-13)
    # The path ends opposite its start. For a point just after the start, the beginning of the window is closer than the end of the path.
    past = 1.1 * path.position([0.001])
    assert path.foot_point(past, [path.length], 0.01).arc_length[0] == pytest.approx(path.length - 0.01, rel=1e-15)
    behind = 1.1 * path.position([0.5 * turn + 0.01])
    assert path.foot_point(behind, [path.length], 0.01).arc_length[0] == path.length


def test_a_wide_window_sees_an_arc_as_a_whole() -> None:
    # Backwards from its start the angle to the foot at six tenths of a turn is shorter, but the arc is not there.
    path = Path([Arc((0.0, 0.0), 0.02, 0.0, 1.5 * math.pi)])
    s = np.array([0.8, 0.1]) * path.length
    found = path.foot_point(0.9 * path.position(s), [0.0, path.length], path.length)
    np.testing.assert_allclose(found.arc_length, s, rtol=1e-13)
    np.testing.assert_allclose(found.signed, 0.002, rtol=1e-12)


def test_a_corner_at_the_end_of_a_spline_does_not_hide_earlier_points() -> None:
    # The last cell of the spline ends where the next curve already has another direction.
    spline = BSpline(3, [(0.0, 0.0), (0.01, 0.02), (0.02, 0.0), (0.03, 0.01)], [0, 0, 0, 0, 1, 1, 1, 1])
    path = Path([Line((-0.001, 0.03), (0.0, 0.0)), spline, Line((0.03, 0.01), (0.0, 0.02))])
    joints = path.breaks[1:3]
    for window in np.geomspace(2e-4, 2e-2, 25):
        s = np.concatenate([joints[0] + np.linspace(1e-4, 2e-3, 30), joints[1] - np.linspace(1e-4, 2e-3, 30)])
        points = path.position(s) + 2e-5 * path.normal(s)
        found = path.foot_point(points, s + 0.9 * window * np.sin(np.arange(60.0)), window)
        np.testing.assert_allclose(found.arc_length, s, rtol=0, atol=1e-12 * path.length)


def test_from_the_centre_of_a_circle_the_foot_is_the_progress() -> None:
    for path in (contour("circle"), Path([Arc((0.3, 0.1), 0.02, 0.2, 3.0)])):
        centre = path.curves[0].centre  # type: ignore[attr-defined]
        around = np.linspace(0.05, 0.95, 7) * path.length
        found = path.foot_point(np.tile(centre, (7, 1)), around, 0.01)
        np.testing.assert_allclose(found.arc_length, around, rtol=1e-13)
        np.testing.assert_allclose(found.distance, 0.02, rtol=1e-13)


def test_from_the_centre_of_curvature_of_a_vertex() -> None:
    # There the distance is flat to fourth order: the distance is exact, the arc length limited by rounding.
    a, b = 0.04, 0.02
    path = contour("ellipse", a=a, b=b)
    found = path.foot_point([(a - b * b / a, 0.0)], [1e-3], 0.01)
    assert found.distance[0] == pytest.approx(b * b / a, rel=1e-14)
    assert abs(found.arc_length[0]) < 2e-5
    # Towards the vertex the foot is well defined again; beyond the centre it leaves the vertex, by symmetry.
    nearer = path.foot_point([(a - 0.9 * b * b / a, 0.0)], [1e-3], 0.01)
    assert abs(nearer.arc_length[0]) < 1e-12 * path.length


@pytest.mark.parametrize("window", [1.0, 2e-3])
def test_near_the_centres_of_curvature_of_blends(window: float) -> None:
    # A short stretch may then have two closest points. The distance is that of the nearer one, or of the end of the window.
    rng, n = np.random.default_rng(3), 100
    points = np.array([0.0, 1.0, 2.2, 3.4, 4.6, 6.0])[:, None] * (1e-3, 0.0) + rng.normal(size=(8, 6, 2)) * 4e-4
    for blend in blends(quintic_bezier(points))[0]:
        path = Path([blend])
        around, places = rng.uniform(0.0, path.length, n), np.linspace(0.0, path.length, 4001)
        far = np.clip(rng.uniform(0.5, 1.6, n) / path.curvature(around), -0.05, 0.05)
        tool = path.position(around) + far[:, None] * path.normal(around)
        found, samples = path.foot_point(tool, around, window), path.position(places)
        for i in range(n):
            least = np.linalg.norm(samples[np.abs(places - around[i]) <= window] - tool[i], axis=1).min()
            assert found.distance[i] <= least * (1.0 + 1e-12)
        np.testing.assert_allclose(np.linalg.norm(path.position(found.arc_length) - tool, axis=1), found.distance, rtol=1e-12)
        assert np.all(np.abs(found.arc_length - around) <= window + 1e-15)


def test_from_the_centre_of_an_ellipse_both_flanks_are_equally_far() -> None:
    path = contour("ellipse", a=0.04, b=0.02)
    for around, expected in ((0.2, 0.25), (0.7, 0.75), (0.3, 0.25)):
        found = path.foot_point([(0.0, 0.0)], [around * path.length], path.length)
        assert found.distance[0] == pytest.approx(0.02, rel=1e-15)
        assert found.arc_length[0] == pytest.approx(expected * path.length, rel=0, abs=1e-9 * path.length)


@pytest.mark.slow
@pytest.mark.parametrize("path", [*map(contour, contour_names()), HELIX, SPATIAL], ids=[*contour_names(), "helix", "nurbs"])
def test_many_samples_at_once_and_one_by_one_agree(path: Path) -> None:
    rng, n = np.random.default_rng(7), 60
    around = rng.uniform(0.0, path.length, n)
    points = path.position(around) + rng.normal(0.0, 2e-4, (n, path.n_axis))
    for window in (1e-3, path.length):
        many = path.foot_point(points, around, window)
        for i in range(n):
            one = path.foot_point(points[i], around[i], window)
            assert one.arc_length[0] == pytest.approx(many.arc_length[i], rel=0, abs=1e-12 * path.length)
            assert one.distance[0] == pytest.approx(many.distance[i], rel=0, abs=1e-14)


def test_more_samples_than_a_chunk() -> None:
    path, n = contour("circle"), (1 << 17) + 3
    s = np.linspace(0.0, 5.0 * path.length, n)
    found = path.foot_point(1.001 * path.position(s), s, 1e-3)
    np.testing.assert_allclose(found.arc_length, s, rtol=0, atol=1e-12)
    assert path.foot_point(np.zeros((0, 2)), [], 1.0).position.shape == (0, 2)


def test_a_point_on_the_path_has_zero_distance() -> None:
    for name in contour_names():
        path = contour(name)
        s = np.linspace(0.0, path.length, 77)
        assert path.foot_point(path.position(s), s, 1e-3).distance.max() < 1e-15


@pytest.mark.parametrize(
    ("points", "around", "window", "message"),
    [
        ([(0.0, 0.0)], [0.0, 1.0], 1.0, r"\(1, 2\).*progress.*\(2, 2\)"),
        ([(0.0, 0.0, 0.0)], [0.0], 1.0, r"must be \(1, 2\)"),
        ([(0.0, 0.0)], [0.0], 0.0, "window = 0.0: must be > 0"),
        ([(0.0, 0.0)], [0.0], math.nan, "window = nan"),
        ([(0.0, math.nan)], [0.0], 1.0, "finite"),
        ([(0.0, 0.0)], [math.inf], 1.0, "finite"),
    ],
)
def test_wrong_input_is_refused(points: list, around: list, window: float, message: str) -> None:
    with pytest.raises(GeometryError, match=message):
        contour("circle").foot_point(points, around, window)
