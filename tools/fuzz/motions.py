"""Random sound motions: a part program as moves, which can be split, moved, turned, mirrored, and written in mm or inch."""

from __future__ import annotations

import math
import random
from collections.abc import Sequence
from dataclasses import dataclass, replace

Point = tuple[float, float, float]
Placing = tuple[tuple[int, float], ...]
"""For each new axis: the old axis that it replaces, and its sign."""
PLANES = {0: "G19", 1: "G18", 2: "G17"}
"""Code of the plane by its normal axis."""
MODES = ("G61", "G61.1", "G64 P0.005", "G64 P0.05", "G64 P0.02 Q0.01")


@dataclass(frozen=True)
class Motion:
    """A move [mm]: rapid (``feed`` 0), line, or arc around ``centre``; ``sense`` is the sign of its turn around the axis ``normal``."""

    start: Point
    end: Point
    feed: float
    centre: Point | None = None
    normal: int = 2
    sense: int = 1

    @property
    def plane(self) -> tuple[int, int]:
        """The two axes of the arc; the second lies a quarter turn, by the right hand, behind the first."""
        return (self.normal + 1) % 3, (self.normal + 2) % 3

    def angle(self, point: Point) -> float:
        """Return the angle of a point around the centre [rad]."""
        assert self.centre is not None
        i, j = self.plane
        return math.atan2(point[j] - self.centre[j], point[i] - self.centre[i])

    def halves(self, share: float) -> tuple[Motion, Motion]:
        """Return the two parts of the move, of the lengths ``share`` and 1 - ``share`` of its own."""
        middle = [a + share * (b - a) for a, b in zip(self.start, self.end, strict=True)]
        if self.centre is not None:
            (i, j), begin = self.plane, self.angle(self.start)
            turn = self.sense * (self.angle(self.end) - begin) % math.tau or math.tau
            radius, at = math.dist(*([p[i], p[j]] for p in (self.start, self.centre))), begin + self.sense * share * turn
            middle[i], middle[j] = self.centre[i] + radius * math.cos(at), self.centre[j] + radius * math.sin(at)
        point: Point = (middle[0], middle[1], middle[2])
        return replace(self, end=point), replace(self, start=point)


def placed(motions: Sequence[Motion], placing: Placing) -> list[Motion]:
    """Return the moves with axes exchanged and mirrored; arcs keep their shape, so a mirror changes their sense."""
    old = [axis for axis, _ in placing]
    swapped = sum(old[i] > old[j] for i in range(3) for j in range(i + 1, 3)) % 2
    mirror = (-1.0) ** swapped * math.prod(sign for _, sign in placing)

    def at(point: Point) -> Point:
        x, y, z = (sign * point[axis] for axis, sign in placing)
        return x, y, z

    moved = []
    for motion in motions:
        normal = old.index(motion.normal)
        sense = int(motion.sense * placing[normal][1] * mirror)
        centre = None if motion.centre is None else at(motion.centre)
        moved.append(replace(motion, start=at(motion.start), end=at(motion.end), centre=centre, normal=normal, sense=sense))
    return moved


def made_motions(draw: random.Random, n_axis: int = 3) -> list[Motion]:
    """Return a rapid from the origin and two to five cuts of some millimetres: lines, arcs and helices."""

    def near(point: Point, reach: float) -> Point:
        x, y, z = (round(value + draw.uniform(-reach, reach), 3) for value in point)
        return x, y, z if n_axis > 2 else 0.0

    start = near((0.0, 0.0, 0.0), 3.0)
    motions = [Motion((0.0, 0.0, 0.0), start, 0.0)]
    for _ in range(draw.randint(2, 5)):
        feed = draw.choice((900.0, 1500.0, 2400.0, 4500.0))
        if draw.random() < 0.6:
            end = near(start, draw.choice((0.5, 1.5, 4.0)))
            motions.append(Motion(start, end, feed))
        else:
            normal = draw.choice((0, 1, 2)) if n_axis > 2 else 2
            i, j = (normal + 1) % 3, (normal + 2) % 3
            radius, begin = draw.uniform(0.5, 2.0), draw.uniform(0.0, math.tau)
            turn, sense = draw.uniform(0.5, 5.5), draw.choice((-1, 1))
            centre, last = list(start), list(start)
            centre[i], centre[j] = start[i] - radius * math.cos(begin), start[j] - radius * math.sin(begin)
            last[i] = centre[i] + radius * math.cos(begin + sense * turn)
            last[j] = centre[j] + radius * math.sin(begin + sense * turn)
            last[normal] += draw.choice((0.0, 0.5)) if n_axis > 2 else 0.0  # a helix
            end = (last[0], last[1], last[2])
            motions.append(Motion(start, end, feed, (centre[0], centre[1], centre[2]), normal, sense))
        start = end
    if draw.random() < 0.5:
        motions.append(Motion(start, near(start, 2.0), 0.0))
    return motions


def written(
    motions: Sequence[Motion], mode: str = "G61", inch: bool = False, shift: Point = (0.0, 0.0, 0.0), first: str = "", steps: bool = False
) -> str:
    """Return the part program: moved by ``shift``, with a line ``first`` before the moves; ``steps`` writes it incrementally (G91)."""
    unit = 25.4 if inch else 1.0
    words = mode.split()  # tolerances P and Q are lengths
    head = " ".join([words[0], *(f"{word[0]}{float(word[1:]) / unit:.15f}" for word in words[1:])])
    lines = ["%", f"{'G20' if inch else 'G21'} {'G91' if steps else 'G90'} G40 G49 G54 G94", head, *([first] if first else [])]
    for motion in motions:
        to = [b - a if steps else b + d for a, b, d in zip(motion.start, motion.end, shift, strict=True)]
        line = " ".join(f"{name}{value / unit:.15f}" for name, value in zip("XYZ", to, strict=True))
        if motion.centre is not None:
            line += "".join(f" {'IJK'[k]}{(motion.centre[k] - motion.start[k]) / unit:.15f}" for k in motion.plane)
            line = f"{PLANES[motion.normal]} {'G3' if motion.sense > 0 else 'G2'} {line}"
        else:
            line = f"{'G1' if motion.feed else 'G0'} {line}"
        lines.append(f"{line} F{motion.feed / unit:.15f}" if motion.feed else line)
    return "\n".join([*lines, "M2", "%", ""])
