"""Merge lines (G64 Q, like LinuxCNC's naive CAM detector) and round corners (G64 P) within tolerances.

A run of lines becomes one line if all points between its ends lie within the tolerance of that line, and in order along it. Seen from the
start of the run, each point permits a cone of directions; one cone within their intersection is stored. In the plane this cone is the
intersection itself. In space it is a little smaller, so a run may end early but never leaves the tolerance. The cost is linear in the
points.

Merging and rounding share the tolerance of a corner: with Q up to P, a point lies at most P/2 off its line, and the blends next to it use
the rest of P. The deviation from the programmed path is at most P, or Q + P/2 where Q is greater than P.

A corner of turning angle q is rounded between the points at arc length a before and after it. At these points the quintic Bezier curve with
control points P0 ... P5 has the position, tangent and curvature vector of the path. P1 and P2 lie on the tangent at (1 - b) a and
(1 - c) a from P0; P2 is then moved by 5/4 ((1 - b) a)^2 times the curvature vector (from r' = 5 (P1 - P0), r'' = 20 (P2 - 2 P1 + P0)). P4
and P3 follow in the same way from P5. Between lines, b a and c a are the distances of P1 and P2 from the corner.

Between lines the curve is nearest to the corner at its middle, (P0 + 5 P1 + 10 P2 + 10 P3 + 5 P4 + P5)/32, at a distance of
a (1 + 5 b + 10 c)/16 sin(q/2). It lies within the triangle of its ends and the corner, so it is nowhere further from the lines. This
determines a from the tolerance.

The shape b(q), c(q) determines the speed. For a given deviation, acceleration limits the speed by the root of 1/max|r''|, jerk by the cube
root of 1/max|r'''|. The shape of least curvature (b = 0.835, c = 0.393 at 90 degrees; Sencer, Ishizaki & Shamoto 2015,
doi 10.1007/s00170-014-6386-2) is within 0.3 % of the circular arc, but 3 times slower than possible where jerk limits the speed. The shape
of least |r'''| loses 20 % in curvature. The table below minimises the larger of the two speed losses: 4 to 7 % at any angle.

Where the jerk limit is low, a stop at the corner can be quicker than a blend. `quicker_blended` compares both in closed form. It assumes
equal neighbouring corners, so that each corner owns half of its two curves. With a stop, each half is half of a move from rest to rest.
With a blend, it is half of a move over the rest of the curve, from the speed at the end of the blend to the same speed, plus the time
within the blend. For a regular polygon this is nearly exact.
"""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.errors import FeedError, refuse
from contourlab.feed.bounds import AxisLimits, LinuxCNC, Samples, Share, peak_speed, ramps, speed_limit
from contourlab.feed.fitting import Quintics, fitted, replaced
from contourlab.feed.linuxcnc import chorded, mark_chains
from contourlab.feed.route import Correspondence, Route
from contourlab.feed.trapezoids import commanded
from contourlab.geometry import Path
from contourlab.geometry.blend import Blends, halves, quintic_bezier, shapes
from contourlab.geometry.curve import Curves, angle_between
from contourlab.geometry.line_and_arc import Arcs, Lines
from contourlab.geometry.path import CORNER_ANGLE
from contourlab.native.kernel import Kernel, kernel

_FORWARD = math.radians(89.0)
"""Largest angle between a line and its run: points then follow one another along the merged line."""


def merged(route: Route, *, chains: bool = False) -> Route:
    """Merge successive feed lines within their `merge_tolerance`, or in `chains` as LinuxCNC; return the route where nothing is merged.

    Lines are merged where feedrate, tolerances and mode are equal, none is rapid, and there is no dwell or exact stop between them. A
    merged line has exactly the ends of its run.
    """
    linked = _linked(route)
    if not linked.any():
        return route
    path = route.path
    points = np.concatenate([path.starts[0], getattr(path.curves[-1], "end", path.ends[0][-1])[None]])
    # The largest distance of a point from its merged line: Q if Q > P, else Q but at most P/2.
    wide, narrow = route.corner_tolerance, route.merge_tolerance
    within = np.where(narrow <= wide, np.minimum(narrow, 0.5 * wide), narrow)
    first = run_starts(points, narrow, linked, mark_chains) if chains else run_starts(points, within, linked)
    last = np.append(first[1:], route.n_curve) - 1
    many = last > first
    if not many.any():
        return route
    number = np.full(route.n_curve, -1)
    number[first[~many]] = np.flatnonzero(~many)
    lines = Lines.between(points[first[many]], points[last[many] + 1])
    planned = Path(Curves([(lines, np.flatnonzero(many)), *path.curves.parts(number)]), path.closed)
    run = np.repeat(np.arange(first.size), last - first + 1)
    # Where the start of each old line lies along the new line of its run, and how far from it.
    direction, away = planned.starts[1][run], points[:-1] - points[first[run]]
    along = np.einsum("ij,ij->i", away, direction)
    aside = np.linalg.norm(away - along[:, None] * direction, axis=1)
    most = np.maximum.reduceat(np.where(many[run], aside, 0.0), first)
    corner = route.corner_tolerance[first]
    unused = np.clip(corner - np.maximum(most, np.roll(most, -1)), 0.5 * corner, corner)
    place = np.append(planned.breaks[run] + np.where(many[run], along, 0.0), planned.length)
    rises = np.append(place[:-1] < np.minimum.accumulate(place[::-1])[::-1][1:], True)  # a point of a chain may lie before the last
    between = Correspondence(place[rises], path.breaks[rises])
    return replace(
        route,
        path=planned,
        correspondence=between if route.correspondence is None else route.correspondence.after(between),
        dwell=route.dwell[last],
        exact_stop=route.exact_stop[last],
        corner_tolerance=corner if chains else unused,
        **{name: getattr(route, name)[first] for name in ("feedrate", "rapid", "merge_tolerance")},
    )


def _linked(route: Route) -> Flags:
    """Return which curves may be merged with the next."""
    usable = route.path.of_kind(Lines) & ~route.rapid & (route.merge_tolerance > 0.0)
    # A line keeps the direction of the fitted curve before or after it, as no corner between them could be rounded.
    fitted_curve = route.path.of_kind(Blends)
    usable &= ~np.roll(fitted_curve, 1) & ~np.roll(fitted_curve, -1)
    linked = usable & np.roll(usable, -1) & (route.dwell == 0.0) & ~route.exact_stop
    for name in ("feedrate", "merge_tolerance", "corner_tolerance"):
        values = getattr(route, name)
        linked &= values == np.roll(values, -1)
    linked[-1] = False
    return np.asarray(linked)


@kernel("f8[:,:] f8[:] f8[:] f8[:,:] i8[:]")
def mark_starts(points, tolerance, linked, memory, begins):
    """Mark the first line of each run; `memory` (3, n_axis) holds directions: the axis of the cone, of the run so far, of a line."""
    cone, chord, line = memory[0], memory[1], memory[2]
    start, half = 0, -1.0
    for i in range(begins.size):
        _direction(points, i, i + 1, line)
        far = _direction(points, start, i, chord)
        if i > 0 and linked[i - 1] != 0.0 and far > 0.0:
            # The merged line must pass the former end point within the tolerance, and no line may run backwards.
            sine = tolerance[i] * (1.0 - 1e-9) / far
            half = _narrowed(cone, half, chord, math.asin(sine) if sine < 1.0 else math.pi)
            half = _narrowed(cone, half, line, _FORWARD)
            if half >= 0.0 and _direction(points, start, i + 1, chord) > 0.0 and _angle(cone, chord) <= half:
                continue
        begins[i], start, half = 1, i, _FORWARD
        for j in range(line.size):
            cone[j] = line[j]


def run_starts(points: Array, tolerance: Array, linked: Flags, mark: Kernel = mark_starts) -> Index:
    """Return the number of the first line of each run.

    Parameters
    ----------
    points : ndarray (n + 1, n_axis) [m]
        Ends of n successive lines.
    tolerance : ndarray (n,) [m]
    linked : ndarray (n,) of bool
        Which lines may be merged with the next.
    mark : Kernel
        Marks the first line of each run.
    """
    begins = np.zeros(len(points) - 1, dtype=np.int64)
    given = (np.ascontiguousarray(part, dtype=float) for part in (points, tolerance, linked))
    mark(*given, np.empty((3, points.shape[1])), begins)
    return np.flatnonzero(begins)


def _direction(points, first, last, found):
    """Fill the unit vector from one point to another; return their distance, 0 for the same place."""
    square = 0.0
    for j in range(found.size):
        found[j] = points[last, j] - points[first, j]
        square += found[j] * found[j]
    size = math.sqrt(square)
    for j in range(found.size if size > 0.0 else 0):
        found[j] /= size
    return size


def _angle(a, b):
    """Return the angle between unit vectors, accurate for small and large angles."""
    apart, along = 0.0, 0.0
    for j in range(a.size):
        apart += (b[j] - a[j]) ** 2
        along += (a[j] + b[j]) ** 2
    return 2.0 * math.atan2(math.sqrt(apart), math.sqrt(along))


def _narrowed(cone, half, other, also):
    """Turn the axis of a cone to the largest cone within it and a second one; return its half angle, negative if there is none.

    >>> axis = np.array([1.0, 0.0])
    >>> half = _narrowed(axis, 0.2, np.array([np.cos(0.3), np.sin(0.3)]), 0.2)
    >>> round(math.atan2(axis[1], axis[0]), 12), round(half, 12)
    (0.15, 0.05)
    """
    apart = _angle(cone, other)
    if apart + half <= also:
        return half
    new = also if apart + also <= half else 0.5 * (half + also - apart)
    turn, swing = half - new if new < also else apart, math.sin(apart)
    if swing > 0.0:  # from the first axis towards the second, along the great circle
        keep, take = math.sin(apart - turn) / swing, math.sin(turn) / swing
        for j in range(cone.size):
            cone[j] = keep * cone[j] + take * other[j]
    return new


MOST_TURN = np.radians(175.0)
"""Sharper corners are not rounded: the motion would almost stop at the tip of the blend."""
LEAST_REACH = 1e-8
"""Shortest piece of a curve [m] that a blend may use."""
_SHARPEST_BEND = 1.0
"""Largest angle of an arc [rad] that a blend may use."""
_TURN = np.radians([0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0, 105.0, 120.0, 135.0, 150.0, 165.0, 170.0, 175.0])
_B = np.array([0.5035, 0.5053, 0.5096, 0.5180, 0.5304, 0.5495, 0.5769, 0.6105, 0.6698, 0.7383, 0.8088, 0.8951, 0.9277, 0.9627])
_C = np.array([0.2085, 0.2118, 0.2196, 0.2340, 0.2549, 0.2840, 0.3229, 0.3790, 0.4474, 0.5353, 0.6445, 0.7911, 0.8523, 0.9219])
_ENOUGH, _AIM = 0.9955, 0.988
"""Accepted and targeted deviation, in tolerances: samples miss at most 0.35 % of the largest deviation."""
_ROUNDS = 12
_GRID = np.linspace(0.0, 1.0, 33)
_COARSE = np.linspace(0.0, 1.0, 17)
_CHUNK, _TIMED = 512, 1024  # corners measured, and timed, together
_WHOLE = Share(1.0, 1.0, 1.0, 1.0)
_BLEND = Share(1.0, 1.0, 0.8, 1.0)
"""Shares for turning in a blend; the rest of the jerk is for braking and speeding up."""


class Corners(NamedTuple):
    """Corners of a path: numbers of the curves before and after each, and its turning angle [rad]; arrays (n,)."""

    before: Index
    after: Index
    turn: Array

    def only(self, which: Index | slice) -> Corners:
        """Return some of the corners."""
        return Corners(self.before[which], self.after[which], self.turn[which])


def shape(turn: Array) -> tuple[Array, Array]:
    """Return b and c of corners with turning angles (n,) [rad]."""
    return np.interp(turn, _TURN, _B), np.interp(turn, _TURN, _C)


def control_points(path: Path, corners: Corners, reach: Array) -> Array:
    """Return the control points (n, 6, n_axis) of blends that use `reach` (n,) [m] of each curve."""
    b, c = shape(corners.turn)
    h, k = ((1.0 - b) * reach)[:, None], ((1.0 - c) * reach)[:, None]
    p, d, bend = path.at(corners.before, np.diff(path.breaks)[corners.before] - reach, 2)
    q, e, other = path.at(corners.after, reach, 2)
    return np.stack([p, p + h * d, p + k * d + 1.25 * h**2 * bend, q - k * e + 1.25 * h**2 * other, q - h * e, q], axis=1)


def largest_reach(path: Path, corners: Corners, tolerance: Array, room: Array) -> Array:
    """Return the length of each curve that the largest blend within the tolerance uses (n,) [m]; 0 without a blend.

    Parameters
    ----------
    tolerance : ndarray (n,) [m], > 0
        Largest distance of the corner from its blend, and of the blend from the path.
    room : ndarray (n,) [m]
        Usable length of each curve.
    """
    b, c = shape(corners.turn)
    in_closed_form = 16.0 * tolerance / ((1.0 + 5.0 * b + 10.0 * c) * np.sin(0.5 * corners.turn))
    ends = (corners.before, np.diff(path.breaks)[corners.before]), (corners.after, 0.0 * room)
    bend = np.maximum(*(np.linalg.norm(path.at(curve, at, 2)[2], axis=1) for curve, at in ends))
    # The margin keeps rounding from lifting a measured deviation above the tolerance.
    reach = np.minimum(room, in_closed_form * (1.0 - 1e-9))
    on = np.flatnonzero(bend > 0.0)
    if on.size:
        most = np.minimum(np.minimum(room[on], _SHARPEST_BEND / bend[on]), 4.0 * in_closed_form[on])
        reach[on] = _measured_reach(path, corners.only(on), tolerance[on], most)
    return np.where(reach < LEAST_REACH, 0.0, reach)


def _measured_reach(path: Path, corners: Corners, tolerance: Array, most: Array) -> Array:
    """Return reaches whose measured deviation is just below the tolerance; the deviation is almost proportional to the reach."""
    low, high = np.zeros_like(most), most.copy()
    reach, on = most.copy(), np.arange(most.size)
    for _ in range(_ROUNDS):
        off = _deviation(path, corners.only(on), reach[on])
        good = off <= _ENOUGH * tolerance[on]
        low[on] = np.where(good, reach[on], low[on])
        high[on] = np.where(good, high[on], reach[on])
        done = good & ((off >= 0.97 * tolerance[on]) | (reach[on] >= most[on]))
        on, off = on[~done], off[~done]
        if not on.size:
            break
        guess = reach[on] * (_AIM * tolerance[on] / np.maximum(off, 1e-300))
        reach[on] = np.where((guess > low[on]) & (guess < high[on]), guess, 0.5 * (low[on] + high[on]))
    return low


def _deviation(path: Path, corners: Corners, reach: Array) -> Array:
    """Return the larger of the corner's distance from its blend and the blend's largest distance from the path; inf for a loop."""
    if reach.size > _CHUNK:
        parts = [slice(i, i + _CHUNK) for i in range(0, reach.size, _CHUNK)]
        return np.concatenate([_deviation(path, corners.only(part), reach[part]) for part in parts])
    points, corner = control_points(path, corners, reach), path.breaks[corners.before + 1]
    away, at = _distances(path, points, np.broadcast_to(_GRID, (reach.size, _GRID.size)), corner, reach)
    missed = np.linalg.norm(at - path.starts[0][corners.after][:, None, :], axis=2).min(axis=1)
    # The distance has a peak between samples where the nearer curve changes.
    top = _GRID[np.argmax(away, axis=1)]
    fine, _ = _distances(path, points, np.clip(top[:, None] + _GRID[1] * np.linspace(-1.0, 1.0, 17), 0.0, 1.0), corner, reach)
    # A blend must not turn back on itself.
    forward = np.einsum("ijk,ik->ij", np.diff(at, axis=1), points[:, 5] - points[:, 0]).min(axis=1) > 0.0
    return np.where(forward, np.maximum(missed, np.maximum(away.max(axis=1), fine.max(axis=1))), np.inf)


def _distances(path: Path, points: Array, u: Array, corner: Array, reach: Array) -> tuple[Array, Array]:
    """Return the distances (n, m) of blends at parameters u (n, m) from the path near the corner, and their positions (n, m, n_axis)."""
    w = 1.0 - u
    weights = np.stack([w**5, 5.0 * u * w**4, 10.0 * u**2 * w**3, 10.0 * u**3 * w**2, 5.0 * u**4 * w, u**5], axis=2)
    at = np.einsum("nmk,nkj->nmj", weights, points)
    m = u.shape[1]
    return path.foot_point(at.reshape(-1, path.n_axis), np.repeat(corner, m), np.repeat(reach, m)).distance.reshape(u.shape), at


# --- blend or stop -------------------------------------------------------------------------------------------------------------------


def quicker_blended(route: Route, corners: Corners, reach: Array, points: Array, limits: AxisLimits) -> Flags:
    """Return at which corners the blend takes less time than a stop (n,).

    Parameters
    ----------
    reach : ndarray (n,) [m]
        Length of each curve that the blend uses.
    points : ndarray (n, 6, n_axis) [m]
        Control points of the blends.
    limits : AxisLimits
        For the path's number of axes.
    """
    before, after, _ = corners
    feedrate = np.minimum(route.feedrate[before], route.feedrate[after])
    parts = [_times_and_speeds(points[i : i + _TIMED], feedrate[i : i + _TIMED], limits) for i in range(0, max(len(points), 1), _TIMED)]
    blend, *ends = (np.concatenate(column) for column in zip(*parts, strict=True))
    stop, rest, span = np.zeros_like(reach), np.zeros_like(reach), np.diff(route.path.breaks)
    for curve, at, speed in ((before, span[before], ends[0]), (after, rest, ends[1])):
        # A blend that uses more than half of a curve owns what it uses.
        owned = np.maximum(span[curve], 2.0 * reach)
        whole, left = _durations(route, curve, at, limits, (owned, rest), (owned - 2.0 * reach, speed))
        stop += 0.5 * whole
        blend += 0.5 * left
    return np.asarray(blend < stop)


def _durations(route: Route, curve: Index, at: Array, limits: AxisLimits, *moves: tuple[Array, Array]) -> Iterator[Array]:
    """Yield the durations (n,) [s] of moves over a length from a speed to the same speed, with the limits at places on curves."""
    _, tangent, second = route.path.at(curve, at, 2)
    with np.errstate(divide="ignore"):
        acceleration, jerk = (np.min(limit / np.abs(tangent), axis=1) for limit in (limits.acceleration, limits.jerk))
    ceiling = speed_limit(Samples(tangent, second, np.zeros_like(second), route.feedrate[curve]), limits, _WHOLE)
    for length, speed in moves:
        peak = peak_speed(length, speed, speed, np.maximum(ceiling, speed), acceleration, jerk, jerk)
        ramp = ramps(speed, peak, acceleration, jerk, jerk)
        cruise = np.maximum(length - 2.0 * ramp.distance, 0.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            yield 2.0 * (ramp.rise_time + ramp.hold_time + ramp.taper_time) + np.where(cruise > 0.0, cruise / peak, 0.0)


def _times_and_speeds(points: Array, feedrate: Array, limits: AxisLimits) -> tuple[Array, Array, Array]:
    """Return the duration of each blend, and the speeds at its ends.

    With the speed v at the slowest place, three limits apply at the distance d from it: the bend; the acceleration, sqrt(v^2 + 2 A d); and
    the jerk, v + (J/5)/4 (d/v)^2, because turning leaves a fifth of J, which acts for the time d/v.
    """
    n, m = len(points), _COARSE.size
    derivatives, stretch = shapes(quintic_bezier(points), _COARSE)
    _, tangent, second, third = derivatives.reshape(4, n * m, -1)
    local = speed_limit(Samples(tangent, second, third, np.repeat(feedrate, m)), limits, _BLEND).reshape(n, m)
    step = 0.5 * (stretch[:, 1:] + stretch[:, :-1]) * np.diff(_COARSE)
    place = np.concatenate([np.zeros((n, 1)), np.cumsum(step, axis=1)], axis=1)
    slowest = np.argmin(local, axis=1)
    least = local[np.arange(n), slowest][:, None]
    away = np.abs(place - place[np.arange(n), slowest][:, None])
    with np.errstate(over="ignore", invalid="ignore"):
        by_acceleration = np.sqrt(least**2 + 2.0 * float(np.min(limits.acceleration)) * away)
        by_jerk = least + np.where(away > 0.0, 0.05 * float(np.min(limits.jerk)) * (away / least) ** 2, 0.0)
    speed = np.minimum(local, np.minimum(by_acceleration, by_jerk))
    return np.asarray(np.sum(2.0 * step / (speed[:, 1:] + speed[:, :-1]), axis=1)), speed[:, 0], speed[:, -1]


_NEARLY_ALL = 0.99
"""Usable fraction of a curve with a blend at one end only."""
_NEARLY_HALF = 0.495
"""Blends that would end between here and the middle of the curve are shortened to end here, so that no sliver remains."""


def blended(route: Route, limits: AxisLimits | None = None) -> Route:
    """Fit curves to short lines and arcs, merge lines and round corners, each within its tolerance.

    Parameters
    ----------
    route : Route
        With `merge_tolerance` and `corner_tolerance`; returned unchanged where both are 0 everywhere.
    limits : AxisLimits, optional
        If given, the route keeps to their velocity along the path, and a corner is not rounded where a stop takes less time than the
        blend; see `quicker_blended`. If they name a planner, the lines that it commands.

    Returns
    -------
    Route
        `path` is the new path, `programmed` the programmed one, `correspondence` the map between them. The deviation is at most P, or
        Q + P/2 where Q is greater than P.

    Notes
    -----
    A quintic curve of continuous tangent and curvature replaces each corner between lines, arcs and helices. It uses at most half of
    each curve, or 99 % of a curve with a blend at one end only. These corners stay: with a dwell or an exact stop, between rapid and
    feed moves, reversals (more than 175 degrees), and at other curves. Where the feedrate changes at a corner, it changes in the middle
    of the blend.
    """
    if limits is not None and limits.planner is not None:
        route = route.within(limits.path_velocity)
        return commanded(merged(chorded(route), chains=True) if isinstance(limits.planner, LinuxCNC) else route, limits)
    refuse(bool(np.isinf(route.corner_tolerance).any()), FeedError, "corner_tolerance: without a bound for LinuxCNC's planner only")
    route = merged(fitted(route if limits is None else route.within(limits.path_velocity)))
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
    plain = path.of_kind(Lines, Arcs)
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
    before, after, _ = corners
    # Where the feedrate changes at a corner, each half of the blend gets the feedrate of its side.
    coefficients, corner, second = _halved(quintic_bezier(points), route.feedrate[before] != route.feedrate[after])
    path, span, size = route.path, np.diff(route.path.breaks), reach[corner]
    whole, middle = np.bincount(corner)[corner] == 1, path.breaks[before + 1][corner]
    stretch = np.where(second, middle, middle - size), np.where(whole | second, middle + size, middle)
    low, high, start, end = np.zeros_like(span), span.copy(), path.starts[0].copy(), path.ends[0].copy()
    low[after], high[before], start[after], end[before] = reach, span[before] - reach, points[:, 5], points[:, 0]
    rounds = Quintics(coefficients, *stretch, np.where(second, after[corner], before[corner]), before[corner])
    return replaced(route, rounds, low, high, start, end)


def _halved(coefficients: Array, wanted: Flags) -> tuple[Array, Index, Flags]:
    """Halve the wanted curves (n, 6, n_axis); return all curves, the number of each one's original, and whether it is a second half."""
    corner = np.repeat(np.arange(len(wanted)), np.where(wanted, 2, 1))
    second = np.append(False, corner[1:] == corner[:-1])
    pieces = coefficients[corner]
    pieces[wanted[corner]] = halves(coefficients[wanted])
    return pieces, corner, second
