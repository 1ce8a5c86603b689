"""The watch: a step that notes when an axis first leaves its following-error limit, or a command stops being finite.

It runs with the loop, so that the sample is exact in every lane and no signal has to be kept for it.
"""

from __future__ import annotations

from functools import cache
from typing import Any

from contourlab.engine.runner import Group
from contourlab.engine.schedule import Late, Node
from contourlab.engine.step import Port, Step
from contourlab.loop.machine import Machine
from contourlab.primitives import fabs, select
from contourlab.result import Status

NAME = "watch"
_STATES = (Port("first"), Port("axis"), Port("gap"))

_AXIS = """
    gap = fabs(inp.reference[{i}] - inp.position[{i}])
    # A number that is not finite fails both comparisons.
    sound = select(gap <= par.limit_{i}, select(inp.command[{i}] - inp.command[{i}] == 0.0, 1.0, 0.0), 0.0)
    fresh = select(x_first < 0.0, 1.0 - sound, 0.0) > 0.5
    x_first, x_axis, x_gap = select(fresh, clock.k, x_first), select(fresh, {i}.0, x_axis), select(fresh, gap, x_gap)
"""


@cache
def _step(n_axis: int) -> Step:
    body = "".join(_AXIS.format(i=i) for i in range(n_axis))
    source = f"def step(par, x, inp, clock):\n    x_first, x_axis, x_gap = x{body}    return (x_first, x_axis, x_gap), ()\n"
    scope: dict[str, Any] = {"__name__": __name__, "fabs": fabs, "select": select}
    exec(source, scope)
    inputs = tuple(Port(name, n_axis) for name in ("reference", "position", "command"))
    return Step(NAME, scope["step"], tuple(f"limit_{i}" for i in range(n_axis)), (), "", _STATES, inputs, ())


def watch_node(machine: Machine, commands: tuple[str, ...]) -> Node:
    """Return the node that watches a machine and the commands of its axes; it stands behind the drives."""
    wires: dict[str, Any] = {
        "reference": "in.reference",
        "position": tuple(Late(f"{name}.plant.position") for name in machine.axis_names),
        "command": commands,
    }
    limits = {f"limit_{i}": axis.limits.following_error for i, axis in enumerate(machine.axes)}
    return Node(NAME, _step(len(machine.axes)), wires, limits, initial={"first": -1.0, "axis": -1.0})


def watched(group: Group, machine: Machine, lane: int = 0) -> Status:
    """Return what the watch has noted in one lane."""
    first, axis, gap = (float(value) for value in group.state_of(NAME)[:, lane])
    if first < 0.0:
        return Status(ok=True)
    limit = machine.axes[int(axis)].limits.following_error
    reason = "the loop gave a number that is not finite"
    if limit < gap < float("inf"):
        reason = f"following error {gap * 1e3:.4g} mm passes the limit of {limit * 1e3:.4g} mm"
    return Status(ok=False, sample=int(first), axis=machine.axis_names[int(axis)], reason=reason)
