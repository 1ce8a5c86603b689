"""Base of the controllers, and anti-windup: treatment of the integral while the drive limits the command."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from contourlab.components.contract import Component, param
from contourlab.primitives import select

ANTI_WINDUP = ("hold", "back-calculation", "none")
"""Values of the parameter `anti_windup`.

"hold" stops the integral while the drive accepts less than the command and the integral would grow further. "back-calculation" feeds the
excess back into the integral with the time constant `tracking_time` (Astrom & Hagglund, "Advanced PID Control", 2006, section 3.5), so that
the integral is right when the limit is left. "none" lets it continue.
"""

TRACKING_TIME = param(default=0.01, unit="s", minimum=0.0, exclusive=True, display="ms", doc="time constant of the back-calculation, T_t")

RISES: dict[str, Callable[[float, float, float], float]] = {
    "hold": lambda wanted, beyond, recovery: select(wanted * beyond > 0.0, 0.0, wanted),
    "back-calculation": lambda wanted, beyond, recovery: wanted - recovery * beyond,
    "none": lambda wanted, beyond, recovery: wanted,
}
"""The rule ``rise(wanted, beyond, recovery)`` of each.

`wanted` is the rise of the integral in this tick without a limit, `beyond` the part of the last command that the drive did not accept, both
in command units; `recovery` is the share of `beyond` fed back in a tick.
"""


class ControlLaw(Component):
    """Base of the controllers of an axis."""

    family = "controller"


def recovery_part(tracking_time: Any, dt: float) -> Any:
    """Return the share of the excess fed back in a tick, 1 - exp(-dt/tracking_time): always below 1."""
    return -np.expm1(-dt / tracking_time)
