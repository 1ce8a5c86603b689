"""Part programs: G-code (RS274/NGC as LinuxCNC means it) in, moves in SI with their source lines out.

Inside: `lexer` (words with columns; `expressions`, `parameters`) -> `block` (codes by modal group, from `vocabulary`) -> `interpreter`
(order of execution on the modal `state`; `events`, `offsets` with `coordinates` and `tools`, `arcs`, `splines`, `cycles`) -> `moves`.
`flow` and `walker` lead from line to line through subprograms, loops and conditions; `reader` frames it all, `grbl` is the lenient
dialect, `files` has the ways in. What is not supported is refused, never skipped.
"""

from contourlab.program.files import iter_moves, open_program, parse_program, read_program
from contourlab.program.moves import PLANE_AXES, Arc, Dwell, Event, Feed, Mode, Move, Notice, Plane, Point, Program, Spline, Traverse
from contourlab.program.reader import Dialect, Reader, Reading
from contourlab.program.tools import Tools, read_tools

__all__ = [
    "PLANE_AXES",
    "Arc",
    "Dialect",
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
    "Tools",
    "Traverse",
    "iter_moves",
    "open_program",
    "parse_program",
    "read_program",
    "read_tools",
]
