"""The gap observer for an axis of a machine file."""

from __future__ import annotations

import math

import numpy as np

from contourlab.components.contract import Component
from contourlab.components.gap_observer.multiple_model import MultipleModel
from contourlab.loop import Axis

STRIBECK = 0.2
"""Share of breakaway minus Coulomb friction that acts as unmodelled force."""
UNCERTAINTY = 0.1
"""Relative uncertainty of torque, inertia and friction that the observer assumes: no machine file is more accurate."""


def observer_of(axis: Axis, servo_period: float, carried_mass: float = 0.0) -> MultipleModel:
    """Return the gap observer of an axis with a two-inertia plant; the drive's values come from the machine file.

    The observer's model has no breakaway friction above Coulomb friction and no disturbance: both count as unmodelled force.
    """
    plant = axis.plant.loaded(carried_mass)
    known = {name: value for name, value in plant.values().items() if name in MultipleModel.parameters}
    known["mass"] = plant.mass + plant.carried_mass
    friction = {"coulomb": axis.friction, "motor_coulomb": axis.motor_friction}
    known |= {name: part.values()["coulomb"] for name, part in friction.items() if "coulomb" in part.parameters}
    if "resolution" in axis.motor_sensor.parameters:
        known["resolution"] = axis.motor_sensor.values()["resolution"]
    known |= {"unmodelled_force": _unmodelled(axis), "uncertainty": UNCERTAINTY}
    known["largest_gap"] = max(MultipleModel.parameters["largest_gap"].default, 5.0 * plant.widest_gap)
    # Hypotheses at most 15 % apart. Only two possible numbers, because each is compiled separately.
    known["hypotheses"] = 32.0 if known["largest_gap"] < 4e-4 else 64.0
    known["load_damping"] += float(axis.friction.values().get("viscous", 0.0)) * (plant.lead / (2.0 * math.pi)) ** 2
    values = plant.constants()
    fast = math.sqrt(values.stiffness_value * (values.motor_mobility + values.load_mobility)) * servo_period
    return MultipleModel(**known, substeps=float(min(max(math.ceil(fast / 0.25), 1), 32)))


def _unmodelled(axis: Axis) -> float:
    friction = axis.friction.values()
    coulomb = float(friction.get("coulomb", 0.0))
    beyond = STRIBECK * max(float(friction.get("breakaway", 0.0)) - coulomb, 0.0)
    return max(1.0, beyond, 0.0 if axis.disturbance is None else _largest_force(axis.disturbance))


def _largest_force(disturbance: Component) -> float:
    """Return the largest force [N] among the parameters of a disturbance."""
    kinds, values = disturbance.parameters, disturbance.values()
    forces = [values[name] for name, kind in kinds.items() if kind.unit == "{force}" and name in values]
    return max((float(np.abs(np.ravel(force)).max(initial=0.0)) for force in forces), default=0.0)
