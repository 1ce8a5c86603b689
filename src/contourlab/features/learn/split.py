"""What repeats from trial to trial, which can be learned; what does not; and where in frequency the error grows."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Array
from contourlab.components.learning.law import LearningLaw, LearningProblem
from contourlab.errors import ComponentError

FEWEST = 4
"""Trials from which a steady course can be told from chance."""
LAST = 6
"""Trials from which the size of chance is estimated."""
GROWN = 0.1
"""The band of growth holds what grew by at least this part of the largest growth."""
EXPLAINED = 2.0
"""Ratio of the square of a change to that of chance, up to which chance explains the change."""


@dataclass(frozen=True)
class Split:
    """u_i = u_R + u_NR,i over the last trials (eq 23), sample by sample; what changes steadily, by learning, is no part of u_NR.

    Attributes
    ----------
    trials : int
        Over how many.
    repeatable, non_repeatable : tuple of float, one for each axis [command unit]
        Rms of the two parts of the feedback.
    bound : tuple of float, one for each axis [command unit, or m where the reference is learned]
        max |h * u_NR|, what of the non-repeatable part passes the law's filter and is learned by mistake; the tracking error stands for the
        feedback where the law learns the reference.
    bound_position : tuple of float, one for each axis, or None [m]
        Largest position error that this causes, by the linear model; None where there is no such model.
    floor : float [m]
        Rms of what of the contour error does not repeat (with one axis, of the tracking error): no learning comes below it.
    """

    trials: int
    repeatable: tuple[float, ...]
    non_repeatable: tuple[float, ...]
    bound: tuple[float, ...]
    bound_position: tuple[float, ...] | None
    floor: float


class Memory:
    """Remembers the last trials.

    Parameters
    ----------
    depth : int, >= 2
        How many.
    """

    def __init__(self, depth: int) -> None:
        self.depth = depth
        self.feedback: list[Array] = []
        self.tracking: list[Array] = []
        self.contour: list[Array] = []

    def add(self, feedback: Array, tracking: Array, contour: Array) -> None:
        """Take in a trial; arrays that nobody changes afterwards."""
        for kept, now in ((self.feedback, feedback), (self.tracking, tracking), (self.contour, contour)):
            kept.append(now)
            del kept[: -self.depth]

    def change(self, tracking: Array, window: tuple[int, int]) -> float:
        """Return the rms over all axes [m] by which a tracking error differs from the last one that is remembered; NaN without one."""
        if not self.tracking:
            return math.nan
        cut = slice(*window)
        return float(np.sqrt(np.square(tracking[cut] - self.tracking[-1][cut]).sum(axis=1).mean()))

    def explained(self) -> bool:
        """Tell whether chance explains how the tracking error has changed over the trials that are remembered."""
        if len(self.tracking) < max(self.depth, FEWEST):
            return False
        scatter, change = _scatter(self.tracking[-FEWEST:]), self.tracking[-1] - self.tracking[0]
        by_chance = 2.0 * float(np.square(scatter).sum())
        return bool(by_chance > 0.0 and float(np.square(change).sum()) <= EXPLAINED * by_chance)

    def split(self, law: LearningLaw, problem: LearningProblem) -> Split | None:
        """Return the estimate; None after fewer than four trials."""
        if len(self.feedback) < FEWEST:
            return None
        rest = _rest(self.feedback)
        passed = [law.passed(part, problem.servo_period) for part in (rest if law.target == "command" else _rest(self.tracking))]
        errors = _rest(self.contour if self.tracking[0].shape[1] > 1 else [part[:, 0] for part in self.tracking])
        try:
            moved = [np.abs(problem.model.forward(part)).max(axis=0) for part in passed]
            position = tuple(np.max(moved, axis=0).tolist())
        except ComponentError:
            position = None
        return Split(
            len(self.feedback),
            tuple(np.sqrt(np.mean(np.square(np.mean(self.feedback, axis=0)), axis=0)).tolist()),
            tuple(np.sqrt(np.mean(np.square(rest), axis=(0, 1))).tolist()),
            tuple(np.max([np.abs(part).max(axis=0) for part in passed], axis=0).tolist()),
            position,
            float(np.sqrt(np.mean(np.square(errors)))),
        )


def _scatter(trials: list[Array]) -> Array:
    """Return the non-repeatable part of one of four trials in a row, up to its sign.

    The third difference removes any steady course and nearly all of a decay, and multiplies what is independent in each trial by the root
    of 1 + 9 + 9 + 1.
    """
    a, b, c, d = trials
    return np.asarray((d - a - 3.0 * (c - b)) / np.sqrt(20.0))


def _rest(trials: list[Array]) -> list[Array]:
    """Return an estimate of the non-repeatable part for each four trials in a row of the last six, where least is still learned."""
    last = trials[-LAST:]
    return [_scatter(last[i : i + FEWEST]) for i in range(len(last) - FEWEST + 1)]


@dataclass(frozen=True)
class Growth:
    """The band of frequencies in which the tracking error grows from trial to trial.

    Attributes
    ----------
    low, high : float [Hz]
        Of the band.
    peak : float [Hz]
        Its middle, weighted by the growth.
    factor : float
        By which the error grew, where it grew most, from one trial to the next.
    axis : str
        The axis in which it grew most.
    """

    low: float
    high: float
    peak: float
    factor: float
    axis: str


def growth_of(errors: list[Array], servo_period: float, axes: tuple[str, ...]) -> Growth | None:
    """Return the band in which the increments of the error grew.

    Parameters
    ----------
    errors : list of ndarray (n_sample, n_axis) [m]
        Tracking errors of the last trials, oldest first; three or more.
    servo_period : float [s]
    axes : tuple of str
        Their names.

    Returns
    -------
    Growth or None
        None where there are fewer than three trials, or nothing grew.
    """
    if len(errors) < 3:
        return None
    before, after = (_spectrum(errors[i] - errors[i - 1], servo_period) for i in (-2, -1))
    grown = after - before
    k, j = np.unravel_index(int(np.argmax(grown)), grown.shape)
    if not grown[k, j] > 0.0:
        return None
    step = 1.0 / (len(errors[0]) * servo_period)
    column = grown[:, j] >= GROWN * grown[k, j]
    low, high = int(k), int(k)
    while low > 0 and column[low - 1]:
        low -= 1
    while high + 1 < len(column) and column[high + 1]:
        high += 1
    # The middle of the band by weight: single lines of the spectrum are a matter of the record's length.
    inside = np.arange(low, high + 1)
    weight = grown[low : high + 1, j]
    middle = float((inside * weight).sum() / weight.sum())
    factor = float(np.sqrt(after[k, j] / max(before[k, j], np.finfo(float).tiny)))
    return Growth(max(low - 0.5, 0.0) * step, (high + 0.5) * step, middle * step, factor, axes[int(j)])


def _spectrum(signal: Array, servo_period: float) -> Array:
    """Return the power spectrum (n_frequency, n_axis), averaged over neighbours up to a tenth of the frequency."""
    from scipy.fft import rfft

    n = len(signal)
    window = np.hanning(n)[:, None]  # an error that does not end where it began would leak into all frequencies
    power = np.abs(rfft(signal * window, axis=0)) ** 2
    total = np.concatenate([np.zeros((1, power.shape[1])), np.cumsum(power, axis=0)])
    k = np.arange(len(power))
    half = 2 + k // 20
    low, high = np.maximum(k - half, 0), np.minimum(k + half + 1, len(power))
    return np.asarray((total[high] - total[low]) / (high - low)[:, None])
