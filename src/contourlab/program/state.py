"""The modal state of the interpreter: coordinate systems and tools, straight moves, dwells, events and named parameters.

Points of a program become positions of the axes, and back:

    axes = origin + R(rotation) (point + shift) + tool

origin and rotation belong to the selected work coordinate system (G54 to G59.3), shift to G92 and G52, tool to G43. R rotates about the Z
axis. As in LinuxCNC, the parameters from #5201 hold these numbers in mm and degrees.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal, TypeAlias

from contourlab.errors import ProgramError
from contourlab.program.block import LARGEST_PARAMETER, SELECTED_SYSTEM, Parameters, Word
from contourlab.program.dialects import LINUXCNC, Rules
from contourlab.program.moves import PLAIN, Dwell, Event, Feed, Mode, Move, Plane, Point, Traverse
from contourlab.program.vocabulary import SYSTEMS, BlockError

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
        return point if self.plain else add(add(turn(add(point, self.shift), self.rotation), self.origin), self.tool)

    def point(self, axes: Point) -> Point:
        """Return the point of the program [m] at given axis positions [m]."""
        return axes if self.plain else less(turn(less(less(axes, self.tool), self.origin), -self.rotation), self.shift)


def metres(value: float, millimetres: bool) -> float:
    """Convert a length in mm or inch to metres; division keeps decimals exact to the last bit."""
    return value / 1000.0 if millimetres else value * 0.0254


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


def store_shift(parameters: Parameters, shift: Point, applied: bool) -> None:
    """Store the shift of G92 [m], and whether it is active."""
    parameters.write(SHIFT_APPLIED, float(applied))
    parameters.write_point(SHIFT_APPLIED + 1, shift)


_POINTS = (5161, 5181, SHIFT_APPLIED + 1, *(_FIRST_OF_SYSTEM + _PER_SYSTEM * system for system in range(1, 10)))
"""First parameters of the points X, Y, Z, A, B, C, U, V, W."""
_ANGLES = (3, 4, 5)
LARGEST_TOOL = 99_999
_ENTRY = re.compile(r"([A-Za-z])\s*([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+))")
_LENGTHS = "XYZ"
_LETTERS = frozenset("TPDXYZABCUVWIJQ")


def unreadable(what: str, file: str | Path, error: OSError | ValueError) -> ProgramError:
    """Return the error of a file that cannot be read."""
    reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
    return ProgramError(f"CL800 the {what} cannot be read: {reason}", file=file)


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
            raise BlockError(f"CL849 tool {number} is not in the tool table: add it, or correct the number", column)

    def offset(self, number: int) -> Point:
        """Return the offset of a tool [m]."""
        return self.offsets.get(number, ORIGIN)


def read_parameters(file: str | Path, parameters: Parameters, millimetres: bool = True) -> None:
    """Take parameters from a LinuxCNC parameter file: number and value on each line, lengths in mm or inch.

    Raises
    ------
    ProgramError
        If the file cannot be read, or a line is none of a parameter.
    """
    for number, line in enumerate(_lines("parameter file", file), start=1):
        words = line.split("#")[0].split()
        if not words:
            continue
        try:
            key, value = int(words[0]), float(words[1])
            if not (1 <= key <= LARGEST_PARAMETER and math.isfinite(value)):
                raise ValueError
        except (ValueError, IndexError):
            cure = "write a number and its value, such as 5221 100.0"
            raise ProgramError(f"CL849 this is not a line of a parameter file: {cure}", file=file, line=number) from None
        # Points and offsets are in machine units, here in mm.
        parameters.write(key, value * 25.4 if _is_length(key) and not millimetres else value)


def _is_length(key: int) -> bool:
    """Return whether a parameter of the file is a linear coordinate: of G28, G30, G92 or a coordinate system."""
    first = next((first for first in _POINTS if first <= key < first + 9), None)
    return first is not None and (key - first) % 9 not in _ANGLES


def _lines(what: str, file: str | Path) -> list[str]:
    try:
        return Path(file).read_text(encoding="utf-8-sig", errors="replace").splitlines()
    except (OSError, ValueError) as error:
        raise unreadable(what, file, error) from error


def read_tools(file: str | Path, millimetres: bool = True) -> Tools:
    """Read a LinuxCNC tool table: one tool on a line, as in ``T1 P1 D3.0 Z+25.4 ; end mill``; lengths in mm or inch.

    Raises
    ------
    ProgramError
        If the file cannot be read, or a line describes no tool.
    """
    tools = Tools()
    tools.complete = True
    for number, line in enumerate(_lines("tool table", file), start=1):
        entry = line.split(";")[0].strip()
        if entry:
            _add(tools, entry, millimetres, file, number)
    return tools


def _add(tools: Tools, entry: str, millimetres: bool, file: str | Path, line: int) -> None:
    if _ENTRY.sub("", entry).strip():
        cure = "write words such as T1 P1 D3.0 Z+25.4, and comments after ';'"
        raise ProgramError(f"CL849 this is not a line of a tool table: {cure}", file=file, line=line)
    words = {letter.upper(): float(value) for letter, value in _ENTRY.findall(entry)}
    unknown = words.keys() - _LETTERS
    if unknown:
        raise ProgramError(f"CL849 a tool table has no word {min(unknown)}: use {', '.join(sorted(_LETTERS))}", file=file, line=line)
    tool = words.get("T", -1.0)
    if tool != round(tool) or not 0 <= tool <= LARGEST_TOOL:
        raise ProgramError(
            f"CL849 a tool number must be a whole number from 0 to {LARGEST_TOOL}: write for example T1", file=file, line=line
        )
    if int(tool) in tools.offsets:
        return  # LinuxCNC takes the first
    x, y, z, diameter = (metres(words.get(letter, 0.0), millimetres) for letter in (*_LENGTHS, "D"))
    tools.offsets[int(tool)] = (x, y, z)
    tools.diameters[int(tool)] = diameter


LARGEST_LENGTH = 1e3
"""Largest coordinate [m]."""
SHORTEST_MOVE = 1e-12
"""Straight moves up to this length [m] are rounding errors; they are left out."""

FeedMode: TypeAlias = Literal["per_minute", "per_turn", "inverse_time"]


@dataclass(slots=True)
class Cycle:
    """Modal values of a canned cycle, in program coordinates [m] and seconds, and their units."""

    depth: float = 0.0
    clearance: float = 0.0
    level: float | None = None
    dwell: float = 0.0
    peck: float = 0.0
    bore: Point = (0.0, 0.0, 0.0)
    millimetres: bool = True
    absolute: bool = True


@dataclass(slots=True)
class Curve:
    """Control points (x, y) [m], weights and order of an unfinished spline."""

    points: list[tuple[float, float]] = field(default_factory=list)
    weights: list[float] = field(default_factory=list)
    order: int = 3


@dataclass(slots=True)
class ModalState:
    """The modal state; the defaults hold at the start of a program.

    Parameters
    ----------
    still : bool
        Whether to make moves of zero length and dwells of 0 s.
    position : (x, y, z) [m]
        The programmed point in the selected coordinate system.
    reached : (x, y, z) [m]
        Position of the axes; it differs from `position` by offsets and omitted short moves.
    rules : Rules
        Those of the dialect.
    motion : int or None
        G-code of the modal motion, times ten; 800 after G80.
    resumed : int
        That of the last G0 to G3; G0 without one.
    feedrate : float [m/s]
        [m/turn] with G95; 0 until set.
    turning : int
        Sense of the spindle: 1 clockwise, -1 counterclockwise, 0 at rest.
    speed : float [turns/min]
    made : int
        Number of moves made.
    machine_points : list of (int, (x, y, z))
        Line and target of each G53 [m], nan for an axis that it does not name; lines of G28 and G30, whose home another file may hold.
    """

    parameters: Parameters = field(default_factory=Parameters)
    tools: Tools = field(default_factory=Tools)
    still: bool = False
    position: Point = (0.0, 0.0, 0.0)
    reached: Point = (0.0, 0.0, 0.0)
    rules: Rules = LINUXCNC
    motion: int | None = None
    resumed: int = 0
    plane: Plane = "XY"
    millimetres: bool = True
    absolute: bool = True
    absolute_centre: bool = False
    diameter: bool = False
    feed_mode: FeedMode = "per_minute"
    feedrate: float = 0.0
    frame: Frame = field(default_factory=Frame)
    mode: Mode = PLAIN
    back_to_clearance: bool = True
    turning: int = 0
    speed: float = 0.0
    cycle: Cycle = field(default_factory=Cycle)
    tangent: tuple[float, float] | None = None
    curve: Curve = field(default_factory=Curve)
    events: list[Event] = field(default_factory=list)
    made: int = 0
    machine_points: list[tuple[int, Point]] = field(default_factory=list)

    def length(self, value: float) -> float:
        """Convert a length in program units to metres."""
        return metres(value, self.millimetres)

    def shown(self, length: float) -> float:
        """Convert metres to program units."""
        return length * 1000.0 if self.millimetres else length / 0.0254

    def shown_position(self) -> Point:
        """Return the programmed point in program units, for #5420 to #5422."""
        x, y, z = self.position
        return (self.shown(x), self.shown(y), self.shown(z))

    def coordinate(self, axis: int, word: Word) -> float:
        """Return the length [m] of an axis word; with G7 an X is a diameter."""
        length = self.length(word.value)
        return 0.5 * length if self.diameter and axis == 0 else length

    def given(self, words: dict[str, Word]) -> list[float | None]:
        """Return the lengths [m] of X, Y and Z, None for missing ones."""
        return [self.coordinate(axis, words[letter]) if letter in words else None for axis, letter in enumerate("XYZ")]

    def target(self, words: dict[str, Word]) -> Point:
        """Return the end point [m] of the axis words of a block."""
        point = list(self.position)
        if "@" in words or "^" in words:
            point[:2] = self.polar(words)
        for axis, letter in enumerate("XYZ"):
            word = words.get(letter)
            if word is not None:
                value = self.coordinate(axis, word)
                point[axis] = value if self.absolute else point[axis] + value
        end = (point[0], point[1], point[2])
        self.check_reach(end, words)
        return end

    def check_reach(self, point: Point, words: dict[str, Word]) -> None:
        """Refuse points beyond the range of any machine."""
        for letter, value in zip("XYZ", point, strict=True):
            if abs(value) > LARGEST_LENGTH:
                word = words.get(letter) or next(iter(words.values()), None)
                fault = f"CL817 {letter} would move to {value:g} m: stay within {LARGEST_LENGTH:g} m of zero"
                raise BlockError(fault, word.column if word else 0)

    def polar(self, words: dict[str, Word]) -> tuple[float, float]:
        """Return x and y [m] of a distance @ from the origin and an angle ^ [degrees] from the x axis; a missing word keeps its value."""
        far, turn = words.get("@"), words.get("^")
        column = (far or words["^"]).column
        for letter in "XY":
            if letter in words:
                raise BlockError(f"CL816 @ or ^ cannot be combined with {letter}: give polar coordinates, or X and Y", words[letter].column)
        x, y, _ = self.position
        radius, angle = math.hypot(x, y), math.atan2(y, x)
        if radius == 0.0 and (not self.absolute or turn is None):
            cure = "write ^ too" if self.absolute else "move away from it with X or Y first, or write G90"
            raise BlockError(f"CL818 at the origin the polar angle is undefined: {cure}", column)
        if self.absolute:
            radius = radius if far is None else self.length(far.value)
            angle = angle if turn is None else math.radians(turn.value)
        else:
            radius += 0.0 if far is None else self.length(far.value)
            angle += 0.0 if turn is None else math.radians(turn.value)
            if radius == 0.0:
                raise BlockError(
                    "CL818 this polar step (G91) ends at the origin, where the angle is undefined: write G90 X0 Y0 instead", column
                )
        return (radius * math.cos(angle), radius * math.sin(angle))

    @property
    def axes(self) -> Point:
        """The programmed point as positions of the axes [m]."""
        return self.frame.axes(self.position)

    def path_feedrate(self, column: int, motion: str) -> float:
        """Return the feedrate [m/s] of G94 and G95.

        Raises
        ------
        BlockError
            If there is no feedrate, or G95 has no spindle speed.
        """
        if self.feedrate == 0.0:
            raise BlockError(f"CL815 {motion} has no feedrate: write F on its line or before it; G94 clears an earlier F", column)
        if self.feed_mode == "per_turn":
            if self.speed == 0.0:
                raise BlockError(f"CL815 {motion} with G95 needs a spindle speed: write S before it", column)
            return self.feedrate * self.speed / 60.0
        return self.feedrate

    def straight(self, end: Point, line: int, feedrate: float | None = None) -> list[Move]:
        """Go straight to a programmed point [m], at a feedrate [m/s] or rapidly; return the move, none for zero length."""
        self.position = end
        axes = self.frame.axes(end)
        if not self.still and math.dist(self.reached, axes) <= SHORTEST_MOVE:
            return []
        start, self.reached = self.reached, axes
        self.made += 1
        if feedrate is None:
            return [Traverse(start, axes, line, self.mode)]
        return [Feed(start, axes, feedrate, line, self.mode)]

    def wait(self, seconds: float, line: int) -> list[Move]:
        """Return a dwell; a dwell of 0 s becomes an event, because the machine stops for it, and a dwell only if `still`."""
        if seconds == 0.0:
            self.tell("G4", 0.0, line)
        if seconds == 0.0 and not self.still:
            return []
        self.made += 1
        return [Dwell(seconds, line)]

    def tell(self, word: str, value: float | None, line: int, index: float | None = None) -> None:
        """Record an event with its place among the moves."""
        self.events.append(Event(word, value, line, index, self.made))

    def take_offsets(self, axes: Point) -> None:
        """Select the coordinate system and the shift of G92 that the parameters hold, with the axes at a position [m]."""
        system = int(self.parameters.number(SELECTED_SYSTEM))
        self.frame.system = system if 1 <= system <= len(SYSTEMS) else 1
        self.frame.origin, self.frame.rotation = origin_of(self.parameters, self.frame.system)
        if self.parameters.number(SHIFT_APPLIED):
            self.frame.shift = self.parameters.point(SHIFT_APPLIED + 1)
        self.reached = axes
        self.see_from(axes)

    def see_from(self, axes: Point) -> None:
        """Recompute the programmed point after a change of the offsets, from the axis positions [m] before the change."""
        self.frame.refresh()
        self.position = self.frame.point(axes)
        if self.mode.tool != self.frame.tool:
            self.mode = replace(self.mode, tool=self.frame.tool)


_FIXED = {"_vmajor": 2.9, "_ccomp": 400.0, "_spindle_rpm_mode": 1.0} | dict.fromkeys(
    ("_vminor", "_spindle_css_mode", "_remap_level", "_task", *(f"_{where}{letter}" for letter in "abcuvw" for where in ("", "abs_"))), 0.0
)
"""Parameters that never change; the language is that of LinuxCNC 2.9."""
_PLANES = {"XY": 170.0, "ZX": 180.0, "YZ": 190.0}


def own_names(state: ModalState, line: Callable[[], int]) -> Mapping[str, Callable[[], float]]:
    """Return the parameters of the interpreter, such as #<_metric>, as functions; `line` returns the current line number."""
    parameters = state.parameters
    names: dict[str, Callable[[], float]] = {
        "_line": lambda: float(line()),
        "_motion_mode": lambda: 800.0 if state.motion is None else float(state.motion),
        "_plane": lambda: _PLANES[state.plane],
        "_metric": lambda: float(state.millimetres),
        "_imperial": lambda: float(not state.millimetres),
        "_absolute": lambda: float(state.absolute),
        "_incremental": lambda: float(not state.absolute),
        "_inverse_time": lambda: float(state.feed_mode == "inverse_time"),
        "_units_per_minute": lambda: float(state.feed_mode == "per_minute"),
        "_units_per_rev": lambda: float(state.feed_mode == "per_turn"),
        "_coord_system": lambda: float(SYSTEMS[int(parameters.number(SELECTED_SYSTEM)) - 1]),
        "_tool_offset": lambda: float(any(state.frame.tool)),
        "_retract_r_plane": lambda: float(state.back_to_clearance),
        "_retract_old_z": lambda: float(not state.back_to_clearance),
        "_ijk_absolute_mode": lambda: float(state.absolute_centre),
        "_lathe_diameter_mode": lambda: float(state.diameter),
        "_lathe_radius_mode": lambda: float(not state.diameter),
        "_spindle_on": lambda: float(state.turning != 0),
        "_spindle_cw": lambda: float(state.turning == 1),
        "_feed": lambda: state.shown(state.feedrate) * (1.0 if state.feed_mode == "per_turn" else 60.0),
        "_rpm": lambda: state.speed,
        "_current_tool": lambda: float(state.tools.current),
        "_selected_tool": lambda: float(state.tools.selected),
        "_value": lambda: parameters.returned or 0.0,
        "_value_returned": lambda: float(parameters.returned is not None),
        "_call_level": lambda: float(parameters.depth),
    }
    for axis, letter in enumerate("xyz"):
        names[f"_{letter}"] = lambda axis=axis: state.shown_position()[axis]  # type: ignore[misc]  # the default binds it
        names[f"_abs_{letter}"] = lambda axis=axis: state.shown(state.axes[axis])  # type: ignore[misc]
    return names | {name: lambda value=value: value for name, value in _FIXED.items()}
