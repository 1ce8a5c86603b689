"""An axis v' = a (u - friction) - b v behind a dead time, under a relay; its motion is computed here, not by the package."""

from __future__ import annotations

import math

import numpy as np
from scipy.optimize import brentq

from contourlab.arrays import Array


def ultimate(gain: float, damping: float, dead: float, period: float) -> tuple[float, float]:
    """Return ultimate gain [command/m] and period [s] with a command that is held between samples."""
    late = dead + 0.5 * period
    w = float(brentq(lambda w: math.atan2(w, damping) + w * late - 0.5 * math.pi, 1e-6, 0.5 * math.pi / late))
    return w * math.hypot(w, damping) / gain, 2.0 * math.pi / w


def relay_run(
    n: int,
    period: float,
    gain: float,
    damping: float,
    dead: float,
    level: float = 1.0,
    hysteresis: float = 0.0,
    count: float = 0.0,
    noise: float = 0.0,
    friction: float = 0.0,
    load: float = 0.0,
    fine: int = 8,
    seed: int = 0,
) -> tuple[Array, Array]:
    """Return command and measured position (n,); the dead time is a whole number of steps of period/fine."""
    draw, h, late = np.random.default_rng(seed).standard_normal(n), period / fine, round(dead * fine / period)
    command, measured, asked = np.zeros(n), np.zeros(n), np.zeros(n * fine)
    left = math.exp(-damping * h)
    gained = (1.0 - left) / damping
    x = v = 0.0
    side = 1.0
    for k in range(n):
        seen = x + noise * draw[k]
        seen = count * round(seen / count) if count else seen
        side = -math.copysign(1.0, seen) if abs(seen) > hysteresis else side
        command[k], measured[k] = level * side, seen
        asked[k * fine : (k + 1) * fine] = level * side
        for i in range(k * fine, (k + 1) * fine):
            force = (asked[i - late] if i >= late else 0.0) + load
            if v == 0.0 and abs(force) <= friction:
                continue
            push = gain * (force - math.copysign(friction, v if v else force))
            later = v * left + push * gained
            later = 0.0 if friction and v * later < 0.0 else later
            x += (v - later + push * h) / damping if later else 0.5 * v * h
            v = later
    return command, measured
