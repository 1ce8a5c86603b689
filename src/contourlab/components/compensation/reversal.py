"""Helpers of the compensations: the pushed side, and the move of a shift from one side of the gap to the other."""

from __future__ import annotations

from contourlab.primitives import clip, copysign, fabs, floor, maximum, minimum, select, sqrt


def pushed_side(speed: float, band: float, before: float) -> float:
    """Return the side on which the load is pushed: +1 or -1, and `before` inside the speed band.

    Standstill keeps the side: a motor that stops keeps its contact.
    """
    return select(speed > band, 1.0, select(speed < -band, -1.0, before))


def limited_jump(now: float, target: float, most: float) -> float:
    """Return `now` moved towards the target by `most` at most; the last move lands on it exactly."""
    left = target - now
    return select(fabs(left) <= most, target, now + clip(left, -most, most))


def limited_ramp(now: float, speed: float, target: float, most_speed: float, most_rise: float, dt: float) -> tuple[float, float]:
    """Return offset and speed after one tick towards a target, with limits of speed and acceleration.

    `most_rise` is the largest change of speed in a tick, a dt. In units of a dt and a dt^2, an offset with speed v that brakes by 1 per
    tick stops after n ticks and a distance v + (v - 1) + ... = n v - n (n - 1)/2, where n - 1 < v <= n. Solved for v, with the least n for
    which n (n + 1)/2 is at least the distance left, this is the highest speed from which it can stop at the target.
    """
    left = target - now
    ticks = fabs(left) / (most_rise * dt)
    n = maximum(-floor(0.5 - sqrt(0.25 + 2.0 * ticks)), 1.0)
    stopping = most_rise * (ticks / n + 0.5 * (n - 1.0))
    wanted = copysign(minimum(most_speed, stopping), left)
    after = clip(wanted, speed - most_rise, speed + most_rise)
    moved = now + after * dt
    # Rounding must not keep it from the target.
    there = fabs(target - moved) <= 1e-9 * most_rise * dt
    return select(there, target, moved), after
