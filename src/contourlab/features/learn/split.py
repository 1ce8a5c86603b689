"""What repeats from trial to trial and what does not: only the former can be learned."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.components.learning.law import LearningLaw, LearningProblem
from contourlab.errors import ComponentError

Array = NDArray[np.float64]
FEWEST = 4
"""Trials from which a steady course and chance can be told apart."""
LAST = 6
"""Trials from which the size of chance is taken."""
EXPLAINED = 2.0
"""Ratio of a change's square to that of chance up to which chance explains it."""


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

    The third difference takes away any steady course, and nearly all of a decay; what is independent in each trial it multiplies by the
    root of 1 + 9 + 9 + 1.
    """
    a, b, c, d = trials
    return np.asarray((d - a - 3.0 * (c - b)) / np.sqrt(20.0))


def _rest(trials: list[Array]) -> list[Array]:
    """Return one estimate of the non-repeatable part for each four trials in a row of the last six, where least is still learned."""
    last = trials[-LAST:]
    return [_scatter(last[i : i + FEWEST]) for i in range(len(last) - FEWEST + 1)]
