"""Round corners within a tolerance (G64 P), so that the motion need not stop at them."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from contourlab.feed.corner_blend import MOST_TURN, control_points, largest_reach, quicker_blended
from contourlab.feed.correspondence import Correspondence
from contourlab.feed.limits import AxisLimits
from contourlab.feed.merging import merged
from contourlab.feed.route import Route
from contourlab.geometry import Arc, Curve, Line, Path
from contourlab.geometry.blend import blends, halves, quintic_bezier
from contourlab.geometry.curve import angle_between
from contourlab.geometry.path import CORNER_ANGLE

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_NEARLY_ALL = 0.99
"""Of a curve with a blend at one end only, so much may be used."""
_NEARLY_HALF = 0.495
"""A blend that would stop short of the middle of its share leaves no sliver: it ends here, or at the middle itself."""


class _Corners(NamedTuple):
    """Corners to blend: the curves before and after each, and by how much it turns [rad]."""

    before: Index
    after: Index
    turn: Array

    def only(self, which: Index) -> _Corners:
        """Return some of the corners."""
        return _Corners(self.before[which], self.after[which], self.turn[which])


def blended(route: Route, limits: AxisLimits | None = None) -> Route:
    """Return the route with dust merged and corners rounded, each within its tolerance.

    Parameters
    ----------
    route : Route
        With `merge_tolerance` and `corner_tolerance`; the route itself where both are 0 everywhere.
    limits : AxisLimits, optional
        Of the machine. With them a corner stays where a stop takes less time than its blend; see `contourlab.feed.corner_blend`.

    Returns
    -------
    Route
        `path` is the new path, `programmed` the programmed one, `correspondence` the map between them. It leaves the programmed path by
        no more than P, or Q + P/2 where Q is greater than P.

    Notes
    -----
    See `contourlab.feed.merging` and `rounded`.
    """
    return rounded(merged(route), limits)


def rounded(route: Route, limits: AxisLimits | None = None) -> Route:
    """Return the route with its corners rounded by quintic blends.

    Parameters
    ----------
    route : Route
        With `corner_tolerance` [m].
    limits : AxisLimits, optional

    Returns
    -------
    Route

    Notes
    -----
    A corner between lines, arcs and helices is replaced by a curve of continuous tangent and curvature; see `contourlab.feed.corner_blend`.
    At most half of a curve goes to the blend at either end, and at most 99 % where only one end has a blend. Corners with a dwell or an
    exact stop, those between a rapid and a feed move, reversals (more than 175 degrees) and corners of other curves stay. Where the
    feedrate changes at a corner, the blend is cut in its middle and each half is driven as its side is.
    """
    path = route.path
    corners = _corners(route)
    if not corners.before.size:
        return route
    span = np.diff(path.breaks)
    reach = _reach(route, corners, span)
    on = np.flatnonzero(reach > 0.0)
    corners, reach = corners.only(on), reach[on]
    points = control_points(path, *corners, reach)
    if limits is not None and not limits.unbounded.any():
        on = np.flatnonzero(quicker_blended(route, corners.before, corners.after, reach, points, limits.for_axes(path.n_axis)))
        corners, reach, points = corners.only(on), reach[on], points[on]
    return _assembled(route, corners, reach, points, span) if reach.size else route


def _corners(route: Route) -> _Corners:
    """Return the corners that may be blended."""
    path, n = route.path, route.n_curve
    before = np.arange(n if path.closed and n > 1 else n - 1)
    after = (before + 1) % n
    turn = angle_between(path.ends[1][before], path.starts[1][after])
    plain = np.array([type(curve) in (Line, Arc) for curve in path.curves], dtype=bool)
    wanted = (route.corner_tolerance[before] > 0.0) & (route.dwell[before] == 0.0) & ~route.exact_stop[before]
    # A rapid comes to rest before a cut begins or after it has ended: slowing down to a cut within a blend would gain no time.
    wanted &= route.rapid[before] == route.rapid[after]
    wanted &= (turn > CORNER_ANGLE) & (turn < MOST_TURN) & plain[before] & plain[after]
    return _Corners(before[wanted], after[wanted], turn[wanted])


def _reach(route: Route, corners: _Corners, span: Array) -> Array:
    """Return how much of its two curves each blend uses, within its shares of them, so that no curve is left with a sliver."""
    n = route.n_curve
    at_end, at_start = np.zeros(n, dtype=bool), np.zeros(n, dtype=bool)
    at_end[corners.before], at_start[corners.after] = True, True
    both = at_end & at_start
    share = np.where(both, 0.5, _NEARLY_ALL) * span
    room = np.minimum(share[corners.before], share[corners.after])
    reach = largest_reach(route.path, *corners, route.corner_tolerance[corners.before], room)
    for _ in range(2):  # a blend shortened for one of its curves may come near the middle of the other
        for curve in (corners.before, corners.after):
            sliver = both[curve] & (reach > _NEARLY_HALF * span[curve]) & (reach < 0.5 * span[curve])
            reach = np.where(sliver, _NEARLY_HALF * span[curve], reach)
    return reach


class _Part(NamedTuple):
    """Curves of the new path: their rank in the old order, the old curve that each belongs to, and where they begin on the old path."""

    rank: Index
    owner: Index
    begin: Array
    curves: list[Curve]


def _assembled(route: Route, corners: _Corners, reach: Array, points: Array, span: Array) -> Route:
    path = route.path
    # Where the feedrate changes at a corner, each half of the blend is driven at that of its side.
    coefficients, corner, second = _halved(quintic_bezier(points), route.feedrate[corners.before] != route.feedrate[corners.after])
    made, piece = blends(coefficients)
    number, second = corner[piece], second[piece]
    begin = path.breaks[corners.before + 1] - reach
    # A blend that had to be divided is spread over its place by length.
    length = np.array([blend.length for blend in made])
    done = np.concatenate([[0.0], np.cumsum(length)])[:-1]
    first = np.searchsorted(number, number)
    share = (done - done[first]) / np.bincount(number, weights=length)[number]
    rounds = _Part(2 * corners.before[number] + 1, corners.before[number], begin[number] + 2.0 * reach[number] * share, list(made))
    kept = _trimmed(path, corners, reach, points, span)
    order = np.argsort(np.concatenate([kept.rank, rounds.rank]), kind="stable")
    curves = [*kept.curves, *rounds.curves]
    planned = Path([curves[i] for i in order.tolist()], path.closed)
    places = np.concatenate([kept.begin, rounds.begin])[order]
    places = np.append(places, places[0] + path.length if path.closed else path.length)
    between = Correspondence(planned.breaks, places)
    owner = np.concatenate([kept.owner, rounds.owner])[order]
    side = np.concatenate([kept.owner, np.where(second, corners.after[number], corners.before[number])])[order]
    return replace(
        route,
        path=planned,
        programmed=route.programmed,
        correspondence=between if route.correspondence is None else route.correspondence.after(between),
        **{name: getattr(route, name)[side] for name in ("feedrate", "rapid", "source_line")},
        **{name: getattr(route, name)[owner] for name in ("dwell", "corner_tolerance", "merge_tolerance", "exact_stop")},
    )


def _halved(coefficients: Array, wanted: NDArray[np.bool_]) -> tuple[Array, Index, NDArray[np.bool_]]:
    """Halve the chosen curves (n, 6, n_axis); return all curves, the index of each one's original, and whether it is a second half."""
    corner = np.repeat(np.arange(len(wanted)), np.where(wanted, 2, 1))
    second = np.append(False, corner[1:] == corner[:-1])
    found = coefficients[corner]
    found[wanted[corner]] = halves(coefficients[wanted])
    return found, corner, second


def _trimmed(path: Path, corners: _Corners, reach: Array, points: Array, span: Array) -> _Part:
    """Return what the blends leave of the curves."""
    low, high = np.zeros_like(span), span.copy()
    low[corners.after], high[corners.before] = reach, span[corners.before] - reach
    stays = high - low > 1e-9 * span
    cut = stays & ((low > 0.0) | (high < span))
    straight = np.array([type(curve) is Line for curve in path.curves], dtype=bool)
    lines = np.flatnonzero(straight & cut)
    start, end = path.starts[0].copy(), path.ends[0].copy()
    uncut: list[Any] = [path.curves[i] for i in lines.tolist()]
    end[lines] = np.reshape([line.end for line in uncut], (-1, path.n_axis))
    # The very points of the blends, so that nothing opens by a rounding.
    start[corners.after], end[corners.before] = points[:, 5], points[:, 0]
    new: dict[int, Curve] = dict(zip(lines.tolist(), Line.many(start[lines], end[lines]), strict=True))
    for i in np.flatnonzero(~straight & cut).tolist():
        arc: Any = path.curves[i]
        new[i] = arc.part(low[i], high[i])
    left = np.flatnonzero(stays)
    return _Part(2 * left, left, path.breaks[left] + low[left], [new.get(i, path.curves[i]) for i in left.tolist()])
