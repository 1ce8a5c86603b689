"""Loops of many variants, analysed in lanes, equal loops analysed one by one."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from contourlab.analysis.linear.sampled_loop import lane_loops, sampled_loop
from contourlab.components.drive.saturation import DelayedSaturation
from contourlab.errors import ComponentError
from contourlab.loop import Controller, Machine
from contourlab.loop.parameters import with_values
from contourlab.papers.ghaffari.setup import TABLE_2, Reading, controller, machine
from contourlab.scenario import load_controller, load_machine
from contourlab.study import Space

READING = Reading()


def stage() -> tuple[Machine, Controller]:
    return machine(1, READING), controller(1, TABLE_2, READING)


def mill() -> tuple[Machine, Controller]:
    found = load_machine("builtin:xyz")
    return found, load_controller("builtin:xyz-controller", found)


@pytest.mark.parametrize("made", [stage, mill])
def test_each_lane_is_the_loop_of_its_own_values(made: object) -> None:
    machine, controller = made()  # type: ignore[operator]
    space = Space.chosen(machine, controller)
    points = np.vstack([space.start, np.random.default_rng(7).uniform(0.25, 0.75, (39, len(space.numbers)))])
    columns = space.columns(points)
    axis = machine.axes[0]
    carried = machine.carried_mass(axis.name)
    rough = lane_loops(axis, controller.axes[axis.name], machine.servo_period, carried, columns).margins()
    assert rough.stable.shape == (len(points),)
    for i in (0, 1, 31, 32, 39):
        other = with_values(machine, controller, {name: float(column[i]) for name, column in columns.items()})[1]
        exact = sampled_loop(axis, other.axes[axis.name], machine.servo_period, carried).margins()
        assert exact.stable == rough.stable[i]
        if exact.stable:
            assert 20.0 * math.log10(rough.gain[i] / exact.gain) == pytest.approx(0.0, abs=0.02)
            assert math.degrees(rough.phase[i] - exact.phase) == pytest.approx(0.0, abs=0.05)
            assert rough.modulus[i] == pytest.approx(exact.modulus, rel=0.02)
        else:
            assert math.isnan(rough.gain[i])


def test_lanes_may_have_a_delay_of_several_ticks() -> None:
    machine, controller = stage()
    axis = replace(machine.axes[0], drive=DelayedSaturation(limit=1.0, delay=2.4e-3))
    columns = {"controller.axes.1.controller.position_gain": np.array([1000.0, 2120.0])}
    lanes = lane_loops(axis, controller.axes["1"], machine.servo_period, 0.0, columns)
    for i, gain in enumerate(columns["controller.axes.1.controller.position_gain"].tolist()):
        law = controller.axes["1"].controller.replace(position_gain=gain)
        alone = sampled_loop(axis, replace(controller.axes["1"], controller=law), machine.servo_period)
        assert lanes.radius(1.0)[i] == pytest.approx(np.abs(alone.poles).max(), abs=1e-6)
        assert lanes.margins().stable[i] == alone.stable


def test_a_variant_without_integral_is_stable() -> None:
    """Its integral still adds up, but nothing reads it."""
    machine, controller = stage()
    columns = {"controller.axes.1.controller.integral_gain": np.array([5.0, 0.0])}
    lanes = lane_loops(machine.axes[0], controller.axes["1"], machine.servo_period, 0.0, columns)
    law = controller.axes["1"].controller.replace(integral_gain=0.0)
    exact = sampled_loop(machine.axes[0], replace(controller.axes["1"], controller=law), machine.servo_period).margins()
    rough = lanes.margins()
    assert exact.stable and rough.stable.all()
    assert rough.phase[1] == pytest.approx(exact.phase, abs=1e-3)
    assert lanes[np.array([1])].margins().phase == pytest.approx(rough.phase[1:], rel=1e-9)


def test_parameters_of_other_axes_are_ignored() -> None:
    machine, controller = stage()
    columns = {"controller.axes.3.controller.position_gain": np.array([1.0, 2.0]), "controller.coupling.weight": np.array([0.1, 0.9])}
    lanes = lane_loops(machine.axes[0], controller.axes["1"], machine.servo_period, 0.0, columns)
    np.testing.assert_array_equal(lanes.a[0], lanes.a[1])
    assert len(lanes.margins().phase) == 2


def test_a_nonlinear_part_is_refused() -> None:
    machine, controller = stage()
    axis = replace(machine.axes[0], drive=DelayedSaturation(limit=1.0, delay=1.5))
    with pytest.raises(ComponentError, match=r"axis 1: .*\b1000\b"):
        lane_loops(axis, controller.axes["1"], machine.servo_period, 0.0, {"controller.axes.1.controller.position_gain": np.array([1.0])})
