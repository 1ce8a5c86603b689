"""Jerk-limited feed along a route, with exact stops at its corners, and what limits its speed at each place.

The route is divided at its stops into segments (`pieces`). A straight segment is planned in closed form: it is cut into pieces with one set
of limits each, a forward pass (speeding up) and a backward pass (braking) find the speed at every border, and each piece is a move of at
most seven spans of constant jerk (`bounds`) without acceleration at the borders. All other segments are planned together by `smooth`. Where
a segment has several motions, the fastest is used.
"""

from __future__ import annotations

from enum import IntEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.arrays import Array, Flags, Index, ranges
from contourlab.errors import FeedError
from contourlab.feed.bounds import N_SPAN, AxisLimits, Bounds, border_speeds, move_spans, peak_speed
from contourlab.feed.pieces import Pieces, Segments, Survey, cut, sample_segments, split_at_stops, survey
from contourlab.feed.reference import Profile, Reference, lap_ranges, whole_samples
from contourlab.feed.route import Route, junction_speed, junctions
from contourlab.feed.smooth import smooth_motions
from contourlab.feed.trapezoids import course, trapezoids

N_SHORT = 200  # segments of up to this many curves are planned in closed form as well


class _Moves(NamedTuple):
    """Motions of some segments: spans (n, 5) as rows (duration, s0, v0, a0, j), and the segment (n,) of each, rising."""

    spans: Array
    segment: Index

    def only(self, rows: Flags | Index) -> _Moves:
        """Return some of the spans."""
        return _Moves(self.spans[rows], self.segment[rows])


def _border_speeds(pieces: Pieces) -> tuple[Array, Array]:
    """Return the speeds at the start and at the end of each piece.

    The speed at a border is the highest that its two pieces permit, lowered until every piece can be crossed within its limits.
    """
    bounds = pieces.bounds
    ceiling = np.minimum(np.minimum(bounds.speed, np.append(bounds.speed[1:], 0.0)), pieces.junction_speed)
    ceiling = np.where(pieces.stop, 0.0, ceiling)
    ceiling[-1] = 0.0
    speed = border_speeds(pieces.length, np.append(0.0, ceiling), bounds.acceleration, bounds.rise, bounds.taper)
    return speed[:-1], speed[1:]


def _closed_form(route: Route, surveyed: Survey, limits: AxisLimits, segments: Segments, chosen: Index) -> _Moves:
    """Plan segments as moves from border to border of their pieces."""
    laps = int(segments.after[-1]) // route.n_curve
    in_lap = np.zeros((laps, route.n_curve), dtype=bool)
    in_lap.reshape(-1)[ranges(segments.first[chosen], segments.after[chosen] - segments.first[chosen])] = True
    pieces = _repeated(cut(route, surveyed, limits, np.asarray(in_lap.any(axis=0))), laps, route)
    start_speed, end_speed = _border_speeds(pieces)
    ceiling, *shape = pieces.bounds
    peak = peak_speed(pieces.length, start_speed, end_speed, ceiling, *shape)
    spans = np.stack(move_spans(pieces.length, start_speed, peak, end_speed, *shape), axis=-1)
    spans[:, :, 1] += pieces.start[:, None]
    return _Moves(spans.reshape(-1, 5), np.repeat(np.searchsorted(segments.after, pieces.curve, side="right"), N_SPAN))


def _repeated(pieces: Pieces, laps: int, route: Route) -> Pieces:
    """Return the pieces of several laps, their starts and curves counted over the laps."""
    lap = np.repeat(np.arange(laps), pieces.start.size)
    return Pieces(
        np.tile(pieces.start, laps) + lap * float(route.path.length),
        np.tile(pieces.length, laps),
        Bounds(*(np.tile(part, laps) for part in pieces.bounds)),
        np.tile(pieces.stop, laps),
        np.tile(pieces.junction_speed, laps),
        np.tile(pieces.curve, laps) + lap * route.n_curve,
    )


def _fastest(n_segment: int, moves: list[_Moves]) -> _Moves:
    """Return the quickest motion of each segment, in the order of travel."""
    time = np.full((len(moves), n_segment), np.inf)
    for row, move in zip(time, moves, strict=True):
        planned = np.unique(move.segment)
        row[planned] = np.bincount(move.segment, move.spans[:, 0], n_segment)[planned]
    best = np.argmin(time, axis=0)
    kept = [move.only(best[move.segment] == k) for k, move in enumerate(moves)]
    whole = _Moves(*(np.concatenate(column) for column in zip(*kept, strict=True)))
    return whole.only(np.argsort(whole.segment, kind="stable"))


def _with_rests(moves: _Moves, route: Route, segments: Segments) -> Array:
    """Insert the dwells after the spans of their segments."""
    lap, curve = np.divmod(segments.after - 1, route.n_curve)
    dwell = np.flatnonzero(route.dwell[curve] > 0.0)
    rows = np.zeros((dwell.size, 5))
    rows[:, 0] = route.dwell[curve[dwell]]
    rows[:, 1] = np.asarray(route.path.breaks)[curve[dwell] + 1] + lap[dwell] * route.path.length
    return np.insert(moves.spans, np.searchsorted(moves.segment, dwell, side="right"), rows, axis=0)


def _motions(route: Route, surveyed: Survey, limits: AxisLimits, laps: int) -> Array:
    """Return the spans of the whole route as rows (duration, s0, v0, a0, j)."""
    segments = split_at_stops(surveyed, laps)
    bent = np.flatnonzero(~segments.straight)
    moves = []
    if bent.size:
        samples = sample_segments(route, surveyed, limits, segments, bent)
        for motion in smooth_motions(route.path, samples, limits):
            of_segment = np.repeat(np.arange(bent.size), np.diff(motion.begin))
            moves.append(_Moves(motion.spans, bent[of_segment]).only(motion.good[of_segment]))
        del samples
    # The closed form is exact on straight segments. On short ones, with little to look ahead to, it may also be the fastest.
    missing = np.ones(segments.first.size, dtype=bool)
    for move in moves:
        missing[move.segment] = False
    closed = np.flatnonzero(segments.straight | missing | (segments.after - segments.first <= N_SHORT))
    if closed.size:
        moves.append(_closed_form(route, surveyed, limits, segments, closed))
    return _with_rests(_fastest(segments.first.size, moves), route, segments)


def plan_profile(route: Route, limits: AxisLimits, *, laps: int = 1, curvature_step: float = 1.0) -> Profile:
    """Plan the motion along a route, from rest to rest, without sampling it; parameters as for `plan`."""
    if laps < 1 or (laps > 1 and not route.path.closed):
        raise FeedError(f"laps = {laps}: give at least 1, and more than 1 only for a closed path")
    limits, route = limits.for_axes(route.path.n_axis), route.within(limits.path_velocity)
    unlimited = np.flatnonzero(limits.unbounded)
    if unlimited.size:
        raise FeedError(
            f"axis {unlimited[0]} has neither an acceleration nor a jerk limit, so no ramp can be planned: "
            "give one of them a finite value, or use uniform(), which has no ramps"
        )
    if limits.planner is None:
        rows = _motions(route, survey(route, limits, curvature_step), limits, laps)
    else:
        rows = trapezoids(route, limits, laps)
    rows = np.concatenate([[[route.dwell_before, 0.0, 0.0, 0.0, 0.0]], rows])
    duration, s0, v0, a0, j = np.ascontiguousarray(rows[rows[:, 0] > 0.0].T)
    ends = np.cumsum(duration)
    return Profile(np.append(0.0, ends[:-1]), s0, v0, a0, j, duration=float(ends[-1]), length=laps * float(route.path.length))


def plan(route: Route, limits: AxisLimits, servo_period: float, *, laps: int = 1, curvature_step: float = 1.0) -> Reference:
    """Plan a motion along a route, from rest to rest: jerk-limited, or as the control of `limits` does.

    Parameters
    ----------
    route : Route
    limits : AxisLimits
    servo_period : float [s], > 0
    laps : int, >= 1
        Laps of a closed path, without a stop in between unless the closing point is a corner.
    curvature_step : float, >= 0
        Largest step of an axis acceleration where the curvature jumps (line to arc), as a fraction of its limit; 0 stops at each jump.
        Like a CNC, the planner passes these places, although no finite jerk limit can hold there. `limit_report` lists the steps
        separately.

    Returns
    -------
    Reference
        Sample k is at the time ``k * servo_period``; the last sample is at rest at the end.

    Raises
    ------
    FeedError
        If the route and the limits have different numbers of axes, or an axis has neither an acceleration nor a jerk limit.
    """
    profile = plan_profile(route, limits, laps=laps, curvature_step=curvature_step)
    return Reference(
        servo_period=servo_period,
        n_sample=whole_samples(profile.duration, servo_period),
        path=route.path,
        programmed=route.programmed,
        correspondence=route.correspondence,
        profile=profile,
        line_breaks=route.line_breaks,
        source_lines=route.source_line,
        rapid=route.rapid,
        laps=lap_ranges(profile, float(route.path.length), laps, servo_period) if laps > 1 else (),
    )


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
    CORNER = 7
    """A corner that the control passes without rounding it."""


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
    limits, route = limits.for_axes(route.path.n_axis), route.within(limits.path_velocity)
    place = np.clip(np.atleast_1d(np.asarray(arc_length, dtype=np.float64)), 0.0, profile.length)
    span, dt = profile.reached(place)
    a0, j = profile.a0[span], profile.j[span]
    v, a = np.maximum(profile.v0[span] + dt * (a0 + dt * j / 2.0), 0.0), a0 + dt * j
    _, t, k, c = route.path.derivatives(place, 3)
    turn = 3.0 * k * (v * a)[:, None] + c * v[:, None] ** 3
    with np.errstate(invalid="ignore", divide="ignore"):
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
    junction = Binding.CURVATURE_STEP if limits.planner is None else Binding.CORNER
    values = [Binding.REST, Binding.FEEDRATE, junction, codes[np.argmax(used, axis=0)]]
    return np.asarray(np.select(rules, values, Binding.PLANNER), dtype=np.int8)


def _junction_ceiling(route: Route, limits: AxisLimits, place: Array, curvature_step: float) -> Array:
    """Return the speed ceiling of the junction at each place (n,), inf where there is none."""
    breaks = np.asarray(route.path.breaks)
    within = np.mod(place, route.path.length) if route.path.closed else place
    junction = np.clip(np.searchsorted(0.5 * (breaks[1:] + breaks[:-1]), within), 0, breaks.size - 1)
    ceiling = junction_speed(junctions(route), limits, curvature_step) if limits.planner is None else course(route, limits).corner
    return np.asarray(np.where(np.abs(within - breaks[junction]) <= MARGIN, ceiling[junction - 1], np.inf))
