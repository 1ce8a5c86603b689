"""What a user says of a log on the command line, and the log that it opens."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from contourlab.errors import LogError, ParameterError, UnitError
from contourlab.logs import Column, Columns, Log, parse_columns, read_columns, read_record, result_of
from contourlab.logs.mapping import once
from contourlab.units import to_si

if TYPE_CHECKING:
    from contourlab.geometry import Path as Contour

PROGRAMS = (".ngc", ".nc", ".gcode", ".gc", ".tap", ".cnc", ".mpf", ".txt")
"""Endings of part programs, where a reference is one and no list of columns."""


@dataclass(frozen=True)
class LogChoice:
    """What a user says of a log.

    Attributes
    ----------
    file : str or Path
    columns : sequence of str
        As ``position.x=NAME [mm]``.
    mapping : str or Path, optional
        A TOML file of columns.
    format : str, optional
    period : str, optional
        As ``"1 ms"``.
    axes : sequence of str
        Those that make the contour; by default all.
    """

    file: str | Path
    columns: Sequence[str] = ()
    mapping: str | Path | None = None
    format: str | None = None
    period: str | None = None
    axes: Sequence[str] = ()

    @property
    def files(self) -> tuple[str | Path, ...]:
        """The files that are read."""
        return (self.file,) if self.mapping is None else (self.file, self.mapping)


def open_log(choice: LogChoice, more: Sequence[Column] = ()) -> Log:
    """Read a log as its user says.

    Parameters
    ----------
    choice : LogChoice
        What the command line says goes before what the file of columns does.
    more : sequence of Column
        Further columns.

    Raises
    ------
    LogError, ParameterError
        As of `contourlab.logs.load_log`.
    """
    said = parse_columns(choice.columns)
    written = read_columns(choice.mapping) if choice.mapping is not None else Columns()
    typed = once((*said, *more), "--column and --reference")
    first = {(column.signal, column.axis) for column in typed}
    columns = (*typed, *(c for c in written.columns if (c.signal, c.axis) not in first))
    period = written.period
    if choice.period is not None:
        period = positive("--period", choice.period, "s", 'a time with its unit, such as "1 ms"')
    record = read_record(choice.file, choice.format or written.format)
    return result_of(record, Columns(columns, period))


def told_apart(files: Sequence[str | Path]) -> list[str]:
    """Return what files are called: their names, with as much of the folders above as tells those of one name apart.

    >>> told_apart(["x/slow.csv", "y/slow.csv", "y/fast.csv"])
    ['x/slow.csv', 'y/slow.csv', 'fast.csv']
    """
    parts = [Path(file).parts for file in files]

    def called(mine: tuple[str, ...]) -> str:
        others = [one for one in parts if one != mine]
        length = next((n for n in range(1, len(mine)) if all(one[-n:] != mine[-n:] for one in others)), len(mine))
        return Path(*mine[-length:]).as_posix()

    return [called(mine) for mine in parts]


def positive(option: str, text: str, unit: str, wanted: str) -> float:
    """Return what an option gives, > 0, in SI.

    Parameters
    ----------
    option, text : str
    unit : str
        Of the dimension that is expected.
    wanted : str
        What would be right, in words.

    Raises
    ------
    ParameterError
        If it is no such quantity.
    """
    try:
        value = to_si(text, unit)
    except UnitError as error:
        raise ParameterError(option, repr(text), wanted) from error
    if not value > 0.0:
        raise ParameterError(option, text, "> 0")
    return value


def is_program(reference: str) -> bool:
    """Tell whether a reference is a part program rather than a list of columns."""
    path = Path(reference)
    return path.suffix.lower() in PROGRAMS or path.is_file()


def reference_columns(reference: str, choice: LogChoice) -> tuple[Column, ...]:
    """Return the columns of the reference out of their names with commas between, in the order of the axes."""
    names = [name.strip() for name in reference.split(",")]
    said = [column.axis for column in parse_columns(choice.columns) if column.signal == "position"]
    wanted = list(choice.axes) or said or list("xyz"[: len(names)])
    if len(names) != len(wanted):
        raise LogError(f"{len(names)} columns for the axes {', '.join(wanted)}: name one for each", file="--reference")
    return parse_columns([f"reference.{axis}={name}" for axis, name in zip(wanted, names, strict=True)], "--reference")


def program_path(program: str, axes: Sequence[str]) -> Contour:
    """Return the path of a part program, in the coordinates of the log's axes."""
    from contourlab.feed import route_from_program
    from contourlab.program import Reading, read_program
    from contourlab.scenario.values import DEFAULT_CORNER_TOLERANCE

    read = read_program(Path(program), reading=Reading(require_end=False))
    return route_from_program(read, tuple(axes), default_tolerance=DEFAULT_CORNER_TOLERANCE).path
