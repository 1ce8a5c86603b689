"""Every refusal names line, column, problem and remedy."""

import re

import pytest
from each import each
from refusals import refuses

from contourlab.errors import ProgramError
from contourlab.program import parse_program
from contourlab.program.vocabulary import G_GROUPS, M_GROUPS, g_name

# Text, line, column, and code.
REFUSED = [
    # Not supported yet.
    ("G0 X1\nX2 G41 D1", 2, 4, "CL808"),
    ("G33 K1 Z2", 1, 1, "CL808"),
    ("G38.2 Z-5", 1, 1, "CL808"),
    ("G71", 1, 1, "CL808"),
    ("M66 P1", 1, 1, "CL808"),
    ("G0 X1 M3 M5", 1, 10, "CL810"),
    ("M7 M8", 1, 4, "CL810"),
    ("S-5 M3", 1, 1, "CL806"),
    ("T1.5", 1, 1, "CL806"),
    ("T-1", 1, 1, "CL806"),
    ("M49 P1", 1, 5, "CL811"),
    ("M50 P1 G4", 1, 5, "CL812"),
    ("G1 F100 X1\nG80 X2", 2, 5, "CL811"),
    ("G1 F100 X1 G41", 1, 12, "CL808"),
    ("F10 G64 P1 G4", 1, 9, "CL812"),
    ("F10 G17 G82 X1 Z-1 R1 P1 G4", 1, 23, "CL812"),
    ("G5.2 X1 Y1 P1", 1, 1, "CL815"),
    ("F10 G5.2 X1 Y1 P1\nM2", 2, 0, "CL826"),
    ("G0 X1 A90", 1, 7, "CL808"),
    ("M101", 1, 1, "CL808"),
    ("G0 X1\nG0 X2 ( Abort, no tool)", 2, 7, "CL846"),
    ("#5400 = 5", 1, 2, "CL838"),
    ("#<_ini[setup]offset> = 3", 1, 2, "CL838"),
    ("#<_HAL[pin]> = 3", 1, 2, "CL838"),
    ("G0 X#<_ini[setup]offset>", 1, 5, "CL837"),
    ("G0 X#<depth>", 1, 5, "CL837"),
    ("G0 X[1+2", 1, 8, "CL835"),
    ("G0 X1 / 2", 1, 7, "CL801"),
    ("G0 @5", 1, 4, "CL818"),
    ("G0 @5 ^10 Y2", 1, 11, "CL816"),
    ("G91 G0 ^20", 1, 8, "CL818"),
    ("G0 X5\nG91 @-5", 2, 5, "CL818"),
    ("@5 ^30", 1, 1, "CL814"),
    ("G18\nG17 G0 @5 ^30", 2, 8, "CL816"),
    # Unknown.
    ("G123", 1, 1, "CL807"),
    ("G6.5", 1, 1, "CL807"),
    ("G1.05 X1", 1, 1, "CL807"),
    ("G-1 X1", 1, 1, "CL807"),
    ("M2.5", 1, 1, "CL807"),
    ("M-2", 1, 1, "CL807"),
    ("M77", 1, 1, "CL807"),
    # Text.
    ("G0 X1 (no end", 1, 7, "CL802"),
    ("G0 (a (b) c) X1", 1, 7, "CL802"),
    ("G0 X1 b)", 1, 7, "CL803"),
    ("G0 X1 )", 1, 7, "CL801"),
    ("G0 X1, Y2", 1, 6, "CL801"),
    ("G0 X1,5", 1, 6, "CL801"),
    ("G0 X1*55", 1, 6, "CL801"),
    ("G0 X1 !", 1, 7, "CL801"),
    ("G0 X1\u00a0Y2", 1, 6, "CL801"),
    ("G0 X\u0661", 1, 4, "CL803"),
    ("G0 X1 \x00", 1, 7, "CL801"),
    ("G0 X", 1, 4, "CL803"),
    ("G0 XY", 1, 4, "CL803"),
    ("G0 X(one)1", 1, 4, "CL803"),
    ("G0 X1(one)0", 1, 11, "CL801"),
    ("G0 X.", 1, 4, "CL803"),
    ("G0 X-", 1, 4, "CL803"),
    ("G0 X1.2.3", 1, 4, "CL803"),
    ("G0 X--", 1, 6, "CL803"),
    ("G0 X1e3", 1, 6, "CL811"),
    ("G0 X1 N10", 1, 7, "CL804"),
    ("(c) N10 G0 X1", 1, 5, "CL804"),
    ("N10 N20 G0 X1", 1, 5, "CL804"),
    ("N-1 G0 X1", 1, 1, "CL804"),
    ("N G0 X1", 1, 1, "CL803"),
    ("(c)\n%\nG0 X1\n%", 2, 1, "CL847"),
    ("G0 X1\n  %", 2, 3, "CL847"),
    ("% part\nG0 X1\n%", 1, 1, "CL801"),
    ("G0 X1 %\nM2", 1, 7, "CL801"),
    # Absurd numbers.
    ("G0 X99999999999", 1, 4, "CL805"),
    ("G0 X" + "9" * 400, 1, 4, "CL805"),
    ("G0 X0." + "0" * 200 + "1", 1, 4, "CL805"),
    ("G0 X1000001", 1, 4, "CL817"),
    ("G91 G0 X900000\nX900000", 2, 1, "CL817"),
    ("G4 P100000", 1, 4, "CL806"),
    ("F10 G2 X1 R900000000", 1, 11, "CL823"),
    # Grammar of a block.
    ("G0 X1 Y2 X3", 1, 10, "CL809"),
    ("G1 F10 X1 F20", 1, 11, "CL809"),
    ("G0 G1 X1", 1, 4, "CL810"),
    ("G1 G1 X1", 1, 4, "CL810"),
    ("G90 G91", 1, 5, "CL810"),
    ("G90.1 G91.1", 1, 7, "CL810"),
    ("G17 G18", 1, 5, "CL810"),
    ("G20 G21", 1, 5, "CL810"),
    ("M2 M30", 1, 4, "CL810"),
    ("X1", 1, 1, "CL814"),
    ("F10 Z1 Y2", 1, 8, "CL814"),
    ("G1 X1", 1, 1, "CL815"),
    ("F0\nG1 X1", 2, 1, "CL815"),
    ("G1\nX1", 1, 1, "CL815"),
    ("G2 I5", 1, 1, "CL815"),
    ("F-5", 1, 1, "CL806"),
    ("G4", 1, 1, "CL813"),
    ("G4 P-1", 1, 4, "CL806"),
    ("G1 F10 X1 I5", 1, 11, "CL811"),
    ("G0 X1 R5", 1, 7, "CL811"),
    ("G0 X1 P5", 1, 7, "CL811"),
    ("K5", 1, 1, "CL811"),
    ("F10 G2 I5\nR5", 2, 1, "CL811"),
    ("F10 G2 I5 G4 P1", 1, 14, "CL812"),
    # Arcs.
    ("F10 G2 X1", 1, 5, "CL820"),
    ("F10 G3", 1, 5, "CL820"),
    ("F10 G2 I5\nX1", 2, 1, "CL820"),
    ("F10 G2 X1 R5 I1", 1, 11, "CL820"),
    ("F10 G2 X1 I5 K1", 1, 14, "CL811"),
    ("G18 F10 G2 X1 J5", 1, 15, "CL811"),
    ("G19 F10 G2 Y1 I5", 1, 15, "CL811"),
    ("F10 G2 Z1 R5", 1, 11, "CL820"),
    ("G18 F10 G2 Y1 R5", 1, 15, "CL820"),
    ("F10 G2 X0 R5", 1, 11, "CL822"),
    ("F10 G2 X10 R4.998", 1, 12, "CL822"),
    ("F10 G2 X10 R0", 1, 12, "CL823"),
    ("F10 G2 I0 J0", 1, 8, "CL823"),
    ("F10 G2 X1 I1", 1, 11, "CL823"),
    ("F10 G2 X20.0284 I10", 1, 17, "CL821"),
    ("F10 G2 X20.05 I10", 1, 15, "CL821"),
    ("F10 G2 X200.15 I100", 1, 16, "CL821"),
    ("F10 G20 G2 X2.0029 I1", 1, 20, "CL821"),
    ("F10 G2 X12005 I6000", 1, 15, "CL821"),
    ("G90.1 F10 G2 X10 I5", 1, 18, "CL820"),
    ("G90.1 G18 F10 G2 X10 I5", 1, 22, "CL820"),
    ("F10 G2 X10 I5 P0", 1, 15, "CL806"),
    ("F10 G2 X10 I5 P1.5", 1, 15, "CL806"),
    # The program as a whole.
    ("", 0, 0, "CL848"),
    ("M2", 0, 0, "CL848"),
    ("%\n%", 0, 0, "CL848"),
    ("(only words)\nG4 P1\nG21 F100\nM2", 0, 0, "CL848"),
    ("G0 X1\nX2\n", 2, 0, "CL847"),
    ("%\nG0 X1", 2, 0, "CL847"),
]


NAMED = [
    ("G0 X1\nX2 G41 D1", "G41 (cutter compensation)"),
    ("M101", "M101 (user-defined code)"),
    ("G0 X1\nG0 X2 ( Abort, no tool)", "no tool"),
    ("G0 X1\u00a0Y2", r"'\xa0'"),
    ("G0 X" + "9" * 400, f"X{'9' * 20}... "),
    ("G1 F10 X1 I5", "G2, G3, G5, G5.1 or G87"),
    ("G18 F10 G2 X1 J5", "ZX plane"),
    ("F10 G2 X10 R4.998", "R = 4.998 mm"),
    ("F10 G2 X20.0284 I10", "10 mm at the arc's start but 10.0284 mm at its end"),
    ("F10 G2 X200.15 I100", "100 mm at the arc's start but 100.15 mm at its end"),
    ("F10 G20 G2 X2.0029 I1", "1 in at the arc's start but 1.0029 in at its end"),
]
"""Texts, and the words or figures of theirs that the message repeats."""


@each("text, line, column, code", REFUSED)
def test_refusals(text: str, line: int, column: int, code: str) -> None:
    with refuses(ProgramError, file="part.ngc", line=line, column=column, code=code) as caught:
        parse_program(text, "part.ngc")
    assert ": " in caught.value.message and code not in str(caught.value)  # problem: remedy


@each("text, words", NAMED)
def test_a_message_names_what_is_wrong(text: str, words: str) -> None:
    with pytest.raises(ProgramError, match=re.escape(words)):
        parse_program(text)


def test_unsupported_codes_are_refused_by_name() -> None:
    refused = 0
    for code in range(1000):
        if code in G_GROUPS:
            continue
        with pytest.raises(ProgramError) as caught:
            parse_program(f"G0 X1 {g_name(code)}\nM2")
        assert caught.value.message.startswith(f"{g_name(code)} ")
        assert (caught.value.line, caught.value.column) == (1, 7)
        refused += 1
    assert refused == 1000 - len(G_GROUPS)
    for number in range(200):
        if number not in M_GROUPS:
            with pytest.raises(ProgramError, match=rf"^<text>:1:7: M{number} "):
                parse_program(f"G0 X1 M{number}\nM2")


def test_every_letter_is_used_or_refused() -> None:
    # The effect of a letter must show: the moves differ from those without it, or the block is refused.
    for letter in "ABCDEHLOQUVW":
        with pytest.raises(ProgramError, match=f"{letter}"):
            parse_program(f"G0 X1 {letter}1\nM2")
