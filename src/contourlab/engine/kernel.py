"""The tick loop: it uses only addresses and row offsets, so that no composition of components recompiles it."""

from __future__ import annotations

import inspect
from functools import cache
from typing import Any

from contourlab.engine.intrinsics import OPTIONS
from contourlab.engine.memory import call_step, load, load_word, store
from contourlab.native.compile import compiled

NODE_FIELDS = ("function", "parameters", "tables", "state", "inputs", "outputs", "repeat")
_FIELDS = len(NODE_FIELDS)
_WORDS = 13
_SIGNATURE = "i8 " * _WORDS + "f8"


def _source(width: int) -> Any:
    def run(  # type: ignore[no-untyped-def]
        nodes, n_node, record_point, external, n_external, tick_stride, signal_stride, signals, log, log_rows, n_log, first, n_tick, period
    ):
        for step in range(n_tick):
            k = first + step
            t = k * period
            for j in range(n_external):
                value = load(external, step * tick_stride + j * signal_stride)
                for i in range(width):
                    store(signals, j * width + i, value)
            for n in range(n_node + 1):
                if n == record_point:
                    for j in range(n_log):
                        row = load_word(log_rows, j)
                        for i in range(width):
                            store(log, (step * n_log + j) * width + i, load(row, i))
                if n < n_node:
                    node = nodes + 8 * _FIELDS * n
                    repeat = load_word(node, 6)
                    held = period / repeat
                    for r in range(repeat):
                        call_step(
                            load_word(node, 0),
                            load_word(node, 1),
                            load_word(node, 2),
                            load_word(node, 3),
                            load_word(node, 4),
                            load_word(node, 5),
                            float(k),
                            t + r * held,
                            held,
                        )

    return run


@cache
def kernel(width: int) -> Any:
    """Return the tick loop over `width` lanes as a C function that releases the interpreter lock.

    Arguments: address and number of node records (NODE_FIELDS); record point; address and number of external signals; strides between ticks
    and between signals, in numbers; address of the signal table; address of the log (n_tick, n_log, width); address and number of its row
    addresses; first tick; number of ticks; period [s].
    """
    sources = (inspect.getsource(_source), inspect.getsource(inspect.getmodule(call_step) or _source), str(width))
    return compiled(_source(width), _SIGNATURE, sources=sources, options=OPTIONS)
