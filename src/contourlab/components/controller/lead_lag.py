"""The lead-lag controller with an integral."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from contourlab.components.contract import LinearModel, param, text_param
from contourlab.components.controller.law import ANTI_WINDUP, RISES, TRACKING_TIME, ControlLaw, recovery_part
from contourlab.engine.step import Port
from contourlab.errors import ParameterError


class LeadLag(ControlLaw):
    """Lead-lag-integral control of the position error: u = K (a s + 1)/(b s + 1) (s + k_i)/s e + u_ff - d_hat, discretised by Tustin.

    A lead for a > b, a lag for a < b. The factors are separate, so that the integral can stop at a limit of the drive
    (`contourlab.components.controller.law`) while the lead continues.

    References
    ----------
    Franklin, Powell & Emami-Naeini, "Feedback Control of Dynamic Systems", section 6.7 (lead design in the frequency domain); the course
    MECH 467 of the University of British Columbia uses it with a phase margin of 60 degrees and k_i of a tenth of the crossover.
    """

    kind = "lead-lag"
    calibrated = ("gain", "lead_time", "lag_time", "integral_rate")
    reference = "Franklin, Powell & Emami-Naeini, section 6.7"
    example = {"gain": 800.0, "lead_time": 0.02, "lag_time": 0.002, "integral_rate": 12.0}
    without_effect = ("tracking_time",)  # the example holds the integral
    states = (Port("previous_error"), Port("lead"), Port("integral"), Port("last_command"))
    inputs = (Port("reference"), Port("position"), Port("disturbance_estimate"), Port("feedforward"), Port("accepted"))
    derived = ("keep", "now", "before", "half_rate", "recovery")

    gain: float = param(unit="{command}/m", minimum=0.0, display="{command}/mm", doc="gain, K")
    lead_time: float = param(unit="s", minimum=0.0, display="ms", doc="time constant of the numerator, a")
    lag_time: float = param(unit="s", minimum=0.0, exclusive=True, display="ms", doc="time constant of the denominator, b")
    integral_rate: float = param(default=0.0, unit="rad/s", minimum=0.0, doc="corner below which the integral acts, k_i")
    anti_windup: str = text_param(default="hold", choices=ANTI_WINDUP, doc="action of the integral while the drive saturates")
    tracking_time: float = TRACKING_TIME

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        below = 2.0 * par.lag_time + dt
        now, before = par.gain * (2.0 * par.lead_time + dt) / below, par.gain * (dt - 2.0 * par.lead_time) / below
        return (2.0 * par.lag_time - dt) / below, now, before, 0.5 * dt * par.integral_rate, recovery_part(par.tracking_time, dt)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, anti_windup: str) -> Any:
        error = inp.reference - inp.position
        lead = par.keep * x.lead + par.now * error + par.before * x.previous_error
        integral = x.integral + RISES[anti_windup](par.half_rate * (lead + x.lead), x.last_command - inp.accepted, par.recovery)
        command = lead + integral + inp.feedforward - inp.disturbance_estimate
        return (error, lead, integral, command), (command,)

    wishes = {
        "phase_margin": param(unit="rad", minimum=0.0, exclusive=True, maximum=math.pi / 2.0, display="deg", doc="of the whole loop"),
        "crossover": param(unit="rad/s", minimum=0.0, exclusive=True, doc="frequency where the loop gain is 1"),
        "integral_rate": param(default=math.inf, unit="rad/s", minimum=0.0, doc="k_i; a tenth of the crossover by default"),
        "delay": param(default=0.0, unit="s", minimum=0.0, display="ms", doc="total delay of the loop, half a servo period included"),
    }

    @staticmethod
    def designed(wishes: Mapping[str, float], model_gain: float, model_damping: float) -> dict[str, float]:
        ki = wishes["integral_rate"] if math.isfinite(wishes["integral_rate"]) else None
        margin, crossover = wishes["phase_margin"], wishes["crossover"]
        return LeadLag.design(margin, crossover, model_gain, model_damping, integral_rate=ki, delay=wishes["delay"])

    @staticmethod
    def design(
        phase_margin: float,
        crossover: float,
        model_gain: float,
        model_damping: float = 0.0,
        *,
        integral_rate: float | None = None,
        delay: float = 0.0,
        integral_counted: bool = True,
    ) -> dict[str, float]:
        """Return the parameters that give a rigid axis a/(s (s + b)) a phase margin at the crossover, where the lead has its maximum.

        Parameters
        ----------
        phase_margin : float [rad]
        crossover : float [rad/s], > 0
        model_gain : float [m/s^2 per command], > 0
            a.
        model_damping : float [1/s], >= 0
            b.
        integral_rate : float [rad/s], >= 0
            k_i; by default a tenth of the crossover.
        delay : float [s], >= 0
            Total delay of the loop, including half a servo period for the hold.
        integral_counted : bool
            Whether the lead compensates the lag of the integral, so that the margin is that of the whole loop. If not, as in the course,
            the loop has atan(k_i/w_c) less: 5.7 degrees with a tenth.

        Raises
        ------
        ParameterError
            If an argument is out of range, or the lead would need a phase below 0 or of 90 degrees or more.

        >>> made = LeadLag.design(math.radians(60.0), 100.0, 2.0)
        >>> round(made["lead_time"] * made["lag_time"] * 100.0**2, 9)
        1.0
        """
        ki = crossover / 10.0 if integral_rate is None else integral_rate
        for name, value, low in (
            ("crossover", crossover, False),
            ("model_gain", model_gain, False),
            ("model_damping", model_damping, True),
            ("integral_rate", ki, True),
            ("delay", delay, True),
        ):
            if not ((value >= 0.0 if low else value > 0.0) and math.isfinite(value)):
                raise ParameterError(name, f"{value:g}", f"{'>=' if low else '>'} 0 and finite")
        s = 1j * crossover
        integral = (s + ki) / s
        lag = math.pi / 2.0 + math.atan2(crossover, model_damping) + crossover * delay
        turn = phase_margin - math.pi + lag - (cmath.phase(integral) if integral_counted else 0.0)
        if not 0.0 <= turn < math.pi / 2.0:
            turned, asked = math.degrees(turn), math.degrees(phase_margin)
            raise ParameterError("phase_margin", f"{asked:g}", f"within reach of a lead of 0 to 90; this one needs {turned:.1f}", "degrees")
        root = math.sqrt((1.0 + math.sin(turn)) / (1.0 - math.sin(turn)))
        lead, below = root / crossover, 1.0 / (root * crossover)
        magnitude = abs(model_gain / (s * (s + model_damping)) * (lead * s + 1.0) / (below * s + 1.0))
        gain = 1.0 / (magnitude * (abs(integral) if integral_counted else 1.0))
        return {"gain": gain, "lead_time": lead, "lag_time": below, "integral_rate": ki}

    def linearize(self) -> LinearModel:
        """Return the model away from the limits."""
        k, a, b, ki = self.gain, self.lead_time, self.lag_time, self.integral_rate
        # (a s + 1)/(b s + 1) = a/b + (1 - a/b)/(b s + 1); states: the low-pass of the error, the integral.
        matrix = np.array([[-1.0 / b, 0.0], [ki * k * (1.0 - a / b), 0.0]])
        inputs = np.array([[1.0 / b, -1.0 / b, 0.0, 0.0], [ki * k * a / b, -ki * k * a / b, 0.0, 0.0]])
        through = np.array([[k * a / b, -k * a / b, -1.0, 1.0]])
        names = ("reference", "position", "disturbance_estimate", "feedforward")
        return LinearModel(matrix, inputs, np.array([[k * (1.0 - a / b), 1.0]]), through, names, ("command",))
