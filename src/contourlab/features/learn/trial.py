"""One trial: its figures, its record for the law, and the law's prior knowledge."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from contourlab.analysis.linear.coupled_loop import axis_link, impulse_responses
from contourlab.arrays import Array
from contourlab.components.learning.law import LearningProblem, TrialRecord
from contourlab.errors import ComponentError, refuse
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine
from contourlab.loop.trials import Trial, Trials
from contourlab.metrics.judge import judge
from contourlab.result import Result, Signal


@dataclass(frozen=True)
class TrialFigures:
    """Figures of one trial, over the judged samples.

    Attributes
    ----------
    trial : int
        0 is the first, which runs with nothing learned or with the given table.
    contour_rms, contour_max, contour_mean : float [m]
        Figures of the exact contour error.
    tracking_rms, tracking_max : tuple of float, one for each axis [m]
        Figures of the reference minus the true position of the axis.
    command_peak : tuple of float, one for each axis [command unit]
        Largest magnitude of the command.
    saturated : int
        Samples at which a command exceeds the limit of its drive.
    part_max : float [m]
        Largest distance of the tool from the programmed path; NaN if not requested.
    change : float [m]
        Rms difference over all axes between this tracking error and that of the trial before; NaN for the first.
    failed : str
        Why the trial stopped early: all errors are then NaN. Empty if it did not.
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
        """The error that learning reduces: the contour rms; with a single axis, which has no contour, the tracking rms."""
        return self.contour_rms if len(self.tracking_rms) > 1 else self.tracking_rms[0]

    @property
    def tracking(self) -> float:
        """Tracking rms over all axes [m]."""
        return float(np.sqrt(np.sum(np.square(self.tracking_rms))))


def figures_of(trial: int, run: Trial, trials: Trials) -> TrialFigures:
    """Return the figures of a trial; `trials` is its runner."""
    n_axis = run.position.shape[1]
    if not run.status.ok:
        unknown = (math.nan,) * n_axis
        reason = f"axis {run.status.axis}, sample {run.status.sample}: {run.status.reason}"
        return TrialFigures(trial, math.nan, math.nan, math.nan, unknown, unknown, unknown, 0, failed=reason)
    cut = trials.judged
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
    """Return the record of a trial for the law.

    `table` is the signal added to the command (zeros if the reference is learned); `beforehand` is the feedforward command, known without
    any error. Both are (n_sample, n_axis).
    """
    # An observer closes its own loop around the plant with its estimate; no table can replace it.
    feedback = run.command - run.excess - table - beforehand + run.estimate
    return TrialRecord(trials.position - run.measured, feedback, run.excess, run.contour_vector)


def part_error(tool: Array, trials: Trials) -> float:
    """Return the largest distance [m] of the tool positions (n_sample, n_axis) from the programmed path, over the judged samples."""
    signals = {
        "tool_position": Signal(tool, ("sample", "axis"), "m"),
        "reference": Signal(trials.position, ("sample", "axis"), "m"),
        "arc_length": Signal(trials.arc_length, ("sample",), "m"),
    }
    judged = judge(Result("trial", trials.machine.axis_names, trials.machine.servo_period, signals), trials.reference)
    return float(np.abs(judged["part_error"][trials.judged]).max())


def learning_problem(machine: Machine, controller: Controller, reference: Reference, target: str, arc_length: Array) -> LearningProblem:
    """Return the law's prior knowledge: the path direction at each sample, and the response to the learned input."""
    tangent = reference.path.derivatives(arc_length, order=1)[1]
    tangent = tangent / np.linalg.norm(tangent, axis=1, keepdims=True)

    def motion() -> tuple[Array, Array]:
        samples = reference.block(0, reference.n_sample)
        return samples.velocity, samples.acceleration

    return LearningProblem(machine.servo_period, tangent, lambda: input_response(machine, controller, target, len(arc_length)), motion)


def input_response(machine: Machine, controller: Controller, target: str, n_sample: int) -> Array:
    """Return the impulse response of each axis' measured position to the learned input.

    Parameters
    ----------
    machine, controller
        Used axis by axis, without contour coupling and nonlinear parts.
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
    # The learned signal enters after the feedforward.
    axes = [axis_link(machine, controller, name) for name in machine.axis_names]
    for name, axis in zip(machine.axis_names, axes, strict=True):
        refuse(not axis.loop.stable, ComponentError, f"axis {name}: the loop is unstable, so the law has no response to learn with")
    return impulse_responses(axes, n_sample, target)
