"""Velocity by the difference of two-tap means, against the plain difference over two ticks."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from contourlab.components.conformance import check_component
from contourlab.components.velocity.filtered_difference import TwoTapDifference
from contourlab.feed import uniform
from contourlab.geometry import contour
from contourlab.loop import simulate
from contourlab.scenario import load_controller, load_machine


def test_it_keeps_the_contract() -> None:
    check_component(TwoTapDifference)


def test_it_is_the_difference_over_two_ticks_of_the_measured_position() -> None:
    machine = load_machine("builtin:ghaffari/a3a1")
    controller = load_controller("builtin:ghaffari/calibrated", machine)
    axes = {name: replace(part, velocity=TwoTapDifference()) for name, part in controller.axes.items()}
    found = simulate(machine, replace(controller, axes=axes), uniform(contour("circle"), 0.5, 1, machine.servo_period))
    position, velocity = found["position"], found["velocity"]
    means = 0.5 * (position[1:] + position[:-1])
    assert np.abs(velocity[2:] - np.diff(means, axis=0) / machine.servo_period).max() < 1e-12
    first = position[0]
    assert np.abs(velocity[0] - (position[0] - first) / (2.0 * machine.servo_period)).max() < 1e-12
