"""Circles and helices: from the words of a G2 or G3 block to an `Arc`.

Tolerances are those of LinuxCNC 2.9 (measured on its interpreter), in the units of the program:

- centre form (I, J, K): the radii at start and end may differ by up to 0.02 sqrt(2) mm or 0.002 sqrt(2) inch; or by
  up to 0.1 % of the greater one, as long as this is less than 100 times as much;
- radius form (R): half the chord may exceed the radius by 0.00127 mm (50 millionths of an inch); the arc is then a
  semicircle;
- a radius below 0.00127 mm is no arc.
"""

from __future__ import annotations

import math

from contourlab.program.block import Block
from contourlab.program.fault import BlockError
from contourlab.program.lexer import Word
from contourlab.program.moves import PLANE_AXES, Arc, Point
from contourlab.program.state import ModalState

RADIUS_TOLERANCE = 50e-6 * 0.0254
"""Least radius, and most that an R may be too small [m]."""
SPIRAL_INCH, SPIRAL_MILLIMETRE = 0.002 * math.sqrt(2.0) * 0.0254, 0.02 * math.sqrt(2.0) * 1e-3
"""How far the radii at start and end may always differ [m]."""
SPIRAL_RELATIVE = 1e-3
"""How far they may differ, of the greater one, up to 100 times the bounds above."""
LARGEST_RADIUS = 1e4
"""Radii beyond this [m] are a slip, and too blunt for the precision of the numbers."""
SHORTEST_HALF_CHORD = 1e-9
"""Ends of an arc that are nearer to each other [m] are one point, but for rounding."""
MOST_TURNS = 10_000

_Vector = tuple[float, float]


def make_arc(block: Block, state: ModalState, end: Point, line: int) -> Arc:
    """Build the arc of a G2 or G3 block from the programmed position to `end`.

    Raises
    ------
    BlockError
        If the words leave no arc, or more than one.
    """
    words = block.words
    first, second, _ = PLANE_AXES[state.plane]
    frame, start = state.frame, state.position
    here, there = (start[first], start[second]), (end[first], end[second])
    clockwise = state.motion == 20
    _check_words(block, state)
    centre = _centre_of_radius(words["R"], state, here, there, clockwise) if "R" in words else _centre_of_offsets(block, state, here, there)
    middle = list(start)
    middle[first], middle[second] = centre
    turns = _turns(words.get("P"))
    return Arc(
        state.reached,
        frame.axes(end),
        frame.axes((middle[0], middle[1], middle[2])),
        state.plane,
        -turns if clockwise else turns,
        0.0 if state.feed_mode == "inverse_time" else state.path_feedrate(_column(block), "G2" if clockwise else "G3"),
        line,
        state.mode,
        0.0 if state.plane == "XY" else frame.rotation,
    )


def _column(block: Block) -> int:
    return block.codes["motion"].column if "motion" in block.codes else next(iter(block.words.values())).column


def _check_words(block: Block, state: ModalState) -> None:
    words, (first, second, normal) = block.words, PLANE_AXES[state.plane]
    name, plane = "G2" if state.motion == 20 else "G3", f"{state.plane} plane"
    column = _column(block)
    if "IJK"[normal] in words:
        stray = words["IJK"[normal]]
        raise BlockError(f"{stray.letter} has no meaning for an arc in the {plane}: delete it", stray.column)
    offsets = "IJK"[first], "IJK"[second]
    given = [letter for letter in offsets if letter in words]
    if "R" in words:
        if given:
            raise BlockError(f"R and {given[0]} in one block: give either radius or centre", words["R"].column)
        if not words.keys() & {"XYZ"[first], "XYZ"[second], "@", "^"}:
            raise BlockError(
                f"an arc with R in the {plane} needs {'XYZ'[first]} or {'XYZ'[second]}: give the end point, "
                f"or write a full circle with {offsets[0]} and {offsets[1]}",
                words["R"].column,
            )
    elif not given:
        raise BlockError(f"{name} has neither centre nor radius: give {offsets[0]} and {offsets[1]}, or R", column)
    elif state.absolute_centre and len(given) == 1:
        missing = offsets[1] if given[0] == offsets[0] else offsets[0]
        cure = f"with G90.1 an arc needs both {offsets[0]} and {offsets[1]}"
        raise BlockError(f"{missing} is missing: {cure}", words[given[0]].column)


def _centre_of_offsets(block: Block, state: ModalState, here: _Vector, there: _Vector) -> _Vector:
    """Return the centre in the plane from I, J, K; `here` and `there` are the start and end in the plane."""
    first, second, _ = PLANE_AXES[state.plane]
    offsets = [block.words.get("IJK"[axis]) for axis in (first, second)]
    u, v = (0.0 if word is None else state.length(word.value) for word in offsets)
    centre = (u, v) if state.absolute_centre else (here[0] + u, here[1] + v)
    column = min(word.column for word in offsets if word is not None)
    radius = math.hypot(here[0] - centre[0], here[1] - centre[1])
    radius_end = math.hypot(there[0] - centre[0], there[1] - centre[1])
    if min(radius, radius_end) < RADIUS_TOLERANCE:
        at = "start" if radius < RADIUS_TOLERANCE else "end"
        raise BlockError(f"an arc of no radius: the centre is the arc's {at} point, correct the centre", column)
    _check_radius(max(radius, radius_end), column)
    gap, allowed = abs(radius - radius_end), SPIRAL_MILLIMETRE if state.millimetres else SPIRAL_INCH
    if gap > 100.0 * allowed or (gap > allowed and gap > SPIRAL_RELATIVE * max(radius, radius_end)):
        raise BlockError(
            f"the radius is {_shown(radius, state)} at the arc's start but {_shown(radius_end, state)} at its end: "
            "correct the centre or the end point",
            column,
        )
    return centre


def _centre_of_radius(word: Word, state: ModalState, here: _Vector, there: _Vector, clockwise: bool) -> _Vector:
    """Return the centre in the plane from R: on the bisector of the chord, on the side that R's sign asks for."""
    radius = abs(state.length(word.value))
    chord = (there[0] - here[0], there[1] - here[1])
    half = 0.5 * math.hypot(*chord)
    if radius < RADIUS_TOLERANCE:
        raise BlockError("an arc of no radius: R must not be zero", word.column)
    _check_radius(radius, word.column)
    if half < SHORTEST_HALF_CHORD:
        cure = "write a full circle with its centre (I, J, K)"
        raise BlockError(f"an arc with R cannot end where it starts: {cure}", word.column)
    if half - radius > RADIUS_TOLERANCE:
        raise BlockError(
            f"R = {_shown(radius, state)} cannot reach the end point, half the chord is {_shown(half, state)}: "
            "make R larger or correct the end point",
            word.column,
        )
    # Rounded decimals of a semicircle leave R a hair off half the chord, whose root would throw the centre far aside.
    height = 0.0 if half > radius * (1.0 - 1e-12) else math.sqrt((radius - half) * (radius + half))
    # The centre of a counterclockwise arc of less than half a turn lies to the left of its chord.
    left = height / (2.0 * half) if clockwise == (word.value < 0.0) else -height / (2.0 * half)
    return (0.5 * (here[0] + there[0]) - left * chord[1], 0.5 * (here[1] + there[1]) + left * chord[0])


def _turns(word: Word | None) -> int:
    if word is None:
        return 1
    turns = round(word.value)
    if turns != word.value or not 1 <= turns <= MOST_TURNS:
        raise BlockError(f"P{word.value:g}: an arc takes a whole number of turns from 1 to {MOST_TURNS}", word.column)
    return turns


def _check_radius(radius: float, column: int) -> None:
    if radius > LARGEST_RADIUS:
        raise BlockError(f"a radius of {radius:g} m: keep below {LARGEST_RADIUS:g} m, or write a straight line", column)


def _shown(length: float, state: ModalState) -> str:
    """Write a length in the program's units."""
    return f"{length * 1000.0:.6g} mm" if state.millimetres else f"{length / 0.0254:.6g} in"
