"""Options of the command line that describe a log, and opening the log."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from contourlab.app.shared_options import LogColumns
from contourlab.errors import LogError, ParameterError, UnitError
from contourlab.logs import Column, Columns, Log, parse_columns, read_columns, read_record, result_of
from contourlab.logs.mapping import once
from contourlab.logs.record import Record
from contourlab.units import to_si

if TYPE_CHECKING:
    from contourlab.geometry import Path as Contour

PROGRAMS = (".ngc", ".nc", ".gcode", ".gc", ".tap", ".cnc", ".mpf", ".txt")
"""File extensions of part programs; a reference with one of them is a program, not a list of columns."""


@dataclass(frozen=True)
class LogChoice:
    """A log and how to read it.

    Attributes
    ----------
    columns : sequence of str
        As ``position.x=NAME [mm]``.
    mapping : str or Path, optional
        A TOML file of columns.
    period : str, optional
        As ``"1 ms"``.
    axes : sequence of str
        Axes of the contour; by default all.
    """

    file: str | Path
    columns: Sequence[str] = ()
    mapping: str | Path | None = None
    format: str | None = None
    period: str | None = None
    axes: Sequence[str] = ()

    @classmethod
    def of(cls, file: str | Path, options: LogColumns) -> LogChoice:
        """Return a log, to be read as the options say."""
        return cls(file, options.column, options.columns, options.format, options.period, getattr(options, "axes", ()))

    @property
    def files(self) -> tuple[str | Path, ...]:
        """The files to read."""
        return (self.file,) if self.mapping is None else (self.file, self.mapping)


def open_log(choice: LogChoice, more: Sequence[Column] = (), guess: Callable[[Record], Iterable[Column]] = lambda record: ()) -> Log:
    """Read a log. Columns and period of the command line override those of the mapping file.

    Parameters
    ----------
    more : sequence of Column
        Further columns.
    guess : callable, optional
        Returns columns of the record for signals that nothing else names.

    Raises
    ------
    LogError, ParameterError
        See `contourlab.logs.load_log`.
    """
    mapping = read_columns(choice.mapping) if choice.mapping is not None else Columns()
    typed = once((*parse_columns(choice.columns), *more), "--column and --reference")
    overridden = {(column.signal, column.axis) for column in typed}
    columns = (*typed, *(c for c in mapping.columns if (c.signal, c.axis) not in overridden))
    period = mapping.period
    if choice.period is not None:
        period = positive("--period", choice.period, "s", 'a time with its unit, such as "1 ms"')
    record = read_record(choice.file, choice.format or mapping.format)
    named = {(column.signal, column.axis) for column in columns}
    columns += tuple(column for column in guess(record) if (column.signal, column.axis) not in named)
    return result_of(record, Columns(columns, period))


def distinct_names(files: Sequence[str | Path]) -> list[str]:
    """Return the names of files, with as many folders as needed to make them distinct.

    >>> distinct_names(["x/slow.csv", "y/slow.csv", "y/fast.csv"])
    ['x/slow.csv', 'y/slow.csv', 'fast.csv']
    """
    paths = [Path(file).parts for file in files]

    def name(path: tuple[str, ...]) -> str:
        others = [other for other in paths if other != path]
        length = next((n for n in range(1, len(path)) if all(other[-n:] != path[-n:] for other in others)), len(path))
        return Path(*path[-length:]).as_posix()

    return [name(path) for path in paths]


def positive(option: str, text: str, unit: str, wanted: str) -> float:
    """Read the value of an option, > 0, in SI.

    Parameters
    ----------
    unit : str
        SI unit of the expected dimension.
    wanted : str
        Expected form, for the message.

    Raises
    ------
    ParameterError
        If the text is not such a quantity, or not positive.
    """
    try:
        value = to_si(text, unit)
    except UnitError as error:
        raise ParameterError(option, repr(text), wanted) from error
    if not value > 0.0:
        raise ParameterError(option, text, "> 0")
    return value


def is_program(reference: str) -> bool:
    """Return whether a reference is a part program, not a list of columns."""
    path = Path(reference)
    return path.suffix.lower() in PROGRAMS or path.is_file()


def reference_columns(reference: str, choice: LogChoice) -> tuple[Column, ...]:
    """Return the columns of the reference from names separated by commas, in the order of the axes."""
    names = [name.strip() for name in reference.split(",")]
    positions = [column.axis for column in parse_columns(choice.columns) if column.signal == "position"]
    axes = list(choice.axes) or positions or list("xyz"[: len(names)])
    if len(names) != len(axes):
        raise LogError(f"{len(names)} columns for the axes {', '.join(axes)}: give one for each axis", file="--reference")
    return parse_columns([f"reference.{axis}={name}" for axis, name in zip(axes, names, strict=True)], "--reference")


def program_path(program: str, axes: Sequence[str]) -> Contour:
    """Return the path of a part program in the coordinates of the log's axes."""
    from contourlab.feed import route_from_program
    from contourlab.program import Reading, read_program
    from contourlab.scenario.values import DEFAULT_CORNER_TOLERANCE

    read = read_program(Path(program), reading=Reading(require_end=False))
    return route_from_program(read, tuple(axes), default_tolerance=DEFAULT_CORNER_TOLERANCE).path
