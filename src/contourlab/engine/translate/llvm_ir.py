"""Print a graph as LLVM IR, for one variant or for a vector of lanes, and compile it for this machine.

In lanes a branch computes the sides that any lane takes, and a loop runs while any lane is in it; a mask keeps the other lanes as they are.
"""

from __future__ import annotations

import ctypes
import struct
from collections.abc import Sequence
from typing import Any

from contourlab.engine.translate.graph import CONDITION, LIBRARY, TABLE, Block, Op
from contourlab.engine.translate.step_graph import StepGraph

_PLAIN = ("fadd", "fsub", "fmul", "fdiv", "fneg")
_INTRINSICS = ("sqrt", "fabs", "floor", "rint", "copysign", "fma")
_SIGNS = {"<": "olt", ">": "ogt", "<=": "ole", ">=": "oge", "==": "oeq", "!=": "une"}
_HASH = (0x9E3779B97F4A7C15, 0xD1342543DE82EF95, 0x2545F4914F6CDD1D)


def exactly(value: float) -> str:
    """Return a number as LLVM reads it without rounding."""
    return f"0x{struct.pack('>d', value).hex().upper()}"


class Writer:
    """Writes operations as lines of IR; each value gets a name.

    Parameters
    ----------
    lanes : int
        1, or the length of the vectors.
    width : int
        Numbers in a row of memory.
    fused : bool
        Whether a fused multiply-add is one instruction, or a product and a sum.
    """

    members: tuple[str, str]
    """Where the members of banks are read, and where they are stored."""

    def __init__(self, lanes: int = 1, width: int = 1, fused: bool = True) -> None:
        self.lanes, self.width, self.fused = lanes, width, fused
        self.lines: list[str] = []
        self.names: dict[int, str] = {}
        self.counters: dict[int, str] = {}
        self.declared: dict[str, str] = {}
        self.label = "entry"
        self.number, self.truth, self.whole = (self.vector(kind) for kind in ("double", "i1", "i64"))
        self._mask = self.spread_constant("i1", "true")
        self._count = 0

    # --- lines

    def vector(self, kind: str) -> str:
        """Return the type of one value for each lane."""
        return kind if self.lanes == 1 else f"<{self.lanes} x {kind}>"

    def new(self) -> str:
        """Return a number that no name or label has yet."""
        self._count += 1
        return str(self._count)

    def let(self, text: str) -> str:
        """Write an instruction; return the name of its value."""
        name = f"%v{self.new()}"
        self.lines.append(f"  {name} = {text}")
        return name

    def put(self, *texts: str) -> None:
        """Write instructions without a value."""
        self.lines += [f"  {text}" for text in texts]

    def start(self, label: str) -> None:
        """Begin a basic block."""
        self.lines.append(f"{label}:")
        self.label = label

    def spread_constant(self, kind: str, value: str) -> str:
        """Return a constant for all lanes."""
        return value if self.lanes == 1 else f"<{', '.join([f'{kind} {value}'] * self.lanes)}>"

    def spread(self, value: str, kind: str = "double") -> str:
        """Return a value that is the same in all lanes."""
        if self.lanes == 1:
            return value
        one = self.let(f"insertelement {self.vector(kind)} poison, {kind} {value}, i64 0")
        return self.let(f"shufflevector {self.vector(kind)} {one}, {self.vector(kind)} poison, <{self.lanes} x i32> zeroinitializer")

    def value(self, op: Op) -> str:
        """Return the name of an operation's value, or the constant."""
        if op.kind != "constant":
            return self.names[id(op)]
        if op.type == CONDITION:
            return self.spread_constant("i1", str(op.extra).lower())
        return self.spread_constant("double", exactly(op.extra))

    def load(self, base: str, index: str) -> str:
        """Return the numbers of all lanes at a row that is the same in all of them."""
        return self.let(f"load {self.number}, ptr {self.let(f'getelementptr double, ptr {base}, i64 {index}')}, align 8")

    def store(self, value: str, base: str, index: str) -> None:
        """Store the numbers of all lanes."""
        self.put(f"store {self.number} {value}, ptr {self.let(f'getelementptr double, ptr {base}, i64 {index}')}, align 8")

    def gather(self, base: str, index: str) -> str:
        """Return numbers at an index that may differ by lane; lanes that do not run read nothing."""
        place = self.let(f"getelementptr double, ptr {base}, {self.whole} {index}")
        if self.lanes == 1:
            return self.let(f"load double, ptr {place}, align 8")
        pointers = f"<{self.lanes} x ptr>"
        name = f"llvm.masked.gather.v{self.lanes}f64.v{self.lanes}p0"
        self.declared[name] = f"declare {self.number} @{name}({pointers}, i32, {self.truth}, {self.number})"
        return self.let(f"call {self.number} @{name}({pointers} {place}, i32 8, {self.truth} {self._mask}, {self.number} zeroinitializer)")

    def truncated(self, value: str) -> str:
        """Return numbers as whole numbers."""
        return self.let(f"fptosi {self.number} {value} to {self.whole}")

    # --- operations

    def block(self, block: Block) -> None:
        """Write the operations of a block."""
        for op in block.ops:
            if op.kind == "branch":
                (self._branch if self.lanes == 1 else self._masked_branch)(op)
            elif op.kind == "loop":
                (self._repeat if op.index else self._loop)(op)
            elif op.kind != "constant" and id(op) not in self.names:
                self.names[id(op)] = self._operation(op)

    def _operation(self, op: Op) -> str:
        args = [self.value(arg) for arg in op.args]
        if op.kind in _PLAIN:
            return self.let(f"{op.kind} {self.number} {', '.join(args)}")
        if op.kind == "fma" and not self.fused:
            return self.let(f"fadd {self.number} {self.let(f'fmul {self.number} {args[0]}, {args[1]}')}, {args[2]}")
        if op.kind in _INTRINSICS:
            return self._call(f"llvm.{op.kind}.{'f64' if self.lanes == 1 else f'v{self.lanes}f64'}", args)
        if op.kind in LIBRARY:
            return self._call(op.kind, args)
        return getattr(self, f"_{op.kind}")(op, args)  # type: ignore[no-any-return]

    def _call(self, name: str, args: Sequence[str]) -> str:
        self.declared[name] = f"declare {self.number} @{name}({', '.join([self.number] * len(args))})"
        # LLVM would make x*x of pow(x, 2): one in a thousand differs in the last digit.
        plain = " nobuiltin" if name == "pow" else ""
        return self.let(f"call {self.number} @{name}({', '.join(f'{self.number} {arg}' for arg in args)}){plain}")

    def _compare(self, op: Op, args: Sequence[str]) -> str:
        return self.let(f"fcmp {_SIGNS[op.extra]} {self.number} {args[0]}, {args[1]}")

    def _and(self, op: Op, args: Sequence[str]) -> str:
        return self.let(f"{op.kind} {self.truth} {args[0]}, {args[1]}")

    _or = _and

    def _not(self, op: Op, args: Sequence[str]) -> str:
        return self.let(f"xor {self.truth} {args[0]}, {self.spread_constant('i1', 'true')}")

    def _select(self, op: Op, args: Sequence[str]) -> str:
        kind = self._type(op)
        return self.let(f"select {self.truth} {args[0]}, {kind} {args[1]}, {kind} {args[2]}")

    def _table(self, op: Op, args: Sequence[str]) -> str:
        return self._of_table("ptr", 2 * op.extra)

    def _size(self, op: Op, args: Sequence[str]) -> str:
        return self.spread(self.let(f"sitofp i64 {self._of_table('i64', 2 * op.extra[1] + 1)} to double"))

    def _of_table(self, kind: str, place: int) -> str:
        """Return a word of ``%tables``: for each table its address and its size."""
        return self.let(f"load {kind}, ptr {self.let(f'getelementptr i64, ptr %tables, i64 {place}')}, align 8")

    def _lookup(self, op: Op, args: Sequence[str]) -> str:
        return self.gather(args[0], self.truncated(args[1]))

    def _pow2(self, op: Op, args: Sequence[str]) -> str:
        biased = self.let(f"add {self.whole} {self.truncated(args[0])}, {self.spread_constant('i64', '1023')}")
        bits = self.let(f"shl {self.whole} {biased}, {self.spread_constant('i64', '52')}")
        return self.let(f"bitcast {self.whole} {bits} to {self.number}")

    def _exponent(self, op: Op, args: Sequence[str]) -> str:
        bits = self.let(f"bitcast {self.number} {args[0]} to {self.whole}")
        bits = self.let(f"lshr {self.whole} {bits}, {self.spread_constant('i64', '52')}")
        bits = self.let(f"sub {self.whole} {bits}, {self.spread_constant('i64', '1023')}")
        return self.let(f"sitofp {self.whole} {bits} to {self.number}")

    def _bit(self, op: Op, args: Sequence[str]) -> str:
        one = self.let(f"and {self.whole} {self.truncated(args[0])}, {self.spread_constant('i64', str(op.extra))}")
        return self.let(f"icmp ne {self.whole} {one}, {self.spread_constant('i64', '0')}")

    def _uniform(self, op: Op, args: Sequence[str]) -> str:
        """The finaliser of splitmix64, as in `contourlab.primitives.uniform`."""

        def times(value: str, factor: int) -> str:
            return self.let(f"mul {self.whole} {value}, {self.spread_constant('i64', str(factor - (factor >> 63 << 64)))}")

        def shifted(value: str, shift: int) -> str:
            return self.let(f"lshr {self.whole} {value}, {self.spread_constant('i64', str(shift))}")

        def folded(value: str, shift: int) -> str:
            return self.let(f"xor {self.whole} {value}, {shifted(value, shift)}")

        a, b, c = (times(self.truncated(arg), factor) for arg, factor in zip(args, _HASH, strict=True))
        z = self.let(f"add {self.whole} {self.let(f'add {self.whole} {a}, {b}')}, {c}")
        z = times(folded(z, 30), 0xBF58476D1CE4E5B9)
        z = folded(times(folded(z, 27), 0x94D049BB133111EB), 31)
        top = self.let(f"sitofp {self.whole} {shifted(z, 12)} to {self.number}")
        half, scale = (self.spread_constant("double", text) for text in ("5.0e-1", "0x3CB0000000000000"))
        return self.let(f"fmul {self.number} {self.let(f'fadd {self.number} {top}, {half}')}, {scale}")

    # --- branches and loops

    def _branch(self, op: Op) -> None:
        n = self.new()
        self.put(f"br i1 {self.value(op.args[0])}, label %then{n}, label %else{n}")
        ends = []
        for label, block in zip((f"then{n}", f"else{n}"), op.blocks, strict=True):
            self.start(label)
            self.block(block)
            ends.append(([self.value(end) for end in block.ends], self.label))
            self.put(f"br label %join{n}")
        self.start(f"join{n}")
        (first, at_first), (second, at_second) = ends
        for result, p, q in zip(op.results, first, second, strict=True):
            self.names[id(result)] = self.let(f"phi {self._type(result)} [ {p}, %{at_first} ], [ {q}, %{at_second} ]")

    def _masked_branch(self, op: Op) -> None:
        outer, condition = self._mask, self.value(op.args[0])
        otherwise = self.let(f"xor {self.truth} {condition}, {self.spread_constant('i1', 'true')}")
        sides = []
        for block, taken in zip(op.blocks, (condition, otherwise), strict=True):
            if not any(inner.kind != "constant" for inner in block.ops):
                sides.append([self.value(end) for end in block.ends])
                continue
            n = self.new()
            self._mask = self.let(f"and {self.truth} {outer}, {taken}")
            some, before = self._any(self._mask), self.label
            self.put(f"br i1 {some}, label %side{n}, label %past{n}")
            self.start(f"side{n}")
            self.block(block)
            ends = [self.value(end) for end in block.ends]
            self.put(f"br label %past{n}")
            after = self.label
            self.start(f"past{n}")
            kinds = [self._type(end) for end in block.ends]
            sides.append(
                [self.let(f"phi {kind} [ {end}, %{after} ], [ zeroinitializer, %{before} ]") for kind, end in zip(kinds, ends, strict=True)]
            )
        self._mask = outer
        for result, p, q in zip(op.results, *sides, strict=True):
            kind = self._type(result)
            self.names[id(result)] = self.let(f"select {self.truth} {condition}, {kind} {p}, {kind} {q}")

    def _any(self, mask: str) -> str:
        name = f"llvm.vector.reduce.or.v{self.lanes}i1"
        self.declared[name] = f"declare i1 @{name}({self.truth})"
        return self.let(f"call i1 @{name}({self.truth} {mask})")

    def _loop(self, op: Op) -> None:
        n, before, outer = self.new(), self.label, self._mask
        start = [self.value(arg) for arg in op.args]
        self.put(f"br label %head{n}")
        self.start(f"head{n}")
        at = len(self.lines)
        carried = [f"%v{self.new()}" for _ in op.extra]
        for name, one, result in zip(carried, op.extra, op.results, strict=True):
            self.names[id(one)] = self.names[id(result)] = name
        active = f"%v{self.new()}"
        self._mask = active if self.lanes > 1 else outer
        self.block(op.blocks[0])
        held = self.value(op.blocks[0].ends[0])
        if self.lanes > 1:
            held = self._mask = self.let(f"and {self.truth} {active}, {held}")
        self.put(f"br i1 {held if self.lanes == 1 else self._any(held)}, label %round{n}, label %done{n}")
        self.start(f"round{n}")
        self.block(op.blocks[1])
        after = [self.value(end) for end in op.blocks[1].ends]
        kinds = [self._type(one) for one in op.extra]
        if self.lanes > 1:
            after = [
                self.let(f"select {self.truth} {held}, {kind} {end}, {kind} {name}")
                for kind, end, name in zip(kinds, after, carried, strict=True)
            ]
        self.put(f"br label %head{n}")
        heads = [
            f"  {name} = phi {kind} [ {p}, %{before} ], [ {q}, %{self.label} ]"
            for name, kind, p, q in zip(carried, kinds, start, after, strict=True)
        ]
        if self.lanes > 1:
            heads.append(f"  {active} = phi {self.truth} [ {outer}, %{before} ], [ {held}, %{self.label} ]")
        self.lines[at:at] = heads
        self.start(f"done{n}")
        self._mask = outer

    def _repeat(self, op: Op) -> None:
        assert op.index
        n, before = self.new(), self.label
        start = [self.value(arg) for arg in op.args]
        self.put(f"br label %round{n}")
        self.start(f"round{n}")
        at = len(self.lines)
        for one in op.extra:
            self.names[id(one)] = f"%v{self.new()}"
        self.counters[id(op.index)] = f"%i{n}"
        self.names[id(op.index)] = self.spread(self.let(f"sitofp i64 %i{n} to double"))
        self.block(op.blocks[1])
        after = [self.value(end) for end in op.blocks[1].ends]
        following = self.let(f"add i64 %i{n}, 1")
        more = self.let(f"icmp slt i64 {following}, {op.index.extra}")
        self.put(f"br i1 {more}, label %round{n}, label %done{n}")
        heads = [f"  %i{n} = phi i64 [ 0, %{before} ], [ {following}, %{self.label} ]"]
        for one, result, p, q in zip(op.extra, op.results, start, after, strict=True):
            heads.append(f"  {self.names[id(one)]} = phi {self._type(one)} [ {p}, %{before} ], [ {q}, %{self.label} ]")
            self.names[id(result)] = q
        self.lines[at:at] = heads
        self.start(f"done{n}")

    def _member(self, op: Op, args: Sequence[str]) -> str:
        return self.load(self.members[0], self._member_row(op))

    def _store_member(self, op: Op, args: Sequence[str]) -> str:
        self.store(args[0], self.members[1], self._member_row(op))
        return ""

    def _member_row(self, op: Op) -> str:
        """Return where in memory a number of a bank's member is."""
        first, size = op.extra
        row = self.let(f"mul i64 {self.counters[id(op.args[-1])]}, {size * self.width}")
        return self.let(f"add i64 {row}, {first * self.width}")

    def _type(self, op: Op) -> str:
        return {CONDITION: self.truth, TABLE: "ptr"}.get(op.type, self.number)


SIGNATURE = ctypes.CFUNCTYPE(None, *(ctypes.c_void_p,) * 5, ctypes.c_int64, *(ctypes.c_double,) * 3, *(ctypes.c_void_p,) * 2)
_HEAD = (
    "define void @step(ptr %par, ptr %tables, ptr %ring, ptr %x, ptr %inp, i64 %mask, "
    "double %k, double %t, double %dt, ptr %next, ptr %out) {"
)


class _StepWriter(Writer):
    members = ("%x", "%next")

    def _parameter(self, op: Op, args: Sequence[str]) -> str:
        return self.load({"parameter": "%par", "state": "%x", "input": "%inp"}[op.kind], op.extra)

    _state = _input = _parameter

    def _k(self, op: Op, args: Sequence[str]) -> str:
        return f"%{op.kind}"

    _t = _dt = _ring = _k

    def _size(self, op: Op, args: Sequence[str]) -> str:
        return self.let(f"sitofp i64 {self.let('add i64 %mask, 1')} to double") if op.extra[0] == "ring" else super()._size(op, args)

    def _delayed(self, op: Op, args: Sequence[str]) -> str:
        return self.gather("%ring", self.let(f"and i64 {self.truncated(args[0])}, %mask"))


def source_of(made: StepGraph) -> str:
    """Return the LLVM IR of a step: a function ``step(par, tables, ring, x, inp, mask, k, t, dt, next, out)`` of one variant.

    `tables` has for each table its address and its size. `ring` is the past of the ring port with ``mask + 1`` values, a
    power of two. The caller stores the present value first.
    """
    writer = _StepWriter()
    writer.start("entry")
    writer.block(made.graph.top)
    for base, values in (("%next", made.states), ("%out", made.outputs)):
        for row, value in enumerate(values):
            writer.store(writer.value(value), base, str(row))
    return "\n".join([*writer.declared.values(), _HEAD, *writer.lines, "  ret void", "}"]) + "\n"


def assembly(source: str, triple: str, processor: str, *, binary: bool = False, effort: int = 2) -> Any:
    """Return the assembly of LLVM IR for another processor, or its object file in bytes; `effort` is LLVM's, from 0 to 3."""
    import llvmlite.binding as binding

    from contourlab.native import llvm

    binding.initialize_all_targets()
    binding.initialize_all_asmprinters()
    machine = binding.Target.from_triple(triple).create_target_machine(cpu=processor, opt=effort)
    return (machine.emit_object if binary else machine.emit_assembly)(llvm.module_of(source, machine, triple))
