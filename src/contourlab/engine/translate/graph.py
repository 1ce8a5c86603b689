"""A graph of operations on numbers and conditions, with branches and loops.

Operations are hash-consed: the same operation on the same values is one. Constants are folded only where the result is exact for every
input, signs of zero and non-finite numbers included, so the graph computes bit for bit what Python computes. With `contract`, a product
that is added becomes a fused multiply-add: faster, and rounded once instead of twice.
"""

from __future__ import annotations

import math
import operator
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import reduce
from typing import Any

NUMBER, WHOLE, CONDITION, TABLE = "f", "n", "b", "p"
"""Types of values: a float64, a whole number of Python, a truth value, the address of a table.

A whole number has no -0.0, so ``-n`` and ``n * -1`` are 0.0 for n = 0. It is a mark around a float64, never an operation of a block:
``args`` hold the float64, and ``extra`` where it is whole, True or a condition, since the sides of an ``if`` may differ.
"""

FOLDED: dict[str, Callable[..., float]] = {
    "fadd": operator.add,
    "fsub": operator.sub,
    "fmul": operator.mul,
    "fdiv": operator.truediv,
    "fneg": operator.neg,
    "fabs": math.fabs,
    "sqrt": math.sqrt,
    "copysign": math.copysign,
}
COMPARED: dict[str, Callable[[float, float], bool]] = {
    "<": operator.lt,
    ">": operator.gt,
    "<=": operator.le,
    ">=": operator.ge,
    "==": operator.eq,
    "!=": operator.ne,
}
LIBRARY = ("exp", "log", "tanh", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "pow", "fmod")
"""Operations that a mathematical library computes; all others are exact everywhere, and so is `fmod`."""
_COSTS = {"fdiv": 8, "sqrt": 10, "uniform": 15} | dict.fromkeys(LIBRARY, 40)
_KEEPS_WHOLE = ("fadd", "fsub", "fmul", "fneg")
_FIXED = ("constant", "parameter", "table", "size", "period", "dt")
"""Values that are the same in every tick; what is computed from them alone is computed once."""
LARGEST = 100_000
"""Most operations; the largest of the shipped scenarios has 10 000."""
_GUARDED = ("lookup", "delayed", "member", "branch", "loop")
"""Operations that must not run where their branch is not taken: an index may lie outside, a loop may not end."""
LIGHT = 8
"""Up to this cost both sides of a branch are computed, and one is selected. Jumping over a costlier side that no lane takes pays,
however much the lanes differ."""


class MismatchError(Exception):
    """What cannot be translated; the evaluator adds file and line."""


UNSET: Any = type("Unset", (), {"__repr__": lambda self: "unset"})()
"""The value of a name that has none, or not the same kind of value, on both sides of a branch."""


class Op:
    """An operation: `kind`, the operations that it takes, its type, and what else identifies it.

    A branch has two blocks and a loop has two (the test, and one round). `results` are the values that come out of either. A loop with a
    known number of rounds has an `index` in place of a test; its `extra` is that number. What is `fixed` is the same in every tick.
    """

    __slots__ = ("args", "blocks", "extra", "fixed", "index", "kind", "results", "type")

    def __init__(self, kind: str, args: tuple[Op, ...], type_: str, extra: Any = None) -> None:
        self.kind, self.args, self.type, self.extra = kind, args, type_, extra
        self.blocks: tuple[Block, ...] = ()
        self.results: tuple[Op, ...] = ()
        self.index: Op | None = None
        self.fixed = False

    def __repr__(self) -> str:
        return f"<{self.kind} {self.extra}>" if self.extra is not None else f"<{self.kind}>"


class Block:
    """Operations in order; `ends` are the values that leave a side of a branch, or a round of a loop."""

    def __init__(self, parent: Block | None = None) -> None:
        self.parent = parent
        self.ops: list[Op] = []
        self.known: dict[Any, Op] = {}
        self.ends: tuple[Op, ...] = ()

    def every(self) -> Iterator[Op]:
        """Yield all operations, those of inner blocks included."""
        for op in self.ops:
            yield op
            for block in op.blocks:
                yield from block.every()

    def effects(self) -> list[Op]:
        """Return the operations that change memory, and the branches and loops around them."""
        found: list[Op] = []
        for op in self.ops:
            inner = [effect for block in op.blocks for effect in block.effects()]
            if inner or op.kind.startswith("store"):
                found += [op, *inner]
        return found


class Graph:
    """Builds operations into the current block.

    Parameters
    ----------
    contract : bool
        Whether to make fused multiply-adds: faster, and rounded otherwise than Python.
    """

    def __init__(self, contract: bool = False) -> None:
        self.contract = contract
        self.top = self.block = Block()
        self.scope: Any = None
        self._size = 0

    # --- operations

    def op(self, kind: str, args: Sequence[Op] = (), type_: str = NUMBER, extra: Any = None) -> Op:
        """Return an operation: the one that is there already, or a new one in the current block."""
        # Whether a product is fused depends on the step that uses it: each step, and each sub-step, has its own.
        key = (kind, tuple(map(id, args)), extra.hex() if isinstance(extra, float) else extra, self.scope if kind == "fmul" else None)
        block: Block | None = self.block
        while block is not None:
            if key in block.known:
                return block.known[key]
            block = block.parent
        self._size += 1
        if self._size > LARGEST:
            raise MismatchError(f"the step has more than {LARGEST} operations: divide it, or make its loops real ones")
        made = Op(kind, tuple(args), type_, extra)
        made.fixed = kind in _FIXED or (bool(args) and kind not in _GUARDED and all(arg.fixed for arg in args))
        home = self.top if made.fixed else self.block
        home.known[key] = made
        home.ops.append(made)
        return made

    def effect(self, kind: str, args: Sequence[Op], extra: Any) -> None:
        """Append an operation that changes memory."""
        self.block.ops.append(Op(kind, tuple(args), "", extra))

    def constant(self, value: float) -> Op:
        """Return a constant: a condition if the value is a bool, else a number."""
        return self.op("constant", (), CONDITION, value) if isinstance(value, bool) else self.op("constant", (), NUMBER, float(value))

    def number(self, value: Any) -> Op:
        """Return a value as a number; a condition counts 1 or 0, as in Python."""
        if isinstance(value, Op) and value.type in (NUMBER, WHOLE):
            return value.args[0] if value.type == WHOLE else value
        if isinstance(value, Op) and value.type == CONDITION:
            return self.op("select", (value, self.constant(1.0), self.constant(0.0)))
        if isinstance(value, (int, float)):
            return self.constant(float(value))
        cure = getattr(value, "cure", "write float(...) around it" if hasattr(value, "dtype") else "write a plain number")
        raise MismatchError(f"a number is needed, not {value!r}: {cure}")

    def condition(self, value: Any) -> Op | bool:
        """Return the truth of a value."""
        if isinstance(value, Op):
            return value if value.type == CONDITION else self.compare("!=", value, 0.0)
        return bool(value)

    def arithmetic(self, kind: str, *values: Any) -> Any:
        """Return the result of an arithmetic operation; of plain numbers a plain number."""
        if not any(isinstance(value, Op) for value in values):
            return FOLDED[kind](*values)
        args = [self.number(value) for value in values]
        made = self._computed(kind, args)
        if kind not in _KEEPS_WHOLE or not all(map(is_whole, values)):
            return made
        positive = any(op.kind == "constant" and op.extra > 0.0 for op in args)
        return self.whole(made, *values, zero=kind == "fneg" or (kind == "fmul" and not positive))

    def exact(self, made: Op) -> Any:
        """Return a number up to 2**53, beyond which Python's whole numbers have digits that a float64 has not; else NaN."""
        return self.select(self.compare("<=", self.arithmetic("fabs", made), 2.0**53), made, math.nan)

    def whole(self, made: Op, *values: Any, zero: bool = True) -> Any:
        """Return a number marked as whole where all values are; `zero` says whether it may be -0.0, which a whole number is not."""
        whole, made = reduce(lambda p, q: self.logic("and", p, q), map(is_whole, values), True), self.number(made)
        if zero and whole is not False:
            made = self.select(whole, self._computed("fadd", [made, self.constant(0.0)]), made)  # -0.0 + 0.0 is 0.0
        return _marked(made, whole)

    def _computed(self, kind: str, args: list[Op]) -> Op:
        if all(op.kind == "constant" for op in args):
            with suppress(ArithmeticError, ValueError):
                return self.constant(FOLDED[kind](*(op.extra for op in args)))
        if kind == "fmul" and _is(args[0], 1.0):
            return args[1]
        if (kind in ("fmul", "fdiv") and _is(args[1], 1.0)) or (kind == "fsub" and _is(args[1], 0.0)):
            return args[0]
        if kind == "fneg" and args[0].kind == "fneg":
            return args[0].args[0]
        return self.op(kind, args)

    def compare(self, sign: str, a: Any, b: Any) -> Any:
        """Return a comparison; of plain numbers a bool."""
        if not isinstance(a, Op) and not isinstance(b, Op):
            return COMPARED[sign](a, b)
        return self.op("compare", (self.number(a), self.number(b)), CONDITION, sign)

    def logic(self, kind: str, *values: Any) -> Any:
        """Return ``and``, ``or`` or ``not`` of conditions."""
        if kind == "not":
            (value,) = values
            return self.op("not", (value,), CONDITION) if isinstance(value, Op) else not value
        decides = kind == "or"
        for one, other in (values, values[::-1]):
            if not isinstance(one, Op):
                return bool(one) if bool(one) == decides else other
        return self.op(kind, values, CONDITION)

    def select(self, condition: Any, a: Any, b: Any) -> Any:
        """Return a where the condition holds, else b; both are computed. Tuples are joined item by item."""
        if not isinstance(condition, Op):
            return a if condition else b
        return self._joined(a, b, lambda p, q: self._selected(condition, p, q), (self.block, self.block))

    def _selected(self, condition: Op, p: Op, q: Op) -> Op:
        if p is condition or q is condition:  # of conditions: p or q, p and q
            return self.op("or" if p is condition else "and", (p, q), CONDITION)
        return self.op("select", (condition, p, q), p.type)

    # --- branches and loops

    def branch(self, condition: Any, then: Callable[[], Any], other: Callable[[], Any]) -> Any:
        """Return the value of one of two functions, each evaluated in a block of its own.

        If both sides are light, both are computed and one is selected.
        """
        if not isinstance(condition, Op):
            return then() if condition else other()
        blocks, values = [], []
        for side in (then, other):
            with self.within(Block(self.block)) as block:
                values.append(side())
            blocks.append(block)
        if all(map(_is_light, blocks)):
            for block in blocks:
                self.block.ops += block.ops
                for key, op in block.known.items():
                    self.block.known.setdefault(key, op)
            return self.select(condition, *values)
        made = Op("branch", (condition,), "")
        made.blocks = tuple(blocks)
        pairs: list[tuple[Op, Op]] = []
        results: list[Op] = []

        def join(p: Op, q: Op) -> Op:
            pairs.append((p, q))
            results.append(Op("result", (made,), p.type))
            return results[-1]

        value = self._joined(values[0], values[1], join, blocks)
        blocks[0].ends, blocks[1].ends = tuple(p for p, _ in pairs), tuple(q for _, q in pairs)
        made.results = tuple(results)
        self.block.ops.append(made)
        return value

    def repeat(
        self, head: int | Callable[[list[Op]], Any], start: Sequence[Any], body: Callable[[Any, list[Op]], Sequence[Any]]
    ) -> list[Op]:
        """Repeat a body.

        Parameters
        ----------
        head : int or callable
            How many times, at least once; or a test, which takes the values before a round, and returns a condition.
        start : sequence
            Numbers and conditions before the first round.
        body : callable
            Takes the number of the round, from 0, or None with a test, and the values before the round; returns the values after the round.

        Returns the values after the last round.

        Notes
        -----
        The loop is built again if a number is whole before a round and not after it, or the reverse: a condition then says where it is.
        """
        begin = [self._as_condition(value) if _is_condition(value) else self.number(value) for value in start]
        wholes = [is_whole(value) for value in start]
        while True:
            made = Op("loop", (*begin, *(whole for whole in wholes if isinstance(whole, Op))), "")
            made.blocks = (Block(self.block), Block(self.block))
            made.extra = tuple(Op("carried", (made,), op.type) for op in made.args)
            made.results = tuple(Op("result", (made,), op.type) for op in made.args)
            before = _marked_each(made.extra, wholes)
            if isinstance(head, int):
                made.index = Op("index", (made,), NUMBER, head)
            else:
                with self.within(made.blocks[0]) as block:
                    block.ends = (self._as_condition(head(before)),)
            with self.within(made.blocks[1]) as block:
                after = body(made.index, before)
                block.ends = tuple(self._kept(value, op) for value, op in zip(after, begin, strict=True))
                now = [is_whole(value) for value in after]
                block.ends += tuple(self._as_condition(q) for p, q in zip(wholes, now, strict=True) if isinstance(p, Op))
            same = [isinstance(p, Op) or p is q or op.type == CONDITION for op, p, q in zip(begin, wholes, now, strict=True)]
            if all(same):
                self.block.ops.append(made)
                return _marked_each(made.results, wholes)
            wholes = [whole if still else self._as_condition(whole) for whole, still in zip(wholes, same, strict=True)]

    @contextmanager
    def within(self, block: Block) -> Iterator[Block]:
        """Build into another block for a while."""
        held, self.block = self.block, block
        try:
            yield block
        finally:
            self.block = held

    def _kept(self, value: Any, before: Op) -> Op:
        """Return a value after a round, of the type that it had before."""
        if before.type == NUMBER:
            return self.number(value)
        if not _is_condition(value):
            raise MismatchError("a name is a condition before a round of a loop and a number after it: begin with a number")
        return self._as_condition(value)

    def _as_condition(self, value: Any) -> Op:
        value = self.condition(value)
        return value if isinstance(value, Op) else self.constant(value)

    def _joined(self, a: Any, b: Any, join: Callable[[Op, Op], Op], sides: Sequence[Block]) -> Any:
        """Return two values joined: what is the same on both sides stays as it is, what cannot be joined is `UNSET`.

        `sides` are the blocks in which a and b were computed: there they become values of one type.
        """
        if isinstance(a, tuple) and isinstance(b, tuple) and len(a) == len(b):
            items = [self._joined(p, q, join, sides) for p, q in zip(a, b, strict=True)]
            return type(a)(*items) if hasattr(a, "_fields") else tuple(items)
        if a is b or (not isinstance(a, Op) and not isinstance(b, Op) and type(a) is type(b) and _same(a, b)):
            return a
        if not isinstance(a, (Op, int, float)) or not isinstance(b, (Op, int, float)):
            return UNSET

        def joined(convert: Callable[[Any], Op], *values: Any) -> Op:
            pair: list[Op] = []
            for side, value in zip(sides, values, strict=True):
                with self.within(side):
                    pair.append(convert(value))
            return pair[0] if pair[0] is pair[1] else join(*pair)

        if _is_condition(a) and _is_condition(b):
            return joined(self._as_condition, a, b)
        wholes = is_whole(a), is_whole(b)
        return _marked(joined(self.number, a, b), wholes[0] if wholes[0] is wholes[1] else joined(self._as_condition, *wholes))


def is_whole(value: Any) -> Op | bool:
    """Return where a value is a whole number or a truth value of Python: always, never, or where a condition holds."""
    if isinstance(value, Op):
        return value.extra if value.type == WHOLE else value.type == CONDITION
    return isinstance(value, int)


def _marked(value: Op, whole: Op | bool) -> Op:
    """Return a number marked as whole where it is."""
    return value if whole is False or value.type == CONDITION else Op("whole", (value,), WHOLE, whole)


def _marked_each(ops: Sequence[Op], wholes: Sequence[Op | bool]) -> list[Op]:
    """Mark the numbers that a loop carries; the conditions that it carries for some of them follow."""
    more = iter(ops[len(wholes) :])
    return [_marked(op, next(more) if isinstance(whole, Op) else whole) for op, whole in zip(ops, wholes, strict=False)]


def _is(op: Op, value: float) -> bool:
    return op.kind == "constant" and op.extra == value and math.copysign(1.0, op.extra) == math.copysign(1.0, value)


def _is_condition(value: Any) -> bool:
    return isinstance(value, bool) or getattr(value, "type", "") == CONDITION


def _same(a: Any, b: Any) -> bool:
    return bool(a == b) and (not isinstance(a, float) or math.copysign(1.0, a) == math.copysign(1.0, b))


def _is_light(block: Block) -> bool:
    return all(op.kind not in _GUARDED and op.type for op in block.ops) and sum(_COSTS.get(op.kind, 1) for op in block.ops) <= LIGHT


_DECIDING = ("compare", "floor", "rint", "fmod", "lookup", "delayed", "uniform", "bit")
"""Operations that jump: the last digit of what they read may decide."""


def fuse_products(blocks: Sequence[Block], wanted: Sequence[Op]) -> None:
    """Make fused multiply-adds of products that are used once, in the step that makes them; call it before `prune`.

    A product with two uses stays: a number less itself must be 0. So does one in a sum that, in the end, only comparisons, `floor`, `rint`
    and indices read: they decide as in Python. `wanted` holds all that crosses the border of a step: it is not fused with what follows.
    """
    ops = [op for block in blocks for op in block.every()]
    uses = Counter(id(arg) for op in ops for arg in op.args)
    uses.update(id(end) for op in ops for block in op.blocks for end in block.ends)
    uses.update(map(id, wanted))
    read = _needed(blocks, wanted, _DECIDING)
    for block in blocks:
        _fuse_in(block, uses, read)


def _fuse_in(block: Block, uses: Counter[int], read: set[int]) -> None:
    made: list[Op] = []
    for op in block.ops:
        for inner in op.blocks:
            _fuse_in(inner, uses, read)
        free = [arg.kind == "fmul" and uses[id(arg)] == 1 for arg in op.args]
        if op.kind in ("fadd", "fsub") and any(free) and id(op) in read:
            (a, b), first = op.args, free[0]
            product, other = (a, b) if first else (b, a)
            left = product.args[0]
            if op.kind == "fsub":
                negative = Op("fneg", (other if first else left,), NUMBER)
                negative.fixed = negative.args[0].fixed
                made.append(negative)
                left, other = (left, negative) if first else (negative, other)
            op.kind, op.args = "fma", (left, product.args[1], other)
        made.append(op)
    block.ops = made


def prune(blocks: Sequence[Block], wanted: Sequence[Op]) -> None:
    """Remove every operation that neither the wanted values nor memory need."""
    needed = _needed(blocks, wanted)
    for block in blocks:
        _keep(block, needed)


def _needed(blocks: Sequence[Block], wanted: Sequence[Op], ends: Sequence[str] = ()) -> set[int]:
    """Return the operations that the wanted values and memory need, but for those that only operations of the kinds `ends` need."""
    needed: set[int] = set()
    rest = [*wanted, *(op for block in blocks for op in block.effects())]
    while rest:
        op = rest.pop()
        if id(op) in needed:
            continue
        needed.add(id(op))
        if op.kind in ends:
            continue
        if op.kind == "loop":
            rest += op.blocks[0].ends
            continue
        rest += op.args
        if op.kind in ("result", "carried"):
            made = op.args[0]
            at = (made.results if op.kind == "result" else made.extra).index(op)
            if made.kind == "branch":
                rest += [block.ends[at] for block in made.blocks]
            else:
                rest += [made.args[at], made.extra[at], made.blocks[1].ends[at]]
    return needed


def _keep(block: Block, needed: set[int]) -> None:
    block.ops = [op for op in block.ops if id(op) in needed]
    for op in block.ops:
        if op.kind in ("branch", "loop"):
            kept = [i for i, value in enumerate(op.results if op.kind == "branch" else op.extra) if id(value) in needed]
            op.results = tuple(op.results[i] for i in kept)
            for side in op.blocks if op.kind == "branch" else op.blocks[1:]:
                side.ends = tuple(side.ends[i] for i in kept)
            if op.kind == "loop":
                op.args, op.extra = tuple(op.args[i] for i in kept), tuple(op.extra[i] for i in kept)
        for inner in op.blocks:
            _keep(inner, needed)
