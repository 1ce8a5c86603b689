"""A tick loop, and functions of words of memory, as a WebAssembly module that imports nothing but its memory.

LLVM emits an object for a linker. As its functions call nothing and own no data, none is needed: the import of the memory and the exports
are written anew, and what is for a linker is left out.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
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


@dataclass(frozen=True)
class Target:
    """Where a loop as WebAssembly finds what it needs: `tables` is the word where places and sizes of tables begin.

    After `n_table` of them, two words each, follow the place of the inputs, how many ticks these have, and the place of the log.
    """

    tables: int
    n_table: int
    period: float

    @property
    def code(self) -> str:
        """Return what the code depends on."""
        return f"{TARGET} {self.tables} {self.n_table} {self.period.hex()}"

    def compiled(self, source: str) -> bytes:
        """Return LLVM IR as an object for a linker."""
        # Whatever runs the module compiles it anew: more effort takes up to fifty times as long here, and the ticks are no faster.
        code: bytes = llvm_ir.assembly(source, *TARGET, binary=True, effort=0)
        return code

    def loaded(self, code: bytes) -> bytes:
        """Return the object itself."""
        return code


def loop_source(made: TickGraph, target: Target) -> str:
    """Return the LLVM IR of ``run(first, count)``, which runs some ticks.

    Places are words of 8 bytes from the beginning of memory; the rows of the group begin at `ROWS`. The inputs lie signal by signal, the
    log tick by tick.
    """
    words = [(f"%word_{i}", f"inttoptr (i32 {8 * (target.tables + 2 * target.n_table + i)} to ptr)") for i in range(3)]
    begin = [
        *(f"%{name} = inttoptr i32 {8 * place} to ptr" for name, place in (("memory", ROWS), ("tables", target.tables))),
        *(f"{name} = load i64, ptr {place}, align 8" for name, place in words),
        "%inputs = inttoptr i64 %word_0 to ptr",
        "%of_log = inttoptr i64 %word_2 to ptr",
        *("%first = sext i32 %begin to i64", "%n_tick = sext i32 %count to i64", f"%logged = mul i64 %first, {len(made.log)}"),
        "%external = getelementptr double, ptr %inputs, i64 %first",
        "%logs = getelementptr double, ptr %of_log, i64 %logged",
        *(f"%{name} = add i64 0, {n}" for name, n in (("lane", 0), ("tick_stride", 1), ("log_stride", 1))),
        "%signal_stride = add i64 %word_1, 0",
        f"%period = fadd double {llvm_ir.exactly(target.period)}, 0.0",
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


def module_of(functions: Mapping[str, bytes]) -> bytes:
    """Return objects of one function each, by its name, as a module that exports them and imports ``env.memory``.

    Raises
    ------
    EngineError
        If a function would need more than the memory.
    """
    import llvmlite.binding as llvm

    types = kinds = bodies = exports = b""
    for i, (name, code) in enumerate(functions.items()):
        parts = {part.name(): part.data() for part in llvm.object_file.ObjectFileRef.from_data(code).sections()}
        needs, others = parts[b"IMPORT"], {name for name in parts if name.isupper()} - {b"TYPE", b"IMPORT", b"FUNCTION", b"CODE"}
        alone = needs.startswith(b"\x01" + _text("env") + _text("__linear_memory")) and not others
        refuse(not alone, EngineError, f"the loop needs more than its memory: {needs!r} {others}")
        # Each part is a number, here 1, and as many types, functions or bodies.
        types, kinds, bodies = types + parts[b"TYPE"][1:], kinds + _number(i), bodies + parts[b"CODE"][1:]
        exports += _text(name) + b"\x00" + _number(i)
    n, memory = _number(len(functions)), b"\x01" + _text("env") + _text("memory") + b"\x02\x00\x01"
    sections = {1: n + types, 2: memory, 3: n + kinds, 7: n + exports, 10: n + bodies}
    return b"\x00asm\x01\x00\x00\x00" + b"".join(bytes([kind]) + _number(len(part)) + part for kind, part in sections.items())


def _number(n: int) -> bytes:
    """Return a whole number in LEB128."""
    return bytes([n]) if n < 128 else bytes([n & 127 | 128]) + _number(n >> 7)


def _text(text: str) -> bytes:
    return _number(len(text)) + text.encode()
