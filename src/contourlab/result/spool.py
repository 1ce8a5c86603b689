"""A file for HDF5 to write to, which never sees a write fail: the failure is kept and raised when HDF5 is out of the way."""

from __future__ import annotations

import io
import os
from pathlib import Path
from typing import Any


class Spool(io.FileIO):
    """Binary file that takes every write, and remembers the first one that failed.

    HDF5 cannot close a file once a write has failed, on a full disk say: it goes on holding it and takes the interpreter down at its end.
    What comes after a failure is held in memory until the file is closed, since HDF5 reads its own structures back; on the disk the file is
    of no use any more.
    """

    def __init__(self, file: Path, mode: str) -> None:
        super().__init__(file, mode)
        self.failure: OSError | None = None
        self._held: list[tuple[int, bytes]] = []

    def write(self, data: Any) -> int:
        view, start, done = memoryview(data).cast("B"), self.tell(), 0
        try:
            # The system may take a part only, up to where the disk is full.
            while self.failure is None and done < len(view):
                done += super().write(view[done:])
        except OSError as error:
            self.failure = error
        if self.failure is not None:
            self._held.append((start + done, bytes(view[done:])))
            self.seek(start + len(view))
        return len(view)

    def readinto(self, buffer: Any) -> int:
        view, start = memoryview(buffer).cast("B"), self.tell()
        read = super().readinto(view)
        view[read:] = bytes(len(view) - read)
        for at, data in self._held:
            low, high = max(at, start), min(at + len(data), start + len(view))
            if low < high:
                view[low - start : high - start] = data[low - at : high - at]
        self.seek(start + len(view))
        return len(view)

    def truncate(self, size: int | None = None) -> int:
        try:
            return super().truncate(size)
        except OSError as error:
            self.failure = self.failure or error
            return size if size is not None else os.fstat(self.fileno()).st_size

    def check(self) -> None:
        """Raise the failure, if there was one."""
        if self.failure is not None:
            raise self.failure
