"""`precompensate` against LinuxCNC itself: the same control, untouched, follows the corrected program better."""

from pathlib import Path

import numpy as np
import pytest
from linuxcnc_rig import Plant, Rig, missing

from contourlab.features.precompensate.command import precompensate

PROGRAM = "G21 G90 G17 G64 P0.002\nG1 F1800 X15 Y0\nG3 X15 Y0 I-15 J0\nG1 X0 Y0\nM2\n"
PLANTS = {"x": Plant(gain=2300.0, play=0.015), "y": Plant(gain=1800.0, damping=34.0)}

pytestmark = [pytest.mark.oracle, pytest.mark.slow]  # LinuxCNC runs in real time


def radial(log: Path) -> np.ndarray:
    """Return the radial error of the load [um] on the circle, without its first and last 30 degrees."""
    rows = np.loadtxt(log, delimiter=",", skiprows=1)
    angle, radius = np.arctan2(rows[:, 6], rows[:, 5]), np.hypot(rows[:, 5], rows[:, 6])
    return 1e3 * (radius - 15.0)[(np.abs(angle) > np.pi / 6.0) & (radius > 14.0)]


def test_three_passes_make_a_better_circle(tmp_path: Path) -> None:
    if missing():
        pytest.skip(missing())
    part = tmp_path / "part.ngc"
    part.write_text(PROGRAM)
    rig, program, rms, results = Rig(PLANTS), part, [], []
    for k in range(4):
        log = rig.run(program.read_text(), tmp_path / f"run-{k}.csv")
        rms.append(float(np.sqrt((radial(log) ** 2).mean())))
        program = tmp_path / f"part-{k + 1}.ngc"
        results.append(precompensate(part, log=[log], passes=tmp_path / "passes").save(program))
    assert results[-1].position == "load"
    assert rms[3] < rms[0] / 5.0, rms
    durations = [one.duration for one in results[-1].passes]
    assert 0.98 * durations[0] < min(durations) and max(durations) < 1.02 * durations[0]
