"""Feed along stretches that are not straight: near the least time, with limited jerk.

For many stretches at once, each from rest to rest:

1. `reach` finds the fastest v^2 by arc length under the axes' accelerations, with their signs (the method of reachable sets: Pham and
   Pham, "A new approach to time-optimal path parameterization based on reachability analysis", IEEE Transactions on Robotics 34(3),
   2018). The jerk enters as a third family of limits, linear in the acceleration and in v^2: |t| a/T + 3 |k| v a + |c| v^3 <= J.
2. The motion is averaged over the time T: its steps within T/`STEPS` each are averaged over `STEPS` neighbours and made the
   coefficients of a cubic B-spline. That keeps the length, bounds the acceleration, and has constant jerk in each span. So that the
   average keeps to the ceiling of the speed, each narrow of it is widened beforehand by what the average takes in there; and each
   summit of the speed is cut off where it lasts T, so that the acceleration can change its sign.
3. The result is held against the true limits in every span and at every sample. Around a place where it breaks one, the limits used in
   step 1 are lowered, and all is done again; what lies elsewhere does not change. A final check evaluates the path itself.

Only a stretch that has passed step 3 is handed back. Every step is linear in the number of samples.
"""

from __future__ import annotations

import math
from functools import cache
from types import SimpleNamespace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from contourlab.feed.kernels import LOWERED, MOVED
from contourlab.feed.limits import AxisLimits
from contourlab.feed.segments import Samples
from contourlab.geometry import Path

Array = NDArray[np.float64]
Index = NDArray[np.intp]

PERIODS = (1.0, 0.7, 0.5, 0.35, 0.25)  # T tried, in units of A/J: at 1 the acceleration may rise to its limit within T
STEPS = 4  # of the time grid in T
ROUNDING = 1e-6  # of a limit
CLOSE = 1e-3  # of a limit: what the path may show between the samples
ROUNDS = 60  # corrections at most
BEND = 4000.0  # slowing down by a step accelerates by 6 v h/D^2: D is as long as keeps that below 6/BEND of the limit
BLOCK = 50  # periods in a part of a stretch that keeps a time grid of its own; it is slowed down by half a step at an average
HASTE = 2.5  # rounds after which a correction counts twice, then three times: what is left is stubborn
PER_SPAN = 4  # places checked in each span, besides the samples ...
PER_SPAN_MOST = 24  # ... or at which the path is evaluated, where spans hold many samples
MOST_SPANS = (8, 10_000)  # a sample, and besides: where the jerk is plentiful, T is no shorter than this gives
MANY = (5_000, 200_000)  # samples above which only the two, and the one, most likely periods are tried
CHUNK = 32_768  # places per pass


class Shaped(NamedTuple):
    """Motions of several stretches.

    spans : ndarray (n_span, 5)
        Duration, arc length, speed, acceleration at the start of each span; its jerk.
    begin : ndarray (n_stretch + 1,) of int
        First span of each stretch.
    good : ndarray (n_stretch,) of bool
        Whether the motion of the stretch keeps to the limits.
    """

    spans: Array
    begin: Index
    good: NDArray[np.bool_]

    @property
    def duration(self) -> Array:
        """Time that each stretch takes [s]."""
        return np.asarray(np.add.reduceat(self.spans[:, 0], self.begin[:-1]))


@cache
def _kernels() -> SimpleNamespace:
    """Return the compiled recursions of `kernels` and `speed_profile`, by name."""
    from contourlab.feed import kernels, speed_profile
    from contourlab.native.compile import kernel  # the compiler is loaded when something is planned

    f, m, i = "f8[:]", "f8[:,:]", "i8[:]"
    signatures = {
        kernels.reach: [f, m, m, m, f, f, f, f, f, f, "f8", f, f, f, f, i],
        kernels.spread: [f, f, "f8", f, i],
        kernels.flatten: [f, f, "f8", f],
        speed_profile.demand: [f, m, m, m, f, i, m, i, f, f, f, "i8", "f8", i, "f8[:,:,:]", f, f, m, i],
        speed_profile.clock: [f, f, i, i, i, "f8", f, f, i],
        speed_profile.steps: [f, f, f, i, i, f, i, i, "f8", f],
        kernels.lower: [f, m, m, "f8", "f8", f, m, i],
    }
    return SimpleNamespace(**{step.__name__: kernel(step, " ".join(types)) for step, types in signatures.items()})


class _Blocks(NamedTuple):
    """First and last sample of each block, and whether it may end within a step (n_block,)."""

    first: NDArray[np.int64]
    last: NDArray[np.int64]
    free: NDArray[np.int64]


class _Grid(NamedTuple):
    """Steps in time: time at the samples (n,); of each block (n_block,) the time, how many steps, the first; first step of each stretch."""

    time: Array
    lasting: Array
    steps: NDArray[np.int64]
    leading: NDArray[np.int64]
    begin: Index

    @property
    def n_step(self) -> int:
        return int(self.begin[-1])


class _Memory(NamedTuple):
    """What the kernel `reach` keeps from call to call; arrays (n,)."""

    reference: Array
    ceiling: Array
    behind: Array
    square: Array


def _memory(n: int, *, apart: bool) -> _Memory:
    """Return the memory of a first call; `apart` where the ceiling is not the reference as well."""
    reference = np.full(n, np.nan)
    return _Memory(reference, np.full(n, np.nan) if apart else reference, np.full(n, np.nan), np.full(n, np.nan))


class _Planner:
    """Arrays that the rounds of one period share; `parts` are those of the limits that may be used at each sample:

    of the acceleration, of the jerk for changes of the tangential acceleration, of the speed. There are tens of samples to a line of a
    program: these arrays limit the length of a program, so each has its reason, and intermediate arrays are freed early.
    """

    def __init__(self, path: Path, samples: Samples, limits: AxisLimits, period: float) -> None:
        n = samples.arc_length.size
        self.run = _kernels()
        self.path, self.samples, self.period = path, samples, period
        self.velocity, self.acceleration, self.jerk = (np.array(part) for part in (limits.velocity, limits.acceleration, limits.jerk))
        self.inverse = tuple(1.0 / part for part in (self.velocity, self.acceleration, self.jerk))
        self.place = tuple(np.ascontiguousarray(part) for part in (samples.arc_length, samples.tangent, samples.second, samples.third))
        self.base = samples.speed_ceiling(limits, held=period > 0.0)
        self.begin = samples.begin.astype(np.int64)
        self.flags = np.zeros(n, dtype=np.int64)
        self.half = 0.5 * period * (STEPS + 2) / STEPS  # what the average takes in on either side
        self.parts = np.ones((3, n))
        self.first = _memory(n, apart=False)
        self.second = _memory(n, apart=True) if period > 0.0 else self.first
        first, last = self.begin[:-1], self.begin[1:] - 1
        self.blocks = _Blocks(first, last, np.ones_like(first))  # whole stretches, until `divide`
        self.divided = False

    def square(self) -> Array:
        """Return v^2 at the samples."""
        ceiling = self.base * self.parts[2]
        if self.period == 0.0:
            self._reach(ceiling, ceiling, self.first)
        else:
            wide = np.empty_like(ceiling)
            self.run.spread(self.place[0], ceiling, self.half, wide, np.empty(ceiling.size, dtype=np.int64))
            self._reach(wide, wide, self.first)
            speed = np.sqrt(self.first.square, out=ceiling)
            self.run.flatten(self.place[0], speed, self.period * (STEPS + 1) / STEPS, wide)
            # The second time the shares of the jerk are reckoned at nearly the speed that is driven.
            speed *= 1.05
            speed += 1e-9
            self._reach(np.minimum(wide, speed, out=speed), wide, self.second)
        self.flags &= ~LOWERED
        return self.second.square

    def _reach(self, reference: Array, ceiling: Array, memory: _Memory) -> None:
        limits = self.acceleration, self.jerk, self.period
        self.run.reach(*self.place, self.parts[0], self.parts[1], reference, ceiling, *limits, *memory, self.flags)

    def look(self, spans: Array, begin: Index, watched: NDArray[np.int64]) -> tuple[Array, Array]:
        """Return the greatest demand of each stretch as a part of the limits, and the faults, as the kernel `demand` does."""
        peak, faults = np.empty(begin.size - 1), np.empty((len(spans), 7))
        here, worst = np.empty((3, 1, self.velocity.size)), np.empty(4)
        count = np.zeros(1, dtype=np.int64)
        where = *self.place, self.samples.ceiling, self.begin, spans, begin.astype(np.int64)
        self.run.demand(*where, *self.inverse, PER_SPAN, 1.0 + ROUNDING, watched, here, worst, peak, faults, count)
        return peak, faults[: int(count[0])]

    def changed(self, faults: Array) -> NDArray[np.int64]:
        """Return the samples to check: blocks that have changed or had faults, and their neighbours."""
        different = self.flags & MOVED != 0
        different[faults[:, 0].astype(np.intp)] = True
        # A block's last sample is the next one's first; each block is checked with its neighbours.
        edges = np.append(self.blocks.first, different.size)
        blocks = np.add.reduceat(different, edges[:-1]) > 0
        ends = different[self.blocks.last]
        blocks |= ends
        near = blocks.astype(np.int64)
        near[1:] |= blocks[:-1]
        near[:-1] |= blocks[1:]
        return np.repeat(near, np.diff(edges))

    def lower(self, faults: Array, haste: float) -> None:
        """Lower the limits of the samples that the average at each fault takes in."""
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
        self.run.lower(self.place[0], np.ascontiguousarray(faults), np.stack(factors), self.half, haste, low, self.parts, self.flags)

    def divide(self, square: Array) -> None:
        """Divide the stretches into blocks of about `BLOCK` periods, each of a whole number of steps.

        A correction in one block then leaves the time grid of the others unchanged, and they need no new check.
        """
        first, last = self.blocks.first, self.blocks.last
        time, lasting, _ = self._clock(square, self.blocks)
        fastest = math.sqrt(float(square.max()))
        size = max(BLOCK * self.period, np.sqrt(BEND * fastest * self.period / STEPS / float(self.acceleration.min())))
        number = np.floor(np.divide(time, size, out=time), out=time)
        # The last block of a stretch is a long one, not a short one; its time is not that of its last sample.
        most = np.maximum(np.floor(lasting / size) - 1.0, 0.0)
        np.minimum(number, np.repeat(most, np.diff(self.begin)), out=number)
        number[last] = number[np.maximum(last - 1, 0)]
        further = number[1:] > number[:-1]
        further[last[:-1]] = False  # there another stretch begins
        border = np.flatnonzero(further) + 1
        starts = np.sort(np.concatenate([first, border]))
        ends = np.append(starts[1:], self.begin[-1])
        free = np.isin(ends, self.begin[1:])
        self.blocks = _Blocks(starts, np.where(free, ends - 1, ends), free.astype(np.int64))
        self.divided = True

    def _clock(self, square: Array, blocks: _Blocks) -> tuple[Array, Array, NDArray[np.int64]]:
        time, lasting, count = np.empty_like(square), np.empty(blocks.first.size), np.zeros(blocks.first.size, dtype=np.int64)
        self.run.clock(self.place[0], square, *blocks, self.period / STEPS, time, lasting, count)
        return time, lasting, count

    def spans(self, square: Array) -> tuple[Array, Index]:
        """Turn v^2 at the samples into spans; return them and the first of each stretch."""
        return self._averaged(square) if self.period > 0.0 else self._plain(square)

    def duration(self) -> float:
        """Return the time that all the motions take before any correction [s]."""
        square = self.square()
        return self._grid(square).n_step * self.period / STEPS if self.period > 0.0 else float(self._plain(square)[0][:, 0].sum())

    def _plain(self, square: Array) -> tuple[Array, Index]:
        """Return spans of constant acceleration, one for each interval."""
        speed, step = np.sqrt(square), np.diff(self.place[0])
        moves = (step > 0.0) & (speed[1:] + speed[:-1] > 0.0)
        moves[self.begin[1:-1] - 1] = False
        lasting = 2.0 * step[moves] / (speed[1:] + speed[:-1])[moves]
        acceleration = np.diff(square)[moves] / (2.0 * step[moves])
        none = np.zeros_like(acceleration)
        spans = np.stack([lasting, self.place[0][:-1][moves], speed[:-1][moves], acceleration, none], axis=-1)
        return spans, np.append(0, np.cumsum(moves))[np.append(self.begin[:-1], moves.size)]

    def _grid(self, square: Array) -> _Grid:
        """Lay the time grid of steps over the blocks of all stretches."""
        if not self.divided:
            self.divide(square)
        time, lasting, count = self._clock(square, self.blocks)
        leading = np.searchsorted(self.blocks.first, self.begin[:-1])
        # Steps of each stretch, and behind them zeros enough that no average reaches into the next.
        begin = np.append(0, np.cumsum(np.add.reduceat(count, leading) + STEPS + 1))
        shift = np.repeat((STEPS + 1) * np.arange(leading.size), np.diff(np.append(leading, count.size)))
        return _Grid(time, lasting, count, np.cumsum(count) - count + shift, begin)

    def _averaged(self, square: Array) -> tuple[Array, Index]:
        """Return spans of constant jerk, each a part of the period long."""
        grid = self._grid(square)
        h, arc_length, blocks = self.period / STEPS, self.place[0], self.blocks
        first, last, begin = self.begin[:-1], self.begin[1:] - 1, grid.begin
        mean = np.zeros(grid.n_step)
        self.run.steps(arc_length, square, grid.time, blocks.first, blocks.last, grid.lasting, grid.leading, grid.steps, h, mean)
        del grid
        padded = np.concatenate([np.zeros(STEPS + 1), mean])
        box = padded[2 : 2 + mean.size].copy()
        for k in range(1, STEPS):
            box += padded[k + 2 : k + 2 + mean.size]
        box = np.concatenate([[0.0, 0.0], box / STEPS])
        older, old, new = box[:-2], box[1:-1], box[2:]
        v0, a0, j = 0.5 * (older + old), (old - older) / h, (new - 2.0 * old + older) / h**2
        gone = np.append(0.0, np.cumsum(h * (v0 + h * (a0 / 2.0 + h * j / 6.0))))
        of_stretch = np.repeat(np.arange(first.size), np.diff(begin))
        s0 = np.minimum(arc_length[first][of_stretch] + (gone[:-1] - gone[begin[:-1]][of_stretch]), arc_length[last][of_stretch])
        return np.stack([np.full_like(v0, h), s0, v0, a0, j], axis=-1), begin


def _by_path(planner: _Planner, spans: Array, begin: Index) -> tuple[Array, Array]:
    """Return what `_Planner.look` does, by the derivatives of the path instead of those of the samples."""
    samples, stretch = planner.samples, np.repeat(np.arange(begin.size - 1), np.diff(begin))
    per_span = min(PER_SPAN + 2 * samples.arc_length.size // len(spans), PER_SPAN_MOST) if planner.period > 0.0 else 2 * PER_SPAN
    peak, faults = np.zeros(begin.size - 1), []
    inside = np.linspace(1e-9, 1.0 - 1e-9, per_span)
    limits = planner.velocity, planner.acceleration, planner.jerk
    rows = max(CHUNK // per_span, 1)
    for start in range(0, len(spans), rows):
        part = spans[start : start + rows]
        dt = (part[:, :1] * inside).ravel()
        s0, v0, a0, j = (np.repeat(column, per_span) for column in part[:, 1:].T)
        place = s0 + dt * (v0 + dt * (a0 / 2.0 + dt * j / 6.0))
        v, a = v0 + dt * (a0 + dt * j / 2.0), a0 + dt * j
        _, t, k, c = planner.path.derivatives(place, 3)
        turn = c * v[:, None] ** 3
        needed = t * v[:, None], t * a[:, None] + k * v[:, None] ** 2, t * j[:, None] + 3.0 * k * (v * a)[:, None] + turn
        ratio = np.stack([np.max(np.abs(value) / limit, axis=1) for value, limit in zip(needed, limits, strict=True)], axis=-1)
        ratio = np.concatenate([ratio, np.max(np.abs(turn) / planner.jerk, axis=1)[:, None]], axis=-1).reshape(-1, per_span, 4)
        worst = ratio[:, :, :3].max(axis=2)
        np.maximum.at(peak, stretch[start : start + rows], worst.max(axis=1))
        bad = np.flatnonzero(worst.max(axis=1) > 1.0 + CLOSE)
        if bad.size:
            at = bad * per_span + np.argmax(worst[bad], axis=1)
            i = np.searchsorted(samples.arc_length, place[at], side="right") - 1
            low, high = samples.begin[stretch[start + bad]], samples.begin[stretch[start + bad] + 1] - 2
            faults.append(np.column_stack([np.clip(i, low, high), place[at], v[at], ratio[bad].max(axis=1)]))
    return peak, np.concatenate(faults) if faults else np.empty((0, 7))


def _corrected(planner: _Planner) -> Shaped:
    """Lower the limits where the result breaks them, until it does not."""
    faults = np.empty((0, 7))
    for round_ in range(ROUNDS):
        square = planner.square()
        spans, begin = planner.spans(square)
        peak, faults = planner.look(spans, begin, planner.changed(faults))
        if len(faults) == 0 or round_ == ROUNDS - 1:
            # Good by the samples, which are cheap; the path itself decides.
            peak, faults = planner.look(spans, begin, np.ones_like(planner.flags))
            by_path, more = _by_path(planner, spans, begin)
            peak, faults = np.maximum(peak, by_path), np.concatenate([faults, more])
            if len(faults) == 0:
                break
        planner.lower(faults, 1.0 + round_ / HASTE)
    return Shaped(spans, begin, peak <= 1.0 + CLOSE)


def _least_time(samples: Samples, limits: AxisLimits) -> float:
    """Return a time that no motion can beat [s]."""
    fastest = np.maximum(np.minimum(samples.ceiling, float(np.linalg.norm(limits.velocity))), 1e-12)
    return float(np.sum(np.diff(samples.arc_length) / np.minimum(fastest[1:], fastest[:-1])))


def shaped(path: Path, samples: Samples, limits: AxisLimits) -> list[Shaped]:
    """Plan stretches from rest to rest, in several ways.

    Parameters
    ----------
    path : Path
    samples : Samples
    limits : AxisLimits
        For the path's number of axes. The jerk may be unlimited.

    Returns
    -------
    list of Shaped
        One for each period tried; none where an acceleration has no limit.
    """
    if not np.all(np.isfinite(limits.acceleration)):
        return []
    unit = float(np.max(limits.acceleration / limits.jerk))
    shortest = STEPS * _least_time(samples, limits) / (MOST_SPANS[0] * samples.arc_length.size + MOST_SPANS[1])
    # Without a limit of the jerk, a short average still wins where the plain motion would have to be corrected.
    periods = sorted({max(part * unit, shortest) for part in PERIODS}) if unit > 0.0 else [0.0, shortest]
    n_tried = 3 - int(np.searchsorted(MANY, samples.arc_length.size))
    if n_tried < 3 and len(periods) > n_tried:
        # The time before corrections shows well enough which periods are worth correcting.
        trials = [_Planner(path, samples, limits, period).duration() for period in periods]
        periods = [periods[k] for k in np.argsort(trials)[:n_tried]]
    return [_corrected(_Planner(path, samples, limits, period)) for period in periods]
