"""Friction laws of plants; `contourlab.components.mechanics.core` integrates them."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import Component, param
from contourlab.engine.step import Port
from contourlab.primitives import exp, maximum, tanh

STRIBECK_VELOCITY = param(default=1e-3, unit="m/s", minimum=0.0, exclusive=True, display="mm/s", doc="speed scale of the fall to F_c, v_s")
VISCOUS = param(default=0.0, unit="{force}*s/m", minimum=0.0, doc="rise of friction with speed, c")


class Friction(Component):
    """Base: a resistance to motion."""

    family = "friction"


def stribeck(par: Any, v: float) -> float:
    """Return the friction of steady sliding without its viscous part, F_c + (F_s - F_c) exp(-(v/v_s)^2)."""
    ratio = v * par.inverse_stribeck
    return par.coulomb + (par.breakaway - par.coulomb) * exp(-ratio * ratio)  # type: ignore[no-any-return]


class NoFriction(Friction):
    """No friction besides the plant's own damping."""

    kind = "none"
    reference = "no friction"
    law = "smooth"

    @staticmethod
    def force(par: Any, v: float) -> float:
        return 0.0


class Coulomb(Friction):
    """Coulomb, viscous and Stribeck friction with true sticking.

    Sliding with speed w = |v|: F = F_c + (F_s - F_c) exp(-(w/v_s)^2) + c w, against the motion. At rest any force up to F_s is held
    and the velocity is exactly zero: the reversal is located within the step.

    References
    ----------
    Armstrong-Helouvry, Dupont & Canudas de Wit, "A survey of models, analysis tools and compensation methods for the control of machines
    with friction", Automatica 30 (1994), section 2.
    """

    kind = "coulomb"
    example = {"coulomb": 0.2, "breakaway": 0.3, "stribeck_velocity": 1e-3, "viscous": 2.0}
    law = "sticking"
    derived = ("inverse_stribeck",)
    reference = "Armstrong-Helouvry, Dupont & Canudas de Wit 1994"

    coulomb: float = param(unit="{force}", minimum=0.0, doc="sliding friction at speed, F_c")
    breakaway: float = param(default=0.0, unit="{force}", minimum=0.0, doc="friction at rest, F_s; at least F_c")
    stribeck_velocity: float = STRIBECK_VELOCITY
    viscous: float = VISCOUS

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


class Rising(Friction):
    """Sticking friction that rises with speed to its sliding level, as on greased guides and preloaded nuts.

    Sliding with speed w = |v|: F = F_c - (F_c - F_s) exp(-(w/v_r)^2) + c w, against the motion. At rest any force up to F_s is held. With
    F_s above F_c it is the `coulomb` law.
    """

    kind = "rising"
    example = {"coulomb": 0.3, "breakaway": 0.2, "rise_velocity": 1e-2, "viscous": 2.0}
    law = "sticking"
    derived = ("inverse_rise",)
    reference = "curve of concave friction over speed; not a Stribeck effect"

    coulomb: float = param(unit="{force}", minimum=0.0, doc="sliding friction at speed, without its viscous part, F_c")
    breakaway: float = param(unit="{force}", minimum=0.0, doc="friction at rest and just above, F_s")
    rise_velocity: float = param(unit="m/s", minimum=0.0, exclusive=True, display="mm/s", doc="speed at 63 % of the rise to F_c, v_r")
    viscous: float = VISCOUS

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


class SmoothCoulomb(Friction):
    """Coulomb, viscous and Stribeck friction without a jump at rest: F = (F_c + (F_s - F_c) exp(-(v/v_s)^2)) tanh(v/v_e) + c v.

    It never sticks: under a force at rest the axis creeps at up to v_e. Use it for gradients and stiff couplings. Near rest it is a damper
    of F_s/v_e: on a mass m an integration with the step h is stable only below F_s h/(m v_e) = 2.78. A machine checks this; a smaller v_e
    needs more sub-steps.
    """

    kind = "smooth-coulomb"
    example = {"coulomb": 0.2, "breakaway": 0.3, "stribeck_velocity": 1e-3, "smoothing_velocity": 1e-4, "viscous": 2.0}
    law = "smooth"
    derived = ("inverse_stribeck", "inverse_smoothing")
    reference = "regularised form of Coulomb and Stribeck friction"

    coulomb: float = param(unit="{force}", minimum=0.0, doc="friction at speed, F_c")
    breakaway: float = param(unit="{force}", minimum=0.0, doc="friction near rest, F_s")
    stribeck_velocity: float = STRIBECK_VELOCITY
    smoothing_velocity: float = param(
        default=1e-5, unit="m/s", minimum=0.0, exclusive=True, display="mm/s", doc="speed scale on which friction changes its sign, v_e"
    )
    viscous: float = VISCOUS

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return 1.0 / par.stribeck_velocity, 1.0 / par.smoothing_velocity

    @staticmethod
    def force(par: Any, v: float) -> float:
        return stribeck(par, v) * tanh(v * par.inverse_smoothing) + par.viscous * v  # type: ignore[no-any-return]

    @staticmethod
    def steepest(par: Any) -> float:
        """Return the largest slope of friction over speed [force s/m]: the one at rest."""
        return par.breakaway * par.inverse_smoothing + par.viscous  # type: ignore[no-any-return]


class LuGre(Friction):
    """Bristle model with presliding: z' = v - s0 |v| z / g(v), F = s0 z + s1 z' + s2 v, g = F_c + (F_s - F_c) exp(-(v/v_s)^2).

    The bristle is stiff (s0 of 1e5 N/m and more). It is integrated implicitly together with the axis' velocity, so that few sub-steps are
    enough. s1 is constant, as in the paper's simulations: where it is large against 2 sqrt(s0 m), fast motions are damped more than on
    real guides. With F_s < F_c friction dips below F_c near rest.

    References
    ----------
    Canudas de Wit, Olsson, Astrom & Lischinsky, "A new model for control of systems with friction", IEEE TAC 40 (1995), eqs (1)-(4).
    """

    kind = "lugre"
    example = {"coulomb": 0.2, "breakaway": 0.3, "stiffness": 1e4, "bristle_damping": 30.0, "viscous": 2.0}
    law = "bristle"
    derived = ("inverse_stribeck",)
    reference = "Canudas de Wit et al. 1995, eqs 1-4"
    states = (Port("bristle"),)

    coulomb: float = param(unit="{force}", minimum=0.0, exclusive=True, doc="sliding friction at speed, F_c")
    breakaway: float = param(unit="{force}", minimum=0.0, exclusive=True, doc="largest friction at vanishing speed, F_s")
    stribeck_velocity: float = STRIBECK_VELOCITY
    stiffness: float = param(unit="{force}/m", minimum=0.0, exclusive=True, doc="bristle stiffness, s0")
    bristle_damping: float = param(default=0.0, unit="{force}*s/m", minimum=0.0, doc="bristle damping, s1")
    viscous: float = VISCOUS

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        return (1.0 / par.stribeck_velocity,)

    level = staticmethod(stribeck)
