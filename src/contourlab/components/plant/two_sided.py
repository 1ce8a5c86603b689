"""Plants whose motor and load can differ in position: their base, and axes with one structural resonance, a spring without a gap."""

from __future__ import annotations

import math
from typing import Any, ClassVar

import numpy as np

from contourlab.components.contract import LinearModel, param
from contourlab.components.families import TWO_SIDED
from contourlab.components.mechanics.two_mass_mechanics import two_mass_bristle_step, two_mass_step
from contourlab.components.plant.plant import BallScrew, Plant
from contourlab.engine.step import ports
from contourlab.errors import ComponentError

COARSEST = 0.5
"""Largest phase of the shaft's oscillation in a sub-step [rad]; there the fourth-order method damps it by 1e-4 per sub-step."""


class TwoSided(Plant):
    """Base of two masses joined by a spring and a damper, with or without a gap; all states are lengths at the load.

    A subclass derives `contourlab.components.families.TWO_SIDED`. `bonded` is 1 without a gap. `two_mass_mechanics` integrates the motion.
    """

    two_sided = True
    physical: ClassVar[bool] = True
    states = ports("motor_position", "motor_velocity", "position", "velocity", "side", "twist")
    outputs = ports("position", "velocity", "acceleration", "motor_position", "motor_velocity", "gap_state", "shaft_force")

    def gap_function(self) -> Any:
        """Return ``gap(par, position)``: half the gap at the load's position, and its slope."""
        return even_gap

    def joined(self, motor: Any, load: Any, motor_view: Any, load_view: Any) -> Any:
        """Return the step with a friction on either side."""
        laws = {motor.law, load.law}
        if laws > {"bristle"} and laws != {"bristle", "smooth"}:
            # A held body and one with bending bristles would need a joint solution at every stop.
            raise ComponentError(
                f"a {self.kind} cannot combine a bristle friction with one of law {(laws - {'bristle'}).pop()!r} (motor {motor.kind}, load "
                f"{load.kind}): use bristles on both sides, or a smooth friction or none on the other side"
            )
        join = two_mass_bristle_step if "bristle" in laws else two_mass_step
        return join(self.gap_function(), self.physical, motor, load, motor_view, load_view)

    def linearize(self) -> LinearModel:
        """Return the model in contact: the drive without its gap."""
        d = self.constants()
        k, c, motor, load = d.stiffness_value, d.damper_value, d.motor_mobility, d.load_mobility
        a = np.array(
            [
                [0.0, 1.0, 0.0, 0.0],
                [-k * motor, -c * motor - d.motor_decay, k * motor, c * motor],
                [0.0, 0.0, 0.0, 1.0],
                [k * load, c * load, -k * load, -c * load - d.load_decay],
            ]
        )
        b = np.array([[0.0, 0.0], [d.force_value * motor, 0.0], [0.0, 0.0], [0.0, load]])
        names = ("position", "velocity", "motor_position", "motor_velocity")
        return LinearModel(a, b, np.eye(4)[[2, 3, 0, 1]], np.zeros((4, 2)), ("command", "load"), names)

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        places = {"position": position, "motor_position": position}
        return places, places

    @property
    def force_per_command(self) -> float:
        return float(self.constants().force_value)

    def rigid_model(self) -> tuple[float, float]:
        d = self.constants()
        motor, load = 1.0 / d.motor_mobility, 1.0 / d.load_mobility
        return float(d.force_value / (motor + load)), float((motor * d.motor_decay + load * d.load_decay) / (motor + load))

    def mobilities(self) -> tuple[float, ...]:
        d = self.constants()
        return float(d.load_mobility), float(d.motor_mobility)

    def stiffened(self, resonance: float) -> Any:
        """Return the plant with a well damped (0.7) resonance [Hz] of its shaft in contact; itself if it is as stiff already."""
        raise NotImplementedError

    @property
    def shaft_rate(self) -> float:
        """Angular frequency [rad/s] of the undamped shaft in contact."""
        d = self.constants()
        return np.sqrt(d.stiffness_value * (d.motor_mobility + d.load_mobility))  # type: ignore[no-any-return]

    def fewest_substeps(self, dt: float) -> tuple[int, str]:
        d = self.constants()
        fast = np.max(self.shaft_rate)
        damped = np.max(d.damper_value * (d.motor_mobility + d.load_mobility) + np.maximum(d.motor_decay, d.load_decay))
        wanted = max(fast * dt / COARSEST, damped * dt / 1.0)
        return max(1, math.ceil(wanted - 1e-9)), f"a shaft that oscillates at {fast / (2.0 * math.pi):.4g} Hz"


def even_gap(par: Any, position: float) -> tuple[float, float]:
    """Return half of a gap that is the same everywhere, and its slope."""
    return par.half_gap, 0.0


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
    reference = "Altintas et al. 2011"
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
    reference = "Altintas et al. 2011"
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
