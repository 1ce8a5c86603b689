"""A path with feedrates, dwells and tolerances for each of its curves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal, NamedTuple, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.arrays import Array, Flags, Index
from contourlab.contours.shapes import spline_curves
from contourlab.errors import FeedError, GeometryError, ProgramError
from contourlab.feed.correspondence import Correspondence, place_on_programmed
from contourlab.geometry import Arc, Curve, Line, Path
from contourlab.program import Arc as ArcMove
from contourlab.program import Dwell, Program, Spline, Traverse

LONGEST = 1e6
"""Longest path [m]; beyond, planning meets the end of floating-point numbers."""
PathControl: TypeAlias = Literal["program", "exact_path", "exact_stop", "blend"]
_PER_CURVE: dict[str, Any] = {
    "feedrate": float,
    "rapid": bool,
    "dwell": float,
    "source_line": np.int64,
    "corner_tolerance": float,
    "merge_tolerance": float,
    "exact_stop": bool,
}
"""Types of the data of each curve."""


def _per_curve(name: str, value: ArrayLike, n_curve: int, dtype: Any) -> NDArray[Any]:
    array = np.array(value, dtype=dtype)
    if array.shape not in ((), (1,), (n_curve,)):
        raise FeedError(f"{name} has shape {array.shape}: give one value, or one for each of the {n_curve} curves")
    array = np.array(np.broadcast_to(array, (n_curve,)))
    array.flags.writeable = False
    return array


@dataclass(frozen=True, eq=False)
class Route:
    """A path and how to drive along each of its curves.

    Parameters
    ----------
    path : Path
        The path to drive.
    feedrate : array_like (n_curve,) [m/s], > 0
        Along the path; inf on rapid curves, where only the machine's limits apply.
    rapid : array_like (n_curve,) of bool
    dwell : array_like (n_curve,) [s], >= 0
        Time at rest after each curve.
    source_line : array_like (n_curve,) of int
        Program line, from 1; 0 for none.
    programmed : Path, optional
        The programmed path, where `path` deviates from it (blended corners).
    dwell_before : float [s], >= 0
        Time at rest before the first curve.
    corner_tolerance : array_like (n_curve,) [m], >= 0
        Permitted deviation at the corner at the end of each curve (G64 P). See `blended`.
    merge_tolerance : array_like (n_curve,) [m], >= 0
        Permitted deviation of points between merged lines (G64 Q).
    exact_stop : array_like (n_curve,) of bool
        Whether the motion stops at the end of each curve even where the path is smooth (G61.1).
    correspondence : Correspondence, optional
        Map from `path` to `programmed`, where they differ.

    Raises
    ------
    FeedError
        If a feedrate is not positive, a dwell or a tolerance negative, a length does not fit the path, or the path is too long.
    """

    path: Path
    feedrate: Array
    rapid: Flags
    dwell: Array
    source_line: Index
    programmed: Path = None  # type: ignore[assignment]  # set in __post_init__
    dwell_before: float = 0.0
    corner_tolerance: Array = 0.0  # type: ignore[assignment]  # one value per curve after __post_init__
    merge_tolerance: Array = 0.0  # type: ignore[assignment]
    exact_stop: Flags = False  # type: ignore[assignment]
    correspondence: Correspondence | None = None

    def __post_init__(self) -> None:
        n_curve = len(self.path.curves)
        if not self.path.length <= LONGEST:
            raise FeedError(f"the path is {self.path.length:.4g} m long: give at most {LONGEST:g} m; is its unit right?")
        for name, dtype in _PER_CURVE.items():
            object.__setattr__(self, name, _per_curve(name, getattr(self, name), n_curve, dtype))
        object.__setattr__(self, "programmed", self.programmed or self.path)
        good = (self.feedrate > 0.0) & (np.isfinite(self.feedrate) | self.rapid)
        if not np.all(good):
            worst = int(np.argmin(good))
            line = f" (line {self.source_line[worst]})" if self.source_line[worst] else ""
            raise FeedError(
                f"feedrate of curve {worst}{line} is {self.feedrate[worst]:g} m/s: it must be finite and > 0 (inf on rapid curves only)"
            )
        if not (np.all(np.isfinite(self.dwell) & (self.dwell >= 0.0)) and 0.0 <= self.dwell_before < np.inf):
            raise FeedError("dwell: each must be finite and >= 0 s")
        for name in ("corner_tolerance", "merge_tolerance"):
            values = getattr(self, name)
            if not np.all(np.isfinite(values) & (values >= 0.0)):
                raise FeedError(f"{name}: each must be finite and >= 0 m")

    @property
    def n_curve(self) -> int:
        """Number of curves."""
        return len(self.path.curves)

    def programmed_arc_length(self, s: ArrayLike) -> Array:
        """Return the arc lengths (n,) [m] on `programmed` for arc lengths (n,) [m] on `path`."""
        return place_on_programmed(self.correspondence, self.path, self.programmed, s)


def route_from_path(path: Path, feedrate: float, *, dwell: float = 0.0, programmed: Path | None = None) -> Route:
    """Return the route along a path at one feedrate.

    Parameters
    ----------
    path : Path
    feedrate : float [m/s], > 0
    dwell : float [s], >= 0
        Time at rest at the end.
    programmed : Path, optional

    Returns
    -------
    Route

    Raises
    ------
    FeedError
        If the feedrate is not positive.
    """
    dwells = np.zeros(len(path.curves))
    dwells[-1] = dwell
    return Route(path, np.asarray(feedrate), np.asarray(False), dwells, np.asarray(0), programmed or path)


def _axis_columns(axes: Sequence[str]) -> list[int]:
    letters = [axis.lower() for axis in axes]
    if not letters or len(set(letters)) != len(letters) or not set(letters) <= set("xyz"):
        raise FeedError(f"axes = {tuple(axes)}: write some of x, y, z, each once")
    return ["xyz".index(letter) for letter in letters]


def _point(values: Sequence[float], columns: list[int]) -> Array:
    return np.array([values[column] for column in columns])


def _moved(move: Any) -> list[int]:
    """Return the axes (0 = x, 1 = y, 2 = z) that a move moves."""
    if isinstance(move, ArcMove):
        return [i for i in range(3) if any(unit[i] for unit in move.directions()[:2]) or move.start[i] != move.end[i]]
    points = (*move.points, move.end) if isinstance(move, Spline) else (move.end,)
    return [i for i in range(3) if any(point[i] != move.start[i] for point in points)]


def _check_axes(program: Program, move: Any, columns: list[int]) -> None:
    """Raise an error for a move of an axis that the machine lacks."""
    missing = [] if len(columns) == 3 else [column for column in _moved(move) if column not in columns]
    if missing:
        names, have = (", ".join("XYZ"[column] for column in some) for some in (missing, columns))
        raise ProgramError(
            f"the program moves {names}, but the machine has {have} only: give axes for {names}, or remove the move",
            file=program.name,
            line=move.source_line,
        )


def _bent_curves(move: Any, columns: list[int]) -> list[Curve]:
    """Return the curves of an arc, helix or spline in the machine's axes; none for a straight move."""
    if isinstance(move, ArcMove):
        u, v = (_point(unit, columns) for unit in move.directions()[:2])
        start, end, centre = (_point(point, columns) for point in (move.start, move.end, move.centre))
        return [Arc.through(start, end, centre, move.sweep, u, v)]
    if not isinstance(move, Spline):
        return []
    points = np.array([_point(point, columns) for point in move.points])
    return spline_curves(move.degree, points, np.array(move.knots), np.array(move.weights))


class _Row(NamedTuple):
    """Data of one curve."""

    feedrate: float
    rapid: bool
    source_line: int
    corner_tolerance: float
    merge_tolerance: float
    exact_stop: bool
    dwell: float = 0.0


def _row(move: Any, default_tolerance: float) -> _Row:
    mode, rapid = move.mode, isinstance(move, Traverse)
    corner = merge = 0.0
    if mode.control == "blend":
        corner = default_tolerance if mode.tolerance is None else mode.tolerance
        merge = default_tolerance if mode.tolerance is None else mode.merge or 0.0
    return _Row(np.inf if rapid else move.feedrate, rapid, move.source_line, corner, merge, mode.control == "exact_stop")


def route_from_program(program: Program, axes: Sequence[str] = ("x", "y", "z"), *, default_tolerance: float = 0.0) -> Route:
    """Return the route of a part program, as programmed; `blended` then rounds its corners.

    A traverse (G0) is a straight line at rapid rate. The move that ends at a corner sets its tolerance. The motion stops for spindle, tool,
    coolant and pauses.

    Parameters
    ----------
    program : Program
    axes : sequence of str
        The machine's linear axes in their order: ``x``, ``y``, ``z`` or some of them.
    default_tolerance : float [m], >= 0
        For corners and merged lines under G64 without P.

    Returns
    -------
    Route

    Raises
    ------
    ProgramError
        If the program moves an axis that is not in `axes`, or a spline has a cusp; the error names the line.
    FeedError
        If the program moves nothing, or `axes` is wrong.
    """
    columns = _axis_columns(axes)
    rests = {event.after for event in program.events if event.rests}
    curves: list[Curve | None] = []  # None: a straight line
    ends: list[tuple[Sequence[float], Sequence[float]]] = []  # of the straight lines
    rows: list[_Row] = []
    before = 0.0
    for number, move in enumerate(program.moves):
        if number in rests and rows:
            rows[-1] = rows[-1]._replace(exact_stop=True)
        if isinstance(move, Dwell):
            if rows:
                rows[-1] = rows[-1]._replace(dwell=rows[-1].dwell + move.seconds)
            else:
                before += move.seconds
            continue
        _check_axes(program, move, columns)
        row = _row(move, default_tolerance)
        try:
            bent = _bent_curves(move, columns)
        except GeometryError as error:
            cure = "move the control points, or write two splines"
            raise ProgramError(f"the motion cannot be planned: {error}: {cure}", file=program.name, line=move.source_line) from error
        if bent:
            curves += bent
            rows += [*[row._replace(exact_stop=False)] * (len(bent) - 1), row]
        elif any(move.start[column] != move.end[column] for column in columns):
            curves.append(None)
            ends.append((move.start, move.end))
            rows.append(row)
    if not rows:
        raise FeedError(f"{program.name}: the program moves no axis: add a move")
    starts, stops = np.array(ends).reshape(-1, 2, 3)[:, :, columns].transpose(1, 0, 2)
    lines = iter(Line.many(starts, stops))
    path = Path([next(lines) if curve is None else curve for curve in curves])
    per_curve: dict[str, Any] = {name: np.array(column) for name, column in zip(_Row._fields, zip(*rows, strict=True), strict=True)}
    return Route(path, programmed=path, dwell_before=before, **per_curve)


def controlled(route: Route, control: PathControl, corner_tolerance: float, merge_tolerance: float | None = None) -> Route:
    """Return a route with one path control for all corners; `blended` does the rounding and merging.

    Parameters
    ----------
    control : {"program", "exact_path", "exact_stop", "blend"}
        ``"program"`` changes nothing; ``"exact_path"`` (G61) stops where the direction jumps; ``"exact_stop"`` (G61.1) stops at
        the end of every curve; ``"blend"`` (G64) rounds every corner.
    corner_tolerance : float [m], >= 0
        Largest deviation of a blend from its corner.
    merge_tolerance : float [m], >= 0, optional
        Largest deviation of points from merged lines; by default `corner_tolerance`.

    Raises
    ------
    FeedError
        If the control is unknown.
    """
    if control not in get_args(PathControl):
        raise FeedError(f"unknown path control {control!r}: use one of {', '.join(get_args(PathControl))}")
    if control == "program":
        return route
    corner = corner_tolerance if control == "blend" else 0.0
    merge = corner if merge_tolerance is None or control != "blend" else merge_tolerance
    stop = np.asarray(control == "exact_stop")
    return replace(route, corner_tolerance=np.asarray(corner), merge_tolerance=np.asarray(merge), exact_stop=stop)
