"""Read a part program line by line, from text, or from a file."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
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


def iter_moves(
    lines: Iterable[str], name: str | Path = "<text>", *, require_end: bool = True, reading: Reading | None = None
) -> Iterator[Move]:
    """Read a part program line by line; keep only the lines that a loop or call may return to.

    Parameters
    ----------
    lines : iterable of str
        With or without line breaks, for example an open text file.
    name : str or Path
        Name of the program in error messages.
    require_end : bool
        See `Reading`; all its other fields have their defaults.
    reading : Reading, optional
        All choices; replaces `require_end`.

    Yields
    ------
    Move
        In the order of execution, without moves of zero length.

    Raises
    ------
    ProgramError
        With file, line and column, when the faulty line is reached; at the end if there is no motion at all.

    Notes
    -----
    The language is RS274/NGC as LinuxCNC 2.9 reads it. The program starts at machine zero (0, 0, 0) in G17, G21, G54, G90, G91.1, G94 and
    G99, with no motion and no feedrate, all offsets zero. Positions are those of the axes: work coordinate systems (G10 L2, L20, G54 to
    G59.3 with rotation, G92, G52) and tool offsets (G43, G43.1, G43.2) are applied. Supported besides: G0 to G3 with I, J, K or R and P
    turns, G4, G5, G5.1, G5.2 with G5.3, G7, G8, G17 to G19, G20, G21, G28, G30, G40, G53, G61, G61.1, G64 with P and Q, G73, G74, G80 to
    G89, G90 to G91.1, G93 to G95, G97 to G99, polar coordinates, parameters, expressions, O-words, M98 and M99. S, T, M0, M1, M3 to M9,
    M19, M48 to M53, M60 to M65, M67 and M68 are kept as events. Everything else is refused.

    Stricter than LinuxCNC: a spline begun with G5.2 must be closed, G4 shares its P with no other code, a cycle needs its words again after
    a change of units, and numbers too large for any machine are refused. More tolerant: lines may be longer than 255 characters.

    References
    ----------
    T. R. Kramer, F. M. Proctor, E. Messina, *The NIST RS274/NGC Interpreter, Version 3*, NISTIR 6556, 2000.

    >>> [move.end for move in iter_moves(["G0 X10", "Y20", "M2"])]
    [(0.01, 0.0, 0.0), (0.01, 0.02, 0.0)]
    """
    reader = Reader(lines, name, reading or Reading(require_end=require_end))
    for move in reader.moves():
        reader.state.events.clear()  # unused here, and a program may have one on every line
        yield move


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
