"""Drives with backlash for several tests."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from contourlab.analysis.backlash.lure import BacklashLoop
from contourlab.papers.shahin.two_inertia_loop import Feedback, TwoInertias, motor_pid, two_inertia_loop

# Table 1 of Shahin, ElMaraghy & ElBeheiry; half of the gap 12.5 um on a screw of 16 mm.
J_M, J_L, K_S, HALF_GAP = 5.2e-3, 4.4e-3, 950.0, 2.0 * math.pi * 12.5e-6 / 0.016
PAPER = TwoInertias(J_M, J_L, K_S, HALF_GAP)
# Table 2: K_1' = K_4', K_2' = K_5', K_3 = K_6.
SCHEME_II = motor_pid(200.0, 1000.0, 0.0, J_M)
SCHEME_III = motor_pid(200.0, 1000.0, 25.0, J_M)
FREE = Feedback((0.0, 0.0, 0.0, 0.0))


def drive(**changes: float) -> TwoInertias:
    """Return the paper's drive with changes."""
    return replace(PAPER, **changes)


def paper_loop() -> BacklashLoop:
    """Return the paper's drive under scheme II."""
    return two_inertia_loop(PAPER, SCHEME_II)


def integrated(loop: BacklashLoop, start: NDArray[np.float64], times: NDArray[np.float64], tolerance: float = 1e-12) -> NDArray[np.float64]:
    """Return states (n_time, n) of the dead-zone model by an integrator that knows nothing of modes."""

    def slope(_: float, x: NDArray[np.float64]) -> NDArray[np.float64]:
        d = loop.c @ x
        return loop.a @ x - loop.b * loop.stiffness * (max(d - loop.half_gap, 0.0) + min(d + loop.half_gap, 0.0))

    found = solve_ivp(
        slope, (0.0, times[-1]), start, "DOP853", t_eval=times, rtol=tolerance, atol=1e-4 * tolerance * loop.half_gap, max_step=2e-3
    )
    return np.asarray(found.y.T)
