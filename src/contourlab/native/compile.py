"""Numba turns a kernel, unchanged, into the language of LLVM."""

from __future__ import annotations

import ctypes
import inspect
from collections.abc import Iterable, Sequence
from functools import cache
from types import FunctionType
from typing import Any

import llvmlite.binding as llvm
from numba import njit, types
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler_lock import global_compiler_lock
from numba.core.errors import NumbaError
from numba.core.registry import cpu_target
from numba.extending import intrinsic

from contourlab.errors import EngineError
from contourlab.native.calls import called
from contourlab.native.store import without_collector

_OPTIONS: dict[str, Any] = {"error_model": "numpy", "boundscheck": False, "no_rewrites": True, "forceinline": True, "_nrt": False}
"""Plain IEEE arithmetic without bounds checks. Nothing counts references to arrays, which took up to a third of the time of a search; so
nothing may make one."""
_OPTIONS |= {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}
_TYPES = {"i8": types.int64, "f8": types.float64, "b1": types.boolean, "void": types.void}
_LLVM_TYPES = {ctypes.c_void_p: "ptr", ctypes.c_int64: "i64", ctypes.c_double: "double"}


class _Library(JITCodeLibrary):  # type: ignore[misc]
    """What Numba wrote for a function and those that it calls: LLVM runs once, when all of a kernel is there."""

    def _optimize_functions(self, ll_module: Any) -> None: ...

    def _optimize_final_module(self) -> None: ...

    def _finalize_final_module(self) -> None:
        self._finalized = True

    def get_pointer_to_function(self, name: str) -> int:
        self._ensure_finalized()
        return 0


def _instruction(emit: Any) -> Any:
    returns, *takes = (_TYPES[word] for word in emit.instruction)

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        value = emit(builder, *args)
        return context.get_dummy_value() if returns is types.void else value

    def operation(typingctx: Any, *kinds: Any) -> Any:
        return returns(*takes), codegen

    # Numba binds the arguments by this signature.
    operation.__signature__ = inspect.signature(emit)  # type: ignore[attr-defined]
    operation.__name__ = emit.__name__
    return intrinsic(operation)


@cache
def _twin(function: Any, fastmath: frozenset[str]) -> Any:
    """Return the twin of a function and of those that it calls, for Numba."""
    if hasattr(function, "instruction"):
        return _instruction(function)
    scope = function.__globals__ | {name: _twin(value, fastmath) for name, value in called(function).items()}
    own = FunctionType(function.__code__, scope, function.__name__, function.__defaults__)
    return njit(fastmath=set(fastmath), **_OPTIONS)(own)


def lowered(function: Any, kinds: Sequence[str], fastmath: Iterable[str], taken: Sequence[Any]) -> bytes:
    """Return a kernel as bitcode of LLVM, in which only the function ``run`` is visible; it takes arguments as `taken` says.

    Raises
    ------
    EngineError
        If Numba cannot compile it.
    """
    takes = [types.Array(_TYPES[kind[:2]], kind.count(":"), "C") if ":" in kind else _TYPES[kind] for kind in kinds]
    codegen = cpu_target.target_context.codegen()
    with global_compiler_lock, without_collector():
        vars(codegen).update(_library_class=_Library, set_env=lambda *_: None)
        try:
            twin = _twin(function, frozenset(fastmath))
            twin.compile(types.void(*takes))
        except NumbaError as reason:
            raise EngineError(f"kernel {function.__name__} does not compile; it may not make an array, a list or a dict") from reason
        finally:
            del codegen._library_class, codegen.set_env
    (made,) = twin.overloads.values()
    module = made.library._final_module.clone()
    run = module.get_function(made.fndesc.llvm_func_name)
    if [str(one.type) for one in run.arguments] != [_LLVM_TYPES[one] for one in taken]:
        raise EngineError(f"kernel {function.__name__}: this Numba hands over arguments in another way; install the one of constraints.txt")
    for part in module.functions:
        if not part.is_declaration:
            part.linkage = llvm.Linkage.internal
    run.linkage, run.name = llvm.Linkage.external, "run"
    # A third of the size, and nothing that depends on the processor.
    passes = llvm.create_new_module_pass_manager()
    passes.add_sroa_pass()
    passes.add_instruction_combine_pass()
    passes.add_simplify_cfg_pass()
    passes.add_strip_symbols_pass()
    passes.run(module, llvm.create_pass_builder(codegen._tm, llvm.create_pipeline_tuning_options()))
    bitcode: bytes = module.as_bitcode()
    return bitcode
