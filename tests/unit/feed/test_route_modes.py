"""The effect of a program's path control on a route, and its splines."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from contourlab.errors import FeedError
from contourlab.feed import Route, blended, route_from_program
from contourlab.geometry import BSpline, Line, Path
from contourlab.geometry.blend import Blend
from contourlab.program import Mode, parse_program

HEAD = "G21 G90 G1 F600\n"


def test_the_tolerance_of_a_corner_is_that_of_the_move_that_ends_there() -> None:
    program = parse_program(HEAD + "X1\nG64 P0.02 Q0.005\nX2\nY1\nG64 P0.03\nX3\nG61\nY2\nG61.1\nX4\nM2\n")
    route = route_from_program(program, ("x", "y"))
    np.testing.assert_allclose(route.corner_tolerance, [0, 2e-5, 2e-5, 3e-5, 0, 0], rtol=1e-12)
    np.testing.assert_allclose(route.merge_tolerance[[0, 1, 2, 4, 5]], [0, 5e-6, 5e-6, 0, 0], rtol=1e-12)
    np.testing.assert_array_equal(route.exact_stop, [False] * 5 + [True])
    found = blended(route)
    # Corners follow moves 2, 3, 4 and 5; the last one is exact.
    assert sum(isinstance(c, Blend) for c in found.path.curves) == 3
    np.testing.assert_allclose(found.path.position(found.path.corners), [(3e-3, 2e-3)], rtol=0, atol=1e-15)


def test_without_a_tolerance_corners_are_exact_by_default() -> None:
    program = parse_program(HEAD + "G64\nX1\nY1\nM2\n")
    assert not route_from_program(program, ("x", "y")).corner_tolerance.any()
    np.testing.assert_array_equal(route_from_program(program, ("x", "y"), default_tolerance=1e-5).corner_tolerance, [1e-5, 1e-5])


def test_a_programmed_spline_becomes_that_curve() -> None:
    program = parse_program(HEAD + "X10\nG5 I3 J2 P-1 Q-4 X20 Y5\nG1 X30\nM2\n")
    line, spline, _ = route_from_program(program, ("x", "y")).path.curves
    assert isinstance(line, Line)
    assert isinstance(spline, BSpline)
    # A cubic Bezier curve: at half its parameter (P0 + 3 P1 + 3 P2 + P3)/8.
    points = 1e-3 * np.array([(10.0, 0.0), (13.0, 2.0), (19.0, 1.0), (20.0, 5.0)])
    middle = np.array([1.0, 3.0, 3.0, 1.0]) @ points / 8.0
    near = spline.position(np.linspace(0.0, spline.length, 20_001))
    assert np.linalg.norm(near - middle, axis=1).min() < spline.length / 20_000
    np.testing.assert_allclose(near[[0, -1]], points[[0, -1]], rtol=0, atol=1e-15)


@pytest.mark.parametrize(
    ("name", "wrong"), [*itertools.product(["corner_tolerance", "merge_tolerance"], [-1e-6, np.nan]), ("merge_tolerance", np.inf)]
)
def test_an_invalid_tolerance_is_refused(name: str, wrong: float) -> None:
    with pytest.raises(FeedError, match=rf"{name}: .*>= 0 m"):
        Route(Path([Line((0.0, 0.0), (1.0, 0.0))]), 0.1, False, 0.0, 0, **{name: wrong})  # type: ignore[arg-type]


def test_stops_at_events_stay_under_another_path_control() -> None:
    program = parse_program(HEAD + "G64 P0.02\nX1\nM8\nX2\nY1\nG61.1\nX3\nM2\n")
    for mode, tolerance, stops in (
        (Mode("blend", 1e-5, 0.0), 1e-5, [True, False, False, False]),
        (Mode("exact_path"), 0.0, [True, False, False, False]),
        (Mode("exact_stop"), 0.0, [True] * 4),
        (None, None, [True, False, False, True]),
    ):
        route = route_from_program(program, ("x", "y"), mode=mode)
        assert route.exact_stop.tolist() == stops
        assert mode is None or route.corner_tolerance.tolist() == [tolerance] * 4
