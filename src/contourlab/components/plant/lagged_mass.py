"""Plants whose drive force lags the command."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.components.contract import LinearModel, param
from contourlab.components.mechanics.propagator import NAMES, STIFFEST, doublings_for, propagator
from contourlab.components.plant.plant import SingleMass
from contourlab.engine.step import Port


class LaggedMass(SingleMass):
    """A mass driven through a first-order lag, with back-action of its velocity: v' = m (f + load - friction) - d v, f' = r (g u - f) - b
    v.

    m is the mobility, d the decay, r the rate of the lag, g the force per command at rest, b the back-action; f is in force units. A
    subclass returns the five as `rates`. The linear part is integrated exactly, so that r may be far above one over the servo period.
    """

    states = (Port("position"), Port("velocity"), Port("force"))
    derived = (
        *("mobility_value", "decay_value", "rate_value", "gain_value", "back_value"),
        *(f"{part}_{name}" for part in ("full", "half") for name in NAMES),
    )

    def rates(self, par: Any) -> tuple[Any, Any, Any, Any, Any]:
        """Return m [m/s^2 per force], d [1/s], r [1/s], g [force per command] and b [force/m]: numbers or arrays (n_variant,)."""
        raise NotImplementedError

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        m, d, r, g, b = self.rates(par)
        doublings = doublings_for(np.max((d + r + np.sqrt(m * b)) * dt))
        full, half = (propagator(d, r, d * r + m * b, h, doublings) for h in (dt, 0.5 * dt))
        return (m, d, r, g, b, *full, *half)

    @staticmethod
    def drive_force(par: Any, command: float) -> float:
        """Return the force at rest for a steady command."""
        return par.gain_value * command  # type: ignore[no-any-return]

    def fewest_substeps(self, dt: float) -> tuple[int, str]:
        m, d, r, _, b = self.rates(self)
        # The linear part is exact up to STIFFEST of its shortest time constants per step.
        wanted = math.ceil(np.max(d + r + np.sqrt(m * b)) * dt / STIFFEST)
        words = f"a {self.kind} whose time constants are so far below the servo period; or use a plant without them, such as mass-damper"
        return max(1, wanted), words

    def rigid_model(self) -> tuple[float, float]:
        """Return gain a and damping b of v' = a u - b v with the same steady velocity; 1/b is the sum of the time constants."""
        m, d, r, g, b = (float(number) for number in self.rates(self))
        return m * r * g / (d + r), (d * r + m * b) / (d + r)

    def linearize(self) -> LinearModel:
        m, d, r, g, back = self.rates(self)
        a = np.array([[0.0, 1.0, 0.0], [0.0, -d, m], [0.0, -back, -r]])
        b = np.array([[0.0, 0.0], [0.0, m], [r * g, 0.0]])
        return LinearModel(a, b, np.eye(2, 3), np.zeros((2, 2)), ("command", "load"), ("position", "velocity"))


class LinearMotor(LaggedMass):
    """Voltage-driven linear motor: K_amp e = R i + L i' + K_b v, (m + m_c) v' = K_f i - b v + load - friction.

    The command is the input voltage e of the amplifier; the third state is the motor force K_f i. Position over command is eq (3),
    K_amp K_f/(s (L m s^2 + (R m + b L) s + R b + K_b K_f)). Force ripple is a disturbance ("force-ripple"); transport delay and amplifier
    limit belong to the drive ("delayed-saturation"). If the amplifier controls the current, or inductance is negligible, use "mass-damper".

    References
    ----------
    Gecer Ulu, Ulu & Cakmakci, "Design and analysis of a modular learning based cross-coupled control algorithm for multi-axis precision
    positioning systems", eqs (1)-(3).
    """

    kind = "linear-motor"
    reference = "Gecer Ulu, Ulu & Cakmakci 2016, eqs 1-3"
    example = {
        "resistance": 2.5,
        "inductance": 4e-3,
        "back_emf": 18.0,
        "force_constant": 21.0,
        "mass": 1.8,
        "carried_mass": 0.4,
        "viscous_friction": 12.0,
        "amplifier_gain": 3.0,
    }
    command_unit = "V"

    resistance: float = param(unit="ohm", minimum=0.0, exclusive=True, doc="winding resistance, R", source="Gecer Ulu et al., eq 1")
    inductance: float = param(unit="H", minimum=0.0, exclusive=True, display="mH", doc="of the winding, L", source="Gecer Ulu et al., eq 1")
    back_emf: float = param(unit="V*s/m", minimum=0.0, doc="voltage induced per speed, K_BEMF", source="Gecer Ulu et al., eq 1")
    force_constant: float = param(unit="N/A", minimum=0.0, exclusive=True, doc="force per current, K_f", source="Gecer Ulu et al., eq 2")
    mass: float = param(unit="kg", minimum=0.0, exclusive=True, doc="moving mass of the axis itself, m", source="Gecer Ulu et al., eq 2")
    carried_mass: float = param(default=0.0, unit="kg", minimum=0.0, doc="additional mass on the axis")
    viscous_friction: float = param(default=0.0, unit="N*s/m", minimum=0.0, doc="friction of the guide, b", source="Gecer Ulu et al., eq 2")
    amplifier_gain: float = param(default=1.0, minimum=0.0, exclusive=True, doc="volts per command, K_amp", source="Gecer Ulu et al., eq 1")

    def rates(self, par: Any) -> tuple[Any, Any, Any, Any, Any]:
        mass, rate = par.mass + par.carried_mass, par.resistance / par.inductance
        gain = par.force_constant * par.amplifier_gain / par.resistance
        return 1.0 / mass, par.viscous_friction / mass, rate, gain, par.force_constant * par.back_emf / par.inductance


class SecondOrderIntegrator(LaggedMass):
    """Identified axis P(s) = G wn^2/(s (s^2 + 2 zeta wn s + wn^2)), with any damping ratio.

    It is the linear motor of eq (3) without viscous friction, in other parameters: the third state is a force that lags with the rate
    2 zeta wn. Forces are in command units: the command L balances a steady load L. The transport delay of eq (4) belongs to the drive, as
    in ``drive = {kind = "delayed-saturation", delay = "15 ms"}``.

    With a finite `mass`, carried axes slow it down: mobility is proportional to mass/(mass + carried_mass); rate and back-action stay, as
    for the motor. With an infinite `mass` (the default) carried mass has no effect: the response is assumed to include everything carried.

    References
    ----------
    Gecer Ulu, Ulu & Cakmakci, "Design and analysis of a modular learning based cross-coupled control algorithm for multi-axis precision
    positioning systems", eq (4).
    """

    kind = "second-order-integrator"
    reference = "Gecer Ulu, Ulu & Cakmakci 2016, eq 4"
    example = {"dc_gain": 0.05, "damping_ratio": 1.1, "natural_frequency": 150.0, "mass": 2.0, "carried_mass": 0.7}
    command_unit = "V"
    force_unit = "V"

    dc_gain: float = param(
        unit="m/s/V",
        minimum=0.0,
        exclusive=True,
        display="mm/s/V",
        doc="steady velocity per command, G_DC",
        source="Gecer Ulu et al., eq 4",
    )
    damping_ratio: float = param(minimum=0.0, exclusive=True, doc="of the velocity response, zeta", source="Gecer Ulu et al., eq 4")
    natural_frequency: float = param(unit="rad/s", minimum=0.0, exclusive=True, doc="of velocity, omega_n", source="Gecer Ulu et al., eq 4")
    mass: float = param(default=math.inf, unit="kg", minimum=0.0, exclusive=True, doc="moving mass when identified; inf: unknown")
    carried_mass: float = param(default=0.0, unit="kg", minimum=0.0, doc="mass added since; acts only with a known `mass`")

    @property
    def knows_mass(self) -> bool:
        return math.isfinite(self.mass)

    def rates(self, par: Any) -> tuple[Any, Any, Any, Any, Any]:
        rate = 2.0 * par.damping_ratio * par.natural_frequency
        mobility = par.dc_gain * par.natural_frequency / (2.0 * par.damping_ratio)
        share = 1.0 / (1.0 + par.carried_mass / par.mass)
        return mobility * share, 0.0 * rate, rate, 1.0 + 0.0 * rate, rate / par.dc_gain
