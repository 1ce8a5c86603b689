"""Coordinate systems and tools: convert points of a program to positions of the axes, and back.

    axes = origin + R(rotation) (point + shift) + tool

origin and rotation belong to the selected work coordinate system (G54 to G59.3), shift to G92 and G52, tool to G43. R rotates about the Z
axis. As in LinuxCNC, the parameters from #5201 hold these numbers in mm and degrees.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from pathlib import Path

from contourlab.errors import ProgramError
from contourlab.program.expressions import Parameters
from contourlab.program.moves import Point
from contourlab.program.vocabulary import BlockError

ORIGIN: Point = (0.0, 0.0, 0.0)
SHIFT_APPLIED = 5210
_FIRST_OF_SYSTEM = 5201
_PER_SYSTEM = 20
_ROTATION = 9


@dataclass(slots=True)
class Frame:
    """The active offsets.

    Parameters
    ----------
    system : int, 1 to 9
        1 for G54, 9 for G59.3.
    origin, shift, tool : (x, y, z) [m]
    rotation : float [degrees]
    """

    system: int = 1
    origin: Point = ORIGIN
    rotation: float = 0.0
    shift: Point = ORIGIN
    tool: Point = ORIGIN
    plain: bool = True

    def refresh(self) -> None:
        """Note whether all offsets are zero, to skip the arithmetic; call after every change."""
        self.plain = self.rotation == 0.0 and self.origin == self.shift == self.tool == ORIGIN

    def axes(self, point: Point) -> Point:
        """Return the axis positions [m] of a point of the program."""
        if self.plain:
            return point
        return add(add(turn(add(point, self.shift), self.rotation), self.origin), self.tool)

    def point(self, axes: Point) -> Point:
        """Return the point of the program [m] at given axis positions [m]."""
        if self.plain:
            return axes
        return less(turn(less(less(axes, self.tool), self.origin), -self.rotation), self.shift)


def add(a: Point, b: Point) -> Point:
    """Return a + b."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def less(a: Point, b: Point) -> Point:
    """Return a - b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def updated(point: Point, given: list[float | None]) -> Point:
    """Return a point with the given coordinates replaced."""
    x, y, z = (old if new is None else new for old, new in zip(point, given, strict=True))
    return (x, y, z)


def turn(point: Point, degrees: float) -> Point:
    """Return a point turned about the Z axis."""
    if degrees == 0.0:
        return point
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return (point[0] * c - point[1] * s, point[0] * s + point[1] * c, point[2])


def origin_of(parameters: Parameters, system: int) -> tuple[Point, float]:
    """Return origin [m] and rotation [degrees] of a work coordinate system, 1 to 9."""
    first = _FIRST_OF_SYSTEM + _PER_SYSTEM * system
    return parameters.point(first), parameters.number(first + _ROTATION)


def store_origin(parameters: Parameters, system: int, origin: Point, rotation: float) -> None:
    """Set origin [m] and rotation [degrees] of a work coordinate system."""
    first = _FIRST_OF_SYSTEM + _PER_SYSTEM * system
    parameters.write_point(first, origin)
    parameters.write(first + _ROTATION, rotation)


def load_shift(parameters: Parameters) -> Point:
    """Return the stored shift of G92 [m]."""
    return parameters.point(SHIFT_APPLIED + 1)


def store_shift(parameters: Parameters, shift: Point, applied: bool) -> None:
    """Store the shift of G92 [m], and whether it is active."""
    parameters.write(SHIFT_APPLIED, float(applied))
    parameters.write_point(SHIFT_APPLIED + 1, shift)


LARGEST_TOOL = 99_999
_ENTRY = re.compile(r"([A-Za-z])\s*([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+))")
_LENGTHS = "XYZ"
_LETTERS = frozenset("TPDXYZABCUVWIJQ")


class Tools:
    """Offsets of the tools by number; other tools have zero offset.

    Attributes
    ----------
    offsets : dict of int to (x, y, z) [m]
    diameters : dict of int to float [m]
    current, selected : int
        The tool in the spindle, and the next one; 0 for none.
    complete : bool
        Whether a tool table lists all tools.
    """

    def __init__(self) -> None:
        self.offsets: dict[int, Point] = {}
        self.diameters: dict[int, float] = {}
        self.current, self.selected = 0, 0
        self.complete = False

    def check(self, number: int, column: int) -> None:
        """Refuse a tool that is missing from the tool table; 0 is no tool."""
        if self.complete and number and number not in self.offsets:
            raise BlockError(f"tool {number} is not in the tool table: add it, or correct the number", column)

    def offset(self, number: int) -> Point:
        """Return the offset of a tool [m]."""
        return self.offsets.get(number, ORIGIN)


def read_tools(file: str | Path) -> Tools:
    """Read a LinuxCNC tool table: one tool on a line, as in ``T1 P1 D3.0 Z+25.4 ; end mill``; lengths in mm.

    Raises
    ------
    ProgramError
        If the file cannot be read, or a line describes no tool.
    """
    try:
        text = Path(file).read_text(encoding="utf-8-sig", errors="replace")
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise ProgramError(f"the tool table cannot be read: {reason}", file=file) from error
    tools = Tools()
    tools.complete = True
    for number, line in enumerate(text.splitlines(), start=1):
        entry = line.split(";")[0].strip()
        if entry:
            _add(tools, entry, file, number)
    return tools


def _add(tools: Tools, entry: str, file: str | Path, line: int) -> None:
    if _ENTRY.sub("", entry).strip():
        cure = "write words such as T1 P1 D3.0 Z+25.4, and comments after ';'"
        raise ProgramError(f"this is not a line of a tool table: {cure}", file=file, line=line)
    words = {letter.upper(): float(value) for letter, value in _ENTRY.findall(entry)}
    unknown = words.keys() - _LETTERS
    if unknown:
        raise ProgramError(f"a tool table has no word {min(unknown)}: use {', '.join(sorted(_LETTERS))}", file=file, line=line)
    tool = words.get("T", 0.0)
    if tool != round(tool) or not 1 <= tool <= LARGEST_TOOL:
        raise ProgramError(f"a tool number must be a whole number from 1 to {LARGEST_TOOL}: write for example T1", file=file, line=line)
    if int(tool) in tools.offsets:
        raise ProgramError(f"tool {int(tool)} is listed twice: delete one of the lines", file=file, line=line)
    x, y, z = (words.get(letter, 0.0) / 1000.0 for letter in _LENGTHS)
    tools.offsets[int(tool)] = (x, y, z)
    tools.diameters[int(tool)] = words.get("D", 0.0) / 1000.0
