"""Plan segments that are not straight: near the least time, with limited jerk.

For many segments at once, each from rest to rest:

1. `reach` finds the largest v^2 by arc length under the axis accelerations (reachable sets: Pham and Pham, "A new approach to time-optimal
   path parameterization based on reachability analysis", IEEE Transactions on Robotics 34(3), 2018). The jerk adds a third family of
   limits, linear in the acceleration and in v^2: |t| a/T + 3 |k| v a + |c| v^3 <= J.
2. The motion is averaged over the time T: the mean speeds of time steps T/`STEPS` are averaged over `STEPS` neighbours and become the
   coefficients of a cubic B-spline. This keeps the length, bounds the acceleration and makes the jerk constant in each span. To keep the
   average below the speed ceiling, each narrow place of the ceiling is first widened by half the averaging time. Each speed peak is cut
   off where it lasts T, so that the acceleration can change its sign.
3. Every span and sample is checked against the true limits. Around a violation the limits of step 1 are lowered, and all steps repeat;
   other places stay unchanged. A final check evaluates the path itself.

Only segments that pass step 3 are used. Every step is linear in the number of samples.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from contourlab.arrays import Array, Flags, Index, across
from contourlab.feed import kernels
from contourlab.feed.bounds import AxisLimits
from contourlab.feed.kernels import LOWERED, MOVED, STALE, STRAIGHT
from contourlab.feed.pieces import SegmentSamples
from contourlab.geometry import Path
from contourlab.threads import in_threads

PERIODS = (1.0, 0.7, 0.5, 0.35, 0.25)  # T tried, in units of A/J: at 1 the acceleration may rise to its limit within T
STEPS = 4  # time steps in T
ROUNDING = 1e-6  # of a limit
CLOSE = 1e-3  # of a limit: permitted excess between the samples
ROUNDS = 60  # most corrections
BEND = 4000.0  # stretching a block of duration D by one step h adds 6 v h/D^2: blocks are so long that this is below 6/BEND of the limit
BLOCK = 50  # periods in a block; each block has its own time grid, which stretches it by half a step on average
HASTE = 2.5  # rounds after which the exponent of a correction grows by 1
PER_SPAN = 16  # places checked in each span, besides the samples
ON_PATH = np.array([6, 4])  # least number of steps of the check on the path, in a span and in an interval that is not straight
MOST_SPANS = (8, 10_000)  # per sample, and in addition; this bounds T from below where the jerk limit is high
FEW = 2_000  # with fewer samples, starting threads takes longer than they save
MANY = (5_000, 200_000)  # with more samples, only the two most promising periods, or only the best one, are tried
CHUNK = 8_192  # places per pass
GROUP = 16_384  # samples of segments planned together, at least


class SmoothMotion(NamedTuple):
    """Motions of several segments.

    spans : ndarray (n_span, 5)
        Duration; arc length, speed, acceleration at the start; jerk.
    begin : ndarray (n_segment + 1,) of int
        First span of each segment.
    good : ndarray (n_segment,) of bool
        Whether the motion of the segment is within the limits.
    """

    spans: Array
    begin: Index
    good: Flags


class _Blocks(NamedTuple):
    """First and last sample of each block, and whether it may end within a step (n_block,)."""

    first: Index
    last: Index
    free: Index


class _Planner:
    """Arrays that the correction rounds of one period share.

    `parts` (3, n) are the usable fractions of the acceleration limit, of the jerk limit for changes of the tangential acceleration, and of
    the speed ceiling. Each line of a program has tens of samples, so intermediate arrays are freed early.
    """

    def __init__(self, path: Path, samples: SegmentSamples, base: Array, limits: AxisLimits, period: float) -> None:
        n = samples.arc_length.size
        self.path, self.samples, self.period = path, samples, period
        self.velocity, self.acceleration, self.jerk = (np.array(part) for part in (limits.velocity, limits.acceleration, limits.jerk))
        self.inverse = tuple(1.0 / part for part in (self.velocity, self.acceleration, self.jerk))
        self.place = tuple(np.ascontiguousarray(part) for part in samples[:4])
        self.base = base
        self.begin = samples.begin.astype(np.int64)
        curved = np.any((samples.second != 0.0) | (samples.third != 0.0), axis=1)
        self.flags = np.where(curved | np.roll(curved, -1), 0, STRAIGHT)
        self.half = 0.5 * period * (STEPS + 2) / STEPS  # of the averaging window
        self.parts = np.ones((3, n))
        # What the kernel `reach` keeps from call to call; of the first the ceiling is the reference.
        reference, behind, square = np.full((3, n), np.nan)
        self.first = (reference, reference, behind, square)
        self.second = tuple(np.full((4, n), np.nan)) if period > 0.0 else self.first
        first, last = self.begin[:-1], self.begin[1:] - 1
        self.blocks = _Blocks(first, last, np.ones_like(first))  # whole segments, until `divide`
        self.divided = False

    def square(self) -> Array:
        """Return v^2 at the samples."""
        ceiling = self.base * self.parts[2]
        if self.period == 0.0:
            self._reach(ceiling, ceiling, self.first)
        else:
            wide = np.empty_like(ceiling)
            kernels.spread(self.place[0], ceiling, self.half, wide, np.empty(ceiling.size, dtype=np.int64))
            self._reach(wide, wide, self.first)
            speed = np.sqrt(self.first[-1], out=ceiling)
            kernels.flatten(self.place[0], speed, self.period * (STEPS + 1) / STEPS, wide)
            # Now evaluate the jerk limits close to the final speed.
            speed *= 1.05
            speed += 1e-9
            self._reach(np.minimum(wide, speed, out=speed), wide, self.second)
        self.flags &= ~LOWERED
        return self.second[-1]

    def _reach(self, reference: Array, ceiling: Array, memory: tuple[Array, ...]) -> None:
        limits = self.acceleration, self.jerk, self.period
        kernels.reach(*self.place, self.parts[0], self.parts[1], reference, ceiling, *limits, *memory, self.flags)

    def check(self, spans: Array, begin: Index, watched: Index) -> tuple[Array, Array]:
        """Return the largest fraction of a limit that each segment needs, and the violations; see the kernel `demand`."""
        peak, faults = np.empty(begin.size - 1), np.empty((len(spans), 7))
        here, worst = np.empty((3, 1, self.velocity.size)), np.empty(4)
        count = np.zeros(1, dtype=np.int64)
        motion = *self.place, self.samples.ceiling, self.begin, spans, begin.astype(np.int64)
        kernels.demand(*motion, *self.inverse, PER_SPAN, 1.0 + ROUNDING, watched, here, worst, peak, faults, count)
        return peak, faults[: int(count[0])]

    def changed(self, faults: Array) -> Index:
        """Return 1 for the samples to check: blocks that have changed or had violations, and what is averaged with them; else 0."""
        different, arc_length = self.flags & MOVED != 0, self.place[0]
        different[faults[:, 0].astype(np.intp)] = True
        # The last sample of a block is the first of the next.
        edges = np.append(self.blocks.first, different.size)
        blocks = np.flatnonzero((np.add.reduceat(different, edges[:-1]) > 0) | different[self.blocks.last])
        around = 4.0 * self.half * math.sqrt(float(self.second[-1].max()))
        first = np.searchsorted(arc_length, arc_length[edges[blocks]] - around)
        after = np.searchsorted(arc_length, arc_length[edges[blocks + 1] - 1] + around, side="right")
        change = np.zeros(different.size + 1, dtype=np.int64)
        np.add.at(change, first, 1)
        np.add.at(change, after, -1)
        return np.asarray(np.minimum(np.cumsum(change[:-1]), 1))

    def lower(self, faults: Array, haste: float) -> None:
        """Lower the limits of the samples within the averaging window around each violation."""
        of_speed, of_acceleration, of_jerk, turn = faults.T[3:]
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            ease = np.clip((0.99 - turn) / (of_jerk - turn), 0.7, 0.98)
        slower = np.clip(1.0 - (of_jerk - 0.99) * turn / 3.0, 0.9, 1.0)
        factors = (
            np.where(of_acceleration > 1.0, 0.99 / of_acceleration, 1.0),
            np.where(of_jerk > 1.0, ease, 1.0),
            np.minimum(np.where(of_speed > 1.0, 0.999 / of_speed, 1.0), np.where(of_jerk > 1.0, slower, 1.0)),
        )
        low = np.ones_like(self.base)
        kernels.lower(self.place[0], np.ascontiguousarray(faults), np.stack(factors), self.half, haste, low, self.parts, self.flags)

    def divide(self, square: Array) -> None:
        """Divide the segments into blocks of about `BLOCK` periods, each of a whole number of steps.

        A correction in one block then leaves the time grids of the other blocks unchanged, and these need no new check.
        """
        first, last = self.blocks.first, self.blocks.last
        time, duration, _ = self._clock(square)
        fastest = math.sqrt(float(square.max()))
        size = max(BLOCK * self.period, np.sqrt(BEND * fastest * self.period / STEPS / float(self.acceleration.min())))
        number = np.floor(np.divide(time, size, out=time), out=time)
        # Join the rest of a segment to its last whole block; `time` does not hold the time of its last sample.
        most = np.maximum(np.floor(duration / size) - 1.0, 0.0)
        np.minimum(number, np.repeat(most, np.diff(self.begin)), out=number)
        number[last] = number[np.maximum(last - 1, 0)]
        further = number[1:] > number[:-1]
        further[last[:-1]] = False  # the next segment begins there
        starts = np.sort(np.concatenate([first, np.flatnonzero(further) + 1]))
        ends = np.append(starts[1:], self.begin[-1])
        free = np.isin(ends, self.begin[1:])
        self.blocks = _Blocks(starts, np.where(free, ends - 1, ends), free.astype(np.int64))
        self.divided = True

    def _clock(self, square: Array) -> tuple[Array, Array, Index]:
        n_block = self.blocks.first.size
        time, duration, count = np.empty_like(square), np.empty(n_block), np.zeros(n_block, dtype=np.int64)
        kernels.clock(self.place[0], square, *self.blocks, self.period / STEPS, time, duration, count)
        return time, duration, count

    def spans(self, square: Array) -> tuple[Array, Index]:
        """Turn v^2 at the samples into spans; return them and the first span of each segment."""
        return self._averaged(square) if self.period > 0.0 else self._plain(square)

    def duration(self) -> float:
        """Return the duration of all motions before any correction [s]."""
        square = self.square()
        return int(self._grid(square)[-1][-1]) * self.period / STEPS if self.period > 0.0 else float(self._plain(square)[0][:, 0].sum())

    def _plain(self, square: Array) -> tuple[Array, Index]:
        """Return spans of constant acceleration, one for each interval, and the first span of each segment."""
        speed, step = np.sqrt(square), np.diff(self.place[0])
        moves = (step > 0.0) & (speed[1:] + speed[:-1] > 0.0)
        moves[self.begin[1:-1] - 1] = False
        duration = 2.0 * step[moves] / (speed[1:] + speed[:-1])[moves]
        acceleration = np.diff(square)[moves] / (2.0 * step[moves])
        spans = [duration, self.place[0][:-1][moves], speed[:-1][moves], acceleration, np.zeros_like(acceleration)]
        return np.stack(spans, axis=-1), np.append(0, np.cumsum(moves))[np.append(self.begin[:-1], moves.size)]

    def _grid(self, square: Array) -> tuple[Array, Array, Index, Index, Index]:
        """Lay a grid of time steps over the blocks of all segments.

        Returns
        -------
        time : ndarray (n,)
            At the samples, from the start of the block.
        duration, first, n_step : ndarray (n_block,)
            Duration of each block, its first step, and its number of steps.
        begin : ndarray (n_segment + 1,)
            First step of each segment.
        """
        if not self.divided:
            self.divide(square)
        time, duration, count = self._clock(square)
        first_block = np.searchsorted(self.blocks.first, self.begin[:-1])
        # Zeros after each segment keep its averages out of the next.
        begin = np.append(0, np.cumsum(np.add.reduceat(count, first_block) + STEPS + 1))
        shift = np.repeat((STEPS + 1) * np.arange(first_block.size), np.diff(np.append(first_block, count.size)))
        return time, duration, np.cumsum(count) - count + shift, count, begin

    def _averaged(self, square: Array) -> tuple[Array, Index]:
        """Return spans of constant jerk, one for each time step, and the first span of each segment."""
        time, *steps, begin = self._grid(square)
        h, arc_length, blocks = self.period / STEPS, self.place[0], self.blocks
        mean, spans = np.zeros(int(begin[-1])), np.empty((int(begin[-1]), 5))
        kernels.steps(arc_length, square, time, blocks.first, blocks.last, *steps, h, mean)
        kernels.averaged(mean, begin, arc_length[self.begin[:-1]], arc_length[self.begin[1:] - 1], STEPS, h, spans)
        return spans, begin


def _check_on_path(planner: _Planner, spans: Array, begin: Index) -> tuple[Array, Array]:
    """Check like `_Planner.check`, with the derivatives of the path instead of those of the samples."""
    samples, segment, peak = planner.samples, np.repeat(np.arange(begin.size - 1), np.diff(begin)), np.zeros(begin.size - 1)
    at, reached, of, (time, place) = np.array([0, 0, CHUNK]), np.zeros(1), np.empty(CHUNK, dtype=np.int64), np.empty((2, CHUNK))
    faults, rows, worst = [np.empty((0, 7))], np.empty((CHUNK, 6)), np.empty(4)
    while at[2] == CHUNK:
        kernels.walk(planner.place[0], planner.flags, spans, ON_PATH, at, reached, of, time, place)
        here = of[: at[2]]
        derivatives = np.ascontiguousarray(planner.path.derivatives(place[: here.size], 3).transpose(0, 2, 1))
        kernels.needed(spans, here, time, place, derivatives, *planner.inverse, worst, rows)
        of_row = segment[here[np.diff(here, prepend=-1) > 0]]
        found = rows[: of_row.size]
        most = across(np.maximum, found[:, 2:5])
        np.maximum.at(peak, of_row, most)
        bad = np.flatnonzero(most > 1.0 + CLOSE)
        before = np.searchsorted(samples.arc_length, found[bad, 0], side="right") - 1
        before = np.clip(before, samples.begin[of_row[bad]], samples.begin[of_row[bad] + 1] - 2)
        faults.append(np.column_stack([before, found[bad]]))
    return peak, np.concatenate(faults)


def _corrected(planner: _Planner) -> SmoothMotion:
    """Lower the limits around violations until none is left, in at most `ROUNDS` rounds."""
    faults = np.empty((0, 7))
    for round_ in range(ROUNDS):
        spans, begin = planner.spans(planner.square())
        changed = planner.changed(faults) if round_ else np.ones_like(planner.flags)
        planner.flags |= changed * STALE
        peak, faults = planner.check(spans, begin, changed)
        del changed  # long routes need the memory
        if len(faults) == 0 or round_ == ROUNDS - 1:
            # The check at the samples is cheap; the check on the path itself decides. What has not changed has passed both before.
            by_path, more = _check_on_path(planner, spans, begin)
            peak, faults = np.maximum(peak, by_path), np.concatenate([faults, more])
            if len(faults) == 0:
                break
            planner.flags &= ~STALE
        planner.lower(faults, 1.0 + round_ / HASTE)
    return SmoothMotion(spans, begin, peak <= 1.0 + CLOSE)


def smooth_motions(path: Path, samples: SegmentSamples, limits: AxisLimits) -> list[SmoothMotion]:
    """Plan segments from rest to rest, once for each averaging period; return nothing if an axis has no acceleration limit.

    Parameters
    ----------
    limits : AxisLimits
        For the path's number of axes.
    """
    if not np.all(np.isfinite(limits.acceleration)):
        return []
    unit = float(np.max(limits.acceleration / limits.jerk))
    fastest = np.maximum(np.minimum(samples.ceiling, float(np.linalg.norm(limits.velocity))), 1e-12)
    least_time = float(np.sum(np.diff(samples.arc_length) / np.minimum(fastest[1:], fastest[:-1])))
    shortest = STEPS * least_time / (MOST_SPANS[0] * samples.arc_length.size + MOST_SPANS[1])
    # Without a jerk limit, a short average is still better where the plain motion needs corrections.
    periods = sorted({max(part * unit, shortest) for part in PERIODS}) if unit > 0.0 else [0.0, shortest]
    groups, n_tried = _groups(samples), 3 - int(np.searchsorted(MANY, samples.arc_length.size))
    threads = None if samples.arc_length.size > FEW else 1

    def planned(group: SegmentSamples) -> list[SmoothMotion]:
        ceiling = {steady: group.speed_ceiling(limits, steady=steady) for steady in {period > 0.0 for period in periods}}

        def planner(period: float) -> _Planner:
            return _Planner(path, group, ceiling[period > 0.0], limits, period)

        chosen = _promising(planner, periods, n_tried) if n_tried < 3 else list(map(planner, periods))
        return in_threads(_corrected, chosen, threads if len(groups) == 1 else 1)

    return [_joined(list(motions)) for motions in zip(*in_threads(planned, groups, threads), strict=True)]


def _promising(planner: Callable[[float], _Planner], periods: list[float], most: int) -> list[_Planner]:
    """Return planners of the periods with the shortest durations before corrections; the duration has one minimum over the period."""
    held: list[tuple[float, _Planner]] = []

    def tried(period: float) -> float:
        one = planner(period)
        held.append((one.duration(), one))
        duration = held[-1][0]
        held.sort(key=lambda pair: pair[0])
        del held[most:]  # each needs much memory
        return duration

    middle = (len(periods) - 1) // 3
    least = tried(periods[middle])
    for way in (periods[:middle][::-1], periods[middle + 1 :]):
        before = least
        for period in way:
            before, last = tried(period), before
            if before >= last:
                break
    return [one for _, one in held]


def _groups(samples: SegmentSamples) -> list[SegmentSamples]:
    """Divide samples between segments into groups that are planned one by one: their arrays stay in the processor's cache."""
    begin = samples.begin
    edges = np.unique(np.append(np.searchsorted(begin, np.arange(0, begin[-1], GROUP)), begin.size - 1))
    pairs = pairwise(edges.tolist())
    return [SegmentSamples._make([*(part[begin[a] : begin[b]] for part in samples[:5]), begin[a : b + 1] - begin[a]]) for a, b in pairs]


def _joined(motions: list[SmoothMotion]) -> SmoothMotion:
    """Return the motions of successive groups of segments as one."""
    spans, begin, good = zip(*motions, strict=True)
    shift = np.cumsum([0, *map(len, spans)])
    starts = [part[:-1] + offset for part, offset in zip(begin, shift, strict=False)]
    return SmoothMotion(np.concatenate(spans), np.append(np.concatenate(starts), shift[-1]), np.concatenate(good))
