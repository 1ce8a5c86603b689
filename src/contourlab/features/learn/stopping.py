"""When learning has come to its end: converged, or on its way to nowhere."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

from contourlab.errors import ParameterError
from contourlab.features.learn.trial import TrialFigures

EXPLAINED_GAIN = 0.05
"""Part of the error beyond which an improvement is none of chance, however much the trials differ."""
RESOLUTION = 1e-12
"""Error [m] below which better and worse are a matter of rounding."""


@dataclass(frozen=True)
class Stopping:
    """When to stop. What is watched is the contour rms; with one axis, the tracking rms.

    Nothing is called diverged as long as the tracking error still falls, or the trials differ less and less.

    Attributes
    ----------
    improvement : float, 0 to 1
        Converged, when `patience` trials have taken no more than this part off the best contour error before them, nor off the best
        tracking error, and do not rise steadily; 0 goes on to the last trial.
    patience : int, >= 2
    explained : bool
        Whether it has converged, too, when chance explains how the errors changed over the last `patience` trials.
    divergence : float, > 1
        Diverged, when a trial is worse than the best by this factor.
    growth : int, >= 2
        Diverged, too, when so many trials in a row were each worse than the one before, and the last one is worse than the best by
        `growth_margin`.
    growth_margin : float, > 0
        In parts of the best.
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
class Verdict:
    """Why learning stops: the word, and the reason in a sentence."""

    word: str
    reason: str


def best_of(figures: list[TrialFigures]) -> int:
    """Return the number of the best trial; of equals the first, and 0 where none came to its end."""
    merits = [math.inf if math.isnan(trial.merit) else trial.merit for trial in figures]
    return merits.index(min(merits))


def verdict(figures: list[TrialFigures], stopping: Stopping, explained: bool) -> Verdict | None:
    """Return why learning stops after these trials, or None if it goes on.

    Parameters
    ----------
    figures : list of TrialFigures
        Of all trials so far.
    stopping : Stopping
    explained : bool
        Whether chance explains how the errors changed of late.
    """
    last = figures[-1]
    if last.failed:
        return Verdict("diverged", f"trial {last.trial} did not come to its end: {last.failed}")
    merits = [max(trial.merit, RESOLUTION) for trial in figures]
    grows = _grows(figures, merits, stopping)
    if grows is not None or stopping.improvement == 0.0 or len(figures) <= stopping.patience:
        return grows
    tracking = [max(trial.tracking, RESOLUTION) for trial in figures]
    gain = max(_gain(merits, stopping), _gain(tracking, stopping))
    if gain <= stopping.improvement:
        return _settled(figures, merits, stopping, explained)
    if stopping.explained and explained and gain <= EXPLAINED_GAIN:
        return Verdict("converged", f"chance explains how the errors changed over the last {stopping.patience} trials")
    return None


def _gain(errors: list[float], stopping: Stopping) -> float:
    """Return the part of the best error before them that the last trials have taken off."""
    before = min(errors[: -stopping.patience])
    return max(before - min(errors[-stopping.patience :]), 0.0) / before


def _settled(figures: list[TrialFigures], merits: list[float], stopping: Stopping, explained: bool) -> Verdict | None:
    """Return what it means that neither contour nor tracking error has become smaller; None where trials are to show it."""
    best = merits.index(min(merits))
    risen = merits[-1] / merits[best] - 1.0
    said = f"the last {stopping.patience} trials made neither contour nor tracking error smaller{_saturation(figures)}"
    if best + 1 < len(merits):
        said += f"; the last one is {100.0 * risen:.2g} % above trial {best}"
    if explained:
        return Verdict("converged", f"{said}, which chance explains")
    beyond = risen > stopping.growth_margin
    if beyond and (best == 0 or _swells(figures, stopping)):
        return Verdict("diverged", f"no trial was better than the first; {said}" if best == 0 else said)
    if not beyond and _rises(merits, stopping) and _swells(figures, stopping):
        return None
    return Verdict("converged", said)


def _grows(figures: list[TrialFigures], merits: list[float], stopping: Stopping) -> Verdict | None:
    last, best = figures[-1], min(merits)
    # While the axes still follow better from trial to trial, the contour error may rise for a while: one axis learns faster than another.
    # And where trials differ less and less they have a limit, if a worse one than they have passed on the way.
    if last.tracking <= min(trial.tracking for trial in figures) or not _swells(figures, stopping):
        return None
    saturated = _saturation(figures)
    # One bad trial may be chance, as where an axis stuck once; two are not.
    if len(merits) > 1 and min(merits[-2:]) > stopping.divergence * best:
        return Verdict("diverged", f"trial {last.trial} is {merits[-1] / best:.3g} times as bad as the best{saturated}")
    if _rises(merits, stopping) and merits[-1] > (1.0 + stopping.growth_margin) * best:
        return Verdict("diverged", f"the last {stopping.growth} trials were each worse than the one before{saturated}")
    return None


def _saturation(figures: list[TrialFigures]) -> str:
    """Say at how many samples the drives saturate, which no learning gets beyond."""
    return f"; the drives saturate at {figures[-1].saturated} samples" if figures[-1].saturated else ""


def _rises(merits: list[float], stopping: Stopping) -> bool:
    """Tell whether each of the last trials was worse than the one before."""
    run = merits[-stopping.growth - 1 :]
    return len(run) > stopping.growth and all(b > a for a, b in pairwise(run))


def _swells(figures: list[TrialFigures], stopping: Stopping) -> bool:
    """Tell whether the change from trial to trial has not become smaller over the last trials."""
    changes = [trial.change for trial in figures[1:]][-stopping.growth :]
    return len(changes) < 2 or changes[-1] >= min(changes[0], changes[-2])
