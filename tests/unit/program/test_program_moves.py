"""Single moves: coordinates, units, modes, arcs in all planes; expected values by hand."""

import math

import pytest

from contourlab.program import Arc, Dwell, Feed, Move, Traverse, parse_program


def moves(*lines: str) -> tuple[Move, ...]:
    return parse_program("\n".join((*lines, "M2"))).moves


def only_arc(*lines: str) -> Arc:
    (arc,) = [move for move in moves(*lines) if isinstance(move, Arc)]
    return arc


def test_traverse_and_feed_in_millimetres() -> None:
    assert moves("G0 X10 Y-2.5", "G1 Z-1 F600") == (
        Traverse((0.0, 0.0, 0.0), (0.01, -0.0025, 0.0), 1),
        Feed((0.01, -0.0025, 0.0), (0.01, -0.0025, -0.001), 0.01, 2),
    )


def test_inches() -> None:
    (move,) = moves("G20 G1 X1 F60")
    assert isinstance(move, Feed)
    assert move.end == (0.0254, 0.0, 0.0)
    assert move.feedrate == 0.001  # F was read before G20: 60 mm/min


def test_motion_is_modal() -> None:
    kinds = [type(move) for move in moves("G1 F100 X1", "X2", "G0", "X3", "Y1", "G1 Y2")]
    assert kinds == [Feed, Feed, Traverse, Traverse, Feed]


def test_feedrate_is_modal() -> None:
    assert [move.feedrate for move in moves("F60 G1 X1", "X2", "F120", "X3") if isinstance(move, Feed)] == [
        0.001,
        0.001,
        0.002,
    ]


def test_incremental_distance() -> None:
    ends = [move.end for move in moves("G91 G0 X1", "X1 Y1", "G90 X1") if isinstance(move, Traverse)]
    assert ends == [(0.001, 0.0, 0.0), (0.002, 0.001, 0.0), (0.001, 0.001, 0.0)]


def test_every_move_starts_at_the_end_of_the_previous_one() -> None:
    made = moves("G1 F100 X1 Y1", "G3 X3 Y1 I1 J0", "G4 P1", "G2 X5 R1", "G0 X0")
    travelled = [move for move in made if not isinstance(move, Dwell)]
    assert travelled[0].start == (0.0, 0.0, 0.0)
    assert [move.start for move in travelled[1:]] == [move.end for move in travelled[:-1]]


def test_moves_of_zero_length_are_left_out() -> None:
    assert [move.source_line for move in moves("G1 F100", "X1", "X1", "Y0", "G91 X0", "G4 P0", "X1")] == [2, 7]


def test_tiny_increments_are_accumulated() -> None:
    # 5000 steps of 1e-9 mm are each too short for a move, but their sum is not.
    end = moves("G91 G0 X1", *["X0.0000000009"] * 5000, "Y1")[-1].end  # type: ignore[union-attr]
    assert end[0] == pytest.approx(0.001 + 5000 * 0.9e-12, abs=2e-12)


def test_an_arc_after_too_short_steps_starts_where_the_last_move_ended() -> None:
    first, arc = moves("G91 G0 X1", "X0.0000000009", "G3 I5 F100")
    assert isinstance(first, Traverse)
    assert isinstance(arc, Arc)
    assert arc.start == first.end
    assert arc.end[0] > first.end[0]


@pytest.mark.parametrize(("plane", "offset"), [("G17", "I5"), ("G17", "J5"), ("G18", "K5"), ("G19", "K5")])
def test_an_offset_alone_repeats_the_modal_arc(plane: str, offset: str) -> None:
    assert [type(move) for move in moves(f"{plane} F100", f"G2 {offset}", offset)] == [Arc, Arc]


def test_quarter_arcs_of_both_senses() -> None:
    ccw = only_arc("G0 X10", "G3 X0 Y10 I-10 J0 F600")
    assert ccw == Arc((0.01, 0.0, 0.0), (0.0, 0.01, 0.0), (0.0, 0.0, 0.0), "XY", 1, 0.01, 2)
    assert ccw.sweep == pytest.approx(math.pi / 2)
    cw = only_arc("G0 X10", "G2 X0 Y10 I-10 J0 F600")
    assert cw.turns == -1
    assert cw.sweep == pytest.approx(-3 * math.pi / 2)


@pytest.mark.parametrize(("code", "sense"), [("G2", -1), ("G3", 1)])
def test_full_circle_needs_no_axis_words(code: str, sense: int) -> None:
    arc = only_arc("G0 X10", f"{code} I-10 F600")
    assert (arc.start, arc.end, arc.centre) == ((0.01, 0.0, 0.0), (0.01, 0.0, 0.0), (0.0, 0.0, 0.0))
    assert arc.sweep == pytest.approx(sense * 2 * math.pi)


def test_p_gives_the_number_of_turns() -> None:
    arc = only_arc("G0 X10", "G2 X0 Y10 Z3 I-10 P3 F600")
    assert arc.turns == -3
    assert arc.sweep == pytest.approx(-(1.5 + 4.0) * math.pi)


def test_helix_centre_is_at_the_height_of_the_start() -> None:
    arc = only_arc("G0 X10 Z5", "G3 X10 Z-2 I-10 J0 F600")
    assert arc.centre == (0.0, 0.0, 0.005)
    assert arc.end == (0.01, 0.0, -0.002)
    assert arc.radius == 0.01


@pytest.mark.parametrize(
    ("plane", "name", "start", "words", "centre", "end"),
    [
        # A quarter turn, counterclockwise seen from the tip of the normal: first axis to second axis.
        ("G17", "XY", "X10", "X0 Y10 I-10 J0", (0.0, 0.0, 0.0), (0.0, 0.01, 0.0)),
        ("G18", "ZX", "Z10", "Z0 X10 K-10 I0", (0.0, 0.0, 0.0), (0.01, 0.0, 0.0)),
        ("G19", "YZ", "Y10", "Y0 Z10 J-10 K0", (0.0, 0.0, 0.0), (0.0, 0.0, 0.01)),
    ],
)
def test_planes_are_right_handed(plane: str, name: str, start: str, words: str, centre: tuple[float, ...], end: tuple[float, ...]) -> None:
    arc = only_arc(f"{plane} G0 {start}", f"G3 {words} F600")
    assert (arc.plane, arc.centre, arc.end, arc.turns) == (name, centre, end, 1)
    assert arc.sweep == pytest.approx(math.pi / 2)


@pytest.mark.parametrize(
    ("words", "centre", "sweep"),
    [
        ("G3 X10 R10", (5.0, math.sqrt(75.0)), math.pi / 3),
        ("G3 X10 R-10", (5.0, -math.sqrt(75.0)), 5 * math.pi / 3),
        ("G2 X10 R10", (5.0, -math.sqrt(75.0)), -math.pi / 3),
        ("G2 X10 R-10", (5.0, math.sqrt(75.0)), -5 * math.pi / 3),
        ("G3 X10 R5", (5.0, 0.0), math.pi),
        ("G3 X10 R4.9995", (5.0, 0.0), math.pi),  # half a micrometre too small: a semicircle
    ],
)
def test_radius_form(words: str, centre: tuple[float, float], sweep: float) -> None:
    arc = only_arc(f"{words} F600")
    assert arc.centre == pytest.approx((centre[0] / 1000, centre[1] / 1000, 0.0), abs=1e-15)
    assert arc.sweep == pytest.approx(sweep)


def test_a_semicircle_with_a_rounded_radius_keeps_its_centre() -> None:
    # R is slightly above half the chord: without care its square root would shift the centre by 30 nm.
    arc = only_arc("G0 X0.1 Y0.2", "G3 X0.4 Y0.6 R0.25000000000001 F600")
    assert arc.centre[:2] == pytest.approx((0.00025, 0.0004), abs=1e-15)


def test_absolute_centre() -> None:
    arc = only_arc("G90.1 G0 X10 Y5", "G3 X0 Y15 I0 J5 F600")
    assert arc.centre == (0.0, 0.005, 0.0)
    assert only_arc("G90.1 G0 X10", "G91.1 G3 X0 Y10 I-10 F600").centre == (0.0, 0.0, 0.0)


def test_centre_is_incremental_in_incremental_distance_too() -> None:
    arc = only_arc("G0 X10", "G91 G3 X-10 Y10 I-10 F600")
    assert (arc.end, arc.centre) == ((0.0, 0.01, 0.0), (0.0, 0.0, 0.0))


@pytest.mark.parametrize(
    ("line", "mismatch"),
    [
        ("G21 G2 X20.028 I10", 28e-6),  # below 0.02 sqrt(2) mm
        ("G21 G2 X200.09 I100", 90e-6),  # more, but below 0.1 %
        ("G20 G2 X2.0028 I1", 2.8e-3 * 0.0254),
    ],
)
def test_radii_may_differ_slightly(line: str, mismatch: float) -> None:
    assert only_arc(f"{line} F600").radius_mismatch == pytest.approx(mismatch, rel=1e-6)


def test_a_sweep_near_zero_is_a_full_circle() -> None:
    assert only_arc("G0 X10", "G3 X10 Y0.000001 I-10 F600").sweep == pytest.approx(2 * math.pi)
    assert only_arc("G0 X10", "G3 X10 Y0.001 I-10 F600").sweep == pytest.approx(1e-4)


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("G1 @10 ^30", (5.0 * math.sqrt(3.0), 5.0)),
        ("G1 @-5 ^90", (0.0, -5.0)),
        ("G1 X3 Y4\n^90", (0.0, 5.0)),
        ("G1 X3 Y4\n@10", (6.0, 8.0)),
        ("G1 X5\nG91 @1 ^90", (0.0, 6.0)),
        ("G1 X5\nG91 ^-90", (0.0, -5.0)),
        ("G1 X5\nG3 @5 ^180 I-5", (-5.0, 0.0)),
        ("G18 G1 @5 ^90 Z2", (0.0, 5.0)),
        ("G1 @[2 + 3] ^[9 * 10]", (0.0, 5.0)),
    ],
)
def test_polar_coordinates(text: str, end: tuple[float, float]) -> None:
    last = parse_program(f"G21 F100\n{text}\nM2").moves[-1]
    assert last.end[:2] == pytest.approx((1e-3 * end[0], 1e-3 * end[1]), abs=1e-17)  # type: ignore[union-attr]
