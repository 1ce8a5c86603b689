"""A program planned part by part: same motion, bounded parts."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import pytest

from contourlab.errors import ParameterError
from contourlab.features.check.program_check import Checked, check, parts
from contourlab.features.limits.command import limits
from contourlab.program import Reader, Reading
from contourlab.scenario import load_machine

STOPS = (
    "G21 G90 G61.1 F1200 T1 M6 S900 M3\nG0 X10\nG1 X20\nG4 P0.5\nG4 P0.25\nG1 Y10\nM5\nG1 X30\nG3 X40 I5\nG0 Z5\nG0 Z0\n"
    "G1 X0\nT2 M6\nG1 X5\nG4 P0.125\nM2\n"
)
ROUND = "G21 G64 P0.05 F3000\n" + "".join(f"G1 X{math.cos(0.01 * i):.5f} Y{math.sin(0.01 * i):.5f}\n" for i in range(1000)) + "M2\n"


def checked(folder: Path, text: str) -> Checked:
    file = folder / "part.ngc"
    file.write_text(text, encoding="utf-8")
    return check(file)


def test_parts_between_stops_change_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = checked(tmp_path, STOPS)
    for size in (1, 2, 3, 5):
        monkeypatch.setattr("contourlab.features.check.program_check.PART", size)
        found = checked(tmp_path, STOPS)
        for name in ("cycle_time", "dwell", "length", "feed_time_without_acceleration"):
            assert getattr(found, name) == pytest.approx(getattr(whole, name), rel=1e-9), (size, name)
        same = {name: getattr(whole, name) for name in ("cycle_time", "dwell", "length", "feed_time_without_acceleration")}
        assert replace(found, **same) == whole
    assert whole.dwell == 0.875
    assert whole.added_stops == 0


def test_a_long_run_is_cut(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = checked(tmp_path, ROUND)
    monkeypatch.setattr("contourlab.features.check.program_check.PART", 100)
    cut = checked(tmp_path, ROUND)
    assert (whole.added_stops, cut.added_stops) == (0, 4)
    assert whole.cycle_time is not None
    assert cut.cycle_time is not None
    assert 0.0 < cut.cycle_time - whole.cycle_time < 4 * 0.5
    assert cut.length == pytest.approx(whole.length)
    reader = Reader(ROUND.split("\n"), reading=Reading())
    assert [len(part.program.moves) for part in parts(reader, [])] == [200] * 5


def test_lines_after_the_end_are_counted(tmp_path: Path) -> None:
    assert checked(tmp_path, "G0 X1\nM2\nthis\nthat\n").n_line == 4
    found = checked(tmp_path, "G0 X1\n" + 250_000 * "X1" + "\nM2\n")
    assert (found.n_line, found.problems[0].line, found.moves) == (3, 2, {"traverse": 1})


def test_a_machine_is_a_file_or_an_object(tmp_path: Path) -> None:
    named, machine = checked(tmp_path, STOPS), load_machine("builtin:xyz")
    given = check(tmp_path / "part.ngc", machine=machine)
    assert given.machine == {"name": named.machine["name"], "file": ""}
    assert (given.cycle_time, given.box, given.findings) == (named.cycle_time, named.box, named.findings)
    words, given_limits = limits(tmp_path / "part.ngc", machine="xyz"), limits(tmp_path / "part.ngc", machine=machine)
    assert given_limits.rows == words.rows and given_limits.passed is words.passed
    with pytest.raises(ParameterError):
        check(tmp_path / "part.ngc", machine=machine.axes[0])  # type: ignore[arg-type]
