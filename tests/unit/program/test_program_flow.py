"""O-words, M98 and M99: the executed lines, their repetitions, and messages for mismatches."""

from __future__ import annotations

import re
import time
import tracemalloc
from collections.abc import Iterator
from pathlib import Path

import pytest
from each import each
from refusals import refuses

from contourlab.errors import ParameterError, ProgramError
from contourlab.program import Dwell, Reader, Reading, open_program, parse_program, read_program
from contourlab.program.flow import LONGEST_LINE, Tape


def ends(text: str) -> list[float]:
    """Return the x [mm] at the end of each move."""
    moves = parse_program(f"G21 F100 G1\n{text}\nM2").moves
    return [round(1e3 * move.end[0], 9) for move in moves if not isinstance(move, Dwell)]


@each(
    "text, wanted",
    [
        ("o1 if [1]\nX1\no1 else\nX2\no1 endif", [1]),
        ("o1 if [0]\nX1\no1 else\nX2\no1 endif", [2]),
        ("o1 if [0]\nX1\no1 endif\nX3", [3]),
        ("#1 = 2\no1 if [#1 EQ 1]\nX1\no1 elseif [#1 EQ 2]\nX2\no1 elseif [1]\nX3\no1 else\nX4\no1 endif", [2]),
        ("o1 if [0]\nX1\no1 elseif [0]\nX2\no1 else\nX4\no1 endif", [4]),
        ("o1 if [0]\no2 if [1]\nX1\no2 else\nX2\no2 endif\no1 endif\nX5", [5]),
        ("o1 if [1]\no2 if [0]\nX1\no2 else\nX2\no2 endif\no1 else\nX3\no1 endif", [2]),
        ("#1 = 0\no1 while [#1 LT 3]\n#1 = [#1 + 1]\nX#1\no1 endwhile", [1, 2, 3]),
        ("o1 while [0]\nX1\no1 endwhile\nX2", [2]),
        ("#1 = 5\no1 do\n#1 = [#1 + 1]\nX#1\no1 while [#1 LT 3]", [6]),
        ("#1 = 0\no1 repeat [3]\n#1 = [#1 + 1]\nX#1\no1 endrepeat", [1, 2, 3]),
        ("o1 repeat [0]\nX1\no1 endrepeat\nX2", [2]),
        ("o1 repeat [-2]\nX1\no1 endrepeat\nX2", [2]),
        ("#1 = 0\no1 while [1]\n#1 = [#1 + 1]\no2 if [#1 EQ 3]\no1 break\no2 endif\nX#1\no1 endwhile\nX9", [1, 2, 9]),
        ("#1 = 0\no1 while [#1 LT 4]\n#1 = [#1 + 1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\nX#1\no1 endwhile", [1, 3, 4]),
        ("#1 = 0\no1 do\n#1 = [#1 + 1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\nX#1\no1 while [#1 LT 4]", [1, 3, 4]),
        (
            "#1 = 0\no1 while [#1 LT 2]\no2 repeat [2]\n#1 = [#1 + 1]\nX#1\n"
            "o3 if [#1 EQ 1]\no1 continue\no3 endif\no2 endrepeat\no1 endwhile",
            [1, 2, 3],
        ),
        ("o1 repeat [2]\no2 while [1]\nG91 X1\no2 break\no2 endwhile\no1 endrepeat", [1, 2]),
        ("o9 if [1]\no1 while [1]\no2 if [1]\no1 break\no2 endif\no1 endwhile\nX1\no9 endif", [1]),
        ("o[1 + 1] if [1]\nX1\no2 endif", [1]),
        ("o<A b> if [1]\nX1\nO<ab> endif", [1]),
        ("o007 if [1]\nX1\nO7 endif", [1]),
        ("N10 o1 if [1] (a) (b)\n N20 O1 endif (there)\nX1", [1]),
        ("o1 if [1] ; (c) d\nX1\no1 endif", [1]),
    ],
)
def test_conditions_and_loops(text: str, wanted: list[float]) -> None:
    assert ends(text) == wanted


@each(
    "text, wanted",
    [
        ("o1 sub\nX#1 Y#2\no1 endsub\no1 call [3] [4]\no1 call [5]", [3, 5]),
        ("#1 = 7\no1 sub\n#1 = 9\nX#1\no1 endsub\no1 call [3]\nX#1", [9, 7]),
        ("#31 = 7\no1 sub\n#31 = 9\no1 endsub\no1 call\nX#31", [9]),
        ("#<_g> = 2 #<l> = 3\no1 sub\n#<_g> = 5 #<l> = 6\nX#<l>\no1 endsub\no1 call\nX#<_g>\nX#<l>", [6, 5, 3]),
        ("o1 sub\nX1\no2 if [#1 EQ 1]\no1 return\no2 endif\nX2\no1 endsub\no1 call [1]\nX3\no1 call [2]", [1, 3, 1, 2]),
        ("o1 sub\no1 endsub [#1 * 2]\no1 call [4]\nX#<_value>\nX[#<_value_returned> + 20]", [8, 21]),
        ("o1 sub\no1 endsub\no1 call\nX[#<_value_returned> + 20]", [20]),
        ("o1 sub\nX1\no1 endsub\no2 sub\nX2\no1 call\nX3\no2 endsub\no2 call", [2, 1, 3]),
        ("o1 call\nX5\nM2\no1 sub\nX1\no1 endsub", [1, 5]),
        ("o1 sub\nX#1\no2 if [#1 GT 1]\no1 call [#1 - 1]\no2 endif\no1 endsub\no1 call [4]", [4, 3, 2, 1]),
        ("o1 sub\nX[#<_call_level>]\no1 endsub\no1 call\nX[#<_call_level> + 7]", [1, 7]),
        ("M98 P5 L3\nX9\nM2\nO5\nG91 X1\nG90\nM99", [1, 2, 3, 9]),
        ("#1 = 4\nM98 P5\nX#1\nM2\nO5\nX#1\n#1 = 6\nM99", [4, 6]),
        ("M98 P5\nM2\nO5\nX1\nM98 P6\nX3\nM99\nO6\nX2\nM99", [1, 2, 3]),
        ("o1 sub\no2 while [1]\nX1\no1 return\no2 endwhile\no1 endsub\no1 call\nX2", [1, 2]),
        ("o2 sub\nX2\no2 endsub\no<a> sub\n#<s> = 2\no#<s> call\no<a> endsub\no<a> call", [2]),
        ("o<a> sub\n#<s> = 2\no#<s> if [1]\nX2\no#<s> endif\no<a> endsub\no<a> call", [2]),
    ],
)
def test_subprograms(text: str, wanted: list[float]) -> None:
    assert ends(text) == wanted


@each(
    "text, line, column, message",
    [
        ("o100 sub", 1, 1, "CL841 .*O100 endsub"),
        ("o<name> call", 1, 1, "CL844 .*Oname"),
        ("G0 X1\n  O100 if [0]\nX2\nX3", 2, 3, "CL841 .*O100 if"),
        ("G0 X1\no1 while [1]\nX2", 3, 0, "CL841 .*O1 while"),
        ("o1 endif", 1, 1, "CL842 .*O1 endif"),
        ("o1 else", 1, 1, "CL842 .*O1 else"),
        ("o1 if [1]\no2 endif", 2, 1, "CL842 .*O2 endif"),
        ("o1 if [1]\no2 while [1]\no1 endif", 3, 1, "CL842 .*O1 endif"),
        ("o1 endwhile", 1, 1, "CL842"),
        ("o1 endrepeat", 1, 1, "CL842"),
        ("o1 repeat [2]\no1 break\no1 endrepeat", 2, 1, "CL842"),
        ("o1 repeat [2]\no1 continue\no1 endrepeat", 2, 1, "CL842"),
        ("o1 (c) if [1]\nX1\no1 endif", 1, 4, "CL802"),
        ("o1 if (c) [1]\nX1\no1 endif", 1, 7, "CL802"),
        ("o1 if [1 (c)]\nX1\no1 endif", 1, 10, "CL802"),
        ("o1 break", 1, 1, "CL842"),
        ("o1 continue", 1, 1, "CL842"),
        ("o1 endsub", 1, 1, "CL842"),
        ("o1 return [1]", 1, 1, "CL842"),
        ("o1 if", 1, 1, "CL840"),
        ("o1 if [1] [2]", 1, 1, "CL840"),
        ("o1 repeat [1/0]", 1, 13, "CL836 .*1 / 0"),
        ("o1 repeat [2 ** 60]", 1, 1, "CL806"),
        ("o1 begin", 1, 4, "CL840"),
        ("o1 do [2]", 1, 1, "CL840"),
        ("o1 if [1] X2", 1, 11, "CL840"),
        ("o call", 1, 3, "CL835"),
        ("o<open call", 1, 2, "CL839 .*'>'"),
        ("o[1.5] call", 1, 2, "CL840"),
        ("o1234567890 call", 1, 2, "CL840"),
        ("o1 sub\no2 sub\no2 endsub\no1 endsub", 2, 1, "CL843 .*O2 sub .*O1 sub"),
        ("o1 sub\no1 endsub\no1 sub\no1 endsub", 3, 1, "CL843"),
        ("o1 if [1]\no1 endif\no1 if [1]\no1 endif", 3, 1, "CL843 .*line 1 "),
        (
            "o1 repeat [1]\no1 endrepeat\no1 while [1]\no1 endwhile",
            3,
            1,
            "CL843 .*line 1 ",
        ),
        ("o1 call" + " [1]" * 31, 1, 1, "CL840 .*30 arguments"),
        ("%\no9 call\nX1\n%\no9 sub\nX2\no9 endsub", 2, 1, "CL844 .*O9"),
        ("%\nM98 P9\nX1\n%\nO9\nX2\nM99", 2, 1, "CL844 .*O9"),
        ("%\no1 if [0]\nX1\n%\no1 endif", 2, 1, "CL841 .*O1 if"),
        ("o1 if [0]\n#<s> = 2\no#<s> if [1]\no#<s> endif\no1 endif", 3, 2, "CL837 .*#<s>"),
        ("M98", 1, 1, "CL813"),
        ("M98 P1.5", 1, 5, "CL806"),
        ("M98 P7", 1, 1, "CL844 .*O7"),
        ("o1 sub\no1 call\no1 endsub\no1 call", 2, 1, "CL845 .*9 deep"),
        ("M98 P1\nM2\nO1\nM98 P1\nM99", 4, 1, "CL845 .*9 deep"),
    ],
)
def test_refusals(text: str, line: int, column: int, message: str) -> None:
    with pytest.raises(ProgramError) as caught:
        parse_program(f"{text}\nM2" if column else text)  # a missing end has no column
    assert re.match(message, f"{caught.value.code} {caught.value.message}")
    assert (caught.value.line, caught.value.column) == (line, column)


@pytest.mark.slow
@pytest.mark.parametrize(
    "text",
    ["o1 while [1]\no1 endwhile", "o1 do\nG21\no1 while [1]", "o1 repeat [999999999]\no1 endrepeat",
     "M98 P1 L999999999\nM2\nO1\nM99", "o1 while [1]\no2 repeat [3]\n#1 = 2\no2 endrepeat\no1 endwhile", "o1 while [1]\nG0 X0\no1 endwhile",
     "o1 while [1]\nG92 X0\no1 continue\no1 endwhile"],
)  # fmt: skip
def test_endless_loops_are_stopped_early(text: str) -> None:
    begun = time.perf_counter()
    with pytest.raises(ProgramError, match=r"endless|never"):
        parse_program(f"{text}\nM2", reading=Reading(most_moves=10_000))
    assert time.perf_counter() - begun < 30.0


def test_loops_may_count_to_a_hundred_thousand_but_not_for_ever() -> None:
    """Here to a thousandth of it, with a thousandth of the limit."""
    reading = Reading(most_moves=Reading().most_moves // 1000)
    text = "#1 = 0\no1 while [#1 lt {}]\n#1 = [#1 + 1]\no1 endwhile\nG1 F1 X1\nM2"
    assert len(parse_program(text.format(100), reading=reading).moves) == 1
    with pytest.raises(ProgramError):
        parse_program(text.format(200), reading=reading)


def test_a_subprogram_may_use_a_label_again() -> None:
    assert ends("o1 sub\no9 if [1]\nX1\no9 endif\no1 endsub\no9 if [1]\no1 call\no1 call\no9 endif") == [1]


def test_subprograms_in_separate_files(tmp_path: Path) -> None:
    (tmp_path / "drill.ngc").write_text("o<drill> sub\nG0 X#1\no<drill> endsub\nM2\n", encoding="utf-8")
    (tmp_path / "bad.ngc").write_text("(a)\no<bad> sub\nG0 X\no<bad> endsub\nM2\n", encoding="utf-8")
    main = tmp_path / "main.ngc"
    main.write_text("o<Drill> call [7]\nG0 Y1\nM2\n", encoding="utf-8")
    moves = read_program(main).moves
    assert [move.end for move in moves] == [(0.007, 0.0, 0.0), (0.007, 0.001, 0.0)]  # type: ignore[union-attr]
    main.write_text("o<bad> call\nM2\n", encoding="utf-8")
    with refuses(ProgramError, "X has", file=tmp_path / "bad.ngc", line=3):
        read_program(main)
    with refuses(ProgramError, "Odrill", line=1, column=1):
        parse_program("o<drill> call [7]\nM2")
    assert len(parse_program("o<drill> call [7]\nM2", reading=Reading(folder=tmp_path)).moves) == 1
    with refuses(ProgramError, r"O\.\./main", line=1, column=1):
        parse_program("o<../main> call\nM2", reading=Reading(folder=tmp_path / "deeper"))


def test_block_delete() -> None:
    text = "/G0 X1\nG0 X2\n /N5 X3\n/o1 if [1]\n/X4\n/o1 endif\nM2"
    assert [1e3 * m.end[0] for m in parse_program(text).moves] == [1, 2, 3, 4]  # type: ignore[union-attr]
    assert [1e3 * m.end[0] for m in parse_program(text, reading=Reading(block_delete=True)).moves] == [2]  # type: ignore[union-attr]


def test_the_tape_keeps_lines_that_may_run_again() -> None:
    tape = Tape(iter(f"line {i}" for i in range(10)), "t")
    assert tape.line(3) == "line 3"
    tape.forget(3)
    assert tape.line(3) == "line 3"
    assert tape.line(9) == "line 9"
    assert tape.line(10) is None


@pytest.mark.slow
def test_a_long_program_is_not_kept_in_memory() -> None:
    """Ten times as many lines, including loops, need no more memory."""

    def peak(count: int) -> int:
        tracemalloc.start()
        for _ in Reader(_lines(count), reading=Reading(require_end=False)).moves():
            pass
        found = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        return found

    peak(1000)
    short, long = peak(2_000), peak(20_000)
    assert long < 1.5 * short + 20_000


def _lines(count: int) -> Iterator[str]:
    yield "G21 G1 F100 #1 = 0"
    for number in range(count):
        yield f"X{number % 977} Y{number % 31}"
        if number % 1000 == 0:
            yield f"o{number} repeat [3]"
            yield "#1 = [#1 + 1]"
            yield f"o{number} endrepeat"


def test_a_loop_that_moves_without_changing_any_state_is_refused() -> None:
    with refuses(ProgramError, "O1 while", line=4, column=1):
        parse_program("o1 while [1]\nG0 X1\nG0 X0\no1 endwhile\nM2\n")
    # A loop that advances with each turn ends by its own condition.
    assert len(parse_program("G91\no1 while [#5420 LT 5]\nG0 X1\no1 endwhile\nM2\n").moves) == 5


def test_many_subprograms_after_the_end_are_read_once() -> None:
    calls = "".join(f"o{n} call\n" for n in range(1, 2001))
    subs = "".join(f"o{n} sub\nG1 X{n}\no{n} endsub\n" for n in range(1, 2001))
    read = []
    lines = (calls.splitlines() for calls in (f"F100\n{calls}M2\n{subs}",))

    def counted() -> Iterator[str]:
        for line in next(lines):
            read.append(line)
            yield line

    moves = list(Reader(counted()).moves())
    assert [round(1e3 * move.end[0]) for move in moves if not isinstance(move, Dwell)] == list(range(1, 2001))
    assert len(read) <= 8002


def test_moves_from_another_file_have_the_line_of_the_call(tmp_path: Path) -> None:
    (tmp_path / "drill.ngc").write_text("o<drill> sub\n\n\nG0 X1\no<drill> endsub\nM2\n", encoding="utf-8")
    (tmp_path / "main.ngc").write_text("G21\no<drill> call\nG0 X0\nM2\n", encoding="utf-8")
    program = read_program(tmp_path / "main.ngc")
    assert [move.source_line for move in program.moves] == [2, 3]
    (tmp_path / "drill.ngc").write_text("o<drill> sub\nG0 X1\nfoo\no<drill> endsub\nM2\n", encoding="utf-8")
    with pytest.raises(ProgramError) as caught:
        read_program(tmp_path / "main.ngc")
    assert (Path(caught.value.file).name, caught.value.line) == ("drill.ngc", 3)


def test_loops_cannot_produce_unlimited_moves() -> None:
    reading = Reading(most_moves=1500)
    text = "F100\n{}\no1 repeat [{}]\nG1 X1\nX0\no1 endrepeat\nM2"
    lines = "\n".join(f"G1 Y{i % 7 + 1}" for i in range(1500))  # moves written in the text itself are not limited
    assert len(parse_program(text.format(lines, 500), reading=reading).moves) == 1500 + 1000
    with refuses(ProgramError, "most_moves", line=4):
        parse_program(text.format("", 501), reading=reading)


def test_a_long_line_in_a_loop_counts_more_than_once() -> None:
    text = "G91 G0 X1" + 32 * 3 * " " + "\n"
    reading = Reading(most_moves=100)
    assert len(parse_program(f"o1 repeat [15]\n{text}o1 endrepeat\nM2", reading=reading).moves) == 15
    with refuses(ProgramError, "most_moves"):
        parse_program(f"o1 repeat [25]\n{text}o1 endrepeat\nM2", reading=reading)


def test_cycles_cannot_produce_unlimited_moves() -> None:
    text = "F100 G81 X1 Z-1 R1 L600\nM2"
    assert len(parse_program(text).moves) > 1000
    with refuses(ProgramError, "most_moves", line=1):
        parse_program(text, reading=Reading(most_moves=1000))
    with refuses(ProgramError, "strokes", line=1):
        parse_program("F100 G91 G83 X1 Z-1 R1 Q0.001 L200\nM2")
    with refuses(ParameterError, "most_moves"):
        Reading(most_moves=0)


def test_a_long_line_is_refused_before_it_is_read(tmp_path: Path) -> None:
    text = "G0 X1\n(" + LONGEST_LINE * "c" + ")\nM2"
    with refuses(ProgramError, line=2, column=LONGEST_LINE + 1):
        parse_program(text)
    file = tmp_path / "long.ngc"
    file.write_text("G0 X1\n" + 20_000_000 * "X1", encoding="utf-8")
    tracemalloc.start()
    with open_program(file) as reader, refuses(ProgramError, line=2, column=LONGEST_LINE + 1):
        list(reader.moves())
    assert tracemalloc.get_traced_memory()[1] < 10_000_000
    tracemalloc.stop()
