"""LuGre friction: bristles that bend before they slip."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import Component, param
from contourlab.engine.step import Port
from contourlab.primitives import exp


class LuGre(Component):
    """Bristle model with presliding: z' = v - s0 |v| z / g(v), F = s0 z + s1 z' + s2 v, g = F_c + (F_s - F_c) exp(-(v/v_s)^2).

    The bristle is stiff (s0 of 1e5 N/m and more); it is integrated implicitly together with the axis' velocity, so that a servo period
    needs no thousand sub-steps. s1 is a constant here, as in the paper's simulations; where it is large beside 2 sqrt(s0 m), fast motions
    meet more damping than real guides give. With F_s < F_c friction dips below F_c near rest.

    References
    ----------
    Canudas de Wit, Olsson, Astrom & Lischinsky, "A new model for control of systems with friction", IEEE TAC 40 (1995), eqs (1)-(4).
    """

    family = "friction"
    kind = "lugre"
    example = {"coulomb": 0.2, "breakaway": 0.3, "stiffness": 1e4, "bristle_damping": 30.0, "viscous": 2.0}
    law = "bristle"
    derived = ("inverse_stribeck",)
    reference = "Canudas de Wit et al. 1995, eqs 1-4"
    states = (Port("bristle"),)

    coulomb: float = param(unit="{force}", minimum=0.0, exclusive=True, doc="sliding friction at speed, F_c")
    breakaway: float = param(unit="{force}", minimum=0.0, exclusive=True, doc="largest friction at vanishing speed, F_s")
    stribeck_velocity: float = param(
        default=1e-3,
        unit="m/s",
        minimum=0.0,
        exclusive=True,
        display="mm/s",
        doc="speed at which friction has come down to F_c, v_s",
    )
    stiffness: float = param(unit="{force}/m", minimum=0.0, exclusive=True, doc="of the bristles, s0")
    bristle_damping: float = param(default=0.0, unit="{force}*s/m", minimum=0.0, doc="of the bristles, s1")
    viscous: float = param(default=0.0, unit="{force}*s/m", minimum=0.0, doc="rise of friction with speed, s2")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (1.0 / par.stribeck_velocity,)

    @staticmethod
    def level(par: Any, v: float) -> float:
        """Return the friction of steady sliding without its viscous part, g(v)."""
        ratio = v * par.inverse_stribeck
        return par.coulomb + (par.breakaway - par.coulomb) * exp(-ratio * ratio)  # type: ignore[no-any-return]
