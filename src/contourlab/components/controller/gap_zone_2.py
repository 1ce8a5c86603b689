"""The gap controller of type II."""

from __future__ import annotations

from contourlab.components.controller.zone_law import TypeTwo


class GapZone2(TypeTwo):
    """u = J_m r_a - K_4' (w_m - r_v) - K_5' (theta_m - r -+ beta): the motor follows the reference through the gap.

    References
    ----------
    Shahin, ElMaraghy & ElBeheiry, "On nonlinearity control of CNC feed drives", eq (15). With the gains of the
    contact zone it is the contact zone's law.
    """

    kind = "gap-zone-2"
    reference = "Shahin, ElMaraghy & ElBeheiry, eq 15"
    example = {"rate_gain": 10.0, "position_gain": 200.0, "motor_inertia": 5.2e-3, "lead": 0.016, "backlash_gap": 0.05}
