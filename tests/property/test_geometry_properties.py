"""Invariants of curves, foot points and tables over contours, motions and tolerances drawn at random."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from contourlab.geometry import Arc, Line, Nurbs, Path, contour
from contourlab.geometry.parametric import Ellipse, Star

Array = NDArray[np.float64]
few = settings(max_examples=30, deadline=None)
some = settings(max_examples=50, deadline=None)
unit = st.floats(0.0, 1.0)
names = st.sampled_from(["circle", "ellipse", "lemniscate", "diamond", "star", "butterfly", "line-line-circle"])
POINTS = np.array([(0.0, 0.0), (1.0, 2.0), (3.0, 1.0), (4.0, -1.0), (6.0, 0.0), (7.0, 3.0), (9.0, 2.0)]) * 0.01
KNOTS = np.array([0.0, 0.0, 0.0, 0.0, 0.3, 0.5, 0.8, 1.0, 1.0, 1.0, 1.0])
WEIGHTS = np.array([1.0, 2.0, 0.7, 1.0, 3.0, 1.0, 1.0])

cached_contour = cache(contour)


@st.composite
def smooth_paths(draw: st.DrawFn) -> Path:
    """Ellipses to 1:20, stars, and splines of random control polygons that always go forward."""
    kind = draw(st.sampled_from(["ellipse", "star", "spline"]))
    if kind == "ellipse":
        a = draw(st.floats(1e-3, 1.0))
        return Path([Ellipse(a, a * draw(st.floats(0.05, 20.0)))], closed=True)
    if kind == "star":
        return Path([Star(draw(st.floats(1e-3, 1.0)), draw(st.integers(2, 9)), draw(st.floats(0.0, 0.8)))], closed=True)
    n = draw(st.integers(4, 9))
    y = draw(st.lists(st.floats(-1.0, 1.0), min_size=n, max_size=n))
    points = np.column_stack([np.linspace(0.0, 1.0, n), y]) * draw(st.floats(0.01, 1.0))
    knots = np.concatenate([[0.0] * 3, np.linspace(0.0, 1.0, n - 2), [1.0] * 3])
    weights = draw(st.lists(st.floats(0.3, 3.0), min_size=n, max_size=n))
    return Path([Nurbs(3, points, knots, weights)])


def moved(points: Array, angle: float, shift: Array, scale: float) -> Array:
    rotation = np.array([(math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle))])
    return scale * (points @ rotation) + shift


def mixed_path(angle: float = 0.0, shift: tuple[float, float] = (0.0, 0.0), scale: float = 1.0, reverse: bool = False) -> Path:
    """A path of line, arc and NURBS with a corner, moved, scaled, or run backwards: always built from moved or reversed data."""
    go = np.array(shift)
    begin, turn = moved(np.array([(-0.04, -0.02), (0.0, -0.02)]), angle, go, scale)
    centre, spline = moved(np.array([(0.0, -0.01)]), angle, go, scale)[0], moved(POINTS, angle, go, scale)
    first, sweep = angle - math.pi / 2, math.pi
    if not reverse:
        return Path([Line(begin, turn), Arc(centre, 0.01 * scale, first, sweep), Nurbs(3, spline, KNOTS, WEIGHTS)])
    back = Nurbs(3, spline[::-1], (1.0 - KNOTS)[::-1], WEIGHTS[::-1])
    return Path([back, Arc(centre, 0.01 * scale, first + sweep, -sweep), Line(turn, begin)])


PLAIN = mixed_path()


@few
@given(
    st.floats(-7.0, 7.0), st.tuples(st.floats(-2.0, 2.0), st.floats(-2.0, 2.0)), st.sampled_from([1e-3, 0.1, 1.0, 30.0]), st.integers(0, 99)
)
def test_curves_follow_motion_and_scale(angle: float, shift: tuple[float, float], scale: float, seed: int) -> None:
    path, rng = mixed_path(angle, shift, scale), np.random.default_rng(seed)
    s = rng.uniform(0.0, PLAIN.length, 12)
    # A shift of metres costs digits in the data of a curve of a tenth of a millimetre.
    digits = 1e-15 * (math.hypot(*shift) + scale)
    assert math.isclose(path.length, scale * PLAIN.length, rel_tol=1e-13, abs_tol=20.0 * digits)
    np.testing.assert_allclose(path.position(scale * s), moved(PLAIN.position(s), angle, np.array(shift), scale), rtol=0, atol=1e2 * digits)
    blur = 1e3 * digits / scale
    np.testing.assert_allclose(path.curvature(scale * s) * scale, PLAIN.curvature(s), rtol=0, atol=1e-9 + 1e5 * blur)
    points = PLAIN.position(s) + rng.uniform(-3e-3, 3e-3, (12, 2))
    a = PLAIN.foot_point(points, s, 8e-3)
    b = path.foot_point(moved(points, angle, np.array(shift), scale), scale * s, 8e-3 * scale)
    np.testing.assert_allclose(b.signed, scale * a.signed, rtol=0, atol=1e2 * digits)


@few
@given(st.integers(0, 10_000))
@pytest.mark.slow
def test_a_reversed_path_is_the_same_with_exchanged_sides(seed: int) -> None:
    path, back, rng = PLAIN, mixed_path(reverse=True), np.random.default_rng(seed)
    length = path.length
    assert math.isclose(back.length, length, rel_tol=1e-13)
    s = rng.uniform(0.0, length, 20)
    np.testing.assert_allclose(back.position(length - s), path.position(s), rtol=0, atol=1e-14)
    np.testing.assert_allclose(back.tangent(length - s), -path.tangent(s), rtol=0, atol=1e-10)
    np.testing.assert_allclose(back.curvature(length - s), -path.curvature(s), rtol=0, atol=1e-7)
    np.testing.assert_allclose(back.curvature_derivative(length - s), path.curvature_derivative(s), rtol=1e-6, atol=1e-2)
    points = path.position(s) + rng.uniform(-4e-3, 4e-3, (20, 2))
    here, there = path.foot_point(points, s, 0.01), back.foot_point(points, length - s, 0.01)
    np.testing.assert_allclose(there.signed, -here.signed, rtol=0, atol=1e-14)


@some
@given(names, unit, st.floats(1e-7, 0.03), st.floats(0.0, 2.0 * math.pi), st.floats(1e-3, 1.0), st.floats(-1.0, 1.0))
def test_the_foot_is_no_further_than_any_point_of_its_window(
    name: str, part: float, reach: float, angle: float, width: float, early: float
) -> None:
    path = cached_contour(name)
    s, window = part * path.length, width * path.length
    point = path.position(s)[0] + reach * np.array([math.cos(angle), math.sin(angle)])
    around = s + early * 0.5 * window
    found = path.foot_point([point], [around], window)
    low, high = (around - window, around + window) if path.closed else np.clip([around - window, around + window], 0.0, path.length)
    if path.closed:
        low, high = max(low, around - 0.5 * path.length), min(high, around + 0.5 * path.length)
    samples = np.append(np.linspace(low, high, 3000), np.clip(s, low, high))
    least = np.linalg.norm(path.position(samples) - point, axis=1).min()
    assert found.distance[0] <= least + 1e-15
    # It also lies in the window and on the path, at the reported distance.
    assert low - 1e-12 * path.length <= found.arc_length[0] <= high + 1e-12 * path.length
    np.testing.assert_allclose(path.position(found.arc_length), found.position, rtol=0, atol=1e-12 * path.length)
    assert math.isclose(float(np.linalg.norm(found.position[0] - point)), found.distance[0], rel_tol=1e-12, abs_tol=1e-17)
    # Tracking error is never less than contour error.
    assert found.distance[0] <= np.linalg.norm(path.position(np.clip(around, low, high)) - point, axis=1)[0] + 1e-15


@some
@given(smooth_paths(), unit, st.floats(-0.9, 0.9))
@pytest.mark.slow
def test_a_point_on_a_normal_has_its_foot_at_its_root(path: Path, part: float, share: float) -> None:
    s = part * path.length
    window = 0.01 * path.length
    near = np.clip(s + np.linspace(-window, window, 201), 0.0, path.length) if not path.closed else s + np.linspace(-window, window, 201)
    offset = share * min(1.0 / max(float(np.abs(path.curvature(near)).max()), 1e-9), path.length)
    point = path.position(s) + offset * path.normal(s)
    found = path.foot_point(point, [s], window)
    # Within the radii of curvature of an arc that turns by less than half a turn, no other point comes closer.
    if np.sum(np.abs(np.diff(near)) * np.abs(path.curvature(near[1:]))) < math.pi / 2:
        assert abs(found.arc_length[0] - s) <= 1e-12 * path.length
        assert abs(found.signed[0] - offset) <= 1e-13 * path.length


@some
@given(smooth_paths(), st.floats(-12.0, -2.0), st.lists(unit, min_size=30, max_size=30), st.integers(1, 60))
@pytest.mark.slow
def test_the_table_keeps_its_bound_everywhere(path: Path, exponent: float, parts: list[float], pieces: int) -> None:
    tolerance = 10.0**exponent * path.length
    table = path.table(tolerance, pieces=pieces)
    s = np.concatenate(
        [np.array(parts) * path.length, (table.start[:-1, None] + np.diff(table.start)[:, None] * np.array(parts[:6])).ravel()]
    )
    off = np.linalg.norm(table.evaluate(s, 0)[0] - path.position(s), axis=1)
    assert off.max() <= table.error_bound + 1e-13 * path.length
    assert table.error_bound <= tolerance
    assert len(table.coefficients) >= pieces


@some
@given(smooth_paths())
def test_arc_length_is_arc_length(path: Path) -> None:
    s = np.linspace(0.0, path.length, 301)
    assert np.abs(np.linalg.norm(path.tangent(s), axis=1) - 1.0).max() < 1e-13
    # A chord is never longer than its arc, and shorter by kappa^2 h^3 / 24 at most, kappa being the greatest on it.
    points = path.position(s)
    chord, h = np.linalg.norm(np.diff(points, axis=0), axis=1), path.length / 300
    rounding = 2e-13 * path.length + 4.0 * np.finfo(float).eps * np.abs(points).max()  # each end lies within 1e-13 of the length
    bend = np.abs(path.curvature(np.linspace(0.0, path.length, 6001)))
    assert (chord <= h + rounding).all()
    assert (chord >= h - 1.05 * bend.max() ** 2 * h**3 / 24.0 - rounding).all()


@few
@given(smooth_paths(), unit)
def test_a_closed_path_is_the_same_in_every_lap(path: Path, part: float) -> None:
    if not path.closed:
        return
    s = part * path.length
    laps = np.array([-7.0, -1.0, 1.0, 12.0])
    np.testing.assert_allclose(
        path.position(s + laps * path.length), np.repeat(path.position(s), 4, axis=0), rtol=0, atol=1e-13 * path.length
    )
