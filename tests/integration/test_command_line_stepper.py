"""A router with stepper motors, as a user writes it: run, judged, and what other commands make of a machine without gains."""

from __future__ import annotations

import json
import re
import shlex
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from refusals import mentions
from typed_commands import Run, Said, write

from contourlab.cli.main import main
from contourlab.result import Result
from contourlab.scenario import load_axis

MACHINE = """\
[machine]
name = "router"
servo_period = "1 ms"
axes = ["x", "y"]
[axes."*"]
substeps = 5
[axes."*".plant]
kind = "stepper"
mass = "8 kg"
inertia = "0.6 kg*cm^2"
lead = "5 mm"
holding_torque = "1.9 N*m"
microsteps = 8
[axes."*".friction]
kind = "coulomb"
coulomb = "30 N"
breakaway = "40 N"
[axes."*".drive]
kind = "step-generator"
acceleration_limit = "8 m/s^2"
[axes."*".limits]
velocity = "12 m/min"
acceleration = "1.2 m/s^2"
jerk = "100 m/s^3"
travel = "400 mm"
"""
STEPS = '[controller.axes."*"]\ncontroller = "steps"\n'
CIRCLE = (
    'machine = "router.toml"\ncontour = {name = "circle", radius = "20 mm"}\n'
    + STEPS
    + '[feed]\nfeedrate = "3 m/min"\n[run]\ntolerance = "30 um"\n'
)
LINE = "G21 G90 G61 F12000\nG1 X40\nG1 Y40\nG1 X0\nG1 Y0\nM2\n"
WEAK = MACHINE.replace("1.9 N*m", "0.3 N*m")
HASTY = WEAK.replace('"1.2 m/s^2"', '"6 m/s^2"')
FULL_STEP = 25e-6


@pytest.fixture(autouse=True)
def files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for name, text in (("router.toml", MACHINE), ("steps.toml", STEPS), ("circle.toml", CIRCLE), ("part.ngc", LINE)):
        Path(name).write_text(text, encoding="utf-8")


def read(said: Said) -> dict[str, Any]:
    scheme: dict[str, Any] = json.loads(said.out)["schemes"]["base"]
    return scheme


def test_a_circle_runs_and_passes_and_a_failure_has_a_next_command(contourlab: Run) -> None:
    said = contourlab("run", "circle.toml")
    assert (said.code, said.err) == (0, "")
    result = Result.load("results/signals/base.nc")
    # The count is at the command a period later, the motor close to it.
    off = result["applied_command"][:-1] - result["axis_position"][1:]
    assert 0.05 * FULL_STEP < np.abs(off).max() < 0.5 * FULL_STEP
    assert "next: " not in said.out
    Path("circle.toml").write_text(CIRCLE.replace('"30 um"', '"1 um"'), encoding="utf-8")
    said = contourlab("run", "circle.toml")
    words = shlex.split(next(line for line in said.out.splitlines() if line.startswith("next: ")))[2:]
    assert (said.code, words[0]) == (1, "sensitivity")
    assert main([*words, "--values", "5", "--parts", "curves"]) == 0


def test_an_acceleration_too_high_loses_steps_and_says_where(contourlab: Run) -> None:
    Path("router.toml").write_text(HASTY, encoding="utf-8")
    asked = ("run", "part.ngc", "--machine", "router.toml", "--controller", "steps.toml", "--tolerance", "20 mm", "--json")
    said = contourlab(*asked)
    scheme = read(said)
    assert (said.code, said.err, scheme["verdict"]["passed"]) == (1, "", False)
    assert scheme["metrics"]["part_error"]["max"] < 20e-3
    lost = [each for each in scheme["findings"] if each["code"] == "CL209"]
    result = Result.load("results/signals/base.nc")
    off = (result["applied_command"][:-1] - result["axis_position"][1:]) / FULL_STEP
    for each in lost:
        i = "xy".index(each["place"][5])
        first = int(np.flatnonzero(np.abs(off[:, i]) > 2.0)[0]) + 1
        assert each["values"]["time"] == pytest.approx(first * 1e-3)
        assert each["values"]["line"] == {"x": 2, "y": 3}[each["place"][5]]
        assert each["values"]["steps"] == 4 * abs(round(off[-1, i] / 4.0))
        assert each["values"]["most"] == pytest.approx(np.abs(off[:, i]).max() * FULL_STEP)
    assert len(lost) == 2
    assert scheme["metrics"]["part_error"]["max"] > 50.0 * FULL_STEP


def test_at_an_acceleration_that_it_can_it_loses_none(contourlab: Run) -> None:
    Path("router.toml").write_text(WEAK, encoding="utf-8")
    said = contourlab("run", "part.ngc", "--machine", "router.toml", "--controller", "steps.toml", "--tolerance", "30 um", "--json")
    assert (said.code, [each["code"] for each in read(said)["findings"] if each["code"] == "CL209"]) == (0, [])


def test_a_step_generator_below_the_limits_of_the_axis_is_the_cause_of_the_error(contourlab: Run) -> None:
    Path("router.toml").write_text(MACHINE.replace('"8 m/s^2"', '"0.3 m/s^2"'), encoding="utf-8")
    said = contourlab("run", "circle.toml", "--json")
    verdict = read(said)["verdict"]
    assert (said.code, verdict["causes"][0]["name"]) == (1, "saturation")
    assert verdict["causes"][0]["share"] > 0.9


def test_a_motor_that_stalls_diverges_and_says_where_it_lost_steps(contourlab: Run) -> None:
    Path("router.toml").write_text(HASTY.replace("microsteps = 8", 'microsteps = 8\ncorner_speed = "20 mm/s"'), encoding="utf-8")
    Path("part.ngc").write_text("G21 G90 G61 F12000\nG1 X20\nG1 X350\nM2\n", encoding="utf-8")
    said = contourlab("run", "part.ngc", "--machine", "router.toml", "--controller", "steps.toml", "--tolerance", "30 um")
    assert said.code == 3
    assert mentions([said.err], "axis x", "line 2", "full steps")


REFUSED = {
    ("tune", "circle.toml"): "stepper",
    ("analyse", "circle.toml"): "stepper",
    ("notch", "circle.toml"): "stepper",
    ("link", "circle.toml"): "stepper",
    ("sensitivity", "circle.toml", "--quick"): "stepper",
    ("swap", "circle.toml", "--axis", "y", "--with", "module.toml"): "stepper",
    ("export", "circle.toml", "--to", "c99"): '"steps"',
    ("backlash", "circle.toml"): "backlash",
}


@pytest.mark.parametrize(("words", "what"), REFUSED.items(), ids=[words[0] for words in REFUSED])
def test_questions_about_gains_end_in_one_line(words: tuple[str, ...], what: str, contourlab: Run) -> None:
    module = MACHINE[MACHINE.index('[axes."*".plant]') :].replace('axes."*".', "").replace("1.9", "1.5")
    Path("module.toml").write_text("substeps = 5\n" + module, encoding="utf-8")
    said = contourlab(*words)
    assert (said.code, said.out) == (2, "")
    assert len([line for line in said.err.splitlines() if line.startswith("contourlab: ")]) == 1
    assert mentions([said.err], what)


def test_beside_a_step_drive_the_other_axis_has_gains(contourlab: Run) -> None:
    drive = 'substeps = 2\nplant = {kind = "step-drive", natural_frequency = "40 Hz", velocity_feedforward = 1}'
    screw = 'plant = {kind = "ball-screw", mass = "33 kg", inertia = "2 kg*cm^2", lead = "10 mm", torque_constant = "0.49 N*m/A"}'
    head, limits = MACHINE[: MACHINE.index('[axes."*"]')], MACHINE[MACHINE.index('[axes."*".limits]') :]
    Path("router.toml").write_text(f"{head}[axes.x]\n{drive}\n[axes.y]\n{screw}\n{limits}", encoding="utf-8")
    cascade = 'controller = {kind = "cascade", gains = {bandwidth = "300 rad/s"}}'
    loops = f'[controller.axes.x]\ncontroller = "steps"\n[controller.axes.y]\n{cascade}\n'
    Path("circle.toml").write_text(CIRCLE.replace(STEPS, loops), encoding="utf-8")
    assert contourlab("run", "circle.toml").code in (0, 1)
    assert contourlab("analyse", "circle.toml").code == 0
    assert contourlab("tune", "circle.toml", "--budget", "50").code in (0, 1)


def test_the_machines_of_the_guide_run(contourlab: Run) -> None:
    page = (Path(__file__).parents[2] / "docs/how-to/steppers.md").read_text(encoding="utf-8")
    router, drive = re.findall(r"^```toml\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
    Path("router.toml").write_text(router, encoding="utf-8")
    assert contourlab("run", "router.toml").code == 0
    axis = load_axis(write(Path(), drive, "axis.toml"), "x")
    lag = axis.plant.values()
    late = 2.0 * lag["damping_ratio"] * (1.0 - lag["velocity_feedforward"]) / (2.0 * np.pi * lag["natural_frequency"])
    assert f"{1e3 * late:.2g} ms" in page


def test_check_and_limits_answer_as_for_any_machine(contourlab: Run) -> None:
    for words in (("check", "part.ngc"), ("limits", "part.ngc")):
        said = contourlab(*words, "--machine", "router.toml")
        assert (said.code, said.err) == (0, "")


@pytest.mark.slow
def test_learning_and_precompensation_change_the_reference(contourlab: Run) -> None:
    law = '[learning]\nlaw = {kind = "zero-phase", gain = 0.3, half_width = 5, target = "reference"}\ntrials = 2\n'
    Path("learn.toml").write_text(CIRCLE + law, encoding="utf-8")
    assert contourlab("learn", "learn.toml").code == 0
    asked = ("precompensate", "part.ngc", "--machine", "router.toml", "--controller", "steps.toml", "--out", "pre.ngc", "--repeat", "1")
    assert contourlab(*asked).code in (0, 1)


def test_a_sweep_over_the_torque_finds_where_it_is_too_small(contourlab: Run) -> None:
    Path("sweep.toml").write_text(
        'scenario = "circle.toml"\nvariants = 8\ndesign = "sobol"\ntolerance = "30 um"\n[vary]\n'
        '"axes.*.plant.holding_torque" = {log-uniform = ["0.02 N*m", "1.9 N*m"], together = true}\n',
        encoding="utf-8",
    )
    said = contourlab("sweep", "sweep.toml", "--out", "store", "--json")
    assert said.code == 0
    found = json.loads(said.out)
    assert 0 < found["yield"]["passed"] < 8
