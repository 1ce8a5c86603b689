"""The interface to machine code: arguments, refusals, and agreement of each plain function with its compiled form."""

from __future__ import annotations

import subprocess
import sys
import zlib
from functools import cache
from pathlib import Path
from types import FunctionType, ModuleType

import numpy as np
import pytest

from contourlab.errors import EngineError
from contourlab.native import kernel as native_kernel
from contourlab.native import store
from contourlab.native.kernel import Kernel, kernel


def _half(value):  # type: ignore[no-untyped-def]
    return 0.5 * value


@kernel("f8[:,:] f8[:] f8 i8[:]")
def sums(table, out, factor, count):  # type: ignore[no-untyped-def]
    for i in range(table.shape[0]):
        out[i] = 0.0
        for j in range(table.shape[1]):
            out[i] += factor * _half(table[i, j])
        count[0] += 1


@kernel("f8[:] f8")
def greedy(out, factor):  # type: ignore[no-untyped-def]
    made = np.empty(out.size)
    made[0] = factor
    out[0] = made[0]


@kernel("i8[:] i8")
def stepped(out, step):  # type: ignore[no-untyped-def]
    for i in range(0, out.size, step):
        out[i] = i


def test_a_kernel_that_raises_says_so() -> None:
    stepped(np.zeros(4, np.int64), 2)
    with pytest.raises(EngineError):
        stepped(np.zeros(4, np.int64), 0)


def test_a_kernel_agrees_with_its_source() -> None:
    table = np.random.default_rng(3).normal(size=(5, 3))
    plain, native = np.empty(5), np.empty(5)
    counts = np.zeros(1, np.int64), np.zeros(1, np.int64)
    sums.plain(table, plain, 3.0, counts[0])
    sums(table, native, 3.0, counts[1])
    np.testing.assert_allclose(native, plain, rtol=1e-15)
    assert counts[0][0] == counts[1][0] == 5


@pytest.mark.parametrize("table", [np.zeros((5, 3), np.float32), np.zeros(15), np.zeros((3, 5)).T])
def test_other_arrays_are_refused(table: np.ndarray) -> None:
    with pytest.raises(TypeError, match="argument 0"):
        sums(table, np.empty(5), 1.0, np.zeros(1, np.int64))


@pytest.mark.slow
def test_a_kernel_that_allocates_memory_is_refused() -> None:
    with pytest.raises(EngineError, match=r"greedy.*array"):
        greedy(np.empty(5), 1.0)


@pytest.mark.parametrize("damaged", [False, True])
def test_what_the_package_keeps_needs_no_numba(damaged: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(native_kernel, "KEPT", tmp_path)
    monkeypatch.setattr(store, "folder", lambda: tmp_path / "none")
    code = zlib.compress(stepped.lowered)
    (tmp_path / stepped.key).write_bytes(code[: len(code) // 2] if damaged else code)
    if not damaged:
        monkeypatch.setitem(sys.modules, "contourlab.native.compile", None)
    out = np.full(5, 7)
    Kernel(stepped.plain, "i8[:] i8")(out, 2)
    assert out.tolist() == [0, 7, 2, 7, 4]


def test_the_compiler_is_loaded_only_for_planning() -> None:
    script = "import sys, contourlab.feed, contourlab.native; sys.exit(bool({'numba', 'llvmlite'} & set(sys.modules)))"
    assert subprocess.run([sys.executable, "-c", script], check=False).returncode == 0


def test_the_key_of_a_kernel_covers_the_modules_of_all_that_it_calls() -> None:
    from contourlab.feed import bounds
    from contourlab.native.calls import modules

    assert modules(bounds._quickest.plain) == {"contourlab.feed.bounds"}


def test_the_constants_of_a_kernel_are_in_its_key() -> None:
    """The key holds the text of the modules of all functions, so a constant must be written there, not imported."""
    import ast
    import inspect

    from contourlab.feed import planner  # imports all kernels of the planner
    from contourlab.native.calls import called as called_by
    from contourlab.native.kernel import KERNELS

    @cache
    def imported(module: ModuleType) -> set[str]:
        tree = ast.parse(inspect.getsource(module))
        return {name.asname or name.name for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) for name in node.names}

    def check(function: FunctionType) -> None:
        module = inspect.getmodule(function)
        assert module is not None
        values = {name for name in function.__code__.co_names if isinstance(function.__globals__.get(name), int | float | tuple)}
        assert not values & imported(module), function
        for called in called_by(function).values():
            check(called)

    assert planner and len(KERNELS) > 10
    for one in KERNELS:
        check(one.plain)
