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

How much of each limit V may use is a free choice (`Share`); `piece_bounds` tries several and keeps the fastest for each piece.
"""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.feed.limits import AxisLimits
from contourlab.feed.scurve import cruise_speed, ramp_distance, ramp_time
from contourlab.native.kernel import kernel


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


SHARES = tuple(
    Share(turning, speeding, turning_jerk, mixed)
    for turning, speeding in ((0.97, 0.9), (0.9, 0.8), (0.8, 0.7), (0.6, 0.8))
    for turning_jerk, mixed in ((0.7, 0.1), (0.5, 0.25), (0.25, 0.4))
)
PACE = 0.8  # of the speed ceiling: assumed at the ends of a piece when shares are compared


def _arrays(samples: Samples, limits: AxisLimits) -> tuple[Array, ...]:
    """Return samples and limits as the kernels take them."""
    return tuple(np.ascontiguousarray(part) for part in (*samples, limits.velocity, limits.acceleration, limits.jerk))


def speed_limit(samples: Samples, limits: AxisLimits, share: Share) -> Array:
    """Return the highest constant speed at each sample (n,) [m/s]."""
    found = np.empty(samples.feedrate.size)
    _speed_limits(*_arrays(samples, limits), share.turning, share.turning_jerk, found)
    return found


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
    """
    found = np.empty((4, starts.size))
    borders = np.append(starts, samples.feedrate.size)
    _quickest(*_arrays(samples, limits), np.array(SHARES), borders, length, np.where(stops, 0.0, PACE), found)
    return Bounds(*found)


def _ratio(limit, demand):
    """Return a limit divided by a demand >= 0."""
    return math.inf if demand == 0.0 else limit / demand


@kernel("f8[:,:] f8[:,:] f8[:,:] f8[:] f8[:] f8[:] f8[:] f8 f8 f8[:]")
def _speed_limits(tangent, second, third, feedrate, velocity, acceleration, jerk, of_turning, of_turning_jerk, found):
    for i in range(feedrate.size):
        speed, turning, changing, _, _ = _least_ratios(i, i + 1, tangent, second, third, feedrate, velocity, acceleration, jerk)
        found[i] = min(speed, math.sqrt(of_turning * turning), np.cbrt(of_turning_jerk * changing))


def _taper(t, k, V, A, limit):
    """Return the largest taper that keeps t a + k v^2 within the limit on the way up to the speed V.

    With g(v) = (limit - k v^2)/t the taper is the minimum of g^2 / (2 (V - v)) where g < A.
    The minimum lies at the larger root of 3 k v^2 - 4 k V v + limit = 0.
    """
    if k == 0.0 or t == 0.0 or math.isinf(limit) or A * t + k * V * V <= limit:
        return math.inf
    first = math.sqrt(max((limit - A * t) / k, 0.0))  # where g falls below A
    if first >= V:
        return math.inf
    root = (2.0 * V + math.sqrt(max(4.0 * V * V - 3.0 * limit / k, 0.0))) / 3.0
    lowest = max(root, first) if root < V else first
    at_first, at_lowest = (limit - k * first * first) / t, (limit - k * lowest * lowest) / t
    return min(at_first * at_first / (2.0 * (V - first)), at_lowest * at_lowest / (2.0 * (V - lowest)))


def _least_ratios(first, after, tangent, second, third, feedrate, velocity, acceleration, jerk):
    """Return the least feedrate or V/|t|, and the least A/|k|, J/|c|, A/|t| and J/|k|, of all axes at the samples [first, after)."""
    speed, turning, changing, steady, mixed = math.inf, math.inf, math.inf, math.inf, math.inf
    for i in range(first, after):
        speed = min(speed, feedrate[i])
        for axis in range(velocity.size):
            t, k, c = abs(tangent[i, axis]), abs(second[i, axis]), abs(third[i, axis])
            speed, steady = min(speed, _ratio(velocity[axis], t)), min(steady, _ratio(acceleration[axis], t))
            turning, mixed = min(turning, _ratio(acceleration[axis], k)), min(mixed, _ratio(jerk[axis], k))
            changing = min(changing, _ratio(jerk[axis], c))
    return speed, turning, changing, steady, mixed


def _bounds(first, after, tangent, second, third, acceleration, jerk, V, low, mixed):
    """Return acceleration, rise and taper of the piece with the samples [first, after) at a speed ceiling V.

    `low` is the acceleration permitted at low speeds, `mixed` the largest for which 3 k v a has its share of the jerk.
    """
    A, rise, taper = math.inf, math.inf, math.inf
    for i in range(first, after):
        for axis in range(acceleration.size):
            unused = max(acceleration[axis] - abs(second[i, axis]) * V * V, 0.0)
            A = min(A, _ratio(unused, abs(tangent[i, axis])))
    A = min(max(low, A), mixed)
    for i in range(first, after):
        for axis in range(acceleration.size):
            t, k, unused = abs(tangent[i, axis]), abs(second[i, axis]), jerk[axis]
            if not math.isinf(unused):
                unused -= abs(third[i, axis]) * V * V * V + (3.0 * k * V * A if k > 0.0 else 0.0)
            rise = min(rise, _ratio(unused, t))
            taper = min(taper, _taper(t, k, V, A, acceleration[axis]))
    return A, rise, min(rise, taper)


def _time(length, start, end, ceiling, acceleration, rise, taper):
    """Return the duration of a move."""
    peak = cruise_speed(length, start, end, ceiling, acceleration, rise, taper)
    time, left = 0.0, length
    for low in (start, end):
        time += ramp_time(low, peak, acceleration, rise, taper)
        left -= ramp_distance(low, peak, acceleration, rise, taper)
    return time + max(left, 0.0) / peak


@kernel("f8[:,:] f8[:,:] f8[:,:] f8[:] f8[:] f8[:] f8[:] f8[:,:] i8[:] f8[:] f8[:,:] f8[:,:]")
def _quickest(tangent, second, third, feedrate, velocity, acceleration, jerk, shares, borders, length, pace, found):
    """Fill the bounds (4, n_piece) by the share with which each piece takes the least time; pace: speeds at the ends, of the ceiling."""
    for piece in range(length.size):
        first, after, least = borders[piece], borders[piece + 1], math.inf
        speed, turning, changing, steady, mixed = _least_ratios(
            first, after, tangent, second, third, feedrate, velocity, acceleration, jerk
        )
        straight = math.isinf(mixed) and math.isinf(turning) and math.isinf(changing)
        for number in range(1 if straight else shares.shape[0]):
            of_turning, of_speeding, of_turning_jerk, of_mixed_jerk = shares[number]
            V = min(speed, math.sqrt(of_turning * turning), np.cbrt(of_turning_jerk * changing))
            if length[piece] / V >= least:
                continue
            A, rise, taper = _bounds(
                first, after, tangent, second, third, acceleration, jerk, V, of_speeding * steady, of_mixed_jerk * mixed / (3.0 * V)
            )
            time = _time(length[piece], pace[piece, 0] * V, pace[piece, 1] * V, V, A, rise, taper)
            if time < least:
                least = time
                found[0, piece], found[1, piece], found[2, piece], found[3, piece] = V, A, rise, taper
