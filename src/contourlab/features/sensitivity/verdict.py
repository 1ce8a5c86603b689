"""Conclusions of a study: which parameters matter, which do not, which interact, and what to calibrate first."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np

from contourlab.arrays import Array, Flags
from contourlab.features.sensitivity.curves import CHANGE, Curve
from contourlab.features.sensitivity.study import Study
from contourlab.figures import figure, listing
from contourlab.findings import Finding, finding

LOCAL = "local sensitivity"
SMALL = 0.05
"""Share of the variance, or of the largest effect, below which a parameter does not matter."""
WIDE = 0.1
"""If half an interval is wider than this, the order of parameters is uncertain."""
TOGETHER = 0.1
"""Share of the variance, and relative second difference, above which two parameters interact."""
WORTHWHILE = 0.05
"""A parameter is worth calibrating if its minimum lies below the present figure by more than this share."""
MOST_PAIRS, MOST_FIRST = 4, 3


@dataclass(frozen=True)
class Ranking:
    """Parameters in three groups, each with its strength, largest first.

    Attributes
    ----------
    measure : str
        The measure of strength.
    matter, undecided, negligible : dict of str to float
        Short names and strengths; undecided where the interval includes the threshold. A parameter that alone lowers the figure by
        `WORTHWHILE` matters, whatever its strength over the whole range.
    """

    measure: str
    matter: dict[str, float]
    undecided: dict[str, float]
    negligible: dict[str, float]


def ranking(study: Study) -> Ranking:
    """Rank by the best measure available: total Sobol indices, Morris' mu*, local sensitivities, or the change over the curves."""
    if study.sobol is not None:
        return _ranking(study, "total index", study.sobol.total, study.sobol.total_interval, SMALL)
    if study.morris is not None:
        top = float(study.morris.mu_star.max())
        return _ranking(study, "mu*", study.morris.mu_star, study.morris.mu_star_interval, SMALL * top)
    if study.local is not None:
        slopes = np.array([abs(slope.sensitivity) for slope in study.local.slopes])
        differences = np.array([slope.difference for slope in study.local.slopes])
        return _ranking(study, LOCAL, np.nan_to_num(slopes), np.nan_to_num(differences, nan=np.inf), SMALL)
    decades = np.array([_decades(curve) for curve in study.curves or ()])
    return _ranking(study, "change over its curve", decades, np.zeros(len(decades)), float(np.log10(1.0 + CHANGE)))


def _ranking(study: Study, measure: str, strength: Array, interval: Array, bound: float) -> Ranking:
    order = np.argsort(-strength, kind="stable")

    def named(which: Flags) -> dict[str, float]:
        return {study.space.numbers[j].short: float(strength[j]) for j in order if which[j]}

    alone = {curve.variable.short for _, curve in _worthwhile(study)}
    matter = (strength - interval > bound) | np.array([variable.short in alone for variable in study.space.numbers])
    negligible = ~matter & (strength + interval < bound)
    return Ranking(measure, named(matter), named(~matter & ~negligible), named(negligible))


def _decades(curve: Curve) -> float:
    good = curve.figures[np.isfinite(curve.figures)]
    return float(np.log10(good.max() / good.min())) if good.size and good.min() > 0.0 else 0.0


def verdict(study: Study) -> tuple[Finding, ...]:
    """Return the conclusions of a study."""
    return (*_groups(ranking(study)), *_interactions(study), *_first(study), *_doubts(study))


def _groups(ranked: Ranking) -> Iterator[Finding]:
    measure = ranked.measure
    if ranked.matter:
        yield finding("CL656", measure=measure, **_listed(ranked.matter))
    else:
        yield finding("CL657", measure=measure)
    if ranked.undecided:
        yield finding("CL658", measure=measure, **_listed(ranked.undecided))
    if ranked.negligible and measure == LOCAL:
        yield finding("CL660", **_listed(ranked.negligible))
    elif ranked.negligible:
        yield finding("CL659", **_listed(ranked.negligible))


def _listed(group: dict[str, float]) -> dict[str, Any]:
    return {"parameters": tuple(group), "strengths": tuple(group.values())}


def _interactions(study: Study) -> Iterator[Finding]:
    names = [variable.short for variable in study.space.numbers]
    pairs = list(combinations(range(len(names)), 2))
    findings = [*_shared(study, names), *_local_interactions(study, names, pairs)]
    yield from findings
    if not findings and pairs and (study.sobol is not None or study.local is not None):
        yield finding("CL665")


def _shared(study: Study, names: list[str]) -> Iterator[Finding]:
    """Yield the parameters that explain more of the variance together than alone."""
    sobol = study.sobol
    if sobol is None:
        return
    beyond = sobol.total - sobol.first
    clear = np.flatnonzero(beyond - np.hypot(sobol.total_interval, sobol.first_interval) > TOGETHER)
    if clear.size:
        yield finding("CL661", **_listed({names[j]: float(beyond[j]) for j in clear}))
    if sobol.second is not None and sobol.second_interval is not None:
        for j, k in np.argwhere(np.nan_to_num(sobol.second - sobol.second_interval) > SMALL / 2.0):
            yield finding("CL662", f"{names[j]} and {names[k]}", share=float(sobol.second[j, k]))


def _local_interactions(study: Study, names: list[str], pairs: Iterable[tuple[int, int]]) -> Iterator[Finding]:
    if study.local is None:
        return
    matrix, difference = study.local.interactions, study.local.interaction_differences
    strong = [pair for pair in pairs if abs(matrix[pair]) > TOGETHER + 2.0 * difference[pair]]
    strong.sort(key=lambda pair: -abs(matrix[pair]))
    if strong:
        shown = {f"{names[j]} with {names[k]}": float(matrix[j, k]) for j, k in strong[:MOST_PAIRS]}
        yield finding("CL663", pairs=tuple(shown), strengths=tuple(shown.values()), count=len(strong))
    elif any(difference[pair] > TOGETHER for pair in pairs):
        yield finding("CL664")


def _first(study: Study) -> Iterator[Finding]:
    """Yield the parameters that alone lower the figure most."""
    first = _worthwhile(study)[:MOST_FIRST]
    if first:
        shown = [f"{curve.variable.short} to {figure(ratio, '%')}" for ratio, curve in first]
        yield finding("CL667", shown=shown, parameters=[curve.variable.short for _, curve in first], ratios=[ratio for ratio, _ in first])
    elif study.curves is not None:
        yield finding("CL666", least=WORTHWHILE)
    bounds = [curve.variable.short for _, curve in first if curve.minimum is not None and curve.minimum.bound]
    if bounds:
        yield finding("CL668", parameters=bounds)


def _worthwhile(study: Study) -> list[tuple[float, Curve]]:
    """Return the curves whose minimum lies below the present figure by `WORTHWHILE`, lowest first, each with that ratio."""
    minima = [(curve.minimum.figure / study.present, curve) for curve in study.curves or () if curve.minimum is not None]
    return sorted((one for one in minima if one[0] < 1.0 - WORTHWHILE), key=lambda one: one[0])


def _doubts(study: Study) -> Iterator[Finding]:
    if study.sobol is not None and study.sobol.total_interval.max() > WIDE:
        yield finding("CL669", interval=float(study.sobol.total_interval.max()))
    for name, sampled in (("Morris", study.morris_sample), ("Sobol", study.sobol_sample)):
        if sampled is not None and sampled.failed:
            yield finding("CL674", name, failed=sampled.failed, runs=sampled.runs, share=sampled.failed / sampled.runs)
    doubtful: dict[str, list[str]] = {}
    for slope in study.local.slopes if study.local is not None else ():
        if slope.doubt is not None:
            doubtful.setdefault(slope.doubt.code, []).append(slope.variable.short)
    for code, names in doubtful.items():
        yield finding(code, listing(names), parameters=names)
