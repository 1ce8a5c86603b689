"""The shipped circle-diamond-square program against its drawing."""

import math
from importlib.resources import files
from pathlib import Path

import pytest

from contourlab.program import Arc, Dwell, Feed, Move, Program, Traverse, read_program

# Kind, end point [mm]; for arcs the centre in the plane [mm], the sweep [quarter turns, + ccw] and the feedrate
# [mm/min]. Taken from the drawing in the program's header, not from the reader.
DRAWING: list[tuple[object, ...]] = [
    ("traverse", (0, 0, 10)),
    ("traverse", (26, 0, 10)),
    ("traverse", (26, 0, 2)),
    ("arc", (26, 0, -2), (0, 0), 4, 1500),
    ("arc", (26, 0, -2), (0, 0), 4, 2400),
    ("arc", (31, 5, -2), (31, 0), -1, 2400),
    ("dwell", 0.25),
    ("arc", (26, 0, -2), (31, 0), 1, 2400),
    ("arc", (26, 0, -2), (0, 0), -4, 2400),
    ("arc", (31, -5, -2), (31, 0), 1, 2400),
    ("traverse", (31, -5, 5)),
    ("traverse", (19.8, -28.2, 5)),
    ("feed", (19.8, -28.2, -4), 1500),
    ("arc", (19.8, -19.8, -4), (24, -24), -1, 2400),
    ("feed", (39.6, 0, -4), 2400),
    ("feed", (0, 39.6, -4), 2400),
    ("feed", (-39.6, 0, -4), 2400),
    ("feed", (0, -39.6, -4), 2400),
    ("feed", (19.8, -19.8, -4), 2400),
    ("arc", (28.2, -19.8, -4), (24, -24), -1, 2400),
    ("traverse", (28.2, -19.8, 5)),
    ("traverse", (46, -6, 5)),
    ("feed", (46, -6, -6), 1500),
    ("arc", (40, 0, -6), (46, 0), -1, 3000),
    ("feed", (40, 36, -6), 3000),
    ("arc", (36, 40, -6), (36, 36), 1, 3000),
    ("feed", (-36, 40, -6), 3000),
    ("arc", (-40, 36, -6), (-36, 36), 1, 3000),
    ("feed", (-40, -36, -6), 3000),
    ("arc", (-36, -40, -6), (-36, -36), 1, 3000),
    ("feed", (46, -40, -6), 3000),
    ("arc", (40, -46, -6), (46, -46), -3, 3000),
    ("feed", (40, 0, -6), 3000),
    ("arc", (46, 6, -6), (46, 0), -1, 3000),
    ("traverse", (46, 6, 10)),
    ("traverse", (0, 0, 10)),
]


@pytest.fixture(scope="module")
def program() -> Program:
    return read_program(Path(str(files("contourlab") / "machines" / "programs" / "circle_diamond_square.ngc")))


def in_drawing_units(move: Move) -> tuple[object, ...]:
    if isinstance(move, Dwell):
        return ("dwell", move.seconds)
    end = tuple(round(1e3 * value, 9) for value in move.end)
    if isinstance(move, Traverse):
        return ("traverse", end)
    feedrate = round(6e4 * move.feedrate, 9)
    if isinstance(move, Feed):
        return ("feed", end, feedrate)
    centre = tuple(round(1e3 * value, 9) for value in move.centre[:2])
    return ("arc", end, centre, round(move.sweep / (math.pi / 2), 9), feedrate)


def test_moves_agree_with_the_drawing(program: Program) -> None:
    assert [in_drawing_units(move) for move in program.moves] == DRAWING


def test_it_fits_its_envelope(program: Program) -> None:
    for move in program.moves:
        if isinstance(move, Dwell):
            continue
        x, y, z = (1e3 * value for value in move.end)
        reach = 1e3 * move.radius if isinstance(move, Arc) else 0.0
        if isinstance(move, Arc):
            x, y = 1e3 * move.centre[0], 1e3 * move.centre[1]
        assert abs(x) + reach <= 60.0
        assert abs(y) + reach <= 60.0
        assert -10.0 <= z <= 20.0


def test_radii_close_exactly(program: Program) -> None:
    for move in program.moves:
        if isinstance(move, Arc):
            assert abs(move.radius_mismatch) < 1e-15


def test_cutting_lasts_twenty_to_forty_seconds(program: Program) -> None:
    seconds = 0.0
    for move in program.moves:
        if isinstance(move, Feed):
            seconds += math.dist(move.start, move.end) / move.feedrate
        elif isinstance(move, Arc):
            length = math.hypot(move.radius * move.sweep, move.end[2] - move.start[2])
            seconds += length / move.feedrate
        elif isinstance(move, Dwell):
            seconds += move.seconds
    assert 20.0 < seconds < 40.0


def test_it_uses_all_axes_and_names_itself(program: Program) -> None:
    assert program.name == "circle_diamond_square.ngc"
    for move in program.moves:
        assert program.lines[move.source_line - 1].startswith("N")
