"""What the sampler needs in compiled code: loads and stores that the vectoriser understands, and functions without branches."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from types import FunctionType
from typing import Any

from llvmlite import ir
from numba import njit, types
from numba.extending import intrinsic

from contourlab.engine.translate import polynomials
from contourlab.native.compile import INNER

# No nnan/ninf: a flag that assumes finite numbers would fold away every check for them. Of the others, `contract` and `arcp` (a sixth of
# the jerk) change a last digit and `nsz` the sign of a zero: nothing here counts, jumps or divides by what they touch.
OPTIONS: dict[str, Any] = {"fastmath": {"contract", "nsz", "arcp"}, "error_model": "numpy", "boundscheck": False}
INLINE: dict[str, Any] = {**OPTIONS, **INNER, "forceinline": True}
_DOUBLE, _INT = ir.DoubleType(), ir.IntType(64)
_REGIONS = ("parameter", "input", "scratch", "output")
_WORD, _NUMBER = types.int64, types.float64


def _instruction(returns: Any, *takes: Any) -> Callable[[Callable[..., Any]], Any]:
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


def _tagged(builder: Any, instruction: Any, region: str) -> Any:
    """Tell the vectoriser that the regions of memory never overlap."""
    module = builder.module
    domain = module.add_metadata(["contourlab"])
    nodes = {name: module.add_metadata([f"contourlab.{name}", domain]) for name in _REGIONS}
    instruction.set_metadata("alias.scope", module.add_metadata([nodes[region]]))
    instruction.set_metadata("noalias", module.add_metadata([nodes[name] for name in _REGIONS if name != region]))
    return instruction


def _load(region: str) -> Any:
    """Return ``load(address, index) -> float`` for one region of memory."""

    @_instruction(_NUMBER, _WORD, _WORD)
    def load_at(builder: Any, address: Any, index: Any) -> Any:
        base = builder.inttoptr(address, _DOUBLE.as_pointer())
        return _tagged(builder, builder.load(builder.gep(base, [index], inbounds=True)), region)

    return load_at


def _store(region: str) -> Any:
    """Return ``store(address, index, value)`` for one region of memory."""

    @_instruction(types.void, _WORD, _WORD, _NUMBER)
    def store_at(builder: Any, address: Any, index: Any, value: Any) -> None:
        base = builder.inttoptr(address, _DOUBLE.as_pointer())
        _tagged(builder, builder.store(value, builder.gep(base, [index], inbounds=True)), region)

    return store_at


load_parameter, load_input, load_scratch = _load("parameter"), _load("input"), _load("scratch")
store_scratch, store_output = _store("scratch"), _store("output")


@_instruction(_WORD, _NUMBER)
def truncate(builder: Any, x: Any) -> Any:
    """Return the whole part of a number, as an index."""
    return builder.fptosi(x, _INT)


def _compare(predicate: str) -> Any:
    @_instruction(_NUMBER, _NUMBER, _NUMBER)
    def operation(builder: Any, a: Any, b: Any) -> Any:
        return builder.select(builder.fcmp_ordered(predicate, b, a), b, a)  # a NaN in a stays

    return operation


minimum, maximum = _compare("<"), _compare(">")


@_instruction(_NUMBER, _NUMBER)
def _rint(builder: Any, x: Any) -> Any:
    return builder.call(builder.module.declare_intrinsic("llvm.rint", [_DOUBLE]), [x])


@_instruction(_NUMBER, _NUMBER, _NUMBER, _NUMBER)
def _fma(builder: Any, a: Any, b: Any, c: Any) -> Any:
    return builder.fma(a, b, c)


@_instruction(_NUMBER, types.boolean, _NUMBER, _NUMBER)
def _select(builder: Any, condition: Any, a: Any, b: Any) -> Any:
    flag = condition if condition.type == ir.IntType(1) else builder.trunc(condition, ir.IntType(1))
    return builder.select(flag, a, b)


def _bit(mask: int) -> Any:
    @_instruction(types.boolean, _NUMBER)
    def operation(builder: Any, n: Any) -> Any:
        return builder.icmp_signed("!=", builder.and_(builder.fptosi(n, _INT), ir.Constant(_INT, mask)), ir.Constant(_INT, 0))

    return operation


_OPERATIONS: dict[str, Any] = {"fma": _fma, "rint": _rint, "select": _select, "odd": _bit(1), "twos": _bit(2)}


def _compiled(function: Any) -> Any:
    """Return a polynomial in machine code."""
    called = {name: _compiled(value) for name, value in _functions_of(function).items() if name not in _OPERATIONS}
    return njit(**INLINE)(FunctionType(function.__code__, _OPERATIONS | called, function.__name__))


def _functions_of(function: Any) -> dict[str, Any]:
    return {name: function.__globals__[name] for name in function.__code__.co_names if name in function.__globals__}


poly_sin, poly_cos = _compiled(polynomials.sin), _compiled(polynomials.cos)
