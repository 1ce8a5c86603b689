"""A motion along a path, as spans of constant jerk, and the samples of it that figures and verdicts cover.

By default these are the cutting moves.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from contourlab.arrays import Array, Flags, Index, true_spans


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
    """Rising, separate sample ranges [start, stop), and what they cover, in words.

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


WHOLE, LAST_LAP, CUTTING = "whole motion", "last lap", "cutting moves"


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
