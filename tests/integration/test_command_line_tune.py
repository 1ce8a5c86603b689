"""``contourlab tune`` as a user types it: the answer, the file, and refusals."""

from __future__ import annotations

import json
import math
import shlex
from pathlib import Path
from typing import Any

import pytest
from typed_commands import contents

from contourlab.app.results import SAFETY
from contourlab.cli.main import main
from contourlab.features.tune import study
from contourlab.scenario import load_scenario

STAGE = """\
[machine]
name = "XY"
servo_period = "1 ms"
axes = ["x", "y"]
[axes."*"]
plant = {kind = "rigid-axis", gain = "1200 mm/s^2/full_scale", damping = "9 1/s"}
friction = {kind = "coulomb", coulomb = "0.02 full_scale"}
drive = {kind = "saturation", limit = "1 full_scale"}
sensor = {kind = "encoder", resolution = "0.5 um"}
limits = {velocity = "200 mm/s", acceleration = "1 m/s^2", jerk = "20 m/s^3"}
"""
MOTION = """
name = "circle"
machine = "stage.toml"
controller = "control.toml"
[contour]
name = "circle"
radius = "10 mm"
[feed]
law = "uniform"
frequency = "0.5 Hz"
laps = 2
[run]
tolerance = "%s um"
"""
CONTROL = {
    "position": 'kind = "position"\nvelocity_gain = "0.04 full_scale*s/mm"\nposition_gain = "1.5 full_scale/mm"\nintegral_gain = "5 1/s"\n'
    'model_gain = "900 mm/s^2/full_scale"\nmodel_damping = "6 1/s"\n',
    "cascade": 'kind = "cascade"\ngains = {bandwidth = "100 rad/s"}\n',
    "pid": 'kind = "pid"\nproportional_gain = "1.5 full_scale/mm"\nintegral_gain = "6 full_scale/mm/s"\n'
    'derivative_gain = "0.04 full_scale*s/mm"\n',
    "lead-lag": 'kind = "lead-lag"\ngains = {phase_margin = "60 deg", crossover = "60 rad/s"}\n',
    "state-feedback": 'kind = "state-feedback"\ngains = {natural_frequency = "50 rad/s", damping = 0.8, pole = "10 rad/s"}\n',
}


@pytest.fixture(autouse=True)
def _in_a_folder_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def written(folder: Path, kind: str = "position", tolerance: str = "100") -> Path:
    """Write a scenario of two axes under a kind of controller."""
    (folder / "stage.toml").write_text(STAGE)
    velocity = '[controller.axes."*".velocity]\nkind = "filtered-difference"\nbandwidth = "1500 rad/s"\n'
    (folder / "control.toml").write_text(f'[controller.axes."*".controller]\n{CONTROL[kind]}{velocity}')
    file = folder / "circle.toml"
    file.write_text(MOTION % tolerance)
    return file


def codes(found: dict[str, Any]) -> list[str]:
    """Return the codes of the findings of a calibration."""
    return [one["code"] for one in found["findings"]]


@pytest.mark.parametrize("kind", sorted(CONTROL))
@pytest.mark.slow
def test_every_kind_of_controller_is_calibrated_and_its_file_runs(kind: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, out = written(tmp_path, kind), tmp_path / "tuned.toml"
    assert main(["tune", str(file), "--budget", "200", "--write", str(out), "--json"]) == 0
    told = capsys.readouterr()
    found = json.loads(told.out)
    assert told.err == "" and found["result"]["runs"] > 90
    assert found["passed"] is True and found["result"]["after"]["violations"] == []
    before, after = (found["result"][key] for key in ("before", "after"))
    assert after["figures"]["part_error_max"] <= before["figures"]["part_error_max"]
    for margins in after["margins"].values():
        assert margins["gain"] is None or 20.0 * math.log10(margins["gain"]) >= 6.0
        assert math.degrees(margins["phase"]) >= 30.0
    assert out.read_text().startswith("# ") and f"# {SAFETY}" in out.read_text().splitlines()
    again = tmp_path / "again.toml"
    again.write_text(file.read_text().replace("control.toml", "tuned.toml"))
    capsys.readouterr()
    assert main(["run", str(again), "--out", str(tmp_path / "results"), "--json"]) == 0
    ran = json.loads(capsys.readouterr().out)
    error = ran["schemes"]["base"]["metrics"]["contour_error"]
    assert error["integral"] == pytest.approx(after["figures"]["contour_error_integral"], rel=1e-9)
    made = load_scenario(again).controller
    for name, value in found["result"]["values"].items():
        _, _, axis, slot, word = name.split(".")
        assert getattr(getattr(made.axes[axis], slot), word) == value, name
    for number in found["result"]["space"]["numbers"]:
        value = found["result"]["values"][number["name"]]
        assert number["low"] * (1.0 - 1e-5) <= value <= number["high"] * (1.0 + 1e-5), number["name"]  # six digits


@pytest.mark.slow
def test_the_text_shows_the_search_and_drive_terms(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path)
    words = ["tune", str(file), "--method", "both", "--budget", "200", "--plots", "svg", "--out", str(tmp_path / "pictures")]
    assert main(words) == 0
    said = capsys.readouterr().out
    for part in ("pass 1", "Kv", "Pgain", "FF2", "CL607"):
        assert part in said, part
    *_, last = said.splitlines()
    kept = tmp_path / "pictures" / "tuned.toml"
    assert last == f"next: contourlab run {file} --controller {kept}"
    assert main([*shlex.split(last)[2:], "--check"]) == 0
    assert {path.name for path in (tmp_path / "pictures" / "plots").iterdir()} == {"tune-course.svg", "tune-lines.svg", "tune-error.svg"}


@pytest.mark.slow
def test_an_interrupted_search_keeps_what_one_parameter_at_a_time_found(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    file, words = written(tmp_path), ["--parameter", "x.position_gain", "--parameter", "x.model_gain", "--budget", "200", "--json"]

    def stopped(*given: Any, **options: Any) -> Any:
        raise KeyboardInterrupt

    assert main(["tune", str(file), *words, "--method", "sequential", "--write", str(tmp_path / "whole.toml")]) == 0
    whole = json.loads(capsys.readouterr().out)
    monkeypatch.setattr(study, "global_search", stopped)
    assert main(["tune", str(file), *words]) == 130
    found = json.loads(capsys.readouterr().out)
    assert "CL610" in codes(found) and found["result"]["values"] == whole["result"]["values"]
    assert (tmp_path / "results" / "tuned.toml").read_text() == (tmp_path / "whole.toml").read_text()
    assert main(["tune", str(file), *words, "--method", "global"]) == 130
    assert capsys.readouterr().out == ""


def test_a_tolerance_that_is_missed_is_a_failed_verdict(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path, tolerance="0.01")
    assert main(["tune", str(file), "--parameter", "x.position_gain", "--budget", "100", "--json"]) == 1
    found = json.loads(capsys.readouterr().out)
    assert not found["passed"] and "CL608" in codes(found)


@pytest.mark.slow
def test_figures_that_grow_are_reported(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Energy is saved at the cost of the path; the objective is listed first."""
    words = ["tune", str(written(tmp_path)), "--objective", "energy", "--parameter", "y.model_gain", "--parameter", "y.model_damping"]
    assert main([*words, "--budget", "400", "--json"]) == 1
    found = json.loads(capsys.readouterr().out)
    ratios = {one["place"]: one["values"]["ratio"] for one in found["findings"] if one["code"] == "CL609"}
    energy, integral = ratios.values()
    assert next(iter(ratios)) == "command energy" and energy < 1.0 < integral


def test_an_optimum_at_a_bound_is_reported(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["tune", str(written(tmp_path)), "--parameter", "x.model_gain=0.8 m/s^2/full_scale..1 m/s^2/full_scale"]
    assert main([*words, "--budget", "400", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert list(found["result"]["values"].values()) == pytest.approx([0.8], rel=1e-3)
    assert [one["values"]["parameters"] for one in found["findings"] if one["code"] == "CL602"] == [["x.model_gain"]]


@pytest.mark.slow
def test_a_result_that_violates_a_bound_is_not_written(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "tuned.toml"
    words = ["tune", str(written(tmp_path)), "--parameter", "x.model_gain", "--phase-margin", "85", "--budget", "100"]
    words += ["--write", str(out), "--json"]
    assert main(words) == 1
    found = json.loads(capsys.readouterr().out)
    assert "CL606" in codes(found) and found["controller_file"] is None
    assert not out.exists()


@pytest.mark.slow
def test_a_part_program_on_a_machine(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    part, out = tmp_path / "part.ngc", tmp_path / "tuned.toml"
    part.write_text("%\nG17 G21 G90 G94\nG1 X5 F1500\nG3 X5 Y6 I0 J3\nM30\n%\n")
    words = ["tune", str(part), "--machine", "xyz", "--controller", "xyz-controller", "--parameter", "y.position_gain", "--write", str(out)]
    words += ["--budget", "100"]
    assert main([*words, "--tolerance", "50 um"]) == 0
    assert "CL607" in capsys.readouterr().out
    assert main(["run", str(part), "--machine", "xyz", "--controller", str(out), "--check", "--out", str(tmp_path / "r")]) == 0


@pytest.mark.slow
def test_a_scheme_is_chosen_by_its_name(capsys: pytest.CaptureFixture[str]) -> None:
    words = ["tune", "builtin:ghaffari/demo-stage.toml", "--scheme", "with modified reference, initial gains", "--json"]
    assert main([*words, "--parameter", "observer.model_damping", "--budget", "100"]) in (0, 1)
    found = json.loads(capsys.readouterr().out)
    assert found["scheme"] == "with modified reference, initial gains"
    assert found["result"]["before"]["figures"]["contour_error_integral"] == pytest.approx(272.9e-6, rel=1e-3)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--scheme", "none such"], "no scheme"),
        (["--method", "magic"], "sequential, global, both"),
        (["--start", "here"], "scenario, placed"),
        (["--objective", "speed"], "integral"),
        (["--parameter", "x.none"], "such as"),
        (["--parameter", "x.position_gain=1..2"], "full_scale/mm"),
        (["--plateau", "flat"], "robust"),
        (["--lanes", "2"], "8 to 1024"),
        (["--seed", "-1"], "0 to "),
        (["--workers", "0"], "1 or more"),
        (["--gain-margin", "-1"], "0 to 60"),
        (["--plots", "bmp"], "png"),
        (["--write", "tuned.txt"], ".toml"),
        (["--tolerance", "1 um"], "--tolerance is for part programs"),
        (["--parameter", "x.position_gian"], "controller.axes.x.controller.position_gain"),
        (["--parameter", "x.plant.gain"], "a parameter of the controller"),
        (["--parameter", "x.integral_gain=9 1/s..2 1/s"], "bounds 9 to 2 1/s: must be in order, the lower one first"),
        (["--parameter", "x.integral_gain=2 1/s..2 1/s"], "bounds 2 to 2 1/s: must be two that differ"),
        (["--parameter", "x.integral_gain=nan 1/s..2 1/s"], "not a finite number"),
        (["--parameter", "x.integral_gain=1 1/s..2 1/s", "--parameter", "integral_gain=3 1/s..4 1/s"], "given bounds once"),
        (["--budget", "0"], "32 to "),
        (["--width", "nan"], "> 1"),
        (["--objective", "integral=nan"], "a weight > 0"),
        (["--limited", "2"], "--limited = 2: must be 0 to 1"),
        (["--command", "0"], "--command = 0: must be > 0"),
    ],
)
def test_wrong_options_are_refused(words: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["tune", str(written(tmp_path)), *words]) == 2
    message = capsys.readouterr().err
    assert said in message
    assert "Traceback" not in message


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--write", "folder.toml"], "name a file with --write"),
        (["--write", "file/tuned.toml"], "choose another folder with --write"),
        (["--plots", "svg", "--out", "file"], "choose another folder with --out"),
    ],
)
def test_an_unwritable_target_is_refused_before_anything_runs(
    words: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("contourlab.features.tune.command.calibrated", lambda *_, **__: pytest.fail("it ran"))
    (tmp_path / "folder.toml").mkdir()
    (tmp_path / "file").write_text("of the user")
    assert main(["tune", str(written(tmp_path)), *words]) == 2
    assert said in capsys.readouterr().err


@pytest.mark.slow
def test_pictures_leave_other_results_alone(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "results").mkdir()
    (tmp_path / "results" / "report.html").write_text("older")
    words = ["--parameter", "x.integral_gain", "--budget", "100", "--plots", "svg", "--out", str(tmp_path / "results")]
    assert main(["tune", str(written(tmp_path)), *words]) == 0
    assert str(tmp_path / "results" / "plots" / "tune-course.svg") in capsys.readouterr().out
    assert (tmp_path / "results" / "report.html").read_text() == "older"


@pytest.mark.slow
def test_a_start_beyond_its_bounds_is_moved_inside_and_reported(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["--parameter", "x.integral_gain=8 1/s..12 1/s", "--budget", "100", "--json"]
    assert main(["tune", str(written(tmp_path)), *words]) == 0
    found = json.loads(capsys.readouterr().out)
    assert 8.0 <= found["result"]["values"]["controller.axes.x.controller.integral_gain"] <= 12.0
    (outside,) = [one for one in found["findings"] if one["code"] == "CL601"]
    assert outside["place"] == "x.integral_gain" and outside["values"] == {"value": 5.0, "start": 8.0}


@pytest.mark.parametrize("name", ["circle.toml", "control.toml", "stage.toml"])
def test_the_scenario_and_its_files_are_not_written_over(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = written(tmp_path)
    before = contents(tmp_path)
    assert main(["tune", str(file), "--write", str(tmp_path / name)]) == 2
    assert contents(tmp_path) == before
    said = capsys.readouterr().err
    assert str(tmp_path / name) in said and "--write" in said and said.count("\n") == 1


def test_placing_is_refused_for_kinds_without_placement(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["tune", str(written(tmp_path, "pid")), "--start", "placed"]) == 2
    said = capsys.readouterr().err
    assert "pid" in said and "axis x" in said and said.count("\n") == 1


def test_a_relay_experiment(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, out = written(tmp_path), tmp_path / "tuned.toml"
    assert main(["tune", str(file), "--method", "relay", "--write", str(out), "--phase-margin", "20", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["result"]
    assert found["method"] in found["rules"] and set(found["relay"]) == {"x", "y"} and out.exists()
    assert main(["tune", str(file), "--method", "relay", "--phase-margin", "20"]) == 0
    assert "Relay experiment" in capsys.readouterr().out
