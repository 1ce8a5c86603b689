"""Spelling, comments, framing, files."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from each import each
from refusals import refuses

from contourlab.errors import ProgramError
from contourlab.program import Dwell, Reader, Reading, Traverse, parse_program, read_program

TO_TEN = (Traverse((0.0, 0.0, 0.0), (0.01, 0.0, 0.0), 1),)


@each(
    "line",
    [
        "G0 X10", "g0x10", "G00X10.", "G 0 X 1 0", "G0\tX1\t0", "  G0 X+10  ", "G0.0 X010.000", "G0 X + 1 0 .", "X10G0",
        "N10 G0 X10", "n 1 0 G0 X10", "N10.5 G0 X10", "N99999999 G0 X10", "G0 (to ten) X10", "(a)G0(b)(c)X10(d)",
        "G0 X10 ; X20", "G0 X10 ; (", "G0 X10 (; ) ", "G0 X10 (% / # [ O100 )", "G0 X10;", "G0 X10 ()",
        "(MSG, hello) G0 X10", "G0 X10 (Fräser \u2300 6)",
    ],
)  # fmt: skip
def test_spellings_of_the_same_move(line: str) -> None:
    assert parse_program(f"{line}\nM2").moves == TO_TEN


@pytest.mark.parametrize("end", ["M2", "M02", "m 2", "M30", "M2.0", "N5 M2 (done)"])
def test_ends(end: str) -> None:
    assert parse_program(f"G0 X10\n{end}").moves == TO_TEN


@pytest.mark.parametrize("text", ["%\nG0 X10\n%", "\n\n  % \nG0 X10\n%\nG0 X20\nM2", "%\nG0 X10\nM2\n%", "%\nG0 X10\nM2", "G0 X10\nM2\n%"])
def test_percent_frames_a_program(text: str) -> None:
    assert [move.end for move in parse_program(text).moves] == [(0.01, 0.0, 0.0)]  # type: ignore[union-attr]


@pytest.mark.parametrize("text", ["G0 X10\nM2\n", "G0 X10\r\nM2\r\n", "G0 X10\rM2\r", "G0 X10\nM2"])
def test_line_breaks(text: str) -> None:
    program = parse_program(text)
    assert program.moves == TO_TEN
    assert program.lines == ("G0 X10", "M2")


def test_source_lines_count_every_line() -> None:
    program = parse_program("(head)\n\nG0 X1\n; more\n\nX2\nM2")
    assert [move.source_line for move in program.moves] == [3, 6]
    assert [program.lines[move.source_line - 1] for move in program.moves] == ["G0 X1", "X2"]


def test_other_separators_do_not_shift_line_numbers() -> None:
    program = parse_program("(a\u2028b\x0cc\x85d)\nG0 X1\nM2")
    assert program.moves[0].source_line == 2


def test_require_end_can_be_waived() -> None:
    assert parse_program("G0 X10", require_end=False).moves == TO_TEN
    assert parse_program("%\nG0 X10", require_end=False).moves[0].source_line == 2


@pytest.mark.parametrize(
    ("content", "encoding"),
    [("(Fräser) G0 X10\nM2", "utf-8"), ("(Fräser) G0 X10\nM2", "latin-1"), ("G0 X10\nM2", "utf-8-sig")],
)
def test_encodings(tmp_path: Path, content: str, encoding: str) -> None:
    file = tmp_path / "part.ngc"
    file.write_bytes(content.encode(encoding))
    program = read_program(file)
    assert program.moves == TO_TEN
    assert program.name == "part.ngc"
    assert program.lines == tuple(content.split("\n"))


def test_errors_name_the_file_as_given(tmp_path: Path) -> None:
    file = tmp_path / "part.ngc"
    file.write_text("G0 X1\nG41 X2\n")
    with pytest.raises(ProgramError) as caught:
        read_program(file)
    assert (caught.value.file, caught.value.line, caught.value.column) == (str(file), 2, 1)
    assert str(caught.value).startswith(f"{file}:2:1: G41 ")


def test_unreadable_files(tmp_path: Path) -> None:
    for place in (tmp_path / "missing.ngc", tmp_path, "nul\0byte"):
        with refuses(ProgramError, "read", file=str(place), line=0):
            read_program(place)


def test_a_reader_reads_only_as_far_as_needed() -> None:
    read: list[int] = []

    def lines() -> Iterator[str]:
        for number in range(1, 1000):
            read.append(number)
            yield f"G0 X{number}\n"

    moves = Reader(lines(), reading=Reading(require_end=False)).moves()
    assert [next(moves).source_line for _ in range(3)] == [1, 2, 3]
    assert read == [1, 2, 3]


def test_a_dwell_is_stored_in_seconds() -> None:
    assert parse_program("G4 P0.25\nG20 G0 X1\nG4 P1.5\nM2").moves[::2] == (Dwell(0.25, 1), Dwell(1.5, 3))
