"""Files appear whole or not at all."""

from __future__ import annotations

import contextlib
import os
import tempfile
from collections.abc import Iterator
from pathlib import Path

from contourlab.errors import OutputError


@contextlib.contextmanager
def replacing(file: str | Path, *, durable: bool = False) -> Iterator[Path]:
    """Yield a temporary file beside `file`; rename it to `file` if the block succeeds, else remove it.

    If `durable`, the file is on the disk when the block ends, and survives a power failure.

    Raises
    ------
    OutputError
        If the folder cannot be made or written to, the disk is full, or `file` is a device or a folder.
    """
    target = Path(file)
    if target.exists() and not target.is_file():  # a rename would take the place of the device
        raise OutputError(f"{target}: cannot be written: it is not a regular file")
    temporary: Path | None = None
    try:
        try:
            target.parent.mkdir(parents=True, exist_ok=True)
            handle, name = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name}.", suffix=".part")
            os.close(handle)
            temporary = Path(name)
            yield temporary
            # Temporary files are private; give the result the user's usual permissions.
            umask = os.umask(0)
            os.umask(umask)
            temporary.chmod(0o666 & ~umask)
            if durable:
                _sync(temporary)
            temporary.replace(target)
            if durable and os.name != "nt":  # Windows has no handles of folders
                _sync(target.parent)
        except OSError as error:
            raise OutputError(f"{target}: cannot be written: {error.strerror or error}") from error
    finally:
        if temporary is not None:
            temporary.unlink(missing_ok=True)


def _sync(path: Path) -> None:
    handle = os.open(path, os.O_RDWR if path.is_file() else os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def write_bytes_atomic(file: str | Path, data: bytes, *, durable: bool = False) -> None:
    """Write a file whole or not at all; see `replacing`."""
    with replacing(file, durable=durable) as temporary:
        temporary.write_bytes(data)


def write_text_atomic(file: str | Path, text: str) -> None:
    """Write a text file in UTF-8, whole or not at all."""
    write_bytes_atomic(file, text.encode("utf-8", "replace"))
