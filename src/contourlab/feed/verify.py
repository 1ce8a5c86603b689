"""Check a reference against the axis limits, independently of any planner.

The check uses only position samples and their differences over the servo period, so it applies to planned, imported and measured
references. Differences are weighted means of the derivatives over the samples they span, so they never exceed the true peak.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from itertools import chain
from typing import NamedTuple

import numpy as np

from contourlab.arrays import Array, Flags, Index, ranges
from contourlab.feed.bounds import AxisLimits
from contourlab.feed.reference import Reference
from contourlab.feed.route import KINK_TIME, MOST_KINK, curvature_jump, direction_jump
from contourlab.geometry import Path


@dataclass(frozen=True)
class Worst:
    """The largest value of one axis, its limit, and where it occurs.

    Parameters
    ----------
    axis : int
    value, limit : float [m/s, m/s^2 or m/s^3]
    allowance : float [m/s, m/s^2 or m/s^3]
        Part of `value` due to rounded positions.
    sample : int
        -1 if no sample counts.
    time : float [s]
    position : tuple of float [m]
    source_line : int
        Program line; 0 for none.
    """

    axis: int
    value: float
    limit: float
    allowance: float = 0.0
    sample: int = -1
    time: float = 0.0
    position: tuple[float, ...] = ()
    source_line: int = 0

    @property
    def ratio(self) -> float:
        """(value - allowance) / limit; above 1 the limit is violated."""
        return max(self.value - self.allowance, 0.0) / self.limit


class CurvatureSteps(NamedTuple):
    """Steps of acceleration where the curvature jumps, in order of time.

    Attributes
    ----------
    sample : ndarray (n,) of int
        The last sample before each step.
    size : ndarray (n, n_axis) [m/s^2]
    """

    sample: Index
    size: Array


@dataclass(frozen=True)
class LimitReport:
    """The largest values, one `Worst` per axis.

    Parameters
    ----------
    velocity, acceleration, jerk : tuple of Worst
        Acceleration without kinks, jerk without kinks and curvature steps.
    curvature_step : tuple of Worst
        Steps of acceleration where the curvature jumps (line to arc), compared with the acceleration limit, because no finite jerk limit
        can hold there without a stop. Without a jerk limit this limit is inf.
    kink : tuple of Worst
        Steps of velocity [m/s] where the direction jumps by up to `contourlab.feed.route.MOST_KINK`, compared with the acceleration
        limit times `KINK_TIME`. A control that rounds no corner passes kinks of any angle, and has no such limit.
    n_kink : int
        Number of kinks passed.
    steps : CurvatureSteps or None
        All curvature steps passed; None stands for no steps.
    """

    velocity: tuple[Worst, ...]
    acceleration: tuple[Worst, ...]
    jerk: tuple[Worst, ...]
    curvature_step: tuple[Worst, ...]
    kink: tuple[Worst, ...]
    n_kink: int = 0
    steps: CurvatureSteps | None = field(default=None, compare=False, repr=False)

    def ok(self, tolerance: float = 0.005) -> bool:
        """Return whether every limit holds within `tolerance`, a fraction of the limit >= 0."""
        return all(worst.ratio <= 1.0 + tolerance for worst in self.all())

    def jerk_peaks(self, axis: int, servo_period: float) -> CurvatureSteps:
        """Return the curvature steps at which the jerk of an axis, over a servo period [s], exceeds its limit: `size` is (n,)."""
        if self.steps is None:
            return CurvatureSteps(np.zeros(0, dtype=np.int64), np.zeros(0))
        sample, size = self.steps.sample, self.steps.size[:, axis]
        kept = size > self.jerk[axis].limit * servo_period
        return CurvatureSteps(sample[kept], size[kept])

    @property
    def kinds(self) -> tuple[tuple[Worst, ...], ...]:
        """The entries of each kind, in the order of `KINDS`."""
        return self.velocity, self.acceleration, self.jerk, self.curvature_step, self.kink

    def all(self) -> tuple[Worst, ...]:
        """Return every entry: velocity, acceleration, jerk, curvature step, kink."""
        return tuple(chain(*self.kinds))


KINDS = ("velocity", "acceleration", "jerk", "curvature step", "kink")
"""Kinds of entries of a `LimitReport`, in the order of `LineUse.kind`."""


class LineUse:
    """How much of the limits each program line uses.

    Attributes
    ----------
    ratio : ndarray (n_line,)
        Largest ratio of the line (the index; 0 for none), as `Worst.ratio`; nan for a line without samples.
    kind, axis, sample : ndarray (n_line,) of int
        Where it occurs: index in `KINDS`, axis, sample.
    """

    def __init__(self, n_line: int) -> None:
        self.ratio = np.full(n_line, np.nan)
        self.kind, self.axis, self.sample = (np.full(n_line, -1, dtype=np.int64) for _ in range(3))

    def add(self, kind: int, ratios: Array, samples: Index, lines: Index) -> None:
        """Add ratios (n, n_axis) of one kind at `samples` (n,) of program `lines` (n,)."""
        axis = np.argmax(ratios, axis=1)
        ratio = ratios[np.arange(len(axis)), axis]
        better = np.flatnonzero(~(ratio <= self.ratio[lines]))
        better = better[np.argsort(ratio[better], kind="stable")]  # the last of a line stays
        at = lines[better]
        self.ratio[at], self.kind[at], self.axis[at], self.sample[at] = ratio[better], kind, axis[better], samples[better]


class _Jumps(NamedTuple):
    """Arc lengths (n,) in [0, length) at which direction or curvature jumps, and by how much for each axis (n, n_axis)."""

    place: Array
    size: Array
    length: float

    def passed(self, arc_length: Array) -> Index:
        """Return the number of jumps up to each progress, laps included."""
        laps = np.floor(arc_length / self.length)
        within = np.searchsorted(self.place, arc_length - laps * self.length, side="right")
        return np.asarray(within + laps * self.place.size, dtype=np.int64)

    def first(self, before: Index, after: Index) -> Array:
        """Return the arc length (m,) of the first jump between two different numbers of jumps passed (m,)."""
        low = np.minimum(before, after)
        return np.asarray(self.place[low % self.place.size] + low // self.place.size * self.length)

    def largest(self, before: Index, after: Index) -> Array:
        """Return the largest jumps (m, n_axis) between two different numbers of jumps passed (m,)."""
        low, count = np.minimum(before, after), np.abs(after - before)
        return np.asarray(np.maximum.reduceat(self.size[ranges(low, count) % self.place.size], np.cumsum(count) - count))


def _jumps(path: Path, step: Array, counted: Flags) -> _Jumps:
    """Select the `counted` jumps at the ends of the curves (n_curve, n_axis)."""
    at_start = np.roll(counted, 1)
    place = np.asarray(path.breaks, dtype=np.float64)[:-1][at_start]
    return _Jumps(place, np.abs(np.roll(step, 1, axis=0)[at_start]), float(path.length))


@dataclass
class _Record:
    """The largest values of one kind so far, for each axis."""

    limit: Array
    allowance: Array
    kind: int = 0
    use: LineUse | None = None
    value: Array = field(init=False)
    sample: Index = field(init=False)

    def __post_init__(self) -> None:
        self.value = np.zeros_like(self.limit)
        self.sample = np.full(self.limit.size, -1, dtype=np.int64)

    def add(self, values: Array, samples: Index, lines: Index | None = None) -> None:
        """Add values (n, n_axis) at `samples` (n,) of program `lines` (n,)."""
        if values.shape[0] == 0:
            return
        if self.use is not None and lines is not None:
            self.use.add(self.kind, np.maximum(values - self.allowance, 0.0) / self.limit, samples, lines)
        row = np.argmax(values, axis=0)
        peak = values[row, np.arange(values.shape[1])]
        better = (peak > self.value) | (self.sample < 0)
        self.value = np.where(better, peak, self.value)
        self.sample = np.where(better, samples[row], self.sample)

    def located(self, reference: Reference) -> tuple[Worst, ...]:
        """Return the largest value of each axis with its place."""
        entries = []
        for axis, (value, sample) in enumerate(zip(self.value.tolist(), self.sample.tolist(), strict=True)):
            worst = Worst(axis, value, float(self.limit[axis]), float(self.allowance[axis]))
            if sample >= 0:
                block = reference.block(sample, sample + 1)
                place, line = tuple(block.position[0].tolist()), int(reference.source_line(block.arc_length)[0])
                worst = replace(worst, sample=sample, time=sample * reference.servo_period, position=place, source_line=line)
            entries.append(worst)
        return tuple(entries)


def limit_report(reference: Reference, limits: AxisLimits) -> LimitReport:
    """Find the largest velocity, acceleration and jerk of each axis.

    Parameters
    ----------
    reference : Reference
        Read in blocks, so that memory does not grow with its length.
    limits : AxisLimits

    Returns
    -------
    LimitReport

    Raises
    ------
    FeedError
        If the limits have a different number of axes.

    Notes
    -----
    Sample k labels the differences p[k+1] - p[k], p[k+1] - 2 p[k] + p[k-1] and p[k+2] - 3 p[k+1] + 3 p[k] - p[k-1].
    A curvature step between k and k+1 is the jump of the curvature times v^2; or, if that is more, the second difference at
    k+2 less the one at k-1, the nearest that do not span it, less three servo periods of permitted jerk. At a kink the velocity step of an
    axis is the direction jump times a speed: the lowest speed at the samples around, less half a servo period of the largest acceleration
    limit. Recorded references know their progress only to about a sample, so one more sample on each side is left out, and the
    speed at a curvature step is the lowest around.
    """
    return _report(reference, limits, None)


def limit_report_by_line(reference: Reference, limits: AxisLimits) -> tuple[LimitReport, LineUse]:
    """Return the report of `limit_report`, and how much of the limits each program line uses."""
    use = LineUse(int(reference.source_lines.max(initial=0)) + 1)
    return _report(reference, limits, use), use


def _report(reference: Reference, limits: AxisLimits, use: LineUse | None) -> LimitReport:
    limits = limits.for_axes(reference.n_axis)
    period, wide = reference.servo_period, 0 if reference.recorded is None else 1
    ends = reference.block(0, 1), reference.block(reference.n_sample - 1, reference.n_sample)
    extent = max(float(np.max(np.abs(end.position))) + float(end.arc_length[0]) for end in ends) + reference.path.length
    noise = 2.0 * np.finfo(float).eps * extent * np.ones(limits.n_axis)
    eased = limits.jerk * period * (3 + 2 * wide)
    step_limit = np.where(np.isinf(limits.jerk), np.inf, limits.acceleration)
    kinds = {
        "velocity": (limits.velocity, noise / period),
        "acceleration": (limits.acceleration, 2.0 * noise / period**2),
        "jerk": (limits.jerk, 4.0 * noise / period**3),
        "curvature_step": (step_limit, 4.0 * noise / period**2),
        "kink": (limits.acceleration * (KINK_TIME if limits.planner is None else np.inf), MOST_KINK * noise / period),
    }
    records = {name: _Record(*about, kind, use) for kind, (name, about) in enumerate(kinds.items())}
    path, curvature, direction = reference.path, curvature_jump(reference.path), direction_jump(reference.path)
    angle = np.linalg.norm(direction, axis=1)
    bends = _jumps(path, curvature, np.any(curvature != 0.0, axis=1))
    kinks = _jumps(path, direction, (angle > 0.0) & ((angle <= MOST_KINK) | (limits.planner is not None)))
    n_kink, steps = 0, []
    for start, stop in reference.blocks():
        passed, kinked = _check_block(reference, start, stop, records, bends, kinks, eased, wide)
        n_kink += kinked
        steps.append(passed)
    samples, sizes = (np.concatenate(column) for column in zip(*steps, strict=True))
    located = {name: record.located(reference) for name, record in records.items()}
    return LimitReport(**located, n_kink=n_kink, steps=CurvatureSteps(samples, sizes))


def _check_block(
    reference: Reference, start: int, stop: int, records: Mapping[str, _Record], bends: _Jumps, kinks: _Jumps, eased: Array, wide: int
) -> tuple[CurvatureSteps, int]:
    """Add the samples [start, stop), and the neighbours they need, to the records; return the curvature steps and the number of kinks."""
    margin = 4 + wide
    low, high = max(start - margin, 0), min(stop + margin, reference.n_sample)
    block = reference.block(low, high)
    period = reference.servo_period
    velocity = np.diff(block.position, axis=0) / period  # row i: samples low + i and the next
    acceleration = np.diff(velocity, axis=0) / period  # row i: centred at low + i + 1
    jerk = np.diff(acceleration, axis=0) / period  # row i: from low + i to low + i + 3
    index, n_kink, n_bend = np.arange(low, high), kinks.passed(block.arc_length), bends.passed(block.arc_length)
    n_jump = n_kink + n_bend

    def clear(passed: Index, order: int) -> Flags:
        """Return which differences of an order span no jump."""
        first = np.arange(index.size - order)
        return np.asarray(passed[np.clip(first - wide, 0, None)] == passed[np.clip(first + order + wide, None, index.size - 1)])

    lines = None if records["velocity"].use is None else reference.source_line(block.arc_length)

    def of(rows: Index | Flags, first: int = 0) -> Index | None:
        """Return the program lines of some rows, the first of which is sample `low + first`."""
        return None if lines is None else lines[first:][: len(rows)][rows] if rows.dtype == bool else lines[first + rows]

    records["velocity"].add(np.abs(velocity), index[:-1], of(np.arange(len(velocity))))
    smooth = clear(n_kink, 2)
    records["acceleration"].add(np.abs(acceleration[smooth]), index[1:-1][smooth], of(smooth, 1))
    smooth = clear(n_jump, 3)
    records["jerk"].add(np.abs(jerk[smooth]), index[1 : 1 + jerk.shape[0]][smooth], of(smooth, 1))
    around = np.linalg.norm(velocity, axis=1)
    # A step between rows i and i + 1 shows between the second differences centred at i + 2 + wide and i - 1 - wide.
    at = np.flatnonzero(np.diff(n_jump) != 0)
    at = at[(at - 2 - wide >= 0) & (at + 1 + wide < acceleration.shape[0])]
    size = np.maximum(np.abs(acceleration[at + 1 + wide] - acceleration[at - 2 - wide]) - eased, 0.0)
    bend = n_bend[at] != n_bend[at + 1]
    row = at[bend]
    # The jump of the curvature times v^2 between the samples of each row and the next.
    passed = n_bend[row], n_bend[row + 1]
    speed = _speed_at(bends.first(*passed), row, around, block.arc_length, wide)
    size[bend] = np.maximum(size[bend], bends.largest(*passed) * speed[:, None] ** 2)
    records["curvature_step"].add(size, index[at], of(at))
    # Row k spans a kink between the samples k and k + 1.
    turn = np.flatnonzero(np.diff(n_kink) != 0)
    turn = turn[(turn - 1 - wide >= 0) & (turn + 1 + wide < velocity.shape[0])]
    if turn.size:
        slowest = np.maximum(_lowest(around, turn, wide) - 0.5 * period * float(np.max(records["acceleration"].limit)), 0.0)
        records["kink"].add(kinks.largest(n_kink[turn], n_kink[turn + 1]) * slowest[:, None], index[turn], of(turn))
    here = (index[row] >= start) & (index[row] < stop)
    n_turn = int(np.count_nonzero((index[turn] >= start) & (index[turn] < stop)))
    return CurvatureSteps(index[row[here]], size[bend][here]), n_turn


def _lowest(around: Array, row: Index, wide: int) -> Array:
    """Return the lowest speed between the samples around those of each row (m,)."""
    return np.asarray(np.min([around[row + i] for i in range(-1 - wide, 2 + wide)], axis=0))


def _speed_at(place: Array, row: Index, around: Array, arc_length: Array, wide: int) -> Array:
    """Return the speed at places (m,) between the samples of each row (m,) and the next: the lowest of three linear estimates."""
    if wide:
        return _lowest(around, row, wide)
    part = (place - arc_length[row]) / (arc_length[row + 1] - arc_length[row])
    middle = around[row] + (part - 0.5) * 0.5 * (around[row + 1] - around[row - 1])
    left = around[row - 1] + (0.5 + part) * (around[row - 1] - around[row - 2])
    right = around[row + 1] - (1.5 - part) * (around[row + 2] - around[row + 1])
    return np.maximum(np.minimum(middle, np.minimum(left, right)), 0.0)
