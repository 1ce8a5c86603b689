"""The position controller with velocity feedback and model feedforward."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from contourlab.components.contract import REFERENCE, LinearModel, param, require_positive, text_param
from contourlab.components.controller.law import ControlLaw
from contourlab.engine.step import Port, ports
from contourlab.errors import ParameterError


class PositionController(ControlLaw):
    """PI position control with velocity feedback and feedforward of the axis' model.

    ``structure = "feedforward"`` (eq 15): u = K_V (r_v - v) + K_P (r' - p) + K_P K_I int (r' - p) + (r_a + b' r_v)/a' + u_ff - d_hat.
    Position and integral act on the modified reference r'; velocity and acceleration come from the reference itself, since differences of
    r' would feed the measured position back. With the ideal axis a'/(s (s + b')) the position follows the reference exactly.

    ``structure = "ipv"``: u = K_P K_I int (r' - p) - K_P p - K_V v + u_ff - d_hat with p counted from the start, which has the closed loop
    of eq (16) and no feedforward of the reference. In either structure u_ff is the input ``feedforward``.

    ``anti_windup = "hold"`` stops the integral while the drive saturates and the error would drive it further.

    References
    ----------
    Ghaffari & Ulsoy, "Component swapping modularity for distributed precision contouring", eqs (15), (16), (20)-(23). Eq (15) gives P/R'
    = 1 with the ideal axis; eq (16) belongs to the structure without feedforward. Eq (20) lacks an s in the term 2 zeta w_n s.
    """

    kind = "position"
    calibrated = ("velocity_gain", "position_gain", "integral_gain")
    calibrated_ahead = ("model_damping", "model_gain")
    example = {"velocity_gain": 100.0, "position_gain": 4000.0, "integral_gain": 11.8, "model_gain": 0.9, "model_damping": 30.0}
    reference = "Ghaffari & Ulsoy 2017, eqs 15-16 and 20-23"
    states = (Port("integral"), Port("start"), Port("last_command"))
    inputs = (*REFERENCE, *ports("position", "velocity", "disturbance_estimate", "feedforward", "accepted"))
    derived = ("integral_rate", "acceleration_feedforward", "velocity_feedforward")

    velocity_gain: float = param(default=0.0, unit="{command}*s/m", minimum=0.0, display="{command}*s/mm", doc="K_V")
    position_gain: float = param(default=0.0, unit="{command}/m", minimum=0.0, display="{command}/mm", doc="K_P")
    integral_gain: float = param(default=0.0, unit="1/s", minimum=0.0, doc="K_I; the integral acts with K_P K_I")
    model_gain: float = param(
        default=math.inf,
        unit="m/s^2/{command}",
        minimum=0.0,
        exclusive=True,
        display="mm/s^2/{command}",
        doc="gain of the feedforward model, a'; inf: none",
    )
    model_damping: float = param(default=0.0, unit="1/s", minimum=0.0, doc="decay rate of the velocity of the feedforward model, b'")
    structure: str = text_param(default="feedforward", choices=("feedforward", "ipv"), doc="structure of eq (15) or of eq (16)")
    anti_windup: str = text_param(default="hold", choices=("hold", "none"), doc="action of the integral while the drive saturates")

    def check_values(self) -> None:
        # Without its integral this structure ignores the reference.
        if self.structure == "ipv" and np.any((self.integral_gain == 0.0) & (self.position_gain > 0.0)):
            raise ParameterError("integral_gain", "0", '> 0 with structure = "ipv", which acts only through its integral', "1/s")

    wishes = {
        "natural_frequency": param(unit="rad/s", minimum=0.0, exclusive=True, doc="natural frequency of two poles"),
        "damping": param(minimum=0.0, exclusive=True, doc="damping ratio of these two poles"),
        "pole": param(unit="rad/s", minimum=0.0, exclusive=True, doc="a third, real pole"),
    }

    @staticmethod
    def designed(wishes: Mapping[str, float], model_gain: float, model_damping: float) -> dict[str, float]:
        return PositionController.place(**wishes, model_gain=model_gain, model_damping=model_damping)

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return par.position_gain * par.integral_gain, 1.0 / par.model_gain, par.model_damping / par.model_gain

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *, anti_windup: str, structure: str) -> Any:
        error = inp.reference - inp.position
        rise = clock.dt * error
        if anti_windup == "hold":
            rise = 0.0 if (x.last_command - inp.accepted) * error > 0.0 else rise
        integral = x.integral + rise
        if structure == "ipv":
            proportional = par.position_gain * (x.start - inp.position) - par.velocity_gain * inp.velocity
            command = proportional + par.integral_rate * integral + inp.feedforward - inp.disturbance_estimate
        else:
            forward = par.acceleration_feedforward * inp.reference_acceleration + par.velocity_feedforward * inp.reference_velocity
            loop = par.velocity_gain * (inp.reference_velocity - inp.velocity) + par.position_gain * error
            command = loop + par.integral_rate * integral + forward + inp.feedforward - inp.disturbance_estimate
        return (integral, x.start, command), (command,)

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        return {"start": position}, {}

    @staticmethod
    def place(natural_frequency: float, damping: float, pole: float, model_gain: float, model_damping: float) -> dict[str, float]:
        """Return the gains that place the poles of eq (20): w_n, zeta and a real pole.

        Parameters
        ----------
        natural_frequency : float [rad/s], > 0
        damping : float, > 0
        pole : float [rad/s], > 0
        model_gain, model_damping : float
            a' and b' of the axis.

        Raises
        ------
        ParameterError
            If an argument is not positive, or the velocity gain would be negative: the axis has more damping than the desired poles.

        >>> gains = PositionController.place(25.0, 0.7, 35.0, 0.873, 19.7)
        >>> round(gains["velocity_gain"] / 1000, 4), round(gains["position_gain"] / 1000, 3), round(gains["integral_gain"], 2)
        (0.0576, 2.119, 11.82)
        """
        require_positive(natural_frequency=natural_frequency, damping=damping, pole=pole, model_gain=model_gain)
        velocity_gain = (pole + 2.0 * damping * natural_frequency - model_damping) / model_gain
        if velocity_gain < 0.0:
            wanted = pole + 2.0 * damping * natural_frequency
            raise ParameterError("model_damping", f"{model_damping:g}", f"<= pole + 2 damping natural_frequency = {wanted:g}", "1/s")
        return {
            "velocity_gain": velocity_gain,
            "position_gain": (2.0 * pole * damping * natural_frequency + natural_frequency**2) / model_gain,
            "integral_gain": pole * natural_frequency / (2.0 * pole * damping + natural_frequency),
            "model_gain": model_gain,
            "model_damping": model_damping,
        }

    def linearize(self) -> LinearModel:
        p, v = self.position_gain, self.velocity_gain
        rate = p * self.integral_gain
        ahead = 0.0 if self.structure == "ipv" else 1.0
        gains = [ahead * p, ahead * (v + self.model_damping / self.model_gain), ahead / self.model_gain, -p, -v, -1.0, 1.0]
        names = tuple(port.name for port in self.inputs[:-1])
        b = np.array([[1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0]])
        return LinearModel(np.zeros((1, 1)), b, np.array([[rate]]), np.array([gains]), names, ("command",))
