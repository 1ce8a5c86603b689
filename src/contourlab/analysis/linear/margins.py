"""Stability margins of one loop gain, and of all weighted means of a few.

The means of a few loop gains fill, at each frequency, a polygon of the complex plane. Its distance from -1 is their modulus margin.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Complex

LoopGain = Callable[[Array], Complex]
"""Loop gain (n,), or loop gains (n, n_loop), at frequencies (n,) [rad/s]."""
AROUND_A_POLE = (-2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0)
"""Grid frequencies about a pole, in multiples of its width."""


@dataclass(frozen=True)
class Margins:
    """Stability margins of a loop gain. For an unstable loop all but `stable` are nan.

    Attributes
    ----------
    gain : float
        Smallest factor > 1 at which the loop gain would reach -1; infinite if there is none in the frequency range.
    phase : float [rad]
        Smallest change of phase at a gain of 1 that would reach -1: positive for a lag, negative for a lead; infinite if the gain is
        never 1.
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


UNSTABLE = Margins(math.nan, math.nan, math.nan, math.nan, stable=False)


def margins(loop: LoopGain, frequency: ArrayLike, *, stable: bool) -> Margins:
    """Return the margins of a loop.

    Parameters
    ----------
    loop : callable
        Gives the loop gain (n,) at frequencies (n,) [rad/s].
    frequency : array_like (n,) [rad/s]
        Rising, fine enough that no two crossings lie between neighbours. Each crossing is then refined to rounding.
    stable : bool
        Whether the closed loop is stable: the gain alone does not show it.
    """
    if not stable:
        return UNSTABLE
    w = np.asarray(frequency, dtype=float)
    gain = np.asarray(loop(w), dtype=complex)
    crossover, phase = min(_phases(loop, w, gain), key=lambda crossing: abs(crossing[1]), default=(math.nan, math.inf))
    larger = [crossing for crossing in _factors(loop, w, gain) if crossing[1] > 1.0]
    phase_crossover, factor = min(larger, key=lambda crossing: crossing[1], default=(math.nan, math.inf))
    modulus, _ = nearest_approach(lambda x: abs(1.0 + _value(loop, x)), w, np.abs(1.0 + gain), n_dip=3, tolerance=1e-6)
    return Margins(factor, phase, crossover, modulus, True, phase_crossover)


def _phases(loop: LoopGain, w: Array, gain: Complex) -> Iterator[tuple[float, float]]:
    """Yield each frequency where the gain is 1, with the angle from there to -1."""
    with np.errstate(divide="ignore"):  # a gain of 0 has no crossing
        size = np.log(np.abs(gain))
    for at in _zeros(lambda x: math.log(abs(_value(loop, x))), w, size):
        yield at, float(np.angle(-_value(loop, at)))


def _factors(loop: LoopGain, w: Array, gain: Complex) -> Iterator[tuple[float, float]]:
    """Yield each frequency where the loop gain is real and negative, with the factor from there to -1."""
    values = [(at, _value(loop, at)) for at in _zeros(lambda x: _value(loop, x).imag, w, gain.imag)]
    # At the Nyquist frequency a sampled loop is real: it meets the real axis without crossing it.
    if abs(gain[-1].imag) <= 1e-9 * abs(gain[-1]):
        values.append((float(w[-1]), complex(gain[-1])))
    for at, value in values:
        if value.real < 0.0:
            yield at, 1.0 / abs(value)


def interpolated_margins(w: Array, gain: Complex) -> Margins:
    """Return the margins of a stable loop by linear interpolation of its gain (n,) at frequencies (n,) [rad/s]."""
    phase, crossover = _interpolated_phase(w, gain)
    factor, phase_crossover = _interpolated_factor(w, gain)
    return Margins(factor, phase, crossover, float(np.abs(1.0 + gain).min()), True, phase_crossover)


def _interpolated_phase(w: Array, gain: Complex) -> tuple[float, float]:
    with np.errstate(divide="ignore"):
        size = np.log(np.abs(gain))
    at = np.flatnonzero(np.isfinite(size[:-1]) & np.isfinite(size[1:]) & (size[:-1] * size[1:] <= 0.0) & (size[:-1] != size[1:]))
    if not at.size:
        return math.inf, math.nan
    part = size[at] / (size[at] - size[at + 1])
    angle = np.angle(-gain[at]) + part * np.angle(gain[at + 1] / gain[at])
    angle = np.angle(np.exp(1j * angle))
    best = int(np.argmin(np.abs(angle)))
    return float(angle[best]), float(w[at[best]] * (w[at[best] + 1] / w[at[best]]) ** part[best])


def _interpolated_factor(w: Array, gain: Complex) -> tuple[float, float]:
    at = np.flatnonzero(gain.imag[:-1] * gain.imag[1:] < 0.0)
    part = gain.imag[at] / (gain.imag[at] - gain.imag[at + 1])
    real, where = gain.real[at] + part * (gain.real[at + 1] - gain.real[at]), w[at] * (w[at + 1] / w[at]) ** part
    if abs(gain[-1].imag) <= 1e-9 * abs(gain[-1]):
        real, where = np.append(real, gain[-1].real), np.append(where, w[-1])
    inside = (real < 0.0) & (real > -1.0)
    if not inside.any():
        return math.inf, math.nan
    best = int(np.argmin(real[inside]))
    return float(-1.0 / real[inside][best]), float(where[inside][best])


def nearest_approach(distance: Callable[[float], float], w: Array, values: Array, *, n_dip: int, tolerance: float) -> tuple[float, float]:
    """Return the smallest distance and its frequency: the smallest dips of the grid `values` (n,), each refined between its neighbours."""
    from scipy.optimize import minimize_scalar

    low = np.concatenate([[math.inf], values, [math.inf]])
    dips = np.flatnonzero((values <= low[:-2]) & (values <= low[2:]))
    candidates = [(float(values.min()), float(w[values.argmin()]))]
    for i in dips[np.argsort(values[dips])][:n_dip]:
        bounds = (float(w[max(i - 1, 0)]), float(w[min(i + 1, w.size - 1)]))
        best = minimize_scalar(distance, bounds=bounds, method="bounded", options={"xatol": tolerance * bounds[1]})
        candidates.append((float(best.fun), float(best.x)))
    return min(candidates)


def frequency_grid(servo_period: float, poles: Complex, n_delay: int) -> Array:
    """Return frequencies [rad/s] up to Nyquist, dense enough over decades, delays and poles to miss no crossing of a loop gain.

    Parameters
    ----------
    servo_period : float [s]
    poles : ndarray (n_pole,) of complex
        Of the open and closed loop, in the z plane.
    n_delay : int
        Longest delay, in servo periods.
    """
    top = math.pi / servo_period
    angle, width = np.abs(np.angle(poles)), np.abs(1.0 - np.abs(poles))
    grids = [np.geomspace(1e-5 * top, top, 400), np.linspace(0.0, top, 12 * n_delay + 2)]
    w = np.unique(np.concatenate([*grids, *((angle + k * width) / servo_period for k in AROUND_A_POLE)]))
    return np.asarray(w[(w >= 1e-5 * top) & (w <= top)])


def _zeros(function: Callable[[float], float], w: Array, values: Array) -> list[float]:
    """Return the zero crossings of a function, bracketed by its values on a grid."""
    from scipy.optimize import brentq

    above = values > 0.0
    return [float(brentq(function, w[i], w[i + 1], xtol=1e-13 * w[i + 1], rtol=1e-14)) for i in np.flatnonzero(above[1:] != above[:-1])]


def _value(loop: LoopGain, w: float) -> complex:
    return complex(loop(np.array([w]))[0])


SHARES = np.linspace(0.0, 1.0, 33)
"""Points on an edge to try first; the worst is then refined between its neighbours."""


@dataclass(frozen=True, eq=False)
class HullMargin:
    """A margin, with its frequency [rad/s] and weights (n,)."""

    value: float
    frequency: float
    weights: Array

    @classmethod
    def nearest(cls, value: float, frequency: float, vertices: Complex) -> HullMargin:
        """Return a margin with the weights of the point nearest to -1 in the polygon of `vertices` (n,)."""
        from scipy.optimize import nnls

        # A heavy weight holds the sum at 1 to rounding.
        heavy = 1e6 * max(1.0, float(np.abs(vertices + 1.0).max()))
        weights, _ = nnls(np.vstack([vertices.real + 1.0, vertices.imag, np.full(vertices.size, heavy)]), np.array([0.0, 0.0, heavy]))
        return cls(value, frequency, weights / weights.sum())


def hull_modulus(vertices: Complex) -> Array:
    """Return the distance (n,) of -1 from the convex hull of points (n, n_vertex): 0 where it is inside.

    >>> hull_modulus(np.array([[0.0, 2.0j], [-2.0 - 1.0j, 1.0j]])).round(6)
    array([1., 0.])
    """
    to = vertices + 1.0
    n = to.shape[1]
    best = np.abs(to).min(axis=1)
    for i in range(n):
        for j in range(i + 1, n):
            side = to[:, j] - to[:, i]
            square = np.abs(side) ** 2
            # The foot of -1 on the edge, limited to its ends.
            share = np.clip(-(to[:, i] * side.conj()).real / np.where(square > 0.0, square, 1.0), 0.0, 1.0)
            best = np.minimum(best, np.abs(to[:, i] + share * side))
    if n > 2:
        angle = np.sort(np.angle(to), axis=1)
        widest = np.maximum(np.diff(angle, axis=1).max(axis=1), angle[:, 0] + 2.0 * np.pi - angle[:, -1])
        best[widest < np.pi] = 0.0
    return np.asarray(best)


def edge_margins(loops: LoopGain, frequency: Array, pairs: Sequence[tuple[int, int]]) -> tuple[HullMargin, HullMargin]:
    """Return the smallest phase margin and gain margin over all weighted means of stable loops.

    The unit circle and the negative real axis enter a polygon through its edges, so that means of two loops are enough.

    Parameters
    ----------
    loops : callable
        Gives the loop gains (n, n_loop) at frequencies (n,) [rad/s].
    frequency : ndarray (n,) [rad/s]
        Search grid, rising and fine enough for each of the loops.
    pairs : sequence of (int, int)
        The edges; empty for one loop.
    """
    values = loops(frequency)
    n, scale = values.shape[1], float(np.abs(values).max(initial=1.0))
    alike = [np.abs(values[:, i] - values[:, j]).max() <= 1e-12 * scale for i, j in pairs]
    edges = [pair for pair, same in zip(pairs, alike, strict=True) if not same] or [(0, 0)]
    worst = []
    for measure, rough_margin in enumerate((_interpolated_phase, _interpolated_factor)):
        rough = [
            (abs(rough_margin(frequency, values[:, i] + share * (values[:, j] - values[:, i]))[0]), (i, j), float(share))
            for i, j in edges
            for share in SHARES
        ]
        worst.append(_refined(loops, frequency, n, *min(rough, key=lambda entry: entry[0])[1:], measure))
    return worst[0], worst[1]


def _refined(loops: LoopGain, w: Array, n: int, edge: tuple[int, int], share: float, measure: int) -> HullMargin:
    """Return the exact margin of the worst mean on an edge near a share."""
    from scipy.optimize import minimize_scalar

    def weights(at: float) -> Array:
        mean = np.zeros(n)
        mean[edge[0]] += 1.0 - at
        mean[edge[1]] += at
        return mean

    def exact(at: float) -> tuple[float, float]:
        mean = weights(at)
        result = margins(lambda x: np.asarray(loops(x) @ mean), w, stable=True)
        return (result.phase, result.crossover) if measure == 0 else (result.gain, result.phase_crossover)

    def size(at: float) -> float:
        return min(abs(exact(at)[0]), 1e12)

    shares = [share]
    if edge[0] != edge[1] and math.isfinite(exact(share)[0]):
        bounds = (max(share - float(SHARES[1]), 0.0), min(share + float(SHARES[1]), 1.0))
        shares.append(float(minimize_scalar(size, bounds=bounds, method="bounded", options={"xatol": 1e-4}).x))
    worst = min(shares, key=size)
    return HullMargin(*exact(worst), weights(worst))


def doubling(factor: float) -> float:
    """Return the number of steps (trials, laps, periods) in which an error doubles: ln 2/ln(factor).

    Parameters
    ----------
    factor : float, > 0
        Growth per step; up to 1 the error never doubles, and the result is infinite.

    >>> round(doubling(1.003)), doubling(2.0), doubling(1.0)
    (231, 1.0, inf)
    """
    return math.log(2.0) / math.log(factor) if factor > 1.0 else math.inf
