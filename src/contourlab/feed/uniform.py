"""Constant speed along a closed path, as in the papers: one lap per period, without ramps."""

from __future__ import annotations

import math

import numpy as np

from contourlab.errors import FeedError
from contourlab.feed.profile import Profile
from contourlab.feed.reference import Reference, checked_period
from contourlab.geometry import Path

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
    if not path.closed:
        raise FeedError("uniform() needs a closed path; use plan() for an open one")
    if not (frequency > 0.0 and math.isfinite(frequency)):
        raise FeedError(f"frequency = {frequency!r}: must be finite and > 0 Hz")
    if int(laps) != laps or laps < 1:
        raise FeedError(f"laps = {laps!r}: must be a whole number >= 1")
    exact = laps / max(frequency * period, 1e-300)
    if exact > MOST_SAMPLES:
        raise FeedError(f"{laps} laps at {frequency:g} Hz take {exact:.3g} servo periods: use a frequency near 1 Hz")
    n_sample = round(exact)
    if n_sample < 1 or abs(exact - n_sample) > 1e-9 * exact:
        per_lap = max(round(1.0 / (frequency * period)), 1)
        raise FeedError(
            f"{laps} laps at {frequency:g} Hz take {exact:.9g} servo periods of {period:g} s, not a whole number: "
            f"use frequency = {1.0 / (per_lap * period):.12g} Hz or servo_period = {1.0 / (per_lap * frequency):.12g} s"
        )
    per_lap = n_sample // laps
    whole = per_lap * laps == n_sample
    ranges = tuple((lap * per_lap, (lap + 1) * per_lap) for lap in range(laps)) if whole else ((0, n_sample),)
    zero = np.zeros(1)
    length = float(path.length)
    profile = Profile(zero, zero, np.array([length * frequency]), zero, zero, duration=laps / frequency, length=laps * length)
    return Reference(
        servo_period=period,
        n_sample=n_sample,
        path=path,
        programmed=path,
        profile=profile,
        source_lines=np.zeros(len(path.curves), dtype=np.int64),
        laps=ranges,
    )
