"""What `record` writes, run by LinuxCNC itself: the log is read with no option, and its figures are those of the control."""

from pathlib import Path

import numpy as np
import pytest
from linuxcnc_rig import PERIOD, Plant, Rig, missing

import contourlab as cl

pytestmark = [pytest.mark.oracle, pytest.mark.slow]  # LinuxCNC runs in real time

PROGRAM = "\n".join(["G21 G90 G17 G64 P0.02", "F1500", "G0 X20 Y20", "G1 X60", "G3 X60 Y40 J10", "G1 X20 Y20", "G0 X0 Y0", "M2", ""])


def test_a_recorded_program_is_measured_with_no_option(tmp_path: Path) -> None:
    if missing():
        pytest.skip(missing())
    rig = Rig({"x": Plant(play=0.0, friction=15.0), "y": Plant(play=0.0, friction=15.0)})
    ini, _ = rig.write(tmp_path / "machine")
    recording = cl.record(ini).save(tmp_path / "recording")
    assert "CL993" in {one.code for one in recording.findings}  # the rig loads halui only on request
    log = rig.record(PROGRAM, tmp_path / "recording", tmp_path / "run.csv")
    rows = np.loadtxt(log, delimiter=",", skiprows=1)
    time, line, commands = rows[:, 0], rows[:, -1].astype(int), rows[:, [1, 3]]
    assert np.diff(time) == pytest.approx(np.full(time.size - 1, PERIOD), abs=1e-9)
    still = np.abs(np.diff(commands, axis=0)).max(axis=1) == 0.0
    lead, tail = int(np.argmin(still)), int(np.argmin(still[::-1]))
    assert lead * PERIOD > 0.3 and 0.3 < tail * PERIOD < 1.5  # half a second before and after, as far as halui tells in time
    assert commands.min(axis=0) == pytest.approx([0.0, 0.0], abs=1e-6) and commands[:, 0].max() == pytest.approx(70.0, abs=0.01)
    (tmp_path / "part.ngc").write_text(PROGRAM)
    measured = cl.measure(log, machine=ini, program=tmp_path / "part.ngc", tolerance="1 mm")
    (run,) = measured.runs
    assert measured.passed and run.metrics.basis == "cutting moves"
    assert run.metrics.judged_time == pytest.approx((40.0 + np.pi * 10.0 + np.hypot(40.0, 20.0)) / 25.0, rel=0.05)
    assert set(run.lines(np.arange(run.result.n_sample)).tolist()) == {0, 3, 4, 5, 6, 7}
    assert run.shift == pytest.approx({"x": 0.0, "y": 0.0, "z": 0.0}, abs=1e-8)  # though LinuxCNC rounds the corners
    assert 1e-6 < run.metrics.planning_deviation.max <= 21e-6
    # The tool follows with the error that the log has, and an independent sum gives it.
    cut = np.isin(line, (4, 5, 6))
    late = np.linalg.norm(rows[cut][:, [1, 3]] - rows[cut][:, [2, 4]], axis=1).max() * 1e-3
    assert run.metrics.contour_error.max < late < 1e-3
    assert {cause.name for cause in run.verdict.causes} >= {"planning", "lag", "servo mismatch"}
