"""The part error as the goal: batches judge against the programmed path, and a calibration never ends worse than it began."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import contourlab as cl
from contourlab.features.tune.study import TuneSettings, tune
from contourlab.loop.parameters import with_values
from contourlab.scenario import Scenario, scenario_from_parts
from contourlab.study import Setting

PART = "G21 G17 G90 F2400\nG64 P0.05\nG0 X5 Y5 Z5\nG1 Z0\nG1 X15\nY12\nG3 X10 Y17 I-5 J0\nG1 X5 Y12\nG0 Z5\nM2\n"


@pytest.fixture(scope="module")
def scenario(tmp_path_factory: pytest.TempPathFactory) -> Scenario:
    part = tmp_path_factory.mktemp("part") / "part.ngc"
    part.write_text(PART, encoding="ascii")
    return scenario_from_parts(part, "xyz", "xyz-controller")


def test_batches_judge_the_part_error_exactly(scenario: Scenario) -> None:
    """Rounded corners: the part error is not the contour error, and equals that of the exact judge."""
    case = scenario.base
    reference = case.reference()
    plant = case.machine.axis("x").plant
    dampings = [plant.values()["damping"] * factor for factor in (1.0, 1.3)]
    batch = cl.simulate_batch(case.machine, case.controller, reference, {"axes.x.plant.damping": dampings}, part=True)
    for i, damping in enumerate(dampings):
        other = plant.replace(damping=damping)
        axes = tuple(replace(axis, plant=other) if axis.name == "x" else axis for axis in case.machine.axes)
        judged = cl.judge(cl.simulate(replace(case.machine, axes=axes), case.controller, reference), reference)
        error = np.abs(judged["part_error"][reference.judged.samples])
        assert batch.figures["part_error_max"][i] == pytest.approx(error.max(), rel=1e-3)
        assert batch.figures["part_error_rms"][i] == pytest.approx(np.sqrt(np.mean(error**2)), rel=1e-3)
        assert batch.figures["part_error_max"][i] > 1.1 * batch.figures["contour_error_max"][i]


@pytest.mark.slow
@pytest.mark.parametrize("method", ["sequential", "both"])
def test_a_calibration_never_ends_worse(scenario: Scenario, method: str) -> None:
    """Started again from its own result it stays at least as good, whatever its rule prefers."""
    case = scenario.base
    controller, largest = case.controller, np.inf
    for _ in range(2):
        settings = TuneSettings(within=0.2, method=method, budget=200, parameter=("position_gain", "velocity_gain"))
        tuned = tune(Setting(case.machine, controller, case.reference()), settings)
        assert tuned.after.figures["part_error_max"] <= min(largest, tuned.before.figures["part_error_max"])
        controller, largest = tuned.controller, tuned.after.figures["part_error_max"]


FLAT = "G21 G17 G90 G61 F2400\nG0 X5 Y5\nG1 X25\nG3 X30 Y10 I0 J5\nG1 X25\nM2\n"


@pytest.mark.parametrize("method", ["sequential", "global"])
@pytest.mark.slow
def test_gains_of_an_axis_that_does_not_move_stay(method: str, tmp_path: Path) -> None:
    """On a part in x and y every search has moved z's gains; it has nothing to gain there."""
    (tmp_path / "flat.ngc").write_text(FLAT, encoding="ascii")
    case = scenario_from_parts(tmp_path / "flat.ngc", "xyz", "xyz-controller").base
    names = tuple(f"controller.axes.{axis}.controller.{gain}" for axis in "zyx" for gain in ("velocity_gain", "position_gain"))
    known = cl.loop.parameters_of(case.machine, case.controller)
    slow = {name: 0.5 * getattr(*known[name]) for name in names if ".z." not in name}
    machine, controller = with_values(case.machine, case.controller, slow)
    tuned = tune(Setting(machine, controller, case.reference()), TuneSettings(method=method, budget=300, starts=1, parameter=names))
    assert tuned.method == method and not tuned.after.violations
    start = {variable.name: variable.value for variable in tuned.space.numbers}
    moved = {name for name, value in tuned.values.items() if value != start[name]}
    assert moved and not any(".z." in name for name in moved)
    (left,) = [found for found in tuned.findings if found.code == "CL611"]
    assert left.values["share"] == 0.01 and {"z.velocity_gain"} <= set(left.values["parameters"])
    assert {variable.short for variable in tuned.space.numbers if variable.name in moved}.isdisjoint(left.values["parameters"])
    assert tuned.after.figures["part_error_max"] < 0.95 * tuned.before.figures["part_error_max"]
