"""The study: curves, small changes and global indices for one machine, one controller and one motion."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from contourlab.app.json_values import HIDDEN
from contourlab.app.quick import too_slow
from contourlab.arrays import Array
from contourlab.errors import ParameterError
from contourlab.features.sensitivity.curves import FINE, Curve, curves
from contourlab.features.sensitivity.indices import Drawn, Sample, sample
from contourlab.features.sensitivity.local import STEPS, Local, local
from contourlab.metrics.run_figures import RunFigure, goal_named
from contourlab.study import Runner, Space
from contourlab.study.design import morris_points, saltelli_points
from contourlab.study.statistics import MorrisIndices, SobolIndices, morris_indices, sobol_indices

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
