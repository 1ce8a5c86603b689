"""The tick loop of a schedule as one function, for one variant or for lanes: its LLVM IR."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence

from contourlab.engine.translate.graph import Op
from contourlab.engine.translate.llvm_ir import Writer
from contourlab.engine.translate.step_graph import TickGraph

VECTOR = 16
"""Lanes that run together: two of the longest registers; with more of them the processor runs out of registers."""
SIGNATURE = ctypes.CFUNCTYPE(
    None, *(ctypes.c_void_p,) * 3, *(ctypes.c_int64,) * 2, ctypes.c_void_p, *(ctypes.c_int64,) * 3, ctypes.c_double, ctypes.c_int64
)
_TAKES = (
    "ptr noalias %memory, ptr noalias %tables, ptr noalias %external, i64 %tick_stride, i64 %signal_stride, "
    "ptr noalias %logs, i64 %log_stride, i64 %first, i64 %n_tick, double %period"
)
_HEAD = f"define void @run({_TAKES}, i64 %lane) #0 {{"
_PLACES = ("tid", "ctaid", "ntid")
"""Of a thread of a GPU: its number in its block, the number of the block, and the threads of a block."""
_ON_GPU = "".join(f"declare i32 @llvm.nvvm.read.ptx.sreg.{name}.x()\n" for name in _PLACES)
_ON_GPU += f"define ptx_kernel void @run({_TAKES}) {{"
_FOOT = 'attributes #0 = { nounwind "prefer-vector-width"="512" "no-trapping-math"="true" }\n!0 = !{i32 1}'


class LoopWriter(Writer):
    """Writes the operations of a tick; each row of memory has `width` numbers."""

    members = ("%mem", "%mem")
    rings: dict[int, tuple[str, str, str]]
    """By number: where a ring is, and the mask of an index, also for each lane."""

    def ring(self, number: int) -> tuple[str, str, str]:
        """Read the place and the length of a ring."""
        row, length = (self._of_table("i64", 2 * number + i) for i in range(2))
        mask = self.let(f"sub i64 {length}, 1")
        place = self.let(f"mul i64 {row}, {self.width}")
        return self.let(f"getelementptr double, ptr %mem, i64 {place}"), mask, self.spread(mask, "i64")

    def row(self, row: int) -> str:
        return str(row * self.width)

    def record(self, value: str, place: str) -> str:
        """Store a number of each lane in the log; return the place of the next row.

        Vectors bypass the processor's caches, which the log would flush.
        """
        self.put(f"store {self.number} {value}, ptr {place}, {'align 8' if self.lanes == 1 else 'align 64, !nontemporal !0'}")
        return self.let(f"getelementptr double, ptr {place}, i64 %log_stride")

    def _parameter(self, op: Op, args: Sequence[str]) -> str:
        return self.load("%mem", self.row(op.extra))

    def _period(self, op: Op, args: Sequence[str]) -> str:
        return self.spread(f"%{op.kind}")

    _tick = _time = _period

    def _external(self, op: Op, args: Sequence[str]) -> str:
        place = self.let(f"mul i64 %signal_stride, {op.extra}")
        place = self.let(f"getelementptr double, ptr %fed, i64 {place}")
        return self.spread(self.let(f"load double, ptr {place}, align 8"))

    def _store_ring(self, op: Op, args: Sequence[str]) -> str:
        ring, mask, _ = self.rings[op.extra]
        self.store(args[0], ring, self.let(f"mul i64 {self.let(f'and i64 %k, {mask}')}, {self.width}"))
        return ""

    def _delayed(self, op: Op, args: Sequence[str]) -> str:
        ring, _, mask = self.rings[op.extra]
        index = self.let(f"and {self.whole} {self.truncated(args[0])}, {mask}")
        index = self.let(f"mul {self.whole} {index}, {self.spread_constant('i64', str(self.width))}")
        if self.lanes > 1:
            index = self.let(f"add {self.whole} {index}, <{', '.join(f'i64 {lane}' for lane in range(self.lanes))}>")
        return self.gather(ring, index)


def source_of(
    made: TickGraph, lanes: int, width: int, *, gpu: bool = False, fused: bool = True, own: tuple[str, Sequence[str]] = ("", ())
) -> str:
    """Return the LLVM IR of ``run(memory, tables, external, tick_stride, signal_stride, logs, log_stride, first, n_tick, period, lane)``.

    It runs `n_tick` ticks of the `lanes` that begin at `lane`, records into ``logs`` (n_tick, n_log, log_stride), and leaves states and
    signals of the last tick in memory. For a GPU it has no argument `lane`: each thread runs the lane of its number. `own` is another head
    of the function, and the instructions that make its arguments of those of that head.
    """
    w = LoopWriter(lanes, width, fused)
    w.start("entry")
    w.put(*own[1])
    if gpu:
        thread, block, size = (w.let(f"call i32 @llvm.nvvm.read.ptx.sreg.{name}.x()") for name in _PLACES)
        before = w.let(f"mul i32 {block}, {size}")
        w.put(f"%lane = zext i32 {w.let(f'add i32 {before}, {thread}')} to i64")
    w.put("%mem = getelementptr double, ptr %memory, i64 %lane", "%log = getelementptr double, ptr %logs, i64 %lane")
    w.put("%some = icmp sgt i64 %n_tick, 0", "br i1 %some, label %enter, label %done")
    w.start("enter")
    w.rings = {number: w.ring(number) for number in made.rings}
    starts = [w.load("%mem", w.row(row)) for _, row, _ in made.carried]
    w.block(made.graph.top)
    w.put("br label %ticks")
    w.start("ticks")
    w.put("%step = phi i64 [ 0, %enter ], [ %next, %latch ]")
    at = len(w.lines)
    for i, (op, _, _) in enumerate(made.carried):
        w.names[id(op)] = f"%c{i}"
    w.put("%k = add i64 %first, %step", "%tick = sitofp i64 %k to double", "%time = fmul double %tick, %period")
    w.put("%fed_at = mul i64 %step, %tick_stride", "%fed = getelementptr double, ptr %external, i64 %fed_at")
    w.block(made.body)
    row_of_log = "%row_of_log"
    for op in made.log:
        row_of_log = w.record(w.value(op), row_of_log)
    w.put("br label %latch")
    w.start("latch")
    w.put("%next = add i64 %step, 1", "%more = icmp slt i64 %next, %n_tick", "br i1 %more, label %ticks, label %leave")
    w.lines[at:at] = [
        f"  %c{i} = phi {w.number} [ {start}, %enter ], [ {w.value(after)}, %latch ]"
        for i, ((_, _, after), start) in enumerate(zip(made.carried, starts, strict=True))
    ]
    w.lines.insert(at, f"  %row_of_log = phi ptr [ %log, %enter ], [ {row_of_log}, %latch ]")
    w.start("leave")
    for row, op in [*((row, after) for _, row, after in made.carried), *made.signals]:
        w.store(w.value(op), "%mem", w.row(row))
    w.put("br label %done")
    w.start("done")
    head, foot = (_ON_GPU, "") if gpu else (own[0], "") if own[0] else (_HEAD, _FOOT)
    return "\n".join([*w.declared.values(), head, *w.lines, "  ret void", "}", foot]) + "\n"
