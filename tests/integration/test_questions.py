"""Questions asked in Python: the same answers as the commands, and no file."""

from __future__ import annotations

import json
from pathlib import Path

import made_circles
import matplotlib as mpl
import pytest
from typed_commands import CIRCLE, PART, AsJson, write

import contourlab as cl
from contourlab.app.json_values import json_values

mpl.use("agg")


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def names(folder: Path) -> set[str]:
    """Return the names of all files."""
    return {file.name for file in folder.rglob("*") if file.is_file()}


def test_a_circle_has_the_same_answer_as_the_command(folder: Path, as_json: AsJson) -> None:
    made_circles.write_log(Path("log.csv"), x=8e-6, lag=1e-4)
    answer = cl.circle("log.csv", tolerance="5 um")
    assert names(folder) == {"log.csv"} and answer.passed is False
    typed = as_json("circle", "log.csv", "--tolerance", "5 um", code=1)
    assert json_values(answer) == typed
    assert list(answer.to_pandas()["cause"])[:2] == ["backlash", "servo mismatch"]
    assert answer.plot().get_xlabel() == "angle [deg]" and "backlash x" in answer._repr_html_()
    saved = answer.save("out")
    assert Path(saved.report).exists() and json.loads(Path("out/summary.json").read_text(encoding="utf-8"))["causes"] == typed["causes"]


def test_files_and_objects_give_the_same_answer(folder: Path) -> None:
    write(folder, CIRCLE, "circle.toml")
    case = cl.load_scenario("circle.toml").base
    options = {"method": "sequential", "parameter": "1.position_gain", "lanes": 8}
    first = cl.tune("circle.toml", **options)
    second = cl.tune(case.machine, case.controller, case.reference(), **options)
    assert first.result.values == second.result.values and names(folder) == {"circle.toml"}
    # What JSON has under a key is an attribute too.
    assert (first.name, first.scheme) == (first.scenario.name, first.case.name) == tuple(map(json_values(first).get, ("name", "scheme")))
    with pytest.raises(AttributeError):
        _ = first.colour
    assert first.to_pandas()["after"].tolist() == list(first.result.values.values())
    kept = first.save("out").controller_file
    assert first.result.after.violations or (kept is not None and kept.exists())
    ran = cl.run(case.machine, case.controller, case.reference(), interval=False)
    assert ran.outcomes[0].metrics == cl.run("circle.toml", interval=False).outcomes[0].metrics


def test_a_failed_verdict_is_an_answer_and_bad_input_an_error(folder: Path) -> None:
    write(folder, CIRCLE.replace("16 um", "0.01 um"), "circle.toml")
    assert cl.run("circle.toml", interval=False).passed is False
    with pytest.raises(cl.ContourlabError):
        cl.run("nowhere.toml")
    with pytest.raises(cl.ContourlabError):
        cl.tune("circle.toml", budget=3)
    with pytest.raises(TypeError):
        cl.tune("circle.toml", bugdet=100)
    assert names(folder) == {"circle.toml"}


def test_a_program_is_checked_and_its_limits_are(folder: Path, as_json: AsJson) -> None:
    write(folder, PART)
    checked = cl.check("part.ngc")
    assert checked.faults == 0 and json_values(checked) == as_json("check", "part.ngc")
    test = cl.limits("part.ngc", velocity="1 mm/s")
    assert test.passed is not None and set(test.to_pandas()["axis"]) == {"x", "y", "z"}
    annotated = test.save(annotate="annotated.ngc")
    assert annotated.annotated == "annotated.ngc" and Path("annotated.ngc").exists()
