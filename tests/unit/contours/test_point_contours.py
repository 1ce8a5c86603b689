"""Point files: reading, interpolating and smoothing splines, corners."""

from __future__ import annotations

import math
import re
from pathlib import Path as File

import numpy as np
import pytest
from drawings import away
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.special import ellipe

from contourlab.contours import read_contour, study_contour
from contourlab.contours.fit import fit_points
from contourlab.contours.reader import read_points
from contourlab.errors import GeometryError, UnitError
from contourlab.geometry import Line

ANGLE = math.radians(30.0)


def written(folder: File, text: str) -> File:
    file = folder / "points.csv"
    file.write_text(text, encoding="utf-8")
    return file


def ellipse(n: int) -> np.ndarray:
    """Points of an ellipse of 40 by 20 mm at alternating distances; the last is the first."""
    u = np.linspace(0.0, 2.0 * math.pi, n)
    u[1:-1:2] += 0.3 * u[1]
    points = 1e-3 * np.column_stack([40 * np.cos(u), 20 * np.sin(u)])
    points[-1] = points[0]
    return points


def rounding(points: np.ndarray) -> str:
    return "\n".join(",".join(repr(float(1e3 * x)) for x in row) for row in points)


@pytest.mark.parametrize(
    "text",
    [
        "x [mm],y [mm]\n0,0\n30,40\n",
        "# measured on Tuesday\n\nx (mm); y (mm)\n0,0; 0,0\n30,0; 40,0 # the end\n",
        "y [mm]\tx [cm]\n0\t0\n40\t3\n",
        "0 0\n30 40\n",
        "x,y\n0,0\n30,40",
        "\ufeffX [mm], Y [mm]\r\n0, 0\r\n3e1, 4e1\r\n",
        "x [mm]  y [mm]\n0 0\n30 40\n",
    ],
)
def test_ways_to_write_two_points(tmp_path: File, text: str) -> None:
    path = read_contour(written(tmp_path, text), unit=None if "[" in text or "(" in text else "mm")
    np.testing.assert_allclose(path.position([0.0, path.length]), [(0.0, 0.0), (0.03, 0.04)], rtol=0, atol=1e-17)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "no points"),
        ("x [mm],y [mm]\n", "but has 0"),
        ("x [mm],y [mm]\n1,2\n", "but has 1"),
        ("x [mm],y [mm]\n1,2\n1,2\n3,4\n", "csv:3: .*line 2"),
        ("x [mm],y [mm]\n1,2\n\n3\n", "csv:4: has 1 columns"),
        ("x [mm],y [mm]\n1,2\n3,4,5\n", "csv:3: has 3 columns"),
        ("x [mm],y [mm]\n1,2\n3,nan\n", "csv:3: nan"),
        ("x [mm],y [mm]\n1,2\n3,1e999\n", "csv:3: 1e999"),
        ("x [mm],y [mm]\n1,2\n3,four\n", "csv:3: 'four'"),
        ("x [mm],x [mm]\n1,2\n3,4\n", "csv:1: .*twice"),
        ("x [mm],7\n1,2\n3,4\n", "csv:1: '7'"),
        ("x,y\n1,2\n3,4\n", "csv:1: .*no unit"),
        ("1,2\n3,4\n", "csv:1: .*no unit"),
        ("a,b,c,d\n1,2,3,4\n", "csv:1: has 4 columns"),
        ("x [mm]\n1\n2\n", "csv:1: has 1 columns"),
    ],
)
def test_errors_name_their_line(tmp_path: File, text: str, message: str) -> None:
    with pytest.raises(GeometryError, match=message):
        read_contour(written(tmp_path, text))


def test_errors_in_units_and_settings(tmp_path: File) -> None:
    file = written(tmp_path, "x [mm],y [mm]\n1,2\n3,4\n5,5\n")
    with pytest.raises(GeometryError, match=r"\bmm\b.*unit = 'inch'"):
        read_contour(file, unit="inch")
    assert read_contour(file, unit="mm").n_axis == 2
    for wrong in ({"tolerance": 0.0}, {"corner_angle": 4.0}, {"corner_angle": 0.0}, {"layer": "cut"}, {"chain": 1}, {"scale": -1.0}):
        with pytest.raises(GeometryError):
            read_contour(file, **wrong)  # type: ignore[arg-type]
    with pytest.raises(GeometryError, match=r"csv:1: column x\b.* kg"):
        read_contour(written(tmp_path, "x [kg],y [kg]\n1,2\n3,4\n"))
    with pytest.raises(UnitError, match="kg"):
        read_contour(written(tmp_path, "1,2\n3,4\n"), unit="kg")
    (tmp_path / "latin.csv").write_bytes(b"x [mm],y [mm]\n1,2\n\xff,3\n")
    with pytest.raises(GeometryError, match=r"latin\.csv: .*byte 18"):
        read_contour(tmp_path / "latin.csv")


@pytest.mark.slow
def test_the_spline_converges_with_the_sixth_order() -> None:
    """Against the original ellipse; doubling the points leaves 1/64 of the error (1/16 with chord lengths as parameter)."""
    u = np.linspace(0.01, 6.2, 77)
    probe = 1e-3 * np.column_stack([40 * np.cos(u), 20 * np.sin(u)])
    errors = []
    for n in (81, 161, 321):
        fit = fit_points(ellipse(n), None, ANGLE)
        assert fit.path.closed
        assert fit.n_corner == 0
        errors.append(away(fit.path, probe))
    # Over two doublings, because the places of the probes between the points scatter each one; the limit is between orders four and six.
    assert math.log2(errors[0] / errors[2]) / 2.0 > 5.0, errors
    assert fit.path.length == pytest.approx(0.16 * ellipe(0.75), rel=1e-9)


def test_a_closed_spline_is_smooth_where_it_closes() -> None:
    fit = fit_points(ellipse(40), None, ANGLE)
    begin, end = fit.path.curves[0].derivatives([0.0, fit.path.length], 3).transpose(1, 0, 2)
    for k in range(4):
        np.testing.assert_allclose(begin[k], end[k], rtol=0, atol=1e-8 * max(1.0, float(np.abs(begin[k]).max())))


@given(
    steps=st.lists(st.tuples(st.floats(0.5, 2.0), st.floats(-1.0, 1.0), st.floats(-1.0, 1.0)), min_size=1, max_size=25),
    n_axis=st.sampled_from([2, 3]),
    angle=st.floats(0.1, 3.0),
)
@settings(max_examples=60)
@pytest.mark.slow
def test_every_point_lies_on_the_path(steps: list[tuple[float, float, float]], n_axis: int, angle: float) -> None:
    points = 1e-3 * np.cumsum(np.array([(0.0, 0.0, 0.0), *steps]), axis=0)[:, :n_axis]
    fit = fit_points(points, None, angle)
    assert fit.deviation < 1e-13
    np.testing.assert_allclose(fit.path.position([0.0, fit.path.length]), points[[0, -1]], rtol=0, atol=1e-12)
    s = np.linspace(0.0, fit.path.length, 20 * len(points))
    near = np.linalg.norm(fit.path.position(s)[:, None] - points, axis=2).min(axis=0)
    assert (near <= s[1]).all()


def test_sharp_turns_are_corners() -> None:
    """A square with points along its sides, from the middle of one, becomes four straight splines; it stops nowhere else."""
    side = np.linspace(-10.0, 10.0, 9)[:-1]
    square = np.concatenate(
        [np.column_stack(c) for c in ((side, -10 + 0 * side), (10 + 0 * side, side), (-side, 10 + 0 * side), (-10 + 0 * side, -side))]
    )
    square = 1e-3 * np.roll(square, -4, axis=0)
    fit = fit_points(np.concatenate([square, square[:1]]), None, ANGLE)
    assert fit.n_corner == 4
    np.testing.assert_allclose(fit.path.corners, [0.01, 0.03, 0.05, 0.07], rtol=0, atol=1e-12)
    assert fit.path.length == pytest.approx(0.08, rel=1e-12)
    np.testing.assert_allclose(fit.path.position(0.0), [(0.0, -0.01)], atol=1e-15)
    # The same from a corner, with only the corners as points.
    four = fit_points(1e-3 * np.array([(0, 0), (1, 0), (1, 1), (0, 1), (0, 0.0)]), None, ANGLE)
    assert all(isinstance(curve, Line) for curve in four.path.curves)
    assert four.path.corners.tolist() == pytest.approx([0.0, 1e-3, 2e-3, 3e-3])


def test_the_corner_angle_decides() -> None:
    zigzag = 1e-3 * np.array([(0, 0), (10, 0), (20, 10 * math.tan(math.radians(40))), (30, 10 * math.tan(math.radians(40)))])
    assert fit_points(zigzag, None, math.radians(39)).n_corner == 2
    assert fit_points(zigzag, None, math.radians(41)).n_corner == 0


@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.slow
def test_smoothing_stays_within_its_tolerance_and_reports_its_deviation(closed: bool) -> None:
    rng = np.random.default_rng(3)
    exact = ellipse(200) if closed else ellipse(200)[:150]
    noisy = exact + 2e-6 * rng.uniform(-1.0, 1.0, exact.shape)
    if closed:
        noisy[-1] = noisy[0]
    tolerance = 5e-6
    fit = fit_points(noisy, tolerance, math.radians(80))
    assert fit.path.closed == closed
    assert away(fit.path, noisy) <= fit.deviation * (1 + 1e-9) <= tolerance
    through = fit_points(noisy, None, math.radians(80))
    # The ellipse bends at most by a / b^2 = 100 /m; a curve through every noisy point bends more.
    bends = [float(np.abs(p.curvature(np.linspace(0.0, p.length, 2000))).max()) for p in (fit.path, through.path)]
    assert abs(bends[0] - 100.0) < abs(bends[1] - 100.0)
    if not closed:
        np.testing.assert_allclose(fit.path.position([0.0, fit.path.length]), noisy[[0, -1]], rtol=0, atol=1e-12)
    assert f"{1e6 * fit.deviation:.3g} um" in fit.note


def test_a_file_of_points_gives_its_original_contour(tmp_path: File) -> None:
    file = written(tmp_path, "x [mm],y [mm]\n" + rounding(ellipse(200)))
    found = study_contour(file)
    # The longest chord c, 1.3 steps of the ellipse, is most off at the largest curvature, 100 /m: by c^2 / 800.
    step = 2.0 * math.pi / 199.0
    most = max(100.0 * (0.02 * 1.3 * step) ** 2, (0.04 * 1.3 * step) ** 2 * 50.0 / 3.0) / 8.0
    numbers = re.search(r"^200 points.* (\S+) um .*\b0 corners.*closed", found.notes[0])
    assert numbers
    bulge = float(numbers[1])
    assert 0.5 * most < 1e-6 * bulge < 1.1 * most
    assert found.path.length == pytest.approx(0.16 * ellipe(0.75), rel=1e-9)
    turned = read_points(file, reverse=True).path
    s = np.linspace(0.0, turned.length, 30)
    np.testing.assert_allclose(turned.position(s), found.path.position(found.path.length - s), rtol=0, atol=1e-9)


def test_three_columns_are_a_path_in_space(tmp_path: File) -> None:
    u = np.linspace(0.0, 4.0 * math.pi, 120)
    rows = np.column_stack([10 * np.cos(u), 10 * np.sin(u), u])
    path = read_contour(written(tmp_path, "\n".join(" ".join(map(repr, row)) for row in rows.tolist())), unit="mm")
    assert path.n_axis == 3
    assert path.length == pytest.approx(1e-3 * 4.0 * math.pi * math.hypot(10.0, 1.0), rel=1e-7)
