"""The schedule in plain Python: the steps as they are written, no compiler. Slow, and the oracle of the compiled engine."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from contourlab.engine.runner import Group
from contourlab.engine.schedule import Schedule
from contourlab.engine.step import Bank, pack, record, rows, unpack
from contourlab.primitives import Clock

Array = NDArray[np.float64]


class _PastOf:
    """A lane's column of a ring, in the form that `primitives.delayed` reads."""

    def __init__(self, column: Array) -> None:
        self.values = column


class InterpretedGroup(Group):
    """A group whose steps run in plain Python, lane by lane."""

    def __init__(self, schedule: Schedule, width: int, lanes: slice) -> None:
        super().__init__(schedule, width, lanes)
        self._sources = schedule.sources
        self._first = schedule.first_row
        steps = [node.step for node in schedule.nodes]
        self._types = [tuple(record(tuple(p.name for p in ports)) for ports in (s.own_states, s.inputs)) for s in steps]
        self.refresh()

    def refresh(self) -> None:
        self._par = [[self._par_of(n, i) for i in range(self.width)] for n in range(len(self.schedule.nodes))]

    def _par_of(self, n: int, lane: int) -> tuple[object, ...]:
        node = self.schedule.nodes[n]
        values: list[object] = [float(v) for v in self.parameters[n][:, lane]]
        values += [np.ravel(node.tables[name]).tolist() for name in node.step.tables]
        if node.step.ring:
            values.append(_PastOf(self.rings[n][:, lane]))
        return node.step.par_type(*values)  # type: ignore[no-any-return]

    def run(self, external: Array, log_rows: list[int], out: Array | None = None) -> Array:
        log = np.empty((len(external), len(log_rows), self.width)) if out is None else out
        for step, fed in enumerate(np.asarray(external, dtype=float)):
            self.signals[: len(fed)] = fed[:, None]
            for n in range(len(self.schedule.nodes) + 1):
                if n == self.schedule.record_point:
                    log[step] = self.signals[log_rows]
                if n < len(self.schedule.nodes):
                    self._run_node(n)
            self.tick += 1
        return log

    def _run_node(self, n: int) -> None:
        node = self.schedule.nodes[n]
        if (self.tick - node.phase) % node.every:
            return
        held = self.schedule.period * node.every / node.repeat
        for r in range(node.repeat):
            clock = Clock(float(self.tick), self.tick * self.schedule.period + r * held, held)
            for lane in range(self.width):
                self._run_lane(n, lane, clock)

    def _run_lane(self, n: int, lane: int, clock: Clock) -> None:
        step = self.schedule.nodes[n].step
        state_type, input_type = self._types[n]
        taken = [s if isinstance(s, float) else float(self.signals[s, lane]) for s in self._sources[n]]
        inputs = input_type(*unpack(step.inputs, taken))
        if step.ring:
            self.rings[n][int(clock.k) % len(self.rings[n]), lane] = getattr(inputs, step.ring)
        kept = self.state[n][:, lane]
        states, par = state_type(*unpack(step.own_states, kept.tolist())), self._par[n][lane]
        found = (self._run_bank(step.bank, kept[rows(step.own_states) :], par, states, inputs, clock),) if step.bank else ()
        x_next, y = step.function(par, states, inputs, clock, *found)
        own = pack(step.own_states, x_next)
        kept[: len(own)] = own
        first = self._first[n]
        flat = pack(step.outputs, y)
        self.signals[first : first + len(flat), lane] = flat

    @staticmethod
    def _run_bank(bank: Bank, kept: Array, par: object, states: object, inputs: object, clock: Clock) -> tuple[float, ...]:
        """Advance the members in their part of the states, and return what the last one found."""
        found = (0.0,) * bank.n_found
        for i, member in enumerate(kept.reshape(bank.count, bank.size)):
            member[:], found = bank.function(par, states, tuple(member.tolist()), found, float(i), inputs, clock)
        return found
