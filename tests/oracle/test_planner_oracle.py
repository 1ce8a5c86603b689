"""The planner against LinuxCNC's, with the same moves and limits: cycle time, and LinuxCNC's samples under our judge."""

import math
import shutil
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from program_oracle import load_module
from reference_data import SHARED

from contourlab.feed import LimitReport, Reference, limit_report, plan
from contourlab.program import Program, parse_program

BENCHMARK = Path(__file__).parents[2] / "benchmarks" / "linuxcnc.py"
TOOL = SHARED / "tools" / "planner_oracle.py"
PERIOD = 1e-3
HEAD = "G21 G90 G17 F6000\n"
PROGRAMS = {
    "square": "G1 X20\nG1 Y20\nG1 X0\nG1 Y0\n",
    "circle": "G2 X0 Y0 I20 J0\n",
    "slot": "G1 X30\nG3 X30 Y16 I0 J8\nG1 X0\nG3 X0 Y0 I0 J-8\n",
    "zigzag": "".join(f"G1 X{1.5 * k} Y{1.3 * (k % 2)}\n" for k in range(1, 21)),
    "space": "G0 X12 Y9 Z5\nG1 X20 Y-4 Z0\nG18 G2 X30 Z10 I10 K0\nG1 Z0\nG0 X0 Y0\n",
}

pytestmark = [
    pytest.mark.oracle,
    pytest.mark.slow,  # LinuxCNC runs in real time
    # The shared tool does not close its files.
    pytest.mark.filterwarnings("ignore::ResourceWarning", "ignore::pytest.PytestUnraisableExceptionWarning"),
    pytest.mark.skipif(shutil.which("linuxcnc") is None, reason="LinuxCNC is not installed"),
    pytest.mark.skipif(not TOOL.is_file(), reason="the shared oracle tools are not next to the repository"),
]


@pytest.fixture(scope="module")
def planning() -> ModuleType:
    """The benchmark that runs both planners."""
    return load_module(BENCHMARK)


def program_of(name: str) -> Program:
    return parse_program(f"{HEAD}{PROGRAMS[name]}M2\n", name)


def theirs_of(planning: ModuleType, program: Program, mode: str) -> np.ndarray:
    return np.asarray(planning.their_samples(planning.rewritten(program, mode), program.moves[-1].end))


def rates(points: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the worst velocity, acceleration and jerk of each axis, by differences."""
    found = [np.abs(np.diff(points, order, axis=0)).max(axis=0) / PERIOD**order for order in (1, 2, 3)]
    return found[0], found[1], found[2]


def assert_matches_differences(report: LimitReport, points: np.ndarray, smooth: bool) -> None:
    """Check the report against plain differences; where the curvature jumps, its jerk is smaller, as it lists the jump apart."""
    velocity, acceleration, jerk = rates(points)
    assert [w.value for w in report.velocity] == pytest.approx(velocity, rel=1e-9, abs=1e-12)
    assert [w.value for w in report.acceleration] == pytest.approx(acceleration, rel=1e-9, abs=1e-9)
    for worst in report.velocity:
        there = points[worst.sample : worst.sample + 2, worst.axis]
        assert abs(there[1] - there[0]) / PERIOD == pytest.approx(worst.value, rel=1e-9, abs=1e-12)
    if smooth:
        assert [w.value for w in report.jerk] == pytest.approx(jerk, rel=1e-9, abs=1e-6)
    assert all(w.value <= most * (1 + 1e-9) + 1e-6 for w, most in zip(report.jerk, jerk, strict=True))


@pytest.mark.parametrize("name", PROGRAMS)
def test_exact_path(planning: ModuleType, name: str) -> None:
    program = program_of(name)
    route, limits = planning.driven(program), planning.limits()
    theirs = theirs_of(planning, program, "G61")

    # Not slower, although the jerk limit costs each ramp one servo period.
    ours = plan(route, limits, PERIOD)
    assert ours.duration <= 1.05 * (len(theirs) - 1) * PERIOD

    # Within the limits, by the judge and by plain differences.
    assert limit_report(ours, limits).ok()
    points = np.array(ours.block(0, ours.n_sample).position)
    velocity, acceleration, jerk = rates(points)
    assert velocity.max() <= planning.VELOCITY * (1 + 1e-6)
    assert acceleration.max() <= planning.ACCELERATION * (1 + 1e-3)
    if len(route.path.curves) == 1:
        assert jerk.max() <= planning.JERK * (1 + 1e-3)

    # Both drive the programmed path: theirs to a nanometre of rounding on lines, to its own arcs' accuracy on arcs.
    assert planning.deviation(points, route.path) <= 1e-12
    assert planning.deviation(theirs, route.path) <= 0.5e-6

    report = limit_report(Reference.from_samples(theirs, PERIOD, route.path), limits)
    assert_matches_differences(report, theirs, smooth=len(route.path.curves) == 1)


def test_blended_corners_are_seen_by_the_judge(planning: ModuleType) -> None:
    """A right angle blended by an arc that passes its corner at P leaves its legs by P / sqrt(2)."""
    program = program_of("square")
    route = planning.driven(program)
    theirs = theirs_of(planning, program, "G64 P0.1")
    assert planning.deviation(theirs, route.path) == pytest.approx(1e-4 / math.sqrt(2.0), rel=0.02)
    report = limit_report(Reference.from_samples(theirs, PERIOD, route.path), planning.limits())
    assert_matches_differences(report, theirs, smooth=False)
    # LinuxCNC reaches 100 mm/s, so a limit of half that must fail.
    assert not limit_report(Reference.from_samples(theirs, PERIOD, route.path), planning.limits(velocity=0.05, jerk=math.inf)).ok()
