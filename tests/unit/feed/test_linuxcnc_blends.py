"""Motion as LinuxCNC plans it under G64, beside figures of its own planner."""

import math
from dataclasses import replace

import numpy as np
import pytest

from contourlab.arrays import Array
from contourlab.errors import FeedError
from contourlab.feed import AxisLimits, Route, blended, limit_report, plan, route_from_path, route_from_program
from contourlab.feed.bounds import LinuxCNC
from contourlab.feed.route import controlled
from contourlab.geometry import Arc, Line, Path, contour
from contourlab.geometry.line_and_arc import Lines
from contourlab.program import parse_program

VELOCITY, ACCELERATION, CYCLE = np.array([0.1, 0.08, 0.03]), np.array([0.5, 0.4, 0.2]), 1e-3
BEND = 2.0 * math.atan2(5.0, 4.0)


def limits_of(**settings: float) -> AxisLimits:
    return AxisLimits(VELOCITY, ACCELERATION, planner=LinuxCNC(**settings))  # type: ignore[arg-type]


def made(*moves: tuple[tuple[float, ...], float] | tuple[tuple[float, ...], float, tuple[float, ...], float]) -> Route:
    """Return a route through ends [mm] with feedrates [mm/s], 0 for a rapid; arcs also have a centre and an angle."""
    at, curves = np.zeros(3), []
    for end, _, *arc in moves:
        to = 1e-3 * np.array(end)
        curves.append(Arc.through(at, to, 1e-3 * np.array(arc[0]), arc[1]) if arc else Line(at, to))  # type: ignore[arg-type]
        at = to
    feed = 1e-3 * np.array([feed or math.inf for _, feed, *_ in moves])
    return Route(Path(curves), feed, np.isinf(feed), np.array(0.0), np.array(0))


SQUARE = made(*(((x, y, 0.0), 40.0) for x, y in ((10.0, 0.0), (10.0, 10.0), (0.0, 10.0), (0.0, 0.0))))
ZIGZAG = made(*(((0.5 * k, 0.2 * (k % 2), 0.0), 40.0) for k in range(1, 40)))
LOOP = made(((20, 0, 0), 40), ((20, 10, 0), 40, (24, 5, 0), BEND - 2.0 * math.pi), ((0, 10, 0), 40))
WAVE = made(((20, 0, 0), 40), ((20, 10, 0), 40, (24, 5, 0), -BEND), ((30, 10, 0), 40, (25, 14, 0), BEND), ((40, 0, 0), 40))
PLUNGE = made(
    ((0, 0, -5), 10), ((10, 0, -5), 40, (5, 0, -5), math.pi), ((0, 0, -5), 40, (5, 0, -5), math.pi), ((0, 0, 0), 40)
)  # no arc lies in the plane of a plunge and a circle: parabolas
RAPIDS = made(((10, 0, 5), 0), ((10, 10, 5), 0), ((10, 10, 0), 10), ((30, 10, 0), 40), ((30, 5, 0), 30), ((30, 5, 5), 0))

HORN = "G3 X-8.8 Y-2.3 I-3.8 J-3.5 F2400\nG3 X-8.5 Y-1.8 I0.65 J-0.05\nG3 X0.7 Y1.2 I4.6 J1.5\nG3 X0.2 Y1.9 I-0.25 J0.35\n"
SPRING = "G1 X20 F2400\nG3 X20 Y10 Z3 I3 J5\nG1 X0 Y12\nG2 X0 Y2 Z0 I-4 J-5\nG1 X10 Y0\n"
SLOWER = "G1 X-6.5 F4800\nG1 X-7.9 Y0.4 F100\nG0 X-9 Y20\n"  # within the second move it brakes to the feedrate
LAST = "G1 Z-8 F1800\nG3 X3 Y1.5 R2\nG4 P0.1\nG1 Z-4\nG3 X3 Y2.5 R0.6\n"  # the arcs brake before what is before them rests


def off_corners(route: Route, limits: AxisLimits) -> tuple[float, float]:
    """Return the duration of a motion [s], and the largest distance of a programmed corner from it [m]."""
    reference = plan(blended(route, limits), limits, CYCLE)
    a, b = (reference.block(k, reference.n_sample - 1 + k).position for k in (0, 1))
    step = b - a
    square = np.maximum((step**2).sum(axis=1), 1e-30)
    away = []
    for corner in route.path.starts[0][1:]:
        along = np.clip(((corner - a) * step).sum(axis=1) / square, 0.0, 1.0)[:, None]
        away.append(np.sqrt(((a + along * step - corner) ** 2).sum(axis=1).min()))
    return reference.duration, max(away)


@pytest.mark.parametrize(
    ("route", "within", "without"),
    [
        (SQUARE, (1.436, 0.0500e-3), (0.989, 2.0711e-3)),
        (ZIGZAG, (1.386, 0.0500e-3), (1.361, 0.0519e-3)),
        (LOOP, (1.718, 0.0494e-3), (1.457, 1.8588e-3)),
        (WAVE, (1.998, 0.0494e-3), (1.629, 1.7870e-3)),
        (PLUNGE, (2.303, 0.0512e-3), (2.016, 0.1768e-3)),
        (RAPIDS, (2.447, 0.0500e-3), (2.112, 2.0711e-3)),
    ],
)
def test_times_and_deviations_of_linuxcnc(route: Route, within: tuple[float, float], without: tuple[float, float]) -> None:
    """Measured with its planner (tp.c of commit f1270d6ed7) under G64 P0.05 without Q, and under G64; it rests one cycle at the end."""
    for tolerance, (measured, off) in ((5e-5, within), (math.inf, without)):
        tolerant = replace(route, corner_tolerance=np.asarray(tolerance))
        duration, away = off_corners(tolerant, limits_of())
        assert duration == pytest.approx(measured - CYCLE, rel=0.002)
        assert away == pytest.approx(off, rel=0.05)
        report = limit_report(plan(blended(tolerant, limits_of()), limits_of(), CYCLE), limits_of())
        assert all(worst.ratio <= 1.01 for worst in report.velocity)


@pytest.mark.parametrize(
    ("moves", "within", "without"),
    [
        (HORN, (1.402, 0.0373e-3), (1.365, 0.0758e-3)),
        (SPRING, (3.217, 0.0761e-3), (2.500, 2.0000e-3)),
        (SLOWER.partition("G0")[0], (0.737, 0.0500e-3), (0.731, 0.0508e-3)),
        (SLOWER, (0.893, 0.0500e-3), (0.893, 0.0508e-3)),
        (LAST, (1.576, 0.0515e-3), (1.247, 1.4052e-3)),
    ],
)
def test_parabolas_into_arcs_and_a_lower_feedrate(moves: str, within: tuple[float, float], without: tuple[float, float]) -> None:
    """Measured in the same way, in G-code."""
    for mode, (measured, off) in (("G64 P0.05 Q0", within), ("G64", without)):
        program = parse_program(f"G21 G90 G17 {mode}\n{moves}M2\n")
        duration, away = off_corners(route_from_program(program, default_tolerance=math.inf), limits_of())
        assert duration == pytest.approx(measured - CYCLE, rel=0.002)
        assert away == pytest.approx(off, rel=0.05)


def test_a_dwell_stays_after_a_move_that_its_blend_takes_whole() -> None:
    helices = "G2 X24.20108 Y-4.14969 Z1.7927 I11.812756 J-3.753207 F12000\nG2 X24.873196 Y-4.665946 Z-0.6598 I-1.387074 J-2.501479\n"
    route = route_from_program(parse_program(f"G21 G90 G17 G64\n{helices}G4 P0.35\nM2\n"), default_tolerance=math.inf)
    planned = blended(route, limits_of())
    assert planned.dwell[-1] == 0.35
    assert planned.path.ends[0][-1] == pytest.approx(route.path.ends[0][-1], abs=1e-12)


@pytest.mark.parametrize(
    ("feed", "override", "measured", "off"),
    [(3.0, 1.0, 13.333, 0.0119e-3), (3.0, 3.0, 13.235, 0.1068e-3), (10.0, 1.0, 3.996, 0.1319e-3), (10.0, 3.0, 3.881, 0.5000e-3)],
)
def test_corners_are_planned_for_the_largest_override(feed: float, override: float, measured: float, off: float) -> None:
    """Measured in the same way, P0.5; at a low feedrate the blend is no larger than its speed needs."""
    route = replace(SQUARE, feedrate=np.full(4, 1e-3 * feed), corner_tolerance=np.asarray(5e-4))
    duration, away = off_corners(route, limits_of(largest_override=override))
    assert duration == pytest.approx(measured - CYCLE, abs=2e-3)
    assert away == pytest.approx(off, rel=0.01)


@pytest.mark.parametrize(("blocks", "measured"), [(52, 0.971), (12, 1.753)])
def test_it_looks_at_moves_not_at_what_blends_leave_of_them(blocks: int, measured: float) -> None:
    """Measured in the same way: a polygon of 360 lines under G64, with ARC_BLEND_OPTIMIZATION_DEPTH 50 and 10."""
    angle = np.radians(np.arange(361.0))
    points = 5e-3 * np.stack([np.cos(angle) - 1.0, np.sin(angle), 0.0 * angle], axis=1)
    route = replace(route_from_path(Path(Line.many(points[:-1], points[1:])), 0.1), corner_tolerance=np.asarray(math.inf))
    assert off_corners(route, limits_of(planner_blocks=blocks))[0] == pytest.approx(measured - CYCLE, rel=0.02)


def chains(points: Array, tolerance: float) -> list[int]:
    """Return the points that the canonical interface of LinuxCNC keeps, one after the other as it reads them."""
    kept, chained = [0], list[int]()
    for new in range(1, len(points)):
        start, way = points[kept[-1]], points[new] - points[kept[-1]]
        along = [min(max(float((points[k] - start) @ way / (way @ way)), 0.0), 1.0) for k in chained]
        off = [float(np.linalg.norm(points[k] - start - share * way)) for k, share in zip(chained, along, strict=True)]
        if chained and (len(chained) > 100 or max(off) > tolerance):
            kept.append(chained[-1])
            chained = []
        chained.append(new)
    return [*kept, chained[-1]]


@pytest.mark.parametrize(("n", "turn", "tolerance"), [(400, 0.02, 2e-5), (400, 0.3, 5e-5), (400, 0.0, 1e-6), (60, 2.0, 1e-4)])
def test_lines_are_chained_as_it_chains_them(n: int, turn: float, tolerance: float) -> None:
    """At most 101 lines; also where a point lies before the last."""
    rng = np.random.default_rng(n)
    angle = np.cumsum(turn * rng.normal(size=n))
    step = 1e-4 * rng.uniform(0.2, 2.0, size=(n, 1)) * np.stack([np.cos(angle), np.sin(angle), 0.0 * angle], axis=1)
    points = np.vstack([np.zeros(3), np.cumsum(step, axis=0)])
    route = replace(route_from_path(Path(Line.many(points[:-1], points[1:])), 0.04), merge_tolerance=np.asarray(tolerance))
    planned = blended(route, limits_of())
    assert planned.path.position(planned.path.breaks) == pytest.approx(points[chains(points, tolerance)], abs=1e-12)
    at = np.linspace(0.0, planned.path.length, 2000)
    assert np.all(np.diff(planned.programmed_arc_length(at)) >= 0.0)


def test_a_small_arc_becomes_two_lines_and_a_flat_one_joins_a_chain() -> None:
    small = made(((5, 0, 0), 40), ((5, 0.1, 0), 40, (5, 0.05, 0), math.pi), ((0, 0.1, 0), 40))
    planned = blended(replace(small, merge_tolerance=np.asarray(5.1e-5)), limits_of())
    assert planned.path.of_kind(Lines).all()
    points = 1e-3 * np.array([[0, 0, 0], [5, 0, 0], [5.05, 0.05, 0], [5, 0.1, 0], [0, 0.1, 0]])
    assert planned.path.position(planned.path.breaks) == pytest.approx(points[chains(points, 5.1e-5)], abs=1e-12)
    lone = blended(replace(small, merge_tolerance=np.array([0.0, 5.1e-5, 0.0])), limits_of())
    assert lone.path.ends[0] == pytest.approx(points[[1, 3, 4]], abs=1e-12)
    assert blended(replace(small, merge_tolerance=np.asarray(4.9e-5)), limits_of()).n_curve == 3
    around = made(((5, 0, 0), 40), ((5, 0, 0), 40, (4, 0, 0), 2.0 * math.pi), ((5, 0, 0.5), 40, (4, 0, 0), 4.0 * math.pi))
    assert blended(replace(around, merge_tolerance=np.asarray(5e-5)), limits_of()).n_curve == 3


def test_a_program_is_in_g64_without_a_bound_until_it_says_otherwise() -> None:
    """As LinuxCNC starts; nothing is merged then, and under G61 nothing rounded."""
    program = parse_program("G21 G90 G1 F600\nX1\nY1\nG64 P0.02\nX3\nG61\nY2\nM2\n")
    route = route_from_program(program, default_tolerance=math.inf, default_control="blend")
    assert route.corner_tolerance.tolist() == [math.inf, math.inf, 2e-5, 0.0]
    assert route.merge_tolerance.tolist() == [0.0, 0.0, 2e-5, 0.0]
    every = controlled(route, "blend", math.inf)
    assert np.isinf(every.corner_tolerance).all() and not every.merge_tolerance.any()
    with pytest.raises(FeedError, match="LinuxCNC"):
        blended(every, AxisLimits(0.1, 0.5, 10.0))


def test_what_it_does_not_drive_is_refused() -> None:
    with pytest.raises(FeedError, match="jerk"):
        blended(route_from_path(contour("ellipse"), 0.02), AxisLimits(0.1, 0.5, planner=LinuxCNC()))


def test_a_blended_route_is_planned_as_it_is() -> None:
    route = blended(replace(WAVE, corner_tolerance=np.asarray(5e-5)), limits_of())
    assert blended(route, limits_of()) is route
    breaks = route.path.breaks
    off = route.path.position(breaks) - WAVE.path.position(route.programmed_arc_length(breaks))
    assert np.linalg.norm(off, axis=1).max() < 6e-5
