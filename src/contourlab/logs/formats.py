"""The formats of logs, their recognition, and binary ones in a process of their own."""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ContourlabError, LogError, MissingPackageError, ParameterError
from contourlab.file_kinds import mistaken
from contourlab.findings import Finding
from contourlab.logs import accelerometer, delimited, linuxcnc, matlab, parquet, results, sinumerik, sinumerik_capture, twincat
from contourlab.logs.reading import MEMORY, TIME, Channel, Record, factor, head_of, raised

_CODE = "from contourlab.logs.formats import main; main()"


@dataclass(frozen=True)
class Format:
    """A format of logs.

    Attributes
    ----------
    name : str
        Value of ``--format``.
    matches : callable
        ``matches(file, head) -> bool``, from the name and the first bytes.
    read : callable
        ``read(file) -> Record``.
    is_binary : bool
        Whether `read_record` reads it in a process of its own.
    """

    name: str
    matches: Callable[[Path, bytes], bool]
    read: Callable[[Path], Record]
    is_binary: bool = False


# From the most specific to any table of numbers.
FORMATS = {
    kind.name: kind
    for kind in (
        Format("contourlab", results.matches, results.read, is_binary=True),
        Format("matlab", matlab.matches, matlab.read, is_binary=True),
        Format("parquet", parquet.matches, parquet.read, is_binary=True),
        Format("sinumerik", sinumerik.matches, sinumerik.read),
        Format("sinumerik-capture", sinumerik_capture.matches, sinumerik_capture.read),
        Format("twincat", twincat.matches, twincat.read),
        Format("halscope", linuxcnc.matches_scope, linuxcnc.read_scope),
        Format("halsampler", linuxcnc.matches_sampler, linuxcnc.read_sampler),
        Format("accelerometer", accelerometer.matches, accelerometer.read),
        Format("csv", delimited.matches, delimited.read),
    )
}


def format_of(file: str | Path) -> Format:
    """Recognise the format of a file.

    Raises
    ------
    LogError
        If the file cannot be read, is empty, or has no known format.
    """
    path = Path(file)
    head = head_of(path)
    for kind in FORMATS.values():
        if kind.matches(path, head):
            return kind
    raise LogError(mistaken(path, "a log") or f"has no known format: name it with --format, one of {', '.join(FORMATS)}", file=path)


def read_record(file: str | os.PathLike[str], format: str | None = None) -> Record:  # noqa: A002
    """Read a log without interpretation; one that is read already stays what it is.

    Parameters
    ----------
    format : str, optional
        One of `FORMATS`; by default recognised.

    Raises
    ------
    LogError
        If it cannot be read.
    ParameterError
        If the format is unknown.
    """
    known = getattr(file, "record", file)
    if isinstance(known, Record):
        return known
    path = Path(file)
    if format is None:
        kind = format_of(path)
    elif format in FORMATS:
        head_of(path)
        kind = FORMATS[format]
    else:
        raise ParameterError("format", repr(format), f"one of {', '.join(FORMATS)}")
    return read_apart(kind.name, path) if kind.is_binary else kind.read(path)


def read_apart(format: str, file: Path) -> Record:  # noqa: A002
    """Read a file of a binary format in a process of its own.

    The libraries of such formats are written in C: a damaged file may crash them, and a small one may fill the memory. The process has a
    limit of memory and of time, and answers with a line of JSON and the numbers.

    Raises
    ------
    LogError
        If the file cannot be read, crashes its library, or exceeds a limit.
    MissingPackageError
        If the library is not installed.
    """
    path = os.pathsep.join(folder or "." for folder in sys.path)
    # -P: a file named numpy.py beside the log must not run.
    command = [sys.executable, "-P", "-c", _CODE, format, str(file)]
    with tempfile.TemporaryFile() as answer:
        try:
            process = subprocess.run(
                command,
                stdin=subprocess.DEVNULL,
                stdout=answer,
                stderr=subprocess.DEVNULL,
                timeout=TIME * factor(),
                env={**os.environ, "PYTHONPATH": path, "OPENBLAS_NUM_THREADS": "1"},
                check=False,
            )
        except subprocess.TimeoutExpired:
            raise LogError(f"takes longer than {TIME * factor():g} s to read as {format}: {raised()}", file=file) from None
        answer.seek(0)
        text = answer.readline()
        if process.returncode or not text.endswith(b"\n"):
            raise LogError(f"is damaged: its {format} reader crashed (code {process.returncode}); export it again", file=file)
        content = json.loads(text)
        if "missing" in content:
            raise MissingPackageError(*content["missing"])
        if "error" in content:
            raise LogError(content["error"], file=file)
        arrays = [np.fromfile(answer, np.float64, size) for size in content.pop("sizes")]
    channels = tuple(
        Channel(name, arrays[values], unit, None if time is None else arrays[time], is_timestamp)
        for name, unit, is_timestamp, values, time in content.pop("channels")
    )
    findings = tuple(Finding(**fields) for fields in content.pop("findings"))
    return Record(file, format, channels, findings=findings, **content)


def main() -> None:
    """Read a file in this process and write the answer to stdout; arguments are format and file."""
    kind, file = sys.argv[1:]
    with contextlib.suppress(ImportError, ValueError, OSError):  # Windows has no such limit
        import resource

        resource.setrlimit(resource.RLIMIT_DATA, (int(MEMORY * factor()), resource.getrlimit(resource.RLIMIT_DATA)[1]))
    arrays: list[Array] = []
    try:
        content = _content(FORMATS[kind].read(Path(file)), arrays)
    except MissingPackageError as error:
        content = {"missing": [error.package, error.extra]}
    except LogError as error:
        content = {"error": error.message}
    except ContourlabError as error:
        content = {"error": str(error)}
    except MemoryError:
        content = {"error": f"needs more than {MEMORY * factor() / 1e6:.0f} MB to be read as {kind}: {raised()}"}
    except RecursionError:
        content = {"error": "is nested too deeply, or contains itself: export it again"}
    except Exception as error:  # the libraries pass on any error of a damaged file
        content = {"error": f"cannot be read as {kind}: {' '.join(str(error).split()) or type(error).__name__}"}
    sys.stdout.buffer.write(json.dumps({**content, "sizes": [values.size for values in arrays]}).encode() + b"\n")
    for values in arrays:
        sys.stdout.buffer.write(np.ascontiguousarray(values, dtype=np.float64).data)


def _content(record: Record, arrays: list[Array]) -> dict[str, Any]:
    """Return a record without its numbers, which go to `arrays`; channels share their times."""
    places: dict[int, int] = {}

    def place(values: Array) -> int:
        if id(values) not in places:
            places[id(values)] = len(arrays)
            arrays.append(values)
        return places[id(values)]

    return {
        "channels": [(c.name, c.unit, c.is_timestamp, place(c.values), None if c.time is None else place(c.time)) for c in record.channels],
        "period": record.period,
        "constants": dict(record.constants),
        "attributes": dict(record.attributes),
        "findings": [asdict(finding) for finding in record.findings],
    }
