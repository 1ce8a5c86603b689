"""Machine code on disk, filed by what it was made from.

Numba's own cache does not notice an edit in a callee and cannot keep generated source. Here the key is made of the transitive sources, the
versions of the tools and the processor. Files appear by atomic rename, so two processes may write at once.

Code from the cache runs with the rights of the user. So the folder must belong to the user alone, and each file carries a digest of its key
and content that is checked before anything is loaded. A file that fails a check is compiled again and replaced.
"""

from __future__ import annotations

import atexit
import contextlib
import gc
import hashlib
import logging
import os
import platform
import shutil
import stat
import struct
import sys
import tempfile
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import llvmlite
import llvmlite.binding as llvm

_MAGIC = b"contourlab machine code 4\n"
_DIGEST = hashlib.sha256().digest_size
_LENGTH = struct.Struct("<Q")
_OTHERS_WRITE = stat.S_IWGRP | stat.S_IWOTH


@cache
def toolchain() -> str:
    """Return the versions and the processor that machine code is valid for."""
    features = llvm.get_host_cpu_features().flatten() if hasattr(llvm, "get_host_cpu_features") else ""
    versions = (_MAGIC, llvmlite.__version__, sys.version, platform.machine(), platform.system())
    return repr((*versions, llvm.get_host_cpu_name(), features))


@cache
def folder() -> Path:
    """Return the cache folder: ``CONTOURLAB_CACHE``, else one in the user's cache; a private temporary one if that is not safe."""
    wanted = _wanted_folder()
    fault = _fault_of(wanted)
    if not fault:
        return wanted
    private = Path(tempfile.mkdtemp(prefix="contourlab-"))
    atexit.register(shutil.rmtree, private, ignore_errors=True)
    _warn(f"{wanted}: {fault}. Each process compiles again: set CONTOURLAB_CACHE to a folder of your own")
    return private


def _wanted_folder() -> Path:
    chosen = os.environ.get("CONTOURLAB_CACHE")
    if chosen:
        return Path(chosen)
    home = os.environ.get("LOCALAPPDATA") or os.environ.get("XDG_CACHE_HOME")
    return Path(home or os.path.expanduser("~/.cache")) / "contourlab"  # noqa: PTH111  Path.expanduser raises where there is no home


def _fault_of(wanted: Path) -> str:
    """Make the folder if needed; return why it is not safe to use, or nothing."""
    try:
        wanted.mkdir(mode=0o700, parents=True, exist_ok=True)
        state = wanted.lstat()
        if not stat.S_ISDIR(state.st_mode):
            return "a link, not a folder"
        if _foreign(state):
            return "other users own it or may write there"
        wanted.chmod(0o700)
        tempfile.TemporaryFile(dir=wanted).close()
    except OSError as error:
        return f"not usable ({error.strerror})"
    return ""


def _foreign(state: os.stat_result) -> bool:
    """Return whether another user may have written a file or folder."""
    return hasattr(os, "geteuid") and (state.st_uid != os.geteuid() or bool(state.st_mode & _OTHERS_WRITE))


@cache
def _warn(message: str) -> None:
    logging.getLogger("contourlab").warning("contourlab: %s", message)


@contextlib.contextmanager
def without_collector() -> Iterator[None]:
    """Pause the garbage collector: a compiler makes many objects, and nearly all live until it is done."""
    held = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if held:
            gc.enable()


def _file(key: str) -> Path:
    return folder() / f"{key}.code"


def read(key: str) -> list[bytes] | None:
    """Return what `write` filed under a key; None if there is nothing, or it fails a check."""
    try:
        return _checked(key)
    except FileNotFoundError:
        return None
    except (OSError, ValueError):
        _warn(f"{folder()}: damaged or foreign machine code is compiled again")
        return None


def _checked(key: str) -> list[bytes]:
    # A link is not followed, and a pipe does not block.
    handle = os.open(_file(key), os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    with os.fdopen(handle, "rb") as stream:
        if _foreign(os.fstat(handle)):
            raise ValueError("written by another user")
        head, digest, body = stream.read(len(_MAGIC)), stream.read(_DIGEST), stream.read()
    if head != _MAGIC or digest != _digest(key, body):
        raise ValueError("damaged")
    return _parts(body)


def _digest(key: str, body: bytes) -> bytes:
    return hashlib.sha256(key.encode() + body).digest()


def _parts(body: bytes) -> list[bytes]:
    parts, at = [], 0
    while at < len(body):
        (length,) = _LENGTH.unpack_from(body, at)
        at += _LENGTH.size
        parts.append(body[at : at + length])
        at += length
    return parts


def write(key: str, parts: list[bytes]) -> None:
    """File some bytes under a key. A folder that cannot be written costs time, nothing else."""
    body = b"".join(_LENGTH.pack(len(part)) + part for part in parts)
    with contextlib.suppress(OSError):
        handle, temporary = tempfile.mkstemp(dir=folder())
        try:
            with os.fdopen(handle, "wb") as stream:
                stream.write(_MAGIC + _digest(key, body) + body)
            Path(temporary).replace(_file(key))
        except OSError:
            Path(temporary).unlink(missing_ok=True)
            raise
