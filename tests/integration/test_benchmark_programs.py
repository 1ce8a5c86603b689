"""The table of part programs: its commands can be repeated, and an interruption keeps the finished rows."""

from __future__ import annotations

import importlib.util
import json
import shlex
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from contourlab.cli.main import main

FILE = Path(__file__).parents[2] / "benchmarks" / "programs.py"


@pytest.fixture
def programs() -> ModuleType:
    """The benchmark as a module."""
    spec = importlib.util.spec_from_file_location("programs_benchmark", FILE)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def write_parts(folder: Path) -> Path:
    """Write programs that need the options to run on the machine: one too large, one without an end."""
    parts = folder / "some parts"
    parts.mkdir()
    (parts / "a.ngc").write_text("G21 G90 F9000\nG1 X900\n", encoding="ascii")
    (parts / "b.ngc").write_text("G21 G90 F1000\nG1 X5\n", encoding="ascii")
    return parts


@pytest.mark.slow
def test_the_command_repeats_the_run(programs: ModuleType, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    parts = write_parts(tmp_path)
    row = programs.run(parts / "b.ngc", tmp_path / "out")
    assert "error" not in row
    command = json.loads((tmp_path / "out" / "b" / "summary.json").read_text(encoding="utf-8"))["command"]
    words = shlex.split(command)
    assert words[0] == "contourlab"
    again = tmp_path / "again"
    assert main([*words[1:], "--out", str(again)]) == 0, capsys.readouterr().err
    figures = [
        json.loads((f / "summary.json").read_text(encoding="utf-8"))["schemes"]["base"]["metrics"] for f in (tmp_path / "out/b", again)
    ]
    assert figures[0] == figures[1]
    assert main([*shlex.split(programs.command_of(parts / "a.ngc"))[1:], "--check"]) == 0


def test_an_interruption_keeps_the_finished_rows(
    programs: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def run(file: Path, out: Path) -> dict[str, Any]:
        if file.name == "b.ngc":
            raise KeyboardInterrupt
        return {"program": file.name, "error": "too long", "seconds": 1.0}

    monkeypatch.setattr(programs, "run", run)
    monkeypatch.setattr(sys, "argv", ["programs.py", str(write_parts(tmp_path)), "--out", str(tmp_path / "out")])
    assert programs.main() == 130
    shown = capsys.readouterr()
    assert "a.ngc: " in shown.out
    assert "1 of 2" in shown.err
    assert [row["program"] for row in json.loads((tmp_path / "out" / "programs.json").read_text(encoding="utf-8"))] == ["a.ngc"]


def test_an_empty_folder_says_what_to_type(
    programs: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "argv", ["programs.py", str(tmp_path)])
    assert programs.main() == 2
    assert "make programs PROGRAMS=<folder>" in capsys.readouterr().err
