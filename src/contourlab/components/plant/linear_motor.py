"""A linear motor by its electrical and mechanical data."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import param
from contourlab.components.plant.lagged_mass import LaggedMass


class LinearMotor(LaggedMass):
    """Voltage-driven linear motor: K_amp e = R i + L i' + K_b v, (m + m_c) v' = K_f i - b v + load - friction.

    The command is the voltage in front of the amplifier, and the third state the motor's force K_f i. Position over command is eq (3),
    K_amp K_f/(s (L m s^2 + (R m + b L) s + R b + K_b K_f)). The ripple of its force over position is a disturbance ("force-ripple"), a
    transport delay and the amplifier's limit belong to the drive ("delayed-saturation"). Where current is controlled inside the amplifier,
    or inductance does not matter, take "mass-damper".

    References
    ----------
    Gecer Ulu, Ulu & Cakmakci, "Design and analysis of a modular learning based cross-coupled control algorithm for multi-axis precision
    positioning systems", eqs (1)-(3).
    """

    kind = "linear-motor"
    reference = "Gecer Ulu, Ulu & Cakmakci, eqs 1-3"
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

    resistance: float = param(unit="ohm", minimum=0.0, exclusive=True, doc="of the winding, R", source="Gecer Ulu et al., eq 1")
    inductance: float = param(unit="H", minimum=0.0, exclusive=True, display="mH", doc="of the winding, L", source="Gecer Ulu et al., eq 1")
    back_emf: float = param(unit="V*s/m", minimum=0.0, doc="voltage induced per speed, K_BEMF", source="Gecer Ulu et al., eq 1")
    force_constant: float = param(unit="N/A", minimum=0.0, exclusive=True, doc="force per current, K_f", source="Gecer Ulu et al., eq 2")
    mass: float = param(unit="kg", minimum=0.0, exclusive=True, doc="sliding mass of the axis itself, m", source="Gecer Ulu et al., eq 2")
    carried_mass: float = param(default=0.0, unit="kg", minimum=0.0, doc="mass that the axis carries besides its own")
    viscous_friction: float = param(default=0.0, unit="N*s/m", minimum=0.0, doc="of the guide, b", source="Gecer Ulu et al., eq 2")
    amplifier_gain: float = param(default=1.0, minimum=0.0, exclusive=True, doc="volts per command, K_amp", source="Gecer Ulu et al., eq 1")

    def rates(self, par: Any) -> tuple[Any, Any, Any, Any, Any]:
        mass, rate = par.mass + par.carried_mass, par.resistance / par.inductance
        gain = par.force_constant * par.amplifier_gain / par.resistance
        return 1.0 / mass, par.viscous_friction / mass, rate, gain, par.force_constant * par.back_emf / par.inductance
