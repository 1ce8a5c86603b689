"""Read tables of an accelerometer as Klipper writes them: time and acceleration in three directions, with the names behind #."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

from contourlab.logs import delimited
from contourlab.logs.reading import Record

UNITS = {"time": "s", "accel": "mm/s^2"}
"""Units of the firmware; the file states none."""
_HEAD = re.compile(rb'(?:\s*#[^\r\n]*[\r\n])*\s*#?\s*"?time"?\s*[,;\t]\s*"?accel_[xyz]\b')


def matches(file: Path, head: bytes) -> bool:
    """Tell whether the first line, or the last one behind #, names a time and accelerations."""
    return _HEAD.match(head) is not None


def read(file: Path) -> Record:
    """Read a table; its columns become the acceleration of an axis.

    Raises
    ------
    LogError
        See `contourlab.logs.delimited.read`.
    """
    record, channels = delimited.read(file), []
    for channel in record.channels:
        kind, _, axis = channel.name.partition("_")
        meaning = ("acceleration", axis) if kind == "accel" else None
        channels.append(replace(channel, unit=channel.unit or UNITS.get(kind, ""), meaning=meaning))
    return replace(record, format="accelerometer", channels=tuple(channels))
