"""``contourlab refine`` as typed: from a scenario and a log to a machine that can be run."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typed_commands import AsJson, Refused, contents

from contourlab.app.results import staged
from contourlab.cli.main import main
from contourlab.scenario import load_machine, load_scenario

MACHINE = """
[machine]
name = "table"
servo_period = "1 ms"
axes = ["x", "y"]

[axes."*"]
sensor = {kind = "encoder", resolution = "0.1 um"}
friction = {kind = "coulomb", coulomb = "COULOMB N"}
plant = {kind = "mass-damper", mass = "50 kg", damping = "DAMPING N*s/m", force_constant = "100 N/A"}

[axes."*".limits]
velocity = "100 mm/s"
acceleration = "1 m/s^2"
jerk = "20 m/s^3"
"""
SCENARIO = """
machine = "NAME.toml"
[contour]
name = "circle"
radius = "10 mm"
[feed]
feedrate = "40 mm/s"
[controller.axes."*".controller]
kind = "lead-lag"
gains = {phase_margin = "60 deg", crossover = "60 rad/s"}
"""
NAMES = ["axes.*.plant.damping", "axes.*.friction.coulomb=5 N..80 N"]


def written(folder: Path, name: str, damping: float, coulomb: float) -> Path:
    """Write a scenario; its gains are those of one model, whatever its friction."""
    (folder / f"{name}.toml").write_text(MACHINE.replace("COULOMB", str(coulomb)).replace("DAMPING", str(damping)))
    file = folder / f"{name}-circle.toml"
    file.write_text(SCENARIO.replace("NAME", name).replace('crossover = "60 rad/s"}', 'crossover = "60 rad/s"}'))
    return file


@pytest.fixture(scope="module")
def scene(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a scenario of guessed values, and the log of the true one: damping 300 and Coulomb friction 40 N."""
    from contourlab.loop import simulate

    folder = tmp_path_factory.mktemp("scene")
    guess, true = load_scenario(written(folder, "guess", 500.0, 20.0)), load_scenario(written(folder, "true", 300.0, 40.0))
    seen = simulate(true.machine, guess.controller, true.base.reference())
    rest = np.zeros((100, 2))
    asked, found = (np.vstack([rest + data[0], data, rest + data[-1]]) for data in (seen["reference"], seen["position"]))
    rows = np.column_stack([np.arange(len(asked)) * 1e-3, 1e3 * asked, 1e3 * found])
    head = "time [s],x ref [mm],y ref [mm],x pos [mm],y pos [mm]"
    (folder / "log.csv").write_text(head + "\n" + "\n".join(",".join(f"{v:.6f}" for v in row) for row in rows))
    (folder / "columns.toml").write_text(
        '[columns]\n"reference.x" = "x ref"\n"reference.y" = "y ref"\n"position.x" = "x pos"\n"position.y" = "y pos"\n'
    )
    return folder


def words(scene: Path, *more: str, names: list[str] | None = None) -> list[str]:
    chosen = [word for name in (NAMES if names is None else names) for word in ("--parameter", name)]
    return [
        "refine", str(scene / "guess-circle.toml"), "--log", str(scene / "log.csv"), "--columns", str(scene / "columns.toml"),
        *chosen, "--starts", "1", *more,
    ]  # fmt: skip


def codes(found: dict[str, Any]) -> list[tuple[str, str]]:
    """Return code and place of the findings of a refinement."""
    return [(one["code"], one["place"]) for one in found["findings"]]


def parameters(found: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """Return the refined parameters by their labels."""
    return {one["sought"]["label"]: one for one in found["result"]["parameters"]}


@pytest.mark.slow
def test_a_machine_comes_out_of_a_log(scene: Path, tmp_path: Path, as_json: AsJson) -> None:
    out = tmp_path / "machine.toml"
    more = ["--write", str(out), "--plots", "svg", "--out", str(tmp_path / "seen"), "--validation", str(scene / "log.csv")]
    found = as_json(*words(scene, *more))
    for axis in "xy":
        for name, true in (("plant.damping", 300.0), ("friction.coulomb", 40.0)):
            figure = parameters(found)[f"axes.{axis}.{name}"]
            assert figure["value"] == pytest.approx(true, abs=4.0 * figure["deviation"] + 2e-3 * true)
    assert all(row["explained"] > 0.999 for row in found["result"]["after"] + found["validation"])
    assert found["validation_before"][0]["explained"] < found["validation"][0]["explained"]
    assert ("CL564", "log") in codes(found)
    machine = load_machine(out)
    assert machine.axis("y").friction.values()["coulomb"] == pytest.approx(parameters(found)["axes.y.friction.coulomb"]["value"], rel=1e-5)
    assert 'source = "fitted", deviation = "' in out.read_text() and 'from = "log.csv"' in out.read_text()
    drawn = {file.name for file in (tmp_path / "seen" / "plots").iterdir()}
    assert drawn == {f"log-position-{axis}{part}.svg" for axis in "xy" for part in ("", "-left")}


def test_the_table_shows_unseen_samples(scene: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(words(scene, "--window", "0 s..1 s")) == 0
    said = capsys.readouterr().out
    assert "\nunseen before  " in said and "\nunseen  " in said and "deviation" in said and "explained" in said


@pytest.fixture
def odd(scene: Path, tmp_path: Path) -> str:
    """The log, but after 1.2 s that of another axis: its errors are half as large, with the opposite sign."""
    head, *lines = (scene / "log.csv").read_text().splitlines()
    rows = np.array([[float(cell) for cell in line.split(",")] for line in lines])
    rows[1200:, 3:] = 1.5 * rows[1200:, 1:3] - 0.5 * rows[1200:, 3:]
    (tmp_path / "odd.csv").write_text("\n".join([head, *(",".join(f"{v:.6f}" for v in row) for row in rows)]))
    return str(tmp_path / "odd.csv")


def test_a_fit_that_holds_only_in_its_window_is_reported(scene: Path, odd: str, as_json: AsJson) -> None:
    typed = [odd if word == str(scene / "log.csv") else word for word in words(scene)]
    found = as_json(*typed, "--window", "0 s..1.15 s", "--validation", odd)
    before, after = ({row["axis"]: row["rms"] for row in found["result"][key]} for key in ("unseen_before", "unseen"))
    assert after["y"] > 1.01 * before["y"]
    assert all((("CL559", f"odd, position of {axis}") in codes(found)) == (after[axis] > 1.01 * before[axis]) for axis in "xy")
    assert "CL560" in {code for code, _ in codes(found)}
    # A log made with the same values is followed better outside the window too.
    assert not {"CL559", "CL560"} & {code for code, _ in codes(as_json(*words(scene), "--window", "0 s..1.15 s"))}


def test_the_window_is_shaded_in_the_pictures(scene: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from contourlab.rendering import plots
    from contourlab.rendering.charts import Chart

    drawn: list[Chart] = []
    monkeypatch.setattr(plots, "write_charts", lambda charts, folder, formats: drawn.extend(charts) or ())
    more = ["--plots", "png", "--out", str(tmp_path)]
    assert main(words(scene, "--window", "0.5 s..9 s", *more, names=NAMES[:1])) == 0
    end = drawn[0].panels[0].curves[0].x[-1]
    assert [chart.panels[0].span for chart in drawn] == [(0.5, end)] * 4
    assert all(chart.panels[0].span_label for chart in drawn)
    drawn.clear()
    assert main(words(scene, *more, names=NAMES[:1])) == 0
    assert [chart.panels[0].span for chart in drawn] == [None] * 4


@pytest.mark.slow
def test_controllers_that_were_refined_get_files_of_their_own(scene: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    gain = "controller.axes.*.controller.gain"
    assert main(words(scene, "--write", str(tmp_path / "m.toml"), names=[*NAMES, gain])) == 0
    file = tmp_path / "m-log-controller.toml"
    assert f"controller: {file}" in capsys.readouterr().out and 'from = "log.csv"' in file.read_text()
    joined = tmp_path / "joined.toml"
    text = (scene / "guess-circle.toml").read_text().split("[controller.axes")[0]
    joined.write_text('controller = "m-log-controller.toml"\n' + text.replace("guess.toml", "m.toml"))
    assert load_scenario(joined).controller.axes["x"].controller.kind == "lead-lag"


@pytest.mark.parametrize(
    ("names", "more", "said"),
    [
        (["axes.x.plant.weight"], [], "a parameter of the machine"),
        (["axes.x.friction.coulomb=5..x N"], [], "bounds LOW..HIGH"),
        (["axes.x.friction.coulomb=5 mm..80 mm"], [], "bounds LOW..HIGH"),
        (["axes.x.friction.coulomb=50 N"], [], "bounds LOW..HIGH"),
        (NAMES, ["--window", "soon"], "two times"),
        (NAMES, ["--window", "2 s..1 s"], "the earlier one first"),
        (NAMES, ["--window", "0 s..1 s", "--window", "0 s..1 s"], "one for all logs"),
        (NAMES, ["--window", "50 s..60 s"], "--window = 50 s..60 s: must be times at which log moves, 0.1 s to 1.869 s on its clock"),
        (NAMES, ["--starts", "0"], "starts from 1 to 32"),
        (NAMES, ["--also", "builtin:ubc/lead-lag", "--also", "builtin:ubc/lead-lag"], "one scenario, or one for each log"),
        (NAMES, ["--plots", "gif"], "gif"),
        (NAMES, ["--validation", "nowhere.csv"], "nowhere.csv"),
    ],
)
def test_bad_options_are_refused(scene: Path, refused: Refused, names: list[str], more: list[str], said: str) -> None:
    error = refused(*words(scene, *more, names=names))
    assert said in error and "Traceback" not in error


def test_an_invalid_folder_is_refused_before_the_work(scene: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "file").write_text("")
    assert main(words(scene, "--write", str(tmp_path / "file" / "m.toml"))) == 2
    assert "Traceback" not in capsys.readouterr().err
    with staged(tmp_path):
        pass


def test_parameters_refined_together_have_correlations(scene: Path, tmp_path: Path, as_json: AsJson) -> None:
    out = tmp_path / "machine.toml"
    found = as_json(*words(scene, "--write", str(out)))
    names = found["result"]["correlation_of"]
    for axis in load_machine(out).axes:
        ((one, other, value),) = axis.correlations
        i, j = (names.index(f"axes.{axis.name}.{name}") for name in (one, other))
        assert {one, other} == {"plant.damping", "friction.coulomb"}
        assert value == pytest.approx(found["result"]["correlation"][i][j], abs=1e-4) and value < -0.3


@pytest.mark.slow
def test_parameters_of_two_axes_have_correlations(scene: Path, tmp_path: Path, as_json: AsJson, capsys: pytest.CaptureFixture[str]) -> None:
    """Under a cross-coupled controller each axis responds to the other: the machine's file has the correlations between axes."""
    coupled = tmp_path / "coupled.toml"
    text = (scene / "guess-circle.toml").read_text().replace('"guess.toml"', f'"{scene / "guess.toml"}"')
    coupled.write_text(text + '[controller.estimator]\nkind = "newton"\n[controller.coupling]\nkind = "cross-coupled"\ngain = "1 A/mm"\n')
    out = tmp_path / "machine.toml"
    typed = [str(coupled) if word == str(scene / "guess-circle.toml") else word for word in words(scene, "--write", str(out))]
    found = as_json(*typed, code=(0, 1))
    assert found["result"]["usable"]
    names = found["result"]["correlation_of"]
    machine = load_machine(out)
    correlated = {(one, other): value for one, other, value in machine.correlations}
    assert len(correlated) >= 2 and all(one.split(".")[0] != other.split(".")[0] for one, other in correlated)
    for (one, other), value in correlated.items():
        assert value == pytest.approx(found["result"]["correlation"][names.index(f"axes.{one}")][names.index(f"axes.{other}")], abs=1e-4)
    assert max(map(abs, correlated.values())) > 0.01
    # Refining again without one axis drops its correlations with the other.
    again = tmp_path / "again.toml"
    coupled.write_text(coupled.read_text().replace(str(scene / "guess.toml"), str(out)))
    typed = [word if word != str(out) else str(again) for word in typed if word != "axes.*.plant.damping"]
    typed[typed.index("axes.*.friction.coulomb=5 N..80 N")] = "axes.x.friction.coulomb=5 N..80 N"
    del typed[typed.index("--parameter")]
    assert main(typed) in (0, 1)
    capsys.readouterr()
    assert {frozenset(pair[:2]) for pair in load_machine(again).correlations} == {
        frozenset(pair) for pair in correlated if "x.friction.coulomb" not in pair
    }


def test_old_correlations_are_kept_only_if_both_parameters_are(scene: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    head = 'mass = {value = "50 kg", source = "fitted", deviation = "1 kg"}'
    pairs = '[["plant.mass", "friction.coulomb", 0.5], ["plant.mass", "plant.damping", 0.2]]'
    text = (scene / "guess.toml").read_text().replace('mass = "50 kg"', head).replace('[axes."*"]', f'[axes."*"]\ncorrelations = {pairs}')
    text = text.replace('coulomb = "20.0 N"', 'coulomb = {value = "20 N", source = "fitted", deviation = "2 N"}')
    text = text.replace('damping = "500.0 N*s/m"', 'damping = {value = "500 N*s/m", source = "fitted", deviation = "5 N*s/m"}')
    (tmp_path / "guess.toml").write_text(text)
    (tmp_path / "guess-circle.toml").write_text((scene / "guess-circle.toml").read_text())
    out = tmp_path / "machine.toml"
    typed = [
        str(tmp_path / "guess-circle.toml") if word == str(scene / "guess-circle.toml") else word for word in words(scene, names=NAMES[1:])
    ]
    assert main([*typed, "--write", str(out)]) == 0
    assert all(axis.correlations == (("plant.mass", "plant.damping", 0.2),) for axis in load_machine(out).axes)


@pytest.mark.slow
def test_a_log_in_a_wrong_unit_makes_no_machine(scene: Path, tmp_path: Path, refused: Refused, capsys: pytest.CaptureFixture[str]) -> None:
    """Positions a tenth too small put the only parameter at its bound: unusable. Positions a thousand times too small are refused."""
    lines = [line.split(",") for line in (scene / "log.csv").read_text().splitlines()]
    small = [",".join([*cells[:3], *(f"{0.9 * float(cell):.6f}" for cell in cells[3:])]) for cells in lines[1:]]
    (tmp_path / "log.csv").write_text("\n".join([",".join(lines[0]), *small]))
    out, given = tmp_path / "machine.toml", words(scene, "--write", str(tmp_path / "machine.toml"), "--json", names=["axes.x.plant.mass"])
    assert main([str(tmp_path / "log.csv") if word == str(scene / "log.csv") else word for word in given]) == 1
    found = json.loads(capsys.readouterr().out, parse_constant=pytest.fail)
    assert parameters(found)["axes.x.plant.mass"]["at_bound"] and not found["result"]["usable"] and not out.exists()
    (tmp_path / "log.csv").write_text((scene / "log.csv").read_text().replace("pos [mm]", "pos [um]"))
    assert "log.csv: " in refused(*[str(tmp_path / "log.csv") if word == str(scene / "log.csv") else word for word in given])


@pytest.mark.slow
def test_missing_samples_are_reported(scene: Path, tmp_path: Path, as_json: AsJson) -> None:
    lines = (scene / "log.csv").read_text().splitlines()
    thin = tmp_path / "thin.csv"
    thin.write_text("\n".join(lines[:400] + lines[404:]) + "\n")
    typed = [str(thin) if word == str(scene / "log.csv") else word for word in words(scene, names=NAMES[:1])]
    doubts = [one["text"] for one in as_json(*typed, code=(0, 1))["findings"] if one["code"] == "CL427"]
    assert any("thin" in text and "4 of" in text for text in doubts)


@pytest.mark.slow
def test_logs_are_named_by_folder_and_equal_columns_are_reported(scene: Path, tmp_path: Path, as_json: AsJson) -> None:
    for folder in ("first", "second"):
        (tmp_path / folder).mkdir()
        shutil.copyfile(scene / "log.csv", tmp_path / folder / "log.csv")
    typed = [str(tmp_path / "first" / "log.csv") if word == str(scene / "log.csv") else word for word in words(scene)]
    found = as_json(*typed, "--log", tmp_path / "second" / "log.csv")
    assert {row["run"] for row in found["result"]["after"]} == {"first-log", "second-log"}
    columns = (scene / "columns.toml").read_text().replace('"y pos"', '"y ref"')
    (tmp_path / "same.toml").write_text(columns)
    typed = [str(tmp_path / "same.toml") if word == str(scene / "columns.toml") else word for word in words(scene)]
    found = as_json(*typed, code=(0, 1))
    assert "CL404" in {code for code, _ in codes(found)}


@pytest.mark.parametrize("option", ["--write", "--out"])
def test_an_unwritable_target_is_refused_before_refining(
    scene: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, refused: Refused, option: str
) -> None:
    from contourlab.features.refine import command as refine

    (tmp_path / "taken").mkdir()
    (tmp_path / "file").write_text("")
    monkeypatch.setattr(refine, "refined", lambda *args, **more: pytest.fail("refined"))
    assert option in refused(*words(scene, "--plots", "png", option, str(tmp_path / {"--write": "taken", "--out": "file"}[option])))
    assert sorted(file.name for file in tmp_path.iterdir()) == ["file", "taken"]


@pytest.mark.parametrize("name", ["guess-circle.toml", "guess.toml", "log.csv", "columns.toml", "second.csv"])
def test_input_files_are_not_overwritten(scene: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, refused: Refused, name: str) -> None:
    from contourlab.features.refine import command as refine

    copy = tmp_path / "scene"
    shutil.copytree(scene, copy)
    shutil.copy(copy / "log.csv", copy / "second.csv")
    before = contents(copy)
    assert name in before
    monkeypatch.setattr(refine, "refined", lambda *args, **more: pytest.fail("refined"))
    said = refused(*words(copy, "--validation", str(copy / "second.csv"), "--write", str(copy / name)))
    assert str(copy / name) in said and "--write" in said
    assert contents(copy) == before


@pytest.mark.slow
def test_several_logs_are_left_out_in_turn(scene: Path, tmp_path: Path, as_json: AsJson, capsys: pytest.CaptureFixture[str]) -> None:
    """A second log with other friction: the table, the JSON and the file state how far a new run may be from its simulation."""
    from contourlab.loop import simulate

    true, guess = load_scenario(written(tmp_path, "other", 300.0, 48.0)), load_scenario(scene / "guess-circle.toml")
    seen = simulate(true.machine, guess.controller, true.base.reference())
    rows = np.column_stack([np.arange(seen.n_sample) * 1e-3, 1e3 * seen["reference"], 1e3 * seen["position"]])
    head = (scene / "log.csv").read_text().splitlines()[0]
    (tmp_path / "other.csv").write_text(head + "\n" + "\n".join(",".join(f"{v:.6f}" for v in row) for row in rows))
    out = tmp_path / "machine.toml"
    typed = words(scene, "--log", str(tmp_path / "other.csv"), "--write", str(out))
    found = as_json(*typed)
    crossed = found["cross_validation"]
    assert [one["run"] for one in crossed["held_out"]] == ["log", "other"] and crossed["level"] == 2.0 / 3.0
    (stated,) = (one["values"] for one in found["findings"] if one["code"] == "CL566")
    assert 1.02 < crossed["rms_factor"] == stated["rms_high"] < 2.0
    # Friction of 40 N in one log and 48 N in the other.
    assert parameters(found)["axes.x.friction.coulomb"]["deviation"] == pytest.approx(4.0, rel=0.1)
    assert 'deviation = "4' in out.read_text()
    assert main(typed) == 0 and "\nleft out  " in capsys.readouterr().out
    found = as_json(*words(scene))
    assert found["cross_validation"] is None and "CL567" in {code for code, _ in codes(found)}
