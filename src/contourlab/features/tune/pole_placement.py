"""A start by pole placement: the fastest poles of each axis that keep the margins, then all axes slowed down by the best common factor."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from contourlab.analysis.linear.loop_lanes import rough_margins, sampled_loops
from contourlab.components.contract import Component
from contourlab.design import Evaluator
from contourlab.design.guards import SLACK, Bounds
from contourlab.errors import ComponentError, ParameterError
from contourlab.features.tune.objective import Goal, Objective
from contourlab.loop import Axis, AxisController, Controller, Machine, parameter_names

SPEEDS = 96
"""Number of pole speeds tried, from a ten-thousandth of the Nyquist frequency to half of it."""
FRACTIONS = np.geomspace(0.1, 1.0, 32)
"""Fractions of the fastest poles, tried for all axes together."""
SCALED = {"natural_frequency": 1.0, "bandwidth": 1.0, "crossover": 1.0, "pole": 1.4}
"""Design requests that scale with the speed; ratio of the real pole as in Ghaffari & Ulsoy, 35 to 25 rad/s."""
FIXED = {"damping": 0.7, "phase_margin": math.radians(60.0)}


def placed_start(evaluator: Evaluator, goal: Goal, bounds: Bounds) -> Controller:
    """Return the controller with poles at the fraction of the fastest speed that gives the smallest objective.

    Parameters
    ----------
    evaluator : Evaluator
        Evaluator of the machine, its controller and the motion.
    goal : Goal
        Only its first figure counts.
    bounds : Bounds

    Raises
    ------
    ParameterError
        If a controller cannot be designed from poles, its loop has no linear model or is stable at no speed, or every run fails or exceeds
        the drive limits.
    """
    machine, controller = evaluator.machine, evaluator.controller
    speeds = {axis.name: _fastest(machine, axis, controller.axes[axis.name], bounds) for axis in machine.axes}
    candidates = [placed for fraction in FRACTIONS.tolist() if (placed := _placed(machine, controller, speeds, fraction)) is not None]
    if not candidates:
        raise ParameterError("start", "placed", "scenario: no common fraction of the fastest poles gives gains on every axis")
    parameters = [parameter_names(machine, candidate) for candidate in candidates]
    columns: dict[str, np.ndarray] = {}
    for name in parameters[-1]:
        if ".controller." in name:
            values = np.array([getattr(*known[name]) for known in parameters], dtype=float)
            if np.isfinite(values).all():
                columns[name] = values
    last = {name: float(values[-1]) for name, values in columns.items()}
    runs = Objective(replace(evaluator, controller=candidates[-1]), Goal(goal.weights[:1]), last)(columns)
    good = (runs.limited <= bounds.limited) & (runs.largest <= bounds.command)
    ranked = np.where(good, runs.value, np.inf)
    if not np.isfinite(ranked).any():
        raise ParameterError("start", "placed", "scenario: with placed poles every run fails or exceeds the drive limits")
    return candidates[int(np.argmin(ranked))]


def _placed(machine: Machine, controller: Controller, speeds: Mapping[str, float], fraction: float) -> Controller | None:
    """Return the controller with poles at a fraction of the speeds; None if a plant's own damping is too large for such slow poles."""
    axes = dict(controller.axes)
    try:
        for axis in machine.axes:
            slots = axes[axis.name]
            gains = _designed(slots.controller, fraction * speeds[axis.name], model_of(machine, axis, slots), axis.name)
            axes[axis.name] = replace(slots, controller=slots.controller.replace(**gains))
    except ParameterError:
        return None
    return replace(controller, axes=axes)


def _fastest(machine: Machine, axis: Axis, slots: AxisController, bounds: Bounds) -> float:
    """Return the largest speed [rad/s] of placed poles that keeps the margins, or comes nearest to keeping them."""
    model = model_of(machine, axis, slots)
    speeds = np.geomspace(1e-4, 0.5, SPEEDS) * math.pi / machine.servo_period
    designs: list[tuple[float, dict[str, float]]] = []
    for speed in speeds.tolist():
        try:
            designs.append((speed, _designed(slots.controller, speed, model, axis.name)))
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


def _designed(part: Component, speed: float, model: tuple[float, float], axis: str) -> dict[str, float]:
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
