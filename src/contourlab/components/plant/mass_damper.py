"""A linear axis in physical units: mass, damping, force constant."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import param
from contourlab.components.plant.plant import SingleMass


class MassDamper(SingleMass):
    """Mass with viscous damping, pushed by a current-controlled motor: m v' = K_f i - c v + load - friction.

    `carried_mass` is the mass on the axis: a work piece, other axes. A machine adds the axes mounted on this one. All of `mass` counts as
    linear motion when another axis carries this one; if much of it is rotary inertia, use "ball-screw", which separates the two.
    """

    kind = "mass-damper"
    example = {"mass": 20.0, "damping": 100.0, "force_constant": 60.0}
    reference = "Newton's second law"
    command_unit = "A"
    derived = ("mobility_value", "decay_value")

    mass: float = param(unit="kg", minimum=0.0, exclusive=True, doc="moving mass of the axis; rotating parts as J (2 pi / lead)^2")
    carried_mass: float = param(default=0.0, unit="kg", minimum=0.0, doc="additional mass on the axis")
    damping: float = param(default=0.0, unit="N*s/m", minimum=0.0, doc="viscous damping of guides, screw and motor")
    force_constant: float = param(unit="N/A", minimum=0.0, exclusive=True, doc="force of the drive per command")

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        mass = par.mass + par.carried_mass
        return 1.0 / mass, par.damping / mass

    @staticmethod
    def drive_force(par: Any, command: float) -> float:
        return par.force_constant * command  # type: ignore[no-any-return]
