"""The independent judge of a reference: what each drive gets, against the limits of its axis.

It uses only position samples and their differences over the servo period. So it judges planned, imported and measured
references alike, and does not trust a planner's own derivatives. Differences are weighted means
of the derivatives over the samples they span, hence never above the true peak.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from contourlab.feed.junctions import KINK_TIME, MOST_KINK, curvature_jump, direction_jump
from contourlab.feed.limits import AxisLimits
from contourlab.feed.reference import Reference
from contourlab.geometry import Path

Array = NDArray[np.float64]

BLOCK = 65536  # samples per pass


@dataclass(frozen=True)
class Worst:
    """The place where one axis comes nearest to a limit, or goes furthest beyond it.

    Parameters
    ----------
    axis : int
    value, limit : float
        In m/s, m/s^2 or m/s^3.
    allowance : float
        What rounding of the positions, and for a curvature step the jerk that is allowed anyway, may add.
    sample : int
        -1 where there was nothing to look at.
    time : float [s]
    position : tuple of float [m]
    source_line : int
        0 where there is no program.
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
        """Value, less the allowance, as a part of the limit; above 1 the limit is broken."""
        return max(self.value - self.allowance, 0.0) / self.limit


@dataclass(frozen=True)
class LimitReport:
    """The worst of each kind, one `Worst` per axis.

    Parameters
    ----------
    velocity, acceleration, jerk : tuple of Worst
        The jerk without those places where the curvature of the path jumps.
    curvature_step : tuple of Worst
        Steps of acceleration where the curvature jumps (line to arc), held against the acceleration limit: there no
        finite jerk limit can hold short of a stop. Without a jerk limit no step is an offence, its limit is inf.
    kink : tuple of Worst
        Steps of velocity [m/s] where the direction jumps by a little (`contourlab.feed.junctions.MOST_KINK`), held against what the
        acceleration limit gives in `KINK_TIME`; the acceleration is without those places.
    n_step, n_kink : int
        How many such places were driven through.
    """

    velocity: tuple[Worst, ...]
    acceleration: tuple[Worst, ...]
    jerk: tuple[Worst, ...]
    curvature_step: tuple[Worst, ...]
    kink: tuple[Worst, ...]
    n_step: int = 0
    n_kink: int = 0

    def ok(self, tolerance: float = 0.005) -> bool:
        """Tell whether every limit holds within `tolerance` (a part of the limit, >= 0)."""
        return all(worst.ratio <= 1.0 + tolerance for worst in self.all())

    def all(self) -> tuple[Worst, ...]:
        """Return every entry: velocity, acceleration, jerk, curvature step, kink."""
        return (*self.velocity, *self.acceleration, *self.jerk, *self.curvature_step, *self.kink)


class _Kinks(NamedTuple):
    """Where the direction jumps by little: arc lengths (n,) in [0, length) [m], and by how much each axis' does (n, n_axis)."""

    place: Array
    jump: Array

    def largest(self, before: NDArray[np.int64], after: NDArray[np.int64]) -> Array:
        """Return the largest jumps (m, n_axis) of those that lie between two counts of `_jumps_passed` (m,), which differ."""
        low, count = np.minimum(before, after), np.abs(after - before)
        first = np.cumsum(count) - count
        which = np.repeat(low - first, count) + np.arange(int(count.sum()))
        return np.asarray(np.maximum.reduceat(self.jump[which % self.place.size], first))


def _kinks(path: Path) -> _Kinks:
    jump = direction_jump(path)
    angle = np.linalg.norm(jump, axis=1)
    wanted = (angle > 0.0) & (angle <= MOST_KINK)
    return _Kinks(_junctions_at(path, wanted), np.abs(np.roll(jump, 1, axis=0)[np.roll(wanted, 1)]))


def _junctions_at(path: Path, wanted: NDArray[np.bool_]) -> Array:
    """Return the arc lengths in [0, length) of the ends of some curves [m]."""
    return np.asarray(np.asarray(path.breaks)[:-1][np.roll(wanted, 1)], dtype=np.float64)


@dataclass
class _Record:
    """The worst seen so far of one kind, for each axis."""

    limit: Array
    allowance: Array
    value: Array = field(init=False)
    sample: NDArray[np.int64] = field(init=False)

    def __post_init__(self) -> None:
        self.value = np.zeros_like(self.limit)
        self.sample = np.full(self.limit.size, -1, dtype=np.int64)

    def see(self, values: Array, samples: NDArray[np.int64]) -> None:
        """Take in values (n, n_axis) that belong to `samples`."""
        if values.shape[0] == 0:
            return
        row = np.argmax(values, axis=0)
        peak = values[row, np.arange(values.shape[1])]
        better = (peak > self.value) | (self.sample < 0)
        self.value = np.where(better, peak, self.value)
        self.sample = np.where(better, samples[row], self.sample)


def _located(record: _Record, reference: Reference) -> tuple[Worst, ...]:
    """Return each worst value with its place."""
    entries = []
    for axis, (value, sample) in enumerate(zip(record.value.tolist(), record.sample.tolist(), strict=True)):
        worst = Worst(axis, value, float(record.limit[axis]), float(record.allowance[axis]))
        if sample >= 0:
            block = reference.block(sample, sample + 1)
            place, line = tuple(block.position[0].tolist()), int(reference.source_line(block.arc_length)[0])
            worst = replace(worst, sample=sample, time=sample * reference.servo_period, position=place, source_line=line)
        entries.append(worst)
    return tuple(entries)


def _jumps_passed(arc_length: Array, jumps: Array, length: float) -> NDArray[np.int64]:
    """Count the jumps of curvature up to each progress, laps included."""
    laps = np.floor(arc_length / length)
    within = np.searchsorted(jumps, arc_length - laps * length, side="right")
    return np.asarray(within + laps * jumps.size, dtype=np.int64)


def limit_report(reference: Reference, limits: AxisLimits) -> LimitReport:
    """Find the worst velocity, acceleration and jerk of each axis.

    Parameters
    ----------
    reference : Reference
        Of any origin; read in blocks, so that memory does not grow with its length.
    limits : AxisLimits

    Returns
    -------
    LimitReport

    Raises
    ------
    FeedError
        If the limits are for another number of axes.

    Notes
    -----
    Sample k labels the differences p[k+1] - p[k], p[k+1] - 2 p[k] + p[k-1] and p[k+2] - 3 p[k+1] + 3 p[k] - p[k-1].
    A curvature step between k and k+1 is the second difference at k+2 less the one at k-1, the nearest that lie
    clear of it; three servo periods of permitted jerk are allowed for. At a kink the velocity of an axis jumps by the
    jump of the path's direction times the speed, which is the least that the samples around show, less what the
    acceleration limit makes of it in half a period. Recorded references, whose progress is
    known to about a sample only, are given one sample more on each side.
    """
    limits = limits.for_axes(reference.n_axis)
    period, wide = reference.servo_period, 0 if reference.recorded is None else 1
    ends = reference.block(0, 1), reference.block(reference.n_sample - 1, reference.n_sample)
    extent = max(float(np.max(np.abs(end.position))) + float(end.arc_length[0]) for end in ends) + reference.path.length
    noise = 2.0 * np.finfo(float).eps * extent * np.ones(limits.n_axis)
    with np.errstate(invalid="ignore"):
        eased = np.where(np.isinf(limits.jerk), 0.0, limits.jerk * period * (3 + 2 * wide))
    step_limit = np.where(np.isinf(limits.jerk), np.inf, limits.acceleration)
    records = (
        _Record(limits.velocity, noise / period),
        _Record(limits.acceleration, 2.0 * noise / period**2),
        _Record(limits.jerk, 4.0 * noise / period**3),
        _Record(step_limit, eased + 4.0 * noise / period**2),
        _Record(limits.acceleration * KINK_TIME, MOST_KINK * noise / period),
    )
    places = _junctions_at(reference.path, np.any(curvature_jump(reference.path) != 0.0, axis=1)), _kinks(reference.path)
    n_step = n_kink = 0
    for start in range(0, reference.n_sample, BLOCK):
        steps, kinks = _look(reference, start, min(start + BLOCK, reference.n_sample), records, places, wide)
        n_step, n_kink = n_step + steps, n_kink + kinks
    velocity, acceleration, jerk, step, kink = (_located(record, reference) for record in records)
    return LimitReport(velocity, acceleration, jerk, step, kink, n_step, n_kink)


def _look(
    reference: Reference, start: int, stop: int, records: tuple[_Record, ...], places: tuple[Array, _Kinks], wide: int
) -> tuple[int, int]:
    """Take in the samples [start, stop), with enough of their neighbours; return the numbers of curvature steps and kinks."""
    margin = 4 + wide
    low, high = max(start - margin, 0), min(stop + margin, reference.n_sample)
    block = reference.block(low, high)
    period = reference.servo_period
    velocity = np.diff(block.position, axis=0) / period  # row i: samples low + i and the next
    acceleration = np.diff(velocity, axis=0) / period  # row i: centred at low + i + 1
    jerk = np.diff(acceleration, axis=0) / period  # row i: from low + i to low + i + 3
    index = np.arange(low, high)
    records[0].see(np.abs(velocity), index[:-1])
    length, kinks = float(reference.path.length), _jumps_passed(block.arc_length, places[1].place, float(reference.path.length))
    clear = (
        kinks[np.clip(np.arange(acceleration.shape[0]) - wide, 0, None)]
        == kinks[np.clip(np.arange(2, index.size) + wide, None, index.size - 1)]
    )
    records[1].see(np.abs(acceleration[clear]), index[1:-1][clear])
    passed = kinks + _jumps_passed(block.arc_length, places[0], length)
    first = np.clip(np.arange(jerk.shape[0]) - wide, 0, None)
    last = np.clip(np.arange(jerk.shape[0]) + 3 + wide, None, index.size - 1)
    smooth = passed[first] == passed[last]
    records[2].see(np.abs(jerk[smooth]), index[1 : 1 + jerk.shape[0]][smooth])
    # A step between rows i and i + 1 shows between the second differences centred at i + 2 + wide and i - 1 - wide.
    at = np.flatnonzero(np.diff(passed) != 0)
    at = at[(at - 2 - wide >= 0) & (at + 1 + wide < acceleration.shape[0])]
    step = np.abs(acceleration[at + 1 + wide] - acceleration[at - 2 - wide])
    records[3].see(step, index[at])
    # Row k spans a kink between the samples k and k + 1.
    turn = np.flatnonzero(np.diff(kinks) != 0)
    turn = turn[(turn - 1 - wide >= 0) & (turn + 1 + wide < velocity.shape[0])]
    if turn.size:
        around = np.linalg.norm(velocity, axis=1)
        speed = np.min([around[turn + i] for i in range(-1 - wide, 2 + wide)], axis=0)
        slowest = np.maximum(speed - 0.5 * period * float(np.max(records[1].limit)), 0.0)
        records[4].see(places[1].largest(kinks[turn], kinks[turn + 1]) * slowest[:, None], index[turn])
    at = at[np.diff(passed - kinks)[at] != 0]
    return tuple(int(np.count_nonzero((index[some] >= start) & (index[some] < stop))) for some in (at, turn))  # type: ignore[return-value]
