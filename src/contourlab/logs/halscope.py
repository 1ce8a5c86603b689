"""LinuxCNC's halscope: what its menu "save log" writes, in the form of 2.10 and in the older one (src/hal/utils/scope_files.c)."""

from __future__ import annotations

import re
from pathlib import Path

from contourlab.errors import LogError
from contourlab.logs.reading import lines_of, numbers
from contourlab.logs.record import Channel, Record

_FIRST = re.compile(r"(#\s*)?Sampling period is (\d+) (ns|nSec)\s*\Z")


def matches(file: Path, head: bytes) -> bool:
    """Tell whether the first line states the period as halscope does."""
    return _FIRST.match(head.decode("latin-1").partition("\n")[0]) is not None


def read(file: Path) -> Record:
    """Read a log of halscope. Pins of bits are 1 and 0, however they are written; a decimal comma of older versions is read.

    Raises
    ------
    LogError
        If a line is faulty; says which.
    """
    written, notes = lines_of(file)
    lines = [(i, line.strip()) for i, line in written]
    first = _FIRST.match(lines[0][1]) if lines else None
    if first is None:
        raise LogError('does not begin with "Sampling period is ... ns"', file=file, line=1)
    if int(first[2]) == 0:
        raise LogError("the sampling period is 0 ns: halscope had no thread to sample in", file=file, line=lines[0][0])
    body = [(i, line) for i, line in lines[1:] if not line.startswith("#")]
    if not body:
        raise LogError("holds no samples", file=file)
    names, rows = _table(body) if first[1] else _labelled(body, file)
    if not rows:
        raise LogError("holds no samples", file=file)
    comma = any("," in cell for _, cells in rows for cell in cells)
    values = numbers(rows, names, file, comma)
    channels = tuple(Channel(name, column) for name, column in zip(names, values.T, strict=True))
    return Record(file, "halscope", channels, int(first[2]) / 1e9, notes=notes)


def _table(body: list[tuple[int, str]]) -> tuple[list[str], list[tuple[int, list[str]]]]:
    """Return names and rows of the new form: a line of names, then numbers, parted by semicolons."""
    return body[0][1].split(";"), [(i, line.split(";")) for i, line in body[1:]]


def _labelled(body: list[tuple[int, str]], file: Path) -> tuple[list[str], list[tuple[int, list[str]]]]:
    """Return names and rows of the old form, in which the name stands before each number."""
    names = body[0][1].split()[::2]
    for i, line in body:
        words = line.split()
        if words[::2] != names or len(words) % 2:
            raise LogError(f"is not a line of {', '.join(names)}, each with its number", file=file, line=i)
    return names, [(i, line.split()[1::2]) for i, line in body]
