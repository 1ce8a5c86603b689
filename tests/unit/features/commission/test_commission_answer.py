"""From files and a log to gains; and logs that are not what they should be."""

from collections.abc import Callable
from pathlib import Path

import made_commission as bench
import numpy as np
import pytest

from contourlab.app.json_values import json_values
from contourlab.features.commission.command import Commissioned, commission, prepare
from contourlab.features.commission.hal_files import read_setup

Rows = dict[str, np.ndarray]


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> bench.Made:
    return bench.made(tmp_path_factory.mktemp("machine"))


@pytest.fixture(scope="module")
def answered(made: bench.Made, tmp_path_factory: pytest.TempPathFactory) -> tuple[Commissioned, Path]:
    folder = tmp_path_factory.mktemp("answer")
    return commission(made.ini, made.hal, [made.log(folder / "log1.csv")], folder / "out"), folder / "out"


def test_first_call_writes_what_to_run(made: bench.Made, tmp_path: Path) -> None:
    before = made.ini.read_bytes(), made.hal.read_bytes()
    result = prepare(made.ini, made.hal, tmp_path)
    assert [file.name for file in result.files] == ["excite.ngc", "sampler.hal", "steps.md"]
    assert before == (made.ini.read_bytes(), made.hal.read_bytes())
    assert result.passed


@pytest.mark.parametrize("axis", ["x", "y"])
def test_axes_are_recovered(answered: tuple[Commissioned, Path], axis: str) -> None:
    true, found = bench.MODELS[axis], answered[0].models[axis]
    for name, tolerance in (("gain", 0.01), ("damping", 0.01), ("friction", 0.03)):
        assert getattr(found.model, name) == pytest.approx(getattr(true, name), rel=tolerance)
        assert found.deviations[name] < tolerance * getattr(true, name)
    assert found.model.delay == pytest.approx(true.delay, abs=5e-5)
    assert found.noise == pytest.approx(bench.NOISE / np.sqrt(3.0), rel=0.2)
    assert found.play == pytest.approx(bench.PLAY[axis], abs=max(4.0 * found.play_deviation, 3e-7))
    assert found.simulated == pytest.approx(found.measured, rel=0.02)


def test_gains_do_what_is_predicted(made: bench.Made, answered: tuple[Commissioned, Path]) -> None:
    result = answered[0]
    assert result.passed
    setup = read_setup(made.ini, made.hal)
    for factor, limit in ((1.0, 2.0), (0.75, 40.0), (1.25, 40.0)):
        rows = bench.simulated(setup, made.ini.parent / "excite.ngc", result.pid, factor)
        for axis in "xy":
            reached = 1e3 * np.abs(rows[f"{axis}_cmd [mm]"] - rows[f"{axis} [mm]"]).max()
            assert reached < limit * result.predicted[axis].after
            if factor == 1.0:
                assert reached > 0.5 * result.predicted[axis].after
                assert reached < 0.1 * result.predicted[axis].before


def test_diff_leads_to_the_proposed_gains(made: bench.Made, answered: tuple[Commissioned, Path], tmp_path: Path) -> None:
    result, folder = answered
    diff = (folder / "gains.diff").read_text()
    patched = []
    for file in (made.ini, made.hal):
        old, new = file.read_text().splitlines(), list[str]()
        at, inside = 0, False
        for line in diff.splitlines():
            if line.startswith("--- "):
                inside = line == f"--- a/{file.name}"
            elif line.startswith("@@") and inside:
                start = int(line.split()[1].split(",")[0][1:]) - 1
                new += old[at:start]
                at = start
            elif inside and line[:1] in " +-" and not line.startswith("+++"):
                new += [line[1:]] if line[0] in " +" else []
                at += line[0] in " -"
        (tmp_path / file.name).write_text("\n".join([*new, *old[at:]]) + "\n")
        patched.append(tmp_path / file.name)
    setup = read_setup(*patched)
    assert {axis.name: axis.gains for axis in setup.axes} == {axis: pytest.approx(gains) for axis, gains in result.pid.items()}


def test_json_has_gains_and_prediction(answered: tuple[Commissioned, Path]) -> None:
    values = json_values(answered[0])
    assert set(values["pid"]["x"]) == {"Pgain", "Igain", "Dgain", "FF0", "FF1", "FF2", "FF3"}
    assert values["predicted"]["y"]["before"] > 10.0 * values["predicted"]["y"]["after"] > 0.0
    assert {"CL890", "CL892"} <= {one["code"] for one in values["findings"]}
    assert "largest error" in values["answer"][0]


def test_safe_values_lie_half_way(answered: tuple[Commissioned, Path]) -> None:
    result = answered[0]
    assert result.safe["x"]["Pgain"] == pytest.approx(0.5 * (0.8 + result.pid["x"]["Pgain"]), rel=1e-4)


def test_report_and_picture(answered: tuple[Commissioned, Path]) -> None:
    page = (answered[1] / "report.html").read_text()
    assert "data:image/png" in page
    assert (answered[1] / "circle.png").read_bytes()[:4] == b"\x89PNG"


# --- logs that are not what they should be --------------------------------------------------------------------------------------------


def swapped(rows: Rows) -> Rows:
    return rows | {"x [mm]": rows["y [mm]"], "y [mm]": rows["x [mm]"]}


def clipped(rows: Rows) -> Rows:
    return rows | {"x_out": np.clip(rows["x_out"], -0.3, 0.3)}


def short(rows: Rows) -> Rows:
    moves = np.flatnonzero(np.diff(rows["x_cmd [mm]"]))
    return {name: values[moves[0] - 200 : moves[0] + 120] for name, values in rows.items()}


DOCTORED: list[tuple[str, Callable[[Rows], Rows]]] = [
    ("CL876", lambda rows: rows | {"x [mm]": -rows["x [mm]"]}),
    ("CL881", lambda rows: rows | {"x_out": -rows["x_out"]}),
    ("CL878", lambda rows: rows | {"x [mm]": 2.0 * rows["x [mm]"]}),
    ("CL877", lambda rows: rows | {"x [mm]": rows["x [mm]"] / 25.4}),
    ("CL877", lambda rows: rows | {"x [mm]": 25.4 * rows["x [mm]"]}),
    ("CL883", lambda rows: rows | {"x_out": 0.1 * rows["x_out"]}),
    ("CL874", swapped),
    ("CL880", lambda rows: rows | {"x_out": rows["y_out"], "y_out": rows["x_out"]}),
    ("CL885", clipped),
    ("CL886", short),
    ("CL875", lambda rows: rows | {"x [mm]": 0.0 * rows["x [mm]"]}),
    ("CL873", lambda rows: rows | {"x_cmd [mm]": 0.0 * rows["x_cmd [mm]"]}),
    ("CL871", lambda rows: rows | {"time [s]": 2.0 * rows["time [s]"]}),
    ("CL870", lambda rows: {name: values for name, values in rows.items() if name != "x [mm]"}),
    ("CL893", lambda rows: {name: values for name, values in rows.items() if "load" not in name}),
    ("CL872", lambda rows: {name: values for name, values in rows.items() if "out" not in name}),
]


@pytest.mark.parametrize(("code", "doctor"), DOCTORED, ids=[f"{code}-{k}" for k, (code, _) in enumerate(DOCTORED)])
def test_doctored_logs_are_named(
    made: bench.Made, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, code: str, doctor: Callable[[Rows], Rows]
) -> None:
    monkeypatch.setattr("contourlab.features.commission.tuning.BUDGET", 32)
    log = made.log(tmp_path / "log.csv", doctor(made.rows))
    result = commission(made.ini, made.hal, [log], tmp_path / "out")
    assert code in {one.code for one in result.findings}
    wrong = [one for one in result.findings if one.code == code and one.entry.severity == "error"]
    assert all(one.place.removeprefix("axis ") not in result.pid for one in wrong)


def test_a_wrong_period_in_the_ini_file_shows_in_a_log_without_times(made: bench.Made, tmp_path: Path) -> None:
    ini = tmp_path / "wrong.ini"
    ini.write_text(made.ini.read_text().replace("SERVO_PERIOD = 1000000", "SERVO_PERIOD = 2000000"))
    log = tmp_path / "log.txt"
    names = ("x_cmd [mm]", "x [mm]", "x_out", "y_cmd [mm]", "y [mm]", "y_out")
    samples = np.column_stack([np.arange(len(made.rows["x_out"])), *(made.rows[name] for name in names)])
    log.write_text("".join(f"{int(row[0])} " + " ".join(f"{value:f}" for value in row[1:]) + " \n" for row in samples))
    result = commission(ini, made.hal, [log], tmp_path / "out")
    factors = [one.values["factor"] for one in result.findings if one.code == "CL882"]
    assert factors == pytest.approx([0.5, 0.5], rel=0.05)
    assert not result.pid


def test_noise_is_named(made: bench.Made, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bench, "NOISE", 5e-6)
    monkeypatch.setattr("contourlab.features.commission.tuning.BUDGET", 32)
    setup = read_setup(made.ini, made.hal)
    log = made.log(tmp_path / "log.csv", bench.simulated(setup, made.ini.parent / "excite.ngc"))
    result = commission(made.ini, made.hal, [log], tmp_path / "out")
    assert "CL891" in {one.code for one in result.findings}
