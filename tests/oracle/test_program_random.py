"""Random programs over the whole language: LinuxCNC's interpreter makes the same moves, or refuses the same line."""

from __future__ import annotations

import random
import re
from pathlib import Path
from types import ModuleType

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from program_generator import Writer
from program_oracle import NEEDED, compare, difference, load_oracle, modes, our_moves, their_moves

from contourlab.program import Arc, Dwell, Spline

pytestmark = NEEDED


@pytest.fixture(scope="module")
def oracle() -> ModuleType:
    return load_oracle()


@pytest.mark.parametrize("first", range(0, 48, 8))
@pytest.mark.slow
def test_same_moves_or_the_same_refusal(oracle: ModuleType, tmp_path: Path, first: int) -> None:
    """Full doubles: kinds, end points, centres, turns, feedrates, lines; splines by the vertices of their chords."""
    file, count = tmp_path / "program.ngc", 0
    for seed in range(first, first + 8):
        file.write_text(Writer(seed).program(), encoding="utf-8")
        made, wrong = compare(oracle, file)
        assert not wrong, f"seed {seed}: {wrong}"
        count += made
    assert count > 100


@settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(seed=st.integers(48, 2**63))
@pytest.mark.slow
def test_same_moves_of_programs_never_seen_before(oracle: ModuleType, tmp_path_factory: pytest.TempPathFactory, seed: int) -> None:
    """The same with new programs each time; hypothesis keeps those that fail."""
    file = tmp_path_factory.mktemp("random") / "program.ngc"
    file.write_text(Writer(seed).program(), encoding="utf-8")
    _, wrong = compare(oracle, file)
    assert not wrong, wrong


def test_the_generator_reaches_the_whole_language() -> None:
    """Arcs of all planes, splines, dwells and faults do occur: no kind of block is always refused."""
    kinds: set[object] = set()
    whole = refused = 0
    for seed in range(60):
        made, error = our_moves(Writer(seed).program())
        whole, refused = whole + (error is None), refused + (error is not None)
        kinds |= {type(m.move) for m in made} | {m.move.plane for m in made if isinstance(m.move, Arc)}
        kinds |= {m.move.degree for m in made if isinstance(m.move, Spline)}
        kinds |= {"turned" for m in made if isinstance(m.move, Arc) and m.move.turned}
    assert kinds >= {Arc, Dwell, Spline, "XY", "YZ", "ZX", 2, 3, "turned"}
    assert whole > 20
    assert refused > 10


@pytest.mark.parametrize("seed", range(8))
def test_subprograms_of_m98(oracle: ModuleType, tmp_path: Path, seed: int) -> None:
    """Only the stand-alone program reads these; it prints four decimals and keeps its parameters in inches."""
    dice = random.Random(seed)
    lines = ["G21 F100 S200 M3", "#7 = 1"]
    for _ in range(12):
        word = dice.choice(["M98 P5", "M98 P5 L2", "M98 P[5 + 1]", "M98 P6 L3", "G91", "G90", f"G1 X{dice.randrange(9)}", "#7 = 2"])
        lines.append(word)
    subs = ["O5", "G1 X#7 Y2", "G2 I3", "M99", "O6", "#7 = [#7 + 1]", "G1 Z#7", "M98 P5", "M99"]
    file = tmp_path / "program.ngc"
    file.write_text("\n".join([*lines, "M2", *subs, ""]), encoding="utf-8")
    count, wrong = compare(oracle, file, backend="rs274")
    assert not wrong, wrong
    assert count > 0


def test_path_control_tolerances_and_merging(oracle: ModuleType, tmp_path: Path) -> None:
    file = tmp_path / "program.ngc"
    for seed in range(20):
        dice = random.Random(seed)
        lines = [dice.choice(["G21 F100", "G20 F100"])]
        for _ in range(15):
            code = dice.choice(["G61", "G61.1", "G64", "G64 P0.01", "G64 P0.1 Q0.02", "G64 P0", "G64 Q0.5", ""])
            lines += [code, f"G1 X{dice.randrange(1, 9)}.{dice.randrange(9)} Y{dice.randrange(9)}"]
        file.write_text("\n".join([*lines, "G81 X1 Z-1 R1", "G0 X0", "M2", ""]), encoding="utf-8")
        theirs, (ours, error) = modes(file), our_moves(file.read_text(encoding="utf-8"))
        assert error is None
        assert len(theirs) == len(ours)
        for mine, (control, tolerance, merge) in zip(ours, theirs, strict=True):
            mode = mine.move.mode  # type: ignore[union-attr]
            assert (mode.control or "exact_path") == control
            if control == "blend":
                # The interpreter prints 0 without P; it prints merging if it is given or follows P.
                assert 1e3 * (mode.tolerance or 0.0) == pytest.approx(tolerance or 0.0, abs=2e-3)
                assert 1e3 * (mode.merge or 0.0) == pytest.approx(merge or 0.0, abs=2e-3)


TABLE = "T1 P1 D6 Z20.5 ; mill\nT2 P2 X1.5 Y-2 Z11 D3\nT7 P7 Z-3 D10\n"


@pytest.mark.parametrize("seed", range(8))
def test_tool_lengths_from_a_table(oracle: ModuleType, tmp_path: Path, seed: int) -> None:
    """G43, G43 H, G43.2 H, G10 L1 and L10 with tools of a table; the stand-alone program needs the table in inches.

    No line has both G43 and M6: after it the stand-alone program would take its position from a stub without offsets.
    """
    dice = random.Random(seed)
    table, file = tmp_path / "mm.tbl", tmp_path / "program.ngc"
    table.write_text(TABLE, encoding="utf-8")
    inches = tmp_path / "inch.tbl"
    inches.write_text(_in_inches(TABLE), encoding="utf-8")
    lines = ["G21 F100", "T1 M6"]
    for _ in range(25):
        tool = dice.choice("127")
        lines.append(dice.choice([f"T{tool} M6", f"G43 H{tool}", "G43", f"G43.2 H{tool}", "G49", f"G10 L1 P{tool} Z{dice.randrange(30)}",
                                  f"G10 L10 P{tool} Z{dice.randrange(5)}", f"G10 L2 P1 X{dice.randrange(9)} Z2", "G43.1 Z7",
                                  "G0 X1 Z5", "G1 Z2", "G91 G0 Z1", "G90 G1 X3"]))  # fmt: skip
        lines.append(f"G0 Z{dice.randrange(20)}")
    file.write_text("\n".join([*lines, "M2", ""]), encoding="utf-8")
    theirs, complaint = their_moves(oracle, file, "rs274", tool=str(inches))
    ours, error = our_moves(file.read_text(encoding="utf-8"), tools=table)
    assert not complaint, complaint
    assert error is None
    wrong = difference(ours, theirs, exact=False)
    assert not wrong, wrong


def _in_inches(table: str) -> str:
    """Return a tool table in inches; lengths keep all their digits."""
    return re.sub(r"([XYZD])([-.0-9]+)", lambda word: f"{word[1]}{float(word[2]) / 25.4:.12f}", table.replace(" ; mill", ""))
