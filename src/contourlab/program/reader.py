"""Part programs from files and text, read line by line: framing, line numbers, dialects, and the end of a program."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Literal, TextIO, TypeAlias, get_args

from contourlab.errors import ParameterError, ProgramEndError, ProgramError, check_known, refuse
from contourlab.file_kinds import mistaken
from contourlab.program.block import Block, Parameters, read_block, without_blanks
from contourlab.program.dialects import DIALECTS, LINUXCNC
from contourlab.program.flow import LONGEST_LINE, Tape, Walker
from contourlab.program.interpreter import execute
from contourlab.program.moves import Dwell, Move, Notice, Point, Program
from contourlab.program.own_rules import CHECKS, PREPARE
from contourlab.program.state import (
    ORIGIN,
    ModalState,
    Tools,
    metres,
    own_names,
    read_parameters,
    read_tools,
    store_origin,
    store_shift,
    unreadable,
)
from contourlab.program.vocabulary import G_GROUPS, M_GROUPS, SYSTEMS, BlockError
from contourlab.units import setting

Dialect: TypeAlias = Literal["linuxcnc", "grbl", "grblhal", "fanuc", "mach3"]
MOST_NOTICES = 1000
MOST_PROBLEMS = 100
"""Most faults collected."""
MOST_SHOWN = 200
"""Most characters of a program's own message to show."""
_PROGRAM_ENDS = (2, 30)
_RETURN = 99

NO_END = "the program has no end"
"""Begin of the notice or error of a program without M2, M30 or %."""


@dataclass(frozen=True, kw_only=True)
class Reading:
    """How to read a program.

    Parameters
    ----------
    dialect : {"linuxcnc", "grbl", "grblhal", "fanuc", "mach3"}
        Control for which the program is written; see `contourlab.program.dialects`. With ``"grbl"`` and ``"grblhal"`` a program needs no
        end, the first motion is G0 by default, comments need no end, and lines for the controller itself ($...) are skipped; each of
        these gives a `Notice`.
    require_end : bool
        Whether a program must end with M2, M30 or M99, or be enclosed in two lines of ``%``, as in LinuxCNC. Otherwise the end of the text
        ends the program.
    block_delete : bool
        Whether to skip lines that begin with /; LinuxCNC skips them only if the operator's switch is on.
    tools : str, Path, or None
        LinuxCNC tool table, for G43. Without it all tools have length 0.
    parameters : str, Path, or None
        LinuxCNC parameter file, with the work offsets. Without it all are zero.
    unit : {"mm", "inch"}
        Machine unit: of tool table, parameter file and a program that sets none.
    zero : str
        Zero of the program in machine coordinates, such as ``"100, 100, -20"`` in the machine unit: the origin of every coordinate system.
    start : str
        Position of the axes in machine coordinates at the begin, in the same form; machine zero if empty.
    startup : str
        Blocks that the control executes before the program, one a line.
    startup_place : str
        Where the control's file has it, such as ``router.ini:22``: it is then read in LinuxCNC's dialect.
    remapped : tuple of str
        Codes that the control's file gives another meaning, each with its place, such as ``"M6 router.ini:31"``. The procedure is not
        run: a code that LinuxCNC has without it keeps its own meaning, and a notice says so; any other is refused.
    folder : Path or None
        Folder of subprogram files; by default that of the program.
    subprograms : tuple of str
        Folders of subprogram files that are searched before `folder`.
    most_moves : int, > 0
        Most lines that loops and subprograms execute, plus moves of cycles: a few lines can make any number. A line counts once more for
        each 32 characters. Plain lines are not limited.

    Raises
    ------
    ParameterError
        If the dialect is unknown, `most_moves` is not positive, or `zero` or `start` is no point.
    """

    dialect: Dialect = "linuxcnc"
    require_end: bool = True
    block_delete: bool = False
    tools: str | Path | None = field(default=None, metadata=setting())
    parameters: str | Path | None = field(default=None, metadata=setting())
    unit: Literal["mm", "inch"] = "mm"
    zero: str = field(default="", metadata=setting())
    start: str = field(default="", metadata=setting())
    startup: str = field(default="", metadata=setting(maximum=260))
    startup_place: str = field(default="", metadata=setting())
    remapped: tuple[str, ...] = field(default=(), metadata=setting())
    folder: Path | None = None
    subprograms: tuple[str, ...] = field(default=(), metadata=setting())
    most_moves: int = field(default=500_000, metadata=setting(minimum=1))

    def __post_init__(self) -> None:
        check_known("dialect", self.dialect, get_args(Dialect))
        refuse(self.most_moves < 1, ParameterError, "most_moves", self.most_moves, "1 or more")
        for name in ("zero", "start"):
            self.point(name)

    def point(self, name: str) -> Point:
        """Return `zero` or `start` [m]; the origin without one.

        Raises
        ------
        ParameterError
            If it is no point.
        """
        text = getattr(self, name)
        try:
            x, y, z = (metres(float(word), self.unit == "mm") for word in (text or "0,0,0").split(","))
        except ValueError:
            x = y = z = math.nan
        if not all(map(math.isfinite, (x, y, z))):
            raise ParameterError(name, repr(text), f'three numbers, x, y and z, in {self.unit}, such as "100, 100, -20"')
        return x, y, z


class Reader:
    """Read a part program line by line; keep only the lines that a loop or call may return to.

    Parameters
    ----------
    lines : iterable of str
        With or without line breaks, for example an open text file.
    name : str or Path
        Name of the program in error messages.
    still : bool
        Whether to yield moves of zero length and dwells of 0 s, too.
    problems : list of ProgramError, optional
        Collects up to `MOST_PROBLEMS` faults; faulty lines are skipped. Without it the first fault is raised.

    Attributes
    ----------
    state : ModalState
        The state after the last block whose moves were yielded.
    notices : list of Notice
    walker : Walker
        Follows loops and subprograms.
    on_block : callable or None
        Called with each line that is executed and its block, before its moves.

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
    """

    def __init__(
        self,
        lines: Iterable[str],
        name: str | Path = "<text>",
        reading: Reading | None = None,
        *,
        still: bool = False,
        problems: list[ProgramError] | None = None,
    ) -> None:
        self.name, self.reading, self.problems = name, reading or Reading(), problems
        self.notices: list[Notice] = []
        self._known: set[str] = set()
        is_mm, tools, dialect = self.reading.unit == "mm", self.reading.tools, self.reading.dialect
        rules, self._prepare, self._check = DIALECTS[dialect], PREPARE.get(dialect), CHECKS.get(dialect)
        self.state = ModalState(tools=Tools() if tools is None else read_tools(tools, is_mm), still=still, millimetres=is_mm, rules=rules)
        self.state.back_to_clearance = not rules.own_cycles
        self.parameters = Parameters(self.state.shown_position)
        self.state.parameters = self.parameters
        if self.reading.parameters is not None:
            read_parameters(self.reading.parameters, self.parameters, is_mm)
        if self.reading.zero:
            store_shift(self.parameters, ORIGIN, applied=False)
            for system in range(1, len(SYSTEMS) + 1):
                store_origin(self.parameters, system, self.reading.point("zero"), 0.0)
        if self.reading.parameters is not None or self.reading.zero or self.reading.start:
            self.state.take_offsets(self.reading.point("start"))
        self._lines, self._n_read = iter(lines), 0
        self.walker = Walker(Tape(self._framed(), str(name)), self.parameters, self._subprogram, self.reading.most_moves)
        self.walker.keywords = rules.o_words
        self.parameters.own = own_names(self.state, lambda: self.walker.place[1])
        self.on_block: Callable[[str, Block], None] | None = None
        self._open = self._closed = self._ended = False

    def moves(self) -> Iterator[Move]:
        """Yield the moves in the order of execution.

        Raises
        ------
        ProgramError
            With file, line and column, when the faulty line is reached; at the end if there is no motion, or no end.
        """
        walker, state, moved = self.walker, self.state, False
        self._start_up()
        lines = walker.lines()
        while True:
            try:
                line = next(lines, None)
                if line is None or (self._closed and line.strip() == "%"):
                    break
                block = self._block(line)
                if self.on_block is not None and block is not None:
                    self.on_block(line, block)
                made = execute(block, state, walker.main_line) if block else []
                if len(made) > 1:
                    walker.spend(len(made) - 1)
            except BlockError as fault:
                self._take(fault)
                lines = walker.lines()
                continue
            for move in made:
                moved = moved or not isinstance(move, Dwell)
                yield move
            if block and ("stop" in block.codes or "call" in block.codes):
                try:
                    if self._leaves(block):
                        break
                except BlockError as fault:
                    self._take(fault)
            del self.notices[MOST_NOTICES:]
        self._check_end(moved)

    def _start_up(self) -> None:
        """Execute the blocks that the control executes before each program."""
        place, own = self.reading.startup_place or self.name, (self.state.rules, self._prepare, self._check)
        if self.reading.startup_place:  # of a LinuxCNC, whatever dialect follows
            self.state.rules, self._prepare, self._check = LINUXCNC, None, None
        for line in self.reading.startup.splitlines():
            try:
                block = self._block(line)
                moves = execute(block, self.state, 0) if block else []
            except BlockError as fault:
                raise fault.raised(f"{fault.message}, in the start-up code {line!r}", file=place) from None
            refuse(moves, ProgramError, f"CL846 the start-up code {line!r} moves axes: leave out its moves", file=place)
        self.state.rules, self._prepare, self._check = own

    def _take(self, fault: BlockError) -> None:
        """Store a fault if faults are collected and reading can continue; raise it otherwise."""
        file, number = self.walker.place
        error = fault.raised(fault.message, file=file, line=max(number, 1), column=fault.column)
        # A fault without a column concerns a whole loop or file: reading cannot continue.
        if self.problems is None or not fault.column or len(self.problems) >= MOST_PROBLEMS:
            raise error from None
        # A loop repeats its fault in every pass.
        if str(error) not in self._known:
            self._known.add(str(error))
            self.problems.append(error)

    def count_lines(self) -> int:
        """Return the number of lines of the program; reads those after its end."""
        self._n_read += sum(1 for _ in self._lines)
        return self._n_read

    def _framed(self) -> Iterator[str]:
        """Yield the lines without their breaks, up to and with the % that closes the program."""
        started = False
        for raw in self._lines:
            self._n_read += 1
            line = raw.rstrip("\r\n")
            mark = "%" in line and line.strip() == "%"
            self._closed = mark and self._open
            self._open = self._open or (mark and not started)
            started = started or bool(line.strip())
            yield line
            if self._closed:
                return

    def _block(self, line: str) -> Block | None:
        """Return the block of a line; None if there is nothing to execute."""
        if "/" in line and line.lstrip().startswith("/"):
            if self.reading.block_delete:
                return None
            line = line.replace("/", " ", 1)
        if "%" in line and line.strip() == "%":
            if self._open:
                return None
            if not self.reading.require_end:
                fault = "% closes the program, but the first line has no % to open it: ignored"
                self.notices.append(Notice(fault, self.walker.place[1], line.index("%") + 1))
                return None
        if self._prepare is not None:
            line = self._prepare(line, self.walker.place[1], self.notices, self.state)
        elif "(" in line and (abort := _ABORT.search(line)) and ";" not in line[: abort.start()]:
            raise BlockError(f"CL846 the program stops itself here, with (abort,...):{abort[1][:MOST_SHOWN]}", abort.start() + 1)
        if self.reading.remapped:
            self._check_remapped(line)
        block = read_block(line, self.parameters, self.state.rules)
        if self._check is not None:
            self._check(block, self.state)
        return block

    def _check_remapped(self, line: str) -> None:
        """Note the codes of a line to which the control's file gives another meaning; refuse those that have no other."""
        places = dict(entry.partition(" ")[::2] for entry in self.reading.remapped)
        text, columns = without_blanks(line)
        for code in _CODE.finditer(text):
            letter, number = code[1].upper(), float(code[2] or math.nan)
            name = letter if letter in places else f"{letter}{number:g}"
            words = f"{name} is remapped by {places.get(name)}; that procedure is not run"
            if name not in places or words in self._known:
                continue
            if not (round(10.0 * number) in G_GROUPS if letter == "G" else letter != "M" or number in M_GROUPS):
                raise BlockError(f"CL808 {words}: write the moves that it makes", columns[code.start()])
            self._known.add(words)
            self.notices.append(Notice(words, self.walker.place[1], columns[code.start()]))

    def _leaves(self, block: Block) -> bool:
        """Follow M98 and M99; return whether the program ends with this block."""
        if "call" in block.codes:
            self._call(block)
            return False
        code = block.codes["stop"].number
        if code == _RETURN:
            self._ended = not self.walker.back()
        self._ended = self._ended or code in _PROGRAM_ENDS
        return self._ended

    def _call(self, block: Block) -> None:
        """Execute M98: P is the number of the subprogram, L the number of repeats."""
        column = block.codes["call"].column
        label, repeats = (block.words[x].whole(0, 10**9, f"{x} of M98") if x in block.words else None for x in "PL")
        if label is not None and label > 9999 and self.state.rules.own_cycles and repeats is None:
            repeats, label = divmod(label, 10_000)  # P00031234 runs O1234 three times
        if label is None:
            raise BlockError("CL813 M98 has no P: write the number of the subprogram", column)
        self.walker.enter(str(label), None, column, 1 if repeats is None else repeats)

    def _subprogram(self, label: str) -> Tape | None:
        """Return the lines of a subprogram file."""
        if self.reading.folder is None or not re.fullmatch(r"[a-z0-9_.-]+", label):
            return None
        folders = [*map(Path, self.reading.subprograms), self.reading.folder]
        files = (folder / f"{label}.ngc" for folder in folders)
        file = next((file for file in files if file.is_file()), None)
        return None if file is None else Tape(iter(split_lines(read_text(file))), str(file))

    def _check_end(self, moved: bool) -> None:
        if self.state.curve.points:
            cure = "write G5.3 after its last control point"
            raise ProgramError(f"CL826 the NURBS begun with G5.2 is not closed: {cure}", file=self.name, line=self.walker.place[1])
        if not moved and (self.state.still or self.problems is not None):
            self.notices.append(Notice("the program contains no motion", 1, 1))
        elif not moved:
            cure = "write at least one G0, G1, G2 or G3 that leads away from the start (X0 Y0 Z0)"
            raise ProgramError(f"CL848 the program contains no motion: {cure}", file=self.name)
        if self._ended or self._closed:
            return
        line = self.walker.place[1]
        if not (self.state.rules.needs_end and self.reading.require_end):
            self.notices.append(Notice(f"{NO_END} (M2 or M30): its last line ends it", max(line, 1), 1))
        else:
            cure = "add a line with % at the end" if self._open else "add M2 or M30 at the end"
            raise ProgramEndError(f"CL847 {NO_END}: {cure}", file=self.name, line=line)


_CODE = re.compile(r"(?<![a-z_])([gmtsf])([0-9]+\.?[0-9]*|(?=[#\[]))(?![^<]*>)")
"""A code, or a word T, S or F, outside of names in <>."""
_ABORT = re.compile(r"\([ \t]*abort,([^()]*)\)[^()]*$", re.IGNORECASE)
_LINE_BREAK = re.compile(r"\r\n|\n|\r")


def read_text(path: Path) -> str:
    """Return the text of a file, in UTF-8 or else in Latin-1; raise ProgramError if it cannot be read."""
    try:
        content = path.read_bytes()
    except (OSError, ValueError) as error:
        raise unreadable("part program", path, error) from error
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("latin-1")


def split_lines(text: str) -> list[str]:
    """Return the lines of a text, without their breaks."""
    # Not splitlines(): its other separators (form feed, U+2028 ...) would shift the line numbers of editors.
    lines = _LINE_BREAK.split(text)
    return lines[:-1] if lines and not lines[-1] else lines


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
    chosen = _beside(path, reading or Reading(require_end=require_end))
    return _program(read_text(path), path.name, str(file), chosen, problems)


def _beside(path: Path, reading: Reading) -> Reading:
    """Look for subprograms beside a file; refuse a file that is something else: a picture, a scenario, a log ..."""
    if words := mistaken(path, "a part program"):
        raise ProgramError(f"CL800 {words}", file=path)
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
    chosen = _beside(path, reading or Reading())
    try:
        if path.exists() and not path.is_file() and not path.is_dir():
            # A pipe can be read only once; other files are first read to the end to check whether they are UTF-8.
            yield Reader(split_lines(read_text(path)), str(file), chosen, still=still, problems=problems)
            return
        text = path.open(encoding="utf-8-sig" if _is_utf8(path) else "latin-1", newline=None)
    except (OSError, ValueError) as error:
        raise unreadable("part program", file, error) from error
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
    return Program(name, tuple(moves), lines, tuple(reader.state.events), tuple(reader.notices), tuple(reader.state.machine_points))
