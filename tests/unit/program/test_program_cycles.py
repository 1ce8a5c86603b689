"""Canned cycles and splines: strokes by hand, and end conditions of the curves."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from each import each
from refusals import refuses

from contourlab.errors import ProgramError
from contourlab.geometry import Nurbs
from contourlab.program import Dwell, Feed, Spline, Traverse, parse_program

HEAD = "G21 F60 S100 M3\n"


def strokes(text: str) -> list[tuple[str, tuple[float, ...] | float]]:
    """Return kind and end [mm] or time [s] of each move."""
    found: list[tuple[str, tuple[float, ...] | float]] = []
    for move in parse_program(f"{HEAD}{text}\nM2").moves:
        if isinstance(move, Dwell):
            found.append(("wait", move.seconds))
        else:
            kind = {Traverse: "rapid", Feed: "feed"}[type(move)]
            found.append((kind, tuple(round(1e3 * value, 9) + 0.0 for value in move.end)))
    return found


def test_drilling_in_a_row() -> None:
    """Level 5, clearance 2: G98 returns to 5, G99 to 2; with G91, R and Z count from the start of the row, and L steps on."""
    assert strokes("G0 Z5\nG98 G81 X1 Y2 Z-3 R2\nG99 X4\nX5 L2")[1:] == [
        ("rapid", (1, 2, 5)), ("rapid", (1, 2, 2)), ("feed", (1, 2, -3)), ("rapid", (1, 2, 5)),
        ("rapid", (4, 2, 5)), ("rapid", (4, 2, 2)), ("feed", (4, 2, -3)), ("rapid", (4, 2, 2)),
        ("rapid", (5, 2, 2)), ("feed", (5, 2, -3)), ("rapid", (5, 2, 2)), ("feed", (5, 2, -3)), ("rapid", (5, 2, 2)),
    ]  # fmt: skip
    assert strokes("G0 Z5\nG91 G99 G81 X1 Z-3 R-2 L2")[1:] == [
        ("rapid", (1, 0, 5)), ("rapid", (1, 0, 3)), ("feed", (1, 0, 0)), ("rapid", (1, 0, 3)),
        ("rapid", (2, 0, 3)), ("feed", (2, 0, 0)), ("rapid", (2, 0, 3)),
    ]  # fmt: skip


def test_a_start_below_the_clearance_rises_first() -> None:
    assert strokes("G81 X1 Z-3 R2") == [
        ("rapid", (0, 0, 2)), ("rapid", (1, 0, 2)), ("feed", (1, 0, -3)), ("rapid", (1, 0, 2)),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("code", "tail"),
    [
        ("G82 P0.5", [("feed", -3), ("wait", 0.5), ("rapid", 2)]),
        ("G85", [("feed", -3), ("feed", 2)]),
        ("G86 P0.5", [("feed", -3), ("wait", 0.5), ("rapid", 2)]),
        ("G89 P0.25", [("feed", -3), ("wait", 0.25), ("feed", 2)]),
        ("G84", [("feed", -3), ("feed", 2)]),
        ("G73 Q2", [("feed", 0), ("rapid", 0.254), ("feed", -2), ("rapid", -1.746), ("feed", -3), ("rapid", 2)]),
        (
            "G83 Q2",
            [("feed", 0), ("rapid", 2), ("rapid", 0.254), ("feed", -2), ("rapid", 2), ("rapid", -1.746), ("feed", -3), ("rapid", 2)],
        ),
        ("G83 Q9", [("feed", -3), ("rapid", 2)]),
    ],
)
def test_strokes(code: str, tail: list[tuple[str, float]]) -> None:
    made = strokes(f"G0 Z2\n{code} X1 Z-3 R2")[2:]
    assert [(kind, end[2] if isinstance(end, tuple) else end) for kind, end in made] == tail


@pytest.mark.parametrize(("plane", "words", "last"), [("G18", "Z1 X2 Y-3", (2, 2, 1)), ("G19", "Y1 Z2 X-3", (2, 1, 2))])
def test_cycles_work_normal_to_their_plane(plane: str, words: str, last: tuple[float, ...]) -> None:
    made = strokes(f"{plane} G99 G81 {words} R2")
    assert made[-1] == ("rapid", last)
    assert made[-2][0] == "feed"


def test_tapping_reverses_the_spindle() -> None:
    program = parse_program(f"{HEAD}G84 X1 Z-3 R2\nM2")
    assert [event.word for event in program.events] == ["S", "M3", "M5", "M4", "M5", "M3"]
    assert "M4" in [event.word for event in program.events if event.source_line == 2]


def test_a_cycle_moves_exactly_and_keeps_the_mode() -> None:
    moves = parse_program(f"{HEAD}G64 P0.1 G0 Z5\nG81 X1 Z-3 R2\nG0 X3\nM2").moves
    assert [move.mode.control for move in moves] == ["blend", *["exact_path"] * 4, "blend"]  # type: ignore[union-attr]


def test_pecks_sum_exactly() -> None:
    """Ten times 0.9 mm is 9 mm despite rounding."""
    feeds = [end for kind, end in strokes("G0 Z-1\nG83 X5 Z-10 R-1 Q0.9") if kind == "feed"]
    assert len(feeds) == 10


@each(
    "text, column, message",
    [
        ("G81 X1", 1, "CL830 .*Z"),
        ("G81 X1 Z-1", 1, "CL830 .*R"),
        ("G18 G81 X1 Z1 R1", 5, "CL830 .*Y"),
        ("G82 X1 Z-1 R1", 1, "CL830"),
        ("G83 X1 Z-1 R1", 1, "CL830"),
        ("G83 X1 Z-1 R1 Q0", 1, "CL831"),
        ("G83 X1 Z-900 R1 Q0.001", 1, "CL831 .*100000"),
        ("G81 X1 Z5 R1", 1, "CL831"),
        ("G81 X1 Z-1 R1 L0", 15, "CL806"),
        ("G81 X1 Z-1 R1 L1.5", 15, "CL806"),
        ("G82 X1 Z-1 R1 P-1", 15, "CL806"),
        ("G74 X1 Z-1 R1", 1, "CL832 .*M4"),
        ("M4 G84 X1 Z-1 R1", 4, "CL832 .*M3"),
        ("M5 G86 X1 Z-1 R1 P1", 4, "CL832"),
        ("G93 G81 X1 Z-1 R1", 5, "CL816"),
        ("G81 R1", 1, "CL813"),
        ("G74 X1 Z-1 R1 L2", 15, "CL811"),
        ("G87 X1 Z-1 R1", 1, "CL830"),
    ],
)
def test_cycle_refusals(text: str, column: int, message: str) -> None:
    with pytest.raises(ProgramError) as caught:
        parse_program(f"{HEAD}{text}\nM2")
    assert re.match(message, f"{caught.value.code} {caught.value.message}")
    assert (caught.value.line, caught.value.column) == (2, column)


def test_remembered_words_end_with_a_change_of_units() -> None:
    with refuses(ProgramError, "G81.*depth", line=4):
        parse_program(f"{HEAD}G81 X1 Z-1 R1\nG20\nX2\nM2")
    assert parse_program(f"{HEAD}G81 X1 Z-1 R1\nG20\nX2 Z-1 R1\nM2").moves[-1].end == (0.0508, 0.0, 0.0254)  # type: ignore[union-attr]


# Splines


def spline(text: str) -> tuple[Spline, Nurbs]:
    (move,) = [m for m in parse_program(f"G21 F60\n{text}\nM2").moves if isinstance(m, Spline)]
    return move, Nurbs(move.degree, move.points, move.knots, move.weights)


def test_a_cubic_starts_and_ends_along_its_handles() -> None:
    move, curve = spline("G0 X1 Y1\nG5 X5 Y1 I1 J2 P-1 Q3")
    ends = curve.raw(np.array([curve.first, curve.last]), 1)
    assert ends[0] == pytest.approx(np.array([[0.001, 0.001, 0.0], [0.005, 0.001, 0.0]]))
    assert ends[1] == pytest.approx(3.0 * np.array([[0.001, 0.002, 0.0], [0.001, -0.003, 0.0]]))
    assert move.degree == 3


def test_a_cubic_without_a_handle_continues_smoothly() -> None:
    first, second = [m for m in parse_program("G21 F60\nG5 X5 Y1 I1 J2 P-1 Q3\nG5 X9 Y0 P0 Q1\nM2").moves if isinstance(m, Spline)]
    assert np.subtract(second.points[1], second.points[0]) == pytest.approx(np.subtract(first.points[3], first.points[2]), abs=1e-18)


def test_a_quadratic_is_the_parabola() -> None:
    """Handle (2, 4) from (0, 0) to (4, 0): x = 4u, y = 8u(1 - u)."""
    _, curve = spline("G5.1 X4 Y0 I2 J4")
    u = np.linspace(0.0, 1.0, 7)
    point = curve.raw(curve.first + u * (curve.last - curve.first), 0)[0]
    assert 1e3 * point == pytest.approx(np.column_stack([4 * u, 8 * u * (1 - u), 0 * u]))


def test_a_nurbs_of_order_three_is_a_quarter_circle() -> None:
    """Weights 1, sqrt(1/2), 1 on the corners of a square, as in textbooks."""
    _, curve = spline(f"G0 X10 Y0\nG5.2 X10 Y10 P{math.sqrt(0.5):.15f} L3\nX0 Y10 P1\nG5.3")
    point = curve.raw(np.linspace(curve.first, curve.last, 50), 0)[0]
    assert np.hypot(point[:, 0], point[:, 1]) == pytest.approx(0.01, rel=1e-12)
    assert point[-1] == pytest.approx([0.0, 0.01, 0.0])


@each(
    "text, line, message",
    [
        ("G5 X1 Y1 P1 Q1", 2, "CL825"),
        ("G5 X1 Y1 I1 P1 Q1", 2, "CL825"),
        ("G5 X1 Y1 I1 J1 P1", 2, "CL825"),
        ("G5.1 X1 Y1", 2, "CL825"),
        ("G18 G5 X1 Y1 I1 J1 P1 Q1", 2, "CL816"),
        ("G5 X1 Y1 Z1 I1 J1 P1 Q1", 2, "CL816"),
        ("G93\nG5 X1 Y1 I1 J1 P1 Q1", 3, "CL816"),
        ("G5.2 X1 P1", 2, "CL825"),
        ("G5.2 X1 Y1", 2, "CL825"),
        ("G5.2 X1 Y1 P0", 2, "CL825"),
        ("G5.2 X1 Y1 P1 L1", 2, "CL806"),
        ("G5.2 X1 Y1 P1\nG5.3", 3, "CL826"),
        ("G5.2 X1 Y1 P1\nG1 X2", 3, "CL826"),
        ("G5.3", 2, "CL826"),
    ],
)
def test_spline_refusals(text: str, line: int, message: str) -> None:
    with pytest.raises(ProgramError) as caught:
        parse_program(f"G21 F60\n{text}\nM2")
    assert re.match(message, f"{caught.value.code} {caught.value.message}")
    assert caught.value.line == line
