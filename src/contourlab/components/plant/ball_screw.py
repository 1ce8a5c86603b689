"""A ball-screw axis from catalogue data: motor, screw and table."""

from __future__ import annotations

import math
from typing import Any

from contourlab.components.contract import param
from contourlab.components.plant.plant import SingleMass


class BallScrew(SingleMass):
    """Rigid ball-screw feed drive: (m + m_c + J (2 pi/l)^2) v' = (2 pi eta / l) K_t i - c v + load - friction.

    Motor current drives the screw; rotor, coupling and screw turn with it. Valid below the first torsional resonance, and without
    backlash.

    References
    ----------
    Altintas, "Manufacturing Automation", 2nd ed., chapter on feed drives: inertia and torque reflected over the lead.
    """

    kind = "ball-screw"
    example = {"mass": 20.0, "inertia": 2e-4, "lead": 0.01, "torque_constant": 0.5, "damping": 100.0}
    reference = "Altintas, Manufacturing Automation, feed drives"
    command_unit = "A"
    derived = ("mobility_value", "decay_value", "force_constant_value")

    mass: float = param(unit="kg", minimum=0.0, exclusive=True, doc="mass of the table and everything fixed to it")
    carried_mass: float = param(default=0.0, unit="kg", minimum=0.0, doc="additional mass on the axis")
    inertia: float = param(unit="kg*m^2", minimum=0.0, display="kg*cm^2", doc="inertia of rotor, coupling and screw, J")
    lead: float = param(unit="m", minimum=0.0, exclusive=True, display="mm", doc="travel per turn of the screw, l")
    torque_constant: float = param(unit="N*m/A", minimum=0.0, exclusive=True, doc="torque of the motor per command, K_t")
    efficiency: float = param(default=0.95, minimum=0.0, maximum=1.0, exclusive=True, doc="of the screw, eta; ground: 0.9 to 0.95")
    damping: float = param(default=0.0, unit="N*s/m", minimum=0.0, doc="viscous damping seen at the table, c")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        per_metre = 2.0 * math.pi / par.lead
        mass = par.mass + par.carried_mass + par.inertia * per_metre * per_metre
        return 1.0 / mass, par.damping / mass, par.torque_constant * par.efficiency * per_metre

    @staticmethod
    def drive_force(par: Any, command: float) -> float:
        return par.force_constant_value * command  # type: ignore[no-any-return]
