"""A tick loop, and functions of words of memory, as a WebAssembly module that imports nothing but its memory.

LLVM emits a relocatable object. As its functions call nothing and own no data, it needs no linker: the import of the memory and the exports
are written anew, and the sections for a linker left out.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from contourlab.engine.translate import llvm_ir
from contourlab.engine.translate.graph import Op, prune
from contourlab.engine.translate.step_graph import TickGraph
from contourlab.engine.translate.tick_loop import LoopWriter, source_of
from contourlab.engine.translate.tracing import Trace
from contourlab.errors import EngineError, refuse

TARGET = ("wasm32-unknown-unknown", "generic")
ROWS = 128
"""The first word of memory that is used: an address of zero is none."""


@dataclass(frozen=True)
class Places:
    """Where a loop finds everything: words of 8 bytes from the beginning of memory. The rows of the group begin at `ROWS`."""

    tables: int
    inputs: int
    log: int
    n_tick: int
    period: float


def loop_source(made: TickGraph, at: Places) -> str:
    """Return the LLVM IR of ``run(first, count)``, which runs some ticks; the inputs lie signal by signal, the log tick by tick."""
    begin = [
        *(f"%{name} = inttoptr i32 {8 * place} to ptr" for name, place in (("memory", ROWS), ("tables", at.tables))),
        *("%first = sext i32 %begin to i64", "%n_tick = sext i32 %count to i64", "%lane = add i64 0, 0"),
        f"%external = getelementptr double, ptr inttoptr (i32 {8 * at.inputs} to ptr), i64 %first",
        f"%tick_stride = add i64 0, 1\n  %signal_stride = add i64 0, {at.n_tick}\n  %log_stride = add i64 0, 1",
        f"%logged = mul i64 %first, {len(made.log)}",
        f"%logs = getelementptr double, ptr inttoptr (i32 {8 * at.log} to ptr), i64 %logged",
        f"%period = fadd double {llvm_ir.exactly(at.period)}, 0.0",
    ]
    return source_of(made, 1, 1, fused=False, own=("define void @run(i32 %begin, i32 %count) {", begin))


def function_source(name: str, trace: Trace, results: Mapping[int, Op]) -> str:
    """Return the LLVM IR of a function without arguments that stores results at places, words from `ROWS` on.

    It returns 1 if the conditions of the trace hold, else 0.
    """
    graph, w = trace.graph, LoopWriter(fused=False)
    holds = graph.constant(True)
    for condition in trace.conditions:
        holds = graph.logic("and", holds, condition)
    prune([graph.top], [holds, *results.values()])
    w.start("entry")
    w.put(f"%mem = inttoptr i32 {8 * ROWS} to ptr")
    w.block(graph.top)
    for place, op in results.items():
        w.store(w.value(op), "%mem", str(place))
    w.put(f"ret i32 {w.let(f'zext i1 {w.value(holds)} to i32')}")
    return "\n".join([*w.declared.values(), f"define i32 @{name}() {{", *w.lines, "}"]) + "\n"


_TYPES, _IMPORTS, _FUNCTIONS, _EXPORTS, _CODE = 1, 2, 3, 7, 10
"""Numbers of sections."""


def module_of(functions: Mapping[str, str]) -> bytes:
    """Return functions, LLVM IR by name, as a module that exports them and imports ``env.memory``.

    Raises
    ------
    EngineError
        If a function would need more than the memory.
    """
    lines = [line for source in functions.values() for line in source.splitlines()]
    declared = dict.fromkeys(line for line in lines if line.startswith("declare"))
    lines = [*declared, *(line for line in lines if line not in declared)]
    parts = _sections(llvm_ir.foreign_code("\n".join(lines), *TARGET))
    alone = parts[_IMPORTS].startswith(b"\x01" + _MEMORY) and parts.keys() <= {0, _TYPES, _IMPORTS, _FUNCTIONS, _CODE}
    refuse(not alone, EngineError, f"the loop needs more than its memory: {parts[_IMPORTS]!r}")
    parts[_IMPORTS] = b"\x01" + _text("env") + _text("memory") + b"\x02\x00\x01"
    parts[_EXPORTS] = _number(len(functions)) + b"".join(_text(name) + b"\x00" + _number(i) for i, name in enumerate(functions))
    order = (_TYPES, _IMPORTS, _FUNCTIONS, _EXPORTS, _CODE)
    return b"\x00asm\x01\x00\x00\x00" + b"".join(bytes([kind]) + _number(len(parts[kind])) + parts[kind] for kind in order)


def _sections(code: bytes) -> dict[int, bytes]:
    """Return the contents of the sections of a module, by number."""
    found, at = {}, 8
    while at < len(code):
        kind, length, shift, more = code[at], 0, 0, True
        while more:
            at += 1
            length |= (code[at] & 127) << shift
            shift, more = shift + 7, code[at] > 127
        found[kind] = code[at + 1 : at + 1 + length]
        at += 1 + length
    return found


def _number(n: int) -> bytes:
    """Return a whole number in LEB128."""
    return bytes([n]) if n < 128 else bytes([n & 127 | 128]) + _number(n >> 7)


def _text(text: str) -> bytes:
    return _number(len(text)) + text.encode()


_MEMORY = _text("env") + _text("__linear_memory") + b"\x02"
"""How an object of LLVM imports its memory."""
