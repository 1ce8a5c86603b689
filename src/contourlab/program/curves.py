"""Arcs and splines: turn the words of a G2, G3, G5, G5.1, G5.2 or G5.3 block into an `Arc` or a `Spline`.

Tolerances of arcs are those of LinuxCNC 2.9 (measured on its interpreter), in the units of the program:

- centre form (I, J, K): the radii at start and end may differ by up to 0.02 sqrt(2) mm or 0.002 sqrt(2) inch; or by
  up to 0.1 % of the greater radius, but at most 100 times these values;
- radius form (R): half the chord may exceed the radius by 0.00127 mm (50 millionths of an inch); the arc is then a
  semicircle;
- the radius is at least 0.00127 mm.

Splines lie in the XY plane: G5 (cubic), G5.1 (quadratic), and G5.2 with G5.3 (NURBS). I and J give a control point relative to the start, P
and Q relative to the end. A cubic without I and J continues the cubic before it. The NURBS of G5.2 begins at the tool. Its knots are evenly
spaced and clamped; its order (degree + 1) is L, by default 3. G5 and G5.1 apply to their own block only, as in LinuxCNC 2.9.
"""

from __future__ import annotations

import math

from contourlab.program.block import Block, Word
from contourlab.program.moves import PLANE_AXES, Arc, Move, Point, Spline
from contourlab.program.state import Curve, ModalState
from contourlab.program.vocabulary import BlockError

RADIUS_TOLERANCE = 50e-6 * 0.0254
"""Smallest radius [m], and largest amount by which R may be too small [m]."""
SPIRAL_INCH, SPIRAL_MILLIMETRE = 0.002 * math.sqrt(2.0) * 0.0254, 0.02 * math.sqrt(2.0) * 1e-3
"""Allowed difference of the radii at start and end [m]."""
SPIRAL_RELATIVE = 1e-3
"""Allowed difference relative to the greater radius, up to 100 times the bounds above."""
LARGEST_RADIUS = 1e4
"""Larger radii [m] are mistakes, and too large for double precision."""
SHORTEST_HALF_CHORD = 1e-9
"""Half the distance of the ends of an arc [m] below which they are one point, up to rounding."""
MOST_TURNS = 10_000

_Vector = tuple[float, float]


def make_arc(block: Block, state: ModalState, end: Point, line: int) -> Arc:
    """Build the arc of a G2 or G3 block from the programmed position to `end`.

    Raises
    ------
    BlockError
        If the words define no arc, or more than one.
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
    turns = words["P"].whole(1, MOST_TURNS, "the number of turns", 0.0) if "P" in words else 1
    return Arc(
        state.reached,
        frame.axes(end),
        frame.axes((middle[0], middle[1], middle[2])),
        state.plane,
        -turns if clockwise else turns,
        0.0 if state.feed_mode == "inverse_time" else state.path_feedrate(block.column, "G2" if clockwise else "G3"),
        line,
        state.mode,
        0.0 if state.plane == "XY" else frame.rotation,
    )


def _check_words(block: Block, state: ModalState) -> None:
    words, (first, second, normal) = block.words, PLANE_AXES[state.plane]
    plane = f"{state.plane} plane"
    if "IJK"[normal] in words:
        stray = words["IJK"[normal]]
        raise BlockError(f"{stray.letter} has no meaning for an arc in the {plane}: delete it", stray.column)
    offsets = "IJK"[first], "IJK"[second]
    given = [letter for letter in offsets if letter in words]
    if "R" in words:
        if given:
            raise BlockError(f"the arc has both R and {given[0]}: give either the radius or the centre", words["R"].column)
        if not words.keys() & {"XYZ"[first], "XYZ"[second], "@", "^"}:
            ends = f"{'XYZ'[first]} or {'XYZ'[second]}"
            raise BlockError(f"an arc with R in the {plane} needs {ends}: write one; a full circle needs its centre", words["R"].column)
    elif not given:
        name = "G2" if state.motion == 20 else "G3"
        raise BlockError(f"{name} has neither centre nor radius: give {offsets[0]} and {offsets[1]}, or R", block.column)
    elif state.absolute_centre and len(given) == 1:
        raise BlockError(f"with G90.1 an arc needs both {offsets[0]} and {offsets[1]}: write the missing one", words[given[0]].column)


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
        raise BlockError(f"the arc has no radius: its centre is its {at} point; correct the centre", column)
    _check_radius(max(radius, radius_end), column)
    gap, allowed = abs(radius - radius_end), SPIRAL_MILLIMETRE if state.millimetres else SPIRAL_INCH
    if gap > 100.0 * allowed or (gap > allowed and gap > SPIRAL_RELATIVE * max(radius, radius_end)):
        radii = f"{_show(radius, state)} at the arc's start but {_show(radius_end, state)} at its end"
        raise BlockError(f"the radius is {radii}: correct the centre or the end point", column)
    return centre


def _centre_of_radius(word: Word, state: ModalState, here: _Vector, there: _Vector, clockwise: bool) -> _Vector:
    """Return the centre in the plane from R: on the bisector of the chord, on the side given by the sign of R."""
    radius = abs(state.length(word.value))
    chord = (there[0] - here[0], there[1] - here[1])
    half = 0.5 * math.hypot(*chord)
    if radius < RADIUS_TOLERANCE:
        raise BlockError("the arc has no radius: R must not be 0", word.column)
    _check_radius(radius, word.column)
    if half < SHORTEST_HALF_CHORD:
        raise BlockError("an arc with R cannot end where it starts: for a full circle, give its centre (I, J, K)", word.column)
    if half - radius > RADIUS_TOLERANCE:
        why = f"cannot reach the end point, because half the chord is {_show(half, state)}"
        raise BlockError(f"R = {_show(radius, state)} {why}: make R larger or correct the end point", word.column)
    # In a semicircle with rounded decimals, R differs slightly from half the chord; the root of this difference would move the centre far.
    height = 0.0 if half > radius * (1.0 - 1e-12) else math.sqrt((radius - half) * (radius + half))
    # The centre of a counterclockwise arc of less than half a turn lies to the left of its chord.
    left = height / (2.0 * half) if clockwise == (word.value < 0.0) else -height / (2.0 * half)
    return (0.5 * (here[0] + there[0]) - left * chord[1], 0.5 * (here[1] + there[1]) + left * chord[0])


def _check_radius(radius: float, column: int) -> None:
    if radius > LARGEST_RADIUS:
        raise BlockError(f"the arc's radius is {radius:g} m: keep it below {LARGEST_RADIUS:g} m, or write a straight line", column)


def _show(length: float, state: ModalState) -> str:
    """Write a length in program units."""
    return f"{state.shown(length):.6g} {'mm' if state.millimetres else 'in'}"


MOST_POINTS = 100_000
LARGEST_ORDER = 10


def bezier(block: Block, state: ModalState, line: int) -> list[Move]:
    """Make a cubic (G5) or quadratic (G5.1) spline of one segment.

    Raises
    ------
    BlockError
        If words are missing.
    """
    words, cubic, column = block.words, state.motion == 50, block.column
    name = "G5" if cubic else "G5.1"
    feedrate = state.path_feedrate(column, name)
    _check_plane(block, state, name)
    given = [letter in words for letter in "IJ"]
    if any(given) != all(given):
        cure = "write both" + (", or neither to continue the previous G5" if cubic else "")
        raise BlockError(f"{name} needs both I and J: {cure}", column)
    away = (state.length(words["I"].value), state.length(words["J"].value)) if all(given) else state.tangent if cubic else None
    if away is None:
        cure = "write both" + ("; only a G5 directly after another G5 can omit them" if cubic else "")
        raise BlockError(f"{name} has no I and J: {cure}", column)
    start, end = state.position, state.target(words)
    points = [start, (start[0] + away[0], start[1] + away[1], start[2])]
    state.tangent = None
    if cubic:
        if "P" not in words or "Q" not in words:
            raise BlockError("G5 needs both P and Q: write the second control point, relative to the end", column)
        p, q = state.length(words["P"].value), state.length(words["Q"].value)
        points.append((end[0] + p, end[1] + q, end[2]))
        state.tangent = (-p, -q)
    points.append(end)
    return _spline(state, points, [1.0] * len(points), len(points) - 1, feedrate, line, column)


def _check_plane(block: Block, state: ModalState, name: str) -> None:
    if state.plane != "XY":
        raise BlockError(f"{name} needs the XY plane: write G17 before it", block.column)
    if "Z" in block.words:
        raise BlockError(f"{name} stays in the XY plane: delete Z", block.words["Z"].column)


def add_control_point(block: Block, state: ModalState) -> None:
    """Add the control point of a G5.2 block.

    Raises
    ------
    BlockError
        If a coordinate or a weight is missing.
    """
    words, curve, column = block.words, state.curve, block.column
    state.path_feedrate(column, "G5.2")
    _check_plane(block, state, "G5.2")
    if ("X" in words) != ("Y" in words):
        raise BlockError("a control point of G5.2 needs both X and Y: write the missing one", column)
    weight, fresh, point = words["P"].value if "P" in words else None, not curve.points, "X" in words
    if not (fresh or point):
        raise BlockError("a control point of G5.2 needs X and Y: write them", column)
    if (weight is None and point) or (weight is not None and weight <= 0.0):
        raise BlockError("each control point of G5.2 needs a weight P greater than 0: write for example P1", column)
    if fresh:
        # The first control point is the tool position; a P without X and Y is its weight.
        curve.order = 3
        curve.points.append(state.position[:2])
        curve.weights.append(1.0 if point or weight is None else weight)
    if "L" in words:
        curve.order = max(words["L"].whole(2, LARGEST_ORDER, "the order of a NURBS", 0.0), 3)
    if point and weight is not None:
        curve.points.append(state.target(words)[:2])
        curve.weights.append(weight)
    if len(curve.points) > MOST_POINTS:
        raise BlockError(f"the NURBS has more than {MOST_POINTS} control points: close it with G5.3", column)


def close_curve(block: Block, state: ModalState, line: int) -> list[Move]:
    """Make the NURBS of the preceding G5.2 blocks (G5.3).

    Raises
    ------
    BlockError
        If there are no control points, or too few for the order.
    """
    curve, column = state.curve, block.codes["other"].column
    if not curve.points:
        raise BlockError("G5.3 has no G5.2 before it: write the control points with G5.2 first", column)
    if len(curve.points) < curve.order:
        count = f"at least {curve.order} control points, but has {len(curve.points)}"
        raise BlockError(f"a NURBS of order {curve.order} needs {count}: write more, or a smaller L", column)
    points: list[Point] = [(u, v, state.position[2]) for u, v in curve.points]
    state.curve, state.motion = Curve(), None
    return _spline(state, points, curve.weights, curve.order - 1, state.path_feedrate(column, "G5.3"), line, column)


def _spline(
    state: ModalState, points: list[Point], weights: list[float], degree: int, feedrate: float, line: int, column: int
) -> list[Move]:
    if all(point == points[0] for point in points):
        raise BlockError("all control points of the spline are the same: correct them, or delete the spline", column)
    axes = [state.frame.axes(point) for point in points]
    axes[0] = state.reached
    state.position, state.reached = points[-1], axes[-1]
    inner = len(points) - degree - 1
    knots = [0.0] * (degree + 1) + [float(i + 1) for i in range(inner)] + [float(inner + 1)] * (degree + 1)
    state.made += 1
    return [Spline(degree, tuple(axes), tuple(weights), tuple(knots), feedrate, line, state.mode)]
