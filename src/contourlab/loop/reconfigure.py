"""Replace the controller while the machine runs.

All components are compiled before the run. At the sample of the change a new schedule is built. Every node that both loops have keeps its
state (plants, and drives with their delays); a node that only the new loop has starts at rest, a filter at the last command. A new
controller takes over the states of the old one, with the integral scaled to the same command. The remaining jump of the command is handed
over, see `contourlab.loop.template`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.engine.runner import Group, make_group
from contourlab.engine.schedule import Node
from contourlab.engine.step import record
from contourlab.errors import ParameterError
from contourlab.feed import Reference
from contourlab.loop.machine import Controller, Machine
from contourlab.loop.template import Loop, build
from contourlab.primitives import Clock
from contourlab.units import setting


@dataclass(frozen=True)
class Change:
    """A controller that takes over.

    Attributes
    ----------
    time : float [s], > 0
        Time of the change; it takes effect at the next sample.
    controller : Controller
        For all axes.
    handover_time : float [s], >= 0
        Time constant with which the jump of each command decays; 0 lets it jump. The supervisor of an axis has its own.
    file : str
        File of the controller.

    Raises
    ------
    ParameterError
        If a time is out of range.
    """

    time: float = field(metadata=setting("s", minimum=0.0, exclusive=True, name="at"))
    controller: Controller
    handover_time: float = field(default=0.01, metadata=setting("s", "ms", minimum=0.0))
    file: str = field(default="", metadata=setting(name="controller"))

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
    """A change with compiled components: its sample, and the loop as if built at the start."""

    change: Change
    sample: int
    loop: Loop


def prepared(
    changes: Sequence[Change], machine: Machine, controller: Controller, reference: Reference, given: Mapping[str, Any], compiled: bool
) -> list[Prepared]:
    """Return the changes in order of time, compiled, without those beyond the end of the reference.

    Parameters
    ----------
    changes, machine, controller, reference
        As of `contourlab.loop.simulate`.
    given : mapping
        Further arguments of `contourlab.loop.template.build`.

    Raises
    ------
    ParameterError
        If two changes are at the same sample, or the links of a controller differ from those of the first one.
    """
    in_order: list[Prepared] = []
    for change in sorted(changes, key=lambda one: one.time):
        sample = change.sample(machine.servo_period)
        if in_order and in_order[-1].sample == sample:
            raise ParameterError("changes", f"two at {change.time:g} s", "at most one in each sample")
        for name in machine.axis_names:
            # Messages on their way in a link could not be taken over.
            if name in change.controller.axes and change.controller.axes[name].link != controller.axes[name].link:
                raise ParameterError("changes", f"a new link of axis {name} at {change.time:g} s", "with the link of the first controller")
        if sample < reference.n_sample:
            first = reference.block(0, 1).position[0]
            loop = build(machine, change.controller, reference.path, first, handover_time=change.handover_time, **given)
            make_group(loop.schedule, 1, slice(0, 1), compiled)
            in_order.append(Prepared(change, sample, loop))
    return in_order


def taken_over(
    due: Prepared, machine: Machine, reference: Reference, given: Mapping[str, Any], running: Group, compiled: bool
) -> tuple[Loop, Group]:
    """Return loop and memory of a controller that takes over from the running one."""
    places = np.array([running.signals[running.schedule.row(f"{name}.plant.position"), 0] for name in machine.axis_names])
    progress = float(reference.block(due.sample, due.sample + 1).arc_length[0])
    loop = build(machine, due.change.controller, reference.path, places, progress, handover_time=due.change.handover_time, **given)
    group = make_group(loop.schedule, 1, slice(0, 1), compiled)
    known = {node.name: j for j, node in enumerate(running.schedule.nodes)}
    for i, node in enumerate(loop.schedule.nodes):
        j = known.get(node.name, -1)
        if node.step.name.startswith("filter/"):
            group.state[i][:] = _accepted(running, node.name)  # its states are commands
        if node.step.name == "unfiltered" and j < 0:
            group.signals[loop.schedule.first_row[i]] = _accepted(running, node.name)
        if j < 0:
            continue
        before = running.schedule.nodes[j]
        if before.step == node.step and len(running.rings[j]) == len(group.rings[i]):
            group.state[i][:] = running.state[j]
            group.rings[i][:] = running.rings[j]
            rows = sum(port.rows for port in node.step.outputs)
            to, off = loop.schedule.first_row[i], running.schedule.first_row[j]
            group.signals[to : to + rows] = running.signals[off : off + rows]
        if node.step.name.startswith("controller/") and not _same(before, node):
            _carry(before, running.state[j], node, group.state[i], _accepted(running, node.name))
    group.tick = running.tick
    return loop, group


def _same(before: Node, node: Node) -> bool:
    return before.step == node.step and all(np.array_equal(before.parameters[name], node.parameters[name]) for name in node.parameters)


def _accepted(running: Group, node: str) -> float:
    """Return the last command of a node's axis that the drive accepted, as the controller knows it."""
    axis, known = node.partition(".")[0], running.schedule.row_of
    names = (f"{axis}.unfiltered.accepted", f"{axis}.drive.accepted", f"{axis}.drive.applied")
    return float(running.signals[next(known[name] for name in names if name in known), 0])


def _carry(before: Node, old: Array, node: Node, new: Array, accepted: float) -> None:
    """Copy the states that two controllers share by name; scale the integral to give the same command."""
    rows = {port.name: row for row, port in enumerate(before.step.states) if not port.size}
    for row, port in enumerate(node.step.states):
        if port.name == "last_command":
            new[row] = accepted
        elif port.name == "integral" and port.name in rows:
            worth, own = _worth(before), _worth(node)
            new[row] = old[rows[port.name]] * worth / own if own else 0.0
        elif port.name in rows and not port.size:
            new[row] = old[rows[port.name]]


def _worth(node: Node) -> float:
    """Return the command per unit of a controller's integral."""
    step = node.step
    if step.tables or step.ring or any(port.size for port in (*step.states, *step.inputs)):
        return 0.0
    par = step.par_type(**{name: float(np.ravel(node.parameters[name])[0]) for name in step.parameters})
    state, inputs = (record(tuple(port.name for port in ports)) for ports in (step.states, step.inputs))
    at_rest = state(*(0.0 for _ in step.states))
    nothing, clock = inputs(*(0.0 for _ in step.inputs)), Clock(0.0, 0.0, 1e-9)
    wound = at_rest._replace(integral=NUDGE) if "integral" in at_rest._fields else at_rest
    given = [step.function(par, x, nothing, clock)[1][0] for x in (at_rest, wound)]
    return float(given[1] - given[0]) / NUDGE


NUDGE = 1e-9
"""Perturbation of an integral: small enough not to reach a limit."""
