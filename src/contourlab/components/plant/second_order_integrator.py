"""A servo axis known by the response of its velocity: one of second order."""

from __future__ import annotations

import math
from typing import Any

from contourlab.components.contract import param
from contourlab.components.plant.lagged_mass import LaggedMass


class SecondOrderIntegrator(LaggedMass):
    """Axis of P(s) = G wn^2/(s (s^2 + 2 zeta wn s + wn^2)), as an identification gives it; any damping ratio.

    It is the linear motor of eq (3) without viscous friction, in other letters, so that the third state is a force that lags with the rate
    2 zeta wn. Forces are in units of the command: a steady load of L is balanced by the command L. The transport delay of eq (4) belongs to
    the drive, as in ``drive = {kind = "delayed-saturation", delay = "15 ms"}``.

    With its moved mass given it takes up the mass of axes that stand on it: mobility goes with mass/(mass + carried_mass), rate and
    back-action stay, as they do for the motor. Without a mass (infinity) no other mass changes it: its response is taken to have been
    measured with all that is carried.

    References
    ----------
    Gecer Ulu, Ulu & Cakmakci, "Design and analysis of a modular learning based cross-coupled control algorithm for multi-axis precision
    positioning systems", eq (4).
    """

    kind = "second-order-integrator"
    reference = "Gecer Ulu, Ulu & Cakmakci, eq 4"
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
    damping_ratio: float = param(minimum=0.0, exclusive=True, doc="of the velocity's response, zeta", source="Gecer Ulu et al., eq 4")
    natural_frequency: float = param(unit="rad/s", minimum=0.0, exclusive=True, doc="of velocity, omega_n", source="Gecer Ulu et al., eq 4")
    mass: float = param(default=math.inf, unit="kg", minimum=0.0, exclusive=True, doc="moved mass when identified; inf: not known")
    carried_mass: float = param(default=0.0, unit="kg", minimum=0.0, doc="mass that came onto the axis since; acts beside a known `mass`")

    @property
    def knows_mass(self) -> bool:
        return math.isfinite(self.mass)

    def rates(self, par: Any) -> tuple[Any, Any, Any, Any, Any]:
        rate = 2.0 * par.damping_ratio * par.natural_frequency
        mobility = par.dc_gain * par.natural_frequency / (2.0 * par.damping_ratio)
        share = 1.0 / (1.0 + par.carried_mass / par.mass)
        return mobility * share, 0.0 * rate, rate, 1.0 + 0.0 * rate, rate / par.dc_gain
