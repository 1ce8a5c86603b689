"""Reading: the grbl dialect with its notices, reserved names of the interpreter, and the modal state."""

from __future__ import annotations

import re

import pytest
from each import each
from refusals import refuses

from contourlab.errors import ParameterError, ProgramError
from contourlab.program import Dwell, Feed, Reader, Reading, parse_program
from contourlab.program.moves import Notice

GRBL = Reading(dialect="grbl")


@pytest.mark.parametrize(
    ("text", "line", "column", "message"),
    [
        ("G1 F10 X1", 1, 1, "no end"),
        ("$H\nG0 X1\nM2", 1, 1, r"\$H"),
        ("G0 X1\n!\nM2", 2, 1, "!"),
        ("G0 X1\n%\nM2", 2, 1, "%"),
        ("G0 X1 (to one\nM2", 1, 7, "comment"),
        ("(a) Y1 X1\nM2", 1, 5, "motion code"),
        ("X1 (then G0)\nM2", 1, 1, "motion code"),
    ],
)
def test_each_tolerated_deviation_gives_a_notice(text: str, line: int, column: int, message: str) -> None:
    notices = parse_program(text, reading=GRBL).notices
    assert len(notices) == 1
    assert (notices[0].line, notices[0].column) == (line, column)
    assert isinstance(notices[0], Notice)
    assert re.search(message, notices[0].message)
    with pytest.raises(ProgramError):
        parse_program(text)


@pytest.mark.parametrize("text", ["G0 X1 ; see (note\nM2", "G0 X1 (a) Y2\nM30", "%\nG0 X1\n%", "G28\nG0 X1\nM2", "G92 X0\nG0 X1\nM2"])
def test_programs_valid_for_linuxcnc_give_no_notice(text: str) -> None:
    lenient = parse_program(text, reading=GRBL)
    assert lenient.notices == ()
    assert lenient.moves == parse_program(text).moves


def test_grbl_does_not_hide_errors() -> None:
    for text, column in (("G0 X1 (a (b) c)\nM2", 10), ("G0 X1 Q5\nM2", 7), ("G0 X\nM2", 4), ("G0 X1 )\nM2", 7)):
        with pytest.raises(ProgramError) as caught:
            parse_program(text, reading=GRBL)
        assert (caught.value.line, caught.value.column) == (1, column)


def test_an_unknown_dialect() -> None:
    with pytest.raises(ParameterError, match=r"'haas'.*linuxcnc, grbl, grblhal, fanuc, mach3"):
        Reading(dialect="haas")  # type: ignore[arg-type]


@each(
    "lines, name, value",
    [
        ("G20", "_metric", 0), ("G20", "_imperial", 1), ("G18", "_plane", 180), ("G55", "_coord_system", 550),
        ("G59.3", "_coord_system", 593),
        ("G91", "_incremental", 1), ("G91", "_absolute", 0), ("G93", "_inverse_time", 1), ("G95", "_units_per_rev", 1),
        ("G90.1", "_ijk_absolute_mode", 1), ("G7", "_lathe_diameter_mode", 1), ("M4", "_spindle_on", 1), ("M4", "_spindle_cw", 0),
        ("S250", "_rpm", 250), ("F90", "_feed", 90), ("G43.1 Z1", "_tool_offset", 1), ("T4 M6", "_current_tool", 4),
        ("T4", "_selected_tool", 4),
        ("G98", "_retract_old_z", 1), ("G99", "_retract_r_plane", 1), ("G1 F9 X2", "_motion_mode", 10), ("", "_motion_mode", 800),
        ("G1 F9 X2", "_x", 2),
        ("G10 L2 P1 X5\nG1 F9 X2", "_x", 2), ("G10 L2 P1 X5\nG1 F9 X2", "_abs_x", 7), ("", "_line", 2), ("", "_call_level", 0),
    ],
)  # fmt: skip
def test_predefined_parameters(lines: str, name: str, value: float) -> None:
    reader = Reader(f"{lines}\n#100 = #<{name}>\nG21 G0 Y9\nM2".split("\n"))
    list(reader.moves())
    assert reader.parameters.number(100) == value
    with refuses(ProgramError, f"#<{name}>", line=1, column=2):
        parse_program(f"#<{name}> = 1\nM2")


def test_a_reader_gives_the_modal_state_after_each_move() -> None:
    reader = Reader(["G21 F60", "G1 X1", "F120", "G1 X1", "X2", "M2"], still=True)
    found = [(move.source_line, reader.state.feedrate, reader.state.position[0]) for move in reader.moves()]
    assert found == [(2, 0.001, 0.001), (4, 0.002, 0.001), (5, 0.002, 0.002)]


# The order of execution, except for what test_program_order.py covers.


def ends(text: str) -> list[tuple[float, ...]]:
    return [tuple(round(1e3 * v, 9) for v in move.end) for move in parse_program(f"{text}\nM2").moves]  # type: ignore[union-attr]


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("G10 L2 P2 X5\nG0 X1 G55", [(6, 0, 0)]),  # coordinate system before motion
        ("G10 L1 P3 Z5\nG0 Z1 G43 H3", [(0, 0, 6)]),  # tool length before motion
        ("G0 X1 G91 G90.1\nX1", [(1, 0, 0), (2, 0, 0)]),
        ("G0 X1\n#1 = 5 X#1\nX#1", [(1, 0, 0), (0, 0, 0), (5, 0, 0)]),  # a line uses parameters from before the line
        ("G0 X5 G21\nG10 L2 P1 X1 G20", [(5, 0, 0)]),
        ("G0 X#5420\nX[#5420 + 1]\nX[#5420 + 1]", [(1, 0, 0), (2, 0, 0)]),
    ],
)
def test_order_within_a_line(text: str, wanted: list[tuple[float, ...]]) -> None:
    assert ends(text) == wanted


def test_units_apply_to_the_offsets_of_their_line() -> None:
    assert ends("G10 L2 P1 X1 G20\nG21 G0 X0 Y1") == [(25.4, 1, 0)]


def test_a_pause_follows_the_motion_and_other_events_precede_it() -> None:
    program = parse_program("F60 M0 M3 S9 G1 X1\nM2")
    assert [event.word for event in program.events] == ["S", "M3", "M0"]


def test_inverse_time_is_one_over_the_minutes() -> None:
    """5 mm at F2 take half a minute; the next move has its own F; G94 needs a new feedrate."""
    moves = parse_program("G93\nG1 X3 Y4 F2\nX0 Y0 F1\nG94 F60\nX1\nM2").moves
    assert [round(6e4 * m.feedrate, 9) for m in moves if isinstance(m, Feed)] == [10.0, 5.0, 60.0]
    with pytest.raises(ProgramError, match=r"G1\b.*G93\b.*\bF\b"):
        parse_program("G93\nG1 X3 F2\nX4\nM2")


def test_inverse_time_is_never_slower_than_a_tenth_per_minute() -> None:
    """As in LinuxCNC, in the units of the program."""
    moves = parse_program("G93\nG1 X0.001 F2\nG20 G1 X0.001 F2\nM2").moves
    assert [m.feedrate for m in moves if isinstance(m, Feed)] == pytest.approx([1e-4 / 60.0, 2.54e-3 / 60.0])


def test_feed_per_turn_needs_a_speed() -> None:
    moves = parse_program("G95 F0.5 S120\nG1 X1\nM2").moves
    assert [round(6e4 * m.feedrate, 9) for m in moves if isinstance(m, Feed)] == [60.0]
    with refuses(ProgramError, "spindle", line=2):
        parse_program("G95 F0.5\nG1 X1\nM2")


@pytest.mark.parametrize(("still", "wanted"), [(True, [0.0, 0.5]), (False, [0.5])])
def test_a_dwell_of_no_time_is_kept_with_the_moves_of_no_length(still: bool, wanted: list[float]) -> None:
    reader = Reader(["G4 P0", "G4 P0.5", "G0 X1", "M2"], still=still)
    assert [move.seconds for move in reader.moves() if isinstance(move, Dwell)] == wanted
    assert [(event.word, event.source_line) for event in reader.state.events] == [("G4", 1)]
