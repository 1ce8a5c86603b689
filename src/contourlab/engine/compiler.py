"""Compile a plain step to a machine-code function over lanes.

The source of a step is compiled unchanged: its functions are rebuilt with compiled primitives and wrapped in a loop over lanes. The wrapper
is a C function of addresses, so that the tick loop that calls it is never compiled again.
"""

from __future__ import annotations

import dis
import hashlib
import inspect
import types as python_types
from collections.abc import Callable
from functools import cache
from typing import Any

from numba import cfunc, njit, types
from numba.core.errors import NumbaError, UnsupportedBytecodeError

from contourlab import primitives
from contourlab.engine import intrinsics, memory
from contourlab.engine.intrinsics import INLINE, OPTIONS, VECTOR_OPERATIONS, maths
from contourlab.engine.step import Bank, Port, Step, record, rows
from contourlab.errors import EngineError
from contourlab.native import store

STEP_SIGNATURE = types.void(*(types.int64,) * 5, *(types.float64,) * 3)
_PRIMITIVES = {getattr(primitives, name): name for name in primitives.__all__ if callable(getattr(primitives, name))}
_PLAIN = (int, float, bool, str, tuple, type(None))


@cache
def _target(width: int) -> dict[str, Callable[..., Any]]:
    return {**maths(width), **VECTOR_OPERATIONS}


def _names(function: Any) -> dict[str, Any]:
    """Return every global name and closure variable that a function uses, with its value."""
    code = function.__code__
    # co_names holds attribute names as well, so ask the instructions which names are global.
    used = {i.argval for i in dis.get_instructions(code) if i.opname == "LOAD_GLOBAL"}
    found = {name: function.__globals__[name] for name in sorted(used) if name in function.__globals__}
    for name, cell in zip(code.co_freevars, function.__closure__ or (), strict=True):
        found[name] = cell.cell_contents
    return found


def _walk(function: Any, seen: dict[Any, None]) -> None:
    if function in seen:
        return
    seen[function] = None
    for value in _names(function).values():
        if isinstance(value, python_types.FunctionType) and _PRIMITIVES.get(value) not in _target(1):
            _walk(value, seen)


def _code_words(code: python_types.CodeType) -> list[str]:
    """Return the content of a code object without its place in the file."""
    constants = [c if not isinstance(c, python_types.CodeType) else _code_words(c) for c in code.co_consts]
    return [code.co_code.hex(), repr(constants), repr((code.co_names, code.co_varnames, code.co_freevars, code.co_cellvars))]


@cache
def _engine_sources() -> str:
    """Return the sources that every step is compiled with, so that an edit here discards all machine code."""
    return "".join(inspect.getsource(module) for module in (intrinsics, memory))


def source_key(step: Step, width: int) -> str:
    """Return the key of a step's machine code: a hash of its transitive sources, layout, lanes, and tool chain."""
    seen: dict[Any, None] = {}
    _walk(step.function, seen)
    if step.bank:
        _walk(step.bank.function, seen)
    words: list[str] = [repr(step.layout), wrapper_source(step, width), _engine_sources(), store.toolchain()]
    for function in seen:
        words += _code_words(function.__code__)
        words += [f"{name}={value!r}" for name, value in sorted(_names(function).items()) if isinstance(value, _PLAIN)]
    return hashlib.sha256("\n".join(words).encode()).hexdigest()[:32]


class _Specialiser:
    """Rebuilds functions with compiled primitives in place of plain ones."""

    def __init__(self, width: int) -> None:
        self.target = _target(width)
        self.done: dict[Any, Any] = {}

    def function(self, plain: Any) -> Any:
        """Return the compiled twin of a plain function."""
        if plain not in self.done:
            scope: dict[str, Any] = {"__builtins__": __builtins__, "__name__": plain.__module__}
            scope.update({name: self.value(value, plain) for name, value in _names(plain).items()})
            # Free variables become cells again; globals keep their names.
            cells = tuple(python_types.CellType(scope[name]) for name in plain.__code__.co_freevars)
            rebuilt = python_types.FunctionType(plain.__code__, scope, plain.__name__, plain.__defaults__, cells)
            self.done[plain] = njit(**INLINE)(rebuilt)
        return self.done[plain]

    def value(self, value: Any, user: Any) -> Any:
        name = _PRIMITIVES.get(value) if callable(value) else None
        if name in self.target:
            return self.target[name]
        if isinstance(value, python_types.FunctionType):
            return self.function(value)
        if isinstance(value, (*_PLAIN, type, python_types.ModuleType)):
            return value
        raise EngineError(f"step function {user.__qualname__} uses {value!r}, which cannot be compiled: use the names of primitives")


def _read(row_source: Callable[[int], str], ports: tuple[Port, ...]) -> str:
    """Return source that builds one value per port from rows of lanes."""
    parts, row = [], 0
    for port in ports:
        items = [row_source(row + i) for i in range(port.rows)]
        parts.append(f"({', '.join(items)},)" if port.size else items[0])
        row += port.rows
    return "".join(f"{part}, " for part in parts)


def _write(storer: str, address: str, value: str, ports: tuple[Port, ...], width: int) -> list[str]:
    lines, row = [], 0
    for n, port in enumerate(ports):
        for i in range(port.rows):
            item = f"{value}[{n}][{i}]" if port.size else f"{value}[{n}]"
            lines.append(f"        {storer}({address}, {(row + i) * width} + i, {item})")
        row += port.rows
    return lines


def wrapper_source(step: Step, width: int) -> str:
    """Return the readable source of the lane loop around a step.

    `inp` is the address of a list of row addresses (inputs can be anywhere in the signal table); the others are contiguous rows of lanes.
    """

    def contiguous(region: str, address: str) -> Callable[[int], str]:
        return lambda row: f"load_{region}({address}, {row * width} + i)"

    parameters = tuple(Port(name) for name in step.parameters)
    n_input = sum(port.rows for port in step.inputs)
    head = [f"    source{n} = load_address(inp, {n})" for n in range(n_input)]
    head += [f"    table{n} = load_address(table, {n})" for n in range(len(step.tables))]
    body = []
    par = _read(contiguous("parameter", "par"), parameters) + "".join(f"table{n}, " for n in range(len(step.tables)))
    if step.ring:
        n = len(step.tables)
        index = [port.name for port in step.inputs].index(step.ring)
        head += [f"    ring, mask = load_address(table, {n}), load_address(table, {n + 1})"]
        head += [f"    slot = (truncate(k) & mask) * {width}"]
        body += [f"        store_ring(ring, slot + i, inputs[{index}])"]
        par += "(ring + 8 * i, mask), "
    states = f"State({_read(contiguous('state', 'x'), step.own_states)})" if step.own_states else "()"
    inputs = f"Input({_read(lambda row: f'load_input(source{row}, i)', step.inputs)})" if step.inputs else "()"
    lines = ["def component(par, table, x, inp, out, k, t, dt):", *head, f"    for i in range({width}):"]
    lines += [f"        inputs = {inputs}", *body]
    lines += [f"        values, states, clock = {f'Par({par})' if par else '()'}, {states}, Clock(k, t, dt)"]
    if step.bank:
        lines += _bank_source(step.bank, rows(step.own_states), width)
    lines += [f"        x_next, y = step(values, states, inputs, clock{', found' if step.bank else ''})"]
    lines += _write("store_state", "x", "x_next", step.own_states, width)
    lines += _write("store_output", "out", "y", step.outputs, width)
    return "\n".join(lines) + "\n"


def _bank_source(bank: Bank, first: int, width: int) -> list[str]:
    """Return source that runs the members of a bank, whose states start at row `first`, in the loop over lanes."""
    lines = [f"        nothing = ({'0.0, ' * bank.n_found})", "        found = nothing", f"        for m in range({bank.count}):"]
    lines += [f"            base = ({first} + m * {bank.size}) * {width} + i"]
    lines += [f"            before = ({''.join(f'load_state(x, base + {j * width}), ' for j in range(bank.size))})"]
    lines += ["            kept, found = member(values, states, before, found, float(m), inputs, clock)"]
    return lines + [f"            store_state(x, base + {j * width}, kept[{j}])" for j in range(bank.size)]


def _compile(step: Step, width: int) -> Any:
    scope: dict[str, Any] = {name: getattr(memory, name) for name in dir(memory) if name.startswith(("load_", "store_"))}
    specialised = _Specialiser(width).function
    scope.update(
        truncate=memory.truncate,
        step=specialised(step.function),
        member=specialised(step.bank.function) if step.bank else None,
        Par=step.par_type,
        State=record(tuple(port.name for port in step.own_states)),
        Input=record(tuple(port.name for port in step.inputs)),
        Clock=primitives.Clock,
    )
    exec(compile(wrapper_source(step, width), f"<{step.name}>", "exec"), scope)
    try:
        compiled = cfunc(STEP_SIGNATURE, **OPTIONS)(scope["component"])
    except (NumbaError, UnsupportedBytecodeError, NotImplementedError) as error:
        raise EngineError(f"{step.name} cannot be compiled: {_first_words(error)}") from error
    if "NRT_" in compiled._library.get_llvm_str():
        # Code that allocates memory would also crash when loaded from the cache into a process without a memory manager.
        raise EngineError(f"{step.name} makes a list, a dict or an array: a step works on numbers and tuples of numbers")
    return compiled


def _first_words(error: Exception) -> str:
    """Return the line of a compiler's message that states the error; the lines before it give its place."""
    lines = [line.strip() for line in str(error).splitlines() if line.strip()]
    return next((line for line in lines if not line.startswith(("Failed in ", "During:", "File "))), type(error).__name__)


@cache
def compile_step(step: Step, width: int) -> int:
    """Return the address of a step compiled over `width` lanes, from the cache on disk if possible.

    Raises
    ------
    EngineError
        If the step uses something that cannot be compiled, or its tuples do not fit its ports.
    """
    return store.address(source_key(step, width), lambda: _compile(step, width), step.name, inner=True)
