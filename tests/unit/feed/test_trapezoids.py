"""Motion as grbl plans it, beside closed forms, a planner in C, and one that follows grbl's buffer line by line."""

import ctypes
import math
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path as File

import numpy as np
import pytest
from reference_data import reference_file

from contourlab.arrays import Array
from contourlab.errors import FeedError
from contourlab.feed import AxisLimits, Route, blended, limit_report, plan, route_from_path
from contourlab.feed.bounds import Grbl, LinuxCNC
from contourlab.feed.planner import Binding, limiting, plan_profile
from contourlab.feed.route import controlled
from contourlab.feed.trapezoids import course
from contourlab.geometry import Arc, Line, Path, contour
from contourlab.geometry.line_and_arc import Lines

VELOCITY, ACCELERATION = np.array([0.1, 0.08, 0.03]), np.array([0.5, 0.4, 0.2])
WHOLE = 1000  # a buffer for all lines of these tests


def of_points(points: Array, feed: float = 0.04) -> Route:
    return route_from_path(Path(Line.many(points[:-1], points[1:])), feed)


def limits_of(blocks: int = 16, deviation: float = 1e-5) -> AxisLimits:
    return AxisLimits(VELOCITY, ACCELERATION, planner=Grbl(deviation, 2e-6, blocks))


def walk(n: int, step: float, turn: float, seed: int) -> Array:
    """Return points (n + 1, 3) of lines of about one length [m] that turn at random."""
    rng = np.random.default_rng(seed)
    angle = np.cumsum(rng.normal(size=n + 1) * turn)
    steps = np.stack([np.cos(angle), np.sin(angle), 0.2 * rng.normal(size=n + 1)], axis=1)
    return np.cumsum(steps * step * rng.uniform(0.2, 2.0, size=(n + 1, 1)), axis=0)


def streamed(points: Array, feed: float, blocks: int, deviation: float) -> float:
    """Return the duration [s] if all lines that a buffer holds are planned anew, from rest at the end of the last, as each line begins."""
    leg = np.diff(points, axis=0)
    length = np.sqrt((leg**2).sum(axis=1))
    unit = leg / length[:, None]
    n, entry, total = len(leg), 0.0, 0.0
    steep = [min(a / abs(u) for a, u in zip(ACCELERATION, row, strict=True) if u) for row in unit]
    nominal = [min(feed, *(v / abs(u) for v, u in zip(VELOCITY, row, strict=True) if u)) for row in unit]

    def ceiling(k: int) -> float:
        cosine, change = -float(unit[k - 1] @ unit[k]), unit[k] - unit[k - 1]
        if abs(cosine) > 0.999999:
            return 0.0 if cosine > 0.0 else min(nominal[k - 1] ** 2, nominal[k] ** 2)
        change /= np.linalg.norm(change)
        half = math.sqrt(0.5 * (1.0 - cosine))
        least = min(a / abs(u) for a, u in zip(ACCELERATION, change, strict=True) if u)
        return min(least * deviation * half / (1.0 - half), nominal[k - 1] ** 2, nominal[k] ** 2)

    for i in range(n):
        end = 0.0
        for k in range(min(i + blocks - 1, n) - 1, i, -1):
            end = min(ceiling(k), end + 2.0 * steep[k] * length[k])
        end = min(end, entry + 2.0 * steep[i] * length[i])
        top = min(nominal[i] ** 2, 0.5 * (entry + end) + steep[i] * length[i])
        ramps = (2.0 * top - entry - end) / (2.0 * steep[i])
        total += (2.0 * math.sqrt(top) - math.sqrt(entry) - math.sqrt(end)) / steep[i] + (length[i] - ramps) / math.sqrt(top)
        entry = end
    return total


def test_a_line_is_a_trapezoid_and_a_short_one_a_triangle() -> None:
    """At 0.04 m/s and 0.5 m/s^2 the ramps take 80 ms and 1.6 mm each."""
    limits = limits_of()
    assert plan_profile(of_points(np.array([[0.0, 0, 0], [0.1, 0, 0]])), limits).duration == pytest.approx(0.1 / 0.04 + 0.08, rel=1e-12)
    short = plan_profile(of_points(np.array([[0.0, 0, 0], [0.002, 0, 0]])), limits)
    assert short.duration == pytest.approx(2.0 * math.sqrt(0.002 / 0.5), rel=1e-12)
    assert not short.j.any()


def test_a_corner_is_passed_at_the_speed_of_its_junction_deviation() -> None:
    """A right angle of x and y: s = sqrt(1/2), and the slower axis y has 0.4 sqrt(2) along the bisector. Straight on: the feedrate."""
    route = of_points(np.array([[0.0, 0, 0], [0.05, 0, 0], [0.05, 0.05, 0], [0.05, 0.1, 0], [0.05, 0.0, 0]]))
    half = math.sqrt(0.5)
    speed = course(route, limits_of()).corner
    assert speed == pytest.approx([math.sqrt(0.4 * math.sqrt(2.0) * 1e-5 * half / (1.0 - half)), 0.04, 0.0, 0.0], rel=1e-12)
    assert course(route, limits_of(deviation=0.0)).corner[0] == 0.0
    profile = plan_profile(route, limits_of())
    assert limiting(route, limits_of(), profile, [0.05, 0.02])[:].tolist() == [Binding.CORNER, Binding.FEEDRATE]


@pytest.mark.parametrize(("n", "step", "turn"), [(3, 0.02, 1.0), (60, 1e-3, 0.3), (300, 2e-4, 0.05), (300, 5e-5, 2.0)])
def test_the_buffer_limits_how_far_the_control_sees(n: int, step: float, turn: float) -> None:
    points = walk(n, step, turn, n)
    for blocks in (4, 16, WHOLE):
        duration = plan_profile(of_points(points), limits_of(blocks)).duration
        assert duration == pytest.approx(streamed(points, 0.04, blocks, 1e-5), rel=1e-9)


@pytest.mark.parametrize("blocks", [3, 16])
def test_pieces_of_a_line_are_as_fast_as_a_stop_within_the_buffer_allows(blocks: int) -> None:
    """A line in pieces of 50 um: behind the running one the buffer holds `blocks` - 2, over which the axis stops."""
    points = np.zeros((400, 3))
    points[:, 0] = 5e-5 * np.arange(400)
    profile = plan_profile(of_points(points), limits_of(blocks))
    assert profile.v0.max() == pytest.approx(math.sqrt((2.0 * (blocks - 2) + 1.0) * 0.5 * 5e-5), rel=1e-9)


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")
def test_a_whole_program_ahead_takes_the_time_of_the_planner_in_c(tmp_path: File) -> None:
    """Within 1e-9; another program, which sees all lines."""
    source, library = reference_file("prototypes", "reference", "grbl.c"), tmp_path / "grbl.so"
    subprocess.run(["gcc", "-O1", "-shared", "-fPIC", "-o", str(library), str(source), "-lm"], check=True)
    array = np.ctypeslib.ndpointer(float, flags="C")
    plan_in_c = ctypes.CDLL(str(library)).plan
    plan_in_c.argtypes = [array, ctypes.c_int, ctypes.c_double, array, array, ctypes.c_double, array, array]
    plan_in_c.restype = ctypes.c_double
    for n, step, turn in ((5, 0.02, 1.0), (500, 3e-3, 0.2), (900, 5e-5, 0.02), (900, 1e-3, 2.0)):
        points = walk(n, step, turn, n)
        ours = plan_profile(of_points(points), limits_of(WHOLE)).duration
        assert ours == pytest.approx(plan_in_c(points, n, 0.04, VELOCITY, ACCELERATION, 1e-5, np.empty(n + 1), np.empty(n)), rel=1e-9)


def test_arcs_become_chords_within_their_tolerance() -> None:
    """As many as grbl makes; corners, ends and dwells stay, and places on the chords those of the arc."""
    helix = Arc((0.0, 0.0, 0.0), 0.01, 0.0, 3.0, rise=(0.0, 0.0, 0.005))
    path = Path([Line((0.01, -0.01, 0.0), (0.01, 0.0, 0.0)), helix])
    route = blended(route_from_path(path, 0.02, dwell=0.5), limits_of())
    n = math.floor(0.5 * 3.0 * 0.01 / math.sqrt(2e-6 * (2.0 * 0.01 - 2e-6)))
    assert route.n_curve == 1 + n and route.path.of_kind(Lines).all()
    assert np.count_nonzero(route.dwell) == 1 and route.dwell[-1] == 0.5
    assert route.path.ends[0][-1] == pytest.approx(path.ends[0][-1], abs=1e-15)
    s = np.linspace(0.0, route.path.length, 5000)
    off = np.linalg.norm(route.path.position(s) - path.position(route.programmed_arc_length(s)), axis=1)
    assert 1.5e-6 < off.max() < 2e-6 * (n + 1) ** 2 / n**2
    tiny = blended(route_from_path(Path([Arc((0.0, 0.0, 0.0), 9e-7, 0.0, 3.0)]), 0.02), limits_of())
    assert tiny.n_curve == 1


def test_ends_are_rounded_to_steps_and_lines_of_no_step_left_out() -> None:
    """Steps of 10 um; the dwell of a line of 2 um comes before the motion, or after the line before; what turns is planned as commanded."""
    points = np.array([[0.0, 0, 0], [2e-6, 0, 0], [1.0031e-2, 0, 0], [1.0032e-2, 2e-6, 0], [1.0032e-2, 5.006e-3, 0]])
    planner = Grbl(steps=(1e-5, 1e-5, 0.0))
    limits = AxisLimits(VELOCITY, ACCELERATION, planner=planner)
    route = of_points(points)
    route = blended(replace(route, dwell=np.array([0.1, 0.0, 0.2, 0.0])), limits)
    corner = np.array([[0.0, 0, 0], [0.01003, 0, 0], [0.01003, 0.00501, 0]])
    assert route.path.position(route.path.breaks) == pytest.approx(corner, abs=1e-15)
    assert route.dwell_before == 0.1 and route.dwell.tolist() == [0.2, 0.0]
    assert route.programmed_arc_length(route.path.breaks) == pytest.approx([0.0, 0.010031 + math.hypot(1e-6, 2e-6), 0.015037236], abs=1e-8)
    walked = walk(200, 5e-5, 0.1, 3) * np.array([1.0, 1.0, 0.0])
    rounded = np.round(walked / 1e-5) * 1e-5
    moved = np.append(True, np.any(np.diff(rounded, axis=0), axis=1))
    duration = plan_profile(blended(of_points(walked), limits), limits).duration
    assert duration == pytest.approx(streamed(rounded[moved], 0.04, 16, 1e-5), rel=1e-9)
    assert duration > 1.2 * plan_profile(of_points(walked), limits_of()).duration
    half = blended(of_points(np.array([[0.0, 0, 0], [2.5e-5, -2.5e-5, 0]])), limits)  # away from zero, as C's lround
    assert half.path.ends[0][0] == pytest.approx([3e-5, -3e-5, 0.0], abs=1e-15)
    with pytest.raises(FeedError, match="step"):
        blended(of_points(points[:2]), limits)


def test_other_curves_are_refused() -> None:
    ellipse = route_from_path(contour("ellipse"), 0.02)
    flat = AxisLimits(0.1, 0.5, planner=Grbl())
    with pytest.raises(FeedError, match="lines and arcs only"):
        blended(ellipse, flat)
    with pytest.raises(FeedError, match="blended"):
        plan(route_from_path(contour("circle"), 0.02), flat, 1e-3)
    with pytest.raises(FeedError, match="limit"):
        plan(of_points(np.eye(3)), AxisLimits(0.1, jerk=10.0, acceleration=np.inf, planner=Grbl()), 1e-3)


def test_the_command_stays_on_the_lines_and_within_the_limits() -> None:
    """Of axes and feedrate. The velocity jumps at corners; no limit bounds that."""
    points = walk(80, 3e-3, 1.2, 7)
    route, limits, period = of_points(points), limits_of(), 1e-3
    reference = plan(blended(route, limits), limits, period)
    block = reference.block(0, reference.n_sample)
    assert route.path.position(block.arc_length) == pytest.approx(block.position, abs=1e-15)
    assert block.position[-1] == pytest.approx(points[-1], abs=1e-12)
    assert block.feedrate.max() <= 0.04 * (1.0 + 1e-12)
    assert np.abs(block.acceleration).max(axis=0) == pytest.approx(ACCELERATION, rel=1e-6)
    report = limit_report(reference, limits)
    assert report.ok() and report.n_kink == 79
    jump = np.abs(np.diff(block.velocity, axis=0)).max()
    assert max(worst.value for worst in report.kink) == pytest.approx(jump, rel=0.2) and jump > 10.0 * period * ACCELERATION.max()


def _square() -> Path:
    corners = 0.01 * np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 0]])
    return Path(Line.many(corners[:-1], corners[1:]))


def _bent() -> Path:
    angle = 5e-4 * np.arange(50)
    points = np.cumsum(np.vstack([np.zeros(3), 5e-4 * np.stack([np.cos(angle), np.sin(angle), 0.0 * angle], axis=1)]), axis=0)
    return Path(Line.many(points[:-1], points[1:]))


def _slot() -> Path:
    turn = Arc((0.02, 0.005, 0.0), 0.005, -0.5 * math.pi, math.pi)
    return Path([Line((0.0, 0.0, 0.0), (0.02, 0.0, 0.0)), turn, Line((0.02, 0.01, 0.0), (0.0, 0.01, 0.0))])


def _helix() -> Path:
    around = Arc((0.0, 0.0, 0.002), 0.005, 0.0, -2.0 * math.pi, rise=(0.0, 0.0, -0.006))
    return Path([Line((0.0, 0.0, 0.0), (0.005, 0.0, 0.002)), around, Line((0.005, 0.0, -0.004), (0.005, 0.0, -0.005))])


@pytest.mark.parametrize(
    ("path", "feed", "exact_path", "exact_stop"),
    [
        (_square(), [0.04], 1.403, 1.361),
        (_bent(), [0.04], 0.719, 3.201),
        (_slot(), [0.08], 1.076, 1.407),
        (_helix(), [math.inf, 0.02, 0.02], 2.010, 1.995),
    ],
)
def test_the_times_of_linuxcnc(path: Path, feed: list[float], exact_path: float, exact_stop: float) -> None:
    """Measured with its planner (tp.c of commit f1270d6ed7), fed with these moves under G61 and G61.1; it rests one cycle at the end."""
    limits = AxisLimits(VELOCITY, ACCELERATION, planner=LinuxCNC())
    route = Route(path, np.array(feed), np.isinf(feed), np.array(0.0), np.array(0), path)
    for control, measured in (("exact_path", exact_path), ("exact_stop", exact_stop)):
        planned = plan(blended(controlled(route, control, 0.0), limits), limits, 1e-3)
        assert planned.duration == pytest.approx(measured - 1e-3, abs=2e-3)
        assert limit_report(planned, limits).velocity[0].ratio <= 1.0 + 1e-9


def test_laps_of_a_closed_path_pass_its_first_point() -> None:
    square = np.array([[0.0, 0.0], [0.02, 0.0], [0.02, 0.02], [0.0, 0.02], [0.0, 0.0]])
    route = route_from_path(Path(Line.many(square[:-1], square[1:]), closed=True), 0.02)
    limits = AxisLimits(0.1, 0.5, planner=Grbl())
    one, three = (plan(route, limits, 1e-3, laps=laps) for laps in (1, 3))
    corner = course(route, limits).corner
    assert corner == pytest.approx(corner[0]) and corner[0] > 0.0
    lost = 2.0 * (0.02 / 0.5 - (0.02 - corner[0]) / 0.5 - 0.5 * (corner[0] / 0.5) * corner[0] / 0.02)
    assert 3.0 * one.duration - three.duration == pytest.approx(2.0 * lost, rel=1e-9)
    assert len(three.laps) == 3
