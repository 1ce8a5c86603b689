"""Options of the command line that describe a log, and opening the log."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, cast

from contourlab.app.shared_options import LogColumns
from contourlab.errors import LogError
from contourlab.logs import Column, Columns, Log, Record, parse_columns, read_columns, read_record, result_of
from contourlab.logs.mapping import once

if TYPE_CHECKING:
    from contourlab.geometry import Path as Contour

PROGRAMS = (".ngc", ".nc", ".gcode", ".gc", ".tap", ".cnc", ".mpf", ".txt")
"""File extensions of part programs; a reference with one of them is a program, not a list of columns."""


@dataclass(frozen=True)
class LogChoice:
    """A log and how to read it.

    Attributes
    ----------
    file : str or Path
        Or a `Log`, which stands for its name.
    columns : sequence of str
        As ``position.x=NAME [mm]``.
    mapping : str or Path, optional
        A TOML file of columns.
    period : float, optional [s]
    axes : sequence of str
        Axes of the contour; by default all.
    """

    file: str | Path
    columns: Sequence[str] = ()
    mapping: str | Path | None = None
    format: str | None = None
    period: float | None = None
    axes: Sequence[str] = ()

    @classmethod
    def of(cls, file: str | Path | Log, options: LogColumns) -> LogChoice:
        """Return a log, to be read as the options say."""
        return cls(cast("Path", file), options.column, options.columns, options.format, options.si("period"), getattr(options, "axes", ()))

    @property
    def files(self) -> tuple[str | Path, ...]:
        """The files to read."""
        return (self.file,) if self.mapping is None else (self.file, self.mapping)

    @property
    def content(self) -> bytes:
        """What is read: the bytes of the file, or the numbers of a log that is read already."""
        if isinstance(self.file, Log):
            return b"".join(channel.values.tobytes() for channel in self.file.record.channels)
        return Path(self.file).read_bytes()


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
    mapping = choice.file.given if isinstance(choice.file, Log) else Columns()
    if choice.mapping is not None:
        mapping = read_columns(choice.mapping)
    typed = once((*parse_columns(choice.columns), *more), "--column and --reference")
    overridden = {(column.signal, column.axis) for column in typed}
    columns = (*typed, *(c for c in mapping.columns if (c.signal, c.axis) not in overridden))
    record = read_record(choice.file, choice.format or mapping.format)
    named = {(column.signal, column.axis) for column in columns}
    columns += tuple(column for column in guess(record) if (column.signal, column.axis) not in named)
    return result_of(record, Columns(columns, choice.period or mapping.period))


def distinct_names(files: Sequence[str | os.PathLike[str]]) -> list[str]:
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
    from contourlab.program import Reading, read_program
    from contourlab.scenario.values import program_route

    return program_route(read_program(Path(program), reading=Reading(require_end=False)), tuple(axes)).path
