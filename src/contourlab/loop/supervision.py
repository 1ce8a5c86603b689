"""Several controllers for one axis: the supervisor says which is active, and the command is handed over without a bump.

All of them run all the time, on the same measurements, and all see the command that was really carried out: to one that is not active this
is as if the drive did not take its own, so that its integral is held or led back as its `anti_windup` says. What is left of a difference at
a switch is taken over as an offset that decays with the supervisor's `handover_time`.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from contourlab.engine.step import Port, Step
from contourlab.primitives import select

__all__ = ["handover_parameters", "handover_step"]


@cache
def handover_step(n: int) -> Step:
    """Return the step that passes on the active one of `n` commands."""
    inputs = (Port("commands", n), Port("active"), Port("accepted"))
    return Step("handover", _hand_over, ("kept", "blended"), (), "", (Port("active"), Port("offset")), inputs, (Port("command"),))


def _hand_over(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    wanted = inp.commands[0]
    for i in range(1, len(inp.commands)):
        wanted = select(inp.active == float(i), inp.commands[i], wanted)
    offset = select(inp.active == x.active, x.offset, par.blended * (inp.accepted - wanted))
    # A supervisor that gives no number is to end the run, not to leave the axis without a command.
    return (inp.active, par.kept * offset), (wanted + offset + 0.0 * inp.active,)


def handover_parameters(handover_time: Any, dt: float) -> dict[str, Any]:
    """Return the parameters of the step for a time constant [s]; with zero there is no offset: the command jumps."""
    time = np.asarray(handover_time, dtype=float)
    blended = np.where(time > 0.0, 1.0, 0.0)
    return {"kept": np.exp(-dt / np.where(time > 0.0, time, np.inf)) * blended, "blended": blended}
