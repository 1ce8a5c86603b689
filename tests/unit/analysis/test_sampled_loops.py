"""Loops of many variants, analysed in lanes, equal loops analysed one by one."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from contourlab.analysis.linear.sampled_loop import rough_margins, sampled_loop, sampled_loops
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
    found = sampled_loops(axis, controller.axes[axis.name], machine.servo_period, columns, carried)
    assert len(found) == len(points)
    for i in (0, 1, 31, 32, 39):
        other = with_values(machine, controller, {name: float(column[i]) for name, column in columns.items()})[1]
        alone = sampled_loop(axis, other.axes[axis.name], machine.servo_period, carried)
        np.testing.assert_allclose(found[i].a, alone.a, rtol=1e-11, atol=1e-13)
        np.testing.assert_allclose(found[i].b, alone.b, rtol=1e-11, atol=1e-13)
        exact, rough = alone.margins(), rough_margins(found[i])
        assert exact.stable == rough.stable
        if exact.stable:
            assert 20.0 * math.log10(rough.gain / exact.gain) == pytest.approx(0.0, abs=0.02)
            assert math.degrees(rough.phase - exact.phase) == pytest.approx(0.0, abs=0.05)
            assert rough.modulus == pytest.approx(exact.modulus, rel=0.02)


def test_lanes_may_have_a_delay_of_several_ticks() -> None:
    machine, controller = stage()
    axis = replace(machine.axes[0], drive=DelayedSaturation(limit=1.0, delay=2.4e-3))
    columns = {"controller.axes.1.controller.position_gain": np.array([1000.0, 2120.0])}
    found = sampled_loops(axis, controller.axes["1"], machine.servo_period, columns)[1]
    alone = sampled_loop(axis, controller.axes["1"], machine.servo_period)
    np.testing.assert_allclose(np.sort_complex(found.poles), np.sort_complex(alone.poles), atol=1e-6)
    assert rough_margins(found).stable == alone.stable


def test_parameters_of_other_axes_are_ignored() -> None:
    machine, controller = stage()
    columns = {"controller.axes.3.controller.position_gain": np.array([1.0, 2.0]), "controller.coupling.weight": np.array([0.1, 0.9])}
    found = sampled_loops(machine.axes[0], controller.axes["1"], machine.servo_period, columns)
    np.testing.assert_array_equal(found[0].a, found[1].a)


def test_a_nonlinear_part_is_refused() -> None:
    machine, controller = stage()
    axis = replace(machine.axes[0], drive=DelayedSaturation(limit=1.0, delay=1.5))
    with pytest.raises(ComponentError, match=r"axis 1: .*\b1000\b"):
        sampled_loops(axis, controller.axes["1"], machine.servo_period, {"controller.axes.1.controller.position_gain": np.array([1.0])})
