"""Zero-phase filters over whole trials.

At its ends a trial is continued by its mirror image, d c b a | a b c d | d c b a. A filter is then a symmetric matrix whose eigenvalues are
its response at the frequencies of the record: it keeps a constant, and where the response is at most 1 it amplifies nothing. Other
continuations (odd image, last value) pass the end samples unfiltered: learning can diverge there although it converges elsewhere.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array


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
