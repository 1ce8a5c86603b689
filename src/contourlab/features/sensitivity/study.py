"""The whole study: curves, small changes and global indices of one machine under one controller along one motion."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from contourlab.design import Space
from contourlab.errors import ParameterError
from contourlab.features.sensitivity.curves import Curve, check_values, curves
from contourlab.features.sensitivity.distribution import Distribution
from contourlab.features.sensitivity.figure import FIGURES, Figure
from contourlab.features.sensitivity.indices import (
    MorrisIndices,
    SobolIndices,
    check_morris,
    check_saltelli,
    morris_indices,
    morris_points,
    saltelli_points,
    sobol_indices,
)
from contourlab.features.sensitivity.local import Local, local
from contourlab.features.sensitivity.outcome import Outcome, outcome
from contourlab.features.sensitivity.runs import Array, Judge, Runs

PARTS = ("curves", "local", "morris", "sobol")


@dataclass(frozen=True)
class Plan:
    """What is asked for.

    Attributes
    ----------
    parts : sequence of str
        Of `PARTS`.
    figure : Figure
    values : int
        Of each number, for its curve.
    base : int
        N of Saltelli's sampling.
    second : bool
        Whether Sobol's indices of pairs are wanted.
    trajectories : int
        Of Morris' design.
    logarithmic : bool
        Whether global indices are of the decimal logarithm of the figure.
    seed : int
        Of both samplings.
    """

    parts: Sequence[str] = PARTS
    figure: Figure = field(default_factory=lambda: FIGURES["integral"])
    values: int = 41
    base: int = 512
    second: bool = False
    trajectories: int = 32
    logarithmic: bool = True
    seed: int = 0

    def __post_init__(self) -> None:
        for part in self.parts:
            if part not in PARTS:
                raise ParameterError("--parts", repr(part), f"of {', '.join(PARTS)}")
        if not self.parts:
            raise ParameterError("--parts", "none", f"one of {', '.join(PARTS)} or more")

    def check(self, n: int) -> None:
        """See that it can be done with a number of numbers, ahead of all runs.

        Raises
        ------
        ParameterError
            If an option is out of range.
        """
        if "curves" in self.parts:
            check_values(self.values)
        if "morris" in self.parts:
            check_morris(self.trajectories)
        if "sobol" in self.parts:
            check_saltelli(n, self.base)


@dataclass(frozen=True, eq=False)
class Study:
    """What was found; None for what was not asked for.

    Attributes
    ----------
    space : Space
    plan : Plan
    figure : float [SI]
        With all numbers at their values.
    curves : tuple of Curve or None
    local : Local or None
    morris, sobol : indices or None
    morris_outcome, sobol_outcome : Outcome or None
        What they were taken from.
    distributions : tuple of Distribution
    """

    space: Space
    plan: Plan
    figure: float
    curves: tuple[Curve, ...] | None
    local: Local | None
    morris: MorrisIndices | None
    morris_outcome: Outcome | None
    sobol: SobolIndices | None
    sobol_outcome: Outcome | None
    distributions: tuple[Distribution, ...]


def sensitivity_study(
    space: Space,
    runs: Runs,
    plan: Plan,
    drawn: Sequence[Distribution],
    level: float,
    *,
    limits: dict[str, tuple[float, float]] | None = None,
    stage: Callable[[str], None] = lambda words: None,
) -> Study:
    """Make the study.

    Parameters
    ----------
    space : Space
    runs : Runs
    plan : Plan
    drawn : sequence of Distribution
        Of each number, for the global indices.
    level : float [SI]
        The figure of a run at the failure limit, see `contourlab.features.sensitivity.figure.failure_level`.
    limits : dict of str to (float, float) [SI], optional
        What numbers may be at all.
    stage : callable
        Told what comes next.

    Raises
    ------
    ParameterError
        If an option is out of range, too many runs fail, or the run fails with all numbers at their values.
    """
    n, judge = len(space.numbers), runs.judge(plan.figure.key)
    plan.check(n)
    points = saltelli_points(n, plan.base, plan.second, plan.seed) if "sobol" in plan.parts else None
    paths = morris_points(n, plan.trajectories, plan.seed) if "morris" in plan.parts else None
    stage("the run as it is")
    figure = float(judge(space_values(space))[0])
    if math.isnan(figure):
        raise ParameterError("the run as it is", "fails", "one that holds: start from other values")
    lines = little = effects = shares = effect_outcome = share_outcome = None
    if "curves" in plan.parts:
        stage("curves, one number at a time")
        lines = curves(space, judge, plan.values)
    if "local" in plan.parts:
        stage("small changes and interactions")
        little = local(space, judge, limits)
    if paths is not None:
        stage("elementary effects (Morris)")
        effect_outcome = _outcome(space, judge, drawn, paths, plan, level)
        effects = morris_indices(paths, effect_outcome.values, plan.seed)
    if points is not None:
        stage("variance shares (Sobol)")
        share_outcome = _outcome(space, judge, drawn, points, plan, level)
        shares = sobol_indices(share_outcome.values, n, plan.second, plan.seed)
    return Study(space, plan, figure, lines, little, effects, effect_outcome, shares, share_outcome, tuple(drawn))


def holds(space: Space, runs: Runs) -> bool:
    """Tell whether the run with all numbers at their values does not fail."""
    return all(bool(np.isfinite(values[0])) for values in runs(space_values(space)).values())


def space_values(space: Space) -> dict[str, Array]:
    """Return the values [SI] of all numbers as one run takes them."""
    return {number.name: np.array([number.value]) for number in space.numbers}


def _outcome(space: Space, judge: Judge, drawn: Sequence[Distribution], points: Array, plan: Plan, level: float) -> Outcome:
    columns = {one.number.name: one.values(points[:, j]) for j, one in enumerate(drawn)}
    return outcome(judge(columns), level, plan.logarithmic, space, points)
