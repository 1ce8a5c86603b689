"""Part programs from files and text: framing, line numbers, and the end of a program."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from pathlib import Path

from contourlab.errors import ProgramError
from contourlab.program.block import read_block
from contourlab.program.fault import BlockError
from contourlab.program.interpreter import execute
from contourlab.program.moves import Dwell, Event, Move, Program
from contourlab.program.parameters import Parameters
from contourlab.program.state import ModalState

__all__ = ["iter_moves", "parse_program", "read_program"]

PROGRAM_ENDS = (2, 30)
_LINE_BREAK = re.compile(r"\r\n|\n|\r")


def iter_moves(
    lines: Iterable[str], name: str | Path = "<text>", *, require_end: bool = True, events: list[Event] | None = None
) -> Iterator[Move]:
    """Read a part program line by line, holding no more than one line.

    Parameters
    ----------
    lines : iterable of str
        With or without line breaks, for example an open text file.
    name : str or Path
        What error messages call the program.
    require_end : bool
        Whether a program must say where it ends: by M2, by M30, or by standing between two lines of ``%``. LinuxCNC
        does; without it, the end of the text is the end of the program.
    events : list of Event, optional
        What is asked for besides motion is added to it as the lines are read.

    Yields
    ------
    Move
        In the order of execution; moves of no length are left out.

    Raises
    ------
    ProgramError
        With file, line and column, when the faulty line is reached; at the end if there is no motion at all.

    Notes
    -----
    The language is RS274/NGC as LinuxCNC 2.9 reads it. The program starts at machine zero (0, 0, 0) in G17, G21, G90,
    G91.1 and G94, with no motion and no feedrate. Supported: G0, G1, G2, G3 (I, J, K or R, and P turns), G4, G17, G18,
    G19, G20, G21, G90, G91, G90.1, G91.1, G94, F, M2, M30, N, ``%``, comments, parameters, expressions, functions, and polar
    coordinates (@ and ^). S,
    T, M0, M1, M3 to M9 and M48 to M53 are kept as events. G40, G49, G54 to G59.3 (no offset can be set), G61, G61.1 (every
    corner is met exactly), G80, G97, G98 and G99 change nothing here. Everything else is refused.

    Stricter than LinuxCNC: a feedrate must be given before G1, G2 or G3 with words, and numbers beyond any machine are
    refused. More tolerant: lines may be longer than 255 characters.

    References
    ----------
    T. R. Kramer, F. M. Proctor, E. Messina, *The NIST RS274/NGC Interpreter, Version 3*, NISTIR 6556, 2000.

    >>> [move.end for move in iter_moves(["G0 X10", "Y20", "M2"])]
    [(0.01, 0.0, 0.0), (0.01, 0.02, 0.0)]
    """
    state, frame, moved = ModalState(), _Frame(), False
    parameters = Parameters(state.shown_position)
    told: list[Event] = [] if events is None else events
    for number, line in frame.blocks(lines):
        try:
            block = read_block(line, parameters)
            moves = execute(block, state, number, told)
        except BlockError as fault:
            raise ProgramError(fault.message, file=name, line=number, column=fault.column) from None
        for move in moves:
            moved = moved or not isinstance(move, Dwell)
            yield move
        if "stop" in block.codes and block.codes["stop"].number in PROGRAM_ENDS:
            frame.ended = True
            break
    if not moved:
        raise ProgramError(
            "the program holds no motion: write at least one G0, G1, G2 or G3 move that ends elsewhere than it begins (X0 Y0 Z0 at first)",
            file=name,
        )
    if require_end and not frame.ended:
        cure = "add a line with % at the end" if frame.open else "add M2 or M30 at the end"
        raise ProgramError(f"the program has no end: {cure}", file=name, line=frame.number)


class _Frame:
    """The frame of a program: line numbers, and the lines of ``%`` around it, the first of which opens the text."""

    def __init__(self) -> None:
        self.number, self.open, self.ended = 0, False, False

    def blocks(self, lines: Iterable[str]) -> Iterator[tuple[int, str]]:
        """Yield the number (from 1) and text of each line up to the closing ``%``."""
        started = False
        for self.number, raw in enumerate(lines, start=1):
            line = raw.rstrip("\r\n")
            if "%" in line and line.strip() == "%" and (self.open or not started):
                if self.open:
                    self.ended = True
                    return
                self.open = started = True
                continue
            started = started or bool(line.strip())
            yield self.number, line


def parse_program(text: str, name: str = "<text>", *, require_end: bool = True) -> Program:
    """Read a part program from text.

    Parameters
    ----------
    text : str
    name : str
        The program's name, also in error messages.
    require_end : bool
        See `iter_moves`.

    Raises
    ------
    ProgramError
        As `iter_moves`.

    >>> parse_program("G21 G1 X10 F600\\nM2").moves[0].feedrate
    0.01
    """
    return _program(text, name, name, require_end)


def read_program(file: str | Path, *, require_end: bool = True) -> Program:
    """Read a part program from a file, in UTF-8 or else in Latin-1.

    Parameters
    ----------
    file : str or Path
    require_end : bool
        See `iter_moves`.

    Returns
    -------
    Program
        Its name is the file's, without folders.

    Raises
    ------
    ProgramError
        If the file cannot be read, and as `iter_moves`.
    """
    path = Path(file)
    try:
        content = path.read_bytes()
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise ProgramError(f"the part program cannot be read: {reason}", file=file) from error
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = content.decode("latin-1")
    return _program(text, path.name, str(file), require_end)


def _program(text: str, name: str, place: str, require_end: bool) -> Program:
    # Not splitlines(): its other separators (form feed, U+2028 ...) would shift the line numbers of editors.
    lines = tuple(_LINE_BREAK.split(text))
    if lines and not lines[-1]:
        lines = lines[:-1]
    events: list[Event] = []
    moves = tuple(iter_moves(lines, place, require_end=require_end, events=events))
    return Program(name, moves, lines, tuple(events))
