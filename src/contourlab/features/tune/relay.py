"""Gains by rules from a simulated relay experiment (Astrom & Hagglund)."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from contourlab.analysis.identification.relay import PID, RULES, RelayTest, relay_test
from contourlab.arrays import Array
from contourlab.components.contract import Component
from contourlab.components.controller.relay import Relay
from contourlab.errors import DivergenceError, ParameterError, ResultError, refuse
from contourlab.feed import Reference
from contourlab.loop import Axis, AxisController, simulate
from contourlab.study import Setting, Space

SHARE = 0.5
"""Level of the relay over the limit of the drive; halved while an axis leaves its following-error limit, but not below `LEAST`."""
LEAST = 0.01
NOISES = 4.0
"""Hysteresis over the noise of the sensor."""
TICKS = (1 << 13, 1 << 17)
"""Ticks of the first experiment, and the most of those that follow, each four times as long until enough cycles are steady."""
ENOUGH = 30
"""Steady cycles that end an experiment."""


def relay_tests(setting: Setting) -> dict[str, RelayTest]:
    """Simulate a relay experiment with all axes where the motion begins, and return its outcome by axis.

    Raises
    ------
    ParameterError
        If a drive has no limit or reaches it, or no axis oscillates steadily within its following-error limit.
    """
    machine, controllers = setting.machine, setting.controller.axes
    for axis in machine.axes:
        slots = controllers[axis.name]
        alone = not (slots.predictor or slots.supervisor or slots.link or axis.plant.takes_position)
        refuse(not alone, ParameterError, "method", "relay", f"another: a relay alone cannot close the loop of axis {axis.name}")
        refuse(not math.isfinite(_limit(axis)), ParameterError, "method", "relay", f"given with a limit of the drive of axis {axis.name}")
    start, share, n = setting.reference.block(0, 1).position, SHARE, TICKS[0]
    while True:
        relays = {axis.name: _closed(axis, controllers[axis.name], share) for axis in machine.axes}
        held = replace(setting, controller=replace(setting.controller, axes=relays, estimator=None, coupling=None))
        try:
            tests = _tests(held, np.repeat(start, n, axis=0))
            if n == TICKS[1] or min(test.cycles for test in tests.values()) >= ENOUGH:
                return tests
            n *= 4
        except DivergenceError as error:
            refuse(share < LEAST, ParameterError, "method", "relay", f"another: {error}")
            share *= 0.5
        except ResultError as error:
            refuse(n == TICKS[1], ParameterError, "method", "relay", f"another: {error}")
            n *= 4


def _limit(axis: Axis) -> float:
    """Return the limit of the drive [command]; infinite if there is none."""
    return float(getattr(axis.drive, "limit", math.inf))


def _closed(axis: Axis, slots: AxisController, share: float) -> AxisController:
    sensor = axis.sensor
    hysteresis = getattr(sensor, "resolution", 0.0) + (NOISES * getattr(sensor, "noise", 0.0) if sensor.kind == "encoder" else 0.0)
    return replace(slots, controller=Relay(amplitude=share * _limit(axis), hysteresis=hysteresis), feedforward=None)


def _tests(setting: Setting, positions: Array) -> dict[str, RelayTest]:
    machine = setting.machine
    reference = Reference.from_samples(positions, machine.servo_period, setting.reference.path)
    run = simulate(machine, setting.controller, reference, seed=setting.seed)
    tests = {}
    for i, axis in enumerate(machine.axes):
        slots = setting.controller.axes[axis.name]
        refuse(float(np.abs(run["command"][:, i]).max()) > _limit(axis), ResultError, f"axis {axis.name}: the drive is at its limit")
        asked = run["unfiltered_command" if slots.filters else "command"][:, i]
        if slots.observer is not None:  # the relay sees the axis with its observer, as the controller does
            asked = asked + run["disturbance_estimate"][:, i]
        try:
            tests[axis.name] = relay_test(asked, run["position"][:, i] - positions[0, i], machine.servo_period)
        except ResultError as error:
            raise ResultError(f"axis {axis.name}: {error}") from error
    return tests


def rule_values(setting: Setting, space: Space, tests: Mapping[str, RelayTest]) -> dict[str, dict[str, float]]:
    """Return the values [SI] of the space by each rule that sets just the gains that are in use.

    Raises
    ------
    ParameterError
        If a controller has no such gains, or no rule sets those in use.
    """
    start, by_rule = {one.name: one.nearest for one in space.numbers}, dict[str, dict[str, float]]()
    for rule in RULES:
        values = dict(start)
        for axis, test in tests.items():
            part = setting.controller.axes[axis].controller
            terms = _terms(part, test.gains(rule))
            used = {name for name in terms if getattr(part, name) not in (0.0, math.inf)}
            names = {f"controller.axes.{axis}.controller.{name}": value for name, value in terms.items() if value not in (0.0, math.inf)}
            if not terms or used != {name.rpartition(".")[2] for name in names} or not names.keys() <= start.keys():
                break
            values |= names
        else:
            by_rule[rule] = values
    refuse(not by_rule, ParameterError, "method", "relay", "given with gains of P, PI or PID in use on all axes: no rule sets those in use")
    return by_rule


def _terms(part: Component, gains: PID) -> dict[str, float]:
    """Return the parameters of a controller that acts on the position as u = P e + I int e - D v."""
    p, i, d = gains.proportional, gains.integral, gains.derivative
    match part.kind:
        case "pid":
            return {"proportional_gain": p, "integral_gain": i, "derivative_gain": d}
        case "state-feedback":
            return {"position_gain": p, "integral_gain": i, "velocity_gain": d}
        case "position":
            return {"position_gain": p, "integral_gain": i / p, "velocity_gain": d}
        case "cascade" if d > 0.0:
            # K (K_v + 1/T_i) = P and K K_v/T_i = I, with K_v the larger of the two
            half = 0.5 * p / d
            kv = half + math.sqrt(max(half**2 - i / d, 0.0))
            return {"velocity_gain": d, "position_gain": kv, "integral_time": d * kv / i if i else math.inf}
    return {}
