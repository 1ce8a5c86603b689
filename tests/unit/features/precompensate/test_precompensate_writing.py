"""Corrected programs: only the path of cutting moves changes."""

import re
from pathlib import Path

import numpy as np
import pytest

from contourlab.errors import ProgramError
from contourlab.features.precompensate.reading import contour_of, parse_blocks, read_blocks
from contourlab.features.precompensate.writing import marked, without_motion, write_corrected
from contourlab.program import Dwell, Feed, Reading, parse_program

READING = Reading(require_end=False)
AXES = ("x", "y")
TOLERANCE = 0.5e-6


def corrected(text: str, size: float = 50e-6, reading: Reading = READING) -> tuple[str, list[str]]:
    """Return a program whose path is displaced by a constant vector, and the reasons of moves that stay."""
    source = parse_blocks(text, "part", reading, AXES)
    contour = contour_of(source, AXES, 1e-3)
    written = write_corrected(contour, np.full((len(contour.nodes), 2), size), TOLERANCE)
    again = contour_of(parse_blocks(written.text, "again", reading, AXES), AXES, 1e-3)
    np.testing.assert_allclose(again.path.breaks, written.corrected_arc, atol=1e-8)
    assert [event.word for event in again.source.program.events] == [event.word for event in source.program.events]
    return written.text, [block.reason for block in source.blocks]


@pytest.mark.parametrize(
    ("line", "kept"),
    [
        ("N10 G1 X1 Y2 F300 (out) M8", "N10 F300 (out) M8"),
        ("G2X1.5Y-2I[3*[1+1]]J#<depth>", ""),
        ("#5=3 G1 X#5 Y[sin[30]+#5]", "#5=3"),
        ("g91 g1 @-.0025 ^4.5", "g91"),
        ("G64 P0.01 G1 X2", "G64 P0.01"),
        ("G17 G2 X1 R2 P2 S900 ; X9", "G17 S900 ; X9"),
    ],
)
def test_motion_leaves_the_rest_of_a_line(line: str, kept: str) -> None:
    assert without_motion(line) == kept


def test_lines_and_comments_stay_and_the_path_is_displaced() -> None:
    text = "%\nN1 G21 G90 (start)\nN2 G0 X10 Y0 Z5\nN3 G1 Z0 F100\nN4 G3 X0 Y10 I-10 J0 F600 M8 (arc)\nN5 G0 Z5\nN6 M2\n%\n"
    written, reasons = corrected(text)
    lines = written.splitlines()
    assert [line for line in lines if line.startswith("N")] == [
        "N1 G21 G90 (start)", "N2 G0 X10 Y0 Z5", "N3 G1 Z0 F100", "N4 F600 M8 (arc)", "N5 G0 Z5", "N6 M2",
    ]  # fmt: skip
    assert reasons == ["-", "-", "", "-"]
    moves = [move for move in parse_program(written).moves if isinstance(move, Feed)][1:]
    points = np.array([move.end for move in moves[:-2]])[:, :2] - 50e-6
    assert np.abs(np.hypot(*points.T) - 0.01).max() < 2e-9  # vertices lie on the displaced arc
    assert moves[-1].end == (0.0, 0.01, 0.0)  # it ends where it was programmed
    assert {round(move.feedrate, 9) for move in moves} == {0.01}


@pytest.mark.parametrize(
    "modes",
    ["G20 G90", "G21 G91", "G54 G10 L2 P1 X3 Y4 R30\nG21 G90", "G92 X7 Y1\nG21 G90", "G21 G90 G93", "G21 G90 G61", "G21 G90 G61.1"],
)
def test_every_mode_gives_the_same_displacement(modes: str) -> None:
    text = f"{modes}\nG1 X1 Y0.5 F60\nG2 X2 Y0 I0.2 J-0.6 F60\nG1 Y-1 F60\nG0 X0 Y0\nM2\n"
    try:
        parse_program(text)
    except ProgramError:
        text = f"{modes}\nG1 X1 Y0.5 F60\nG1 X2 Y0 F60\nG1 Y-1 F60\nG0 X0 Y0\nM2\n"
    source = parse_blocks(text, "part", READING, AXES)
    contour = contour_of(source, AXES, 1e-3)
    written, _ = corrected(text)
    path = contour_of(parse_blocks(written, "again", READING, AXES), AXES, 1e-3).path
    points = path.position(np.asarray(path.breaks)[1:-3])
    foot = contour.path.foot_point(points - 50e-6, np.asarray(path.breaks)[1:-3], 1e-3)
    assert foot.distance.max() < 1e-8
    last = parse_program(text).moves[-1].end
    assert parse_program(written).moves[-1].end == pytest.approx(last, abs=1e-9)


def test_each_line_takes_as_long_as_the_control_took_there() -> None:
    """A half circle written a tenth smaller, which the control drove at half the feed up to its middle."""
    source = parse_blocks("G21 G90 G61\nG0 X10\nG3 X-10 Y0 I-10 J0 F600\nG1 Z1\nM2\n", "part", READING, AXES)
    contour = contour_of(source, AXES, 1e-3)
    middle = 0.01 + 0.005 * np.pi
    fastest = np.where(contour.nodes <= middle, 0.005, 1.0)
    written = write_corrected(contour, -0.1 * contour.positions, TOLERANCE, fastest)
    *moves, last, lift = [move for move in parse_program(written.text).moves if isinstance(move, Feed)]
    ends = np.array([move.end for move in moves])
    length = np.linalg.norm(np.diff(ends, axis=0, prepend=[moves[0].start]), axis=1)
    feed, first = np.array([move.feedrate for move in moves]), ends[:, 0] > 1e-4
    assert (length / feed)[first][1:].sum() == pytest.approx(0.005 * np.pi / 0.005, rel=0.02)
    np.testing.assert_allclose(feed[first][1:], 0.9 * 0.005, rtol=1e-3)
    assert {*feed[ends[:, 0] < -1e-4], last.feedrate, lift.feedrate} == {0.01}
    assert [move.mode.control for move in (moves[-1], last)] == ["blend", "exact_path"]


def test_exact_stops_stay_at_corners_only() -> None:
    written, _ = corrected("G21 G90 G61\nG1 F600 X10\nG3 X20 Y10 I0 J10\nG1 X0\nM2\n")
    exact = [move.mode.control == "exact_path" for move in parse_program(written).moves]
    assert sum(exact) == 2  # the corner at X20 Y10, and the end
    assert not exact[0]


def test_helices_keep_their_height() -> None:
    written, _ = corrected("G21 G90\nG1 X10 F600\nG3 X-10 Y0 Z-4 I-10 J0\nM2\n")
    moves = [move for move in parse_program(written).moves if move.end[2] < 0.0]
    angles = np.array([np.arctan2(move.end[1] - 50e-6, move.end[0] - 50e-6) for move in moves[:-2]])
    heights = np.array([move.end[2] for move in moves[:-2]])
    np.testing.assert_allclose(heights, -4e-3 * angles / np.pi, atol=2e-8)


def test_splines_are_replaced_whole() -> None:
    text = "G21 G90\nF300\nG5.2 X3 Y-1 P2 L3\nX5 Y-10 P1 (second)\nX3 Y-20 P1\nX0 Y-25 P1\nG5.3\nG0 X0 Y0\nM2\n"
    written, reasons = corrected(text)
    assert reasons == ["", "-"]
    assert "G5" not in written
    assert "(second)" in written


def test_cycles_loops_and_dwells_are_untouched() -> None:
    text = "G21 G90\nG1 X5 F600\nG81 X10 Y10 Z-2 R1\nX20\nG80\no1 repeat [2]\nG91 G1 X1\nG90\no1 endrepeat\nG4 P0.5\nG1 X0 Y0\nM2\n"
    written, reasons = corrected(text)
    assert "inside a loop or subprogram" in reasons
    for line in text.splitlines()[2:10]:
        assert line in written.splitlines()


def test_a_corrected_program_is_recognised_by_its_moves(tmp_path: Path) -> None:
    file = tmp_path / "part.ngc"
    file.write_text("G21 G90\nG1 X5 F600 M2\n")
    assert read_blocks(file, READING, AXES).blocks[0].reason == "with another code that acts on its line"


def test_a_line_to_the_same_point_between_two_cuts_moves_with_them() -> None:
    text, _ = corrected("G21 G90 G64 P0.002\nG1 X10 Y0 F1500\nN5 G1 X10 Y0 (again)\nG1 X10 Y10\nG0 X0 Y0\nM2\n")
    assert "N5 (again)" in text.splitlines()


PROGRAMS = {
    "linuxcnc": "%\nG21 G90 G64 P0.02\nG0 X0 Y0\nG1 X20 F1500\nG3 X20 Y0 I-10 J0\nG0 X0\nG61\nG1 Y9.5\nG64 P0.02 Q0.01\nG1 X9\nM2\n%\n",
    "grbl": "G21 G90\nG0 X0 Y0\nG1 X20 F1500\nG3 X20 Y0 I-10 J0 K0\nG0 X0\nG61\nG1 Y9.5\nG1 X9\nM30\n",
    "fanuc": "%\nO1001 (PART)\nG21 G90\nG0 X0. Y0.\nG1 X20. F1500\nG3 X20. Y0. I-10.\nG0 X0.\nG61\nG1 Y9.5\nG64\nX9.\nG28 Z0.\nM30\n%\n",
    "mach3": "(Mach3)\nG21 G90 G91.1\nG0 X0 Y0\nG1 X20 F1500\nG3 X20 Y0 I-10 J0\nG0 X0\nG61\nG1 Y9.5\nG64\nX9\nM30\n",
}

FINE = "G64 P0.02 Q0.001"


@pytest.mark.parametrize(
    ("dialect", "controls", "dwell", "decimals"),
    [
        ("linuxcnc", [FINE, "G64 P0.02 Q0.02", "G61", "G64 P0.001", "G61", "G64 P0.02 Q0.01", FINE, "G64 P0.02 Q0.01"], "G4 P0.25", 6),
        ("grbl", ["G61"], "G4 P0.25", 6),
        ("grblhal", ["G61"], "G4 P0.25", 6),
        ("fanuc", ["G64", "G61", "G64", "G61", "G64"], "G4 P250", 3),
        ("mach3", ["G64", "G61", "G64", "G61", "G64"], "G4 P0.25", 6),
    ],
)  # fmt: skip
def test_each_dialect_is_written_as_its_control_reads_it(dialect: str, controls: list[str], dwell: str, decimals: int) -> None:
    text = PROGRAMS[dialect.removesuffix("hal")]
    reading = Reading(dialect=dialect, require_end=False)  # type: ignore[arg-type]
    contour = contour_of(parse_blocks(text, "part", reading, AXES), AXES, 1e-3)
    block = contour.starts[0][1]
    written = write_corrected(contour, np.full((len(contour.nodes), 2), 50e-6), TOLERANCE, dwells={block: 0.25}, stops=True)
    again = contour_of(parse_blocks(marked(written.text, 2, "part"), "again", reading, AXES), AXES, 1e-3)
    np.testing.assert_allclose(again.path.breaks, written.corrected_arc, atol=1e-8)
    assert again.events == contour.events
    lines = written.text.splitlines()
    assert [line.split(" G90 ")[-1] for line in lines if re.search(r"G6[14]", line)][dialect == "linuxcnc" :] == controls
    assert lines[lines.index(dwell) - 2].startswith("G0 X0")
    assert sum(isinstance(move, Dwell) and move.seconds == 0.25 for move in again.source.program.moves) == 1
    numbers = re.findall(r"[XYZ]-?[0-9]+\.([0-9]*)", "\n".join(line for line in lines if line.startswith("G1 ")))
    assert numbers and max(map(len, numbers)) == decimals
    # A Fanuc reads a length without a point in micrometres.
    assert not re.search(r"^G1 .*[XYZF]-?[0-9]+( |$)", written.text, re.MULTILINE) or dialect != "fanuc"


def test_the_mark_stands_behind_the_number_of_a_program() -> None:
    assert marked("%\nO1001 (PART)\nG1\n", 2, "a b").splitlines()[:3] == ["%", "O1001 (PART)", "(contourlab precompensate: pass 2 of a_b)"]
    assert marked("o100 sub\nG1\n", 1, "a").startswith("(contourlab")


def test_g64_is_set_once_where_the_program_sets_no_path_control() -> None:
    contour = contour_of(parse_blocks("G21 G90\nG0 X1\nG1 X10 F600\nG0 X0\nG1 X-9\nM2\n", "part", READING, AXES), AXES, 1e-3)
    for stops in (False, True):
        written = write_corrected(contour, np.zeros((len(contour.nodes), 2)), TOLERANCE, stops=stops)
        moves = parse_program(written.text).moves
        assert [line for line in written.text.splitlines() if "G64" in line] == ["G64 P0.001"] * stops
        assert {move.mode.tolerance for move in moves if isinstance(move, Feed)} == ({1e-6} if stops else {None})
