"""The contact-zone controller of type I."""

from __future__ import annotations

from contourlab.components.controller.zone_law import InertiaGains


class ContactZone1(InertiaGains):
    """u = J_m (r_a - K_1 (w_m - r_v) - K_2 (theta_m - r -+ beta)): the motor follows the reference, moved to the flank it presses on.

    References
    ----------
    Shahin, ElMaraghy & ElBeheiry, "On nonlinearity control of CNC feed drives", eq (10). It is Tao & Kokotovic's law for a stiff drive.
    """

    kind = "contact-zone-1"
    reference = "Shahin, ElMaraghy & ElBeheiry, eq 10"
    example = {"rate_gain": 400.0, "position_gain": 2000.0, "motor_inertia": 5.2e-3, "lead": 0.016, "backlash_gap": 0.05}
