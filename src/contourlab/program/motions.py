"""Arcs, splines and canned cycles: turn the words of a block into moves.

Tolerances of arcs (G2, G3) are those of LinuxCNC 2.9 (measured on its interpreter), in the units of the program:

- centre form (I, J, K): the radii at start and end may differ by up to 0.02 sqrt(2) mm or 0.002 sqrt(2) inch; or by
  up to 0.1 % of the greater radius, but at most 100 times these values;
- radius form (R): half the chord may exceed the radius by 0.00127 mm (50 millionths of an inch); the arc is then a
  semicircle;
- the radius is at least 0.00127 mm.

Splines lie in the XY plane: G5 (cubic), G5.1 (quadratic), and G5.2 with G5.3 (NURBS). I and J give a control point relative to the start, P
and Q relative to the end. A cubic without I and J continues the cubic before it. The NURBS of G5.2 begins at the tool. Its knots are evenly
spaced and clamped; its order (degree + 1) is L, by default 3. G5 and G5.1 apply to their own block only, as in LinuxCNC 2.9.

Canned cycles are G73, G74 and G81 to G89, in the active plane, with L repeats, R, and G98 or G99. Depth, clearance (R) and level of a cycle
lie along the normal of the plane. The tool goes to each hole at the level or the clearance, then makes the strokes of the cycle. The path
is exact (G61), except for the first rise to the clearance, as in LinuxCNC.
"""

from __future__ import annotations

import math
from dataclasses import replace

from contourlab.errors import refuse
from contourlab.program.block import Block, Word
from contourlab.program.dialects import LINUXCNC
from contourlab.program.moves import PLANE_AXES, Arc, Move, Point, Spline
from contourlab.program.state import Curve, Cycle, ModalState
from contourlab.program.vocabulary import BlockError, g_name

RADIUS_TOLERANCE = LINUXCNC.radius_slack
"""Smallest radius [m]."""
SPIRAL_RELATIVE = 1e-3
"""Allowed difference of the radii at start and end relative to the greater one, up to 100 times that of the dialect."""
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
    if "IJK"[normal] in words and ("R" in words or not state.rules.stray_offsets):
        stray = words["IJK"[normal]]
        raise BlockError(f"CL811 {stray.letter} has no meaning for an arc in the {plane}: delete it", stray.column)
    offsets = "IJK"[first], "IJK"[second]
    given = [letter for letter in offsets if letter in words]
    if state.rules.plain_arcs and ("P" in words or not words.keys() & {"XYZ"[first], "XYZ"[second]}):
        ends = f"{'XYZ'[first]} or {'XYZ'[second]}"
        raise BlockError(f"CL820 an arc of grbl needs {ends}, and has no P (errors 26, 32, 36): write a block for each turn", block.column)
    if "R" in words:
        if given:
            raise BlockError(f"CL820 the arc has both R and {given[0]}: give either the radius or the centre", words["R"].column)
        if not words.keys() & {"XYZ"[first], "XYZ"[second], "@", "^"}:
            ends = f"{'XYZ'[first]} or {'XYZ'[second]}"
            raise BlockError(
                f"CL820 an arc with R in the {plane} needs {ends}: write one; a full circle needs its centre", words["R"].column
            )
    elif not given:
        name = "G2" if state.motion == 20 else "G3"
        raise BlockError(f"CL820 {name} has neither centre nor radius: give {offsets[0]} and {offsets[1]}, or R", block.column)
    elif state.absolute_centre and len(given) == 1:
        raise BlockError(f"CL820 with G90.1 an arc needs both {offsets[0]} and {offsets[1]}: write the missing one", words[given[0]].column)


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
        raise BlockError(f"CL823 the arc has no radius: its centre is its {at} point; correct the centre", column)
    _check_radius(max(radius, radius_end), column)
    gap, allowed = abs(radius - radius_end), state.rules.spiral[not state.millimetres]
    if gap > 100.0 * allowed or (gap > allowed and gap > SPIRAL_RELATIVE * max(radius, radius_end)):
        radii = f"{_show(radius, state)} at the arc's start but {_show(radius_end, state)} at its end"
        raise BlockError(f"CL821 the radius is {radii}: correct the centre or the end point", column)
    return centre


def _centre_of_radius(word: Word, state: ModalState, here: _Vector, there: _Vector, clockwise: bool) -> _Vector:
    """Return the centre in the plane from R: on the bisector of the chord, on the side given by the sign of R."""
    radius = abs(state.length(word.value))
    chord = (there[0] - here[0], there[1] - here[1])
    half = 0.5 * math.hypot(*chord)
    refuse(radius < RADIUS_TOLERANCE, BlockError, "CL823 the arc has no radius: R must not be 0", word.column)
    _check_radius(radius, word.column)
    if half < SHORTEST_HALF_CHORD:
        raise BlockError("CL822 an arc with R cannot end where it starts: for a full circle, give its centre (I, J, K)", word.column)
    if half - radius > state.rules.radius_slack:
        why = f"cannot reach the end point, because half the chord is {_show(half, state)}"
        raise BlockError(f"CL822 R = {_show(radius, state)} {why}: make R larger or correct the end point", word.column)
    # In a semicircle with rounded decimals, R differs slightly from half the chord; the root of this difference would move the centre far.
    height = 0.0 if half > radius * (1.0 - 1e-12) else math.sqrt((radius - half) * (radius + half))
    # The centre of a counterclockwise arc of less than half a turn lies to the left of its chord.
    left = height / (2.0 * half) if clockwise == (word.value < 0.0) else -height / (2.0 * half)
    return (0.5 * (here[0] + there[0]) - left * chord[1], 0.5 * (here[1] + there[1]) + left * chord[0])


def _check_radius(radius: float, column: int) -> None:
    if radius > LARGEST_RADIUS:
        raise BlockError(f"CL823 the arc's radius is {radius:g} m: keep it below {LARGEST_RADIUS:g} m, or write a straight line", column)


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
        raise BlockError(f"CL825 {name} needs both I and J: {cure}", column)
    away = (state.length(words["I"].value), state.length(words["J"].value)) if all(given) else state.tangent if cubic else None
    if away is None:
        cure = "write both" + ("; only a G5 directly after another G5 can omit them" if cubic else "")
        raise BlockError(f"CL825 {name} has no I and J: {cure}", column)
    start, end = state.position, state.target(words)
    points = [start, (start[0] + away[0], start[1] + away[1], start[2])]
    state.tangent = None
    if cubic:
        if "P" not in words or "Q" not in words:
            raise BlockError("CL825 G5 needs both P and Q: write the second control point, relative to the end", column)
        p, q = state.length(words["P"].value), state.length(words["Q"].value)
        points.append((end[0] + p, end[1] + q, end[2]))
        state.tangent = (-p, -q)
    points.append(end)
    return _spline(state, points, [1.0] * len(points), len(points) - 1, feedrate, line, column)


def _check_plane(block: Block, state: ModalState, name: str) -> None:
    refuse(state.plane != "XY", BlockError, f"CL816 {name} needs the XY plane: write G17 before it", block.column)
    if "Z" in block.words:
        raise BlockError(f"CL816 {name} stays in the XY plane: delete Z", block.words["Z"].column)


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
    refuse(("X" in words) != ("Y" in words), BlockError, "CL825 a control point of G5.2 needs both X and Y: write the missing one", column)
    weight, fresh, point = words["P"].value if "P" in words else None, not curve.points, "X" in words
    refuse(not (fresh or point), BlockError, "CL825 a control point of G5.2 needs X and Y: write them", column)
    if (weight is None and point) or (weight is not None and weight <= 0.0):
        raise BlockError("CL825 each control point of G5.2 needs a weight P greater than 0: write for example P1", column)
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
    refuse(
        len(curve.points) > MOST_POINTS,
        BlockError,
        f"CL826 the NURBS has more than {MOST_POINTS} control points: close it with G5.3",
        column,
    )


def close_curve(block: Block, state: ModalState, line: int) -> list[Move]:
    """Make the NURBS of the preceding G5.2 blocks (G5.3).

    Raises
    ------
    BlockError
        If there are no control points, or too few for the order.
    """
    curve, column = state.curve, block.codes["other"].column
    refuse(not curve.points, BlockError, "CL826 G5.3 has no G5.2 before it: write the control points with G5.2 first", column)
    if len(curve.points) < curve.order:
        count = f"at least {curve.order} control points, but has {len(curve.points)}"
        raise BlockError(f"CL826 a NURBS of order {curve.order} needs {count}: write more, or a smaller L", column)
    points: list[Point] = [(u, v, state.position[2]) for u, v in curve.points]
    state.curve, state.motion = Curve(), None
    return _spline(state, points, curve.weights, curve.order - 1, state.path_feedrate(column, "G5.3"), line, column)


def _spline(
    state: ModalState, points: list[Point], weights: list[float], degree: int, feedrate: float, line: int, column: int
) -> list[Move]:
    if all(point == points[0] for point in points):
        raise BlockError("CL825 all control points of the spline are the same: correct them, or delete the spline", column)
    axes = [state.frame.axes(point) for point in points]
    axes[0] = state.reached
    state.position, state.reached = points[-1], axes[-1]
    inner = len(points) - degree - 1
    knots = [0.0] * (degree + 1) + [float(i + 1) for i in range(inner)] + [float(inner + 1)] * (degree + 1)
    state.made += 1
    return [Spline(degree, tuple(axes), tuple(weights), tuple(knots), feedrate, line, state.mode)]


PECK_CLEARANCE = 0.010 * 0.0254
"""Distance above the last depth at which pecking resumes feed [m]."""
LEAST_STROKE = 1e-10
"""Strokes up to this length [m] are rounding errors; they are left out."""
MOST_REPEATS = 10_000
MOST_STROKES = 100_000
LONGEST_DWELL = 86_400.0
_DWELLING = (820, 860, 880, 890)
_TURNING = (740, 840, 860, 870, 880)
_PECKING = (730, 830)


def drill(block: Block, state: ModalState, line: int, *, again: bool) -> list[Move]:
    """Execute a canned cycle.

    Parameters
    ----------
    state : ModalState
        Its motion is the cycle.
    again : bool
        Whether the same cycle was active before: missing words then keep their values, unless the units have changed.

    Raises
    ------
    BlockError
        If a word is missing, the depth is above the clearance, or the spindle does not turn as needed.
    """
    mode = state.mode
    cycle = _Cycle(block, state, line, again)
    cycle.run()
    state.mode = mode
    return cycle.moves


class _Cycle:
    """One block of a canned cycle."""

    def __init__(self, block: Block, state: ModalState, line: int, again: bool) -> None:
        assert state.motion is not None  # the cycle
        # LinuxCNC reads stored numbers in the new units; here the program must write them again.
        again = again and state.cycle.millimetres == state.millimetres
        self.own = state.rules.own_cycles
        if self.own:
            # The data hold from cycle to cycle; whether those of G91 hold in G90 is not known.
            again = state.cycle.level is not None and (state.cycle.millimetres, state.cycle.absolute) == (state.millimetres, state.absolute)
            state.cycle = state.cycle if again else Cycle(level=state.cycle.level)
        state.cycle.millimetres, state.cycle.absolute = state.millimetres, state.absolute
        self.words, self.state, self.line, self.again = block.words, state, line, again
        self.code, self.name = state.motion, g_name(state.motion)
        self.column, self.axes = block.column, PLANE_AXES[state.plane]
        self.moves: list[Move] = []
        self.u, self.v = (state.position[axis] for axis in self.axes[:2])
        self.clearance = self.depth = self.back = 0.0
        if state.feed_mode == "inverse_time":
            raise BlockError(f"CL816 {self.name} cannot use inverse-time feed (G93): write G94 and F", self.column)
        self.feedrate = state.path_feedrate(self.column, self.name)

    def run(self) -> None:
        """Make the moves of all repeats."""
        here, level = self.state.position[self.axes[2]], self._read_levels()
        self._read_dwell_and_peck()
        bore = self._read_bore() if self.code == 870 else None
        if self.code in _TURNING:
            self._check_spindle()
        word = self.words.get("L") or (self.words.get("K") if self.own else None)
        repeats = 1 if word is None else word.whole(0 if self.own else 1, MOST_REPEATS, "the number of repeats")
        if repeats == 0:
            return
        if level < self.clearance:
            refuse(
                self.own, BlockError, "CL831 the tool stands below R, and a Fanuc goes to the hole first: raise it to R before", self.column
            )
            self._go(self.clearance)
            here = self.clearance
        self.state.mode = replace(self.state.mode, control="exact_path", tolerance=None, merge=None)
        if self.code in _PECKING and repeats * (self.clearance - self.depth) / self.state.cycle.peck > MOST_STROKES:
            raise BlockError(f"CL831 the peck Q of {self.name} needs more than {MOST_STROKES} strokes: make it larger", self.column)
        for repeat in range(repeats):
            self._next_hole()
            if repeat == 0 and here > self.clearance + LEAST_STROKE:
                self._go(here)
                self._go(self.clearance)
            else:
                self._go(self.back)
                if self.back > self.clearance:
                    self._go(self.clearance)
            if bore is not None:
                self._back_bore(*bore)
            elif self.code in _PECKING:
                self._peck()
            else:
                self._plain()
        self.state.position = self._point(self.back, (0.0, 0.0))
        self.state.check_reach(self.state.position, self.words)

    def _read_levels(self) -> float:
        """Set clearance, depth and return level; return the level before the first of consecutive cycles."""
        state, memory, normal = self.state, self.state.cycle, self.axes[2]
        letter = "XYZ"[normal]
        for wanted, what in ((letter, "depth"), ("R", "clearance")):
            refuse(wanted not in self.words and not self.again, BlockError, f"CL830 {self.name} has no {what}: write {wanted}", self.column)
        if letter in self.words:
            memory.depth = state.coordinate(normal, self.words[letter])
        if "R" in self.words:
            memory.clearance = state.length(self.words["R"].value)
        level = memory.level = state.position[normal] if memory.level is None else memory.level
        self.clearance = memory.clearance if state.absolute else memory.clearance + level
        if abs(level - self.clearance) < LEAST_STROKE:
            level = self.clearance
        self.depth = memory.depth if state.absolute else self.clearance + memory.depth
        if self.clearance < self.depth:
            raise BlockError(f"CL831 the clearance R is below the depth {letter}: raise R or lower {letter}", self.column)
        self.back = self.clearance if state.back_to_clearance else max(level, self.clearance)
        return level

    def _read_dwell_and_peck(self) -> None:
        memory = self.state.cycle
        if "P" in self.words:
            memory.dwell = self.words["P"].value * self.state.rules.dwell
            if not 0.0 <= memory.dwell <= LONGEST_DWELL:
                raise BlockError(f"CL806 the dwell is {memory.dwell:g} s: write one from 0 to {LONGEST_DWELL:g} s", self.words["P"].column)
        elif self.code in _DWELLING and not (self.again or self.own):
            raise BlockError(f"CL830 {self.name} has no dwell: write P, in seconds", self.column)
        if "Q" in self.words:
            memory.peck = self.state.length(self.words["Q"].value)
        if self.code not in _PECKING:
            return
        if "Q" not in self.words and not self.again:
            raise BlockError(f"CL830 {self.name} has no peck: write Q, the depth of one stroke", self.column)
        if memory.peck <= 0.0:
            raise BlockError(f"CL831 the peck Q of {self.name} must be greater than 0: write Q with the depth of one stroke", self.column)

    def _read_bore(self) -> tuple[tuple[float, float], float]:
        """Return lateral offset and top of a back bore (G87)."""
        letters = ["IJK"[axis] for axis in self.axes]
        memory, absolute = self.state.cycle, self.state.absolute
        kept: tuple[float | None, ...] = memory.bore if self.again else (None, None, None)
        i, j, k = (self.state.length(self.words[x].value) if x in self.words else old for x, old in zip(letters, kept, strict=True))
        if i is None or j is None or k is None:
            sideways = f"{letters[0]} and {letters[1]} (sideways offset)"
            raise BlockError(f"CL830 G87 needs {sideways} and {letters[2]} (top of the bore): write all three", self.column)
        memory.bore = (i, j, k)
        return (i, j), k if absolute else self.depth + k

    def _check_spindle(self) -> None:
        sense = self.state.turning
        refuse(sense == 0, BlockError, f"CL832 {self.name} needs a turning spindle: write M3 or M4 before it", self.column)
        if (self.code, sense) in ((740, 1), (840, -1)):
            other = "M4" if sense > 0 else "M3"
            raise BlockError(f"CL832 {self.name} needs the spindle to turn the other way: write {other} before it", self.column)

    def _next_hole(self) -> None:
        """Go to the next hole, absolute or incremental."""
        first, second, normal = self.axes
        end = self.state.target({letter: word for letter, word in self.words.items() if letter != "XYZ"[normal]})
        self.u, self.v = end[first], end[second]

    def _point(self, depth: float, aside: tuple[float, float]) -> Point:
        first, second, normal = self.axes
        point = [0.0, 0.0, 0.0]
        point[first], point[second], point[normal] = self.u + aside[0], self.v + aside[1], depth
        return (point[0], point[1], point[2])

    def _go(self, depth: float, *, feed: bool = False, aside: tuple[float, float] = (0.0, 0.0)) -> None:
        self.moves += self.state.straight(self._point(depth, aside), self.line, self.feedrate if feed else None)

    def _wait(self) -> None:
        if self.state.cycle.dwell or self.state.still:
            self.moves += self.state.wait(self.state.cycle.dwell, self.line)

    def _spindle(self, sense: int) -> None:
        self.state.tell({1: "M3", -1: "M4", 0: "M5"}[sense], None, self.line)

    def _plain(self) -> None:
        """Drill (G81, G82), tap (G74, G84), ream (G85), bore (G86, G88, G89)."""
        code, sense = self.code, self.state.turning
        self._go(self.depth, feed=True)
        if code in (740, 840):
            self._spindle(0)
            self._spindle(-sense)
            self._wait()
            self._go(self.back, feed=True)
            self._spindle(0)
            self._spindle(sense)
            return
        if code in _DWELLING:
            self._wait()
        if code in (860, 880):
            self._spindle(0)
        if code == 850:
            self._go(self.clearance, feed=True)
        if code == 880:
            self.state.tell("M0", None, self.line)  # the operator retracts the tool by hand
        else:
            self._go(self.back, feed=code == 890)
        if code in (860, 880):
            self._spindle(sense)

    def _peck(self) -> None:
        """Drill in strokes: G83 retracts to the clearance after each, G73 only breaks the chip."""
        reached = self.clearance - self.state.cycle.peck
        while reached > self.depth + LEAST_STROKE:
            self._go(reached, feed=True)
            if self.code == 830:
                self._go(self.clearance)
            self._go(reached + PECK_CLEARANCE)
            reached -= self.state.cycle.peck
        self._go(self.depth, feed=True)
        self._go(self.back)

    def _back_bore(self, aside: tuple[float, float], top: float) -> None:
        """Bore from below: move aside, stop the spindle, go down and in, turn it, bore up and down, stop it, and leave the same way."""
        sense = self.state.turning
        self._go(self.clearance, aside=aside)
        self._spindle(0)
        self._go(self.depth, aside=aside)
        self._go(self.depth)
        self._spindle(sense)
        self._go(top, feed=True)
        self._go(self.depth, feed=True)
        self._spindle(0)
        self._go(self.depth, aside=aside)
        self._go(self.back, aside=aside)
        self._go(self.back)
        self._spindle(sense)
