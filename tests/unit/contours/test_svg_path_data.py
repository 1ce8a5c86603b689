"""SVG path data: the grammar, the curves of the standard, and error handling."""

from __future__ import annotations

import math
from pathlib import Path as File

import numpy as np
import pytest
from drawings import MM, svg
from hypothesis import given
from hypothesis import strategies as st

from contourlab.contours import read_contour
from contourlab.contours.drawing import ConicShape, LineShape, Shape, SplineShape
from contourlab.contours.svg import path_shapes, read_svg


def only(data: str) -> list[Shape]:
    """Return the shapes of data with one subpath and no error."""
    parts, trouble = path_shapes(data)
    assert trouble is None
    assert len(parts) == 1
    return parts[0]


def corners(shapes: list[Shape]) -> list[tuple[float, ...]]:
    """Return the end points of connected lines."""
    assert all(isinstance(shape, LineShape) for shape in shapes)
    return [tuple(shapes[0].start), *(tuple(shape.end) for shape in shapes)]  # type: ignore[union-attr]


def control(shape: Shape) -> list[list[float]]:
    assert isinstance(shape, SplineShape)
    return shape.points.tolist()  # type: ignore[no-any-return]


@pytest.mark.parametrize(
    ("data", "last"),
    [
        # After another family or none, the first control point is the current point (SVG 2, 9.3.6 and 9.3.7).
        ("M30 20 q-10 0 -20 -10 s 3 4 5 5", [[10, 10], [10, 10], [13, 14], [15, 15]]),
        ("M30 20 t 4 4 s 3 4 5 5", [[34, 24], [34, 24], [37, 28], [39, 29]]),
        ("M10 10 L20 10 S 25 5 30 10", [[20, 10], [20, 10], [25, 5], [30, 10]]),
        ("M0 0 C 0 10 10 10 10 0 T 30 5", [[10, 0], [10, 0], [30, 5]]),
        ("M0 0 c 0 10 10 10 10 0 s 1 1 2 2 t 20 5", [[12, 2], [12, 2], [32, 7]]),
        ("M0 0 Q 5 5 10 0 L 20 0 T 30 5", [[20, 0], [20, 0], [30, 5]]),
        ("M0 0 Q 5 5 10 0 M 20 0 T 30 5", [[20, 0], [20, 0], [30, 5]]),
        # After the same family, the last control point is reflected at the current point, repeatedly.
        ("M0 0 C 0 10 10 10 10 0 S 20 -10 20 0", [[10, 0], [10, -10], [20, -10], [20, 0]]),
        ("M0 0 c 0 10 10 10 10 0 s 10 -5 10 0 s 7 7 8 0", [[20, 0], [20, 5], [27, 7], [28, 0]]),
        ("M0 0 Q 5 8 10 0 T 20 0", [[10, 0], [15, -8], [20, 0]]),
        ("M0 0 q 5 8 10 0 t 10 0 10 0", [[20, 0], [25, 8], [30, 0]]),
    ],
)
def test_smooth_curves_reflect_only_their_own_family(data: str, last: list[list[float]]) -> None:
    parts, trouble = path_shapes(data)
    assert trouble is None
    assert control(parts[-1][-1]) == last


def test_the_curve_on_the_machine_equals_the_drawn_one(tmp_path: File) -> None:
    path = read_contour(svg(tmp_path, '<path d="M30 20 q-10 0 -20 -10 t 3 4 S 60 40 70 10"/>'))
    # t: its control point is 2 (10, 10) - (20, 20) = (0, 0); S after it starts from (13, 14) towards (60, 40).
    half = 0.25 * np.array([10, 10]) + 0.25 * np.array([13, 14])
    s = np.linspace(0.0, path.length, 20001)
    near = np.linalg.norm(path.position(s) - MM * np.array([half[0], 80 - half[1]]), axis=1)
    assert near.min() < path.length / 20000
    tangent = path.curves[-1].derivatives([1e-4], 1)[1, 0]
    np.testing.assert_allclose(math.atan2(tangent[1], tangent[0]), math.atan2(-26, 47), atol=0.01)


@pytest.mark.parametrize(
    ("data", "points"),
    [
        ("M1.5.5-3e2,2", [(1.5, 0.5), (-300, 2)]),
        ("M1-2-3-4", [(1, -2), (-3, -4)]),
        ("m1,2 3,4 , 5 6", [(1, 2), (4, 6), (9, 12)]),
        ("M 1 2 3 4", [(1, 2), (3, 4)]),
        ("\n M0+.5\tH 4V8h-1 -1v2", [(0, 0.5), (4, 0.5), (4, 8), (3, 8), (2, 8), (2, 10)]),
        ("M0 0L1e1.5.25E1 3.", [(0, 0), (10, 0.5), (2.5, 3)]),
        ("M1 1h3v3z", [(1, 1), (4, 1), (4, 4), (1, 1)]),
    ],
)
def test_the_grammar_of_numbers(data: str, points: list[tuple[float, ...]]) -> None:
    assert corners(only(data)) == points


def test_drawing_continues_from_the_start_of_a_closed_subpath() -> None:
    parts, trouble = path_shapes("m5 5 h3 v3 z l-2 0 m 1 1 l 1 0 z m 10 0 h 1")
    assert trouble is None
    # The second starts at (5, 5) and ends at (3, 5); the third starts at (4, 6), and its z returns there.
    assert [corners(part) for part in parts] == [
        [(5, 5), (8, 5), (8, 8), (5, 5)],
        [(5, 5), (3, 5)],
        [(4, 6), (5, 6), (4, 6)],
        [(14, 6), (15, 6)],
    ]


@pytest.mark.parametrize(
    ("data", "drawn", "character", "word"),
    [
        ("M 1 1 L foo", 0, 9, "number"),
        ("M0 0L5 5 x", 1, 10, "'x'"),
        ("M0 0L5 5 6", 1, 11, "number"),
        ("M0 0L5 5,", 1, 10, "number"),
        ("M0 0L5 5,L6 6", 1, 10, "number"),
        ("M0 0L,5 5", 0, 6, "number"),
        ("M0 0 1 1,,2 2", 1, 10, "number"),
        ("L5 5", 0, 1, "'L'"),
        ("M0 0H5A1 1 0 2 0 3 3", 1, 14, "flag"),
        ("M0 0H5V1e99", 1, 8, "1e99"),
        ("M0 0h5 none", 1, 8, "'n'"),
    ],
)
def test_data_are_drawn_up_to_the_first_error(data: str, drawn: int, character: int, word: str) -> None:
    parts, trouble = path_shapes(data)
    assert sum(map(len, parts)) == drawn
    assert trouble is not None and f" {character}: " in trouble and word in trouble


def test_an_error_is_noted_with_its_element(tmp_path: File) -> None:
    drawing = read_svg(svg(tmp_path, '<path id="a" d="M 1 1 L 4 5 L foo"/><path d="hello"/><path/>'))
    assert len(drawing.chains) == 1
    assert drawing.chains[0].length == pytest.approx(5 * MM)
    expected = (("path 'a': ", " 15: "), ("path, element 2: ", " 1: "), ("path, element 3: ", "length"))
    for note, (start, word) in zip(drawing.notes, expected, strict=True):
        assert note.startswith(start) and word in note


def conic(data: str) -> ConicShape:
    (shape,) = only(data)
    assert isinstance(shape, ConicShape)
    return shape


def at(shape: ConicShape, angle: float) -> np.ndarray:
    return np.asarray(shape.centre + shape.p * math.cos(angle) + shape.q * math.sin(angle))


@pytest.mark.parametrize(
    ("flags", "centre", "sweep"),
    [("00", (10, 0), -math.pi / 2), ("01", (0, 10), math.pi / 2), ("10", (0, 10), -1.5 * math.pi), ("11", (10, 0), 1.5 * math.pi)],
)
def test_the_four_arcs_between_two_points(flags: str, centre: tuple[float, float], sweep: float) -> None:
    """From (0, 0) to (10, 10) with a radius of 10; a positive sweep turns x towards y."""
    shape = conic(f"M0 0A10 10 0 {flags}10 10")
    np.testing.assert_allclose(shape.centre, centre, atol=1e-14)
    assert shape.end - shape.start == pytest.approx(sweep, rel=1e-14)


def test_too_small_radii_are_scaled_up() -> None:
    shape = conic("M10 10a1 1 0 0 1 20 0")
    np.testing.assert_allclose(shape.centre, [20, 10], atol=1e-14)
    assert np.linalg.norm(shape.p) == pytest.approx(10, rel=1e-15)
    tall = conic("M0 0a-1 3 90 0 1 12 0")  # turned by 90 degrees, 3 lies along x; signs of radii are ignored
    np.testing.assert_allclose([np.linalg.norm(tall.p), np.linalg.norm(tall.q)], [2, 6], rtol=1e-14)
    np.testing.assert_allclose(tall.centre, [6, 0], atol=1e-14)


def test_arcs_without_a_radius_and_without_a_chord() -> None:
    assert corners(only("M0 0a0 5 0 0 1 3 4a5 0 0 1 1 1 1")) == [(0, 0), (3, 4), (4, 5)]
    assert path_shapes("M0 0a5 5 0 1 1 0 0") == ([], None)


size = st.floats(0.1, 100.0)
place = st.floats(-100.0, 100.0)


@given(size, size, st.floats(-720.0, 720.0), st.booleans(), st.booleans(), place, place)
def test_arcs_end_at_their_given_end_points(rx: float, ry: float, turn: float, large: bool, sweep: bool, x: float, y: float) -> None:
    if math.hypot(x, y) < 1e-3:
        return
    shape = conic(f"M1 2a{rx!r} {ry!r} {turn!r} {large:d}{sweep:d}{x!r} {y!r}")
    far = 1e-10 * (max(rx, ry) / min(rx, ry)) * max(rx, ry, 100.0)
    np.testing.assert_allclose(at(shape, shape.start), [1, 2], atol=far)
    np.testing.assert_allclose(at(shape, shape.end), [1 + x, 2 + y], atol=far)
    angle = shape.end - shape.start
    assert (angle > 0) == sweep
    assert abs(angle) >= math.pi - 1e-5 if large else abs(angle) <= math.pi + 1e-5
    assert np.linalg.norm(shape.p) / np.linalg.norm(shape.q) == pytest.approx(rx / ry, rel=1e-12)
    # Check the rotation of the ellipse: p lies along its first axis.
    assert shape.p @ [-math.sin(math.radians(turn)), math.cos(math.radians(turn))] == pytest.approx(0.0, abs=1e-9 * np.linalg.norm(shape.p))


@given(st.text("MmLlHhVvCcSsQqTtAaZz0123456789.,+-eE \n", max_size=60))
def test_any_text_gives_curves_or_an_error_with_its_place(data: str) -> None:
    parts, trouble = path_shapes(data)
    assert all(np.isfinite(shape.extent()).all() for part in parts for shape in part)
    if trouble is not None:
        number = int(trouble.split()[3].rstrip(":"))
        assert 1 <= number <= len(data) + 1
        # The text before the error draws the same: the text after it has no effect.
        again, _ = path_shapes(data[: number - 1])
        assert [len(part) for part in again] == [len(part) for part in parts]
