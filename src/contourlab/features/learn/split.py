"""The repeatable part of the error, which can be learned, the non-repeatable part, and the frequencies at which the error grows."""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Array, Index
from contourlab.components.learning.law import LearningLaw, LearningProblem
from contourlab.errors import ComponentError

FEWEST = 4
"""Smallest number of trials that separates a steady trend from chance."""
LAST = 6
"""Number of last trials used to estimate chance."""
GROWN = 0.1
"""The growth band contains frequencies that grew by at least this share of the largest growth."""
EXPLAINED = 2.0
"""Chance explains a change up to this ratio of its square to the square expected by chance."""


@dataclass(frozen=True)
class Split:
    """Feedback of the last trials, split sample by sample: u_i = u_R + u_NR,i (eq 23); u_NR excludes the steady change by learning.

    Attributes
    ----------
    trials : int
        Number of trials used.
    repeatable, non_repeatable : tuple of float, one for each axis [command unit]
        Rms of the two parts of the feedback.
    bound : tuple of float, one for each axis [command unit, or m where the reference is learned]
        ``max |h * u_NR|``: the non-repeatable part that passes the law's filter and is learned by mistake. For a law that learns the
        reference: the same of the tracking error instead of the feedback.
    bound_position : tuple of float, one for each axis, or None [m]
        Largest position error that this causes, by the linear model; None without such a model.
    floor : float [m]
        Rms of the non-repeatable contour error (with one axis, tracking error): learning cannot go below it.
    """

    trials: int
    repeatable: tuple[float, ...]
    non_repeatable: tuple[float, ...]
    bound: tuple[float, ...]
    bound_position: tuple[float, ...] | None
    floor: float


class Memory:
    """The last trials.

    Parameters
    ----------
    depth : int, >= 2
        Number of trials kept.
    """

    def __init__(self, depth: int) -> None:
        self.trials: deque[tuple[Array, Array, Array]] = deque(maxlen=depth)

    def add(self, feedback: Array, tracking: Array, contour: Array) -> None:
        """Add a trial; the arrays must not change afterwards."""
        self.trials.append((feedback, tracking, contour))

    @property
    def tracking(self) -> list[Array]:
        """The tracking errors, oldest first."""
        return [tracking for _, tracking, _ in self.trials]

    def change(self, tracking: Array, judged: Index) -> float:
        """Return the rms difference over all axes [m] between a tracking error and that of the last trial kept; NaN without one."""
        if not self.trials:
            return math.nan
        return float(np.sqrt(np.square(tracking[judged] - self.trials[-1][1][judged]).sum(axis=1).mean()))

    def explained(self) -> bool:
        """Return whether chance explains the change of the tracking error over the trials kept."""
        tracking = self.tracking
        if len(tracking) < max(self.trials.maxlen or 0, FEWEST):
            return False
        scatter, change = _scatter(tracking[-FEWEST:]), tracking[-1] - tracking[0]
        by_chance = 2.0 * float(np.square(scatter).sum())
        return bool(by_chance > 0.0 and float(np.square(change).sum()) <= EXPLAINED * by_chance)

    def split(self, law: LearningLaw, problem: LearningProblem) -> Split | None:
        """Return the estimate; None with fewer than four trials."""
        if len(self.trials) < FEWEST:
            return None
        feedback, tracking, contour = map(list, zip(*self.trials, strict=True))
        rest = _rest(feedback)
        passed = [law.passed(part, problem.servo_period) for part in (rest if law.target == "command" else _rest(tracking))]
        errors = _rest(contour if tracking[0].shape[1] > 1 else [part[:, 0] for part in tracking])
        try:
            moved = [np.abs(problem.model.forward(part)).max(axis=0) for part in passed]
            position = tuple(np.max(moved, axis=0).tolist())
        except ComponentError:
            position = None
        return Split(
            len(feedback),
            tuple(np.sqrt(np.mean(np.square(np.mean(feedback, axis=0)), axis=0)).tolist()),
            tuple(np.sqrt(np.mean(np.square(rest), axis=(0, 1))).tolist()),
            tuple(np.max([np.abs(part).max(axis=0) for part in passed], axis=0).tolist()),
            position,
            float(np.sqrt(np.mean(np.square(errors)))),
        )


def _scatter(trials: list[Array]) -> Array:
    """Return an estimate of the non-repeatable part of one trial from four trials in a row, up to its sign.

    The third difference removes any steady trend and nearly all of a decay. It multiplies the independent parts by the root of
    1 + 9 + 9 + 1.
    """
    a, b, c, d = trials
    return np.asarray((d - a - 3.0 * (c - b)) / np.sqrt(20.0))


def _rest(trials: list[Array]) -> list[Array]:
    """Return an estimate of the non-repeatable part for every four consecutive trials of the last six, which learn the least."""
    last = trials[-LAST:]
    return [_scatter(last[i : i + FEWEST]) for i in range(len(last) - FEWEST + 1)]


@dataclass(frozen=True)
class Growth:
    """The band of frequencies in which the tracking error grows from trial to trial.

    Attributes
    ----------
    low, high : float [Hz]
        Ends of the band.
    peak : float [Hz]
        Middle of the band, weighted by the growth.
    factor : float
        Growth factor per trial at the frequency with the largest growth.
    axis : str
        The axis with the largest growth.
    """

    low: float
    high: float
    peak: float
    factor: float
    axis: str


def growth_of(errors: list[Array], servo_period: float, axes: tuple[str, ...]) -> Growth | None:
    """Return the band in which the change of the error from trial to trial grew.

    Parameters
    ----------
    errors : list of ndarray (n_sample, n_axis) [m]
        Tracking errors of the last trials, oldest first; three or more.
    servo_period : float [s]

    Returns
    -------
    Growth or None
        None with fewer than three trials, or without growth.
    """
    if len(errors) < 3:
        return None
    before, after = (_spectrum(errors[i] - errors[i - 1]) for i in (-2, -1))
    grown = after - before
    k, j = np.unravel_index(int(np.argmax(grown)), grown.shape)
    if not grown[k, j] > 0.0:
        return None
    step = 1.0 / (len(errors[0]) * servo_period)
    outside = np.flatnonzero(grown[:, j] < GROWN * grown[k, j])
    low = int(outside[outside < k].max(initial=-1)) + 1
    high = int(outside[outside > k].min(initial=len(grown))) - 1
    # The weighted middle of the band: single lines of the spectrum depend on the length of the record.
    inside = np.arange(low, high + 1)
    weight = grown[low : high + 1, j]
    middle = float((inside * weight).sum() / weight.sum())
    factor = float(np.sqrt(after[k, j] / max(before[k, j], np.finfo(float).tiny)))
    return Growth(max(low - 0.5, 0.0) * step, (high + 0.5) * step, middle * step, factor, axes[int(j)])


def _spectrum(signal: Array) -> Array:
    """Return the power spectrum (n_frequency, n_axis), averaged over neighbours up to a tenth of the frequency."""
    from scipy.fft import rfft

    n = len(signal)
    window = np.hanning(n)[:, None]  # a difference between start and end would leak into all frequencies
    power = np.abs(rfft(signal * window, axis=0)) ** 2
    total = np.concatenate([np.zeros((1, power.shape[1])), np.cumsum(power, axis=0)])
    k = np.arange(len(power))
    half = 2 + k // 20
    low, high = np.maximum(k - half, 0), np.minimum(k + half + 1, len(power))
    return np.asarray((total[high] - total[low]) / (high - low)[:, None])
