"""``contourlab identify`` as typed for a log of commanded and actual position: the model by default, and files that `run` predicts with."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from identified_logs import codes
from typed_commands import AsJson, Refused

from contourlab.components.controller.steps import Steps
from contourlab.components.drive.step_generator import PositionLag
from contourlab.components.plant.stepper import StepDrive
from contourlab.feed import AxisLimits, plan, route_from_path
from contourlab.geometry import contour
from contourlab.loop import Axis, AxisController, Controller, Machine
from contourlab.loop.simulate import simulate

PERIOD = 1e-3
TRUE = {
    "x": {"natural_frequency": 30.0, "damping_ratio": 1.5, "velocity_feedforward": 0.6},
    "y": {"natural_frequency": 20.0, "damping_ratio": 1.2, "velocity_feedforward": 0.5},
}
TRUE_MACHINE = """
[machine]
name = "true"
servo_period = "1 ms"
axes = ["x", "y"]
[axes."*"]
substeps = 8
limits = {velocity = "200 mm/s", acceleration = "2 m/s^2", jerk = "40 m/s^3"}
drive = {kind = "position-lag", delay = "3.1 ms"}
[axes.x.plant]
kind = "step-drive"
natural_frequency = "30 Hz"
damping_ratio = 1.5
velocity_feedforward = 0.6
[axes.y.plant]
kind = "step-drive"
natural_frequency = "20 Hz"
damping_ratio = 1.2
velocity_feedforward = 0.5
"""
PART = "G21 G90 G17 G61\nF3000\nG1 X20 Y5\nG2 X20 Y25 I0 J10\nG1 X0 Y0\nM2\n"


@pytest.fixture(scope="module")
def log(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the log of two unequal axes along a star, with 0.5 um of noise."""
    folder = tmp_path_factory.mktemp("loops")
    axes = tuple(Axis(name, StepDrive(**plant), drive=PositionLag(delay=0.0031), substeps=8) for name, plant in TRUE.items())
    machine = Machine("true", axes, PERIOD)
    controller = Controller({name: AxisController(controller=Steps()) for name in TRUE})
    limits = AxisLimits(*(np.full(2, value) for value in (0.2, 2.0, 40.0)))
    reference = plan(route_from_path(contour("star", radius=0.02), feedrate=0.05), limits, PERIOD)
    run = simulate(machine, controller, reference)
    noise = 5e-7 * np.random.default_rng(0).standard_normal(run["position"].shape)
    columns = np.hstack([PERIOD * np.arange(run.n_sample)[:, None], 1e3 * run["reference"], 1e3 * (run["position"] + noise)])
    file = folder / "log.csv"
    heads = "time [s],x cmd [mm],y cmd [mm],x pos [mm],y pos [mm]"
    np.savetxt(file, columns, delimiter=",", header=heads, comments="", fmt="%.9g")
    return file


@pytest.mark.slow
def test_the_files_predict_what_was_measured(log: Path, tmp_path: Path, as_json: AsJson) -> None:
    machine = tmp_path / "machine.toml"
    answer = as_json("identify", log, "--write", machine)
    assert (answer["model"], answer["axis"]) == ("position-loop", "x, y")
    for axis, plant in TRUE.items():
        gain = 0.5 * 2.0 * np.pi * plant["natural_frequency"] / plant["damping_ratio"]
        for name, true in (("Kv", gain), ("delay", 0.0041), ("velocity_feedforward", plant["velocity_feedforward"])):
            figure = answer["parameters"][f"{name} {axis}"]
            assert abs(figure["value"] - true) < 4.0 * figure["robust_deviation"] < 0.5 * true
    (run,) = answer["details"]["runs"]
    measured, predicted = (run["contour_error"][name] for name in ("measured", "predicted"))
    assert predicted["rms"] == pytest.approx(measured["rms"], rel=0.02)
    assert predicted["largest"] == pytest.approx(measured["largest"], rel=0.05)
    (tmp_path / "part.ngc").write_text(PART)
    ran = as_json(*["run", tmp_path / "part.ngc", "--no-interval", "--out", tmp_path / "out"], *files_of(machine))
    true = tmp_path / "true.toml"
    true.write_text(TRUE_MACHINE)
    should = as_json(*["run", tmp_path / "part.ngc", "--no-interval", "--out", tmp_path / "true"], *files_of(machine, true))
    wanted, got = (one["schemes"]["base"]["metrics"]["contour_error"]["max"] for one in (should, ran))
    assert got == pytest.approx(wanted, rel=0.02)


def files_of(machine: Path, other: Path | None = None) -> list[str]:
    """Return the options of the files that were written, or of another machine with the same controller."""
    return ["--machine", str(other or machine), "--controller", str(machine.with_name("machine-controller.toml"))]


@pytest.mark.slow
def test_one_axis_can_be_named_and_the_model_too(log: Path, as_json: AsJson) -> None:
    answer = as_json("identify", log, "--axis", "y", "--model", "position-loop", "--window", "0..1500", "--validation", log)
    assert answer["axis"] == "y" and {*answer["parameters"]} >= {"Kv", "delay"}
    assert [run["contour_error"] for run in answer["details"]["runs"]] == [None, None]
    assert answer["details"]["runs"][1]["axes"]["y"]["stays"] < 0.05


@pytest.mark.slow
def test_a_second_log_with_the_same_samples_is_named(log: Path, as_json: AsJson) -> None:
    assert "CL516" in codes(as_json("identify", log, "--axis", "x", "--validation", log))


def test_a_sign_that_is_wrong_is_refused(log: Path, refused: Refused, tmp_path: Path) -> None:
    words = ["--column", "position.x=-x pos [mm]", "--column", "reference.x=x cmd [mm]", "--axis", "x"]
    assert "does not follow its reference" in refused("identify", log, *words, "--write", tmp_path / "machine.toml")
    assert not (tmp_path / "machine.toml").exists()


def test_a_log_with_a_force_still_has_a_mass(tmp_path: Path, as_json: AsJson) -> None:
    time = PERIOD * np.arange(8000)
    place = 0.02 * np.sin(2.0 * np.pi * 0.7 * time) + 0.006 * np.sin(2.0 * np.pi * 2.9 * time)
    speed = np.gradient(place, PERIOD)
    force = 40.0 * np.gradient(speed, PERIOD) + 150.0 * speed + 12.0 * np.sign(speed)
    file = tmp_path / "force.csv"
    heads = "time [s],x cmd [mm],x pos [mm],push [N]"
    np.savetxt(file, np.column_stack([time, 1e3 * place, 1e3 * place, force]), delimiter=",", header=heads, comments="", fmt="%.9g")
    assert as_json("identify", file, "--column", "force.x=push")["model"] == "rigid"


@pytest.mark.slow
def test_machine_and_controller_are_written_together_or_not_at_all(log: Path, refused: Refused, tmp_path: Path) -> None:
    (tmp_path / "machine-controller.toml").mkdir()
    refused("identify", log, "--axis", "x", "--write", tmp_path / "machine.toml")
    assert [file.name for file in tmp_path.iterdir() if file.suffix == ".toml"] == ["machine-controller.toml"]
