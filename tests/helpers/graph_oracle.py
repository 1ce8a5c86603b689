"""Evaluate the graph of a tick in plain Python, one operation at a time: what its machine code must compute, bit for bit.

It shares no code with the writers of LLVM IR and C99. `Bounded` carries a bound of the distance from plain Python with each number.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from fractions import Fraction
from typing import Any

from contourlab.engine.translate.graph import Block, Op
from contourlab.engine.translate.step_graph import TickGraph
from contourlab.primitives import uniform

_SIGNS: dict[str, Callable[[Any, Any], bool]] = {
    "<": lambda a, b: a < b,
    ">": lambda a, b: a > b,
    "<=": lambda a, b: a <= b,
    ">=": lambda a, b: a >= b,
    "==": lambda a, b: a == b,
    "!=": lambda a, b: a != b,
}
_WORD = 1 << 64


class UnsureError(Exception):
    """A decision that rounding may turn."""


def fma(a: float, b: float, c: float) -> float:
    """Return a*b + c, rounded once."""
    if not all(map(math.isfinite, (a, b, c))):
        return c if math.isfinite(a) and math.isfinite(b) else a * b + c
    exact = Fraction(a) * Fraction(b) + Fraction(c)
    if not exact:
        return a * b + c  # the sign of a zero
    try:
        return float(exact)
    except OverflowError:
        return math.inf if exact > 0 else -math.inf


def whole(x: float) -> int:
    """Return a number as a word of the processor, which for others than whole numbers of 64 bits is the smallest."""
    return int(x) if -(2.0**63) <= x < 2.0**63 else -(1 << 63)


def _bits(x: float) -> int:
    return int(struct.unpack("<Q", struct.pack("<d", x))[0])


def _number(bits: int) -> float:
    return float(struct.unpack("<d", struct.pack("<Q", bits % _WORD))[0])


def _divided(a: float, b: float) -> float:
    if b:
        return a / b
    return math.copysign(math.inf, a) * math.copysign(1.0, b) if a and not math.isnan(a) else math.nan


def _rounded(function: Callable[[float], int]) -> Callable[[float], float]:
    return lambda x: math.copysign(function(x), x) if math.isfinite(x) else x


def _library(function: Callable[[float], float]) -> Callable[[float], float]:
    def called(x: float) -> float:
        with suppress(ValueError):
            return function(x)
        return -math.inf if x == 0.0 else math.nan

    return called


NUMERIC: Mapping[str, Callable[..., float]] = {
    "fadd": lambda a, b: a + b,
    "fsub": lambda a, b: a - b,
    "fmul": lambda a, b: a * b,
    "fdiv": _divided,
    "fneg": lambda a: -a,
    "fma": fma,
    "fabs": math.fabs,
    "copysign": math.copysign,
    "floor": _rounded(math.floor),
    "rint": _rounded(round),
    **{name: _library(getattr(math, name)) for name in ("sqrt", "exp", "log", "tanh", "sin", "cos")},
    "pow2": lambda n: _number(whole(n) + 1023 << 52),
    "exponent": lambda x: float((_bits(x) >> 52) - 1023),
    "uniform": uniform,
}


class Oracle:
    """One lane of a tick.

    Parameters
    ----------
    made : TickGraph
    memory : sequence of float
        The lane's column of the memory of a group.
    tables : sequence of sequence of float
    rings : mapping of int to (int, int)
        By number, the first row of memory and the length.
    period : float [s]
    """

    def __init__(
        self,
        made: TickGraph,
        memory: Sequence[float],
        tables: Sequence[Sequence[float]],
        rings: Mapping[int, tuple[int, int]],
        period: float,
    ) -> None:
        self.made, self.tables, self.rings, self.period = made, tables, rings, period
        self.memory: list[Any] = [self.known(value) for value in memory]
        self.values: dict[int, Any] = {id(before): self.memory[row] for before, row, _ in made.carried}
        self.k, self.fed = 0, ()

    def tick(self, k: int, fed: Sequence[float]) -> list[Any]:
        """Compute a tick; return what it logs."""
        self.k, self.fed = k, fed
        self.block(self.made.graph.top)
        self.block(self.made.body)
        logged = [self.value(op) for op in self.made.log]
        carried = [(before, self.value(after)) for before, _, after in self.made.carried]
        self.values |= {id(before): after for before, after in carried}
        return logged

    # --- numbers

    def known(self, x: float) -> Any:
        """Return a number that plain Python has too."""
        return x

    def numeric(self, kind: str, args: Sequence[Any]) -> Any:
        return NUMERIC[kind](*args)

    def compared(self, sign: str, a: Any, b: Any) -> bool:
        return _SIGNS[sign](a, b)

    def index(self, x: Any) -> int:
        return whole(x)

    # --- the graph

    def value(self, op: Op) -> Any:
        if op.kind != "constant":
            return self.values[id(op)]
        return op.extra if isinstance(op.extra, bool) else self.known(op.extra)

    def block(self, block: Block) -> None:
        for op in block.ops:
            if op.kind == "branch":
                side = op.blocks[0 if self.value(op.args[0]) else 1]
                self.block(side)
                self._set(op.results, side.ends)
            elif op.kind == "loop":
                self._loop(op)
            elif op.kind != "constant":
                self.values[id(op)] = self._computed(op, [self.value(arg) for arg in op.args if arg.kind != "table"])

    def _set(self, ops: Sequence[Op], values: Sequence[Op]) -> None:
        computed = [self.value(value) for value in values]
        self.values |= {id(op): value for op, value in zip(ops, computed, strict=True)}

    def _loop(self, op: Op) -> None:
        test, round_ = op.blocks
        self._set(op.extra, op.args)
        n = 0
        while True:
            if op.index:
                self.values[id(op.index)] = self.known(float(n))
                if n == op.index.extra:
                    break
            else:
                self.block(test)
                if not self.value(test.ends[0]):
                    break
            self.block(round_)
            self._set(op.extra, round_.ends)
            n += 1
        self._set(op.results, op.extra)

    def _computed(self, op: Op, args: list[Any]) -> Any:
        kind, extra = op.kind, op.extra
        if kind in ("parameter", "external"):
            return self.memory[extra] if kind == "parameter" else self.known(self.fed[extra])
        if kind in ("tick", "time", "period"):
            return self.known({"tick": float(self.k), "time": self.k * self.period, "period": self.period}[kind])
        if kind == "compare":
            return self.compared(extra, *args)
        if kind in ("and", "or", "not"):
            return not args[0] if kind == "not" else args[0] and args[1] if kind == "and" else args[0] or args[1]
        if kind == "select":
            return args[1] if args[0] else args[2]
        if kind == "size":
            return self.known(float(len(self.tables[extra[1]]) if extra[0] == "table" else self.rings[extra[1]][1]))
        if kind == "lookup":
            return self.known(self.tables[op.args[0].extra][self.index(args[0])])
        if kind == "bit":
            return bool(self.index(args[0]) & extra)
        if kind == "store_ring":
            first, length = self.rings[extra]
            self.memory[first + self.k % length] = args[0]
        elif kind == "delayed":
            first, length = self.rings[extra]
            return self.memory[first + self.index(args[0]) % length]
        elif kind == "table":
            return None
        else:
            return self.numeric(kind, args)
        return None


class Bounded(Oracle):
    """Carries pairs: a number, and a bound of its distance from what plain Python computes; decisions within it raise `UnsureError`.

    It takes a contracted graph of `maths.EXACT`. A number computed with polynomials is as near to it: they agree with the library to
    `DIGITS` units in the last place, sine and cosine also to `CLOSE`.
    """

    DIGITS, CLOSE = 4.0, 1e-15

    def known(self, x: float) -> Any:
        return x, 0.0

    def numeric(self, kind: str, args: Sequence[Any]) -> Any:
        x, e = [arg[0] for arg in args], [arg[1] for arg in args]
        v = NUMERIC[kind](*x)
        if kind == "uniform":
            return NUMERIC[kind](*(self.whole_number(arg) for arg in args)), 0.0
        off = self._off(kind, x, e, v)
        if kind == "fma" and x[0] * x[1] + x[2] != v:
            off += abs(x[0] * x[1] + x[2] - v)
        if off and not math.isfinite(v + off):
            raise UnsureError
        if any(e) and kind not in ("fneg", "fabs", "copysign", "floor", "rint"):
            off += 2.0 * math.ulp(v) + 2.0 * math.ulp(off)
        return v, off * (1.0 + 1e-9)

    def _off(self, kind: str, x: list[float], e: list[float], v: float) -> float:
        """Return how far the result may move when the arguments do."""
        if kind in ("sin", "cos", "tanh", "exp", "log"):
            moved = e[0] if kind not in ("exp", "log") else v * math.expm1(e[0]) if kind == "exp" else self._over(e[0], x[0] - e[0])
            return moved + self.DIGITS * math.ulp(v) + (self.CLOSE if kind in ("sin", "cos") else 0.0)
        if not any(e):
            return 0.0
        if kind in ("floor", "rint"):
            low, high = (NUMERIC[kind](x[0] + step) for step in (-e[0], e[0]))
            if not low == high == v or (v == 0.0 and abs(x[0]) <= e[0]):
                raise UnsureError
            return 0.0
        if kind == "copysign":
            if abs(x[1]) <= e[1] and e[1]:
                raise UnsureError
            return e[0]
        if kind in ("fmul", "fma"):
            product = abs(x[0]) * e[1] + abs(x[1]) * e[0] + e[0] * e[1]
            return product + (e[2] + 2.0 * math.ulp(x[0] * x[1]) if kind == "fma" else 0.0)
        if kind == "fdiv":
            return self._over(e[0] + abs(v) * e[1], abs(x[1]) - e[1])
        return self._over(e[0], v) if kind == "sqrt" else sum(e)

    @staticmethod
    def _over(a: float, b: float) -> float:
        if a and not b > 0.0:
            raise UnsureError
        return a / b if a else 0.0

    def compared(self, sign: str, a: Any, b: Any) -> bool:
        near = a[1] + b[1]
        if near and not abs(a[0] - b[0]) > near * (1.0 + 1e-9):
            raise UnsureError
        return _SIGNS[sign](a[0], b[0])

    def whole_number(self, x: Any) -> float:
        if math.trunc(x[0] - x[1]) != math.trunc(x[0] + x[1]):
            raise UnsureError
        return float(x[0])

    def index(self, x: Any) -> int:
        return whole(self.whole_number(x) if x[1] else x[0])
