"""Paths: joints, corners, laps, normals and curvature, and refusals."""

from __future__ import annotations

import hashlib
import math
import struct
from itertools import pairwise

import numpy as np
import pytest

from contourlab.errors import GeometryError
from contourlab.geometry import Arc, BSpline, Line, Path, contour
from contourlab.geometry.parametric import Ellipse

SQUARE = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.0)]


def polyline(points: list[tuple[float, ...]], closed: bool = False) -> Path:
    return Path([Line(a, b) for a, b in pairwise(points)], closed=closed)


@pytest.fixture
def mixed() -> Path:
    """Return line, arc and spline, smooth at the first joint and with a corner at the second."""
    arc = Arc((0.03, 0.01), 0.01, -math.pi / 2, math.pi)
    spline = BSpline(3, [(0.03, 0.02), (0.02, 0.04), (0.0, 0.03), (-0.01, 0.05)], [0, 0, 0, 0, 1, 1, 1, 1])
    return Path([Line((0.0, 0.0), (0.03, 0.0)), arc, spline, Line((-0.01, 0.05), (-0.01, 0.07))])


def test_breaks_and_corners_of_an_open_and_a_closed_square() -> None:
    opened, closed = polyline(SQUARE), polyline(SQUARE, closed=True)
    np.testing.assert_array_equal(opened.breaks, [0, 1, 2, 3, 4])
    assert opened.length == 4.0
    np.testing.assert_array_equal(opened.corners, [1, 2, 3])
    np.testing.assert_array_equal(closed.corners, [0, 1, 2, 3])


def test_a_tangent_joint_is_no_corner_even_if_the_curvature_jumps(mixed: Path) -> None:
    np.testing.assert_allclose(mixed.corners, mixed.breaks[2:4], rtol=1e-15)
    before, after = mixed.breaks[1] + np.array([-1e-9, 1e-9])
    assert mixed.curvature(before)[0] == 0.0
    assert mixed.curvature(after)[0] == pytest.approx(100.0)


@pytest.mark.parametrize(("angle", "is_corner"), [(1e-2, True), (2e-6, True), (5e-7, False), (0.0, False)])
def test_a_corner_turns_by_more_than_a_microradian(angle: float, is_corner: bool) -> None:
    path = polyline([(0.0, 0.0), (1.0, 0.0), (1.0 + math.cos(angle), math.sin(angle))])
    assert path.corners.size == is_corner


def test_a_turn_back_is_a_corner() -> None:
    np.testing.assert_array_equal(polyline([(0.0, 0.0), (2.0, 0.0), (1.0, 0.0)]).corners, [2.0])
    np.testing.assert_array_equal(Path([Line((0.0,), (2.0,)), Line((2.0,), (-1.0,))]).corners, [2.0])


def test_a_joint_belongs_to_the_curve_that_begins_there() -> None:
    path = polyline(SQUARE)
    s = [0.0, 0.5, 1.0, np.nextafter(2.0, 0.0), 2.0, 4.0]
    np.testing.assert_array_equal(path.curve_index(s), [0, 0, 1, 1, 2, 3])
    np.testing.assert_array_equal(path.tangent([1.0]), [(0.0, 1.0)])
    np.testing.assert_array_equal(polyline(SQUARE, closed=True).curve_index([4.0, -0.5, 9.5]), [0, 3, 1])


def test_every_part_equals_its_curve_to_the_last_bit_of_the_sum(mixed: Path) -> None:
    for curve, begin in zip(mixed.curves, mixed.breaks[:-1], strict=True):
        along = np.linspace(0.0, curve.length, 41)[1:-1]
        expected = curve.derivatives(along)
        found = mixed.derivatives(begin + along)
        for order in range(4):
            size = max(np.abs(expected[order]).max(), 1e-3)
            np.testing.assert_allclose(found[order], expected[order], rtol=0, atol=1e-11 * size)


def test_order_of_samples_does_not_matter(mixed: Path) -> None:
    s = np.linspace(0.0, mixed.length, 101)
    shuffled = np.random.default_rng(5).permutation(101)
    np.testing.assert_array_equal(mixed.derivatives(s[shuffled]), mixed.derivatives(s)[:, shuffled])
    one_by_one = np.concatenate([mixed.derivatives(x) for x in s], axis=1)
    np.testing.assert_allclose(one_by_one, mixed.derivatives(s), rtol=1e-14, atol=1e-15)


def test_a_closed_path_continues_in_laps_and_an_open_one_stops() -> None:
    closed = contour("star")
    s = np.linspace(0.01, 0.99, 23) * closed.length
    for lap in (-2, -1, 1, 1000):
        np.testing.assert_allclose(closed.position(s + lap * closed.length), closed.position(s), rtol=0, atol=1e-13)
    opened = polyline(SQUARE[:4])
    np.testing.assert_array_equal(opened.position([-1.0, 99.0]), [(0.0, 0.0), (0.0, 1.0)])


@pytest.mark.parametrize("name", ["circle", "ellipse", "lemniscate", "star", "butterfly"])
def test_a_smooth_closed_contour_has_no_seam(name: str) -> None:
    path = contour(name)
    assert path.corners.size == 0
    before, after = path.derivatives([np.nextafter(path.length, 0.0), 0.0], 1).transpose(1, 0, 2)
    np.testing.assert_allclose(before, after, rtol=0, atol=1e-12)


def test_normals_point_left_in_the_plane_and_to_the_centre_in_space() -> None:
    clockwise = contour("circle", radius=0.5, clockwise=1)
    s = np.linspace(0.0, clockwise.length, 9)
    outward = clockwise.position(s) / 0.5
    np.testing.assert_allclose(clockwise.normal(s), outward, atol=1e-14)
    np.testing.assert_allclose(clockwise.curvature(s), -2.0, rtol=1e-14)
    lifted = Path([Arc((0.0, 0.0, 1.0), 0.5, 0.0, -2.0 * math.pi)])
    np.testing.assert_allclose(lifted.normal(s)[:, :2], -outward, atol=1e-14)
    np.testing.assert_allclose(lifted.curvature(s), 2.0, rtol=1e-14)
    straight = Path([Line((0.0, 0.0, 0.0), (1.0, 2.0, 3.0))])
    for values in (straight.normal([0.5]), straight.curvature([0.5]), straight.curvature_derivative([0.5])):
        np.testing.assert_array_equal(values, np.zeros_like(values))


def test_curvature_in_space_is_that_of_the_plane_it_lies_in() -> None:
    points = np.array([(0.0, 0.0), (1.0, 2.0), (3.0, 1.0), (4.0, 5.0)])
    knots, tilt = [0, 0, 0, 0, 1, 1, 1, 1], np.array([(0.6, 0.0, 0.8), (0.0, 1.0, 0.0)])
    flat, tilted = Path([BSpline(3, points, knots)]), Path([BSpline(3, points @ tilt, knots)])
    s = np.linspace(0.0, flat.length, 50)
    kappa = flat.curvature(s)
    assert kappa.min() < 0.0 < kappa.max()
    np.testing.assert_allclose(tilted.curvature(s), np.abs(kappa), rtol=1e-11, atol=1e-12)
    np.testing.assert_allclose(tilted.curvature_derivative(s), flat.curvature_derivative(s) * np.sign(kappa), rtol=1e-10, atol=1e-10)
    assert flat.is_planar
    assert not tilted.is_planar


def test_a_gap_is_refused_with_its_place() -> None:
    lines = [Line((0.0, 0.0), (1.0, 0.0)), Line((1.0, 0.0), (1.0, 1.0)), Line((1.0, 1.5), (0.0, 0.0))]
    with pytest.raises(GeometryError, match=r"curve 3 .*0\.5 m.*curve 2, .*\[1\.0, 1\.0\]"):
        Path(lines)
    near = [Line((0.0, 0.0), (1.0, 0.0)), Line((1.0, 0.9e-9), (1.0, 1.0))]
    assert Path(near).length == pytest.approx(2.0)
    with pytest.raises(GeometryError, match=r"curve 2 .*1\.1e-09 m"):
        Path([near[0], Line((1.0, 1.1e-9), (1.0, 1.0))])


def test_an_invalid_path_is_refused() -> None:
    with pytest.raises(GeometryError, match="one curve"):
        Path([])
    with pytest.raises(GeometryError, match="coordinates"):
        Path([Line((0.0, 0.0), (1.0, 0.0)), Line((1.0, 0.0, 0.0), (1.0, 1.0, 0.0))])
    with pytest.raises(GeometryError, match="must end"):
        polyline(SQUARE[:4], closed=True)


def test_the_digest_depends_only_on_the_geometry(mixed: Path) -> None:
    assert mixed.digest == Path(list(mixed.curves)).digest
    paths = [mixed, polyline(SQUARE), polyline(SQUARE, closed=True), polyline(SQUARE[::-1]), polyline(SQUARE[:3])]
    paths += [Path([Ellipse(0.04, 0.02)]), Path([Ellipse(0.04, 0.020000000000000004)]), contour("ellipse"), contour("circle")]
    paths += [contour("circle", clockwise=1), contour("circle", start_angle=1.0), contour("star"), contour("star", lobes=6)]
    assert len({path.digest for path in paths}) == len(paths)
    written = b"open" + b"line" + struct.pack("<4d", 0.0, 0.0, 3.0, 4.0)
    assert Path([Line((0, 0), (3, 4))]).digest == hashlib.sha256(written).hexdigest()
