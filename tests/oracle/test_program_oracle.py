"""The reader against LinuxCNC's interpreter, rule by rule: limits of valid arcs, order of execution, refusals on the same line."""

from __future__ import annotations

import random
from importlib.resources import files
from pathlib import Path
from types import ModuleType

import pytest
from program_oracle import NEEDED, compare, load_oracle, our_moves

SHIPPED = Path(str(files("contourlab") / "machines" / "programs" / "circle_diamond_square.ngc"))

pytestmark = NEEDED


@pytest.fixture(scope="module")
def oracle() -> ModuleType:
    return load_oracle()


def same(oracle: ModuleType, text: str, folder: Path) -> int:
    """Compare move by move, up to the line that both refuse; return how many moves there were."""
    file = folder / "program.ngc"
    file.write_text(text, encoding="utf-8")
    count, wrong = compare(oracle, file)
    assert not wrong, wrong
    return count


def test_random_polar_programs(oracle: ModuleType, tmp_path: Path) -> None:
    for seed in range(12):
        rng = random.Random(seed)
        lines = ["G21 F100 G1 X3 Y4"]
        for _ in range(30):
            words = [f"{letter}{rng.choice([0.5, 1, 2.5, -1, 30, 77.7, 145])}" for letter in "@^Z" if rng.random() < 0.6]
            lines.append(" ".join([rng.choice(["G0", "G1", "", "", "G90", "G91", "G18", "G17", "G20", "G21"]), *words]))
        assert same(oracle, "\n".join([*lines, "M2"]), tmp_path) >= 1


def test_shipped_program(oracle: ModuleType, tmp_path: Path) -> None:
    assert same(oracle, SHIPPED.read_text(encoding="utf-8"), tmp_path) == 36


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


@pytest.mark.parametrize("seed", range(30))
def test_random_programs(oracle: ModuleType, tmp_path: Path, seed: int) -> None:
    same(oracle, random_program(random.Random(seed)), tmp_path)


@pytest.mark.parametrize(
    "text",
    [
        "F100\nG94\nG1 X1", "X1", "F100 G1 X1\nG4 X2 P-1", "F10 G2 X20.029 I10", "F10 G2 X200.11 I100",
        "F10 G2 X10 R4.9987", "F10 G2 X0.002 I0.001", "G20 F10 G2 X2.0029 I1", "F10 G2 X12005 I6000", "G0 X1 X2",
        "G1.05 X1", "G0 X1 (a (b))", "F10 G2 X10 I5\nX20", "F10 G2 X10 I5 P0", "F10 G90.1 G2 X10 I5", "F0\nG1 X1", "G53 X1", "G53",
        "G2 I1 F3\nG53 X2",
        "G17 G81 X1 Z-1 R1 L0 F9", "M3 S9 F9 G74 X1 Z-1 R1", "S9 M4 F9 G74 X1 Z-1 R1 L2", "G10 L2 P10 X1", "G10 L20 P1 R5",
        "G43.1 G49 Z1", "G5.3",
        "G93\nG1 X1", "G93 F2 G81 X1 Z-1 R1", "o1 endif", "o1 if [1]\no1 endif\no1 if [1]\no1 endif",
        "o1 sub\no2 sub\no2 endsub\no1 endsub",
        "G0 X1\nG0 X2 (ABORT, no)\nG0 X3",
        "%\no9 call\nG0 X1\n%\no9 sub\nG0 X2\no9 endsub", "%\no1 if [0]\nG0 X1\n%\no1 endif",
        "o1 if [0]\n#<s> = 2\no#<s> if [1]\no#<s> endif\no1 endif", "o1 sub\no[1/0] if [1]\no1 endsub\nG0 X2",
        "G92 X1 G1", "G10 L2 P1 X1 G1", "G28 X1 G0", "G55 G54", "G0 X#<nothing>", "#5420 = 1", "G18 G5 X1 Y1 I1 J1 P1 Q1 F9",
        "o1 repeat [2]\nG0 X1\no1 break\no1 endrepeat", "o1 repeat [2]\nG0 X1\no1 continue\no1 endrepeat",
        "o1 (c) if [1]\no1 endif", "o1 if (c) [1]\no1 endif", "o1 if [1 (c)]\no1 endif",
    ],
)  # fmt: skip
def test_both_refuse(oracle: ModuleType, tmp_path: Path, text: str) -> None:
    assert our_moves(text)[1] is not None
    same(oracle, f"{text}\nM2\n", tmp_path)


@pytest.mark.parametrize(
    "text",
    [
        "F10 G2 X20.028 I10", "F10 G2 X200.1 I100", "F10 G2 X10 R4.9988", "F10 G2 X0.0028 I0.0014",
        "G20 F10 G2 X2.0028 I1", "F10 G2 X10002.8 I5000", "F10 G2 X0 Y0 I5", "%\nG0 X1\n%", "g 0 x - 1 . 5 (c)",
        "G1 X1 G20 F10", "G94 F10 G1 X1", "G1 F10 X1 G55", "G2 K5 G18 F10", "G0 X1 G91", "/G0 X1", "#1 = 5 G0 X#1 Y1", "G0 X1 Z2 G43.1",
        "G7 G0 X10",
        "o1 if [0]\nG0 X2\no1 else\nG0 X1\no1 endif", "G10 L2 P1 X5 G20\nG0 X1", "o1 repeat [1.4]\nG0 X1\no1 endrepeat",
        "G92 X5\nG53 G0 X1",
        "G93 G1 X0.001 F2", "G4 P0", "F100000000 G1 X1", "G0 X1 ; (abort, no)", "G0 X1 (abort, no) (note)", "G0 X1 (abort no)",
        "o1 if [0]\n(abort, no)\no1 endif\nG0 X1",
        "o2 sub\nG0 X2\no2 endsub\no<a> sub\n#<s> = 2\no#<s> call\no<a> endsub\no<a> call",
        "o<a> sub\n#<s> = 2\no#<s> if [1]\nG0 X2\no#<s> endif\no<a> endsub\no<a> call",
        "G0 X[#<_motion_mode> / 100]",
        "%\no1 while [#1 LT 2]\n#1 = [#1 + 1]\nG0 X1\n%\no1 endwhile",
    ],
)  # fmt: skip
def test_both_accept(oracle: ModuleType, tmp_path: Path, text: str) -> None:
    assert same(oracle, f"{text}\nM2\n", tmp_path) == 1


@pytest.mark.parametrize("plane", ["G18", "G19"])
def test_tapping_outside_xy_differs(oracle: ModuleType, tmp_path: Path, plane: str) -> None:
    """LinuxCNC takes the axes of the feed in a wrong order; if it is mended, the documentation and the generator have to change."""
    file = tmp_path / "program.ngc"
    file.write_text(f"{plane} F10 S9 M3 G84 X-1 Y-2 Z-3 R2\nM2\n", encoding="utf-8")
    assert compare(oracle, file)[1].startswith("end:")
