"""Runs a schedule: lays out memory for a group of lanes, calls the tick loop block by block, and watches for what runs away."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.engine.schedule import Schedule
from contourlab.engine.step import Port, rows

__all__ = ["Group", "make_group"]

Array = NDArray[np.float64]


class Group:
    """The memory of `width` variants and the tick loop over it.

    Parameters
    ----------
    schedule : Schedule
        What to run.
    width : int
        Lanes: 1, or a multiple of 16.
    lanes : slice
        Which of the variants this group carries; arrays of parameters are cut by it and padded with their last value.
    """

    def __init__(self, schedule: Schedule, width: int, lanes: slice) -> None:
        self.schedule, self.width, self.lanes = schedule, width, lanes
        self.tick = 0
        self.signals = np.zeros((schedule.n_row, width))
        self.parameters, self.state, self.rings = [], [], []
        for node in schedule.nodes:
            step = node.step
            block = np.empty((len(step.parameters), width))
            for i, name in enumerate(step.parameters):
                block[i] = self._lane_values(node.parameters[name])
            self.parameters.append(block)
            self.state.append(self._fill(step.states, node.initial))
            length = 1 << max(node.ring_length - 1, 0).bit_length()
            self.rings.append(np.zeros((length, width)) if step.ring else np.zeros((0, width)))
            for port in step.outputs:
                first = schedule.row(f"{node.name}.{port.name}")
                self.signals[first : first + port.rows] = self._fill((port,), node.start)

    def _lane_values(self, value: Any) -> float | Array:
        lanes = np.asarray(value, dtype=float)
        if lanes.ndim == 0:
            return float(lanes)
        part = lanes[self.lanes]
        return np.concatenate([part, np.repeat(part[-1:], self.width - part.size)])

    def _fill(self, ports: tuple[Port, ...], values: Any) -> Array:
        block = np.zeros((rows(ports), self.width))
        row = 0
        for port in ports:
            value = values.get(port.name)
            if value is not None:
                for i, item in enumerate(value if port.size else (value,)):
                    block[row + i] = self._lane_values(item)
            row += port.rows
        return block

    def snapshot(self) -> tuple[Any, ...]:
        """Return all that changes while ticks run."""
        return (self.tick, self.signals.copy(), [x.copy() for x in self.state], [r.copy() for r in self.rings])

    def restore(self, saved: tuple[Any, ...]) -> None:
        """Go back to a snapshot."""
        self.tick = saved[0]
        self.signals[:] = saved[1]
        for mine, theirs in zip([*self.state, *self.rings], [*saved[2], *saved[3]], strict=True):
            mine[:] = theirs

    def finite(self) -> NDArray[np.bool_]:
        """Tell for each lane whether all its states and signals are finite."""
        good = np.isfinite(self.signals).all(axis=0)
        for x in self.state:
            good &= np.isfinite(x).all(axis=0)
        return np.asarray(good)

    def state_of(self, node: str) -> Array:
        """Return the states of a node (n_state, width): a view that changes as ticks run."""
        return self.state[next(i for i, known in enumerate(self.schedule.nodes) if known.name == node)]

    def first_bad_node(self) -> str:
        """Return the name of the first node that holds a number that is not finite; empty if there is none."""
        for node, x in zip(self.schedule.nodes, self.state, strict=True):
            signals = [
                self.signals[self.schedule.row(f"{node.name}.{port.name}") + i] for port in node.step.outputs for i in range(port.rows)
            ]
            if not (np.isfinite(x).all() and all(np.isfinite(s).all() for s in signals)):
                return node.name
        return ""

    def run(self, external: Array, log_rows: list[int], out: Array | None = None) -> Array:
        """Run one tick per row of `external` (n_tick, n_external); return the log (n_tick, n_log, width), in `out` where it is given."""
        raise NotImplementedError


class CompiledGroup(Group):
    """A group whose steps are machine code."""

    def __init__(self, schedule: Schedule, width: int, lanes: slice) -> None:
        from contourlab.engine.compiler import compile_step
        from contourlab.engine.kernel import NODE_FIELDS, kernel

        super().__init__(schedule, width, lanes)
        self._kernel = kernel(width)
        self._signal_table = self.signals.ctypes.data
        self._kept: list[Any] = []
        self._records = np.zeros((len(schedule.nodes), len(NODE_FIELDS)), dtype=np.int64)
        for n, node in enumerate(schedule.nodes):
            outputs = node.step.outputs
            first = schedule.row(f"{node.name}.{outputs[0].name}") if outputs else 0
            self._records[n] = (
                compile_step(node.step, width),
                self.parameters[n].ctypes.data,
                self._table_words(n).ctypes.data,
                self.state[n].ctypes.data,
                self._input_words(n).ctypes.data,
                self._row_address(first),
                node.every,
                node.phase,
                node.repeat,
            )

    def _row_address(self, row: int) -> int:
        return self._signal_table + 8 * self.width * row

    def _keep(self, array: NDArray[Any]) -> NDArray[Any]:
        self._kept.append(array)
        return array

    def _table_words(self, n: int) -> NDArray[np.int64]:
        node = self.schedule.nodes[n]
        words = [self._keep(np.ascontiguousarray(node.tables[name], dtype=float)).ctypes.data for name in node.step.tables]
        if node.step.ring:
            words += [self.rings[n].ctypes.data, len(self.rings[n]) - 1]
        return self._keep(np.array(words or [0], dtype=np.int64))

    def _input_words(self, n: int) -> NDArray[np.int64]:
        words = []
        for source in self.schedule.sources[n]:
            if isinstance(source, float):
                words.append(self._keep(np.full(self.width, source)).ctypes.data)
            else:
                words.append(self._row_address(source))
        return self._keep(np.array(words or [0], dtype=np.int64))

    def run(self, external: Array, log_rows: list[int], out: Array | None = None) -> Array:
        external = np.ascontiguousarray(external, dtype=float)
        n_tick = len(external)
        log = np.empty((n_tick, len(log_rows), self.width)) if out is None else out
        assert log.flags.c_contiguous  # the tick loop knows no strides
        addresses = np.array([self._row_address(row) for row in log_rows] or [0], dtype=np.int64)
        self._kernel(
            self._records.ctypes.data,
            len(self._records),
            self.schedule.record_point,
            external.ctypes.data,
            external.shape[1],
            self._signal_table,
            log.ctypes.data,
            addresses.ctypes.data,
            len(log_rows),
            self.tick,
            n_tick,
            self.schedule.period,
        )
        self.tick += n_tick
        return log


def make_group(schedule: Schedule, width: int, lanes: slice, jit: bool) -> Group:
    """Return a group of lanes, compiled or in plain Python."""
    if jit:
        return CompiledGroup(schedule, width, lanes)
    from contourlab.engine.interpreter import InterpretedGroup

    return InterpretedGroup(schedule, width, lanes)
