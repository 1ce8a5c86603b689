"""Machines small enough to reason about, with every kind of slot filled."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from component_rig import make

import contourlab as cl

PERIOD = 1e-3


def stage(**changes: Any) -> cl.Machine:
    """Return a two-axis machine with sticking friction, encoders and delayed commands."""

    def axis(name: str, gain: float, coulomb: float) -> cl.Axis:
        parts: dict[str, Any] = {
            "plant": make("plant", "rigid-axis", gain=gain, damping=6.0),
            "friction": make("friction", "coulomb", coulomb=coulomb, breakaway=1.2 * coulomb, stribeck_velocity=2e-3),
            "drive": make("drive", "delayed-saturation", limit=10.0, delay=1.5e-3),
            "sensor": make("sensor", "encoder", resolution=125e-9, noise=5e-8),
        }
        return cl.Axis(name, **{**parts, **changes})

    return cl.Machine("stage", (axis("x", 1.1, 0.055), axis("y", 0.65, 0.088)), PERIOD)


def control(coupled: bool = True, **gains: float) -> cl.Controller:
    """Return position loops with observers, and modified reference."""

    def axis(model_gain: float) -> cl.AxisController:
        chosen = {"velocity_gain": 70.0, "position_gain": 2800.0, "integral_gain": 12.0, **gains}
        return cl.AxisController(
            make("controller", "position", model_gain=model_gain, model_damping=25.0, **chosen),
            make("velocity", "filtered-difference", bandwidth=800.0),
            make("observer", "disturbance-observer", bandwidth=200.0, filter_bandwidth=2000.0, model_gain=model_gain, model_damping=25.0),
        )

    axes = {"x": axis(1.0), "y": axis(0.6)}
    if not coupled:
        return cl.Controller(axes)
    return cl.Controller(axes, make("estimator", "newton", iterations=2), make("coupling", "modified-reference", weight=0.5))


def with_axis(machine: cl.Machine, name: str, **changes: Any) -> cl.Machine:
    """Return the machine with some parts of one axis exchanged."""
    return replace(machine, axes=tuple(replace(a, **changes) if a.name == name else a for a in machine.axes))
