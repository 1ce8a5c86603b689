"""Dates and times of day in a log, as seconds from the first of them."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import LogError
from contourlab.logs.reading import is_empty, shown

__all__ = ["RIGHT", "Moments", "is_moment", "moments_of"]

Array = NDArray[np.float64]
SECOND, MINUTE, HOUR, DAY = 10**9, 60 * 10**9, 3600 * 10**9, 86400 * 10**9
"""In nanoseconds."""
YEAR_FIRST, DAY_FIRST, MONTH_FIRST, UNTOLD = "year first", "day first", "month first", "day or month first"
_PLACES = {YEAR_FIRST: (0, 1, 2), DAY_FIRST: (2, 1, 0), MONTH_FIRST: (2, 0, 1)}
RIGHT = "write times as 2024-05-31T14:03:21.250, with Z or +02:00 behind them or not, or as seconds; or give --period"
_LIKE = re.compile(
    r"(\d{1,4}[-/.]\d{1,2}[-/.]\d{1,4}|\d{8}(?=T))?[T ,]*"
    r"(\d{1,2}:\d\d(:\d\d([.,:]\d+)?)?|\d{6}([.,]\d+)?)?\s*([AaPp][Mm])?\s*(Z|[+-]\d\d(:?\d\d)?)?\Z"
)
_DATE = re.compile(r"\d{1,4}(?P<mark>[-/.])\d{1,2}(?P=mark)\d{1,4}(?=[T ,]|\Z)|\d{8}(?=T)")
_CLOCK = re.compile(r"(?P<hour>\d{1,2}):(?P<minute>\d\d)(:(?P<second>\d\d))?\s*(?P<half>[AaPp][Mm])?\s*(?P<zone>Z|[+-]\d\d(:?\d\d)?)?\Z")
_PACKED = re.compile(r"\AT(\d\d)(\d\d)(\d\d)")
_FRACTION = re.compile(r"((?<=:\d\d:\d\d)|(?<=T\d{6}))[.,](?P<decimals>\d{1,9})(?!\d)|(?<=:\d\d:\d\d):(?P<thousandths>\d{3})(?!\d)")


@dataclass(frozen=True, eq=False)
class Moments:
    """What a column of dates and times of day says.

    Attributes
    ----------
    seconds : ndarray (n,) [s]
        From its first moment on, in UTC where zones are said; not a number where a cell is empty, and everywhere where there is a fault.
    notes : tuple of str
        How it was understood, in words.
    fault : LogError or None
        Why it tells no times of samples; to be raised by whoever needs them.
    """

    seconds: Array
    notes: tuple[str, ...] = ()
    fault: LogError | None = None


class _Cell(NamedTuple):
    """A moment without the fraction of its second: the numbers of its date and their order, and its time of day."""

    date: tuple[int, int, int] | None
    order: str
    clock: int | None
    """Nanoseconds since midnight, in UTC where there is a zone."""
    zoned: bool = False
    half: bool = False
    """Whether the time of day says AM or PM."""


@dataclass(frozen=True)
class _Column:
    """Cells of a column, None where one is empty, and the fractions of their seconds in nanoseconds."""

    cells: list[_Cell | None]
    fractions: list[int]

    @property
    def first(self) -> _Cell:
        return next(cell for cell in self.cells if cell is not None)


@dataclass(frozen=True)
class _Place:
    """Where a column stands, for messages."""

    number: int
    name: str
    lines: Sequence[int]
    file: Path

    def fault(self, row: int, words: str) -> LogError:
        return LogError(words, file=self.file, line=self.lines[row])


def is_moment(cell: str) -> bool:
    """Tell whether a cell looks like a date, a time of day or both, told for sure or not.

    >>> is_moment("2024-05-31T14:03:21.250Z"), is_moment("31.05.2024 14:03"), is_moment("1.5"), is_moment("")
    (True, True, False, False)
    """
    text = cell.strip()
    return _LIKE.match(text) is not None and (":" in text or text[8:9] == "T" or any(text.count(mark) == 2 for mark in "-/."))


def moments_of(columns: Mapping[int, Sequence[str]], names: Sequence[str], lines: Sequence[int], file: Path) -> dict[int, Moments]:
    """Return what columns of dates and times of day say, by their number.

    Times of day alone are put together with the dates of another column, where there is one; without a date they are counted on past
    midnight. Nothing is raised here: a log may hold a date that nobody needs.

    Parameters
    ----------
    columns : mapping of int to sequence of str
        Cells of the columns that hold such, by the column's number from 0: ISO 8601, ``2024-05-31T14:03:21.250+02:00`` or
        ``20240531T140321.250``, with a blank for the T or not; the day first with dots, ``31.05.2024``; with slashes where a number above
        12 tells the day from the month, or all dates are one; times of day, ``14:03:21.250``, ``14:03:21:250``, ``2:03:21.250 PM``. Zones
        in all rows or in none. Empty cells are gaps.
    names : sequence of str
        Of all columns of the file.
    lines : sequence of int
        Lines of the rows in the file.
    file : Path
    """
    places = {j: _Place(j, names[j], lines, file) for j in columns}
    found: dict[int, Moments] = {}
    read: dict[int, _Column] = {}
    for j, texts in columns.items():
        try:
            read[j] = _taken_apart(texts, places[j])
        except LogError as error:
            found[j] = _at_fault(error, len(texts))
    clocks = [j for j, column in read.items() if column.first.date is None]
    dates = [j for j, column in read.items() if column.first.clock is None]
    named = [j for j in dates if names[j].strip().casefold() in ("date", "datum")] or dates
    for j, column in read.items():
        if j in dates:
            beside = f": its times of day are in {names[clocks[0]]!r}" if clocks else f": {RIGHT}"
            fault = LogError(f"column {names[j]!r} holds dates without times of day, which are no times of samples{beside}", file=file)
            found[j] = _at_fault(fault, len(column.cells))
        elif j in clocks and len(named) == 1:
            found[j] = _with_dates(column, read[named[0]], places[j], places[named[0]])
        else:
            found[j] = _told(column, column, places[j])
    return {j: found[j] for j in columns}


def _at_fault(fault: LogError, n: int) -> Moments:
    return Moments(np.full(n, np.nan), fault=fault)


def _with_dates(clocks: _Column, dates: _Column, place: _Place, of_dates: _Place) -> Moments:
    """Return the moments of times of day whose dates stand in another column; without the dates where those cannot be told."""
    found = _told(clocks, dates, of_dates)
    if found.fault is None:
        return Moments(found.seconds, (f"the dates in {of_dates.name!r} and the times of day in {place.name!r} are taken together",))
    why = f"the times of day in {place.name!r} are taken without their dates: {found.fault.message.removesuffix(f': {RIGHT}')}"
    alone = _told(clocks, clocks, place)
    return Moments(alone.seconds, (why, *alone.notes))


def _told(clocks: _Column, dates: _Column, place: _Place) -> Moments:
    """Return the seconds of times of day with the dates of their own cells or of others, `place` being that of the dates."""
    rows, of_day, days = [], [], []
    for row, (cell, fraction, day) in enumerate(zip(clocks.cells, clocks.fractions, dates.cells, strict=True)):
        if cell is not None and day is not None and cell.clock is not None:
            rows.append(row)
            of_day.append(cell.clock + fraction)
            days.append(day)
    if not rows:
        return _at_fault(LogError(f"no row has both a date in {place.name!r} and a time of day", file=place.file), len(clocks.cells))
    clock = np.array(of_day, dtype=np.int64)
    notes: tuple[str, ...] = ()
    if dates.first.date is None:
        clock %= DAY
        day_of = np.cumsum(np.diff(clock, prepend=clock[0]) < -DAY // 2, dtype=np.int64)
        notes = (f"times of day in {place.name!r} run past midnight, and are counted on",) if day_of[-1] else ()
    else:
        try:
            day_of = _days(days, rows, place)
        except LogError as error:
            return _at_fault(error, len(clocks.cells))
    seconds = np.full(len(clocks.cells), np.nan)
    # Counted from the first one as whole nanoseconds: a double holds none of them since 1970.
    seconds[rows] = day_of * 86400.0 + (clock - clock[0]) * 1e-9
    return Moments(seconds, notes)


def _days(cells: Sequence[_Cell], rows: Sequence[int], place: _Place) -> NDArray[np.int64]:
    """Return the days from the first one on; refuse what is no day of a calendar, or may be two."""
    dates = [cell.date for cell in cells if cell.date is not None]
    first_rows = dict(zip(reversed(dates), reversed(rows), strict=True))
    order = cells[0].order
    if order == UNTOLD:
        order = _order(first_rows, place)
    year, month, day = _PLACES[order]
    number = {}
    for date, row in first_rows.items():
        text = f"{date[year]:04d}-{date[month]:02d}-{date[day]:02d}"
        try:
            number[date] = int(np.datetime64(text, "D").astype(np.int64))
        except ValueError:
            raise place.fault(row, f"{text} in column {place.name!r} is no day of the calendar") from None
    return np.array([number[date] - number[dates[0]] for date in dates], dtype=np.int64)


def _order(first_rows: Mapping[tuple[int, int, int], int], place: _Place) -> str:
    """Return whether day or month goes first in dates with slashes: a number above 12 tells; where all are one day either will do."""
    day_first = [row for date, row in first_rows.items() if date[0] > 12]
    month_first = [row for date, row in first_rows.items() if date[1] > 12]
    if day_first and month_first:
        words = f"dates in column {place.name!r} have the day first and the month first: {RIGHT}"
        raise place.fault(max(min(day_first), min(month_first)), words)
    if not day_first and not month_first and len(first_rows) > 1:
        date, row = min(first_rows.items(), key=lambda pair: pair[1])
        raise place.fault(row, f"day and month of {date[0]:02d}/{date[1]:02d} in column {place.name!r} cannot be told for sure: {RIGHT}")
    return MONTH_FIRST if month_first else DAY_FIRST


def _taken_apart(texts: Sequence[str], place: _Place) -> _Column:
    """Return the cells of a column; refuse those that cannot be told for sure, and more than one way of writing."""
    found = _Column([], [])
    first = last = None
    for row, text in enumerate(texts):
        word = text.strip(' "')
        part = _FRACTION.search(word)
        cell = _cell(word if part is None else word[: part.start()] + word[part.end() :])
        if cell is None and not is_empty(word):
            words = f"{shown(text)} in column {place.number + 1} is no date and time that can be told for sure: {RIGHT}"
            raise place.fault(row, words)
        if cell is not None and cell is not last:
            first, last = first or cell, cell
            _check_form(cell, first, text, row, place)
        found.cells.append(cell)
        found.fractions.append(0 if part is None else int((part["decimals"] or part["thousandths"]).ljust(9, "0")))
    return found


def _check_form(cell: _Cell, first: _Cell, text: str, row: int, place: _Place) -> None:
    """Refuse a cell that is written in another way than the first one of its column."""
    if cell.zoned != first.zoned:
        raise place.fault(row, f"{shown(text)} in column {place.number + 1}: only some of its times say their zone")
    if (cell.order, cell.half, cell.clock is None) != (first.order, first.half, first.clock is None):
        raise place.fault(row, f"{shown(text)} in column {place.number + 1} is written in another way than those before it")


@lru_cache(maxsize=4096)  # thousands of samples share a second
def _cell(text: str) -> _Cell | None:
    """Return what a cell without the fraction of its second says, None where that is in doubt."""
    date = _DATE.match(text)
    numbers, order = (None, "") if date is None else _dated(date.group())
    if date is not None and not order:
        return None
    rest = text if date is None else text[date.end() :]
    if date is not None and not rest:
        return _Cell(numbers, order, None)
    clock = _CLOCK.match(_PACKED.sub(r"\1:\2:\3", rest).lstrip("T ,"))
    if clock is None or (date is None and clock["second"] is None):
        return None
    hour, minute, second = int(clock["hour"]), int(clock["minute"]), int(clock["second"] or 0)
    if clock["half"]:
        if not 1 <= hour <= 12:
            return None
        hour = hour % 12 + (12 if clock["half"].upper() == "PM" else 0)
    if hour > 23 or minute > 59 or second > 59:
        return None
    since = hour * HOUR + minute * MINUTE + second * SECOND - _ahead(clock["zone"])
    return _Cell(numbers, order, since, clock["zone"] is not None, clock["half"] is not None)


def _dated(text: str) -> tuple[tuple[int, int, int], str]:
    """Return the numbers of a date and their order; an empty one where the year cannot be told."""
    if text.isdigit():
        return (int(text[:4]), int(text[4:6]), int(text[6:])), YEAR_FIRST
    texts = re.split("[-/.]", text)
    year_at = [k for k in (0, 2) if len(texts[k]) == 4]
    order = "" if len(year_at) != 1 else YEAR_FIRST if year_at == [0] else DAY_FIRST if "." in text else UNTOLD
    return (int(texts[0]), int(texts[1]), int(texts[2])), order


def _ahead(zone: str | None) -> int:
    """Return the nanoseconds that a zone is ahead of UTC."""
    if zone is None or zone == "Z":
        return 0
    digits = zone[1:].replace(":", "").ljust(4, "0")
    return (-1 if zone[0] == "-" else 1) * (int(digits[:2]) * HOUR + int(digits[2:]) * MINUTE)
