"""Read binary formats in a process of their own.

Their libraries are written in C: a damaged file may crash them, and a small one may fill the memory. The process has a limit of memory
and of time, and answers with a line of JSON and the numbers.
"""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ContourlabError, LogError, MissingPackageError
from contourlab.findings import Finding
from contourlab.logs import matlab, parquet, results
from contourlab.logs.record import MEMORY, TIME, Channel, Record, factor, raised

READERS: dict[str, Callable[[Path], Record]] = {"matlab": matlab.read, "parquet": parquet.read, "contourlab": results.read}
_CODE = "from contourlab.logs.apart import main; main()"


def read_apart(format: str, file: Path) -> Record:  # noqa: A002
    """Read a file of one of `READERS`.

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
        content = _content(READERS[kind](Path(file)), arrays)
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
