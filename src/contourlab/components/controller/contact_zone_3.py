"""The contact-zone controller of type III."""

from __future__ import annotations

from contourlab.components.controller.zone_law import Integral


class ContactZone3(Integral):
    """u = J_m r_a - K_1' (w_m - r_v) - K_2' (theta_m - r -+ beta) - K_3 int (theta_m - r): type II with an integral.

    References
    ----------
    Shahin, ElMaraghy & ElBeheiry, "On nonlinearity control of CNC feed drives", eq (13).
    """

    kind = "contact-zone-3"
    reference = "Shahin, ElMaraghy & ElBeheiry, eq 13"
    example = {
        "rate_gain": 10.0,
        "position_gain": 200.0,
        "integral_gain": 25.0,
        "anti_windup": "back-calculation",
        "motor_inertia": 5.2e-3,
        "lead": 0.016,
        "backlash_gap": 0.05,
    }
