"""A path as functions of arc length for compiled steps, with parameters and tables.

Any path is a table of quintic pieces; a circle is evaluated in closed form, which is faster and exact.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ParameterError
from contourlab.geometry.line_and_arc import Arc
from contourlab.geometry.path import Path
from contourlab.geometry.table import path_table
from contourlab.primitives import clip, cos, dot, floor, lookup, maximum, select, sin, sub


@dataclass(frozen=True, eq=False)
class PathView:
    """A path for a step.

    Attributes
    ----------
    evaluate : callable
        ``evaluate(par, s)`` returns r, dr/ds and d2r/ds2 as tuples over the axes.
    parameters, tables : mapping
        To be added to those of the step; every name starts with ``path_``.
    path : Path or None
        The path of `view_of`.
    made : tuple
        Arguments of `view_of`, which makes the view anew in another process: a function made in a function does not travel.
    """

    evaluate: Callable[[Any, float], Any]
    parameters: Mapping[str, float]
    tables: Mapping[str, Array]
    path: Path | None = None
    made: tuple[Any, ...] = ()

    def __reduce__(self) -> Any:
        return view_of, self.made


def check_view(view: PathView | None, path: Path) -> None:
    """Raise ParameterError if a view is not that of the path; None stands for that view."""
    seen = getattr(view, "path", None)
    if view is not None and (seen is None or (seen is not path and seen.digest != path.digest)):
        raise ParameterError("view", "a view of another path" if seen is not None else f"{view!r:.60}", "view_of(reference.path), or None")


@lru_cache(maxsize=4)
def view_of(path: Path, tolerance: float = 1e-10, pieces: int | None = None, analytic: bool = True, arcs: float = 1.0) -> PathView:
    """Return the view of a path; the last few are cached.

    Parameters
    ----------
    tolerance : float [m], > 0
        Largest distance of the table from the path.
    pieces : int, optional
        Least number of pieces.
    analytic : bool
        Whether a circle is evaluated in closed form.
    arcs : float, > 0
        Share of the tolerance for arcs.
    """
    if analytic and path.closed and path.n_axis == 2 and len(path.curves) == 1 and isinstance(path.curves[0], Arc):
        return replace(_circle(path), made=(path, tolerance, pieces, analytic))
    table = path_table(path, tolerance, pieces or 1, arcs)
    parameters = {
        "path_inverse_cell": float(table.inverse_cell),
        "path_length": path.length,
        "path_inverse_length": 1.0 / path.length,
        "path_wrap": 1.0 if path.closed else 0.0,
        "path_last_cell": float(len(table.cell) - 2),
        "path_last_piece": float(len(table.coefficients) - 1),
    }
    tables = {"path_start": table.start, "path_coefficients": table.coefficients, "path_cell": table.cell}
    return PathView(_table_evaluator(path.n_axis, table.halvings), parameters, tables, path, (path, tolerance, pieces, analytic, arcs))


def _circle(path: Path) -> PathView:
    at_start = path.derivatives(np.zeros(1), order=2)[:, 0]
    radius = 1.0 / float(np.hypot(*at_start[2]))
    centre = at_start[0] + radius * radius * at_start[2]
    spoke = at_start[0] - centre
    parameters = {
        "path_radius": radius,
        "path_rate": math.copysign(1.0, spoke[0] * at_start[1][1] - spoke[1] * at_start[1][0]) / radius,
        "path_phase": math.atan2(spoke[1], spoke[0]),
        "path_centre_0": float(centre[0]),
        "path_centre_1": float(centre[1]),
    }
    return PathView(_on_circle, parameters, {}, path)


@cache
def newton_of(evaluate: Any) -> tuple[Any, Any]:
    """Return the Newton step towards the foot point, within the window around a centre, and the squared distance of a place."""

    def improve(par: Any, s: float, position: Any, centre: float) -> float:
        q, q1, q2 = evaluate(par, s)
        gap = sub(q, position)
        square = dot(q1, q1)
        slope = maximum(square + dot(q2, gap), 0.1 * square)
        return clip(s - dot(q1, gap) / slope, centre - par.window, centre + par.window)

    def square_distance(par: Any, s: float, position: Any) -> float:
        q, _, _ = evaluate(par, s)
        gap = sub(q, position)
        return dot(gap, gap)

    return improve, square_distance


def _on_circle(par: Any, s: float) -> Any:
    angle = par.path_phase + par.path_rate * s
    c, d = cos(angle), sin(angle)
    slope = par.path_radius * par.path_rate
    bend = slope * par.path_rate
    point = (par.path_centre_0 + par.path_radius * c, par.path_centre_1 + par.path_radius * d)
    return point, (-slope * d, slope * c), (-bend * c, -bend * d)


def _quintic(table: Any, base: float, h: float) -> Any:
    c0, c1, c2 = lookup(table, base), lookup(table, base + 1.0), lookup(table, base + 2.0)
    c3, c4, c5 = lookup(table, base + 3.0), lookup(table, base + 4.0), lookup(table, base + 5.0)
    value = c0 + h * (c1 + h * (c2 + h * (c3 + h * (c4 + h * c5))))
    first = c1 + h * (2.0 * c2 + h * (3.0 * c3 + h * (4.0 * c4 + h * 5.0 * c5)))
    second = 2.0 * c2 + h * (6.0 * c3 + h * (12.0 * c4 + h * 20.0 * c5))
    return value, first, second


@cache
def _table_evaluator(n_axis: int, halvings: int = 0) -> Callable[[Any, float], Any]:
    find = _finder(halvings) if halvings else _find

    def evaluate(par: Any, s: float) -> Any:
        # On a closed path s counts laps; on an open one it is clipped.
        along = s - par.path_wrap * par.path_length * floor(s * par.path_inverse_length)
        along = clip(along, 0.0, par.path_length)
        piece = find(par, along, clip(floor(along * par.path_inverse_cell), 0.0, par.path_last_cell))
        base, h = 6.0 * n_axis * piece, along - lookup(par.path_start, piece)
        return tuple(zip(*(_quintic(par.path_coefficients, base + 6.0 * j, h) for j in range(n_axis)), strict=True))

    return evaluate


def _find(par: Any, along: float, cell: float) -> float:
    """Return the piece, if at most one piece starts inside each cell."""
    piece = lookup(par.path_cell, cell)
    piece = piece + (1.0 if along >= lookup(par.path_start, piece + 1.0) else 0.0)
    return clip(piece, 0.0, par.path_last_piece)


@cache
def _finder(halvings: int) -> Callable[[Any, float, float], float]:
    """Return a search for the piece within a cell with a fixed number of bisections, so that all lanes take the same steps."""

    def find(par: Any, along: float, cell: float) -> float:
        first, last = lookup(par.path_cell, cell), lookup(par.path_cell, cell + 1.0)
        for _ in range(halvings):
            middle = floor(0.5 * (first + last + 1.0))
            right = along >= lookup(par.path_start, middle)
            first, last = select(right, middle, first), select(right, last, maximum(middle - 1.0, first))
        return first

    return find
