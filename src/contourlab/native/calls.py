"""What a kernel calls: plain functions of the project, and instructions of LLVM."""

from __future__ import annotations

from collections.abc import Callable
from types import FunctionType
from typing import Any


def called(function: Any) -> dict[str, Any]:
    """Return the functions of the project that a function calls, by the name it uses."""
    found = {name: function.__globals__.get(name) for name in function.__code__.co_names}
    ours = __name__.partition(".")[0] + ".", function.__module__
    return {name: value for name, value in found.items() if isinstance(value, FunctionType) and value.__module__.startswith(ours)}


def modules(function: Any) -> set[str]:
    """Return the modules of a function and of all functions that it calls."""
    return {function.__module__}.union(*map(modules, called(function).values()))


def instruction(signature: str) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Return a decorator of ``emit(builder, *values) -> value``, which writes the instructions of LLVM for a call of it in a kernel.

    `signature` has the kinds of result and arguments: ``i8``, ``f8``, ``b1`` or ``void``.
    """

    def decorated(emit: Callable[..., Any]) -> Callable[..., Any]:
        emit.__dict__["instruction"] = signature.split()
        return emit

    return decorated
