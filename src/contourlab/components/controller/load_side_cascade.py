"""The cascade closed over the load's position, with damping by the difference of both sides' velocities."""

from __future__ import annotations

from typing import Any

import numpy as np

from contourlab.components.contract import REFERENCE, LinearModel, param
from contourlab.components.controller.cascade import Cascade, cascade_step
from contourlab.engine.step import ports


class LoadSideCascade(Cascade):
    """P-PI cascade over the load: v_c = K_v (r - p_l) + w r_v, u = PI(v_c - v_m) - k_d (v_m - v_l) + k_a r_a + u_ff - d_hat.

    The position loop is closed over the load, so that the table stands where it is asked for, backlash or not; the velocity loop over the
    motor. Closed over a gap such a loop hunts: the position loop has to be slow enough, and k_d, which acts as a damper between motor and
    load, takes the swing out of the shaft. Gains are worked out as those of `Cascade`.

    References
    ----------
    Nordin & Gutman, "Controlling mechanical systems with backlash - a survey", Automatica 38 (2002), section 4; Zhang & Furusho, "Speed
    control of two-inertia system by PI/PID control", IEEE Trans. Industrial Electronics 47 (2000) (velocity difference as damping).
    """

    kind = "load-side-cascade"
    calibrated = ("velocity_gain", "integral_time", "damping_gain", "position_gain")
    calibrated_ahead = ("velocity_feedforward", "acceleration_feedforward")
    reference = "Nordin & Gutman 2002, section 4"
    example = {**Cascade.example, "damping_gain": 20.0}
    inputs = (*REFERENCE, *ports("load_position", "motor_velocity", "load_velocity", "disturbance_estimate", "feedforward", "accepted"))

    damping_gain: float = param(
        default=0.0, unit="{command}*s/m", minimum=0.0, display="{command}*s/mm", doc="on the velocity of the motor against the load, k_d"
    )

    def step_function(self) -> Any:
        return cascade_step(self.anti_windup, over_load=True)

    def linearize(self) -> LinearModel:
        """Return the model away from the limits."""
        kv, k, w, kd = self.position_gain, self.velocity_gain, self.velocity_feedforward, self.damping_gain
        asked = np.array([kv, w, 0.0, -kv, -1.0, 0.0, 0.0, 0.0])
        through = k * asked + np.array([0.0, 0.0, self.acceleration_feedforward, 0.0, -kd, kd, -1.0, 1.0])
        names = tuple(port.name for port in self.inputs[:-1])
        rate = k / self.integral_time
        return LinearModel(np.zeros((1, 1)), rate * asked[None, :], np.ones((1, 1)), through[None, :], names, ("command",))
