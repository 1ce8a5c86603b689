"""One cell of a log that holds a date, a time of day or both, taken apart."""

from __future__ import annotations

import re
from functools import lru_cache
from typing import NamedTuple

SECOND, MINUTE, HOUR, DAY = 10**9, 60 * 10**9, 3600 * 10**9, 86400 * 10**9
"""In nanoseconds."""
YEAR_FIRST, DAY_FIRST, MONTH_FIRST, UNTOLD = "year first", "day first", "month first", "day or month first"
NAMED = "month by its name"
_MONTHS = ["january", "february", "march", "april", "may", "june", "july", "august", "september", "october", "november", "december"]
_LIKE = re.compile(
    r"(\d{1,4}[-/.]\d{1,2}[-/.]\d{1,4}|\d{8}(?=T)|"
    r"(?P<named>\d{1,2}(\.? |[-/.])[^\W\d_]{3,}\.?[-/. ]\d{2,4}|[^\W\d_]{3,}\.? \d{1,2},? \d{4}))?[T ,]*"
    r"(\d{1,2}:\d\d(:\d\d([.,:]\d+)?)?|\d{6}([.,]\d+)?)?\s*([AaPp][Mm])?\s*(Z|[+-]\d\d(:?\d\d)?)?\Z"
)
_DATE = re.compile(r"\d{1,4}(?P<mark>[-/.])\d{1,2}(?P=mark)\d{1,4}(?=[T ,]|\Z)|\d{8}(?=T)")
_DAY_MONTH = re.compile(r"(?P<day>\d{1,2})(\.? |[-/.])(?P<month>[A-Za-z]{3,9})\.?[-/. ](?P<year>\d{4})(?=[T ,]|\Z)")
_MONTH_DAY = re.compile(r"(?P<month>[A-Za-z]{3,9})\.? (?P<day>\d{1,2}),? (?P<year>\d{4})(?=[T ,]|\Z)")
_CLOCK = re.compile(r"(?P<hour>\d{1,2}):(?P<minute>\d\d)(:(?P<second>\d\d))?\s*(?P<half>[AaPp][Mm])?\s*(?P<zone>Z|[+-]\d\d(:?\d\d)?)?\Z")
_PACKED = re.compile(r"\AT(\d\d)(\d\d)(\d\d)")
_FRACTION = re.compile(r"((?<=:\d\d:\d\d)|(?<=T\d{6}))[.,](?P<decimals>\d{1,9})(?!\d)|(?<=:\d\d:\d\d):(?P<thousandths>\d{3})(?!\d)")


class Cell(NamedTuple):
    """A moment without the fraction of its second: the numbers of its date and their order, and its time of day."""

    date: tuple[int, int, int] | None
    order: str
    clock: int | None
    """Nanoseconds since midnight, in UTC where there is a zone."""
    zoned: bool = False
    half: bool = False
    """Whether the time of day says AM or PM."""


def is_moment(cell: str) -> bool:
    """Tell whether a cell looks like a date, a time of day or both, told for sure or not.

    >>> is_moment("2024-05-31T14:03:21.250Z"), is_moment("31.05.2024 14:03"), is_moment("1.5"), is_moment("")
    (True, True, False, False)
    >>> is_moment("31-May-2024 14:03:21"), is_moment("31. Mai 2024"), is_moment("may")
    (True, True, False)
    """
    text = cell.strip()
    found = _LIKE.match(text)
    if found is None:
        return False
    return found["named"] is not None or ":" in text or text[8:9] == "T" or any(text.count(mark) == 2 for mark in "-/.")


def taken_apart(text: str) -> tuple[Cell | None, int]:
    """Return what a cell says, None where that is in doubt, and the fraction of its second in nanoseconds.

    >>> taken_apart("31-May-2024 00:00:01.25")
    (Cell(date=(31, 5, 2024), order='month by its name', clock=1000000000, zoned=False, half=False), 250000000)
    """
    part = _FRACTION.search(text)
    if part is None:
        return _cell(text), 0
    return _cell(text[: part.start()] + text[part.end() :]), int((part["decimals"] or part["thousandths"]).ljust(9, "0"))


@lru_cache(maxsize=4096)  # thousands of samples share a second
def _cell(text: str) -> Cell | None:
    """Return what a cell without the fraction of its second says, None where that is in doubt."""
    date = _DATE.match(text) or _DAY_MONTH.match(text) or _MONTH_DAY.match(text)
    numbers, order = (None, "") if date is None else _named(date) if "month" in date.re.groupindex else _dated(date.group())
    if date is not None and not order:
        return None
    rest = text if date is None else text[date.end() :]
    if date is not None and not rest:
        return Cell(numbers, order, None)
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
    return Cell(numbers, order, since, clock["zone"] is not None, clock["half"] is not None)


def _named(date: re.Match[str]) -> tuple[tuple[int, int, int], str]:
    """Return day, month and year of a date whose month has its English name, and their order; an empty one where that is no month."""
    name = date["month"].casefold()
    month = next((k for k, whole in enumerate(_MONTHS, 1) if whole.startswith(name) or name == "sept" == whole[:4]), 0)
    return (int(date["day"]), month, int(date["year"])), NAMED if month else ""


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
