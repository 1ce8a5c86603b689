"""Whether a blend is worth its while: where jerk is scarce, a stop at the corner can be quicker than creeping round it.

Both are reckoned in closed form for a corner whose neighbours are like itself, so that its two curves are halved between them. With a stop
each half is half of a move from rest to rest; with a blend it is half of a move over what the blend leaves, from the speed at the blend's
end to that speed again, and the time within the blend. Along a polygon of equal sides that is nearly exact.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from contourlab.feed.bounds import Samples, Share, speed_limit
from contourlab.feed.limits import AxisLimits
from contourlab.feed.route import Route
from contourlab.feed.scurve import peak_speed, ramps
from contourlab.geometry.blend import quintic_bezier, shapes

Array = NDArray[np.float64]
Index = NDArray[np.int64]

_GRID = np.linspace(0.0, 1.0, 17)
_CHUNK = 1024  # corners looked at together
_WHOLE = Share(1.0, 1.0, 1.0, 1.0)
_BLEND = Share(1.0, 1.0, 0.8, 1.0)
"""Part of the limits that the planner spends on turning in a blend: the rest of the jerk goes into braking before it and speeding up."""


def quicker_blended(route: Route, before: Index, after: Index, reach: Array, points: Array, limits: AxisLimits) -> NDArray[np.bool_]:
    """Return at which corners the blend takes less time than a stop (n,).

    Parameters
    ----------
    route : Route
    before, after : ndarray (n,) of int
        The curves that end and begin at each corner.
    reach : ndarray (n,) [m]
        How much of either curve the blend uses.
    points : ndarray (n, 6, n_axis) [m]
        Control points of the blends.
    limits : AxisLimits
        For the path's number of axes.

    Returns
    -------
    ndarray (n,) of bool
    """
    feedrate = np.minimum(route.feedrate[before], route.feedrate[after])
    parts = [_passed(points[i : i + _CHUNK], feedrate[i : i + _CHUNK], limits) for i in range(0, max(len(points), 1), _CHUNK)]
    blend, *ends = (np.concatenate(column) for column in zip(*parts, strict=True))
    stop = np.zeros_like(reach)
    span = np.diff(route.path.breaks)
    for curve, at, speed in ((before, span[before], ends[0]), (after, np.zeros_like(reach), ends[1])):
        here = _Side(route, curve, at, limits)
        stop += 0.5 * here.time(span[curve], np.zeros_like(reach))
        blend += 0.5 * here.time(np.maximum(span[curve] - 2.0 * reach, 0.0), speed)
    return np.asarray(blend < stop)


class _Side:
    """Limits along a curve next to its corner."""

    def __init__(self, route: Route, curve: Index, at: Array, limits: AxisLimits) -> None:
        _, tangent, second = route.path.at(curve, at, 2)
        with np.errstate(divide="ignore"):
            share = np.abs(tangent)
            self.acceleration, self.jerk = (np.min(limit / share, axis=1) for limit in (limits.acceleration, limits.jerk))
        samples = Samples(tangent, second, np.zeros_like(second), route.feedrate[curve])
        self.ceiling = speed_limit(samples, limits, _WHOLE)

    def time(self, length: Array, speed: Array) -> Array:
        """Return the times (n,) [s] of moves over `length` from `speed` to `speed`."""
        ceiling = np.maximum(self.ceiling, speed)
        shape = self.acceleration, self.jerk, self.jerk
        peak = peak_speed(length, speed, speed, ceiling, *shape)
        ramp = ramps(speed, peak, *shape)
        cruise = np.maximum(length - 2.0 * ramp.distance, 0.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            return 2.0 * (ramp.rise_time + ramp.hold_time + ramp.taper_time) + np.where(cruise > 0.0, cruise / peak, 0.0)


def _passed(points: Array, feedrate: Array, limits: AxisLimits) -> tuple[Array, Array, Array]:
    """Return the time that each blend takes, and the speeds at its ends.

    Away from its slowest place a blend is driven as fast as it bends there, as acceleration permits, v^2 + 2 A d, and as the jerk
    left beside the turning does, a fifth of J, in the time d/v that the way d takes: v + (J/5)/4 (d/v)^2.
    """
    n, m = len(points), _GRID.size
    derivatives, stretch = shapes(quintic_bezier(points), _GRID)
    _, tangent, second, third = derivatives.reshape(4, n * m, -1)
    samples = Samples(tangent, second, third, np.repeat(feedrate, m))
    local = speed_limit(samples, limits, _BLEND).reshape(n, m)
    step = 0.5 * (stretch[:, 1:] + stretch[:, :-1]) * np.diff(_GRID)
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
