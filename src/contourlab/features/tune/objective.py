"""Figures of a run: the objective of a calibration in batches, and all figures of one controller from the exact judge."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from contourlab.analysis.linear.margins import Margins
from contourlab.app.json_values import HIDDEN
from contourlab.arrays import Array
from contourlab.errors import DivergenceError, ParameterError
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine, simulate
from contourlab.metrics import judge, summarise
from contourlab.metrics.judge import check_follows
from contourlab.result import Result
from contourlab.study import Evaluator
from contourlab.study.guards import Guards

FIGURES = {
    "part_error_max": ("part error, largest", "um"),
    "part_error_rms": ("part error, rms", "um"),
    "contour_error_integral": ("contour error, integral", "um s"),
    "contour_error_rms": ("contour error, rms", "um"),
    "contour_error_max": ("contour error, largest", "um"),
    "contour_error_signed_mean": ("contour error, signed mean", "um"),
    "tracking_error_rms": ("tracking error, rms", "um"),
    "command_energy": ("command energy", "s"),
    "command_largest": ("largest command, share of the drive's limit", "%"),
    "limited_share": ("time at a drive's limit", "%"),
}
"""Figures of a run: printed name and display unit."""
GOALS = {
    "part": "part_error_max",
    "integral": "contour_error_integral",
    "max": "contour_error_max",
    "rms": "contour_error_rms",
    "tracking": "tracking_error_rms",
    "energy": "command_energy",
}
"""Figures that a calibration can minimise."""
TIE = 1e-3
"""Weight of the part error's rms beside its largest value: it decides between gains that reach the same."""


@dataclass(frozen=True)
class Goal:
    """Figures to minimise, with weights.

    Attributes
    ----------
    weights : tuple of (str, float)
        Names from `GOALS`, weights > 0. In a sum, each figure is relative to its value at the start.
    """

    weights: tuple[tuple[str, float], ...] = (("part", 1.0),)

    def __post_init__(self) -> None:
        names = [name for name, _ in self.weights]
        for name, weight in self.weights:
            if name not in GOALS:
                raise ParameterError("objective", repr(name), f"one of {', '.join(GOALS)}, or a sum such as integral=1,energy=0.1")
            if not (weight > 0.0 and math.isfinite(weight)):
                raise ParameterError("objective", f"{name}={weight:g}", "a weight > 0")
        if not names or len(set(names)) < len(names):
            raise ParameterError("objective", ",".join(names) or "none", "at least one figure, none of them twice")

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
    def figure(self) -> str | None:
        """Key of the only figure in `FIGURES`; None for a sum."""
        return GOALS[self.weights[0][0]] if len(self.weights) == 1 else None

    @property
    def label(self) -> str:
        """The goal as text."""
        return self.weights[0][0] if self.figure else " + ".join(f"{weight:g} {name}" for name, weight in self.weights)

    @property
    def unit(self) -> str:
        """Display unit of the objective; empty for a sum."""
        return FIGURES[self.figure][1] if self.figure else ""


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
    evaluator : Evaluator
        Computes the part error from now on if the goal includes it.
    start : mapping of str to float [SI]
        Parameters at which the figures of a sum are scaled to 1.

    Notes
    -----
    A largest part error counts as larger by as much as the rms exceeds that of the start: a circle that shrinks to hide its reversal spikes
    is no better.
    """

    evaluator: Evaluator
    goal: Goal
    start: Mapping[str, float]
    _scales: dict[str, float] = field(default_factory=dict, init=False, repr=False)
    _rms: float = field(default=math.inf, init=False, repr=False)

    def __post_init__(self) -> None:
        self.evaluator.part |= any(name == "part" for name, _ in self.goal.weights)
        if self.evaluator.part:
            rms = float(self.at(self.start).figures["part_error_rms"][0])
            self._rms = rms if rms > 0.0 else math.inf
        if self.goal.figure is None:
            figures = self.at(self.start).figures
            scales = {GOALS[name]: float(figures[GOALS[name]][0]) for name, _ in self.goal.weights}
            if not all(math.isfinite(scale) and scale > 0.0 for scale in scales.values()):
                raise ParameterError("objective", self.goal.label, "a single figure: the run at the start fails, so a sum has no scale")
            self._scales = scales

    def __call__(self, columns: Mapping[str, Array]) -> ObjectiveValues:
        """Run with parameter values [SI], each (n,)."""
        figures = self.evaluator(columns)
        if self.evaluator.part:
            rms = figures["part_error_rms"]
            excess = np.maximum(rms / self._rms - 1.0, 0.0)
            figures |= {"part_error_max": (1.0 + excess) * figures["part_error_max"] + TIE * rms}
        values = figures[GOALS[self.goal.weights[0][0]]]
        if self._scales:
            parts = [weight * figures[GOALS[name]] / self._scales[GOALS[name]] for name, weight in self.goal.weights]
            values = np.asarray(np.sum(parts, axis=0))
        failed = (figures["failed_at"] >= 0.0) | ~np.isfinite(values)
        return ObjectiveValues(np.where(failed, np.inf, values), figures["limited_share"], figures["command_largest"], figures)

    def at(self, values: Mapping[str, float]) -> ObjectiveValues:
        """Run once with parameter values [SI]."""
        return self({name: np.array([value]) for name, value in values.items()})


@dataclass(frozen=True, eq=False)
class Evaluation:
    """One controller: a single run, judged exactly, and the exact margins.

    Attributes
    ----------
    figures : dict of str to float [SI]
        By the keys of `FIGURES`; nan if the run failed.
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


def evaluate(
    machine: Machine, controller: Controller, reference: Reference, guards: Guards, *, seed: int = 0, moving: bool = False
) -> Evaluation:
    """Run a controller once, judge it exactly, and check it against the bounds of `guards`.

    Parameters
    ----------
    machine, controller, reference
        See `contourlab.loop.simulate`.
    seed : int
        Seed of all noise.
    moving : bool
        Whether the axes start with the velocity of the reference.
    """
    exact = Guards([(machine, controller)], guards.bounds)
    margins = exact.exact({})
    try:
        run = judge(simulate(machine, controller, reference, seed=seed, moving=moving), reference)
        check_follows(run, reference)
    except DivergenceError as error:
        return Evaluation(dict.fromkeys(FIGURES, math.nan), margins, (f"diverges: {error}",), None)
    figures = _figures(run, machine, reference)
    return Evaluation(figures, margins, exact.broken({}, figures["limited_share"], figures["command_largest"], margins), run)


def _figures(run: Result, machine: Machine, reference: Reference) -> dict[str, float]:
    metrics = summarise(run, reference)
    error = metrics.contour_error
    judged = metrics.judged.samples
    tracking = np.linalg.norm((run["reference"] - run["position"])[judged], axis=1)
    # Relative to the drive's limit, if any, as in `contourlab.loop.BatchResult`.
    limits = np.array([getattr(axis.drive, "limit", math.inf) for axis in machine.axes], dtype=float)
    scales = np.where(np.isfinite(limits), limits, 1.0)
    asked, applied = run["command"][judged], run["applied_command"][judged]
    return {
        "part_error_max": metrics.part_error.max,
        "part_error_rms": metrics.part_error.rms,
        "contour_error_integral": error.integral,
        "contour_error_rms": error.rms,
        "contour_error_max": error.max,
        "contour_error_signed_mean": error.signed_mean,
        "tracking_error_rms": float(np.sqrt(np.mean(tracking**2))),
        "command_energy": float(((applied / scales) ** 2).sum() * run.servo_period),
        "command_largest": float((np.abs(asked) / scales).max()),
        "limited_share": float((np.abs(asked) > limits).any(axis=1).mean()),
    }
