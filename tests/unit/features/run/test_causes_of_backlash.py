"""Backlash as a cause of an error."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import contourlab as cl
from contourlab.components.compensation.backlash import BacklashOffset
from contourlab.components.controller.cascade import Cascade
from contourlab.components.friction.laws import Coulomb
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.features.run.causes import causes, without_backlash
from contourlab.features.run.remedies import remedies
from contourlab.features.run.verdict import Trial, advice

PERIOD = 1e-3
DRIVE = TwoInertia(motor_inertia=5.2e-3, load_inertia=4.4e-3, lead=0.016, stiffness=9500.0, shaft_damping=0.5, backlash_gap=60e-6)


def rig(plant: TwoInertia, compensation: BacklashOffset | None = None) -> tuple[cl.Machine, cl.Controller, cl.Reference]:
    gains = Cascade.tune(80.0, 0.9, *plant.rigid_model(), 20.0)
    axis = cl.Axis("x", plant, Coulomb(coulomb=200.0), substeps=10)
    mine = cl.AxisController(controller=Cascade(**gains), feedback="motor", compensation=compensation)
    machine = cl.Machine("m", (axis, replace(axis, name="y")), PERIOD)
    return machine, cl.Controller({"x": mine, "y": mine}), cl.uniform(cl.contour("circle", radius=0.02), 0.25, 1, PERIOD)


def test_the_contribution_of_a_gap_is_the_change_of_error_without_it() -> None:
    machine, controller, reference = rig(DRIVE)
    judged = cl.judge(cl.simulate(machine, controller, reference), reference)
    sample = int(np.abs(judged["part_error"][1000:]).argmax()) + 1000
    found, untold = causes(machine, controller, reference, judged, sample)
    told = {cause.name: cause.contribution for cause in found}
    assert not untold
    assert sum(told.values()) == pytest.approx(abs(judged["part_error"][sample]))
    assert told["backlash"] > 0.3 * abs(judged["part_error"][sample])


def test_a_machine_without_a_gap_has_no_such_cause() -> None:
    machine, controller, reference = rig(DRIVE.replace(backlash_gap=0.0))
    judged = cl.judge(cl.simulate(machine, controller, reference), reference)
    found, _ = causes(machine, controller, reference, judged, 2500)
    assert "backlash" not in {cause.name for cause in found}


def test_without_the_gap_its_compensation_is_zero_too() -> None:
    machine, controller, _ = rig(DRIVE, BacklashOffset(backlash_gap=60e-6, backlash_velocity=0.01, backlash_acceleration=1.0))
    tight, told = without_backlash(machine, controller)
    assert all(axis.plant.gap_at(0.0) == 0.0 for axis in tight.axes)  # type: ignore[attr-defined]
    compensation = told.axes["x"].compensation
    assert compensation is not None and compensation.values()["backlash_gap"] == 0.0
    again, same = without_backlash(tight, controller)
    assert again is tight and same is controller


@pytest.mark.slow
def test_an_offset_is_tried_where_the_gap_has_no_compensation() -> None:
    machine, controller, reference = rig(DRIVE)
    words = "compensating the backlash by an offset on reversal"
    assert words in dict(remedies(machine, controller))
    judged = cl.judge(cl.simulate(machine, controller, reference), reference)
    start = Trial((), controller, reference, float(np.abs(judged["part_error"]).max()))
    best = advice(machine, start, 0.0)[0]
    assert best.changes and best.worst < 0.99 * start.worst
    offset = BacklashOffset(backlash_gap=60e-6, backlash_velocity=0.01, backlash_acceleration=1.0)
    assert words not in dict(remedies(*rig(DRIVE, offset)[:2]))
    assert words not in dict(remedies(*rig(DRIVE.replace(backlash_gap=0.0))[:2]))
