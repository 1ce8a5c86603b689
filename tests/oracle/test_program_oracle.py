"""The reader against LinuxCNC's own interpreter: the same moves of the same text, refusals where it refuses."""

import importlib.util
import math
import random
import re
import shutil
from importlib.resources import files
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from contourlab.errors import ProgramError
from contourlab.program import PLANE_AXES, Arc, Dwell, Feed, Move, Traverse, iter_moves

SHARED = Path(__file__).parents[2].parent / "shared"
TOOL = SHARED / "tools" / "rs274_oracle.py"
GCODE = SHARED / "gcode"
PROGRAMS = sorted(path for path in GCODE.glob("*") if path.suffix in {".ngc", ".nc", ".gcode"})
SHIPPED = Path(str(files("contourlab") / "machines" / "programs" / "circle_diamond_square.ngc"))

pytestmark = [
    pytest.mark.oracle,
    # The shared tool leaves the closing of its files to the interpreter.
    pytest.mark.filterwarnings("ignore::ResourceWarning", "ignore::pytest.PytestUnraisableExceptionWarning"),
    pytest.mark.skipif(shutil.which("rs274") is None, reason="LinuxCNC's interpreter rs274 is not installed"),
    pytest.mark.skipif(not TOOL.is_file(), reason="the shared oracle tools are not beside the repository"),
]

# Words that leave the tool's path alone on a machine without offsets and with tools of no length and diameter.
PATHLESS = re.compile(
    r"^\s*%\s*$|\([^)]*\)|;.*|[ST]\s*[0-9.]+|M0*[013456789](?![0-9])|G64(\s*P\s*[0-9.]+)?|G(40|49|54|80)(?![0-9.])|G43\s*H\s*[0-9]+"
    r"|G4[12]\s*D\s*[0-9]+",
    re.IGNORECASE | re.MULTILINE,
)
TOOLS = re.compile(r"^T[0-9]+[ \t]*$|(?<= )T[0-9]+(?=[ \n])|\bM0?6\b", re.MULTILINE)
# Programs that use no other unsupported words; the rest need parameters, O-words, cycles, splines or polar words.
PLAIN = {
    "CAMotics__examples_compass_text.ngc",
    "CAMotics__examples_vcarve_vcarve.ngc",
    "cncjs__examples_gcode_Circle_Diamond_Square_Calibration.gcode",
    "cncjs__examples_gcode_arc-xz-plane.gcode",
    "cncjs__examples_gcode_circle-inch.gcode",
    "cncjs__examples_gcode_circle.gcode",
    "cncjs__examples_gcode_full-circle-without-xyz.gcode",
    "cncjs__examples_gcode_helical-thread-milling.gcode",
    "grbl__test_gcode_8x_gear_test.nc",
    "grbl__test_gcode_HSM_test.nc",
    "linuxcnc__nc_files_3dtest.ngc",
    "linuxcnc__nc_files_arcspiral.ngc",
    "linuxcnc__nc_files_cds.ngc",
    "linuxcnc__nc_files_tort.ngc",
}
# As they are, without anything taken out.
SUPPORTED = {
    "CAMotics__examples_heart_heart.ngc",
    "cncjs__examples_gcode_arc-xz-plane.gcode",
    "cncjs__examples_gcode_circle-inch.gcode",
    "cncjs__examples_gcode_circle.gcode",
    "grbl__test_gcode_8x_gear_test.nc",
    "grbl__test_gcode_HSM_test.nc",
    "linuxcnc__nc_files_3dtest.ngc",
    "linuxcnc__nc_files_tort.ngc",
}


@pytest.fixture(scope="module")
def oracle() -> ModuleType:
    spec = importlib.util.spec_from_file_location("rs274_oracle", TOOL)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def their_moves(oracle: ModuleType, file: Path) -> tuple[list[dict[str, Any]], bool]:
    """Return LinuxCNC's moves, those of no length left out, and whether it refused the rest."""
    try:
        moves, refused = oracle.moves(str(file), backend="gcode"), False
    except oracle.OracleError as error:
        moves, refused = error.args[1], True
    kept, place = [], (0.0, 0.0, 0.0)
    for move in moves:
        if move["kind"] == "dwell":
            kept += [move] if move["seconds"] > 0.0 else []
            continue
        if move["kind"] == "arc" or math.dist(place, move["end"]) > 1e-9:
            kept.append(move | {"start": place})
            place = move["end"]
    return kept, refused


def our_moves(text: str) -> tuple[list[Move], ProgramError | None]:
    """Return the moves read up to an error, and the error."""
    moves: list[Move] = []
    try:
        for move in iter_moves(text.split("\n"), require_end=False):
            moves.append(move)
    except ProgramError as error:
        return moves, error
    return moves, None


def assert_same(ours: list[Move], theirs: list[dict[str, Any]]) -> None:
    kinds = {Traverse: "traverse", Feed: "feed", Arc: "arc", Dwell: "dwell"}
    for mine, other in zip(ours, theirs, strict=True):
        assert kinds[type(mine)] == other["kind"], (mine, other)
        if isinstance(mine, Dwell):
            assert mine.seconds == pytest.approx(other["seconds"])
            continue
        assert mine.source_line == other["line"]
        assert [1e3 * v for v in mine.start] == pytest.approx(other["start"], abs=1e-9)
        assert [1e3 * v for v in mine.end] == pytest.approx(other["end"], abs=1e-9)
        if not isinstance(mine, Traverse):
            assert 6e4 * mine.feedrate == pytest.approx(other["feed"], rel=1e-9)
        if isinstance(mine, Arc):
            first, second, _ = PLANE_AXES[mine.plane]
            assert sorted(mine.plane) == sorted(other["plane"])
            assert mine.turns == other["turns"]
            assert 1e3 * mine.centre[first] == pytest.approx(other["centre"][first], abs=1e-8)
            assert 1e3 * mine.centre[second] == pytest.approx(other["centre"][second], abs=1e-8)
            assert mine.sweep == pytest.approx(sweep_of(other, first, second), abs=1e-6)


def sweep_of(move: dict[str, Any], first: int, second: int) -> float:
    """Return the angle [rad] of one of LinuxCNC's arcs by counting up from its start."""
    start, end = (
        math.atan2(move[key][second] - move["centre"][second], move[key][first] - move["centre"][first]) for key in ("start", "end")
    )
    sense = 1.0 if move["turns"] > 0 else -1.0
    angle = sense * (end - start)
    while angle < 1e-6:
        angle += 2.0 * math.pi
    return sense * (angle + 2.0 * math.pi * (abs(int(move["turns"])) - 1))


def compare(oracle: ModuleType, text: str, folder: Path) -> int:
    """Compare move by move, up to the line that both refuse; return how many moves there were."""
    file = folder / "program.ngc"
    # Without a tool table the interpreter refuses tools, which have no length here.
    file.write_text(TOOLS.sub(" ", text), encoding="latin-1")
    theirs, refused = their_moves(oracle, file)
    ours, error = our_moves(text)
    assert (error is not None) == refused, error
    assert_same(ours, theirs)
    return len(ours)


def test_random_polar_programs(oracle: ModuleType, tmp_path: Path) -> None:
    for seed in range(12):
        rng = random.Random(seed)
        lines = ["G21 F100 G1 X3 Y4"]
        for _ in range(30):
            words = [f"{letter}{rng.choice([0.5, 1, 2.5, -1, 30, 77.7, 145])}" for letter in "@^Z" if rng.random() < 0.6]
            lines.append(" ".join([rng.choice(["G0", "G1", "", "", "G90", "G91", "G18", "G17", "G20", "G21"]), *words]))
        assert compare(oracle, "\n".join([*lines, "M2"]), tmp_path) >= 1


def test_shipped_program(oracle: ModuleType, tmp_path: Path) -> None:
    assert compare(oracle, SHIPPED.read_text(encoding="utf-8"), tmp_path) == 36


@pytest.mark.parametrize("file", [path for path in PROGRAMS if path.name in SUPPORTED], ids=lambda path: path.name)
def test_programs_as_they_are(oracle: ModuleType, tmp_path: Path, file: Path) -> None:
    assert compare(oracle, file.read_text(encoding="latin-1"), tmp_path) > 1


@pytest.mark.parametrize("file", [path for path in PROGRAMS if path.name in PLAIN], ids=lambda path: path.name)
def test_programs_without_pathless_words(oracle: ModuleType, tmp_path: Path, file: Path) -> None:
    text = PATHLESS.sub(" ", file.read_text(encoding="latin-1"))
    assert compare(oracle, text, tmp_path) > 1


@pytest.mark.parametrize("file", [path for path in PROGRAMS if path.name not in SUPPORTED], ids=lambda path: path.name)
def test_unsupported_words_are_refused_where_they_stand(file: Path) -> None:
    text = file.read_text(encoding="latin-1")
    _, error = our_moves(text)
    assert error is not None
    assert error.line >= 1
    assert error.column >= 1
    there = text.split("\n")[error.line - 1][error.column - 1 :].upper()
    if word := re.match(r"([A-Z][0-9.]*) \(", error.message):
        assert re.sub(r"([GM])0+(?=[0-9])", r"\1", there).startswith(word[1])
    elif error.message.startswith("the radius is"):
        assert there[0] in "IJK"
    else:
        named = {"O-words": "O", "polar": "@^", "%": "%", "neither": "GXYZ"}
        assert there[0] in named[next(word for word in error.message.split() if word in named)]


NUMBERS = ["0", "0.001", "1", "-1", "2.5", "-2.5", "5", "10", "-10", "3.1416", "-7.25"]
AXES = {"G17": "XYZ", "G18": "ZXY", "G19": "YZX"}
OFFSETS = dict(zip("XYZ", "IJK", strict=True))


def random_program(rng: random.Random) -> str:
    """Return blocks of all supported words; about one in sixty breaks a rule."""
    lines, plane, absolute_centre = ["G21 F100 G1 X1 Y1"], "G17", False
    for _ in range(rng.randrange(20, 60)):
        words: list[str] = []
        for code, chance in (("G20", 0.05), ("G21", 0.05), ("G90", 0.1), ("G91", 0.1), ("F60", 0.1), ("F2.5", 0.05),
                             ("(note)", 0.05), ("M2", 0.003), ("G1", 0.004)):  # fmt: skip
            if rng.random() < chance and not (code[:2] in {"G2", "G9"} and any(w[:2] == code[:2] for w in words)):
                words.append(code)
        if rng.random() < 0.1:
            plane = rng.choice(list(AXES))
            words.append(plane)
        if rng.random() < 0.05:
            absolute_centre = rng.random() < 0.3
            words.append("G90.1" if absolute_centre else "G91.1")
        if rng.random() < 0.03:
            words += ["G94"] + ([] if any(w[0] == "F" for w in words) else ["F75"])
        words += random_motion(rng, AXES[plane], absolute_centre)
        rng.shuffle(words)
        lines.append(" ".join(words))
    return "\n".join([*lines, "M2", ""])


def random_motion(rng: random.Random, axes: str, absolute_centre: bool) -> list[str]:
    kind = rng.choice(["G0", "G1", "G0", "G1", "modal", "R", "circle", "circle", "dwell"])
    if kind == "dwell":
        return ["G4", "P" + rng.choice(["0.5", "0", "2"])]
    if kind == "R":
        radius = "R" + rng.choice(["9000", "-9000", "12345.678", "-12345.678", "20", "-20"])
        # No short chords: with such radii the last bit of a coordinate would move the centre.
        return [rng.choice(["G2", "G3"]), radius, *(a + rng.choice(NUMBERS[2:]) for a in axes if rng.random() < 0.9)]
    if kind == "circle":
        offsets = [OFFSETS[a] + rng.choice(NUMBERS[2:8]) for a in axes[:2] if absolute_centre or rng.random() < 0.7]
        height = [axes[2] + rng.choice(NUMBERS)] if rng.random() < 0.5 else []
        turns = ["P" + rng.choice("135")] if rng.random() < 0.2 else []
        return [rng.choice(["G2", "G3"]), *(offsets or [OFFSETS[axes[0]] + "5"]), *height, *turns]
    straight = [] if kind == "modal" and rng.random() < 0.1 else [kind if kind != "modal" else rng.choice(["G0", "G1"])]
    return straight + [letter + rng.choice(NUMBERS) for letter in "XYZ" if rng.random() < 0.5]


@pytest.mark.parametrize("seed", range(40))
def test_random_programs(oracle: ModuleType, tmp_path: Path, seed: int) -> None:
    compare(oracle, random_program(random.Random(seed)), tmp_path)


@pytest.mark.parametrize(
    "text",
    [
        "F100\nG94\nG1 X1", "X1", "F100 G1 X1\nG4 X2 P-1", "F10 G2 X20.029 I10", "F10 G2 X200.11 I100",
        "F10 G2 X10 R4.9987", "F10 G2 X0.002 I0.001", "G20 F10 G2 X2.0029 I1", "F10 G2 X12005 I6000", "G0 X1 X2",
        "G1.05 X1", "G0 X1 (a (b))", "F10 G2 X10 I5\nX20", "F10 G2 X10 I5 P0", "F10 G90.1 G2 X10 I5", "F0\nG1 X1",
    ],
)  # fmt: skip
def test_both_refuse(oracle: ModuleType, tmp_path: Path, text: str) -> None:
    assert our_moves(text)[1] is not None
    compare(oracle, f"{text}\nM2\n", tmp_path)


@pytest.mark.parametrize(
    "text",
    [
        "F10 G2 X20.028 I10", "F10 G2 X200.1 I100", "F10 G2 X10 R4.9988", "F10 G2 X0.0028 I0.0014",
        "G20 F10 G2 X2.0028 I1", "F10 G2 X10002.8 I5000", "F10 G2 X0 Y0 I5", "%\nG0 X1\n%", "g 0 x - 1 . 5 (c)",
    ],
)  # fmt: skip
def test_both_accept(oracle: ModuleType, tmp_path: Path, text: str) -> None:
    assert compare(oracle, f"{text}\nM2\n", tmp_path) == 1
