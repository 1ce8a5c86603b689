"""Keys of steps: all that their machine code is made from."""

from __future__ import annotations

import dis
import hashlib
from functools import cache
from types import CodeType, FunctionType
from typing import Any

from contourlab import primitives
from contourlab.engine.step import Step

_PLAIN = (int, float, bool, str, tuple, type(None))


@cache
def source_key(step: Step) -> str:
    """Return a key of a step: its layout, and the code of all functions that it calls, with their constants."""
    functions: dict[FunctionType, None] = {}
    for function in (step.function, *((step.bank.function,) if step.bank else ())):
        assert isinstance(function, FunctionType)
        _collect(function, functions)
    words = [step.name, repr(step.layout)]
    for function in functions:
        words += code_words(function.__code__)
        words += [f"{name}={value!r}" for name, value in sorted(_names(function).items()) if isinstance(value, _PLAIN)]
    return hashlib.sha256("\n".join(words).encode()).hexdigest()[:32]


def _collect(function: FunctionType, functions: dict[FunctionType, None]) -> None:
    if function in functions or function.__module__ == primitives.__name__:
        return
    functions[function] = None
    for value in _names(function).values():
        if isinstance(value, FunctionType):
            _collect(value, functions)


def _names(function: FunctionType) -> dict[str, Any]:
    """Return every global name and closure variable that a function uses, with its value."""
    code = function.__code__
    # co_names holds attribute names as well, so ask the instructions which names are global.
    used = {name for inner in codes(code) for name in _globals_of(inner)}
    values = {name: function.__globals__[name] for name in sorted(used) if name in function.__globals__}
    for name, cell in zip(code.co_freevars, function.__closure__ or (), strict=True):
        values[name] = cell.cell_contents
    return values


def _globals_of(code: CodeType) -> set[str]:
    return {instruction.argval for instruction in dis.get_instructions(code) if instruction.opname == "LOAD_GLOBAL"}


def codes(code: CodeType) -> list[CodeType]:
    """Return a code object and those inside it."""
    return [code, *(inner for constant in code.co_consts if isinstance(constant, CodeType) for inner in codes(constant))]


def code_words(code: CodeType) -> list[str]:
    """Return the content of a code object, without its place in the file."""
    constants = [c if not isinstance(c, CodeType) else code_words(c) for c in code.co_consts]
    return [code.co_code.hex(), repr(constants), repr((code.co_names, code.co_varnames, code.co_freevars, code.co_cellvars))]
