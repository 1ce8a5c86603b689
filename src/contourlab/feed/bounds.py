"""From limits of the axes to limits along the path.

Along r(s) an axis moves with

    velocity      t v
    acceleration  t a + k v^2                  t = dr/ds, k = d2r/ds2, c = d3r/ds3 (of that axis)
    jerk          t j + 3 k v a + c v^3

A *piece* of the path gets four numbers: a ceiling V of the speed, an acceleration A, and two jerks, `rise` (at the low
end of a speed change) and `taper` (at its high end). Every ramp of `scurve` within them keeps |a| below
min(A, sqrt(2 taper (V - v))) at the speed v, so the demands of turning and of speeding up are split by speed: the
acceleration fades as the turning takes over. The limits hold at every sample of the piece when

    |t| min(A, sqrt(2 taper (V - v))) + |k| v^2 <= limit of acceleration    for all v in [0, V]
    |t| rise + 3 |k| V A + |c| V^3              <= limit of jerk

and the functions below take the largest values that do. How much of each limit V may use up is a matter of choice
(`Share`); `piece_bounds` tries a few and keeps, for each piece, the fastest.
"""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from contourlab.feed.limits import AxisLimits
from contourlab.feed.scurve import peak_speed, ramps

Array = NDArray[np.float64]


class Samples(NamedTuple):
    """Samples of a piece: derivatives (n, n_axis), and the programmed ceiling of speed (n,)."""

    tangent: Array
    second: Array
    third: Array
    feedrate: Array


class Share(NamedTuple):
    """How the limits are split: parts of a whole, each in (0, 1)."""

    turning: float  # of the acceleration limit, for k v^2 at full speed
    speeding: float  # of the acceleration limit, for the tangential acceleration at low speed
    turning_jerk: float  # of the jerk limit, for c v^3
    mixed_jerk: float  # of the jerk limit, for 3 k v a


class Bounds(NamedTuple):
    """Limits of each piece: speed, acceleration, jerk at low and at high speed; arrays (n_piece,)."""

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
    """Divide limits by |demand|, with inf where the demand is zero."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        return np.where(demand == 0.0, np.inf, limit / np.abs(demand))


def speed_limit(samples: Samples, limits: AxisLimits, share: Share) -> Array:
    """Return the highest speed at each sample, without regard to speeding up or braking.

    Parameters
    ----------
    samples : Samples
        n points of the path.
    limits : AxisLimits
    share : Share

    Returns
    -------
    ndarray (n,) [m/s]
    """
    velocity = _ratio(limits.velocity, samples.tangent)
    turning = np.sqrt(_ratio(share.turning * limits.acceleration, samples.second))
    turning_jerk = np.cbrt(_ratio(share.turning_jerk * limits.jerk, samples.third))
    lowest = np.minimum(np.minimum(velocity, turning), turning_jerk).min(axis=1)
    return np.asarray(np.minimum(samples.feedrate, lowest))


def _acceleration(samples: Samples, speed: Array, limits: AxisLimits, share: Share) -> tuple[Array, Array]:
    """Return at each sample the acceleration for low speeds, and the one that holds up to full speed."""
    whole = share.speeding * _ratio(limits.acceleration, samples.tangent)
    left = limits.acceleration - np.abs(samples.second) * speed[:, None] ** 2  # inf stays inf
    at_speed = _ratio(np.maximum(left, 0.0), samples.tangent)
    mixed = _ratio(share.mixed_jerk * limits.jerk, 3.0 * samples.second * speed[:, None])
    return np.minimum(whole, mixed).min(axis=1), np.minimum(at_speed, mixed).min(axis=1)


def _taper(samples: Samples, speed: Array, acceleration: Array, limits: AxisLimits) -> Array:
    """Return at each sample the largest taper that keeps |t| a + |k| v^2 within the limit on the way up to `speed`.

    With g(v) = (limit - |k| v^2)/|t| the taper is the minimum of g^2 / (2 (V - v)) over those v where g < A.
    Its derivative vanishes at 3 k v^2 - 4 k V v + limit = 0, whose larger root is the minimum.
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
    return np.asarray(np.where(free, np.inf, taper).min(axis=1))


def _bounds(samples: Samples, starts: NDArray[np.intp], limits: AxisLimits, share: Share) -> Bounds:
    """Return the bounds of pieces whose samples begin at `starts`."""
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
        left = np.where(np.isinf(limits.jerk), np.inf, limits.jerk - mixed - turning)
    rise, _ = lowest(_ratio(left, samples.tangent).min(axis=1))
    taper, _ = lowest(_taper(samples, speed_there, there, limits))
    return Bounds(speed, acceleration, rise, np.minimum(rise, taper))


def _time(bounds: Bounds, length: Array, stops: NDArray[np.bool_]) -> Array:
    """Estimate the time each piece takes: from rest where it begins or ends at a stop, else from 80 % speed."""
    start, end = (np.where(stop, 0.0, 0.8 * bounds.speed) for stop in stops.T)
    peak = peak_speed(length, start, end, *bounds)
    time = np.zeros_like(length)
    covered = np.zeros_like(length)
    for low in (start, end):
        part = ramps(low, peak, bounds.acceleration, bounds.rise, bounds.taper)
        time += part.rise_time + part.hold_time + part.taper_time
        covered += part.distance
    return time + np.maximum(length - covered, 0.0) / peak


def piece_bounds(samples: Samples, starts: NDArray[np.intp], length: Array, stops: NDArray[np.bool_], limits: AxisLimits) -> Bounds:
    """Return the limits along the path of each piece.

    Parameters
    ----------
    samples : Samples
        The samples of all pieces, one piece after another, both ends of each included.
    starts : ndarray (n_piece,) of int
        Where each piece's samples begin.
    length : ndarray (n_piece,) [m]
    stops : ndarray (n_piece, 2) of bool
        Whether the piece begins, and ends, at rest; guides the split between turning and speeding up.
    limits : AxisLimits

    Returns
    -------
    Bounds
    """
    straight = ~np.any(samples.second != 0.0, axis=1) & ~np.any(samples.third != 0.0, axis=1)
    shares = (Share(1.0, 1.0, 1.0, 1.0),) if bool(np.all(straight)) else SHARES
    # Each piece is by itself: some thousands of samples at a time keep the working memory small.
    groups = np.unique(np.searchsorted(starts, np.arange(0, samples.feedrate.size, CHUNK)))
    ends = np.append(starts[1:], samples.feedrate.size)
    found = []
    for first, after in pairwise(np.append(groups[groups < starts.size], starts.size).tolist()):
        rows, some = slice(int(starts[first]), int(ends[after - 1])), slice(first, after)
        part = Samples(*(column[rows] for column in samples))
        found.append(_best(part, starts[some] - starts[first], length[some], stops[some], limits, shares))
    return Bounds(*(np.concatenate(column) for column in zip(*found, strict=True)))


def _best(
    samples: Samples, starts: NDArray[np.intp], length: Array, stops: NDArray[np.bool_], limits: AxisLimits, shares: tuple[Share, ...]
) -> Bounds:
    """Return the bounds of those shares with which each piece takes the least time."""
    best = _bounds(samples, starts, limits, shares[0])
    if len(shares) == 1:
        return best
    best_time = _time(best, length, stops)
    for share in shares[1:]:
        trial = _bounds(samples, starts, limits, share)
        time = _time(trial, length, stops)
        better = time < best_time
        best = Bounds(*(np.where(better, new, old) for new, old in zip(trial, best, strict=True)))
        best_time = np.where(better, time, best_time)
    return best
