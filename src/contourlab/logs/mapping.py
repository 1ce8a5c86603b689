"""Map columns to signals: as the user says, or by name if it leaves no doubt."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from contourlab.errors import LogError, UnitError
from contourlab.logs.names import TIME, meant
from contourlab.logs.reading import name_and_unit
from contourlab.logs.record import Channel, Record, quoted
from contourlab.units import same_dimension, to_si

SIGNALS = {
    "reference": "m",
    "position": "m",
    "motor_position": "m",
    "axis_position": "m",
    "tool_position": "m",
    "velocity": "m/s",
    "reference_velocity": "m/s",
    "command": "",
    "current": "A",
    "force": "N",
    "torque": "N*m",
    "disturbance_estimate": "",
}
"""Signals that a column can be, with their unit; an empty one is what the column has."""
_TARGET = re.compile(r"(?P<signal>[a-z_]+)(?:\.(?P<axis>\w+))?\Z")


@dataclass(frozen=True)
class Column:
    """A column of a log that is a signal.

    Attributes
    ----------
    signal : str
        Of `SIGNALS`, or "time".
    axis : str
        Empty where the signal is one for all axes.
    column : str
        Name of the column, or a part of it that no other has.
    unit : str
        Overrides the file's; empty for the file's own.
    factor : float
        On the values: -1 where the file counts the other way.
    """

    signal: str
    axis: str
    column: str
    unit: str = ""
    factor: float = 1.0

    @property
    def target(self) -> str:
        """Signal and axis, as ``position.x``."""
        return f"{self.signal}.{self.axis}" if self.axis else self.signal


@dataclass(frozen=True)
class Columns:
    """The user's mapping of a log: columns, period and format."""

    columns: tuple[Column, ...] = ()
    period: float | None = None
    format: str | None = None


def parse_columns(texts: Iterable[str], where: str = "--column") -> tuple[Column, ...]:
    """Read columns as the command line has them: ``position.x=Encoder X [mm]``, with ``-`` before the name where it counts the other way.

    Raises
    ------
    LogError
        If one is no such text, or names a signal twice.

    >>> parse_columns(["position.x = -enc_x [mm]"])
    (Column(signal='position', axis='x', column='enc_x', unit='mm', factor=-1.0),)
    """
    found = []
    for text in texts:
        target, equals, column = (part.strip() for part in text.partition("="))
        if not equals or not column:
            raise LogError(f"{text!r}: write for example position.x=NAME [mm]", file=where)
        name, unit = name_and_unit(column.removeprefix("-") if column.startswith("-") else column)
        found.append(_column(target, name, unit, -1.0 if column.startswith("-") else 1.0, where))
    return once(found, where)


def read_columns(file: str | Path) -> Columns:
    """Read a mapping from a TOML file.

    ::

        period = "1 ms"
        format = "csv"
        [columns]
        time = "t [s]"
        "position.x" = "enc_x [mm]"
        "command.x" = {column = "torque", unit = "N*m", factor = -1.0}

    Raises
    ------
    LogError
        If a key is unknown or a value is not of its kind; says the key.
    """
    path = Path(file)
    try:
        content = tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise LogError(f"cannot be read: {error.strerror or error}", file=path) from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise LogError(f"is no TOML: {error}", file=path) from error
    for key in content:
        if key not in ("period", "format", "columns"):
            raise LogError(f"{key}: unknown key; there are period, format, columns", file=path)
    table = content.get("columns", {})
    if not isinstance(table, Mapping):
        raise LogError('columns: must be a table, such as [columns] with "position.x" = "enc_x [mm]"', file=path)
    columns = [_of_table(target, value, path) for target, value in table.items()]
    try:
        period = to_si(content["period"], "s") if "period" in content else None
    except (UnitError, TypeError, ValueError) as error:
        raise LogError(f"period: {error}", file=path) from error
    if period is not None and not period > 0.0:
        raise LogError(f"period = {content['period']}: must be > 0", file=path)
    return Columns(once(columns, path), period, content.get("format"))


def _of_table(target: str, value: Any, path: Path) -> Column:
    if isinstance(value, str):
        name, unit = name_and_unit(value)
        return _column(target, name, unit, 1.0, path)
    if not isinstance(value, Mapping) or not isinstance(value.get("column"), str):
        raise LogError(f'columns.{target}: write "NAME [unit]" or {{column = "NAME", unit = "mm", factor = -1.0}}', file=path)
    for key in value:
        if key not in ("column", "unit", "factor"):
            raise LogError(f"columns.{target}.{key}: unknown key; there are column, unit, factor", file=path)
    factor = value.get("factor", 1.0)
    if isinstance(factor, bool) or not isinstance(factor, int | float) or not abs(factor) > 0.0 or abs(factor) > 1e12:
        raise LogError(f"columns.{target}.factor = {factor!r}: must be a number other than 0", file=path)
    return _column(target, value["column"], str(value.get("unit", "")), float(factor), path)


def _column(target: str, name: str, unit: str, factor: float, where: str | Path) -> Column:
    found = _TARGET.match(target)
    if found is None or found["signal"] not in (TIME, *SIGNALS):
        raise LogError(f"{target!r} is no signal: write one of {TIME}, {', '.join(SIGNALS)}, and its axis, such as position.x", file=where)
    signal, axis = found["signal"], found["axis"] or ""
    if (signal == TIME) != (not axis):
        raise LogError(f"{target!r}: " + ("time has no axis" if axis else f"of which axis? Write {signal}.x"), file=where)
    expected = "s" if signal == TIME else SIGNALS[signal]
    try:
        if unit and not same_dimension(unit, expected or unit):
            raise LogError(f"{target}: {unit} is no unit of {signal}, such as {expected}", file=where)
    except UnitError as error:
        raise LogError(f"{target}: {error}", file=where) from error
    return Column(signal, axis, name, unit, factor)


def once(columns: Sequence[Column], where: str | Path) -> tuple[Column, ...]:
    """Return the columns; refuse two for the same signal.

    Raises
    ------
    LogError
        If two are; names both.
    """
    first: dict[tuple[str, str], Column] = {}
    for column in columns:
        before = first.setdefault((column.signal, column.axis), column)
        if before is not column:
            raise LogError(f"{column.target} is given twice, as {before.column!r} and as {column.column!r}: keep one", file=where)
    return tuple(columns)


def guessed(record: Record) -> dict[tuple[str, str], list[str]]:
    """Return which columns each signal and axis may be by their names: a time, and for each axis a reference, a position, a velocity.

    `contourlab.logs.names` reads the name, or else the channel's path in the control. A column named ``position.x`` is that signal,
    whatever else sounds alike. Timestamps are the time if no other column is named so. Several names for one signal leave a doubt.
    """
    found: dict[tuple[str, str], list[str]] = {}
    for channel in record.channels:
        target = _meaning(channel)
        if target is not None and not (target == (TIME, "") and channel.is_timestamp):
            found.setdefault(target, []).append(channel.name)
    for channel in record.channels:
        if (own := _own(channel)) is not None:
            found[own] = [channel.name]
    dates = [channel for channel in record.channels if channel.is_timestamp]
    if (TIME, "") not in found and dates:
        dates = [channel for channel in dates if channel.fault is None] or dates
        dates = [channel for channel in dates if _meaning(channel) == (TIME, "")] or dates
        found[TIME, ""] = [channel.name for channel in dates]
    return found


def _own(channel: Channel) -> tuple[str, str] | None:
    """Return the signal and axis whose name a column has."""
    own = _TARGET.match(channel.name)
    return (own["signal"], own["axis"]) if own is not None and own["signal"] in SIGNALS and own["axis"] else None


def _meaning(channel: Channel) -> tuple[str, str] | None:
    return _own(channel) or meant(channel.name) or meant(channel.symbol)


def unknown(record: Record) -> str:
    """Return the message that asks for columns."""
    cure = "say for example --column 'position.x=NAME [mm]', or name a file of columns with --columns"
    return f"which column is what? There are {quoted(record.names)}; {cure}"
