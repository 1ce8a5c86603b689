"""The configurations that LinuxCNC ships: each is read or refused in one line, and its values are those of LinuxCNC's own reader."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from made_controls import LINUXCNC

from contourlab.controls.linuxcnc.files import read_ini
from contourlab.errors import ScenarioError
from contourlab.program import Feed, read_program
from contourlab.scenario import load_machine
from contourlab.scenario.load import reading_on

SAMPLES = Path("/usr/share/doc/linuxcnc/examples/sample-configs")
KEYS = (("TRAJ", "LINEAR_UNITS"), ("KINS", "KINEMATICS"), ("EMCMOT", "SERVO_PERIOD"), ("JOINT_0", "MAX_VELOCITY"), ("AXIS_X", "MAX_LIMIT"))


def configurations() -> list[Path]:
    if not SAMPLES.is_dir():
        pytest.skip("LinuxCNC's sample configurations are not installed")
    return sorted(SAMPLES.rglob("*.ini"))


def test_each_is_read_or_refused() -> None:
    read = 0
    for file in configurations():
        try:
            machine = load_machine(file)
        except ScenarioError as error:
            assert "\n" not in str(error), file
        else:
            read += 1
            assert machine.control is not None
            assert all(name in machine.axis_names for name in machine.control.unmodelled)
    assert read > 250


def test_values_are_those_of_its_own_reader() -> None:
    """``inivar`` reads no included file."""
    reader = shutil.which("inivar")
    if reader is None:
        pytest.skip("inivar is not installed")
    compared = 0
    for file in configurations()[::8]:
        if "#INCLUDE" in file.read_text(errors="replace"):
            continue
        ini = read_ini(file)
        for section, key in KEYS:
            told = subprocess.run([reader, "-ini", file, "-sec", section, "-var", key], capture_output=True, text=True)
            entry = ini.first(section, key)
            expected = told.stdout.strip() if told.returncode == 0 else ""
            assert (entry.value if entry else "") == expected.split(" #")[0].strip(), (file, section, key)
            compared += bool(expected)
    assert compared > 50


def test_subprograms_are_found_in_its_order(tmp_path: Path) -> None:
    """PROGRAM_PREFIX first, then SUBROUTINE_PATH; the folder of the program itself is not among them."""
    interpreter = shutil.which("rs274")
    if interpreter is None:
        pytest.skip("LinuxCNC's interpreter rs274 is not installed")
    file = tmp_path / "m.ini"
    more = "[DISPLAY]\nPROGRAM_PREFIX = nc\n[RS274NGC]\nPARAMETER_FILE = m.var\nSUBROUTINE_PATH = subs:more\n"
    file.write_text(LINUXCNC.replace("[RS274NGC]\n", more))
    part = tmp_path / "prog" / "part.ngc"
    for folder, x in (("prog", 4), ("more", 3), ("subs", 2), ("nc", 1)):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "foo.ngc").write_text(f"o<foo> sub\nG1 X{x} F100\no<foo> endsub\nM2\n")
        part.write_text("G20\no<foo> call\nM2\n")
        done = subprocess.run([interpreter, "-i", file, "-g", part], capture_output=True, text=True, timeout=60, cwd=tmp_path)
        theirs = re.findall(r"STRAIGHT_FEED\(([\d.]+)", done.stdout)
        program = read_program(part, reading=reading_on(load_machine(file), {"parameters": None}))
        ours = [move.end[0] / 0.0254 for move in program.moves if isinstance(move, Feed)]
        assert ours == pytest.approx([x]) and list(map(float, theirs)) == pytest.approx([] if folder == "prog" else ours)
