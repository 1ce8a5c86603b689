"""LinuxCNC's halsampler: a line of numbers for each sample, in the order of the pins; "overrun" where some were lost (halsampler(1))."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from contourlab.errors import LogError
from contourlab.logs.reading import numbers, text_of
from contourlab.logs.record import Channel, Record

__all__ = ["matches", "read"]

OVERRUN = "overrun"


def matches(file: Path, head: bytes) -> bool:
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


def read(file: Path) -> Record:
    """Read what halsampler wrote, with ``-t`` or without.

    The file knows neither names nor period: columns are named 1, 2, ... in the order of the sampler's pins, and the period has to be
    given. A first column of whole numbers that only grows is the sample's number, which is kept as the channel ``sample``.

    Raises
    ------
    LogError
        If a line is faulty, or samples were lost and are not numbered.
    """
    lines = [(i, line.split()) for i, line in enumerate(text_of(file).splitlines(), 1) if line.strip()]
    rows = [(i, cells) for i, cells in lines if cells != [OVERRUN]]
    if not rows:
        raise LogError("holds no samples", file=file)
    values = numbers(rows, len(rows[0][1]), file)
    first = values[:, 0]
    tagged = values.shape[1] > 1 and len(first) > 1 and bool(np.all(first == np.rint(first)) and np.all(np.diff(first) >= 1.0))
    lost = len(lines) - len(rows)
    if lost and not tagged:
        line = next(i for i, cells in lines if cells == [OVERRUN])
        raise LogError("samples were lost here, and they are not numbered: sample again with halsampler -t", file=file, line=line)
    names = (["sample"] if tagged else []) + [str(j + 1) for j in range(values.shape[1] - tagged)]
    notes = (f"{lost} overruns: samples were lost there",) if lost else ()
    return Record(file, "halsampler", tuple(Channel(n, v) for n, v in zip(names, values.T, strict=True)), notes=notes)
