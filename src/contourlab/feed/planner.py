"""Jerk-limited feed along a route, with exact stops at its corners.

The route is cut into pieces with one set of limits each (`pieces`, `bounds`). Two passes over the pieces of each smooth
stretch, forward for speeding up and backward for braking, give the speed at every border; then each piece is one move
of at most seven spans of constant jerk (`scurve`). The tangential acceleration is zero at the borders of pieces.
Stretches with general curves are planned a second way (`smooth`), and the faster of the two is taken.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import FeedError
from contourlab.feed.bounds import Bounds
from contourlab.feed.limits import AxisLimits
from contourlab.feed.pieces import Pieces, cut, survey
from contourlab.feed.profile import Profile
from contourlab.feed.reference import Reference, lap_ranges, whole_samples
from contourlab.feed.route import Route
from contourlab.feed.scurve import move_spans, peak_speed, reachable_speed
from contourlab.feed.smooth import Stretch, smooth_profile
from contourlab.feed.stretches import general_stretches
from contourlab.geometry import Path

__all__ = ["plan", "plan_profile"]

Array = NDArray[np.float64]


def _border_speeds(pieces: Pieces) -> tuple[Array, Array]:
    """Return the speeds at the start and at the end of each piece.

    A border's speed is the highest that its two pieces permit, lowered until every piece can be crossed from its
    start to its end within its limits: forward for speeding up, backward for braking.
    """
    bounds = pieces.bounds
    ceiling = np.minimum(np.minimum(bounds.speed, np.append(bounds.speed[1:], 0.0)), pieces.joint_speed)
    ceiling = np.where(pieces.stop, 0.0, ceiling)
    ceiling[-1] = 0.0
    # Pieces between two stops need no look-ahead; only the others are walked over.
    before = np.append(0.0, ceiling[:-1])
    walk = np.flatnonzero((before > 0.0) | (ceiling > 0.0))
    if walk.size:
        rows = zip(
            walk.tolist(),
            pieces.length[walk].tolist(),
            *(part[walk].tolist() for part in (bounds.acceleration, bounds.rise, bounds.taper)),
            strict=True,
        )
        table = list(rows)
        speed = [0.0, *ceiling.tolist()]
        for i, length, acceleration, rise, taper in table:
            if speed[i + 1] > speed[i]:
                speed[i + 1] = reachable_speed(speed[i], speed[i + 1], length, acceleration, rise, taper)
        for i, length, acceleration, rise, taper in reversed(table):
            if speed[i] > speed[i + 1]:
                speed[i] = reachable_speed(speed[i + 1], speed[i], length, acceleration, rise, taper)
        ceiling = np.array(speed[1:])
    return np.append(0.0, ceiling[:-1]), ceiling


def _spans(moves: tuple[Array, ...], pieces: Pieces, rest_after: Array, length: float) -> Array:
    """Return eight spans for each piece as rows (duration, s0, v0, a0, j): its move, and the rest after it."""
    rows = np.zeros((pieces.start.size, 8, 5))
    rows[:, :7] = np.stack(moves, axis=-1)
    rows[:, :7, 1] += pieces.start[:, None]
    rows[:, 7, 1] = np.append(pieces.start[1:], length)
    rows[:, 7, 0] = rest_after
    return rows.reshape(-1, 5)


def _with_smooth_stretches(rows: Array, pieces: Pieces, path: Path, stretches: Iterable[Stretch], limits: AxisLimits) -> Array:
    """Put the spans of smooth stretches in the place of their pieces, where they are faster."""
    parts, done = [], 0
    for stretch in stretches:
        begin, end = float(stretch.arc_length[0]), float(stretch.arc_length[-1])
        first, after = np.searchsorted(pieces.start, [begin - 1e-12, end - 1e-12])
        top, bottom = 8 * int(first), 8 * int(after) - 1  # the last row is the rest after the stretch
        profile = smooth_profile(path, stretch, limits, float(rows[top:bottom, 0].sum()))
        if profile is None:
            continue
        lasting = np.diff(np.append(profile.t0, profile.duration))
        new = np.stack([lasting, profile.s0 + begin, profile.v0, profile.a0, profile.j], axis=-1)
        parts += [rows[done:top], new]
        done = bottom
    return np.concatenate([*parts, rows[done:]])


def _profile(rows: Array, rest_before: float, length: float) -> Profile:
    """Return the profile of spans (duration, s0, v0, a0, j), without those that last no time."""
    rows = np.concatenate([[[rest_before, 0.0, 0.0, 0.0, 0.0]], rows])
    lasting, s0, v0, a0, j = np.ascontiguousarray(rows[rows[:, 0] > 0.0].T)
    ends = np.cumsum(lasting)
    return Profile(np.append(0.0, ends[:-1]), s0, v0, a0, j, duration=float(ends[-1]), length=length)


def _repeated(pieces: Pieces, laps: int, lap_length: float) -> Pieces:
    """Return the pieces of several laps."""
    if laps == 1:
        return pieces
    start = np.concatenate([pieces.start + lap * lap_length for lap in range(laps)])
    return Pieces(
        start,
        np.tile(pieces.length, laps),
        Bounds(*(np.tile(part, laps) for part in pieces.bounds)),
        np.tile(pieces.stop, laps),
        np.tile(pieces.joint_speed, laps),
        np.tile(pieces.curve, laps),
    )


def plan_profile(route: Route, limits: AxisLimits, *, laps: int = 1, curvature_step: float = 1.0) -> Profile:
    """Plan the motion along a route, without sampling it.

    Parameters
    ----------
    route, limits, laps, curvature_step
        As for `plan`.

    Returns
    -------
    Profile
        From rest to rest over ``laps`` times the length of the path.
    """
    if laps < 1 or (laps > 1 and not route.path.closed):
        raise FeedError(f"laps = {laps}: give at least 1, and more than 1 only for a closed path")
    if not curvature_step >= 0.0:
        raise FeedError(f"curvature_step = {curvature_step}: give a part of the acceleration limit, >= 0")
    lap_length = float(route.path.length)
    limits = limits.for_axes(route.path.n_axis)
    free = np.flatnonzero(np.isinf(limits.acceleration) & np.isinf(limits.jerk))
    if free.size:
        raise FeedError(
            f"axis {free[0]} has neither an acceleration nor a jerk limit, so no ramp can be planned: "
            "give one of them a finite value, or use uniform(), which has no ramps"
        )
    seen = survey(route, limits, curvature_step)
    pieces = _repeated(cut(route, seen, limits), laps, lap_length)
    start_speed, end_speed = _border_speeds(pieces)
    bounds = pieces.bounds
    shape = (bounds.acceleration, bounds.rise, bounds.taper)
    peak = peak_speed(pieces.length, start_speed, end_speed, bounds.speed, *shape)
    moves = move_spans(pieces.length, start_speed, peak, end_speed, *shape)
    rest = np.where(pieces.stop, route.dwell[pieces.curve], 0.0)
    rows = _spans(moves, pieces, rest, laps * lap_length)
    rows = _with_smooth_stretches(rows, pieces, route.path, general_stretches(route, seen, laps), limits)
    return _profile(rows, route.dwell_before, laps * lap_length)


def plan(
    route: Route,
    limits: AxisLimits,
    servo_period: float,
    *,
    laps: int = 1,
    curvature_step: float = 1.0,
) -> Reference:
    """Plan a jerk-limited motion along a route, from rest to rest.

    Parameters
    ----------
    route : Route
    limits : AxisLimits
        Limits of each axis; they hold on every smooth stretch.
    servo_period : float [s], > 0
    laps : int, >= 1
        How many times a closed path is driven without stopping in between (unless its closing point is a corner).
    curvature_step : float, >= 0
        Where the curvature jumps (line to arc), an axis' acceleration steps by |jump| v^2, and no finite jerk
        limit can hold there short of a stop. As controllers do, the planner drives through, at a speed where the
        step is at most this part of the axis' acceleration limit. 0 stops at each jump. `limit_report` lists these
        steps apart.

    Returns
    -------
    Reference
        Sample k belongs to ``k * servo_period``; the last sample is at rest at the end.

    Raises
    ------
    FeedError
        If the route and the limits have different numbers of axes, or an axis has neither an
        acceleration nor a jerk limit.
    """
    profile = plan_profile(route, limits, laps=laps, curvature_step=curvature_step)
    n_sample = whole_samples(profile.duration, servo_period)
    ranges = lap_ranges(profile, float(route.path.length), laps, servo_period) if laps > 1 else ()
    return Reference(
        servo_period=servo_period,
        n_sample=n_sample,
        path=route.path,
        programmed=route.programmed,
        profile=profile,
        source_lines=route.source_line,
        laps=ranges,
    )
