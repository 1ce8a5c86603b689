"""Dialects other than LinuxCNC's: which blocks a control refuses, and the moves it makes of the others.

The error numbers of grbl are those that its own parser (gcode.c of 1.1h, compiled with stubs) gave for these lines.
"""

from __future__ import annotations

import pytest

from contourlab.errors import ProgramError
from contourlab.program import Arc, Dwell, Feed, Reading, Traverse, parse_program
from contourlab.program.dialects import DIALECTS, named_in


def read(dialect: str, text: str) -> list[tuple[object, ...]]:
    """Return the moves: kind, end [mm], and feed [mm/min] or seconds."""
    moves = []
    for move in parse_program(text, reading=Reading(dialect=dialect, require_end=False)).moves:  # type: ignore[arg-type]
        if isinstance(move, Dwell):
            moves.append(("dwell", round(move.seconds, 9)))
            continue
        end = tuple(round(1e3 * value, 6) for value in move.end)
        moves.append(
            (type(move).__name__, end) if isinstance(move, Traverse) else (type(move).__name__, end, round(6e4 * move.feedrate, 6))
        )
    return moves


def code(dialect: str, text: str) -> tuple[str, int]:
    """Return code and line of the first fault."""
    with pytest.raises(ProgramError) as caught:
        read(dialect, text)
    return caught.value.code, caught.value.line


GRBL_REFUSES = [
    ("G17 G2 X10 Y0 K5", "CL820", 35), ("G2 I5", "CL820", 26), ("G2 Z1 I5", "CL820", 32), ("G2 X10 I5 P2", "CL820", 36),
    ("G2 X10 R5 K1", "CL811", 36), ("G2 X10 I5.003", "CL821", 33), ("G2 X10 R4.999", "CL822", 34),
    ("G80\nX1", "CL811", 31), ("G80\nG92 X1", "CL811", 31), ("G80 G0 X1", "CL810", 21),
    ("G49 G0 X1", "CL812", 24), ("G43.1 X1", "CL811", 37), ("G0 G28 X1", "CL812", 24), ("G28 G4 P1", "CL810", 21),
    ("G90.1", "CL807", 20), ("G64", "CL807", 20), ("G61.1", "CL807", 20), ("G81 X1 Z-1 R1", "CL807", 20), ("G98", "CL807", 20),
    ("G59.1", "CL807", 23), ("G92.2", "CL807", 20), ("G95", "CL807", 20), ("M6", "CL807", 20), ("G0 X1 Q1", "CL807", 20),
    ("G10 L2 P1", "CL813", 26), ("G10 L2 P7 X1", "CL813", 29), ("G10 L2 P1 R9 X1", "CL813", 20), ("G10 L1 P1 Z1", "CL813", 20),
    ("T256", "CL806", 38), ("G1 X1 F" + "0" * 75, "CL805", 11),
    ("G41 D1", "CL808", 20), ("G0 X[1+1]", "CL808", 2), ("O100 sub", "CL840", 20),
]  # fmt: skip
"""Lines, codes, and the error number of grbl."""


@pytest.mark.parametrize(("line", "expected", "number"), GRBL_REFUSES)
def test_grbl_refuses_what_its_parser_refuses(line: str, expected: str, number: int) -> None:
    assert number > 0
    assert code("grbl", f"G21 G90 F600\nG0 X0 Y0\n{line}") == (expected, 2 + len(line.split("\n")))


def test_grbl_reads_arcs_feeds_and_g53_by_its_own_rules() -> None:
    arc = ("Arc", (10.0, 0.0, 0.0), 400.0)
    assert read("grbl", "G2 X10 Y0 I5 J0 K0.000 F400") == [arc]
    assert read("grbl", "G2 X10 Y0 I5 J0 K9 F400") == [arc]
    assert read("grbl", "G2 X10 Y0 I5.002 F400") == [arc]
    assert read("grbl", "F600\nG94\nG1 X10") == [("Feed", (10.0, 0.0, 0.0), 600.0)]
    assert code("grbl", "F600\nG93\nG94\nG1 X10") == ("CL815", 4)
    assert read("grbl", "G20 F10\nG1 X1") == [("Feed", (25.4, 0.0, 0.0), 254.0)]
    assert read("linuxcnc", "G20 F10\nG1 X1") == [("Feed", (25.4, 0.0, 0.0), 10.0)]
    assert read("grbl", "G0 X1\nG91 G53 X5") == [("Traverse", (1.0, 0.0, 0.0)), ("Traverse", (5.0, 0.0, 0.0))]
    assert read("grbl", "X1 G91.1 M7 (" + "c" * 90 + ")" + " " * 90) == [("Traverse", (1.0, 0.0, 0.0))]


def test_grblhal_has_the_cycles_and_the_arcs_of_grbl() -> None:
    assert read("grblhal", "G2 X10 Y0 I5 J0 K1 F400")[0][0] == "Arc"
    assert len(read("grblhal", "M6 T1\nG2 I5 P2 F400\nG98 G81 X1 Z-1 R1\nG80")) == 5
    assert code("grblhal", "G90.1") == ("CL807", 1)


def test_a_motion_beside_g28_only_sets_the_mode() -> None:
    for dialect in ("fanuc", "mach3"):
        text = "G21 G90 G1 X5. Z3. F100.\nG0 G91 G28 Z2.\nX1."
        assert read(dialect, text)[1:] == [
            ("Traverse", (5.0, 0.0, 5.0)),
            ("Traverse", (5.0, 0.0, 0.0)),
            ("Traverse", (6.0, 0.0, 0.0)),
        ]
    assert code("linuxcnc", text) == ("CL812", 2)


def test_after_g80_the_motion_before_the_cycle_is_in_force() -> None:
    for dialect in ("fanuc", "mach3"):
        cycle = "G0 Z5.\nG98 G81 X1. Z-1. R2. F100.\nG80\n"
        assert read(dialect, cycle + "Z15.")[-1] == ("Traverse", (1.0, 0.0, 15.0))
        assert read(dialect, "G1 X0.5 F50.\n" + cycle.replace("G0 Z5.", "Z5.") + "X3.")[-1] == ("Feed", (3.0, 0.0, 5.0), 100.0)
        assert read(dialect, "G0 Z5.\nG98 G81 X1. Z-1. R2. F100.\nG80 X7.")[-1] == ("Traverse", (7.0, 0.0, 5.0))


def test_mach3_takes_the_last_arc_mode_and_its_own_unit_codes() -> None:
    assert read("mach3", "G90.1 G91.1\nG0 X5.\nG2 X15. I5. F100.")[-1] == ("Arc", (15.0, 0.0, 0.0), 100.0)
    assert read("mach3", "G00G21G17G90G40G49G80\nG70\nG0X1")[-1] == ("Traverse", (25.4, 0.0, 0.0))
    assert code("mach3", "G0 X1\nG20 G21") == ("CL810", 2)
    assert code("mach3", "G0 X1\nG12 I5") == ("CL808", 2)
    assert code("mach3", "O1 if [1 GT 0]\nG0 X1\nO1 endif") == ("CL840", 1)
    assert len(read("mach3", "%\nO1000 (main)\n#1=3\nM98 P20 L2\nM30\nO20\nG91 G0 X#1\nM99\n%")) == 2


FANUC_CYCLES = [
    # G98 from the start; R and Z hold for the next cycle, too, and for other cycles until G80.
    ("G81 X1. Z-3. R2. F60.\nX4.", [(1, 0, 10), (1, 0, 2), (1, 0, -3), (1, 0, 10), (4, 0, 10), (4, 0, 2), (4, 0, -3), (4, 0, 10)]),
    ("G99 G81 X1. Z-3. R2. F60.\nG82 X4. P500", [(1, 0, 10), (1, 0, 2), (1, 0, -3), (1, 0, 2), (4, 0, 2), (4, 0, -3), 0.5, (4, 0, 2)]),
    # K repeats; K0 only stores the data.
    ("G91 G99 G81 X1. Z-3. R-8. K2 F60.", [(1, 0, 10), (1, 0, 2), (1, 0, -1), (1, 0, 2), (2, 0, 2), (2, 0, -1), (2, 0, 2)]),
    ("G99 G81 X1. Z-3. R2. F60. K0\nX4.", [(4, 0, 10), (4, 0, 2), (4, 0, -3), (4, 0, 2)]),
    # Q holds, too; the peck retracts 0.254 mm, or to R.
    ("G99 G73 X1. Z-2. R2. Q2. F60.", [(1, 0, 10), (1, 0, 2), (1, 0, 0), (1, 0, 0.254), (1, 0, -2), (1, 0, 2)]),
    ("G99 G83 X1. Z-2. R2. Q2. F60.", [(1, 0, 10), (1, 0, 2), (1, 0, 0), (1, 0, 2), (1, 0, 0.254), (1, 0, -2), (1, 0, 2)]),
    ("G85 X1. Z-3. R2. F60.", [(1, 0, 10), (1, 0, 2), (1, 0, -3), (1, 0, 2), (1, 0, 10)]),
]


@pytest.mark.parametrize(("text", "points"), FANUC_CYCLES)
def test_cycles_of_fanuc(text: str, points: list[object]) -> None:
    made = read("fanuc", f"O0001\nG21 G90 G0 Z10.\n{text}\nG80\nM30")
    assert [move[1] for move in made[1:]] == [point if isinstance(point, float) else tuple(map(float, point)) for point in points]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("G81 X1. R2. F60.", "CL830"), ("G81 X1. Z-1. R12. F60.", "CL831"), ("G81 X1. Z-1. R2. F60.\nG80\nG81 X2.", "CL830"),
        ("G91 G81 X1. Z-1. R-2. F60.\nG90 X2.", "CL830"), ("G82 X1. Z-1. R2. P500. F60.", "CL806"),
        ("G28", "CL813"), ("G53 G1 X1. F60.", "CL813"), ("G91 G53 G0 X1.", "CL816"), ("G10 L20 P1 X1.", "CL813"),
        ("G76 X1. Z-1. R2. Q1. F60.", "CL808"), ("G5.1 Q1", "CL808"), ("G90.1", "CL807"), ("M60", "CL807"),
        ("#1=5", "CL808"), ("IF[#1EQ1]GOTO5", "CL808"), ("O1 sub", "CL840"), ("G0 G1 X1.", "CL810"),
        ("G52 X1.", "CL808"), ("G4 P500 Z5.", "CL811"), ("G10 L2 P0 X1.", "CL816"),
    ],
)  # fmt: skip
def test_fanuc_refuses(text: str, expected: str) -> None:
    assert code("fanuc", f"G21 G90 G0 Z10.\n{text}")[0] == expected


def test_fanuc_reads_dwells_modes_and_calls() -> None:
    assert read("fanuc", "G0 X1.\nG4 P1500\nG04 X0.25")[1:] == [("dwell", 1.5), ("dwell", 0.25)]
    assert read("fanuc", "G91 G90 G15 G69 G50.1 G0 X1.\nG90 X2.") == [("Traverse", (1.0, 0.0, 0.0)), ("Traverse", (2.0, 0.0, 0.0))]
    assert len(read("fanuc", "G0 X1.\nM98 P00030020\nM30\nO0020\nG91 X1.\nM99")) == 4
    program = parse_program("G61 G1 X1. F60.\nM30", reading=Reading(dialect="fanuc"))
    assert program.moves[0].mode.control == "exact_stop"
    assert isinstance(program.moves[0], Feed)
    notices = parse_program("G0 X1. Y0\nX20 Y3\nM30", reading=Reading(dialect="fanuc")).notices
    assert [(notice.line, notice.column) for notice in notices] == [(2, 1)]


def test_only_those_read_by_a_manual_say_so() -> None:
    assert {name for name, rules in DIALECTS.items() if rules.manual} == {"fanuc", "mach3"}
    assert all(rules.assumed for rules in DIALECTS.values() if rules.manual)


@pytest.mark.parametrize(
    ("head", "names"),
    [
        ("a.nc\n(Post Processor: grbl_post)", ["grbl"]), ("a.nc\n; for FluidNC", ["grblhal"]), ("a.nc\n%\nO0001(PART)", ["fanuc"]),
        ("a.nc\n(vendor: HAAS)", ["fanuc"]), ("a.tap\nG0 X1", ["mach3"]), ("a.nc\nG00G21G80\nG71G91.1", ["mach3"]),
        ("a.ngc\nG21\nO100 sub\nG0 X1", []), ("grblish.ngc\nG0 X1", []),
    ],
)  # fmt: skip
def test_what_a_program_names(head: str, names: list[str]) -> None:
    assert named_in(head) == names


def test_the_arc_keeps_its_centre() -> None:
    (arc,) = parse_program("G2 X10 Y0 I5 J0 K3 F400", reading=Reading(dialect="grbl", require_end=False)).moves
    assert isinstance(arc, Arc)
    assert arc.centre == pytest.approx((5e-3, 0.0, 0.0))
    assert arc.turns == -1
