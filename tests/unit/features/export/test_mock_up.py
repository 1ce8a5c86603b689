"""Exported mock-up units: valid, and equal to plain Python, bit for bit."""

from __future__ import annotations

import io
import subprocess
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from exported_axes import excited, exported

from contourlab.engine.translate import control, fmi
from contourlab.features.export.command import compiler, unit_of

PARTS = ["controller/cascade", "predictor/smith", "feedforward/friction", "compensation/quadrant-pulses", "gap_observer/multiple-model"]
needs_compiler = pytest.mark.skipif(compiler() is None, reason="no C compiler is installed")


def written(folder: Path, case: str, version: str) -> Path:
    file = folder / "axis_x.fmu"
    file.write_bytes(unit_of(exported(case).control, version))
    return file


@pytest.mark.parametrize("version", fmi.VERSIONS)
def test_the_interface_compiles_without_a_warning(tmp_path: Path, version: str) -> None:
    made = exported("controller/cascade").control
    (tmp_path / "axis_x.h").write_text(control.header_of(made))
    (tmp_path / "axis_x_fmi.c").write_text(fmi.wrapper_of(made, version))
    command = compiler()
    if command is None:
        pytest.skip("no C compiler is installed")
    strict = ["-std=c99", "-Wall", "-Wextra", "-Wconversion", "-pedantic", "-Werror", "-c"]
    done = subprocess.run([command, *strict, "axis_x_fmi.c"], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


@needs_compiler
@pytest.mark.parametrize("version", fmi.VERSIONS)
def test_fmpy_finds_no_fault_and_simulates_it(tmp_path: Path, version: str) -> None:
    fmpy = pytest.importorskip("fmpy", reason="fmpy is not installed")
    validation = pytest.importorskip("fmpy.validation")
    file = written(tmp_path, "feedforward/friction", version)
    assert validation.validate_fmu(str(file)) == []
    assert fmpy.simulate_fmu(str(file), stop_time=0.05, output=["command"])["command"].tolist() == [0.0] * 51
    units = {variable.name: variable.unit for variable in fmpy.read_model_description(str(file)).modelVariables}
    assert units["position"] == "m"
    assert units["controller_velocity_gain"] == "full_scale*s/m"
    assert units["command"] == "full_scale"


@needs_compiler
@pytest.mark.parametrize(
    ("case", "version"),
    [
        pytest.param(case, version, marks=[pytest.mark.slow] if (n + m) % 2 else [])
        for n, case in enumerate(PARTS) for m, version in enumerate(fmi.VERSIONS)
    ],
)  # fmt: skip
def test_it_computes_the_commands_of_plain_python(tmp_path: Path, case: str, version: str) -> None:
    fmpy = pytest.importorskip("fmpy", reason="fmpy is not installed")
    file, run = written(tmp_path, case, version), excited(exported(case))
    description = fmpy.read_model_description(str(file))
    number = {variable.name: variable.valueReference for variable in description.modelVariables}
    unit: Any = fmpy.instantiate_fmu(fmpy.extract(str(file)), description, "CoSimulation")
    three = version == "3.0"
    set_, get = (unit.setFloat64, unit.getFloat64) if three else (unit.setReal, unit.getReal)
    places, commands = [number[name] for name in run.names], []
    if not three:
        unit.setupExperiment(startTime=0.0)
    unit.enterInitializationMode()
    set_(places, run.inputs[0].tolist())
    unit.exitInitializationMode()
    for k, row in enumerate(run.inputs.tolist()):
        set_(places, row)
        unit.doStep(currentCommunicationPoint=1e-3 * k, communicationStepSize=1e-3)
        commands += get([number["command"]])
    with pytest.raises(Exception, match="DoStep"):  # not a whole number of periods
        unit.doStep(currentCommunicationPoint=0.4, communicationStepSize=1.5e-3)
    unit.terminate()
    unit.freeInstance()
    np.testing.assert_array_equal(commands, run.command)


def test_the_same_controller_gives_the_same_sources() -> None:
    one, other = (zipfile.ZipFile(io.BytesIO(unit_of(exported("controller/cascade").control, "3.0"))) for _ in range(2))
    names = one.namelist()
    assert names == other.namelist()
    assert {"modelDescription.xml", "sources/buildDescription.xml", "sources/axis_x.c", "sources/axis_x_fmi.c"} <= set(names)
    assert all(one.read(name) == other.read(name) for name in names if name.startswith(("sources", "model")))
