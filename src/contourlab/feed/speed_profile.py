"""Turn v^2 at samples into a motion, and check it against the limits: recursions like those of `kernels`."""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

import math

from contourlab.native.kernel import kernel


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
