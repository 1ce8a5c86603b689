"""LinuxCNC's stand-alone interpreter as the oracle of the part-program reader: its moves, ours, and where they differ."""

from __future__ import annotations

import importlib.util
import math
import re
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from reference_data import SHARED

from contourlab.errors import ProgramError
from contourlab.geometry import Nurbs
from contourlab.program import Arc, Dwell, Feed, Move, Reader, Reading, Spline, Traverse

TOOL = SHARED / "tools" / "rs274_oracle.py"
NEEDED = [
    pytest.mark.oracle,
    # The shared tool does not close its files.
    pytest.mark.filterwarnings("ignore::ResourceWarning", "ignore::pytest.PytestUnraisableExceptionWarning"),
    pytest.mark.skipif(shutil.which("rs274") is None, reason="LinuxCNC's interpreter rs274 is not installed"),
    pytest.mark.skipif(not TOOL.is_file(), reason="the shared oracle tools are not next to the repository"),
]
KINDS = {Traverse: "traverse", Feed: "feed", Arc: "arc", Dwell: "dwell", Spline: "nurbs"}

Theirs = list[dict[str, Any]]


def load_oracle() -> ModuleType:
    """Return the shared tool as a module."""
    return load_module(TOOL)


def load_module(file: Path) -> ModuleType:
    """Return a file outside all packages as a module."""
    spec = importlib.util.spec_from_file_location(file.stem, file)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@dataclass
class Made:
    """One of our moves with the feedrate in force behind it [m/s or m/turn]."""

    move: Move
    feedrate: float
    per_turn: bool


def our_moves(text: str, folder: Path | None = None, tools: Path | None = None) -> tuple[list[Made], ProgramError | None]:
    """Return the moves up to an error, including those of zero length, and the error."""
    made: list[Made] = []
    reader = Reader(text.split("\n"), "text", Reading(require_end=False, folder=folder, tools=tools), still=True)
    try:
        for move in reader.moves():
            made.append(Made(move, reader.state.feedrate, reader.state.feed_mode == "per_turn"))
            assert len(made) < 100_000, "an endless loop"
    except ProgramError as error:
        return made, None if "contains no motion" in error.message else error
    return made, None


def their_moves(oracle: ModuleType, file: Path, backend: str, **options: Any) -> tuple[Theirs, str]:
    """Return LinuxCNC's moves, and its error message, empty if there is none."""
    # LinuxCNC keeps the tools in a file of the home folder, which parallel interpreters would share.
    with tempfile.TemporaryDirectory() as home, pytest.MonkeyPatch.context() as patch:
        patch.setenv("HOME", home)
        try:
            moves, complaint = oracle.moves(str(file), backend=backend, timeout=20, **options), ""
        except oracle.OracleError as error:
            moves, complaint = error.args[1], error.args[0]
    return moves, complaint


def refused_line(complaint: str) -> int:
    """Return the line at which the `gcode` backend gave up."""
    found = re.match(r"gcode line (\d+):", complaint)
    assert found is not None, complaint
    return int(found[1])


def difference(made: list[Made], theirs: Theirs, *, exact: bool, inches: bool = True) -> str:
    """Return how the two lists of moves differ, empty if they agree; `exact` means full doubles, else four decimals."""
    near = 1e-8 if exact else 5e-3 if inches else 2e-4
    left = list(theirs)
    for mine in made:
        move = mine.move
        if not left:
            return f"we make more: {move}"
        if exact and isinstance(move, Spline):
            left, wrong = _spline_left(move, left, near)
        else:
            wrong = _move_differs(mine, left[0], near)
            left = left[1:]
        if wrong:
            return wrong
    return f"they make {len(left)} more: {left[0]}" if left else ""


def _move_differs(mine: Made, other: dict[str, Any], near: float) -> str:
    move = mine.move
    where = f"{move}\n    theirs: {other}"
    if KINDS[type(move)] != other["kind"]:
        return f"kind: {where}"
    if isinstance(move, Spline):
        return ""
    if isinstance(move, Dwell):
        return "" if abs(move.seconds - other["seconds"]) <= 1e-4 * max(1.0, move.seconds) else f"seconds: {where}"
    scale = max(1.0, *(abs(value) for value in other["end"])) if near < 1e-6 else 1.0
    if math.dist(_tip(move.end, move), other["end"]) > near * scale:
        return f"end: {where}"
    if not isinstance(move, Traverse) and not _same_feedrate(mine, move, other["feed"], near):
        return f"feedrate {6e4 * move.feedrate}: {where}"
    if near < 1e-6 and other["line"] is not None and move.source_line != other["line"]:
        return f"line: {where}"
    if isinstance(move, Arc):
        gap = np.subtract(_tip(move.centre, move), other["centre"])
        aside = max(abs(float(np.dot(gap, unit))) for unit in move.directions()[:2])
        scale = max(scale, 1e3 * move.radius) if near < 1e-6 else 1.0
        if move.turns != other["turns"] or sorted(move.plane) != sorted(other["plane"]) or aside > near * scale:
            return f"arc, centre {aside} mm aside: {where}"
    return ""


def _same_feedrate(mine: Made, move: Feed | Arc, theirs: float, near: float) -> bool:
    ours = 1e3 * mine.feedrate if mine.per_turn else 6e4 * move.feedrate
    return abs(ours - theirs) <= (1e-9 * max(1.0, theirs) if near < 1e-6 else max(2e-3, 1e-4 * theirs))


def _tip(point: tuple[float, float, float], move: Any) -> list[float]:
    return [1e3 * (value - offset) for value, offset in zip(point, move.mode.tool, strict=True)]


def _spline_left(move: Spline, theirs: Theirs, near: float) -> tuple[Theirs, str]:
    """Remove the chords of a spline from LinuxCNC's moves; each must end on our curve, the last one at its end."""
    count = 0
    end = _tip(move.end, move)
    vertices: list[tuple[float, float, float]] = []
    while count < len(theirs) and theirs[count]["kind"] == "feed":
        vertices.append(theirs[count]["end"])
        count += 1
        if math.dist(vertices[-1], end) < 1e-6 and not (count < len(theirs) and theirs[count]["line"] == move.source_line):
            break
    if not vertices or math.dist(vertices[-1], end) > 1e-6:
        return theirs, f"the spline does not end like theirs: {move}\n    theirs: {vertices[-1:]}"
    aside = farthest_aside(move, np.array(vertices))
    if aside > 100.0 * near:
        return theirs, f"a vertex of the spline lies {aside} mm aside: {move}"
    return theirs[count:], ""


def farthest_aside(move: Spline, vertices: np.ndarray[Any, np.dtype[np.float64]]) -> float:
    """Return the largest distance of points [mm] from a spline [mm]: dense samples first, then the nearest is refined."""
    tips = np.array([_tip(point, move) for point in move.points])
    curve = Nurbs(move.degree, tips, move.knots, move.weights)
    u = np.linspace(curve.first, curve.last, 4001)
    samples = curve.raw(u, 0)[0]
    worst = 0.0
    for vertex in vertices:
        gaps = np.sum((samples - vertex) ** 2, axis=1)
        # Where the curve turns back sharply, the nearest sample may lie on the wrong branch: refine all low points.
        low_points = [i for i in np.argsort(gaps)[:12] if gaps[i] <= min(gaps[max(i - 1, 0)], gaps[min(i + 1, len(u) - 1)])]
        worst = max(worst, min(_refined(curve, vertex, u[max(i - 1, 0)], u[min(i + 1, len(u) - 1)]) for i in low_points))
    return worst


def _refined(curve: Nurbs, vertex: np.ndarray[Any, np.dtype[np.float64]], low: float, high: float) -> float:
    """Return the least distance of a point from a short piece of a curve [mm]."""
    gaps = np.empty(0)
    for _ in range(8):
        tried = np.linspace(low, high, 21)
        gaps = np.linalg.norm(curve.raw(tried, 0)[0] - vertex, axis=1)
        best = int(np.argmin(gaps))
        low, high = tried[max(best - 1, 0)], tried[min(best + 1, 20)]
    return float(gaps.min())


def modes(file: Path) -> list[tuple[str, float | None, float | None]]:
    """Return path control, tolerance and tolerance of joined lines [mm] at each of the interpreter's moves."""
    done = subprocess.run(["rs274", "-g", str(file)], capture_output=True, text=True, errors="replace", timeout=60, cwd=file.parent)
    unit, found = 1.0, []
    control: tuple[str, float | None, float | None] = ("exact_path", None, None)
    for call, arguments in re.findall(r"N\S*\s+([A-Z_0-9]+)\((.*)\)", done.stdout):
        if call == "USE_LENGTH_UNITS":
            unit = 25.4 if "INCH" in arguments else 1.0
        elif call == "SET_MOTION_CONTROL_MODE":
            name, *tolerance = arguments.split(",")
            kind = {"CANON_EXACT_STOP": "exact_stop", "CANON_EXACT_PATH": "exact_path", "CANON_CONTINUOUS": "blend"}[name]
            control = (kind, float(tolerance[0]) * unit, None) if tolerance and kind == "blend" else (kind, None, None)
        elif call == "SET_NAIVECAM_TOLERANCE":
            control = (*control[:2], float(arguments) * unit)
        elif call in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "ARC_FEED") or call.startswith("NURBS"):
            found.append(control)
    return found


def compare(oracle: ModuleType, file: Path, *, backend: str = "gcode", tools: Path | None = None) -> tuple[int, str]:
    """Compare move by move up to the line that both refuse; return the number of moves and the difference, empty if there is none."""
    options = {} if backend == "gcode" or tools is None else {"tool": str(tools)}
    theirs, complaint = their_moves(oracle, file, backend, **options)
    text = file.read_text(encoding="latin-1")
    made, error = our_moves(text, file.parent, tools)
    if bool(complaint) != (error is not None):
        return len(made), f"ours: {error}\n    theirs: {complaint or 'accepted'}"
    if error is not None and backend == "gcode":
        in_subprogram = re.search(r"(?im)^ *o.* call", text)  # a fault there is reported at the line of the call
        # LinuxCNC reports an unreadable line as the next one, and a missing end at the end of the text.
        if refused_line(complaint) - error.line not in (0, 1) and "has no end" not in error.message and not in_subprogram:
            return len(made), f"refused on different lines: ours {error}\n    theirs: {complaint}"
        # Moves that a refused block made before its fault do not count.
        made = [m for m in made if m.move.source_line != error.line]
        theirs = [t for t in theirs if t["line"] != error.line]
    exact = backend == "gcode"
    wrong = difference(made, theirs, exact=exact, inches="G20" in text.upper())
    if wrong and exact:
        # If heights agree up to the last bit, there may be a zero-length move more or less.
        wrong = difference([m for m in made if not _is_stop(m.move)], _without_stops(theirs), exact=True)
    return len(made), wrong


def _is_stop(move: Move) -> bool:
    return isinstance(move, Traverse | Feed) and math.dist(move.start, move.end) < 1e-12


def _without_stops(theirs: Theirs) -> Theirs:
    return [t for t in theirs if t["kind"] not in ("traverse", "feed") or t.get("start_unknown") or math.dist(t["start"], t["end"]) > 1e-9]
