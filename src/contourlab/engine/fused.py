"""The tick loop of a composition as one compiled function: found in memory, on disk, or translated and compiled when first needed."""

from __future__ import annotations

import hashlib
import inspect
import threading
from functools import cache
from importlib.resources import files as files_of
from typing import Any

from contourlab import primitives
from contourlab.engine.gpu import Gpu
from contourlab.engine.keys import source_key
from contourlab.engine.schedule import Schedule
from contourlab.engine.translate import llvm_ir, maths, tick_graph, tick_loop
from contourlab.engine.translate.tick_graph import Rows
from contourlab.engine.translate.tick_loop import VECTOR
from contourlab.native import store

_FOLDER = files_of("contourlab.engine.translate")
_loops: dict[str, Any] = {}
_building = threading.Lock()
"""Threads of a batch that need the same loop wait for the first."""


@cache
def _translator() -> str:
    """Return a digest of translator, primitives and tools: a change of any of them discards all machine code."""
    files = sorted((file.name, file.read_text(encoding="utf-8")) for file in _FOLDER.iterdir() if file.name.endswith(".py"))
    return _digest((inspect.getsource(primitives), files, store.toolchain()))


def _digest(words: object) -> str:
    return hashlib.sha256(repr(words).encode()).hexdigest()[:32]


def _key(schedule: Schedule, places: Rows, log_rows: tuple[int, ...], width: int, code: str) -> str:
    nodes = [(source_key(node.step), node.repeat) for node in schedule.nodes]
    return _digest((nodes, schedule.sources, schedule.record_point, places, log_rows, width, VECTOR, code, _translator()))


def tick_loop_of(schedule: Schedule, places: Rows, log_rows: tuple[int, ...], width: int, gpu: Gpu | None = None) -> Any:
    """Return the tick loop of a schedule as a C function of `tick_loop.SIGNATURE`, or as a function of a GPU.

    Parameters
    ----------
    schedule : Schedule
    places : Rows
        Where the memory of a group has everything.
    log_rows : tuple of int
        Rows of signals to record.
    width : int
        Lanes of the memory: 1, or a multiple of `VECTOR`, which run together.
    gpu : Gpu, optional

    Raises
    ------
    EngineError
        If a step uses what cannot be translated; names file and line.
    """
    key = _key(schedule, places, log_rows, width, "" if gpu is None else gpu.code)
    with _building:
        if key not in _loops:
            parts = store.read(key)
            if parts is None:
                made = tick_graph.tick_graph(schedule, places, log_rows, maths.SINGLE if width == 1 else maths.LANES)
                if gpu is None:
                    parts = [llvm_ir.object_code(tick_loop.source_of(made, min(width, VECTOR), width))]
                else:
                    parts = [gpu.compiled(tick_loop.source_of(made, 1, width, gpu=True))]
                store.write(key, parts)
            _loops[key] = llvm_ir.loaded(parts[0], "run", tick_loop.SIGNATURE) if gpu is None else gpu.loaded(parts[0])
    return _loops[key]
