"""The pole-cancelling PID that acts on the speed error."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.components.contract import REFERENCE, LinearModel, param, text_param
from contourlab.components.controller.law import ControlLaw
from contourlab.components.mechanics.discretise import low_pass_weight
from contourlab.engine.step import Port, ports


class SpeedPID(ControlLaw):
    """PID whose zeros cancel the lag of the plant G w_n^2/(s (s^2 + 2 zeta w_n s + w_n^2)), so that the loop is 1/(T_a s).

    With eq (8), K_P = 2 zeta/(G T_a w_n), K_I = 1/(G T_a), K_D = 1/(G T_a w_n^2), acting on the *speed* error, whose integral is the
    position error e: u = K_I e + K_P e' + K_D e'' + u_ff - d_hat. Then L = 1/(T_a s), the closed loop is 1/(1 + T_a s), and at the speed v
    the axis lags by v T_a. e' is the reference velocity minus the velocity that the controller sees. e'' is the reference acceleration
    minus the difference of that velocity, through a first-order filter of `acceleration_bandwidth` (backward Euler). The cancellation is
    exact without that filter, and off by the order of 1/(T_a bandwidth) with it. With a transport delay tau in the loop choose T_a of at
    least 4 tau, or use a predictor. No integral can wind up.

    ``structure = "position"`` is eq (8) read as a PID on the *position* error, u = K_P e + K_I int e + K_D e': L = 1/(T_a s^2), two poles
    on the imaginary axis. It is included to show why it is not used.

    References
    ----------
    Gecer Ulu, Ulu & Cakmakci, "Design and analysis of a modular learning based cross-coupled control algorithm for multi-axis precision
    positioning systems", eqs (4) and (6)-(8).
    """

    kind = "speed-pid"
    calibrated = ("time_constant",)
    reference = "Gecer Ulu et al., eqs 6-8"
    example = {"dc_gain": 0.8, "damping_ratio": 1.1, "natural_frequency": 150.0, "time_constant": 0.01, "acceleration_bandwidth": 900.0}
    states = (Port("integral"), Port("previous_velocity"), Port("acceleration"))
    inputs = (*REFERENCE, *ports("position", "velocity", "disturbance_estimate", "feedforward"))
    derived = ("proportional", "integral", "derivative", "weight")

    dc_gain: float = param(unit="m/s/{command}", minimum=0.0, exclusive=True, display="mm/s/{command}", doc="steady speed per command, G")
    damping_ratio: float = param(minimum=0.0, doc="zeta of the plant")
    natural_frequency: float = param(unit="rad/s", minimum=0.0, exclusive=True, doc="w_n of the plant")
    time_constant: float = param(unit="s", minimum=0.0, exclusive=True, display="ms", doc="time constant of the closed loop, T_a")
    acceleration_bandwidth: float = param(default=math.inf, unit="rad/s", minimum=0.0, exclusive=True, doc="acceleration filter; inf: none")
    structure: str = text_param(default="speed", choices=("speed", "position"), doc="error that the PID acts on")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        rate = 1.0 / (par.dc_gain * par.time_constant)
        weight = low_pass_weight(par.acceleration_bandwidth, dt, "backward-euler")
        return 2.0 * par.damping_ratio * rate / par.natural_frequency, rate, rate / par.natural_frequency**2, weight

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, structure: str) -> Any:
        error = inp.reference - inp.position
        speed_error = inp.reference_velocity - inp.velocity
        acceleration = x.acceleration + par.weight * ((inp.velocity - x.previous_velocity) / clock.dt - x.acceleration)
        integral = x.integral + clock.dt * error
        if structure == "speed":
            law = par.integral * error + par.proportional * speed_error + par.derivative * (inp.reference_acceleration - acceleration)
        else:
            law = par.integral * integral + par.proportional * error + par.derivative * speed_error
        return (integral, inp.velocity, acceleration), (law + inp.feedforward - inp.disturbance_estimate,)

    def linearize(self) -> LinearModel | None:
        """Return the linear model; None on the speed error without a filter: the bare derivative has no state-space model."""
        par, w = self.constants(), self.acceleration_bandwidth
        kp, ki, kd = par.proportional, par.integral, par.derivative
        names = tuple(port.name for port in self.inputs)
        if self.structure == "position":
            b = np.array([[1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0]])
            through = np.array([[kp, kd, 0.0, -kp, -kd, -1.0, 1.0]])
            return LinearModel(np.zeros((1, 1)), b, np.array([[ki]]), through, names, ("command",))
        if w == math.inf:
            return None
        # s w/(s + w) v = w v - w^2/(s + w) v
        b = np.array([[0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]])
        through = np.array([[ki, kp, kd, -ki, -kp - kd * w, -1.0, 1.0]])
        return LinearModel(np.array([[-w]]), b, np.array([[kd * w * w]]), through, names, ("command",))
