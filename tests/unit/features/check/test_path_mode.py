"""A program that leaves the path mode to the control: check and run say what they assumed."""

from __future__ import annotations

from pathlib import Path

import pytest

from contourlab.features.check.program_check import check
from contourlab.features.limits.command import limits
from contourlab.features.run.outcome import run_case
from contourlab.findings import Finding
from contourlab.scenario import parse_scenario, scenario_from_parts

CASES = [
    ("G1 X5\nG1 Y5\n", {"CL110": (2, None)}),
    ("G0 X1 Z1\nG61\nG1 X5\n", {}),
    ("G0 X1\nG64 P0.02\nG1 X5\nG1 Y5\nG61.1\nG1 X2\n", {}),
    ("G0 X1\nG64\nG1 X5\nG4 P0\nG2 X2 Y2 R20\n", {"CL111": (4, 1e-5)}),
    ("G1 X5\nG64 G1 Y5\nG64 P0.01\nX1\nG64\nX2\n", {"CL110": (2, None), "CL111": (3, 1e-5)}),
    ("G64\nG0 X1\nG61 G1 X3\n", {}),
]


def assumed(findings: tuple[Finding, ...]) -> dict[str, tuple[int, float | None]]:
    return {one.code: (one.values["line"], one.values.get("tolerance")) for one in findings if one.code in ("CL110", "CL111")}


LINES = [
    ("G1 X5\nG1 Y5\n", {"CL110": ["2-3"]}),
    ("G64\nG1 X5\n(nothing)\nG0 Z1\nG1 X6\nG61\nG1 X1\nG64\nX2\nG64 P1 X3\nG64\nX4\n", {"CL111": ["3-6", "10", "13"]}),
    ("#1=0\nO1 while [#1 LT 3]\nG64 G1 X1\nG61 X2\nX3\nG64 X4\n#1=[#1+1]\nO1 endwhile\n", {"CL111": ["4", "7"]}),
    ("G1 X1\nG64\n" + "X2\nX1\n" * 30, {"CL110": ["2"], "CL111": ["4-63"]}),
]


@pytest.mark.parametrize(("moves", "expected"), LINES)
@pytest.mark.parametrize("size", [1, 7, 2500])
def test_all_lines_are_named(
    moves: str, expected: dict[str, list[str]], size: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In parts of any size, from loops too; lines that cut nothing do not divide a stretch."""
    monkeypatch.setattr("contourlab.features.check.program_check.PART", size)
    part = program(tmp_path, moves)
    for found in (check(part, machine="xyz").findings, limits(part, machine="xyz").findings):
        assert {one.code: one.values["lines"] for one in found if one.code in ("CL110", "CL111")} == expected


def program(folder: Path, moves: str) -> Path:
    (folder / "part.ngc").write_text(f"G21 G90 F1200\n{moves}M2\n", encoding="ascii")
    return folder / "part.ngc"


@pytest.mark.parametrize(("moves", "expected"), CASES)
@pytest.mark.parametrize("size", [1, 2500])
def test_check_says_what_it_assumed(
    moves: str, expected: dict[str, tuple[int, float | None]], size: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("contourlab.features.check.program_check.PART", size)
    found = check(program(tmp_path, moves), machine="xyz").findings
    assert assumed(found) == expected and {one.entry.severity for one in found} <= {"info"}


@pytest.mark.parametrize(
    ("feed", "expected"),
    [
        ({}, {"CL110": (2, None), "CL111": (3, 1e-5)}),
        ({"corner_tolerance": "3 um"}, {"CL110": (2, None), "CL111": (3, 3e-6)}),
        ({"path_control": "exact_path"}, {}),
        ({"path_control": "blend"}, {}),
    ],
)
def test_run_says_what_it_assumed(feed: dict[str, str], expected: dict[str, tuple[int, float | None]], tmp_path: Path) -> None:
    part = program(tmp_path, CASES[4][0])
    assert assumed(run_case(scenario_from_parts(part, "xyz", "xyz-controller", feed=feed).base, explain=False).findings) == expected


def test_a_contour_has_no_mode() -> None:
    text = 'machine = "builtin:xyz"\ncontroller = "builtin:xyz-controller"\ncontour = "circle"\n[feed]\nfeedrate = "9 m/min"\n'
    assert assumed(run_case(parse_scenario(text).base, explain=False).findings) == {}
