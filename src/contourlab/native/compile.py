"""Compile a plain function over numbers and arrays to machine code.

The function is compiled unchanged, to a C function or, for a kernel, to Numba's own, and kept in `store` under a key made of its sources,
so that the next process only loads it.
"""

from __future__ import annotations

import ctypes
import hashlib
import inspect
import sys
from collections.abc import Callable, Iterable
from types import FunctionType
from typing import Any

import numpy as np
from numba import cfunc, njit, types
from numba.core.errors import NumbaError

from contourlab.errors import EngineError
from contourlab.native import store

OPTIONS: dict[str, Any] = {"error_model": "numpy", "boundscheck": False}
INNER: dict[str, Any] = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True, "forceinline": True, "_nrt": False}
"""For functions that only compiled code calls: wrappers for Python and C take half of the compile time. Nothing counts references
to arrays, which took up to a third of the time of a search; so nothing may make one."""
PROJECT = __name__.partition(".")[0] + "."
_KINDS: dict[str, tuple[Any, Any, Any]] = {
    "i8": (types.int64, ctypes.c_int64, np.int64),
    "f8": (types.float64, ctypes.c_double, np.float64),
}
_ARRAY = (ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int64, ctypes.c_int64, ctypes.c_void_p)
"""How Numba's functions take an array: its owner (twice, none here), the number and the size of its elements, its address; then its shape
and its strides follow."""
_LLVM_TYPES = {ctypes.c_void_p: "ptr", ctypes.c_int64: "i64", ctypes.c_double: "double"}
_DATA = object.__basicsize__
"""Where an array of NumPy keeps the address of its elements: first of all, after what every object has."""
_ended = (ctypes.c_void_p * 2)()
_ENDED = ctypes.addressof(_ended), ctypes.addressof(_ended) + ctypes.sizeof(ctypes.c_void_p)
"""Where Numba's functions leave a result, which kernels do not have, and an exception, which their status tells too."""


def compiled(function: Any, signature: str, *, sources: Iterable[str], options: dict[str, Any] | None = None) -> Callable[..., None]:
    """Return a plain function of numbers as a C function.

    Parameters
    ----------
    function : callable
        Returns nothing.
    signature : str
        Kinds of the arguments, separated by blanks: ``i8`` (a whole number or an address) or ``f8``.
    sources : iterable of str
        Source text of everything compiled in; it determines the key.
    options : dict, optional
        Options of Numba; by default plain IEEE arithmetic without bounds checks.

    Returns
    -------
    callable
    """
    kinds = [_KINDS[word] for word in signature.split()]
    chosen = OPTIONS if options is None else options
    # A set has no fixed order: it would give another key in every process.
    settings = repr(sorted((name, sorted(value) if isinstance(value, set) else value) for name, value in chosen.items()))
    words = (function.__name__, signature, settings, *sources, inspect.getsource(compiled), store.toolchain())
    key = hashlib.sha256("\n".join(words).encode()).hexdigest()[:32]
    prototype: Any = ctypes.CFUNCTYPE(None, *(kind[1] for kind in kinds))

    def build() -> tuple[Any, str]:
        made: Any = cfunc(types.void(*(kind[0] for kind in kinds)), **chosen)(function)
        return made._library, made._wrapper_name

    return prototype(store.address(key, build, function.__name__.strip("_")))  # type: ignore[no-any-return]


def _called(function: Any) -> dict[str, Any]:
    """Return the functions of the project that a function calls, by the name it uses."""
    found = {name: function.__globals__.get(name) for name in function.__code__.co_names}
    ours = PROJECT, function.__module__
    return {name: value for name, value in found.items() if isinstance(value, FunctionType) and value.__module__.startswith(ours)}


def _modules(function: Any) -> set[str]:
    """Return the modules of a function and of all functions that it calls."""
    return {function.__module__}.union(*map(_modules, _called(function).values()))


def _twin(function: Any, done: dict[Any, Any]) -> Any:
    """Return the compiled twin of a function and of those that it calls."""
    if function not in done:
        scope = function.__globals__ | {name: _twin(value, done) for name, value in _called(function).items()}
        done[function] = njit(**OPTIONS, **INNER)(FunctionType(function.__code__, scope, function.__name__, function.__defaults__))
    return done[function]


def _taken(kinds: list[str]) -> list[Any]:
    """Return how a kernel takes its arguments, after the places of result and exception."""
    taken: list[Any] = [ctypes.c_void_p] * 2
    for kind in kinds:
        taken += _ARRAY + (ctypes.c_int64,) * (2 * kind.count(":")) if ":" in kind else (_KINDS[kind][1],)
    return taken


def _build(function: Any, kinds: list[str]) -> tuple[Any, str]:
    """Compile a kernel alone: a C function around it would optimise all of it again."""
    takes = [types.Array(_KINDS[kind[:2]][0], kind.count(":"), "C") if ":" in kind else _KINDS[kind][0] for kind in kinds]
    twin = _twin(function, {})
    try:
        twin.compile(types.void(*takes))
    except NumbaError as reason:
        raise EngineError(f"kernel {function.__name__} does not compile; it may not make an array, a list or a dict") from reason
    (made,) = twin.overloads.values()
    arguments = made.library.get_function(made.fndesc.llvm_func_name).arguments
    if [str(one.type) for one in arguments] != [_LLVM_TYPES[one] for one in _taken(kinds)]:
        raise EngineError(f"kernel {function.__name__}: this Numba hands over arguments in another way; install the one of constraints.txt")
    return made.library, made.fndesc.llvm_func_name


def compiled_kernel(function: Any, signature: str) -> Callable[..., None]:
    """Return the machine code of a `contourlab.native.kernel.Kernel`."""
    kinds = signature.split()
    sources = [inspect.getsource(sys.modules[name]) for name in (*sorted(_modules(function)), __name__)]
    words = (function.__name__, signature, *sources, store.toolchain())
    key = hashlib.sha256("\n".join(words).encode()).hexdigest()[:32]
    prototype: Any = ctypes.CFUNCTYPE(ctypes.c_int32, *_taken(kinds))
    run = prototype(store.address(key, lambda: _build(function, kinds), function.__name__.strip("_")))
    takes = [(kind.count(":"), np.dtype(_KINDS[kind[:2]][2])) for kind in kinds]

    def call(*arguments: Any) -> None:
        handed: list[Any] = [*_ENDED]
        for i, ((dims, dtype), value) in enumerate(zip(takes, arguments, strict=True)):
            if not dims:
                handed.append(value)
                continue
            if not isinstance(value, np.ndarray) or value.dtype != dtype or value.ndim != dims or not value.flags.c_contiguous:
                raise TypeError(f"{function.__name__}: argument {i} must be a contiguous array {kinds[i]}, not {value.dtype} {value.shape}")
            # Ten times as fast as `value.ctypes.data`.
            address = ctypes.c_void_p.from_address(id(value) + _DATA).value
            handed += [None, None, value.size, 8, address, *value.shape, *value.strides]
        if run(*handed):
            raise EngineError(f"kernel {function.__name__} raised an error: run its plain function to see it")

    return call
