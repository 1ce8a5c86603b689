"""Quadrature signals from a text file of numbers."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import LogError, UnitError
from contourlab.logs import Channel, Record, read_record
from contourlab.logs.reading import CUT, lines_in, text_of
from contourlab.units import to_si

PAIRS = (("u1", "u2"), ("cos", "sin"), ("a", "b"))
"""Names of signals that are found without an option, the cosine first."""
TIMES = ("t", "time")
REFERENCE = "reference"


@dataclass(frozen=True, eq=False)
class QuadratureRecord:
    """The signals of a file.

    Attributes
    ----------
    names : (str, str)
        Names of the signals, the cosine first.
    unit : str
        Unit of the signals, as in the file.
    u1, u2 : ndarray (n,)
        Signals in that unit.
    time : ndarray (n,) [s] or None
    reference : ndarray (n,) [m] or None
        True position.
    """

    source: Record
    names: tuple[str, str]
    unit: str
    u1: Array
    u2: Array
    time: Array | None
    reference: Array | None
    reference_name: str


def read_quadrature(file: str | Path, columns: str | None = None, reference: str | None = None) -> QuadratureRecord:
    """Read quadrature signals.

    Parameters
    ----------
    file : str or Path
        A table of numbers; see `contourlab.logs.delimited.read`.
    columns : str, optional
        Names or numbers of the signals, ``"u1,u2"``; by default u1 and u2, cos and sin, a and b, or the only two columns.
    reference : str, optional
        Column of the true position; by default "reference", if present.

    Raises
    ------
    LogError
        If a column is missing or cannot be read; with the line.
    """
    record = read_record(file, "csv")
    first, second = _signals(record, columns)
    if first is second:
        raise LogError(f"column {first.name} is given twice: an encoder has two signals", file=record.file)
    if first.unit != second.unit:
        units = f"{first.name} is in {first.unit or 'no unit'}, {second.name} in {second.unit or 'no unit'}"
        raise LogError(units, file=record.file)
    known = {channel.name.lower(): channel for channel in record.channels}
    true = _column(record, reference) if reference is not None else known.get(REFERENCE)
    clock = next((known[name] for name in TIMES if name in known), None)
    for channel in (first, second, clock, true):
        if channel is not None and channel.fault is not None:
            raise channel.fault
        if channel is not None and not np.isfinite(channel.values).all():
            sample = int(np.argmin(np.isfinite(channel.values)))
            raise LogError(f"column {channel.name} has no finite number here", file=record.file, line=line_of(record, sample))
    return QuadratureRecord(
        record,
        (first.name, second.name),
        first.unit,
        first.values,
        second.values,
        None if clock is None else clock.values * (_factor(record, clock, "s") if clock.unit else 1.0),
        None if true is None else true.values * _factor(record, true, "m"),
        "" if true is None else true.name,
    )


def line_of(record: Record, sample: int) -> int:
    """Return the line number (from 1) of a sample (from 0)."""
    lines = [i for i, line in lines_in(text_of(record.file), record.file) if line.strip()[0] not in "#%"]
    return lines[len(lines) - len(record.channels[0].values) - (CUT in record.findings) + sample]


def _signals(record: Record, columns: str | None) -> tuple[Channel, Channel]:
    if columns is not None:
        names = columns.split(",")
        if len(names) != 2:
            raise LogError(f"{columns}: two names separated by a comma, the cosine first, such as u1,u2", file="--columns")
        return _column(record, names[0]), _column(record, names[1])
    known = {channel.name.lower(): channel for channel in record.channels}
    for cosine, sine in PAIRS:
        if cosine in known and sine in known:
            return known[cosine], known[sine]
    if len(record.channels) == 2:
        return record.channels[0], record.channels[1]
    raise LogError(f"unknown signal columns: give --columns u1,u2; there are: {', '.join(record.names)}", file=record.file)


def _column(record: Record, name: str) -> Channel:
    """Return a column by its name (case is ignored) or its number (from 1)."""
    wanted = name.strip().lower()
    for channel in record.channels:
        if channel.name.lower() == wanted:
            return channel
    if wanted.isdecimal() and 1 <= int(wanted) <= len(record.channels):
        return record.channels[int(wanted) - 1]
    raise LogError(f"no column {name!r}; there are: {', '.join(record.names)}", file=record.file)


def _factor(record: Record, channel: Channel, unit: str) -> float:
    """Return the size of a column's unit in SI."""
    if not channel.unit:
        example = f"{channel.name} [{unit}]"
        raise LogError(f"column {channel.name} has no unit: write it in the header, such as {example}", file=record.file)
    try:
        return to_si(f"1 {channel.unit}", unit)
    except UnitError as error:
        raise LogError(f"column {channel.name}: {error}", file=record.file) from error
