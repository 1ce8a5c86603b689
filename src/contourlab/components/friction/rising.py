"""Friction that rises with speed to its sliding level, with true sticking."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import Component, param
from contourlab.primitives import exp


class Rising(Component):
    """Friction that is least at rest, as measured on greased guides and preloaded nuts: the contrary of Stribeck's dip.

    Sliding with speed w = |v|: F = F_c - (F_c - F_s) exp(-(w/v_r)^2) + c w, against the motion. At rest any force up to F_s is held, as by
    `contourlab.components.friction.coulomb`, which takes F_c where F_s is smaller; with F_s above F_c the two are the same law.
    """

    family = "friction"
    kind = "rising"
    example = {"coulomb": 0.3, "breakaway": 0.2, "rise_velocity": 1e-2, "viscous": 2.0}
    law = "sticking"
    derived = ("inverse_rise",)
    reference = "curve of concave friction over speed; not a Stribeck effect"

    coulomb: float = param(unit="{force}", minimum=0.0, doc="sliding friction at speed, without its viscous part, F_c")
    breakaway: float = param(unit="{force}", minimum=0.0, doc="friction at rest and just above, F_s")
    rise_velocity: float = param(
        unit="m/s", minimum=0.0, exclusive=True, display="mm/s", doc="speed at which 63 % of the way from F_s to F_c are done, v_r"
    )
    viscous: float = param(default=0.0, unit="{force}*s/m", minimum=0.0, doc="rise of friction with speed, c")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (1.0 / par.rise_velocity,)

    @staticmethod
    def held(par: Any) -> float:
        """Return the largest force that is held at rest."""
        return par.breakaway  # type: ignore[no-any-return]

    @staticmethod
    def sliding(par: Any, speed: float) -> float:
        """Return the resistance at a speed; smooth through zero, for a step that overshoots the reversal."""
        ratio = speed * par.inverse_rise
        return par.coulomb - (par.coulomb - par.breakaway) * exp(-ratio * ratio) + par.viscous * speed  # type: ignore[no-any-return]
