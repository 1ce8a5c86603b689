"""Print the graph of a step as C99: one function without allocation, on <math.h> alone."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from typing import ClassVar

from contourlab.engine.translate.graph import CONDITION, LIBRARY, TABLE, Block, Op
from contourlab.engine.translate.step_graph import StepGraph

_LEAVES = {"parameter": "par", "state": "x", "input": "inp", "table": "tables"}
_TYPES = {CONDITION: "bool", TABLE: "const double *"}
HASH = """
static double uniform(double stream, double k, double draw)
{
    if (!(fabs(stream) + fabs(k) + fabs(draw) < 0x1p63)) return NAN;
    uint64_t z = (uint64_t)(int64_t)stream * 0x9E3779B97F4A7C15u + (uint64_t)(int64_t)k * 0xD1342543DE82EF95u
               + (uint64_t)(int64_t)draw * 0x2545F4914F6CDD1Du;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    z ^= z >> 31;
    return ((double)(z >> 12) + 0.5) * 0x1p-52;
}
"""


def source_of(made: StepGraph, name: str = "") -> str:
    """Return C99 source of a step.

    Parameters
    ----------
    made : StepGraph
    name : str
        Name of the function; by default made of the name of the step.

    Returns
    -------
    str
        Compile it without contraction of products and sums (``-ffp-contract=off``): then it computes what Python computes, as far as both
        use the same mathematical library.
    """
    step = made.step
    called = name or re.sub(r"\W+", "_", step.name)
    writer = Writer()
    writer.block(made.graph.top, "    ")
    ends = [f"    x_next[{row}] = {writer.value(value)};" for row, value in enumerate(made.states)]
    ends += [f"    out[{row}] = {writer.value(value)};" for row, value in enumerate(made.outputs)]
    arguments = ["const double *par", "const double *x", "const double *inp", "double k", "double t", "double dt"]
    arguments += ["const double *const *tables", "const int64_t *sizes"] if step.tables else []
    arguments += ["const double *ring", "int64_t mask"] if step.ring else []
    arguments += ["double *x_next", "double *out"]
    signals = (("x", step.states), ("inp", step.inputs), ("out", step.outputs))
    unused = "".join(f" (void){argument.split('*')[-1].split()[-1]};" for argument in arguments)
    return "\n".join(
        [
            f"/* {step.name}, written by contourlab. Compile with -ffp-contract=off.",
            *_comment("par", step.parameters),
            *(line for name, ports in signals for line in _comment(name, [port.name for port in ports for _ in range(port.rows)])),
            *_comment("tables, with their sizes", step.tables),
            *([f"   ring: past values of {step.ring}, at index tick & mask; store the present value first."] if step.ring else []),
            "*/",
            "#include <math.h>",
            "#include <stdbool.h>",
            "#include <stdint.h>",
            *([HASH] if any(op.kind == "uniform" for op in made.graph.top.every()) else [""]),
            f"void {called}({', '.join(arguments)})",
            "{",
            f"   {unused}",
            *writer.lines,
            *ends,
            "}",
            "",
        ]
    )


def _comment(name: str, fields: Sequence[str]) -> list[str]:
    return [f"   {name}: {', '.join(fields)}"] if fields else []


class Writer:
    """Writes operations as statements; each value is a variable. A subclass has another language, or says where numbers are."""

    elsewhere: tuple[str, ...] = ("constant", "k", "t", "dt", "ring")
    """Kinds of operations without a variable of their own."""
    symbols: ClassVar = {"fadd": "+", "fsub": "-", "fmul": "*", "fdiv": "/", "and": "&&", "or": "||", "fneg": "-", "not": "!"}
    functions: ClassVar = {name: name for name in ("sqrt", "fabs", "floor", "rint", "copysign", "fma", *LIBRARY, "uniform")}
    declares = True
    """Whether a variable is declared where it is first assigned."""
    assigns, if_, else_, while_, leave = "=", "if ({}) {{", "} else {", "for (;;) {", "if (!{}) break;"
    end_if = end_for = end_while = "}"

    def __init__(self) -> None:
        self.lines: list[str] = []
        self._names: dict[int, str] = {}

    def value(self, op: Op) -> str:
        """Return the text of a value."""
        if op.kind == "constant":
            return str(op.extra).lower() if op.type == CONDITION else literal(op.extra)
        return op.kind if op.kind in self.elsewhere else self._names[id(op)]

    def name(self, op: Op, ending: str = "") -> str:
        """Return the variable of a value."""
        return self._names.setdefault(id(op), f"v{len(self._names)}") + ending

    def _declared(self, op: Op, const: str = "const ", ending: str = "") -> str:
        """Return the left side of the first assignment to a variable."""
        name = self.name(op, ending)
        return f"{const}{_TYPES.get(op.type, 'double')} {name}".replace("const const", "const") if self.declares else name

    def block(self, block: Block, pad: str) -> None:
        """Write the operations of a block."""
        for op in block.ops:
            if op.kind == "branch":
                self._branch(op, pad)
            elif op.kind == "loop":
                self._loop(op, pad)
            elif op.kind.startswith("store"):
                self.assign(pad, self.stored(op), self.value(op.args[0]))
            elif op.kind not in self.elsewhere:
                self.compute(op, pad)

    def assign(self, pad: str, name: str, value: str) -> None:
        """Write an assignment."""
        self.lines.append(f"{pad}{name} {self.assigns} {value};")

    def compute(self, op: Op, pad: str) -> None:
        """Write an operation that gives a value."""
        self.assign(pad, self._declared(op), self.text(op, *map(self.value, op.args)))

    def text(self, op: Op, *args: str) -> str:
        """Return the expression of an operation."""
        if op.kind in self.functions:
            return f"{self.functions[op.kind]}({', '.join(args)})"
        if op.kind in _LEAVES:
            return f"{_LEAVES[op.kind]}[{op.extra}]"
        if op.kind == "size":
            return "(double)mask + 1.0" if op.extra[0] == "ring" else f"(double)sizes[{op.extra[1]}]"
        if op.kind == "compare":
            return f"{args[0]} {self.symbols.get(op.extra, op.extra)} {args[1]}"
        if op.kind == "select":
            return f"{args[0]} ? {args[1]} : {args[2]}"
        if op.kind == "lookup":
            return f"{args[0]}[(int64_t){args[1]}]"
        if op.kind == "delayed":
            return self.past(op, args[0])
        if op.kind == "member":
            return self.member(op)
        symbol = self.symbols[op.kind]
        return f"{symbol}{args[0]}" if len(args) == 1 else f"{args[0]} {symbol} {args[1]}"

    def past(self, op: Op, tick: str) -> str:
        """Return the place of a past value."""
        return f"ring[(int64_t){tick} & mask]"

    def member(self, op: Op) -> str:
        """Return the place of a number of a bank's member."""
        return f"x[{self.member_row(op, op.extra[0])}]"

    def stored(self, op: Op) -> str:
        """Return the place where an operation stores."""
        return f"x_next[{self.member_row(op, op.extra[0])}]"

    def member_row(self, op: Op, first: int) -> str:
        """Return the index of a number of a bank's member, in an array that holds the bank from `first` on."""
        return f"{first} + {op.extra[1]} * {self.value(op.args[-1])}_n"

    def _branch(self, op: Op, pad: str) -> None:
        if self.declares:
            self.lines += [f"{pad}{self._declared(result, const='')};" for result in op.results]
        for head, block in ((self.if_.format(self.value(op.args[0])), op.blocks[0]), (self.else_, op.blocks[1])):
            self.lines.append(pad + head)
            self.block(block, pad + "    ")
            for result, end in zip(op.results, block.ends, strict=True):
                self.assign(pad + "    ", self.name(result), self.value(end))
        self.lines.append(pad + self.end_if)

    def _loop(self, op: Op, pad: str) -> None:
        (test, round_), inner = op.blocks, pad + "    "
        for carried, result, start in zip(op.extra, op.results, op.args, strict=True):
            self._names[id(result)] = self.name(carried)
            self.assign(pad, self._declared(carried, const=""), self.value(start))
        if op.index:
            self.lines += [pad + line for line in self.counting(self.name(op.index), op.index.extra)]
        else:
            self.lines.append(pad + self.while_)
            self.block(test, inner)
            self.lines.append(inner + self.leave.format(self.value(test.ends[0])))
        self.block(round_, inner)
        # All of the next values are computed before the first is stored.
        for carried, end in zip(op.extra, [self.value(end) for end in round_.ends], strict=True):
            self.assign(inner, self._declared(carried, ending="_after"), end)
        for carried in op.extra:
            self.assign(inner, self.name(carried), f"{self.name(carried)}_after")
        self.lines.append(pad + (self.end_for if op.index else self.end_while))

    def counting(self, index: str, count: int) -> list[str]:
        """Return the head of a loop that counts, and its index as a number."""
        head = f"for (int64_t {index}_n = 0; {index}_n < {count}; ++{index}_n) {{"
        return [head, f"    const double {index} = (double){index}_n; (void){index};"]


def literal(number: float) -> str:
    """Return a number that reads back identical."""
    if math.isnan(number):
        return "NAN"
    if math.isinf(number):
        return "INFINITY" if number > 0.0 else "(-INFINITY)"
    return repr(number) if math.copysign(1.0, number) > 0.0 else f"({number!r})"
