"""Dates and times of day in a log, as seconds from the first of them."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import LogError
from contourlab.logs.moment_cell import DAY, DAY_FIRST, MONTH_FIRST, NAMED, SECOND, UNTOLD, YEAR_FIRST, Cell, is_moment, taken_apart
from contourlab.logs.reading import called, is_empty, number, shown

Array = NDArray[np.float64]
_PLACES = {YEAR_FIRST: (0, 1, 2), DAY_FIRST: (2, 1, 0), MONTH_FIRST: (2, 0, 1), NAMED: (2, 1, 0)}
EXAMPLE = "2024-05-31T14:03:21.250"
RIGHT = f"write times as {EXAMPLE}, with Z or +02:00 behind them or not, or as seconds; or give --period"


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


@dataclass(frozen=True)
class _Column:
    """Cells of a column, None where one is empty, and the fractions of their seconds in nanoseconds."""

    cells: list[Cell | None]
    fractions: list[int]

    @property
    def first(self) -> Cell:
        return next(cell for cell in self.cells if cell is not None)


@dataclass(frozen=True)
class _Place:
    """Where a column stands, for messages."""

    name: str
    lines: Sequence[int]
    file: Path

    def fault(self, row: int, words: str) -> LogError:
        return LogError(words, file=self.file, line=self.lines[row])


def moments_of(
    columns: Mapping[int, Sequence[str]],
    names: Sequence[str],
    lines: Sequence[int],
    file: Path,
    milliseconds: Mapping[int, Sequence[str]] | None = None,
) -> dict[int, Moments]:
    """Return what columns of dates and times of day say, by their number.

    Times of day alone are put together with the dates of another column, where there is one; without a date they are counted on past
    midnight. Nothing is raised here: a log may hold a date that nobody needs.

    Parameters
    ----------
    columns : mapping of int to sequence of str
        Cells of the columns that hold such, by the column's number from 0: ISO 8601, ``2024-05-31T14:03:21.250+02:00`` or
        ``20240531T140321.250``, with a blank for the T or not; the day first with dots, ``31.05.2024``; with slashes where a number above
        12 tells the day from the month, or all dates are one; months by their English names, ``31-May-2024``; times of day,
        ``14:03:21.250``, ``14:03:21:250``, ``2:03:21.250 PM``. Zones in all rows or in none. Empty cells are gaps.
    names : sequence of str
        Of all columns of the file.
    lines : sequence of int
        Lines of the rows in the file.
    file : Path
    milliseconds : mapping of int to sequence of str, optional
        Cells of the columns that are called so: joined to the whole seconds of the times of day to their left.
    """
    places = {j: _Place(name, lines, file) for j, name in enumerate(names)}
    found: dict[int, Moments] = {}
    read: dict[int, _Column] = {}
    for j, texts in columns.items():
        try:
            read[j] = _taken_apart(texts, places[j])
        except LogError as error:
            found[j] = _at_fault(error, len(texts))
    untold = [moments.fault.message.removesuffix(f": {RIGHT}") for j, moments in found.items() if moments.fault and _are_dates(columns[j])]
    joined = _join_milliseconds(read, milliseconds or {}, places)
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
        elif j in clocks and (why := untold if not named else [f"they are in {' or '.join(repr(names[k]) for k in named)}"]):
            found[j] = _without_dates(column, places[j], "; ".join(why))
        else:
            found[j] = _told(column, column, places[j])
        if j in joined:
            found[j] = replace(found[j], notes=(*found[j].notes, joined[j]))
    return {j: found[j] for j in columns}


def _at_fault(fault: LogError, n: int) -> Moments:
    return Moments(np.full(n, np.nan), fault=fault)


def _join_milliseconds(read: Mapping[int, _Column], columns: Mapping[int, Sequence[str]], places: Mapping[int, _Place]) -> dict[int, str]:
    """Give times of day in whole seconds the milliseconds of the column to their right; return what there is to say, by their number."""
    said = {}
    for k, texts in columns.items():
        whole = [j for j, column in read.items() if column.first.clock is not None and not any(column.fractions)]
        if not whole:
            continue
        j = max((j for j in whole if j < k), default=whole[0])
        parts = [_milliseconds(text) for text in texts]
        wrong = next((row for row, part in enumerate(parts) if part is not None and not 0 <= part < SECOND), None)
        if wrong is not None:
            where = f"{shown(texts[wrong])} in line {places[k].lines[wrong]} is none of 0 to 999"
            said[j] = f"{called(places[k].name)} is not joined to the times in {places[j].name!r} as milliseconds: {where}"
            continue
        column = read[j]
        cells = [cell if part is not None else None for cell, part in zip(column.cells, parts, strict=True)]
        if not any(cells):
            continue
        column.cells[:] = cells
        column.fractions[:] = [part or 0 for part in parts]
        said[j] = f"the times of day in {places[j].name!r} and the milliseconds in {places[k].name!r} are taken together"
    return said


def _milliseconds(text: str) -> int | None:
    """Return milliseconds in nanoseconds, None where the cell is empty, -1 where it holds anything else."""
    if is_empty(text):
        return None
    try:
        return round(1e6 * number(text, comma="," in text))
    except (ValueError, OverflowError):
        return -1


def _with_dates(clocks: _Column, dates: _Column, place: _Place, of_dates: _Place) -> Moments:
    """Return the moments of times of day whose dates stand in another column; without the dates where those cannot be told."""
    found = _told(clocks, dates, of_dates)
    if found.fault is None:
        return Moments(found.seconds, (f"the dates in {of_dates.name!r} and the times of day in {place.name!r} are taken together",))
    return _without_dates(clocks, place, found.fault.message)


def _without_dates(clocks: _Column, place: _Place, why: str) -> Moments:
    """Return the moments of times of day whose dates cannot be told, and say why not."""
    alone = _told(clocks, clocks, place)
    said = f"the times of day in {place.name!r} are taken without their dates: {why.removesuffix(f': {RIGHT}')}"
    return replace(alone, notes=(said, *alone.notes))


def _are_dates(texts: Sequence[str]) -> bool:
    """Tell whether a column looks like one of dates without times of day, told for sure or not."""
    first = next((text.strip(' "') for text in texts if not is_empty(text.strip(' "'))), "")
    return is_moment(first) and re.search(r":|\dT\d", first) is None


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


def _days(cells: Sequence[Cell], rows: Sequence[int], place: _Place) -> NDArray[np.int64]:
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
        cell, fraction = taken_apart(word)
        if cell is None and not is_empty(word):
            words = f"{shown(text)} in {called(place.name)} is no date and time that can be told for sure: {RIGHT}"
            raise place.fault(row, words)
        if cell is not None and cell is not last:
            first, last = first or cell, cell
            _check_form(cell, first, text, row, place)
        found.cells.append(cell)
        found.fractions.append(fraction)
    return found


def _check_form(cell: Cell, first: Cell, text: str, row: int, place: _Place) -> None:
    """Refuse a cell that is written in another way than the first one of its column."""
    if cell.zoned != first.zoned:
        raise place.fault(row, f"{shown(text)} in {called(place.name)}: only some of its times say their zone")
    if (cell.order, cell.half, cell.clock is None) != (first.order, first.half, first.clock is None):
        raise place.fault(row, f"{shown(text)} in {called(place.name)} is written in another way than those before it")
