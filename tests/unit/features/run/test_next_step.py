"""The next command after a run: it can be typed as it stands."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from contourlab.app.command_line import chosen_options
from contourlab.cli.main import main
from contourlab.scenario import builtin_file

PART = "G21 G90 F1500\nG64 P0.01\nG1 X8\nG3 X8 Y8 I0 J4\nG1 X0\nM2\n"


def last_line(capsys: pytest.CaptureFixture[str]) -> list[str]:
    """Return the words of the last line that was printed, without the prompt."""
    line = capsys.readouterr().out.strip().splitlines()[-1]
    assert line.startswith("next: contourlab ")
    return shlex.split(line)[2:]


@pytest.fixture
def part(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """A part program on a shipped machine."""
    monkeypatch.chdir(tmp_path)
    Path("my part.ngc").write_text(PART, encoding="ascii")
    return ["run", "my part.ngc", "--machine", "xyz", "--controller", "xyz-controller", "--no-interval"]


def test_without_a_tolerance_it_judges(part: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(part) == 0
    words = last_line(capsys)
    assert words[:2] == ["run", "my part.ngc"] and "--tolerance" in words
    assert main([*words, "--check"]) == 0


@pytest.mark.slow
def test_after_a_failure_it_runs_the_proposed_controller(part: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*part, "--tolerance", "0.5 um"]) == 1
    words = last_line(capsys)
    assert words[0] == "run" and Path(words[words.index("--controller") + 1]).is_file() and words.count("--controller") == 1
    assert main([*words, "--check"]) == 0


@pytest.mark.slow
def test_where_the_plan_leaves_the_path_it_does_not_tune(part: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    program = Path("my part.ngc")
    program.write_text(program.read_text(encoding="ascii").replace("P0.01", "P1").replace("G1 X0", "G1 X0\nG1 Y0"), encoding="ascii")
    assert main([*part, "--tolerance", "10 um"]) == 1
    assert last_line(capsys) == ["explain", "CL208"]


def test_after_a_success_it_proposes_nothing(part: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*part, "--tolerance", "1 mm"]) == 0
    assert "next:" not in capsys.readouterr().out


def test_plugins_are_named_again() -> None:
    options = ["--plugin", "a.py", "--out", "here", "--plugin", "b.py", "--tolerance", "1 um"]
    assert chosen_options(options, "--plugin") == ["--plugin", "a.py", "--plugin", "b.py"]


@pytest.mark.slow
def test_a_search_does_not_write_where_its_controller_lies(part: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*part, "--out", "results"]) == 0
    capsys.readouterr()
    Path("results/tuned.toml").write_text(builtin_file("xyz-controller").read_text())
    words = ["results/tuned.toml" if word == "xyz-controller" else word for word in part]
    assert main([*words, "--tolerance", "0.5 um", "--out", "again"]) == 1
    assert main([*words, "--tolerance", "0.5 um"]) == 1
    searches = re.findall(r"contourlab tune [^<]*", Path("results/report.html").read_text(encoding="utf-8"))
    assert searches and all("--out" in words for words in searches)
