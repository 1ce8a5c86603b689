"""`contourlab circle` as typed."""

from __future__ import annotations

import importlib.util
import json
import math
import sys
from pathlib import Path
from types import ModuleType

import made_circles
import numpy as np
import pytest
from messages import message_in, pictures
from typed_commands import AsJson, Refused

from contourlab.cli.main import main

BENCHMARK = Path(__file__).parents[2] / "benchmarks" / "circle_causes.py"


@pytest.fixture(autouse=True)
def _folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def ball_bar(file: Path, unit: str = "um", noise: float = 2e-8) -> Path:
    """Write angle and deviation of a circle in both senses."""
    rows = [(run.turned, run.deviation) for run in made_circles.runs(x=8e-6, square=1e-4, noise=noise)]
    angle, deviation = np.concatenate([a for a, _ in rows]), np.concatenate([d for _, d in rows])
    table = np.column_stack([np.degrees(np.mod(angle, 2.0 * math.pi)), deviation * {"um": 1e6, "mm": 1e3}[unit]])
    np.savetxt(file, table, fmt="%.5f", delimiter=",", header=f"angle [deg],deviation [{unit}]", comments="")
    return file


def test_a_log_of_both_senses(as_json: AsJson) -> None:
    made_circles.write_log(Path("log.csv"), x=8e-6, lag=1e-4)
    result = as_json("circle", "log.csv")
    first, second = result["causes"][:2]
    assert (first["cause"], first["axis"], second["cause"]) == ("backlash", "x", "servo mismatch")
    assert first["value"] == pytest.approx(8e-6, rel=0.01) and second["value"] == pytest.approx(1e-4, rel=0.01)
    assert result["radius"] == pytest.approx(0.05, abs=1e-8) and result["feedrate"] == pytest.approx(0.05, rel=1e-3)
    assert [run["clockwise"] for run in result["runs"]] == [False, True]
    assert {"CL480", "CL483", "CL491"} <= {found["code"] for found in result["findings"]}
    assert json.loads(Path("results/summary.json").read_text(encoding="utf-8"))["causes"] == result["causes"]


@pytest.mark.slow
def test_two_logs_give_the_same_as_one(as_json: AsJson) -> None:
    for name, clockwise in (("ccw.csv", False), ("cw.csv", True)):
        made_circles.write_log(Path(name), senses=(clockwise,), x=8e-6, square=1e-4)
    result = as_json("circle", "ccw.csv", "cw.csv")
    found = {cause["cause"]: cause for cause in reversed(result["causes"])}
    assert found["squareness"]["value"] == pytest.approx(1e-4, rel=0.01)
    assert found["backlash"]["value"] == pytest.approx(8e-6, rel=0.01)


def test_one_sense_says_what_it_cannot_separate(as_json: AsJson) -> None:
    made_circles.write_log(Path("log.csv"), senses=(True,), square=1e-4)
    result = as_json("circle", "log.csv")
    assert result["causes"][0]["cause"] == "squareness or servo mismatch" and result["bidirectional"] is None
    assert {"CL488", "CL489"} <= {found["code"] for found in result["findings"]}


@pytest.mark.slow
def test_tolerance_and_next_command(capsys: pytest.CaptureFixture[str]) -> None:
    made_circles.write_log(Path("log.csv"), x=8e-6)
    assert main(["circle", "log.csv", "--tolerance", "20 um"]) == 0
    assert main(["circle", "log.csv", "--tolerance", "5 um"]) == 1
    out = capsys.readouterr().out
    assert out.splitlines()[-1].startswith("next: contourlab identify log.csv")
    assert max(map(len, out.splitlines()[:-1])) <= 80


@pytest.mark.parametrize("unit", ["um", pytest.param("mm", marks=pytest.mark.slow)])
def test_a_file_of_angle_and_deviation(unit: str, as_json: AsJson) -> None:
    ball_bar(Path("bar.txt"), unit)
    result = as_json("circle", "bar.txt", "--radius", "50 mm", "--feed", "3000 mm/min")
    found = {cause["cause"]: cause for cause in reversed(result["causes"])}
    assert found["backlash"]["value"] == pytest.approx(8e-6, rel=0.01)
    assert found["squareness"]["value"] == pytest.approx(1e-4, rel=0.01)
    assert result["feedrate"] == pytest.approx(0.05)


def test_radii_under_other_names(as_json: AsJson) -> None:
    (run,) = made_circles.runs(senses=(False,), x=8e-6)
    np.savetxt("r.txt", np.column_stack([np.degrees(run.turned), 1e3 * (run.radius + run.deviation)]), fmt="%.6f")
    words = ("--column", "angle=1 [deg]", "--column", "radius=2 [mm]", "--radius", "50 mm")
    assert as_json("circle", "r.txt", *words)["causes"][0]["value"] == pytest.approx(8e-6, rel=0.01)


@pytest.mark.slow
def test_the_report_is_one_file_with_a_slider_for_each_cause() -> None:
    made_circles.write_log(Path("log.csv"), x=8e-6)
    assert main(["circle", "log.csv"]) == 0
    text = Path("results/report.html").read_text(encoding="utf-8")
    assert "http://" not in text and "https://" not in text
    test = pictures(message_in(text))["causes"]
    assert len(test["runs"]) == 2 and "backlash x" in test["causes"]
    run = test["runs"][0]
    left = run["deviation"] - np.sum(run["curves"], axis=0)
    # Centre and radius stay; at each reversal the step is spread over samples that the fit leaves out.
    assert np.std(left) < 0.1 * np.std(run["deviation"])


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("none.csv",), "none.csv"),
        (("line.csv",), "circle"),
        (("log.csv", "--axes", "x,q"), "q"),
        (("log.csv", "--tolerance", "5"), "--tolerance"),
        (("log.csv", "--radius", "20 mm"), "20 mm"),
        (("bar.txt",), "--radius"),
    ],
)
def test_bad_input_is_one_line(words: tuple[str, ...], said: str, refused: Refused) -> None:
    made_circles.write_log(Path("log.csv"))
    ball_bar(Path("bar.txt"))
    table = np.column_stack([np.arange(500) * 1e-3, np.linspace(0.0, 10.0, 500), np.linspace(0.0, 20.0, 500)])
    np.savetxt("line.csv", table, delimiter=",", header="time [s],position.x [mm],position.y [mm]", comments="")
    assert said in refused("circle", *words)


@pytest.fixture(scope="module")
def benchmark() -> ModuleType:
    """The benchmark as a module."""
    spec = importlib.util.spec_from_file_location("circle_benchmark", BENCHMARK)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


@pytest.mark.slow
def test_injected_errors_come_back(benchmark: ModuleType) -> None:
    rows = list(benchmark.cases(5, 1))
    assert all(row["reported"][0][0] == max(row["injected"], key=row["injected"].get) for row in rows)
    assert len({row["reported"][0][0] for row in rows}) >= 4
    errors = [
        abs(row["found"][name][0] / size - 1.0) for row in rows for name, size in row["injected"].items() if len(row["injected"]) == 1
    ]
    assert max(errors) < 0.03
