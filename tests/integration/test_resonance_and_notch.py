"""A resonance at 60 Hz from a log to a controller with a notch, as typed."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest
from identified_logs import codes, found_by
from typed_commands import AsJson, Refused

from contourlab.analysis.linear.sampled_loop import sampled_loop
from contourlab.app.results import SAFETY
from contourlab.cli.main import main
from contourlab.scenario import load_scenario
from contourlab.scenario.load import load_axis

MACHINE = """
[machine]
name = "gantry"
servo_period = "0.5 ms"
axes = ["x", "y"]
[axes."*"]
friction = {kind = "coulomb", coulomb = "60 N"}
drive = {kind = "delayed-saturation", limit = "40 A", delay = "1 ms"}
limits = {velocity = "12 m/min", acceleration = "1.5 m/s^2", jerk = "40 m/s^3"}
[axes.x.plant]
kind = "two-mass"
mass = "40 kg"
load_share = 0.8
resonance = "60 Hz"
damping_ratio = 0.03
damping = "80 N*s/m"
force_constant = "55 N/A"
[axes.x.motor_sensor]
kind = "encoder"
resolution = "0.1 um"
noise = "50 nm"
[axes.y]
plant = {kind = "mass-damper", mass = "25 kg", damping = "80 N*s/m", force_constant = "55 N/A"}
sensor = {kind = "encoder", resolution = "0.1 um", noise = "50 nm"}
"""
SHAKE = """
name = "axis x shaken"
program = "shake.ngc"
machine = "machine.toml"
[controller.axes."*"]
feedback = "motor"
velocity = {kind = "filtered-difference", bandwidth = "3000 rad/s"}
controller = {kind = "cascade", gains = {bandwidth = "30 rad/s", damping = 1.0, position_gain = "5 1/s"}}
[controller.axes.x.feedforward]
kind = "sweep"
amplitude = "1 A"
first_frequency = "10 Hz"
last_frequency = "250 Hz"
duration = "2 s"
"""
PART = """
name = "a pocket"
program = "part.ngc"
[machine]
file = "machine.toml"
[axes.x]
file = "x.toml"
friction = {kind = "coulomb", coulomb = "60 N"}
[axes.x.limits]
velocity = "12 m/min"
acceleration = "1.5 m/s^2"
jerk = "40 m/s^3"
[axes.x.drive]
limit = "40 A"
[controller.axes."*"]
feedback = "motor"
velocity = {kind = "filtered-difference", bandwidth = "3000 rad/s"}
controller = {kind = "cascade", gains = {bandwidth = "70 rad/s", damping = 1.0, position_gain = "14 1/s"}}
"""
TRUE = {"mass": 40.0, "load_share": 0.8, "resonance": 60.0, "damping_ratio": 0.03, "damping": 80.0, "delay": 1e-3}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with a log of the axis, shaken while it moves one way, so that friction does not reverse."""
    folder = tmp_path_factory.mktemp("resonance")
    for name, text in (("machine.toml", MACHINE), ("shake.toml", SHAKE), ("part.toml", PART)):
        (folder / name).write_text(text)
    (folder / "shake.ngc").write_text("G21 G90\nG1 X400 F2400\nM2\n")
    (folder / "part.ngc").write_text("G21 G90 G64 P0.01\nG1 X40 F3000\nY40\nG2 X20 Y20 I-20 J0\nG1 X0 Y0\nM2\n")
    assert main(["run", str(folder / "shake.toml"), "--out", str(folder / "shaken")]) == 0
    return folder


def words(folder: Path, *more: str) -> list[str]:
    given = ["--model", "two-mass", "--axis", "x", "--gain", "55 N/A", "--excitation", "command"]
    return [str(folder / "shaken/signals/base.nc"), *given, *more]


@pytest.fixture
def identified(folder: Path, capsys: pytest.CaptureFixture[str]) -> dict[str, Any]:
    capsys.readouterr()
    return found_by(words(folder, "--write", str(folder / "x.toml")), capsys)


def test_the_log_gives_the_resonance_and_the_masses(folder: Path, identified: dict[str, Any]) -> None:
    for name, value in TRUE.items():
        figure = identified["parameters"][name]
        assert abs(figure["value"] - value) < 3.0 * figure["robust_deviation"], name
        assert figure["value"] == pytest.approx(value, rel=0.02)
    axis = load_axis(folder / "x.toml")
    assert axis.plant.kind == "two-mass" and axis.plant.values()["resonance"] == pytest.approx(60.0, rel=1e-3)
    assert axis.plant.origins["damping_ratio"].source == "fitted" and axis.motor_sensor.kind == "encoder"
    assert any(set(pair[:2]) == {"plant.load_share", "plant.resonance"} for pair in axis.correlations)


@pytest.mark.slow
def test_the_reference_of_a_moving_axis_is_no_test_signal(folder: Path, refused: Refused, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    given = words(folder)
    del given[-2:]
    main(["identify", *given, "--json"])
    answer = json.loads(capsys.readouterr().out)
    assert "problems" in answer or not answer["usable"]
    assert "--excitation" in refused("identify", *words(folder)[:-1], "noise")


@pytest.mark.slow
def test_the_notch_keeps_6_db_and_30_degrees_with_the_gains_that_break_them(
    folder: Path, identified: dict[str, Any], as_json: AsJson
) -> None:
    out = folder / "notched.toml"
    found = as_json("notch", folder / "part.toml", "--write", out)
    assert f"# {SAFETY}" in out.read_text().splitlines()
    design = found["designs"]["x"]
    assert list(found["designs"]) == ["x"] and not codes(found)
    assert design["resonance"] == pytest.approx(60.0, rel=1e-3)
    assert design["velocity_gain_after"] == design["velocity_gain_before"]
    before, after = design["margins_before"], design["margins_after"]
    assert 20.0 * math.log10(before["gain"]) < 6.0 and math.degrees(before["phase"]) < 30.0
    for margins in (after, *design["margins_moved"]):
        assert 20.0 * math.log10(margins["gain"]) >= 6.0 and math.degrees(margins["phase"]) >= 30.0
    assert design["largest_after"] > 1.5 * design["largest_before"]
    # Without a notch the same margins cost more than half of the contour error.
    rms = {key: found[key]["figures"]["contour_error_rms"] for key in ("before", "without", "after")}
    assert rms["after"] < 0.6 * rms["without"]
    # The machine itself, not its model, under the controller that was written.
    true = 'name = "after"\nprogram = "part.ngc"\nmachine = "machine.toml"\ncontroller = "notched.toml"\n'
    (folder / "notched-part.toml").write_text(true)
    scenario = load_scenario(folder / "notched-part.toml")
    truth = scenario.machine.axis("x")
    assert truth.plant.values()["mass"] == 40.0
    real = sampled_loop(truth, scenario.controller.axes["x"], scenario.machine.servo_period).margins()
    assert 20.0 * math.log10(real.gain) > 6.0 and math.degrees(real.phase) > 30.0
    assert main(["run", str(folder / "notched-part.toml"), "--out", str(folder / "after")]) == 0


@pytest.mark.slow
def test_before_and_after_are_printed(folder: Path, identified: dict[str, Any], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["notch", str(folder / "part.toml")]) == 0
    text = capsys.readouterr().out
    for row in ("gain margin", "phase margin", "velocity gain", "contour error, rms"):
        assert sum(line.startswith(row) for line in text.splitlines()) == 1


@pytest.mark.slow
def test_gains_that_no_notch_saves_are_lowered(folder: Path, identified: dict[str, Any], as_json: AsJson) -> None:
    (folder / "fast.toml").write_text(PART.replace('bandwidth = "70', 'bandwidth = "150'))
    found = as_json("notch", folder / "fast.toml")
    assert codes(found) == {"CL642"} and not found["designs"]["x"]["margins_before"]["stable"]
    assert found["designs"]["x"]["velocity_gain_after"] == found["designs"]["x"]["largest_after"]


@pytest.mark.slow
def test_a_position_loop_that_is_too_fast_fails(folder: Path, identified: dict[str, Any], as_json: AsJson) -> None:
    (folder / "stiff.toml").write_text(PART.replace('position_gain = "14', 'position_gain = "80'))
    assert codes(as_json("notch", folder / "stiff.toml", code=1)) == {"CL641"}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("more", "word"), [(["--axes", "z"], "z"), (["--axes", "y"], "mass-damper"), (["--write", "notched.json"], ".toml")]
)  # fmt: skip
def test_faults_are_named(folder: Path, identified: dict[str, Any], more: list[str], word: str, refused: Refused) -> None:
    error = refused("notch", folder / "part.toml", *more)
    assert word in error


@pytest.mark.slow
def test_axes_that_keep_their_margins_get_no_notch(folder: Path, identified: dict[str, Any], as_json: AsJson) -> None:
    (folder / "slow.toml").write_text(PART.replace('bandwidth = "70', 'bandwidth = "30'))
    found = as_json("notch", folder / "slow.toml")
    assert codes(found) == {"CL640"} and not found["designs"]
