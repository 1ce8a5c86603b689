"""Logs of LinuxCNC.

halscope: what its menu "save log" writes, in the form of 2.10 and in the older one (src/hal/utils/scope_files.c). halsampler: a line of
numbers for each sample, in the order of the pins, and "overrun" where samples were lost (halsampler(1)).
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import LogError
from contourlab.logs.reading import lines_of, numbers
from contourlab.logs.record import Channel, Record

Array = NDArray[np.float64]
OVERRUN = "overrun"
MOSTLY = 0.9
"""Share of steps by one above which a first column counts samples, even where the count begins anew."""
_FIRST = re.compile(r"(#\s*)?Sampling period is (\d+) (ns|nSec)\s*\Z")


def matches_scope(file: Path, head: bytes) -> bool:
    """Tell whether the first line states the period as halscope does."""
    return _FIRST.match(head.decode("latin-1").partition("\n")[0]) is not None


def read_scope(file: Path) -> Record:
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
    if first[1]:  # the new form: a line of names, then numbers
        names, rows = body[0][1].split(";"), [(i, line.split(";")) for i, line in body[1:]]
    else:
        names, rows = _labelled(body, file)
    if not rows:
        raise LogError("holds no samples", file=file)
    comma = any("," in cell for _, cells in rows for cell in cells)
    values = numbers(rows, names, file, comma)
    channels = tuple(Channel(name, column) for name, column in zip(names, values.T, strict=True))
    return Record(file, "halscope", channels, int(first[2]) / 1e9, notes=notes)


def _labelled(body: list[tuple[int, str]], file: Path) -> tuple[list[str], list[tuple[int, list[str]]]]:
    """Return names and rows of the old form, in which the name stands before each number."""
    names = body[0][1].split()[::2]
    for i, line in body:
        words = line.split()
        if words[::2] != names or len(words) % 2:
            raise LogError(f"is not a line of {', '.join(names)}, each with its number", file=file, line=i)
    return names, [(i, line.split()[1::2]) for i, line in body]


def matches_sampler(file: Path, head: bytes) -> bool:
    """Tell whether it is one: lines end in a blank before the line feed, as halsampler writes them, or an overrun stands there."""
    lines = head.decode("latin-1").split("\n")[:-1]
    if not lines:
        return False
    if any(line.strip() == OVERRUN for line in lines):
        return True
    return all(line.endswith(" ") and not line.endswith("  ") and _plain(line) for line in lines[:20])


def _plain(line: str) -> bool:
    try:
        [float(cell) for cell in line.split()]
    except ValueError:
        return False
    return bool(line.split())


def read_sampler(file: Path) -> Record:
    """Read what halsampler wrote, with ``-t`` or without.

    The file knows neither names nor period: columns are named 1, 2, ... in the order of the sampler's pins, and the period has to be
    given. A first column of whole numbers that only grows is the sample's number, which is kept as the channel ``sample``; where that is a
    pin, ``--format csv`` reads the table as it is.

    Raises
    ------
    LogError
        If a line is faulty, samples were lost and are not numbered, or their numbers begin anew.
    """
    written, notes = lines_of(file)
    lines = [(i, line.split()) for i, line in written]
    rows = [(i, cells) for i, cells in lines if cells != [OVERRUN]]
    if not rows:
        raise LogError("holds no samples", file=file)
    values = numbers(rows, [str(j + 1) for j in range(len(rows[0][1]))], file)
    tagged = _is_numbered(rows, values[:, 0], file)
    lost = len(lines) - len(rows)
    if lost and not tagged:
        line = next(i for i, cells in lines if cells == [OVERRUN])
        raise LogError("samples were lost here, and they are not numbered: sample again with halsampler -t", file=file, line=line)
    names = (["sample"] if tagged else []) + [str(j + 1) for j in range(values.shape[1] - tagged)]
    notes += (f"{lost} overruns: samples were lost there",) if lost else ()
    return Record(file, "halsampler", tuple(Channel(n, v) for n, v in zip(names, values.T, strict=True)), notes=notes)


def _is_numbered(rows: list[tuple[int, list[str]]], first: Array, file: Path) -> bool:
    """Tell whether the first column is the number of the sample: whole, as it is written, and growing."""
    if len(rows[0][1]) < 2 or len(rows) < 2 or any("." in cells[0] for _, cells in rows):
        return False
    step = np.diff(first)
    if np.all(step >= 1.0):
        return True
    # Bits and counts of an encoder stand still, or turn back one by one: numbers of samples do neither.
    if np.mean(step == 1.0) > MOSTLY and np.all(step[step != 1.0] < 0.0):
        back = int(np.argmin(step))
        raise LogError(
            f"the number of the sample goes back from {first[back]:.0f} to {first[back + 1]:.0f}: are two records in one file? "
            "If the first column is a pin, read it with --format csv",
            file=file,
            line=rows[back + 1][0],
        )
    return False
