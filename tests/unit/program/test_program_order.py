"""RS274/NGC fixes the order of execution within a block, independent of the order of the words."""

import itertools

import pytest

from contourlab.errors import ProgramError
from contourlab.program import Arc, Dwell, Feed, Traverse, parse_program


def test_f_is_read_before_the_units_change() -> None:
    inch, metric = parse_program("G20\nF10\nG21 F10 G1 X1\nG20 F10 X1\nM2").moves
    assert isinstance(inch, Feed)
    assert isinstance(metric, Feed)
    assert inch.feedrate == pytest.approx(10 * 0.0254 / 60, rel=1e-15)
    assert metric.feedrate == pytest.approx(10 * 0.001 / 60, rel=1e-15)


def test_a_change_of_units_keeps_the_feedrate() -> None:
    first, second = parse_program("G21 F60\nG1 X1\nG20\nX1\nM2").moves
    assert isinstance(first, Feed)
    assert isinstance(second, Feed)
    assert first.feedrate == second.feedrate == 0.001


def test_units_change_before_the_motion() -> None:
    assert parse_program("G0 X1 G20\nM2").moves[0].end == (0.0254, 0.0, 0.0)  # type: ignore[union-attr]


def test_g94_clears_an_earlier_feedrate_but_not_the_one_on_its_line() -> None:
    assert isinstance(parse_program("F60\nF120 G1 X1 G94\nM2").moves[0], Feed)
    with pytest.raises(ProgramError, match="G94 clears") as caught:
        parse_program("F60\nG94\nG1 X1\nM2")
    assert (caught.value.line, caught.value.column) == (3, 1)


def test_f_applies_to_the_motion_of_its_block() -> None:
    first, second = parse_program("G1 F60 X1\nX2 F120\nM2").moves
    assert isinstance(first, Feed)
    assert isinstance(second, Feed)
    assert (first.feedrate, second.feedrate) == (0.001, 0.002)


def test_dwell_comes_before_motion() -> None:
    assert [type(move) for move in parse_program("G1 F60 X2 G4 P0.5\nM2").moves] == [Dwell, Feed]


def test_distance_mode_changes_before_the_motion() -> None:
    moves = parse_program("G0 X1\nX1 G91\nM2").moves
    assert moves[-1].end == (0.002, 0.0, 0.0)  # type: ignore[union-attr]


def test_plane_changes_before_the_arc() -> None:
    (arc,) = parse_program("F60 G2 K5 G18\nM2").moves
    assert isinstance(arc, Arc)
    assert arc.plane == "ZX"


def test_arc_distance_mode_changes_before_the_arc() -> None:
    moves = parse_program("G0 X10\nF60 G3 I0 J0 G90.1\nM2").moves
    assert isinstance(moves[1], Arc)
    assert moves[1].centre == (0.0, 0.0, 0.0)


def test_motion_comes_before_the_end() -> None:
    assert parse_program("M2 G0 X1\nG0 X2").moves == (Traverse((0.0, 0.0, 0.0), (0.001, 0.0, 0.0), 1),)


def test_nothing_after_the_end_is_read() -> None:
    assert len(parse_program("G0 X1\nM30\nthis is no G-code (").moves) == 1


def test_the_order_of_words_does_not_matter() -> None:
    words = ("G91", "G20", "F60", "G1", "X1", "G4", "P2")
    want = parse_program(" ".join(words) + "\nM2").moves
    assert len(want) == 2
    for order in itertools.permutations(words):
        assert parse_program(" ".join(order) + "\nM2").moves == want
