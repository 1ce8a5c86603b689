"""Coulomb, viscous and Stribeck friction without a jump at rest."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import Component, param
from contourlab.primitives import exp, tanh


class SmoothCoulomb(Component):
    """The smooth form of Coulomb friction: F = (F_c + (F_s - F_c) exp(-(v/v_s)^2)) tanh(v/v_e) + c v.

    It never sticks: at rest a force lets the axis creep at up to v_e. Take it where a smooth model is wanted (gradients, stiff couplings);
    its error shows as creep below about v_e. Near rest it is a damper of F_s/v_e: on a mass m an integration with the step h is stable
    below F_s h/(m v_e) = 2.78 only, which a machine checks; a smaller v_e wants more sub-steps of the axis.
    """

    family = "friction"
    kind = "smooth-coulomb"
    example = {"coulomb": 0.2, "breakaway": 0.3, "stribeck_velocity": 1e-3, "smoothing_velocity": 1e-4, "viscous": 2.0}
    law = "smooth"
    derived = ("inverse_stribeck", "inverse_smoothing")
    reference = "regularised form of Coulomb and Stribeck friction"

    coulomb: float = param(unit="{force}", minimum=0.0, doc="friction at speed, F_c")
    breakaway: float = param(unit="{force}", minimum=0.0, doc="friction near rest, F_s")
    stribeck_velocity: float = param(
        default=1e-3,
        unit="m/s",
        minimum=0.0,
        exclusive=True,
        display="mm/s",
        doc="speed at which friction has come down to F_c, v_s",
    )
    smoothing_velocity: float = param(
        default=1e-5,
        unit="m/s",
        minimum=0.0,
        exclusive=True,
        display="mm/s",
        doc="speed over which friction changes its sign, v_e",
    )
    viscous: float = param(default=0.0, unit="{force}*s/m", minimum=0.0, doc="rise of friction with speed, c")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return 1.0 / par.stribeck_velocity, 1.0 / par.smoothing_velocity

    @staticmethod
    def force(par: Any, v: float) -> float:
        ratio = v * par.inverse_stribeck
        level = par.coulomb + (par.breakaway - par.coulomb) * exp(-ratio * ratio)
        return level * tanh(v * par.inverse_smoothing) + par.viscous * v  # type: ignore[no-any-return]

    @staticmethod
    def steepest(par: Any) -> float:
        """Return the largest rise of friction with speed [force s/m]: that at rest."""
        return par.breakaway * par.inverse_smoothing + par.viscous  # type: ignore[no-any-return]
