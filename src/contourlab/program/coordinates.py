"""Coordinate systems: from the points of a program to the positions of the axes, and back.

    axes = origin + R(rotation) (point + shift) + tool

origin and rotation belong to the work coordinate system in force (G54 to G59.3), shift is that of G92 and G52, tool the offset of G43.
R turns about the Z axis. The numbers stand in the parameters #5201 and on, in mm and degrees, as LinuxCNC keeps them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from contourlab.program.moves import Point
from contourlab.program.parameters import Parameters

ORIGIN: Point = (0.0, 0.0, 0.0)
SHIFT_APPLIED = 5210
_FIRST_OF_SYSTEM = 5201
_PER_SYSTEM = 20
_ROTATION = 9


@dataclass(slots=True)
class Frame:
    """The offsets in force.

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
        """Note whether all offsets are zero, which saves most programs the arithmetic; to be called after every change."""
        self.plain = self.rotation == 0.0 and self.origin == self.shift == self.tool == ORIGIN

    def axes(self, point: Point) -> Point:
        """Return the position of the axes [m] of a point of the program."""
        if self.plain:
            return point
        return add(add(turn(add(point, self.shift), self.rotation), self.origin), self.tool)

    def point(self, axes: Point) -> Point:
        """Return the point of the program at a position of the axes [m]."""
        if self.plain:
            return axes
        return less(turn(less(less(axes, self.tool), self.origin), -self.rotation), self.shift)


def add(a: Point, b: Point) -> Point:
    """Return a + b."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def less(a: Point, b: Point) -> Point:
    """Return a - b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def turn(point: Point, degrees: float) -> Point:
    """Return a point turned about the Z axis."""
    if degrees == 0.0:
        return point
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return (point[0] * c - point[1] * s, point[0] * s + point[1] * c, point[2])


def _first(system: int) -> int:
    return _FIRST_OF_SYSTEM + _PER_SYSTEM * system


def origin_of(parameters: Parameters, system: int) -> tuple[Point, float]:
    """Return origin [m] and rotation [degrees] of a work coordinate system, 1 to 9."""
    first = _first(system)
    x, y, z = (parameters.number(first + axis) / 1000.0 for axis in range(3))
    return (x, y, z), parameters.number(first + _ROTATION)


def store_origin(parameters: Parameters, system: int, origin: Point, rotation: float) -> None:
    """Set origin [m] and rotation [degrees] of a work coordinate system."""
    first = _first(system)
    for axis in range(3):
        parameters.write(first + axis, origin[axis] * 1000.0)
    parameters.write(first + _ROTATION, rotation)


def load_shift(parameters: Parameters) -> Point:
    """Return the kept shift of G92 [m]."""
    x, y, z = (parameters.number(SHIFT_APPLIED + 1 + axis) / 1000.0 for axis in range(3))
    return (x, y, z)


def store_shift(parameters: Parameters, shift: Point, applied: bool) -> None:
    """Keep the shift of G92 [m], and whether it is in force."""
    parameters.write(SHIFT_APPLIED, float(applied))
    for axis in range(3):
        parameters.write(SHIFT_APPLIED + 1 + axis, shift[axis] * 1000.0)
