"""An axis and its controllers for the tests of the sampled loop."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import Component
from contourlab.components.controller.position import PositionController
from contourlab.components.drive.saturation import Saturation
from contourlab.components.ideal import TrueVelocity
from contourlab.components.observer.disturbance_observer import DisturbanceObserver
from contourlab.components.plant.plant import RigidAxis
from contourlab.loop.machine import Axis, AxisController

T, A, B = 1e-3, 0.9, 1.0
KV, KP, KI = 50.0, 1500.0, 9.0
W_V, W_D, W_Z, A_HAT, B_HAT = 700.0, 120.0, 1500.0, 0.7, 15.0


def observer(**changed: Any) -> DisturbanceObserver:
    values = {"bandwidth": W_D, "filter_bandwidth": W_Z, "model_gain": A_HAT, "model_damping": B_HAT, **changed}
    return DisturbanceObserver(**values)


def controller(
    kv: float = KV, kp: float = KP, ki: float = KI, velocity: Component | None = None, seen: Component | None = None, **more: Any
) -> AxisController:
    made = PositionController(velocity_gain=kv, position_gain=kp, integral_gain=ki, model_gain=A_HAT, model_damping=B_HAT, **more)
    return AxisController(made, velocity or TrueVelocity(), seen)


def axis(drive: Component | None = None, damping: float = B) -> Axis:
    return Axis("x", RigidAxis(gain=A, damping=damping), drive=drive or Saturation())
