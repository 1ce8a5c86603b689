"""A path with feedrates, dwells and tolerances for each of its curves; its map to the programmed path; its junctions.

Junctions are exact stops, curvature jumps and small direction jumps; each has a speed at which it may be passed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal, NamedTuple, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.arrays import Array, Flags, Index
from contourlab.contours.drawing import spline_curves
from contourlab.errors import FeedError, GeometryError, ProgramError, refuse
from contourlab.feed.bounds import AxisLimits
from contourlab.geometry import Arc, Curve, Path
from contourlab.geometry.curve import Curves, interval
from contourlab.geometry.line_and_arc import Lines
from contourlab.geometry.path import CORNER_ANGLE
from contourlab.native.kernel import kernel
from contourlab.program import Arc as ArcMove
from contourlab.program import Dwell, Mode, Program, Spline, Traverse


@kernel("f8[:] f8[:] f8[:] f8[:]")
def _spans(s, planned, programmed, span):  # type: ignore[no-untyped-def]
    """Write the length in `programmed` of the interval of `planned` around each s."""
    k = 0
    for i in range(s.size):
        k = interval(planned, s[i], k)  # type: ignore[no-untyped-call]
        span[i] = programmed[k + 1] - programmed[k]


@dataclass(frozen=True, eq=False)
class Correspondence:
    """A piecewise linear map from arc length on the planned path to arc length on the programmed path.

    Parameters
    ----------
    planned, programmed : array_like (n_node,) [m], strictly rising
        `planned` starts and ends with the planned path. On a closed path the map repeats lap by lap.

    Raises
    ------
    FeedError
        If there are fewer than two nodes, or they do not rise.
    """

    planned: Array
    programmed: Array

    def __post_init__(self) -> None:
        for name in ("planned", "programmed"):
            values = np.array(getattr(self, name), dtype=float)
            if values.ndim != 1 or values.size < 2 or not np.all(np.diff(values) > 0.0):
                raise FeedError(f"{name}: give two or more strictly rising nodes")
            values.flags.writeable = False
            object.__setattr__(self, name, values)
        if self.planned.size != self.programmed.size:
            raise FeedError(f"{self.planned.size} planned and {self.programmed.size} programmed nodes: give the same number of each")

    def _laps(self, s: ArrayLike) -> tuple[Array, Array]:
        along, lap = np.atleast_1d(np.asarray(s, dtype=float)), self.planned[-1] - self.planned[0]
        number = np.floor((along - self.planned[0]) / lap)
        return along - number * lap, number * (self.programmed[-1] - self.programmed[0])

    def __call__(self, s: ArrayLike) -> Array:
        """Return the programmed arc lengths (n,) [m] of planned ones (n,) [m]."""
        along, lap = self._laps(s)
        return np.asarray(np.interp(along, self.planned, self.programmed) + lap)

    def span(self, s: ArrayLike) -> Array:
        """Return the length on the programmed path (n,) [m] of the node interval around each planned arc length (n,)."""
        along, _ = self._laps(s)
        span = np.empty(along.size)
        _spans(along, self.planned, self.programmed, span)
        return span

    def after(self, first: Correspondence) -> Correspondence:
        """Compose: apply `first`, then this map."""
        # A lap of `first` may start anywhere on a lap of this map, so it can span the nodes of two laps.
        inner = np.concatenate([self.planned, self.planned[1:] + (self.planned[-1] - self.planned[0])])
        inner = inner[(inner > first.programmed[0]) & (inner < first.programmed[-1])]
        nodes = np.unique(np.concatenate([first.planned, np.interp(inner, first.programmed, first.planned)]))
        values = self(first(nodes))
        # Merge nodes that differ by rounding alone.
        values = np.minimum(np.maximum.accumulate(values), values[-1])
        keep = np.append(True, np.diff(values) > 0.0)
        nodes, values = nodes[keep], values[keep]
        nodes[-1] = first.planned[-1]
        return Correspondence(nodes, values)


def place_on_programmed(correspondence: Correspondence | None, path: Path, programmed: Path, s: ArrayLike) -> Array:
    """Return programmed arc lengths (n,) of planned ones (n,); without a map, in proportion to the path lengths."""
    if correspondence is not None:
        return correspondence(s)
    return np.atleast_1d(np.asarray(s, dtype=float)) * (1.0 if programmed is path else programmed.length / path.length)


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


class Course(NamedTuple):
    """What the planner of a control makes of each curve of a route.

    Parameters
    ----------
    nominal, top : ndarray (n_curve,) [m/s]
        Speed without the neighbours, with the feedrate and without it.
    steep : ndarray (n_curve,) [m/s^2]
        Acceleration along the curve.
    corner : ndarray (n_curve,) [m/s]
        Largest speed at the end of the curve, 0 at stops.
    counts : ndarray (n_curve,)
        1 for a move in the buffer of the control, 0 for what belongs to another.
    """

    nominal: Array
    top: Array
    steep: Array
    corner: Array
    counts: Array


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
    source_line : array_like (n,) of int
        Program line of each curve of `programmed`, from 1; 0 for none.
    programmed : Path, optional
        The programmed path, where `path` deviates from it (blended corners).
    dwell_before : float [s], >= 0
        Time at rest before the first curve.
    corner_tolerance : array_like (n_curve,) [m], >= 0
        Permitted deviation at the corner at the end of each curve (G64 P); inf for G64 without a bound, as LinuxCNC alone plans it. See
        `blended`.
    merge_tolerance : array_like (n_curve,) [m], >= 0
        Permitted deviation of points between merged lines (G64 Q).
    exact_stop : array_like (n_curve,) of bool
        Whether the motion stops at the end of each curve even where the path is smooth (G61.1).
    correspondence : Correspondence, optional
        Map from `path` to `programmed`, where they differ.
    course : Course, optional
        What the planner of a control makes of it, where `blended` has found that.

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
    course: Course | None = None

    def __post_init__(self) -> None:
        n_curve = len(self.path.curves)
        if not self.path.length <= LONGEST:
            raise FeedError(f"the path is {self.path.length:.4g} m long: give at most {LONGEST:g} m; is its unit right?")
        object.__setattr__(self, "programmed", self.programmed or self.path)
        for name, dtype in _PER_CURVE.items():
            n = len(self.programmed.curves) if name == "source_line" else n_curve
            object.__setattr__(self, name, _per_curve(name, getattr(self, name), n, dtype))
        good = (self.feedrate > 0.0) & (np.isfinite(self.feedrate) | self.rapid)
        if not np.all(good):
            worst = int(np.argmin(good))
            line = f" (line {self.source_line[worst]})" if self.programmed is self.path and self.source_line[worst] else ""
            raise FeedError(
                f"feedrate of curve {worst}{line} is {self.feedrate[worst]:g} m/s: it must be finite and > 0 (inf on rapid curves only)"
            )
        if not (np.all(np.isfinite(self.dwell) & (self.dwell >= 0.0)) and 0.0 <= self.dwell_before < np.inf):
            raise FeedError("dwell: each must be finite and >= 0 s")
        for name in ("corner_tolerance", "merge_tolerance"):
            values = getattr(self, name)
            bounded = np.isfinite(values) | (name == "corner_tolerance")
            refuse(not np.all(bounded & (values >= 0.0)), FeedError, f"{name}: each must be finite and >= 0 m")

    @property
    def n_curve(self) -> int:
        """Number of curves."""
        return len(self.path.curves)

    def within(self, path_velocity: float) -> Route:
        """Return the route with no feedrate above a velocity along the path [m/s], rapids included."""
        return self if np.all(self.feedrate <= path_velocity) else replace(self, feedrate=np.minimum(self.feedrate, path_velocity))

    def programmed_arc_length(self, s: ArrayLike) -> Array:
        """Return the arc lengths (n,) [m] on `programmed` for arc lengths (n,) [m] on `path`."""
        return place_on_programmed(self.correspondence, self.path, self.programmed, s)

    @property
    def line_breaks(self) -> Array:
        """Where on `path` the curves of `programmed` begin, and the last one ends (n + 1,) [m]."""
        if self.correspondence is None:
            return self.programmed.breaks * (self.path.length / self.programmed.length)
        return Correspondence(self.correspondence.programmed, self.correspondence.planned)(self.programmed.breaks)


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


def _point(values: Sequence[float], columns: list[int]) -> Array:
    return np.array([values[column] for column in columns])


def _check_axes(program: Program, move: Any, columns: list[int]) -> None:
    """Raise an error for a move of an axis (0 = x, 1 = y, 2 = z) that the machine lacks."""
    if len(columns) == 3:
        return
    turning = move.directions()[:2] if isinstance(move, ArcMove) else ()
    points = (*move.points, move.end) if isinstance(move, Spline) else (move.end,)
    absent = (i for i in range(3) if i not in columns)
    missing = [i for i in absent if any(unit[i] for unit in turning) or any(point[i] != move.start[i] for point in points)]
    if missing:
        names, have = (", ".join("XYZ"[column] for column in some) for some in (missing, columns))
        raise ProgramError(
            f"CL819 the program moves {names}, but the machine has {have} only: give axes for {names}, or remove the move",
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


def _row(move: Any, mode: Mode, default_tolerance: float, default_control: str) -> _Row:
    rapid = isinstance(move, Traverse)
    corner = merge = 0.0
    if (mode.control or default_control) == "blend":
        corner = default_tolerance if mode.tolerance is None else mode.tolerance
        merge = np.nan_to_num(default_tolerance, posinf=0.0) if mode.tolerance is None else mode.merge or 0.0
    return _Row(np.inf if rapid else move.feedrate, rapid, move.source_line, corner, merge, mode.control == "exact_stop")


def route_from_program(
    program: Program,
    axes: Sequence[str] = ("x", "y", "z"),
    *,
    default_tolerance: float = 0.0,
    default_control: PathControl = "exact_path",
    mode: Mode | None = None,
) -> Route:
    """Return the route of a part program, as programmed; `blended` then rounds its corners.

    A traverse (G0) is a straight line at rapid rate. The move that ends at a corner sets its tolerance. The motion stops for spindle, tool,
    coolant and pauses.

    Parameters
    ----------
    program : Program
    axes : sequence of str
        The machine's linear axes in their order: ``x``, ``y``, ``z`` or some of them.
    default_tolerance : float [m], >= 0
        For corners and merged lines under G64 without P; inf, as LinuxCNC plans, for corners without a bound and no merged lines.
    default_control : {"exact_path", "blend"}
        For moves before the first G61 or G64.
    mode : Mode, optional
        In place of that of each move.

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
    letters = [axis.lower() for axis in axes]
    if not letters or len(set(letters)) != len(letters) or not set(letters) <= set("xyz"):
        raise FeedError(f"axes = {tuple(axes)}: write some of x, y, z, each once")
    columns = ["xyz".index(letter) for letter in letters]
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
        row = _row(move, mode or move.mode, default_tolerance, default_control)
        try:
            bent = _bent_curves(move, columns)
        except GeometryError as error:
            cure = "move the control points, or write two splines"
            raise ProgramError(f"CL819 the motion cannot be planned: {error}: {cure}", file=program.name, line=move.source_line) from error
        if bent:
            curves += bent
            rows += [*[row._replace(exact_stop=False)] * (len(bent) - 1), row]
        elif any(move.start[column] != move.end[column] for column in columns):
            curves.append(None)
            ends.append((move.start, move.end))
            rows.append(row)
    refuse(not rows, FeedError, f"{program.name}: the program moves no axis: add a move")
    starts, stops = np.array(ends).reshape(-1, 2, 3)[:, :, columns].transpose(1, 0, 2)
    others = {i: curve for i, curve in enumerate(curves) if curve is not None}
    lines = (Lines.between(starts, stops), np.setdiff1d(np.arange(len(curves)), list(others)))
    path = Path(Curves([lines, *(Curves.of(others.values()).parts(np.array(list(others))) if others else ())]))
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
    merge = np.nan_to_num(corner, posinf=0.0) if merge_tolerance is None or control != "blend" else merge_tolerance
    stop = np.asarray(control == "exact_stop")
    return replace(route, corner_tolerance=np.asarray(corner), merge_tolerance=np.asarray(merge), exact_stop=stop)


NUDGE = 1e-7  # of a curve's length: evaluate the ends this far inside
MOST_KINK = 0.1
"""Largest direction jump [rad] that is passed without a stop."""
KINK_TIME = 1e-5
"""At a kink an axis velocity may jump by its acceleration limit times this time [s]."""
JUMP = 1e-6  # [1/m], and relative to the curvature: smaller jumps are rounding


class Junctions(NamedTuple):
    """Where curves meet; entry i is the end of curve i, the last one the end of the path.

    stop : ndarray (n_curve,) of bool
    jump : ndarray (n_curve, n_axis) [1/m]
        Step of d2r/ds2.
    kink : ndarray (n_curve, n_axis)
        Step of dr/ds; zero at stops.
    room : ndarray (n_curve,) [m]
        Length of the shorter of the two curves.
    """

    stop: Flags
    jump: Array
    kink: Array
    room: Array


def _steps(path: Path, order: int) -> tuple[Array, Array, Array]:
    """Return the step of a derivative (n_curve, n_axis) at the end of each curve, and its values before and after."""
    breaks = np.asarray(path.breaks)
    inside = np.diff(breaks) * NUDGE
    start, end = path.derivatives(breaks[:-1] + inside, order + 1), path.derivatives(breaks[1:] - inside, order + 1)
    # Extrapolate from just inside each curve to its ends.
    after = np.roll(start[order] - inside[:, None] * start[order + 1], -1, axis=0)
    before = end[order] + inside[:, None] * end[order + 1]
    step = after - before
    if not path.closed:
        step[-1] = 0.0
    return step, before, after


def curvature_jump(path: Path) -> Array:
    """Return the step of d2r/ds2 (n_curve, n_axis) [1/m] at the end of each curve; at the end of an open path 0."""
    jump, before, after = _steps(path, 2)
    scale = np.maximum(1.0, np.maximum(np.linalg.norm(after, axis=1), np.linalg.norm(before, axis=1)))
    jump[np.abs(jump) < JUMP * scale[:, None]] = 0.0
    return jump


def direction_jump(path: Path) -> Array:
    """Return the step of dr/ds (n_curve, n_axis) at the end of each curve; its size is the angle [rad] if that is small."""
    jump, _, _ = _steps(path, 1)
    jump[np.linalg.norm(jump, axis=1) <= CORNER_ANGLE] = 0.0
    return jump


def junctions(route: Route) -> Junctions:
    """Find exact stops, and the jumps of curvature and direction that are passed without a stop.

    Notes
    -----
    The motion stops at direction jumps above `MOST_KINK`, at dwells and requested stops, between rapid and feed moves, and at the end of an
    open path. Rounded coordinates cause smaller direction jumps. Like a control in exact path mode, the motion passes them at a speed where
    no axis velocity jumps by more than its acceleration limit times `KINK_TIME`, or times the time to the nearer junction if this is less.
    """
    turn = direction_jump(route.path)
    stop = (route.dwell > 0.0) | route.exact_stop | (route.rapid != np.roll(route.rapid, -1)) | (np.linalg.norm(turn, axis=1) > MOST_KINK)
    stop[-1] |= not route.path.closed
    length = np.diff(np.asarray(route.path.breaks))
    return Junctions(stop, curvature_jump(route.path), np.where(stop[:, None], 0.0, turn), np.minimum(length, np.roll(length, -1)))


def junction_speed(at: Junctions, limits: AxisLimits, curvature_step: float) -> Array:
    """Return the speed ceiling (n_curve,) [m/s] of each junction from its steps of acceleration, |jump| v^2, and velocity, |kink| v."""
    refuse(not curvature_step >= 0.0, FeedError, f"curvature_step = {curvature_step}: give a fraction of the acceleration limit, >= 0")
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        square = np.where(at.jump == 0.0, np.inf, curvature_step * limits.acceleration / np.abs(at.jump))
        step = min(curvature_step, 1.0) * limits.acceleration * KINK_TIME
        speed = np.where(at.kink == 0.0, np.inf, step / np.abs(at.kink)).min(axis=1)
        # Kinks in quick succession act like a curve: turning from one to the next takes acceleration.
        turning = np.where(at.kink == 0.0, np.inf, step / KINK_TIME / np.abs(at.kink)).min(axis=1) * at.room
    return np.asarray(np.minimum(np.sqrt(np.minimum(square.min(axis=1), turning)), speed))
