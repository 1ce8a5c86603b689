"""What all learning laws have in common: the record of a trial, what is known of the machine, and the form of a law."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np

from contourlab.arrays import Array, Complex
from contourlab.components.contract import Component, text_param


@dataclass(frozen=True, eq=False)
class TrialRecord:
    """What a real controller knows of a trial when it is over.

    Attributes
    ----------
    tracking_error : ndarray (n_sample, n_axis) [m]
        Reference less measured position.
    feedback_command : ndarray (n_sample, n_axis) [command unit]
        What the controllers and the coupling gave because of errors: the command that the drive accepted, less what was learned before,
        less what is known beforehand (feedforward of the reference).
    excess : ndarray (n_sample, n_axis) [command unit]
        What of the command lay beyond the drive's limit; zero where it did not saturate.
    contour_error : ndarray (n_sample, n_axis) [m] or None
        Vector from the tool, as measured, to the path; only for laws that ask for it (`LearningLaw.needs_contour_error`).
    """

    tracking_error: Array
    feedback_command: Array
    excess: Array
    contour_error: Array | None = None


class InputModel:
    """Linear model of each axis from the learned input to the measured position: convolution with an impulse response, by FFT.

    Nothing wraps around: what is fed and what comes out are as long as a trial, and zero before it.

    Parameters
    ----------
    impulse : ndarray (m, n_axis), m <= n_sample
        Position at sample i after an input of 1 at sample 0; zero from m on.
    n_sample : int
    """

    def __init__(self, impulse: Array, n_sample: int) -> None:
        from scipy.fft import next_fast_len, rfft

        self.impulse, self.n_sample = impulse[:n_sample], n_sample
        self.length = int(next_fast_len(n_sample + len(self.impulse) - 1, real=True))
        self.response: Complex = rfft(self.impulse, self.length, axis=0)

    def through(self, signal: Array, response: Complex | Array) -> Array:
        """Return what a frequency response (as long as `response`) makes of a signal (n_sample, n_axis)."""
        from scipy.fft import irfft, rfft

        # Along memory: the transforms of a signal that lies sample by sample would jump from axis to axis.
        columns = np.ascontiguousarray(signal.T)
        return np.asarray(irfft(rfft(columns, self.length) * response.T, self.length)[:, : self.n_sample].T)

    def forward(self, signal: Array) -> Array:
        """Return the positions G u that an input causes."""
        return self.through(signal, self.response)

    def adjoint(self, signal: Array) -> Array:
        """Return G' e, the transpose of `forward`."""
        return self.through(signal, self.response.conj())


@dataclass(frozen=True, eq=False)
class LearningProblem:
    """What is known before the first trial.

    Attributes
    ----------
    servo_period : float [s]
    tangent : ndarray (n_sample, n_axis)
        Direction of the path, of length 1, at the place of the reference.
    impulses : callable
        Gives the impulse responses (m, n_axis) from the learned input to the position; called only by laws that use a model.
    """

    servo_period: float
    tangent: Array
    impulses: Callable[[], Array]

    @cached_property
    def model(self) -> InputModel:
        """The model of the axes, worked out once."""
        return InputModel(self.impulses(), len(self.tangent))

    def across(self, vectors: Array) -> Array:
        """Return the part of vectors (n_sample, n_axis) that is normal to the path, v - t (t.v)."""
        return np.asarray(vectors - self.tangent * (self.tangent * vectors).sum(axis=1, keepdims=True))


class LearningLaw(Component):
    """Base of all laws: a law says what the next table is, this class keeps a saturated trial from winding it up.

    Where the drive saturated, the table does not move further in the direction in which it did.
    """

    family: ClassVar[str] = "learning"

    target: str = text_param(default="command", choices=("command", "reference"), doc="the table adds to the command or to the reference")

    @property
    def needs_contour_error(self) -> bool:
        """Whether it wants `TrialRecord.contour_error`."""
        return False

    def update(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        """Return the table of the next trial.

        Parameters
        ----------
        table : ndarray (n_sample, n_axis) [command unit, or m for the reference]
            What the trial ran with.
        trial : TrialRecord
        problem : LearningProblem

        Returns
        -------
        ndarray (n_sample, n_axis)
            A new array.
        """
        wanted = self.revised(table, trial, problem)
        if not trial.excess.any():
            return wanted
        return np.asarray(np.where(trial.excess * (wanted - table) > 0.0, table, wanted))

    def revised(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        """Return the next table as the law has it; arguments and result as of `update`."""
        # What tells one law from another.
        raise NotImplementedError

    def passed(self, signal: Array, servo_period: float) -> Array:
        """Return what the law's own filter lets through of a signal (n_sample, n_axis): all, where it has none."""
        return signal
