"""A start by pole placement: the fastest poles of each axis that keep the margins, then all axes slowed down by the best common factor."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from contourlab.errors import ParameterError
from contourlab.features.tune.objective import Goal, Objective
from contourlab.loop import Controller, Machine, parameters_of
from contourlab.study import Runner
from contourlab.study.guards import Bounds
from contourlab.study.placement import designed, fastest_speed, model_of

FRACTIONS = np.geomspace(0.1, 1.0, 32)
"""Fractions of the fastest poles, tried for all axes together."""


def placed_start(runner: Runner, goal: Goal, bounds: Bounds) -> Controller:
    """Return the controller with poles at the fraction of the fastest speed that gives the smallest objective.

    Parameters
    ----------
    runner : Runner
    goal : Goal
        Only its first figure counts.

    Raises
    ------
    ParameterError
        If a controller cannot be designed from poles, its loop has no linear model or is stable at no speed, or every run fails or exceeds
        the drive limits.
    """
    setting = runner.setting
    machine, controller = setting.machine, setting.controller
    speeds = {axis.name: fastest_speed(machine, axis, controller.axes[axis.name], bounds) for axis in machine.axes}
    candidates = [made for fraction in FRACTIONS.tolist() if (made := _placed(machine, controller, speeds, fraction)) is not None]
    if not candidates:
        raise ParameterError("start", "placed", "scenario: no common fraction of the fastest poles gives gains on every axis")
    parameters = [parameters_of(machine, candidate) for candidate in candidates]
    columns: dict[str, np.ndarray] = {}
    for name in parameters[-1]:
        if ".controller." in name:
            values = np.array([getattr(*known[name]) for known in parameters], dtype=float)
            if np.isfinite(values).all():
                columns[name] = values
    last = {name: float(values[-1]) for name, values in columns.items()}
    placed = replace(runner, setting=replace(setting, controller=candidates[-1]))
    runs = Objective(placed, Goal(goal.weights[:1]), last)(columns)
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
            gains = designed(slots.controller, fraction * speeds[axis.name], model_of(machine, axis, slots), axis.name)
            axes[axis.name] = replace(slots, controller=slots.controller.replace(**gains))
    except ParameterError:
        return None
    return replace(controller, axes=axes)
