"""Response of an axis of second order and an integrator to a held command: closed forms for any damping ratio and any delay."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["held_response", "impulse_response", "position_step", "velocity_step"]

Array = NDArray[np.float64]


def _modes(time: ArrayLike, damping_ratio: float, natural_frequency: float) -> tuple[Array, Array, Array]:
    """Return t, exp(-a t) sinh(d t)/d and exp(-a t) cosh(d t), with a = zeta wn and d^2 = a^2 - wn^2 of either sign; zero for t < 0."""
    t = np.maximum(np.asarray(time, dtype=float), 0.0)
    a = damping_ratio * natural_frequency
    d = np.sqrt(complex(a * a - natural_frequency * natural_frequency))
    fast = -2.0 * d * t
    slow = np.exp((d - a) * t)
    # (exp(x) - 1)/x, which is 1 where both modes are one.
    ratio = np.where(np.abs(fast) > 1e-12, np.expm1(fast) / np.where(np.abs(fast) > 1e-12, fast, 1.0), 1.0)
    return t, (t * slow * ratio).real, (0.5 * slow * (1.0 + np.exp(fast))).real


def _joined(whole: Array, t: Array, order: int, a: float, w2: float) -> Array:
    """Return a closed form with its power series near the start, where one minus nearly one has lost its digits."""
    power, last, coefficient, series = t**order / math.factorial(order), 0.0, w2, np.zeros_like(t)
    for k in range(8):
        series += coefficient * power
        power = power * t / (order + k + 1)
        last, coefficient = coefficient, -2.0 * a * coefficient - w2 * last
    return np.asarray(np.where((a + math.sqrt(w2)) * t < 0.02, series, whole))


def impulse_response(time: ArrayLike, damping_ratio: float, natural_frequency: float) -> Array:
    """Return c(t) [1/s] of wn^2/(s^2 + 2 zeta wn s + wn^2): eq (5), and its like for zeta <= 1.

    Parameters
    ----------
    time : array_like [s]
        The response is 0 before 0.
    damping_ratio : float, > 0
    natural_frequency : float [rad/s], > 0

    References
    ----------
    Gecer Ulu, Ulu & Cakmakci, eq (5), for damping ratios above 1.

    >>> round(float(impulse_response(0.01, 1.1, 150.0)), 3)
    46.695
    """
    t, sine, _ = _modes(time, damping_ratio, natural_frequency)
    return np.asarray(np.where(t > 0.0, natural_frequency**2 * sine, 0.0))


def velocity_step(time: ArrayLike, damping_ratio: float, natural_frequency: float) -> Array:
    """Return the response of wn^2/(s^2 + 2 zeta wn s + wn^2) to a unit step at 0: the velocity per dc_gain and command."""
    t, sine, cosine = _modes(time, damping_ratio, natural_frequency)
    a, w2 = damping_ratio * natural_frequency, natural_frequency**2
    return _joined(1.0 - cosine - a * sine, t, 2, a, w2)


def position_step(time: ArrayLike, damping_ratio: float, natural_frequency: float) -> Array:
    """Return the integral of `velocity_step` [s]: the position per dc_gain and command."""
    t, sine, cosine = _modes(time, damping_ratio, natural_frequency)
    a, w = damping_ratio * natural_frequency, natural_frequency
    return _joined(t - 2.0 * damping_ratio / w * (1.0 - cosine) + (2.0 * a * a / (w * w) - 1.0) * sine, t, 3, a, w * w)


def held_response(
    command: Array, period: float, damping_ratio: float, natural_frequency: float, delay: float = 0.0, *, of: str = "velocity"
) -> Array:
    """Return velocity [m/s] or position [m] at the samples of an axis with the gain 1 that starts at rest.

    Parameters
    ----------
    command : ndarray (n,)
        Held from each sample to the next; zero before the first.
    period : float [s], > 0
    damping_ratio : float, > 0
    natural_frequency : float [rad/s], > 0
    delay : float [s], >= 0
    of : str
        ``"velocity"`` or ``"position"``.
    """
    from scipy.signal import fftconvolve

    n = command.size
    step = velocity_step if of == "velocity" else position_step
    jumps = np.diff(command, prepend=0.0)
    response = step(np.arange(n) * period - delay, damping_ratio, natural_frequency)
    at = np.flatnonzero(jumps)
    if at.size <= 8:
        # A pulse or a step: to rounding.
        found = np.zeros(n)
        for k in at:
            found[k:] += jumps[k] * response[: n - k]
        return found
    return np.asarray(fftconvolve(jumps, response)[:n])
