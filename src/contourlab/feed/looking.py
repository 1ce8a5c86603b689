"""From v^2 at samples to a motion, and the look at what it demands: recursions along the samples of stretches, as in `kernels`.

They are compiled by `contourlab.native.door`, and run as plain Python as well.
"""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

import math

__all__ = ["clock", "demand", "lower", "steps"]


def clock(arc_length, square, time):
    """Fill the time (n,) [s] at each sample of a motion, running on over the stretches."""
    time[0] = 0.0
    before = math.sqrt(square[0])
    for i in range(1, arc_length.size):
        speed = math.sqrt(square[i])
        step, both = arc_length[i] - arc_length[i - 1], speed + before
        time[i] = time[i - 1] + (2.0 * step / both if step > 0.0 and both > 0.0 else 0.0)
        before = speed


def steps(arc_length, square, time, begin, begin_span, period, mean):
    """Fill the mean speed in each step of the time grid of each stretch; the last one ends within its step.

    Parameters
    ----------
    arc_length, square, time (n,)
    begin, begin_span (n_stretch + 1,)
        The samples of each stretch, and its steps with the empty ones behind them.
    period [s]
        Of the grid.
    mean (n_step,) [m/s]
        Zero beforehand.
    """
    for stretch in range(begin.size - 1):
        first, last = begin[stretch], begin[stretch + 1] - 1
        i, reached, row = first, 0.0, begin_span[stretch]
        whole = arc_length[last] - arc_length[first]
        count = 1
        while reached < whole:
            at = time[first] + count * period
            if at >= time[last] or row + count >= begin_span[stretch + 1]:
                mean[row + count - 1] = (whole - reached) / period
                break
            while time[i + 1] <= at:
                i += 1
            dt, step = at - time[i], arc_length[i + 1] - arc_length[i]
            pull = 0.5 * (square[i + 1] - square[i]) / step if step > 0.0 else 0.0
            place = arc_length[i] - arc_length[first] + dt * (math.sqrt(square[i]) + 0.5 * dt * pull)
            mean[row + count - 1] = (place - reached) / period
            reached = place
            count += 1


def lower(arc_length, faults, factors, half, haste, low, parts):
    """Lower parts of the limits around faults.

    Parameters
    ----------
    arc_length (n,)
    faults (m, 7)
        As filled by `demand`.
    factors (3, m)
        By which each part is to be lowered.
    half [s]
        What a motion takes in on either side of a place.
    haste
        Power to which the factors are taken.
    low (3, n)
        Working memory, full of ones.
    parts (3, n)
        Lowered.
    """
    n = arc_length.size
    for again in range(2):
        for fault in range(faults.shape[0]):
            place, width = faults[fault, 1], faults[fault, 2] * half
            first = last = int(faults[fault, 0])
            # An interval takes its limits from its first sample; where curves meet, there are two at one place.
            while first > 0 and arc_length[first] >= place - width:
                first -= 1
            if first > 0 and arc_length[first - 1] == arc_length[first]:
                first -= 1
            while last < n - 1 and arc_length[last] <= place + width:
                last += 1
            for part in range(3):
                for i in range(first, last + 1):
                    if again == 0:
                        low[part, i] = min(low[part, i], factors[part, fault])
                    else:
                        parts[part, i] *= max(low[part, i] ** haste, 0.5)
                        low[part, i] = 1.0


def _over(tangent, second, third, row, v, a, j, velocity, acceleration, jerk, worst):
    """Raise worst: velocity, acceleration, jerk as parts of the limits, and the part of the jerk limit that turning alone takes.

    The limits are given by their inverses.
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
    """Fill `here` with the derivatives of the path between the samples i and i + 1: cubics, since each is known with its own; the third quadratic."""
    for axis in range(tangent.shape[1]):
        t0, t1 = tangent[i, axis], tangent[i + 1, axis]
        k0, k1 = second[i, axis], second[i + 1, axis]
        c0, c1 = third[i, axis], third[i + 1, axis]
        if gap <= 0.0 or (k0 == 0.0 and k1 == 0.0):
            here[0, 0, axis], here[1, 0, axis], here[2, 0, axis] = t0, k0, c0
            continue
        both = part * (1.0 - part)
        # What the straight line between the two slopes misses of the rise.
        t_bow, k_bow = (t1 - t0) / gap - 0.5 * (k0 + k1), (k1 - k0) / gap - 0.5 * (c0 + c1)
        here[2, 0, axis] = c0 + part * (c1 - c0) + 6.0 * both * k_bow
        here[1, 0, axis] = k0 + part * (k1 - k0) + gap * both * (0.5 * (c0 - c1) + (2.0 * part - 1.0) * k_bow)
        here[0, 0, axis] = t0 + part * (t1 - t0) + gap * both * (0.5 * (k0 - k1) + (2.0 * part - 1.0) * t_bow)


def _along(span, i, last, arc_length, tangent, second, third, ceiling, spans, velocity, acceleration, jerk, per_span, here, worst):
    """Look at one span, from sample i on; return the last sample passed, the greatest demand, and where it is: sample, place, speed."""
    lasting, s0, v0, a0, j = spans[span, 0], spans[span, 1], spans[span, 2], spans[span, 3], spans[span, 4]
    for r in range(4):
        worst[r] = 0.0
    before, at, most = 0.0, s0, 0.0
    where, place, speed = i, s0, v0
    for step in range(per_span):
        dt = lasting * step / (per_span - 1)
        s = s0 + dt * (v0 + dt * (a0 / 2.0 + dt * j / 6.0))
        # The samples on the way here, each end of a curve with its own derivatives.
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


def demand(
    arc_length, tangent, second, third, ceiling, begin, spans, begin_span, velocity, acceleration, jerk, per_span, allowed, watched, here,
    worst, peak, faults, count
):  # fmt: skip
    """Look at a motion in every span and at every sample.

    Parameters
    ----------
    arc_length, ceiling (n,); tangent, second, third (n, n_axis)
    spans (n_span, 5)
        Duration, s, v, a at the start, and the jerk.
    begin, begin_span (n_stretch + 1,)
        The samples and the spans of each stretch.
    velocity, acceleration, jerk (n_axis,)
        The inverses of the limits.
    per_span
        Places looked at in each span, both ends among them.
    allowed
        Part of a limit that is no fault.
    watched (n,)
        Zero at samples after which nothing is to be looked at.
    here (3, 1, n_axis), worst (4,)
        Working memory.
    peak (n_stretch,)
        Filled with the greatest part of any limit that is needed in each stretch.
    faults (n_span, 7)
        Filled for each span that needs more than is allowed: sample before the worst place, arc length and speed there, the parts of
        the velocity, acceleration and jerk limits, and that of the jerk limit which turning alone takes.
    count (1,)
        Number of faults.
    """
    count[0] = 0
    for stretch in range(begin.size - 1):
        i, last = begin[stretch], begin[stretch + 1] - 2
        peak[stretch] = 0.0
        for span in range(begin_span[stretch], begin_span[stretch + 1]):
            while i < last and arc_length[i + 1] <= spans[span, 1]:
                i += 1
            if watched[i] == 0:
                continue
            i, most, where, place, speed = _along(
                span, i, last, arc_length, tangent, second, third, ceiling, spans, velocity, acceleration, jerk, per_span, here, worst
            )
            peak[stretch] = max(peak[stretch], most)
            if most > allowed:
                k = count[0]
                faults[k, 0], faults[k, 1], faults[k, 2] = where, place, speed
                for r in range(4):
                    faults[k, 3 + r] = worst[r]
                count[0] = k + 1
