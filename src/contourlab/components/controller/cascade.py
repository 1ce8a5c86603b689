"""Cascades of a position and a velocity loop, as in servo drives."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, ClassVar

import numpy as np

from contourlab.components.contract import REFERENCE, LinearModel, param, require_positive, text_param
from contourlab.components.controller.law import ANTI_WINDUP, RISES, TRACKING_TIME, ControlLaw, recovery_part
from contourlab.components.mechanics.propagator import low_pass_weight
from contourlab.engine.step import Port, ports
from contourlab.errors import ParameterError
from contourlab.primitives import clip


class Cascade(ControlLaw):
    """P-PI cascade: a proportional position loop around a PI velocity loop.

    v_c = K_v (r - p) + w r_v, u = K (1 + 1/(T_i s)) (v_c - v) + k_a r_a + u_ff - d_hat, limited to `command_limit`. Without velocity
    feedforward the axis lags by v/K_v at the speed v; with w = 1 and k_a the inverse of the model's acceleration per command, an axis
    without damping follows its reference. The integral is in command units, by backward Euler; for limits see
    `contourlab.components.controller.law`.

    A measured velocity is late: by half a tick, and by its filter. With `balance_bandwidth` (that of the filter) the velocity fed forward
    is as late, so that an axis that follows exactly has no velocity error, and does not overshoot where it stops.

    References
    ----------
    Gross, Hamann & Wiegartner, "Electrical Feed Drives in Automation", 2001 (cascade of servo drives, K_v factor); Pritschow, "A comparison
    of linear and conventional electromechanical drives", CIRP Annals 47(2), 1998.
    """

    kind = "cascade"
    over_load: ClassVar[bool] = False
    # Not its feedforward, the inverse of the model: calibrated, it would offset the friction of one part and harm others.
    calibrated: ClassVar[tuple[str, ...]] = ("velocity_gain", "integral_time", "position_gain")
    reference = "Pritschow 1998; Gross, Hamann & Wiegartner 2001"
    example = {
        "position_gain": 40.0,
        "velocity_gain": 120.0,
        "integral_time": 0.02,
        "velocity_feedforward": 0.9,
        "acceleration_feedforward": 0.5,
        "command_limit": 300.0,
        "balance_bandwidth": 600.0,
    }
    without_effect = ("tracking_time",)  # the example holds the integral
    states = ports("integral", "last_command", "last_velocity", "smooth")
    inputs: ClassVar[tuple[Port, ...]] = (*REFERENCE, *ports("position", "velocity", "disturbance_estimate", "feedforward", "accepted"))
    derived = ("integral_rate", "recovery", "balance_weight")

    position_gain: float = param(unit="1/s", minimum=0.0, doc="velocity per position error, K_v")
    velocity_gain: float = param(unit="{command}*s/m", minimum=0.0, display="{command}*s/mm", doc="gain of the velocity loop, K")
    integral_time: float = param(default=math.inf, unit="s", minimum=0.0, exclusive=True, display="ms", doc="integral time, T_i")
    velocity_feedforward: float = param(default=1.0, minimum=0.0, maximum=2.0, doc="part of the reference velocity fed forward, w")
    acceleration_feedforward: float = param(
        default=0.0, unit="{command}*s^2/m", minimum=0.0, display="{command}*s^2/mm", doc="command per reference acceleration, k_a"
    )
    balance_bandwidth: float = param(
        default=math.inf, unit="rad/s", minimum=0.0, exclusive=True, doc="corner of the low-pass on the velocity fed forward; inf: none"
    )
    command_limit: float = param(default=math.inf, unit="{command}", minimum=0.0, exclusive=True, doc="largest command (peak current)")
    anti_windup: str = text_param(default="hold", choices=ANTI_WINDUP, doc="action of the integral at a limit")
    tracking_time: float = TRACKING_TIME

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        weight = low_pass_weight(par.balance_bandwidth, dt, "backward-euler")
        return par.velocity_gain / par.integral_time, recovery_part(par.tracking_time, dt), weight

    @property
    def balanced(self) -> bool:
        """Whether the reference velocity is filtered."""
        return math.isfinite(self.balance_bandwidth)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, anti_windup: str, over_load: bool, balanced: bool) -> Any:
        position = inp.load_position if over_load else inp.position
        velocity = inp.motor_velocity if over_load else inp.velocity
        asked, smooth = inp.reference_velocity, 0.0
        if balanced:
            # A measured velocity is the mean over the last tick, then filtered.
            smooth = x.smooth + par.balance_weight * (0.5 * (asked + x.last_velocity) - x.smooth)
        wanted = par.position_gain * (inp.reference - position) + par.velocity_feedforward * (smooth if balanced else asked)
        speed_error = wanted - velocity
        rise = RISES[anti_windup](clock.dt * par.integral_rate * speed_error, x.last_command - inp.accepted, par.recovery)
        integral = x.integral + rise
        forward = par.acceleration_feedforward * inp.reference_acceleration + inp.feedforward
        command = par.velocity_gain * speed_error + integral + forward
        if over_load:
            command = command - par.damping_gain * (velocity - inp.load_velocity)
        command = command - inp.disturbance_estimate
        return (integral, command, asked, smooth), (clip(command, -par.command_limit, par.command_limit),)

    wishes = {
        "bandwidth": param(unit="rad/s", minimum=0.0, exclusive=True, doc="bandwidth of the velocity loop"),
        "damping": param(default=1.0, minimum=0.0, exclusive=True, doc="damping ratio of the velocity loop"),
        "position_gain": param(default=math.inf, unit="1/s", minimum=0.0, exclusive=True, doc="K_v; a fifth of the bandwidth by default"),
    }

    @staticmethod
    def designed(wishes: Mapping[str, float], model_gain: float, model_damping: float) -> dict[str, float]:
        kv = wishes["position_gain"]
        return Cascade.tune(wishes["bandwidth"], wishes["damping"], model_gain, model_damping, kv if math.isfinite(kv) else None)

    @staticmethod
    def tune(
        bandwidth: float, damping: float, model_gain: float, model_damping: float = 0.0, position_gain: float | None = None
    ) -> dict[str, float]:
        """Return the gains for a rigid axis v' = a u - b v: the velocity loop gets the poles of s^2 + 2 zeta w s + w^2.

        Parameters
        ----------
        bandwidth : float [rad/s], > 0
            w of the velocity loop.
        damping : float, > 0
            zeta of the velocity loop.
        model_gain : float [m/s^2 per command], > 0
            a.
        model_damping : float [1/s], >= 0
            b, below 2 zeta w.
        position_gain : float [1/s], > 0
            K_v; by default a fifth of the bandwidth, so that the loops hardly interact.

        Raises
        ------
        ParameterError
            If an argument is out of range, or the axis has more damping than the desired poles.

        Notes
        -----
        With b = 0 the whole loop is stable for every K_v while zeta >= 0.5 (Routh: 2 zeta (w + 2 zeta K_v) > K_v).

        >>> gains = Cascade.tune(200.0, 1.0, 0.8)
        >>> gains["velocity_gain"], gains["integral_time"], gains["position_gain"], gains["acceleration_feedforward"]
        (500.0, 0.01, 40.0, 1.25)
        """
        kv = bandwidth / 5.0 if position_gain is None else position_gain
        require_positive(bandwidth=bandwidth, damping=damping, model_gain=model_gain, position_gain=kv)
        most = 2.0 * damping * bandwidth
        if not 0.0 <= model_damping < most:
            raise ParameterError("model_damping", f"{model_damping:g}", f">= 0 and < 2 damping bandwidth = {most:g}", "1/s")
        gain = (most - model_damping) / model_gain
        return {
            "position_gain": kv,
            "velocity_gain": gain,
            "integral_time": model_gain * gain / bandwidth**2,
            "velocity_feedforward": 1.0,
            "acceleration_feedforward": 1.0 / model_gain,
        }

    def linearize(self) -> LinearModel:
        """Return the model away from the limits."""
        place, speed = ("load_position", "motor_velocity") if self.over_load else ("position", "velocity")
        kv, w = self.position_gain, self.velocity_feedforward
        asked_by = {"reference": kv, "reference_velocity": w, place: -kv, speed: -1.0}
        direct = {"reference_acceleration": self.acceleration_feedforward, "disturbance_estimate": -1.0, "feedforward": 1.0}
        if self.over_load:
            direct |= {"motor_velocity": -self.values()["damping_gain"], "load_velocity": self.values()["damping_gain"]}
        names = tuple(port.name for port in self.inputs[:-1])
        asked = np.array([asked_by.get(name, 0.0) for name in names])
        through = self.velocity_gain * asked + np.array([direct.get(name, 0.0) for name in names])
        rate, low_pass = self.velocity_gain / self.integral_time, self.balance_bandwidth
        if not math.isfinite(low_pass):
            return LinearModel(np.zeros((1, 1)), rate * asked[None, :], np.ones((1, 1)), through[None, :], names, ("command",))
        fed = np.array([float(name == "reference_velocity") for name in names])
        asked, through = asked - w * fed, through - self.velocity_gain * w * fed
        a = np.array([[0.0, rate * w], [0.0, -low_pass]])
        b, c = np.stack([rate * asked, low_pass * fed]), np.array([[1.0, self.velocity_gain * w]])
        return LinearModel(a, b, c, through[None, :], names, ("command",))


class LoadSideCascade(Cascade):
    """P-PI cascade over the load: v_c = K_v (r - p_l) + w r_v, u = PI(v_c - v_m) - k_d (v_m - v_l) + k_a r_a + u_ff - d_hat.

    The position loop uses the load position, so that the table reaches its reference despite backlash; the velocity loop uses the motor.
    Such a loop over a gap can hunt: keep the position loop slow. k_d acts as a damper between motor and load and damps oscillations of the
    shaft. `tune` works as for `Cascade`.

    References
    ----------
    Nordin & Gutman, "Controlling mechanical systems with backlash - a survey", Automatica 38 (2002), section 4; Zhang & Furusho, "Speed
    control of two-inertia system by PI/PID control", IEEE Trans. Industrial Electronics 47 (2000) (velocity difference as damping).
    """

    kind = "load-side-cascade"
    over_load = True
    calibrated = ("velocity_gain", "integral_time", "damping_gain", "position_gain")
    reference = "Nordin & Gutman 2002, section 4"
    example = {**Cascade.example, "damping_gain": 20.0}
    inputs = (*REFERENCE, *ports("load_position", "motor_velocity", "load_velocity", "disturbance_estimate", "feedforward", "accepted"))

    damping_gain: float = param(
        default=0.0, unit="{command}*s/m", minimum=0.0, display="{command}*s/mm", doc="gain on motor minus load velocity, k_d"
    )
