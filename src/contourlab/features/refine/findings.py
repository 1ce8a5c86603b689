"""Findings that question refined parameters."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from contourlab.analysis.identification.least_squares import Descent, FitCovariance
from contourlab.features.refine.log_run import Agreement
from contourlab.features.refine.parameters import RefinedParameter
from contourlab.findings import Finding, finding

TOGETHER = 0.95
"""Correlation from which two parameters cannot be distinguished."""
UNKNOWN = 0.5
"""Relative deviation from which a parameter is hardly known."""
EXPLAINED = 0.5
"""Explained share of a signal's variance below which there is a finding."""
WORSE = 0.01
"""Share by which the residual of data that was not fitted may grow."""
COLOURED = 1.5
"""Ratio of deviations for a coloured and a white residual from which there is a finding."""


def fit_findings(
    parameters: Sequence[RefinedParameter],
    descent: Descent,
    knowledge: FitCovariance,
    after: Sequence[Agreement],
    descents: tuple[int, int],
) -> Iterator[Finding]:
    """Yield findings that question the parameters.

    Parameters
    ----------
    knowledge : FitCovariance
        Covariance of the parameters that are not at a bound.
    descents : (int, int)
        Number of descents, and of those that reached the same minimum as the best one.
    """
    for parameter in parameters:
        value, deviation, place = parameter.value, parameter.deviation, parameter.sought.label
        if parameter.at_bound:
            yield finding("CL550", place, value=value)
        elif not np.isfinite(deviation):
            yield finding("CL551", place)
        elif deviation > UNKNOWN * abs(value) and not parameter.sought.signed:
            yield finding("CL552", place, ratio=deviation / abs(value) if value else np.inf)
    yield from _correlated(parameters, knowledge)
    if not descent.converged:
        yield finding("CL554", steps=descent.iterations)
    made, same = descents
    if made > 1 and same < made:
        yield finding("CL555", made=made, same=same)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratios = np.array([parameter.deviation for parameter in parameters]) / [parameter.white_deviation for parameter in parameters]
    ratio = float(np.nan_to_num(ratios, nan=1.0, posinf=1.0).max())
    if ratio > COLOURED:
        yield finding("CL556", ratio=ratio)
    for one in after:
        if one.explained <= 0.0:
            yield finding("CL558", one.place)
        elif one.explained < EXPLAINED:
            yield finding("CL557", one.place, explained=one.explained)


def _correlated(parameters: Sequence[RefinedParameter], knowledge: FitCovariance) -> Iterator[Finding]:
    labels = [parameter.sought.label for parameter in parameters if not parameter.at_bound]
    for i, j in np.argwhere(np.triu(np.abs(knowledge.correlation), 1) > TOGETHER).tolist():
        if not (knowledge.untold[i] or knowledge.untold[j]):
            yield finding("CL553", f"{labels[i]} and {labels[j]}", correlation=float(knowledge.correlation[i, j]))


def unseen_findings(before: Sequence[Agreement], after: Sequence[Agreement], validation: bool = False) -> Iterator[Finding]:
    """Yield findings where the refined model fits unseen data worse than the model at the start.

    Parameters
    ----------
    before, after : sequence of Agreement
        For the same signals in the same order.
    validation : bool
        Whether the data is a log for validation, or the part of a fitted log outside `--window`.
    """
    for one, other in zip(before, after, strict=True):
        if other.rms > (1.0 + WORSE) * one.rms:
            values = {"ratio": other.rms / one.rms, "before": one.rms, "after": other.rms}
            yield finding("CL560", other.place, **values) if validation else finding("CL559", other.place, **values)
