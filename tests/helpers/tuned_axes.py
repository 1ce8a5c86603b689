"""Axes whose best gains are known."""

from __future__ import annotations

from contourlab.components.controller.position import PositionController
from contourlab.components.plant.plant import RigidAxis
from contourlab.feed import Reference, uniform
from contourlab.geometry import contour
from contourlab.loop import Axis, AxisController, Controller, Machine

GAIN, DAMPING = 1.2, 9.0
PERIOD = 1e-3


def rigid_stage(first: float = GAIN, second: float = GAIN) -> Machine:
    """Return two axes without friction, v' = a u - 9 v, whose encoders see everything."""
    return Machine("rigid", tuple(Axis(name, RigidAxis(gain=a, damping=DAMPING)) for name, a in (("x", first), ("y", second))), PERIOD)


def position_control(**changes: float) -> Controller:
    """Return the same position controller on both axes."""
    gains = {"velocity_gain": 40.0, "position_gain": 1500.0, "integral_gain": 5.0, "model_gain": GAIN, "model_damping": DAMPING}
    return Controller({name: AxisController(PositionController(**(gains | changes))) for name in ("x", "y")})


def circle(laps: int = 2) -> Reference:
    """Return a circle of 10 mm at 1 Hz."""
    return uniform(contour("circle", radius=0.01), 1.0, laps, PERIOD)
