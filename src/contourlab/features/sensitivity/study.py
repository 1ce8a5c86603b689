"""The study: curves, small changes and global indices for one machine, one controller and one motion."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from contourlab.app.json_values import HIDDEN
from contourlab.app.quick import too_slow
from contourlab.arrays import Array
from contourlab.errors import ParameterError, UnitError
from contourlab.features.sensitivity.curves import FINE, STEPS, Curve, Local, curves, local
from contourlab.loop.parameters import fits
from contourlab.metrics.run_figures import RunFigure, goal_named
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


STAGES = {
    "curves": "curves, one parameter at a time",
    "local": "small changes and interactions",
    "morris": "elementary effects (Morris)",
    "sobol": "variance shares (Sobol)",
}
PARTS = tuple(STAGES)
TRANSFORMS = ("log", "none")
QUICK = (128, 64, 32, 16)
"""N of Saltelli's sampling in a quick study: the largest that fits; the smallest is the least that the indices permit."""
QUICK_VALUES = 11
"""Values of a curve in a quick study."""


@dataclass(frozen=True)
class Plan:
    """Settings of a study.

    Attributes
    ----------
    parts : sequence of str
        From `PARTS`.
    figure : str
        One of `contourlab.metrics.run_figures.GOALS`, by word or name.
    values : int, >= 5
        Number of values of each curve.
    base : int
        N of Saltelli's sampling, a power of two, >= 16.
    second : bool
        Whether to compute second-order Sobol indices.
    trajectories : int, >= 4
        Number of trajectories of Morris' design.
    transform : str
        One of `TRANSFORMS`: whether global indices use the decimal logarithm of the figure, or the figure itself.
    seed : int, >= 0
        Seed of both samplings.
    """

    parts: Sequence[str] = PARTS
    figure: str = "integral"
    values: int = 41
    base: int = 512
    second: bool = False
    trajectories: int = 32
    transform: str = "log"
    seed: int = 0

    def __post_init__(self) -> None:
        for part in self.parts:
            if part not in PARTS:
                raise ParameterError("--parts", repr(part), f"one of {', '.join(PARTS)}")
        if not self.parts:
            raise ParameterError("--parts", "none", f"at least one of {', '.join(PARTS)}")
        goal_named(self.figure, "--figure")
        if self.transform not in TRANSFORMS:
            raise ParameterError("--transform", repr(self.transform), " or ".join(TRANSFORMS))
        for name, least, part in (("values", 5, "curves"), ("trajectories", 4, "morris"), ("seed", 0, "")):
            if getattr(self, name) < least and (not part or part in self.parts):
                raise ParameterError(f"--{name}", f"{getattr(self, name)}", f"{least} or more")
        if "sobol" in self.parts and (self.base < 16 or self.base & (self.base - 1)):
            near = [2**k for k in range(4, 25) if 2**k <= max(2 * self.base, 16)][-2:]
            raise ParameterError("--base", f"{self.base}", f"a power of two, 16 or more, such as {' or '.join(map(str, near))}")

    def check(self, n: int) -> None:
        """Raise `ParameterError` if the study is not possible with `n` parameters."""
        if "sobol" in self.parts and n < 2:
            raise ParameterError("--parameter", f"{n}", "two or more for Sobol indices; with one, use --parts curves,local")

    def runs(self, n: int) -> int:
        """Return the largest number of runs that the study takes with `n` parameters."""
        return sum(runs for _, runs in self.work(n))

    def work(self, n: int) -> list[tuple[str, int]]:
        """Return first word and largest number of runs of each stage of the study with `n` parameters."""
        runs = {
            "curves": n * (self.values + 2 * FINE + 1),
            "local": 2 * STEPS * n + 1 + 4 * n**2,
            "morris": self.trajectories * (n + 1),
            "sobol": self.base * ((2 if self.second else 1) * n + 2),
        }
        return [(STAGES[part], runs[part]) for part in PARTS if part in self.parts]

    def quick(self, n: int, fits: float) -> Plan:
        """Return the largest quick study of `n` parameters whose runs fit, or the full one; if need be without the small changes.

        Raises
        ------
        ParameterError
            If no quick study fits.
        """
        for plan in (self, *self._quick_plans()):
            if plan.runs(n) <= fits:
                return plan
        raise too_slow(plan.runs(n), fits)

    def _quick_plans(self) -> Iterator[Plan]:
        fewer = tuple(part for part in self.parts if part != "local")
        for parts in dict.fromkeys((tuple(self.parts), fewer or ("local",))):
            for base in QUICK:
                yield replace(self, parts=parts, values=QUICK_VALUES, base=base, trajectories=max(base // 8, 4))

    @property
    def judged(self) -> RunFigure:
        """The figure."""
        return goal_named(self.figure, "--figure")


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
    *,
    limits: dict[str, tuple[float, float]] | None = None,
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
    limits : dict of str to (float, float) [SI], optional
        Ranges that the components accept.
    stage : callable
        Called with the name of each stage.

    Raises
    ------
    ParameterError
        If an option is out of range, too many runs fail, or the run fails with all parameters at their present values.
    """
    n, judge = len(space.numbers), runs.judge(plan.judged.name)
    plan.check(n)

    def sampled(points: Array) -> Sample:
        columns = {one.variable.name: one.values(points[:, j]) for j, one in enumerate(drawn)}
        return sample(judge(columns), level, plan.transform == "log", space, points)

    stage("present values")
    present = float(judge(present_values(space))[0])
    if math.isnan(present):
        raise ParameterError("run at the present values", "failed", "successful: start from other values")
    parts: dict[str, object] = {}
    if "curves" in plan.parts:
        stage(STAGES["curves"])
        parts["curves"] = curves(space, judge, plan.values)
    if "local" in plan.parts:
        stage(STAGES["local"])
        parts["local"] = local(space, judge, limits)
    if "morris" in plan.parts:
        stage(STAGES["morris"])
        points = morris_points(n, plan.trajectories, plan.seed)
        effects = sampled(points)
        parts |= {"morris_sample": effects, "morris": morris_indices(points, effects.values, plan.seed)}
    if "sobol" in plan.parts:
        stage(STAGES["sobol"])
        shares = sampled(saltelli_points(n, plan.base, plan.second, plan.seed))
        parts |= {"sobol_sample": shares, "sobol": sobol_indices(shares.values, n, plan.second, plan.seed)}
    return Study(plan, space, tuple(drawn), present, **parts)  # type: ignore[arg-type]


def holds(space: Space, runs: Runner) -> bool:
    """Return whether the run with all parameters at their present values succeeds."""
    return all(bool(np.isfinite(values[0])) for values in runs(present_values(space)).values())


def present_values(space: Space) -> dict[str, Array]:
    """Return the present values [SI] of all parameters, as one run."""
    return {variable.name: np.array([variable.value]) for variable in space.numbers}
