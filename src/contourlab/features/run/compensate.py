"""Backlash compensation for an axis, worked out from what is known of it."""

from __future__ import annotations

import math

from contourlab.components.compensation.backlash_inverse import BacklashInverse
from contourlab.components.compensation.backlash_offset import BacklashOffset
from contourlab.components.plant.two_inertia import TwoInertia
from contourlab.loop import Axis, AxisController


def lost_motion_of(axis: Axis) -> float:
    """Return the lost motion of an axis [m]: its free travel, and what friction winds the shaft up by on either side; 0 without a gap."""
    if not isinstance(axis.plant, TwoInertia) or not axis.plant.widest_gap > 0.0:
        return 0.0
    friction = float(axis.friction.values().get("coulomb", 0.0))
    return axis.plant.widest_gap + 2.0 * friction / float(axis.plant.constants().stiffness_value)


def wants_offset(axis: Axis, mine: AxisController) -> bool:
    """Tell whether nothing takes up the backlash of an axis: a loop closed over the motor, and no part that reckons with a gap."""
    aware = mine.compensation is not None or any("backlash_gap" in part.parameters for part in mine.controllers.values())
    return lost_motion_of(axis) > 0.0 and mine.feedback == "motor" and not aware


def offset_of(axis: Axis, lost_motion: float) -> tuple[BacklashOffset, BacklashInverse]:
    """Return offset and inverse for a lost motion [m], as fast as the axis may be accelerated: half of the way up, half of it down."""
    most = axis.limits.acceleration
    acceleration = most if math.isfinite(most) else 1.0
    speed = math.sqrt(acceleration * lost_motion)
    offset = BacklashOffset(backlash_gap=lost_motion, backlash_velocity=speed, backlash_acceleration=acceleration)
    return offset, BacklashInverse(backlash_gap=lost_motion, jump_velocity=speed)
