"""Curves reversed, with moved ends, and splines split at corners."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from contourlab.contours.drawing import spline_curves
from contourlab.errors import GeometryError
from contourlab.geometry import Arc, BSpline, Curve, EllipticalArc, Line, Nurbs, Path, backwards, with_ends
from contourlab.geometry.nurbs import split_at
from contourlab.geometry.parametric import Lemniscate, Spiral

POINTS = np.array([(0, 0), (10, 20), (20, -15), (30, 10), (45, 5), (50, 0)]) * 1e-3
CLAMPED = np.array([0, 0, 0, 0, 1, 2.5, 4, 4, 4, 4.0])
FREE = np.array([0, 1, 2.2, 3, 4, 5.5, 6, 7, 8, 9.0])
WEIGHTS = np.array([1, 2, 0.5, 1, 3, 1.0])
CURVES: dict[str, Curve] = {
    "line": Line((0, 0), (0.03, 0.04)),
    "arc": Arc((0.01, 0), 0.02, 0.3, 2.5),
    "helix": Arc((0.0, 0.0, 0.0), 0.02, 0.3, -5.0, rise=(0.0, 0.0, 0.01)),
    "elliptical arc": EllipticalArc((0.01, 0.02), (0.03, 0.01), (0.0, 0.02), 0.4, 4.0),
    "b-spline": BSpline(3, POINTS, CLAMPED),
    "free b-spline": BSpline(3, POINTS, FREE),
    "nurbs": Nurbs(3, POINTS, CLAMPED, WEIGHTS),
    "free nurbs": Nurbs(3, POINTS, FREE, WEIGHTS),
    "lemniscate": Lemniscate(0.03),
}


@pytest.mark.parametrize("name", CURVES)
def test_a_reversed_curve_is_the_same_from_its_end(name: str) -> None:
    curve, turned = CURVES[name], backwards(CURVES[name])
    s = np.linspace(0.0, curve.length, 33)
    assert turned.length == pytest.approx(curve.length, rel=1e-13)
    there, back = curve.derivatives(curve.length - s, 3), turned.derivatives(s, 3)
    for k in range(4):
        scale = float(np.abs(there[k]).max()) + 1e-3
        np.testing.assert_allclose(back[k], (-1.0) ** k * there[k], rtol=0, atol=1e-9 * scale)
    again = backwards(turned)
    np.testing.assert_allclose(again.position(s), curve.position(s), rtol=0, atol=1e-15)
    assert turned.describe() != curve.describe()


@pytest.mark.parametrize(
    "curve", [CURVES["elliptical arc"], Spiral(0.004, 0.003, 1.6), Spiral(0.0, 0.003, 2.0)], ids=["ellipse", "spiral", "from 0"]
)
def test_derivatives_agree_with_differences_of_the_order_below(curve: Curve) -> None:
    """Fourth-order central differences."""
    s, h = np.linspace(0.1, 0.9, 17) * curve.length, 1e-3 * curve.length
    steps = [curve.derivatives(s + k * h, 2) for k in (-2, -1, 1, 2)]
    slope = (steps[0] - 8.0 * steps[1] + 8.0 * steps[2] - steps[3]) / (12.0 * h)
    exact = curve.derivatives(s, 3)[1:]
    for k in range(3):
        np.testing.assert_allclose(slope[k], exact[k], rtol=0, atol=1e-6 * float(np.abs(exact[k]).max()))


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in CURVES if name != "lemniscate"])
@given(shift=st.lists(st.floats(-1e-6, 1e-6), min_size=6, max_size=6))
@settings(max_examples=15)
def test_ends_are_moved_as_requested_and_the_rest_by_little_more(name: str, shift: list[float]) -> None:
    curve = CURVES[name]
    move = np.array(shift).reshape(2, 3)[:, : curve.n_axis]
    ends = curve.position([0.0, curve.length]) + move
    found = with_ends(curve, *ends)
    assert type(found) is type(curve)
    np.testing.assert_allclose(found.position([0.0, found.length]), ends, rtol=0, atol=1e-12)
    x = np.linspace(0.0, 1.0, 41)
    gaps = np.linalg.norm(found.position(x * found.length) - curve.position(x * curve.length), axis=1)
    assert gaps.max() <= 3.5 * np.linalg.norm(move, axis=1).max() + 1e-12


def test_ends_that_would_move_the_rest_far_are_refused() -> None:
    """Separating the ends of an almost full circle would enlarge the circle a lot."""
    curve = EllipticalArc((0, 0), (1, 0), (0, 0.5), 0.0, 2 * math.pi - 1e-4)
    ends = curve.position([0.0, curve.length])
    with pytest.raises(GeometryError, match=r"EllipticalArc.*1e-06 m"):
        with_ends(curve, ends[0] + [1e-6, 0], ends[1] - [1e-6, 0])
    with pytest.raises(GeometryError, match="Lemniscate"):
        with_ends(CURVES["lemniscate"], (0, 0), (0, 1e-6))


@pytest.mark.parametrize(("knots", "places"), [(CLAMPED, [0.4, 1.0, 3.9]), (FREE, [3.5, 4.0, 5.9])])
def test_a_split_spline_is_the_same_curve(knots: np.ndarray, places: list[float]) -> None:
    """Against scipy's evaluation of the whole spline."""
    from scipy.interpolate import BSpline as Known

    known = Known(knots, POINTS, 3)
    pieces = split_at(3, POINTS, knots, np.array(places))
    assert len(pieces) == 4
    marks = [knots[3], *places, knots[-4]]
    for (points, t), a, b in zip(pieces, marks, marks[1:], strict=False):
        u = np.linspace(a, b, 9)
        np.testing.assert_allclose(BSpline(3, points, t).raw(u[:-1], 0)[0], known(u[:-1]), rtol=0, atol=1e-15)
        np.testing.assert_allclose(Known(t, points, 3)(u), known(u), rtol=0, atol=1e-15)


def test_corners_split_a_spline() -> None:
    """Two quadratic Beziers that meet at a right angle, in one spline, plain and rational."""
    points = np.array([(0, 0), (1, 1), (2, 1), (2, 3), (4, 3.0)])
    knots = np.array([0, 0, 0, 1, 1, 2, 2, 2.0])
    for weights in (None, np.array([1, 2, 1, 0.5, 1.0])):
        pieces = spline_curves(2, points, knots, weights)
        assert len(pieces) == 2
        np.testing.assert_allclose(pieces[0].position(pieces[0].length), [(2, 1)], atol=1e-15)
        np.testing.assert_allclose(pieces[1].position(0.0), [(2, 1)], atol=1e-15)
    # Straight through the joint there is no corner, but legs of different lengths make the curvature jump.
    smooth = points.copy()
    smooth[3] = (5, 1)
    joined = spline_curves(2, smooth, knots, None)
    assert len(joined) == 2
    assert Path(joined).corners.size == 0
    # One knot too many, with the point doubled, as some programs write it.
    double, more = np.insert(points, 2, points[2], axis=0), np.insert(knots, 3, 1.0)
    assert len(spline_curves(2, double, more, None)) == 2
    double[3] += 0.1
    with pytest.raises(GeometryError, match=r"gap.* 1$"):
        spline_curves(2, double, more, None)


def test_polygons_and_straight_splines_are_lines() -> None:
    corners = np.array([(0, 0), (1, 0), (1, 1), (3, 1.0)])
    found = spline_curves(1, corners, np.array([0, 0, 1, 2, 3, 3.0]), None)
    assert [type(curve) for curve in found] == [Line] * 3
    straight = np.linspace((0, 0), (3, 4), 6)
    found = spline_curves(3, straight, CLAMPED, None)
    assert isinstance(found[0], Line)
    assert found[0].length == pytest.approx(5.0)
    free = spline_curves(3, straight, FREE, None)
    assert isinstance(free[0], Line)
    assert free[0].length < 5.0


def test_a_nurbs_circle_is_a_circle() -> None:
    h = math.sqrt(0.5)
    points = np.array([(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0.0)])
    knots = np.array([0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4.0])
    (curve,) = spline_curves(2, points, knots, np.array([1, h, 1, h, 1, h, 1, h, 1]))
    assert curve.length == pytest.approx(2 * math.pi, rel=1e-13)


@pytest.mark.parametrize(
    ("degree", "knots", "weights", "message"),
    [
        (3, CLAMPED[:-1], None, "needs 10 knots"),
        (3, CLAMPED[::-1].copy(), None, "decrease"),
        (3, CLAMPED, WEIGHTS[:-1], "one weight"),
        (3, CLAMPED, -WEIGHTS, "one weight"),
        (7, CLAMPED, None, "degree 7"),
    ],
)
def test_splines_with_inconsistent_data_are_refused(degree: int, knots: np.ndarray, weights: np.ndarray | None, message: str) -> None:
    with pytest.raises(GeometryError, match=message):
        spline_curves(degree, POINTS, knots, weights)
