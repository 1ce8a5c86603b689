"""What limits the speed of a motion at each place: the programmed feedrate, a limit of an axis, or a stop."""

from __future__ import annotations

from enum import IntEnum

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.feed.junctions import junctions
from contourlab.feed.limits import AxisLimits
from contourlab.feed.pieces import junction_speed
from contourlab.feed.profile import Profile
from contourlab.feed.route import Route

Array = NDArray[np.float64]

NEAR_FEED = 0.98  # of the programmed feedrate: at or above, the feedrate is the limit
NEAR = 0.9  # of any other limit
MARGIN = 1e-9  # [m] places this near to a joint are at it
STILL = 1e-7  # [m/s] rounding of a place next to a stop


class Binding(IntEnum):
    """What limits the speed."""

    REST = 0
    """The motion stands still: a corner, a dwell, an exact stop, the start or the end."""
    FEEDRATE = 1
    """The programmed feedrate."""
    VELOCITY = 2
    """The velocity of an axis."""
    ACCELERATION = 3
    """The acceleration of an axis, in turning or in speeding up or braking."""
    JERK = 4
    """The jerk of an axis."""
    CURVATURE_STEP = 5
    """The step of acceleration where the curvature jumps."""
    PLANNER = 6
    """None of them: the planner keeps a margin near slow places ahead and behind."""


def limiting(route: Route, limits: AxisLimits, profile: Profile, arc_length: ArrayLike, *, curvature_step: float = 1.0) -> NDArray[np.int8]:
    """Find what limits the speed of a planned motion at given places.

    Parameters
    ----------
    route : Route
        What was planned.
    limits : AxisLimits
        With which it was planned.
    profile : Profile
        Its motion: the `profile` of the reference that `plan` returned.
    arc_length : array_like (n,) [m]
        Progress from 0 to the length of the motion, over laps as well; of a place where the motion rests, the time of its arrival counts.
    curvature_step : float, >= 0
        As it was given to `plan`.

    Returns
    -------
    ndarray (n,) of int8
        Values of `Binding`: the limit that is used to the greatest part; within 2 % of the programmed feedrate, the feedrate.

    Raises
    ------
    FeedError
        If the limits are for another number of axes.

    Notes
    -----
    An axis uses t v of its velocity, t a + k v^2 of its acceleration, t j + 3 k v a + c v^3 of its jerk (see `contourlab.feed.bounds`).
    Below 90 % of every limit the planner itself is named.
    """
    limits = limits.for_axes(route.path.n_axis)
    where = np.clip(np.atleast_1d(np.asarray(arc_length, dtype=np.float64)), 0.0, profile.length)
    v, a, j = _along(profile, where)
    _, t, k, c = route.path.derivatives(where, 3)
    turn = 3.0 * k * (v * a)[:, None] + c * v[:, None] ** 3
    index = route.path.curve_index(where)
    at_joint = _junction_ceiling(route, limits, where, curvature_step)
    with np.errstate(invalid="ignore"):
        used = np.stack(
            [
                v / route.feedrate[index],
                np.max(np.abs(t * v[:, None]) / limits.velocity, axis=1),
                np.max(np.abs(t * a[:, None] + k * v[:, None] ** 2) / limits.acceleration, axis=1),
                np.max(np.abs(t * j[:, None] + turn) / limits.jerk, axis=1),
                v / at_joint,
            ]
        )
    codes = np.array([Binding.FEEDRATE, Binding.VELOCITY, Binding.ACCELERATION, Binding.JERK, Binding.CURVATURE_STEP])
    used[0] = np.where(used[0] >= NEAR_FEED, used[0], 0.0)
    found = np.where(used.max(axis=0) >= NEAR, codes[np.argmax(used, axis=0)], Binding.PLANNER)
    # The feed, and the joint that a place lies at, come before what happens to be used beside them.
    found = np.where(used[4] >= NEAR, Binding.CURVATURE_STEP, found)
    found = np.where(used[0] >= NEAR_FEED, Binding.FEEDRATE, found)
    return np.asarray(np.where(v <= STILL, Binding.REST, found), dtype=np.int8)


def _junction_ceiling(route: Route, limits: AxisLimits, where: Array, curvature_step: float) -> Array:
    """Return the ceiling of speed of a joint at each place (n,), inf where there is none."""
    breaks = np.asarray(route.path.breaks)
    within = np.mod(where, route.path.length) if route.path.closed else where
    joint = np.clip(np.searchsorted(0.5 * (breaks[1:] + breaks[:-1]), within), 0, breaks.size - 1)
    ceiling = junction_speed(junctions(route), limits, curvature_step)
    return np.asarray(np.where(np.abs(within - breaks[joint]) <= MARGIN, ceiling[joint - 1], np.inf))


def _along(profile: Profile, where: Array) -> tuple[Array, Array, Array]:
    """Return speed, acceleration and jerk (n,) at each place of a motion."""
    # Spans at rest and spans at one place begin together: the first of them is met on arrival.
    span = np.clip(np.searchsorted(profile.s0, where, side="right") - 1, 0, profile.n_span - 1)
    lasting = np.diff(np.append(profile.t0, profile.duration))[span]
    below, above = np.zeros_like(where), lasting.copy()
    s0, v0, a0, j = profile.s0[span], profile.v0[span], profile.a0[span], profile.j[span]
    for _ in range(60):
        middle = 0.5 * (below + above)
        early = s0 + middle * (v0 + middle * (a0 / 2.0 + middle * j / 6.0)) < where
        below, above = np.where(early, middle, below), np.where(early, above, middle)
    return np.maximum(v0 + above * (a0 + above * j / 2.0), 0.0), a0 + above * j, j
