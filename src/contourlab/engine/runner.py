"""Run a schedule over a group of lanes: in machine code, or in plain Python, the slow oracle of the compiled engine."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from itertools import accumulate, pairwise, product
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Flags, Index, aligned
from contourlab.engine.gpu import Gpu
from contourlab.engine.step import Bank, Node, Schedule, pack, record, rows, unpack
from contourlab.engine.translate.maths import LANES, SINGLE
from contourlab.engine.translate.step_graph import Rows
from contourlab.engine.translate.tick_loop import VECTOR
from contourlab.errors import EngineError
from contourlab.primitives import Clock

CALL = 0.2
"""Time [s] of one call of a GPU: a GPU with a screen stops calls of a few seconds."""
FIRST = 64
"""Ticks of the first call."""
LOGGED = 1 << 25
"""Most numbers that a call of a GPU records."""
_NUMBER = (float, int)


class Group:
    """The memory of `width` variants and the tick loop over it.

    One array holds, row by row, the signals, states, parameters and rings of all nodes. It is aligned to cache lines, and everything that
    changes is copied in one piece.

    Parameters
    ----------
    schedule : Schedule
        What to run.
    width : int
        Lanes: 1, or a multiple of 16.
    lanes : slice or ndarray of int
        The variants in this group; parameter arrays are cut to it and padded with their last value.
    """

    def __init__(self, schedule: Schedule, width: int, lanes: slice | Index) -> None:
        self.schedule, self.width, self.lanes = schedule, width, lanes
        self.tick = 0
        self.loops: dict[tuple[int, ...], Any] = {}  # machine code by the rows that it records
        same, own = schedule.begin
        sizes, n = memory_rows(schedule), len(schedule.nodes)
        self._n_live = sum(sizes[: n + 1])
        self.memory = aligned((sum(sizes), width))
        self.memory[: len(same)], self.memory[len(same) :] = same[:, None], 0.0
        for row, value in own.items():
            self.memory[row] = self._in_lanes(value)
        first = tuple(accumulate(sizes, initial=0))
        parts = [self.memory[a:b] for a, b in pairwise(first)]
        self.signals, self.state, self.parameters, self.rings = parts[0], parts[1 : n + 1], parts[n + 1 : 2 * n + 1], parts[2 * n + 1 :]
        self.places = Rows(first[1 : n + 1], first[n + 1 : 2 * n + 1], first[2 * n + 1 :], tuple(map(len, self.rings)))

    def _in_lanes(self, value: ArrayLike) -> Array:
        """Return a value of each lane, from one for each variant or one for all."""
        part = np.asarray(value, dtype=float)
        part = part[self.lanes] if part.ndim else part[None]
        return np.concatenate([part, np.repeat(part[-1:], self.width - part.size)])

    def take(self, nodes: Sequence[Node]) -> None:
        """Take the parameters of nodes that differ from those of the schedule in values only."""
        for values, node in zip(self.parameters, nodes, strict=True):
            for row, name in zip(values, node.step.parameters, strict=True):
                value = node.parameters[name]
                row[:] = value if isinstance(value, _NUMBER) else self._in_lanes(value)
        self.refresh()

    def snapshot(self) -> tuple[int, Array]:
        """Return everything that changes while ticks run."""
        return self.tick, self.memory.copy()

    def restore(self, saved: tuple[int, Array]) -> None:
        """Go back to a snapshot."""
        self.tick = saved[0]
        self.memory[:] = saved[1]

    def finite(self) -> Flags:
        """Return for each lane whether all its states and signals are finite."""
        return np.asarray(np.isfinite(self.memory[: self._n_live]).all(axis=0))

    def state_of(self, node: str) -> Array:
        """Return the states of a node (n_state, width): a view that changes as ticks run."""
        return self.state[next(i for i, known in enumerate(self.schedule.nodes) if known.name == node)]

    def first_bad_node(self) -> str:
        """Return the name of the first node with a non-finite number; empty if there is none."""
        for n, (node, x) in enumerate(zip(self.schedule.nodes, self.state, strict=True)):
            first = self.schedule.first_row[n]
            if not (np.isfinite(x).all() and np.isfinite(self.signals[first : first + rows(node.step.outputs)]).all()):
                return node.name
        return ""

    def refresh(self) -> None:
        """Apply parameters that were written to `parameters`."""

    def run(self, external: Array, log_rows: list[int], out: Array | None = None) -> Array:
        """Run one tick per row of `external` (n_tick, n_external); return the log (n_tick, n_log, width), in `out` if given."""
        raise NotImplementedError


def memory_rows(schedule: Schedule) -> list[int]:
    """Return the rows of the parts of a group's memory: the signals, then the states, the parameters and the ring of each node."""
    steps = [node.step for node in schedule.nodes]
    rings = [1 << max(node.ring_length - 1, 0).bit_length() if node.step.ring else 0 for node in schedule.nodes]
    return [schedule.n_row, *(step.n_state for step in steps), *(len(step.parameters) for step in steps), *rings]


class CompiledGroup(Group):
    """A group whose whole tick is machine code."""

    def __init__(self, schedule: Schedule, width: int, lanes: slice | Index, like_lanes: bool = False) -> None:
        super().__init__(schedule, width, lanes)
        self._maths = LANES if width > 1 or like_lanes else SINGLE
        self.tables = [np.ascontiguousarray(node.tables[name], dtype=float) for node in schedule.nodes for name in node.step.tables]
        words = [(table.ctypes.data, table.size) for table in self.tables]
        words += [(first, len(ring)) for first, ring in zip(self.places.rings, self.rings, strict=False) if len(ring)]
        self.tables_at = np.array(words, dtype=np.int64).reshape(-1, 2)
        self._data = self.memory.ctypes.data, self.tables_at.ctypes.data

    def restore(self, saved: tuple[int, Array]) -> None:
        super().restore(saved)
        self.loops.clear()  # a value that its steps read may have changed since

    def run(self, external: Array, log_rows: list[int], out: Array | None = None) -> Array:
        external = np.asarray(external, dtype=float)
        log = aligned((len(external), len(log_rows), self.width)) if out is None else out
        of_tick, of_row, _ = log.strides
        # The tick loop stores row after row, and vectors in whole cache lines.
        assert log.dtype == float and (not log.size or log.strides[2] == log.itemsize)
        assert not log.size or (of_tick == len(log_rows) * of_row and (self.width == 1 or (log.ctypes.data | of_row) % 64 == 0))
        strides = [stride // external.itemsize for stride in external.strides]
        data = *self._data, external.ctypes.data, *strides, log.ctypes.data, of_row // log.itemsize
        loop = self._loop(tuple(log_rows))
        for lane in range(0, self.width, VECTOR):
            loop(*data, self.tick, len(external), self.schedule.period, lane)
        self.tick += len(external)
        return log

    def _loop(self, log_rows: tuple[int, ...], gpu: Gpu | None = None) -> Any:
        from contourlab.engine.fused import tick_loop_of

        loop = self.loops.get(log_rows)
        if loop is None:
            loop = self.loops[log_rows] = tick_loop_of(self.schedule, self.places, log_rows, self.width, self._maths, gpu)
        return loop


class _PastOf:
    """A lane's column of a ring, in the form that `primitives.delayed` reads: it gives Python's floats."""

    def __init__(self, column: Array) -> None:
        self.values = column.data


class InterpretedGroup(Group):
    """A group whose steps run in plain Python, lane by lane."""

    def __init__(self, schedule: Schedule, width: int, lanes: slice | Index) -> None:
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
        held = self.schedule.period / node.repeat
        for r, lane in product(range(node.repeat), range(self.width)):
            self._run_lane(n, lane, Clock(float(self.tick), self.tick * self.schedule.period + r * held, held))

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
        own, flat, first = pack(step.own_states, x_next), pack(step.outputs, y), self._first[n]
        kept[: len(own)], self.signals[first : first + len(flat), lane] = own, flat

    @staticmethod
    def _run_bank(bank: Bank, kept: Array, par: object, states: object, inputs: object, clock: Clock) -> tuple[float, ...]:
        """Advance the members in their part of the states, and return what the last member found."""
        found = (0.0,) * bank.n_found
        for i, member in enumerate(kept.reshape(bank.count, bank.size)):
            member[:], found = bank.function(par, states, tuple(member.tolist()), found, float(i), inputs, clock)
        return found


class GpuGroup(CompiledGroup):
    """A group whose lanes are threads of a GPU; its memory here has states and signals after each run."""

    def __init__(self, schedule: Schedule, width: int, lanes: slice | Index, gpu: Gpu) -> None:
        super().__init__(schedule, width, lanes)
        self._gpu = gpu
        gpu.use()
        self._rows, *self._table_memory = (gpu.memory(array.size) for array in (self.memory, *self.tables))
        for memory, values in zip((self._rows, *self._table_memory), (self.memory, *self.tables), strict=True):
            memory.write(values)
        self.tables_at[: len(self.tables), 0] = [memory.address for memory in self._table_memory]
        self._table_list = gpu.memory(self.tables_at.size)
        self._table_list.write(self.tables_at)

    def run(self, external: Array, log_rows: list[int], out: Array | None = None) -> Array:
        gpu, external = self._gpu, np.ascontiguousarray(external, dtype=float)
        log = np.empty((len(external), len(log_rows), self.width)) if out is None else out
        gpu.use()
        function, entry = self._loop(tuple(log_rows), gpu), len(log_rows) * self.width
        most = max(min(LOGGED // max(entry, 1), len(external)), 1)
        fed, logged = gpu.memory(external.size), gpu.memory(most * entry)
        fed.write(external)
        k, ticks = 0, min(FIRST, most)
        while k < len(external):
            part, began = log[k : k + ticks], perf_counter()
            of_tick = fed.address + k * external.strides[0]
            places = (self._rows.address, self._table_list.address, of_tick, external.shape[1], 1, logged.address, self.width)
            words = map(ctypes.c_int64, (*places, self.tick, len(part)))
            gpu.run(function, self.width, [*words, ctypes.c_double(self.schedule.period)])
            if part.size:
                logged.read(seen := np.empty(part.shape))
                part[:] = seen
            self.tick, k = self.tick + len(part), k + len(part)
            ticks = max(min(2 * ticks, int(ticks * CALL / (perf_counter() - began)), most), 1)
        self._rows.read(self.memory[: self._n_live])
        return log

    def refresh(self) -> None:
        raise EngineError("a group on a GPU runs with the parameters that it has")

    def restore(self, saved: tuple[int, Array]) -> None:
        raise EngineError("a group on a GPU does not go back")


def make_group(schedule: Schedule, width: int, lanes: slice | Index, jit: bool, gpu: Gpu | None = None) -> Group:
    """Return a group of lanes, compiled or in plain Python, or on a GPU."""
    if gpu is not None:
        return GpuGroup(schedule, width, lanes, gpu)
    return (CompiledGroup if jit else InterpretedGroup)(schedule, width, lanes)


ALONE = 2
"""Most variants that are left over from whole lanes and run each alone: that is quicker than lanes that are mostly empty."""


def groups_of(schedule: Schedule, variants: Index, jit: bool) -> list[Group]:
    """Return groups of 16 lanes for variants (n,) in order, with the numbers of lanes; those that are left over may run alone."""
    if not jit:
        return [InterpretedGroup(schedule, variants.size, variants)]
    left = variants.size % VECTOR
    left = left if left <= ALONE else 0
    full, single = np.split(variants, [variants.size - left])
    groups: list[Group] = [CompiledGroup(schedule, VECTOR, full[i : i + VECTOR]) for i in range(0, full.size, VECTOR)]
    for group in groups[1:]:
        group.loops = groups[0].loops  # looked up once
    return groups + [CompiledGroup(schedule, 1, single[i : i + 1], like_lanes=True) for i in range(left)]
