"""What a fit leaves: whether its residual has energy at one frequency, as a resonance leaves it, and in which band a log tells that.

References
----------
Welch, "The use of fast Fourier transform for the estimation of power spectra", IEEE Trans. Audio and Electroacoustics 15(2), 1967.
Bendat & Piersol, "Random Data", 4th ed., sections 8.5 (scatter of a spectrum) and 6.1 (coherent output).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Array
from contourlab.findings import Finding, finding

RESOLUTION, MOST = 1.0, 0.8
"""Distance of the lines of the spectrum [Hz], and highest line over the Nyquist frequency."""
LOWEST, FEWEST = 8.0, 8
"""Lowest frequency [lines] that is searched, and fewest segments of a spectrum that is."""
AROUND, APART = 1.6, 1.2
"""A line is compared with those between these times off its frequency, both ways."""
CLEAR = 10.0
"""Power of a peak over that of its neighbourhood: 10 dB. Lines of a coarse encoder at constant speed reach 7 or 8."""


@dataclass(frozen=True)
class LeftOver:
    """Unexplained energy.

    Attributes
    ----------
    band : (float, float) [Hz]
        What was searched: where the log excites, between the first and the last line; zeros without.
    frequency : float [Hz]
        Of the clearest line in the band; nan without.
    clear : float
        Power of the clearest line over that of its neighbourhood.
    """

    band: tuple[float, float]
    frequency: float
    clear: float


def left_over_findings(
    place: str, residual: Array, excitation: Array, explained: Array, period: float, highest: float = np.inf, counts: float = 0.0
) -> list[Finding]:
    """Return a finding on a peak in a residual, or on the band in which there is none; see `left_over`.

    `counts` is the rms that the counts of an encoder alone leave, at constant speed in lines: a residual within it has no peak.
    """
    left = left_over(residual, excitation, explained, period, highest)
    if not left.band[1] > 0.0:
        return [finding("CL599", place)]
    low, high = left.band
    peak = left.clear > CLEAR and residual.std() > counts
    return [finding("CL597" if peak else "CL598", place, frequency=left.frequency, clear=left.clear, low=low, high=high)]


def left_over(residual: Array, excitation: Array, explained: Array, period: float, highest: float = np.inf) -> LeftOver:
    """Look for a peak in the spectrum of a residual.

    Parameters
    ----------
    residual, explained : ndarray (n,)
        Measured minus predicted, and predicted.
    excitation : ndarray (n,)
        What drives the model: its spectrum tells peaks of the motion from those of the axis.
    period : float [s]
    highest : float [Hz]
        Cut-off of a low-pass: lines are compared below it only.

    Notes
    -----
    A peak counts if it stands out of the residual and out of residual over excitation: the lobes of a motion do so in the first alone. A
    log excites where the model's output is above the residual, or where the residual follows the excitation.
    """
    from scipy.signal import csd, welch

    n = round(1.0 / (RESOLUTION * period))
    nothing = LeftOver((0.0, 0.0), np.nan, 0.0)
    if n < 4.0 * LOWEST or residual.size < FEWEST * n // 2:  # too slow, or too short
        return nothing
    f, left = welch(residual, 1.0 / period, nperseg=n)
    _, driven = welch(excitation, 1.0 / period, nperseg=n)
    _, output = welch(explained, 1.0 / period, nperseg=n)
    _, cross = csd(residual, excitation, 1.0 / period, nperseg=n)
    coherent = np.abs(cross) ** 2 / np.maximum(left * driven, 1e-300)
    chance = 1.0 - 0.001 ** (1.0 / max(2.0 * residual.size / n - 2.0, 1.0))
    searched = (f >= LOWEST * f[1]) & (f <= min(MOST * f[-1], highest / AROUND))
    excited = searched & ((output > left) | (coherent > chance))
    if not excited.any():
        return nothing
    band = float(f[excited].min()), float(f[excited].max())
    best, sharpest = np.nan, 0.0
    for k in np.flatnonzero(excited):
        off = np.maximum(f / f[k], f[k] / np.maximum(f, 1e-9))
        near = (off > APART) & (off < AROUND)
        if near.sum() < 4:
            continue
        over = [spectrum[k] / _at(f, spectrum, near, f[k]) for spectrum in (left, left / np.maximum(driven, 1e-300))]
        if min(over) > sharpest and coherent[k] > chance:
            best, sharpest = float(f[k]), float(min(over))
    return LeftOver(band, best, sharpest)


def _at(f: Array, spectrum: Array, near: Array, at: float) -> float:
    """Return what lines near a frequency make of its power: a power law through them."""
    _, level = np.polyfit(np.log(f[near] / at), np.log(np.maximum(spectrum[near], 1e-300)), 1)
    return float(np.exp(level))
