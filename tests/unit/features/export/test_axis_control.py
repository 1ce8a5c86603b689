"""The controller of one axis, cut out of the servo loop."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from each import each
from exported_axes import CASES, REFUSED, excited, exported
from refusals import refuses

from contourlab.components.ideal import IdealSensor
from contourlab.errors import ParameterError
from contourlab.features.export.command import axis_control, record, there_and_back
from contourlab.loop import Controller, Machine
from contourlab.scenario import load_controller, load_machine


def shipped(name: str = "xyz", controller: str = "xyz-controller") -> tuple[Machine, Controller]:
    machine = load_machine(f"builtin:{name}")
    return machine, replace(load_controller(f"builtin:{controller}", machine), coupling=None)


@pytest.mark.parametrize("axis", ["x", "z"])
def test_alone_it_computes_the_commands_of_the_loop_bit_for_bit(axis: str) -> None:
    machine, controller = shipped()
    machine = replace(machine, axes=tuple(replace(one, sensor=IdealSensor()) for one in machine.axes))
    found = axis_control(machine, controller, axis)
    motion = there_and_back(machine.axis(axis), machine.servo_period, 600) + np.array([0.0125, 0.0, 0.0])
    run = record(found, motion)
    assert np.abs(run.command).max() > 0.1
    np.testing.assert_array_equal(run.command, run.in_loop)


def test_a_change_of_a_parameter_is_free_only_where_nothing_is_derived_from_it() -> None:
    machine, controller = shipped()
    made = axis_control(machine, controller, "x").control
    assert {field.name for field in made.parameters.values()} == {"observer_model_damping", "controller_velocity_gain", "drive_limit"}
    assert "controller_integral_rate" in {field.name for field in made.constants.values()}
    assert {field.name: field.unit for field in made.parameters.values()}["controller_velocity_gain"] == "A*s/m"


def test_the_hash_names_machine_and_controller() -> None:
    machine, controller = shipped()
    one, other = (axis_control(which, controller, "x").digest for which in (machine, replace(machine, servo_period=1e-3)))
    assert one == axis_control(machine, controller, "y").digest != other


def test_what_one_axis_cannot_know_is_refused() -> None:
    machine = load_machine("builtin:xyz")
    with refuses(ParameterError, name="controller.coupling"):
        axis_control(machine, load_controller("builtin:xyz-controller", machine), "x")
    for case in REFUSED:
        with refuses(ParameterError, name=f"controller.axes.x.{case.partition('/')[0]}"):
            exported(case)


@each("case", [case for case in CASES if case not in REFUSED])
def test_every_part_of_an_axis_can_be_exported(case: str) -> None:
    run = excited(exported(case), 100)
    assert np.isfinite(run.command).all()
    assert np.ptp(run.command) > 0.0


def test_text_of_others_cannot_leave_its_comment() -> None:
    machine, controller = shipped()
    notes = axis_control(replace(machine, name='a */ b *) "c" <d>\n'), controller, "x").control.notes
    assert not set('\n"<>') & set("".join(notes))
    assert "*/" not in notes[0] and "*)" not in notes[0]
