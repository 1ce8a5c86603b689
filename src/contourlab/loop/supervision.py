"""Several controllers for one axis: the supervisor says which is active, and the command is handed over without a bump.

All of them run all the time, on the same measurements. What a controller is told to have been accepted is to the active one what the drive
took of its own command, whatever was added to it at the hand-over; to one that is not active it is the command that was carried out, as if
the drive did not obey, so that its integral is led there. For that an integral has to be led back, so that a controller whose `anti_windup`
is "hold" is run with "back-calculation" beside others. What is left of a difference at a switch is taken over as an offset that decays with
the supervisor's `handover_time`.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from contourlab.components.contract import Component
from contourlab.engine.step import Port, Step
from contourlab.primitives import select


def conditioned(part: Component) -> Component:
    """Return a controller fit to run beside others: an integral that is only held would not follow what is carried out."""
    if "anti_windup" not in part.parameters or part.values()["anti_windup"] != "hold":
        return part
    if "back-calculation" not in part.parameters["anti_windup"].choices:
        return part
    found: Component = part.replace(anti_windup="back-calculation")
    return found


@cache
def handover_step(n: int) -> Step:
    """Return the step that passes on the active one of `n` commands."""
    inputs = (Port("commands", n), Port("active"), Port("accepted"))
    outputs = (Port("command"), Port("active"), Port("offset"))
    return Step("handover", _hand_over, ("kept", "blended"), (), "", (Port("active"), Port("offset")), inputs, outputs)


def _hand_over(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    # What the one that was active would go on with; one of another loop is known by what it did last.
    wanted, left = inp.commands[0], select(x.active < 0.0, inp.accepted, inp.commands[0] + x.offset)
    for i in range(1, len(inp.commands)):
        wanted = select(inp.active == float(i), inp.commands[i], wanted)
        left = select(x.active == float(i), inp.commands[i] + x.offset, left)
    offset = select(inp.active == x.active, x.offset, par.blended * (left - wanted))
    # A supervisor that gives no number is to end the run, not to leave the axis without a command.
    return (inp.active, par.kept * offset), (wanted + offset + 0.0 * inp.active, inp.active, offset)


def _tell(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    return (), (inp.accepted - select(inp.active == inp.number, inp.offset, 0.0),)


TOLD = Step("told", _tell, (), (), "", (), tuple(map(Port, ("accepted", "active", "offset", "number"))), (Port("accepted"),))
"""What a controller of a number is told to have been accepted of its command."""


def handover_parameters(handover_time: Any, dt: float) -> dict[str, Any]:
    """Return the parameters of the step for a time constant [s]; with zero there is no offset: the command jumps."""
    time = np.asarray(handover_time, dtype=float)
    blended = np.where(time > 0.0, 1.0, 0.0)
    return {"kept": np.exp(-dt / np.where(time > 0.0, time, np.inf)) * blended, "blended": blended}
