"""Loops and calls are written out only where a move inside is corrected, and nothing else changes."""

import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from contourlab.features.precompensate.reading import read_blocks
from contourlab.program import Reading, read_program

PROGRAM = """%
N10 G21 G90 G64 P0.01 (start)
#100 = 3 #<deep> = 2
o<ring> sub
  #3 = [#1 * 2]
  G0 X[#1] Y0 (ring start)
  G1 Z-1 F100 S500 M3
  G3 X[#1] Y0 I[-#1] J0 F[#2]
  #100 = [#100 + 1]
o<ring> endsub [#3]
o<drill> sub
G0 X#1
G1 Z-2
o<drill> endsub
N20 o<ring> call [10] [600] (first)
N30 #200 = 1
o1 while [#200 LT 3]
  G1 X[#200 * 5] Y[2*#100] M8
  o2 if [#200 EQ 2]
    o<ring> call [5] [300]
  o2 endif
  #200 = [#200 + 1]
o1 endwhile
o<drill> call [4]
G0 X#100
M98 P77 L2
G91
o3 repeat [2]
G0 Z1
o3 endrepeat
G90
o<other> call
G1 X0 Y#200
M2
O77
G1 X2 F#100 (back)
M99
%
"""
UNROLLED = {
    15: "(N20 o<ring> call [10] [600]: unrolled)\nG0 X10 Y0 (ring start)\nG1 Z-1 F100 S500 M3\nG3 X10 Y0 I-10 J0 F600\n#100 = 4\n"
        "(end of N20 o<ring> call [10] [600])",
    17: "(o1 while [#200 LT 3]: unrolled)\nG1 X5 Y8 M8\nG1 X10 Y8 M8\nG0 X5 Y0 (ring start)\nG1 Z-1 F100 S500 M3\nG3 X5 Y0 I-5 J0 F300\n"
        "#100 = 5\n#200 = 3\n(end of o1 while [#200 LT 3])",
    26: "(M98 P77 L2: unrolled)\nG1 X2 F5 (back)\nG1 X2 F5 (back)\n(end of M98 P77 L2)",
    32: "(o<other> call: unrolled)\nG1 Y7\n(end of o<other> call)",
}  # fmt: skip


@pytest.fixture
def part(tmp_path: Path) -> Path:
    file = tmp_path / "part.ngc"
    file.write_text(PROGRAM)
    Path(tmp_path, "other.ngc").write_text("o<other> sub\nG1 Y[3+4]\no<other> endsub\nM2\n")
    return file


def test_only_what_is_corrected_is_written_out(part: Path) -> None:
    source = read_blocks(part, Reading(), ("x", "y"))
    by_line: dict[int, list[str]] = {}
    for number, line in zip(source.numbers, source.program.lines, strict=True):
        by_line.setdefault(number, []).append(line)
    shown = {number: "\n".join(lines) for number, lines in by_line.items()}
    assert {number: shown[number] for number in UNROLLED} == UNROLLED
    original = dict(enumerate(PROGRAM.splitlines(), 1))
    gone = set(original) - set(shown)
    assert gone == set(range(18, 24))  # the loop after its first line
    assert all(shown[number] == original[number] for number in set(shown) - set(UNROLLED))
    ends = [[move.end for move in program.moves] for program in (source.program, read_program(part))]
    np.testing.assert_allclose(*ends, atol=1e-12)
    assert not any(block.reason.startswith("inside") for block in source.blocks)


def test_a_program_that_would_move_differently_stays(tmp_path: Path) -> None:
    """The value of a call is known to the control only."""
    file = tmp_path / "part.ngc"
    file.write_text("G21 G90\no1 sub\nG1 X#1 F600\no1 endsub [7]\no1 call [5]\nG1 Y#<_value>\nM2\n")
    source = read_blocks(file, Reading(), ("x", "y"))
    assert source.blocks[0].reason == "inside a loop or subprogram"
    assert "\n".join(source.program.lines) + "\n" == file.read_text()


@pytest.mark.oracle
def test_linuxcnc_makes_the_same_moves(part: Path) -> None:
    if shutil.which("rs274") is None:
        pytest.skip("LinuxCNC's interpreter rs274 is not installed")

    def canonical(file: Path) -> list[str]:
        ran = subprocess.run(["rs274", "-g", file.name], cwd=file.parent, capture_output=True, text=True, check=True)
        return [re.sub(r"^\s*\d+\s+N\S+\s*", "", line) for line in ran.stdout.splitlines() if "COMMENT" not in line]

    plain = part.with_name("plain.ngc")
    plain.write_text("\n".join(read_blocks(part, Reading(), ("x", "y")).program.lines) + "\n")
    assert canonical(plain) == canonical(part)
    assert sum("ARC_FEED" in line for line in canonical(plain)) == 2
