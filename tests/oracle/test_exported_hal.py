"""Exported HAL components: halcompile builds them, and LinuxCNC runs a circle with them in place of its `pid`."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from exported_axes import exported
from linuxcnc_rig import Plant, Rig, missing

from contourlab.engine.translate import hal
from contourlab.features.export.command import export
from contourlab.feed import Reference
from contourlab.loop import simulate
from contourlab.scenario import load_scenario

pytestmark = [pytest.mark.oracle, pytest.mark.skipif(shutil.which("halcompile") is None, reason="halcompile is not installed")]
MODULES = Path("/usr/lib/linuxcnc/modules")
NAMES = ("rigx", "rigy")
SCENARIO = """
name = "rig"
[machine]
name = "rig"
servo_period = "1 ms"
axes = ["rigx", "rigy"]
[axes."*"]
plant = {kind = "rigid-axis", gain = "2 m/s^2/full_scale", damping = "30 1/s"}
friction = {kind = "coulomb", coulomb = "0.01 full_scale"}
drive = {kind = "saturation", limit = "10 full_scale"}
limits = {velocity = "200 mm/s", acceleration = "1 m/s^2", jerk = "1000 m/s^3"}
[controller.axes."*"]
velocity = {kind = "filtered-difference", bandwidth = "1000 rad/s"}
feedforward = {kind = "friction", coulomb = "0.008 full_scale", breakaway = "0.008 full_scale", smoothing_velocity = "1 mm/s"}
controller = {kind = "position", gains = {natural_frequency = "60 rad/s", damping = 0.8, pole = "10 rad/s"}}
[controller.axes."*".observer]
kind = "disturbance-observer"
bandwidth = "60 rad/s"
filter_bandwidth = "1000 rad/s"
model_gain = "2 m/s^2/full_scale"
model_damping = "30 1/s"
[contour]
name = "circle"
radius = "10 mm"
[feed]
feedrate = "1 m/min"
"""
CONFIGURATION = """\
loadrt [KINS]KINEMATICS
loadrt [EMCMOT]EMCMOT servo_period_nsec=[EMCMOT]SERVO_PERIOD num_joints=[KINS]JOINTS
loadrt contourlab_axis names=axis.x,axis.y
addf motion-command-handler servo-thread
addf axis.x servo-thread
addf axis.y servo-thread
addf motion-controller servo-thread
{controllers}
{nets}
net z joint.2.motor-pos-cmd => joint.2.motor-pos-fb
net estop iocontrol.0.user-enable-out => iocontrol.0.emc-enable-in
"""
SIGNALS = """\
net {a}-fb axis.{a}.motor => joint.{n}.motor-pos-fb
net {a}-out axis.{a}.u
net {a}-load <= axis.{a}.load
"""


@pytest.mark.slow
@pytest.mark.parametrize(
    "case", ["controller/pid", "predictor/smith", "gap_observer/multiple-model", "compensation/quadrant-pulses", "drive/unlimited"]
)
def test_halcompile_builds_a_component(tmp_path: Path, case: str) -> None:
    (tmp_path / "axis_x.comp").write_text(hal.component_of(exported(case).control))
    done = subprocess.run(["halcompile", "--compile", "axis_x.comp"], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "warning" not in done.stderr
    assert (tmp_path / "axis_x.so").exists()


@pytest.fixture
def machine_files(tmp_path: Path) -> Iterator[Path]:
    """Export two axes, install their components, and write the HAL file from the exported lines; remove them afterwards."""
    if missing():
        pytest.skip(missing())
    file = tmp_path / "rig.toml"
    file.write_text(SCENARIO)
    export(file, to="hal").save(tmp_path / "code")
    controllers, nets = "", ""
    for n, axis in enumerate(NAMES):
        subprocess.run(["halcompile", "--install", f"axis_{axis}.comp"], cwd=tmp_path / "code", check=True, capture_output=True)
        lines = [line for line in (tmp_path / "code" / f"axis_{axis}.hal").read_text().splitlines() if not line.startswith("#")]
        controllers += "\n".join(line for line in lines if not line.startswith("net")) + "\n"
        exported_nets = "\n".join(line for line in lines if line.startswith("net")) + "\n"
        for theirs, ours in (("pos-cmd", "cmd"), ("pos-fb", "fb"), ("output", "out")):
            exported_nets = exported_nets.replace(f"net {axis}-{theirs}", f"net {'xy'[n]}-{ours}")
        nets += exported_nets + SIGNALS.format(a="xy"[n], n=n)
    (tmp_path / "rig.hal").write_text(CONFIGURATION.format(controllers=controllers, nets=nets))
    yield tmp_path
    for axis in NAMES:
        (MODULES / f"axis_{axis}.so").unlink(missing_ok=True)


@pytest.mark.slow
def test_linuxcnc_contours_as_simulated(machine_files: Path) -> None:
    rig = Rig(dict.fromkeys("xy", Plant(play=0.0, substeps=1)), hal=(machine_files / "rig.hal").read_text())
    log = rig.run("G21 G90 G17 G61\nF1000\nG2 X0 Y0 I10 J0\nM2\n", machine_files / "log.csv")
    rows = np.genfromtxt(log, delimiter=",", skip_header=1)
    moving = np.flatnonzero(np.any(np.diff(rows[:, 1:3], axis=0) != 0.0, axis=1))
    rows = 1e-3 * rows[moving[0] - 1 : moving[-1] + 2]
    commanded, measured = rows[:, 1:3], rows[:, 3:5]
    case = load_scenario(machine_files / "rig.toml").base
    reference = Reference.from_samples(commanded, 1e-3, case.reference().path)
    simulated = simulate(case.machine, case.controller, reference)["position"]

    def rms_and_largest(points: np.ndarray) -> list[float]:
        distance = np.abs(np.hypot(points[:, 0] - 0.01, points[:, 1]) - 0.01)
        return [float(np.sqrt(np.mean(distance**2))), float(distance.max())]

    assert rms_and_largest(commanded)[1] < 0.1e-6
    assert rms_and_largest(measured) == pytest.approx(rms_and_largest(simulated), rel=0.01)
