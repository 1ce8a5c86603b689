"""Passes over the operations of a graph: fused multiply-adds, and removal of what nothing needs."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from contourlab.engine.translate.graph import NUMBER, Block, Op

_DECIDING = ("compare", "floor", "rint", "lookup", "delayed", "uniform", "bit")
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
            values = op.results if op.kind == "branch" else op.extra
            kept = [i for i, value in enumerate(values) if id(value) in needed]
            op.results = tuple(op.results[i] for i in kept)
            for side in op.blocks if op.kind == "branch" else op.blocks[1:]:
                side.ends = tuple(side.ends[i] for i in kept)
            if op.kind == "loop":
                op.args, op.extra = tuple(op.args[i] for i in kept), tuple(op.extra[i] for i in kept)
        for inner in op.blocks:
            _keep(inner, needed)
