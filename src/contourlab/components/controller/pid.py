"""PID control of the position."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.components.contract import LinearModel, param, text_param
from contourlab.components.controller.law import ANTI_WINDUP, RISES, TRACKING_TIME, ControlLaw, recovery_part
from contourlab.components.mechanics.discretise import low_pass_weight
from contourlab.engine.step import Port
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
