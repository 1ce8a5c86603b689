"""``contourlab commission linuxcnc`` as typed."""

import json
from pathlib import Path
from typing import Any

import made_commission as bench
import numpy as np
import pytest
from reference_data import reference_file
from relay_rig import relay_run, ultimate

from contourlab.analysis.identification.descent import DescentSettings
from contourlab.cli.main import main
from contourlab.features.commission.identification import IdentifiedAxis
from contourlab.features.commission.loop import AxisModel, Law
from contourlab.features.commission.records import read_log
from contourlab.features.commission.setup import read_setup
from contourlab.findings import Finding, finding
from contourlab.logs.window import parse_window


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> bench.Made:
    return bench.made(tmp_path_factory.mktemp("machine"))


def test_first_call_says_what_to_type_next(made: bench.Made, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["commission", "linuxcnc", str(made.ini), str(made.hal), "--out", str(tmp_path)]) == 0
    assert "--log log1.txt" in capsys.readouterr().out
    assert main(["check", str(tmp_path / "excite.ngc")]) == 0


def test_errors_set_the_exit_code_and_leave_no_gains(made: bench.Made, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    rows = made.rows | {f"{axis} [mm]": -made.rows[f"{axis} [mm]"] for axis in "xy"}
    log = made.log(tmp_path / "log.csv", rows)
    assert main(["commission", "linuxcnc", str(made.ini), str(made.hal), "--log", str(log), "--out", str(tmp_path / "out"), "--json"]) == 1
    result = json.loads(capsys.readouterr().out)
    assert result["pid"] == {}
    assert [one["place"] for one in result["findings"] if one["code"] == "CL876"] == ["axis x", "axis y"]


def test_a_part_of_a_log(made: bench.Made, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log, setup = made.log(tmp_path / "log1.csv"), read_setup(made.ini, made.hal)
    (whole, _), (part, _) = (read_log(log, setup, window) for window in (None, parse_window("100..2099")))
    assert whole.keys() == part.keys() and whole
    for axis, one in part.items():
        for name in ("command", "measured", "output"):
            assert getattr(one, name).tolist() == getattr(whole[axis], name)[100:2100].tolist()
    words = ["commission", "linuxcnc", str(made.ini), str(made.hal), "--log", str(log), "--window", "soon"]
    assert main([*words, "--out", str(tmp_path / "out")]) == 2
    assert "--window" in capsys.readouterr().err


def test_inputs_are_not_replaced(made: bench.Made, tmp_path: Path) -> None:
    hal = tmp_path / "sampler.hal"
    hal.write_text(made.hal.read_text())
    assert main(["commission", "linuxcnc", str(made.ini), str(hal), "--out", str(tmp_path)]) == 2
    assert hal.read_text() == made.hal.read_text()


@pytest.mark.parametrize("missing", ["machine.ini", "machine.hal"])
def test_missing_files_are_named(made: bench.Made, tmp_path: Path, capsys: pytest.CaptureFixture[str], missing: str) -> None:
    files = {"machine.ini": made.ini, "machine.hal": made.hal} | {missing: tmp_path / missing}
    assert main(["commission", "linuxcnc", *map(str, files.values()), "--out", str(tmp_path)]) == 2
    assert missing in capsys.readouterr().err


# --- what the loop is closed on -------------------------------------------------------------------------------------------------------

FIELD = ("m.ini", "a.hal", "xy")
STEPPERS = {"trial3": ("router.ini", "router.hal", "xyz"), "field/stepgen": FIELD, "field/p-zero": FIELD}


def called(capsys: pytest.CaptureFixture[str], *words: object) -> tuple[int, dict[str, Any]]:
    """Return exit code and JSON of the command."""
    code = main(["commission", "linuxcnc", *map(str, words), "--json"])
    said = capsys.readouterr()
    assert said.out, said.err
    return code, json.loads(said.out)


def codes(result: dict[str, Any], axis: str) -> set[str]:
    return {one["code"] for one in result["findings"] if one["place"] == f"axis {axis}"}


def step_log(file: Path, axes: str) -> Path:
    """Write a log, as halsampler does, of pids with P 1000 and FF1 1 that drive step generators and are fed by their counters."""
    time = 1e-3 * np.arange(4000)
    columns = [np.arange(4000.0)]
    for k, _ in enumerate(axes):
        command = 20.0 * np.sin(2.0 * np.pi * (0.4 + 0.1 * k) * time) ** 3
        place, before, rows = 0.0, 0.0, []
        for wanted in command.tolist():
            counted = round(640.0 * place) / 640.0
            out = 1000.0 * (before - counted) + 1000.0 * (wanted - before)
            rows.append((wanted, counted, out))
            place, before = place + 1e-3 * out, wanted
        columns += list(np.array(rows).T)
    np.savetxt(file, np.column_stack(columns), fmt=["%d"] + ["%.6f"] * (len(columns) - 1), newline=" \n")
    return file


@pytest.mark.parametrize("folder", STEPPERS)
@pytest.mark.parametrize("logged", [False, True])
def test_loops_around_step_generators_get_no_gains(folder: str, logged: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    ini, hal, axes = STEPPERS[folder]
    out = tmp_path / "out"
    words: list[object] = [reference_file("repro", folder, ini), reference_file("repro", folder, hal), "--out", out]
    if logged:
        out.mkdir()
        (out / "gains.diff").write_text("of an earlier answer")
        words += ["--log", step_log(tmp_path / "log1.txt", axes)]
    code, result = called(capsys, *words)
    assert code == 1
    assert {name: axis["loop"] for name, axis in result["axes"].items()} == dict.fromkeys(axes, "step generator")
    assert all(axis.keys() == {"loop", "why"} and axis["why"] for axis in result["axes"].values())
    for axis in axes:
        assert "CL864" in codes(result, axis)
        assert ("CL865" in codes(result, axis)) == (folder == "field/p-zero")
    assert result["pid"] == result["predicted"] == {}
    assert sorted(file.name for file in out.glob("*")) == (["report.html"] if logged else [])


def test_an_empty_hal_file_refuses_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = reference_file("repro/field/empty-hal/a.hal").parent
    code, result = called(capsys, folder / "m.ini", folder / "a.hal", "--out", tmp_path)
    assert (code, {axis["loop"] for axis in result["axes"].values()}) == (1, {"step generator"})


def wired(made: bench.Made, folder: Path, **sinks: str) -> tuple[Path, Path]:
    """Return copies of the files in which the output of an axis goes to a sink, which counts at ``SINK-fb``."""
    hal, ini = made.hal.read_text(), folder / "rig.ini"
    ini.write_text(made.ini.read_text())
    for axis, sink in sinks.items():
        counter = f"{sink.rpartition('.')[0]}.position-fb"
        hal = hal.replace(f"=> axis.{axis}.u", f"=> {sink}").replace(f"net {axis}-fb axis.{axis}.motor", f"net {axis}-fb {counter}")
    (folder / "rig.hal").write_text(hal)
    return ini, folder / "rig.hal"


@pytest.mark.parametrize(
    ("sink", "loop", "code"),
    [
        ("axis.x.u", "unknown", 0),
        ("hm2_5i20.0.pwmgen.00.value", "unknown", 0),
        ("lcec.0.x.target-torque", "servo", 0),
        ("cia402.0.velocity-cmd", "velocity drive", 0),
        ("stepgen.0.velocity-cmd", "step generator", 1),
    ],
)
def test_what_is_left_to_commission_is_excited(
    made: bench.Made, tmp_path: Path, capsys: pytest.CaptureFixture[str], sink: str, loop: str, code: int
) -> None:
    files = wired(made, tmp_path, x=sink)
    found, result = called(capsys, *files, "--out", tmp_path / "out")
    assert found == code
    assert {name: axis["loop"] for name, axis in result["axes"].items()} == {"x": loop, "y": "unknown"}
    program = (tmp_path / "out" / "excite.ngc").read_text()
    assert [f"G53 G1 {axis}" in program for axis in "XY"] == [code == 0, True]
    assert (tmp_path / "out" / "sampler.hal").exists() and (tmp_path / "out" / "steps.md").exists()


def test_a_pid_without_gains_is_refused_at_once(made: bench.Made, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    ini, hal = wired(made, tmp_path)
    head, joint = ini.read_text().split("[JOINT_0]\n")
    ini.write_text(f"{head}[JOINT_0]\n" + joint.replace("P = 0.8", "P = 0", 1).replace("FF1 = 0.015", "FF1 = 0", 1))
    code, result = called(capsys, ini, hal, "--out", tmp_path / "out")
    assert (code, codes(result, "x"), codes(result, "y")) == (1, {"CL865"}, set())
    assert not (tmp_path / "out").exists()


def velocity_rows(made: bench.Made, axis: str, lag: float) -> dict[str, np.ndarray]:
    """Return the rows of an axis whose velocity follows the output with a lag, under P 20 and FF1 1 in machine units."""
    command = made.rows[f"{axis}_cmd [mm]"]
    place, out = np.zeros(command.size), np.zeros(command.size)
    x = v = 0.0
    kept, before = np.exp(-1e-3 / lag), float(command[0])
    for k, wanted in enumerate(command.tolist()):
        place[k] = 2e-4 * round(x / 2e-4)
        out[k] = 20.0 * (before - place[k]) + (wanted - before) / 1e-3
        x += 1e-3 * out[k] + (v - out[k]) * lag * (1.0 - kept)
        v, before = out[k] + (v - out[k]) * kept, wanted
    return {f"{axis}_cmd [mm]": command, f"{axis} [mm]": place, f"{axis}_out": out}


def velocity_made(made: bench.Made, folder: Path, lag: float) -> tuple[Path, Path, Path]:
    """Return the files of a machine with two velocity drives whose pins do not say so, and their log."""
    ini, hal = wired(made, folder)
    ini.write_text(ini.read_text().replace("P = 0.8", "P = 20").replace("I = 0.5", "I = 0").replace("FF1 = 0.015", "FF1 = 1"))
    rows = {"time [s]": made.rows["time [s]"]} | velocity_rows(made, "x", lag) | velocity_rows(made, "y", lag)
    return ini, hal, made.log(folder / "log1.csv", rows)


@pytest.mark.slow
@pytest.mark.parametrize("lag", [2e-3, 9e-3])
def test_a_velocity_drive_is_named_and_answered_after_its_log(
    made: bench.Made, tmp_path: Path, capsys: pytest.CaptureFixture[str], lag: float
) -> None:
    ini, hal, log = velocity_made(made, tmp_path, lag)
    code, result = called(capsys, ini, hal, "--log", log, "--out", tmp_path / "out")
    assert {name: axis["loop"] for name, axis in result["axes"].items()} == {"x": "velocity drive", "y": "velocity drive"}
    assert code == 0 and codes(result, "x") == codes(result, "y") == {"CL598", "CL868", "CL890", "CL893"}
    for axis in "xy":
        model = result["models"][axis]["model"]
        assert 1.0 / model["damping"] == pytest.approx(lag, rel=0.01)
        assert model["damping"] / model["gain"] == pytest.approx(1000.0, rel=1e-3)
        assert result["predicted"][axis]["after"] < 0.3 * result["predicted"][axis]["before"]


@pytest.mark.parametrize(("lag", "said", "refused"), [(2e-3, "torque", "xy"), (0.0, "velocity", "x"), (20e-3, "torque", "xy")])
def test_a_log_of_another_drive_than_said_gives_no_gains(
    made: bench.Made,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    lag: float,
    said: str,
    refused: str,
) -> None:
    """A slow loop is what no torque explains; without a lag the axes take a torque."""
    drive = IdentifiedAxis(AxisModel(1.0, 50.0), {}, 99.0, Law(1e-3), np.zeros(0), 0.0, 0.0, 0.0, 0.0, 0.0)

    def identify(*_: object, velocity: bool) -> IdentifiedAxis | Finding:
        return drive if velocity and lag else finding("CL886", "axis y", parameters=())

    monkeypatch.setattr("contourlab.features.commission.command.identify_axis", identify)
    ini, hal, log = velocity_made(made, tmp_path, lag) if lag else (*wired(made, tmp_path), made.log(tmp_path / "log1.csv"))
    code, result = called(capsys, ini, hal, "--log", log, "--out", tmp_path / "out", "--drive", said)
    assert (code, result["pid"]) == (1, {})
    assert [axis for axis in "xy" if "CL869" in codes(result, axis)] == list(refused)
    assert main(["commission", "linuxcnc", str(ini), str(hal), "--log", str(log), "--out", str(tmp_path / "out"), "--drive", said]) == 1
    assert "next:" not in capsys.readouterr().out


@pytest.mark.slow
def test_no_diff_while_an_axis_has_no_answer(
    made: bench.Made, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """X closes its loop on its own steps, y moves a machine: y is answered, but no diff sets the gains of one of two axes."""
    settings = ((1, 1.0, DescentSettings(most_iterations=2)),)  # hardly search for a shaft, and for gains not at all
    monkeypatch.setattr("contourlab.features.commission.identification.SEARCHES", settings)
    monkeypatch.setattr("contourlab.features.commission.tuning.BUDGET", 32)
    files = wired(made, tmp_path, x="stepgen.0.velocity-cmd")
    out = tmp_path / "out"
    code, result = called(capsys, *files, "--log", made.log(tmp_path / "log1.csv"), "--out", out)
    assert (code, list(result["pid"])) == (1, ["y"])
    assert {name: axis["loop"] for name, axis in result["axes"].items()} == {"x": "step generator", "y": "servo"}
    assert {"CL864"} == codes(result, "x") and "CL890" in codes(result, "y")
    assert [one["code"] for one in result["findings"] if one["code"] == "CL867"] == ["CL867"]
    assert not {"gains.diff", "safe.diff"} & {file.name for file in out.iterdir()}


def relay_log(file: Path, level: float = 5.0) -> Path:
    """Write the log of a relay experiment."""
    command, position = relay_run(2000, 1e-3, 1.8, 50.0, 3e-3, level, hysteresis=2e-6, count=1e-6, friction=0.1)
    rows = zip(1e-3 * np.arange(2000), command, 1e3 * position, strict=True)
    lines = (f"{time:.3f},{u:g},{p:.3f}" for time, u, p in rows)
    file.write_text("\n".join(["time [s],command.x [V],position.x [mm]", *lines]))
    return file


def test_the_log_of_a_relay_experiment(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["commission", "relay", str(relay_log(tmp_path / "relay.csv")), "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    test, truth = answer["axes"]["x"], ultimate(1.8, 50.0, 3e-3, 1e-3)
    for key, true in zip(("gain", "period"), truth, strict=True):
        assert test[key]["low"] <= true <= test[key]["high"]
    assert answer["units"] == {"x": "V"} and answer["gains"]["x"]["Ziegler-Nichols P"]["proportional"] == 0.5 * test["gain"]["value"]
    assert main(["commission", "relay", str(tmp_path / "relay.csv")]) == 0
    assert "Tyreus-Luyben PID" in capsys.readouterr().out


@pytest.mark.parametrize("options", [["--axis", "q"], ["--window", "0..299"]])
def test_no_relay_experiment(options: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["commission", "relay", str(relay_log(tmp_path / "relay.csv")), *options]) == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_a_run_of_the_control_is_no_relay_experiment(made: bench.Made, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["commission", "relay", str(made.log(tmp_path / "log.csv")), "--axis", "x"]
    assert main([*words, "--column", "command.x=x_out [V]", "--column", "position.x=x [mm]"]) == 2
    assert "no steady oscillation" in capsys.readouterr().err
