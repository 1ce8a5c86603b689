"""A program read with what it takes to write each move again, its contour with a correction, and the program written again."""

from __future__ import annotations

import itertools
import math
import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import astuple, dataclass, field, replace
from functools import cached_property
from pathlib import Path

import numpy as np

from contourlab import geometry
from contourlab.arrays import Array, Flags, Index
from contourlab.errors import ProgramError
from contourlab.feed import Route
from contourlab.geometry.thinning import polygon_corners
from contourlab.program import Arc, Dwell, Feed, Move, Point, Program, Reader, Reading, Spline, Traverse
from contourlab.program.block import Block as Executed
from contourlab.program.block import Key
from contourlab.program.dialects import Rules
from contourlab.program.moves import PLANE_AXES
from contourlab.program.reader import read_text, split_lines
from contourlab.program.state import Frame
from contourlab.program.vocabulary import CYCLES, G_GROUPS
from contourlab.result.stamp import identity, stamp
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
_MOTION = re.compile(r"G\s*0*([0123]|5(\.[123])?)(?![\d.])", re.IGNORECASE)
_GEOMETRY = "XYZIJKRL@^"


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
    count: dict[int, int] = {}
    for move in reader.moves():
        state, line = reader.state, move.source_line
        first = line
        motion = _MOTION.search(COMMENT.sub("", lines[line - 1]))
        if isinstance(move, Spline) and not (motion and motion[1].startswith("5.1")):
            first = next((k for k in range(line, 0, -1) if _SPLINE_START.search(lines[k - 1])), line)
        reason = _reason(move, columns, [] if reader.walker.repeating else lines[first - 1 : line], state.motion)
        if state.diameter and not reason:
            reason = "in diameters (G7)"
        if reader.walker.repeating and not reason:
            reason, regions.found[-1].corrected = "inside a loop or subprogram", True
        blocks.append(Block(move, (first, line), replace(state.frame), state.millimetres, state.absolute, state.feed_mode, reason))
        count[line] = count.get(line, 0) + 1
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


def without_motion(line: str) -> str:
    """Return a line without its motion: axis words, centres, radii and motion codes; the rest stays.

    >>> without_motion("N10 G17 G2 (arc) X9 Y[3+1] I-2. F200 M8")
    'N10 G17 (arc) F200 M8'
    """
    blend = re.search(r"G\s*0*64(?!\d)", COMMENT.sub("", line), re.IGNORECASE)
    dropped = _GEOMETRY + ("" if blend else "PQ")
    kept, at = [], 0
    while at < len(line):
        letter = line[at]
        if letter in "(;":
            end = line.find(")", at) + 1 if letter == "(" else len(line)
            kept.append(line[at : end or len(line)])
            at = end or len(line)
            continue
        if not (letter.isalpha() or letter in "@^#"):
            kept.append(letter)
            at += 1
            continue
        end = _word_end(line, at)
        word = line[at:end]
        if letter.upper() not in dropped and not (letter in "gG" and _MOTION.fullmatch(word.strip())):
            kept.append(word)
        elif kept and kept[-1] == " ":
            kept.pop()
        at = end
    return "".join(kept).strip()


def _word_end(line: str, at: int) -> int:
    """Return the end of a word, an assignment included: the next letter, sign of a comment, or axis sign outside brackets."""
    end, depth = at + 1, 0
    assigned = line[at] == "#"
    while end < len(line):
        sign = line[end]
        if sign in "[<":
            depth += 1
        elif sign in "]>":
            depth -= 1
        elif depth == 0 and (sign in "(;@^" or (sign == "#" and not assigned and line[at + 1 : end].strip(" +-#"))):
            break
        elif depth == 0 and sign.isalpha():
            function = re.match(r"[A-Za-z]+\s*\[", line[end:])
            if function is None or (line[at + 1 : end].strip(" =+-#") and not assigned):
                break
            end += function.end() - 1
            continue
        end += 1
    while line[end - 1] == " ":
        end -= 1
    return end


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


MARK = "(contourlab precompensate: pass "
"""How a corrected program begins."""
STEP = 1.25
"""Speeds of the control along a line, largest over smallest; between them, a line may be faster than the control was."""
_SMOOTH = 1e-9
_PLAIN = re.compile(r"\s*((N\d+|G0*[0123]|[XYZIJKRF][-+]?[\d.]+)\s*)+", re.IGNORECASE)
"""A line of motion only: between two corrected moves it is one without length, to a point that moved away."""


@dataclass(frozen=True, eq=False)
class Written:
    """A corrected program.

    Attributes
    ----------
    text : str
    corrected_arc : ndarray (n,) [m]
        Places along its path, rising: the end of each of its curves, after 0.
    programmed_arc : ndarray (n,) [m]
        The same places along the programmed path.
    n_line : int
        Lines that replace corrected moves.
    """

    text: str
    corrected_arc: Array
    programmed_arc: Array
    n_line: int


@dataclass(eq=False)
class _Lines:
    """Lines that replace a block, where they end, how far the control may round them, and what is in force behind them.

    That is: whether a feed below the programmed one, and a line with G64.
    """

    end: Array
    blend: float
    text: list[str] = field(default_factory=list)
    points: list[Array] = field(default_factory=list)
    places: list[float] = field(default_factory=list)
    slowed: bool = False
    control: str = ""


def write_corrected(
    contour: Contour,
    correction: Array,
    tolerance: float,
    fastest: Array | float = np.inf,
    blend: float | None = None,
    dwells: Mapping[int, float] | None = None,
    stops: bool = False,
) -> Written:
    """Return the program whose path is the programmed one plus a correction.

    Parameters
    ----------
    contour : Contour
    correction : ndarray (n_node, n_axis) [m]
        Displacement of each node. A corrected part begins and ends at its programmed points.
    tolerance : float [m]
        Largest distance of a written line from the corrected path.
    fastest : ndarray (n_node,) [m/s], optional
        Largest speed at each node along the programmed path; lines that could be faster get a feed word.
    blend : float [m], optional
        By how much the control may round and smooth the written lines, as P or Q of G64; twice the tolerance, if it is not given.
    dwells : mapping of int to float [s], optional
        Dwells to add, by the number of the block after each.
    stops : bool
        Whether the control stops at corners where the program sets no path control; G64 is then set from the first corrected line on.
    """
    fastest, blend = np.broadcast_to(fastest, len(contour.nodes)), blend or 2.0 * tolerance
    replaced: dict[int, _Lines] = {}
    blocks = contour.source.blocks
    for first, last in contour.chunks:
        lines = _Lines(contour.path.position(contour.path.breaks[first : first + 1])[0], blend)
        numbers = contour.route.source_line[first:last]
        for k in np.unique(numbers).tolist():
            curves = first + np.flatnonzero(numbers == k)
            index = contour.node_range(int(curves[0]), int(curves[-1]))
            lines = _replacing(contour, blocks[k - 1], index, correction, lines, tolerance, curves[-1] == last - 1, fastest)
            if stops and blocks[k - 1].move.mode.control is None:
                lines.text = [*_blending(contour.source.rules, blend * blocks[k - 1].scale), *lines.text]
                stops = False
            replaced[k - 1] = lines
    arcs, places, at = [0.0], [0.0], np.asarray(contour.path.position(np.zeros(1))[0])
    breaks = contour.path.breaks
    done = set()
    for curve, number in enumerate(contour.route.source_line.tolist()):
        new = replaced.get(number - 1)
        if new is None:
            arcs.append(arcs[-1] + float(breaks[curve + 1] - breaks[curve]))
            places.append(float(breaks[curve + 1]))
            at = contour.path.position(breaks[curve + 1 : curve + 2])[0]
        elif number not in done:
            done.add(number)
            for point, place in zip(new.points, new.places, strict=True):
                arcs.append(arcs[-1] + float(np.linalg.norm(point - at)))
                places.append(place)
                at = point
    n_line = sum(len(lines.points) for lines in replaced.values())
    return Written(with_dwells(contour, dwells or {}, replaced), np.array(arcs), np.array(places), n_line)


def _replacing(
    contour: Contour, block: Block, index: Index, correction: Array, before: _Lines, tolerance: float, ends: bool, fastest: Array
) -> _Lines:
    """Return the lines of one block, from where the lines before ended."""
    columns = ["xyz".index(axis) for axis in contour.axes]
    move, places = block.move, contour.nodes[index]
    share = (places - places[0]) / (places[-1] - places[0])
    points = np.array(move.start) + share[:, None] * (np.array(move.end) - np.array(move.start))  # type: ignore[union-attr]
    points[:, columns] = contour.positions[index] + correction[index]
    points[0, columns] = before.end
    if ends:
        index, points, places = np.append(index, index[-1]), np.vstack([points, points[-1:]]), np.append(places, places[-1])
        points[-1, columns] = contour.positions[index[-1]]
    rules = contour.source.rules
    digits = rules.decimals[0 if block.millimetres else 1]
    exact = np.array([block.shown(tuple(point)) for point in points.tolist()])
    shown = np.round(exact, digits) + 0.0  # no -0
    moved = np.append(True, (np.diff(shown[:, columns], axis=0) != 0.0).any(axis=1))
    shown, points, places, fastest = shown[moved], points[moved], places[moved], fastest[index[moved]]
    corners = polygon_corners(exact[moved], tolerance * block.scale)
    if block.feed_mode == "per_minute":
        fastest = np.maximum(fastest, 1e-3 * move.feedrate)  # type: ignore[union-attr]
        level = np.rint(np.log(np.minimum(fastest, move.feedrate)) / math.log(STEP))  # type: ignore[union-attr]
        corners = np.union1d(corners, 1 + np.flatnonzero(np.diff(level)))
    kept = corners[1:]
    lines = _Lines(points[-1, columns], before.blend, slowed=before.slowed, control=before.control)
    varies = np.ptp(shown, axis=0) > 0.0
    for k in kept.tolist():
        words = [f"{'XYZ'[j]}{shown[k, j]:.{digits}f}".rstrip("0") for j in np.flatnonzero(varies)]
        lines.text.append("G1 " + " ".join(words))
        lines.points.append(block.axes(shown[k])[columns])
        lines.places.append(float(places[k]))
    if block.feed_mode == "per_minute" and len(kept):
        speed = np.maximum(np.maximum.reduceat(fastest, corners[:-1]), fastest[kept])
        length = np.linalg.norm(np.diff(points[corners], axis=0), axis=1)
        _with_feeds(lines, block, speed * length / np.maximum(np.diff(places[corners]), 1e-12))
    turns = ends or bool((np.abs(np.asarray(contour.path.corners) - places[-1]) < _SMOOTH).any())
    _with_modes(lines, block, rules, turns, ends)
    if lines.slowed and ends:
        lines.text.append(block.feed_word)
    return lines


def _with_feeds(lines: _Lines, block: Block, largest: Array) -> None:
    """Add feed words to lines that may not have the programmed feed, and to the first one that has it again."""
    feed, in_force = block.feed_word, "" if lines.slowed else block.feed_word
    scale = 60.0 * block.scale
    for k, one in enumerate(largest.tolist()):
        word = feed if one >= block.move.feedrate else f"F{scale * one:.{1 if block.millimetres else 3}f}"  # type: ignore[union-attr]
        lines.text[k] += f" {word}" if word != in_force else ""
        in_force = word
    lines.slowed = in_force != feed


def _with_modes(lines: _Lines, block: Block, rules: Rules, corner: bool, ends: bool) -> None:
    """Add the codes that let short lines run as one move and stay as they are, and those that restore the modes of the program."""
    mode, fine = block.move.mode, lines.blend * block.scale  # type: ignore[union-attr]
    if mode.control in ("exact_path", "exact_stop"):
        if len(lines.text) > 1 and rules.blend is not None:
            code = "G61.1" if mode.control == "exact_stop" and not rules.stops_at_g61 else "G61"
            lines.text.insert(len(lines.text) - int(corner or mode.control == "exact_stop"), code)
            lines.text = [*_blending(rules, fine), *lines.text]
    elif mode.tolerance and mode.merge and mode.merge > lines.blend and rules.blend:
        # With Q as large as P, by default, the control may smooth the correction away.
        (own,), (closer,) = (_blending(rules, mode.tolerance * block.scale, q) for q in (mode.merge * block.scale, fine))
        lines.text = [*([closer] if lines.control != closer else []), *lines.text, *([own] if ends else [])]
        lines.control = closer
    if not block.absolute:
        lines.text = ["G90", *lines.text, "G91"]
    if block.feed_mode == "inverse_time":
        lines.text = [f"G94 {block.feed_word}", *lines.text, "G93"]


def _blending(rules: Rules, tolerance: float, merge: float | None = None) -> list[str]:
    """Return the line that sets G64 with a P and a Q in the unit of the program, as far as a dialect has them."""
    given = [(letter, value) for letter, value in (("P", tolerance), ("Q", merge)) if value is not None and letter in (rules.blend or "")]
    return [] if rules.blend is None else [" ".join(["G64", *(f"{letter}{value:.6f}".rstrip("0") for letter, value in given)])]


def with_dwells(contour: Contour, dwells: Mapping[int, float], replaced: Mapping[int, _Lines] | None = None) -> str:
    """Return the program with dwells [s] before some blocks, and the lines of others replaced."""
    replaced = replaced or {}
    source, typed = contour.source, contour.source.program.lines
    by_line: dict[int, list[str]] = {}
    for k, lines in replaced.items():
        first, last = source.blocks[k].lines
        for number in range(first, last + 1):
            text = without_motion(typed[number - 1])
            if isinstance(source.blocks[k].move, Spline) and number != first:
                text = text if "(" in text or ";" in text else ""
            by_line[number] = [text] if text else []
        by_line[last] += lines.text
    for first, last in contour.chunks:
        numbers = np.unique(contour.route.source_line[first:last]) - 1
        for before, after in itertools.pairwise(numbers.tolist()):
            for number in range(source.blocks[before].lines[1] + 1, source.blocks[after].lines[0]):
                if _PLAIN.fullmatch(COMMENT.sub("", typed[number - 1])):
                    text = without_motion(typed[number - 1])
                    by_line[number] = [text] if text else []
    for k, seconds in dwells.items():
        number = source.blocks[k].lines[0]
        dwell = f"G4 P{seconds / source.rules.dwell:.3f}".rstrip("0").rstrip(".")
        by_line[number] = [dwell, *by_line.get(number, [typed[number - 1]])]
    return "".join(f"{text}\n" for number, line in enumerate(typed, 1) for text in by_line.get(number, [line]))


def marked(text: str, number: int, name: str, source: tuple[str, ...] = ()) -> str:
    """Return a program with comments that say what it is and what made it, after an opening % and O-number; `source` is the one before."""
    plain = "".join(letter if letter.isalnum() or letter in "._-" else "_" for letter in name)
    opening = re.match(r"(%.*\n)?([O:][0-9]+[ \t]*(\([^()\n]*\))?[ \t]*\n)?", text, re.IGNORECASE)
    at = opening.end() if opening else 0
    return f"{text[:at]}{MARK}{number} of {plain})\n({stamp(program=identity(source))})\n{text[at:]}"
