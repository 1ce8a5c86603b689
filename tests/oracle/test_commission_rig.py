"""`commission linuxcnc` against LinuxCNC itself: its gains in the real control, on simulated axes."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from linuxcnc_rig import Plant, Rig, missing
from made_commission import fitted_once

from contourlab.features.commission.command import commission
from contourlab.features.commission.excitation import excitation
from contourlab.features.commission.identification import IdentifiedAxis, identify_axis
from contourlab.features.commission.loop import GAINS, Law
from contourlab.features.commission.records import moving, read_log
from contourlab.features.commission.setup import read_setup

PROGRAM = "G21 G90 G17 G64 P0.002\nG1 F3000 X15 Y0\nG3 X15 Y0 I-15 J0\nG2 X15 Y0 I-15 J0\nG1 X0 Y-5\nG1 X0 Y0\nM2\n"
PLANTS = {
    "x": Plant(gain=1350.0, damping=22.0, friction=31.0, play=0.034, noise=0.0004),
    "y": Plant(gain=3800.0, damping=47.0, friction=9.0, play=0.011, noise=0.0002, substeps=1),
}

pytestmark = [pytest.mark.oracle, pytest.mark.slow]  # LinuxCNC runs in real time


LOADED = {
    "x": Plant(gain=1900.0, damping=25.0, friction=15.0, play=0.03, noise=0.0002, frequency=45.0, behind=12.0),
    "y": Plant(gain=1900.0, damping=25.0, friction=15.0, play=0.03, noise=0.0002, frequency=90.0, part=0.3, behind=6.0),
}


def largest(log: Path) -> np.ndarray:
    """Return the largest |command - motor position| [um] of both axes."""
    rows = np.loadtxt(log, delimiter=",", skiprows=1)
    return 1e3 * np.abs(rows[:, 1:3] - rows[:, 3:5]).max(axis=0)


def test_one_log_gives_gains_for_the_real_control(tmp_path: Path) -> None:
    if missing():
        pytest.skip(missing())
    rig = Rig(PLANTS)
    ini, hal = rig.write(tmp_path)
    commission(ini, hal).save(tmp_path / "out")
    log = rig.run((tmp_path / "out" / "excite.ngc").read_text(), tmp_path / "log.csv")
    program = tmp_path / "part.ngc"
    program.write_text(PROGRAM)
    result = commission(ini, hal, log=[log], program=program).save(tmp_path / "out")
    assert result.passed
    for axis, plant in PLANTS.items():
        model = result.models[axis]
        assert model.play == pytest.approx(1e-3 * plant.play, abs=max(4.0 * model.play_deviation, 1e-6))
    before = largest(rig.run(PROGRAM, tmp_path / "before.csv"))
    after = largest(Rig(PLANTS, result.pid).run(PROGRAM, tmp_path / "after.csv"))
    predicted = np.array([[result.predicted[axis].before, result.predicted[axis].after] for axis in "xy"])
    assert (before > 10.0 * after).all(), (before, after)
    for measured, expected in ((before, predicted[:, 0]), (after, predicted[:, 1])):
        assert (measured < 2.0 * expected).all(), (measured, expected)
        assert (expected < 2.0 * measured).all(), (measured, expected)
    for share in (0.75, 1.25):
        scaled = {axis: replace(plant, gain=share * plant.gain) for axis, plant in PLANTS.items()}
        off = largest(Rig(scaled, result.pid).run(PROGRAM, tmp_path / "off.csv"))
        assert (off < 0.2 * before).all(), (off, before)


VELOCITY = {
    "x": Plant(gain=250.0, damping=265.0, friction=25.0, play=0.02, noise=0.0002, regulated=250.0, reset=18.0),
    "y": Plant(1000.0, 62.0, 14.0, play=0.03, noise=0.0003, frequency=55.0, part=0.3, behind=9.0, regulated=50.0, reset=6.0),
}
"""Inner loops of 250 and 50 1/s; the second one takes 20 times its output as speed, and moves a load with inertia behind play."""


def test_velocity_drives_are_found_and_do_what_is_predicted(tmp_path: Path) -> None:
    if missing():
        pytest.skip(missing())
    before = {"x": {"Pgain": 15.0, "Igain": 0.0, "FF1": 0.8}, "y": {"Pgain": 0.4, "Igain": 0.0, "FF1": 0.04}}
    ini, hal = (rig := Rig(VELOCITY, before)).write(tmp_path)
    program = excitation(read_setup(ini, hal))
    result = commission(ini, hal, log=[rig.run(program, tmp_path / "log.csv")], drive="velocity")
    assert result.passed and {axis.loop for axis in result.axes.values()} == {"velocity drive"}
    for axis, plant in VELOCITY.items():
        model = result.models[axis].model
        assert (model.regulated, model.reset) == pytest.approx((plant.regulated, plant.reset), rel=0.05)
    rows = np.loadtxt(Rig(VELOCITY, result.pid).run(program, tmp_path / "after.csv"), delimiter=",", skiprows=1)
    after = result.predicted
    for places, expected in ((rows[:, 3:5], [after[a].after for a in "xy"]), (rows[:, 5:7], [after[a].load for a in "xy"])):
        measured = 1e3 * np.abs(rows[:, 1:3] - places).max(axis=0)
        assert (measured < 1.5 * np.array(expected)).all() and (np.array(expected) < 1.5 * measured).all(), (measured, expected)
    assert (largest(tmp_path / "after.csv") < 0.1 * largest(tmp_path / "log.csv")).all()


def test_play_behind_a_load_with_inertia(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    if missing():
        pytest.skip(missing())
    fitted_once(monkeypatch)
    rig = Rig(LOADED)
    ini, hal = rig.write(tmp_path)
    setup = read_setup(ini, hal)
    log = rig.run(excitation(setup), tmp_path / "log.csv")
    record, _ = read_log(log, setup)
    for axis in setup.axes[:2]:
        present = np.array([axis.gains[name] / setup.unit for name in GAINS])
        for load in (True, False):
            one = moving(record[axis.name] if load else replace(record[axis.name], load=None))
            found = identify_axis([one], present, Law(setup.period))
            assert isinstance(found, IdentifiedAxis)
            assert not load or found.play == pytest.approx(30e-6, abs=2e-6)
            assert abs(found.play - 30e-6) < 2.0 * found.play_deviation
