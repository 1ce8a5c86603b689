"""Part programs: G-code (RS274/NGC as LinuxCNC means it) in, moves in SI with their source lines out.

Inside: `block` (words with columns, codes by modal group; `expressions`, `parameters`, `vocabulary`) -> `interpreter` (order of execution
on the modal `state`; `offsets` with `coordinates`, `curves`, `cycles`) -> `moves`. `flow` and `walker` lead from line to line through
subprograms, loops and conditions. `reader` frames the program and knows the dialects; `files` opens it. What is not supported is refused,
never skipped.
"""

from contourlab.program.files import iter_moves, open_program, parse_program, read_program
from contourlab.program.moves import PLANE_AXES, Arc, Dwell, Event, Feed, Mode, Move, Notice, Plane, Point, Program, Spline, Traverse
from contourlab.program.reader import Reader, Reading

__all__ = [
    "PLANE_AXES",
    "Arc",
    "Dwell",
    "Event",
    "Feed",
    "Mode",
    "Move",
    "Notice",
    "Plane",
    "Point",
    "Program",
    "Reader",
    "Reading",
    "Spline",
    "Traverse",
    "iter_moves",
    "open_program",
    "parse_program",
    "read_program",
]
