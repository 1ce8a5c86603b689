"""When learning stops: converged or diverged."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from contourlab.errors import ParameterError
from contourlab.features.learn.trial import TrialFigures
from contourlab.findings import Finding, finding

EXPLAINED_GAIN = 0.05
"""Largest improvement that chance can explain, even if the trials differ widely."""
RESOLUTION = 1e-12
"""Errors [m] below this differ only by rounding."""


@dataclass(frozen=True)
class Stopping:
    """When to stop, judged by the contour rms; with one axis, by the tracking rms.

    Learning does not count as diverged while the tracking error falls or the trials differ less and less.

    Attributes
    ----------
    improvement : float, 0 to 1
        Converged if `patience` trials improve neither the best contour error nor the best tracking error by more than this share, and the
        error does not rise steadily; 0 continues to the last trial.
    patience : int, >= 2
    explained : bool
        Whether learning has also converged if chance explains the change of the errors over the last `patience` trials.
    divergence : float, > 1
        Diverged if the last two trials are worse than the best by more than this factor.
    growth : int, >= 2
        Diverged also if each of this many trials is worse than the one before, and the last is worse than the best by `growth_margin`.
    growth_margin : float, > 0
        As a share of the best.

    Raises
    ------
    ParameterError
        If a number is out of range.
    """

    improvement: float = 0.01
    patience: int = 10
    explained: bool = True
    divergence: float = 2.0
    growth: int = 5
    growth_margin: float = 0.05

    def __post_init__(self) -> None:
        for name, low, high, words in (
            ("improvement", 0.0, 1.0, "from 0 to 1"),
            ("patience", 2, math.inf, "2 or more"),
            ("divergence", math.nextafter(1.0, 2.0), math.inf, "> 1"),
            ("growth", 2, math.inf, "2 or more"),
            ("growth_margin", math.nextafter(0.0, 1.0), math.inf, "> 0"),
        ):
            if not low <= getattr(self, name) <= high:
                raise ParameterError(name, f"{getattr(self, name):g}", words)


@dataclass(frozen=True)
class Stop:
    """How learning ended (converged, diverged or interrupted), and why."""

    status: str
    finding: Finding


def best_of(figures: list[TrialFigures]) -> int:
    """Return the number of the best trial: the first of equal ones, 0 if all stopped early."""
    merits = [math.inf if math.isnan(trial.merit) else trial.merit for trial in figures]
    return merits.index(min(merits))


def verdict(figures: list[TrialFigures], stopping: Stopping, explained: bool) -> Stop | None:
    """Return why learning stops after these trials, or None if it continues.

    Parameters
    ----------
    figures : list of TrialFigures
        Figures of all trials so far.
    explained : bool
        Whether chance explains the latest change of the errors.
    """
    last = figures[-1]
    if last.failed:
        return Stop("diverged", finding("CL303", trial=last.trial, reason=last.failed))
    merits = [max(trial.merit, RESOLUTION) for trial in figures]
    grows = _grows(figures, merits, stopping)
    if grows is not None or stopping.improvement == 0.0 or len(figures) <= stopping.patience:
        return grows
    tracking = [max(trial.tracking, RESOLUTION) for trial in figures]
    gain = max(_gain(merits, stopping), _gain(tracking, stopping))
    if gain <= stopping.improvement:
        return _settled(figures, merits, stopping, explained)
    if stopping.explained and explained and gain <= EXPLAINED_GAIN:
        return Stop("converged", finding("CL302", trials=stopping.patience))
    return None


def _gain(errors: list[float], stopping: Stopping) -> float:
    """Return the share by which the last trials have reduced the best error before them."""
    before = min(errors[: -stopping.patience])
    return max(before - min(errors[-stopping.patience :]), 0.0) / before


def _settled(figures: list[TrialFigures], merits: list[float], stopping: Stopping, explained: bool) -> Stop | None:
    """Return how learning ends when neither error falls any more; None if more trials are needed to decide."""
    best = merits.index(min(merits))
    risen = merits[-1] / merits[best] - 1.0
    values: dict[str, Any] = {"trials": stopping.patience, "best": best, "above": risen}
    if explained:
        return Stop("converged", finding("CL302", **values))
    beyond = risen > stopping.growth_margin
    if beyond and (best == 0 or _swells(figures, stopping)):
        return Stop("diverged", finding("CL306", **values))
    if not beyond and _rises(merits, stopping) and _swells(figures, stopping):
        return None
    return Stop("converged", finding("CL301", **values))


def _grows(figures: list[TrialFigures], merits: list[float], stopping: Stopping) -> Stop | None:
    last, best = figures[-1], min(merits)
    # While tracking improves, the contour error may rise for some trials, because one axis learns faster than another.
    # Trials that differ less and less approach a limit, even if an earlier trial was better.
    if last.tracking <= min(trial.tracking for trial in figures) or not _swells(figures, stopping):
        return None
    # One bad trial may be chance, for example an axis that stuck once; two are not.
    if len(merits) > 1 and min(merits[-2:]) > stopping.divergence * best:
        return Stop("diverged", finding("CL304", trial=last.trial, factor=merits[-1] / best))
    if _rises(merits, stopping) and merits[-1] > (1.0 + stopping.growth_margin) * best:
        return Stop("diverged", finding("CL305", trials=stopping.growth))
    return None


def _rises(merits: list[float], stopping: Stopping) -> bool:
    """Return whether each of the last trials was worse than the one before."""
    run = merits[-stopping.growth - 1 :]
    return len(run) > stopping.growth and all(b > a for a, b in pairwise(run))


def _swells(figures: list[TrialFigures], stopping: Stopping) -> bool:
    """Return whether the change from trial to trial has not fallen over the last trials."""
    changes = [trial.change for trial in figures[1:]][-stopping.growth :]
    return len(changes) < 2 or changes[-1] >= min(changes[0], changes[-2])
