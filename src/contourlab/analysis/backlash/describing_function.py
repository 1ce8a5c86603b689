"""Describing function of a gap with a spring behind it: the torque's first harmonic over a sinusoidal motor-load difference.

Without shaft damping it is the textbook's dead zone, N = k (1 - 2/pi (asin(h/A) + h/A sqrt(1 - (h/A)^2))). With it, contact is made at the
instant that the relaxing shaft is met and is left where the torque falls to 0; between the two the torque is a sine and its harmonics are
closed forms.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.errors import ParameterError

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


def dead_zone_gain(amplitude: ArrayLike, half_gap: float = 1.0) -> Array:
    """Return the describing function N(A)/k of a dead zone, in [0, 1).

    >>> float(dead_zone_gain(1.0)), round(float(dead_zone_gain(2.0)), 6)
    (0.0, 0.391002)
    """
    ratio = np.minimum(half_gap / np.maximum(np.asarray(amplitude, dtype=float), half_gap), 1.0)
    return np.asarray(1.0 - 2.0 / math.pi * (np.arcsin(ratio) + ratio * np.sqrt(1.0 - ratio**2)))


def inverse_dead_zone_gain(gain: float) -> float:
    """Return A/h at which the describing function N/k is `gain`, in (0, 1).

    >>> round(inverse_dead_zone_gain(0.391002), 5)
    2.0
    """
    from scipy.optimize import brentq

    if not 0.0 < gain < 1.0:
        raise ParameterError("gain", gain, "between 0 and 1, the range of a dead zone's describing function")
    # Over the angle p with sin p = h/A it is smooth at both ends: gain = 1 - (2 p + sin 2 p)/pi.
    angle = brentq(lambda p: 1.0 - (2.0 * p + math.sin(2.0 * p)) / math.pi - gain, 0.0, math.pi / 2.0, xtol=1e-15)
    return 1.0 / math.sin(angle)


def contact_phases(amplitude: ArrayLike, damping: ArrayLike) -> tuple[Array, Array]:
    """Return the phases (n,), (n,) between which a sinusoidal difference A sin p, p = w t, is in contact above, nan where it never is.

    Parameters
    ----------
    amplitude : array_like (n,)
        A over half of the gap.
    damping : array_like (n,)
        w d/k: damping of the shaft over its stiffness, times the frequency.
    """
    a, q = np.broadcast_arrays(np.asarray(amplitude, dtype=float), np.asarray(damping, dtype=float))
    size = a * np.hypot(1.0, q)
    inside = np.where(a > 1.0, size, np.nan)
    # Torque a sin p + q a cos p - 1 = 0, where it falls.
    end = math.pi - np.arcsin(1.0 / inside) - np.arctan(q)
    left = a * np.sin(end) - 1.0
    # On the other side half a turn before: the shaft was left with the twist -left, which relaxes. `reach` is how far the gap is overrun.
    low, high = end - math.pi, np.full_like(end, math.pi / 2.0)
    with np.errstate(over="ignore"):
        for _ in range(60):
            middle = 0.5 * (low + high)
            relaxed = -left * np.exp(-(middle - end + math.pi) / np.maximum(q, 1e-300))
            overrun = a * np.sin(middle) - relaxed > 1.0
            low, high = np.where(overrun, low, middle), np.where(overrun, middle, high)
    return np.where(a > 1.0, 0.5 * (low + high), np.nan), end


def harmonic(amplitude: ArrayLike, damping: ArrayLike, order: int = 1) -> Complex:
    """Return a harmonic of the torque over stiffness and amplitude, for theta_d = A sin(w t); order 1 is the describing function N/k.

    Parameters
    ----------
    amplitude : array_like (n,)
        A over half of the gap.
    damping : array_like (n,)
        w d/k; 0 is the dead zone.
    order : int, odd
        Even harmonics are zero by symmetry.

    Returns
    -------
    ndarray (n,) of complex
        H with torque = k A Im(sum of H_n e^(j n w t)); 0 without contact.

    References
    ----------
    Gelb & Vander Velde, Multiple-Input Describing Functions, table of dead zones; Nordin, Galic & Gutman for the damped shaft.
    """
    a, q = np.broadcast_arrays(np.asarray(amplitude, dtype=float), np.asarray(damping, dtype=float))
    begin, end = contact_phases(a, q)
    n = order

    def part(m: int) -> Complex:
        """Integral of e^(j m p) over the contact."""
        if m == 0:
            return np.asarray(end - begin, dtype=complex)
        return np.asarray((np.exp(1j * m * end) - np.exp(1j * m * begin)) / (1j * m))

    # a sin p + q a cos p - 1, times e^(-j n p), over half a turn; the other half doubles it.
    sine = (part(1 - n) - part(-1 - n)) / 2j
    cosine = (part(1 - n) + part(-1 - n)) / 2.0
    total = 2.0 / math.pi * 1j * (a * sine + q * a * cosine - part(-n)) / a
    return np.asarray(np.where(np.isfinite(begin), total, 0.0))
