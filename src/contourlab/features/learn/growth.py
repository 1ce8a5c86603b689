"""Where in frequency an error grows from trial to trial."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
SHARE = 0.1
"""The band holds what grew by at least this part of the largest growth."""


@dataclass(frozen=True)
class Growth:
    """The band of frequencies in which the tracking error grew.

    Attributes
    ----------
    low, high : float [Hz]
        Of the band.
    peak : float [Hz]
        Its middle, weighted by the growth.
    factor : float
        By which the error grew, where it grew most, from one trial to the next.
    axis : str
        The axis in which it grew most.
    """

    low: float
    high: float
    peak: float
    factor: float
    axis: str

    def __str__(self) -> str:
        return (
            f"axis {self.axis} grows between {self.low:.3g} and {self.high:.3g} Hz, about {self.peak:.3g} Hz, "
            f"where the error is multiplied by {self.factor:.3g} in a trial"
        )


def growth_of(errors: list[Array], servo_period: float, axes: tuple[str, ...]) -> Growth | None:
    """Return the band in which the increments of the error grew.

    Parameters
    ----------
    errors : list of ndarray (n_sample, n_axis) [m]
        Tracking errors of the last trials, oldest first; three or more.
    servo_period : float [s]
    axes : tuple of str
        Their names.

    Returns
    -------
    Growth or None
        None where there are fewer than three trials, or nothing grew.
    """
    if len(errors) < 3:
        return None
    before, after = (_spectrum(errors[i] - errors[i - 1], servo_period) for i in (-2, -1))
    grown = after - before
    k, j = np.unravel_index(int(np.argmax(grown)), grown.shape)
    if not grown[k, j] > 0.0:
        return None
    step = 1.0 / (len(errors[0]) * servo_period)
    column = grown[:, j] >= SHARE * grown[k, j]
    low, high = int(k), int(k)
    while low > 0 and column[low - 1]:
        low -= 1
    while high + 1 < len(column) and column[high + 1]:
        high += 1
    # The middle of the band by weight: single lines of the spectrum are a matter of the record's length.
    inside = np.arange(low, high + 1)
    weight = grown[low : high + 1, j]
    middle = float((inside * weight).sum() / weight.sum())
    factor = float(np.sqrt(after[k, j] / max(before[k, j], np.finfo(float).tiny)))
    return Growth(max(low - 0.5, 0.0) * step, (high + 0.5) * step, middle * step, factor, axes[int(j)])


def _spectrum(signal: Array, servo_period: float) -> Array:
    """Return the power spectrum (n_frequency, n_axis), averaged over neighbours up to a tenth of the frequency."""
    from scipy.fft import rfft

    n = len(signal)
    window = np.hanning(n)[:, None]  # an error that does not end where it began would leak into all frequencies
    power = np.abs(rfft(signal * window, axis=0)) ** 2
    total = np.concatenate([np.zeros((1, power.shape[1])), np.cumsum(power, axis=0)])
    k = np.arange(len(power))
    half = 2 + k // 20
    low, high = np.maximum(k - half, 0), np.minimum(k + half + 1, len(power))
    return np.asarray((total[high] - total[low]) / (high - low)[:, None])
