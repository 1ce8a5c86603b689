"""B-splines and NURBS against scipy, conics that they represent exactly, and the published butterfly."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from reference_data import reference_file
from scipy.interpolate import BSpline as ScipySpline
from scipy.interpolate import make_interp_spline

from contourlab.errors import GeometryError
from contourlab.geometry import BSpline, Nurbs, Path, contour
from contourlab.geometry.parametric import Ellipse

POINTS = np.array([(0.0, 0.0), (1.0, 2.0), (3.0, 1.0), (4.0, -1.0), (6.0, 0.0), (7.0, 3.0), (9.0, 2.0)])
KNOTS = [0.0, 0.0, 0.0, 0.0, 0.3, 0.5, 0.8, 1.0, 1.0, 1.0, 1.0]
ROOT = math.sqrt(0.5)
SQUARE = np.array([(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)], dtype=float)
QUARTERS = [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]
CORNER_WEIGHTS = [1, ROOT, 1, ROOT, 1, ROOT, 1, ROOT, 1]


@pytest.mark.parametrize("degree", [2, 3, 4, 5])
def test_a_spline_and_its_derivatives_by_parameter_agree_with_scipy(degree: int) -> None:
    inner = np.linspace(0.0, 2.0, len(POINTS) - degree + 1)
    knots = np.concatenate([[0.0] * degree, inner, [2.0] * degree])
    mine, other = BSpline(degree, POINTS, knots), ScipySpline(knots, POINTS, degree)
    u = np.linspace(0.0, 2.0, 41)[:-1] + 0.013
    raw = mine.raw(u, 3)
    for order in range(4):
        np.testing.assert_allclose(raw[order], other(u, nu=order), rtol=1e-11, atol=1e-11)


def test_a_spline_ends_where_its_clamped_polygon_ends() -> None:
    path = Path([BSpline(3, POINTS, KNOTS)])
    np.testing.assert_allclose(path.position([0.0, path.length]), [POINTS[0], POINTS[-1]], atol=1e-14)
    for at, leg in ((0.0, POINTS[1] - POINTS[0]), (path.length, POINTS[-1] - POINTS[-2])):
        np.testing.assert_allclose(path.tangent(at)[0], leg / np.linalg.norm(leg), atol=1e-13)


def test_an_unclamped_spline_runs_from_its_first_inner_knot_to_its_last() -> None:
    knots = np.arange(len(POINTS) + 4.0)
    spline = BSpline(3, POINTS, knots)
    expected = ScipySpline(knots, POINTS, 3)([3.0, 7.0 - 1e-12])
    np.testing.assert_allclose(spline.position([0.0, spline.length]), expected, atol=1e-11)


def test_a_parabola_has_the_length_of_the_textbook() -> None:
    # Bezier points of y = x^2 from 0 to 1.
    curve = BSpline(2, [(0, 0), (0.5, 0), (1, 1)], [0, 0, 0, 1, 1, 1])
    assert curve.length == pytest.approx(math.sqrt(5.0) / 2.0 + math.asinh(2.0) / 4.0, rel=1e-14)
    path, s = Path([curve]), np.linspace(0.0, curve.length, 31)
    x, y = path.position(s).T
    np.testing.assert_allclose(y, x**2, rtol=0, atol=1e-15)
    np.testing.assert_allclose(path.curvature(s), 2.0 / (1.0 + 4.0 * x**2) ** 1.5, rtol=1e-12)
    np.testing.assert_allclose(path.curvature_derivative(s), -24.0 * x / (1.0 + 4.0 * x**2) ** 3, rtol=0, atol=1e-11)


def test_a_circle_is_a_nurbs_exactly() -> None:
    circle = Nurbs(2, SQUARE, QUARTERS, CORNER_WEIGHTS)
    assert circle.length == pytest.approx(2.0 * math.pi, rel=1e-14)
    s = np.linspace(0.0, circle.length, 101)
    round_ = np.column_stack([np.cos(s), np.sin(s)])
    swing = np.column_stack([-np.sin(s), np.cos(s)])
    # By arc length the parametrisation has no effect.
    np.testing.assert_allclose(circle.derivatives(s), [round_, swing, -round_, -swing], rtol=0, atol=3e-13)


def test_an_ellipse_is_the_affine_image_of_that_circle() -> None:
    nurbs, ellipse = Nurbs(2, SQUARE * [0.04, 0.02], QUARTERS, CORNER_WEIGHTS), Ellipse(0.04, 0.02)
    assert nurbs.length == pytest.approx(ellipse.length, rel=1e-14)
    s = np.linspace(0.0, nurbs.length, 101)
    for mine, other in zip(nurbs.derivatives(s), ellipse.derivatives(s), strict=True):
        np.testing.assert_allclose(mine, other, rtol=0, atol=1e-11 * np.abs(other).max())


def test_equal_weights_make_a_polynomial_spline() -> None:
    a, b = BSpline(3, POINTS, KNOTS), Nurbs(3, POINTS, KNOTS, [2.5] * len(POINTS))
    s = np.linspace(0.0, a.length, 57)
    np.testing.assert_allclose(a.derivatives(s), b.derivatives(s), rtol=1e-10, atol=1e-10)


@pytest.mark.parametrize(("scale", "shift"), [(1.0, 1000.0), (1e-3, 0.0), (1e4, -3e4), (1.0, 1e6)])
def test_scaling_the_parameter_changes_nothing(scale: float, shift: float) -> None:
    a, b = BSpline(3, POINTS, KNOTS), BSpline(3, POINTS, scale * np.array(KNOTS) + shift)
    digits = 1e-12 + 1e-14 * abs(shift) / scale
    assert b.length == pytest.approx(a.length, rel=digits)
    s = np.linspace(0.0, a.length, 57)
    np.testing.assert_allclose(b.position(np.minimum(s, b.length)), a.position(s), rtol=0, atol=10 * digits)


def test_the_butterfly_agrees_with_its_data() -> None:
    data = json.loads(reference_file("data/contours/butterfly_nurbs.json").read_text(encoding="utf-8"))
    points, weights, knots = (np.array(data[name], dtype=float) for name in ("control_points", "weights", "knots"))
    # This source leaves the contour open by 1 um, one unit of its last digit.
    assert points[-1] == pytest.approx(points[0], abs=1.0001e-3)
    points[-1] = points[0]
    path = Path([Nurbs(data["degree"], points, knots, weights)], closed=True)
    ours = contour("butterfly")
    assert ours.length * 1e3 == pytest.approx(path.length, rel=1e-13)
    s = np.linspace(0.0, path.length, 999)
    np.testing.assert_allclose(ours.position(s * 1e-3) * 1e3, path.position(s), rtol=0, atol=1e-10)


def test_the_butterfly_agrees_with_published_values() -> None:
    path = contour("butterfly")
    assert path.length * 1e3 == pytest.approx(382.86, abs=0.005)
    assert path.corners.size == 0
    points = path.position(np.linspace(0.0, path.length, 20001)) * 1e3
    np.testing.assert_allclose(points.min(axis=0), (5.92, 6.78), atol=0.005)
    np.testing.assert_allclose(points.max(axis=0), (103.08, 65.67), atol=0.005)
    curve = path.curves[0]
    assert isinstance(curve, Nurbs)
    assert curve.smallest_radius() * 1e3 == pytest.approx(0.023, abs=0.0005)
    # Its smallest radius is at parameter 0.256, found from its own curvature.
    s = np.linspace(0.0, path.length, 400001)
    assert curve.parameter(s[np.argmax(np.abs(path.curvature(s)))])[0] == pytest.approx(0.256, abs=0.001)


def test_the_length_of_the_butterfly_by_another_quadrature() -> None:
    # Midpoint chords of the rational form by scipy, between the knots where it is smooth; Romberg's rule raises the order.
    curve = contour("butterfly").curves[0]
    assert isinstance(curve, Nurbs)
    lifted = ScipySpline(curve.knots, np.column_stack([curve.points * curve.weights[:, None], curve.weights]), 3)
    sums = []
    for n in (400, 800, 1600):
        u = np.unique(np.concatenate([np.linspace(a, b, n + 1) for a, b in zip(curve.joints()[:-1], curve.joints()[1:], strict=True)]))
        x = lifted(u)
        sums.append(np.linalg.norm(np.diff(x[:, :2] / x[:, 2:], axis=0), axis=1).sum())
    once = [(4.0 * b - a) / 3.0 for a, b in ((sums[0], sums[1]), (sums[1], sums[2]))]
    assert (16.0 * once[1] - once[0]) / 15.0 == pytest.approx(curve.length, rel=1e-11)


def test_the_fan_as_a_spline_through_its_way_points() -> None:
    data = json.loads(reference_file("data/contours/fan_waypoints.json").read_text(encoding="utf-8"))
    points = np.column_stack([data["x"], data["y"]])
    chord = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    cubic = make_interp_spline(chord, points, k=3, bc_type="periodic")
    path = Path([BSpline(3, cubic.c, cubic.t)], closed=True)
    assert path.corners.size == 0
    assert path.length > chord[-1]
    assert path.length == pytest.approx(chord[-1], rel=0.02)
    # Every way-point lies on it.
    found = path.foot_point(points, chord * path.length / chord[-1], 0.05 * path.length)
    assert found.distance.max() < 1e-11


def test_corners_gaps_and_points_of_rest_inside_a_spline_are_refused() -> None:
    with pytest.raises(GeometryError, match=r"BSpline.*corner.* 1: "):
        BSpline(1, [(0, 0), (1, 0), (1, 1)], [0, 0, 1, 2, 2])
    with pytest.raises(GeometryError, match=r"Nurbs.*corner.* 0\.5: "):
        Nurbs(2, [(0, 0), (1, 0), (2, 1), (3, 0), (4, 0)], [0, 0, 0, 0.5, 0.5, 1, 1, 1], [1, 1, 1, 1, 1])
    with pytest.raises(GeometryError, match=r"gap.* 1: "):
        BSpline(1, [(0, 0), (1, 0), (2, 0), (3, 0)], [0, 0, 1, 1, 2, 2])
    with pytest.raises(GeometryError, match=r"stationary.* 0\.5"):
        # x = u^2, y = u^3 turns back at its cusp.
        BSpline(3, [(1, -1), (-1 / 3, 1), (-1 / 3, -1), (1, 1)], [0] * 4 + [1] * 4)
    with pytest.raises(GeometryError, match=r"stationary.* 0"):
        BSpline(3, [(0, 0), (0, 0), (1, 1), (2, 0)], [0] * 4 + [1] * 4)


def test_a_double_knot_without_a_corner_is_fine() -> None:
    straight = BSpline(2, [(0, 0), (1, 1), (2, 2), (4, 0), (6, 0)], [0, 0, 0, 1, 2, 3, 3, 3])
    assert straight.length > 6.0
    smooth = BSpline(2, [(0, 0), (1, 0), (2, 1), (3, 2), (4, 2)], [0, 0, 0, 1, 1, 2, 2, 2])
    assert Path([smooth]).corners.size == 0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((3, POINTS, KNOTS[:-1]), "degree 3 .*7 .*11 knots"),
        ((0, POINTS, KNOTS), "degree 0"),
        ((3, POINTS[:3], KNOTS[:7]), "3 control points"),
        ((3, POINTS, sorted(KNOTS, reverse=True)), "knots.*decrease"),
        ((3, POINTS, [1.0] * 11), "interval"),
        ((3, POINTS * np.nan, KNOTS), "finite"),
        ((3, POINTS, [math.inf] * 11), "finite"),
        ((3, POINTS[:, 0], KNOTS), r"shape \(n, n_axis\)"),
        ((3, POINTS * 0.0, KNOTS), "zero length"),
        ((3, "points", KNOTS), "control points"),
    ],
)
def test_invalid_splines_are_refused_with_a_reason(arguments: tuple, message: str) -> None:
    with pytest.raises(GeometryError, match=message):
        BSpline(*arguments)


@pytest.mark.parametrize("weights", [[1.0] * 6, [1.0] * 6 + [0.0], [1.0] * 6 + [-1.0], [1.0] * 6 + [math.nan]])
def test_weights_are_positive_and_one_per_point(weights: list[float]) -> None:
    with pytest.raises(GeometryError, match="weight > 0"):
        Nurbs(3, POINTS, KNOTS, weights)
