"""Reduce the commands of a loop to figures while the lanes run, without storing signals."""

from __future__ import annotations

from functools import cache
from typing import Any

from contourlab.engine.step import Port, Step
from contourlab.primitives import fabs, maximum, select

EFFORT_SUMS = ("count", "sum_square", "largest", "limited")
"""States of the step, in order."""

_AXIS = """
    command, accepted = inp.command[{i}] * par.rate_{i}, inp.accepted[{i}] * par.rate_{i}
    square = square + accepted * accepted
    largest = maximum(largest, fabs(command))
    limited = select(fabs(command - accepted) > 0.0, 1.0, limited)
"""


@cache
def effort_step(n_axis: int) -> Step:
    """Return the step that sums up commands.

    Parameters of the node: ``rate_0``, ``rate_1`` ..., a factor on the command of each axis (one over the limit of its drive, or 1), and
    ``first`` and ``last``, the evaluated ticks (inclusive).

    Notes
    -----
    ``sum_square`` adds the squares of the commands that the drives accepted, ``largest`` is the largest command to any drive, ``limited``
    counts the ticks at which any drive was saturated.
    """
    body = "".join(_AXIS.format(i=i) for i in range(n_axis))
    source = (
        "def step(par, x, inp, clock):\n    square, largest, limited = 0.0, 0.0, 0.0" + body + "\n"
        "    counts = select(clock.k >= par.first, select(clock.k <= par.last, 1.0, 0.0), 0.0)\n"
        "    return (x.count + counts, x.sum_square + counts * square, maximum(x.largest, counts * largest),\n"
        "            x.limited + counts * limited), ()\n"
    )
    scope: dict[str, Any] = {"__name__": __name__, "fabs": fabs, "maximum": maximum, "select": select}
    exec(source, scope)
    parameters = (*(f"rate_{i}" for i in range(n_axis)), "first", "last")
    inputs = (Port("command", n_axis), Port("accepted", n_axis))
    return Step("effort", scope["step"], parameters, (), "", tuple(Port(name) for name in EFFORT_SUMS), inputs, ())
