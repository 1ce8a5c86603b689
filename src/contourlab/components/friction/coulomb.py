"""Coulomb, viscous and Stribeck friction with true sticking."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import Component, param
from contourlab.primitives import exp, maximum


class Coulomb(Component):
    """Friction that holds the axis at rest until its breakaway force is passed, and resists its motion afterwards.

    Sliding with speed w = |v|: F = F_c + (F_s - F_c) exp(-(w/v_s)^2) + c w, against the motion. At rest any force up to F_s is held:
    the velocity is exactly zero, found by locating the reversal within a step (see `contourlab.components.mechanics.core`).

    References
    ----------
    Armstrong-Helouvry, Dupont & Canudas de Wit, "A survey of models, analysis tools and compensation methods for the control of machines
    with friction", Automatica 30 (1994), section 2.
    """

    family = "friction"
    kind = "coulomb"
    example = {"coulomb": 0.2, "breakaway": 0.3, "stribeck_velocity": 1e-3, "viscous": 2.0}
    law = "sticking"
    derived = ("inverse_stribeck",)
    reference = "Armstrong-Helouvry, Dupont & Canudas de Wit 1994"

    coulomb: float = param(unit="{force}", minimum=0.0, doc="sliding friction at speed, F_c")
    breakaway: float = param(default=0.0, unit="{force}", minimum=0.0, doc="friction at rest, F_s; taken as F_c where it is smaller")
    stribeck_velocity: float = param(
        default=1e-3,
        unit="m/s",
        minimum=0.0,
        exclusive=True,
        display="mm/s",
        doc="speed at which friction has come down from F_s to F_c, v_s",
    )
    viscous: float = param(default=0.0, unit="{force}*s/m", minimum=0.0, doc="rise of friction with speed, c")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (1.0 / par.stribeck_velocity,)

    @staticmethod
    def held(par: Any) -> float:
        """Return the largest force that is held at rest."""
        return maximum(par.coulomb, par.breakaway)

    @staticmethod
    def sliding(par: Any, speed: float) -> float:
        """Return the resistance at a speed; smooth through zero, for a step that overshoots the reversal."""
        ratio = speed * par.inverse_stribeck
        drop = maximum(par.breakaway - par.coulomb, 0.0)
        return par.coulomb + drop * exp(-ratio * ratio) + par.viscous * speed  # type: ignore[no-any-return]
