"""Dates and times of day in a log, as seconds from the first of them."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import LogError
from contourlab.logs.reading import is_empty, shown
from contourlab.logs.record import Channel

DAY = 86_400 * 10**9
"""Nanoseconds."""
EXAMPLE = "2024-05-31T14:03:21.250"
CURE = f"write timestamps as {EXAMPLE}, with Z or +02:00 behind them or not, or as seconds; or give --period"

_DATE = (
    r"(\d{1,4}[-/.]\d{1,2}[-/.]\d{1,4}|\d{8}(?=T)"
    r"|\d{1,2}(\.? |[-/.])[^\W\d_]{3,}\.?[-/. ]\d{2,4}|[^\W\d_]{3,}\.? \d{1,2},? \d{4})"
)
_ZONE = r"(?P<zone>Z|[+-]\d\d(:?\d\d)?)?\Z"
_CLOCK_LIKE = r"\d{1,2}:\d\d(:\d\d([.,:]\d+)?)?\s*([AaPp][Mm])?"
_LIKE = re.compile(rf"({_CLOCK_LIKE}|{_DATE}([T ,]*{_CLOCK_LIKE}|T\d{{6}}([.,]\d+)?)?)\s*{_ZONE}")
_CLOCK = r"([01]?\d|2[0-3]):[0-5]\d:[0-5]\d(\.\d{1,9})?"
_FORMS = {
    "ISO8601": re.compile(rf"(\d{{4}}-\d\d-\d\d[T ]{_CLOCK}|\d{{8}}T\d{{6}}(\.\d{{1,9}})?){_ZONE}"),
    "mixed": re.compile(rf"(\d{{1,2}}\.\d{{1,2}}\.\d{{4}}|\d{{1,2}}[- ][A-Za-z]{{3,9}}[- ]\d{{4}}) {_CLOCK}{_ZONE}"),
    "time of day": re.compile(rf"{_CLOCK}\Z"),
}
"""Timestamps without doubt; the names of the first two are formats of `pandas.to_datetime`."""


def is_timestamp(cell: str) -> bool:
    """Tell whether a cell looks like a date, a time of day or both, in doubt or not.

    >>> is_timestamp("2024-05-31T14:03:21.250Z"), is_timestamp("31.05.2024 14:03"), is_timestamp("1.5"), is_timestamp("")
    (True, True, False, False)
    >>> is_timestamp("31-May-2024 14:03:21"), is_timestamp("31. Mai 2024"), is_timestamp("may")
    (True, True, False)
    """
    return _LIKE.match(cell.strip()) is not None


def timestamp_channel(name: str, texts: Sequence[str], lines: Sequence[int], file: Path) -> Channel:
    """Return a column of timestamps as a channel of seconds from the first one.

    Nothing is raised here, because nobody may need the column: `Channel.fault` holds the error.

    Parameters
    ----------
    name : str
    texts : sequence of str
        Cells: ISO 8601 with T or a blank; the day first with dots; English month names; or times of day, which are counted on past
        midnight. Zones in all rows or in none. Empty cells are gaps.
    lines : sequence of int
        Line of each row in the file.
    file : Path
    """
    rows = [row for row, text in enumerate(texts) if not is_empty(text)]
    seconds = np.full(len(texts), np.nan)
    notes: tuple[str, ...] = ()
    try:
        ticks, is_clock = _ticks([texts[row] for row in rows], name, [lines[row] for row in rows], file)
    except LogError as fault:
        return Channel(name, seconds, "s", is_timestamp=True, fault=fault)
    if ticks.size:
        day, clock = ticks // DAY, ticks % DAY
        if is_clock:
            day = np.cumsum(np.diff(clock, prepend=clock[0]) < -DAY // 2)
            notes = (f"times of day in {name!r} run past midnight, and are counted on",) if day[-1] else ()
        seconds[rows] = (day - day[0]) * 86400.0 + (clock - clock[0]) * 1e-9
    return Channel(name, seconds, "s", is_timestamp=True, notes=notes)


def _ticks(texts: list[str], name: str, lines: Sequence[int], file: Path) -> tuple[NDArray[np.int64], bool]:
    """Return timestamps in nanoseconds, and whether they are times of day."""
    import pandas

    cells = [text.strip(' "').replace(",", ".") for text in texts]
    forms = [_form(cell) for cell in cells]
    wrong = [form is None or form != forms[0] for form in forms]
    ticks = np.zeros(len(cells), dtype=np.int64)
    is_clock = bool(forms and forms[0] and forms[0][0] == "time of day")
    if is_clock and not any(wrong):
        ticks = pandas.to_timedelta(cells).as_unit("ns").asi8
    elif forms and forms[0] and not any(wrong):
        stamps = pandas.to_datetime(cells, format=forms[0][0], dayfirst=True, utc=True, errors="coerce")
        wrong, ticks = stamps.isna().tolist(), stamps.as_unit("ns").asi8
    if any(wrong):
        k = wrong.index(True)
        other = ", written in another way than those before it," if forms[k] and forms[k] != forms[0] else ""
        raise LogError(f"{shown(texts[k])} in column {name!r}{other} is no timestamp without doubt: {CURE}", file=file, line=lines[k])
    return ticks, is_clock


def _form(cell: str) -> tuple[str, bool] | None:
    """Return which of `_FORMS` a cell has, and whether it has a zone; None if it is in doubt."""
    for name, form in _FORMS.items():
        if found := form.match(cell):
            return name, bool(found.groupdict().get("zone"))
    return None
