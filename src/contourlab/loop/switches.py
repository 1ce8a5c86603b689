"""Replace the controller while the machine runs; find every switch from one controller of an axis to another: when, where and why.

All components are compiled before the run. At the sample of the change a new schedule is built. Every node that both loops have keeps its
state (plants, and drives with their delays); a node that only the new loop has starts at rest, a filter at the last command. A new
controller takes over the states of the old one, with the integral scaled to the same command. The remaining jump of the command is handed
over, see `contourlab.loop.template`.

The switches are derived from the signals ``active_controller`` and ``switch_reason`` and from the names of controllers and reasons. No
samples are kept: a run of any length can be followed block by block.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.engine.runner import Group, make_group
from contourlab.engine.step import Node, record
from contourlab.errors import ParameterError, refuse
from contourlab.feed import Reference
from contourlab.loop.machine import AxisController, Controller, Machine
from contourlab.loop.template import Wiring, build
from contourlab.primitives import Clock
from contourlab.result import Result
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
        refuse(not (self.time > 0.0 and math.isfinite(self.time)), ParameterError, "time", f"{self.time:g}", "> 0 and finite", "s")
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
    loop: Wiring


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
        for coupling in (controller.coupling, change.controller.coupling):
            if coupling is not None and coupling.gives("rate") and not reference.decided:
                raise ParameterError("changes", f'with the coupling "{coupling.kind}"', "with couplings without the output rate")
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
) -> tuple[Wiring, Group]:
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


RECORDED = ("active_controller", "switch_reason")
"""Signals of the supervisors."""
_MOST = 1 << 15  # numbers of controllers and reasons are below this


@dataclass(frozen=True, slots=True)
class SwitchKind:
    """A kind of switch: axis, names of the two controllers, reason."""

    axis: str
    before: str
    after: str
    reason: str


@dataclass(frozen=True, slots=True)
class Switch:
    """One switch: time [s], sample, axis, controllers before and after, reason, arc length [m], program line (0 if none)."""

    time: float
    sample: int
    axis: str
    before: str = field(metadata={"json": "from"})
    after: str = field(metadata={"json": "to"})
    reason: str
    arc_length: float
    line: int


@dataclass(frozen=True, eq=False)
class Switches:
    """The switches of a run, or of a part of it, in order of time.

    Attributes
    ----------
    axes : tuple of str
        Axes that have a supervisor, or whose controller is changed.
    servo_period : float [s]
    kind : ndarray (n,) of int
        Of each switch: an index into `kinds`.
    sample : ndarray (n,) of int
        Of the run; the new controller's command is that of this sample.
    arc_length : ndarray (n,) [m]
        Of the reference; NaN if it was not kept.
    line : ndarray (n,) of int
        Of the part program, from 1; 0 without a program.
    active : mapping of str to mapping of str to int
        By axis and name of controller: samples for which it was active.
    first : mapping of str to str
        By axis: the controller that was active before the first switch.
    """

    axes: tuple[str, ...]
    servo_period: float
    kinds: tuple[SwitchKind, ...]
    kind: Index
    sample: Index
    arc_length: Array
    line: Index
    active: dict[str, dict[str, int]]
    first: dict[str, str]

    def __len__(self) -> int:
        return len(self.sample)

    @property
    def time(self) -> Array:
        """Time of each switch [s]."""
        return np.asarray(self.sample * self.servo_period)

    def counts(self) -> dict[SwitchKind, int]:
        """Return the number of switches of each kind, the most frequent first."""
        counted = np.bincount(self.kind, minlength=len(self.kinds))
        return dict(Counter({kind: int(n) for kind, n in zip(self.kinds, counted, strict=True) if n}).most_common())

    def rows(self, most: int | None = None) -> Iterator[Switch]:
        """Yield the switches one by one, at most so many."""
        columns = (self.time, self.sample, self.kind, self.arc_length, self.line)
        for time, sample, number, along, line in zip(*(column[:most].tolist() for column in columns), strict=True):
            kind = self.kinds[number]
            yield Switch(time, sample, kind.axis, kind.before, kind.after, kind.reason, along, line)

    def of(self, axis: str) -> Index:
        """Return the numbers of the switches of one axis."""
        chosen = np.array([kind.axis == axis for kind in self.kinds], dtype=bool)
        return np.flatnonzero(chosen[self.kind]) if len(self.kinds) else np.zeros(0, dtype=np.int64)


def switches_of(
    result: Result, controller: Controller, reference: Reference | None = None, changes: Sequence[Change] = ()
) -> Switches | None:
    """Return the switches of a run; None if no axis has a supervisor and no controller takes over.

    Parameters
    ----------
    result : Result
        With the signals `RECORDED`, and ``arc_length`` for the positions. If it begins later than the run, its first sample gives the
        controller active before.
    reference : Reference, optional
        Gives the program line of each switch.
    changes : sequence of Change
        Controllers that took over during the run.
    """
    log = SwitchLog(controller, result.servo_period, reference, changes)
    return log.add(result) if changes or "active_controller" in result else None


@dataclass
class SwitchLog:
    """Follow a run block by block: keep the active controllers."""

    controller: Controller
    servo_period: float
    reference: Reference | None = None
    changes: Sequence[Change] = ()
    _active: dict[str, str] = field(default_factory=dict)
    _numbers: dict[str, int] = field(default_factory=dict)

    @property
    def led(self) -> bool:
        """Whether any axis has a supervisor, so that the signals `RECORDED` exist."""
        return any(any(axis.supervisor is not None for axis in one.axes.values()) for one in self._controllers)

    @property
    def _controllers(self) -> list[Controller]:
        return [self.controller, *(change.controller for change in self.changes)]

    def add(self, result: Result) -> Switches:
        """Return the switches of the next block."""
        parts: list[tuple[Index, Index, Index]] = []
        kinds: dict[SwitchKind, int] = {}
        active: dict[str, dict[str, int]] = {}
        first: dict[str, str] = {}
        for axis in self._axes(result):
            held: Counter[str] = Counter()
            for start, stop, names, why in self._stretches(result, axis):
                part = self._stretch(result, axis, (start, stop), (names, why), held, kinds)
                first.setdefault(axis, part[2])
                parts.append((*part[:2], np.full(len(part[0]), result.axes.index(axis))))
            active[axis] = dict(held)
        sample, kind, column = (np.concatenate([f[i] for f in parts] or [np.zeros(0, dtype=np.int64)]) for i in range(3))
        order = np.lexsort((column, sample))
        sample, kind = sample[order], kind[order]
        along = result["arc_length"][sample] if "arc_length" in result else np.full(len(sample), np.nan)
        line = np.zeros(len(sample), dtype=np.int64)
        if self.reference is not None and len(sample) and np.isfinite(along).all():
            line = self.reference.source_line(along)
        return Switches(tuple(active), result.servo_period, tuple(kinds), kind, sample + result.start, along, line, active, first)

    def _axes(self, result: Result) -> list[str]:
        led = (name for name in result.axes if any(one.axes[name].supervisor is not None for one in self._controllers))
        return list(result.axes if self.changes else led)

    def _stretches(self, result: Result, axis: str) -> list[tuple[int, int, _Labels, str]]:
        """Return the stretches of a block with one set of controllers: samples, names, and the reason of the take-over."""
        edges = [(0, _Labels(self.controller.axes[axis], ""), "")]
        for change in sorted(self.changes, key=lambda one: one.time):
            sample = change.sample(self.servo_period)
            label = Path(change.file).stem or f"from {change.time:g} s"
            why = f"the controller of {change.file or 'a change'} takes over"
            edges.append((sample, _Labels(change.controller.axes[axis], label), why))
        ends = [sample for sample, _, _ in edges[1:]] + [result.start + result.n_sample]
        stretches = []
        for (begin, names, why), end in zip(edges, ends, strict=True):
            low, high = max(begin - result.start, 0), min(end - result.start, result.n_sample)
            if low < high:
                stretches.append((low, high, names, why if begin - result.start == low and why else ""))
        return stretches

    def _stretch(
        self, result: Result, axis: str, span: tuple[int, int], label: tuple[_Labels, str], held: Counter[str], kinds: dict[SwitchKind, int]
    ) -> tuple[Index, Index, str]:
        """Return samples and kinds of the switches within a stretch, and the controller active before it."""
        (start, stop), (names, why) = span, label
        number, reason = _numbers(result, axis, start, stop)
        times = np.bincount(number)
        held.update({names.controller(int(n)): int(times[n]) for n in np.flatnonzero(times)})
        # A whole run starts with number 0; for a part of a run the controller before is unknown.
        begins = axis not in self._active
        last = (0 if result.start == 0 else int(number[0])) if begins else self._numbers[axis]
        before = names.controller(last) if begins else self._active[axis]
        where = np.flatnonzero(np.diff(number, prepend=number[0] if why else last))
        earlier = np.where(where > 0, number[where - 1], last)
        codes, inverse = np.unique((earlier * _MOST + number[where]) * _MOST + reason[where], return_inverse=True)
        made = []
        for code in codes:
            one, other, because = int(code) // _MOST**2, int(code) // _MOST % _MOST, int(code) % _MOST
            kind = SwitchKind(axis, names.controller(one), names.controller(other), names.reason(because, other))
            made.append(kinds.setdefault(kind, len(kinds)))
        sample, kind_of = where + start, np.array(made, dtype=np.int64)[inverse]
        if why:
            taking = SwitchKind(axis, before, names.controller(int(number[0])), why)
            sample, kind_of = np.append(start, sample), np.append(kinds.setdefault(taking, len(kinds)), kind_of)
        self._active[axis], self._numbers[axis] = names.controller(int(number[-1])), int(number[-1])
        return sample, kind_of, before


class _Labels:
    """Names of the controllers of an axis and of its supervisor's reasons."""

    def __init__(self, parts: AxisController, label: str) -> None:
        self.names, self.label = tuple(parts.controllers), label
        self.reasons: tuple[str, ...] = getattr(parts.supervisor, "reasons", ())

    def controller(self, number: int) -> str:
        name = self.names[number] if 0 <= number < len(self.names) else f"number {number}"
        return name if not self.label else f"{self.label}: {name}" if len(self.names) > 1 else self.label

    def reason(self, number: int, after: int) -> str:
        if not 1 <= number <= len(self.reasons):
            return "no reason given"
        return self.reasons[number - 1].replace("{name}", self.controller(after))


def _numbers(result: Result, axis: str, start: int, stop: int) -> tuple[Index, Index]:
    """Return active controller and reason as whole numbers; a sample without one (the last of a failed run) keeps the one before."""
    if "active_controller" not in result:
        return np.zeros(stop - start, dtype=np.int64), np.zeros(stop - start, dtype=np.int64)
    column = result.axes.index(axis)
    active = result["active_controller"][start:stop, column]
    known = np.isfinite(active)
    if not known.all():
        active = np.nan_to_num(active[np.maximum.accumulate(np.where(known, np.arange(len(active)), 0))])
    reason = result["switch_reason"][start:stop, column] if "switch_reason" in result else np.zeros(stop - start)
    return np.clip(active, 0, _MOST - 1).astype(np.int64), np.clip(np.nan_to_num(reason), 0, _MOST - 1).astype(np.int64)
