"""What the integral of a controller does while its command cannot be carried out."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from contourlab.primitives import select

ANTI_WINDUP = ("hold", "back-calculation", "none")
"""Words of the parameter `anti_windup`.

"hold" stops the integral while the drive takes less than it was asked for and the integral would ask for more still; "back-calculation"
leads the surplus back into the integral with the time constant `tracking_time` (Astrom & Hagglund, "Advanced PID Control", 2006, section
3.5), so that it is where it has to be when the limit is left; with "none" it runs on.
"""


@cache
def integral_rise(kind: str) -> Any:
    """Return the rule ``rise(wanted, beyond, recovery)`` of a word of `ANTI_WINDUP`.

    `wanted` is what the integral would rise by in this tick, `beyond` what the drive did not take of the last command, both in command
    units; `recovery` is the part of `beyond` that is led back in a tick.
    """

    def hold(wanted: float, beyond: float, recovery: float) -> float:
        return select(wanted * beyond > 0.0, 0.0, wanted)

    def back(wanted: float, beyond: float, recovery: float) -> float:
        return wanted - recovery * beyond

    def none(wanted: float, beyond: float, recovery: float) -> float:
        return wanted

    return {"hold": hold, "back-calculation": back, "none": none}[kind]


def recovery_part(tracking_time: Any, dt: float) -> Any:
    """Return the part of the surplus that is led back in a tick, 1 - exp(-dt/tracking_time): below 1 however short the time is."""
    return -np.expm1(-dt / tracking_time)
