"""`circle` on a circle of LinuxCNC itself: play behind loads with inertia, beside the spikes of the motors."""

from pathlib import Path

import numpy as np
import pytest
from linuxcnc_rig import PERIOD, Plant, Rig, missing

from contourlab.features.circle.command import Cause, causes_of
from contourlab.features.circle.fit import fit_circle
from contourlab.features.circle.runs import Circle, runs_of

pytestmark = [pytest.mark.oracle, pytest.mark.slow]  # LinuxCNC runs in real time

PROGRAM = "\n".join(
    ["G21 G90 G17 G64 P0.002", "G1 F600 X20 Y0", "G4 P0.5"]
    + [line for word in ("G3", "G2") for line in (*[f"{word} X20 Y0 I-20 J0"] * 2, "G4 P0.5")]
    + ["M2", ""]
)
PLAY = {"x": 20e-6, "y": 8e-6}
PID = {"Pgain": 8.0, "Igain": 60.0, "Dgain": 0.1, "FF1": 0.014, "FF2": 0.0005}


def test_play_is_ranked_above_the_spikes_of_the_motors(tmp_path: Path) -> None:
    if missing():
        pytest.skip(missing())
    axis = {"gain": 1900.0, "damping": 25.0, "friction": 15.0, "noise": 2e-4, "frequency": 60.0, "behind": 12.0}
    plants = {name: Plant(play=1e3 * play, **axis) for name, play in PLAY.items()}
    log = Rig(plants, dict.fromkeys("xy", PID)).run(PROGRAM, tmp_path / "log.csv")
    rows = 1e-3 * np.loadtxt(log, delimiter=",", skiprows=1)

    def causes(first: int) -> dict[str, Cause]:
        runs = runs_of("log", rows[:, first : first + 2], PERIOD, Circle(np.zeros(2), 0.02), rows[:, 1:3])
        return {cause.name: cause for cause in causes_of(fit_circle(runs, ("x", "y")))}

    motor, load = causes(3), causes(5)
    assert list(load)[:2] == ["backlash x", "backlash y"]
    for name, play in PLAY.items():
        assert load[f"backlash {name}"].value == pytest.approx(play, abs=1e-6)
        own = motor[f"reversal spikes {name}"]
        assert load[f"reversal spikes {name}"].value == pytest.approx(own.value, abs=1e-6)
        assert own.value > motor[f"backlash {name}"].contribution
