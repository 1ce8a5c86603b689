"""State feedback with placed poles."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from contourlab.components.contract import REFERENCE, LinearModel, param, require_positive, text_param
from contourlab.components.controller.law import ANTI_WINDUP, RISES, TRACKING_TIME, ControlLaw, recovery_part
from contourlab.components.mechanics.propagator import low_pass_weight
from contourlab.engine.step import Port, ports
from contourlab.errors import ParameterError


def _coefficients(poles: Sequence[complex], order: int) -> list[float]:
    """Return c_1 ... of s^m + c_1 s^(m-1) + ..., padded to order + 1 values: the last is zero without an integral."""
    n = len(poles)
    if n not in (order, order + 1):
        raise ParameterError("poles", f"a list of {n}", f"a list of {order}, or of {order + 1} with the integral")
    found = np.poly(np.asarray(poles, dtype=complex))
    if not np.isfinite(found).all() or np.abs(found.imag).max() > 1e-9 * np.abs(found).max():
        raise ParameterError("poles", "a list", "finite, with complex poles in conjugate pairs", "rad/s")
    if max(complex(pole).real for pole in poles) >= 0.0:
        raise ParameterError("poles", "a list", "with negative real parts", "rad/s")
    return [*found.real[1:].tolist(), *([0.0] if n == order else [])]


class StateFeedback(ControlLaw):
    """Feedback of position, velocity and acceleration (for a second-order model), with an integral of the position error.

    ``following = "model"``: u = K_I int (r - p) + k_1 (r - p) + k_2 (r_v - v) + k_3 (r_a - a) + f_1 r_v + f_2 r_a + f_3 r_j + u_ff - d_hat.
    With the inverse of the model in f the axis follows the reference, and the poles shape the remaining error. ``following = "position"``
    uses only the position of the reference: u = K_I int (r - p) + k_1 (r - p) - k_2 v - k_3 a, so that the closed loop has no zeros except
    that of the integral, and lags. This is the pole-placement controller of textbooks.

    a is the difference of the velocity that the controller sees, through a first-order filter of `acceleration_bandwidth` (backward Euler).
    The jerk r_j is the difference of the reference's acceleration. Pole placement ignores the filter: keep its bandwidth well above the
    poles. `place_rigid` and `place_second_order` return all gains for a model.

    References
    ----------
    Franklin, Powell & Emami-Naeini, "Feedback Control of Dynamic Systems", sections 7.5 and 7.10 (integral); the models are eqs (1)-(2) of
    Ghaffari & Ulsoy and eq (4) of Gecer Ulu, Ulu & Cakmakci.
    """

    kind = "state-feedback"
    calibrated = ("acceleration_gain", "velocity_gain", "position_gain", "integral_gain")
    calibrated_ahead = ("velocity_feedforward", "acceleration_feedforward", "jerk_feedforward")
    reference = "Franklin, Powell & Emami-Naeini, sections 7.5 and 7.10"
    example = {
        "position_gain": 900.0,
        "velocity_gain": 40.0,
        "acceleration_gain": 0.3,
        "integral_gain": 3000.0,
        "velocity_feedforward": 2.0,
        "acceleration_feedforward": 0.8,
        "jerk_feedforward": 0.002,
        "acceleration_bandwidth": 900.0,
    }
    without_effect = ("tracking_time",)  # the example holds the integral
    states = (Port("integral"), Port("previous_velocity"), Port("acceleration"), Port("previous_reference"), Port("last_command"))
    inputs = (*REFERENCE, *ports("position", "velocity", "disturbance_estimate", "feedforward", "accepted"))
    derived = ("weight", "recovery")

    position_gain: float = param(unit="{command}/m", minimum=0.0, display="{command}/mm", doc="k_1")
    velocity_gain: float = param(default=0.0, unit="{command}*s/m", display="{command}*s/mm", doc="k_2; negative removes damping")
    acceleration_gain: float = param(default=0.0, unit="{command}*s^2/m", display="{command}*s^2/mm", doc="k_3; 0 for a rigid model")
    integral_gain: float = param(default=0.0, unit="{command}/m/s", minimum=0.0, display="{command}/mm/s", doc="K_I")
    velocity_feedforward: float = param(default=0.0, unit="{command}*s/m", minimum=0.0, display="{command}*s/mm", doc="f_1")
    acceleration_feedforward: float = param(default=0.0, unit="{command}*s^2/m", minimum=0.0, display="{command}*s^2/mm", doc="f_2")
    jerk_feedforward: float = param(default=0.0, unit="{command}*s^3/m", minimum=0.0, display="{command}*s^3/mm", doc="f_3")
    acceleration_bandwidth: float = param(default=math.inf, unit="rad/s", minimum=0.0, exclusive=True, doc="acceleration filter; inf: none")
    following: str = text_param(default="model", choices=("model", "position"), doc="the reference with derivatives, or position alone")
    anti_windup: str = text_param(default="hold", choices=ANTI_WINDUP, doc="what the integral does while the drive saturates")
    tracking_time: float = TRACKING_TIME
    unbounded = ("velocity_gain", "acceleration_gain")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return low_pass_weight(par.acceleration_bandwidth, dt, "backward-euler"), recovery_part(par.tracking_time, dt)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, anti_windup: str, following: str) -> Any:
        error = inp.reference - inp.position
        integral = x.integral + RISES[anti_windup](clock.dt * par.integral_gain * error, x.last_command - inp.accepted, par.recovery)
        acceleration = x.acceleration + par.weight * ((inp.velocity - x.previous_velocity) / clock.dt - x.acceleration)
        if following == "model":
            jerk = (inp.reference_acceleration - x.previous_reference) / clock.dt
            back = par.velocity_gain * (inp.reference_velocity - inp.velocity)
            back += par.acceleration_gain * (inp.reference_acceleration - acceleration)
            forward = par.velocity_feedforward * inp.reference_velocity + par.acceleration_feedforward * inp.reference_acceleration
            forward += par.jerk_feedforward * jerk
        else:
            back, forward = -par.velocity_gain * inp.velocity - par.acceleration_gain * acceleration, 0.0
        law = integral + par.position_gain * error + back + forward
        command = law + inp.feedforward - inp.disturbance_estimate
        return (integral, inp.velocity, acceleration, inp.reference_acceleration, command), (command,)

    wishes = {
        "natural_frequency": param(unit="rad/s", minimum=0.0, exclusive=True, doc="natural frequency of two poles"),
        "damping": param(default=0.7, minimum=0.0, exclusive=True, doc="damping ratio of these two poles"),
        "pole": param(default=math.inf, unit="rad/s", minimum=0.0, exclusive=True, doc="a third, real pole for the integral; inf: none"),
    }

    @staticmethod
    def designed(wishes: Mapping[str, float], model_gain: float, model_damping: float) -> dict[str, float]:
        w, zeta = wishes["natural_frequency"], wishes["damping"]
        root = cmath.sqrt(zeta * zeta - 1.0)
        poles = [-w * (zeta - root), -w * (zeta + root), *([-wishes["pole"]] if math.isfinite(wishes["pole"]) else [])]
        return StateFeedback.place_rigid(poles, model_gain, model_damping)

    @staticmethod
    def place_rigid(poles: Sequence[complex], model_gain: float, model_damping: float = 0.0) -> dict[str, float]:
        """Return the gains that place the poles of a rigid axis v' = a u - b v, and the feedforward of its inverse.

        Parameters
        ----------
        poles : sequence of complex (2,) or (3,) [rad/s]
            With negative real parts, complex ones in conjugate pairs; a third pole adds an integral.
        model_gain : float [m/s^2 per command], > 0
            a.
        model_damping : float [1/s], >= 0
            b.

        Raises
        ------
        ParameterError

        >>> StateFeedback.place_rigid([-30.0 + 40.0j, -30.0 - 40.0j], 2.0, 10.0)["position_gain"]
        1250.0
        """
        require_positive(model_gain=model_gain)
        c = _coefficients(poles, 2)
        return {
            "velocity_gain": (c[0] - model_damping) / model_gain,
            "position_gain": c[1] / model_gain,
            "integral_gain": c[2] / model_gain,
            "velocity_feedforward": model_damping / model_gain,
            "acceleration_feedforward": 1.0 / model_gain,
        }

    @staticmethod
    def place_second_order(poles: Sequence[complex], dc_gain: float, damping_ratio: float, natural_frequency: float) -> dict[str, float]:
        """Return the gains that place the poles of G w^2/(s (s^2 + 2 zeta w s + w^2)), and the feedforward of its inverse.

        Parameters
        ----------
        poles : sequence of complex (3,) or (4,) [rad/s]
            With negative real parts, complex ones in conjugate pairs; a fourth pole adds an integral.
        dc_gain : float [m/s per command], > 0
            G.
        damping_ratio : float, >= 0
            zeta.
        natural_frequency : float [rad/s], > 0
            w.

        Raises
        ------
        ParameterError
        """
        require_positive(dc_gain=dc_gain, natural_frequency=natural_frequency)
        w, c = natural_frequency, _coefficients(poles, 3)
        gain = dc_gain * w * w
        return {
            "acceleration_gain": (c[0] - 2.0 * damping_ratio * w) / gain,
            "velocity_gain": (c[1] - w * w) / gain,
            "position_gain": c[2] / gain,
            "integral_gain": c[3] / gain,
            "velocity_feedforward": 1.0 / dc_gain,
            "acceleration_feedforward": 2.0 * damping_ratio / (dc_gain * w),
            "jerk_feedforward": 1.0 / gain,
        }

    def linearize(self) -> LinearModel | None:
        """Return the model away from the limits; None if it differentiates without a filter: jerk feedforward, or an infinite bandwidth."""
        follows = 1.0 if self.following == "model" else 0.0
        if follows * self.jerk_feedforward or (self.acceleration_gain and self.acceleration_bandwidth == math.inf):
            return None
        k1, k2, k3, ki = self.position_gain, self.velocity_gain, self.acceleration_gain, self.integral_gain
        w = self.acceleration_bandwidth if k3 else 1.0
        b = np.array([[ki, 0.0, 0.0, -ki, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0]])
        forward = [k1, follows * (k2 + self.velocity_feedforward), follows * (k3 + self.acceleration_feedforward)]
        through = np.array([[*forward, -k1, -k2 - k3 * w, -1.0, 1.0]])
        names = tuple(port.name for port in self.inputs[:-1])
        return LinearModel(np.diag([0.0, -w]), b, np.array([[1.0, k3 * w * w]]), through, names, ("command",))
