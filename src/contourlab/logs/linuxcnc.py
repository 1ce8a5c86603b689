"""Logs of LinuxCNC.

halscope: the output of "save log", of 2.10 and of older versions (src/hal/utils/scope_files.c). halsampler: a line of numbers per sample,
in the order of the pins, and "overrun" for lost samples (halsampler(1)).
"""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import LogError, refuse
from contourlab.findings import finding
from contourlab.logs.reading import REPEATED, Channel, Record, columns_of, lines_of, number_channel

OVERRUN = "overrun"
MOSTLY = 0.9
"""Share of steps by one above which a first column counts samples, restarts included."""
_FIRST = re.compile(r"(#\s*)*Sampling period is (\d+) (ns|nSec)\s*\Z")
_SAMPLE = re.compile(r"(-?\d+([.,]\d{6})?)([ \t;]+(-?\d+([.,]\d{6})?))+[ \t;]*\Z")
_SIX = re.compile(r"\d[.,]\d{6}(?!\d)")
"""A line of halsampler with blanks stripped or replaced by semicolons: whole numbers, and others with six decimals."""


def matches_scope(file: Path, head: bytes) -> bool:
    """Tell whether the first line states the sampling period."""
    return _FIRST.match(head.decode("latin-1").partition("\n")[0]) is not None


def read_scope(file: Path) -> Record:
    """Read a log of halscope; bits become 1 and 0, and decimal commas are read.

    Raises
    ------
    LogError
        If a line is faulty.
    """
    written, findings = lines_of(file)
    lines = [(i, line.strip()) for i, line in written]
    first = _FIRST.match(lines[0][1]) if lines else None
    if first is None:
        raise LogError('does not begin with "Sampling period is ... ns": save it again with halscope', file=file, line=1)
    if int(first[2]) == 0:
        raise LogError("the sampling period is 0 ns: choose a thread in halscope and sample again", file=file, line=lines[0][0])
    if repeated := next((i for i, line in lines[1:] if _FIRST.match(line)), 0):
        raise LogError(REPEATED, file=file, line=repeated)
    body = [(i, line) for i, line in lines[1:] if not line.startswith("#")]
    has_names = bool(body) and len(body[0][1].split()) == 1  # since 2.10: a line of names, then numbers
    refuse(len(body) < 1 + has_names, LogError, "contains no samples", file=file)
    if has_names:
        names, rows = body[0][1].split(";"), [(i, line.split(";")) for i, line in body[1:]]
    else:
        names, rows = _labelled(body, file)
    comma = any("," in cell for _, cells in rows for cell in cells)
    channels = _channels(rows, names, file, comma)
    return Record(file, "halscope", channels, int(first[2]) / 1e9, findings=findings)


def _channels(rows: list[tuple[int, list[str]]], names: list[str], file: Path, comma: bool = False) -> tuple[Channel, ...]:
    lines = [line for line, _ in rows]
    columns = columns_of(rows, len(names), file)
    return tuple(number_channel(name, cells, lines, file, comma) for name, cells in zip(names, columns, strict=True))


def _labelled(body: list[tuple[int, str]], file: Path) -> tuple[list[str], list[tuple[int, list[str]]]]:
    """Return names and rows of the older form, with a name before each number."""
    names = body[0][1].split()[::2]
    for i, line in body:
        cells = line.split()
        if cells[::2] != names or len(cells) % 2:
            raise LogError(f"must contain {', '.join(names)}, each followed by its number", file=file, line=i)
    return names, [(i, line.split()[1::2]) for i, line in body]


def matches_sampler(file: Path, head: bytes) -> bool:
    """Tell whether lines end in a blank, as halsampler writes them, or have its six decimals, or one is an overrun.

    Raises
    ------
    LogError
        If the blanks were stripped and the first column may be the sample number, so that the numbers of the columns are ambiguous.
    """
    lines = head.decode("latin-1").replace("\r\n", "\n").split("\n")[:-1]
    if not lines:
        return False
    if any(line.strip() == OVERRUN for line in lines):
        return True
    if all(line.endswith(" ") and not line.endswith("  ") and _plain(line) for line in lines[:20]):
        return True
    if not all(_SAMPLE.match(line) for line in lines[:20]) or not any(_SIX.search(line) for line in lines[:20]):
        return False
    first = [re.split(r"[ \t;]", line)[0] for line in lines[:20]]
    if all(cell.isdecimal() for cell in first) and all(int(a) < int(b) for a, b in pairwise(first)):
        cure = (
            "name the format, --format halsampler (columns count from the second) or --format csv, or restore the blank at each line's end"
        )
        raise LogError(f"may be a log of halsampler -t whose lines were changed: {cure}", file=file)
    return True


def _plain(line: str) -> bool:
    try:
        [float(cell) for cell in line.split()]
    except ValueError:
        return False
    return bool(line.split())


def read_sampler(file: Path) -> Record:
    """Read the output of halsampler, with or without ``-t``.

    It has neither names nor period: columns are named 1, 2, ... in the order of the pins, and the period must be given. A first column of
    increasing whole numbers becomes the channel ``sample``, the sample number; if it is a pin, use ``--format csv``.

    Raises
    ------
    LogError
        If a line is faulty, unnumbered samples were lost, or sample numbers restart.
    """
    written, findings = lines_of(file)
    lines = [(i, line.replace(",", ".").replace(";", " ").split()) for i, line in written]
    rows = [(i, cells) for i, cells in lines if cells != [OVERRUN]]
    refuse(not rows, LogError, "contains no samples", file=file)
    channels = _channels(rows, [str(j + 1) for j in range(len(rows[0][1]))], file)
    tagged = _is_numbered(rows, channels[0].values, file)
    lost = len(lines) - len(rows)
    if lost and not tagged:
        line = next(i for i, cells in lines if cells == [OVERRUN])
        raise LogError("unnumbered samples were lost here: sample again with halsampler -t", file=file, line=line)
    if tagged:
        channels = tuple(replace(c, name=str(j) if j else "sample") for j, c in enumerate(channels))
    findings += (finding("CL422", overruns=lost),) if lost else ()
    return Record(file, "halsampler", channels, findings=findings)


def _is_numbered(rows: list[tuple[int, list[str]]], first: Array, file: Path) -> bool:
    """Tell whether the first column is the sample number: written as whole numbers, and increasing."""
    if len(rows[0][1]) < 2 or len(rows) < 2 or any("." in cells[0] for _, cells in rows):
        return False
    step = np.diff(first)
    if np.all(step >= 1.0):
        return True
    # Bits and encoder counts stand still or step back; sample numbers do neither.
    if np.mean(step == 1.0) > MOSTLY and np.all(step[step != 1.0] < 0.0):
        back = int(np.argmin(step))
        raise LogError(
            f"the sample number goes back from {first[back]:.0f} to {first[back + 1]:.0f}: split the file if it contains two records; "
            "if its first column is a pin, use --format csv",
            file=file,
            line=rows[back + 1][0],
        )
    return False
