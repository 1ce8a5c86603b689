"""The programmed contour with its correction, and the program written again: short lines for the corrected moves, all else as it is."""

from __future__ import annotations

import itertools
import math
import re
import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

import numpy as np

from contourlab import geometry
from contourlab.arrays import Array, Flags, Index
from contourlab.features.precompensate.blocks import COMMENT, Block, Source, without_motion
from contourlab.feed import Route, route_from_program
from contourlab.geometry.thinning import polygon_corners
from contourlab.program import Arc, Dwell, Feed, Mode, Move, Point, Spline
from contourlab.program.moves import PLANE_AXES

FINEST = 5e-6
"""Smallest distance between two nodes [m]."""


@dataclass(frozen=True, eq=False)
class Contour:
    """The path of a program in the axes of a log, and its nodes.

    Attributes
    ----------
    source : Source
    axes : tuple of str
    route : Route
        Its `source_line` is the number of the block, from 1.
    period : float [s]
        Time between nodes at the programmed feed.
    """

    source: Source
    axes: tuple[str, ...]
    route: Route
    period: float

    @property
    def path(self) -> geometry.Path:
        """The programmed path."""
        return self.route.path

    @cached_property
    def corrected(self) -> Flags:
        """Whether each curve (n_curve,) can be corrected."""
        return np.array([not self.source.blocks[k - 1].reason for k in self.route.source_line.tolist()])

    @cached_property
    def nodes(self) -> Array:
        """Rising arc lengths (n_node,) [m] that hold the correction; every end of a curve is one."""
        parts = [np.zeros(1)]
        breaks = self.path.breaks
        for k, corrected in enumerate(self.corrected.tolist()):
            step = max(FINEST, float(self.route.feedrate[k]) * self.period) if corrected else np.inf
            n = max(1, int(np.ceil((breaks[k + 1] - breaks[k]) / step)))
            parts.append(np.linspace(breaks[k], breaks[k + 1], n + 1)[1:])
        return np.concatenate(parts)

    @cached_property
    def positions(self) -> Array:
        """Position of each node (n_node, n_axis) [m]."""
        return np.asarray(self.path.position(self.nodes))

    def is_corrected(self, arc_length: Array) -> Flags:
        """Return whether places (n,) [m] lie on curves that can be corrected."""
        return np.asarray(self.corrected[self.path.curve_index(arc_length)])


def contour_of(source: Source, axes: Sequence[str], period: float) -> Contour:
    """Return the contour of a program in some of its axes.

    Parameters
    ----------
    source : Source
    axes : sequence of str
        Some of x, y, z; motion of the others is left out.
    period : float [s]

    Raises
    ------
    FeedError
        If nothing moves these axes.
    """
    columns = ["xyz".index(axis) for axis in axes]
    moves = tuple(_flat(replace(block.move, source_line=k + 1), columns) for k, block in enumerate(source.blocks))
    route = route_from_program(replace(source.program, moves=moves), tuple(axes))
    return Contour(source, tuple(axes), route, period)


def _flat(move: Move, columns: Sequence[int]) -> Move:
    """Return a move without motion of other axes than some; an arc that leaves their plane becomes a line, which is not corrected."""

    def flat(point: Point) -> Point:
        return tuple(value if k in columns else 0.0 for k, value in enumerate(point))  # type: ignore[return-value]

    if len(columns) == 3 or isinstance(move, Dwell):
        return move
    if isinstance(move, Spline):
        return replace(move, points=tuple(map(flat, move.points)))
    if isinstance(move, Arc) and not set(PLANE_AXES[move.plane][:2]) <= set(columns):
        return Feed(flat(move.start), flat(move.end), move.feedrate, move.source_line, move.mode)
    moved = replace(move, start=flat(move.start), end=flat(move.end))
    return replace(moved, centre=flat(moved.centre)) if isinstance(moved, Arc) else moved


def chunks(contour: Contour) -> list[tuple[int, int]]:
    """Return the ranges of curves [start, stop) that are corrected without a break between."""
    blocks, lines = contour.source.blocks, contour.route.source_line
    ranges: list[tuple[int, int]] = []
    for k, corrected in enumerate(contour.corrected.tolist()):
        if not corrected:
            continue
        between = blocks[lines[k - 1] : lines[k] - 1] if k else ()
        if ranges and ranges[-1][1] == k and not between:
            ranges[-1] = (ranges[-1][0], k + 1)
        else:
            ranges.append((k, k + 1))
    return ranges


def room(contour: Contour) -> Array:
    """Return the distance (n_node,) [m] along the path of each node from the nearer end of its corrected part; 0 outside."""
    distance = np.zeros(len(contour.nodes))
    for first, last in chunks(contour):
        index = node_range(contour, first, last - 1)
        places = contour.nodes[index]
        distance[index] = np.minimum(places - places[0], places[-1] - places)
    return distance


def node_range(contour: Contour, first: int, last: int) -> Index:
    """Return the numbers of the nodes from the start of one curve to the end of another, both included."""
    breaks, nodes = contour.path.breaks, contour.nodes
    return np.arange(np.searchsorted(nodes, breaks[first]), np.searchsorted(nodes, breaks[last + 1]) + 1)


MARK = "(contourlab precompensate: pass "
"""How a corrected program begins."""
STEP = 1.25
"""Speeds of the control along a line, largest over smallest; between them, a line may be faster than the control was."""
_CONTROLS = {"exact_path": "G61", "exact_stop": "G61.1"}
_SMOOTH = 1e-9
_PLAIN = re.compile(r"\s*((N\d+|G0*[0123]|[XYZIJKRF][-+]?[\d.]+)\s*)+", re.IGNORECASE)
"""A line of motion only: between two corrected moves it is one without length, to a point that moved away."""


@dataclass(frozen=True, eq=False)
class Written:
    """A corrected program.

    Attributes
    ----------
    text : str
    corrected_arc : ndarray (n,) [m]
        Places along its path, rising: the end of each of its curves, after 0.
    programmed_arc : ndarray (n,) [m]
        The same places along the programmed path.
    n_line : int
        Lines that replace corrected moves.
    shortest : float [s]
        Shortest time of such a line at its feed.
    """

    text: str
    corrected_arc: Array
    programmed_arc: Array
    n_line: int
    shortest: float


@dataclass(eq=False)
class _Lines:
    """Lines that replace a block, the places where they end, and whether a feed below the programmed one is in force behind them."""

    end: Array
    text: list[str] = field(default_factory=list)
    points: list[Array] = field(default_factory=list)
    places: list[float] = field(default_factory=list)
    slowed: bool = False


def write_corrected(contour: Contour, correction: Array, tolerance: float, fastest: Array | float = np.inf) -> Written:
    """Return the program whose path is the programmed one plus a correction.

    Parameters
    ----------
    contour : Contour
    correction : ndarray (n_node, n_axis) [m]
        Displacement of each node. A corrected part begins and ends at its programmed points.
    tolerance : float [m]
        Largest distance of a written line from the corrected path.
    fastest : ndarray (n_node,) [m/s], optional
        Largest speed at each node along the programmed path; lines that could be faster get a feed word.
    """
    fastest = np.broadcast_to(fastest, len(contour.nodes))
    replaced: dict[int, _Lines] = {}
    blocks, shortest = contour.source.blocks, np.inf
    for first, last in chunks(contour):
        lines = _Lines(contour.path.position(contour.path.breaks[first : first + 1])[0])
        numbers = contour.route.source_line[first:last]
        for k in np.unique(numbers).tolist():
            curves = first + np.flatnonzero(numbers == k)
            index = node_range(contour, int(curves[0]), int(curves[-1]))
            ends, start = curves[-1] == last - 1, lines.end
            lines = _replacing(contour, blocks[k - 1], index, correction, lines, tolerance, ends, fastest)
            steps = np.linalg.norm(np.diff(np.vstack([start, *lines.points]), axis=0), axis=1)
            shortest = min(shortest, float(steps.min(initial=np.inf)) / float(contour.route.feedrate[curves[0]]))
            replaced[k - 1] = lines
    arcs, places, at = [0.0], [0.0], np.asarray(contour.path.position(np.zeros(1))[0])
    breaks = contour.path.breaks
    done = set()
    for curve, number in enumerate(contour.route.source_line.tolist()):
        new = replaced.get(number - 1)
        if new is None:
            arcs.append(arcs[-1] + float(breaks[curve + 1] - breaks[curve]))
            places.append(float(breaks[curve + 1]))
            at = contour.path.position(breaks[curve + 1 : curve + 2])[0]
        elif number not in done:
            done.add(number)
            for point, place in zip(new.points, new.places, strict=True):
                arcs.append(arcs[-1] + float(np.linalg.norm(point - at)))
                places.append(place)
                at = point
    n_line = sum(len(lines.points) for lines in replaced.values())
    return Written(_text(contour, replaced), np.array(arcs), np.array(places), n_line, shortest)


def _replacing(
    contour: Contour, block: Block, index: Index, correction: Array, before: _Lines, tolerance: float, ends: bool, fastest: Array
) -> _Lines:
    """Return the lines of one block, from where the lines before ended."""
    columns = ["xyz".index(axis) for axis in contour.axes]
    move, places = block.move, contour.nodes[index]
    share = (places - places[0]) / (places[-1] - places[0])
    points = np.array(move.start) + share[:, None] * (np.array(move.end) - np.array(move.start))  # type: ignore[union-attr]
    points[:, columns] = contour.positions[index] + correction[index]
    points[0, columns] = before.end
    if ends:
        index, points, places = np.append(index, index[-1]), np.vstack([points, points[-1:]]), np.append(places, places[-1])
        points[-1, columns] = contour.positions[index[-1]]
    digits = 6 if block.millimetres else 8
    shown = np.round([block.shown(tuple(point)) for point in points.tolist()], digits) + 0.0  # no -0
    moved = np.append(True, (np.diff(shown[:, columns], axis=0) != 0.0).any(axis=1))
    shown, points, places, fastest = shown[moved], points[moved], places[moved], fastest[index[moved]]
    corners = polygon_corners(shown, tolerance * block.scale)
    if block.feed_mode == "per_minute":
        fastest = np.maximum(fastest, 1e-3 * move.feedrate)  # type: ignore[union-attr]
        level = np.rint(np.log(np.minimum(fastest, move.feedrate)) / math.log(STEP))  # type: ignore[union-attr]
        corners = np.union1d(corners, 1 + np.flatnonzero(np.diff(level)))
    kept = corners[1:]
    lines = _Lines(points[-1, columns], slowed=before.slowed)
    varies = np.ptp(shown, axis=0) > 0.0
    for k in kept.tolist():
        words = [f"{'XYZ'[j]}{shown[k, j]:.{digits}f}".rstrip("0").rstrip(".") for j in np.flatnonzero(varies)]
        lines.text.append("G1 " + " ".join(words))
        lines.points.append(points[k, columns])
        lines.places.append(float(places[k]))
    if block.feed_mode == "per_minute" and len(kept):
        speed = np.maximum(np.maximum.reduceat(fastest, corners[:-1]), fastest[kept])
        length = np.linalg.norm(np.diff(points[corners], axis=0), axis=1)
        _with_feeds(lines, block, speed * length / np.maximum(np.diff(places[corners]), 1e-12))
    turns = ends or bool((np.abs(np.asarray(contour.path.corners) - places[-1]) < _SMOOTH).any())
    _with_modes(lines, block, move.mode, turns, tolerance)  # type: ignore[union-attr]
    if lines.slowed and ends:
        lines.text.append(block.feed_word)
    return lines


def _with_feeds(lines: _Lines, block: Block, largest: Array) -> None:
    """Add feed words to lines that may not have the programmed feed, and to the first one that has it again."""
    feed, in_force = block.feed_word, "" if lines.slowed else block.feed_word
    scale = 60.0 * block.scale
    for k, one in enumerate(largest.tolist()):
        word = feed if one >= block.move.feedrate else f"F{scale * one:.{1 if block.millimetres else 3}f}"  # type: ignore[union-attr]
        lines.text[k] += f" {word}" if word != in_force else ""
        in_force = word
    lines.slowed = in_force != feed


def _with_modes(lines: _Lines, block: Block, mode: Mode, corner: bool, tolerance: float) -> None:
    """Add the codes that let short lines run as one move, and those that restore the modes of the program."""
    code = _CONTROLS.get(mode.control or "")
    if code is not None and len(lines.text) > 1:
        blend = 2.0 * tolerance * block.scale
        stops = corner or mode.control == "exact_stop"
        lines.text.insert(0, f"G64 P{blend:.6f}")
        lines.text.insert(len(lines.text) - int(stops), code)
    if not block.absolute:
        lines.text = ["G90", *lines.text, "G91"]
    if block.feed_mode == "inverse_time":
        lines.text = [f"G94 {block.feed_word}", *lines.text, "G93"]


def _text(contour: Contour, replaced: dict[int, _Lines]) -> str:
    """Return the program with the lines of some blocks replaced."""
    source = contour.source
    by_line: dict[int, list[str]] = {}
    for k, lines in replaced.items():
        first, last = source.blocks[k].lines
        texts = [without_motion(source.lines[number - 1]) for number in range(first, last + 1)]
        for number, text in zip(range(first, last + 1), texts, strict=True):
            if isinstance(source.blocks[k].move, Spline) and number != first:
                text = text if "(" in text or ";" in text else ""
            by_line[number] = [text] if text else []
        by_line[last] += lines.text
    for first, last in chunks(contour):
        numbers = np.unique(contour.route.source_line[first:last]) - 1
        for before, after in itertools.pairwise(numbers.tolist()):
            for number in range(source.blocks[before].lines[1] + 1, source.blocks[after].lines[0]):
                if _PLAIN.fullmatch(COMMENT.sub("", source.lines[number - 1])):
                    text = without_motion(source.lines[number - 1])
                    by_line[number] = [text] if text else []
    written: list[str] = []
    for number, line in enumerate(source.lines, 1):
        written += by_line.get(number, [line])
    return "\n".join(written) + "\n"


def marked(text: str, number: int, name: str) -> str:
    """Return a program with a comment that says what it is, after an opening %."""
    plain = "".join(letter if letter.isalnum() or letter in "._-" else "_" for letter in name)
    head, rest = ("%\n", text[2:]) if text.startswith("%\n") else ("", text)
    return f"{head}{MARK}{number} of {plain})\n{rest}"


def complaint(text: str, folder: Path) -> str:
    """Return what LinuxCNC's interpreter says against a program; empty for nothing."""
    with tempfile.TemporaryDirectory() as name:
        file = Path(name, "program.ngc")
        file.write_text(text, encoding="utf-8", errors="replace")
        try:
            ran = subprocess.run(
                ["rs274", "-g", str(file)], capture_output=True, text=True, errors="replace", timeout=60, cwd=folder, check=False
            )
        except (OSError, subprocess.TimeoutExpired):
            return ""
    lines = [line.strip() for line in ran.stderr.splitlines() if line.strip()]
    return "" if ran.returncode == 0 else (lines[-1] if lines else f"code {ran.returncode}")[:200]
