"""A tick loop, and functions of words of memory, as a WebAssembly module that imports nothing but its memory.

LLVM emits an object for a linker. As its functions call nothing and own no data, none is needed: the import of the memory and the exports
are written anew, and what is for a linker is left out.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce

from contourlab.engine.translate import llvm_ir
from contourlab.engine.translate.graph import Op, prune
from contourlab.engine.translate.step_graph import TickGraph
from contourlab.engine.translate.tick_loop import LoopWriter, source_of
from contourlab.engine.translate.tracing import Trace
from contourlab.errors import EngineError, refuse

TARGET = ("wasm32-unknown-unknown", "generic")
ROWS = 128
"""The first word of memory that is used: an address of zero is none."""


def loop_source(made: TickGraph, tables: int, inputs: int, log: int, n_tick: int, period: float) -> str:
    """Return the LLVM IR of ``run(first, count)``, which runs some ticks.

    Places are words of 8 bytes from the beginning of memory; the rows of the group begin at `ROWS`. The inputs lie signal by signal, the
    log tick by tick.
    """
    begin = [
        *(f"%{name} = inttoptr i32 {8 * place} to ptr" for name, place in (("memory", ROWS), ("tables", tables))),
        *("%first = sext i32 %begin to i64", "%n_tick = sext i32 %count to i64", f"%logged = mul i64 %first, {len(made.log)}"),
        f"%external = getelementptr double, ptr inttoptr (i32 {8 * inputs} to ptr), i64 %first",
        f"%logs = getelementptr double, ptr inttoptr (i32 {8 * log} to ptr), i64 %logged",
        *(f"%{name} = add i64 0, {n}" for name, n in (("lane", 0), ("tick_stride", 1), ("signal_stride", n_tick), ("log_stride", 1))),
        f"%period = fadd double {llvm_ir.exactly(period)}, 0.0",
    ]
    return source_of(made, 1, 1, fused=False, own=("define void @run(i32 %begin, i32 %count) {", begin))


def function_source(name: str, trace: Trace, results: Mapping[int, Op]) -> str:
    """Return the LLVM IR of a function without arguments that stores results at places, words from `ROWS` on.

    It returns 1 if the conditions of the trace hold, else 0.
    """
    graph, w = trace.graph, LoopWriter(fused=False)
    holds = reduce(lambda a, b: graph.logic("and", a, b), trace.conditions, graph.constant(True))
    prune([graph.top], [holds, *results.values()])
    w.start("entry")
    w.put(f"%mem = inttoptr i32 {8 * ROWS} to ptr")
    w.block(graph.top)
    for place, op in results.items():
        w.store(w.value(op), "%mem", str(place))
    w.put(f"ret i32 {w.let(f'zext i1 {w.value(holds)} to i32')}")
    return "\n".join([*w.declared.values(), f"define i32 @{name}() {{", *w.lines, "}"])


def module_of(functions: Mapping[str, str]) -> bytes:
    """Return functions, LLVM IR by name, as a module that exports them and imports ``env.memory``.

    Raises
    ------
    EngineError
        If a function would need more than the memory.
    """
    import llvmlite.binding as llvm

    lines = "\n".join(functions.values()).splitlines()
    declared = dict.fromkeys(line for line in lines if line.startswith("declare"))
    # Whatever runs the module compiles it anew: more effort takes up to fifty times as long here, and the ticks are no faster.
    code = llvm_ir.assembly("\n".join([*declared, *(line for line in lines if line not in declared)]), *TARGET, binary=True, effort=0)
    parts = {part.name(): part.data() for part in llvm.object_file.ObjectFileRef.from_data(code).sections()}
    needs, others = parts[b"IMPORT"], {name for name in parts if name.isupper()} - {b"TYPE", b"IMPORT", b"FUNCTION", b"CODE"}
    alone = needs.startswith(b"\x01" + _text("env") + _text("__linear_memory")) and not others
    refuse(not alone, EngineError, f"the loop needs more than its memory: {needs!r} {others}")
    exports = b"".join(_text(name) + b"\x00" + _number(i) for i, name in enumerate(functions))
    memory = b"\x01" + _text("env") + _text("memory") + b"\x02\x00\x01"
    sections = {1: parts[b"TYPE"], 2: memory, 3: parts[b"FUNCTION"], 7: _number(len(functions)) + exports, 10: parts[b"CODE"]}
    return b"\x00asm\x01\x00\x00\x00" + b"".join(bytes([kind]) + _number(len(part)) + part for kind, part in sections.items())


def _number(n: int) -> bytes:
    """Return a whole number in LEB128."""
    return bytes([n]) if n < 128 else bytes([n & 127 | 128]) + _number(n >> 7)


def _text(text: str) -> bytes:
    return _number(len(text)) + text.encode()
