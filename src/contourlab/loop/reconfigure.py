"""A controller that takes over from another one while the machine runs.

All of its components are compiled before the run begins. At the sample of the change, between two ticks, its schedule is laid out anew, and
every node that both have (the plants above all, with what is in the delay of the drives) goes on from where it stands; what only the new
one has begins as at rest where the axes are. Commands are handed over without a jump, see `contourlab.loop.supervision`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from contourlab.engine.runner import Group, make_group
from contourlab.engine.schedule import Node
from contourlab.errors import ParameterError
from contourlab.feed import Reference
from contourlab.loop.machine import Controller, Machine
from contourlab.loop.template import Loop, build

__all__ = ["Change", "Prepared", "prepared", "taken_over"]


@dataclass(frozen=True)
class Change:
    """A controller that takes over.

    Attributes
    ----------
    time : float [s], > 0
        When; it is done at the next sample.
    controller : Controller
        For all axes.
    handover_time : float [s], >= 0
        Time constant with which the jump of each command decays; 0 lets it jump. An axis with a supervisor has its own.
    file : str
        Where it was read from.
    """

    time: float
    controller: Controller
    handover_time: float = 0.01
    file: str = ""

    def __post_init__(self) -> None:
        if not (self.time > 0.0 and math.isfinite(self.time)):
            raise ParameterError("time", f"{self.time:g}", "> 0 and finite", "s")
        if not (self.handover_time >= 0.0 and math.isfinite(self.handover_time)):
            raise ParameterError("handover_time", f"{self.handover_time:g}", ">= 0 and finite", "s")

    def sample(self, servo_period: float) -> int:
        """Return the first sample of the controller."""
        return math.ceil(self.time / servo_period - 1e-9)


@dataclass(frozen=True)
class Prepared:
    """A change whose components are compiled: at which sample it comes, and the loop as it would stand at the start."""

    change: Change
    sample: int
    loop: Loop


def prepared(changes: Sequence[Change], machine: Machine, reference: Reference, given: Mapping[str, Any], compiled: bool) -> list[Prepared]:
    """Return the changes in their order, compiled; those beyond the end of the reference are left out.

    Parameters
    ----------
    changes, machine, reference
        As of `contourlab.loop.simulate`.
    given : mapping
        Further arguments of `contourlab.loop.template.build`.
    compiled : bool

    Raises
    ------
    ParameterError
        If two come at the same sample, or a controller wants to look ahead where the first one did not.
    """
    found: list[Prepared] = []
    for change in sorted(changes, key=lambda one: one.time):
        sample = change.sample(machine.servo_period)
        if found and found[-1].sample == sample:
            raise ParameterError("changes", f"two at {change.time:g} s", "one for each sample")
        if sample < reference.n_sample:
            first = reference.block(0, 1).position[0]
            loop = build(machine, change.controller, reference.path, first, handover_time=change.handover_time, **given)
            make_group(loop.schedule, 1, slice(0, 1), compiled)
            found.append(Prepared(change, sample, loop))
    return found


def taken_over(
    due: Prepared, machine: Machine, reference: Reference, given: Mapping[str, Any], running: Group, compiled: bool
) -> tuple[Loop, Group]:
    """Return loop and memory of a controller that takes over from what is running."""
    places = np.array([running.signals[running.schedule.row(f"{name}.plant.position"), 0] for name in machine.axis_names])
    progress = float(reference.block(due.sample, due.sample + 1).arc_length[0])
    loop = build(machine, due.change.controller, reference.path, places, progress, handover_time=due.change.handover_time, **given)
    group = make_group(loop.schedule, 1, slice(0, 1), compiled)
    known = {node.name: j for j, node in enumerate(running.schedule.nodes)}
    for i, node in enumerate(loop.schedule.nodes):
        j = known.get(node.name, -1)
        if j >= 0 and len(running.rings[j]) == len(group.rings[i]) and _goes_on(running.schedule.nodes[j], node):
            group.state[i][:] = running.state[j]
            group.rings[i][:] = running.rings[j]
            rows = sum(port.rows for port in node.step.outputs)
            to, off = loop.schedule.first_row[i], running.schedule.first_row[j]
            group.signals[to : to + rows] = running.signals[off : off + rows]
    group.tick = running.tick
    return loop, group


_OWN = ("controller", "other_", "supervisor", "handover", "observer", "gap_observer", "compensation", "feedforward")


def _goes_on(before: Node, node: Node) -> bool:
    """Tell whether a node takes over what another one remembers; a controller with other gains begins anew: its integral means another."""
    if before.step != node.step:
        return False
    own = node.name.rpartition(".")[2].startswith(_OWN)
    return not own or all(np.array_equal(before.parameters[name], node.parameters[name]) for name in node.parameters)
