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
    With pole matching, 1 - exp(-w dt), the derivative w (u - y) of a ramp comes out too small by w dt e/(1 - e), e = exp(-w dt): at
    w dt = 2 it is 0.31 of the slope. Backward Euler, w dt/(1 + w dt), gives the slope itself. An infinite bandwidth has the weight 1.
    """
    turn = np.multiply(bandwidth, dt)
    return -np.expm1(-turn) if rule == "pole-matched" else 1.0 / (1.0 + 1.0 / turn)
