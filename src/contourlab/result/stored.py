"""Signals of a run in temporary files: written block by block, read where they are used, so that memory does not grow with the run."""

from __future__ import annotations

import math
import os
import shutil
import tempfile
import weakref
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from threading import Lock
from typing import Any, NamedTuple

import numpy as np

from contourlab.errors import OutputError
from contourlab.result.signals import Signal


def scratch() -> str:
    """Return the folder for temporary files: that of ``TMPDIR``, else ``/var/tmp``, since ``/tmp`` is often in memory."""
    return tempfile.gettempdir() if os.environ.get("TMPDIR") or not os.access("/var/tmp", os.W_OK) else "/var/tmp"


class _File:
    """A temporary file; it is removed with the last signal that is in it."""

    def __init__(self) -> None:
        with _named():
            self.open = tempfile.TemporaryFile(dir=scratch())  # noqa: SIM115  # open as long as its signals are used
        weakref.finalize(self, self.open.close)
        self.end, self.alone = 0, Lock()

    def taken(self, size: int, spare: int) -> int:
        """Return where `size` bytes begin, and keep them; OutputError if these and `spare` more are not free on the disk."""
        if size + spare > (free := shutil.disk_usage(scratch()).free):
            need, have = (f"{number / 1e9:.3g} GB" for number in (size + spare, free))
            raise OutputError(f"{scratch()}: the run needs {need}, {have} are free: set TMPDIR to a folder with more room")
        with self.alone:
            self.end += size
            return self.end - size

    def write(self, offset: int, data: Any) -> None:
        """Write bytes at some place; OutputError if they cannot be written, e.g. on a full disk."""
        with self.alone, _named():
            self.open.seek(offset)
            self.open.write(data)
            self.open.flush()


@contextmanager
def _named() -> Iterator[None]:
    """Say what to do if a temporary file cannot be written."""
    try:
        yield
    except OSError as error:
        raise OutputError(f"{scratch()}: cannot be written: {error.strerror}: set TMPDIR to a folder with more room") from error


class _Column(NamedTuple):
    """Where a signal begins in its file, the shape of a sample, dimensions and unit."""

    offset: int
    shape: tuple[int, ...]
    dims: tuple[str, ...]
    unit: str

    @property
    def row(self) -> int:
        """Bytes of a sample."""
        return 8 * math.prod(self.shape)


class Stored(Mapping[str, Signal]):
    """Samples [start, stop) of signals in a temporary file: written block by block, each mapped into memory whenever it is asked for.

    Parameters
    ----------
    n_sample : int
        Most samples.
    file : optional
        That of other signals, which takes these too.
    spare : int
        Bytes of a sample that others will take in the same file.
    """

    def __init__(self, n_sample: int, file: _File | None = None, spare: int = 0) -> None:
        self.columns: dict[str, _Column] = {}
        self.start, self.stop, self.file, self._n_sample, self._spare = 0, 0, file or _File(), n_sample, spare

    def append(self, signals: Mapping[str, Signal]) -> None:
        """Write the next samples; every call needs the same signals.

        Raises
        ------
        OutputError
            If there is no room for all samples, or these cannot be written.
        """
        if not self.columns:
            made = {name: _Column(0, signal.data.shape[1:], signal.dims, signal.unit) for name, signal in signals.items()}
            size = self._n_sample * sum(column.row for column in made.values())
            offset = self.file.taken(size, self._n_sample * self._spare)
            for name, column in made.items():
                self.columns[name] = column._replace(offset=offset)
                offset += self._n_sample * column.row
        for name, signal in signals.items():
            column = self.columns[name]
            self.file.write(column.offset + self.stop * column.row, np.ascontiguousarray(signal.data).data)
        self.stop += len(signal.data)

    def __getitem__(self, name: str) -> Signal:
        column, n = self.columns[name], self.stop - self.start
        given: dict[str, Any] = {"offset": column.offset + self.start * column.row, "shape": (n, *column.shape)}
        data = np.memmap(self.file.open, np.float64, "r", **given) if n else np.empty(given["shape"])
        return Signal(data, column.dims, column.unit)

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.columns)

    def __reduce__(self) -> tuple[Any, ...]:
        """Copies, and what another process gets, are in memory."""
        return dict, ({name: replace(signal, data=np.array(signal.data)) for name, signal in self.items()},)

    def part(self, **changed: Any) -> Stored:
        """Return these signals with other `columns`, `start` or `stop`."""
        part = Stored.__new__(Stored)
        vars(part).update(vars(self) | changed)
        return part

    def window(self, start: int, stop: int) -> Stored:
        """Return samples [start, stop) of these."""
        first, last, _ = slice(start, stop).indices(self.stop - self.start)
        return self.part(start=self.start + first, stop=self.start + max(first, last))
