"""The study: curves, small changes and global indices for one machine, one controller and one motion."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from contourlab.app.json_values import HIDDEN
from contourlab.arrays import Array
from contourlab.errors import ParameterError, UnitError
from contourlab.features.sensitivity.curves import Curve, Local, curves, local
from contourlab.features.sensitivity.options import STAGES, Plan
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
        if self.kind not in KINDS:
            raise ParameterError("--distribution", repr(self.kind), f"one of {', '.join(KINDS)}")
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
    wanted = f"a deviation of {variable.short} above 0, such as 5 %{f' or 2 {unit}' if unit else ''}"
    try:
        if text.endswith("%"):
            deviation = abs(variable.value) * float(text[:-1]) / 100.0
        else:
            deviation = float(read_number(text if variable.unit else float(text), variable.unit, variable.display))
    except (UnitError, ValueError) as error:
        raise ParameterError("--deviation", repr(text), wanted) from error
    if not 0.0 < deviation < math.inf:
        raise ParameterError("--deviation", repr(text), wanted)
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
        raise ParameterError(
            "runs", f"{100.0 * share:.0f} % failed", f"{right}. Narrow the bounds, beginning with {_strayed(space, points[bad])}"
        )
    cap = level if math.isfinite(level) else BEYOND * float(figures[~bad].max())
    values = np.minimum(np.where(bad, cap, figures), cap)
    if logarithmic:
        flat = values <= 0.0
        if flat.any():
            where = f"a figure of {values.min():g} in {int(flat.sum())} of {flat.size} runs, mainly {_strayed(space, points[flat])}"
            raise ParameterError("--transform log", where, "above 0 in all runs; use --transform none, which reuses these runs")
        values = np.log10(values)
    return Sample(values, logarithmic, values.size, int(bad.sum()), cap)


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
    if math.isnan(present):
        raise ParameterError("run at the present values", "failed", "successful: start from other values")
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


def present_values(space: Space) -> dict[str, Array]:
    """Return the present values [SI] of all parameters, as one run."""
    return {variable.name: np.array([variable.value]) for variable in space.numbers}
