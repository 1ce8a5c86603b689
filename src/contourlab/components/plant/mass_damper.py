"""A linear axis in physical units: mass, damping, force constant."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import param
from contourlab.components.plant.plant import SingleMass


class MassDamper(SingleMass):
    """Mass with viscous damping, pushed by a current-controlled motor: m v' = K_f i - c v + load - friction.

    `carried_mass` is the mass on the axis (other axes of the machine, a work piece); a machine adds the axes mounted on this one.
    Between axes that move along each other all of the mass counts as moving in a straight line; where much of it only turns, take
    "ball-screw", which tells the two apart.
    """

    kind = "mass-damper"
    example = {"mass": 20.0, "damping": 100.0, "force_constant": 60.0}
    reference = "Newton's second law"
    command_unit = "A"
    derived = ("mobility_value", "decay_value")

    mass: float = param(unit="kg", minimum=0.0, exclusive=True, doc="moved mass of the axis; rotating parts as J (2 pi / lead)^2")
    carried_mass: float = param(default=0.0, unit="kg", minimum=0.0, doc="mass that the axis carries besides its own")
    damping: float = param(default=0.0, unit="N*s/m", minimum=0.0, doc="viscous damping of guides, screw and motor")
    force_constant: float = param(unit="N/A", minimum=0.0, exclusive=True, doc="force of the drive per command")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        mass = par.mass + par.carried_mass
        return 1.0 / mass, par.damping / mass

    @staticmethod
    def drive_force(par: Any, command: float) -> float:
        return par.force_constant * command  # type: ignore[no-any-return]
