"""A group whose ticks run as one fused loop."""

from __future__ import annotations

import numpy as np

from contourlab.engine.fused import tick_loop_of
from contourlab.engine.runner import Group
from contourlab.engine.schedule import Schedule
from contourlab.engine.translate.tick_graph import Rows


class FusedGroup(Group):
    def __init__(self, schedule: Schedule, width: int, lanes: slice) -> None:
        super().__init__(schedule, width, lanes)
        self._tables = [np.ascontiguousarray(node.tables[name], dtype=float) for node in schedule.nodes for name in node.step.tables]
        self._addresses = np.array([table.ctypes.data for table in self._tables], dtype=np.int64)
        n, first = len(schedule.nodes), self.borders
        lengths = tuple(len(ring) for ring in self.rings)
        self._places = Rows(tuple(first[1 : n + 1]), tuple(first[n + 1 : 2 * n + 1]), tuple(first[2 * n + 2 : 3 * n + 2]), lengths)

    def run(self, external: np.ndarray, log_rows: list[int], out: np.ndarray | None = None) -> np.ndarray:
        external = np.asarray(external, dtype=float)
        strides = [stride // external.itemsize for stride in external.strides]
        log = np.empty((len(external), len(log_rows), self.width)) if out is None else out
        loop = tick_loop_of(self.schedule, self._places, log_rows, self.width)
        data = [array.ctypes.data for array in (self.memory, self._addresses, external)]
        loop(*data, *strides, log.ctypes.data, self.tick, len(external), self.schedule.period, 0)
        self.tick += len(external)
        return log
