"""A program written again, with a correction of its contour."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.features.precompensate.reading import COMMENT, MOTION, Block, Contour
from contourlab.geometry.thinning import polygon_corners
from contourlab.program import Spline
from contourlab.program.dialects import Rules
from contourlab.result.stamp import identity, stamp

MARK = "(contourlab precompensate: pass "
"""How a corrected program begins."""
STEP = 1.25
"""Speeds of the control along a line, largest over smallest; between them, a line may be faster than the control was."""
_SMOOTH = 1e-9
_PLAIN = re.compile(r"\s*((N\d+|G0*[0123]|[XYZIJKRF][-+]?[\d.]+)\s*)+", re.IGNORECASE)
"""A line of motion only: between two corrected moves it is one without length, to a point that moved away."""
_GEOMETRY = "XYZIJKRL@^"
_HIDDEN = re.compile(
    r"\([^()]*\)|;.*|<[^<>]*>|((abs|acos|asin|a?tan|cos|exists|exp|fix|fup|ln|round|sin|sqrt)\s*)?\[[^][]*\]", re.IGNORECASE
)
"""Comments, names and brackets, with the function before them."""
_WORD = re.compile(r"([a-z@^])(\s*[-+#])*(\s*[\d.~/])*", re.IGNORECASE)
"""A word of a line in which these are masked; an assignment has no letter."""


def without_motion(line: str) -> str:
    """Return a line without its motion: axis words, centres, radii and motion codes; the rest stays.

    >>> without_motion("N10 G17 G2 (arc) X9 Y[3+1] I-2. F200 M8")
    'N10 G17 (arc) F200 M8'
    """
    blend = re.search(r"G\s*0*64(?!\d)", COMMENT.sub("", line), re.IGNORECASE)
    dropped, masked, before = _GEOMETRY + ("" if blend else "PQ"), line, ""
    while masked != before:  # brackets from the inside
        before, masked = masked, _HIDDEN.sub(lambda found: ("\0" if found[0][0] in "(;" else "~") * len(found[0]), masked)
    kept, at = "", 0
    for word in _WORD.finditer(masked):
        if word[1].upper() in dropped or MOTION.fullmatch(word[0]):
            kept += line[at : word.start()].removesuffix(" ")
            at = word.end()
    return (kept + line[at:]).strip()


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
    """

    text: str
    corrected_arc: Array
    programmed_arc: Array
    n_line: int


@dataclass(eq=False)
class _Lines:
    """Lines that replace a block, where they end, how far the control may round them, and what is in force behind them.

    That is: whether a feed below the programmed one, and a line with G64.
    """

    end: Array
    blend: float
    text: list[str] = field(default_factory=list)
    points: list[Array] = field(default_factory=list)
    places: list[float] = field(default_factory=list)
    slowed: bool = False
    control: str = ""


def write_corrected(
    contour: Contour,
    correction: Array,
    tolerance: float,
    fastest: Array | float = np.inf,
    blend: float | None = None,
    dwells: Mapping[int, float] | None = None,
    stops: bool = False,
) -> Written:
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
    blend : float [m], optional
        By how much the control may round and smooth the written lines, as P or Q of G64; twice the tolerance, if it is not given.
    dwells : mapping of int to float [s], optional
        Dwells to add, by the number of the block after each.
    stops : bool
        Whether the control stops at corners where the program sets no path control; G64 is then set from the first corrected line on.
    """
    fastest, blend = np.broadcast_to(fastest, len(contour.nodes)), blend or 2.0 * tolerance
    replaced: dict[int, _Lines] = {}
    blocks = contour.source.blocks
    for first, last in contour.chunks:
        lines = _Lines(contour.path.position(contour.path.breaks[first : first + 1])[0], blend)
        numbers = contour.route.source_line[first:last]
        for k in np.unique(numbers).tolist():
            curves = first + np.flatnonzero(numbers == k)
            index = contour.node_range(int(curves[0]), int(curves[-1]))
            lines = _replacing(contour, blocks[k - 1], index, correction, lines, tolerance, curves[-1] == last - 1, fastest)
            if stops and blocks[k - 1].move.mode.control is None:
                lines.text = [*_blending(contour.source.rules, blend * blocks[k - 1].scale), *lines.text]
                stops = False
            replaced[k - 1] = lines
    steps, places, at = [0.0], [0.0], np.asarray(contour.path.position(np.zeros(1))[0])
    last = 0
    for number, length, end in zip(contour.route.source_line.tolist(), np.diff(contour.path.breaks), contour.path.breaks[1:], strict=True):
        new = replaced.get(number - 1)
        if new is None:
            steps.append(float(length))
            places.append(float(end))
            at = contour.path.position(np.array([end]))[0]
        elif number != last:
            steps += np.linalg.norm(np.diff([at, *new.points], axis=0), axis=1).tolist()
            places += new.places
            at = new.points[-1] if new.points else at
        last = number
    n_line = sum(len(lines.points) for lines in replaced.values())
    return Written(with_dwells(contour, dwells or {}, replaced), np.cumsum(steps), np.array(places), n_line)


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
    rules = contour.source.rules
    digits = rules.decimals[0 if block.millimetres else 1]
    exact = np.array([block.shown(tuple(point)) for point in points.tolist()])
    shown = np.round(exact, digits) + 0.0  # no -0
    moved = np.append(True, (np.diff(shown[:, columns], axis=0) != 0.0).any(axis=1))
    shown, points, places, fastest = shown[moved], points[moved], places[moved], fastest[index[moved]]
    corners = polygon_corners(exact[moved], tolerance * block.scale)
    if block.feed_mode == "per_minute":
        fastest = np.maximum(fastest, 1e-3 * move.feedrate)  # type: ignore[union-attr]
        level = np.rint(np.log(np.minimum(fastest, move.feedrate)) / math.log(STEP))  # type: ignore[union-attr]
        corners = np.union1d(corners, 1 + np.flatnonzero(np.diff(level)))
    kept = corners[1:]
    lines = _Lines(points[-1, columns], before.blend, slowed=before.slowed, control=before.control)
    varies = np.ptp(shown, axis=0) > 0.0
    for k in kept.tolist():
        words = [f"{'XYZ'[j]}{shown[k, j]:.{digits}f}".rstrip("0") for j in np.flatnonzero(varies)]
        lines.text.append("G1 " + " ".join(words))
        lines.points.append(block.axes(shown[k])[columns])
        lines.places.append(float(places[k]))
    if block.feed_mode == "per_minute" and len(kept):
        speed = np.maximum(np.maximum.reduceat(fastest, corners[:-1]), fastest[kept])
        length = np.linalg.norm(np.diff(points[corners], axis=0), axis=1)
        _with_feeds(lines, block, speed * length / np.maximum(np.diff(places[corners]), 1e-12))
    turns = ends or bool((np.abs(np.asarray(contour.path.corners) - places[-1]) < _SMOOTH).any())
    _with_modes(lines, block, rules, turns, ends)
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


def _with_modes(lines: _Lines, block: Block, rules: Rules, corner: bool, ends: bool) -> None:
    """Add the codes that let short lines run as one move and stay as they are, and those that restore the modes of the program."""
    mode, fine = block.move.mode, lines.blend * block.scale  # type: ignore[union-attr]
    if mode.control in ("exact_path", "exact_stop"):
        if len(lines.text) > 1 and rules.blend is not None:
            code = "G61.1" if mode.control == "exact_stop" and not rules.stops_at_g61 else "G61"
            lines.text.insert(len(lines.text) - int(corner or mode.control == "exact_stop"), code)
            lines.text = [*_blending(rules, fine), *lines.text]
    elif mode.tolerance and mode.merge and mode.merge > lines.blend and rules.blend:
        # With Q as large as P, by default, the control may smooth the correction away.
        (own,), (closer,) = (_blending(rules, mode.tolerance * block.scale, q) for q in (mode.merge * block.scale, fine))
        lines.text = [*([closer] if lines.control != closer else []), *lines.text, *([own] if ends else [])]
        lines.control = closer
    if not block.absolute:
        lines.text = ["G90", *lines.text, "G91"]
    if block.feed_mode == "inverse_time":
        lines.text = [f"G94 {block.feed_word}", *lines.text, "G93"]


def _blending(rules: Rules, tolerance: float, merge: float | None = None) -> list[str]:
    """Return the line that sets G64 with a P and a Q in the unit of the program, as far as a dialect has them."""
    given = [(letter, value) for letter, value in (("P", tolerance), ("Q", merge)) if value is not None and letter in (rules.blend or "")]
    return [] if rules.blend is None else [" ".join(["G64", *(f"{letter}{value:.6f}".rstrip("0") for letter, value in given)])]


def with_dwells(contour: Contour, dwells: Mapping[int, float], replaced: Mapping[int, _Lines] | None = None) -> str:
    """Return the program with dwells [s] before some blocks, and the lines of others replaced."""
    replaced = replaced or {}
    source, typed = contour.source, contour.source.program.lines
    by_line: dict[int, list[str]] = {}
    for k, lines in replaced.items():
        first, last = source.blocks[k].lines
        for number in range(first, last + 1):
            text = without_motion(typed[number - 1])
            if isinstance(source.blocks[k].move, Spline) and number != first:
                text = text if "(" in text or ";" in text else ""
            by_line[number] = [text] if text else []
        by_line[last] += lines.text
    for first, last in contour.chunks:
        numbers = np.unique(contour.route.source_line[first:last]) - 1
        for before, after in itertools.pairwise(numbers.tolist()):
            for number in range(source.blocks[before].lines[1] + 1, source.blocks[after].lines[0]):
                if _PLAIN.fullmatch(COMMENT.sub("", typed[number - 1])):
                    text = without_motion(typed[number - 1])
                    by_line[number] = [text] if text else []
    for k, seconds in dwells.items():
        number = source.blocks[k].lines[0]
        dwell = f"G4 P{seconds / source.rules.dwell:.3f}".rstrip("0").rstrip(".")
        by_line[number] = [dwell, *by_line.get(number, [typed[number - 1]])]
    return "".join(f"{text}\n" for number, line in enumerate(typed, 1) for text in by_line.get(number, [line]))


def marked(text: str, number: int, name: str, source: tuple[str, ...] = ()) -> str:
    """Return a program with comments that say what it is and what made it, after an opening % and O-number; `source` is the one before."""
    plain = "".join(letter if letter.isalnum() or letter in "._-" else "_" for letter in name)
    opening = re.match(r"(%.*\n)?([O:][0-9]+[ \t]*(\([^()\n]*\))?[ \t]*\n)?", text, re.IGNORECASE)
    at = opening.end() if opening else 0
    return f"{text[:at]}{MARK}{number} of {plain})\n({stamp(program=identity(source))})\n{text[at:]}"
