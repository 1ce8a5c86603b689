"""Feedforward of the inverse of a rigid axis."""

from __future__ import annotations

from typing import Any

import numpy as np

from contourlab.components.contract import Component, LinearModel, param
from contourlab.engine.step import Port


class InverseDynamics(Component):
    """Command that a rigid axis needs to follow the reference: u = k_v r_v + k_a r_a.

    For v' = a u - b v that is k_a = 1/a, k_v = b/a; for m v' = K_f u - c v it is k_a = m/K_f, k_v = c/K_f. It is for controllers that have
    no feedforward of their own.

    References
    ----------
    Pritschow, "On the influence of the velocity gain factor on the path deviation", CIRP Annals 45(1), 1996.
    """

    family = "feedforward"
    kind = "inverse-dynamics"
    calibrated_ahead = ("velocity_gain", "acceleration_gain")
    reference = "Newton's second law, solved for the command"
    example = {"velocity_gain": 3.0, "acceleration_gain": 0.5}
    inputs = (Port("reference_velocity"), Port("reference_acceleration"))
    outputs = (Port("command"),)

    velocity_gain: float = param(default=0.0, unit="{command}*s/m", minimum=0.0, display="{command}*s/mm", doc="per reference speed, k_v")
    acceleration_gain: float = param(unit="{command}*s^2/m", minimum=0.0, display="{command}*s^2/mm", doc="per reference acceleration, k_a")

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        return (), (par.velocity_gain * inp.reference_velocity + par.acceleration_gain * inp.reference_acceleration,)

    def linearize(self) -> LinearModel:
        through = np.array([[self.velocity_gain, self.acceleration_gain]])
        names = tuple(port.name for port in self.inputs)
        return LinearModel(np.zeros((0, 0)), np.zeros((0, 2)), np.zeros((1, 0)), through, names, ("command",))
