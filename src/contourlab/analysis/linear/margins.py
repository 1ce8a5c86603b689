"""Stability margins: how far a loop gain stays from -1."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
LoopGain = Callable[[Array], Complex]


@dataclass(frozen=True)
class Margins:
    """Stability margins of a loop gain. An unstable loop has none: all but `stable` are nan.

    Attributes
    ----------
    gain : float
        Smallest factor > 1 at which the loop would reach -1; infinite if none in the range looked at.
    phase : float [rad]
        Smallest turn of phase at a gain of 1 that would reach -1: positive if a lag, negative if a lead; infinite if the gain is never 1.
    crossover : float [rad/s]
        Frequency of that phase margin; nan if there is none.
    modulus : float
        Smallest distance of the loop gain from -1.
    stable : bool
        Whether the closed loop is stable.
    phase_crossover : float [rad/s]
        Frequency of the gain margin; nan if there is none.
    """

    gain: float
    phase: float
    crossover: float
    modulus: float
    stable: bool = True
    phase_crossover: float = math.nan


def margins(loop: LoopGain, frequency: ArrayLike, *, stable: bool) -> Margins:
    """Return the margins of a loop.

    Parameters
    ----------
    loop : callable
        Gives the loop gain (n,) at frequencies (n,) [rad/s].
    frequency : array_like (n,) [rad/s]
        Where to look, rising: fine enough that no two crossings lie between neighbours. Each crossing is then found to rounding.
    stable : bool
        Whether the closed loop is stable, which its gain alone cannot tell.
    """
    if not stable:
        return Margins(math.nan, math.nan, math.nan, math.nan, stable=False)
    w = np.asarray(frequency, dtype=float)
    gain = np.asarray(loop(w), dtype=complex)
    crossover, phase = min(_phases(loop, w, gain), key=lambda found: abs(found[1]), default=(math.nan, math.inf))
    larger = [found for found in _factors(loop, w, gain) if found[1] > 1.0]
    phase_crossover, factor = min(larger, key=lambda found: found[1], default=(math.nan, math.inf))
    return Margins(factor, phase, crossover, _modulus(loop, w, gain), True, phase_crossover)


def delay_margin(loop: LoopGain, frequency: ArrayLike) -> float:
    """Return the least delay [s] in a stable loop that brings its gain to -1; infinite if none does.

    Parameters
    ----------
    loop, frequency
        As of `margins`.
    """
    w = np.asarray(frequency, dtype=float)
    found = _phases(loop, w, np.asarray(loop(w), dtype=complex))
    # A crossing that a lead would bring to -1 is brought there by a lag of the rest of the turn.
    return min(((phase % (2.0 * math.pi)) / at for at, phase in found), default=math.inf)


def _phases(loop: LoopGain, w: Array, gain: Complex) -> Iterator[tuple[float, float]]:
    """Find where the gain is 1, and the angle from there to -1."""
    with np.errstate(divide="ignore"):  # a loop without gain is nowhere 1
        size = np.log(np.abs(gain))
    for at in _zeros(lambda x: math.log(abs(_value(loop, x))), w, size):
        yield at, float(np.angle(-_value(loop, at)))


def _factors(loop: LoopGain, w: Array, gain: Complex) -> Iterator[tuple[float, float]]:
    """Find where the loop gain is real and negative, and the factor from there to -1."""
    crossings = _zeros(lambda x: _value(loop, x).imag, w, gain.imag)
    found = [(at, _value(loop, at)) for at in crossings]
    # At the Nyquist frequency a sampled loop is real: it meets the axis there without crossing it.
    if abs(gain[-1].imag) <= 1e-9 * abs(gain[-1]):
        found.append((float(w[-1]), complex(gain[-1])))
    for at, value in found:
        if value.real < 0.0:
            yield at, 1.0 / abs(value)


def _modulus(loop: LoopGain, w: Array, gain: Complex) -> float:
    """Return the smallest distance from -1: the nearest points of the grid, each made better between its neighbours."""
    from scipy.optimize import minimize_scalar

    distance = np.abs(1.0 + gain)
    low = np.concatenate([[math.inf], distance, [math.inf]])
    dips = np.flatnonzero((distance <= low[:-2]) & (distance <= low[2:]))
    best = float(distance.min())
    # On a grid as fine as is asked for, the least of all lies beside one of the few least dips.
    for i in dips[np.argsort(distance[dips])][:3]:
        bounds = (float(w[max(i - 1, 0)]), float(w[min(i + 1, w.size - 1)]))
        found = minimize_scalar(lambda x: abs(1.0 + _value(loop, x)), bounds=bounds, method="bounded", options={"xatol": 1e-6 * bounds[1]})
        best = min(best, float(found.fun))
    return best


def _zeros(function: Callable[[float], float], w: Array, values: Array) -> list[float]:
    """Return the frequencies at which a function passes zero, known by its values on a grid."""
    from scipy.optimize import brentq

    above = values > 0.0
    found = np.flatnonzero(above[1:] != above[:-1])
    return [float(brentq(function, w[i], w[i + 1], xtol=1e-13 * w[i + 1], rtol=1e-14)) for i in found]


def _value(loop: LoopGain, w: float) -> complex:
    return complex(loop(np.array([w]))[0])
