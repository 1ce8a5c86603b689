"""Round corners within a tolerance (G64 P), so that the motion need not stop there."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.feed.corner_blend import MOST_TURN, Corners, control_points, largest_reach, quicker_blended
from contourlab.feed.correspondence import Correspondence
from contourlab.feed.limits import AxisLimits
from contourlab.feed.merging import merged
from contourlab.feed.route import Route
from contourlab.geometry import Arc, Curve, Line, Path
from contourlab.geometry.blend import blends, halves, quintic_bezier
from contourlab.geometry.curve import angle_between
from contourlab.geometry.path import CORNER_ANGLE

_NEARLY_ALL = 0.99
"""Usable fraction of a curve with a blend at one end only."""
_NEARLY_HALF = 0.495
"""Blends that would end between here and the middle of the curve are shortened to end here, so that no sliver remains."""


def blended(route: Route, limits: AxisLimits | None = None) -> Route:
    """Merge short lines and round corners, each within its tolerance.

    Parameters
    ----------
    route : Route
        With `merge_tolerance` and `corner_tolerance`; returned unchanged where both are 0 everywhere.
    limits : AxisLimits, optional
        If given, a corner is not rounded where a stop takes less time than the blend; see `contourlab.feed.corner_blend`.

    Returns
    -------
    Route
        `path` is the new path, `programmed` the programmed one, `correspondence` the map between them. The deviation is at most P, or
        Q + P/2 where Q is greater than P.

    Notes
    -----
    `contourlab.feed.merging` describes the merging. A quintic curve of continuous tangent and curvature replaces each corner between lines,
    arcs and helices. It uses at most half of each curve, or 99 % of a curve with a blend at one end only. These corners stay: with a dwell
    or an exact stop, between rapid and feed moves, reversals (more than 175 degrees), and at other curves. Where the feedrate changes at a
    corner, it changes in the middle of the blend.
    """
    route = merged(route)
    corners = _corners(route)
    if not corners.before.size:
        return route
    reach = _reach(route, corners)
    on = np.flatnonzero(reach > 0.0)
    corners, reach = corners.only(on), reach[on]
    points = control_points(route.path, corners, reach)
    if limits is not None and not limits.unbounded.any():
        on = np.flatnonzero(quicker_blended(route, corners, reach, points, limits.for_axes(route.path.n_axis)))
        corners, reach, points = corners.only(on), reach[on], points[on]
    return _assembled(route, corners, reach, points) if reach.size else route


def _corners(route: Route) -> Corners:
    """Return the corners that may be blended."""
    path, n = route.path, route.n_curve
    before = np.arange(n if path.closed and n > 1 else n - 1)
    after = (before + 1) % n
    turn = angle_between(path.ends[1][before], path.starts[1][after])
    plain = np.array([type(curve) in (Line, Arc) for curve in path.curves], dtype=bool)
    wanted = (route.corner_tolerance[before] > 0.0) & (route.dwell[before] == 0.0) & ~route.exact_stop[before]
    # A rapid move stops before and after a cut.
    wanted &= route.rapid[before] == route.rapid[after]
    wanted &= (turn > CORNER_ANGLE) & (turn < MOST_TURN) & plain[before] & plain[after]
    return Corners(before, after, turn).only(np.flatnonzero(wanted))


def _reach(route: Route, corners: Corners) -> Array:
    """Return the length of each of its two curves that a blend uses, without leaving slivers."""
    number, span = np.arange(route.n_curve), np.diff(route.path.breaks)
    both = np.isin(number, corners.before) & np.isin(number, corners.after)
    usable = np.where(both, 0.5, _NEARLY_ALL) * span
    room = np.minimum(usable[corners.before], usable[corners.after])
    reach = largest_reach(route.path, corners, route.corner_tolerance[corners.before], room)
    for _ in range(2):  # a blend shortened for one of its curves may end near the middle of the other
        for curve in (corners.before, corners.after):
            sliver = both[curve] & (reach > _NEARLY_HALF * span[curve]) & (reach < 0.5 * span[curve])
            reach = np.where(sliver, _NEARLY_HALF * span[curve], reach)
    return reach


def _assembled(route: Route, corners: Corners, reach: Array, points: Array) -> Route:
    """Return the route with the blends (n, 6, n_axis) in place of the corners."""
    path = route.path
    # Where the feedrate changes at a corner, each half of the blend gets the feedrate of its side.
    coefficients, corner, second = _halved(quintic_bezier(points), route.feedrate[corners.before] != route.feedrate[corners.after])
    rounds, piece = blends(coefficients)
    corner, second = corner[piece], second[piece]
    # The parts of a divided blend start in proportion to their lengths.
    length = np.array([blend.length for blend in rounds])
    done = np.concatenate([[0.0], np.cumsum(length)])[:-1]
    share = (done - done[np.searchsorted(corner, corner)]) / np.bincount(corner, weights=length)[corner]
    begin = (path.breaks[corners.before + 1] - reach)[corner] + 2.0 * reach[corner] * share
    before = corners.before[corner]
    kept, kept_begin, kept_curves = _trimmed(path, corners, reach, points)
    order = np.argsort(np.concatenate([2 * kept, 2 * before + 1]), kind="stable")
    curves = [*kept_curves, *rounds]
    planned = Path([curves[i] for i in order.tolist()], path.closed)
    places = np.concatenate([kept_begin, begin])[order]
    places = np.append(places, places[0] + path.length if path.closed else path.length)
    between = Correspondence(planned.breaks, places)
    owner = np.concatenate([kept, before])[order]
    side = np.concatenate([kept, np.where(second, corners.after[corner], before)])[order]
    return replace(
        route,
        path=planned,
        programmed=route.programmed,
        correspondence=between if route.correspondence is None else route.correspondence.after(between),
        **{name: getattr(route, name)[side] for name in ("feedrate", "rapid", "source_line")},
        **{name: getattr(route, name)[owner] for name in ("dwell", "corner_tolerance", "merge_tolerance", "exact_stop")},
    )


def _halved(coefficients: Array, wanted: Flags) -> tuple[Array, Index, Flags]:
    """Halve the wanted curves (n, 6, n_axis); return all curves, the number of each one's original, and whether it is a second half."""
    corner = np.repeat(np.arange(len(wanted)), np.where(wanted, 2, 1))
    second = np.append(False, corner[1:] == corner[:-1])
    pieces = coefficients[corner]
    pieces[wanted[corner]] = halves(coefficients[wanted])
    return pieces, corner, second


def _trimmed(path: Path, corners: Corners, reach: Array, points: Array) -> tuple[Index, Array, list[Curve]]:
    """Trim the curves by their blends; return the number, the start on the path, and the rest of each remaining curve."""
    span = np.diff(path.breaks)
    low, high = np.zeros_like(span), span.copy()
    low[corners.after], high[corners.before] = reach, span[corners.before] - reach
    stays = high - low > 1e-9 * span
    cut = stays & ((low > 0.0) | (high < span))
    straight = np.array([type(curve) is Line for curve in path.curves], dtype=bool)
    lines = np.flatnonzero(straight & cut)
    start, end = path.starts[0].copy(), path.ends[0].copy()
    uncut: list[Any] = [path.curves[i] for i in lines.tolist()]
    end[lines] = np.reshape([line.end for line in uncut], (-1, path.n_axis))
    # Use the ends of the blends themselves, so that rounding opens no gap.
    start[corners.after], end[corners.before] = points[:, 5], points[:, 0]
    new: dict[int, Curve] = dict(zip(lines.tolist(), Line.many(start[lines], end[lines]), strict=True))
    for i in np.flatnonzero(~straight & cut).tolist():
        arc: Any = path.curves[i]
        new[i] = arc.part(low[i], high[i])
    kept = np.flatnonzero(stays)
    return kept, path.breaks[kept] + low[kept], [new.get(i, path.curves[i]) for i in kept.tolist()]
