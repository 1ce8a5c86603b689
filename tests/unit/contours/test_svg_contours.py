"""SVG drawings: shapes, transforms, sizes and the downward axis, against closed forms."""

from __future__ import annotations

import math
from pathlib import Path as File

import numpy as np
import pytest
from drawings import MM, area, away, svg
from scipy.special import ellipe

from contourlab.contours import read_contour
from contourlab.contours.svg import read_svg
from contourlab.errors import GeometryError
from contourlab.geometry import Arc, BSpline, EllipticalArc, Line

HEIGHT = 80.0
"""Height of the drawing, in its user units."""


def seen(*points: tuple[float, float]) -> np.ndarray:
    """Return the machine coordinates of points of the drawing: y counts from the lower edge."""
    return MM * np.array([(x, HEIGHT - y) for x, y in points])


@pytest.mark.parametrize(
    ("body", "length", "enclosed"),
    [
        ('<rect x="10" y="5" width="30" height="20"/>', 100.0, 600.0),
        ('<rect x="10" y="5" width="30" height="20" rx="4"/>', 100 - 32 + 8 * math.pi, 600 - 64 + 16 * math.pi),
        ('<circle cx="20" cy="30" r="7"/>', 14 * math.pi, 49 * math.pi),
        ('<ellipse cx="20" cy="30" rx="10" ry="5"/>', 40 * ellipe(0.75), 50 * math.pi),
        ('<polygon points="0,0 3,0 3,4"/>', 12.0, 6.0),
        ('<path d="M 0 0 H 3 V 4 Z"/>', 12.0, 6.0),
        ('<path d="M 10 10 A 5 5 0 0 1 20 10 A 5 5 0 0 1 10 10"/>', 10 * math.pi, 25 * math.pi),
        ('<path d="m 0 0 a 10 5 0 1 0 20 0 a 10 5 0 1 0 -20 0"/>', 40 * ellipe(0.75), 50 * math.pi),
    ],
)
def test_closed_shapes(tmp_path: File, body: str, length: float, enclosed: float) -> None:
    path = read_contour(svg(tmp_path, body))
    assert path.closed
    assert path.length == pytest.approx(MM * length, rel=1e-12)
    assert abs(area(path)) == pytest.approx(MM**2 * enclosed, rel=1e-11)


def test_the_part_looks_like_the_drawing(tmp_path: File) -> None:
    """Clockwise on the screen is clockwise on the machine; the upper edge is up."""
    path = read_contour(svg(tmp_path, '<polyline points="10,10 40,10 40,30"/>'))
    np.testing.assert_allclose(path.position([0.0, 0.03, 0.05]), seen((10, 10), (40, 10), (40, 30)), atol=1e-15)
    assert area(read_contour(svg(tmp_path, '<polygon points="10,10 40,10 40,30"/>'))) == pytest.approx(-300 * MM**2)
    # A viewBox around the origin keeps its origin.
    centred = read_contour(svg(tmp_path, '<line x1="1" y1="2" x2="4" y2="6"/>', 'width="100mm" viewBox="-50 -50 100 100"'))
    np.testing.assert_allclose(centred.position([0.0, 0.005]), MM * np.array([(1, -2), (4, -6)]), atol=1e-15)


@pytest.mark.parametrize("sweep", [0, 1])
def test_elliptical_arcs_run_as_drawn(tmp_path: File, sweep: int) -> None:
    path = read_contour(svg(tmp_path, f'<path d="M10,10 A 10 5 0 0 {sweep} 30 10 L 30 30"/>'))
    # Half an ellipse around (20, 10): over its upper end where the sweep is clockwise on the screen.
    np.testing.assert_allclose(path.position([0.0, path.length]), seen((10, 10), (30, 30)), atol=1e-14)
    half = path.curves[0].length / 2.0
    np.testing.assert_allclose(path.position(half), seen((20, 10 - 5 if sweep else 10 + 5)), atol=1e-12)


def test_beziers_are_splines_of_their_degree(tmp_path: File) -> None:
    points = np.array([(5.0, 5.0), (20.0, 40.0), (50.0, -10.0), (60.0, 30.0)])
    t = np.linspace(0.0, 1.0, 21)[:, None]
    cubic = (1 - t) ** 3 * points[0] + 3 * t * (1 - t) ** 2 * points[1] + 3 * t**2 * (1 - t) * points[2] + t**3 * points[3]
    path = read_contour(svg(tmp_path, '<path d="M5,5 C20,40 50,-10 60,30"/>'))
    assert isinstance(path.curves[0], BSpline)
    assert path.curves[0].degree == 3
    assert away(path, seen(*cubic.tolist())) < 1e-13
    quadratic = (1 - t) ** 2 * points[0] + 2 * t * (1 - t) * points[1] + t**2 * points[2]
    path = read_contour(svg(tmp_path, '<path d="M5,5 Q20,40 50,-10"/>'))
    assert path.curves[0].degree == 2  # type: ignore[attr-defined]
    assert away(path, seen(*quadratic.tolist())) < 1e-13


def test_control_points_on_the_ends(tmp_path: File) -> None:
    """Drawing programs write straight lines as cubics with control points on the ends."""
    straight = read_contour(svg(tmp_path, '<path d="M0,0 C0,0 30,40 30,40"/>'))
    assert isinstance(straight.curves[0], Line)
    assert straight.length == pytest.approx(0.05, rel=1e-15)
    t = np.linspace(0.0, 1.0, 21)[:, None]
    cubic = 3 * t**2 * (1 - t) * np.array([30.0, 0.0]) + t**3 * np.array([30.0, 40.0])
    assert away(read_contour(svg(tmp_path, '<path d="M0,0 C0,0 30,0 30,40"/>')), seen(*cubic.tolist())) < 0.5e-6


@pytest.mark.parametrize(
    ("transform", "matrix"),
    [
        ("translate(7,-3)", [[1, 0, 7], [0, 1, -3]]),
        ("rotate(90)", [[0, -1, 0], [1, 0, 0]]),
        ("skewX(30)", [[1, math.tan(math.radians(30)), 0], [0, 1, 0]]),
        ("matrix(1 0.2 -0.5 2 3 4) scale(2)", [[2, -1, 3], [0.4, 4, 4]]),
        ("scale(-1,1)", [[-1, 0, 0], [0, 1, 0]]),
    ],
)
def test_transforms_are_exact_for_arcs_too(tmp_path: File, transform: str, matrix: list[list[float]]) -> None:
    """A skewed circle is an ellipse; its axes are not the images of the circle's axes."""
    m = np.array(matrix, dtype=float)
    for body in ('<circle cx="20" cy="10" r="6"/>', '<path d="M 26 10 A 6 6 0 1 1 14 10 A 6 6 0 1 1 26 10"/>'):
        path = read_contour(svg(tmp_path, f'<g transform="{transform}">{body}</g>'))
        angle = np.linspace(0.0, 2.0 * math.pi, 24)
        image = np.column_stack([20 + 6 * np.cos(angle), 10 + 6 * np.sin(angle)]) @ m[:, :2].T + m[:, 2]
        assert away(path, seen(*image.tolist())) < 1e-12
        assert abs(area(path)) == pytest.approx(MM**2 * 36 * math.pi * abs(np.linalg.det(m[:, :2])), rel=1e-10)
        assert {type(curve) for curve in path.curves} == ({EllipticalArc} if "skew" in transform or "matrix" in transform else {Arc})


@pytest.mark.parametrize(
    ("head", "unit", "size"),
    [
        ('width="100mm" height="50mm" viewBox="0 0 100 50"', None, 1e-3),
        ('width="4in" height="2in" viewBox="0 0 100 50"', None, 4 * 0.0254 / 100),
        ('width="10cm" viewBox="0 0 200 100"', None, 0.5e-3),
        ('width="100mm" height="100mm" viewBox="0 0 100 50"', None, 1e-3),
        ('width="100mm" height="50mm"', None, 0.0254 / 96),
        ('viewBox="0 0 100 50"', None, 0.0254 / 96),
        ('width="100%" height="100%" viewBox="0 0 100 50"', None, 0.0254 / 96),
        ("", None, 0.0254 / 96),
        ('viewBox="0 0 100 50"', "mm", 1e-3),
        ('width="4in" height="2in" viewBox="0 0 100 50"', "cm", 1e-2),
        ('width="72pt" height="36pt" viewBox="0 0 100 50"', None, 0.0254 / 100),
    ],
)
def test_sizes_of_user_units(tmp_path: File, head: str, unit: str | None, size: float) -> None:
    path = read_contour(svg(tmp_path, '<line x1="3" y1="1" x2="6" y2="5"/>', head), unit=unit)
    assert path.length == pytest.approx(5 * size, rel=1e-14)


def test_lengths_with_units_inside(tmp_path: File) -> None:
    path = read_contour(svg(tmp_path, '<circle cx="1in" cy="0" r="10mm"/>', ""))
    assert path.length == pytest.approx(0.02 * math.pi, rel=1e-14)
    np.testing.assert_allclose(path.position(0.0), [(0.0354, 0.0)], atol=1e-15)


def test_elements_without_a_contour_are_named(tmp_path: File) -> None:
    body = (
        '<text x="1" y="1">note</text><rect width="3" height="2"/><g style="display: none"><circle r="1"/></g>'
        '<defs><circle id="c" r="9"/></defs><clipPath id="q"><rect width="1" height="1"/></clipPath><foreignObject/>'
    )
    file = svg(tmp_path, body)
    with pytest.raises(
        GeometryError, match=r'1 hidden \(circle\); 1 foreignObject; 1 text.*write ignore = \["hidden", "foreignObject", "text"\]'
    ):
        read_contour(file)
    assert read_contour(file, ignore=["text", "hidden", "foreignObject"]).length == pytest.approx(10 * MM)
    used = svg(tmp_path, '<defs><circle id="c" r="9"/></defs><use href="#c" x="20" y="10"/>')
    assert read_contour(used).length == pytest.approx(18 * MM * math.pi, rel=1e-14)


def test_subpaths_are_separate_chains(tmp_path: File) -> None:
    file = svg(tmp_path, '<path id="both" d="M0,0 h10 v10 z M20,20 h5"/>')
    assert [chain.closed for chain in read_svg(file).chains] == [True, False]
    assert read_contour(file, chain=2).length == pytest.approx(5 * MM)


def test_an_arc_of_zero_radius_is_a_line(tmp_path: File) -> None:
    """SVG 2, section 9.5.1; an arc that ends where it starts is nothing."""
    path = read_contour(svg(tmp_path, '<path d="M0,0 A 0 5 0 0 1 10 0 A 5 5 0 0 1 10 0 V 5"/>'))
    assert path.length == pytest.approx(15 * MM)
    assert [type(curve) for curve in path.curves] == [Line, Line]
    (note,) = read_svg(svg(tmp_path, '<path d="M5,5 Z"/>')).notes
    assert note.startswith("path, element 1: ") and "no length" in note


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("<svg", "is not an SVG drawing"),
        ("<html/>", "<html>"),
        ('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1"/>', "viewBox"),
        ('<svg xmlns="http://www.w3.org/2000/svg" width="3em"/>', 'width = "3em" is not a size'),
        ('<svg xmlns="http://www.w3.org/2000/svg"/>', "no contour"),
    ],
)
def test_files_that_are_not_drawings(tmp_path: File, text: str, message: str) -> None:
    file = tmp_path / "part.svg"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(GeometryError, match=message):
        read_contour(file)
