"""A path with what the program says about driving along it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import FeedError, ProgramError
from contourlab.geometry import Arc, Curve, Line, Path
from contourlab.program import Arc as ArcMove
from contourlab.program import Dwell, Program, Traverse

__all__ = ["Route", "route_from_path", "route_from_program"]

Array = NDArray[np.float64]


def _per_curve(name: str, value: ArrayLike, n_curve: int, dtype: Any) -> NDArray[Any]:
    array = np.array(value, dtype=dtype)
    if array.shape not in ((), (1,), (n_curve,)):
        raise FeedError(f"{name} has shape {array.shape}: give one value, or one for each of the {n_curve} curves")
    array = np.array(np.broadcast_to(array, (n_curve,)))
    array.flags.writeable = False
    return array


@dataclass(frozen=True, eq=False)
class Route:
    """A path and, for each of its curves, how it is to be driven.

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

    Raises
    ------
    FeedError
        If a feedrate is not positive, a dwell negative, or a length does not fit the path.
    """

    path: Path
    feedrate: Array
    rapid: NDArray[np.bool_]
    dwell: Array
    source_line: NDArray[np.int64]
    programmed: Path = None  # type: ignore[assignment]  # replaced by `path` below
    dwell_before: float = 0.0

    def __post_init__(self) -> None:
        n_curve = len(self.path.curves)
        for name, dtype in (("feedrate", float), ("rapid", bool), ("dwell", float), ("source_line", np.int64)):
            object.__setattr__(self, name, _per_curve(name, getattr(self, name), n_curve, dtype))
        object.__setattr__(self, "programmed", self.programmed or self.path)
        good = (self.feedrate > 0.0) & (np.isfinite(self.feedrate) | self.rapid)
        if not np.all(good):
            worst = int(np.argmin(good))
            raise FeedError(
                f"feedrate of curve {worst}{_line(int(self.source_line[worst]))} is {self.feedrate[worst]:g} m/s: "
                "it must be finite and > 0 (inf on rapid curves only)"
            )
        if not (np.all(np.isfinite(self.dwell) & (self.dwell >= 0.0)) and 0.0 <= self.dwell_before < np.inf):
            raise FeedError("dwell: every time at rest must be finite and >= 0 s")

    @property
    def n_curve(self) -> int:
        """Number of curves."""
        return len(self.path.curves)


def _line(source_line: int) -> str:
    return f" (line {source_line})" if source_line else ""


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


def _check_axes(program: Program, move: Any, columns: list[int]) -> None:
    """Refuse a move of an axis that the machine lacks."""
    lacking = [column for column in range(3) if column not in columns]
    moved = [column for column in lacking if move.end[column] != move.start[column]]
    if isinstance(move, ArcMove):
        moved += [column for column in move.axes[:2] if column in lacking and column not in moved]
    if moved:
        names = ", ".join("XYZ"[column] for column in moved)
        have = ", ".join("XYZ"[column] for column in columns)
        raise ProgramError(
            f"the program moves {names}, but the machine has {have} only: give axes for {names}, or remove the move",
            file=program.name,
            line=move.source_line,
        )


def _arc(move: ArcMove, columns: list[int]) -> Curve:
    """Return the arc or helix of a move, in the machine's axes; it joins the programmed ends exactly."""
    unit = np.eye(len(columns))
    u, v = (unit[columns.index(axis)] for axis in move.axes[:2])
    start, end, centre = (_point(point, columns) for point in (move.start, move.end, move.centre))
    return Arc.through(start, end, centre, move.sweep, u, v)


def route_from_program(program: Program, axes: Sequence[str] = ("x", "y", "z")) -> Route:
    """Return the route of a part program.

    Moves without length are left out, their dwell is kept. A traverse (G0) is a straight line at rapid rate.

    Parameters
    ----------
    program : Program
    axes : sequence of str
        The machine's linear axes in their order, of ``x``, ``y``, ``z``.

    Returns
    -------
    Route

    Raises
    ------
    ProgramError
        If the program moves an axis that is not among `axes`; says the line.
    FeedError
        If the program moves nothing, or `axes` is wrong.
    """
    columns = _axis_columns(axes)
    curves: list[Curve] = []
    rows: list[tuple[float, bool, int]] = []
    dwell: list[float] = []
    before = 0.0
    for move in program.moves:
        if isinstance(move, Dwell):
            if curves:
                dwell[-1] += move.seconds
            else:
                before += move.seconds
            continue
        _check_axes(program, move, columns)
        if isinstance(move, ArcMove):
            curves.append(_arc(move, columns))
        else:
            start, end = _point(move.start, columns), _point(move.end, columns)
            if np.array_equal(start, end):
                continue
            curves.append(Line(start, end))
        feedrate = np.inf if isinstance(move, Traverse) else move.feedrate
        rows.append((feedrate, isinstance(move, Traverse), move.source_line))
        dwell.append(0.0)
    if not curves:
        raise FeedError(f"{program.name}: the program moves no axis: there is nothing to drive along")
    feedrates, rapid, lines = (np.array(column) for column in zip(*rows, strict=True))
    path = Path(tuple(curves))
    return Route(path, feedrates, rapid, np.array(dwell), lines, path, before)
