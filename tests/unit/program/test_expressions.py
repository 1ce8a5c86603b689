"""Values in a part program: closed forms, order of operations, and refusals with their column."""

from __future__ import annotations

import re

import pytest
from each import each
from refusals import refuses

from contourlab.errors import ProgramError
from contourlab.program import Program, parse_program
from contourlab.program.block import Parameters, read_words
from contourlab.program.vocabulary import BlockError


def of(text: str, parameters: Parameters | None = None) -> float:
    words = read_words(f"X{text}", parameters)
    assert len(words) == 1
    return words[0].value


@each(
    "text, expected",
    [
        ("[1 + 2 * 3]", 7.0),
        ("[8 - 3 - 2]", 3.0),
        ("[2 ** 3 ** 2]", 64.0),
        ("[-2 ** 2]", 4.0),
        ("[10 / 4 * 2]", 5.0),
        ("[7 MOD 3]", 1.0),
        ("[-7 mod 3]", 2.0),
        ("[-5 MOD -3]", 1.0),
        ("[1 EQ 1.00009]", 1.0),
        ("[1 EQ 1.0002]", 0.0),
        ("[1 GE 1.00005]", 0.0),
        ("[1 LT 2 LT 3]", 1.0),
        ("[1 AND 0 OR 1]", 1.0),
        ("[1 OR 1 AND 0]", 0.0),
        ("[2 XOR 3]", 0.0),
        ("[1 + 1 EQ 2 AND 3 GT 2]", 1.0),
        ("ROUND[-2.5]", -3.0),
        ("ROUND[2.5]", 3.0),
        ("FIX[-2.5]", -3.0),
        ("FUP[-2.5]", -2.0),
        ("-ABS[-3]", -3.0),
        ("--3", 3.0),
        ("- [1 + 1]", -2.0),
        ("SQRT[2 . 2 5]", 1.5),
        ("[((no comment", None),
    ],
)
def test_values(text: str, expected: float | None) -> None:
    if expected is None:
        with pytest.raises(BlockError):
            of(text)
    else:
        assert of(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("SIN[30]", 0.5),
        ("COS[60]", 0.5),
        ("TAN[45]", 1.0),
        ("ASIN[1]", 90.0),
        ("ACOS[0]", 90.0),
        ("ATAN[1]/[-1]", 135.0),
        ("LN[EXP[2]]", 2.0),
    ],
)
def test_functions_are_in_degrees(text: str, expected: float) -> None:
    assert of(text) == pytest.approx(expected, rel=1e-14)


def test_a_line_uses_parameters_from_before_the_line() -> None:
    parameters = Parameters()
    assert of("#1", parameters) == 0.0
    assert read_words("#1 = 5 #2 = [#1 + 1] #<Deep> = 3", parameters) == []
    assert (of("#1", parameters), of("#2", parameters), of("#<DEEP>", parameters)) == (5.0, 1.0, 3.0)
    assert [w.value for w in read_words("X#1 #1 = 9 Y#1", parameters)] == [5.0, 5.0]
    assert of("##[2 - 1]", parameters) == 0.0 and of("#1", parameters) == 9.0
    assert of("EXISTS[#<deep>]", parameters) == 1.0 and of("EXISTS[#<flat>]", parameters) == 0.0


def test_comments_and_blanks_inside_expressions() -> None:
    words = read_words("G 1 X [ 1 (one) + 2 ] (#3 = 4) F #1 ; [")
    assert [(w.letter, w.value, w.column) for w in words] == [("G", 1.0, 1), ("X", 3.0, 5), ("F", 0.0, 32)]


@each(
    "line, column, message",
    [
        ("X[1/0]", 4, "CL836 .*1 / 0"),
        ("X[5 MOD 0]", 5, "CL836 .*5 MOD 0"),
        ("X[-8 ** 0.5]", 6, "CL836"),
        ("X[10 ** 400]", 6, "CL836"),
        ("XSQRT[-1]", 2, r"CL836 .*SQRT\[-1\]"),
        ("XLN[0]", 2, "CL836"),
        ("XASIN[1.5]", 2, "CL836"),
        ("XATAN[1]", 8, "CL835 .*'/'.*ATAN"),
        ("XFOO[1]", 2, "CL835 .*'F'"),
        ("X-SIN+[30]#1=1", 6, "CL835"),
        ("X[1 + ]", 7, "CL803 .*number.*']'"),
        ("X[1 2 3", 7, "CL835 .*']'.*end"),
        ("X[]", 3, "CL803"),
        ("X#<deep>", 2, "CL837 .*#<deep>"),
        ("X#<deep", 3, "CL839 .*'>'"),
        ("X#0", 2, "CL839 .*#0"),
        ("X#5602", 2, "CL839 .*#5602"),
        ("X#1.5", 3, r"CL839 .*#1\.5.*whole"),
        ("#5 3", 4, "CL835 .*'=' is missing"),
        ("#5 =", 4, "CL803"),
        ("#5420 = 3", 2, "CL838 .*#5420"),
        ("G1 X[1] = 2", 9, "CL801 .*'='.*parameter"),
        ("X1 ]#1=2", 4, "CL801 .*']'"),
        ("N[1] X1", 1, "CL804"),
        ("X[1e3]", 4, "CL835 .*'e'"),
        ("X" + "[" * 60 + "1" + "]" * 60, 53, "CL835 .*50 deep"),
        ("X[2 ** 40]", 1, "CL805"),
        ("O[1] sub", 1, "CL840"),
        ("G1 X[2] O[1] call", 9, "CL840"),
    ],
)
def test_refusals_name_the_place(line: str, column: int, message: str) -> None:
    with pytest.raises(BlockError) as caught:
        read_words(line)
    assert re.match(message, caught.value.message)
    assert caught.value.column == column


def test_a_program_with_parameters() -> None:
    program = parse_program("G21 G91 F600\n#<step> = 2.5\n#1 = [#<step> * 4]\nG1 X#1 Y-[#1 / 2]\nG1 X[#5420 - 5]\nM2")
    assert isinstance(program, Program)
    assert [move.end for move in program.moves] == [(0.01, -0.005, 0.0), (0.015, -0.005, 0.0)]  # type: ignore[union-attr]


def test_the_position_is_in_the_current_units() -> None:
    program = parse_program("G20 F60\nG1 X2\nG1 Y#5420\nM2")
    assert program.moves[-1].end == pytest.approx((0.0508, 0.0508, 0.0))  # type: ignore[union-attr]


def test_errors_have_line_and_column() -> None:
    with refuses(ProgramError, "1 / 0", file="part.ngc", line=2, column=7):
        parse_program("G21\nG1 X[1/0] F1\nM2", "part.ngc")
