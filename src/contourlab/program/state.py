"""The modal state of the interpreter, and one handler for each modal group of G-codes that only set it."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from contourlab.program.fault import BlockError
from contourlab.program.lexer import Word
from contourlab.program.moves import Plane, Point

__all__ = ["LARGEST_LENGTH", "SETTERS", "ModalState"]

LARGEST_LENGTH = 1e3
"""Coordinates beyond this [m] are a slip."""

_PLANES: dict[int, Plane] = {170: "XY", 180: "ZX", 190: "YZ"}


@dataclass(slots=True)
class ModalState:
    """What earlier blocks left behind; the defaults hold at the start of a program.

    Parameters
    ----------
    position : (x, y, z) [m]
        The programmed point.
    reached : (x, y, z) [m]
        Where the last move ended; differs from `position` by moves too short to be made.
    motion : int or None
        G-code of the modal motion, times ten.
    feedrate : float [m/s]
        0 = not set yet.
    """

    position: Point = (0.0, 0.0, 0.0)
    reached: Point = (0.0, 0.0, 0.0)
    motion: int | None = None
    plane: Plane = "XY"
    millimetres: bool = True
    absolute: bool = True
    absolute_centre: bool = False
    feedrate: float = 0.0

    def length(self, value: float) -> float:
        """Convert a length in program units to metres; division keeps decimals exact to the last bit."""
        return value / 1000.0 if self.millimetres else value * 0.0254

    def shown_position(self) -> Point:
        """Return the programmed point in the units in force, as #5420 to #5422 have it."""
        scale = 1000.0 if self.millimetres else 1.0 / 0.0254
        x, y, z = self.position
        return (x * scale, y * scale, z * scale)

    def target(self, words: dict[str, Word]) -> Point:
        """Return the end point [m] that the axis words of a block ask for."""
        point = list(self.position)
        if "@" in words or "^" in words:
            point[:2] = self._polar(words)
        for axis, letter in enumerate("XYZ"):
            word = words.get(letter)
            if word is not None:
                value = self.length(word.value)
                point[axis] = value if self.absolute else point[axis] + value
            if abs(point[axis]) > LARGEST_LENGTH:
                raise BlockError(
                    f"{letter} would go to {point[axis]:g} m: no machine is so large, keep to {LARGEST_LENGTH:g} m",
                    (word or next(iter(words.values()))).column,
                )
        return (point[0], point[1], point[2])

    def _polar(self, words: dict[str, Word]) -> tuple[float, float]:
        """Return x and y [m] of a distance @ from the origin and an angle ^ from the x axis, in degrees; what is not given stays."""
        far, turn = words.get("@"), words.get("^")
        column = (far or words["^"]).column
        for letter in "XY":
            if letter in words:
                raise BlockError(f"@ or ^ and {letter} in one block: give polar coordinates, or X and Y", words[letter].column)
        x, y, _ = self.position
        radius, angle = math.hypot(x, y), math.atan2(y, x)
        if radius == 0.0 and (not self.absolute or turn is None):
            cure = "write ^ too" if self.absolute else "leave it by X or Y first, or write G90"
            raise BlockError(f"at the origin there is no angle to go by: {cure}", column)
        if self.absolute:
            radius = radius if far is None else self.length(far.value)
            angle = angle if turn is None else math.radians(turn.value)
        else:
            radius += 0.0 if far is None else self.length(far.value)
            angle += 0.0 if turn is None else math.radians(turn.value)
            if radius == 0.0:
                raise BlockError("a polar step with G91 that ends at the origin leaves no angle to go on by: write X0 Y0 with G90", column)
        return (radius * math.cos(angle), radius * math.sin(angle))


def _set_plane(state: ModalState, code: int) -> None:
    state.plane = _PLANES[code]


def _set_units(state: ModalState, code: int) -> None:
    state.millimetres = code == 210


def _set_distance(state: ModalState, code: int) -> None:
    state.absolute = code == 900


def _set_arc_distance(state: ModalState, code: int) -> None:
    state.absolute_centre = code == 901


SETTERS: dict[str, Callable[[ModalState, int], None]] = {
    "plane": _set_plane,
    "units": _set_units,
    "distance": _set_distance,
    "arc_distance": _set_arc_distance,
}
"""Groups that only set the state, in the order in which RS274/NGC executes them within a block.

The feed mode is set before the feedrate, thus not here.
"""
