"""A program scaled and moved: how a part is brought into the travel of a machine."""

from __future__ import annotations

import math
from dataclasses import replace

from contourlab.errors import ProgramError
from contourlab.program.moves import Arc, Dwell, Move, Point, Program, Spline


def placed(program: Program, scale: float, shift: Point) -> Program:
    """Return a program with every point p of its moves at ``scale * p + shift``.

    Parameters
    ----------
    program : Program
    scale : float, > 0
    shift : (x, y, z) [m]

    Returns
    -------
    Program
        With the feedrates as they were: what is scaled is the part.

    Raises
    ------
    ProgramError
        If the scale is not positive, or a number is not finite.
    """
    if not (scale > 0.0 and all(map(math.isfinite, (scale, *shift)))):
        raise ProgramError(f"scale = {scale!r}, shift = {shift!r}: a finite scale > 0 and finite lengths are wanted", file=program.name)

    def there(point: Point) -> Point:
        x, y, z = (scale * value + offset for value, offset in zip(point, shift, strict=True))
        return (x, y, z)

    def moved(move: Move) -> Move:
        if isinstance(move, Dwell):
            return move
        if isinstance(move, Spline):
            return replace(move, points=tuple(there(point) for point in move.points))
        if isinstance(move, Arc):
            return replace(move, start=there(move.start), end=there(move.end), centre=there(move.centre))
        return replace(move, start=there(move.start), end=there(move.end))

    return replace(program, moves=tuple(moved(move) for move in program.moves))
