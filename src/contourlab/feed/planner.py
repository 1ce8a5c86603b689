"""Jerk-limited feed along a route, with exact stops at its corners.

The route is divided at its stops into stretches (`stretches`). A straight stretch is planned in closed form: cut into pieces with one set
of limits each (`pieces`, `bounds`), two passes over the pieces, forward for speeding up and backward for braking, for the speed at every
border, and one move of at most seven spans of constant jerk a piece (`scurve`), without acceleration at the borders. All other stretches
are planned together by `smooth`; of several motions of a stretch the fastest is taken.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import FeedError
from contourlab.feed.bounds import Bounds
from contourlab.feed.limits import AxisLimits
from contourlab.feed.pieces import Pieces, Survey, cut, survey
from contourlab.feed.profile import Profile
from contourlab.feed.reference import Reference, lap_ranges, whole_samples
from contourlab.feed.route import Route
from contourlab.feed.scurve import N_SPAN, move_spans, peak_speed, reachable_speed
from contourlab.feed.segments import Stretches, ranges, sampled, stretches
from contourlab.feed.smooth import shaped

Array = NDArray[np.float64]
Index = NDArray[np.intp]

N_SHORT = 24  # curves of a stretch up to which the closed form is tried too


class _Moves(NamedTuple):
    """Motions of some stretches: spans (n, 5) as rows (duration, s0, v0, a0, j), and the stretch (n,) of each, rising."""

    spans: Array
    stretch: Index


def _border_speeds(pieces: Pieces) -> tuple[Array, Array]:
    """Return the speeds at the start and at the end of each piece.

    A border's speed is the highest that its two pieces permit, lowered until every piece can be crossed from its
    start to its end within its limits: forward for speeding up, backward for braking.
    """
    bounds = pieces.bounds
    ceiling = np.minimum(np.minimum(bounds.speed, np.append(bounds.speed[1:], 0.0)), pieces.junction_speed)
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


def _closed_form(route: Route, seen: Survey, limits: AxisLimits, parts: Stretches, chosen: Index) -> _Moves:
    """Plan stretches as moves from border to border of their pieces."""
    n_curve, lap_length = route.n_curve, float(route.path.length)
    laps = int(parts.after[-1]) // n_curve
    in_lap = np.zeros((laps, n_curve), dtype=bool)
    in_lap.reshape(-1)[ranges(parts.first[chosen], parts.after[chosen] - parts.first[chosen])] = True
    wanted = np.asarray(in_lap.any(axis=0))
    pieces = _repeated(cut(route, seen, limits, wanted), laps, lap_length, n_curve)
    start_speed, end_speed = _border_speeds(pieces)
    bounds = pieces.bounds
    shape = (bounds.acceleration, bounds.rise, bounds.taper)
    peak = peak_speed(pieces.length, start_speed, end_speed, bounds.speed, *shape)
    spans = np.stack(move_spans(pieces.length, start_speed, peak, end_speed, *shape), axis=-1)
    spans[:, :, 1] += pieces.start[:, None]
    stretch = np.searchsorted(parts.after, pieces.curve, side="right")
    return _Moves(spans.reshape(-1, 5), np.repeat(stretch, N_SPAN))


def _fastest(parts: Stretches, moves: list[_Moves]) -> _Moves:
    """Return of all motions of each stretch the one that takes the least time, in the order of travel."""
    n = parts.first.size
    time = np.full((len(moves), n), np.inf)
    for row, found in zip(time, moves, strict=True):
        lasting = np.bincount(found.stretch, found.spans[:, 0], n)
        has = np.unique(found.stretch)
        row[has] = lasting[has]
    best = np.argmin(time, axis=0)
    kept = [best[found.stretch] == k for k, found in enumerate(moves)]
    stretch = np.concatenate([found.stretch[keep] for found, keep in zip(moves, kept, strict=True)])
    spans = np.concatenate([found.spans[keep] for found, keep in zip(moves, kept, strict=True)])
    order = np.argsort(stretch, kind="stable")
    return _Moves(spans[order], stretch[order])


def _with_rests(found: _Moves, route: Route, parts: Stretches) -> Array:
    """Put the rests after the stretches in between their spans."""
    curve = (parts.after - 1) % route.n_curve
    rest = route.dwell[curve]
    lasting = np.flatnonzero(rest > 0.0)
    if lasting.size == 0:
        return found.spans
    rows = np.zeros((lasting.size, 5))
    rows[:, 0] = rest[lasting]
    rows[:, 1] = np.asarray(route.path.breaks)[curve[lasting] + 1] + (parts.after[lasting] - 1) // route.n_curve * route.path.length
    after = np.searchsorted(found.stretch, lasting, side="right")
    return np.insert(found.spans, after, rows, axis=0)


def _motions(route: Route, seen: Survey, limits: AxisLimits, laps: int) -> Array:
    """Return the spans of the whole route as rows (duration, s0, v0, a0, j)."""
    parts = stretches(seen, laps)
    bent = np.flatnonzero(~parts.straight)
    moves = []
    if bent.size:
        samples = sampled(route, seen, limits, parts, bent)
        for found in shaped(route.path, samples, limits):
            of_stretch = np.repeat(np.arange(bent.size), np.diff(found.begin))
            keep = found.good[of_stretch]
            moves.append(_Moves(found.spans[keep], bent[of_stretch[keep]]))
        del samples
    # The closed form is exact on straight stretches; elsewhere it may win where there is little to look ahead to.
    missing = np.ones(parts.first.size, dtype=bool)
    for way in moves:
        missing[way.stretch] = False
    short = parts.after - parts.first <= N_SHORT
    closed = np.flatnonzero(parts.straight | missing | short)
    if closed.size:
        moves.append(_closed_form(route, seen, limits, parts, closed))
    return _with_rests(_fastest(parts, moves), route, parts)


def _profile(rows: Array, rest_before: float, length: float) -> Profile:
    """Return the profile of spans (duration, s0, v0, a0, j), without those that last no time."""
    rows = np.concatenate([[[rest_before, 0.0, 0.0, 0.0, 0.0]], rows])
    lasting, s0, v0, a0, j = np.ascontiguousarray(rows[rows[:, 0] > 0.0].T)
    ends = np.cumsum(lasting)
    return Profile(np.append(0.0, ends[:-1]), s0, v0, a0, j, duration=float(ends[-1]), length=length)


def _repeated(pieces: Pieces, laps: int, lap_length: float, n_curve: int) -> Pieces:
    """Return the pieces of several laps; their curves are counted on."""
    if laps == 1:
        return pieces
    start = np.concatenate([pieces.start + lap * lap_length for lap in range(laps)])
    return Pieces(
        start,
        np.tile(pieces.length, laps),
        Bounds(*(np.tile(part, laps) for part in pieces.bounds)),
        np.tile(pieces.stop, laps),
        np.tile(pieces.junction_speed, laps),
        np.concatenate([pieces.curve + lap * n_curve for lap in range(laps)]),
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
    lap_length = float(route.path.length)
    limits = limits.for_axes(route.path.n_axis)
    free = np.flatnonzero(limits.unbounded)
    if free.size:
        raise FeedError(
            f"axis {free[0]} has neither an acceleration nor a jerk limit, so no ramp can be planned: "
            "give one of them a finite value, or use uniform(), which has no ramps"
        )
    seen = survey(route, limits, curvature_step)
    return _profile(_motions(route, seen, limits, laps), route.dwell_before, laps * lap_length)


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
        correspondence=route.correspondence,
        profile=profile,
        source_lines=route.source_line,
        laps=ranges,
    )
