"""Every refusal names line, column, problem and remedy."""

import pytest
from each import each

from contourlab.errors import ProgramError
from contourlab.program import parse_program
from contourlab.program.vocabulary import G_GROUPS, M_GROUPS, g_name

# Text, line, column, and a part of the message.
REFUSED = [
    # Not supported yet.
    ("G0 X1\nX2 G41 D1", 2, 4, r"G41 \(cutter compensation\) is not supported yet: let the CAM"),
    ("G33 K1 Z2", 1, 1, r"G33 \(spindle-synchronised motion\)"),
    ("G38.2 Z-5", 1, 1, r"G38\.2 \(probing\)"),
    ("G71", 1, 1, r"G71 \(lathe cycle\)"),
    ("M66 P1", 1, 1, r"M66 \(wait for an input\)"),
    ("G0 X1 M3 M5", 1, 10, "M3 and M5 cannot share a block"),
    ("M7 M8", 1, 4, "M7 and M8 cannot share a block"),
    ("S-5 M3", 1, 1, "S-5: .*spindle speed"),
    ("T1.5", 1, 1, r"T1\.5: .*whole number"),
    ("T-1", 1, 1, "T-1: .*whole number"),
    ("M49 P1", 1, 5, "uses P"),
    ("M50 P1 G4", 1, 5, "use P"),
    ("G1 F100 X1\nG80 X2", 2, 5, "X .*G80"),
    ("G1 F100 X1 G41", 1, 12, r"G41 \(cutter compensation\)"),
    ("F10 G64 P1 G4", 1, 9, "use P"),
    ("F10 G17 G82 X1 Z-1 R1 P1 G4", 1, 23, "use P"),
    ("G5.2 X1 Y1 P1", 1, 1, r"G5\.2 has no feedrate"),
    ("F10 G5.2 X1 Y1 P1\nM2", 2, 0, r"the NURBS begun with G5\.2 is not closed"),
    ("G0 X1 A90", 1, 7, r"A \(rotary axis\)"),
    ("M101", 1, 1, r"M101 \(user-defined code\)"),
    ("G0 X1\nG0 X2 ( Abort, no tool)", 2, 7, "no tool"),
    ("#5400 = 5", 1, 2, "#5400 .*read-only"),
    ("#<_ini[setup]offset> = 3", 1, 2, "_ini.*read-only"),
    ("#<_HAL[pin]> = 3", 1, 2, "_hal.*read-only"),
    ("G0 X#<_ini[setup]offset>", 1, 5, "_ini.*unknown"),
    ("G0 X#<depth>", 1, 5, "has no value yet"),
    ("G0 X[1+2", 1, 8, "']' is missing"),
    ("G0 X1 / 2", 1, 7, "block delete"),
    ("G0 @5", 1, 4, "origin .*\\^"),
    ("G0 @5 ^10 Y2", 1, 11, "give polar coordinates, or X and Y"),
    ("G91 G0 ^20", 1, 8, "X or Y first"),
    ("G0 X5\nG91 @-5", 2, 5, "ends at the origin"),
    ("@5 ^30", 1, 1, "@ has no motion code"),
    ("G18\nG17 G0 @5 ^30", 2, 8, "G17"),
    # Unknown.
    ("G123", 1, 1, "G123 is not a known G-code"),
    ("G6.5", 1, 1, r"G6\.5 is not a known G-code"),
    ("G1.05 X1", 1, 1, r"G1\.05 is not a known G-code"),
    ("G-1 X1", 1, 1, "G-1 is not a known G-code"),
    ("M2.5", 1, 1, r"M2\.5 is not a known M-code"),
    ("M-2", 1, 1, "M-2 is not a known M-code"),
    ("M77", 1, 1, "M77 is not a known M-code"),
    # Text.
    ("G0 X1 (no end", 1, 7, "has no end"),
    ("G0 (a (b) c) X1", 1, 7, "another"),
    ("G0 X1 b)", 1, 7, "B has no number"),
    ("G0 X1 )", 1, 7, r"'\)' has no matching"),
    ("G0 X1, Y2", 1, 6, "decimal point"),
    ("G0 X1,5", 1, 6, "decimal point"),
    ("G0 X1*55", 1, 6, "checksums"),
    ("G0 X1 !", 1, 7, "'!' has no meaning"),
    ("G0 X1\u00a0Y2", 1, 6, r"'\\xa0' has no meaning"),
    ("G0 X\u0661", 1, 4, "X has no number"),
    ("G0 X1 \x00", 1, 7, r"'\\x00' has no meaning"),
    ("G0 X", 1, 4, "X has no number"),
    ("G0 XY", 1, 4, "X has no number"),
    ("G0 X(one)1", 1, 4, "X has no number"),
    ("G0 X1(one)0", 1, 11, "'0' has no meaning"),
    ("G0 X.", 1, 4, r"X\. is not a number"),
    ("G0 X-", 1, 4, "X- is not a number"),
    ("G0 X1.2.3", 1, 4, r"X1\.2\.3 is not a number"),
    ("G0 X--", 1, 6, "a number is missing"),
    ("G0 X1e3", 1, 6, "uses E: .*exponents"),
    ("G0 X1 N10", 1, 7, "first on its line"),
    ("(c) N10 G0 X1", 1, 5, "first on its line"),
    ("N10 N20 G0 X1", 1, 5, "first on its line"),
    ("N-1 G0 X1", 1, 1, "sign"),
    ("N G0 X1", 1, 1, "N has no number"),
    ("(c)\n%\nG0 X1\n%", 2, 1, "% to open"),
    ("G0 X1\n  %", 2, 3, "% to open"),
    ("% part\nG0 X1\n%", 1, 1, "% is only allowed alone"),
    ("G0 X1 %\nM2", 1, 7, "% is only allowed alone"),
    # Absurd numbers.
    ("G0 X99999999999", 1, 4, "too large"),
    ("G0 X" + "9" * 400, 1, 4, r"X9{20}\.\.\. is too large"),
    ("G0 X0." + "0" * 200 + "1", 1, 4, "too large"),
    ("G0 X1000001", 1, 4, "1000 m"),
    ("G91 G0 X900000\nX900000", 2, 1, "1000 m"),
    ("G4 P100000", 1, 4, "in seconds"),
    ("F10 G2 X1 R900000000", 1, 11, "900000 m"),
    # Grammar of a block.
    ("G0 X1 Y2 X3", 1, 10, "two X words"),
    ("G1 F10 X1 F20", 1, 11, "two F words"),
    ("G0 G1 X1", 1, 4, "G0 and G1 cannot share a block"),
    ("G1 G1 X1", 1, 4, "G1 and G1 cannot share a block"),
    ("G90 G91", 1, 5, "G90 and G91"),
    ("G90.1 G91.1", 1, 7, r"G90\.1 and G91\.1"),
    ("G17 G18", 1, 5, "G17 and G18"),
    ("G20 G21", 1, 5, "G20 and G21"),
    ("M2 M30", 1, 4, "M2 and M30"),
    ("X1", 1, 1, "X has no motion code"),
    ("F10 Z1 Y2", 1, 8, "Y has no motion code"),
    ("G1 X1", 1, 1, "G1 has no feedrate"),
    ("F0\nG1 X1", 2, 1, "G1 has no feedrate"),
    ("G1\nX1", 1, 1, "G1 has no feedrate"),
    ("G2 I5", 1, 1, "G2 has no feedrate"),
    ("F-5", 1, 1, "cannot be negative"),
    ("G4", 1, 1, "G4 has no time"),
    ("G4 P-1", 1, 4, "in seconds"),
    ("G1 F10 X1 I5", 1, 11, "uses I: .*G2, G3, G5, G5.1 or G87"),
    ("G0 X1 R5", 1, 7, "uses R"),
    ("G0 X1 P5", 1, 7, "uses P"),
    ("K5", 1, 1, "uses K"),
    ("F10 G2 I5\nR5", 2, 1, "uses R"),
    ("F10 G2 I5 G4 P1", 1, 14, "use P"),
    # Arcs.
    ("F10 G2 X1", 1, 5, "G2 has neither centre nor radius"),
    ("F10 G3", 1, 5, "G3 has neither centre nor radius"),
    ("F10 G2 I5\nX1", 2, 1, "G2 has neither centre nor radius"),
    ("F10 G2 X1 R5 I1", 1, 11, "either the radius or the centre"),
    ("F10 G2 X1 I5 K1", 1, 14, "K has no meaning for an arc in the XY plane"),
    ("G18 F10 G2 X1 J5", 1, 15, "J has no meaning for an arc in the ZX plane"),
    ("G19 F10 G2 Y1 I5", 1, 15, "I has no meaning for an arc in the YZ plane"),
    ("F10 G2 Z1 R5", 1, 11, "needs X or Y"),
    ("G18 F10 G2 Y1 R5", 1, 15, "needs Z or X"),
    ("F10 G2 X0 R5", 1, 11, "cannot end where it starts"),
    ("F10 G2 X10 R4.998", 1, 12, r"R = 4\.998 mm cannot reach the end point, .* 5 mm"),
    ("F10 G2 X10 R0", 1, 12, "no radius"),
    ("F10 G2 I0 J0", 1, 8, "no radius: its centre is its start"),
    ("F10 G2 X1 I1", 1, 11, "no radius: its centre is its end"),
    ("F10 G2 X20.0284 I10", 1, 17, r"10 mm at the arc's start but 10\.0284 mm at its end"),
    ("F10 G2 X20.05 I10", 1, 15, r"10 mm at the arc's start but 10\.05 mm at its end"),
    ("F10 G2 X200.15 I100", 1, 16, r"100 mm at the arc's start but 100\.15 mm at its end"),
    ("F10 G20 G2 X2.0029 I1", 1, 20, r"1 in at the arc's start but 1\.0029 in at its end"),
    ("F10 G2 X12005 I6000", 1, 15, "6000 mm at the arc's start but 6005 mm"),
    ("G90.1 F10 G2 X10 I5", 1, 18, "with G90.1 an arc needs both"),
    ("G90.1 G18 F10 G2 X10 I5", 1, 22, "with G90.1 an arc needs both"),
    ("F10 G2 X10 I5 P0", 1, 15, "number of turns"),
    ("F10 G2 X10 I5 P1.5", 1, 15, "number of turns"),
    # The program as a whole.
    ("", 0, 0, "contains no motion"),
    ("M2", 0, 0, "contains no motion"),
    ("%\n%", 0, 0, "contains no motion"),
    ("(only words)\nG4 P1\nG21 F100\nM2", 0, 0, "contains no motion"),
    ("G0 X1\nX2\n", 2, 0, "no end: add M2 or M30 at the end"),
    ("%\nG0 X1", 2, 0, "no end: add a line with % at the end"),
]


@each("text, line, column, message", REFUSED)
def test_refusals(text: str, line: int, column: int, message: str) -> None:
    with pytest.raises(ProgramError, match=message) as caught:
        parse_program(text, "part.ngc")
    error = caught.value
    assert (error.file, error.line, error.column) == ("part.ngc", line, column)
    assert ": " in error.message  # problem: remedy


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
