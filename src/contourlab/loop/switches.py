"""Every switch from one controller of an axis to another: when, where and why.

Derived from the signals ``active_controller`` and ``switch_reason`` and from the names of controllers and reasons. No samples are kept: a
run of any length can be followed block by block.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.feed import Reference
from contourlab.loop.machine import AxisController, Controller
from contourlab.loop.reconfigure import Change
from contourlab.result import Result

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
    return log.add(result) if log.concerns(result) else None


@dataclass
class SwitchLog:
    """Follow a run block by block: keep the active controllers, and count switches.

    Attributes
    ----------
    counts : Counter of SwitchKind
        Of all blocks so far.
    """

    controller: Controller
    servo_period: float
    reference: Reference | None = None
    changes: Sequence[Change] = ()
    counts: Counter[SwitchKind] = field(default_factory=Counter)
    _active: dict[str, str] = field(default_factory=dict)
    _numbers: dict[str, int] = field(default_factory=dict)

    @property
    def led(self) -> bool:
        """Whether any axis has a supervisor, so that the signals `RECORDED` exist."""
        return any(any(axis.supervisor is not None for axis in one.axes.values()) for one in self._controllers)

    @property
    def _controllers(self) -> list[Controller]:
        return [self.controller, *(change.controller for change in self.changes)]

    def concerns(self, result: Result) -> bool:
        """Return whether a result can have switches."""
        return bool(self.changes) or "active_controller" in result

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
        made = Switches(tuple(active), result.servo_period, tuple(kinds), kind, sample + result.start, along, line, active, first)
        self.counts.update(made.counts())
        return made

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
