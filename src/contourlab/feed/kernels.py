"""Recursions along the samples of segments, compiled when first called.

Arrays over samples have the length n, derivatives of the path the shape (n, n_axis). Two samples may lie at one place, where the curvature
jumps between two curves. x is v^2: the acceleration a is constant between samples, so x is linear in the arc length, x' = 2 a.
"""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

import math

from contourlab.native.kernel import kernel

LIMITED, BEHIND, LOWERED, MOVED = 1, 2, 4, 8  # flags of a sample; see `reach`
TINY = 1e-9  # smallest tangent component that limits the acceleration
N_NEWTON = 60


def _tightest(x, i, double, sign, tangent, second, third, turning, speeding, reference, acceleration, jerk, period):
    """Return the upper limit of sign * a between the samples i and i + 1, for a given x at i, and its derivative by x.

    The axis accelerations are limited at both ends of the interval; at the second end, v^2 is x + 2 a ds.
    """
    best, slope = math.inf, 0.0
    for axis in range(acceleration.size):
        for at in range(i, i + 2):
            p, q = tangent[at, axis], second[at, axis]
            if at > i:
                p += double * q
            p *= sign
            if p < 0.0:
                p, q = -p, -q
            if p > TINY:
                value = (acceleration[axis] * turning[at] - q * x) / p
                if value < best:
                    best, slope = value, -q / p
        if period > 0.0:
            p = abs(tangent[i, axis]) / (period * speeding[i]) + 3.0 * abs(second[i, axis]) * reference[i]
            if p > 0.0:
                q = abs(third[i, axis]) * reference[i]
                value = (jerk[axis] - q * x) / p
                if value < best:
                    best, slope = value, -q / p
    return best, slope


def _note(reference, ceiling, known_reference, known_ceiling, flags):
    """Flag the intervals whose limits have changed as LIMITED, and store the new limits."""
    for i in range(reference.size):
        flags[i] &= LOWERED
        if flags[i] != 0:
            flags[i] |= LIMITED
            if i > 0:  # the interval before ends here
                flags[i - 1] |= LIMITED
        if reference[i] != known_reference[i] or ceiling[i] != known_ceiling[i]:
            flags[i] |= LIMITED
        known_reference[i], known_ceiling[i] = reference[i], ceiling[i]


def _controllable(i, double, following, x, tangent, second, third, turning, speeding, reference, acceleration, jerk, period):
    """Return the largest v^2 up to x at sample i from which the next sample can be reached with at most `following`.

    The width of the interval of accelerations is concave in v^2, so Newton steps from above end at its last root.
    """
    for _ in range(N_NEWTON):
        high, high_slope = _tightest(x, i, double, 1.0, tangent, second, third, turning, speeding, reference, acceleration, jerk, period)
        low, low_slope = _tightest(x, i, double, -1.0, tangent, second, third, turning, speeding, reference, acceleration, jerk, period)
        if (following - x) / double < high:
            high, high_slope = (following - x) / double, -1.0 / double
        if x / double < low:
            low, low_slope = x / double, 1.0 / double
        gap = high + low
        if gap >= -1e-13 * (abs(high) + abs(low)):
            break
        slope = high_slope + low_slope
        x = max(x - gap / slope, 0.0) if slope < 0.0 else 0.5 * x
    return x


@kernel("f8[:] f8[:,:] f8[:,:] f8[:,:] f8[:] f8[:] f8[:] f8[:] f8[:] f8[:] f8 f8[:] f8[:] f8[:] f8[:] i8[:]")
def reach(
    arc_length, tangent, second, third, turning, speeding, reference, ceiling, acceleration, jerk, period, known_reference, known_ceiling,
    behind, square, flags
):  # fmt: skip
    """Find the fastest v^2 from rest to rest: a backward pass for speeds that can stop, a forward pass for the largest.

    A second call with other limits recomputes only what has changed.

    Parameters
    ----------
    arc_length (n,); tangent, second, third (n, n_axis)
    turning, speeding (n,)
        Usable fractions of the acceleration limits, and of the jerk for changes of the tangential acceleration.
    reference (n,) [m/s]
        Speed at which the jerk limits are evaluated; safe if not below the true speed.
    ceiling (n,) [m/s]
        Zero where the motion rests, at least at the first and the last sample.
    acceleration, jerk (n_axis,)
    period [s]
        Time in which the tangential acceleration may rise to its limit; 0 without jerk limits.
    known_reference, known_ceiling, behind, square (n,)
        Kept from call to call, nan before the first: the limits (the same array if `reference` and `ceiling` are the same), the largest
        v^2 from which the motion can stop, and the result v^2 [m^2/s^2].
    flags (n,)
        Input: LOWERED where `turning` or `speeding` have changed since the last call. Output: MOVED where the result has changed. The
        other flags are working memory.
    """
    n = arc_length.size
    _note(reference, ceiling, known_reference, known_ceiling, flags)
    moved = True
    for i in range(n - 1, -1, -1):
        # A change at the end of an interval affects the interval too.
        if flags[i] & (LIMITED | BEHIND) == 0 and not moved:
            continue
        x = ceiling[i] * ceiling[i]
        if i < n - 1:
            double = 2.0 * (arc_length[i + 1] - arc_length[i])
            if double <= 0.0:
                x = min(x, behind[i + 1])
            else:
                x = _controllable(
                    i, double, behind[i + 1], x, tangent, second, third, turning, speeding, reference, acceleration, jerk, period
                )
        moved = x != behind[i]
        behind[i] = x
        if moved:
            flags[i] |= BEHIND
    moved = True
    for i in range(n):
        if i > 0 and (flags[i - 1] | flags[i]) & (LIMITED | BEHIND) == 0 and not moved:
            continue
        x = behind[i]
        if i > 0:
            double, start = 2.0 * (arc_length[i] - arc_length[i - 1]), square[i - 1]
            if double > 0.0:
                high, _ = _tightest(
                    start, i - 1, double, 1.0, tangent, second, third, turning, speeding, reference, acceleration, jerk, period
                )
                start = max(start + double * high, 0.0)
            x = min(x, start)
        moved = x != square[i]
        if moved:
            flags[i] |= MOVED
        square[i] = x


@kernel("f8[:] f8[:,:] f8[:,:] f8 f8 f8[:] f8[:,:] i8[:]")
def lower(arc_length, faults, factors, half, haste, low, parts, flags):
    """Lower the usable fractions of the limits around violations.

    Parameters
    ----------
    arc_length (n,)
    faults (m, 7)
        From `speed_profile.demand`.
    factors (3, m)
        Factor on each fraction.
    half [s]
        Half of the averaging window.
    haste
        Exponent of the factors.
    low (n,)
        Working memory, full of ones.
    parts (3, n)
        Fractions of the acceleration, jerk and speed; lowered.
    flags (n,)
        LOWERED is set where the first or second fraction is lowered.
    """
    n = arc_length.size
    for part in range(3):
        for again in range(2):
            for fault in range(faults.shape[0]):
                place, width = faults[fault, 1], faults[fault, 2] * half
                first = last = int(faults[fault, 0])
                # The first sample of an interval gives its limits; where curves meet, two samples lie at one place.
                while first > 0 and arc_length[first] >= place - width:
                    first -= 1
                if first > 0 and arc_length[first - 1] == arc_length[first]:
                    first -= 1
                while last < n - 1 and arc_length[last] <= place + width:
                    last += 1
                for i in range(first, last + 1):
                    if again == 0:
                        low[i] = min(low[i], factors[part, fault])
                    elif low[i] != 1.0:
                        parts[part, i] *= max(low[i] ** haste, 0.5)
                        low[i] = 1.0
                        if part < 2:
                            flags[i] |= LOWERED


@kernel("f8[:] f8[:] f8 f8[:] i8[:]")
def spread(arc_length, value, half, result, queue):
    """Fill each sample with the least speed in reach: the speed of sample i reaches as far as it travels in the time `half`.

    A smaller speed hides larger ones behind it, even where these reach further.
    """
    n = arc_length.size
    for i in range(n):
        result[i] = value[i]
    for direction in range(2):
        head, tail = 0, 0
        for count in range(n):
            i = count if direction == 0 else n - 1 - count
            while tail > head and value[queue[tail - 1]] >= value[i]:
                tail -= 1
            queue[tail] = i
            tail += 1
            while abs(arc_length[i] - arc_length[queue[head]]) > value[queue[head]] * half:
                head += 1
                if head == tail - 1:
                    break
            result[i] = min(result[i], value[queue[head]])


def _crossing(arc_length, speed, at, towards, level):
    """Return where the speed falls to `level` between the samples `at` and `towards`; the place of `at` if it is lower there already."""
    if level >= speed[at]:
        return arc_length[at]
    return arc_length[at] + (arc_length[towards] - arc_length[at]) * (speed[at] - level) / (speed[at] - speed[towards])


@kernel("f8[:] f8[:] f8 f8[:]")
def flatten(arc_length, speed, lasting, ceiling):
    """Lower the ceiling at each speed peak so that the peak lasts `lasting` seconds, in which the acceleration can change its sign."""
    n = speed.size
    i = 1
    while i < n - 1:
        if not (speed[i] > speed[i - 1] and speed[i] >= speed[i + 1]):
            i += 1
            continue
        level = speed[i]
        left, right = i, i
        # Move both ends down, the higher one first, until the time between them is long enough or another peak joins.
        while left > 0 and right < n - 1 and speed[left - 1] <= speed[left] and speed[right + 1] <= speed[right]:
            lower = max(speed[left - 1], speed[right + 1])
            on_left = left - 1 if speed[left - 1] >= lower else left
            on_right = right + 1 if speed[right + 1] >= lower else right
            if lower < level:
                a, b = _crossing(arc_length, speed, left, left - 1, lower), _crossing(arc_length, speed, right, right + 1, lower)
                if b - a >= lower * lasting:
                    for _ in range(40):
                        middle = 0.5 * (lower + level)
                        a, b = _crossing(arc_length, speed, left, left - 1, middle), _crossing(arc_length, speed, right, right + 1, middle)
                        if b - a >= middle * lasting:
                            lower = middle
                        else:
                            level = middle
                    level = lower
                    break
            left, right, level = on_left, on_right, lower
        for k in range(left, right + 1):
            ceiling[k] = min(ceiling[k], level)
        i = right + 1
