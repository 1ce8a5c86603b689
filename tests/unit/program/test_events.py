"""Program events besides motion are kept in the order of execution and move nothing."""

from __future__ import annotations

from dataclasses import replace

import pytest

from contourlab.errors import ProgramError
from contourlab.program import Program, parse_program
from contourlab.program.moves import PLAIN, Event


def read(text: str) -> Program:
    return parse_program(f"G21 F100\n{text}\nG1 X1\nM2")


def words(text: str) -> list[tuple[str, float | None]]:
    return [(event.word, event.value) for event in read(text).events]


def test_a_block_is_executed_in_its_own_order() -> None:
    """Speed, tool, tool change, spindle, coolant, overrides; the pause follows the motion."""
    assert words("M49 M8 M3 M6 T2 S300 M0") == [
        ("S", 300.0),
        ("T", 2.0),
        ("M6", None),
        ("M3", None),
        ("M8", None),
        ("M49", None),
        ("M0", None),
    ]
    program = read("M0 G1 X5\nM1")
    # Each event is attached to the number of moves made so far.
    assert program.events == (Event("M0", None, 2, after=1), Event("M1", None, 3, after=1))
    assert [move.end for move in program.moves] == [(0.005, 0.0, 0.0), (0.001, 0.0, 0.0)]  # type: ignore[union-attr]


@pytest.mark.parametrize("code", ["M50", "M51", "M52", "M53"])
def test_overrides_accept_a_p_word(code: str) -> None:
    assert words(f"{code} P0") == [(code, 0.0)] and words(code) == [(code, None)]


@pytest.mark.parametrize("idle", ["G40", "G49", "G54", "G59.3", "G80", "G97 S50", "G98", "G99", "G40 G49 G80 G54", "M5 M9"])
def test_words_without_an_effect_on_the_path(idle: str) -> None:
    plain, with_it = read("G0 Y2\n"), read(f"G0 Y2\n{idle}")
    assert with_it.moves == plain.moves


@pytest.mark.parametrize("control", ["G61", "G61.1", "G64", "G64 P0.01 Q0.02"])
def test_path_control_changes_only_the_mode(control: str) -> None:
    plain, with_it = read("G0 Y2\n"), read(f"G0 Y2\n{control}")
    assert with_it.moves[1].mode.control is not None  # type: ignore[union-attr]
    assert tuple(replace(move, mode=PLAIN) for move in with_it.moves) == plain.moves  # type: ignore[call-arg]


def test_tolerances_of_g64() -> None:
    """Joined lines use P if there is no Q; the lengths are in the current units."""
    moves = parse_program("F9 G64 P0.1 Q0.02 G1 X1\nG64 P0.1 X2\nG20 G64 P1 X3\nG64 X4\nG61 X5\nM2").moves
    found = [(move.mode.control, move.mode.tolerance, move.mode.merge) for move in moves]  # type: ignore[union-attr]
    assert found == [
        ("blend", 0.0001, 0.02 / 1000.0),
        ("blend", 0.0001, 0.0001),
        ("blend", 0.0254, 0.0254),
        ("blend", None, None),
        ("exact_path", None, None),
    ]


def test_g80_ends_the_modal_motion_and_yields_to_another() -> None:
    assert read("G80 G1 X3").moves == read("G1 X3").moves


def test_an_m2_ends_the_program_and_an_m0_does_not() -> None:
    assert len(parse_program("G0 X1\nM0\nX2\nM1\nX3\nM2\nX4").moves) == 3


@pytest.mark.parametrize(("words", "column"), [("M19 R400", 5), ("M19 R-1", 5), ("M19 R90 P3", 9), ("M19 P0.5", 5)])
def test_spindle_orientation_is_limited(words: str, column: int) -> None:
    with pytest.raises(ProgramError, match="M19") as caught:
        read(words)
    assert (caught.value.line, caught.value.column) == (2, column)
    assert read("M19 R90 P2").events[0].word == "M19"
