"""The tick loop of a composition as one compiled function: found in memory, on disk, or translated and compiled when first needed."""

from __future__ import annotations

import hashlib
import inspect
import marshal
import threading
from collections.abc import Mapping
from functools import cache, lru_cache
from importlib.resources import files as files_of
from typing import Any

from contourlab import primitives
from contourlab.engine.gpu import Gpu
from contourlab.engine.step import Schedule, Step
from contourlab.engine.translate import maths, step_graph, tick_loop, wasm
from contourlab.engine.translate.outer import Reads
from contourlab.engine.translate.step_graph import Rows
from contourlab.engine.translate.tick_loop import VECTOR
from contourlab.native import llvm, store

_SOURCES = [file for room in ("engine", "engine.translate", "native") for file in files_of(f"contourlab.{room}").iterdir()]
_loops: dict[str, Any] = {}
"""By key: a compiled loop, or the reads that lead to the key of one."""
_building = threading.RLock()
"""Threads of a batch that need the same loop wait for the first. A property that a step reads may itself run a loop."""


@cache
def _translator() -> str:
    """Return a digest of engine, compiler, primitives and tools: a change of any of them discards all machine code."""
    files = sorted((file.name, file.read_text(encoding="utf-8")) for file in _SOURCES if file.name.endswith(".py"))
    return _digest(inspect.getsource(primitives), files, store.toolchain())


def _digest(*words: object) -> str:
    return hashlib.sha256(repr(words).encode()).hexdigest()[:32]


@lru_cache(1024)
def _layout(step: Step) -> str:
    return _digest(step.name, step.layout)


def tick_loop_of(
    schedule: Schedule,
    places: Rows,
    log_rows: tuple[int, ...],
    width: int,
    primitives: Mapping[Any, Any],
    target: Gpu | wasm.Target | None = None,
) -> Any:
    """Return the tick loop of a schedule as a C function of `tick_loop.SIGNATURE`, as a function of a GPU, or as an object of WebAssembly.

    Parameters
    ----------
    schedule : Schedule
    places : Rows
        Where the memory of a group has everything. The loop serves rings of any length: a delay is no reason to compile again.
    log_rows : tuple of int
        Rows of signals to record.
    width : int
        Lanes of the memory: 1, or a multiple of `VECTOR`, which run together.
    primitives : mapping
        `maths.SINGLE`, or `maths.LANES`: functions of lanes are polynomials.
    target : Gpu or wasm.Target, optional
        The loop of WebAssembly rounds each product before it is added.

    Raises
    ------
    EngineError
        If a step uses what cannot be translated; names file and line.
    """
    roots = [function for node in schedule.nodes for function in node.step.functions]
    places = Rows(places.states, places.parameters)
    layout = [(_layout(node.step), node.repeat) for node in schedule.nodes]
    of_lanes, device = primitives is maths.LANES, "" if target is None else target.code
    wiring = (schedule.sources, schedule.record_point, places, log_rows, width, of_lanes, VECTOR, device)
    key = before = _digest(layout, wiring, Reads(roots).words, _translator())
    trace: list[Any] | None = None
    with _building, store.without_collector():
        while key in _loops or _from_disk(key, target):
            if not isinstance(_loops[key], list):
                return _loops[key]
            reads, before, trace = Reads(roots), key, _loops[key]
            reads.again(trace)
            key = _digest(key, reads.words)
        reads = Reads(roots)
        made = step_graph.tick_graph(schedule, places, log_rows, primitives, contract=not isinstance(target, wasm.Target), reads=reads)
        if isinstance(target, wasm.Target):
            source = wasm.loop_source(made, target)
        else:
            source = tick_loop.source_of(made, min(width, VECTOR) if target is None else 1, width, gpu=target is not None)
        code = llvm.object_code(source) if target is None else target.compiled(source)
        other_reads = reads.trace != trace
        if other_reads:
            before, _loops[key] = key, reads.trace
        # The key is that of what the translator read, not of what is there now.
        key = _digest(before, reads.words)
        if other_reads:
            store.write(before, [marshal.dumps(reads.trace), key.encode(), code])
        else:
            store.write(key, [code])
        _loops[key] = _loaded(code, target)
        return _loops[key]


def _from_disk(key: str, target: Gpu | wasm.Target | None) -> bool:
    """Bring what is filed under a key into memory; return whether there is anything.

    A file has a loop, or reads with the loop that they led to first.
    """
    *reads, code = store.read(key) or [b""]
    if reads:
        _loops[key] = marshal.loads(reads[0])
        key = reads[1].decode()
    if code and key not in _loops:
        _loops[key] = _loaded(code, target)
    return bool(code)


def _loaded(code: bytes, target: Gpu | wasm.Target | None) -> Any:
    return llvm.loaded(code, "run", tick_loop.SIGNATURE) if target is None else target.loaded(code)
