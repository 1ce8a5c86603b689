"""How far may the contour error of a new run be from its simulation? Leave out each run in turn, and predict it from the others."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from contourlab.errors import ParameterError, ResultError
from contourlab.features.refine.study import USUAL, Refined, RefinedParameter, RefineSettings, Sought, refine_sought
from contourlab.findings import finding

LEAST = 1e-12
"""Smallest contour error [m] that counts, so that an exact run has a logarithm."""


@dataclass(frozen=True)
class HeldOut:
    """A run, simulated with parameters that were refined against the other runs.

    Attributes
    ----------
    second_half : bool
        Whether only the second half of its motion counts, because parameters of this run alone were fitted to the first half.
    measured_rms, simulated_rms, measured_max, simulated_max : float [m]
        Contour error; of a machine with one axis, the tracking error.
    """

    run: str
    second_half: bool
    measured_rms: float
    simulated_rms: float
    measured_max: float
    simulated_max: float


@dataclass(frozen=True)
class CrossValidation:
    """Prediction of each run from the others.

    Attributes
    ----------
    level : float
        Share of new runs of the same kind whose measured contour error should lie within the factors: n/(n + 1) for n runs.
    rms_factor, max_factor : float, >= 1
        The measured contour error lies between the simulated one divided by the factor, and multiplied by it.
    """

    held_out: tuple[HeldOut, ...]
    level: float
    rms_factor: float
    max_factor: float


def new_run_factor(measured: Sequence[float], simulated: Sequence[float]) -> float:
    """Return the factor within which a new run's measured figure lies around its simulated one, in n of n + 1 cases.

    Parameters
    ----------
    measured, simulated : sequence of float (n,), n > 1
        Figures of runs that were left out.

    Notes
    -----
    With e = ln(measured/simulated), the factor is exp(t rms(e) sqrt(n^2 - 1)/n), where t is the quantile of Student's distribution with
    n - 1 degrees of freedom. It is exact if each run has its own normal value of e, and the mean of the others predicts it: the errors of n
    runs left out then share these n values and sum to zero. If the errors are independent, it contains up to 6 % more of the new runs
    (n = 2). A higher share needs more runs: for two, 90 % would take 5.5 times the rms in place of 1.5.
    """
    from scipy.stats import t

    n = len(measured)
    errors = np.log(np.maximum(measured, LEAST)) - np.log(np.maximum(simulated, LEAST))
    quantile = float(t.ppf(0.5 + 0.5 * n / (n + 1), n - 1))
    return math.exp(quantile * math.sqrt(n * n - 1) / n * float(np.sqrt(np.mean(errors**2))))


def cross_validated(
    refined: Refined, settings: RefineSettings = USUAL, progress: Callable[[str], None] = lambda line: None
) -> tuple[Refined, CrossValidation | None]:
    """Leave out each run in turn; return deviations that include the scatter between runs, and the prediction of the runs, if possible.

    Parameters
    ----------
    settings : RefineSettings, optional
        Each fit starts from the refined parameters, with one descent.
    progress : callable, optional
        Called with a line after each run.

    Notes
    -----
    The deviation of a shared parameter becomes that of the jackknife over runs, sqrt((n - 1)/n sum (value_i - mean)^2), if this is larger.
    Parameters of one run alone cannot come from the others: they are fitted to the first half of its motion, and the second half counts.
    """
    if len(refined.runs) < 2:
        return _unknown(refined, "there is one log only; the deviations come from within it and are likely too small")
    settings = replace(settings, starts=1, rounds=1)
    held: list[HeldOut] = []
    folds: list[dict[Sought, RefinedParameter]] = []
    try:
        for i in range(len(refined.runs)):
            folds.append(_fold(refined, i, settings))
            held.append(_held_out(refined, i, folds[i], settings))
            progress(f"left out {held[i].run}: {1e6 * held[i].measured_rms:.4g} um rms, {1e6 * held[i].simulated_rms:.4g} um predicted")
    except (ParameterError, ResultError) as error:
        return _unknown(refined, str(error))
    rms = new_run_factor([one.measured_rms for one in held], [one.simulated_rms for one in held])
    most = new_run_factor([one.measured_max for one in held], [one.simulated_max for one in held])
    level = len(held) / (len(held) + 1)
    stated = finding("CL566", level=level, rms_low=1.0 / rms, rms_high=rms, max_low=1.0 / most, max_high=most)
    parameters = tuple(_scattered(parameter, folds) for parameter in refined.parameters)
    return replace(refined, parameters=parameters, findings=(*refined.findings, stated)), CrossValidation(tuple(held), level, rms, most)


def _unknown(refined: Refined, reason: str) -> tuple[Refined, None]:
    return replace(refined, findings=(*refined.findings, finding("CL567", reason=reason))), None


def _again(parameter: RefinedParameter, runs: Sequence[int]) -> Sought:
    """Return a parameter to refine again from its refined value, in some of the runs, numbered anew."""
    sought = parameter.sought
    held = tuple(runs.index(i) for i in sought.runs if i in runs)
    return replace(sought, variable=replace(sought.variable, value=parameter.value), runs=held)


def _fold(refined: Refined, left_out: int, settings: RefineSettings) -> dict[Sought, RefinedParameter]:
    """Return the parameters refined without a run, by those refined with it."""
    others = [i for i in range(len(refined.runs)) if i != left_out]
    among = [parameter for parameter in refined.parameters if set(parameter.sought.runs) & set(others)]
    if not any(left_out in parameter.sought.runs for parameter in among):
        raise ParameterError("--parameter", f"none for {refined.runs[left_out].label} and another log", "one that two logs share")
    runs, windows = [refined.runs[i] for i in others], [refined.windows[i] for i in others]
    fit = refine_sought(runs, [_again(parameter, others) for parameter in among], windows=windows, settings=settings)
    return {parameter.sought: refitted for parameter, refitted in zip(among, fit.parameters, strict=True)}


def _held_out(refined: Refined, which: int, fold: dict[Sought, RefinedParameter], settings: RefineSettings) -> HeldOut:
    """Simulate a run with the parameters of the others."""
    run = refined.runs[which]
    run = run.placed({sought.name: refitted.value for sought, refitted in fold.items() if which in sought.runs})
    own = [_again(parameter, [which]) for parameter in refined.parameters if parameter.sought.runs == (which,)]
    begin, end = run.moves
    if own:
        middle = (begin + end) // 2
        times = run.times()
        (run,) = refine_sought([run], own, windows=[(float(times[begin]), float(times[middle]))], settings=settings).runs
        begin = middle
    (rms, most), (simulated_rms, simulated_max) = (run.contour(signals, slice(begin, end)) for signals in (None, run.once()))
    return HeldOut(run.label, bool(own), rms, simulated_rms, most, simulated_max)


def _scattered(parameter: RefinedParameter, folds: Sequence[dict[Sought, RefinedParameter]]) -> RefinedParameter:
    """Return a parameter with the deviation of the jackknife over its runs, if this is larger."""
    refitted = [folds[i][parameter.sought] for i in parameter.sought.runs if parameter.sought in folds[i]]
    # A fold that cannot determine the parameter keeps the start: it says nothing about scatter.
    if len(refitted) < 2 or not all(math.isfinite(one.deviation) for one in (parameter, *refitted)):
        return parameter
    scatter = math.sqrt(len(refitted) - 1) * float(np.std([one.value for one in refitted]))
    return replace(parameter, deviation=max(parameter.deviation, scatter))
