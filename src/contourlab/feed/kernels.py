"""Recursions along the samples of segments, compiled when first called: from v^2 to a motion, checked against the limits.

Arrays over samples have the length n, derivatives of the path the shape (n, n_axis). Two samples may lie at one place, where the curvature
jumps between two curves. x is v^2: the acceleration a is constant between samples, so x is linear in the arc length, x' = 2 a.
"""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

import math

from contourlab.native.kernel import kernel

LIMITED, BEHIND, LOWERED, MOVED, STALE, STRAIGHT = 1, 2, 4, 8, 16, 32  # flags of a sample; see `reach` and `walk`
TINY = 1e-9  # smallest tangent component that limits the acceleration
N_NEWTON = 60
EDGE = 1e-9  # of a span's time: places are checked so far within it


def _interval(x, i, double, tangent, second, third, turning, speeding, reference, acceleration, jerk, period):
    """Return the upper limits of a and of -a between the samples i and i + 1, for a given x at i, each with its derivative by x.

    The axis accelerations are limited at both ends of the interval; at the second end, v^2 is x + 2 a ds.
    """
    high, low, over, under, rise, fall = math.inf, math.inf, 1.0, 1.0, 0.0, 0.0
    steady = 1.0 / (period * speeding[i]) if period > 0.0 else 0.0
    for axis in range(acceleration.size):
        for at in range(i, i + 2):
            p, q = tangent[at, axis], second[at, axis]
            if at > i:
                p += double * q
            if p < 0.0:
                p, q = -p, -q
            if p > TINY:
                limit, turn = acceleration[axis] * turning[at], q * x
                if limit - turn < high * p:
                    high, over, rise = (limit - turn) / p, p, -q
                if limit + turn < low * p:
                    low, under, fall = (limit + turn) / p, p, q
        p = abs(tangent[i, axis]) * steady + 3.0 * abs(second[i, axis]) * reference[i]
        if period > 0.0 and p > 0.0:
            q = abs(third[i, axis]) * reference[i]
            left = jerk[axis] - q * x
            if left < high * p:
                high, over, rise = left / p, p, -q
            if left < low * p:
                low, under, fall = left / p, p, -q
    return high, rise / over, low, fall / under


def _note(reference, ceiling, known_reference, known_ceiling, flags):
    """Flag the intervals whose limits have changed as LIMITED, and store the new limits."""
    for i in range(reference.size):
        flags[i] &= LOWERED | STALE | STRAIGHT
        if flags[i] & LOWERED != 0:
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
        high, high_slope, low, low_slope = _interval(
            x, i, double, tangent, second, third, turning, speeding, reference, acceleration, jerk, period
        )
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
        other flags but STALE and STRAIGHT are working memory.
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
                high, _, _, _ = _interval(
                    start, i - 1, double, tangent, second, third, turning, speeding, reference, acceleration, jerk, period
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
        From `demand`.
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


@kernel("f8[:] f8[:] i8[:] i8[:] i8[:] f8 f8[:] f8[:] i8[:]")
def clock(arc_length, square, first, last, free, period, time, lasting, count):
    """Fill the time at each sample, from the start of its block.

    Parameters
    ----------
    arc_length, square (n,)
    first, last (n_block,)
        First and last sample of each block; a block starts at the last sample of the one before, or at a stop.
    free (n_block,)
        Zero for a block that must take a whole number of periods; such a block is slowed down smoothly between its ends.
    period [s]
        0: no block is slowed down.
    time (n,) [s]
        Output; the time at the end of a block is in `lasting` instead.
    lasting (n_block,) [s], count (n_block,)
        Output: duration of each block, and its number of periods, rounded up.
    """
    for block in range(first.size):
        so_far = 0.0
        before = math.sqrt(square[first[block]])
        time[first[block]] = 0.0
        for i in range(first[block] + 1, last[block] + 1):
            speed = math.sqrt(square[i])
            step, both = arc_length[i] - arc_length[i - 1], speed + before
            so_far += 2.0 * step / both if step > 0.0 and both > 0.0 else 0.0
            if i < last[block]:
                time[i] = so_far
            before = speed
        lasting[block] = so_far
        if period == 0.0:
            continue
        count[block] = max(math.ceil(so_far / period - 1e-9), 1)
        if free[block] == 0:
            lasting[block] = count[block] * period
            more = lasting[block] - so_far
            for i in range(first[block] + 1, last[block]):
                part = time[i] / so_far
                time[i] += more * part * part * (3.0 - 2.0 * part)


@kernel("f8[:] f8[:] f8[:] i8[:] i8[:] f8[:] i8[:] i8[:] f8 f8[:]")
def steps(arc_length, square, time, first, last, lasting, begin, count, period, mean):
    """Fill the mean speed in each step of the time grid; the last step of a block may be short.

    Parameters
    ----------
    arc_length, square, time (n,); first, last, lasting, count (n_block,)
        As for `clock`.
    begin (n_block,)
        First step of each block.
    period [s]
        Time step of the grid.
    mean (n_step,) [m/s]
        Output, for the steps of the blocks.
    """
    for block in range(first.size):
        i, reached, end = first[block], 0.0, last[block]
        whole = arc_length[end] - arc_length[i]
        origin = arc_length[i]
        for k in range(1, count[block] + 1):
            at, place = k * period, whole
            if k < count[block]:
                while i + 1 < end and time[i + 1] <= at:
                    i += 1
                # Within a slowed-down block, time is scaled in each interval.
                until = lasting[block] if i + 1 == end else time[i + 1]
                part = (at - time[i]) / (until - time[i]) if until > time[i] else 1.0
                low, high = math.sqrt(square[i]), math.sqrt(square[i + 1])
                both = low + high
                step = arc_length[i + 1] - arc_length[i]
                if both > 0.0:
                    place = arc_length[i] - origin + step * part * (2.0 * low + part * (high - low)) / both
                place = min(max(place, reached), whole)
            mean[begin[block] + k - 1] = (place - reached) / period
            reached = place


@kernel("f8[:] i8[:] f8[:] f8[:] i8 f8 f8[:,:]")
def averaged(mean, begin, start, end, width, period, spans):
    """Average `width` steps, and make these the coefficients of a cubic B-spline.

    Parameters
    ----------
    mean (n_step,) [m/s]
        Mean speeds; the last `width` + 1 of each segment are 0.
    begin (n_segment + 1,); start, end (n_segment,) [m]
        First step of each segment; arc lengths at both of its ends.
    period [s]
        Time step.
    spans (n_step, 5)
        Output: duration; arc length, speed, acceleration at the start; jerk.
    """
    older, old, travel = 0.0, 0.0, 0.0
    for segment in range(start.size):
        before = travel
        for i in range(begin[segment], begin[segment + 1]):
            new = 0.0
            for k in range(max(i - width + 1, 0), i + 1):
                new += mean[k]
            new /= width
            v, a, j = 0.5 * (older + old), (old - older) / period, (new - 2.0 * old + older) / period**2
            spans[i, 0], spans[i, 1] = period, min(start[segment] + (travel - before), end[segment])
            spans[i, 2], spans[i, 3], spans[i, 4] = v, a, j
            travel += period * (v + period * (a / 2.0 + period * j / 6.0))
            older, old = old, new


def _over(tangent, second, third, row, v, a, j, velocity, acceleration, jerk, worst):
    """Update `worst`: velocity, acceleration, jerk as fractions of the limits, and the fraction of the jerk limit that turning alone needs.

    `velocity`, `acceleration` and `jerk` are the inverses of the limits.
    """
    for axis in range(velocity.size):
        t, k = tangent[row, axis], second[row, axis]
        worst[0] = max(worst[0], abs(t * v) * velocity[axis])
        worst[1] = max(worst[1], abs(t * a + k * v * v) * acceleration[axis])
        turn = third[row, axis] * v * v * v
        whole = abs(t * j + 3.0 * k * v * a + turn) * jerk[axis]
        if whole > worst[2]:
            worst[2] = whole
            worst[3] = abs(turn) * jerk[axis]


def _between(tangent, second, third, i, gap, part, here):
    """Fill `here` with derivatives of the path between the samples i and i + 1: by cubics, the third by a quadratic."""
    for axis in range(tangent.shape[1]):
        t0, t1 = tangent[i, axis], tangent[i + 1, axis]
        k0, k1 = second[i, axis], second[i + 1, axis]
        c0, c1 = third[i, axis], third[i + 1, axis]
        if gap <= 0.0 or (k0 == 0.0 and k1 == 0.0):
            here[0, 0, axis], here[1, 0, axis], here[2, 0, axis] = t0, k0, c0
            continue
        both = part * (1.0 - part)
        # Mean slope less the mean of the slopes at both ends.
        t_bow, k_bow = (t1 - t0) / gap - 0.5 * (k0 + k1), (k1 - k0) / gap - 0.5 * (c0 + c1)
        here[2, 0, axis] = c0 + part * (c1 - c0) + 6.0 * both * k_bow
        here[1, 0, axis] = k0 + part * (k1 - k0) + gap * both * (0.5 * (c0 - c1) + (2.0 * part - 1.0) * k_bow)
        here[0, 0, axis] = t0 + part * (t1 - t0) + gap * both * (0.5 * (k0 - k1) + (2.0 * part - 1.0) * t_bow)


def _along(span, i, last, arc_length, tangent, second, third, ceiling, spans, velocity, acceleration, jerk, per_span, here, worst):
    """Check one span from sample i on; return the last sample passed, the largest demand, and its sample, place and speed."""
    lasting, s0, v0, a0, j = spans[span, 0], spans[span, 1], spans[span, 2], spans[span, 3], spans[span, 4]
    for r in range(4):
        worst[r] = 0.0
    before, at, most = 0.0, s0, 0.0
    where, place, speed = i, s0, v0
    for step in range(per_span):
        dt = lasting * step / (per_span - 1)
        s = s0 + dt * (v0 + dt * (a0 / 2.0 + dt * j / 6.0))
        # Check the samples passed on the way; at a junction, those of both curves.
        while i < last and arc_length[i + 1] <= s:
            i += 1
            part = min(max((arc_length[i] - at) / (s - at), 0.0), 1.0) if s > at else 1.0
            between = before + (dt - before) * part
            v, a = v0 + between * (a0 + between * j / 2.0), a0 + between * j
            _over(tangent, second, third, i, v, a, j, velocity, acceleration, jerk, worst)
            worst[0] = max(worst[0], v / ceiling[i])
            if max(worst[0], worst[1], worst[2]) > most:
                most = max(worst[0], worst[1], worst[2])
                where, place, speed = i, arc_length[i], v
        v, a = v0 + dt * (a0 + dt * j / 2.0), a0 + dt * j
        gap = arc_length[i + 1] - arc_length[i]
        part = min(max((s - arc_length[i]) / gap, 0.0), 1.0) if gap > 0.0 else 0.0
        _between(tangent, second, third, i, gap, part, here)
        _over(here[0], here[1], here[2], 0, v, a, j, velocity, acceleration, jerk, worst)
        worst[0] = max(worst[0], v / max(ceiling[i], ceiling[i + 1]))
        if max(worst[0], worst[1], worst[2]) > most:
            most = max(worst[0], worst[1], worst[2])
            where, place, speed = i, s, v
        before, at = dt, s
    return i, most, where, place, speed


@kernel("f8[:] f8[:,:] f8[:,:] f8[:,:] f8[:] i8[:] f8[:,:] i8[:] f8[:] f8[:] f8[:] i8 f8 i8[:] f8[:,:,:] f8[:] f8[:] f8[:,:] i8[:]")
def demand(
    arc_length, tangent, second, third, ceiling, begin, spans, begin_span, velocity, acceleration, jerk, per_span, allowed, watched, here,
    worst, peak, faults, count
):  # fmt: skip
    """Check a motion at several places of every span and at every sample.

    Parameters
    ----------
    arc_length, ceiling (n,); tangent, second, third (n, n_axis)
    spans (n_span, 5)
        Duration, s, v, a at the start, and the jerk.
    begin, begin_span (n_segment + 1,)
        First sample and first span of each segment.
    velocity, acceleration, jerk (n_axis,)
        Inverses of the limits.
    per_span
        Places checked in each span, both ends included.
    allowed
        Largest fraction of a limit that is no violation.
    watched (n,)
        Zero at samples after which nothing is checked.
    here (3, 1, n_axis), worst (4,)
        Working memory.
    peak (n_segment,)
        Output: largest fraction of any limit needed in each segment.
    faults (n_span, 7)
        Output, a row for each span with a violation: sample before the worst place, arc length and speed there, fractions of the velocity,
        acceleration and jerk limits, and fraction of the jerk limit that turning alone needs.
    count (1,)
        Output: number of violations.
    """
    count[0] = 0
    for segment in range(begin.size - 1):
        i, last = begin[segment], begin[segment + 1] - 2
        peak[segment] = 0.0
        for span in range(begin_span[segment], begin_span[segment + 1]):
            while i < last and arc_length[i + 1] <= spans[span, 1]:
                i += 1
            if watched[i] == 0:
                continue
            i, most, where, place, speed = _along(
                span, i, last, arc_length, tangent, second, third, ceiling, spans, velocity, acceleration, jerk, per_span, here, worst
            )
            peak[segment] = max(peak[segment], most)
            if most > allowed:
                k = count[0]
                faults[k, 0], faults[k, 1], faults[k, 2] = where, place, speed
                for r in range(4):
                    faults[k, 3 + r] = worst[r]
                count[0] = k + 1


def _place(span, spans, dt):
    """Return the place at a time in a span."""
    return spans[span, 1] + dt * (spans[span, 2] + dt * (spans[span, 3] / 2.0 + dt * spans[span, 4] / 6.0))


def _step(span, i, dt, parts, arc_length, flags, spans):
    """Return the sample before the place at `dt`, and the next time: at most a part of the span later, and of the interval further."""
    place, step = _place(span, spans, dt), 0.0
    while True:  # what is close before a sample counts as past it
        step = (arc_length[i + 1] - arc_length[i]) / (1 if flags[i] & STRAIGHT != 0 else parts[1])
        if i == arc_length.size - 2 or (step > 0.0 and place + 0.2 * step < arc_length[i + 1]):
            break
        i += 1
    low, high = dt, min(dt + spans[span, 0] / parts[0], (1.0 - EDGE) * spans[span, 0])
    target = arc_length[i] + step * (max(math.floor((place - arc_length[i]) / step + 0.2), 0.0) + 1.0) if step > 0.0 else math.inf
    above, near, after = _place(span, spans, high), step, i + 1
    if above <= target:
        return i, high
    while after < arc_length.size - 2 and arc_length[after + 1] <= arc_length[after]:
        after += 1
    if after < arc_length.size - 1:  # a miss must not pass the next interval either
        near = min(step, (arc_length[after + 1] - arc_length[after]) / parts[1])
    for k in range(40):
        part = (target - place) / (above - place) if k % 2 == 0 else 0.5
        middle = low + part * (high - low)
        there = _place(span, spans, middle)
        if abs(there - target) <= 0.1 * near:
            return i, middle
        if there < target:
            low, place = middle, there
        else:
            high, above = middle, there
    return i, high


@kernel("f8[:] i8[:] f8[:,:] i8[:] i8[:] f8[:] i8[:] f8[:] f8[:]")
def walk(arc_length, flags, spans, parts, at, reached, of, times, place):
    """Fill the next places at which the path is to be evaluated, until the arrays are full or the motion ends.

    Parameters
    ----------
    arc_length, flags (n,); spans
        STALE where the path is to be checked, STRAIGHT where the interval after a sample is; the others as for `demand`.
    parts (2,)
        Least number of steps in a span, and in an interval that is not straight.
    at (3,), reached (1,)
        Span, sample and time [s] of the next place, kept from call to call, and the number of places filled; 0 before the first call.
    of, times [s], place [m]
        Output: the span of each place, the time from its start, and the place.
    """
    i, dt, count = at[1], reached[0], 0
    for span in range(at[0], spans.shape[0]):
        if dt == 0.0:
            while i < arc_length.size - 2 and arc_length[i + 1] <= spans[span, 1]:
                i += 1
            if flags[i] & STALE == 0:
                continue
            dt = EDGE * spans[span, 0]
        while True:
            if count == of.size:
                at[0], at[1], at[2], reached[0] = span, i, count, dt
                return
            of[count], times[count], place[count] = span, dt, _place(span, spans, dt)
            count += 1
            if dt >= (1.0 - EDGE) * spans[span, 0]:
                break
            i, dt = _step(span, i, dt, parts, arc_length, flags, spans)
        dt = 0.0
    at[0], at[1], at[2], reached[0] = spans.shape[0], i, count, dt


@kernel("f8[:,:] i8[:] f8[:] f8[:] f8[:,:,:] f8[:] f8[:] f8[:] f8[:] f8[:,:]")
def needed(spans, of, times, place, derivatives, velocity, acceleration, jerk, worst, found):
    """Fill rows of faults, as in `demand` without the sample, one for each span that has places.

    Parameters
    ----------
    of, times [s], place [m] (m,)
        Spans, rising, times from the start of the span, and where the motion is then.
    derivatives (4, n_axis, m)
        Of the path, there.
    found (m, 6)
        Output.
    """
    tangent, second, third = derivatives[1].T, derivatives[2].T, derivatives[3].T
    row, most = -1, 0.0
    for k in range(of.size):
        dt, a0, j = times[k], spans[of[k], 3], spans[of[k], 4]
        v = spans[of[k], 2] + dt * (a0 + dt * j / 2.0)
        for r in range(4):
            worst[r] = 0.0
        _over(tangent, second, third, k, v, a0 + dt * j, j, velocity, acceleration, jerk, worst)
        if k == 0 or of[k] != of[k - 1]:
            row, most = row + 1, -1.0
            for r in range(4):
                found[row, 2 + r] = 0.0
        if max(worst[0], worst[1], worst[2]) > most:
            most, found[row, 0], found[row, 1] = max(worst[0], worst[1], worst[2]), place[k], v
        for r in range(4):
            found[row, 2 + r] = max(found[row, 2 + r], worst[r])
