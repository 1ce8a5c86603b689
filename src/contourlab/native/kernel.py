"""Functions that run in machine code, compiled when they are first called.

    @kernel("f8[:] f8 f8[:]")
    def scaled(values, factor, out):
        for i in range(values.size):
            out[i] = factor * values[i]

A kernel returns nothing: results go into arrays. It may use numbers, its array arguments, plain functions of the project and their
constants. It must not make an array, list or dict: the caller passes the memory.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import Any

KERNELS: list[Kernel] = []
"""All kernels of the modules imported so far."""


class Kernel:
    """A plain function with its machine code.

    Parameters
    ----------
    plain : callable
        The same function in Python.
    signature : str
        Kinds of its arguments, separated by blanks: ``i8`` or ``f8``, or C-contiguous arrays of them with ``[:]``, ``[:,:]``, and so on.

    Raises
    ------
    EngineError
        When first called, if the function makes arrays.
    TypeError
        When called with an array of another kind, or one that is not contiguous.
    """

    def __init__(self, plain: Callable[..., None], signature: str) -> None:
        self.plain, self.signature = plain, signature
        self.__name__, self.__doc__ = plain.__name__, plain.__doc__

    @cached_property
    def compiled(self) -> Callable[..., None]:
        """The function in machine code."""
        from contourlab.native.compile import compiled_kernel  # loads the compiler

        return compiled_kernel(self.plain, self.signature)

    def __call__(self, *arguments: Any) -> None:
        """Run the function in machine code."""
        self.compiled(*arguments)


def kernel(signature: str) -> Callable[[Callable[..., None]], Kernel]:
    """Return a decorator that makes a function a `Kernel`."""

    def decorated(plain: Callable[..., None]) -> Kernel:
        KERNELS.append(Kernel(plain, signature))
        return KERNELS[-1]

    return decorated
