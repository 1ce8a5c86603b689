"""Machine code on disk, keyed by what it was made from.

Numba's own cache does not notice an edit in a callee and cannot keep generated source; this one is keyed on the transitive sources, the
versions of the tools and the processor. Files appear by atomic rename, so two processes may fill it at once.
"""

from __future__ import annotations

import contextlib
import gc
import os
import pickle
import platform
import sys
import tempfile
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import llvmlite
import llvmlite.binding as llvm
import numba
from numba.core.registry import cpu_target

_FORMAT = 2
_addresses: dict[str, int] = {}
_alive: list[Any] = []  # libraries whose code is in use: dropping one would free the code


@cache
def toolchain() -> str:
    """Return the versions and the processor that machine code is valid for."""
    features = llvm.get_host_cpu_features().flatten() if hasattr(llvm, "get_host_cpu_features") else ""
    versions = (_FORMAT, numba.__version__, llvmlite.__version__, sys.version, platform.machine(), platform.system())
    return repr((*versions, llvm.get_host_cpu_name(), features))


@cache
def folder() -> Path:
    """Return the cache folder: ``CONTOURLAB_CACHE``, else the user's cache, else a temporary folder."""
    chosen = os.environ.get("CONTOURLAB_CACHE")
    home = os.environ.get("LOCALAPPDATA") or os.environ.get("XDG_CACHE_HOME")
    candidates = [Path(chosen)] if chosen else []
    with contextlib.suppress(RuntimeError):
        candidates.append(Path(home) / "contourlab" if home else Path.home() / ".cache" / "contourlab")
    candidates.append(Path(tempfile.gettempdir()) / f"contourlab-{os.getuid() if hasattr(os, 'getuid') else 'user'}")
    for candidate in candidates:
        with contextlib.suppress(OSError):
            candidate.mkdir(parents=True, exist_ok=True)
            handle, probe = tempfile.mkstemp(dir=candidate)
            os.close(handle)
            Path(probe).unlink()
            return candidate
    return Path(tempfile.mkdtemp(prefix="contourlab-"))


def address(key: str, build: Callable[[], Any], name: str, inner: bool = False) -> int:
    """Return the address of the code filed under `key`; build and file it first where it is missing.

    Parameters
    ----------
    key : str
    build : callable
        Returns a Numba cfunc.
    name : str
        Kept with the code, for people.
    inner : bool
        Whether the function inside the C wrapper is wanted, which the tick loop calls without a detour.
    """
    if key in _addresses:
        return _addresses[key]
    _addresses[key] = found = _loaded(key, build, name, inner)
    return found


def _loaded(key: str, build: Callable[[], Any], name: str, inner: bool) -> int:
    file = folder() / f"{key}.bin"
    with contextlib.suppress(OSError, EOFError, pickle.UnpicklingError, ValueError, KeyError, RuntimeError):
        return _restore(file.read_bytes())
    with _without_collector():
        compiled = build()
    _alive.append(compiled)
    library = compiled._library
    symbol = compiled._wrapper_name
    symbol = symbol.removeprefix("cfunc.") if inner else symbol
    _write(file, pickle.dumps((symbol, name, library.serialize_using_object_code())))
    return int(library.get_pointer_to_function(symbol))


@contextlib.contextmanager
def _without_collector() -> Iterator[None]:
    """Hold the garbage collector: a compiler makes much, next to none of it garbage before it is done, and is looked through in vain."""
    held = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if held:
            gc.enable()


def _restore(data: bytes) -> int:
    symbol, _, state = pickle.loads(data)
    library = cpu_target.target_context.codegen().unserialize_library(state)
    _alive.append(library)
    return int(library.get_pointer_to_function(symbol))


def _write(file: Path, data: bytes) -> None:
    with contextlib.suppress(OSError):  # a cache that cannot be written costs time, nothing else
        handle, temporary = tempfile.mkstemp(dir=file.parent)
        try:
            with os.fdopen(handle, "wb") as stream:
                stream.write(data)
            Path(temporary).replace(file)
        except OSError:
            Path(temporary).unlink(missing_ok=True)
            raise
