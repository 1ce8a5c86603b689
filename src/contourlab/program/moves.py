"""What a part program means: moves as frozen values, in SI, each knowing the source line that it came from."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal, TypeAlias

__all__ = ["FULL_CIRCLE_BELOW", "PLANE_AXES", "Arc", "Dwell", "Event", "Feed", "Move", "Plane", "Point", "Program", "Traverse"]

Point: TypeAlias = tuple[float, float, float]
Plane: TypeAlias = Literal["XY", "YZ", "ZX"]

PLANE_AXES: dict[Plane, tuple[int, int, int]] = {"XY": (0, 1, 2), "YZ": (1, 2, 0), "ZX": (2, 0, 1)}
"""First axis, second axis and normal of each plane (0 = x, 1 = y, 2 = z); each triple is right-handed."""

FULL_CIRCLE_BELOW = 1e-6
"""Sweeps shorter than this [rad] mean a full circle: the end is the start, but for rounding."""


@dataclass(frozen=True, slots=True)
class Traverse:
    """Straight rapid move (G0).

    Parameters
    ----------
    start, end : (x, y, z) [m]
    source_line : int, >= 1
    """

    start: Point
    end: Point
    source_line: int


@dataclass(frozen=True, slots=True)
class Feed:
    """Straight move at a programmed feedrate (G1).

    Parameters
    ----------
    start, end : (x, y, z) [m]
    feedrate : float [m/s], > 0
    source_line : int, >= 1
    """

    start: Point
    end: Point
    feedrate: float
    source_line: int


@dataclass(frozen=True, slots=True)
class Arc:
    """Circular or helical move (G2, G3).

    Parameters
    ----------
    start, end : (x, y, z) [m]
        They differ along the plane's normal for a helix.
    centre : (x, y, z) [m]
        At the start's height.
    plane : {"XY", "YZ", "ZX"}
    turns : int, not 0
        > 0 counterclockwise seen from the tip of the plane's normal, < 0 clockwise; ``abs(turns) - 1`` whole
        circles come on top of the arc from start to end.
    feedrate : float [m/s], > 0
    source_line : int, >= 1

    Notes
    -----
    The radii at start and end may differ by the tolerance of the reader (see `contourlab.program.arcs`): decimals
    of a part program are rounded. Who needs a circle takes `radius` and lets the end be off by `radius_mismatch`.

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
        first, second, _ = self.axes
        angles = [math.atan2(point[second] - self.centre[second], point[first] - self.centre[first]) for point in (self.start, self.end)]
        sense = 1.0 if self.turns > 0 else -1.0
        once = (sense * (angles[1] - angles[0])) % (2.0 * math.pi)
        if once < FULL_CIRCLE_BELOW:
            once += 2.0 * math.pi
        return sense * (once + 2.0 * math.pi * (abs(self.turns) - 1))

    def _radius_to(self, point: Point) -> float:
        first, second, _ = self.axes
        return math.hypot(point[first] - self.centre[first], point[second] - self.centre[second])


@dataclass(frozen=True, slots=True)
class Dwell:
    """Standstill (G4).

    Parameters
    ----------
    seconds : float [s], > 0
    source_line : int, >= 1
    """

    seconds: float
    source_line: int


Move: TypeAlias = Traverse | Feed | Arc | Dwell


@dataclass(frozen=True, slots=True)
class Event:
    """What a program asks for besides motion: spindle, tool, coolant, overrides, pauses.

    Parameters
    ----------
    word : str
        ``"S"``, ``"T"``, or an M-code such as ``"M3"``.
    value : float or None
        Number of S (turns per minute) and T, the P of M50 to M53; None where there is none.
    source_line : int, >= 1
    """

    word: str
    value: float | None
    source_line: int


@dataclass(frozen=True)
class Program:
    """A part program that has been read: at least one move other than a dwell, in the order of execution.

    Parameters
    ----------
    name : str
        The file's name, for people.
    moves : tuple of Move
        Each starts where the one before it ended; the first starts at machine zero (0, 0, 0).
    lines : tuple of str
        The source text; a move came from ``lines[move.source_line - 1]``.
    events : tuple of Event
        Spindle, tool, coolant and the like, in the order of execution; they take no time.
    """

    name: str
    moves: tuple[Move, ...]
    lines: tuple[str, ...] = field(repr=False)
    events: tuple[Event, ...] = ()

    @cached_property
    def used_axes(self) -> tuple[str, ...]:
        """Those of ``"x"``, ``"y"``, ``"z"`` that ever move, in this order.

        >>> Program("p", (Traverse((0.0, 0.0, 0.0), (0.0, 0.01, 0.0), 1),), ("G0 Y10",)).used_axes
        ('y',)
        """
        used: set[int] = set()
        for move in self.moves:
            if isinstance(move, Dwell):
                continue
            if isinstance(move, Arc):
                used.update(move.axes[:2])
            used.update(i for i in range(3) if move.start[i] != move.end[i])
            if len(used) == 3:
                break
        return tuple("xyz"[i] for i in sorted(used))
