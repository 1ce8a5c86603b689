"""Figures of a run: the objective of a calibration in batches, and all figures of one controller from the exact judge."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from contourlab.analysis.linear.margins import Margins
from contourlab.app.json_values import HIDDEN
from contourlab.arrays import Array
from contourlab.errors import DivergenceError, ParameterError, refuse
from contourlab.metrics.figures import judged_part
from contourlab.metrics.judge import check_follows, judge
from contourlab.metrics.run_figures import EFFORT, FIGURES, figures_from, figures_of_run, goal_named, needs
from contourlab.result import Result
from contourlab.study import Runner, Setting, Space
from contourlab.study.guards import Bounds, Guards

TIE = 1e-3
"""Weight of the part error's rms beside its largest value: it decides between gains that reach the same."""


@dataclass(frozen=True)
class Goal:
    """Figures to minimise, with weights.

    Attributes
    ----------
    weights : tuple of (str, float)
        Words or names of `contourlab.metrics.run_figures.GOALS`, weights > 0. In a sum, each figure is relative to its value at the start.
    """

    weights: tuple[tuple[str, float], ...] = (("part", 1.0),)

    def __post_init__(self) -> None:
        names, given = self.names, ",".join(name for name, _ in self.weights)
        for name, weight in self.weights:
            refuse(not (weight > 0.0 and math.isfinite(weight)), ParameterError, "objective", f"{name}={weight:g}", "a weight > 0")
        if not 0 < len(names) == len(self.weights):
            raise ParameterError("objective", given or "none", "at least one figure, none of them twice")

    @staticmethod
    def parse(text: str) -> Goal:
        """Read ``integral``, or ``integral=1,energy=0.1``.

        Raises
        ------
        ParameterError
            If a figure is unknown, or a weight is not a positive number.

        >>> Goal.parse("integral=1, energy=0.1").weights
        (('integral', 1.0), ('energy', 0.1))
        """
        weights = []
        for part in text.split(","):
            name, given, weight = part.partition("=")
            try:
                weights.append((name.strip(), float(weight) if given else 1.0))
            except ValueError as error:
                raise ParameterError("objective", repr(part), "a figure and its weight, such as energy=0.1") from error
        return Goal(tuple(weights))

    @property
    def names(self) -> dict[str, float]:
        """Names of the figures, with their weights."""
        more = ", or a sum such as integral=1,energy=0.1"
        return {goal_named(name, "objective", more).name: weight for name, weight in self.weights}

    @property
    def figure(self) -> str | None:
        """Name of the only figure; None for a sum."""
        return next(iter(self.names)) if len(self.weights) == 1 else None

    @property
    def label(self) -> str:
        """The goal as text."""
        return self.weights[0][0] if self.figure else " + ".join(f"{weight:g} {name}" for name, weight in self.weights)

    @property
    def unit(self) -> str:
        """Display unit of the objective; empty for a sum."""
        return FIGURES[self.figure].display if self.figure else ""


@dataclass(frozen=True, eq=False)
class ObjectiveValues:
    """The objective of n runs.

    Attributes
    ----------
    value : ndarray (n,)
        Infinite where a run failed.
    limited : ndarray (n,)
        Share of the time at a drive's limit.
    largest : ndarray (n,)
        Largest command, relative to the drive's limit.
    figures : mapping of str to ndarray (n,)
        All figures.
    """

    value: Array
    limited: Array
    largest: Array
    figures: Mapping[str, Array]

    def violations(self, values: Mapping[str, float], guards: Guards) -> tuple[str, ...]:
        """Return the bounds that the first run breaks; `values` [SI] are its parameters."""
        return guards.broken(values, float(self.limited[0]), float(self.largest[0]))


@dataclass(eq=False)
class Objective:
    """A goal as a function of parameter values.

    Attributes
    ----------
    runner : Runner
        Computes from now on the figures that the goal and the guards need.
    start : mapping of str to float [SI]
        Parameters at which the figures of a sum are scaled to 1.

    Notes
    -----
    A largest part error counts as larger by as much as the rms exceeds that of the start: a circle that shrinks to hide its reversal spikes
    is no better.
    """

    runner: Runner
    goal: Goal
    start: Mapping[str, float]
    _scales: dict[str, float] = field(default_factory=dict, init=False, repr=False)
    _rms: float = field(default=math.inf, init=False, repr=False)

    def __post_init__(self) -> None:
        self.runner.figures = (*self.goal.names, *(["part_error_rms"] if self._part else []), "limited_share")
        if self._part:
            rms = float(self.at(self.start).figures["part_error_rms"][0])
            self._rms = rms if rms > 0.0 else math.inf
        if self.goal.figure is None:
            figures = self.at(self.start).figures
            self._scales = {name: float(figures[name][0]) for name in self.goal.names}
            if not all(math.isfinite(scale) and scale > 0.0 for scale in self._scales.values()):
                raise ParameterError("objective", self.goal.label, "a single figure: the run at the start fails, so a sum has no scale")

    @property
    def _part(self) -> bool:
        """Whether the part error is needed, the rms beside the largest."""
        return needs(self.goal.names)["part"]

    def __call__(self, columns: Mapping[str, Array]) -> ObjectiveValues:
        """Run with parameter values [SI], each (n,)."""
        figures = self.runner(columns)
        if self._part:
            rms = figures["part_error_rms"]
            excess = np.maximum(rms / self._rms - 1.0, 0.0)
            figures |= {"part_error_max": (1.0 + excess) * figures["part_error_max"] + TIE * rms}
        values = figures[next(iter(self.goal.names))]
        if self._scales:
            parts = [weight * figures[name] / self._scales[name] for name, weight in self.goal.names.items()]
            values = np.asarray(np.sum(parts, axis=0))
        failed = (figures["failed_at"] >= 0.0) | ~np.isfinite(values)
        return ObjectiveValues(np.where(failed, np.inf, values), figures["limited_share"], figures["command_largest"], figures)

    def at(self, values: Mapping[str, float]) -> ObjectiveValues:
        """Run once with parameter values [SI]."""
        return self({name: np.array([value]) for name, value in values.items()})


@dataclass(frozen=True, eq=False)
class Problem:
    """What a calibration minimises, what it must keep, and what it may change."""

    objective: Objective
    guards: Guards
    space: Space

    @staticmethod
    def of(runner: Runner, goal: Goal, bounds: Bounds, space: Space) -> Problem:
        """Return the problem of the setting of a runner; the figures of a sum are scaled to 1 at its values, or the nearest bounds."""
        setting, start = runner.setting, {variable.name: variable.nearest for variable in space.numbers}
        return Problem(Objective(runner, goal, start), Guards(setting.machine, setting.controller, bounds), space)


@dataclass(frozen=True, eq=False)
class Evaluation:
    """One controller: a single run, judged exactly, and the exact margins.

    Attributes
    ----------
    figures : dict of str to float [SI]
        By name; nan if the run failed.
    margins : dict of str to Margins
        By axis; omits axes without a linear model.
    violations : tuple of str
        Broken bounds.
    run : Result or None
        The judged run; None if it diverged.
    """

    figures: dict[str, float]
    margins: dict[str, Margins]
    violations: tuple[str, ...]
    run: Result | None = field(metadata=HIDDEN)

    def worse_than(self, other: Evaluation, figure: str | None) -> bool:
        """Return whether the run failed, breaks a bound, or has a larger figure; None for a goal without a single figure."""
        if self.run is None or self.violations:
            return True
        return figure is not None and self.figures[figure] > other.figures[figure]


def evaluate(setting: Setting, bounds: Bounds) -> Evaluation:
    """Run a controller once, judge it exactly, and check it against the bounds."""
    exact = Guards(setting.machine, setting.controller, bounds)
    margins = exact.exact({})
    try:
        run = judge(setting.single(), setting.reference)
        check_follows(run)
    except DivergenceError as error:
        return Evaluation(dict.fromkeys(FIGURES, math.nan), margins, (f"diverges: {error}",), None)
    part = judged_part(run, setting.reference)
    judged = part.samples
    # Relative to the drive's limit, if any, as in `contourlab.loop.BatchResult`.
    limits = np.array([getattr(axis.drive, "limit", math.inf) for axis in setting.machine.axes], dtype=float)
    scales = np.where(np.isfinite(limits), limits, 1.0)
    asked, applied = run["command"][judged], run["applied_command"][judged]
    effort = {
        "count": judged.size,
        "sum_square": ((applied / scales) ** 2).sum(),
        "largest": (np.abs(asked) / scales).max(),
        "limited": (np.abs(asked) > limits).any(axis=1).sum(),
    }
    values = figures_of_run(run, part) | figures_from(EFFORT, effort, run.servo_period)
    figures = {name: float(value) for name, value in values.items()}
    return Evaluation(figures, margins, exact.broken({}, figures["limited_share"], figures["command_largest"], margins), run)
