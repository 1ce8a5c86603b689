"""The reference of the servo loops: position, velocity and acceleration of each sample, computed on demand.

`uniform` makes one of constant speed along a closed path, as in the papers: one lap per period, without ramps.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import BLOCK, Array, Flags, Index, true_spans
from contourlab.errors import FeedError, refuse
from contourlab.feed.route import Correspondence, place_on_programmed
from contourlab.figures import figure
from contourlab.geometry import Path
from contourlab.notebook import Figure, Frame, Panel, curves, facts_line, facts_table, frame, svg


class Motion(NamedTuple):
    """Progress along the path and its time derivatives.

    Attributes
    ----------
    arc_length : ndarray (n,) [m]
    speed : ndarray (n,) [m/s]
    acceleration : ndarray (n,) [m/s^2]
    jerk : ndarray (n,) [m/s^3]
    """

    arc_length: Array
    speed: Array
    acceleration: Array
    jerk: Array


@dataclass(frozen=True, eq=False)
class Profile:
    """Spans of constant jerk, from t = 0.

    Span i applies for ``t0[i] <= t < t0[i + 1]``, the last one until `duration`::

        s = s0 + v0 dt + a0 dt^2 / 2 + j dt^3 / 6,     dt = t - t0

    Parameters
    ----------
    t0, s0, v0, a0, j : ndarray (n_span,) [s, m, m/s, m/s^2, m/s^3]
        Time, progress, speed and tangential acceleration at the start of each span, and its jerk.
    duration : float [s]
    length : float [m]
        Progress at the end.
    """

    t0: Array
    s0: Array
    v0: Array
    a0: Array
    j: Array
    duration: float
    length: float

    def __post_init__(self) -> None:
        for part in (self.t0, self.s0, self.v0, self.a0, self.j):
            part.flags.writeable = False

    @cached_property
    def ends(self) -> Array:
        """Progress at the end of each span (n_span,) [m]."""
        return np.append(self.s0[1:], self.length)

    @property
    def n_span(self) -> int:
        """Number of spans."""
        return int(self.t0.size)

    def motion(self, time: Array) -> Motion:
        """Evaluate at times (n,) [s]; before the start and after the end the motion is at rest."""
        clamped = np.minimum(np.maximum(time, 0.0), self.duration)
        # Broadcast a single span; gathering it is slower.
        span = np.searchsorted(self.t0, clamped, side="right") - 1 if self.n_span > 1 else np.zeros(1, dtype=np.int64)
        dt = clamped - self.t0[span]
        start_speed, start_acceleration, jerk = self.v0[span], self.a0[span], self.j[span]
        progress = dt * (start_speed + dt * (start_acceleration / 2.0 + dt * jerk / 6.0))
        # Rounding must not pass the end of the span, which is known exactly.
        arc_length = np.minimum(self.s0[span] + progress, self.ends[span])
        speed = np.maximum(start_speed + dt * (start_acceleration + dt * jerk / 2.0), 0.0)
        acceleration, jerk = start_acceleration + dt * jerk, np.broadcast_to(jerk, dt.shape).copy()
        still = (time < 0.0) | (time >= self.duration)
        if np.any(still):
            arc_length[time >= self.duration] = self.length
            for part in (speed, acceleration, jerk):
                part[still] = 0.0
        return Motion(arc_length, speed, acceleration, jerk)

    def reached(self, arc_length: Array) -> tuple[Index, Array]:
        """Return in which span each place (n,) [m] is reached, and the time since the start of that span (n,) [s]."""
        span = np.clip(np.searchsorted(self.s0, arc_length, side="right") - 1, 0, self.n_span - 1)
        s0, v0, a0, j = self.s0[span], self.v0[span], self.a0[span], self.j[span]
        low, high = np.zeros_like(arc_length), np.diff(np.append(self.t0, self.duration))[span]
        for _ in range(60):
            middle = 0.5 * (low + high)
            early = s0 + middle * (v0 + middle * (a0 / 2.0 + middle * j / 6.0)) < arc_length
            low, high = np.where(early, middle, low), np.where(early, high, middle)
        return span, high


_SAME_PLACE = 1e-10
"""A span that begins this close to a border [m] begins there."""
_ROUNDING = 1e-6
"""A time this close behind a sample [samples] is that of the sample: the last digit of a length must not decide."""


class Judged(NamedTuple):
    """The samples that are judged: ranges [start, stop) in order, without overlap, and a name for what they cover.

    Attributes
    ----------
    ranges : tuple of (int, int)
    basis : str
    """

    ranges: tuple[tuple[int, int], ...]
    basis: str

    def within(self, first: int, n_sample: int) -> Judged:
        """Return the part in a result of `n_sample` samples that begins at sample `first`, counted from there; all of it if none is."""
        cut = ((max(start - first, 0), min(stop - first, n_sample)) for start, stop in self.ranges)
        inside = tuple((start, stop) for start, stop in cut if start < stop)
        return Judged(inside, self.basis) if inside else Judged(((0, n_sample),), WHOLE)

    @property
    def text(self) -> str:
        """The ranges and what they cover, as a file of a result keeps them.

        >>> Judged.parse(Judged(((10, 20), (30, 45)), "cutting moves").text)
        Judged(ranges=((10, 20), (30, 45)), basis='cutting moves')
        """
        return f"{self.basis}: {', '.join(f'{start}-{stop}' for start, stop in self.ranges)}"

    @classmethod
    def parse(cls, text: str) -> Judged:
        """Return the ranges of a `text`; ValueError if it is none."""
        basis, _, listed = text.rpartition(": ")
        return cls(tuple((int(start), int(stop)) for start, stop in (part.split("-") for part in listed.split(", "))), basis)

    @property
    def samples(self) -> Index:
        """Numbers of the samples (n,)."""
        return np.concatenate([np.arange(start, stop) for start, stop in self.ranges])

    def mask(self, n_sample: int) -> Flags:
        """Return whether each of n samples is in a range (n,)."""
        inside = np.zeros(n_sample, dtype=bool)
        inside[self.samples] = True
        return inside


WHOLE, LAST_LAP, CUTTING, RAPIDS = "whole motion", "last lap", "cutting moves", "rapid moves"


def ranges_of_curves(profile: Profile, breaks: Array, chosen: Flags, servo_period: float, n_sample: int) -> tuple[tuple[int, int], ...]:
    """Return the sample ranges of chosen curves (n_curve,) between `breaks` (n_curve + 1,) [m]; a rest belongs to the curve before it."""
    edges = np.array(true_spans(chosen), dtype=np.int64).ravel()
    place = breaks[edges]
    span = np.clip(np.searchsorted(profile.s0, place + _SAME_PLACE, side="right") - 1, 0, profile.n_span - 1)
    reached, dt = profile.reached(place)
    leaving = np.where(np.abs(profile.s0[span] - place) <= _SAME_PLACE, profile.t0[span], profile.t0[reached] + dt)
    samples = np.ceil(leaving / servo_period - _ROUNDING).astype(np.int64)
    samples[edges == 0], samples[edges == len(chosen)] = 0, n_sample
    pairs = samples.reshape(-1, 2)
    return tuple((int(start), int(stop)) for start, stop in pairs[pairs[:, 0] < pairs[:, 1]])


CHUNK = 4096
"""Samples computed at once, so that they stay in the processor's cache."""
KEPT_BLOCKS = 4
"""Blocks kept for the next run of the same reference."""
EVEN_POINTS = 2000
"""Even places and times in a picture of a planned motion, besides the ends of curves and spans."""


class ReferenceBlock(NamedTuple):
    """Consecutive samples of a reference.

    Attributes
    ----------
    position, velocity, acceleration : ndarray (n, n_axis) [m, m/s, m/s^2]
    arc_length : ndarray (n,) [m]
        Progress, counted over the laps of a closed path.
    feedrate : ndarray (n,) [m/s]
        Speed along the path.
    table : ndarray (n, 3 n_axis + 2) [m, m/s, m/s^2]
        All of the above in this order; they are views of this table. Each signal is contiguous in memory.
    """

    position: Array
    velocity: Array
    acceleration: Array
    arc_length: Array
    feedrate: Array
    table: Array


Filler: TypeAlias = "Callable[[Reference, int, int, Array], None]"


class Recorded(NamedTuple):
    """Imported positions.

    Attributes
    ----------
    position : ndarray (n, n_axis) [m]
    arc_length : ndarray (n,) [m]
        Progress along the path.
    table : ndarray (n, 3 n_axis + 2), or None
        Of a motion whose progress a loop decided, as of `ReferenceBlock`; None for imported positions, whose velocities are differences.
    planned_time : ndarray (n,) [s], or None
        Of such a motion: the time of its plan at each sample.
    """

    position: Array
    arc_length: Array
    table: Array | None = None
    planned_time: Array | None = None


def checked_period(servo_period: float) -> float:
    """Return the servo period as a float, after a range check."""
    if not (servo_period > 0.0 and np.isfinite(servo_period)):
        raise FeedError(f"servo_period = {servo_period!r}: must be finite and > 0 s, for example 0.001")
    return float(servo_period)


def whole_samples(duration: float, servo_period: float) -> int:
    """Return how many samples cover `duration` seconds, the last one at or after its end."""
    last = int(np.ceil(duration / checked_period(servo_period)))
    return last + 1 if last * servo_period >= duration else last + 2


def lap_ranges(profile: Profile, lap_length: float, laps: int, servo_period: float) -> tuple[tuple[int, int], ...]:
    """Return the samples [start, stop) of each lap of a planned motion."""
    span, dt = profile.reached(np.arange(1.0, laps) * lap_length)
    borders = [int(k) for k in np.ceil((profile.t0[span] + dt) / servo_period)]
    return tuple(pairwise([0, *borders, whole_samples(profile.duration, servo_period)]))


def _differences(position: Array, servo_period: float, start: int, stop: int) -> tuple[Array, Array]:
    """Return velocity and acceleration of recorded positions by central differences; before and after the samples the motion rests."""
    around = position[np.clip(np.arange(start - 1, stop + 1), 0, position.shape[0] - 1)]
    return (around[2:] - around[:-2]) / (2.0 * servo_period), np.diff(around, 2, axis=0) / servo_period**2


def along_path(path: Path, arc_length: Array, speed: Array, acceleration: Array, rows: Array) -> None:
    """Fill rows (3 n_axis, n) with position, velocity and acceleration of each axis, for a motion (n,) along a path."""
    n = path.n_axis
    position, first, second = path.derivatives(arc_length, 2).transpose(0, 2, 1)
    rows[:n] = position
    np.multiply(first, speed, out=rows[n : 2 * n])
    np.multiply(second, speed**2, out=rows[2 * n :])
    rows[2 * n :] += first * acceleration


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class Reference:
    """Set points of the axes; sample k is at the time ``k * servo_period``.

    Memory holds only the spans of the profile; `block` computes samples, in any order. `plan`, `uniform` and `Reference.from_samples`
    create references.

    Parameters
    ----------
    servo_period : float [s]
    n_sample : int
    path, programmed : Path
        The planned and the programmed path.
    profile : Profile or None
        The motion along the path; None for recorded positions.
    line_breaks : ndarray (n + 1,) [m]
        Where on `path` program lines begin, and the last one ends.
    source_lines : ndarray (n,) of int
        These program lines; 0 for none.
    laps : tuple of (start, stop)
        Sample ranges [start, stop) of whole laps.
    recorded : Recorded or None
    correspondence : Correspondence or None
        Map from `path` to `programmed`, where they differ.
    rapid : ndarray (n_curve,) of bool, or None
        The curves at rapid rate; None for none.
    chosen : Judged or None
        Samples to judge, instead of `judged`'s default.
    """

    servo_period: float
    n_sample: int
    path: Path
    programmed: Path
    profile: Profile | None
    line_breaks: Array
    source_lines: Index
    laps: tuple[tuple[int, int], ...] = ()
    recorded: Recorded | None = None
    correspondence: Correspondence | None = None
    rapid: Flags | None = None
    chosen: Judged | None = None
    _kept: dict[tuple[int, int, Filler | None], ReferenceBlock] = field(default_factory=dict, init=False, repr=False)

    @property
    def n_axis(self) -> int:
        """Number of axes."""
        return int(self.path.n_axis)

    @property
    def duration(self) -> float:
        """Duration of the motion [s]; the last sample is at its end or later."""
        return self.profile.duration if self.profile is not None else (self.n_sample - 1) * self.servo_period

    @property
    def decided(self) -> bool:
        """Whether a loop decided its progress; see `contourlab.Loop`."""
        return self.recorded is not None and self.recorded.table is not None

    @cached_property
    def judged(self) -> Judged:
        """The samples that figures cover: those `chosen`, else the last lap, the cutting moves, or all."""
        if self.chosen is not None:
            return self.chosen
        if self.laps:
            return Judged(self.laps[-1:], LAST_LAP)
        if self.rapid is not None and 0 < np.count_nonzero(self.rapid) < len(self.rapid):
            return Judged(self.between(self.path.breaks, ~self.rapid), CUTTING)
        return Judged(((0, self.n_sample),), WHOLE)

    def blocks(self, size: int | None = None) -> Iterator[tuple[int, int]]:
        """Yield the samples [start, stop) of all blocks of at most `size` samples, by default `contourlab.arrays.BLOCK`."""
        return pairwise([*range(0, self.n_sample, size or BLOCK), self.n_sample])

    def between(self, breaks: Array, chosen: Flags) -> tuple[tuple[int, int], ...]:
        """Return the sample ranges of chosen stretches (n,) between breaks [m] of a planned lap; a rest belongs to the stretch before."""
        assert self.profile is not None
        return ranges_of_curves(self.profile, breaks, chosen, self.servo_period, self.n_sample)

    def block(self, start: int, stop: int, fill: Filler | None = None) -> ReferenceBlock:
        """Return the samples [start, stop).

        Parameters
        ----------
        start, stop : int, 0 <= start <= stop <= n_sample
        fill : callable, optional
            Function that computes planned samples, such as the compiled one: called with the reference, start, stop, and the rows
            (3 n_axis + 2, n) to fill.

        Raises
        ------
        FeedError
            If the range is not within the reference.

        Notes
        -----
        velocity = r' s_dot and acceleration = r'' s_dot^2 + r' s_ddot; central differences for recorded positions.
        """
        if not 0 <= start <= stop <= self.n_sample:
            raise FeedError(f"block({start}, {stop}): the reference has the samples 0 to {self.n_sample}")
        key = (start, stop, fill)
        if key not in self._kept:
            if len(self._kept) >= KEPT_BLOCKS:
                del self._kept[next(iter(self._kept))]
            self._kept[key] = self._sampled(start, stop, fill if self.recorded is None and stop > start else None)
        return self._kept[key]

    def _sampled(self, start: int, stop: int, fill: Filler | None) -> ReferenceBlock:
        n = self.n_axis
        rows = np.empty((3 * n + 2, stop - start))
        if fill is not None:
            fill(self, start, stop, rows)
        else:
            for first in range(start, stop, CHUNK):
                last = min(first + CHUNK, stop)
                self._sample(first, last, rows[:, first - start : last - start])
        rows.flags.writeable = False
        return ReferenceBlock(rows[:n].T, rows[n : 2 * n].T, rows[2 * n : 3 * n].T, rows[-2], rows[-1], rows.T)

    def _sample(self, start: int, stop: int, rows: Array) -> None:
        """Fill rows (3 n_axis + 2, stop - start): position, velocity and acceleration of each axis, arc length, feedrate."""
        n = self.n_axis
        position, velocity, acceleration = rows[:n], rows[n : 2 * n], rows[2 * n : 3 * n]
        if self.recorded is not None and self.recorded.table is not None:
            rows[:] = self.recorded.table[start:stop].T
            return
        if self.recorded is not None:
            moving = _differences(self.recorded.position, self.servo_period, start, stop)
            position[:], rows[-2] = self.recorded.position[start:stop].T, self.recorded.arc_length[start:stop]
            velocity[:], acceleration[:] = (part.T for part in moving)
            rows[-1] = np.sqrt((velocity**2).sum(axis=0))
            return
        assert self.profile is not None  # a reference is either planned or recorded
        motion = self.profile.motion(np.arange(start, stop, dtype=np.float64) * self.servo_period)
        rows[-2], rows[-1] = motion.arc_length, motion.speed
        along_path(self.path, motion.arc_length, motion.speed, motion.acceleration, rows[:-2])

    def source_line(self, arc_length: ArrayLike) -> Index:
        """Return the program line (n,), from 1, at some progress (n,) [m]; 0 where there is no program."""
        curve, along = self.path.local(arc_length)
        number = np.searchsorted(self.line_breaks, self.path.breaks[curve] + along, side="right") - 1
        return np.take(self.source_lines, number, mode="wrap" if self.path.closed else "clip")

    def programmed_arc_length(self, arc_length: ArrayLike) -> Array:
        """Return the progress (n,) [m] along `programmed` for a progress (n,) [m] along `path`; both may count laps."""
        return place_on_programmed(self.correspondence, self.path, self.programmed, arc_length)

    def to_pandas(self, start: int = 0, stop: int | None = None) -> Frame:
        """Return samples in SI as a table over time [s].

        Parameters
        ----------
        start, stop : int, 0 <= start <= stop <= n_sample
            Samples [start, stop); all by default. Each takes 8 (3 n_axis + 3) bytes of memory.

        Returns
        -------
        pandas.DataFrame
            ``position 1``, ``velocity 1``, ``acceleration 1`` and so on for each axis, ``arc_length`` and ``feedrate``.

        Raises
        ------
        FeedError
            If the range is not within the reference.
        """
        stop = self.n_sample if stop is None else stop
        block = self.block(start, stop)
        columns = {f"{name} {i + 1}": getattr(block, name)[:, i] for name in block._fields[:3] for i in range(self.n_axis)}
        columns |= {"arc_length": block.arc_length, "feedrate": block.feedrate}
        return frame(columns, np.arange(start, stop) * self.servo_period, "time")

    def plot(self) -> Figure:
        """Draw the path of the first two axes and the feedrate over time; a long motion is thinned, corners and peaks kept."""
        time, speed = self._speeds()
        panels: list[Panel] = [("time [s]", "feedrate [mm/min]", [("", time, 6e4 * speed)])]
        if self.n_axis > 1:
            places = np.unique(np.concatenate([np.linspace(0.0, self.path.length, EVEN_POINTS), self.path.breaks]))
            position = self.path.position(places) if self.recorded is None else self.recorded.position
            panels.insert(0, ("axis 1 [mm]", "axis 2 [mm]", [("", 1e3 * position[:, 0], 1e3 * position[:, 1])]))
        drawn = curves(panels, to_scale=self.n_axis > 1)
        drawn.axes[-1].set_ylim(bottom=0.0)
        return drawn

    def _speeds(self) -> tuple[Array, Array]:
        """Return time [s] and feedrate [m/s] (n,): of every recorded sample, or of even times and every span."""
        if self.recorded is not None:
            velocity = _differences(self.recorded.position, self.servo_period, 0, self.n_sample)[0]
            return np.asarray(np.arange(self.n_sample) * self.servo_period), np.asarray(np.sqrt((velocity**2).sum(axis=1)))
        assert self.profile is not None  # a reference is either planned or recorded
        profile, lasts = self.profile, np.diff(self.profile.t0, append=self.duration)
        # A span has its highest and lowest speed at its ends, or inside where its acceleration is 0.
        turn = profile.t0 + np.clip(-profile.a0 / np.where(profile.j == 0.0, np.inf, profile.j), 0.0, lasts)
        time = np.unique(np.concatenate([np.linspace(0.0, self.duration, EVEN_POINTS, endpoint=False), profile.t0, turn]))
        return time, profile.motion(time).speed

    @cached_property
    def largest_feedrate(self) -> float:
        """Largest feedrate [m/s]."""
        return float(self._speeds()[1].max())

    def _facts(self) -> dict[str, object]:
        """Return what describes the motion."""
        facts: dict[str, object] = {
            "axes": self.n_axis,
            "duration": figure(self.duration, "s", 5),
            "samples": f"{self.n_sample} of {1e3 * self.servo_period:g} ms",
            "length": figure(self.path.length, "mm", 6),
            "largest feedrate": figure(self.largest_feedrate, "mm/min", 4),
        }
        if self.laps:
            facts["laps"] = len(self.laps)
        return {**facts, "judged": self.judged.basis}

    def __repr__(self) -> str:
        return facts_line("Reference", self._facts())

    def _repr_html_(self) -> str:
        return facts_table(self._facts()) + svg(self.plot())

    @cached_property
    def digest(self) -> str:
        """Stable hash of all data that determine the samples."""
        text = hashlib.sha256()
        text.update(np.array([self.servo_period, self.n_sample, self.duration]).tobytes())
        text.update(self.path.digest.encode() + b"/" + self.programmed.digest.encode())
        profile, parts = self.profile, tuple(part for part in self.recorded or () if part is not None)
        if profile is not None:
            parts = (profile.t0, profile.s0, profile.v0, profile.a0, profile.j)
        if self.correspondence is not None:
            parts = (*parts, self.correspondence.planned, self.correspondence.programmed)
        for part in (*parts, self.source_lines):
            text.update(np.ascontiguousarray(part).tobytes())
        return text.hexdigest()

    @classmethod
    def from_samples(
        cls,
        position: ArrayLike,
        servo_period: float,
        path: Path,
        *,
        arc_length: ArrayLike | None = None,
        programmed: Path | None = None,
        source_lines: ArrayLike | None = None,
        correspondence: Correspondence | None = None,
    ) -> Reference:
        """Create a reference from the positions of another planner or a log.

        Parameters
        ----------
        position : array_like (n_sample, n_axis) [m], n_sample >= 2
        servo_period : float [s], > 0
        path : Path
            The path that the positions follow.
        arc_length : array_like (n_sample,) [m], optional
            Progress along the path; by default the length of the polygon through the positions, which must then be free of noise.
        programmed : Path, optional
        source_lines : array_like (n_curve,) of int, optional
        correspondence : Correspondence, optional
            Map from `path` to `programmed`.

        Raises
        ------
        FeedError
            If a shape is wrong or a position is not finite.
        """
        points = np.array(position, dtype=np.float64)
        if points.ndim != 2 or points.shape[0] < 2 or points.shape[1] != path.n_axis:
            raise FeedError(f"position has shape {points.shape}: give (n_sample >= 2, {path.n_axis})")
        finite = np.isfinite(points).all(axis=1)
        refuse(not finite.all(), FeedError, f"position is not finite at sample {int(np.argmin(finite))}")
        if arc_length is None:
            progress = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
        else:
            progress = np.array(arc_length, dtype=np.float64)
        if progress.shape != points.shape[:1] or not np.all(np.isfinite(progress)):
            raise FeedError(f"arc_length must be {points.shape[0]} finite numbers, one for each position")
        lines = np.zeros(len(path.curves), np.int64) if source_lines is None else np.array(source_lines, np.int64)
        if lines.shape != (len(path.curves),):
            raise FeedError(f"source_lines has shape {lines.shape}: give one line for each curve of the path")
        points.flags.writeable = progress.flags.writeable = False
        return cls(
            servo_period=checked_period(servo_period),
            n_sample=points.shape[0],
            path=path,
            programmed=programmed or path,
            profile=None,
            line_breaks=path.breaks,
            source_lines=lines,
            recorded=Recorded(points, progress),
            correspondence=correspondence,
        )


MOST_SAMPLES = 1e15
"""More have no exact number."""


def uniform(path: Path, frequency: float, laps: int, servo_period: float) -> Reference:
    """Return laps of a closed path at constant speed: progress = length * frequency * t.

    The first sample already moves at full speed. The speed is constant along the arc length; on an ellipse this differs from
    x = a cos(2 pi f t), y = b sin(2 pi f t).

    Parameters
    ----------
    path : Path
        Closed.
    frequency : float [Hz], > 0
        Laps per second.
    laps : int, >= 1
    servo_period : float [s], > 0
        All laps together must take a whole number of periods.

    Returns
    -------
    Reference
        Samples 0 to laps/(frequency * servo_period) - 1; the next would repeat the first. `laps` holds one range per lap if a lap is a
        whole number of samples, else one for all.

    Raises
    ------
    FeedError
        If the path is open, or the laps do not end on a sample.
    """
    period = checked_period(servo_period)
    refuse(not path.closed, FeedError, "uniform() needs a closed path; use plan() for an open one")
    refuse(not (frequency > 0.0 and math.isfinite(frequency)), FeedError, f"frequency = {frequency!r}: must be finite and > 0 Hz")
    refuse(int(laps) != laps or laps < 1, FeedError, f"laps = {laps!r}: must be a whole number >= 1")
    exact = laps / max(frequency * period, 1e-300)
    refuse(exact > MOST_SAMPLES, FeedError, f"{laps} laps at {frequency:g} Hz take {exact:.3g} servo periods: use a frequency near 1 Hz")
    n_sample = round(exact)
    if n_sample < 1 or abs(exact - n_sample) > 1e-9 * exact:
        per_lap = max(round(1.0 / (frequency * period)), 1)
        raise FeedError(
            f"{laps} laps at {frequency:g} Hz take {exact:.9g} servo periods of {period:g} s, not a whole number: "
            f"use frequency = {1.0 / (per_lap * period):.12g} Hz or servo_period = {1.0 / (per_lap * frequency):.12g} s"
        )
    per_lap = n_sample // laps
    ranges = tuple((lap * per_lap, (lap + 1) * per_lap) for lap in range(laps)) if per_lap * laps == n_sample else ((0, n_sample),)
    zero, length = np.zeros(1), float(path.length)
    profile = Profile(zero, zero, np.array([length * frequency]), zero, zero, duration=laps / frequency, length=laps * length)
    return Reference(
        servo_period=period,
        n_sample=n_sample,
        path=path,
        programmed=path,
        profile=profile,
        line_breaks=path.breaks,
        source_lines=np.zeros(len(path.curves), dtype=np.int64),
        laps=ranges,
    )
