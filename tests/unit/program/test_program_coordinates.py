"""Work coordinate systems, shifts, home positions and tool lengths: end positions in closed form."""

from __future__ import annotations

import math
import re
from pathlib import Path

import pytest
from each import each
from hypothesis import given
from hypothesis import strategies as st
from refusals import refuses

from contourlab.errors import ProgramError
from contourlab.program import Arc, Dwell, Reading, parse_program
from contourlab.program.state import Frame, read_tools

lengths = st.floats(-10.0, 10.0)
points = st.tuples(lengths, lengths, lengths)


@given(points, points, points, points, st.floats(-720.0, 720.0))
def test_a_frame_and_its_inverse(point: tuple[float, float, float], origin: tuple[float, float, float], shift: tuple[float, float, float],
                          tool: tuple[float, float, float], rotation: float) -> None:  # fmt: skip
    frame = Frame(origin=origin, rotation=rotation, shift=shift, tool=tool)
    frame.refresh()
    assert frame.point(frame.axes(point)) == pytest.approx(point, abs=1e-13)


def test_the_order_of_offsets() -> None:
    """First the shift, then the rotation, then origin and tool: 1 + 1 = 2 along x becomes 2 along y."""
    frame = Frame(origin=(10.0, 0.0, 0.0), rotation=90.0, shift=(1.0, 0.0, 0.0), tool=(0.0, 0.0, 5.0))
    frame.refresh()
    assert frame.axes((1.0, 0.0, 0.0)) == pytest.approx((10.0, 2.0, 5.0))


def last(text: str) -> tuple[float, float, float]:
    """Return the final position of the axes [mm]."""
    move = [m for m in parse_program(f"G21 F100\n{text}\nM2").moves if not isinstance(m, Dwell)][-1]
    x, y, z = move.end
    return (1e3 * x, 1e3 * y, 1e3 * z)


HALF = math.sqrt(0.5)


@each(
    "text, wanted",
    [
        ("G10 L2 P1 X5 Y6\nG0 X1", (6, 0, 0)),
        ("G10 L2 P2 X5\nG0 X1", (1, 0, 0)),
        ("G10 L2 P2 X5\nG55 G0 X1 Y1", (6, 1, 0)),
        ("G10 L2 P9 Z5\nG59.3\nG0 Z1", (0, 0, 6)),
        ("G10 L2 P1 R45\nG0 X10", (10 * HALF, 10 * HALF, 0)),
        ("G10 L2 P1 R45\nG91 G0 Y10", (-10 * HALF, 10 * HALF, 0)),
        ("G10 L2 P0 X5\nG91 G0 X1", (1, 0, 0)),
        ("G0 X5\nG10 L20 P1 X0\nG0 X1", (6, 0, 0)),
        ("G0 X5 Y5\nG10 L20 P0 X1 Y1\nG0 X2 Y2", (6, 6, 0)),
        ("G10 L2 P1 R90\nG0 X3\nG10 L20 P1 X0\nG0 X1", (0, 4, 0)),
        ("G0 X5\nG92 X0\nG0 X1", (6, 0, 0)),
        ("G0 X5\nG92 X0\nG92.1\nG0 X1", (1, 0, 0)),
        ("G0 X5\nG92 X0\nG92.2\nG92.3\nG0 X1", (6, 0, 0)),
        ("G0 X5\nG92 X0\nG92.1\nG92.3\nG0 X1", (1, 0, 0)),
        ("G52 X5\nG0 X1", (6, 0, 0)),
        ("G52 X5\nG52 X7\nG0 X1", (8, 0, 0)),
        ("G10 L2 P1 X5\nG0 X1\nG90 G53 G0 X1 Y2", (1, 2, 0)),
        ("G10 L2 P1 R30\nG53 G0 X1 Y2", (1, 2, 0)),
        ("G20\nG10 L2 P1 X1\nG21\nG0 X1", (26.4, 0, 0)),
        ("#5221 = 9\nG0 X1", (1, 0, 0)),
        ("#5221 = 9\nG54 G0 X1", (1, 0, 0)),
        ("#5221 = 9\nG55\nG54 G0 X1", (10, 0, 0)),
        ("#5241 = 9\nG55\nG0 X1", (10, 0, 0)),
        ("G0 X3 Y4\nG28.1\nG0 X9\nG28", (3, 4, 0)),
        ("G0 X3 Y4 Z5\nG30.1\nG0 X9 Y9 Z9\nG30 Z12", (9, 9, 5)),
        ("#5161 = 7 #5162 = 8\nG28", (7, 8, 0)),
        ("G10 L2 P1 X100\n#5161 = 7\nG0 X0\nG28 X0", (7, 0, 0)),
        ("G43.1 Z10\nG0 Z1", (0, 0, 11)),
        ("G43.1 X1 Y2 Z3\nG0 X0 Y0 Z0", (1, 2, 3)),
        ("G43.1 Z10\nG43.2 Z5\nG0 Z1", (0, 0, 16)),
        ("G43.1 Z10\nG49\nG0 Z1", (0, 0, 1)),
        ("G10 L1 P3 Z7\nG43 H3\nG0 Z1", (0, 0, 8)),
        ("G10 L1 P3 Z7\nT3 M6\nG43\nG0 Z1", (0, 0, 8)),
        ("T3 M6\nG0 Z20\nG10 L10 P3 Z5\nG43\nG0 Z1", (0, 0, 16)),
        ("G10 L2 P9 Z-4\nT3 M6\nG0 Z20\nG10 L11 P3 Z5\nG43\nG0 Z1", (0, 0, 20)),
        ("G43.1 Z10\nG20\nG0 Z1", (0, 0, 35.4)),
        ("G7 G0 X10", (5, 0, 0)),
        ("G7\nG0 X10\nG8\nG0 X10", (10, 0, 0)),
        ("G7\nG91 G0 X10", (5, 0, 0)),
    ],
)
def test_final_positions(text: str, wanted: tuple[float, float, float]) -> None:
    assert last(text) == pytest.approx(wanted, abs=1e-12)


def test_a_home_move_goes_through_the_given_point() -> None:
    moves = parse_program("#5161 = 7 #5163 = 3\nG28 Z9\nM2").moves
    assert [move.end for move in moves] == [(0.0, 0.0, 0.009), (0.0, 0.0, 0.003)]  # type: ignore[union-attr]


@pytest.mark.parametrize("plane", ["G17", "G18", "G19"])
@pytest.mark.parametrize("angle", [0, 30, -77.7, 180])
def test_an_arc_rotates_with_its_coordinate_system(plane: str, angle: float) -> None:
    """Radius and sweep are those of the unrotated arc; the centre rotates with the points."""
    words = {"G17": "X0 Y10 I-10", "G18": "Z0 X10 K-10", "G19": "Y0 Z10 J-10"}[plane]
    start = {"G17": "X10", "G18": "Z10", "G19": "Y10"}[plane]
    arc = parse_program(f"G21 F100 G10 L2 P1 X3 Y-4 R{angle}\n{plane} G0 X0 Y0\n{start}\nG3 {words}\nM2").moves[-1]
    assert isinstance(arc, Arc)
    assert arc.radius == pytest.approx(0.01, rel=1e-12)
    assert arc.radius_mismatch == pytest.approx(0.0, abs=1e-15)
    assert arc.sweep == pytest.approx(math.pi / 2)
    assert arc.centre == pytest.approx((0.003, -0.004, 0.0), abs=1e-15)
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    first, second, normal = arc.directions()
    turned = {"x": (c, s, 0.0), "y": (-s, c, 0.0), "z": (0.0, 0.0, 1.0)}
    if plane != "G17":
        assert (first, second, normal) == tuple(pytest.approx(turned[a]) for a in {"G18": "zxy", "G19": "yzx"}[plane])


def test_tools_from_a_table(tmp_path: Path) -> None:
    table = tmp_path / "tool.tbl"
    table.write_text("; the mills\nT1 P1 D3.0 Z+25.4 ; end mill\n\n t5 x1.5 y-2 z.5\n", encoding="utf-8")
    tools = read_tools(table)
    assert tools.offset(1) == (0.0, 0.0, 0.0254)
    assert tools.offset(5) == (0.0015, -0.002, 0.0005)
    assert (tools.offset(9), tools.diameters[1]) == ((0.0, 0.0, 0.0), 0.003)
    move = parse_program("T5 M6\nG43\nG0 X0 Z1\nM2", reading=Reading(tools=table)).moves[0]
    assert move.end == (0.0015, 0.0 - 0.002 + 0.002, 0.0015) or move.end == (0.0015, -0.002, 0.0015)  # type: ignore[union-attr]
    assert move.mode.tool == (0.0015, -0.002, 0.0005)  # type: ignore[union-attr]


@pytest.mark.parametrize(
    ("text", "line", "message"),
    [
        ("T1.5 Z1", 1, "CL849"),
        ("Z1", 1, "CL849"),
        ("T1 Z1 what", 1, "CL849"),
    ],
)
def test_invalid_tool_tables(tmp_path: Path, text: str, line: int, message: str) -> None:
    table = tmp_path / "tool.tbl"
    table.write_text(text, encoding="utf-8")
    with pytest.raises(ProgramError) as caught:
        read_tools(table)
    assert re.match(message, f"{caught.value.code} {caught.value.message}")
    assert (caught.value.file, caught.value.line) == (str(table), line)
    with refuses(ProgramError, "No such file", file=tmp_path / "none.tbl"):
        read_tools(tmp_path / "none.tbl")


@each(
    "text, column, message",
    [
        ("G10 L3 P1 X1", 1, "CL813"),
        ("G10 P1 X1", 1, "CL813"),
        ("G10 L2 X1", 1, "CL813"),
        ("G10 L1 X1", 1, "CL813 .*tool"),
        ("G10 L2 P10 X1", 8, "CL806"),
        ("G10 L2 P1.5 X1", 8, "CL806"),
        ("G10 L20 P1 R5", 12, "CL811"),
        ("G10 L20 P1 I5 X1", 12, "CL811"),
        ("G10 L1 P0 Z1", 8, "CL806"),
        ("G10 L1 P1", 8, "CL813"),
        ("G10 L2 P1 X1 G0", 14, "CL812"),
        ("G92", 1, "CL813"),
        ("G52", 1, "CL813"),
        ("G43.2", 1, "CL813"),
        ("G43.2 H1 Z1", 1, "CL813"),
        ("G43 H1.5", 5, "CL806"),
        ("G53 G80", 1, "CL813"),
        ("G53", 1, "CL813"),
        ("G53 X1", 5, "CL814"),
        ("G91 G53 G0 X1", 5, "CL816"),
        ("G53 G0 @5 ^3", 1, "CL816"),
        ("H1", 1, "CL811"),
    ],
)
def test_refusals(text: str, column: int, message: str) -> None:
    with pytest.raises(ProgramError) as caught:
        parse_program(f"{text}\nM2")
    assert re.match(message, f"{caught.value.code} {caught.value.message}")
    assert (caught.value.line, caught.value.column) == (1, column)
