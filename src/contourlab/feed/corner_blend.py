"""The shape of a blend: the quintic curve that rounds a corner within a tolerance.

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

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.feed.bounds import Samples, Share, speed_limit
from contourlab.feed.limits import AxisLimits
from contourlab.feed.route import Route
from contourlab.feed.scurve import peak_speed, ramps
from contourlab.geometry import Path
from contourlab.geometry.blend import quintic_bezier, shapes

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
    reach = most.copy()
    on = np.arange(most.size)
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
    step = _GRID[1] * np.linspace(-1.0, 1.0, 17)
    fine, _ = _distances(path, points, np.clip(top[:, None] + step, 0.0, 1.0), corner, reach)
    # A blend must not turn back on itself.
    forward = np.einsum("ijk,ik->ij", np.diff(at, axis=1), points[:, 5] - points[:, 0]).min(axis=1) > 0.0
    return np.where(forward, np.maximum(missed, np.maximum(away.max(axis=1), fine.max(axis=1))), np.inf)


def _distances(path: Path, points: Array, u: Array, corner: Array, reach: Array) -> tuple[Array, Array]:
    """Return the distances (n, m) of blends at parameters u (n, m) from the path near the corner, and their positions (n, m, n_axis)."""
    w = 1.0 - u
    weights = np.stack([w**5, 5.0 * u * w**4, 10.0 * u**2 * w**3, 10.0 * u**3 * w**2, 5.0 * u**4 * w, u**5], axis=2)
    at = np.einsum("nmk,nkj->nmj", weights, points)
    m = u.shape[1]
    feet = path.foot_point(at.reshape(-1, path.n_axis), np.repeat(corner, m), np.repeat(reach, m))
    return feet.distance.reshape(u.shape), at


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
    stop = np.zeros_like(reach)
    span = np.diff(route.path.breaks)
    for curve, at, speed in ((before, span[before], ends[0]), (after, np.zeros_like(reach), ends[1])):
        here = _Side(route, curve, at, limits)
        stop += 0.5 * here.time(span[curve], np.zeros_like(reach))
        blend += 0.5 * here.time(np.maximum(span[curve] - 2.0 * reach, 0.0), speed)
    return np.asarray(blend < stop)


class _Side:
    """Limits along the curves on one side of the corners."""

    def __init__(self, route: Route, curve: Index, at: Array, limits: AxisLimits) -> None:
        _, tangent, second = route.path.at(curve, at, 2)
        with np.errstate(divide="ignore"):
            self.acceleration, self.jerk = (np.min(limit / np.abs(tangent), axis=1) for limit in (limits.acceleration, limits.jerk))
        samples = Samples(tangent, second, np.zeros_like(second), route.feedrate[curve])
        self.ceiling = speed_limit(samples, limits, _WHOLE)

    def time(self, length: Array, speed: Array) -> Array:
        """Return the durations (n,) [s] of moves over `length` from `speed` to the same speed."""
        limits = self.acceleration, self.jerk, self.jerk
        peak = peak_speed(length, speed, speed, np.maximum(self.ceiling, speed), *limits)
        ramp = ramps(speed, peak, *limits)
        cruise = np.maximum(length - 2.0 * ramp.distance, 0.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            return 2.0 * (ramp.rise_time + ramp.hold_time + ramp.taper_time) + np.where(cruise > 0.0, cruise / peak, 0.0)


def _times_and_speeds(points: Array, feedrate: Array, limits: AxisLimits) -> tuple[Array, Array, Array]:
    """Return the duration of each blend, and the speeds at its ends.

    With the speed v at the slowest place, three limits apply at the distance d from it: the bend; the acceleration, sqrt(v^2 + 2 A d); and
    the jerk, v + (J/5)/4 (d/v)^2, because turning leaves a fifth of J, which acts for the time d/v.
    """
    n, m = len(points), _COARSE.size
    derivatives, stretch = shapes(quintic_bezier(points), _COARSE)
    _, tangent, second, third = derivatives.reshape(4, n * m, -1)
    samples = Samples(tangent, second, third, np.repeat(feedrate, m))
    local = speed_limit(samples, limits, _BLEND).reshape(n, m)
    step = 0.5 * (stretch[:, 1:] + stretch[:, :-1]) * np.diff(_COARSE)
    place = np.concatenate([np.zeros((n, 1)), np.cumsum(step, axis=1)], axis=1)
    slowest = np.argmin(local, axis=1)
    least = local[np.arange(n), slowest][:, None]
    away = np.abs(place - place[np.arange(n), slowest][:, None])
    with np.errstate(over="ignore", invalid="ignore"):
        by_acceleration = np.sqrt(least**2 + 2.0 * float(np.min(limits.acceleration)) * away)
        by_jerk = least + np.where(away > 0.0, 0.05 * float(np.min(limits.jerk)) * (away / least) ** 2, 0.0)
    speed = np.minimum(local, np.minimum(by_acceleration, by_jerk))
    time = np.sum(2.0 * step / (speed[:, 1:] + speed[:, :-1]), axis=1)
    return np.asarray(time), speed[:, 0], speed[:, -1]
