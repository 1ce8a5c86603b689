"""Sampled first-order low-passes: the weight of the new value in y += weight (u - y)."""

from __future__ import annotations

from typing import Any

import numpy as np

RULES = ("backward-euler", "pole-matched")
"""Backward Euler keeps the derivative w (u - y) exact on a ramp; pole matching keeps the filter's own time constant."""


def low_pass_weight(bandwidth: Any, dt: float, rule: str) -> Any:
    """Return the weight for a bandwidth [rad/s], > 0 (a number or an array) at a period [s].

    Notes
    -----
    With pole matching, 1 - exp(-w dt), the derivative w (u - y) of a ramp is scaled by w dt e/(1 - e), e = exp(-w dt): 0.31 at
    w dt = 2. With backward Euler, w dt/(1 + w dt), it is exact. An infinite bandwidth has the weight 1.
    """
    turn = np.multiply(bandwidth, dt)
    return -np.expm1(-turn) if rule == "pole-matched" else 1.0 / (1.0 + 1.0 / turn)
