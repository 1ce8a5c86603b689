"""Speed changes with limited acceleration and jerk along one coordinate, in closed form.

A *ramp* raises the speed from v0 to v1 and has no acceleration at either end: the acceleration rises with the jerk
`rise`, stays at its peak, and falls back with the jerk `taper`. Braking is the same ramp run backwards in time, so
that `rise` always acts at the low speed and `taper` at the high one. With Delta = v1 - v0 and the peak

    a = min(A, sqrt(2 Delta / (1/rise + 1/taper)))

the three phases last a/rise, Delta/a - (a/rise + a/taper)/2 and a/taper.

A *move* over a given length is a ramp up, a cruise and a ramp down: at most seven spans.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

N_BISECTION = 80  # halvings: enough to reach the last bit of any speed within 1e-8 of the bracket
N_SPAN = 7  # of a move


class Ramps(NamedTuple):
    """Ramps, each array (n,): peak acceleration [m/s^2], the three durations [s], the distance [m]."""

    peak: Array
    rise_time: Array
    hold_time: Array
    taper_time: Array
    distance: Array


def ramps(low: Array, high: Array, acceleration: Array, rise: Array, taper: Array) -> Ramps:
    """Return the ramps from the speeds `low` to the speeds `high`.

    Parameters
    ----------
    low, high : ndarray (n,) [m/s], 0 <= low <= high
    acceleration : ndarray (n,) [m/s^2], > 0, inf allowed where the jerks are finite
    rise, taper : ndarray (n,) [m/s^3], > 0, inf allowed

    Returns
    -------
    Ramps
    """
    gain = np.maximum(high - low, 0.0)
    softness = 1.0 / rise + 1.0 / taper
    with np.errstate(divide="ignore", invalid="ignore"):
        peak = np.where(gain > 0.0, np.minimum(acceleration, np.sqrt(2.0 * gain / softness)), 0.0)
        total = np.where(gain > 0.0, gain / peak, 0.0)
    rise_time, taper_time = peak / rise, peak / taper
    hold_time = np.maximum(total - 0.5 * (rise_time + taper_time), 0.0)
    after_rise = low + 0.5 * peak * rise_time
    distance = (
        rise_time * (low + peak * rise_time / 6.0)
        + hold_time * (after_rise + 0.5 * peak * hold_time)
        + taper_time * (after_rise + peak * (hold_time + taper_time / 3.0))
    )
    return Ramps(peak, rise_time, hold_time, taper_time, distance)


def ramp_distance(low: float, high: float, acceleration: float, rise: float, taper: float) -> float:
    """Return the distance of one ramp [m]; the same as `ramps` for plain numbers, where a loop needs it."""
    gain = high - low
    if gain <= 1e-200:  # below it the square root of a gain is lost to underflow
        return 0.0
    softness = 1.0 / rise + 1.0 / taper
    peak = acceleration if 2.0 * gain >= acceleration * acceleration * softness else math.sqrt(2.0 * gain / softness)
    up, down = peak / rise, peak / taper
    hold = max(gain / peak - 0.5 * (up + down), 0.0)
    after = low + 0.5 * peak * up
    return up * (low + peak * up / 6.0) + hold * (after + 0.5 * peak * hold) + down * (after + peak * (hold + down / 3.0))


def reachable_speed(low: float, ceiling: float, room: float, acceleration: float, rise: float, taper: float) -> float:
    """Return the highest speed up to `ceiling` that one ramp from `low` reaches within `room`.

    Parameters
    ----------
    low, ceiling : float [m/s], 0 <= low
    room : float [m], > 0
    acceleration, rise, taper : float [m/s^2, m/s^3, m/s^3]

    Returns
    -------
    float
        A speed whose ramp fits into `room` (the answer is never above the true one), at least `low`.
    """
    if ceiling <= low or ramp_distance(low, ceiling, acceleration, rise, taper) <= room:
        return max(ceiling, low)
    below, above = low, ceiling
    for _ in range(N_BISECTION):
        middle = 0.5 * (below + above)
        if above - below <= 4e-16 * above:
            break
        if ramp_distance(low, middle, acceleration, rise, taper) <= room:
            below = middle
        else:
            above = middle
    return below


def peak_speed(length: Array, start: Array, end: Array, ceiling: Array, acceleration: Array, rise: Array, taper: Array) -> Array:
    """Return the cruise speed of each move: the highest whose two ramps fit into its length.

    Parameters
    ----------
    length : ndarray (n,) [m], > 0
    start, end, ceiling : ndarray (n,) [m/s]
        Speeds at both ends (reachable from each other) and the highest speed allowed.
    acceleration, rise, taper : ndarray (n,) [m/s^2, m/s^3, m/s^3]

    Returns
    -------
    ndarray (n,) [m/s]
    """

    def fits(speed: Array) -> NDArray[np.bool_]:
        up = ramps(start, speed, acceleration, rise, taper).distance
        down = ramps(end, speed, acceleration, rise, taper).distance
        return up + down <= length

    below = np.maximum(start, end)
    above = np.maximum(ceiling, below)
    below = np.where(fits(above), above, below)
    for _ in range(N_BISECTION):
        if np.all(above - below <= 4e-16 * above):
            break
        middle = 0.5 * (below + above)
        good = fits(middle)
        below, above = np.where(good, middle, below), np.where(good, above, middle)
    return below


def move_spans(
    length: Array, start: Array, peak: Array, end: Array, acceleration: Array, rise: Array, taper: Array
) -> tuple[Array, Array, Array, Array, Array]:
    """Return the seven spans of each move; spans that are not needed last zero seconds.

    Parameters
    ----------
    length : ndarray (n,) [m]
    start, peak, end : ndarray (n,) [m/s]
    acceleration, rise, taper : ndarray (n,)

    Returns
    -------
    duration, s0, v0, a0, j : ndarray (n, 7)
        With s0 counted from the start of the move.
    """
    up = ramps(start, peak, acceleration, rise, taper)
    down = ramps(end, peak, acceleration, rise, taper)
    cruise = np.maximum(length - up.distance - down.distance, 0.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        cruise_time = np.where(cruise > 0.0, cruise / peak, 0.0)
    none = np.zeros_like(peak)
    duration = np.stack([up.rise_time, up.hold_time, up.taper_time, cruise_time, down.taper_time, down.hold_time, down.rise_time], -1)
    a0 = np.stack([none, up.peak, up.peak, none, none, -down.peak, -down.peak], -1)
    # An infinite jerk acts for no time at all; zero replaces it, so that no product of the two is formed.
    rise, taper = np.where(np.isinf(rise), 0.0, rise), np.where(np.isinf(taper), 0.0, taper)
    j = np.stack([rise, none, -taper, none, -taper, none, rise], -1)
    low = start + 0.5 * up.peak * up.rise_time
    exit_ = end + 0.5 * down.peak * down.rise_time
    v0 = np.stack([start, low, low + up.peak * up.hold_time, peak, peak, exit_ + down.peak * down.hold_time, exit_], -1)
    step = duration * (v0 + duration * (a0 / 2.0 + duration * j / 6.0))
    s0 = np.zeros_like(step)
    np.cumsum(step[:, :3], axis=1, out=s0[:, 1:4])
    # The second half starts from the far end, which is known exactly.
    s0[:, 4] = length - down.distance
    s0[:, 5] = s0[:, 4] + step[:, 4]
    s0[:, 6] = length - step[:, 6]
    return duration, s0, v0, a0, j
