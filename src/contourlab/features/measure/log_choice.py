"""Opening a log as the options of the command line say."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from contourlab.app.command_line import chosen_options
from contourlab.app.shared_options import READING, LogColumns, LogWindow
from contourlab.errors import LogError
from contourlab.logs import Column, Columns, Log, Record, parse_columns, read_columns, read_record, result_of
from contourlab.logs.mapping import once
from contourlab.logs.window import Window, parse_window
from contourlab.result.stamp import tell

if TYPE_CHECKING:
    from contourlab.feed.route import Route
    from contourlab.loop import Machine
    from contourlab.program import Program, Reading

PROGRAMS = (".ngc", ".nc", ".gcode", ".gc", ".tap", ".cnc", ".mpf", ".txt")
"""File extensions of part programs; a reference with one of them is a program, not a list of columns."""


def content_of(file: str | Path | Log) -> bytes:
    """Return what is read: the bytes of a file, or the numbers of a log that is read already."""
    if isinstance(file, Log):
        return b"".join([*(channel.values.tobytes() for channel in file.record.channels), str(file.given.window or "").encode()])
    return Path(file).read_bytes()


def open_log(
    file: str | Path | Log,
    options: LogColumns,
    more: Sequence[Column] = (),
    guess: Callable[[Record], Iterable[Column]] = lambda record: (),
) -> Log:
    """Read a log as its options say. Those of the command line override those of the mapping file, or of a log that is read already.

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
    mapping = file.given if isinstance(file, Log) else Columns()
    if options.columns is not None:
        mapping = replace(read_columns(options.columns), unit=mapping.unit)
    typed = once((*parse_columns(options.column), *more), "--column and --reference")
    overridden = {(column.signal, column.axis) for column in typed}
    columns = (*typed, *(c for c in mapping.columns if (c.signal, c.axis) not in overridden))
    record = read_record(file, options.format or mapping.format)
    named = {(column.signal, column.axis) for column in columns}
    columns += tuple(column for column in guess(record) if (column.signal, column.axis) not in named)
    window = window_of(file, options)
    unit = options.unit or mapping.unit or _unit_of(getattr(options, "machine", None))
    return result_of(record, Columns(columns, options.si("period") or mapping.period, None, unit, window))


def _unit_of(machine: str | Path | Machine | None) -> str:
    """Return the unit of a control whose own file a machine is; empty without one."""
    from contourlab.scenario.load import machine_of, reading_on

    made = None if machine is None else machine_of(machine)
    return "" if made is None or made.control is None else reading_on(made, {}).unit


def read_again(words: Sequence[str]) -> list[str]:
    """Return the options of a command by which another one reads the same log: those that it has, and the unit of its machine."""
    kept, machine = chosen_options(words, *READING), chosen_options(words, "--machine")
    unit = _unit_of(machine[-1]) if machine and "--unit" not in kept else ""
    return [*kept, "--unit", unit] if unit else kept


def window_of(file: str | Path | Log, options: LogWindow) -> Window | None:
    """Return the part of a log that its options say, or else the part that a log was read with before."""
    if options.window:
        return parse_window(options.of_log(0, 1).window[0])
    return file.given.window if isinstance(file, Log) else None


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


def reference_columns(reference: str, columns: Sequence[str], axes: Sequence[str]) -> tuple[Column, ...]:
    """Return the columns of the reference from names separated by commas, in the order of the axes."""
    names = [name.strip() for name in reference.split(",")]
    positions = [column.axis for column in parse_columns(columns) if column.signal == "position"]
    axes = list(axes) or positions or list("xyz"[: len(names)])
    if len(names) != len(axes):
        raise LogError(f"{len(names)} columns for the axes {', '.join(axes)}: give one for each axis", file="--reference")
    return parse_columns([f"reference.{axis}={name}" for axis, name in zip(axes, names, strict=True)], "--reference")


def program_of(file: str | Path, axes: Sequence[str], reading: Reading | None = None) -> tuple[Program, Route]:
    """Return a part program and its route in the coordinates of the log's axes."""
    from contourlab.program import Reading, read_program
    from contourlab.scenario.values import program_route

    program = tell(read_program(Path(file), reading=reading or Reading(require_end=False)))
    return program, program_route(program, tuple(axes))
