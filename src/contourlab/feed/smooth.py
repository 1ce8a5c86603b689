"""Feed along stretches with general curves (splines, ellipses), where limits change all the time.

Moves between borders without acceleration (`planner`) waste time there. Instead, for one stretch from stop to stop:

1. a forward and a backward pass over the samples give the speed of limited acceleration, v(s), with parts of the
   limits held back for jerk and for step 3;
2. the ceiling of the speed is first widened at its narrows, by what step 3 looks ahead and back;
3. the progress s(t) is sampled every h seconds and the steps are made the coefficients of a cubic B-spline. That is
   a moving average of the motion: it keeps the length, bounds the acceleration, and has constant jerk in each span;
4. the result is held against the true limits at many places. Where it breaks them, the limits used in step 1 are
   lowered around that place, and all is done again.

Only a motion that has passed step 4 is handed back.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from contourlab.feed.limits import AxisLimits
from contourlab.feed.profile import Motion, Profile
from contourlab.geometry import Path

__all__ = ["Stretch", "smooth_profile"]

Array = NDArray[np.float64]

TURNING = 0.9  # part of the acceleration limit that turning may use at the ceiling of speed
TURNING_JERK = 0.6  # part of the jerk limit for c v^3 at the ceiling of speed
MIXED_JERK = 0.6  # part of the jerk limit for 3 k v a
PERIODS = (0.35, 0.18, 0.7)  # periods h tried, in units of 2 A / J: at 1 a swing from -A to A keeps to the jerk
ROUNDING = 1e-6  # of a limit
CLOSE = 1e-3  # of a limit: what the path may show between the samples
ROUNDS = 16  # corrections at most
FINEST = 5e-3  # least unit of h, in sqrt(length / acceleration): finer gains no time where jerk is plentiful
SPREAD = 2.0  # half width of the moving average, in periods
PER_SPAN = 12  # places looked at in each span, besides the samples of the path


class Stretch(NamedTuple):
    """Samples of a path from one stop to the next, n in the order of travel.

    arc_length : ndarray (n,) [m]
    tangent, second, third : ndarray (n, n_axis)
    ceiling : ndarray (n,) [m/s]
        Programmed speed, and that at jumps of curvature.
    """

    arc_length: Array
    tangent: Array
    second: Array
    third: Array
    ceiling: Array


def _ceiling(stretch: Stretch, limits: AxisLimits, scale: Array) -> Array:
    """Return the highest speed at each sample with parts of the limits held back."""
    with np.errstate(divide="ignore", invalid="ignore"):
        velocity = limits.velocity / np.abs(stretch.tangent)
        turning = np.sqrt(TURNING * scale[:, None] * limits.acceleration / np.abs(stretch.second))
        jerk = np.cbrt(TURNING_JERK * scale[:, None] * limits.jerk / np.abs(stretch.third))
    lowest = np.fmin(np.fmin(velocity, turning), jerk).min(axis=1)
    return np.asarray(np.minimum(stretch.ceiling, lowest))


def _lowest_within(place: Array, value: Array, width: Array) -> Array:
    """Return the minimum of `value` over [place - width, place + width], for every place."""
    first = np.searchsorted(place, place - width)
    last = np.searchsorted(place, place + width, side="right")
    levels = [value]
    while 2 ** len(levels) <= value.size:
        half = 2 ** (len(levels) - 1)
        levels.append(np.minimum(levels[-1][:-half], levels[-1][half:]))
    level = np.floor(np.log2(np.maximum(last - first, 1))).astype(np.intp)
    result = np.empty_like(value)
    for k, table in enumerate(levels):
        of_level = np.flatnonzero(level == k)
        result[of_level] = np.minimum(table[first[of_level]], table[last[of_level] - 2**k])
    return result


def _square_speed(stretch: Stretch, limits: AxisLimits, scale: Array, ceiling: Array) -> Array:
    """Return v^2 at the samples: forward for speeding up, backward for braking."""
    t = np.maximum(np.abs(stretch.tangent), 1e-6)
    acceleration, jerk = scale[:, None] * limits.acceleration, scale[:, None] * limits.jerk
    with np.errstate(divide="ignore", invalid="ignore"):
        mixed = np.where(stretch.second == 0.0, np.inf, MIXED_JERK * jerk / (3.0 * np.abs(stretch.second)))
    # One set of numbers for each interval, the more careful of its two ends.
    base = np.minimum((acceleration / t)[1:], (acceleration / t)[:-1]).tolist()
    slope = np.maximum((np.abs(stretch.second) / t)[1:], (np.abs(stretch.second) / t)[:-1]).tolist()
    by_jerk = np.minimum(mixed[1:], mixed[:-1]).min(axis=1).tolist()
    step = (2.0 * np.diff(stretch.arc_length)).tolist()
    square = (ceiling**2).tolist()
    square[0] = square[-1] = 0.0

    def reached(b: float, i: int) -> float:
        gain = min([p - q * b for p, q in zip(base[i], slope[i], strict=True)])
        if b > 0.0:
            gain = min(gain, by_jerk[i] / math.sqrt(b))
        return float(b + step[i] * max(gain, 0.0))

    for i in range(len(step)):
        square[i + 1] = min(square[i + 1], reached(square[i], i))
    for i in reversed(range(len(step))):
        square[i] = min(square[i], reached(square[i + 1], i))
    return np.array(square)


def _averaged(stretch: Stretch, square: Array, period: float) -> Profile:
    """Turn v^2 at samples into spans of constant jerk, each one period long."""
    place, speed = stretch.arc_length - stretch.arc_length[0], np.sqrt(square)
    step = np.diff(place)
    lasting = 2.0 * step / (speed[1:] + speed[:-1])
    time = np.append(0.0, np.cumsum(lasting))
    n = max(math.ceil(time[-1] / period), 2)
    h = time[-1] / n
    at = np.arange(1, n) * h
    i = np.clip(np.searchsorted(time, at, side="right") - 1, 0, step.size - 1)
    dt = at - time[i]
    reached = place[i] + dt * (speed[i] + 0.5 * dt * (speed[i + 1] - speed[i]) / lasting[i])
    mean = np.diff(np.concatenate([[0.0], reached, [place[-1]]])) / h
    padded = np.concatenate([[0.0, 0.0], mean, [0.0, 0.0]])
    older, old, new = padded[:-2], padded[1:-1], padded[2:]
    v0, a0, j = 0.5 * (older + old), (old - older) / h, (new - 2.0 * old + older) / h**2
    gone = np.cumsum(h * (v0 + h * (a0 / 2.0 + h * j / 6.0)))
    s0 = np.minimum(np.append(0.0, gone[:-1]), place[-1])
    return Profile(np.arange(n + 2) * h, s0, v0, a0, j, duration=(n + 2) * h, length=float(place[-1]))


def _places(stretch: Stretch, profile: Profile) -> Motion:
    """Return the motion at many times: throughout every span, and at the samples of the path."""
    # Both ends of every span are looked at from inside, for the jerk jumps there.
    local = stretch.arc_length - stretch.arc_length[0]
    per_span = min(max(math.ceil(2.0 * local.size / profile.n_span), 3), PER_SPAN)
    h = profile.duration / profile.n_span
    time = (profile.t0[:, None] + h * np.linspace(1e-9, 1.0 - 1e-9, per_span)).ravel()
    along = profile.motion(time).arc_length
    return profile.motion(np.sort(np.concatenate([time, np.interp(local[1:-1], along, time)])))


def _demand(stretch: Stretch, motion: Motion, limits: AxisLimits, path: Path | None) -> Array:
    """Return the greatest demand at each place of a motion, as a part of the limits.

    The derivatives are those of the path; without it, those of the samples in between which the place lies.
    """
    local = stretch.arc_length - stretch.arc_length[0]
    i = np.clip(np.searchsorted(local, motion.arc_length, side="right") - 1, 0, local.size - 2)
    if path is None:
        part = ((motion.arc_length - local[i]) / np.maximum(local[i + 1] - local[i], 1e-300))[:, None]
        t, k, c = (value[i] + part * (value[i + 1] - value[i]) for value in stretch[1:4])
    else:
        _, t, k, c = path.derivatives(motion.arc_length + stretch.arc_length[0], 3)
    v, a, j = (part[:, None] for part in motion[1:])
    velocity = np.abs(t * v) / limits.velocity
    acceleration = np.abs(t * a + k * v**2) / limits.acceleration
    jerk = np.abs(t * j + 3.0 * k * v * a + c * v**3) / limits.jerk
    of_axes = np.maximum(velocity, np.maximum(acceleration, jerk)).max(axis=1)
    return np.asarray(np.maximum(of_axes, motion.speed / np.minimum(stretch.ceiling[i], stretch.ceiling[i + 1])))


def _corrected(path: Path, stretch: Stretch, limits: AxisLimits, period: float, beat: float) -> Profile | None:
    """Plan with one period h, lowering the limits where the result breaks them, until it does not.

    Gives up once it takes `beat` seconds: corrections only ever make it slower.
    """
    scale = np.ones_like(stretch.arc_length)
    local = stretch.arc_length - stretch.arc_length[0]
    for _ in range(ROUNDS):
        ceiling = _ceiling(stretch, limits, scale)
        speed = np.sqrt(_square_speed(stretch, limits, scale, ceiling))
        ceiling = _lowest_within(local, ceiling, 1.05 * SPREAD * period * speed)
        square = _square_speed(stretch, limits, scale, ceiling)
        profile = _averaged(stretch, square, period)
        if profile.duration >= beat:
            return None
        motion = _places(stretch, profile)
        demand = _demand(stretch, motion, limits, None)
        if np.max(demand) <= 1.0 + ROUNDING:
            # Good by the samples, which are cheap to ask; the path itself has the last word.
            demand = _demand(stretch, motion, limits, path)
            if np.max(demand) <= 1.0 + CLOSE:
                return profile
        place = motion.arc_length
        bad = np.flatnonzero(demand > 1.0 + ROUNDING)
        # Each offence lowers the limits of the samples that its span was averaged over.
        reach = SPREAD * period * np.interp(place[bad], local, np.sqrt(square)) + 1e-3 * local[-1]
        first = np.searchsorted(local, place[bad] - reach)
        last = np.searchsorted(local, place[bad] + reach, side="right")
        lower = np.ones_like(scale)
        for i, k, by in zip(first.tolist(), last.tolist(), demand[bad].tolist(), strict=True):
            np.minimum(lower[i:k], 0.98 / by, out=lower[i:k])
        scale *= np.maximum(lower, 0.6)
    return None


def smooth_profile(path: Path, stretch: Stretch, limits: AxisLimits, beat: float = math.inf) -> Profile | None:
    """Plan one stretch from rest to rest.

    Parameters
    ----------
    path : Path
    stretch : Stretch
    limits : AxisLimits
        With finite acceleration; the jerk may be unlimited.
    beat : float [s]
        Only a faster motion is wanted.

    Returns
    -------
    Profile or None
        With progress counted from the start of the stretch; None where no faster motion passed the check, or where
        the acceleration has no limit.
    """
    if not np.all(np.isfinite(limits.acceleration)):
        return None
    t = np.maximum(np.abs(stretch.tangent), 1e-6)
    along = (limits.acceleration / t).min(axis=1)
    jerk = (limits.jerk / t).min(axis=1)
    unit = float(np.max(2.0 * along / jerk))
    length = float(stretch.arc_length[-1] - stretch.arc_length[0])
    unit = max(unit, FINEST * math.sqrt(length / float(np.min(along))))
    best = None
    for part in PERIODS:
        found = _corrected(path, stretch, limits, part * unit, beat)
        if found is not None:
            best, beat = found, found.duration
    return best
