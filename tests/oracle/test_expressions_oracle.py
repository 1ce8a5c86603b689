"""Random expressions against LinuxCNC's interpreter: both give the same number, or both refuse."""

from __future__ import annotations

import random
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from contourlab.program.block import Parameters, read_words
from contourlab.program.vocabulary import BlockError

pytestmark = [
    pytest.mark.oracle,
    pytest.mark.skipif(shutil.which("rs274") is None, reason="LinuxCNC's interpreter rs274 is not installed"),
]
BINARY = ("+", "-", "*", "/", "**", "MOD", "EQ", "NE", "GT", "GE", "LT", "LE", "AND", "OR", "XOR")
UNARY = ("ABS", "ACOS", "ASIN", "COS", "EXP", "FIX", "FUP", "LN", "ROUND", "SIN", "SQRT", "TAN")
LONGEST = 240  # the interpreter reads lines of up to 255 characters
SETTINGS = "#1=2.5 #2=-3\n#<depth>=0.25 #<_Wide One>=7\n#3=[#1 + #2] #4=1\n"
PARAMETERS = Parameters()
for setting in SETTINGS.splitlines():
    read_words(setting, PARAMETERS)


def value(dice: random.Random, depth: int) -> str:
    """Return a random value as a person might write it."""
    kind = dice.randrange(9 if depth else 5)
    if kind < 2:
        return dice.choice(["", "-", "+", "- -"]) + dice.choice(["0", "1", "2", "3.5", ".25", "7.", "12.125", "1 0"])
    if kind == 2:
        return dice.choice(["#1", "#2", "#3", "##4", "#[2+1]", "-#2", "#77"])
    if kind == 3:
        return dice.choice(["#<depth>", "-#<DEPTH>", "#<_wideone>", "#< _wide one >"])
    if kind == 4:
        return f"EXISTS[#<{dice.choice(['depth', 'height'])}>]"
    if kind == 5:
        return f"{dice.choice(['', '-'])}{dice.choice(UNARY)}[{value(dice, depth - 1)}]"
    if kind == 6:
        return f"ATAN[{value(dice, depth - 1)}]/[{value(dice, depth - 1)}]"
    terms = [value(dice, depth - 1)]
    for _ in range(dice.randint(1, 4)):
        terms += [dice.choice(BINARY).lower() if dice.random() < 0.3 else dice.choice(BINARY), value(dice, depth - 1)]
    return f"[{' '.join(terms)}]"


def ours(text: str) -> float | str:
    """Return the value of an expression in mm, or why it is refused."""
    try:
        return read_words(f"X{text}", PARAMETERS)[0].value
    except BlockError as error:
        return error.message


def theirs(texts: list[str], folder: Path) -> list[float] | None:
    """Return what the interpreter prints for each; None where it refuses."""
    file = folder / "values.ngc"
    file.write_text(f"G21 F100\n{SETTINGS}" + "".join(f"G1 X{text}\n" for text in texts) + "M2\n", encoding="utf-8")
    done = subprocess.run(["rs274", "-g", str(file)], capture_output=True, text=True, timeout=60, cwd=folder)
    found = [float(x) for x in re.findall(r"STRAIGHT_FEED\((\S+?),", done.stdout)]
    return found if done.returncode == 0 and len(found) == len(texts) else None


@pytest.mark.parametrize("seed", range(4))
def test_random_expressions_have_the_same_value(seed: int, tmp_path: Path) -> None:
    dice = random.Random(seed)
    texts = [text for text in (value(dice, 3) for _ in range(400)) if len(text) < LONGEST]
    good = [(text, found) for text in texts if isinstance(found := ours(text), float) and abs(found) < 1e5]
    assert len(good) > 150
    printed = theirs([text for text, _ in good], tmp_path)
    assert printed is not None
    for (text, found), other in zip(good, printed, strict=True):
        assert abs(found - other) < 6e-5, text


def test_linuxcnc_also_refuses_what_we_refuse(tmp_path: Path) -> None:
    """Except for remainders by zero and zero to a negative power, which LinuxCNC keeps until a comparison hides them, and huge numbers."""
    dice = random.Random(7)
    refused = [text for text in (value(dice, 3) for _ in range(400)) if len(text) < LONGEST and isinstance(ours(text), str)][:60]
    assert len(refused) > 30
    accepted = [text for text in refused if theirs([text], tmp_path) is not None]
    known = r"MOD 0 |0 \*\* -|too large: keep"
    assert all(re.search(known, str(ours(text))) for text in accepted)
    assert len(accepted) < 15
