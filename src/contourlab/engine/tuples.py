"""The vector primitives in compiled code: written out for each length, so that no loop stands inside a lane."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numba import types
from numba.extending import overload

from contourlab.engine.intrinsics import INLINE


def _written_out(arguments: str, term: str, count: int, total: bool) -> Any:
    terms = [term.replace("#", str(i)) for i in range(count)]
    body = " + ".join(terms) if total else f"({', '.join(terms)},)"
    scope: dict[str, Any] = {}
    exec(f"def implementation({arguments}):\n    return {body}\n", scope)
    return scope["implementation"]


def _length(*vectors: Any) -> int | None:
    if all(isinstance(v, types.BaseTuple) for v in vectors) and len({v.count for v in vectors}) == 1:
        return int(vectors[0].count)
    return None


def dot(a, b): ...  # type: ignore[no-untyped-def]
def add(a, b): ...  # type: ignore[no-untyped-def]
def sub(a, b): ...  # type: ignore[no-untyped-def]
def scale(factor, a): ...  # type: ignore[no-untyped-def]
def lincomb(p, a, q, b): ...  # type: ignore[no-untyped-def]


def _overloaded(operation: Any, term: str, total: bool = False) -> None:
    """Write an operation of two vectors out for each length."""

    @overload(operation, jit_options=INLINE)
    def written(a, b):  # type: ignore[no-untyped-def]
        n = _length(a, b)
        return None if n is None else _written_out("a, b", term, n, total)


_overloaded(dot, "a[#] * b[#]", total=True)
_overloaded(add, "a[#] + b[#]")
_overloaded(sub, "a[#] - b[#]")


@overload(scale, jit_options=INLINE)
def _scale(factor, a):  # type: ignore[no-untyped-def]
    n = _length(a)
    return None if n is None else _written_out("factor, a", "factor * a[#]", n, False)


@overload(lincomb, jit_options=INLINE)
def _lincomb(p, a, q, b):  # type: ignore[no-untyped-def]
    n = _length(a, b)
    return None if n is None else _written_out("p, a, q, b", "p * a[#] + q * b[#]", n, False)


VECTOR_OPERATIONS: dict[str, Callable[..., Any]] = {"dot": dot, "add": add, "sub": sub, "scale": scale, "lincomb": lincomb}
