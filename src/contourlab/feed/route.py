"""A path with feedrates, dwells and tolerances for each of its curves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import FeedError, ProgramError
from contourlab.feed.correspondence import Correspondence, place_on_programmed
from contourlab.geometry import Arc, BSpline, Curve, Line, Nurbs, Path
from contourlab.geometry.nurbs import cut_where_curvature_jumps
from contourlab.program import Arc as ArcMove
from contourlab.program import Dwell, Program, Spline, Traverse

Array = NDArray[np.float64]
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
"""Data of each curve, and their types."""


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
        The path to be driven.
    feedrate : array_like (n_curve,) [m/s], > 0
        Along the path; inf on rapid curves, where only the machine's limits count.
    rapid : array_like (n_curve,) of bool
    dwell : array_like (n_curve,) [s], >= 0
        Time at rest after each curve.
    source_line : array_like (n_curve,) of int
        Line of the program, from 1; 0 where there is none.
    programmed : Path, optional
        The path as programmed, where `path` deviates from it (blended corners); by default the same.
    dwell_before : float [s], >= 0
        Time at rest before the first curve.
    corner_tolerance : array_like (n_curve,) [m], >= 0
        How far the corner at the end of each curve may be cut (G64 P); 0 where it is met exactly. See `blended`.
    merge_tolerance : array_like (n_curve,) [m], >= 0
        How far points between lines may be missed when they are merged (G64 Q); 0 where none are.
    exact_stop : array_like (n_curve,) of bool
        Whether the motion stops at the end of each curve even where the path goes on smoothly (G61.1).
    correspondence : Correspondence, optional
        Which programmed place belongs to a planned one, where the two paths differ.

    Raises
    ------
    FeedError
        If a feedrate is not positive, a dwell or a tolerance negative, or a length does not fit the path.
    """

    path: Path
    feedrate: Array
    rapid: NDArray[np.bool_]
    dwell: Array
    source_line: NDArray[np.int64]
    programmed: Path = None  # type: ignore[assignment]  # replaced by `path` below
    dwell_before: float = 0.0
    corner_tolerance: Array = 0.0  # type: ignore[assignment]  # one for each curve below
    merge_tolerance: Array = 0.0  # type: ignore[assignment]
    exact_stop: NDArray[np.bool_] = False  # type: ignore[assignment]
    correspondence: Correspondence | None = None

    def __post_init__(self) -> None:
        n_curve = len(self.path.curves)
        for name, dtype in _PER_CURVE.items():
            object.__setattr__(self, name, _per_curve(name, getattr(self, name), n_curve, dtype))
        object.__setattr__(self, "programmed", self.programmed or self.path)
        good = (self.feedrate > 0.0) & (np.isfinite(self.feedrate) | self.rapid)
        if not np.all(good):
            worst = int(np.argmin(good))
            line = f" (line {self.source_line[worst]})" if self.source_line[worst] else ""
            raise FeedError(
                f"feedrate of curve {worst}{line} is {self.feedrate[worst]:g} m/s: "
                "it must be finite and > 0 (inf on rapid curves only)"
            )
        if not (np.all(np.isfinite(self.dwell) & (self.dwell >= 0.0)) and 0.0 <= self.dwell_before < np.inf):
            raise FeedError("dwell: every time at rest must be finite and >= 0 s")
        for name in ("corner_tolerance", "merge_tolerance"):
            values = getattr(self, name)
            if not np.all(np.isfinite(values) & (values >= 0.0)):
                raise FeedError(f"{name}: every tolerance must be finite and >= 0 m")

    @property
    def n_curve(self) -> int:
        """Number of curves."""
        return len(self.path.curves)

    def programmed_arc_length(self, s: ArrayLike) -> Array:
        """Return the arc lengths (n,) [m] on `programmed` that belong to arc lengths (n,) [m] on `path`."""
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
    n_curve = len(path.curves)
    after = np.zeros(n_curve)
    after[-1] = dwell
    none = np.zeros(n_curve, dtype=np.int64)
    return Route(path, np.full(n_curve, feedrate), none.astype(bool), after, none, programmed or path)


def _axis_columns(axes: Sequence[str]) -> list[int]:
    letters = [axis.lower() for axis in axes]
    if not letters or len(set(letters)) != len(letters) or not set(letters) <= set("xyz"):
        raise FeedError(f"axes = {tuple(axes)}: name each linear axis that the program moves once, of x, y, z")
    return ["xyz".index(letter) for letter in letters]


def _point(values: Sequence[float], columns: list[int]) -> Array:
    return np.array([values[column] for column in columns])


def _moved(move: Any) -> list[int]:
    """Return the axes (0 = x, 1 = y, 2 = z) that a move moves."""
    if isinstance(move, ArcMove):
        found = {i for unit in move.directions()[:2] for i in range(3) if unit[i]}
    elif isinstance(move, Spline):
        found = {i for point in move.points for i in range(3) if point[i] != move.start[i]}
    else:
        found = set()
    return sorted(found | {i for i in range(3) if move.start[i] != move.end[i]})


def _check_axes(program: Program, move: Any, columns: list[int]) -> None:
    """Refuse a move of an axis that the machine lacks."""
    if len(columns) == len("xyz"):
        return
    moved = [column for column in _moved(move) if column not in columns]
    if moved:
        names = ", ".join("XYZ"[column] for column in moved)
        have = ", ".join("XYZ"[column] for column in columns)
        raise ProgramError(
            f"the program moves {names}, but the machine has {have} only: give axes for {names}, or remove the move",
            file=program.name,
            line=move.source_line,
        )


def _spline(move: Spline, columns: list[int]) -> list[Curve]:
    """Return the spline of a move in the machine's axes, cut where its curvature jumps."""
    points = np.array([_point(point, columns) for point in move.points])
    if len(set(move.weights)) == 1:
        return cut_where_curvature_jumps(BSpline(move.degree, points, move.knots))
    return cut_where_curvature_jumps(Nurbs(move.degree, points, move.knots, move.weights))


def _arc(move: ArcMove, columns: list[int]) -> Curve:
    """Return the arc or helix of a move, in the machine's axes; it joins the programmed ends exactly."""
    u, v = (_point(unit, columns) for unit in move.directions()[:2])
    start, end, centre = (_point(point, columns) for point in (move.start, move.end, move.centre))
    return Arc.through(start, end, centre, move.sweep, u, v)


class _Row(NamedTuple):
    """Data of one move's curve."""

    feedrate: float
    rapid: bool
    source_line: int
    corner_tolerance: float
    merge_tolerance: float
    exact_stop: bool


def _row(move: Any, default_tolerance: float) -> _Row:
    mode, rapid = move.mode, isinstance(move, Traverse)
    corner = merge = 0.0
    if mode.control == "blend":
        corner = default_tolerance if mode.tolerance is None else mode.tolerance
        merge = default_tolerance if mode.tolerance is None else mode.merge or 0.0
    return _Row(np.inf if rapid else move.feedrate, rapid, move.source_line, corner, merge, mode.control == "exact_stop")


def route_from_program(program: Program, axes: Sequence[str] = ("x", "y", "z"), *, default_tolerance: float = 0.0) -> Route:
    """Return the route of a part program, as programmed: `blended` rounds its corners within their tolerances.

    Moves without length are left out, their dwell is kept. A traverse (G0) is a straight line at rapid rate. The tolerance of a corner is
    that of the move that ends there. The motion rests for spindle, tool, coolant and pauses.

    Parameters
    ----------
    program : Program
    axes : sequence of str
        The machine's linear axes in their order, of ``x``, ``y``, ``z``.
    default_tolerance : float [m], >= 0
        Of corners, and of merged lines, under G64 without P; 0 meets them exactly.

    Returns
    -------
    Route

    Raises
    ------
    ProgramError
        If the program moves an axis that is not among `axes`; names the line.
    FeedError
        If the program moves nothing, or `axes` is wrong.
    """
    columns = _axis_columns(axes)
    rests = {event.after for event in program.events if event.rests}
    bent: dict[int, Curve] = {}
    ends: list[tuple[Sequence[float], Sequence[float]]] = []
    rows: list[_Row] = []
    dwell: list[float] = []
    before = 0.0
    for number, move in enumerate(program.moves):
        if number in rests and rows:
            rows[-1] = rows[-1]._replace(exact_stop=True)
        if isinstance(move, Dwell):
            if rows:
                dwell[-1] += move.seconds
            else:
                before += move.seconds
            continue
        _check_axes(program, move, columns)
        row = _row(move, default_tolerance)
        if isinstance(move, Spline):
            for piece in _spline(move, columns):
                bent[len(rows)] = piece
                ends.append((move.start, move.end))  # replaced by the curve
                rows.append(row._replace(exact_stop=False))
                dwell.append(0.0)
            rows[-1] = row
            continue
        if isinstance(move, ArcMove):
            bent[len(rows)] = _arc(move, columns)
        elif all(move.start[column] == move.end[column] for column in columns):
            continue
        ends.append((move.start, move.end))
        rows.append(row)
        dwell.append(0.0)
    if not rows:
        raise FeedError(f"{program.name}: the program moves no axis: there is nothing to drive along")
    path = Path(_curves(np.array(ends)[:, :, columns], bent))
    per_curve: dict[str, Any] = {name: np.array(column) for name, column in zip(_Row._fields, zip(*rows, strict=True), strict=True)}
    return Route(path, dwell=np.array(dwell), programmed=path, dwell_before=before, **per_curve)


def _curves(ends: Array, bent: dict[int, Curve]) -> list[Curve]:
    """Return a line between each pair of ends (n, 2, n_axis), or the given curve."""
    straight = [i for i in range(len(ends)) if i not in bent]
    lines = dict(zip(straight, Line.many(ends[straight, 0], ends[straight, 1]), strict=True)) if straight else {}
    return [bent[i] if i in bent else lines[i] for i in range(len(ends))]


def controlled(route: Route, control: PathControl, corner_tolerance: float, merge_tolerance: float | None = None) -> Route:
    """Return a route that meets all its corners in one way.

    Parameters
    ----------
    route : Route
    control : {"program", "exact_path", "exact_stop", "blend"}
        ``"program"`` leaves the route as it is; ``"exact_path"`` (G61) meets every corner exactly and stops where the direction jumps;
        ``"exact_stop"`` (G61.1) stops at the end of every curve; ``"blend"`` (G64) rounds every corner.
    corner_tolerance : float [m], >= 0
        How far a blend may leave its corner.
    merge_tolerance : float [m], >= 0, optional
        How far points of merged lines may lie off; as `corner_tolerance` where it is not given.

    Raises
    ------
    FeedError
        If the control is unknown.

    Notes
    -----
    `contourlab.feed.blended` does the rounding and the merging.
    """
    if control == "program":
        return route
    none = np.zeros(route.n_curve)
    if control == "exact_path":
        return replace(route, corner_tolerance=none, merge_tolerance=none, exact_stop=none.astype(bool))
    if control == "exact_stop":
        return replace(route, corner_tolerance=none, merge_tolerance=none, exact_stop=np.ones(route.n_curve, dtype=bool))
    if control == "blend":
        merge = corner_tolerance if merge_tolerance is None else merge_tolerance
        return replace(route, corner_tolerance=none + corner_tolerance, merge_tolerance=none + merge, exact_stop=none.astype(bool))
    raise FeedError(f"path control {control!r}: one of program, exact_path, exact_stop, blend")
