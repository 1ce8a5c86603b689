"""PID control of the position, and the pole-cancelling PID that acts on the speed error."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.components.contract import REFERENCE, LinearModel, param, text_param
from contourlab.components.controller.law import ANTI_WINDUP, RISES, TRACKING_TIME, ControlLaw, recovery_part
from contourlab.components.mechanics.propagator import low_pass_weight
from contourlab.engine.step import Port, ports
from contourlab.primitives import clip


class PID(ControlLaw):
    """Parallel PID on the position error: u = K_P (b r - p) + K_I int e + K_D s N/(s + N) e_d + u_ff - d_hat, e = r - p.

    The derivative is filtered with the bandwidth N. It acts on the error (e_d = e), or on the measurement alone (e_d = -p), so that a jump
    of the reference gives no kick. A weight b below 1 reduces the reference in the proportional part: the zeros of the response to the
    reference move, the poles stay (two degrees of freedom). Positions there count from the start, so that an axis at rest has no command at
    any position. The integral is in command units; integral and derivative use backward Euler.

    At `command_limit`, or at a limit of the drive, the integral stops or is corrected, so that the limit is left without a bump; see
    `contourlab.components.controller.law`.

    References
    ----------
    Astrom & Hagglund, "Advanced PID Control", 2006, sections 3.4 (weights) and 3.5 (windup); Gecer Ulu, Ulu & Cakmakci, "Design and
    analysis of a modular learning based cross-coupled control algorithm", eq (6).
    """

    kind = "pid"
    calibrated = ("derivative_gain", "proportional_gain", "integral_gain")
    reference = "Astrom & Hagglund 2006, sections 3.4-3.5"
    example = {
        "proportional_gain": 900.0,
        "integral_gain": 2000.0,
        "derivative_gain": 12.0,
        "derivative_bandwidth": 600.0,
        "reference_weight": 0.7,
        "command_limit": 400.0,
    }
    without_effect = ("tracking_time",)  # the example holds the integral
    states = (Port("integral"), Port("previous"), Port("slope"), Port("start"), Port("last_command"))
    inputs = (Port("reference"), Port("position"), Port("disturbance_estimate"), Port("feedforward"), Port("accepted"))
    derived = ("weight", "recovery")

    proportional_gain: float = param(unit="{command}/m", minimum=0.0, display="{command}/mm", doc="K_P")
    integral_gain: float = param(default=0.0, unit="{command}/m/s", minimum=0.0, display="{command}/mm/s", doc="K_I")
    derivative_gain: float = param(default=0.0, unit="{command}*s/m", minimum=0.0, display="{command}*s/mm", doc="K_D")
    derivative_bandwidth: float = param(default=1000.0, unit="rad/s", minimum=0.0, exclusive=True, doc="of the derivative filter, N")
    derivative_on: str = text_param(default="error", choices=("error", "measurement"), doc="what is differentiated")
    reference_weight: float = param(default=1.0, minimum=0.0, maximum=2.0, doc="weight of the reference in the proportional part, b")
    command_limit: float = param(default=math.inf, unit="{command}", minimum=0.0, exclusive=True, doc="largest command")
    anti_windup: str = text_param(default="hold", choices=ANTI_WINDUP, doc="what the integral does at a limit")
    tracking_time: float = TRACKING_TIME

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return low_pass_weight(par.derivative_bandwidth, dt, "backward-euler"), recovery_part(par.tracking_time, dt)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, anti_windup: str, derivative_on: str) -> Any:
        error = inp.reference - inp.position
        integral = x.integral + RISES[anti_windup](clock.dt * par.integral_gain * error, x.last_command - inp.accepted, par.recovery)
        seen = error if derivative_on == "error" else -inp.position
        slope = x.slope + par.weight * ((seen - x.previous) / clock.dt - x.slope)
        # Positions count from the start, so that a weight other than 1 gives no command at rest.
        weighed = par.reference_weight * (inp.reference - x.start) - (inp.position - x.start)
        law = par.proportional_gain * weighed + integral + par.derivative_gain * slope
        command = law + inp.feedforward - inp.disturbance_estimate
        return (integral, seen, slope, x.start, command), (clip(command, -par.command_limit, par.command_limit),)

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        return {"start": position, "previous": 0.0 if self.derivative_on == "error" else -position}, {}

    def linearize(self) -> LinearModel:
        """Return the model for a start at position 0, away from the limits."""
        n, d = self.derivative_bandwidth, self.derivative_gain
        ahead = 1.0 if self.derivative_on == "error" else 0.0
        # K_D s N/(s + N) = K_D N - K_D N^2/(s + N)
        b = np.array([[self.integral_gain, -self.integral_gain, 0.0, 0.0], [ahead, -1.0, 0.0, 0.0]])
        through = [self.proportional_gain * self.reference_weight + ahead * d * n, -self.proportional_gain - d * n, -1.0, 1.0]
        names = ("reference", "position", "disturbance_estimate", "feedforward")
        return LinearModel(np.diag([0.0, -n]), b, np.array([[1.0, -d * n * n]]), np.array([through]), names, ("command",))


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
    reference = "Gecer Ulu, Ulu & Cakmakci 2016, eqs 6-8"
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
