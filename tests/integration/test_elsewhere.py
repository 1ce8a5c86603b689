"""Searches give the same numbers in threads, in processes and on a Dask cluster."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest
from made_studies import exported
from rigid_circle import SCENARIO, STAGE
from typed_commands import drag, invoke

from contourlab.cli.main import main

PLAIN = """\
plant = {kind = "rigid-axis", gain = "1000 mm/s^2/full_scale"}
friction = {kind = "drag", coefficient = "0.01 full_scale*s/mm"}
drive = {kind = "saturation", limit = "1 full_scale"}
"""
STUDY = """\
scenario = "circle.toml"
figures = ["contour_error_max"]
[vary]
"controller.axes.x.*.position_gain" = {uniform = ["50 %", "200 %"]}
"""
PART = """\
G17 G21 G90 G94 G64 P0.02
F1200
G1 X10 Y2.5
G3 X15 Y7.5 I0 J5
G1 X7.5 Y15
X-5 Y10
X0 Y0
M2
"""
FILES = {
    "circle.toml": SCENARIO,
    "part.toml": SCENARIO.partition("[contour]")[0].replace('"stage.toml"', '"limited.toml"\nprogram = "part.ngc"'),
    "limited.toml": STAGE + '[axes."*".limits]\nvelocity = "6 m/min"\nacceleration = "2 m/s^2"\njerk = "40 m/s^3"\n',
    "part.ngc": PART,
    "stage.toml": STAGE,
    "plain.toml": PLAIN,
    "strong.toml": PLAIN.replace("1000", "2000"),
    "study.toml": STUDY,
    "drag.py": drag("drag"),
}
GAINS = ["--parameter", "x.model_gain", "--parameter", "y.position_gain"]
BRIEF = ["--budget", "100", "--ways", "one", "--longest", "1 ms"]
COMMANDS = {
    "sensitivity": ["sensitivity", "circle.toml", *GAINS, "--base", "32", "--values", "9", "--trajectories", "4"],
    "tune": ["tune", "circle.toml", *GAINS, "--budget", "200"],
    "swap": ["swap", "circle.toml", "--axis", "x", "--with", "strong.toml", "--parameter", "model_gain", *BRIEF],
    "optimise": ["sweep", "optimise", "study.toml", "--minimise", "contour_error_max", "--trials", "96", "--batch", "48"],
}


def written(folder: Path, kind: str = "drag") -> Path:
    """Return a new folder with the files; `kind` is that of the friction, of which a process takes one plug-in."""
    folder.mkdir()
    for name, text in FILES.items():
        (folder / name).write_text(text.replace('"drag"', f'"{kind}"'))
    return folder


def without_executor(found: Any) -> Any:
    """Return a JSON output without what it says of the executor."""
    for part in (found, found.get("request", {}), found.get("settings", {})):
        part.pop("executor", None)
    return found


def answer(folder: Path, *words: str) -> Any:
    """Return the JSON output of a command in a folder of its own, without what it says of the executor."""
    said = invoke(written(folder), *words, "--plugin", "drag.py", "--json")
    assert said.code in (0, 1), said.err
    return without_executor(json.loads(said.out))


PROCESSES, CLUSTER = ("processes", "2"), ("dask-local", "2")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("command", "motion", "executors"),
    [
        ("sensitivity", "circle", [PROCESSES]),
        ("sensitivity", "part", [PROCESSES]),  # all commands hand the motion over in the same way
        ("tune", "circle", [PROCESSES, CLUSTER]),
        ("swap", "circle", [PROCESSES]),
        ("optimise", "circle", [PROCESSES, CLUSTER]),
    ],
)
def test_an_executor_does_not_change_the_answer(tmp_path: Path, command: str, motion: str, executors: list[tuple[str, str]]) -> None:
    words = [word.replace("circle.toml", f"{motion}.toml") for word in COMMANDS[command]]
    here = answer(tmp_path / "here", *words)
    for executor, workers in executors:
        assert answer(tmp_path / executor, *words, "--executor", executor, "--workers", workers) == here, executor


@pytest.mark.slow
@pytest.mark.parametrize(("motion", "executors"), [("circle", [("threads", "2"), PROCESSES, CLUSTER]), ("part", [PROCESSES])])
def test_an_executor_does_not_change_a_store(tmp_path: Path, motion: str, executors: list[tuple[str, str]]) -> None:
    folder = written(tmp_path / "here")
    (folder / "many.toml").write_text("variants = 96\nchunk = 32\n" + STUDY.replace("circle", motion))
    stores = {}
    for kind, workers in (("threads", "1"), *executors):
        words = ["sweep", "many.toml", "--executor", kind, "--workers", workers, "--out", kind + workers, "--plugin", "drag.py"]
        said = invoke(folder, *words)
        assert said.code == 0, said.err
        stores[kind + workers] = exported(folder / (kind + workers))
    assert {name for name, rows in stores.items() if rows == stores["threads1"]} == stores.keys()
    assert stores["threads1"].count(b"\n") == 97


@pytest.mark.slow
@pytest.mark.parametrize("command", COMMANDS)
def test_a_gpu_does_not_change_the_answer(
    tmp_path: Path, a_gpu: None, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, command: str
) -> None:
    monkeypatch.chdir(written(tmp_path / "here", tmp_path.name.replace("_", "-")))
    found = []
    for executor in ("gpu", "threads"):
        words = ["--plugin", "drag.py", "--json", "--executor", executor, "--out", "found"]
        assert main([*COMMANDS[command], *words]) in (0, 1)
        found.append(without_executor(json.loads(capsys.readouterr().out)))
        shutil.rmtree("found")
    assert found[0] == found[1]


@pytest.mark.parametrize("command", COMMANDS)
def test_an_unknown_executor_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: str) -> None:
    monkeypatch.chdir(tmp_path)
    assert main([*COMMANDS[command], "--executor", "cloud"]) == 2
    assert not list(tmp_path.iterdir())
