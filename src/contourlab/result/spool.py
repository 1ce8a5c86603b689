"""A file for HDF5 to write to, which never sees a write fail: the failure is kept and raised when HDF5 is out of the way."""

from __future__ import annotations

import io
from typing import Any

__all__ = ["Spool"]


class Spool(io.FileIO):
    """Binary file that takes every write, and remembers the first one that failed.

    HDF5 cannot close a file once a write has failed, on a full disk say: it goes on holding it and takes the interpreter down at its end.
    After a failure nothing more is written, and the file is of no use.
    """

    failure: OSError | None = None

    def write(self, data: Any) -> int:
        view = memoryview(data).cast("B")
        done = 0
        try:
            # The system may take a part only, up to where the disk is full.
            while self.failure is None and done < len(view):
                done += super().write(view[done:])
        except OSError as error:
            self.failure = error
        return len(view)

    def truncate(self, size: int | None = None) -> int:
        try:
            return super().truncate(size)
        except OSError as error:
            self.failure = self.failure or error
            return size or 0

    def check(self) -> None:
        """Raise the failure, if there was one."""
        if self.failure is not None:
            raise self.failure
