"""Read a part program line by line, from text, or from a file."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TextIO

from contourlab.errors import ProgramError
from contourlab.file_kinds import mistaken
from contourlab.program.flow import LONGEST_LINE
from contourlab.program.moves import Move, Program
from contourlab.program.reader import Reader, Reading, read_text, split_lines, unreadable


def parse_program(text: str, name: str = "<text>", *, require_end: bool = True, reading: Reading | None = None) -> Program:
    """Read a part program from text.

    Parameters
    ----------
    text : str
    name : str
        Name of the program, also in error messages.
    require_end : bool
        Whether a program must have an end, as in LinuxCNC.
    reading : Reading, optional
        Everything about how to read; replaces `require_end`.

    Returns
    -------
    Program

    Raises
    ------
    ProgramError
        If a line cannot be read, or the program has no end or no motion; names line and column.

    >>> parse_program("G21 G1 X10 F600\\nM2").moves[0].feedrate
    0.01
    """
    return _program(text, name, name, reading or Reading(require_end=require_end))


def read_program(
    file: str | Path, *, require_end: bool = True, reading: Reading | None = None, problems: list[ProgramError] | None = None
) -> Program:
    """Read a part program from a file, in UTF-8 or else in Latin-1.

    Parameters
    ----------
    file : str or Path
    require_end : bool
        Whether a program must have an end, as in LinuxCNC.
    reading : Reading, optional
        Everything about how to read; replaces `require_end`. Subprogram files are searched for in the folder of the program.
    problems : list of ProgramError, optional
        Collects faults; faulty lines are skipped where possible. Without it the first fault is raised.

    Returns
    -------
    Program
        Its name is the file name without folders.

    Raises
    ------
    ProgramError
        If the file or a line cannot be read, or the program has no end or no motion; names line and column.
    """
    path = Path(file)
    _refuse_other(path)
    chosen = _beside(path, reading or Reading(require_end=require_end))
    return _program(read_text(path), path.name, str(file), chosen, problems)


def _refuse_other(path: Path) -> None:
    """Refuse a file that is something else: a picture, a scenario, a log ..."""
    if words := mistaken(path, "a part program"):
        raise ProgramError(words, file=path)


def _beside(path: Path, reading: Reading) -> Reading:
    return replace(reading, folder=path.parent) if reading.folder is None else reading


@contextmanager
def open_program(
    file: str | Path, reading: Reading | None = None, *, still: bool = False, problems: list[ProgramError] | None = None
) -> Iterator[Reader]:
    """Open a part program for reading line by line, in UTF-8 or else in Latin-1.

    Parameters
    ----------
    still, problems
        See `Reader`.

    Raises
    ------
    ProgramError
        If the file cannot be read.
    """
    path = Path(file)
    _refuse_other(path)
    chosen = _beside(path, reading or Reading())
    try:
        if path.exists() and not path.is_file() and not path.is_dir():
            # A pipe can be read only once; other files are first read to the end to check whether they are UTF-8.
            yield Reader(split_lines(read_text(path)), str(file), chosen, still=still, problems=problems)
            return
        text = path.open(encoding="utf-8-sig" if _is_utf8(path) else "latin-1", newline=None)
    except (OSError, ValueError) as error:
        raise unreadable(file, error) from error
    with text:
        yield Reader(_bounded(text), str(file), chosen, still=still, problems=problems)


def _bounded(text: TextIO) -> Iterator[str]:
    """Yield the lines of a file; of a line that is too long, only as much as the reader needs to refuse it."""
    most = LONGEST_LINE + 2
    while line := text.readline(most):
        yield line
        while len(line) == most and line[-1] != "\n":
            line = text.readline(most)


def _is_utf8(path: Path) -> bool:
    try:
        with path.open(encoding="utf-8") as text:
            return all(iter(partial(text.read, 1 << 20), ""))
    except UnicodeDecodeError:
        return False


def _program(text: str, name: str, place: str, reading: Reading, problems: list[ProgramError] | None = None) -> Program:
    lines = tuple(split_lines(text))
    reader = Reader(lines, place, reading, problems=problems)
    moves: list[Move] = []
    try:
        for move in reader.moves():
            moves.append(move)
    except ProgramError as error:
        if problems is None:
            raise
        problems.append(error)
    return Program(name, tuple(moves), lines, tuple(reader.state.events), tuple(reader.notices))
