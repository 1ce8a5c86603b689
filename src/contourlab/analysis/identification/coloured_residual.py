"""Standard deviations of least squares that allow for a residual which is correlated in time, under a window over its lags.

The covariance is (J'J)^-1 S (J'J)^-1, with S the sum of the autocovariances of J'r, each weighted by a window. What differs between fits is
how long a residual remembers, and so the window: one that falls from its top (Bartlett) for rows that are nearly independent, one that is
round there (Parzen) where a sample takes back at the next what it was off at this one, one that is flat (Politis & Romano) where a model
lacks something that lasts.

References
----------
Newey & West, "A simple, positive semi-definite, heteroskedasticity and autocorrelation consistent covariance matrix", Econometrica 55(3),
1987; Andrews, "Heteroskedasticity and autocorrelation consistent covariance matrix estimation", Econometrica 59(3), 1991; Politis & Romano,
"Bias-corrected nonparametric spectral estimation", J. Time Series Analysis 16, 1995.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def bartlett(lags: int) -> Array:
    """Return Bartlett's window (lags + 1,): a line from 1 at no lag to 0 behind the last. Variances under it are never negative."""
    return np.asarray(1.0 - np.arange(lags + 1) / (lags + 1.0))


def parzen(lags: int) -> Array:
    """Return Parzen's window (lags + 1,): two cubics, level at no lag. Variances under it are never negative."""
    x = np.arange(lags + 1) / (lags + 1.0)
    return np.asarray(np.where(x < 0.5, 1.0 - 6.0 * x**2 * (1.0 - x), 2.0 * (1.0 - x) ** 3))


def flat_top(lags: int) -> Array:
    """Return a window (2 lags,), lags >= 1: 1 up to `lags`, then a line to 0 at twice that. A variance under it may come out negative."""
    return np.asarray(np.minimum(1.0, 2.0 - np.arange(2 * lags) / lags))


def usual_lags(n: int) -> int:
    """Return the lags that are usual for n rows, 4 (n/100)^(2/9), and one more."""
    return int(4.0 * (n / 100.0) ** (2.0 / 9.0)) + 1


def memory(residual: Array, faded: float, longest: int) -> int:
    """Return the lag from which on a residual (n,) has forgotten itself: its autocorrelation is below `faded`; `longest` if it never is.

    Parameters
    ----------
    residual : ndarray (n,)
    faded : float
        Between 0 and 1.
    longest : int, >= 0
        The longest lag that is looked at. 0 is returned for a residual of nothing.
    """
    n = residual.size
    power = np.abs(np.fft.rfft(residual, 1 << (2 * n - 1).bit_length())) ** 2
    along = np.fft.irfft(power)[: longest + 1]
    if along[0] <= 0.0:
        return 0
    forgotten = np.flatnonzero(along < faded * along[0])
    return int(forgotten[0]) if forgotten.size else longest


def long_run(rows: Array, window: Array) -> Array:
    """Return the sum of the autocovariances (p, p) of rows, those ahead and behind, each weighted.

    Parameters
    ----------
    rows : ndarray (n, p)
        Of J'r: the slopes of a sample times its residual.
    window : ndarray (k,)
        Weight of each lag, from 0 on; lags beyond the rows count for nothing.
    """
    n, lags = len(rows), min(window.size, len(rows))
    size = 1 << (n + lags - 1).bit_length()
    weights = np.zeros(size)
    weights[:lags] = window[:lags]
    weights[size - lags + 1 :] = window[1:lags][::-1]
    # Both ends of the spectrum stand for themselves, every other line for its conjugate too.
    share = np.fft.rfft(weights).real / size
    share[1:-1] *= 2.0
    spectrum = np.fft.rfft(rows, size, axis=0)
    return np.asarray(((spectrum.conj() * share[:, None]).T @ spectrum).real)


def coloured_deviations(columns: Array, residual: Array, inverse: Array, window: Array) -> Array:
    """Return standard deviations (p,) of least squares that allow for a residual correlated over neighbouring rows.

    Parameters
    ----------
    columns : ndarray (n, p)
        Sensitivities.
    residual : ndarray (n,)
    inverse : ndarray (p, p)
        Of columns' columns.
    window : ndarray (k,)
        Weight of each lag, from 0 on.
    """
    n, p = columns.shape
    covariance = inverse @ long_run(columns * residual[:, None], window) @ inverse * (n / max(n - p, 1))
    return np.asarray(np.sqrt(np.maximum(np.diag(covariance), 0.0)))
