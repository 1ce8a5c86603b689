"""A program read with what it takes to write each move again, and its contour."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import astuple, dataclass, field, replace
from functools import cached_property
from pathlib import Path

import numpy as np

from contourlab import geometry
from contourlab.arrays import Array, Flags, Index
from contourlab.errors import ProgramError
from contourlab.feed import Route
from contourlab.program import Arc, Dwell, Feed, Move, Point, Program, Reader, Reading, Spline, Traverse
from contourlab.program.block import Block as Executed
from contourlab.program.block import Key
from contourlab.program.dialects import Rules
from contourlab.program.moves import PLANE_AXES
from contourlab.program.reader import read_text, split_lines
from contourlab.program.state import Frame
from contourlab.program.vocabulary import CYCLES, G_GROUPS
from contourlab.scenario.values import program_route

COMMENT = re.compile(r"\([^()]*\)|;.*")
_COMPUTED = re.compile(r"[#\[]|M\s*0*9[89](?!\d)", re.IGNORECASE)
_NUMBER = re.compile(r"^\s*N\s*[0-9.]+\s*", re.IGNORECASE)
_FIRST_OF_INTERPRETER = 5000
"""From here on, parameters hold what executed codes set: offsets, positions, tools."""


@dataclass(eq=False)
class Region:
    """An outermost loop or call, with what it executes.

    Attributes
    ----------
    first, last : int
        Its lines in the program, from 1.
    call : str
        The other words of its first line, such as M8 beside M98.
    text : list of str
        Executed lines, then the parameters that they changed.
    corrected : bool
        Whether a move inside could be corrected, if it stood in the program itself.
    """

    first: int
    last: int
    call: str = ""
    text: list[str] = field(default_factory=list)
    corrected: bool = False


class Regions:
    """The loops and calls of a program that is being read."""

    def __init__(self, reader: Reader) -> None:
        self.found: list[Region] = []
        self._reader, self._call, self._before = reader, "", dict[Key, float]()
        reader.on_block, reader.walker.on_region = self._read, self._turned

    def _read(self, line: str, block: Executed) -> None:
        text = executed(line, block)
        if not self._reader.walker.repeating:
            self._call = text if "call" in block.codes else ""
        elif text:
            self.found[-1].text.append(text)

    def _turned(self, begins: bool, line: int) -> None:
        values = self._reader.parameters.outermost()
        if begins:
            self.found.append(Region(line, line, self._call))
            self._before = values
        else:
            self.found[-1].last = line
            for key, value in values.items():
                if self._before.get(key) != value and (isinstance(key, str) or key < _FIRST_OF_INTERPRETER):
                    self.found[-1].text.append(f"#{f'<{key}>' if isinstance(key, str) else key} = {_number(value)}")
        self._call = ""


def executed(line: str, block: Executed) -> str:
    """Return a line as it was executed: without line number, call, return and assignments, with numbers for its expressions.

    >>> from contourlab.program.block import read_block
    >>> line = "N5 g1 X[1/4] #3=2 F200 (edge)"
    >>> executed(line, read_block(line))
    'G1 X0.25 F200 (edge)'
    """
    if not _COMPUTED.search(COMMENT.sub("", line)):
        return _NUMBER.sub("", line).strip()
    calls, ends = "call" in block.codes, "stop" in block.codes and block.codes["stop"].number == 99
    words = [f"G{code.number / 10:g}" for group, code in block.codes.items() if G_GROUPS.get(code.number) == group]
    words += [f"{word.letter}{_number(word.value)}" for word in block.words.values() if not (calls and word.letter in "PL")]
    words += [
        f"M{code.number}"
        for group, code in block.codes.items()
        if G_GROUPS.get(code.number) != group and group != "call" and not (ends and group == "stop")
    ]
    skipped = ["/"] if words and line.lstrip().startswith("/") else []
    return " ".join([*skipped, *words, *(comment for comment in COMMENT.findall(line) if "#" not in comment)])


def _number(value: float) -> str:
    return np.format_float_positional(value, trim="-")


def unrolled(lines: list[str], regions: list[Region]) -> tuple[list[str], list[int]]:
    """Return a program with its corrected regions unrolled, and the original number of each line."""
    written, numbers, at = list[str](), list[int](), 1
    for region in [*(one for one in regions if one.corrected), Region(len(lines) + 1, len(lines) + 1)]:
        written += lines[at - 1 : region.first - 1]
        numbers += range(at, region.first)
        if region.corrected:
            head = COMMENT.sub("", lines[region.first - 1]).strip()
            text = [*([region.call] if region.call else []), f"({head}: unrolled)", *region.text, f"(end of {head})"]
            written += text
            numbers += [region.first] * len(text)
        at = region.last + 1
    return written, numbers


_NOT_TOUCHED = re.compile(r"G\s*0*(4|10|28|30|53|92)(\.\d)?(?![\d.])|M\s*0*(0|1|2|30|60|98|99)(?!\d)|^\s*/", re.IGNORECASE)
"""Codes that a corrected line may not hold: they act at its end, or on its axis words."""
_SPLINE_START = re.compile(r"G\s*0*5\.2", re.IGNORECASE)
MOTION = re.compile(r"G\s*0*([0123]|5(\.[123])?)(?![\d.])", re.IGNORECASE)


@dataclass(frozen=True)
class Block:
    """A move and its place in the program.

    Attributes
    ----------
    move : Move
    lines : (int, int)
        First and last line of the program that describe it, from 1.
    frame : Frame
        Offsets in force.
    millimetres, absolute : bool
    feed_mode : str
        As `contourlab.program.state.FeedMode`.
    reason : str
        Why it cannot be corrected; empty if it can.
    """

    move: Move
    lines: tuple[int, int]
    frame: Frame
    millimetres: bool
    absolute: bool
    feed_mode: str
    reason: str

    @property
    def scale(self) -> float:
        """Program units in a metre."""
        return 1e3 if self.millimetres else 1.0 / 0.0254

    @property
    def feed_word(self) -> str:
        """The feed of a cutting move as a word of the program, per minute."""
        feed = self.move.feedrate * 60.0 * self.scale  # type: ignore[union-attr]
        return f"F{feed:.6f}".rstrip("0")

    def shown(self, axes: Point) -> Point:
        """Return an axis position [m] in the numbers of the program."""
        x, y, z = self.frame.point(axes)
        return (x * self.scale, y * self.scale, z * self.scale)

    def axes(self, shown: Array) -> Array:
        """Return the axis position [m] of numbers (3,) of the program."""
        x, y, z = (shown / self.scale).tolist()
        return np.array(self.frame.axes((x, y, z)))


@dataclass(frozen=True)
class Source:
    """A program as text and as blocks.

    Attributes
    ----------
    program : Program
    blocks : tuple of Block
        One for each move.
    numbers : sequence of int
        Number of each line in the file; they differ where loops and calls were unrolled.
    rules : Rules
        Of its dialect.
    """

    program: Program
    blocks: tuple[Block, ...]
    numbers: Sequence[int]
    rules: Rules


def read_blocks(file: Path, reading: Reading, axes: Sequence[str]) -> Source:
    """Read a program, and unroll the loops and calls whose moves can be corrected.

    If the unrolled program would move differently, it stays as it is.

    Parameters
    ----------
    file : Path
    reading : Reading
    axes : sequence of str
        Axes that can be corrected.

    Raises
    ------
    ProgramError
        If it cannot be read.
    """
    lines = split_lines(read_text(file))
    reading = replace(reading, folder=reading.folder or file.parent)
    source, regions = _source(lines, file, reading, axes)
    if not any(region.corrected for region in regions.found):
        return source
    plain, numbers = unrolled(lines, regions.found)
    try:
        other, _ = _source(plain, file, reading, axes)
    except ProgramError:
        return source
    return replace(other, numbers=numbers) if _same(source.program, other.program) else source


def _same(program: Program, other: Program) -> bool:
    """Return whether two programs move alike, apart from rounding, and have the same events."""

    def values(one: Program) -> tuple[object, ...]:
        moves = ((type(move), *astuple(replace(move, source_line=1))) for move in one.moves)
        return (*moves, *((event.word, event.value) for event in one.events))

    def equal(a: object, b: object) -> bool:
        if isinstance(a, tuple) and isinstance(b, tuple):
            return len(a) == len(b) and all(map(equal, a, b))
        return math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-12) if isinstance(a, float) and isinstance(b, float) else a == b

    return equal(values(program), values(other))


def parse_blocks(text: str, name: str, reading: Reading, axes: Sequence[str]) -> Source:
    """Read a program from text; see `read_blocks`."""
    return _source(split_lines(text), name, reading, axes)[0]


def _source(lines: list[str], name: str | Path, reading: Reading, axes: Sequence[str]) -> tuple[Source, Regions]:
    reader = Reader(lines, name, reading)
    regions = Regions(reader)
    columns = ["xyz".index(axis) for axis in axes]
    blocks: list[Block] = []
    for move in reader.moves():
        state, line = reader.state, move.source_line
        first = line
        motion = MOTION.search(COMMENT.sub("", lines[line - 1]))
        if isinstance(move, Spline) and not (motion and motion[1].startswith("5.1")):
            first = next((k for k in range(line, 0, -1) if _SPLINE_START.search(lines[k - 1])), line)
        reason = _reason(move, columns, [] if reader.walker.repeating else lines[first - 1 : line], state.motion)
        if state.diameter and not reason:
            reason = "in diameters (G7)"
        if reader.walker.repeating and not reason:
            reason, regions.found[-1].corrected = "inside a loop or subprogram", True
        blocks.append(Block(move, (first, line), replace(state.frame), state.millimetres, state.absolute, state.feed_mode, reason))
    count = Counter(block.lines[1] for block in blocks)
    blocks = [replace(b, reason=b.reason or "several moves in a line") if count[b.lines[1]] > 1 else b for b in blocks]
    program = Program(str(name), tuple(b.move for b in blocks), tuple(lines), tuple(reader.state.events), tuple(reader.notices))
    return Source(program, tuple(blocks), range(1, len(lines) + 1), reader.state.rules), regions


def _reason(move: Move, columns: Sequence[int], lines: Sequence[str], motion: int | None) -> str:
    """Return why a move cannot be corrected; "-" for one that does not cut along the corrected axes."""
    if isinstance(move, Dwell) or not isinstance(move, Feed | Arc | Spline):
        return "-"
    if isinstance(move, Arc):
        if not set(PLANE_AXES[move.plane][:2]) <= set(columns):
            return "an arc in a plane that the log does not hold"
    elif not isinstance(move, Spline) and all(move.start[k] == move.end[k] for k in columns):
        return "-"
    if motion in CYCLES:
        return "a canned cycle"
    if any(_NOT_TOUCHED.search(COMMENT.sub("", line)) for line in lines):
        return "with another code that acts on its line"
    return ""


FINEST = 5e-6
"""Smallest distance between two nodes [m]."""


@dataclass(frozen=True, eq=False)
class Contour:
    """The path of a program in the axes of a log, and its nodes.

    Attributes
    ----------
    source : Source
    axes : tuple of str
    route : Route
        Its `source_line` is the number of the block, from 1.
    period : float [s]
        Time between nodes at the programmed feed.
    """

    source: Source
    axes: tuple[str, ...]
    route: Route
    period: float

    @property
    def path(self) -> geometry.Path:
        """The programmed path."""
        return self.route.path

    @cached_property
    def corrected(self) -> Flags:
        """Whether each curve (n_curve,) can be corrected."""
        return np.array([not self.source.blocks[k - 1].reason for k in self.route.source_line.tolist()])

    @cached_property
    def nodes(self) -> Array:
        """Rising arc lengths (n_node,) [m] that hold the correction; every end of a curve is one."""
        parts = [np.zeros(1)]
        breaks = self.path.breaks
        for k, corrected in enumerate(self.corrected.tolist()):
            step = max(FINEST, float(self.route.feedrate[k]) * self.period) if corrected else np.inf
            n = max(1, int(np.ceil((breaks[k + 1] - breaks[k]) / step)))
            parts.append(np.linspace(breaks[k], breaks[k + 1], n + 1)[1:])
        return np.concatenate(parts)

    @cached_property
    def positions(self) -> Array:
        """Position of each node (n_node, n_axis) [m]."""
        return np.asarray(self.path.position(self.nodes))

    @cached_property
    def chunks(self) -> list[tuple[int, int]]:
        """The ranges of curves [start, stop) that are corrected without a break between."""
        blocks, lines = self.source.blocks, self.route.source_line
        ranges: list[tuple[int, int]] = []
        for k in np.flatnonzero(self.corrected).tolist():
            between = blocks[lines[k - 1] : lines[k] - 1] if k else ()
            joins = ranges and ranges[-1][1] == k and not between
            ranges.append((ranges.pop()[0] if joins else k, k + 1))
        return ranges

    @cached_property
    def starts(self) -> list[tuple[int, int]]:
        """The first curve of each corrected part after a rapid, and the block before which its axes may settle: that of a plunge."""
        blocks, starts = self.source.blocks, list[tuple[int, int]]()
        count = Counter(block.lines[0] for block in blocks)
        waits = [isinstance(b.move, Feed | Dwell) and b.reason == "-" and count[b.lines[0]] == 1 for b in blocks]
        for first, _ in self.chunks:
            at = int(self.route.source_line[first]) - 1
            while at and waits[at - 1]:
                at -= 1
            if at and isinstance(blocks[at - 1].move, Traverse):
                starts.append((first, at))
        return starts

    @property
    def room(self) -> Array:
        """Distance (n_node,) [m] along the path of each node from the nearer end of its corrected part; 0 outside."""
        distance = np.zeros(len(self.nodes))
        for first, last in self.chunks:
            index = self.node_range(first, last - 1)
            places = self.nodes[index]
            distance[index] = np.minimum(places - places[0], places[-1] - places)
        return distance

    @property
    def events(self) -> list[tuple[str, float | None]]:
        """What the program does besides moving."""
        return [(event.word, event.value) for event in self.source.program.events]

    def is_corrected(self, arc_length: Array) -> Flags:
        """Return whether places (n,) [m] lie on curves that can be corrected."""
        return np.asarray(self.corrected[self.path.curve_index(arc_length)])

    def node_range(self, first: int, last: int) -> Index:
        """Return the numbers of the nodes from the start of one curve to the end of another, both included."""
        breaks = self.path.breaks
        return np.arange(np.searchsorted(self.nodes, breaks[first]), np.searchsorted(self.nodes, breaks[last + 1]) + 1)


def contour_of(source: Source, axes: Sequence[str], period: float) -> Contour:
    """Return the contour of a program in some of its axes.

    Parameters
    ----------
    source : Source
    axes : sequence of str
        Some of x, y, z; motion of the others is left out.
    period : float [s]

    Raises
    ------
    FeedError
        If nothing moves these axes.
    """
    columns = ["xyz".index(axis) for axis in axes]
    moves = tuple(_flat(replace(block.move, source_line=k + 1), columns) for k, block in enumerate(source.blocks))
    return Contour(source, tuple(axes), program_route(replace(source.program, moves=moves), tuple(axes)), period)


def _flat(move: Move, columns: Sequence[int]) -> Move:
    """Return a move without motion of other axes than some; an arc that leaves their plane becomes a line, which is not corrected."""

    def flat(point: Point) -> Point:
        return tuple(value if k in columns else 0.0 for k, value in enumerate(point))  # type: ignore[return-value]

    if len(columns) == 3 or isinstance(move, Dwell):
        return move
    if isinstance(move, Spline):
        return replace(move, points=tuple(map(flat, move.points)))
    if isinstance(move, Arc) and not set(PLANE_AXES[move.plane][:2]) <= set(columns):
        return Feed(flat(move.start), flat(move.end), move.feedrate, move.source_line, move.mode)
    moved = replace(move, start=flat(move.start), end=flat(move.end))
    return replace(moved, centre=flat(moved.centre)) if isinstance(moved, Arc) else moved
