"""Functions that run in machine code, compiled when they are first called.

    @kernel("f8[:] f8 f8[:]")
    def scaled(values, factor, out):
        for i in range(values.size):
            out[i] = factor * values[i]

A kernel returns nothing: results go into arrays. It may use numbers, its array arguments, plain functions of the project and their
constants. It must not make an array, list or dict: the caller passes the memory.

Numba turns it into the language of LLVM, which takes seconds; LLVM, in a tenth of that, into machine code, which `store` keeps. What Numba
found is the same on every machine: `contourlab.app.precompile` keeps it in the package, so a wheel needs LLVM alone.
"""

from __future__ import annotations

import contextlib
import ctypes
import hashlib
import inspect
import sys
import zlib
from collections.abc import Callable
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.errors import EngineError
from contourlab.native.calls import modules

KEPT = Path(__file__).with_name("kept")
KERNELS: list[Kernel] = []
"""All kernels of the modules imported so far."""
KINDS = {"i8": (ctypes.c_int64, np.dtype(np.int64)), "f8": (ctypes.c_double, np.dtype(np.float64))}
_ARRAY = (ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int64, ctypes.c_int64, ctypes.c_void_p)
"""How Numba's functions take an array: its owner (twice, none here), the number and the size of its elements, its address; then its shape
and its strides follow."""
_DATA = object.__basicsize__
"""Where an array of NumPy keeps the address of its elements: first of all, after what every object has."""
_ended = (ctypes.c_void_p * 2)()
_ENDED = ctypes.addressof(_ended), ctypes.addressof(_ended) + ctypes.sizeof(ctypes.c_void_p)
"""Where Numba's functions leave a result, which kernels do not have, and an exception, which their status tells too."""


@cache
def _compiler() -> list[str]:
    return [file.read_text(encoding="utf-8") for file in sorted(Path(__file__).parent.glob("*.py"))]


def _digest(*words: object) -> str:
    return hashlib.sha256(repr(words).encode()).hexdigest()[:32]


class Kernel:
    """A plain function with its machine code.

    Parameters
    ----------
    plain : callable
        The same function in Python.
    signature : str
        Kinds of its arguments, separated by blanks: ``i8`` or ``f8``, or C-contiguous arrays of them with ``[:]``, ``[:,:]``, and so on.
    fastmath : tuple of str
        Liberties of LLVM with floating-point numbers; by default none.

    Raises
    ------
    EngineError
        When first called, if the function makes arrays.
    TypeError
        When called with an array of another kind, or one that is not contiguous.
    """

    def __init__(self, plain: Callable[..., None], signature: str, fastmath: tuple[str, ...] = ()) -> None:
        self.plain, self.kinds, self.fastmath = plain, signature.split(), fastmath
        self.__name__, self.__doc__ = plain.__name__, plain.__doc__

    @cached_property
    def key(self) -> str:
        """Digest of all that the language of LLVM is made from."""
        sources = [inspect.getsource(sys.modules[name]) for name in sorted(modules(self.plain))]
        return _digest(self.__name__, self.kinds, self.fastmath, sources, _compiler())

    @property
    def taken(self) -> list[Any]:
        """How the compiled function takes its arguments, after the places of result and exception."""
        taken: list[Any] = [ctypes.c_void_p] * 2
        for kind in self.kinds:
            taken += _ARRAY + (ctypes.c_int64,) * (2 * kind.count(":")) if ":" in kind else (KINDS[kind][0],)
        return taken

    @property
    def lowered(self) -> bytes:
        """The bitcode of LLVM, of a function ``run``: kept in the package, or from Numba."""
        with contextlib.suppress(OSError, zlib.error):
            return zlib.decompress((KEPT / self.key).read_bytes())
        from contourlab.native.compile import lowered  # loads Numba

        return lowered(self.plain, self.kinds, self.fastmath, self.taken)

    @cached_property
    def compiled(self) -> Callable[..., None]:
        """The function in machine code."""
        from contourlab.native import llvm, store

        key = _digest(self.key, store.toolchain())
        code = (store.read(key) or [b""])[0]
        if not code:
            code = llvm.object_code(self.lowered, optimised=True)
            store.write(key, [code])
        run = llvm.loaded(code, "run", ctypes.CFUNCTYPE(ctypes.c_int32, *self.taken))
        takes = [(kind.count(":"), KINDS[kind[:2]][1]) for kind in self.kinds]

        def call(*arguments: Any) -> None:
            handed: list[Any] = [*_ENDED]
            for i, ((dims, dtype), value) in enumerate(zip(takes, arguments, strict=True)):
                if not dims:
                    handed.append(value)
                    continue
                if not isinstance(value, np.ndarray) or value.dtype != dtype or value.ndim != dims or not value.flags.c_contiguous:
                    found = f"{value.dtype} {value.shape}"
                    raise TypeError(f"{self.__name__}: argument {i} must be a contiguous array {self.kinds[i]}, not {found}")
                # Ten times as fast as `value.ctypes.data`.
                address = ctypes.c_void_p.from_address(id(value) + _DATA).value
                handed += [None, None, value.size, 8, address, *value.shape, *value.strides]
            if run(*handed):
                raise EngineError(f"kernel {self.__name__} raised an error: run its plain function to see it")

        return call

    def __call__(self, *arguments: Any) -> None:
        """Run the function in machine code."""
        self.compiled(*arguments)


def kernel(signature: str, fastmath: tuple[str, ...] = ()) -> Callable[[Callable[..., None]], Kernel]:
    """Return a decorator that makes a function a `Kernel`."""

    def decorated(plain: Callable[..., None]) -> Kernel:
        KERNELS.append(Kernel(plain, signature, fastmath))
        return KERNELS[-1]

    return decorated
