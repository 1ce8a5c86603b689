"""The gap controller of type I."""

from __future__ import annotations

from typing import Any

from contourlab.components.contract import text_param
from contourlab.components.controller.zone_law import InertiaGains, zone_step


class GapZone1(InertiaGains):
    """u = J_m (a_l - K_4 (w_m - w_l) - K_5 (theta_m - theta_l -+ beta)): the motor goes to a flank of the load, wherever that is.

    References
    ----------
    Shahin, ElMaraghy & ElBeheiry, "On nonlinearity control of CNC feed drives", eq (14). As printed nothing in it
    knows the reference, so that a load without friction is left to itself in the gap and the axis runs away; with `target` "reference" the
    reference stands in the place of the load.
    """

    kind = "gap-zone-1"
    reference = "Shahin, ElMaraghy & ElBeheiry, eq 14"
    example = {"rate_gain": 400.0, "position_gain": 2000.0, "motor_inertia": 5.2e-3, "lead": 0.016, "backlash_gap": 0.05, "target": "load"}

    target: str = text_param(default="reference", choices=("reference", "load"), doc="what the motor is led to; printed is the load")

    def step_function(self) -> Any:
        return zone_step(self, follows_load=self.target == "load")
