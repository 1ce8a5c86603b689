"""Coupled axes for the tests of cross-coupling and learning."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.components.contract import Component
from contourlab.components.controller.pid import SpeedPID
from contourlab.components.controller.position import PositionController
from contourlab.components.drive.saturation import DelayedSaturation, Saturation
from contourlab.components.estimator.local import Tangent
from contourlab.components.plant.lagged_mass import SecondOrderIntegrator
from contourlab.components.plant.plant import RigidAxis
from contourlab.loop.machine import Axis, AxisController, Controller, Machine

PERIOD = 1e-3
IDENTIFIED = {"dc_gain": 1.0, "damping_ratio": 1.1, "natural_frequency": 150.0}
"""The stage of Gecer Ulu, Ulu & Cakmakci with its gain scaled out."""


def unlike(n_axis: int, coupling: Component | None = None) -> tuple[Machine, Controller]:
    """Axes that differ in damping, delay and gains."""
    kinds = ((2e-3, 1.0, 50.0), (5e-3, 8.0, 30.0), (1e-3, 3.0, 40.0))[:n_axis]
    axes, controllers = [], {}
    for name, (delay, damping, kv) in zip("xyz", kinds, strict=False):
        axes.append(Axis(name, RigidAxis(gain=0.9, damping=damping), drive=DelayedSaturation(delay=delay)))
        controllers[name] = AxisController(PositionController(velocity_gain=kv, position_gain=1500.0, integral_gain=9.0))
    return Machine("unlike", tuple(axes), PERIOD), Controller(controllers, Tangent() if coupling else None, coupling)


def alike(n_axis: int, kp: float, coupling: Component | None = None) -> tuple[Machine, Controller]:
    """Axes of one kind under a gain on the position error alone."""
    names = "xyz"[:n_axis]
    axes = tuple(Axis(name, RigidAxis(gain=0.9, damping=30.0)) for name in names)
    made = AxisController(PositionController(position_gain=kp, anti_windup="none"))
    return Machine("alike", axes, PERIOD), Controller(dict.fromkeys(names, made), Tangent() if coupling else None, coupling)


def stages(time_constant: float, delay: float, period: float = PERIOD, coupling: Component | None = None) -> tuple[Machine, Controller]:
    """The two stages of the paper, each under the speed PID that cancels its poles."""
    drive: Component = DelayedSaturation(delay=delay) if delay else Saturation()
    axes = tuple(Axis(name, SecondOrderIntegrator(**IDENTIFIED), drive=drive) for name in "xy")
    made = AxisController(SpeedPID(**IDENTIFIED, time_constant=time_constant))
    return Machine("stages", axes, period), Controller(dict.fromkeys("xy", made), Tangent() if coupling else None, coupling)


def circle(n_sample: int, n_axis: int = 2) -> NDArray[np.float64]:
    """Tangents (n_sample, n_axis) once round a circle; in space it leans."""
    angle = np.linspace(0.0, 2.0 * np.pi, n_sample, endpoint=False)
    found: Any = np.column_stack([np.cos(angle), np.sin(angle), 0.4 * np.sin(angle + 1.0)][:n_axis])
    return np.asarray(found / np.linalg.norm(found, axis=1, keepdims=True))
