"""Canned cycles: G73, G74, G81 to G89, in the active plane, with L repeats, R, and G98 or G99.

Depth, clearance (R) and level of a cycle lie along the normal of the plane. The tool goes to each hole at the level or the clearance, then
makes the strokes of the cycle. The path is exact (G61), except for the first rise to the clearance, as in LinuxCNC.
"""

from __future__ import annotations

from dataclasses import replace

from contourlab.program.block import Block
from contourlab.program.moves import PLANE_AXES, Move, Point
from contourlab.program.state import ModalState
from contourlab.program.vocabulary import BlockError, g_name

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
        state.cycle.millimetres = state.millimetres
        self.words, self.state, self.line, self.again = block.words, state, line, again
        self.code, self.name = state.motion, g_name(state.motion)
        self.column = block.column
        self.axes = PLANE_AXES[state.plane]
        self.moves: list[Move] = []
        self.u, self.v = (state.position[axis] for axis in self.axes[:2])
        self.clearance = self.depth = self.back = 0.0
        if state.feed_mode == "inverse_time":
            raise BlockError(f"{self.name} cannot use inverse-time feed (G93): write G94 and F", self.column)
        self.feedrate = state.path_feedrate(self.column, self.name)

    def run(self) -> None:
        """Make the moves of all repeats."""
        here = self.state.position[self.axes[2]]
        level = self._read_levels()
        self._read_dwell_and_peck()
        bore = self._read_bore() if self.code == 870 else None
        if self.code in _TURNING:
            self._check_spindle()
        if level < self.clearance:
            self._go(self.clearance)
            here = self.clearance
        self.state.mode = replace(self.state.mode, control="exact_path", tolerance=None, merge=None)
        repeats = self.words["L"].whole(1, MOST_REPEATS, "the number of repeats") if "L" in self.words else 1
        if self.code in _PECKING and repeats * (self.clearance - self.depth) / self.state.cycle.peck > MOST_STROKES:
            raise BlockError(f"the peck Q of {self.name} needs more than {MOST_STROKES} strokes: make it larger", self.column)
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
            if wanted not in self.words and not self.again:
                raise BlockError(f"{self.name} has no {what}: write {wanted}", self.column)
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
            raise BlockError(f"the clearance R is below the depth {letter}: raise R or lower {letter}", self.column)
        self.back = self.clearance if state.back_to_clearance else max(level, self.clearance)
        return level

    def _read_dwell_and_peck(self) -> None:
        memory = self.state.cycle
        if "P" in self.words:
            memory.dwell = self.words["P"].value
            if not 0.0 <= memory.dwell <= LONGEST_DWELL:
                raise BlockError(f"P{memory.dwell:g}: write the dwell in seconds, from 0 to {LONGEST_DWELL:g}", self.words["P"].column)
        elif self.code in _DWELLING and not self.again:
            raise BlockError(f"{self.name} has no dwell: write P, in seconds", self.column)
        if self.code not in _PECKING:
            return
        if "Q" in self.words:
            memory.peck = self.state.length(self.words["Q"].value)
        elif not self.again:
            raise BlockError(f"{self.name} has no peck: write Q, the depth of one stroke", self.column)
        if memory.peck <= 0.0:
            raise BlockError(f"the peck Q of {self.name} must be greater than 0: write Q with the depth of one stroke", self.column)

    def _read_bore(self) -> tuple[tuple[float, float], float]:
        """Return lateral offset and top of a back bore (G87)."""
        letters = ["IJK"[axis] for axis in self.axes]
        memory, absolute = self.state.cycle, self.state.absolute
        kept: tuple[float | None, ...] = memory.bore if self.again else (None, None, None)
        i, j, k = (self.state.length(self.words[x].value) if x in self.words else old for x, old in zip(letters, kept, strict=True))
        if i is None or j is None or k is None:
            sideways = f"{letters[0]} and {letters[1]} (sideways offset)"
            raise BlockError(f"G87 needs {sideways} and {letters[2]} (top of the bore): write all three", self.column)
        memory.bore = (i, j, k)
        return (i, j), k if absolute else self.depth + k

    def _check_spindle(self) -> None:
        sense = self.state.turning
        if sense == 0:
            raise BlockError(f"{self.name} needs a turning spindle: write M3 or M4 before it", self.column)
        if (self.code, sense) in ((740, 1), (840, -1)):
            other = "M4" if sense > 0 else "M3"
            raise BlockError(f"{self.name} needs the spindle to turn the other way: write {other} before it", self.column)

    def _next_hole(self) -> None:
        """Go to the next hole, absolute or incremental."""
        state = self.state
        if "@" in self.words or "^" in self.words:
            state.position = (self.u, self.v, state.position[2])
            self.u, self.v = state.polar(self.words)
            return
        places = []
        for axis, old in zip(self.axes[:2], (self.u, self.v), strict=True):
            word = self.words.get("XYZ"[axis])
            value = None if word is None else state.coordinate(axis, word)
            places.append(old if value is None else value if state.absolute else old + value)
        self.u, self.v = places

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
