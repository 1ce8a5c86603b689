"""The moves of a program with what it takes to write each of them again: its lines, units, offsets and modes."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, fields, replace
from pathlib import Path

import numpy as np

from contourlab.errors import ProgramError
from contourlab.program import Arc, Dwell, Feed, Move, Point, Program, Reader, Reading, Spline
from contourlab.program.block import Block as Executed
from contourlab.program.block import Key
from contourlab.program.moves import PLANE_AXES
from contourlab.program.reader import read_text, split_lines
from contourlab.program.state import Frame
from contourlab.program.vocabulary import CYCLES, G_GROUPS

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
            changed = {key: value for key, value in values.items() if self._before.get(key) != value}
            self.found[-1].text += [
                f"#<{key}> = {_number(value)}" if isinstance(key, str) else f"#{key} = {_number(value)}"
                for key, value in changed.items()
                if isinstance(key, str) or key < _FIRST_OF_INTERPRETER
            ]
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
        return f"F{feed:.6f}".rstrip("0").rstrip(".")

    def shown(self, axes: Point) -> Point:
        """Return an axis position [m] in the numbers of the program."""
        x, y, z = self.frame.point(axes)
        return (x * self.scale, y * self.scale, z * self.scale)


@dataclass(frozen=True)
class Source:
    """A program as text and as blocks.

    Attributes
    ----------
    program : Program
    lines : tuple of str
    blocks : tuple of Block
        One for each move.
    numbers : sequence of int
        Number of each line in the file; they differ where loops and calls were unrolled.
    """

    program: Program
    lines: tuple[str, ...]
    blocks: tuple[Block, ...]
    numbers: Sequence[int]


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
    reading = replace(reading, folder=file.parent) if reading.folder is None else reading
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

    def values(one: Program) -> Iterable[object]:
        for move in one.moves:
            yield type(move)
            yield from (getattr(move, one.name) for one in fields(move) if one.name != "source_line")
        yield from ((event.word, event.value) for event in one.events)

    def equal(a: object, b: object) -> bool:
        if isinstance(a, tuple) and isinstance(b, tuple):
            return len(a) == len(b) and all(map(equal, a, b))
        return math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-12) if isinstance(a, float) and isinstance(b, float) else a == b

    return equal(tuple(values(program)), tuple(values(other)))


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
    return Source(program, tuple(lines), tuple(blocks), range(1, len(lines) + 1)), regions


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
