"""Loads and stores with alias scopes, so that the vectoriser knows that tables, states and signals never overlap."""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic

_DOUBLE = ir.DoubleType()
_SCOPES = ("parameter", "state", "input", "output", "table", "ring")


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

    @intrinsic
    def load_at(typingctx: Any, address: Any, index: Any) -> Any:
        def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
            base = builder.inttoptr(args[0], _DOUBLE.as_pointer())
            return _tag(builder, builder.load(builder.gep(base, [args[1]], inbounds=True)), scope)

        return types.float64(types.int64, types.int64), codegen

    return load_at


def make_store(scope: str = "") -> Any:
    """Return ``store(address, index, value)`` for one region of memory, or for any memory."""

    @intrinsic
    def store_at(typingctx: Any, address: Any, index: Any, value: Any) -> Any:
        def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
            base = builder.inttoptr(args[0], _DOUBLE.as_pointer())
            _tag(builder, builder.store(args[2], builder.gep(base, [args[1]], inbounds=True)), scope)
            return context.get_dummy_value()

        return types.void(types.int64, types.int64, types.float64), codegen

    return store_at


load, store = make_load(), make_store()
load_parameter = make_load("parameter")
load_state, store_state = make_load("state"), make_store("state")
load_input = make_load("input")
store_output = make_store("output")
load_table = make_load("table")
load_ring, store_ring = make_load("ring"), make_store("ring")


@intrinsic
def load_address(typingctx: Any, address: Any, index: Any) -> Any:
    """Read entry `index` of an array of 64-bit words that nobody writes to."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        base = builder.inttoptr(args[0], ir.IntType(64).as_pointer())
        return _tag(builder, builder.load(builder.gep(base, [args[1]])), "table")

    return types.int64(types.int64, types.int64), codegen


@intrinsic
def load_word(typingctx: Any, address: Any, index: Any) -> Any:
    """Read entry `index` of an array of 64-bit words that may have been written to."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        base = builder.inttoptr(args[0], ir.IntType(64).as_pointer())
        return builder.load(builder.gep(base, [args[1]]))

    return types.int64(types.int64, types.int64), codegen


@intrinsic
def truncate(typingctx: Any, x: Any) -> Any:
    """The whole part of a number, as an index."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.fptosi(args[0], ir.IntType(64))

    return types.int64(types.float64), codegen


def _make_call() -> Any:
    word, double = types.int64, types.float64
    arguments = (word,) * 5 + (double,) * 3

    @intrinsic
    def call(typingctx: Any, function: Any, par: Any, table: Any, x: Any, inp: Any, out: Any, k: Any, t: Any, dt: Any) -> Any:
        def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
            # The compiled function itself, not its C wrapper: two more arguments, for a result and an exception that it never gives.
            pointer = ir.IntType(8).as_pointer()
            kinds = [pointer, pointer] + [ir.IntType(64)] * 5 + [_DOUBLE] * 3
            target = builder.inttoptr(args[0], ir.FunctionType(ir.IntType(32), kinds).as_pointer())
            unused = builder.bitcast(cgutils.alloca_once(builder, ir.IntType(64)), pointer)
            builder.call(target, [unused, unused, *args[1:]])
            return context.get_dummy_value()

        return types.void(word, *arguments), codegen

    return call


call_step = _make_call()
