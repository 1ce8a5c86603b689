"""Gecer Ulu et al., Figs 9 and 10: convergence over trials, and the errors around the tight turn."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Array
from contourlab.papers.gecer_ulu.setup import EXPERIMENT, KAPPA, SIMULATION, TRIALS, course, reference_of
from contourlab.papers.gecer_ulu.tables import LONG
from contourlab.papers.rows import Row, ours

SHOWN = (0, 1, 2, 5, 10, 15, 20, 25, 30)


@dataclass(frozen=True, eq=False)
class Turn:
    """Fig 10: the path and the tool around the tight turn.

    Attributes
    ----------
    time : ndarray (n,) [s]
        From the turn of the reference.
    reference : ndarray (n, 2) [m]
    feedback, learned : ndarray (n, 2) [m]
        True positions with FB, and with FB CCC ILC after 30 trials.
    feedback_contour, learned_contour : ndarray (n,) [m]
        Exact contour errors, positive to the left.
    """

    time: Array
    reference: Array
    feedback: Array
    learned: Array
    feedback_contour: Array
    learned_contour: Array


def convergence(setting: str, kappa: float = KAPPA, trials: int = TRIALS) -> Array:
    """Return the data of Fig 9: rms [m] of the contour error of eq (10) in trials 0 (nothing learned) to `trials`."""
    run = course(setting, kappa, trials)
    return np.array([1e-9 * run.rms(trial)[2] for trial in range(trials + 1)])


def turn(setting: str, around: float = 3.0) -> Turn:
    """Return the data of Fig 10 for SIMULATION or EXPERIMENT, within `around` [s] of the turn."""
    reference = reference_of(setting)
    asked = reference.block(0, reference.n_sample)
    middle = int(np.argmax(asked.position[:, 0]))
    half = round(around / reference.servo_period)
    cut = slice(max(middle - half, 0), middle + half + 1)
    alone, learned = course(setting, 0.0, LONG), course(setting, KAPPA, LONG)
    time = (np.arange(reference.n_sample)[cut] - middle) * reference.servo_period
    errors = alone.contour[0, cut], learned.contour[TRIALS, cut]
    return Turn(time.astype(float), asked.position[cut], alone.position[0, cut], learned.position[TRIALS, cut], *errors)


def convergence_rows() -> Iterator[Row]:
    """Yield some trials of Fig 9, and the largest contour errors before and after the turn of Fig 10."""
    for setting, limit in ((SIMULATION, "very close to zero"), (EXPERIMENT, "around 30 nm")):
        found = 1e9 * convergence(setting, trials=LONG)
        note = f"FB CCC ILC; in the paper it converges to a value {limit}"
        yield from (ours("Fig 9 contour rms", f"{setting}, trial {trial}", found[trial], "nm", note) for trial in SHOWN)
        seen = turn(setting)
        for words, part in (("before", seen.time < 0.0), ("after", seen.time >= 0.0)):
            size, left = (1e9 * np.abs(error[part]).max() for error in (seen.feedback_contour, seen.learned_contour))
            note = f"{left:.3g} nm with FB CCC ILC; within 3 s of the turn; the paper finds larger errors just after the turn"
            yield ours("Fig 10 largest contour error under FB", f"{setting}, {words} the turn", size, "nm", note)
