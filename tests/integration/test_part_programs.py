"""`contourlab canon` and `contourlab check`, and programs fitted into the travel of a machine, as typed."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest
from schemas import validator
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


def test_canonical_moves_as_json(contourlab: Run, tmp_path: Path) -> None:
    said = contourlab("canon", write(tmp_path, PROGRAM), "--json")
    assert validator("canon").is_valid(json.loads(said.out))
    assert (said.code, said.err) == (0, "")
    rapid, feed, arc, dwell, home = json.loads(said.out)["moves"]
    # G55 has its origin at (10, 20) and is rotated by 90 degrees: its X is the machine's Y.
    assert rapid["kind"] == "traverse"
    assert rapid["end"] == [10.0, 21.0, 0.0]
    assert feed["start"] == rapid["end"]
    assert feed["end"] == [8.0, 21.0, 0.0]
    assert feed["feed"] == 600.0
    assert (feed["path_mode"], feed["blend_tol"], feed["line"]) == ("continuous", 0.05, 4)
    assert arc["plane"] == "XY"
    assert arc["centre"] == [8.0, 23.0, 0.0]
    assert arc["turns"] == -1
    assert arc["end"] == [6.0, 23.0, 0.0]
    assert dwell == {"kind": "dwell", "seconds": 0.25, "line": 6}
    assert home["end"] == [0.0, 0.0, 0.0]
    assert (home["path_mode"], home["blend_tol"]) == ("exact_path", None)


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


def test_check_finds_every_fault(contourlab: Run, tmp_path: Path) -> None:
    said = contourlab("check", write(tmp_path, FAULTY))
    assert said.code == 2
    for place in ("part.ngc:2:7: no active code uses Q", "part.ngc:5:10: W (secondary axis)", "part.ngc:8:1: G41 (cutter compensation)"):
        assert said.out.count(place) == 1, said.out
    assert "3 faults" in said.out


def test_check_describes_a_program(contourlab: Run, tmp_path: Path) -> None:
    text = "G21 G90 T2 M6 S3000 M3 F1200\nG0 X-100\nG1 X20\nG3 X20 I-10\nG4 P0.5\nM2\n"
    said = contourlab("check", write(tmp_path, text), "--json")
    assert said.code == 0, said.out
    found = json.loads(said.out)
    assert found["moves"] == {"traverse": 1, "feed": 1, "arc": 1, "dwell": 1}
    assert found["box"]["x"] == pytest.approx([-0.1, 0.02], abs=1e-12)
    assert found["box"]["y"] == pytest.approx([-0.01, 0.01], abs=1e-12)
    assert found["length"]["feed"] == pytest.approx(0.12 + 0.02 * math.pi)
    assert found["feeds_mm_per_min"] == [1200.0]
    assert (found["tools"], found["spindle_speeds"]) == ([2], [3000.0])
    # Rapids at 0.2 m/s, feed at 20 mm/s, a dwell; acceleration adds more time.
    least = 0.1 / 0.2 + found["length"]["feed"] / 0.02 + 0.5
    assert least < found["cycle_time"] < least + 1.0
    assert found["problems"] == found["notices"] == []
    assert [one["code"] for one in found["findings"]] == ["CL110"]


def test_check_knows_the_travel(contourlab: Run, tmp_path: Path) -> None:
    said = contourlab("check", write(tmp_path, LARGE))
    assert said.code == 0
    assert "CL471 info: " in said.out


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


@pytest.mark.parametrize("text", ["M2\n", "(nothing)\nG21\nM2\n"])
def test_a_program_without_moves_gives_an_empty_document(contourlab: Run, tmp_path: Path, text: str) -> None:
    said = contourlab("canon", write(tmp_path, text), "--json")
    assert (said.code, json.loads(said.out)) == (0, {"moves": []})


def test_travel_is_a_fault_on_a_given_machine(contourlab: Run, tmp_path: Path) -> None:
    file = write(tmp_path, "G1 F100 X5000\nM2\n")
    said = contourlab("check", file)
    assert said.code == 0 and "CL471" in said.out
    held = contourlab("check", file, "--machine", "xyz")
    assert held.code == 2 and "CL470" in held.out
