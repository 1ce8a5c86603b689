"""Frozen answers: the moves that LinuxCNC's interpreter made of our own programs, which together cover the language."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import pytest

from contourlab.program import Arc, Dwell, Feed, Reader, Reading, Spline, Traverse

FOLDER = Path(__file__).parent / "programs"
PROGRAMS = sorted(FOLDER.glob("*.ngc"))
KINDS = {Traverse: "traverse", Feed: "feed", Arc: "arc", Dwell: "dwell"}


def frozen(file: Path) -> list[dict[str, Any]]:
    moves: list[dict[str, Any]] = json.loads(file.with_suffix(".json").read_text(encoding="utf-8"))
    return moves


def tip(point: tuple[float, float, float], tool: tuple[float, float, float]) -> list[float]:
    return [1e3 * (value - offset) for value, offset in zip(point, tool, strict=True)]


@pytest.mark.parametrize("file", PROGRAMS, ids=lambda path: path.stem)
def test_the_moves_are_those_of_linuxcnc(file: Path) -> None:
    """Ends and centres are those of the tool's tip [mm]; a spline is given by the vertices of its chords."""
    theirs = frozen(file)
    with file.open(encoding="utf-8") as lines:
        for move in Reader(lines, file, Reading(), still=True).moves():
            if isinstance(move, Spline):
                end = tip(move.end, move.mode.tool)
                while math.dist(theirs[0]["end"], end) > 1e-6:
                    assert theirs.pop(0)["kind"] == "feed"
                theirs.pop(0)
                continue
            other = theirs.pop(0)
            assert KINDS[type(move)] == other["kind"], (move, other)
            if isinstance(move, Dwell):
                assert move.seconds == pytest.approx(other["seconds"])
                continue
            assert tip(move.end, move.mode.tool) == pytest.approx(other["end"], abs=1e-8), (move, other)
            if isinstance(move, Feed | Arc):
                assert 6e4 * move.feedrate == pytest.approx(other["feed"], rel=1e-9), (move, other)
            if isinstance(move, Arc):
                assert move.turns == other["turns"]
                gap = [a - b for a, b in zip(tip(move.centre, move.mode.tool), other["centre"], strict=True)]
                for unit in move.directions()[:2]:
                    assert sum(g * u for g, u in zip(gap, unit, strict=True)) == pytest.approx(0.0, abs=1e-8), (move, other)
    assert not theirs


def test_all_answers_are_there() -> None:
    assert len(PROGRAMS) >= 12
    assert {file.stem for file in PROGRAMS} == {file.stem for file in FOLDER.glob("*.json")}
