"""From programs and paths to routes."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from refusals import refuses

from contourlab.errors import FeedError, ProgramError
from contourlab.feed import AxisLimits, Route, limit_report, plan, route_from_path, route_from_program
from contourlab.geometry import contour
from contourlab.program import parse_program

SLOT = """G21 G90
G0 X10 Y0
G1 X50 F6000
G3 X50 Y20 I0 J10 F3000
G4 P0.25
G1 X10
G1 X0 Y20
M2
"""


def test_each_move_becomes_a_curve_with_its_feed_and_line():
    route = route_from_program(parse_program(SLOT, "slot"), axes=("x", "y"))
    assert route.n_curve == 5
    assert route.path.n_axis == 2
    np.testing.assert_allclose(route.feedrate, [np.inf, 0.1, 0.05, 0.05, 0.05], rtol=1e-15)
    np.testing.assert_array_equal(route.rapid, [True, False, False, False, False])
    np.testing.assert_array_equal(route.source_line, [2, 3, 4, 6, 7])
    np.testing.assert_allclose(route.dwell, [0, 0, 0.25, 0, 0])
    expected = 0.01 + 0.04 + np.pi * 0.01 + 0.04 + 0.01
    assert route.path.length == pytest.approx(expected, rel=1e-14)


def test_an_arc_ends_at_its_programmed_end():
    route = route_from_program(parse_program("G21 G90 F600\nG2 X20 Y0 I10.0004 J0\nG1 X30\nM2\n"), axes=("x", "y"))
    breaks = route.path.breaks
    position = route.path.derivatives(np.array([breaks[1] * (1 - 1e-13), breaks[1] * (1 + 1e-13)]), 0)[0]
    np.testing.assert_allclose(position, [[0.02, 0.0]] * 2, atol=1e-12)


@pytest.mark.parametrize(
    ("plane", "words", "end"),
    [
        ("G17", "G3 X0 Y10 I-10 J0", (0.0, 0.01, 0.0)),
        ("G18", "G2 X0 Z10 I-10 K0", (0.0, 0.0, 0.01)),
        ("G17", "G2 X0 Y10 Z5 I-10 J0", (0.0, 0.01, 0.005)),
    ],
)
def test_arcs_and_helices_lie_where_programmed(plane, words, end):
    route = route_from_program(parse_program(f"G21 G90 {plane} F600\nG0 X10\n{words}\nM2\n"))
    arc = np.linspace(route.path.breaks[1], route.path.length, 101)
    position = route.path.derivatives(arc[1:], 0)[0]
    np.testing.assert_allclose(position[-1], end, atol=1e-15)
    in_plane = position[:, [0, 2]] if plane == "G18" else position[:, :2]
    np.testing.assert_allclose(np.linalg.norm(in_plane, axis=1), 0.01, rtol=1e-12)
    height = position[:, 1] if plane == "G18" else position[:, 2]
    np.testing.assert_allclose(height, np.linspace(0, 1, 101)[1:] * (end[1] if plane == "G18" else end[2]), atol=1e-15)


def test_the_sense_of_an_arc_is_kept():
    long_way = route_from_program(parse_program("G21 G90 F600\nG0 X10\nG2 X0 Y10 I-10 J0\nM2\n"), axes=("x", "y"))
    assert long_way.path.length == pytest.approx(0.01 + 1.5 * np.pi * 0.01, rel=1e-13)


def test_a_motion_of_a_missing_axis_names_its_line():
    with pytest.raises(ProgramError, match="moves Z") as caught:
        route_from_program(parse_program("G21 G90 F600\nG1 X10\nG1 Z-1\nM2\n", "part.ngc"), axes=("x", "y"))
    assert (caught.value.file, caught.value.line) == ("part.ngc", 3)


@pytest.mark.parametrize("axes", [(), ("x", "x"), ("x", "a")])
def test_axes_must_be_linear_axes(axes):
    with pytest.raises(FeedError, match="axes"):
        route_from_program(parse_program("G21 G90 F600\nG1 X10\nM2\n"), axes=axes)


def test_axes_may_be_in_any_order():
    route = route_from_program(parse_program("G21 G90 F600\nG1 X10 Y20\nM2\n"), axes=("y", "x"))
    np.testing.assert_allclose(route.path.derivatives(np.array([route.path.length]), 0)[0, 0], [0.02, 0.01])


def test_a_dwell_is_spent_at_rest():
    text = "G21 G90 F6000\nG4 P0.5\nG1 X10\nG4 P0.25\nG1 X20\nM2\n"
    still = text.replace("G4 P0.5\n", "").replace("G4 P0.25\n", "")
    limits = AxisLimits([0.5], [2.0], [50.0])
    with_rest = plan(route_from_program(parse_program(text), axes=("x",)), limits, 1e-3)
    half = plan(route_from_program(parse_program("G21 G90 F6000\nG1 X10\nM2\n"), axes=("x",)), limits, 1e-3)
    assert with_rest.duration == pytest.approx(2 * half.duration + 0.75, rel=1e-12)
    through = plan(route_from_program(parse_program(still), axes=("x",)), limits, 1e-3)
    assert through.duration < 2 * half.duration
    block = with_rest.block(0, with_rest.n_sample)
    assert np.all(block.position[:501] == 0.0)
    rest = np.abs(block.position[:, 0] - 0.01) < 1e-12
    assert rest.sum() >= 250


def test_rapid_moves_use_the_axis_limits():
    limits = AxisLimits([0.5, 0.25], [5.0, 5.0], [500.0, 500.0])
    route = route_from_program(parse_program("G21 G90 F60\nG0 X300 Y300\nG1 X310\nM2\n"), axes=("x", "y"))
    report = limit_report(plan(route, limits, 1e-3), limits)
    assert report.ok()
    assert report.velocity[1].ratio == pytest.approx(1.0, rel=1e-9)
    assert report.velocity[0].ratio == pytest.approx(0.5, rel=1e-9)


def test_source_lines_follow_the_motion():
    reference = plan(route_from_program(parse_program(SLOT), axes=("x", "y")), AxisLimits([0.5, 0.5], [2.0, 2.0], [50.0, 50.0]), 1e-3)
    breaks = reference.path.breaks
    middle = 0.5 * (breaks[1:] + breaks[:-1])
    np.testing.assert_array_equal(reference.source_line(middle), [2, 3, 4, 6, 7])


def test_bad_feeds_are_refused():
    path = contour("circle", radius=0.02)
    for feedrate in (0.0, -1.0, np.nan, np.inf):
        with pytest.raises(FeedError, match="feedrate"):
            route_from_path(path, feedrate)
    with pytest.raises(FeedError, match="dwell"):
        route_from_path(path, 0.1, dwell=-1.0)
    with pytest.raises(FeedError, match="source_line"):
        Route(path, 0.1, False, 0.0, [1, 2, 3])


COINCIDENT = {
    "G5.1 X10 I0 J0": [(0, 0), (0, 0), (10, 0)],
    "G5 I0 J0 P0 Q0 X10 Y10": [(0, 0), (0, 0), (10, 10), (10, 10)],
    "G5 I0 J0 P-10 Q10 X10 Y0": [(0, 0), (0, 0), (0, 10), (10, 0)],
    "G5 I10 J10 P0 Q0 X10 Y0": [(0, 0), (10, 10), (10, 0), (10, 0)],
    "G5.2 X0 Y0 P1\nX10 Y10 P2\nG5.3": [(0, 0), (0, 0), (10, 10)],
}


@pytest.mark.parametrize("block", COINCIDENT)
def test_coincident_control_points_at_an_end_keep_the_curve(block: str) -> None:
    """Compared with de Casteljau's points; LinuxCNC accepts these splines as well."""
    path = route_from_program(parse_program(f"G21 G17 F100\n{block}\nM2\n"), axes=("x", "y")).path
    layers = [np.array(point, dtype=float)[None, :] * 1e-3 for point in COINCIDENT[block]]
    u = np.linspace(0.0, 1.0, 101)[:, None]
    while len(layers) > 1:
        layers = [(1.0 - u) * one + u * other for one, other in pairwise(layers)]
    feet = path.foot_point(layers[0], np.full(101, 0.5 * path.length), path.length)
    assert np.abs(feet.distance).max() < 0.5e-6
    assert path.length == pytest.approx(float(np.linalg.norm(np.diff(layers[0], axis=0), axis=1).sum()), rel=1e-3)


@pytest.mark.parametrize("block", ["G5.1 X0 Y0 I1 J1", "G5 I10 J10 P-10 Q10 X10 Y0"])
def test_a_cusp_inside_a_spline_is_refused_with_its_line(block: str) -> None:
    with refuses(ProgramError, match="cusp", line=2):
        route_from_program(parse_program(f"G21 G17 F100\n{block}\nM2\n"), axes=("x", "y"))
