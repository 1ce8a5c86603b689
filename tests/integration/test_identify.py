"""``contourlab identify`` as typed: from a log to an axis file for a machine."""

from __future__ import annotations

import math
from importlib.resources import files
from pathlib import Path
from shutil import copytree

import numpy as np
import pytest
from identified_logs import codes
from reference_data import reference_file
from typed_commands import AsJson, Refused

from contourlab.cli.main import main
from contourlab.scenario.load import load_axis

MASS, VISCOUS, COULOMB, OFFSET = 40.0, 150.0, 12.0, -3.0


def written(folder: Path, seed: int = 0, sign: float = 1.0, seconds: float = 8.0) -> Path:
    """Write the log of an axis of known mass and friction that goes to and fro, with an encoder of 0.1 um and 0.5 N of noise."""
    time = np.arange(0.0, seconds, 1e-3)
    place = 0.02 * np.sin(2.0 * np.pi * 0.7 * time) + 0.006 * np.sin(2.0 * np.pi * 2.9 * time + 1.0)
    speed = 0.02 * 2.0 * np.pi * 0.7 * np.cos(2.0 * np.pi * 0.7 * time) + 0.006 * 2.0 * np.pi * 2.9 * np.cos(2.0 * np.pi * 2.9 * time + 1.0)
    gain = np.gradient(speed, time)
    force = MASS * gain + VISCOUS * speed + COULOMB * np.sign(speed) + OFFSET + 0.5 * np.random.default_rng(seed).standard_normal(time.size)
    file = folder / f"log-{seed}.csv"
    rows = np.column_stack([time, np.round(place / 1e-7) * 1e-4, sign * force])
    file.write_text("time [s],x pos [mm],push [N]\n" + "\n".join(f"{t:.3f},{p:.4f},{f:.6f}" for t, p, f in rows))
    return file


def test_known_figures_are_found_and_make_an_axis(tmp_path: Path, as_json: AsJson) -> None:
    words = ["identify", str(written(tmp_path)), "--column", "force.x=push", "--validation", str(written(tmp_path, 1))]
    out = tmp_path / "axis.toml"
    found = as_json(*words, "--write", out)
    for name, true in (("M", MASS), ("Fv", VISCOUS), ("Fc", COULOMB), ("offset", OFFSET)):
        figure = found["parameters"][name]
        assert figure["value"] == pytest.approx(true, abs=4.0 * figure["robust_deviation"] + 0.01 * abs(true))
    assert found["details"]["validation"]["fit_percent"] == pytest.approx(found["fit_percent"], abs=1.0) and found["fit_percent"] > 95.0
    axis = load_axis(out)
    assert axis.plant.values()["mass"] == pytest.approx(found["parameters"]["M"]["value"], rel=1e-5)
    assert axis.friction.values()["coulomb"] == pytest.approx(found["parameters"]["Fc"]["value"], rel=1e-5)
    assert axis.disturbance is not None
    assert axis.disturbance.values()["force"] == pytest.approx(-found["parameters"]["offset"]["value"], rel=1e-5)
    assert axis.sensor.values()["resolution"] == pytest.approx(1e-7)
    for part, name, figure in ((axis.plant, "mass", "M"), (axis.friction, "coulomb", "Fc"), (axis.disturbance, "force", "offset")):
        origin, estimate = part.origins[name], found["parameters"][figure]
        assert (origin.source, origin.reference) == ("fitted", "log-0.csv")
        assert origin.deviation == pytest.approx(max(estimate["deviation"], estimate["robust_deviation"]), rel=5e-3)
    assert axis.limits.origins["velocity"].note.startswith("20 %")
    assert {frozenset(pair[:2]) for pair in axis.correlations} >= {frozenset(("plant.damping", "friction.coulomb"))}


@pytest.mark.parametrize(("every", "cutoff"), [(1, None), (4, 100.0), (10, 40.0), (20, 20.0)])
def test_the_usual_filter_stays_within_the_record(tmp_path: Path, as_json: AsJson, every: int, cutoff: float | None) -> None:
    """A log at 100 Hz holds nothing beyond 50 Hz. One without the option is the log with the option that it stands for.

    At 50 Hz, differences over two samples show 2.2 % too little of a velocity at 2.9 Hz, so the mass comes out 4.4 % too large.
    """
    log = written(tmp_path, seconds=20.0)
    head, *rows = log.read_text().splitlines()
    log.write_text("\n".join([head, *rows[::every], ""]))
    words = ("identify", log, "--column", "force.x=push")
    found = as_json(*words)
    (lowered,) = [one["values"] for one in found["findings"] if one["code"] == "CL590"] or [None]
    assert (lowered is not None) == (cutoff is not None and cutoff < 100.0)
    if lowered is not None:
        assert (lowered["cutoff"], lowered["nyquist"]) == (cutoff, 500.0 / every)
        same = as_json(*words, "--cutoff", f"{cutoff} Hz")
        assert same["parameters"] == found["parameters"]
    mass = MASS * (1.0 if every < 20 else (0.364 / math.sin(0.364)) ** 2)
    for name, true in (("M", mass), ("Fv", VISCOUS), ("Fc", COULOMB), ("offset", OFFSET)):
        figure = found["parameters"][name]
        assert figure["value"] == pytest.approx(true, abs=4.0 * figure["robust_deviation"] + 0.02 * abs(true))


def test_the_table_shows_what_weakens_the_figures(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["identify", str(written(tmp_path)), "--column", "command.x=push [A]", "--gain", "2 N/A", "--model", "rigid-by-direction"]
    assert main(words) == 0
    said = capsys.readouterr().out
    assert "Fc+" in said and "condition number" in said and "M " in said


@pytest.mark.parametrize(
    ("column", "size", "written_as"), [("torque", 1.0, "N*m"), ("torque", 1e-3, "mN*m"), ("command", 1.0, "N*m"), ("command", 0.1, "N*dm")]
)
def test_a_torque_is_a_force_by_the_lead_for_every_model(
    tmp_path: Path, as_json: AsJson, refused: Refused, column: str, size: float, written_as: str
) -> None:
    arm, out = 0.01 / math.tau, tmp_path / "axis.toml"
    words = ["identify", str(written(tmp_path, seconds=4.0)), "--column", f"{column}.x=push [{written_as}]"]
    found = as_json(*words, "--lead", "10 mm", "--write", out)["parameters"]
    assert found["M"]["value"] == pytest.approx(MASS * size / arm, rel=0.01) and found["M"]["unit"] == "kg"
    assert load_axis(out).plant.values()["force_constant"] == pytest.approx(1.0 / arm)
    given = as_json(*words, "--gain", f"{1.0 / arm:.12g} N/(N*m)")["parameters"]
    assert given["M"]["value"] == pytest.approx(found["M"]["value"], rel=1e-8)
    said = refused(*words, "--lead", "10 mm", "--gain", "628 N/(N*m)")
    assert "--lead" in said and "--gain" in said
    assert "--full-scale" in refused(*words, "--model", "friction", "--lead", "10 mm", "--full-scale", "3 N*m")
    assert "--lead" in refused(*words)


def test_a_command_in_millivolts_is_in_volts(tmp_path: Path, as_json: AsJson, refused: Refused) -> None:
    words = ["identify", str(written(tmp_path, seconds=4.0)), "--column", "command.x=push [mV]", "--gain", "2 N/mV"]
    assert as_json(*words)["parameters"]["M"]["value"] == pytest.approx(2.0 * MASS, rel=0.01)
    said = refused(*words[:4], "--gain", "2 N/A")
    assert "--gain" in said and "N/V" in said


def test_the_measured_axis(tmp_path: Path, as_json: AsJson) -> None:
    log = reference_file("data/emps/DATA_EMPS.mat")
    words = [
        "--column",
        "position.x=qm [m]",
        "--column",
        "command.x=vir [V]",
        "--gain",
        "35.15065188 N/V",
        "--write",
        str(tmp_path / "axis.toml"),
    ]
    found = as_json("identify", log, *words)["parameters"]
    assert [found[name]["value"] for name in ("M", "Fv", "Fc", "offset")] == pytest.approx([95.11, 203.5, 20.39, -3.165], rel=2e-3)
    assert load_axis(tmp_path / "axis.toml").plant.values()["mass"] == pytest.approx(95.1, rel=1e-3)


@pytest.mark.parametrize("model", ["rigid", "rigid-by-direction", "first-order"])
@pytest.mark.parametrize("asked", [[], ["--column", "reference.x=qg [m]"]])
@pytest.mark.slow
def test_the_measured_axis_can_repeat_its_motion(tmp_path: Path, capsys: pytest.CaptureFixture[str], model: str, asked: list[str]) -> None:
    """The built-in scenario of the same motion with the written file: planned as fast as the log and faster, it never saturates."""
    from contourlab.loop import simulate
    from contourlab.scenario import load_scenario

    folder = tmp_path / "emps"
    copytree(Path(str(files("contourlab.machines") / "emps")), folder)
    log = reference_file("data/emps/DATA_EMPS.mat")
    words = ["--column", "position.x=qm [m]", "--column", "command.x=vir [V]", *asked, "--gain", "35.15065188 N/V", "--model", model]
    assert main(["identify", str(log), *words, "--write", str(folder / "axis.toml")]) == 0
    scenario = load_scenario(folder / "there-and-back.toml")
    axis = scenario.machine.axes[0]
    # The reference of the log has 0.842 m/s^2, its motion 0.1278 m/s.
    assert 1.15 * 0.842 < axis.limits.acceleration < 1.3 * 0.842 and axis.limits.velocity == pytest.approx(1.2 * 0.1278, rel=1e-3)
    note = axis.limits.origins["acceleration"].note
    assert note.startswith("20 %") and ("reference" in note) == bool(asked) and ("50 ms" in note) != bool(asked)
    result = simulate(scenario.machine, scenario.controller, scenario.base.reference())
    assert float(np.abs(result["command"]).max()) < axis.drive.values()["limit"]
    assert float(np.abs(np.diff(result["reference"], 2, axis=0)).max()) / 1e-6 > 0.842


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--column", "force.x=push", "--model", "bent"], "--model"),
        (["--column", "force.x=push", "--cutoff", "2 m"], "--cutoff"),
        (["--column", "force.x=push", "--cutoff", "700 Hz"], "Nyquist"),
        (["--column", "force.x=push", "--decimation", "0"], "decimation"),
        (["--column", "force.x=push", "--axis", "q"], "no axis q"),
        (["--column", "force.x=push", "--lead", "10 mm"], "must be omitted, or used with a command in N*m, for model rigid: the command"),
        (["--model", "friction", "--side", "load"], "--side = load: must be omitted: it applies to two-mass, two-inertia"),
        (
            ["--model", "first-order", "--validation", "more.csv"],
            "it applies to rigid, rigid-by-direction, position-loop, and the model is",
        ),
        (["--column", "command.x=push [V]"], "give --gain"),
        (["--column", "command.x=push [V]", "--gain", "three"], "--gain"),
        (["--column", "command.x=push [V]", "--gain", "0 N/V"], "--gain"),
        ([], "no force, torque or command"),
    ],
)
def test_faults_are_refused_with_a_message(tmp_path: Path, refused: Refused, words: list[str], said: str) -> None:
    assert said in refused("identify", written(tmp_path, seconds=2.0), *words, "--write", tmp_path / "axis.toml")
    assert not (tmp_path / "axis.toml").exists()


def test_a_force_with_the_wrong_sign_is_no_axis(tmp_path: Path, refused: Refused) -> None:
    log = written(tmp_path, sign=-1.0)
    assert "log-0.csv: M = -" in refused("identify", log, "--column", "force.x=push", "--write", tmp_path / "axis.toml")
    assert main(["identify", str(log), "--column", "force.x=-push", "--write", str(tmp_path / "axis.toml")]) == 0


def test_samples_at_rest_are_left_out(tmp_path: Path, as_json: AsJson, refused: Refused) -> None:
    """The axis waits between moves under a force below its friction, where the sign of v means nothing."""
    time = np.arange(0.0, 8.0, 1e-3)
    waits = (time % 2.0) > 1.2
    there = np.where(time % 2.0 < 0.6, 0.1, -0.1)
    speed = np.where(waits, 0.0, there * np.sin(np.pi * (time % 2.0) / 0.6) ** 2)
    place, gain = np.cumsum(speed) * 1e-3, np.gradient(speed, time)
    force = np.where(waits, 0.5 * COULOMB, MASS * gain + VISCOUS * speed + COULOMB * np.sign(speed) + OFFSET)
    rows = np.column_stack([time, 1e3 * place, force])
    file = tmp_path / "waits.csv"
    file.write_text("time [s],x pos [mm],push [N]\n" + "\n".join(f"{t:.3f},{p:.7f},{f:.6f}" for t, p, f in rows))
    words = ["identify", str(file), "--column", "force.x=push"]
    found = [as_json(*words, *more, code=(0, 1)) for more in ([], ["--slowest", "5 mm/s"])]
    assert "CL536" in codes(found[0])
    assert "CL536" not in codes(found[1])
    off = [abs(one["parameters"]["Fc"]["value"] - COULOMB) for one in found]
    assert off[1] < off[0] and off[1] < 0.02 * COULOMB
    assert found[1]["fit_percent"] > found[0]["fit_percent"]
    assert "--slowest" in refused(*words, "--slowest", "fast")


def test_validation_with_the_same_samples_is_reported(tmp_path: Path, as_json: AsJson) -> None:
    log = written(tmp_path)
    again = tmp_path / "again.csv"
    again.write_bytes(log.read_bytes())
    for second, same in ((log, True), (again, True), (written(tmp_path, 1), False)):
        assert ("CL516" in codes(as_json("identify", log, "--column", "force.x=push", "--validation", second))) == same


@pytest.mark.slow
def test_the_reference_in_place_of_the_position_makes_no_axis(tmp_path: Path, as_json: AsJson) -> None:
    log, out = reference_file("data/emps/DATA_EMPS.mat"), tmp_path / "axis.toml"
    words = ["identify", str(log), "--column", "position.x=qg [m]", "--column", "command.x=vir [V]", "--gain", "35 N/V"]
    found = as_json(*words, "--write", out, code=1)
    assert not out.exists()
    assert 60.0 < found["fit_percent"] < 75.0
    assert "CL533" in codes(found)
    assert "CL404" in codes(as_json(*words, "--column", "reference.x=qg [m]", code=1))


def test_a_fit_below_ninety_percent_is_reported(tmp_path: Path, as_json: AsJson) -> None:
    """A force ripple that is not friction: a fit of 80 to 90 % is reported, and usable."""
    lines = written(tmp_path).read_text().splitlines()
    rows = np.array([[float(cell) for cell in line.split(",")] for line in lines[1:]])
    size = float(rows[:, 2].std())
    rows[:, 2] += 0.24 * size * np.sin(2.0 * np.pi * rows[:, 1] / 3.0)
    log = tmp_path / "ripple.csv"
    np.savetxt(log, rows, delimiter=",", header=lines[0], comments="", fmt="%.6f")
    found = as_json("identify", log, "--column", "force.x=push")
    assert 80.0 < found["fit_percent"] < 90.0 and "CL533" in codes(found)


@pytest.mark.parametrize("option", ["--write", "--out"])
def test_an_unwritable_target_is_refused_before_a_log_is_read(tmp_path: Path, refused: Refused, option: str) -> None:
    (tmp_path / "taken").mkdir()
    (tmp_path / "file").write_text("")
    bad = {"--write": [str(tmp_path / "taken"), str(tmp_path / "file" / "axis.toml")], "--out": [str(tmp_path / "file")]}
    for place in bad[option]:
        error = refused("identify", tmp_path / "no-log.csv", "--plots", "png", option, place)
        assert option in error and "no-log" not in error
    assert sorted(file.name for file in tmp_path.iterdir()) == ["file", "taken"]


@pytest.mark.parametrize(("sign", "code"), [(1.0, 0), (-1.0, 2)])
def test_folders_above_the_file_are_made_where_it_is_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], sign: float, code: int
) -> None:
    """As for every command; if nothing is written, no folder is left behind."""
    log, out = str(written(tmp_path, sign=sign)), tmp_path / "new" / "below" / "axis.toml"
    assert main(["identify", log, "--column", "force.x=push", "--write", str(out)]) == code
    capsys.readouterr()
    assert out.is_file() == (tmp_path / "new").exists() == (code == 0)


def test_settings_have_the_names_of_the_options(tmp_path: Path, refused: Refused) -> None:
    log = str(written(tmp_path, seconds=2.0))
    assert "--slowest = 10 m/s" in refused("identify", log, "--column", "force.x=push", "--slowest", "10 m/s")
    assert "--cutoff = 9000 Hz" in refused("identify", log, "--column", "force.x=push", "--cutoff", "9 kHz")
    assert "--decimation = 0" in refused("identify", log, "--column", "force.x=push", "--decimation=0")
    assert "below 1e12" in refused("identify", log, "--column", "command.x=push [V]", "--gain", "1e13 N/V")
