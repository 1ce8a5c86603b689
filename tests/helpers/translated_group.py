"""A group whose steps run as translated code, one node and one tick at a time: to compare with plain Python bit for bit."""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.engine.runner import InterpretedGroup
from contourlab.engine.step import Schedule, Step, rows
from contourlab.engine.translate import c99, llvm_ir
from contourlab.engine.translate.step_graph import StepGraph, graph_of, ring_row
from contourlab.native import llvm

Maker = Callable[[StepGraph], Any]


@cache
def in_machine_code(made: StepGraph) -> Any:
    return llvm.loaded(llvm.object_code(llvm_ir.source_of(made)), "step", llvm_ir.SIGNATURE)


def in_c(graphs: Sequence[StepGraph], folder: Path, *flags: str) -> Maker:
    """Compile the C99 sources of some steps as one library with the system's compiler; return what makes their functions of it."""
    names = {id(made): f"step_{n}" for n, made in enumerate(graphs)}
    texts = [c99.source_of(made, names[id(made)]) for made in graphs]
    shared = c99.HASH if any(c99.HASH in text for text in texts) else ""
    source, library = folder / "steps.c", folder / "steps.so"
    source.write_text("\n".join(["#include <math.h>\n#include <stdint.h>", shared, *(text.replace(c99.HASH, "") for text in texts)]))
    strict = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-ffp-contract=off", "-shared", "-fPIC", *flags)
    done = subprocess.run(["gcc", *strict, "-o", str(library), str(source), "-lm"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    loaded = ctypes.CDLL(str(library))

    def make(made: StepGraph) -> Any:
        function, step = loaded[names[id(made)]], made.step
        function.restype = None

        def call(par: int, tables: int, ring: int, x: int, inp: int, mask: int, *rest: float) -> None:
            *time, after, out = rest
            words = [*map(ctypes.c_void_p, (par, x, inp)), *map(ctypes.c_double, time)]
            words += _tables_in_c(tables, len(step.tables)) if step.tables else []
            words += [ctypes.c_void_p(ring), ctypes.c_int64(mask)] if step.ring else []
            function(*words, ctypes.c_void_p(int(after)), ctypes.c_void_p(int(out)))

        return call

    return make


def _tables_in_c(words: int, count: int) -> list[Any]:
    """Return the arguments `tables` and `sizes` of a step in C from the words of a step in machine code."""
    pairs = (ctypes.c_int64 * (2 * count)).from_address(words)
    return [(ctypes.c_int64 * count)(*pairs[first::2]) for first in (0, 1)]


class TranslatedGroup(InterpretedGroup):
    """One variant; `make` turns the graph of a step into a function with the arguments of `llvm_ir.SIGNATURE`.

    `graph` returns the graph of a step: by default an exact one, as of plain Python.
    """

    def __init__(self, schedule: Schedule, make: Maker = in_machine_code, graph: Callable[[Step], StepGraph] = graph_of) -> None:
        super().__init__(schedule, 1, slice(0, 1))
        made = {step: make(graph(step)) for step in {node.step for node in schedule.nodes}}  # each axis has the same steps
        self._functions = [made[node.step] for node in schedule.nodes]

    def _run_node(self, n: int) -> None:
        node = self.schedule.nodes[n]
        step, held = node.step, self.schedule.period / node.repeat
        tables = [np.ascontiguousarray(node.tables[name], dtype=float) for name in step.tables]
        words = np.array([(table.ctypes.data, table.size) for table in tables], dtype=np.int64)
        par = self.parameters[n][:, 0].copy()
        for r in range(node.repeat):
            taken = np.array([s if isinstance(s, float) else float(self.signals[s, 0]) for s in self._sources[n]])
            ring = self._pushed(n, taken)
            x = self.state[n][:, 0].copy()
            following, out = np.empty(step.n_state), np.empty(rows(step.outputs))
            time = (float(self.tick), self.tick * self.schedule.period + r * held, held)
            before, after = (par, words, ring, x, taken), (following, out)
            self._functions[n](*(a.ctypes.data for a in before), len(ring) - 1, *time, *(a.ctypes.data for a in after))
            self.state[n][:, 0] = following
            first = self._first[n]
            self.signals[first : first + out.size, 0] = out

    def _pushed(self, n: int, taken: np.ndarray) -> np.ndarray:
        """Store the present value of the ring port; return the ring."""
        step: Step = self.schedule.nodes[n].step
        if step.ring:
            self.rings[n][self.tick % len(self.rings[n]), 0] = taken[ring_row(step)]
        return np.ascontiguousarray(self.rings[n][:, 0])
