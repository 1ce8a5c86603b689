"""``contourlab canon``: the moves of a part program as a canonical list."""

from __future__ import annotations

import json
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, TextIO, TypedDict

from contourlab.app.session import QUIET, Answer, Asked, Session
from contourlab.features.check import options
from contourlab.features.check.program_check import about_reading
from contourlab.features.check.reading import reading_of
from contourlab.program import Arc, Dwell, Feed, Move, Plane, Point, Reader, Reading, Spline, Traverse, open_program
from contourlab.rendering.table import paragraphs

_KINDS = {Traverse: "traverse", Feed: "feed", Arc: "arc", Spline: "nurbs", Dwell: "dwell"}
_CONTROLS = {None: "exact_path", "exact_path": "exact_path", "exact_stop": "exact_stop", "blend": "continuous"}
_PLANES: dict[Plane, str] = {"XY": "XY", "YZ": "YZ", "ZX": "XZ"}
IN_MEMORY = 16_000_000
"""Characters of output to hold in memory; a longer output goes to a temporary file until the whole program is read."""


class CanonDwell(TypedDict):
    """A dwell.

    Attributes
    ----------
    line : int
        Line of the program.
    """

    kind: Literal["dwell"]
    seconds: float
    line: int


class CanonMove(TypedDict):
    """A straight move of the tool tip, in machine coordinates.

    Attributes
    ----------
    start, end : (float, float, float) [mm]
    abc : (float, float, float)
        Always 0: there are no rotary axes.
    feed : float [mm/min]
        Feed in force; a traverse does not use it.
    line : int
        Line of the program.
    blend_tol : float or None [mm]
        Null in exact path and exact stop; 0 for G64 without P.
    tlo : (float, float, float) [mm]
        Tool offset; not included in the positions.
    """

    kind: Literal["traverse", "feed", "arc", "nurbs"]
    start: list[float]
    end: list[float]
    abc: list[float]
    feed: float
    line: int
    path_mode: Literal["exact_path", "exact_stop", "continuous"]
    blend_tol: float | None
    tlo: list[float]


class CanonArc(CanonMove):
    """An arc or helix.

    Attributes
    ----------
    centre : (float, float, float) [mm]
        At the height of the end.
    turns : int
        Positive counterclockwise.
    """

    plane: Literal["XY", "YZ", "XZ"]
    centre: list[float]
    turns: int


class CanonSpline(CanonMove):
    """A NURBS curve; control points in mm."""

    degree: int
    points: list[list[float]]
    weights: list[float]
    knots: list[float]


class Canon(TypedDict):
    """The moves of a part program, in its order."""

    moves: list[CanonDwell | CanonMove | CanonArc | CanonSpline]


def _shown(point: Point, tool: Point) -> list[float]:
    """Return the tool tip [mm] for axes at a point [m]."""
    return [_mm(a - b) for a, b in zip(point, tool, strict=True)]


def _mm(length: float) -> float:
    # Twelve digits are more than any control prints, and hide rounding such as 0.1 + 0.2.
    return float(f"{length * 1e3:.12g}") + 0.0


def canonical(move: Move, feedrate: float) -> dict[str, Any]:
    """Return a move with the fields of a canonical list.

    Parameters
    ----------
    feedrate : float [m/s]
        Feedrate in force; listed for traverses, which do not use it.

    Returns
    -------
    dict
        A `CanonDwell`, `CanonMove`, `CanonArc` or `CanonSpline`.
    """
    if isinstance(move, Dwell):
        return {"kind": "dwell", "seconds": move.seconds, "line": move.source_line}
    mode = move.mode
    fields: dict[str, Any] = {
        "kind": _KINDS[type(move)],
        "start": _shown(move.start, mode.tool),
        "end": _shown(move.end, mode.tool),
        "abc": [0.0, 0.0, 0.0],
        "feed": float(f"{6e4 * (feedrate if isinstance(move, Traverse) else move.feedrate):.12g}"),
        "line": move.source_line,
        "path_mode": _CONTROLS[mode.control],
        "blend_tol": None if mode.control != "blend" else _mm(mode.tolerance or 0.0),
        "tlo": [_mm(value) for value in mode.tool],
    }
    if isinstance(move, Arc):
        normal = move.directions()[2]
        rise = sum((end - centre) * n for end, centre, n in zip(move.end, move.centre, normal, strict=True))
        x, y, z = (centre + rise * n for centre, n in zip(move.centre, normal, strict=True))
        fields |= {"plane": _PLANES[move.plane], "centre": _shown((x, y, z), mode.tool), "turns": move.turns}
    elif isinstance(move, Spline):
        points = [_shown(point, mode.tool) for point in move.points]
        fields |= {"degree": move.degree, "points": points, "weights": list(move.weights), "knots": list(move.knots)}
    return fields


def canonical_moves(reader: Reader) -> Iterator[dict[str, Any]]:
    """Yield the moves of a reader with the fields of `canonical`."""
    state = reader.state
    for move in reader.moves():
        state.events.clear()  # unused here; there may be one per line
        per_turn = state.speed / 60.0 if state.feed_mode == "per_turn" else 1.0
        yield canonical(move, state.feedrate * per_turn)


@dataclass(frozen=True, eq=False)
class Listed(Answer):
    """The moves of a part program, as a list that may be long.

    Attributes
    ----------
    file : Path
    reading : Reading
        How the program is read.
    """

    file: Path
    reading: Reading

    def __iter__(self) -> Iterator[dict[str, Any]]:
        with open_program(self.file, self.reading, still=True) as reader:
            yield from canonical_moves(reader)

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The moves, one a row."""
        return list(self)

    @property
    def text(self) -> str:
        """The moves, one a line."""
        return "".join(map(_line, self)).rstrip("\n")

    def write(self, out: TextIO, as_json: bool) -> list[str]:
        """Write the moves as lines, or as one JSON document, ``{"moves": [...]}``; nothing if the program has a fault.

        Returns
        -------
        list of str
            Notices of the reader.

        Raises
        ------
        ProgramError
            If the program has a fault, with its line.
        """
        with (
            open_program(self.file, self.reading, still=True) as reader,
            tempfile.SpooledTemporaryFile(IN_MEMORY, "w+", encoding="utf-8") as buffer,
        ):
            buffer.write('{"moves": [' if as_json else "")
            before = "\n"
            for move in canonical_moves(reader):
                buffer.write(before + json.dumps(move) if as_json else _line(move))
                before = ",\n"
            buffer.write("\n]}\n" if as_json else "")
            buffer.seek(0)
            while part := buffer.read(1 << 20):
                out.write(part)
            out.flush()
            about = [paragraphs([str(found)]) for found in about_reading(self.reading)]
            return about + [f"{self.file}:{notice.line}:{notice.column}: {notice.message}" for notice in reader.notices]

    def _next(self, asked: Asked) -> Sequence[object] | None:
        """Check the program; nothing where the output is no terminal."""
        return ["check", self.file, *asked.settings.words()] if sys.stdout.isatty() else None


def canon(file: str | Path, *, settings: options.Canon, session: Session = QUIET) -> Listed:
    """Return the moves of a part program."""
    return Listed(Path(file), reading_of(file, settings))


def _line(move: dict[str, Any]) -> str:
    words = [f"{move['line']:>6}", f"{move['kind']:<8}"]
    if move["kind"] == "dwell":
        return " ".join([*words, f"{move['seconds']:g} s"]) + "\n"
    words += [f"{letter}{value:<9.6g}" for letter, value in zip("XYZ", move["end"], strict=True)]
    if move["kind"] != "traverse":
        words.append(f"F{move['feed']:.6g}")
    if move["kind"] == "arc":
        centre = dict(zip("XYZ", move["centre"], strict=True))
        words += ["about", *(f"{letter}{centre[letter]:.6g}" for letter in move["plane"]), "ccw" if move["turns"] > 0 else "cw"]
        words += [f"{abs(move['turns'])} turns"] if abs(move["turns"]) > 1 else []
    if move["kind"] == "nurbs":
        words.append(f"degree {move['degree']}, {len(move['points'])} control points")
    if move["path_mode"] != "exact_path":
        words.append(move["path_mode"] + (f" {move['blend_tol']:g} mm" if move["blend_tol"] else ""))
    return " ".join(words).rstrip() + "\n"
