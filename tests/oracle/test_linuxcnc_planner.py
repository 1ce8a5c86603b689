"""Programs planned as LinuxCNC plans them, beside LinuxCNC itself: cycle time, corners, and the command over the time."""

from pathlib import Path

import numpy as np
import pytest
from linuxcnc_rig import PERIOD, Rig, missing

from contourlab.feed import blended, plan
from contourlab.program import read_program
from contourlab.scenario import load_machine
from contourlab.scenario.load import reading_on
from contourlab.scenario.values import program_route

pytestmark = [pytest.mark.oracle, pytest.mark.slow]  # LinuxCNC runs in real time

CORNERS = "G0 X5 Y2\nG1 X15 F3000\nY12\nX14 Y13\nX5\nX4.5 Y8\nX8 Y2.5\nX5 Y2\nG0 X20\nY-10\nX0 Y0\n"
ARCS = "G1 X20 F2400\nG3 X20 Y10 I4 J5\nG2 X30 Y10 I5 J-4\nG1 X32 Y8\nG2 X31 Y5 R2\nG1 X0 Y0\n"
SHORT = "".join(f"G1 X{4 * np.sin(a) + 0.3 * np.sin(7 * a):.4f} Y{3 - 3 * np.cos(a):.4f} F4000\n" for a in np.linspace(0.1, 6.28, 60))
PROGRAMS = {"corners": CORNERS, "arcs": ARCS, "short lines": SHORT}
MODES = {"G61": 0.02, "G64 P0.05": 0.02, "G64": 0.05, "": 0.05}
"""Largest difference of the cycle time; without a mode LinuxCNC starts in G64."""


def away(corners: np.ndarray, motion: np.ndarray) -> float:
    """Return the largest distance of corners (n, 2) from the lines between the points of a motion (m, 2)."""
    step = np.diff(motion, axis=0)
    square = np.maximum((step**2).sum(axis=1), 1e-300)
    along = [np.clip(((corner - motion[:-1]) * step).sum(axis=1) / square, 0.0, 1.0)[:, None] for corner in corners]
    return max(np.sqrt(((motion[:-1] + t * step - c) ** 2).sum(axis=1).min()) for c, t in zip(corners, along, strict=True))


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("name", PROGRAMS)
def test_cycle_time_and_corners_are_those_of_linuxcnc(tmp_path: Path, name: str, mode: str) -> None:
    if missing():
        pytest.skip(missing())
    text = f"G21 G90 G17 {mode}\n{PROGRAMS[name]}M2\n"
    (tmp_path / "part.ngc").write_text(text)
    ini, _ = Rig().write(tmp_path)
    machine = load_machine(ini)
    limits, program = machine.planner_limits(), read_program(tmp_path / "part.ngc", reading=reading_on(machine, {}))
    route = program_route(program, machine.axis_names, planner=limits.planner)
    reference = plan(blended(route, limits), limits, PERIOD)
    ours = reference.block(0, reference.n_sample).position[:, :2]
    log = np.loadtxt(Rig().run(text, tmp_path / "log.csv"), delimiter=",", skiprows=1)[:, 1:3] * 1e-3
    moving = np.flatnonzero(np.abs(np.diff(log, axis=0)).sum(axis=1) > 0.0)
    theirs = log[moving[0] : moving[-1] + 2]
    assert len(ours) == pytest.approx(len(theirs), rel=MODES[mode])
    corners = route.path.starts[0][1:, :2]
    assert away(corners, ours) == pytest.approx(away(corners, theirs), rel=0.2, abs=1e-6)
    n = min(len(ours), len(theirs))
    assert np.linalg.norm(ours[:n] - theirs[:n], axis=1).max() < 3.0 * PERIOD * machine.path_velocity
