"""Moves of a part program: frozen values in SI, each with its source line."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Literal, TypeAlias

Point: TypeAlias = tuple[float, float, float]
Plane: TypeAlias = Literal["XY", "YZ", "ZX"]
Control: TypeAlias = Literal["exact_path", "exact_stop", "blend"]

PLANE_AXES: dict[Plane, tuple[int, int, int]] = {"XY": (0, 1, 2), "YZ": (1, 2, 0), "ZX": (2, 0, 1)}
"""First axis, second axis and normal of each plane (0 = x, 1 = y, 2 = z); each triple is right-handed."""

FULL_CIRCLE_BELOW = 1e-6
"""Shorter sweeps [rad] mean a full circle: the end is the start, up to rounding."""


@dataclass(frozen=True, slots=True)
class Mode:
    """The active modes of a move.

    Parameters
    ----------
    control : {"exact_path", "exact_stop", "blend"} or None
        G61, G61.1, G64; None before the first of these codes.
    tolerance : float [m] or None
        P of G64: largest distance of the path from a corner; None without P.
    merge : float [m] or None
        Q of G64, by default P: largest deviation of joined lines.
    tool : (x, y, z) [m]
        Tool offset: the tool tip is at the axis positions minus this offset.
    """

    control: Control | None = None
    tolerance: float | None = None
    merge: float | None = None
    tool: Point = (0.0, 0.0, 0.0)


PLAIN = Mode()
"""The mode at the start of a program."""


@dataclass(frozen=True, slots=True)
class Traverse:
    """Straight rapid move (G0).

    Parameters
    ----------
    start, end : (x, y, z) [m]
        Positions of the axes.
    source_line : int, >= 1
    mode : Mode
    """

    start: Point
    end: Point
    source_line: int
    mode: Mode = PLAIN


@dataclass(frozen=True, slots=True)
class Feed:
    """Straight move at a programmed feedrate (G1).

    Parameters
    ----------
    start, end : (x, y, z) [m]
    feedrate : float [m/s], > 0
    source_line : int, >= 1
    mode : Mode
    """

    start: Point
    end: Point
    feedrate: float
    source_line: int
    mode: Mode = PLAIN


@dataclass(frozen=True, slots=True)
class Arc:
    """Circular or helical move (G2, G3).

    Parameters
    ----------
    start, end : (x, y, z) [m]
        For a helix they differ along the plane's normal.
    centre : (x, y, z) [m]
        At the start's height.
    plane : {"XY", "YZ", "ZX"}
    turns : int, not 0
        > 0 counterclockwise seen from the tip of the plane's normal, < 0 clockwise; ``abs(turns) - 1`` whole circles are added to
        the arc from start to end.
    feedrate : float [m/s], > 0
    source_line : int, >= 1
    mode : Mode
    turned : float [degrees]
        Rotation of the plane about the Z axis (work coordinate system); relevant for YZ and ZX only.

    Notes
    -----
    The radii at start and end may differ by the tolerance of the reader (see `contourlab.program.motions`), because decimals are rounded.
    For a true circle use `radius`; the end is then off by `radius_mismatch`.

    >>> quarter = Arc((0.01, 0.0, 0.0), (0.0, 0.01, 0.0), (0.0, 0.0, 0.0), "XY", 1, 0.025, 1)
    >>> round(quarter.sweep, 6)
    1.570796
    """

    start: Point
    end: Point
    centre: Point
    plane: Plane
    turns: int
    feedrate: float
    source_line: int
    mode: Mode = PLAIN
    turned: float = 0.0

    @property
    def axes(self) -> tuple[int, int, int]:
        """First axis, second axis and normal of the plane (0 = x, 1 = y, 2 = z)."""
        return PLANE_AXES[self.plane]

    @property
    def radius(self) -> float:
        """Distance of the start from the centre, in the plane [m]."""
        return self._radius_to(self.start)

    @property
    def radius_mismatch(self) -> float:
        """Radius at the end less the radius at the start [m]; 0 for a true arc."""
        return self._radius_to(self.end) - self.radius

    @property
    def sweep(self) -> float:
        """Angle travelled [rad], > 0 counterclockwise, < 0 clockwise; never 0."""
        angles = [math.atan2(second, first) for first, second in [self._spoke(point) for point in (self.start, self.end)]]
        sense = 1.0 if self.turns > 0 else -1.0
        once = (sense * (angles[1] - angles[0])) % (2.0 * math.pi)
        if once < FULL_CIRCLE_BELOW:
            once += 2.0 * math.pi
        return sense * (once + 2.0 * math.pi * (abs(self.turns) - 1))

    def directions(self) -> tuple[Point, Point, Point]:
        """Return the unit vectors of the plane's first axis, second axis and normal, in the machine's axes."""
        c, s = math.cos(math.radians(self.turned)), math.sin(math.radians(self.turned))
        units = ((c, s, 0.0), (-s, c, 0.0), (0.0, 0.0, 1.0)) if self.turned and self.plane != "XY" else _UNITS
        first, second, normal = self.axes
        return units[first], units[second], units[normal]

    def _radius_to(self, point: Point) -> float:
        return math.hypot(*self._spoke(point))

    def _spoke(self, point: Point) -> tuple[float, float]:
        """Return a point less the centre, in the plane."""
        spoke = (point[0] - self.centre[0], point[1] - self.centre[1], point[2] - self.centre[2])
        if not self.turned or self.plane == "XY":
            first, second, _ = self.axes
            return spoke[first], spoke[second]
        u, v, _ = self.directions()
        return (
            spoke[0] * u[0] + spoke[1] * u[1] + spoke[2] * u[2],
            spoke[0] * v[0] + spoke[1] * v[1] + spoke[2] * v[2],
        )


@dataclass(frozen=True, slots=True)
class Spline:
    """Rational or polynomial spline (G5, G5.1, G5.2 with G5.3), kept as a curve.

    Parameters
    ----------
    degree : int, >= 1
    points : tuple of (x, y, z) [m]
        Control points; the first is the start of the move, the last its end.
    weights : tuple of float, > 0
        One for each control point; all 1 where the spline is polynomial.
    knots : tuple of float
        ``len(points) + degree + 1`` knots, non-decreasing, clamped at both ends.
    feedrate : float [m/s], > 0
    source_line : int, >= 1
    mode : Mode
    """

    degree: int
    points: tuple[Point, ...]
    weights: tuple[float, ...]
    knots: tuple[float, ...]
    feedrate: float
    source_line: int
    mode: Mode = PLAIN

    @property
    def start(self) -> Point:
        """Where the move begins [m]."""
        return self.points[0]

    @property
    def end(self) -> Point:
        """Where the move ends [m]."""
        return self.points[-1]


@dataclass(frozen=True, slots=True)
class Dwell:
    """Standstill (G4).

    Parameters
    ----------
    seconds : float [s], >= 0
        0 only where the reader keeps moves of zero length.
    source_line : int, >= 1
    """

    seconds: float
    source_line: int


Move: TypeAlias = Traverse | Feed | Arc | Spline | Dwell

_WHILE_MOVING = frozenset(("S", "T", "M48", "M49", "M50", "M51", "M52", "M53", "M62", "M63", "M67"))
_UNITS = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


@dataclass(frozen=True, slots=True)
class Event:
    """A command besides motion: spindle, tool, coolant, override or pause.

    Parameters
    ----------
    word : str
        ``"S"``, ``"T"``, an M-code such as ``"M3"``, or ``"G4"`` for a dwell of 0 s.
    value : float or None
        Number of S [turns per minute] and T, the P of M50 to M53 and M62 to M65, the Q of M61, M67 and M68; None where there is none.
    source_line : int, >= 1
    index : float or None
        The E of M67 and M68: the number of the output.
    after : int, >= 0
        Number of moves before it.
    """

    word: str
    value: float | None
    source_line: int
    index: float | None = None
    after: int = 0

    @property
    def rests(self) -> bool:
        """Whether the machine stops for it: all but speeds, tool numbers, overrides, and outputs set during motion."""
        return self.word not in _WHILE_MOVING


@dataclass(frozen=True, slots=True)
class Notice:
    """A place where the reader was lenient.

    Parameters
    ----------
    message : str
    line, column : int, >= 1
    """

    message: str
    line: int
    column: int


@dataclass(frozen=True)
class Program:
    """A part program: at least one move other than a dwell, in the order of execution.

    Parameters
    ----------
    name : str
        The file's name.
    moves : tuple of Move
        Each starts where the one before it ended; the first starts at machine zero (0, 0, 0).
    lines : tuple of str
        The source text; a move came from ``lines[move.source_line - 1]``.
    events : tuple of Event
        Spindle, tool, coolant, overrides, outputs and pauses, in the order of execution; they take no time.
    notices : tuple of Notice
        Where the dialect was lenient.
    machine_points : tuple of (int, (x, y, z))
        Line and target of each G53 [m], nan for an axis that it does not name; lines of G28 and G30, whose home another file may hold.
    """

    name: str
    moves: tuple[Move, ...]
    lines: tuple[str, ...] = field(repr=False)
    events: tuple[Event, ...] = ()
    notices: tuple[Notice, ...] = ()
    machine_points: tuple[tuple[int, Point], ...] = field(default=(), repr=False)

    def __repr__(self) -> str:
        return f"Program(name: {self.name}; lines: {len(self.lines)}; moves: {len(self.moves)})"
