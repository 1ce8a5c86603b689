"""The samples of a motion that figures and verdicts cover: the cutting moves, unless another choice is made."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.feed.profile import Profile

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
        pairs = (part.split("-") for part in listed.split(", "))
        return cls(tuple((int(start), int(stop)) for start, stop in pairs), basis)

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
    edges = np.flatnonzero(np.diff(np.concatenate([[False], chosen, [False]]).astype(np.int8)))
    samples = np.ceil(_leaving(profile, breaks[edges]) / servo_period - _ROUNDING).astype(np.int64)
    samples[edges == 0], samples[edges == len(chosen)] = 0, n_sample
    pairs = samples.reshape(-1, 2)
    return tuple((int(start), int(stop)) for start, stop in pairs[pairs[:, 0] < pairs[:, 1]])


def _leaving(profile: Profile, place: Array) -> Array:
    """Return the times [s] at which the motion leaves some places."""
    span = np.clip(np.searchsorted(profile.s0, place + _SAME_PLACE, side="right") - 1, 0, profile.n_span - 1)
    reached, dt = profile.reached(place)
    begins = np.abs(profile.s0[span] - place) <= _SAME_PLACE
    return np.where(begins, profile.t0[span], profile.t0[reached] + dt)
