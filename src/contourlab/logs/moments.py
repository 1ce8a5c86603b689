"""Dates and times of day in a log, as seconds from the first of them."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import LogError

__all__ = ["is_moment", "seconds_from_first"]

Array = NDArray[np.float64]
_ISO = re.compile(
    r"((?P<date>\d{4}-\d\d-\d\d)[T ])?(?P<time>\d\d:\d\d(?P<seconds>:\d\d([.,]\d{1,9})?)?)\s?(?P<zone>Z|[+-]\d\d(:?\d\d)?)?\Z"
)
_LIKE = re.compile(
    r"(\d{1,4}[-/.]\d{1,2}[-/.]\d{1,4}|\d{8}T)?[T ,]*(\d{1,2}:\d\d(:\d\d([.,]\d+)?)?|\d{6})?\s*([AaPp][Mm]|Z|[+-]\d\d(:?\d\d)?)?\Z"
)
RIGHT = "write times as 2024-05-31T14:03:21.250, with Z or +02:00 behind them or not, or as seconds"


def is_moment(cell: str) -> bool:
    """Tell whether a cell looks like a date, a time of day or both, told for sure or not.

    >>> is_moment("2024-05-31T14:03:21.250Z"), is_moment("31.05.2024 14:03"), is_moment("1.5"), is_moment("")
    (True, True, False, False)
    """
    text = cell.strip()
    return _LIKE.match(text) is not None and (":" in text or text.count("-") == 2 or text.count("/") == 2 or text.count(".") == 2)


def seconds_from_first(cells: Sequence[str], lines: Sequence[int], column: int, file: Path) -> Array:
    """Return moments (n,) [s] from the first one on; those with an offset from UTC are counted in UTC.

    Parameters
    ----------
    cells : sequence of str
        Dates with times of day in the form of ISO 8601, ``2024-05-31T14:03:21.250+02:00``, or times alone, ``14:03:21.250``; a blank may
        stand for the T, the zone may be missing in all of them.
    lines : sequence of int
        Their lines in the file.
    column : int
        From 0.
    file : Path

    Raises
    ------
    LogError
        If one is no such moment, or only some say their zone; says the line.
    """
    stamps, offsets = [], np.zeros(len(cells))
    zoned: bool | None = None
    for i, (cell, line) in enumerate(zip(cells, lines, strict=True)):
        found = _ISO.match(cell.strip().strip('"').strip())
        if found is None or (found["date"] is None and found["seconds"] is None):
            raise LogError(
                f"{cell.strip()!r} in column {column + 1} is no date and time that can be told for sure: {RIGHT}", file=file, line=line
            )
        zone = found["zone"]
        if zoned is not None and zoned != (zone is not None):
            raise LogError(f"{cell.strip()!r} in column {column + 1}: only some of its times say their zone", file=file, line=line)
        zoned = zone is not None
        if zone is not None and zone != "Z":
            digits = zone[1:].replace(":", "").ljust(4, "0")
            offsets[i] = (-1.0 if zone[0] == "-" else 1.0) * 60.0 * (60 * int(digits[:2]) + int(digits[2:]))
        stamps.append(f"{found['date'] or '1970-01-01'}T{found['time'].replace(',', '.')}")
    ticks = _ticks(stamps, lines, column, file)
    # Counted from the first one as whole nanoseconds: a double holds none of them since 1970.
    return np.asarray((ticks - ticks[0]).astype(np.float64) * 1e-9 - (offsets - offsets[0]))


def _ticks(stamps: Sequence[str], lines: Sequence[int], column: int, file: Path) -> NDArray[np.int64]:
    """Return nanoseconds; refuse what is no day of a calendar, or no time of a day."""
    try:
        return np.array(stamps, dtype="datetime64[ns]").astype(np.int64)
    except ValueError:
        for stamp, line in zip(stamps, lines, strict=True):
            try:
                np.datetime64(stamp, "ns")
            except ValueError as error:
                raise LogError(f"{stamp!r} in column {column + 1} is no day and time: {error}", file=file, line=line) from error
        raise
