"""What the compensations share: which way an axis is pushed, and how a shift goes from one side of the gap to the other."""

from __future__ import annotations

from contourlab.primitives import clip, copysign, fabs, floor, maximum, minimum, select, sqrt


def pushed_side(speed: float, band: float, before: float) -> float:
    """Return the side on which the load is pushed: +1 or -1; inside the speed band the one `before`.

    At standstill the speed is 0 and the side is held: a motor that stops keeps its contact.
    """
    return select(speed > band, 1.0, select(speed < -band, -1.0, before))


def limited_jump(now: float, target: float, most: float) -> float:
    """Return `now` moved towards the target by `most` at most; the last move lands on it exactly."""
    left = target - now
    return select(fabs(left) <= most, target, now + clip(left, -most, most))


def limited_ramp(now: float, speed: float, target: float, most_speed: float, most_rise: float, dt: float) -> tuple[float, float]:
    """Return offset and speed one tick on, on the way to a target with limits of speed and acceleration.

    `most_rise` is the change of speed in a tick, a dt. In units of a dt and a dt^2, an offset with the speed v ends in n ticks, braking by
    1 in each, after v + (v - 1) + ... = n v - n (n - 1)/2, where n - 1 < v <= n. Solved for v, with n the least for which n (n + 1)/2 is
    not less than what is left, this is the highest speed from which it can stop there.
    """
    left = target - now
    ticks = fabs(left) / (most_rise * dt)
    n = maximum(-floor(0.5 - sqrt(0.25 + 2.0 * ticks)), 1.0)
    stopping = most_rise * (ticks / n + 0.5 * (n - 1.0))
    wanted = copysign(minimum(most_speed, stopping), left)
    after = clip(wanted, speed - most_rise, speed + most_rise)
    moved = now + after * dt
    # Rounding must not keep it from its end.
    there = fabs(target - moved) <= 1e-9 * most_rise * dt
    return select(there, target, moved), after
