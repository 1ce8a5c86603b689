"""Third-party programs, unchanged: LinuxCNC's interpreter makes the same moves, or the unsupported word is named."""

from __future__ import annotations

import os
import re
from pathlib import Path
from types import ModuleType

import pytest
from program_oracle import NEEDED, compare, difference, load_oracle, our_moves, their_moves
from reference_data import part_programs

from contourlab.errors import ProgramEndError, ProgramError
from contourlab.program import read_program

pytestmark = NEEDED

INSTALLED = Path("/usr/share/linuxcnc/ncfiles")
FILES = {file.name: file for file in part_programs()}
FILES |= {
    str(file.relative_to(INSTALLED)): file
    for file in sorted(INSTALLED.rglob("*"))
    if file.suffix in {".ngc", ".nc", ".gcode"} and f"linuxcnc__nc_files_{file.name}" not in FILES
}

UNSUPPORTED = {
    "cncjs__examples_gcode_helical-thread-milling.gcode": "G42",
    "linuxcnc__nc_files_daisy.ngc": "A",
    "b-index.ngc": "B",
    "comp-g1.ngc": "G41",
    "comp.ngc": "G42",
    "comp311.ngc": "G41",
    "comp311_2.ngc": "G41",
    "cone.ngc": "B",
    "g76.ngc": "G41",
    "gmoccapy_2_tools_with_cutter_radius_compensation.ngc": "G41",
    "gridprobe.ngc": "G38.2",
    "lathe-g76.ngc": "G41",
    "lathe_g70_71_demo.ngc": "G71.1",
    "lathe_g7x_face_boring.ngc": "G72",
    "lathe_g7x_quadrants.ngc": "G70",
    "lathecomp.ngc": "G42",
    "m70m72-demo.ngc": "M70",
    "m73-demo.ngc": "M73",
    "mmount.ngc": "G41",
    "smartprobe.ngc": "G38.5",
    "threading.ngc": "G33",
    "toplevel.ngc": "M70",
    "useful-subroutines.ngc": "G41",
}
"""Files that need a word that is not supported, and the first such word."""
ONLY_CLOSING_PERCENT = {"CAMotics__examples_compass_text.ngc"}


@pytest.fixture(scope="module")
def oracle() -> ModuleType:
    return load_oracle()


OTHERS = [key for key in FILES if key not in UNSUPPORTED.keys() | ONLY_CLOSING_PERCENT]


@pytest.mark.parametrize("key", OTHERS)
@pytest.mark.slow
def test_the_same_moves(oracle: ModuleType, key: str) -> None:
    """Only the stand-alone program reads tool changes; it prints four decimals and has inches as machine units."""
    file = FILES[key]
    _, complaint = their_moves(oracle, file, "rs274")
    if complaint:
        # Subprograms in separate files, and faults: refused here too.
        with pytest.raises(ProgramError):
            read_program(file)
        return
    _, wrong = compare(oracle, file, backend="rs274")
    assert not wrong, wrong


@pytest.mark.parametrize("key", [key for key in FILES if key in UNSUPPORTED])
def test_unsupported_words_are_reported_at_their_place(key: str) -> None:
    file, word = FILES[key], UNSUPPORTED[key]
    with pytest.raises(ProgramError) as caught:
        read_program(file)
    error = caught.value
    assert error.message.startswith(f"{word} (") and "supported" in error.message
    there = Path(error.file).read_text(encoding="latin-1").split("\n")[error.line - 1][error.column - 1 :]
    assert re.sub(r"(?<=[A-Z])0+(?=[0-9])", "", there.upper().replace(" ", "")).startswith(word)


def test_the_list_of_unsupported_files_is_up_to_date() -> None:
    if not INSTALLED.is_dir() or not part_programs():
        pytest.skip("one of the two collections is not there")
    assert FILES.keys() >= UNSUPPORTED.keys() | ONLY_CLOSING_PERCENT
    assert len(OTHERS) > 150


@pytest.mark.parametrize("name", sorted(ONLY_CLOSING_PERCENT))
def test_a_percent_that_only_closes_is_refused(name: str) -> None:
    """The interpreter refuses it, too; without that line the moves are the same."""
    if name not in FILES:
        pytest.skip("the file is not there")
    with pytest.raises(ProgramEndError, match="%"):
        read_program(FILES[name])


GIVES_UP = {"linuxcnc__nc_files_3D_Chips.ngc"}
"""Outside LinuxCNC the module stops at a word in these files."""
DOUBLES = [file.name for file in part_programs() if file.name in OTHERS and file.name not in GIVES_UP]


@pytest.mark.parametrize("key", DOUBLES)
@pytest.mark.slow
def test_the_same_moves_in_full_doubles(oracle: ModuleType, tmp_path: Path, key: str) -> None:
    """Remove the tool words, which the module cannot run outside LinuxCNC; the tools have zero length, so nothing else changes."""
    text = FILES[key].read_text(encoding="latin-1")
    file = tmp_path / "program.ngc"
    file.write_text(re.sub(r"\bT[0-9]+\b|\bM0?6(?![0-9])|G43\s*H[0-9]+|(?<![A-Z])G43(?![.0-9])", " ", text), encoding="latin-1")
    count, wrong = compare(oracle, file)
    assert not wrong, wrong
    assert count == len(our_moves(file.read_text(encoding="latin-1"))[0]) > 1


LINUXCNC = os.environ.get("CONTOURLAB_LINUXCNC_TESTS", "")
"""The folder `tests` of LinuxCNC's sources; not shipped with contourlab."""
OTHERWISE = {
    # LinuxCNC feeds along another axis than the one normal to the plane.
    "g18-g98-g84.ngc", "g18-g99-g84.ngc", "g19-g98-g84.ngc", "g19-g99-g84.ngc",
    # Its INI file says which parameters are read-only, and where subprogram files are.
    "interp/iniparam-failassign/test.ngc", "interp/sequence-number/test.ngc",
    # Line numbers of six digits run into the next word of the oracle's answer, or more moves than the helper reads.
    "3D_Chips.ngc", "stellabee1.ngc",
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.skipif(not LINUXCNC, reason="CONTOURLAB_LINUXCNC_TESTS does not name LinuxCNC's folder of tests")
def test_golden_cases_of_linuxcnc(oracle: ModuleType) -> None:
    """Each program is refused by both, makes the same moves, or needs a word that is not supported."""
    wrong, same = {}, 0
    for file in sorted(Path(LINUXCNC).rglob("*.ngc")):
        if any(str(file).endswith(name) for name in OTHERWISE):
            continue
        text = file.read_text(encoding="latin-1")
        made, error = our_moves(text, file.parent)
        if error is not None and "supported" in error.message:
            continue
        theirs, complaint = their_moves(oracle, file, "rs274")
        if bool(complaint) != (error is not None):
            wrong[str(file)] = f"ours: {error}, theirs: {complaint}"
        elif error is None and (apart := difference(made, theirs, exact=False)):
            wrong[str(file)] = apart
        same += 1
    assert not wrong
    assert same > 250
