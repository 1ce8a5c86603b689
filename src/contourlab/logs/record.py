"""The content of a log: named channels, constants and notes. Limits on what it may cost: a small file must not fill the memory."""

from __future__ import annotations

import itertools
import math
import os
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from contourlab.arrays import Array
from contourlab.errors import LogError, ParameterError
from contourlab.findings import Finding

AXIS_LETTERS = "xyzabcuvw"
"""Axes in the order of their joints."""
SETTING = "CONTOURLAB_LOG_LIMIT"
"""Environment variable with a factor on all limits."""
COLUMNS = 10_000
LINE = 1_000_000
"""Characters of a line of text."""
NUMBERS = 50_000_000
"""Numbers of a log in a compressed or sparse format."""
MEMORY = 850_000_000
"""Memory of the process that reads a binary format [byte]."""
TIME = 60.0
"""Time of that process [s]."""


@dataclass(frozen=True, eq=False)
class Channel:
    """One column of a log.

    Attributes
    ----------
    name : str
        Name in the file.
    values : ndarray (n,)
        In `unit`; NaN for missing values.
    unit : str
        Unit stated in the file; empty for none.
    time : ndarray (n,) [s] or None
        Time of each value; None if the file has no times.
    is_timestamp : bool
        Whether it held dates or times of day, now in seconds from the first.
    findings : tuple of Finding
        How its values were read.
    fault : LogError or None
        Why its values cannot be read; raised if they are needed.
    symbol : str
        Path of the recorded variable in the control, if the file gives it.
    """

    name: str
    values: Array
    unit: str = ""
    time: Array | None = None
    is_timestamp: bool = False
    findings: tuple[Finding, ...] = ()
    fault: LogError | None = None
    symbol: str = ""


@dataclass(frozen=True, eq=False)
class Record:
    """A log as read.

    Attributes
    ----------
    format : str
        Name of the reader.
    channels : tuple of Channel
        Channels with the same name are numbered, ``x #1``, ``x #2``.
    period : float [s] or None
        Sample period, if the file states it.
    constants : mapping of str to float
        Single numbers of the file, such as gains and scales.
    findings : tuple of Finding
        What was skipped.
    attributes : mapping of str to str, int or float
        Attributes of a result that contourlab wrote.
    """

    file: Path
    format: str
    channels: tuple[Channel, ...]
    period: float | None = None
    constants: Mapping[str, float] = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()
    attributes: Mapping[str, str | int | float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        check_limit(len(self.channels), COLUMNS, "columns", self.file)
        count = Counter(channel.name for channel in self.channels)
        place = {name: itertools.count(1) for name in count}
        numbered = (replace(c, name=f"{c.name} #{next(place[c.name])}") if count[c.name] > 1 else c for c in self.channels)
        object.__setattr__(self, "channels", tuple(numbered))
        if not any(channel.values.size for channel in self.channels):
            raise LogError("contains no samples", file=self.file)
        faults = [channel.fault for channel in self.channels]
        if faults[0] is not None and all(faults):
            raise faults[0]

    @property
    def names(self) -> list[str]:
        """Names of the channels, in the order of the file."""
        return [channel.name for channel in self.channels]

    def channel(self, name: str) -> Channel:
        """Return a channel by its exact name, else ignoring case, else by a part of its name.

        Raises
        ------
        LogError
            If none or several match.
        """
        return self.channels_of([name])[0]

    def channels_of(self, names: Iterable[str]) -> list[Channel]:
        """Return channels by their names, as `channel` does; an error names all columns that are missing."""
        matches = {}
        for name in names:
            folded = name.casefold()
            matches[name] = (
                [c for c in self.channels if c.name == name]
                or [c for c in self.channels if c.name.casefold() == folded]
                or [c for c in self.channels if folded in c.name.casefold()]
            )
        if absent := [name for name, channels in matches.items() if not channels]:
            column = "column" if len(absent) == 1 else "columns"
            raise LogError(f"has no {column} {quoted(absent)}; the columns are {quoted(self.names)}", file=self.file)
        for name, channels in matches.items():
            if len(channels) > 1:
                several = quoted(c.name for c in channels)
                raise LogError(f"column {name!r} is ambiguous, it matches {several}: write the full name", file=self.file)
        return [channels[0] for channels in matches.values()]


def quoted(names: Iterable[str], most: int = 30) -> str:
    """Return up to `most` names in quotes."""
    listed = [repr(name) for name in names]
    more = f" and {len(listed) - most} more" if len(listed) > most else ""
    return ", ".join(listed[:most]) + more


def join_names(names: Sequence[str]) -> str:
    """Join the names of logs; shorten the list if there are more than three.

    >>> join_names(["a", "b", "c", "d"])
    'a, b and 2 more'
    """
    return ", ".join(names) if len(names) <= 3 else f"{', '.join(names[:2])} and {len(names) - 2} more"


def factor() -> float:
    """Return the factor on all limits.

    Raises
    ------
    ParameterError
        If the setting is not a positive number.
    """
    text = os.environ.get(SETTING, "1")
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0.0 < value < math.inf:
        raise ParameterError(SETTING, repr(text), "a factor > 0, such as 4")
    return value


def check_limit(count: int, most: int, what: str, file: Path, line: int = 0) -> None:
    """Raise `LogError` if a log has more than `most` columns, characters or numbers, times the factor."""
    if count > most * factor():
        # Rounded up, so that the value in the message is enough.
        raise LogError(f"has {count} {what}, too many: set {SETTING}={math.ceil(count / most)} to read it", file=file, line=line)


def raised() -> str:
    """Return what to write if memory or time are not enough."""
    return f"if the file is sound, set {SETTING}={math.ceil(2.0 * factor())}"
