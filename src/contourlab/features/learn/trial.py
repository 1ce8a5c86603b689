"""One trial: its figures, what the law gets of it, and what the law knows beforehand."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from contourlab.analysis.linear.coupled_loop import axis_link, impulse_responses
from contourlab.arrays import Array
from contourlab.components.learning.law import LearningProblem, TrialRecord
from contourlab.errors import ComponentError
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine
from contourlab.loop.trials import Trial, Trials
from contourlab.metrics.judge import judge
from contourlab.result import Result, Signal


@dataclass(frozen=True)
class TrialFigures:
    """Figures of one trial, over the samples that count.

    Attributes
    ----------
    trial : int
        0 is the first, which has learned nothing, or what the table given says.
    contour_rms, contour_max, contour_mean : float [m]
        Of the exact contour error.
    tracking_rms, tracking_max : tuple of float, one for each axis [m]
        Of the reference less the axis' true position.
    command_peak : tuple of float, one for each axis [command unit]
        Largest magnitude of the command.
    saturated : int
        Samples at which a command lay beyond the limit of its drive.
    part_max : float [m]
        Largest distance of the tool from the programmed path; NaN where it was not asked for.
    change : float [m]
        Rms over all axes by which the tracking error differs from that of the trial before; NaN for the first.
    failed : str
        Why the trial stopped early; empty if it did not. All errors are NaN then.
    """

    trial: int
    contour_rms: float
    contour_max: float
    contour_mean: float
    tracking_rms: tuple[float, ...]
    tracking_max: tuple[float, ...]
    command_peak: tuple[float, ...]
    saturated: int
    part_max: float = math.nan
    change: float = math.nan
    failed: str = ""

    @property
    def merit(self) -> float:
        """What learning is to lower: the contour rms; with a single axis, which has no contour, the tracking rms."""
        return self.contour_rms if len(self.tracking_rms) > 1 else self.tracking_rms[0]

    @property
    def tracking(self) -> float:
        """Tracking rms over all axes [m]."""
        return float(np.sqrt(np.sum(np.square(self.tracking_rms))))

    def having(self, **figures: float) -> TrialFigures:
        """Return a copy with other figures."""
        return replace(self, **figures)  # type: ignore[arg-type]


def figures_of(trial: int, run: Trial, trials: Trials) -> TrialFigures:
    """Return the figures of the trial that has just run."""
    n_axis = run.position.shape[1]
    if not run.status.ok:
        unknown = (math.nan,) * n_axis
        reason = f"axis {run.status.axis}, sample {run.status.sample}: {run.status.reason}"
        return TrialFigures(trial, math.nan, math.nan, math.nan, unknown, unknown, unknown, 0, failed=reason)
    cut = slice(*trials.window)
    off = trials.position[cut] - run.position[cut]
    command = run.command[cut]
    same = trials.reference.programmed is trials.reference.path
    return TrialFigures(
        trial,
        run.contour_rms,
        run.contour_max,
        run.contour_mean,
        tuple(np.sqrt(np.einsum("ij,ij->j", off, off) / len(off)).tolist()),
        tuple(np.maximum(off.max(axis=0), -off.min(axis=0)).tolist()),
        tuple(np.maximum(command.max(axis=0), -command.min(axis=0)).tolist()),
        int(run.excess[cut].any(axis=1).sum()),
        run.contour_max if same else math.nan,
    )


def record_of(run: Trial, trials: Trials, table: Array, beforehand: Array) -> TrialRecord:
    """Return what the law gets of a trial.

    `table` is what was added to the command (zeros where the reference is learned), `beforehand` the command known without any error;
    both (n_sample, n_axis).
    """
    # An observer's estimate closes its own loop around the plant; no table can replace it.
    feedback = run.command - run.excess - table - beforehand + run.estimate
    return TrialRecord(trials.position - run.measured, feedback, run.excess, run.contour_vector)


def part_error(tool: Array, trials: Trials) -> float:
    """Return the largest distance [m] of the tool's positions (n_sample, n_axis) from the programmed path, over the samples that count."""
    signals = {
        "tool_position": Signal(tool, ("sample", "axis"), "m"),
        "reference": Signal(trials.position, ("sample", "axis"), "m"),
        "arc_length": Signal(trials.arc_length, ("sample",), "m"),
    }
    judged = judge(Result("trial", trials.machine.axis_names, trials.machine.servo_period, signals), trials.reference)
    return float(np.abs(judged["part_error"][slice(*trials.window)]).max())


def learning_problem(machine: Machine, controller: Controller, reference: Reference, target: str, arc_length: Array) -> LearningProblem:
    """Return what a law knows before the first trial: the path's direction at each sample, and the response to what is learned."""
    tangent = reference.path.derivatives(arc_length, order=1)[1]
    tangent = tangent / np.linalg.norm(tangent, axis=1, keepdims=True)
    return LearningProblem(machine.servo_period, tangent, lambda: input_response(machine, controller, target, len(arc_length)))


def input_response(machine: Machine, controller: Controller, target: str, n_sample: int) -> Array:
    """Return the impulse response of each axis' measured position to the learned input.

    Parameters
    ----------
    machine, controller
        Taken axis by axis, without contour coupling and nonlinear parts.
    target : {"command", "reference"}
    n_sample : int
        Longest useful response.

    Returns
    -------
    ndarray (m, n_axis) [m per command unit, or m/m]
        m <= n_sample; later values are below 1e-13 of the largest.

    Raises
    ------
    ComponentError
        If a component is not linear, or a loop is not stable.
    """
    # What is learned enters behind the feedforward.
    axes = [axis_link(machine, controller, name) for name in machine.axis_names]
    for name, axis in zip(machine.axis_names, axes, strict=True):
        if not axis.loop.stable:
            raise ComponentError(f"axis {name}: an unstable loop has no response to learn with")
    return impulse_responses(axes, n_sample, target)
