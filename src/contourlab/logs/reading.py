"""The content of a log, with limits on what it may cost, since a small file must not fill the memory; and reading its text and numbers."""

from __future__ import annotations

import codecs
import contextlib
import csv
import io
import itertools
import math
import os
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.errors import LogError, ParameterError, UnitError, refuse
from contourlab.file_kinds import mistaken
from contourlab.findings import Finding, finding
from contourlab.units import same_dimension

AXIS_LETTERS = "xyzabcuvw"
"""Axes in the order of their joints."""
SETTING = "CONTOURLAB_LOG_LIMIT"
"""Environment variable with a factor on all limits."""
COLUMNS = 10_000
LINE = 1_000_000
"""Characters of a line of text."""
TEXT = 500_000_000
"""Bytes of a text; reading takes five times as much memory."""
LONGEST, FASTEST = 10.0, 50.0
"""Travel [m] that hardly any feed axis reaches, and speed [m/s] that none does."""
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
    values : ndarray (n,) [`unit`]
        NaN for missing values.
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
    meaning : (str, str) or None
        Signal and axis, if the format states them.
    """

    name: str
    values: Array
    unit: str = ""
    time: Array | None = None
    is_timestamp: bool = False
    findings: tuple[Finding, ...] = ()
    fault: LogError | None = None
    symbol: str = ""
    meaning: tuple[str, str] | None = None


@dataclass(frozen=True, eq=False)
class Blocks:
    """The blocks of the part program that a control worked on during a log, each until the next begins.

    Attributes
    ----------
    time : ndarray (n,) [s]
        Where each begins; never decreases.
    line : ndarray (n,) of int
        Its line in its program; 0 for none.
    is_rapid : ndarray (n,) of bool, or None
        Whether it is a rapid move; None if the log does not say.
    program : tuple of str
        Its program; empty if the log does not say.
    """

    time: Array
    line: Index
    is_rapid: Flags | None = None
    program: tuple[str, ...] = ()

    def at(self, time: Array) -> Index:
        """Return the index of the block at some times (n_time,) [s]; -1 before the first."""
        return np.asarray(np.searchsorted(self.time, time, side="right") - 1)


@dataclass(frozen=True, eq=False)
class Record:
    """A log as read; it may stand wherever the name of a log does.

    Attributes
    ----------
    file : Path
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
    blocks : Blocks or None
        Of the part program, if the format has them.
    unit : str
        Unit of lengths that its control usually has, for a format that states none.

    Raises
    ------
    LogError
        If it holds no samples, too many columns, or none that can be read.
    """

    file: Path
    format: str
    channels: tuple[Channel, ...]
    period: float | None = None
    constants: Mapping[str, float] = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()
    attributes: Mapping[str, str | int | float] = field(default_factory=dict)
    blocks: Blocks | None = None
    unit: str = ""

    def __post_init__(self) -> None:
        check_limit(len(self.channels), COLUMNS, "columns", self.file)
        count = Counter(channel.name for channel in self.channels)
        place = {name: itertools.count(1) for name in count}
        numbered = (replace(c, name=f"{c.name} #{next(place[c.name])}") if count[c.name] > 1 else c for c in self.channels)
        object.__setattr__(self, "channels", tuple(numbered))
        refuse(not any(channel.values.size for channel in self.channels), LogError, "contains no samples", file=self.file)
        faults = [channel.fault for channel in self.channels]
        if faults[0] is not None and all(faults):
            raise faults[0]

    def __fspath__(self) -> str:
        return str(self.file)

    __str__ = __fspath__

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
        """Return channels by their names, as `channel` does.

        Raises
        ------
        LogError
            If one is missing, with all that are, or several match.
        """
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
    refuse(not 0.0 < value < math.inf, ParameterError, SETTING, repr(text), "a factor > 0, such as 4")
    return value


def check_limit(count: int, most: int, what: str, file: Path, line: int = 0) -> None:
    """Raise `LogError` if a log has more than `most` columns, characters or numbers, times the factor."""
    if count > most * factor():
        # Rounded up, so that the value in the message is enough.
        raise LogError(f"has {count} {what}, too many: set {SETTING}={math.ceil(count / most)} to read it", file=file, line=line)


def raised() -> str:
    """Return what to write if memory or time are not enough."""
    return f"if the file is sound, set {SETTING}={math.ceil(2.0 * factor())}"


# --- text and numbers; errors name the line ----------------------------------------------------------------------------------------

HEAD = 1 << 16
"""Bytes of a file that identify its format."""
UTF_16 = (b"\xff\xfe", b"\xfe\xff")
"""Byte order marks of UTF-16."""
CUT = finding("CL419")
"""Finding on an interrupted file."""
SHOWN = 40
"""Characters of a faulty cell that a message shows."""
_UNIT = re.compile(r"\s*(?P<name>.*?)\s*[\[(]\s*(?P<unit>[^\])]*?)\s*[\])]\s*\Z")
_NO_UNIT = re.compile(r".*,|\d+\s+[A-Za-z]|.*[A-Za-z]\s+\d+\Z|[XYZxyz]\Z")
"""Text in brackets that is not a unit: ``(64 bit)``, ``[u1, 1]``, ``PosFbk (X)``."""
_EMPTY = frozenset(("", "nan", "-nan", "na", "n/a", "null", "none", "#n/a", "-"))
_BITS = {"true": 1.0, "false": 0.0}


def head_of(file: Path) -> bytes:
    """Return the first bytes of a file, without a byte order mark; UTF-16 as UTF-8.

    Raises
    ------
    LogError
        If it cannot be read, is not a regular file, or is empty.
    """
    if words := mistaken(file, "a log", "a part program"):  # a head of columns may look like a program
        raise LogError(words, file=file)
    refuse(file.exists() and not file.is_file(), LogError, "is not a regular file: copy its content to one", file=file)
    with readable(file), file.open("rb") as stream:
        head = stream.read(HEAD)
    refuse(not head.strip(), LogError, "is empty", file=file)
    return head.decode("utf-16", errors="ignore").encode() if head[:2] in UTF_16 else head.removeprefix(codecs.BOM_UTF8)


@contextmanager
def readable(file: Path) -> Iterator[None]:
    """Raise `LogError` for a file that cannot be read."""
    try:
        yield
    except OSError as error:
        raise LogError(f"cannot be read: {error.strerror or error}", file=file) from error


def text_of(file: Path) -> str:
    """Return the text of a file: UTF-8, UTF-16 with a byte order mark, else Latin-1 as older controls write it.

    Raises
    ------
    LogError
        If it cannot be read, is not text, or is too long.
    """
    with readable(file):
        check_limit(file.stat().st_size, TEXT, "bytes", file)
        data = file.read_bytes()
    if data[:2] in UTF_16:
        return data.decode("utf-16", errors="replace")
    refuse(b"\0" in data[:HEAD], LogError, "is not text: name its format with --format", file=file)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("latin-1")


def lines_of(file: Path) -> tuple[list[tuple[int, str]], tuple[Finding, ...]]:
    """Return the numbered lines of a file without blank ones, and findings.

    A last line without a line break was cut short, and is left out.
    """
    text = text_of(file)
    lines = list(lines_in(text, file))
    return (lines, ()) if not lines or text.endswith(("\n", "\r")) else (lines[:-1], (CUT,))


REPEATED = "the header is repeated here: split the file, it contains two records"


def lines_in(text: str, file: Path) -> Iterator[tuple[int, str]]:
    """Yield the numbered lines of a text without blank ones.

    Raises
    ------
    LogError
        If a line is too long: its cells would fill the memory.
    """
    for i, line in enumerate(io.StringIO(text, newline=None), 1):
        if len(line) > LINE:
            check_limit(len(line.rstrip("\n")), LINE, "characters in a line", file, i)
        if line.strip():
            yield i, line.rstrip("\n")


def cells_of(line: str, mark: str) -> list[str]:
    """Split a line into cells without quotes."""
    if '"' not in line:
        return line.split(mark)
    try:
        return next(csv.reader([line], delimiter=mark))
    except csv.Error:  # an unclosed quote
        return line.split(mark)


def name_and_unit(text: str) -> tuple[str, str]:
    """Split ``"x [mm]"`` or ``"x (mm)"`` into name and unit; a name without one has the unit ``""``.

    >>> name_and_unit("Encoder X [mm]"), name_and_unit("Setpoint (64 bit)")
    (('Encoder X', 'mm'), ('Setpoint (64 bit)', ''))
    """
    match = _UNIT.match(text)
    return (match["name"], match["unit"]) if match and match["name"] and not _NO_UNIT.match(match["unit"]) else (text.strip(), "")


def is_unit(text: str) -> bool:
    """Tell whether a text is a known unit.

    >>> is_unit("mm/min"), is_unit("posn")
    (True, False)
    """
    try:
        return same_dimension(text, text)
    except UnitError:
        return False


def is_empty(cell: str) -> bool:
    """Tell whether a cell holds no value."""
    return _bare(cell) in _EMPTY


def _bare(cell: str) -> str:
    return cell.strip().strip('"').strip().casefold()


def number(text: str, comma: bool = False) -> float:
    """Return a number: 1 and 0 for true and false, NaN for no value; else raise ValueError."""
    cell = _bare(text)
    if cell in _EMPTY:
        return math.nan
    if cell in _BITS:
        return _BITS[cell]
    if "_" in cell or (comma and cell.rfind(".") > cell.rfind(",") >= 0):
        raise ValueError(f"{cell} is not a number, or has commas between thousands")
    return float(cell.replace(".", "").replace(",", ".") if comma and "," in cell else cell)


def columns_of(rows: Sequence[tuple[int, Sequence[str]]], width: int, file: Path) -> list[tuple[str, ...]]:
    """Return the columns of rows of cells; each row has its line number.

    Raises
    ------
    LogError
        If the number of cells is wrong.
    """
    for line, cells in rows:
        if len(cells) != width:
            raise LogError(f"has {len(cells)} columns, but {width} are expected", file=file, line=line)
    return list(zip(*(cells for _, cells in rows), strict=True)) if rows else [()] * width


def number_channel(name: str, cells: Sequence[str], lines: Sequence[int], file: Path, comma: bool = False, unit: str = "") -> Channel:
    """Return a column of numbers; a cell that is no number goes to `Channel.fault`, because the column may not be needed.

    Parameters
    ----------
    lines : sequence of int
        Line of each cell in the file.
    comma : bool
        Whether commas are decimal.
    """
    with contextlib.suppress(ValueError):  # fast path for plain numbers
        return Channel(name, np.array([float(cell.replace("_", "no digit")) for cell in cells]), unit)
    values = np.full(len(cells), np.nan)
    for k, (line, cell) in enumerate(zip(lines, cells, strict=True)):
        try:
            values[k] = cell_number(cell, name, file, line, comma)
        except LogError as fault:
            return Channel(name, np.full(len(cells), np.nan), unit, fault=fault)
    return Channel(name, values, unit)


def cell_number(cell: str, name: str, file: Path, line: int, comma: bool) -> float:
    """Return the number in a cell; raise LogError with column and line if it is not a number."""
    try:
        return number(cell, comma)
    except ValueError:
        raise LogError(f"{shown(cell)} in {called(name)} is not a number", file=file, line=line) from None


def called(name: str) -> str:
    """Name a column in a message, by name or else by number.

    >>> called("x pos"), called("2")
    ("column 'x pos'", 'column 2')
    """
    return f"column {name}" if name.isdigit() else f"column {name!r}"


def shown(cell: str) -> str:
    """Quote a cell in a message, shortened."""
    text = cell.strip()
    return repr(text if len(text) <= SHOWN else f"{text[:SHOWN]}...")
