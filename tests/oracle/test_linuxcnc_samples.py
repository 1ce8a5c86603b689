"""The configurations that LinuxCNC ships: each is read or refused in one line, and its values are those of LinuxCNC's own reader."""

import shutil
import subprocess
from pathlib import Path

import pytest

from contourlab.controls.linuxcnc.files import read_ini
from contourlab.errors import ScenarioError
from contourlab.scenario import load_machine

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
