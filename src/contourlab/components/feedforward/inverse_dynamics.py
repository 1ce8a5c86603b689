"""Feedforward of inertia and friction."""

from __future__ import annotations

from typing import Any

import numpy as np

from contourlab.components.contract import Component, LinearModel, param
from contourlab.engine.step import Port
from contourlab.primitives import exp, tanh


class InverseDynamics(Component):
    """Command that a rigid axis needs to follow the reference: u = k_v r_v + k_a r_a + k_f tanh(r_v/v_e).

    For v' = a u - b v that is k_a = 1/a, k_v = b/a; for m v' = K_f u - c v it is k_a = m/K_f, k_v = c/K_f. k_f is the friction in command
    units. The learning law `basis-functions` finds all three on the machine. With a controller that has its own feedforward they add to it
    and may be negative.

    References
    ----------
    Pritschow, "On the influence of the velocity gain factor on the path deviation", CIRP Annals 45(1), 1996.
    """

    family = "feedforward"
    kind = "inverse-dynamics"
    calibrated_ahead = ("velocity_gain", "acceleration_gain")
    reference = "Newton's second law, solved for the command"
    example = {"velocity_gain": 3.0, "acceleration_gain": 0.5, "friction": 0.2, "smoothing_velocity": 1e-3}
    unbounded = ("velocity_gain", "acceleration_gain", "friction")
    inputs = (Port("reference_velocity"), Port("reference_acceleration"))
    outputs = (Port("command"),)
    derived = ("inverse_smoothing",)

    velocity_gain: float = param(default=0.0, unit="{command}*s/m", display="{command}*s/mm", doc="command per reference velocity, k_v")
    acceleration_gain: float = param(unit="{command}*s^2/m", display="{command}*s^2/mm", doc="per reference acceleration, k_a")
    friction: float = param(default=0.0, unit="{command}", doc="command against the friction, k_f")
    smoothing_velocity: float = param(
        default=3e-4, unit="m/s", minimum=0.0, exclusive=True, display="mm/s", doc="speed scale on which the friction changes its sign, v_e"
    )

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (1.0 / par.smoothing_velocity,)

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        v = inp.reference_velocity
        rigid = par.velocity_gain * v + par.acceleration_gain * inp.reference_acceleration
        return (), (rigid + par.friction * tanh(v * par.inverse_smoothing),)

    def linearize(self) -> LinearModel | None:
        """Return the linear model; None with friction."""
        if self.friction:
            return None
        through = np.array([[self.velocity_gain, self.acceleration_gain]])
        names = tuple(port.name for port in self.inputs)
        return LinearModel(np.zeros((0, 0)), np.zeros((0, 2)), np.zeros((1, 0)), through, names, ("command",))


class FrictionFeedforward(Component):
    """Friction compensation: u = [(F_c + (F_s - F_c) exp(-(v/v_s)^2)) tanh(v/v_e) + c v]/K_f, v the reference velocity.

    The change of sign is spread over v_e. If v_e is too small, the command jumps at a reversal before the axis has turned; if it is too
    large, the command comes late. A good compromise is the speed that the reference reaches within the lag time of the axis.
    `force_constant` converts forces to commands, so that identified friction parameters can be used unchanged.

    References
    ----------
    Armstrong-Helouvry, Dupont & Canudas de Wit, "A survey of models, analysis tools and compensation methods for the control of machines
    with friction", Automatica 30(7), 1994, section 5 (feedforward compensation).
    """

    family = "feedforward"
    kind = "friction"
    calibrated_ahead = ("viscous", "coulomb", "breakaway")
    reference = "Armstrong-Helouvry, Dupont & Canudas de Wit 1994, section 5"
    example = {
        "coulomb": 0.2,
        "breakaway": 0.3,
        "stribeck_velocity": 2e-3,
        "viscous": 2.0,
        "smoothing_velocity": 1e-3,
        "force_constant": 1.5,
    }
    inputs = (Port("reference_velocity"),)
    outputs = (Port("command"),)
    derived = ("inverse_stribeck", "inverse_smoothing", "inverse_constant")

    coulomb: float = param(unit="{force}", minimum=0.0, doc="friction at speed, F_c")
    breakaway: float = param(unit="{force}", minimum=0.0, doc="friction near rest, F_s; F_c: no Stribeck effect")
    stribeck_velocity: float = param(default=1e-3, unit="m/s", minimum=0.0, exclusive=True, display="mm/s", doc="of the fall to F_c, v_s")
    viscous: float = param(default=0.0, unit="{force}*s/m", minimum=0.0, doc="rise of friction with speed, c")
    smoothing_velocity: float = param(
        default=1e-4, unit="m/s", minimum=0.0, exclusive=True, display="mm/s", doc="speed scale on which the command changes its sign, v_e"
    )
    force_constant: float = param(default=1.0, unit="{force}/{command}", minimum=0.0, exclusive=True, doc="force per command, K_f")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return 1.0 / par.stribeck_velocity, 1.0 / par.smoothing_velocity, 1.0 / par.force_constant

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        v = inp.reference_velocity
        ratio = v * par.inverse_stribeck
        level = par.coulomb + (par.breakaway - par.coulomb) * exp(-ratio * ratio)
        return (), (par.inverse_constant * (level * tanh(v * par.inverse_smoothing) + par.viscous * v),)
