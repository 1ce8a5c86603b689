"""Preparation of a measured record: checks, velocity and acceleration without lag, decimation without aliasing.

References
----------
Gautier, "Dynamic identification of robots with power model", IEEE ICRA 1997, sections 4.1 and 4.2: low-pass forwards and backwards,
central differences, parallel filter and decimation; the latter with the filter and the phase of MATLAB's ``decimate``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array
from contourlab.errors import ParameterError, refuse

ANTI_ALIAS_ORDER, ANTI_ALIAS_RIPPLE, ANTI_ALIAS_BAND = 8, 0.05, 0.8
"""Chebyshev filter before decimation: order, ripple [dB], and edge as a share of the new Nyquist frequency."""


@dataclass(frozen=True, eq=False)
class FilteredMotion:
    """Motion from a measured position.

    Attributes
    ----------
    position, velocity, acceleration : ndarray (n,) [m, m/s, m/s^2]
    """

    position: Array
    velocity: Array
    acceleration: Array


def filtered_motion(position: ArrayLike, period: float, *, cutoff: float, order: int = 4) -> FilteredMotion:
    """Return position, velocity and acceleration, filtered without lag by a Butterworth low-pass run forwards and backwards.

    Parameters
    ----------
    position : array_like (n,) [m]
    period : float [s], > 0
    cutoff : float [Hz], > 0
        Below the Nyquist frequency; five times the bandwidth of the position loop is usual. Two passes attenuate it by 6 dB.
    order : int, >= 1
        Of one pass.

    Raises
    ------
    ParameterError
        If the cut-off is not below the Nyquist frequency, or the record is too short for the filter.
    """
    from scipy.signal import butter, sosfiltfilt

    measured = np.asarray(position, dtype=float)
    nyquist = 0.5 / period
    if not 0.0 < cutoff < nyquist:
        raise ParameterError("cutoff", f"{cutoff:g}", f"> 0 and below the Nyquist frequency of the record, {nyquist:g}", "Hz")
    padding = 3 * order
    if measured.size <= padding:
        raise ParameterError("position", f"{measured.size} samples", f"more than the {padding} that the filter starts with")
    smooth = np.asarray(sosfiltfilt(butter(order, cutoff / nyquist, output="sos"), measured, padlen=padding), dtype=float)
    velocity = np.gradient(smooth, period)
    return FilteredMotion(smooth, velocity, np.gradient(velocity, period))


def decimate(signal: ArrayLike, factor: int) -> Array:
    """Return every `factor`-th sample of a signal, low-pass filtered forwards and backwards, with the phase of MATLAB's ``decimate``.

    Parameters
    ----------
    signal : array_like (n,) or (n, k)
        Columns are decimated separately.
    factor : int, >= 1
        With 1 the signal is returned unchanged.

    Returns
    -------
    ndarray (ceil(n/factor), ...)
        The last sample is the signal's last; the first is sample ``factor - (factor*ceil(n/factor) - n) - 1``, from 0.

    Raises
    ------
    ParameterError
        If the signal is too short for the filter.
    """
    from scipy.signal import cheby1, sosfiltfilt

    y = np.asarray(signal, dtype=float)
    if factor == 1:
        return y
    padding, n = 3 * ANTI_ALIAS_ORDER, y.shape[0]
    if n <= padding:
        raise ParameterError("record", f"{n} samples", f"more than the {padding} that the filter ahead of decimation starts with")
    sections = cheby1(ANTI_ALIAS_ORDER, ANTI_ALIAS_RIPPLE, ANTI_ALIAS_BAND / factor, output="sos")
    return np.asarray(sosfiltfilt(sections, y, axis=0, padlen=padding), dtype=float)[kept_samples(n, factor)]


def kept_samples(n_sample: int, factor: int) -> slice:
    """Return the samples of a record that `decimate` keeps; the last is always kept."""
    return slice((n_sample - 1) % factor, None, factor)


JITTER = 1e-3
"""Largest unevenness of the times, as a share of the period; clocks typically jitter by 1e-5."""


def require_finite(name: str, values: Array) -> None:
    """Raise `ParameterError` if a signal (n,) is not finite throughout."""
    bad = np.flatnonzero(~np.isfinite(values))
    if bad.size:
        raise ParameterError(name, f"{values[bad[0]]} at sample {bad[0]}", "finite")


def even_record(time: ArrayLike, signals: Mapping[str, ArrayLike], shortest: int = 50) -> tuple[float, list[Array]]:
    """Return the period [s] of a record, and its times and signals as arrays (n,), checked.

    Parameters
    ----------
    time : array_like (n,) [s]
    signals : mapping of str to array_like (n,)
        By their names in error messages.
    shortest : int
        Smallest number of samples.

    Raises
    ------
    ParameterError
        If there are too few samples, a signal is of another length or not finite, or time does not rise evenly.
    """
    arrays = {name: np.asarray(values, dtype=float) for name, values in {"time": time, **signals}.items()}
    t = arrays["time"]
    refuse(t.ndim != 1, ParameterError, "time", f"shape {t.shape}", "one record, (n,)")
    refuse(t.size < shortest, ParameterError, "time", f"{t.size} samples", f"a record of at least {shortest}")
    for name, array in arrays.items():
        refuse(array.shape != t.shape, ParameterError, name, f"shape {array.shape}", f"as long as time, {t.shape}")
        require_finite(name, array)
    period = float(t[-1] - t[0]) / (t.size - 1)
    if not (period > 0.0 and np.all(np.abs(np.diff(t) - period) <= JITTER * period)):
        raise ParameterError("time", "a record", "rising and evenly spaced: resample it first")
    return period, [*arrays.values()]
