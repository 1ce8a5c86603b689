"""`contourlab run` of part programs without an end or with a tool table, and of drawings in their place."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import ezdxf
import numpy as np
import pytest
from typed_commands import COMMAND, ON_XYZ, PART, Refused, Run, environment, write

from contourlab.cli.main import main
from contourlab.result import Result

ENDLESS = "G21 G90 F1000\nG1 X5\n"
UNOPENED = "G21 G90 F1000\nG1 X5\n%\n"


def test_a_program_without_an_end_is_run_on_request(contourlab: Run, tmp_path: Path) -> None:
    said = contourlab("run", write(tmp_path, UNOPENED), *ON_XYZ, "--no-require-end")
    assert said.code == 0, said.err
    summary = json.loads((tmp_path / "results" / "summary.json").read_text(encoding="utf-8"))
    assert summary["command"] == "contourlab run part.ngc --controller xyz-controller --no-require-end --machine xyz"


@pytest.mark.parametrize("text", [ENDLESS, UNOPENED])
def test_the_refusal_names_the_option(tmp_path: Path, refused: Refused, text: str) -> None:
    part = tmp_path / write(tmp_path, text)
    assert "--no-require-end" in refused("run", part, *ON_XYZ, "--check", lines=2)
    assert main(["run", str(part), *ON_XYZ, "--check", "--no-require-end"]) == 0


def test_in_a_scenario_the_key_is_named(tmp_path: Path, refused: Refused) -> None:
    write(tmp_path, ENDLESS)
    text = 'machine = "builtin:xyz"\ncontroller = "builtin:xyz-controller"\nprogram = "part.ngc"\n'
    scenario = str(tmp_path / write(tmp_path, text, "part.toml"))
    assert "require_end = false" in refused("run", scenario, "--check", lines=2)
    assert "require_end = false" in refused("run", scenario, "--no-require-end", lines=2)


def test_another_fault_does_not_mention_ends(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", str(tmp_path / write(tmp_path, "G1 X5\nM2\n")), *ON_XYZ]) == 2
    assert "require" not in capsys.readouterr().err


def test_block_delete_and_tool_lengths(contourlab: Run, tmp_path: Path) -> None:
    """The tool of 12 mm moves Z up by its length; the line with / would move to X40."""
    write(tmp_path, "T1 P1 Z12 D6 ; mill\n", "mill.tbl")
    write(tmp_path, "G21 G90 F2000\nG43 H1 G1 X5 Z-10\n/G1 X40\nG1 Z-5\nM2\n")
    said = contourlab("run", "part.ngc", *ON_XYZ, "--block-delete", "--tools", "mill.tbl")
    assert said.code == 0, said.err
    reference = np.asarray(Result.load(tmp_path / "results" / "signals" / "base.nc")["reference"])
    assert reference[:, 0].max() == pytest.approx(0.005, abs=1e-9)
    assert reference[-1, 2] == pytest.approx(0.007, abs=1e-9)
    summary = json.loads((tmp_path / "results" / "summary.json").read_text(encoding="utf-8"))
    assert summary["command"].endswith("--block-delete --tools mill.tbl")


@pytest.mark.parametrize("command", [("run", *ON_XYZ), ("run",), ("check",), ("canon",)])
@pytest.mark.parametrize("name", ["part.dxf", "PART.SVG", "points.csv"])
def test_a_drawing_is_no_part_program(tmp_path: Path, capsys: pytest.CaptureFixture[str], command: tuple[str, ...], name: str) -> None:
    assert main([command[0], str(tmp_path / write(tmp_path, "0\nSECTION\n", name)), *command[1:]]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert f"{name}: " in said.err and f'{name}"\n[feed]\n' in said.err
    assert ("points" if name.endswith("csv") else "drawing") in said.err


def test_the_lines_for_a_drawing_run_as_they_are(contourlab: Run, tmp_path: Path) -> None:
    document = ezdxf.new()  # type: ignore[attr-defined]
    document.header["$INSUNITS"] = 4
    document.modelspace().add_circle((0, 0), 10)
    document.saveas(tmp_path / "ring.dxf")
    said = contourlab("run", "ring.dxf", *ON_XYZ)
    assert said.code == 2
    write(tmp_path, said.err.split("run that:")[1], "ring.toml")
    done = contourlab("run", "ring.toml", "--check")
    assert done.code == 0, done.err
    assert "62.8319 mm" in done.out


@pytest.mark.skipif(os.name == "nt", reason="needs a POSIX pseudo-terminal")
@pytest.mark.slow
def test_a_terminal_shows_the_stages_of_a_long_run(tmp_path: Path) -> None:
    ours, theirs = os.openpty()
    write(tmp_path, PART)
    words = [str(COMMAND), "run", "part.ngc", *ON_XYZ, "--tolerance", "0.1 um"]
    with subprocess.Popen(
        words, cwd=tmp_path, stdout=subprocess.DEVNULL, stderr=theirs, env=environment({"TERM": "xterm", "COLUMNS": "120"})
    ) as process:
        os.close(theirs)
        shown = b""
        while True:
            try:
                piece = os.read(ours, 65536)
            except OSError:  # Linux raises this when the other end is closed
                break
            if not piece:
                break
            shown += piece
    os.close(ours)
    assert process.returncode == 1
    stages = ("planning base", "simulating base", "judging base", "looking for the causes", "writing signals", "writing the report")
    places = [shown.decode().find(stage) for stage in stages]
    assert min(places) >= 0
    assert places == sorted(places)
