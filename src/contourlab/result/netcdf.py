"""Results on disk: NetCDF-4, appended block by block so that memory does not grow with the run.

A SHA-256 digest of the file follows its NetCDF part, whose readers ignore it. It is checked before HDF5 sees the file: from a damaged one
HDF5 returns wrong numbers, never returns, or ends the process.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import os
import threading
from collections.abc import Iterator, Mapping
from pathlib import Path
from signal import SIG_DFL, SIGINT
from signal import signal as on_signal
from types import TracebackType
from typing import Any, BinaryIO

import numpy as np

from contourlab.errors import OutputError, ResultError, refuse
from contourlab.result.atomic import replacing
from contourlab.result.signals import Signal, Status


class Spool(io.FileIO):
    """Binary file that accepts every write and records the first failure.

    After a failed write, e.g. on a full disk, HDF5 cannot close its file and crashes the interpreter at exit. Writes after a failure are
    therefore held in memory until the file is closed, because HDF5 reads its own structures back. The file on disk is then useless.
    """

    def __init__(self, file: Path, mode: str) -> None:
        super().__init__(file, mode)
        self.failure: OSError | None = None
        self._held: list[tuple[int, bytes]] = []

    def write(self, data: Any) -> int:
        view, start, done = memoryview(data).cast("B"), self.tell(), 0
        try:
            # The system may write a part only, until the disk is full.
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


@contextlib.contextmanager
def _undisturbed() -> Iterator[None]:
    """Hold Ctrl-C back: raised while HDF5 writes through a `Spool`, it is lost, or ends the process."""
    held: list[int] = []
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = on_signal(SIGINT, lambda number, _: held.append(number))
    try:
        yield
    finally:
        on_signal(SIGINT, before or SIG_DFL)
        if held:
            raise KeyboardInterrupt


_CHUNK = 1 << 14
FORMAT = "contourlab-result/2"
_FIXED = ("format", "made_by", "scheme", "axes", "servo_period", "start", "status_ok", "status_sample", "status_axis", "status_reason")


class ResultWriter:
    """Write blocks of signals one after another; the file appears only if the block of code succeeds.

    Parameters
    ----------
    header : mapping
        From `Result.header`.
    n_sample : int, optional
        Number of samples, if known: a file of fixed size is faster to write.

    Examples
    --------
    >>> import tempfile, numpy as np
    >>> from contourlab.result import Result
    >>> folder = tempfile.TemporaryDirectory()
    >>> result = Result("base", ("x",), 1e-3, {"position": Signal(np.zeros((4, 1)), ("sample", "axis"), "m")})
    >>> with ResultWriter(f"{folder.name}/run.nc", result.header(), result.axes) as writer:
    ...     writer.append(result.signals)
    ...     writer.append(result.signals)
    >>> Result.load(f"{folder.name}/run.nc").n_sample
    8
    >>> folder.cleanup()
    """

    def __init__(
        self, file: str | Path, header: Mapping[str, str | int | float], axes: tuple[str, ...], n_sample: int | None = None
    ) -> None:
        self.file, self.header, self.axes, self.n_sample = Path(file), dict(header), axes, n_sample
        self._stack = contextlib.ExitStack()
        self._spool: Any = None
        self._data: Any = None
        self._names: set[str] = set()
        self._length = 0

    def __enter__(self) -> ResultWriter:
        import h5netcdf
        import h5py

        with contextlib.ExitStack() as stack:
            self._spool = stack.enter_context(Spool(stack.enter_context(replacing(self.file)), "w+"))
            with _undisturbed():
                self._data = stack.enter_context(h5netcdf.File(self._spool, "w"))
                self._data.dimensions = {"sample": self.n_sample or None, "axis": len(self.axes)}
                names = self._data.create_variable("axis", ("axis",), dtype=h5py.string_dtype("utf-8"))
                names[:] = np.array(self.axes, dtype=object)
            # From here on `__exit__` closes what was opened.
            self._stack = stack.pop_all()
        return self

    def append(self, signals: Mapping[str, Signal]) -> None:
        """Write the next samples; every call needs the same signals.

        Raises
        ------
        OutputError
            If they cannot be written, e.g. on a full disk.
        ResultError
            If the signals are not those of the first call.
        """
        try:
            with _undisturbed():
                self._append(signals)
            self._spool.check()
        except OSError as error:
            first = self._spool.failure or error
            raise OutputError(f"{self.file}: cannot be written: {first.strerror or first}") from error

    def _append(self, signals: Mapping[str, Signal]) -> None:
        count = len(next(iter(signals.values())).data) if signals else 0
        if self._length and set(signals) != self._names:
            odd = ", ".join(sorted(set(signals) ^ self._names))
            raise ResultError(f"every block must have the signals of the first one; this one differs in {odd}")
        self._names = set(signals)
        stop = self._length + count
        # Chunks are stored whole: a short run would otherwise be padded to the full chunk.
        rows = max(min(self.n_sample or count, _CHUNK), 1)
        if "time" not in self._data.variables:
            self._data.create_variable("time", ("sample",), float, chunks=(rows,)).attrs["units"] = "s"
        if not self.n_sample:
            self._data.resize_dimension("sample", stop)
        elif stop > self.n_sample:
            raise ResultError(f"{stop} samples for a file of {self.n_sample}")
        for name, signal in signals.items():
            if name not in self._data.variables:
                chunks = (rows,) if signal.data.ndim == 1 else (rows, len(self.axes))
                made = self._data.create_variable(name, signal.dims, float, chunks=chunks, fillvalue=np.nan)
                made.attrs["units"] = signal.unit
            self._data.variables[name][self._length : stop] = signal.data
        index = float(self.header.get("start", 0)) + np.arange(self._length, stop)
        self._data.variables["time"][self._length : stop] = index * float(self.header["servo_period"])
        self._length = stop

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        if kind is not None:
            with _undisturbed():
                self._stack.__exit__(kind, error, trace)
            return
        with self._stack, _undisturbed():
            refuse(self.n_sample and self._length < self.n_sample, ResultError, f"{self._length} samples for a file of {self.n_sample}")
            for name, value in self.header.items():
                self._note(name, value)
            self._data.close()
            self._spool.write(_digest(self._spool, self._spool.seek(0, io.SEEK_END)))
            self._spool.check()

    def _note(self, name: str, value: str | int | float) -> None:
        try:
            self._data.attrs[name] = int(value) if isinstance(value, bool) else value
        except (TypeError, ValueError) as error:
            known = name.removeprefix("attribute_")
            raise ResultError(f"{known} = {value!r}: a file holds text and numbers of 64 bits only") from error


def _digest(stream: BinaryIO, size: int) -> bytes:
    """Return the SHA-256 digest of the first `size` bytes of a stream; leave the stream there."""
    stream.seek(0)
    digest, left = hashlib.sha256(), size
    while left > 0 and (part := stream.read(min(left, 1 << 20))):
        digest.update(part)
        left -= len(part)
    return digest.digest()


def read_netcdf(file: str | Path) -> dict[str, Any]:
    """Return the arguments of a `Result` from its file; see `Result.load`."""
    import h5netcdf
    import h5py

    try:
        with Path(file).open("rb") as stream:
            if _digest(stream, stream.seek(0, io.SEEK_END) - hashlib.sha256().digest_size) != stream.read():
                raise ResultError(f"{file}: no result of contourlab, or damaged or changed since it was written")
        # h5py first: if the root of the file is damaged, h5netcdf fails again in its own clean-up.
        with h5py.File(file, "r") as raw:
            header = {name: _plain(value) for name, value in raw.attrs.items() if not name.startswith("_")}
            if header["format"] != FORMAT:
                raise ResultError(f"{file}: a result of format {header['format']}: this version of contourlab reads {FORMAT}")
            with h5netcdf.File(raw, "r", decode_vlen_strings=True) as data:
                axes = tuple(str(name) for name in data.variables["axis"][:])
                signals = {
                    name: Signal(np.array(v[...]), tuple(v.dimensions), str(_plain(v.attrs["units"])))
                    for name, v in data.variables.items()
                    if name not in ("axis", "time")
                }
        ending = (int(header["status_sample"]), str(header["status_axis"]), str(header["status_reason"]))
        return {
            "scheme": str(header["scheme"]),
            "axes": axes,
            "servo_period": float(header["servo_period"]),
            "signals": signals,
            "status": Status(bool(header["status_ok"]), *ending),
            "attributes": {name.removeprefix("attribute_"): value for name, value in header.items() if name not in _FIXED},
            "start": int(header["start"]),
            "made_by": str(header.get("made_by", "")),
        }
    except (OSError, KeyError, RuntimeError, TypeError, ValueError) as error:
        raise ResultError(f"{file}: cannot be read as a result: {getattr(error, 'strerror', None) or error}") from error


def _plain(value: Any) -> Any:
    """Convert a value from HDF5 to a Python type."""
    if isinstance(value, np.ndarray) and value.size == 1:
        value = value.reshape(())[()]
    if isinstance(value, bytes):
        return value.decode("utf-8")
    return value.item() if isinstance(value, np.generic) else value
