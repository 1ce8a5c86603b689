"""Loads and stores with alias scopes: they tell the vectoriser that tables, states and signals never overlap."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic

_DOUBLE = ir.DoubleType()
_SCOPES = ("parameter", "state", "input", "output", "table", "ring")
WORD, NUMBER = types.int64, types.float64


def instruction(returns: Any, *takes: Any) -> Callable[[Callable[..., Any]], Any]:
    """Make an intrinsic of these types from ``emit(builder, *values) -> value``, which writes its LLVM instructions."""

    def made(emit: Callable[..., Any]) -> Any:
        def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
            value = emit(builder, *args)
            return context.get_dummy_value() if returns is types.void else value

        def operation(typingctx: Any, *kinds: Any) -> Any:
            return returns(*takes), codegen

        # Numba binds the arguments by this signature.
        operation.__signature__ = inspect.signature(emit)  # type: ignore[attr-defined]
        operation.__name__ = emit.__name__
        return intrinsic(operation)

    return made


def _tag(builder: Any, instruction: Any, scope: str) -> Any:
    if not scope:
        return instruction
    module = builder.module
    domain = module.add_metadata(["contourlab"])
    nodes = {name: module.add_metadata([f"contourlab.{name}", domain]) for name in _SCOPES}
    instruction.set_metadata("alias.scope", module.add_metadata([nodes[scope]]))
    instruction.set_metadata("noalias", module.add_metadata([nodes[name] for name in _SCOPES if name != scope]))
    return instruction


def make_load(scope: str = "") -> Any:
    """Return ``load(address, index) -> float`` for one region of memory, or for any memory."""

    @instruction(NUMBER, WORD, WORD)
    def load_at(builder: Any, address: Any, index: Any) -> Any:
        base = builder.inttoptr(address, _DOUBLE.as_pointer())
        return _tag(builder, builder.load(builder.gep(base, [index], inbounds=True)), scope)

    return load_at


def make_store(scope: str = "") -> Any:
    """Return ``store(address, index, value)`` for one region of memory, or for any memory."""

    @instruction(types.void, WORD, WORD, NUMBER)
    def store_at(builder: Any, address: Any, index: Any, value: Any) -> None:
        base = builder.inttoptr(address, _DOUBLE.as_pointer())
        _tag(builder, builder.store(value, builder.gep(base, [index], inbounds=True)), scope)

    return store_at


load, store = make_load(), make_store()
load_parameter = make_load("parameter")
load_state, store_state = make_load("state"), make_store("state")
load_input = make_load("input")
store_output = make_store("output")
load_table = make_load("table")
load_ring, store_ring = make_load("ring"), make_store("ring")


@instruction(WORD, WORD, WORD)
def load_word(builder: Any, address: Any, index: Any) -> Any:
    """Read entry `index` of a writable array of 64-bit words."""
    return builder.load(builder.gep(builder.inttoptr(address, ir.IntType(64).as_pointer()), [index]))


@instruction(WORD, WORD, WORD)
def load_address(builder: Any, address: Any, index: Any) -> Any:
    """Read entry `index` of a constant array of 64-bit words."""
    base = builder.inttoptr(address, ir.IntType(64).as_pointer())
    return _tag(builder, builder.load(builder.gep(base, [index])), "table")


@instruction(WORD, NUMBER)
def truncate(builder: Any, x: Any) -> Any:
    """Return the whole part of a number, as an index."""
    return builder.fptosi(x, ir.IntType(64))


@instruction(types.void, *(WORD,) * 6, *(NUMBER,) * 3)
def call_step(builder: Any, function: Any, par: Any, table: Any, x: Any, inp: Any, out: Any, k: Any, t: Any, dt: Any) -> None:
    """Call a compiled step: the function itself, not its C wrapper."""
    # The first two arguments are for a result and an exception; both are unused.
    pointer = ir.IntType(8).as_pointer()
    kinds = [pointer, pointer] + [ir.IntType(64)] * 5 + [_DOUBLE] * 3
    target = builder.inttoptr(function, ir.FunctionType(ir.IntType(32), kinds).as_pointer())
    unused = builder.bitcast(cgutils.alloca_once(builder, ir.IntType(64)), pointer)
    builder.call(target, [unused, unused, par, table, x, inp, out, k, t, dt])
