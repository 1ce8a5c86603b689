"""Velocity, acceleration and jerk limits of the axes; as limits along the path, and speed changes within them, in closed form.

A *ramp* raises the speed from v0 to v1 without acceleration at either end: the acceleration rises with the jerk `rise`, stays at its peak,
and falls with the jerk `taper`. Braking is the same ramp backwards in time: `rise` acts at the low speed, `taper` at the high one. With
Delta = v1 - v0 and the peak

    a = min(A, sqrt(2 Delta / (1/rise + 1/taper)))

the three phases last a/rise, Delta/a - (a/rise + a/taper)/2 and a/taper.

A *move* over a given length is a ramp up, a cruise at constant speed and a ramp down: at most seven spans.

Along r(s) an axis moves with

    velocity      t v
    acceleration  t a + k v^2                  t = dr/ds, k = d2r/ds2, c = d3r/ds3 (of that axis)
    jerk          t j + 3 k v a + c v^3

A *piece* of the path gets four numbers: a speed ceiling V, an acceleration A, and two jerks, `rise` (at the low end of a speed change) and
`taper` (at its high end). Every ramp within them keeps |a| below min(A, sqrt(2 taper (V - v))) at the speed v: the tangential
acceleration falls as turning takes more of the limit. The limits hold at every sample of the piece if

    |t| min(A, sqrt(2 taper (V - v))) + |k| v^2 <= limit of acceleration    for all v in [0, V]
    |t| rise + 3 |k| V A + |c| V^3              <= limit of jerk

How much of each limit V may use is a free choice (`Share`); `piece_bounds` tries several and keeps the fastest for each piece.
"""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Flags, Index
from contourlab.errors import FeedError, ParameterError, refuse
from contourlab.native.kernel import kernel

RANGES = {"velocity": (1e-6, 1e6), "acceleration": (1e-6, 1e9), "jerk": (1e-6, 1e12)}
"""Smallest and largest limit [m/s, m/s^2, m/s^3]: machines are far inside, and beyond it planning overflows or never ends."""


def _checked(name: str, value: ArrayLike, unit: str, *, finite: bool) -> Array:
    """Return `value` as a read-only vector of valid limits."""
    array = np.array(value, dtype=np.float64, ndmin=1)
    refuse(array.ndim != 1, ParameterError, name, array.tolist(), "one number per axis", unit)
    low, high = RANGES[name]
    if not bool(np.all((array >= low) & (array <= high) | (np.isposinf(array) & (not finite)))):
        raise ParameterError(name, array.tolist(), f"{low:g} to {high:g}" + ("" if finite else ", or inf for no limit"), unit)
    array.flags.writeable = False
    return array


@dataclass(frozen=True)
class Grbl:
    """Planner of grbl and its descendants, see `contourlab.feed.trapezoids`; the defaults are grbl's.

    Parameters
    ----------
    junction_deviation : float [m], >= 0
        ``$11``: sets the speed at corners; 0 stops there.
    arc_tolerance : float [m], > 0
        ``$12``: distance of the chords of an arc from it.
    planner_blocks : int, > 2
        Size of the buffer, which holds one line less.
    steps : tuple of float [m], >= 0
        Travel per step of each axis: ends of lines are rounded to steps; 0 or nothing for none.
    """

    junction_deviation: float = 1e-5
    arc_tolerance: float = 2e-6
    planner_blocks: int = 16
    steps: tuple[float, ...] = ()


@dataclass(frozen=True)
class LinuxCNC:
    """Planner of LinuxCNC, see `contourlab.feed.linuxcnc`; the defaults are LinuxCNC's.

    Parameters
    ----------
    cycle : float [s], > 0
    kink_ratio : float [1], 0.001 to 0.7071
        ``ARC_BLEND_KINK_RATIO``.
    planner_blocks : int, > 2
        ``ARC_BLEND_OPTIMIZATION_DEPTH`` and two.
    gap_cycles : float [1], >= 0
        ``ARC_BLEND_GAP_CYCLES``.
    largest_override : float [1], > 0
        ``MAX_FEED_OVERRIDE``: corners are planned for this.
    """

    cycle: float = 1e-3
    kink_ratio: float = 0.1
    planner_blocks: int = 52
    gap_cycles: float = 4.0
    largest_override: float = 1.0


@dataclass(frozen=True, eq=False)
class AxisLimits:
    """Limits of each axis, and of the velocity along the path; a single number applies to all axes.

    Parameters
    ----------
    velocity : array_like (n_axis,) [m/s], 1e-6 to 1e6
        Also the rate of rapid moves.
    acceleration : array_like (n_axis,) [m/s^2], 1e-6 to 1e9, inf for no limit
    jerk : array_like (n_axis,) [m/s^3], 1e-6 to 1e12, inf for no limit
    path_velocity : float [m/s], > 0
        Along the path, in rapid moves too; inf for no limit.
    planner : Grbl, LinuxCNC or None
        Plan as this control does, without limits of jerk; None for the jerk-limited planner.

    Raises
    ------
    ParameterError
        If a limit is out of its range or not a number, or if the lengths differ.

    >>> AxisLimits([0.5, 0.5], 2.0, 40.0).jerk
    array([40., 40.])
    """

    velocity: Array
    acceleration: Array
    jerk: Array
    path_velocity: float
    planner: Grbl | LinuxCNC | None

    def __init__(
        self,
        velocity: ArrayLike,
        acceleration: ArrayLike,
        jerk: ArrayLike = np.inf,
        *,
        path_velocity: float = math.inf,
        planner: Grbl | LinuxCNC | None = None,
    ) -> None:
        object.__setattr__(self, "path_velocity", path_velocity)
        object.__setattr__(self, "planner", planner)
        parts = {
            "velocity": _checked("velocity", velocity, "m/s", finite=True),
            "acceleration": _checked("acceleration", acceleration, "m/s^2", finite=False),
            "jerk": _checked("jerk", jerk, "m/s^3", finite=False),
        }
        size = max(part.size for part in parts.values())
        for name, part in parts.items():
            refuse(part.size not in (1, size), ParameterError, name, part.tolist(), f"of length 1 or {size}, like the other limits")
            object.__setattr__(self, name, np.broadcast_to(part, (size,)))

    @property
    def n_axis(self) -> int:
        """Number of axes."""
        return int(self.velocity.size)

    @property
    def unbounded(self) -> Flags:
        """Which axes have no limit with which a ramp can be planned (n_axis,): of acceleration or, where jerk is planned, of jerk."""
        return np.isinf(self.acceleration) & (np.isinf(self.jerk) | (self.planner is not None))

    def for_axes(self, n_axis: int) -> AxisLimits:
        """Return the limits for `n_axis` axes; limits of a single axis apply to all.

        Raises
        ------
        FeedError
            If the limits have a different number of axes.
        """
        if self.n_axis == n_axis:
            return self
        refuse(self.n_axis != 1, FeedError, f"limits for {self.n_axis} axes, the path has {n_axis}: give one limit per axis")
        parts = (np.repeat(part, n_axis) for part in (self.velocity, self.acceleration, self.jerk))
        return AxisLimits(*parts, path_velocity=self.path_velocity, planner=self.planner)


N_BISECTION = 80  # enough for the last bit of any speed above 1e-8 of the bracket
N_SPAN = 7  # of a move


class Ramps(NamedTuple):
    """Peak acceleration [m/s^2], durations of the three phases [s] and distance [m] of ramps (n,)."""

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
    acceleration : ndarray (n,) [m/s^2], > 0; may be inf where the jerks are finite
    rise, taper : ndarray (n,) [m/s^3], > 0; may be inf
    """
    gain, softness = np.maximum(high - low, 0.0), 1.0 / rise + 1.0 / taper
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


def _peak(gain: float, acceleration: float, softness: float) -> float:
    return acceleration if 2.0 * gain >= acceleration * acceleration * softness else math.sqrt(2.0 * gain / softness)


def ramp_distance(low: float, high: float, acceleration: float, rise: float, taper: float) -> float:
    """Return the distance of one ramp [m], as `ramps`."""
    gain = high - low
    if gain <= 1e-200:  # avoid underflow
        return 0.0
    peak = _peak(gain, acceleration, 1.0 / rise + 1.0 / taper)
    up, down = peak / rise, peak / taper
    hold = max(gain / peak - 0.5 * (up + down), 0.0)
    after = low + 0.5 * peak * up
    return up * (low + peak * up / 6.0) + hold * (after + 0.5 * peak * hold) + down * (after + peak * (hold + down / 3.0))


def ramp_time(low: float, high: float, acceleration: float, rise: float, taper: float) -> float:
    """Return the duration of one ramp [s], as `ramps`."""
    gain, softness = high - low, 1.0 / rise + 1.0 / taper
    if gain <= 1e-200:
        return 0.0
    peak = _peak(gain, acceleration, softness)
    return 0.5 * peak * softness + max(gain / peak, 0.5 * peak * softness)


def reachable_speed(low: float, ceiling: float, room: float, acceleration: float, rise: float, taper: float) -> float:
    """Return the highest speed up to `ceiling` [m/s] that one ramp from `low` reaches within `room` [m]; rounded down, at least `low`."""
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


def border_speeds(length: Array, ceiling: Array, acceleration: Array, rise: Array, taper: Array) -> Array:
    """Return the highest speeds (n + 1,) [m/s] at the borders of n pieces that every piece permits, by a forward and a backward pass.

    Parameters
    ----------
    length : ndarray (n,) [m]
    ceiling : ndarray (n + 1,) [m/s]
        Largest speed at each border; 0 at both ends.
    acceleration, rise, taper : ndarray (n,)
        Of the pieces, as for `ramps`.
    """
    speed = ceiling.copy()
    _border_speeds(*map(np.ascontiguousarray, (length, acceleration, rise, taper)), speed)
    return speed


def peak_speed(length: Array, start: Array, end: Array, ceiling: Array, acceleration: Array, rise: Array, taper: Array) -> Array:
    """Return the highest cruise speed (n,) [m/s] of moves over `length`; the speeds `start` and `end` must be reachable from each other."""
    parts = np.broadcast_arrays(length, start, end, ceiling, acceleration, rise, taper)
    flat = [np.ascontiguousarray(part, dtype=float).ravel() for part in parts]
    found = np.empty(flat[0].size)
    _peak_speeds(*flat, found)
    return found.reshape(parts[0].shape)


@kernel("f8[:] f8[:] f8[:] f8[:] f8[:]")
def _border_speeds(length, acceleration, rise, taper, speed):
    for i in range(length.size):
        if speed[i + 1] > speed[i]:
            speed[i + 1] = reachable_speed(speed[i], speed[i + 1], length[i], acceleration[i], rise[i], taper[i])
    for i in range(length.size - 1, -1, -1):
        if speed[i] > speed[i + 1]:
            speed[i] = reachable_speed(speed[i + 1], speed[i], length[i], acceleration[i], rise[i], taper[i])


@kernel("f8[:] f8[:] f8[:] f8[:] f8[:] f8[:] f8[:] f8[:]")
def _peak_speeds(length, start, end, ceiling, acceleration, rise, taper, found):
    for i in range(length.size):
        found[i] = cruise_speed(length[i], start[i], end[i], ceiling[i], acceleration[i], rise[i], taper[i])


def cruise_speed(length: float, start: float, end: float, ceiling: float, acceleration: float, rise: float, taper: float) -> float:
    """Return the highest cruise speed of one move [m/s], as `peak_speed`."""
    shape = acceleration, rise, taper
    below = max(start, end)
    above = max(ceiling, below)
    left = _room_left(length, start, end, above, shape)
    if left >= 0.0:
        return above
    lacking, room, side = left, _room_left(length, start, end, below, shape), 0
    for _ in range(N_BISECTION):
        if above - below <= 4e-16 * above:
            break
        # False position; an end that stays twice is halved in weight (the Illinois rule).
        middle = below + (above - below) * room / (room - lacking)
        if not below < middle < above:
            middle = 0.5 * (below + above)
        left = _room_left(length, start, end, middle, shape)
        if left >= 0.0:
            below, room, lacking, side = middle, left, 0.5 * lacking if side == 1 else lacking, 1
        else:
            above, lacking, room, side = middle, left, 0.5 * room if side == -1 else room, -1
    return below


def _room_left(length: float, start: float, end: float, speed: float, shape: tuple[float, float, float]) -> float:
    """Return what a move over a length leaves of it after the ramps up to a speed and down again."""
    return length - (ramp_distance(start, speed, shape[0], shape[1], shape[2]) + ramp_distance(end, speed, shape[0], shape[1], shape[2]))


def move_spans(
    length: Array, start: Array, peak: Array, end: Array, acceleration: Array, rise: Array, taper: Array
) -> tuple[Array, Array, Array, Array, Array]:
    """Return the seven spans of each move (n,) with cruise speed `peak`; unused spans last 0 s.

    Returns
    -------
    duration, s0, v0, a0, j : ndarray (n, 7)
        s0 is counted from the start of the move.
    """
    up = ramps(start, peak, acceleration, rise, taper)
    down = ramps(end, peak, acceleration, rise, taper)
    cruise = np.maximum(length - up.distance - down.distance, 0.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        cruise_time = np.where(cruise > 0.0, cruise / peak, 0.0)
    zero = np.zeros_like(peak)
    duration = np.stack([up.rise_time, up.hold_time, up.taper_time, cruise_time, down.taper_time, down.hold_time, down.rise_time], -1)
    a0 = np.stack([zero, up.peak, up.peak, zero, zero, -down.peak, -down.peak], -1)
    # An infinite jerk acts for no time; write it as 0 to avoid inf * 0.
    rise, taper = np.where(np.isinf(rise), 0.0, rise), np.where(np.isinf(taper), 0.0, taper)
    j = np.stack([rise, zero, -taper, zero, -taper, zero, rise], -1)
    low, exit_ = start + 0.5 * up.peak * up.rise_time, end + 0.5 * down.peak * down.rise_time
    v0 = np.stack([start, low, low + up.peak * up.hold_time, peak, peak, exit_ + down.peak * down.hold_time, exit_], -1)
    step = duration * (v0 + duration * (a0 / 2.0 + duration * j / 6.0))
    s0 = np.zeros_like(step)
    np.cumsum(step[:, :3], axis=1, out=s0[:, 1:4])
    # Count the second half from the far end, which is known exactly.
    s0[:, 4] = length - down.distance
    s0[:, 5] = s0[:, 4] + step[:, 4]
    s0[:, 6] = length - step[:, 6]
    return duration, s0, v0, a0, j


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
