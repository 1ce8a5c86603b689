"""Ordinary axes with one structural resonance: motor side and load side, joined by a spring and a damper without a gap."""

from __future__ import annotations

import math
from typing import Any

from contourlab.components.contract import param
from contourlab.components.families import TWO_SIDED
from contourlab.components.plant.plant import BallScrew
from contourlab.components.plant.two_sided import TwoSided


class Elastic(TwoSided):
    """Base of axes with a resonance: m_m v_m' = F - f - c_m v_m, (m_l + m_c) v_l' = f - c_l v_l + load, f = k (x_m - x_l) + d (v_m - v_l).

    With the mass m = m_m + m_l and the reduced mass mu = m_m m_l/m, k = mu w_r^2 and d = 2 D mu w_r; the viscous damping c acts on both in
    proportion to their masses. So without carried mass the axis has two modes that do not couple,

        x_m/F = (1/(s^2 + s c/m) + (m_l/m_m)/(s^2 + s (2 D w_r + c/m) + w_r^2))/m,
        x_l/F = (1/(s^2 + s c/m) - 1/(s^2 + s (2 D w_r + c/m) + w_r^2))/m,

    and at the antiresonance w_a = w_r sqrt(m_m/m) the load absorbs the motion of the motor. A subclass gives m_m, m_l and F per command.
    """

    derived = TWO_SIDED

    resonance: float = param(unit="Hz", minimum=0.0, exclusive=True, doc="structural resonance as measured, without carried mass, w_r/2 pi")
    damping_ratio: float = param(default=0.02, minimum=0.0, maximum=1.0, doc="of the resonance, D; bolted structures: 0.01 to 0.05")

    def masses(self, par: Any) -> tuple[Any, Any, Any]:
        """Return m_m [kg], m_l [kg] without carried mass, and force per command: numbers or arrays (n_variant,)."""
        raise NotImplementedError

    def stiffened(self, resonance: float) -> Any:
        return self if self.resonance >= resonance else self.replace(resonance=resonance, damping_ratio=0.7)

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        motor, own, force = self.masses(par)
        load, w = own + par.carried_mass, 2.0 * math.pi * par.resonance
        reduced = motor * own / (motor + own)
        stiffness, damper = reduced * w * w, 2.0 * par.damping_ratio * w * reduced
        decay = par.damping / (motor + own)
        # Without a gap there is no twist to unwind.
        nothing = 0.0 * load
        return force, 1.0 / motor, decay, 1.0 / load, decay * own / load, stiffness, damper, nothing, 1.0 + nothing, nothing


class TwoMass(Elastic):
    """Axis of known mass with one resonance, pushed by a current-controlled motor; otherwise like "mass-damper".

    A direct drive on a machine frame, a belt, a rack. `load_share` is the part of the mass beyond the spring. Without a measurement of
    resonance and antiresonance, take 0.5.

    References
    ----------
    Altintas, Verl, Brecher, Uriarte & Pritschow, "Machine tool feed drives", CIRP Annals 60 (2011); Ellis, "Control System Design Guide",
    4th ed., 2012, on compliance and resonance.
    """

    kind = "two-mass"
    example = {"mass": 20.0, "damping": 100.0, "force_constant": 60.0, "resonance": 60.0, "load_share": 0.6, "carried_mass": 2.0}
    reference = "Altintas et al., CIRP Annals 60 (2011)"
    command_unit = "A"

    mass: float = param(unit="kg", minimum=0.0, exclusive=True, doc="moving mass, both sides; rotating parts as J (2 pi / lead)^2")
    carried_mass: float = param(default=0.0, unit="kg", minimum=0.0, doc="additional mass on the load side")
    damping: float = param(default=0.0, unit="N*s/m", minimum=0.0, doc="viscous damping of guides, screw and motor, c")
    force_constant: float = param(unit="N/A", minimum=0.0, exclusive=True, doc="force of the drive per command")
    load_share: float = param(default=0.5, minimum=0.01, maximum=0.99, doc="part of `mass` on the load side, m_l/(m_m + m_l)")

    def masses(self, par: Any) -> tuple[Any, Any, Any]:
        return (1.0 - par.load_share) * par.mass, par.load_share * par.mass, par.force_constant


class ElasticBallScrew(Elastic):
    """Ball-screw axis from catalogue data with one resonance: rotor, coupling and screw against the table; otherwise like "ball-screw".

    References
    ----------
    Altintas, Verl, Brecher, Uriarte & Pritschow, "Machine tool feed drives", CIRP Annals 60 (2011).
    """

    kind = "elastic-ball-screw"
    example = {**BallScrew.example, "resonance": 60.0, "carried_mass": 2.0}
    reference = "Altintas et al., CIRP Annals 60 (2011)"
    command_unit = "A"

    mass = BallScrew.parameters["mass"]
    carried_mass = BallScrew.parameters["carried_mass"]
    inertia: float = param(unit="kg*m^2", minimum=0.0, exclusive=True, display="kg*cm^2", doc="inertia of rotor, coupling and screw, J")
    lead = BallScrew.parameters["lead"]
    torque_constant = BallScrew.parameters["torque_constant"]
    efficiency = BallScrew.parameters["efficiency"]
    damping = BallScrew.parameters["damping"]

    def masses(self, par: Any) -> tuple[Any, Any, Any]:
        per_metre = 2.0 * math.pi / par.lead
        return par.inertia * per_metre * per_metre, par.mass, par.torque_constant * par.efficiency * per_metre
