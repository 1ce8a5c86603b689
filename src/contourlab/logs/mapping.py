"""Map columns to signals, as given or by unambiguous names."""

from __future__ import annotations

import itertools
import re
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from contourlab.errors import LogError, UnitError, refuse
from contourlab.file_kinds import mistaken
from contourlab.logs.reading import AXIS_LETTERS, Channel, Record, name_and_unit, readable
from contourlab.logs.window import Window
from contourlab.units import same_dimension, to_si

TIME, LINE = "time", "line"
LINES = ("line", "program-line", "program_line", "source_line", "motion.program-line", "motion-line", "block", "n")
"""Names of columns with the line of the part program, in lower case."""
SIGNALS = {
    "reference": "m",
    "position": "m",
    "motor_position": "m",
    "axis_position": "m",
    "tool_position": "m",
    "velocity": "m/s",
    "reference_velocity": "m/s",
    "command": "",
    "acceleration": "m/s^2",
    "current": "A",
    "force": "N",
    "torque": "N*m",
    "disturbance_estimate": "",
}
"""Signals and their units; empty for the unit of the column."""
USUAL = {"m": "mm", "m/s": "mm/s"}
"""Units that people write, for messages."""
_TARGET = re.compile(r"(?P<signal>[a-z_]+)(?:\.(?P<axis>\w+))?\Z")


@dataclass(frozen=True)
class Column:
    """The column of a signal.

    Attributes
    ----------
    signal : str
        One of `SIGNALS`, "time", or "line", the line of the part program.
    axis : str
        Empty for a signal of all axes.
    column : str
        Name of the column, or a unique part of it.
    unit : str
        Overrides the file's; empty for the file's own.
    factor : float
        Applied to the values; -1 reverses the direction.
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
    """The user's mapping of a log.

    Attributes
    ----------
    columns : tuple of Column
    period : float or None [s]
    format : str or None
    unit : str
        Unit of lengths in columns that have none; speeds have it per second.
    window : Window or None
        The part to read.
    """

    columns: tuple[Column, ...] = ()
    period: float | None = None
    format: str | None = None
    unit: str = ""
    window: Window | None = None


def parse_columns(texts: Iterable[str], where: str = "--column") -> tuple[Column, ...]:
    """Read columns of the command line: ``position.x=Encoder X [mm]``, with ``-`` before the name to reverse the direction.

    Raises
    ------
    LogError
        If a text has another form, or a signal is named twice.

    >>> parse_columns(["position.x = -enc_x [mm]"])
    (Column(signal='position', axis='x', column='enc_x', unit='mm', factor=-1.0),)
    """
    columns = []
    for text in texts:
        target, equals, column = (part.strip() for part in text.partition("="))
        refuse(not equals or not column, LogError, f"{text!r}: write for example position.x=NAME [mm]", file=where)
        name, unit = name_and_unit(column.removeprefix("-") if column.startswith("-") else column)
        columns.append(_column(target, name, unit, -1.0 if column.startswith("-") else 1.0, where))
    return once(columns, where)


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
        If a key is unknown or a value has the wrong type.
    """
    path = Path(file)
    if words := mistaken(path, "a file of columns"):
        raise LogError(words, file=path)
    try:
        with readable(path):
            content = tomllib.loads(path.read_text(encoding="utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise LogError(f"is not valid TOML: {error}", file=path) from error
    for key in content:
        refuse(key not in ("period", "format", "columns"), LogError, f"{key}: unknown key; use period, format or columns", file=path)
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
            raise LogError(f"columns.{target}.{key}: unknown key; use column, unit or factor", file=path)
    factor = value.get("factor", 1.0)
    if isinstance(factor, bool) or not isinstance(factor, int | float) or not abs(factor) > 0.0 or abs(factor) > 1e12:
        raise LogError(f"columns.{target}.factor = {factor!r}: must be a number other than 0, up to 1e12", file=path)
    return _column(target, value["column"], str(value.get("unit", "")), float(factor), path)


def _column(target: str, name: str, unit: str, factor: float, where: str | Path) -> Column:
    match = _TARGET.match(target)
    if match is None or match["signal"] not in (TIME, LINE, *SIGNALS):
        known = ", ".join((TIME, LINE, *SIGNALS))
        raise LogError(f"{target!r} is not a signal: write one of {known}, and its axis, such as position.x", file=where)
    signal, axis = match["signal"], match["axis"] or ""
    if (signal in (TIME, LINE)) != (not axis):
        cure = f"{signal} has no axis: write {signal}=NAME" if axis else f"write the axis, as in {signal}.x"
        raise LogError(f"{target!r}: {cure}", file=where)
    expected = "s" if signal == TIME else SIGNALS.get(signal, "")
    try:
        if unit and not same_dimension(unit, expected or unit):
            raise LogError(f"{target}: {unit} is not a unit of {signal}; write one such as {USUAL.get(expected, expected)}", file=where)
    except UnitError as error:
        raise LogError(f"{target}: {error}", file=where) from error
    return Column(signal, axis, name, unit, factor)


def once(columns: Sequence[Column], where: str | Path) -> tuple[Column, ...]:
    """Return the columns; refuse two for the same signal."""
    first: dict[tuple[str, str], Column] = {}
    for column in columns:
        before = first.setdefault((column.signal, column.axis), column)
        if before is not column:
            raise LogError(f"{column.target} is given twice, as {before.column!r} and as {column.column!r}: keep one", file=where)
    return tuple(columns)


def guessed(record: Record, unit: str = "") -> dict[tuple[str, str], list[str]]:
    """Return the candidate columns of each signal and axis, by name: time, reference, position, velocity.

    `meant` reads the name, or else the channel's path in the control. A column named ``position.x`` is that signal alone. Timestamps are
    the time if no other column is it. Several candidates are ambiguous. ``x [mm]`` is a position if no other column is that of x; with a
    `unit` of columns without one, ``x`` is, too.
    """
    candidates: dict[tuple[str, str], list[str]] = {}
    for channel in record.channels:
        target = _meaning(channel)
        if target is not None and not (target == (TIME, "") and channel.is_timestamp):
            candidates.setdefault(target, []).append(channel.name)
    bare: dict[tuple[str, str], list[str]] = {}
    for channel in record.channels:
        if (own := _own(channel)) is not None:
            candidates[own] = [channel.name]
        if channel.name.casefold() in _AXES and (channel.unit in _LENGTHS or (unit and not channel.unit)):
            bare.setdefault(("position", channel.name.casefold()), []).append(channel.name)
    candidates = bare | candidates
    dates = [channel for channel in record.channels if channel.is_timestamp]
    if (TIME, "") not in candidates and dates:
        dates = [channel for channel in dates if channel.fault is None] or dates
        dates = [channel for channel in dates if _meaning(channel) == (TIME, "")] or dates
        candidates[TIME, ""] = [channel.name for channel in dates]
    return candidates


def _own(channel: Channel) -> tuple[str, str] | None:
    """Return signal and axis of a column named like ``position.x``."""
    own = _TARGET.match(channel.name)
    return (own["signal"], own["axis"]) if own is not None and own["signal"] in SIGNALS and own["axis"] else None


def _meaning(channel: Channel) -> tuple[str, str] | None:
    return channel.meaning or _own(channel) or meant(channel.name) or meant(channel.symbol)


# --- meaning of a name -------------------------------------------------------------------------------------------------------------

_TIME = {"t", "time", "zeit", "timestamp", "seconds", "datetime"}
_VELOCITY = {"vel", "velo", "velocity", "speed", "geschwindigkeit"}
_PLACE = {"encoder", "position", "pos", "enc"}
_REFERENCE = {
    *("ref", "refcommand", "reference", "setpoint", "soll", "sollposition", "lagesollwert"),
    *("desired", "target", "cmd", "demand", "commanded", "nominal", "noml"),
}
_ASKED = {"set", "command", "des"}
"""Words that mean a reference beside a position or velocity; alone they may mean a force or a set of data."""
_SEEN = {"feedback", "fbk", "actual", "act", "actl", "ist", "istposition", "lageistwert", "measured"}
_MEASURED = _SEEN | {"fb"}  # a function block too: "MAIN.fbAxis1.NcToPlc.SetPos"
_PLAIN = {"axis", "axes", "joint", "channel", "ch", "signal", "value", "data", "raw", "machine", "the", "of"}
"""Words that do not change the meaning."""
_OF_MANY = {"motor", "servo", "drive", "main", "gvl", "nc", "to", "plc"}
"""Words of devices and modules with many signals: ``motor cmd`` may be a torque, ``MAIN.fbAxis1.Cmd`` anything."""
_LETTERS = frozenset(AXIS_LETTERS)
_AXES, _LENGTHS = ("x", "y", "z"), ("m", "mm", "um", "in", "inch")
_KNOWN = _VELOCITY | _PLACE | _REFERENCE | _ASKED | _MEASURED | _PLAIN | _OF_MANY | _LETTERS
_KNOWN_BEFORE = {"current": {"position", "pos"} | _VELOCITY, "feed": {"reference"}, "st": {"axis"}, "lr": {"act", "set"}}
"""Words known only before these: ``current`` may be that of a motor, ``feed act X`` is a speed."""
_SYMBOLS = frozenset("auv")
"""Axis letters that are also symbols of acceleration, voltage and velocity: ``a actual``, ``V (NOM RPM)``."""
_RUN_TOGETHER = re.compile(
    r"(act|set|cmd|ref|des)(pos|velo?)|(pos|velo?)(cmd|fbk?|act|set|ref|des|err|diff)|(data|axis|ref|pos|enc)([xyz])"
)
_BESIDE = re.compile(
    r"\A(?:logs?|out|output|record|run|scope)\.|\(64 bit\)|#\d+\Z"
    r"|(?:[\s_]+|\s*[(\[])(?:in[\s_]+)?(?:[mu]?m|\u00b5m|inch)(?:(?:/|[\s_]per[\s_]|[\s_])(?:s|sec|min))?[)\]]?\Z"
)
"""Parts of a name that are ignored: a structure, the size of a number, the number of a duplicate, a unit."""
_UNUSUAL = re.compile(r"\A\s*-|[^\w\s./:;,()\[\]-]")
"""A sign or an operator, as in a formula."""
_TWINCAT = re.compile(r"ToPlc\.|(Act|Set)(Pos|Velo)\b")
_END_OF_MOVE = re.compile(r"ToPlc\.TargetPos\b")


def meant(name: str) -> tuple[str, str] | None:
    """Return signal and axis of an unambiguous name, else None; the time has the axis "".

    Knows the words of LinuxCNC, TwinCAT (``Axes.Axis 1.ToPlc.ActPos``, ``SetVelo``), Heidenhain (``Noml. pos``), Aerotech (``PosCmd (X)``)
    and common names. Numbers are joints from 0, or TwinCAT axes from 1. An unknown word makes a name ambiguous, because it may change
    the meaning.

    >>> meant("Encoder Feedback X"), meant("joint.0.motor-pos-cmd"), meant("SetPos Y"), meant("Zeit")
    (('position', 'x'), ('reference', 'x'), ('reference', 'y'), ('time', ''))
    >>> meant("Position Error X"), meant("a actual"), meant("x")
    (None, None, None)
    """
    if len(words := _words(name)) == 1 and words[0] in _TIME:
        return TIME, ""
    bare = _BESIDE.sub(" ", name)
    words = _words(bare)
    if _UNUSUAL.search(bare) or _END_OF_MOVE.search(name) or not _are_known(words):
        return None
    axis, signal = _axis(name, words), _signal(set(words))
    if axis is None or signal is None:
        return None
    return None if axis in _SYMBOLS and not set(words) & (_PLACE | _VELOCITY) else (signal, axis)


def _words(name: str) -> list[str]:
    """Return the words of a name in lower case; ``actpos`` is two."""
    words = [word.casefold() for word in re.findall(r"[^\W\d_]+|\d+", re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name))]
    matches = [(word, _RUN_TOGETHER.fullmatch(word)) for word in words]
    return [part for word, match in matches for part in (filter(None, match.groups()) if match else [word])]


def _are_known(words: list[str]) -> bool:
    """Tell whether all words are known; an unknown one may change the meaning, as in ``x position window``."""
    triples = zip(["", *words], words, [*words[1:], ""], strict=False)
    # X1 is axis X; X2 may be its second motor or encoder.
    return all(
        before in ("joint", "axis", "channel", "ch") or (word == "1" and before in _LETTERS)
        if word.isdigit()
        else word in _KNOWN or after in _KNOWN_BEFORE.get(word, ())
        for before, word, after in triples
    )


def _signal(words: set[str]) -> str | None:
    quantities = words & (_PLACE | _VELOCITY)
    if words & _OF_MANY and not quantities:
        return None
    is_asked = bool(words & _REFERENCE or (quantities and words & _ASKED))
    if is_asked and words & _SEEN:
        return None  # "REF ACTL" is the position from the reference mark
    if words & _VELOCITY:
        return "reference_velocity" if is_asked else "velocity"
    if is_asked:
        return "reference"
    return "position" if words & (_PLACE | _MEASURED) else None


def _axis(name: str, words: list[str]) -> str | None:
    """Return the axis, by letter or joint number; None for several axes or an array element."""
    first = 1 if _TWINCAT.search(name) else 0
    axes = {word for word in words if word in _LETTERS}
    for before, word in itertools.pairwise(words):
        if before in ("joint", "axis") and word.isdigit():
            # Array elements may count from 0 or from 1.
            if not first <= int(word) < first + len(AXIS_LETTERS) or f"[{word}]" in name:
                return None
            axes.add(AXIS_LETTERS[int(word) - first])
    return axes.pop() if len(axes) == 1 else None
