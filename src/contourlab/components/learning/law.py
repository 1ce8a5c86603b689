"""Base of the learning laws: record of a trial, model of the machine, and interface of a law."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Complex
from contourlab.components.contract import Component, text_param
from contourlab.errors import ComponentError


@dataclass(frozen=True, eq=False)
class TrialRecord:
    """Record of a trial, as a real controller has it.

    Attributes
    ----------
    tracking_error : ndarray (n_sample, n_axis) [m]
        Reference minus measured position.
    feedback_command : ndarray (n_sample, n_axis) [command unit]
        Command of controllers and coupling due to errors: the command that the drive accepted, minus the learned table, minus the
        feedforward of the reference.
    excess : ndarray (n_sample, n_axis) [command unit]
        Part of the command beyond the drive's limit; zero where it did not saturate.
    contour_error : ndarray (n_sample, n_axis) [m] or None
        Vector from the measured tool position to the path; only for laws with `LearningLaw.needs_contour_error`.
    """

    tracking_error: Array
    feedback_command: Array
    excess: Array
    contour_error: Array | None = None


class InputModel:
    """Linear model of each axis from the learned input to the measured position: convolution with an impulse response, by FFT.

    Nothing wraps around: input and output have the length of a trial and are zero before it.

    Parameters
    ----------
    impulse : ndarray (n, n_axis) [m per unit of the input], n <= n_sample
        Position at sample i after an input of 1 at sample 0; zero from n on.
    n_sample : int
    """

    def __init__(self, impulse: Array, n_sample: int) -> None:
        from scipy.fft import next_fast_len, rfft

        self.impulse, self.n_sample = impulse[:n_sample], n_sample
        self.length = int(next_fast_len(n_sample + len(self.impulse) - 1, real=True))
        self.response: Complex = rfft(self.impulse, self.length, axis=0)

    def through(self, signal: Array, response: Complex | Array) -> Array:
        """Return a signal (n_sample, n_axis) filtered by a frequency response (as long as `self.response`)."""
        from scipy.fft import irfft, rfft

        # Contiguous columns: in sample order each transform would stride over the axes.
        columns = np.ascontiguousarray(signal.T)
        return np.asarray(irfft(rfft(columns, self.length) * response.T, self.length)[:, : self.n_sample].T)

    def forward(self, signal: Array) -> Array:
        """Return the positions G u (n_sample, n_axis) [m] that an input u (n_sample, n_axis) causes."""
        return self.through(signal, self.response)

    def adjoint(self, signal: Array) -> Array:
        """Return G' e (n_sample, n_axis), the transpose of `forward`, of errors e (n_sample, n_axis) [m]."""
        return self.through(signal, self.response.conj())


def _no_motion() -> tuple[Array, Array]:
    raise ComponentError("a law that learns gains of a whole motion has no frequency response")


@dataclass(frozen=True, eq=False)
class LearningProblem:
    """Data known before the first trial.

    Attributes
    ----------
    servo_period : float [s]
    tangent : ndarray (n_sample, n_axis) [m/m]
        Unit tangent of the path at the reference.
    impulses : callable
        Returns the impulse responses (m, n_axis) from the learned input to the position; called only by laws that use a model.
    motion : callable
        Returns velocity [m/s] and acceleration [m/s^2] of the reference, (n_sample, n_axis) each; called only by laws that use them.
        Raises `ComponentError` where there is no reference, as in an analysis by frequency.
    """

    servo_period: float
    tangent: Array
    impulses: Callable[[], Array]
    motion: Callable[[], tuple[Array, Array]] = _no_motion

    @cached_property
    def model(self) -> InputModel:
        """Model of the axes, computed once."""
        return InputModel(self.impulses(), len(self.tangent))

    def across(self, vectors: Array) -> Array:
        """Return the part of vectors (n_sample, n_axis) that is normal to the path, v - t (t.v)."""
        return np.asarray(vectors - self.tangent * (self.tangent * vectors).sum(axis=1, keepdims=True))


class LearningLaw(Component):
    """Base of all laws: a law computes the next table; this class prevents wind-up.

    Where the drive saturated, the table does not move further in that direction.
    """

    family: ClassVar[str] = "learning"

    target: str = text_param(default="command", choices=("command", "reference"), doc="what the table is added to")

    @property
    def needs_contour_error(self) -> bool:
        """Whether the law needs `TrialRecord.contour_error`."""
        return False

    def update(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        """Return the table of the next trial.

        Parameters
        ----------
        table : ndarray (n_sample, n_axis) [command unit, or m for the reference]
            The table of the trial.
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
        """Return the next table (n_sample, n_axis) without protection against wind-up; arguments as in `update`."""
        raise NotImplementedError

    def passed(self, signal: Array, servo_period: float) -> Array:
        """Return a signal (n_sample, n_axis) after the filter of the law, if it has one."""
        return signal


def moving_average(signal: Array, half_width: int, passes: int = 1) -> Array:
    """Return the mean over 2 M + 1 samples around each one, `passes` times.

    Parameters
    ----------
    signal : ndarray (n_sample, n_axis)
    half_width : int, M >= 0
    passes : int, >= 0

    Notes
    -----
    H_M(w) = sin((2 M + 1) w T_s/2) / ((2 M + 1) sin(w T_s/2)).
    """
    from scipy.ndimage import uniform_filter1d

    for _ in range(passes):
        signal = uniform_filter1d(signal, 2 * half_width + 1, axis=0, mode="reflect")
    return signal


def advanced(signal: Array, samples: int) -> Array:
    """Return x(k + samples); zero beyond the end, so that nothing is learned from unknown samples."""
    if not samples:
        return signal
    later = np.zeros_like(signal)
    later[: max(len(signal) - samples, 0)] = signal[samples:]
    return later


def q_response(frequency: ArrayLike, bandwidth: float, order: float, servo_period: float) -> Array:
    """Return the gain (n,) of `q_filter` at frequencies (n,) [rad/s], from 0 to the Nyquist frequency."""
    w = np.asarray(frequency, dtype=float)
    if bandwidth * servo_period >= math.pi:
        return np.ones(w.shape)
    ratio = np.tan(np.minimum(0.5 * w * servo_period, 0.5 * math.pi)) / math.tan(0.5 * bandwidth * servo_period)
    # At the Nyquist frequency itself rounding decides the sign of the tangent.
    return np.asarray(1.0 / (1.0 + np.minimum(np.abs(ratio), 1e9) ** (2.0 * order)))


def q_filter(signal: Array, bandwidth: float, order: int, servo_period: float) -> Array:
    """Return a signal after a Butterworth low-pass run forwards and backwards, 1/(1 + (tan(w T_s/2)/tan(w_q T_s/2))^(2 order)).

    Parameters
    ----------
    signal : ndarray (n_sample, n_axis)
    bandwidth : float [rad/s], > 0
        w_q, where the gain is 1/2; no filter from the Nyquist frequency on.
    order : int, >= 1
    servo_period : float [s]

    Notes
    -----
    The gain is the squared magnitude of the sampled filter; for w far below the Nyquist frequency 1/(1 + (w/w_q)^(2 order)).
    """
    if bandwidth * servo_period >= math.pi:
        return signal
    from scipy.fft import dct, idct

    n = len(signal)
    gain = q_response(np.pi * np.arange(n) / (n * servo_period), bandwidth, order, servo_period)
    # Mirror images at both ends leave only cosines: the filter is this product, without padding.
    return np.asarray(idct(dct(np.ascontiguousarray(signal.T)) * gain).T)
