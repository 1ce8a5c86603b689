"""The contact-zone controller of type II."""

from __future__ import annotations

from contourlab.components.controller.zone_law import TypeTwo


class ContactZone2(TypeTwo):
    """u = J_m r_a - K_1' (w_m - r_v) - K_2' (theta_m - r -+ beta): type I with gains that are torques.

    References
    ----------
    Shahin, ElMaraghy & ElBeheiry, "On nonlinearity control of CNC feed drives", eq (12). Type I with the gains K' = J_m K is the same law.
    """

    kind = "contact-zone-2"
    reference = "Shahin, ElMaraghy & ElBeheiry, eq 12"
    example = {"rate_gain": 10.0, "position_gain": 200.0, "motor_inertia": 5.2e-3, "lead": 0.016, "backlash_gap": 0.05}
