"""Convert axis limits to limits along the path.

Along r(s) an axis moves with

    velocity      t v
    acceleration  t a + k v^2                  t = dr/ds, k = d2r/ds2, c = d3r/ds3 (of that axis)
    jerk          t j + 3 k v a + c v^3

A *piece* of the path gets four numbers: a speed ceiling V, an acceleration A, and two jerks, `rise` (at the low end of a speed change) and
`taper` (at its high end). Every ramp of `scurve` within them keeps |a| below min(A, sqrt(2 taper (V - v))) at the speed v: the tangential
acceleration falls as turning takes more of the limit. The limits hold at every sample of the piece if

    |t| min(A, sqrt(2 taper (V - v))) + |k| v^2 <= limit of acceleration    for all v in [0, V]
    |t| rise + 3 |k| V A + |c| V^3              <= limit of jerk

The functions below find the largest such values. How much of each limit V may use is a free choice (`Share`); `piece_bounds` tries several
and keeps the fastest for each piece.
"""

from __future__ import annotations

from functools import reduce
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.feed.limits import AxisLimits
from contourlab.feed.scurve import peak_speed, ramps


class Samples(NamedTuple):
    """Samples of a piece: derivatives (n, n_axis) and feedrate (n,)."""

    tangent: Array
    second: Array
    third: Array
    feedrate: Array


class Share(NamedTuple):
    """Fractions of the limits, each in (0, 1]."""

    turning: float  # of the acceleration limit, for k v^2 at full speed
    speeding: float  # of the acceleration limit, for the tangential acceleration at low speed
    turning_jerk: float  # of the jerk limit, for c v^3
    mixed_jerk: float  # of the jerk limit, for 3 k v a


class Bounds(NamedTuple):
    """Limits of each piece (n_piece,): speed, acceleration, jerk at low and at high speed."""

    speed: Array
    acceleration: Array
    rise: Array
    taper: Array


CHUNK = 32_768  # samples per pass
SHARES = tuple(
    Share(turning, speeding, turning_jerk, mixed)
    for turning, speeding in ((0.97, 0.9), (0.9, 0.8), (0.8, 0.7), (0.6, 0.8))
    for turning_jerk, mixed in ((0.7, 0.1), (0.5, 0.25), (0.25, 0.4))
)


def _ratio(limit: Array, demand: Array) -> Array:
    """Divide limits by |demand|; inf where the demand is zero."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        return np.where(demand == 0.0, np.inf, limit / np.abs(demand))


def _least(values: Array) -> Array:
    """Return the least value of all axes (n,) of (n, n_axis); NumPy's own reduction of short rows is ten times slower."""
    return reduce(np.minimum, values.T)


def speed_limit(samples: Samples, limits: AxisLimits, share: Share) -> Array:
    """Return the highest constant speed at each sample (n,) [m/s]."""
    velocity = _ratio(limits.velocity, samples.tangent)
    turning = np.sqrt(_ratio(share.turning * limits.acceleration, samples.second))
    turning_jerk = np.cbrt(_ratio(share.turning_jerk * limits.jerk, samples.third))
    lowest = _least(np.minimum(np.minimum(velocity, turning), turning_jerk))
    return np.asarray(np.minimum(samples.feedrate, lowest))


def _acceleration(samples: Samples, speed: Array, limits: AxisLimits, share: Share) -> tuple[Array, Array]:
    """Return the permitted acceleration at low speeds, and at any speed, at each sample."""
    low = share.speeding * _ratio(limits.acceleration, samples.tangent)
    unused = limits.acceleration - np.abs(samples.second) * speed[:, None] ** 2  # inf stays inf
    high = _ratio(np.maximum(unused, 0.0), samples.tangent)
    mixed = _ratio(share.mixed_jerk * limits.jerk, 3.0 * samples.second * speed[:, None])
    return _least(np.minimum(low, mixed)), _least(np.minimum(high, mixed))


def _taper(samples: Samples, speed: Array, acceleration: Array, limits: AxisLimits) -> Array:
    """Return at each sample the largest taper that keeps |t| a + |k| v^2 within the limit on the way up to `speed`.

    With g(v) = (limit - |k| v^2)/|t| the taper is the minimum of g^2 / (2 (V - v)) where g < A.
    The minimum lies at the larger root of 3 k v^2 - 4 k V v + limit = 0.
    """
    t, k = np.abs(samples.tangent), np.abs(samples.second)
    V, A = speed[:, None], acceleration[:, None]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        first = np.sqrt(np.maximum((limits.acceleration - A * t) / k, 0.0))  # where g falls below A
        root = (2.0 * V + np.sqrt(np.maximum(4.0 * V**2 - 3.0 * limits.acceleration / k, 0.0))) / 3.0
        lowest = np.clip(root, first, V)
        lowest = np.where(lowest < V, lowest, first)
        at_first, at_lowest = (((limits.acceleration - k * v**2) / t) ** 2 / (2.0 * (V - v)) for v in (first, lowest))
        taper = np.fmin(at_first, at_lowest)
        free = (k == 0.0) | (t == 0.0) | (first >= V) | np.isinf(limits.acceleration)
    return _least(np.where(free, np.inf, taper))


def _bounds(samples: Samples, starts: Index, limits: AxisLimits, share: Share) -> Bounds:
    """Return the bounds of pieces whose samples start at `starts`."""
    counts = np.diff(np.append(starts, samples.feedrate.size))

    def lowest(values: Array) -> tuple[Array, Array]:
        of_piece = np.minimum.reduceat(values, starts)
        return of_piece, np.repeat(of_piece, counts)

    speed, speed_there = lowest(speed_limit(samples, limits, share))
    low, high = _acceleration(samples, speed_there, limits, share)
    acceleration = np.maximum(lowest(low)[0], lowest(high)[0])
    there = np.repeat(acceleration, counts)
    with np.errstate(invalid="ignore"):
        mixed = 3.0 * np.abs(samples.second) * (speed_there * there)[:, None]
        turning = np.abs(samples.third) * speed_there[:, None] ** 3
        unused = np.where(np.isinf(limits.jerk), np.inf, limits.jerk - mixed - turning)
    rise, _ = lowest(_least(_ratio(unused, samples.tangent)))
    taper, _ = lowest(_taper(samples, speed_there, there, limits))
    return Bounds(speed, acceleration, rise, np.minimum(rise, taper))


def _time(bounds: Bounds, length: Array, stops: Flags) -> Array:
    """Estimate the duration of each piece: from rest at a stop, else from 80 % of its speed."""
    start, end = (np.where(stop, 0.0, 0.8 * bounds.speed) for stop in stops.T)
    peak = peak_speed(length, start, end, *bounds)
    time = np.zeros_like(length)
    covered = np.zeros_like(length)
    for low in (start, end):
        part = ramps(low, peak, bounds.acceleration, bounds.rise, bounds.taper)
        time += part.rise_time + part.hold_time + part.taper_time
        covered += part.distance
    return time + np.maximum(length - covered, 0.0) / peak


def piece_bounds(samples: Samples, starts: Index, length: Array, stops: Flags, limits: AxisLimits) -> Bounds:
    """Return the limits of each piece along the path.

    Parameters
    ----------
    samples : Samples
        Of all pieces in order, both ends of each included.
    starts : ndarray (n_piece,) of int
        First sample of each piece.
    length : ndarray (n_piece,) [m]
    stops : ndarray (n_piece, 2) of bool
        Whether the piece starts, and ends, at rest.
    limits : AxisLimits
    """
    counts = np.diff(np.append(starts, samples.feedrate.size))
    turns = np.any((samples.second != 0.0) | (samples.third != 0.0), axis=1)
    bent = np.logical_or.reduceat(turns, starts)
    found = Bounds(*np.empty((4, starts.size)))
    # Chunks keep the working memory small. On a straight piece all shares give the same bounds.
    groups = np.unique(np.searchsorted(starts, np.arange(0, samples.feedrate.size, CHUNK)))
    ends = starts + counts
    for first, after in pairwise(np.append(groups[groups < starts.size], starts.size).tolist()):
        rows, some = slice(int(starts[first]), int(ends[after - 1])), slice(first, after)
        for chosen, shares in ((~bent[some], SHARES[:1]), (bent[some], SHARES)):
            if chosen.any():
                size, on = counts[some][chosen], np.repeat(chosen, counts[some])
                part = Samples(*(column[rows][on] for column in samples))
                best = _best(part, np.cumsum(size) - size, length[some][chosen], stops[some][chosen], limits, shares)
                for column, values in zip(found, best, strict=True):
                    column[some][chosen] = values
    return found


def _best(
    samples: Samples, starts: Index, length: Array, stops: Flags, limits: AxisLimits, shares: tuple[Share, ...]
) -> Bounds:
    """Return the bounds of the quickest share for each piece."""
    trials = [_bounds(samples, starts, limits, share) for share in shares]
    if len(trials) == 1:
        return trials[0]
    quickest = np.argmin([_time(trial, length, stops) for trial in trials], axis=0)
    return Bounds(*(np.choose(quickest, columns) for columns in zip(*trials, strict=True)))
