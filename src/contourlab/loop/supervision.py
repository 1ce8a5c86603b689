"""Several controllers for one axis: a supervisor chooses the active one, and commands are handed over without a bump.

All controllers run all the time, on the same measurements. Each gets an accepted command. For the active one it is the accepted part of its
own command, minus the hand-over offset. For the others it is the executed command, so that their integrals follow it. This needs
back-calculation: a controller with `anti_windup` "hold" runs with "back-calculation" here. The remaining difference at a switch becomes an
offset, which decays with the supervisor's `handover_time`.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from contourlab.components.contract import Component
from contourlab.engine.step import Port, Step, ports
from contourlab.primitives import select


def conditioned(part: Component) -> Component:
    """Return a controller that can run in parallel with others: with back-calculation, since a held integral would not follow."""
    if "anti_windup" not in part.parameters or part.values()["anti_windup"] != "hold":
        return part
    if "back-calculation" not in part.parameters["anti_windup"].choices:
        return part
    tracking: Component = part.replace(anti_windup="back-calculation")
    return tracking


@cache
def handover_step(n: int) -> Step:
    """Return the step that passes on the active one of `n` commands."""
    inputs = (Port("commands", n), Port("active"), Port("accepted"))
    outputs = (Port("command"), Port("active"), Port("offset"))
    return Step("handover", _hand_over, ("kept", "blended"), (), "", (Port("active"), Port("offset")), inputs, outputs)


def _hand_over(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    # The next command of the previous controller; for one of another loop its last command.
    wanted, left = inp.commands[0], select(x.active < 0.0, inp.accepted, inp.commands[0] + x.offset)
    for i in range(1, len(inp.commands)):
        wanted = select(inp.active == float(i), inp.commands[i], wanted)
        left = select(x.active == float(i), inp.commands[i] + x.offset, left)
    offset = select(inp.active == x.active, x.offset, par.blended * (left - wanted))
    # A non-finite output of a supervisor must end the run, not leave the axis without a command.
    return (inp.active, par.kept * offset), (wanted + offset + 0.0 * inp.active, inp.active, offset)


def _accept(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    return (), (inp.accepted - select(inp.active == inp.number, inp.offset, 0.0),)


ACCEPTED = Step("told", _accept, (), (), "", (), ports("accepted", "active", "offset", "number"), ports("accepted"))
"""Accepted part of the command of the controller with this number."""


def handover_parameters(handover_time: Any, dt: float) -> dict[str, Any]:
    """Return the parameters of the step for a time constant [s]; with zero the command jumps."""
    time = np.asarray(handover_time, dtype=float)
    blended = np.where(time > 0.0, 1.0, 0.0)
    return {"kept": np.exp(-dt / np.where(time > 0.0, time, np.inf)) * blended, "blended": blended}
