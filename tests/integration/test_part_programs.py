"""`contourlab canon` and `contourlab check`, and programs fitted into the travel of a machine, as typed."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from typed_commands import ON_XYZ, Run, write

from contourlab.result import Result

PROGRAM = """\
G21 G17 G90 G64 P0.05 Q0.01
G10 L2 P2 X10 Y20 Z0 R90
G55 G0 X1 Y0
G1 Y2 F600
G2 X3 Y4 I2 J0
G4 P0.25
G54 G61 G0 X0 Y0
M2
"""
FAULTY = """\
G21 F100
G1 X1 Q2
G1 X2
o1 while [#1 LT 3]
  G1 Y#1 W4
  #1 = [#1 + 1]
o1 endwhile
G41 D1
M2
"""
LARGE = "G21 G90 F2000\nG1 X900 Y50\nG2 X1000 Y150 I0 J100\nG0 X200 Y-20\nM2\n"


def test_canonical_moves_as_text(contourlab: Run, tmp_path: Path) -> None:
    said = contourlab("canon", write(tmp_path, PROGRAM))
    lines = said.out.splitlines()
    assert len(lines) == 5
    assert lines[2].split()[:6] == ["5", "arc", "X6", "Y23", "Z0", "F600"]


def test_a_fault_prints_no_moves(contourlab: Run, tmp_path: Path) -> None:
    said = contourlab("canon", write(tmp_path, "G0 X1\nG0 X2\nG1 Y5\nM2\n"), "--json").refusal
    assert "part.ngc:3:1: " in said and "G1" in said and said.count("\n") == 1


def test_leniency_of_the_reader_is_reported(contourlab: Run, tmp_path: Path) -> None:
    said = contourlab("canon", write(tmp_path, "$H\nX5 (no end\nG1 F10 Y1\n"), "--dialect", "grbl")
    assert said.code == 0
    assert len(said.out.splitlines()) == 2
    for place in ("part.ngc:1:1: $H", "part.ngc:2:4: the comment", "part.ngc:2:1: a move before", "part.ngc:3:1: the program has no end"):
        assert place in said.err


DIALECTS = [
    ("part.nc", "G17 G21 G90\nG0 X0 Y0\nG2 X10 Y0 I5 J0 K0.000 F400\nM2\n", "grbl"),
    ("part.nc", "G21 G90 F600\nG94\nG1 X10\nM2\n", "grbl"),
    ("part.tap", "G21 G90\nG81 X1 Y1 Z-1 R2 F100\nG80\nZ15.\nM2\n", "mach3"),
    ("part.nc", "%\nO0001 (PART)\nG21 G90\nG0 X5.\nG0 G91 G28 Z0\nG90\nM2\n%\n", "fanuc"),
    ("part.nc", "G17 G54 G40 G49 G80 G90 G90.1 G91.1\nG20\nG0 Z2\nM2\n", "mach3"),
    ("part.nc", "(Post Processor: grbl_post)\nG0 X1\nM2\n", "grbl"),
    ("part.nc", "(grbl)\n(for FluidNC)\nG0 X1\nG64\nM6 T1\nM2\n", "grblhal"),
]
"""Name and text of programs, and their dialect."""


@pytest.mark.parametrize(("name", "text", "dialect"), DIALECTS)
def test_check_proposes_the_dialect_of_the_program(contourlab: Run, tmp_path: Path, name: str, text: str, dialect: str) -> None:
    (tmp_path / name).write_text(text)
    said = contourlab("check", name)
    assert said.code == (0 if text.startswith("(") else 2)
    assert said.out.rstrip().endswith(f"next: contourlab check {name} --dialect {dialect}")
    again = contourlab("check", name, "--dialect", dialect)
    assert again.code == 0
    assert ("CL477" in again.out) == (dialect in ("fanuc", "mach3"))
    assert f"--dialect {dialect}" in again.out.splitlines()[-1]  # and the run that is proposed then


def test_check_proposes_the_named_dialect_if_the_faults_are_as_many_there(contourlab: Run, tmp_path: Path) -> None:
    said = contourlab("check", write(tmp_path, "(Post Processor: grbl_post)\nG1 X1\nM2\n"))
    assert said.code == 2
    assert said.out.rstrip().endswith("next: contourlab check part.ngc --dialect grbl")


def test_a_program_without_a_dialect_of_its_own_gets_no_proposal(contourlab: Run, tmp_path: Path) -> None:
    write(tmp_path, "G41 D1\nG0 X1\nM2\n")
    assert "--dialect" not in contourlab("check", "part.ngc").out
    notes = contourlab("canon", write(tmp_path, "G0 X1.\nM2\n"), "--dialect", "fanuc").err
    assert "CL477" in notes
    assert notes.endswith("\n")
    assert max(map(len, notes.splitlines())) <= 80


@pytest.mark.parametrize(
    "text", ["N10 G54\nN20 TRANS X10 Y5\n", "0 BEGIN PGM A MM\n1 L X+10 R0 FMAX\n", "G21\nM104 S200\nG1 X10 E0.5 F1800\n"]
)
def test_another_language_is_refused_once(contourlab: Run, tmp_path: Path, text: str) -> None:
    for command in ("check", "canon"):
        said = contourlab(command, write(tmp_path, text)).refusal
        assert said.count("\n") == 1 and "[CL800]" in said and "a program for a" in said


def test_check_finds_every_fault(contourlab: Run, tmp_path: Path) -> None:
    said = contourlab("check", write(tmp_path, FAULTY))
    assert said.code == 2
    for place, code in (("2:7", "CL811"), ("5:10", "CL808"), ("8:1", "CL808")):
        (line,) = (line for line in said.out.splitlines() if line.startswith(f"part.ngc:{place}: "))
        assert line.endswith(f" [{code}]")
        assert code in contourlab("explain", code).answer
    assert "3 faults" in said.out


def test_a_part_that_is_too_large_is_fitted_on_request(contourlab: Run, tmp_path: Path) -> None:
    write(tmp_path, LARGE)
    refused = contourlab("run", "part.ngc", *ON_XYZ)
    assert refused.code == 2
    assert "axis x" in refused.err and "1000 mm" in refused.err
    said = contourlab("run", "part.ngc", *ON_XYZ, "--fit")
    assert said.code == 0, said.err
    assert " 0.294" in said.out
    result = Result.load(tmp_path / "results" / "signals" / "base.nc")
    reference = np.asarray(result["reference"])
    # 1000 mm of x fit into 98 % of 300 mm; y keeps the same scale.
    assert np.ptp(reference[:, 0]) == pytest.approx(0.294, abs=1e-6)
    assert np.ptp(reference[:, 1]) == pytest.approx(0.294 * 0.27, abs=1e-6)
    assert json.loads((tmp_path / "results" / "summary.json").read_text(encoding="utf-8"))["notes"]


def test_fit_leaves_alone_what_fits(contourlab: Run, tmp_path: Path) -> None:
    said = contourlab("run", write(tmp_path, "G21 F1000\nG1 X5\nM2\n"), *ON_XYZ, "--fit")
    assert said.code == 0, said.err
    assert "fitted" not in said.out.lower()
