"""Part programs: G-code (RS274/NGC as LinuxCNC means it) in, moves in SI with their source lines out.

Inside: `lexer` (words with columns) -> `block` (codes by modal group) -> `interpreter` (order of execution on the
modal `state`, `arcs`) -> `moves`; `reader` frames it all. What is not supported yet is refused, never skipped.
"""

from contourlab.program.moves import PLANE_AXES, Arc, Dwell, Event, Feed, Move, Plane, Point, Program, Traverse
from contourlab.program.reader import iter_moves, parse_program, read_program

__all__ = [
    "PLANE_AXES",
    "Arc",
    "Dwell",
    "Event",
    "Feed",
    "Move",
    "Plane",
    "Point",
    "Program",
    "Traverse",
    "iter_moves",
    "parse_program",
    "read_program",
]
