"""The gap controller of type III."""

from __future__ import annotations

from contourlab.components.controller.zone_law import Integral


class GapZone3(Integral):
    """u = J_m r_a - K_4' (w_m - r_v) - K_5' (theta_m - r -+ beta) - K_6 int (theta_m - r): type II with an integral.

    References
    ----------
    Shahin, ElMaraghy & ElBeheiry, "On nonlinearity control of CNC feed drives", eq (16). With the gains of the
    contact zone it is the contact zone's law.
    """

    kind = "gap-zone-3"
    reference = "Shahin, ElMaraghy & ElBeheiry, eq 16"
    example = {
        "rate_gain": 10.0,
        "position_gain": 200.0,
        "integral_gain": 25.0,
        "anti_windup": "back-calculation",
        "motor_inertia": 5.2e-3,
        "lead": 0.016,
        "backlash_gap": 0.05,
    }
