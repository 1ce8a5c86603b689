"""The content of a log as read: named channels, constants and notes."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import LogError

Array = NDArray[np.float64]
AXIS_LETTERS = "xyzabcuvw"
"""Axes in the order of their joints."""


@dataclass(frozen=True, eq=False)
class Channel:
    """One column of a log.

    Attributes
    ----------
    name : str
        As the file has it.
    values : ndarray (n,)
        In `unit`; not a number where the file has no value.
    unit : str
        As the file says; empty where it says none.
    time : ndarray (n,) [s] or None
        Time of each value; None where the file numbers them only.
    is_timestamp : bool
        Whether it holds dates and times of day, counted in seconds from the first of them.
    notes : tuple of str
        How its values were read, in words.
    fault : LogError or None
        Why its values cannot be read; raise it if they are needed.
    symbol : str
        Path of the recorded variable in the control, if the file gives it.
    """

    name: str
    values: Array
    unit: str = ""
    time: Array | None = None
    is_timestamp: bool = False
    notes: tuple[str, ...] = ()
    fault: LogError | None = None
    symbol: str = ""


@dataclass(frozen=True, eq=False)
class Record:
    """A log as it was read.

    Attributes
    ----------
    file : Path
    format : str
        Name of the reader.
    channels : tuple of Channel
        Those of the same name are numbered, ``x #1``, ``x #2``.
    period : float [s] or None
        Between samples, where the file says so.
    constants : mapping of str to float
        Numbers that stand beside the channels: gains, scales.
    notes : tuple of str
        What was skipped in reading, in words.
    attributes : mapping of str to str, int or float
        Of the result that it is, where contourlab wrote it.
    """

    file: Path
    format: str
    channels: tuple[Channel, ...]
    period: float | None = None
    constants: Mapping[str, float] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    attributes: Mapping[str, str | int | float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "channels", _told_apart(self.channels))
        if not any(channel.values.size for channel in self.channels):
            raise LogError("holds no samples", file=self.file)

    @property
    def names(self) -> list[str]:
        """Names of the channels, in the order of the file."""
        return [channel.name for channel in self.channels]

    def channel(self, name: str) -> Channel:
        """Return the channel of that name: exactly, else without regard to case, else the one that the name is a part of.

        Raises
        ------
        LogError
            If there is none, or the name is a part of several; the message lists them.
        """
        for found in (
            [c for c in self.channels if c.name == name],
            [c for c in self.channels if c.name.casefold() == name.casefold()],
            [c for c in self.channels if name.casefold() in c.name.casefold()],
        ):
            if len(found) == 1:
                return found[0]
            if found:
                raise LogError(f"column {name!r} may be {quoted(c.name for c in found)}: write more of its name", file=self.file)
        raise LogError(f"has no column {name!r}; there are {quoted(self.names)}", file=self.file)


def _told_apart(channels: tuple[Channel, ...]) -> tuple[Channel, ...]:
    """Return the channels with equal names numbered, ``x #1``, ``x #2``."""
    count = Counter(channel.name for channel in channels)
    if all(n == 1 for n in count.values()):
        return channels
    seen: Counter[str] = Counter()
    found = []
    for channel in channels:
        seen[channel.name] += 1
        found.append(replace(channel, name=f"{channel.name} #{seen[channel.name]}") if count[channel.name] > 1 else channel)
    return tuple(found)


def quoted(names: Iterable[str], most: int = 30) -> str:
    """Return names in quotes for a message, at most so many."""
    listed = [repr(name) for name in names]
    more = f" and {len(listed) - most} more" if len(listed) > most else ""
    return ", ".join(listed[:most]) + more
