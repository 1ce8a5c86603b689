"""Find what limits the speed at each place: the programmed feedrate, an axis limit, or a stop."""

from __future__ import annotations

from enum import IntEnum

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.arrays import Array
from contourlab.feed.junctions import junction_speed, junctions
from contourlab.feed.limits import AxisLimits
from contourlab.feed.profile import Profile
from contourlab.feed.route import Route

NEAR_FEED = 0.98  # of the programmed feedrate: at or above this, the feedrate is the limit
NEAR = 0.9  # the same for any other limit
MARGIN = 1e-9  # [m] places closer than this to a junction are on it
STILL = 1e-7  # [m/s] slower is a standstill, up to rounding


class Binding(IntEnum):
    """What limits the speed."""

    REST = 0
    """A standstill: corner, dwell, exact stop, start or end."""
    FEEDRATE = 1
    """The programmed feedrate."""
    VELOCITY = 2
    """An axis velocity."""
    ACCELERATION = 3
    """An axis acceleration, from turning, speeding up or braking."""
    JERK = 4
    """An axis jerk."""
    CURVATURE_STEP = 5
    """The acceleration step where the curvature jumps."""
    PLANNER = 6
    """None of these: the planner slows down for a slow place nearby."""


def limiting(route: Route, limits: AxisLimits, profile: Profile, arc_length: ArrayLike, *, curvature_step: float = 1.0) -> NDArray[np.int8]:
    """Find what limits the speed of a planned motion at given places.

    Parameters
    ----------
    route, limits, curvature_step
        As given to `plan`.
    profile : Profile
        `profile` of the planned reference.
    arc_length : array_like (n,) [m]
        Progress from 0 to the end of the motion, counted over all laps.

    Returns
    -------
    ndarray (n,) of int8
        Values of `Binding`: FEEDRATE within 2 % of the feedrate; else the most used limit, if used by at least 90 %; else PLANNER.

    Raises
    ------
    FeedError
        If the limits have a different number of axes.

    Notes
    -----
    An axis moves with velocity t v, acceleration t a + k v^2 and jerk t j + 3 k v a + c v^3; see `contourlab.feed.bounds`.
    """
    limits = limits.for_axes(route.path.n_axis)
    place = np.clip(np.atleast_1d(np.asarray(arc_length, dtype=np.float64)), 0.0, profile.length)
    span, dt = profile.reached(place)
    a0, j = profile.a0[span], profile.j[span]
    v, a = np.maximum(profile.v0[span] + dt * (a0 + dt * j / 2.0), 0.0), a0 + dt * j
    _, t, k, c = route.path.derivatives(place, 3)
    turn = 3.0 * k * (v * a)[:, None] + c * v[:, None] ** 3
    with np.errstate(invalid="ignore"):
        used = np.stack(
            [
                v / route.feedrate[route.path.curve_index(place)],
                np.max(np.abs(t * v[:, None]) / limits.velocity, axis=1),
                np.max(np.abs(t * a[:, None] + k * v[:, None] ** 2) / limits.acceleration, axis=1),
                np.max(np.abs(t * j[:, None] + turn) / limits.jerk, axis=1),
                v / _junction_ceiling(route, limits, place, curvature_step),
            ]
        )
    codes = np.array([Binding.FEEDRATE, Binding.VELOCITY, Binding.ACCELERATION, Binding.JERK, Binding.CURVATURE_STEP])
    used[0] = np.where(used[0] >= NEAR_FEED, used[0], 0.0)
    # In this order: stop, feedrate, junction at this place, most used limit.
    rules = [v <= STILL, used[0] >= NEAR_FEED, used[4] >= NEAR, used.max(axis=0) >= NEAR]
    values = [Binding.REST, Binding.FEEDRATE, Binding.CURVATURE_STEP, codes[np.argmax(used, axis=0)]]
    return np.asarray(np.select(rules, values, Binding.PLANNER), dtype=np.int8)


def _junction_ceiling(route: Route, limits: AxisLimits, place: Array, curvature_step: float) -> Array:
    """Return the speed ceiling of the junction at each place (n,), inf where there is none."""
    breaks = np.asarray(route.path.breaks)
    within = np.mod(place, route.path.length) if route.path.closed else place
    junction = np.clip(np.searchsorted(0.5 * (breaks[1:] + breaks[:-1]), within), 0, breaks.size - 1)
    ceiling = junction_speed(junctions(route), limits, curvature_step)
    return np.asarray(np.where(np.abs(within - breaks[junction]) <= MARGIN, ceiling[junction - 1], np.inf))
