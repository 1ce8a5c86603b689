"""The study: curves, small changes and global indices for one machine, one controller and one motion; and its conclusions."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import Any

import numpy as np

from contourlab.app.json_values import HIDDEN
from contourlab.arrays import Array, Flags
from contourlab.errors import ParameterError, check_known, refuse, refused
from contourlab.features.sensitivity.curves import CHANGE, Curve, Local, curves, local, present_values
from contourlab.features.sensitivity.options import STAGES, Plan
from contourlab.figures import figure, grouped, listing
from contourlab.findings import Finding, finding
from contourlab.loop.parameters import fits
from contourlab.scenario.quantities import read_number
from contourlab.study import DesignVariable, Runner, Space
from contourlab.study.design import morris_points, saltelli_points
from contourlab.study.space import Distribution
from contourlab.study.statistics import MorrisIndices, SobolIndices, morris_indices, sobol_indices

UNIFORM, LOG_UNIFORM, NORMAL = KINDS = ("uniform", "log-uniform", "normal")
REFUSED = 0.25
"""Largest share of failed runs; with more, indices are refused."""
BEYOND = 10.0
"""Without a following-error limit, a failed run counts as this multiple of the worst successful one."""


@dataclass(frozen=True)
class Drawn:
    """The distribution of one parameter within its bounds.

    Attributes
    ----------
    variable : DesignVariable
    kind : str
        One of `KINDS`; ``"normal"`` is centred on the present value and truncated at the bounds.
    deviation : float [SI], > 0
        Standard deviation of a normal distribution before truncation.
    """

    variable: DesignVariable = field(metadata=HIDDEN)
    kind: str = UNIFORM
    deviation: float = 0.0

    def __post_init__(self) -> None:
        variable = self.variable
        check_known("--distribution", self.kind, KINDS)
        if self.kind == LOG_UNIFORM and variable.low <= 0.0:
            raise ParameterError(variable.name, f"bounds {variable.low:g} to {variable.high:g}", "above 0 for a log-uniform distribution")
        if self.kind == NORMAL and not 0.0 < self.deviation < math.inf:
            given = f"{self.deviation:g}" if self.deviation else "no deviation"
            raise ParameterError(variable.name, given, f'given a deviation, as --deviation "{variable.short}=5 %"')
        if self.kind == NORMAL and not variable.low <= variable.value <= variable.high:
            raise ParameterError(variable.name, f"{variable.value:g}", "within its bounds for a normal distribution", variable.unit)

    def values(self, places: Array) -> Array:
        """Return the values [SI] at cumulative probabilities from 0 to 1."""
        low, high = self.variable.low, self.variable.high
        numbers = (self.variable.value, self.deviation) if self.kind == NORMAL else (low, high)
        return Distribution(self.kind, numbers, low, high).values(places)


def distributions(space: Space, kind: str = UNIFORM, deviations: Sequence[str] = ()) -> tuple[Drawn, ...]:
    """Return a distribution for each parameter of a space.

    Parameters
    ----------
    space : Space
    kind : str
        Distribution of the parameters without a deviation.
    deviations : sequence of str
        ``NAME=DEVIATION`` in ``%`` of the value or in the parameter's unit, or one deviation for all. These parameters are normal.

    Raises
    ------
    ParameterError
        If a name is not in the space, or a deviation cannot be read.
    """
    given: dict[str, float] = {}
    for text in deviations:
        name, equals, wanted = (part.strip() for part in text.rpartition("="))
        chosen = [variable for variable in space.numbers if not equals or fits(variable.name, name)]
        if not chosen:
            known = ", ".join(variable.short for variable in space.numbers[:4])
            raise ParameterError("--deviation", repr(text), f"NAME=DEVIATION with a varied parameter, such as {known}")
        given |= {variable.name: _deviation(variable, wanted) for variable in chosen}
    return tuple(
        Drawn(variable, NORMAL, given[variable.name]) if variable.name in given else Drawn(variable, kind) for variable in space.numbers
    )


def _deviation(variable: DesignVariable, text: str) -> float:
    unit = variable.display_unit
    with refused("--deviation", text, f"a deviation of {variable.short} above 0, such as 5 %{f' or 2 {unit}' if unit else ''}"):
        if text.endswith("%"):
            deviation = abs(variable.value) * float(text[:-1]) / 100.0
        else:
            deviation = read_number(text if variable.unit else float(text), variable.unit, variable.display)
        if not 0.0 < deviation < math.inf:
            raise ValueError
    return deviation


@dataclass(frozen=True, eq=False)
class Sample:
    """Figures of runs, prepared for an estimator.

    Attributes
    ----------
    values : ndarray (n,)
        Decimal logarithm of the figure [SI] if `logarithmic`, else the figure [SI].
    logarithmic : bool
    runs, failed : int
    cap : float [SI]
        Upper limit of the figures, and the value of a failed run.
    """

    values: Array = field(metadata=HIDDEN)
    logarithmic: bool
    runs: int
    failed: int
    cap: float


def sample(figures: Array, level: float, logarithmic: bool, space: Space, points: Array) -> Sample:
    """Return figures prepared for an estimator.

    Parameters
    ----------
    figures : ndarray (n,) [SI]
        nan where a run failed.
    level : float [SI]
        Figure of a run that is always at the failure limit; infinite without a limit.
    logarithmic : bool
    space : Space
    points : ndarray (n, n_parameter)
        Points of the runs, 0 to 1, to report where runs fail.

    Raises
    ------
    ParameterError
        If more than `REFUSED` of the runs failed, or `logarithmic` is set and a figure is not above 0.
    """
    bad = np.isnan(figures)
    share = float(bad.mean())
    if share > REFUSED:
        right = f"at most {100.0 * REFUSED:.0f} %: the indices would show what makes the loop fail, not what makes it accurate"
        cure = f"{right}. Narrow the bounds, beginning with {_strayed(space, points[bad])}"
        raise ParameterError("runs", f"{100.0 * share:.0f} % failed", cure)
    cap = level if math.isfinite(level) else BEYOND * float(figures[~bad].max())
    values = np.minimum(np.where(bad, cap, figures), cap)
    flat = values <= 0.0
    if logarithmic and flat.any():
        where = f"a figure of {values.min():g} in {int(flat.sum())} of {flat.size} runs, mainly {_strayed(space, points[flat])}"
        raise ParameterError("--transform log", where, "above 0 in all runs; use --transform none, which reuses these runs")
    return Sample(np.log10(values) if logarithmic else values, logarithmic, values.size, int(bad.sum()), cap)


def _strayed(space: Space, points: Array) -> str:
    """Name the parameter whose mean over points (n, n_parameter) is farthest from the middle of its range, and the nearer end."""
    off = points.mean(axis=0) - 0.5
    at = int(np.argmax(np.abs(off)))
    return f"{space.numbers[at].short} at the {'upper' if off[at] > 0.0 else 'lower'} end"


@dataclass(frozen=True, eq=False)
class Study:
    """Results; None for a part that was not requested.

    Attributes
    ----------
    plan : Plan
    space : Space
    distributions : tuple of Drawn
        Distributions of the parameters, in the order of the space.
    present : float [SI]
        The figure with all parameters at their present values.
    curves : tuple of Curve or None
    local : Local or None
    morris, sobol : indices or None
    morris_sample, sobol_sample : Sample or None
    """

    plan: Plan = field(metadata=HIDDEN)
    space: Space
    distributions: tuple[Drawn, ...]
    present: float
    curves: tuple[Curve, ...] | None = None
    local: Local | None = None
    morris: MorrisIndices | None = None
    morris_sample: Sample | None = None
    sobol: SobolIndices | None = None
    sobol_sample: Sample | None = None


def sensitivity_study(
    space: Space,
    runs: Runner,
    plan: Plan,
    drawn: Sequence[Drawn],
    level: float,
    stage: Callable[[str], None] = lambda name: None,
) -> Study:
    """Run the study.

    Parameters
    ----------
    space : Space
    runs : Runner
    plan : Plan
    drawn : sequence of Drawn
        Distribution of each parameter, for the global indices.
    level : float [SI]
        Figure of a run whose following error is always at its limit.
    stage : callable
        Called with the name of each stage.

    Raises
    ------
    ParameterError
        If an option is out of range, too many runs fail, or the run fails with all parameters at their present values.
    """
    n, judge = len(space.numbers), runs.judge(plan.judged.name)
    plan.work(n)

    def begins(part: str) -> bool:
        if part in plan.chosen:
            stage(STAGES[part])
        return part in plan.chosen

    def sampled(points: Array) -> Sample:
        columns = {one.variable.name: one.values(points[:, j]) for j, one in enumerate(drawn)}
        return sample(judge(columns), level, plan.transform == "log", space, points)

    stage("present values")
    present = float(judge(present_values(space))[0])
    refuse(math.isnan(present), ParameterError, "run at the present values", "failed", "successful: start from other values")
    study = Study(plan, space, tuple(drawn), present)
    if begins("curves"):
        study = replace(study, curves=curves(space, judge, plan.values))
    if begins("local"):
        study = replace(study, local=local(space, judge))
    if begins("morris"):
        points = morris_points(n, plan.trajectories, plan.seed)
        effects = sampled(points)
        study = replace(study, morris_sample=effects, morris=morris_indices(points, effects.values, plan.seed))
    if begins("sobol"):
        shares = sampled(saltelli_points(n, plan.base, plan.second_order, plan.seed))
        study = replace(study, sobol_sample=shares, sobol=sobol_indices(shares.values, n, plan.second_order, plan.seed))
    return study


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
        effect = study.morris.mu_star
        return _ranking(study, "mu*", effect, study.morris.mu_star_interval, SMALL * float(effect.max()))
    if study.local is not None:
        slopes = np.array([abs(slope.sensitivity) for slope in study.local.slopes])
        differences = np.array([slope.difference for slope in study.local.slopes])
        return _ranking(study, LOCAL, np.nan_to_num(slopes), np.nan_to_num(differences, nan=np.inf), SMALL)
    good = [curve.figures[np.isfinite(curve.figures)] for curve in study.curves or ()]
    decades = np.array([float(np.log10(v.max() / v.min())) if v.size and v.min() > 0.0 else 0.0 for v in good])
    return _ranking(study, "change over its curve", decades, np.zeros(len(decades)), float(np.log10(1.0 + CHANGE)))


def _ranking(study: Study, measure: str, strength: Array, interval: Array, bound: float) -> Ranking:
    order = np.argsort(-strength, kind="stable")

    def named(which: Flags) -> dict[str, float]:
        return {study.space.numbers[j].short: float(strength[j]) for j in order if which[j]}

    alone = {curve.variable.short for _, curve in _worthwhile(study)}
    matter = (strength - interval > bound) | np.array([variable.short in alone for variable in study.space.numbers])
    negligible = ~matter & (strength + interval < bound)
    return Ranking(measure, named(matter), named(~matter & ~negligible), named(negligible))


def verdict(study: Study) -> tuple[Finding, ...]:
    """Return the conclusions of a study."""
    return (*_groups(ranking(study)), *_interactions(study), *_first(study), *_doubts(study))


def _groups(ranked: Ranking) -> Iterator[Finding]:
    measure = ranked.measure
    yield finding("CL656", measure=measure, **_listed(ranked.matter)) if ranked.matter else finding("CL657", measure=measure)
    if ranked.undecided:
        yield finding("CL658", measure=measure, **_listed(ranked.undecided))
    if ranked.negligible:
        yield finding("CL660" if measure == LOCAL else "CL659", **_listed(ranked.negligible))


def _listed(group: dict[str, float]) -> dict[str, Any]:
    return {"parameters": tuple(group), "strengths": tuple(group.values())}


def _interactions(study: Study) -> list[Finding]:
    """Return which parameters explain more of the variance together than alone, and which interact near the present values."""
    names = [variable.short for variable in study.space.numbers]
    pairs = list(combinations(range(len(names)), 2))
    findings: list[Finding] = []
    if (sobol := study.sobol) is not None:
        beyond = sobol.total - sobol.first
        clear = np.flatnonzero(beyond - np.hypot(sobol.total_interval, sobol.first_interval) > TOGETHER)
        findings += [finding("CL661", **_listed({names[j]: float(beyond[j]) for j in clear}))] if clear.size else []
        if sobol.second is not None and sobol.second_interval is not None:
            sure = np.argwhere(np.nan_to_num(sobol.second - sobol.second_interval) > SMALL / 2.0)
            findings += [finding("CL662", f"{names[j]} and {names[k]}", share=float(sobol.second[j, k])) for j, k in sure]
    if study.local is not None:
        matrix, difference = study.local.interactions, study.local.interaction_differences
        strong = [pair for pair in pairs if abs(matrix[pair]) > TOGETHER + 2.0 * difference[pair]]
        strong.sort(key=lambda pair: -abs(matrix[pair]))
        shown = {f"{names[j]} with {names[k]}": float(matrix[j, k]) for j, k in strong[:MOST_PAIRS]}
        if strong:
            findings.append(finding("CL663", pairs=tuple(shown), strengths=tuple(shown.values()), count=len(strong)))
        elif any(difference[pair] > TOGETHER for pair in pairs):
            findings.append(finding("CL664"))
    if not findings and pairs and (study.sobol is not None or study.local is not None):
        findings.append(finding("CL665"))
    return findings


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
    return sorted(((ratio, curve) for ratio, curve in minima if ratio < 1.0 - WORTHWHILE), key=lambda pair: pair[0])


def _doubts(study: Study) -> Iterator[Finding]:
    if study.sobol is not None and study.sobol.total_interval.max() > WIDE:
        yield finding("CL669", interval=float(study.sobol.total_interval.max()))
    for name, sampled in (("Morris", study.morris_sample), ("Sobol", study.sobol_sample)):
        if sampled is not None and sampled.failed:
            yield finding("CL674", name, failed=sampled.failed, runs=sampled.runs, share=sampled.failed / sampled.runs)
    slopes = study.local.slopes if study.local is not None else ()
    doubtful = grouped((slope.doubt.code, slope.variable.short) for slope in slopes if slope.doubt is not None)
    for code, names in doubtful.items():
        yield finding(code, listing(names), parameters=names)
