"""Part programs: read G-code (RS274/NGC as LinuxCNC reads it) into moves in SI units with their source lines.

`block` reads a line into words with columns and codes by modal group, with `vocabulary`. `interpreter` executes a block
on the modal `state`, with `motions`, and makes `moves`. `flow` follows subprograms, loops and conditions. `reader` opens a
program and handles its frame and its dialect. Unsupported codes are refused, never skipped.
"""

from contourlab.program.moves import Arc, Dwell, Feed, Mode, Move, Plane, Point, Program, Spline, Traverse
from contourlab.program.reader import Reader, Reading, open_program, parse_program, read_program

__all__ = [
    "Arc",
    "Dwell",
    "Feed",
    "Mode",
    "Move",
    "Plane",
    "Point",
    "Program",
    "Reader",
    "Reading",
    "Spline",
    "Traverse",
    "open_program",
    "parse_program",
    "read_program",
]
