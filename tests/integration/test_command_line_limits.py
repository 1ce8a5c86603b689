"""`contourlab limits` as typed, and annotated programs."""

from __future__ import annotations

import json
import math
import shlex
from pathlib import Path
from typing import Any

import made_circles
import numpy as np
import pytest
from reference_data import SHARED, part_programs

from contourlab.cli.main import main
from contourlab.errors import ProgramError
from contourlab.features.check.canon import Listed
from contourlab.program import Reading

PROGRAM = "G21 G90 G17 G61\nG0 X10 Y0\n(a comment)\nG1 X30 F1200 ; cut\nG3 X30 Y0 I-30 J0\nM2\n"


@pytest.fixture(autouse=True)
def _folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("part.ngc").write_text(PROGRAM, encoding="ascii")


def printed(capsys: pytest.CaptureFixture[str], *words: str, code: int = 0) -> dict[str, Any]:
    assert main([*words, "--json"]) == code
    result: dict[str, Any] = json.loads(capsys.readouterr().out)
    return result


def moves_of(program: Path, reading: Reading) -> list[dict[str, Any]]:
    return list(Listed(program, reading))


def write_sine(file: str, digits: int = 6) -> None:
    """Write a sine of 20 mm at 2 Hz in mm, with program lines."""
    time = 1e-3 * np.arange(2000)
    position = 20.0 * np.sin(4.0 * math.pi * time)
    table = np.column_stack([time, position, np.where(time < 1.0, 4, 5)])
    np.savetxt(file, table, fmt=["%.4f", f"%.{digits}f", "%d"], delimiter=",", header="time [s],reference.x [mm],line", comments="")


def test_a_plan_keeps_the_limits_of_its_machine(capsys: pytest.CaptureFixture[str]) -> None:
    result = printed(capsys, "limits", "part.ngc")
    assert result["passed"] and result["source"] == "plan"
    assert max(peak["use"] for peak in result["peaks"] if peak["kind"] == "jerk") == pytest.approx(1.0, abs=0.01)
    assert [row["line"] for row in result["lines"]] == [2, 4, 5]
    assert sum(row["duration"] for row in result["lines"]) == pytest.approx(result["cycle_time"], abs=2e-3)


def test_a_plan_within_the_limits_given(capsys: pytest.CaptureFixture[str]) -> None:
    """Without a machine; a straight line in closed form: velocity, then acceleration and jerk reach their limits."""
    Path("line.ngc").write_text("G21 G90 G61\nG1 X400 F12000\nM2\n", encoding="ascii")
    limits = ("--acceleration", "1 m/s^2", "--jerk", "x=10 m/s^3")
    result = printed(capsys, "limits", "line.ngc", *limits)
    assert (result["planned_within"], result["given"]) == ("given", ["acceleration", "jerk"])
    largest = {peak["kind"]: peak for peak in result["peaks"] if peak["axis"] == "x"}
    assert largest["acceleration"]["value"] == pytest.approx(1.0, rel=1e-3) and largest["jerk"]["value"] == pytest.approx(10.0, rel=1e-3)
    assert all(peak["use"] <= 1.0 + 1e-6 for peak in result["peaks"] if peak["use"] is not None)
    assert result["cycle_time"] == pytest.approx(0.4 / 0.2 + 0.2 / 1.0 + 1.0 / 10.0, abs=3e-3)  # s/v + v/a + a/j
    on_machine = printed(capsys, "limits", "line.ngc", "--machine", "xyz", *limits, code=2)  # its travel ends at 150 mm
    assert "CL470" in {found["code"] for found in on_machine["findings"]}
    assert (on_machine["planned_within"], on_machine["given"]) == ("machine", ["acceleration", "jerk"])
    assert max(peak["use"] for peak in on_machine["peaks"] if peak["kind"] == "acceleration") == pytest.approx(1.5, rel=0.01)
    main(["limits", "line.ngc", *limits])
    following = shlex.split(capsys.readouterr().out.splitlines()[-1].removeprefix("next: contourlab "))
    assert following == ["limits", "line.ngc", *limits, "--annotate", "line-annotated.ngc"]


def test_a_plan_against_other_limits(capsys: pytest.CaptureFixture[str]) -> None:
    result = printed(capsys, "limits", "part.ngc", "--machine", "xyz", "--acceleration", "x=0.5 m/s^2", code=1)
    over = [peak for peak in result["peaks"] if (peak["use"] or 0.0) > 1.005]
    assert {(peak["axis"], peak["kind"]) for peak in over} >= {("x", "acceleration")} and {peak["axis"] for peak in over} == {"x"}
    assert "CL472" in {found["code"] for found in result["findings"]}
    assert printed(capsys, "limits", "part.ngc", "--machine", "xyz", "--acceleration", "x=1.4 m/s^2", "--tolerance", "10 %")["passed"]


@pytest.mark.parametrize("digits", [6, 3])
def test_a_log_in_closed_form(digits: int, capsys: pytest.CaptureFixture[str]) -> None:
    write_sine("log.csv", digits)
    limits = ("--velocity", "300 mm/s", "--acceleration", "2 m/s^2", "--jerk", "100 m/s^3")
    result = printed(capsys, "limits", "log.csv", *limits, code=1)
    peaks = {peak["kind"]: peak for peak in result["peaks"]}
    omega = 4.0 * math.pi
    for order, kind in enumerate(("velocity", "acceleration", "jerk"), 1):
        assert peaks[kind]["value"] == pytest.approx(0.02 * omega**order, rel=0.08)
        assert peaks[kind]["value"] <= 0.02 * omega**order + peaks[kind]["resolution"] + 1e-9
    assert [peak["kind"] for peak in result["peaks"] if peak["use"] > 1.005] == ["acceleration"]
    assert {row["line"] for row in result["lines"]} == {4, 5}
    assert peaks["jerk"]["window"] == pytest.approx(6e-3 if digits == 6 else 0.03, rel=0.7)


def test_without_limits_there_is_no_verdict(capsys: pytest.CaptureFixture[str]) -> None:
    write_sine("log.csv")
    assert main(["limits", "log.csv"]) == 0
    out = capsys.readouterr().out
    assert out.splitlines()[-1] == "next: contourlab limits log.csv --machine xyz"
    assert max(map(len, out.splitlines())) <= 80


def test_a_log_with_its_program(capsys: pytest.CaptureFixture[str]) -> None:
    made_circles.write_log(Path("log.csv"), senses=(False,), x=8e-6)
    start = made_circles.positions(False)[0][0] * 1e3
    lines = [
        "G21 G90 G17",
        "G1 F3000 X0 Y0",
        f"X{start[0]:.6f} Y{start[1]:.6f}",
        f"G3 X{start[0]:.6f} Y{start[1]:.6f} I{-start[0]:.6f} J{-start[1]:.6f}",
    ]
    Path("circle.ngc").write_text("\n".join([*lines, "M2"]) + "\n", encoding="ascii")
    words = ("limits", "log.csv", "--program", "circle.ngc", "--velocity", "60 mm/s", "--annotate", "out.ngc")
    result = printed(capsys, *words)
    rows = {row["line"]: row for row in result["lines"]}
    assert rows[4]["duration"] == pytest.approx(2.0 * math.pi, rel=0.01) and rows[4]["error"] == pytest.approx(4e-6, rel=0.1)
    text = Path("out.ngc").read_text(encoding="ascii").splitlines()
    assert "error" in text[3] and text[4] == "M2"
    assert moves_of(Path("out.ngc"), Reading()) == moves_of(Path("circle.ngc"), Reading())


def test_annotations_keep_the_program(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["limits", "part.ngc", "--annotate", "out.ngc"]) == 0
    text = Path("out.ngc").read_text(encoding="ascii").splitlines()
    assert text[1].startswith("G0 X10 Y0 (0.000 s + ") and text[2] == "(a comment)" and text[3].startswith("G1 X30 F1200 ; cut (")
    assert moves_of(Path("out.ngc"), Reading()) == moves_of(Path("part.ngc"), Reading())


SLOW = ("3D_Chips", "8x_gear", "HSM_test", "heart.ngc", "flowsnake", "cds.ngc", "spiral", "vcarve", "tort", "butterfly")


@pytest.mark.parametrize(
    "name",
    [pytest.param(file.name, marks=[pytest.mark.slow] if any(word in file.name for word in SLOW) else []) for file in part_programs()],
)
def test_annotated_real_programs_have_the_same_moves(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    file = SHARED / "gcode" / name
    reading = Reading(require_end=False)
    try:
        moves = moves_of(file, reading)
    except ProgramError:  # rotary axis, cutter compensation, faults
        assert main(["limits", str(file), "--annotate", "out.ngc"]) == 2 and not Path("out.ngc").exists()
        return
    result = printed(capsys, "limits", str(file), "--annotate", "out.ngc")
    assert result["passed"] and result["lines"]
    original = file.read_bytes().splitlines()
    written = Path("out.ngc").read_bytes().splitlines()
    assert len(written) == len(original) and written != original
    assert moves_of(Path("out.ngc"), Reading(require_end=False, folder=file.parent)) == moves


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("none.csv",), "none.csv"),
        (("log.csv", "--velocity", "5"), "--velocity"),
        (("log.csv", "--jerk", "q=5 m/s^3"), "--jerk"),
        (("log.csv", "--annotate", "out.ngc"), "--program"),
        (("part.ngc", "--program", "part.ngc"), "--program"),
        (("part.ngc", "--annotate", "part.ngc"), "part.ngc"),
        (("log.csv", "--tolerance", "5 mm"), "--tolerance"),
    ],
)
def test_bad_input_is_one_line(words: tuple[str, ...], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    write_sine("log.csv")
    assert main(["limits", *words]) == 2
    error = capsys.readouterr().err.strip()
    assert said in error and len(error.splitlines()) == 1


def test_each_chord_of_a_fitted_circle_keeps_its_line(capsys: pytest.CaptureFixture[str]) -> None:
    angle = np.linspace(0.0, 2.0 * math.pi, 73)
    chords = [f"X{10.0 * math.cos(a):.4f} Y{10.0 * math.sin(a):.4f}" for a in angle[1:]]
    Path("dense.ngc").write_text("\n".join(["G21 G90 G17 G64 P0.05", "G0 X10 Y0", "G1 F3000", *chords, "M2", ""]), encoding="ascii")
    found = printed(capsys, "limits", "dense.ngc")
    assert [row["line"] for row in found["lines"]] == [2, *range(4, 76)]
    durations = [row["duration"] for row in found["lines"][10:60]]
    assert max(durations) - min(durations) < 2.5 * found["servo_period"]
    rows = {row["line"]: row for row in found["lines"]}
    for peak in found["peaks"]:
        row = rows[peak["line"]]
        assert -1e-9 <= peak["time"] - row["start"] <= row["duration"]
    run = printed(capsys, "run", "dense.ngc", "--machine", "xyz", "--controller", "xyz-controller", "--tolerance", "1 mm")
    ((scheme,),) = (run["schemes"].values(),)
    worst, of_chord = scheme["verdict"]["worst"], 2e-2 * math.sin(math.pi / 72)
    assert worst["line"] == 4 + math.floor((worst["arc_length"] - 0.01) / of_chord)
    assert worst["text"] == chords[worst["line"] - 4]
