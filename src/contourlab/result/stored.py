"""Signals of a run in temporary files: written block by block, read where they are used, so that memory does not grow with the run."""

from __future__ import annotations

import math
import os
import shutil
import tempfile
import weakref
from collections.abc import Iterator, Mapping, Sequence
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


def free_scratch() -> float:
    """Return the bytes that are free for temporary files."""
    return float(shutil.disk_usage(scratch()).free)


class _File:
    """A temporary file; it is removed with the last signal that is in it."""

    def __init__(self) -> None:
        with _named():
            self.open = tempfile.TemporaryFile(dir=scratch())  # noqa: SIM115  # open as long as its signals are used
        weakref.finalize(self, self.open.close)
        self.end, self.alone = 0, Lock()

    def taken(self, size: int) -> int:
        """Return where `size` free bytes begin, and keep them."""
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


class Store:
    """Takes signals block by block, into a temporary file of its own or that of other signals.

    Parameters
    ----------
    n_sample : int
        Most samples.
    beside : Stored, optional
        Signals whose file takes these too.
    """

    def __init__(self, n_sample: int, beside: Stored | None = None) -> None:
        self._columns: dict[str, _Column] = {}
        self._n_sample, self._length = n_sample, 0
        self._file = _File() if beside is None else beside.file

    def append(self, signals: Mapping[str, Signal]) -> None:
        """Write the next samples; every call needs the same signals.

        Raises
        ------
        OutputError
            If they cannot be written, e.g. on a full disk.
        """
        for name, signal in signals.items():
            data, column = np.ascontiguousarray(signal.data), self._columns.get(name)
            if column is None:
                column = _Column(self._file, 0, data.shape[1:], signal.dims, signal.unit)
                column = self._columns[name] = column._replace(offset=self._file.taken(self._n_sample * column.row))
            self._file.write(column.offset + self._length * column.row, data.data)
        self._length += len(data)

    @property
    def signals(self) -> Stored:
        """The signals written so far."""
        return Stored(self._columns, 0, self._length)


class _Column(NamedTuple):
    """Where a signal begins in its file, the shape of a sample, dimensions and unit."""

    file: _File
    offset: int
    shape: tuple[int, ...]
    dims: tuple[str, ...]
    unit: str

    @property
    def row(self) -> int:
        """Bytes of a sample."""
        return 8 * math.prod(self.shape)


class Stored(Mapping[str, Signal]):
    """Samples [start, stop) of signals in temporary files, each mapped into memory whenever it is asked for."""

    def __init__(self, columns: Mapping[str, _Column], start: int, stop: int) -> None:
        self._columns, self.start, self.stop = columns, start, stop

    def __getitem__(self, name: str) -> Signal:
        column, n = self._columns[name], self.stop - self.start
        given: dict[str, Any] = {"offset": column.offset + self.start * column.row, "shape": (n, *column.shape)}
        data = np.memmap(column.file.open, np.float64, "r", **given) if n else np.empty(given["shape"])
        return Signal(data, column.dims, column.unit)

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __reduce__(self) -> tuple[Any, ...]:
        """Copies, and what another process gets, are in memory."""
        return dict, ({name: replace(signal, data=np.array(signal.data)) for name, signal in self.items()},)

    @property
    def file(self) -> _File:
        """The file of these signals."""
        return next(iter(self._columns.values())).file

    def window(self, start: int, stop: int) -> Stored:
        """Return samples [start, stop) of these."""
        first, last, _ = slice(start, stop).indices(self.stop - self.start)
        return Stored(self._columns, self.start + first, self.start + max(first, last))

    def only(self, names: Sequence[str]) -> Stored:
        """Return some of the signals."""
        return Stored({name: self._columns[name] for name in names}, self.start, self.stop)

    def beside(self, others: Stored) -> Stored:
        """Return these and others of the same samples."""
        return Stored({**self._columns, **others._columns}, self.start, self.stop)
