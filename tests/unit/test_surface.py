"""What is made from the questions is up to date, and types reach the user."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
SCRIPT = """
import contourlab as cl

answer = cl.tune("scenario.toml", objective="max", budget=2000)
answer.controller.axes
cl.run("part.ngc", machine="xyz", controller="xyz-controller", tolerance="25 um").save("out")
cl.sweep.merge("one", "two", out="whole")
cl.tune("scenario.toml", bugdet=2000)
cl.circle("log.csv", radius=0.05)
case = cl.load_scenario("scenario.toml").base
law = cl.component("learning", "zero-phase")(gain=0.5)
cl.learn(case.machine, case.controller, case.reference(), law, trials=3).table
cl.learn("scenario.toml", trails=3)
cl.measure(cl.load_log({"x [mm]": [1.0, 2.0]}, period=1e-3)).runs
"""
COMPLETED = {
    'cl.tune("scenario.toml", obj': "objective=",
    'cl.tune("scenario.toml").contr': "controller",
    "cl.sweep.mer": "merge",
    'cl.load_log("log.csv").res': "result",
    "cl.Nur": "Nurbs",
}
"""What is typed, and what a completer offers."""


def test_lines_of_help_and_types_are_up_to_date(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(ROOT / "tools"))
    import surface

    assert surface.LINES.read_text(encoding="utf-8") == surface.lines(), "python tools/surface.py"
    assert surface.STUB.read_text(encoding="utf-8") == surface.stub(), "python tools/surface.py"


@pytest.mark.parametrize("typed", COMPLETED)
def test_a_completer_knows_names_parameters_and_answers(typed: str) -> None:
    import jedi

    offered = {one.name for one in jedi.Script(f"import contourlab as cl\n{typed}").complete()}
    assert COMPLETED[typed] in offered


@pytest.mark.slow
def test_a_type_checker_finds_a_misspelt_parameter(tmp_path: Path) -> None:
    file = tmp_path / "script.py"
    file.write_text(SCRIPT, encoding="utf-8")
    words = [sys.executable, "-m", "mypy", "--strict", str(file)]  # reads what the last check of the whole package left in its cache
    said = subprocess.run(words, cwd=ROOT, capture_output=True, encoding="utf-8", timeout=600, check=False)
    lines = {int(line.split(":")[1]) for line in said.stdout.splitlines() if ": error:" in line and "script.py" in line}
    assert lines == {8, 9, 13}, said.stdout
