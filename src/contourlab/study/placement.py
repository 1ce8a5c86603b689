"""Gains of an axis from poles, and the fastest poles that keep the margins."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np

from contourlab.analysis.linear.sampled_loop import rough_margins, sampled_loops
from contourlab.components.contract import Component
from contourlab.errors import ComponentError, ParameterError
from contourlab.loop import Axis, AxisController, Machine
from contourlab.study.guards import SLACK, Bounds

SPEEDS = 96
"""Number of pole speeds tried, from a ten-thousandth of the Nyquist frequency to half of it."""
SCALED = {"natural_frequency": 1.0, "bandwidth": 1.0, "crossover": 1.0, "pole": 1.4}
"""Design requests that scale with the speed; ratio of the real pole as in Ghaffari & Ulsoy, 35 to 25 rad/s."""
FIXED = {"damping": 0.7, "phase_margin": math.radians(60.0)}


def fastest_speed(machine: Machine, axis: Axis, slots: AxisController, bounds: Bounds) -> float:
    """Return the largest speed [rad/s] of placed poles that keeps the margins, or comes nearest to keeping them."""
    model = model_of(machine, axis, slots)
    speeds = np.geomspace(1e-4, 0.5, SPEEDS) * math.pi / machine.servo_period
    designs: list[tuple[float, dict[str, float]]] = []
    for speed in speeds.tolist():
        try:
            designs.append((speed, designed(slots.controller, speed, model, axis.name)))
        except ParameterError as error:
            last = error
    if not designs:
        raise ParameterError("start", "placed", f"scenario: axis {axis.name} has no gains at any pole speed: {last}") from last
    head = f"controller.axes.{axis.name}.controller."
    names = [name for name, value in designs[0][1].items() if math.isfinite(value)]
    columns = {head + name: np.array([gains[name] for _, gains in designs]) for name in names}
    base = replace(slots, controller=slots.controller.replace(**designs[0][1]))
    try:
        loops = sampled_loops(axis, base, machine.servo_period, columns, machine.carried_mass(axis.name))
    except ComponentError as error:
        raise ParameterError("start", "placed", f"scenario: the loop of axis {axis.name} has no linear model: {error}") from error
    missing = [bounds.missing(rough_margins(loop), SLACK) for loop in loops]
    least = min(missing)
    if math.isinf(least):
        raise ParameterError("start", "placed", f"scenario: axis {axis.name} is unstable at every pole speed")
    # If the observer alone breaks the margins, take the nearest poles; another parameter restores the margins.
    return max(speed for (speed, _), short in zip(designs, missing, strict=True) if short <= least)


def model_of(machine: Machine, axis: Axis, slots: AxisController) -> tuple[float, float]:
    """Return gain and damping of the plant in the position loop: the observer's model if there is one, else the loaded plant's."""
    observer = slots.observer
    if observer is not None and {"model_gain", "model_damping"} <= set(observer.parameters):
        values = observer.values()
        return float(values["model_gain"]), float(values["model_damping"])
    return machine.loaded_plant(axis.name).rigid_model()


def designed(part: Component, speed: float, model: tuple[float, float], axis: str) -> dict[str, float]:
    """Return the gains of a component for poles at a speed [rad/s]."""
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
            raise ParameterError("start", "placed", f"scenario: designing {part.kind} on axis {axis} also needs {name}")
    if not set(wishes) & set(SCALED):
        raise ParameterError("start", "placed", f"scenario: {part.kind} on axis {axis} cannot be designed from poles")
    return dict(kind.designed(wishes, *model))
