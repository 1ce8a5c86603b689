"""A start by pole placement: for each axis the fastest poles that keep the margins, and all axes slowed down together as far as it pays."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from contourlab.analysis.linear.loop_lanes import rough_margins, sampled_loops
from contourlab.components.contract import Component
from contourlab.design.bounds import SLACK, Bounds
from contourlab.errors import ComponentError, ParameterError
from contourlab.loop import Axis, AxisController, Controller, Machine

SPEEDS = 96
"""Speeds that are tried, from a ten-thousandth of the Nyquist frequency to half of it."""
SCALED = {"natural_frequency": 1.0, "bandwidth": 1.0, "crossover": 1.0, "pole": 1.4}
"""Wishes that follow the speed; the real pole as far out as in Ghaffari & Ulsoy, 35 to 25 rad/s."""
FIXED = {"damping": 0.7, "phase_margin": math.radians(60.0)}


def fastest(machine: Machine, controller: Controller, bounds: Bounds) -> dict[str, float]:
    """Return for each axis the largest speed [rad/s] of placed poles that keeps the margins, or comes nearest to it.

    Raises
    ------
    ParameterError
        If a controller works out no gains, its loop has no linear model, or is stable at no speed.
    """
    return {axis.name: _fastest(machine, axis, controller.axes[axis.name], bounds) for axis in machine.axes}


def placed_gains(machine: Machine, controller: Controller, speeds: Mapping[str, float]) -> Controller:
    """Return the controller with gains placed at a speed [rad/s] for each axis."""
    axes = dict(controller.axes)
    for axis in machine.axes:
        mine = axes[axis.name]
        gains = _designed(mine.controller, speeds[axis.name], model_of(machine, axis, mine), axis.name)
        axes[axis.name] = replace(mine, controller=mine.controller.replace(**gains))
    return replace(controller, axes=axes)


def _fastest(machine: Machine, axis: Axis, mine: AxisController, bounds: Bounds) -> float:
    model = model_of(machine, axis, mine)
    speeds = np.geomspace(1e-4, 0.5, SPEEDS) * math.pi / machine.servo_period
    found: list[tuple[float, dict[str, float]]] = []
    for speed in speeds.tolist():
        try:
            found.append((speed, _designed(mine.controller, speed, model, axis.name)))
        except ParameterError as error:
            last = error
            continue
    if not found:
        raise ParameterError(f"axis {axis.name}", "no placing", f"gains that can be worked out: {last}") from last
    head = f"controller.axes.{axis.name}.controller."
    names = [name for name, value in found[0][1].items() if math.isfinite(value)]
    columns = {head + name: np.array([gains[name] for _, gains in found]) for name in names}
    base = replace(mine, controller=mine.controller.replace(**found[0][1]))
    try:
        loops = sampled_loops(axis, base, machine.servo_period, columns, machine.carried_mass(axis.name))
    except ComponentError as error:
        raise ParameterError("start", "placed", f"scenario, since the loop of axis {axis.name} has no linear model: {error}") from error
    short = [bounds.missing(rough_margins(loop), SLACK) for loop in loops]
    least = min(short)
    if math.isinf(least):
        raise ParameterError("start", "placed", f"scenario: at no speed of its poles is axis {axis.name} stable")
    # Where the observer alone takes the margins, the poles that take the least of them are a start: one of the other numbers restores them.
    return max(speed for (speed, _), missing in zip(found, short, strict=True) if missing <= least)


def model_of(machine: Machine, axis: Axis, mine: AxisController) -> tuple[float, float]:
    """Return gain and damping of what the position loop sees: the observer's model where there is one, else the loaded plant's."""
    observer = mine.observer
    if observer is not None and {"model_gain", "model_damping"} <= set(observer.parameters):
        values = observer.values()
        return float(values["model_gain"]), float(values["model_damping"])
    return machine.loaded_plant(axis.name).rigid_model()


def _designed(part: Component, speed: float, model: tuple[float, float], axis: str) -> dict[str, float]:
    """Return the gains of a component for poles of a speed [rad/s]."""
    kind: Any = type(part)
    wishes: dict[str, float] = {}
    for name, parameter in kind.wishes.items():
        if name in SCALED and not (name == "pole" and parameter.default is not None and not part.values().get("integral_gain")):
            wishes[name] = SCALED[name] * speed
        elif name in FIXED:
            wishes[name] = FIXED[name]
        elif parameter.default is not None:
            wishes[name] = parameter.default
        else:
            raise ParameterError("start", "placed", f"scenario: {part.kind} on axis {axis} wants {name}, which nothing here tells")
    if not set(wishes) & set(SCALED):
        raise ParameterError("start", "placed", f"scenario: {part.kind} on axis {axis} works out no gains from poles")
    return dict(kind.designed(wishes, *model))
