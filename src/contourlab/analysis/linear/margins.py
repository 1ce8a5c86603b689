"""Stability margins of one loop gain, and of all weighted means of a few.

The means of a few loop gains fill, at each frequency, a polygon of the complex plane. Its distance from -1 is their modulus margin.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Complex, Flags

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


@dataclass(frozen=True, eq=False)
class RoughMargins:
    """Margins of many loops (n,), interpolated on a frequency grid; fields as of `Margins`, nan for an unstable loop."""

    gain: Array
    phase: Array
    modulus: Array
    stable: Flags


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
    phase, crossover = _phase_margin(loop, w, gain)
    factor, phase_crossover = _gain_margin(loop, w, gain)
    modulus, _ = nearest_approach(lambda x: np.abs(1.0 + loop(x)), w, np.abs(1.0 + gain), n_dip=3, tolerance=1e-7)
    return Margins(factor, phase, crossover, modulus, True, phase_crossover)


def _phase_margin(loop: LoopGain, w: Array, gain: Complex) -> tuple[float, float]:
    """Return the smallest angle to -1 where the gain is 1, and its frequency."""
    with np.errstate(divide="ignore"):  # a gain of 0 has no crossing
        at = _zeros(lambda x: np.log(np.abs(loop(x))), w, np.log(np.abs(gain)))
    angles = np.angle(-loop(at)).tolist()
    return min(zip(angles, at.tolist(), strict=True), key=lambda crossing: abs(crossing[0]), default=(math.inf, math.nan))


def _gain_margin(loop: LoopGain, w: Array, gain: Complex) -> tuple[float, float]:
    """Return the smallest factor above 1 to -1 where the loop gain is real, and its frequency."""
    at = _zeros(lambda x: np.asarray(loop(x).imag), w, gain.imag)
    values = loop(at).real
    # At the Nyquist frequency a sampled loop is real: it meets the real axis without crossing it.
    if abs(gain[-1].imag) <= 1e-9 * abs(gain[-1]):
        at, values = np.append(at, w[-1]), np.append(values, gain[-1].real)
    factors = ((-1.0 / value, where) for value, where in zip(values.tolist(), at.tolist(), strict=True) if -1.0 < value < 0.0)
    return min(factors, default=(math.inf, math.nan))


def rough_margins(gain: Complex, stable: Flags) -> RoughMargins:
    """Return the margins of loops by linear interpolation of their gains (n, n_frequency) at rising frequencies up to Nyquist."""
    figures = _interpolated_phases(gain), _interpolated_factors(gain), np.abs(1.0 + gain).min(axis=1)
    phase, factor, modulus = (np.where(stable, figure, np.nan) for figure in figures)
    return RoughMargins(factor, phase, modulus, stable)


def _interpolated_phases(gain: Complex) -> Array:
    """Return the smallest change of phase (n,) at a gain of 1 that reaches -1; infinite where the gain is never 1."""
    with np.errstate(divide="ignore"):
        size = np.log(np.abs(gain))
    crosses = np.isfinite(size[:, :-1]) & np.isfinite(size[:, 1:]) & (size[:, :-1] * size[:, 1:] <= 0.0) & (size[:, :-1] != size[:, 1:])
    row, at = np.nonzero(crosses)
    before, after = gain[row, at], gain[row, at + 1]
    part = size[row, at] / (size[row, at] - size[row, at + 1])
    angles = np.full(crosses.shape, np.inf)
    angles[row, at] = np.angle(np.exp(1j * (np.angle(-before) + part * np.angle(after / before))))
    return np.asarray(angles[np.arange(len(gain)), np.abs(angles).argmin(axis=1)])


def _interpolated_factors(gain: Complex) -> Array:
    """Return the smallest factor (n,) above 1 that takes the gain to -1; infinite where there is none."""
    crosses = gain.imag[:, :-1] * gain.imag[:, 1:] < 0.0
    row, at = np.nonzero(crosses)
    before, after = gain[row, at], gain[row, at + 1]
    real = np.zeros(gain.shape)
    real[row, at] = before.real + before.imag / (before.imag - after.imag) * (after.real - before.real)
    last = gain[:, -1]
    real[:, -1] = np.where(np.abs(last.imag) <= 1e-9 * np.abs(last), last.real, 0.0)
    most = np.where((real < 0.0) & (real > -1.0), -real, 0.0).max(axis=1)
    with np.errstate(divide="ignore"):
        return np.asarray(1.0 / most)


FINER = np.linspace(0.0, 1.0, 17)
"""Where a function is computed in each interval that holds a zero or a minimum; the interval then shrinks to one of these parts."""


def nearest_approach(distance: Callable[[Array], Array], w: Array, values: Array, *, n_dip: int, tolerance: float) -> tuple[float, float]:
    """Return the smallest distance and its frequency: the smallest dips of the grid `values` (n,), each refined between its neighbours."""
    low = np.concatenate([[math.inf], values, [math.inf]])
    dips = np.flatnonzero((values <= low[:-2]) & (values <= low[2:]))
    candidates = [(float(values.min()), float(w[values.argmin()]))]
    for i in dips[np.argsort(values[dips])][:n_dip]:
        x = w[max(i - 1, 0) : i + 2]
        while x[-1] - x[0] > tolerance * x[-1]:
            x = x[0] + (x[-1] - x[0]) * FINER
            found = distance(x)
            at = int(found.argmin())
            candidates.append((float(found[at]), float(x[at])))
            x = x[max(at - 1, 0) : at + 2]
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


def _zeros(function: Callable[[Array], Array], w: Array, values: Array) -> Array:
    """Return the zero crossings of a function, bracketed by its values on a grid."""
    above = values > 0.0
    at = np.flatnonzero(above[1:] != above[:-1])
    if not at.size:
        return np.zeros(0)
    rises, row = above[at + 1][:, None], np.arange(at.size)
    low, high, ends = w[at], w[at + 1], (values[at], values[at + 1])
    # The last interval is a millionth of the first: a straight line then errs by the square of that.
    for _ in range(5):
        x = low[:, None] + (high - low)[:, None] * FINER
        found = np.column_stack([ends[0], function(x[:, 1:-1].ravel()).reshape(at.size, -1), ends[1]])
        over = np.argmax((found > 0.0) == rises, axis=1)
        low, high, ends = x[row, over - 1], x[row, over], (found[row, over - 1], found[row, over])
    return np.asarray(low - ends[0] * (high - low) / (ends[1] - ends[0]))


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
        # A heavy weight holds the sum at 1 to rounding. No more than three vertices are needed to reach any point of a polygon.
        heavy = 1e6 * max(1.0, float(np.abs(vertices + 1.0).max()))
        system, target = np.vstack([vertices.real + 1.0, vertices.imag, np.full(vertices.size, heavy)]), np.array([0.0, 0.0, heavy])
        best, left = np.zeros(vertices.size), math.inf
        for size in range(1, min(vertices.size, 3) + 1):
            for support in map(list, combinations(range(vertices.size), size)):
                weights = np.zeros(vertices.size)
                weights[support] = np.linalg.lstsq(system[:, support], target)[0]
                residual = float(np.linalg.norm(system @ weights - target))
                if weights.min() >= 0.0 and residual < left:
                    best, left = weights, residual
        return cls(value, frequency, best / best.sum())


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
    scale = float(np.abs(values).max(initial=1.0))
    alike = [np.abs(values[:, i] - values[:, j]).max() <= 1e-12 * scale for i, j in pairs]
    edges = [pair for pair, same in zip(pairs, alike, strict=True) if not same] or [(0, 0)]
    shares = SHARES[:, None]
    means = [values[:, i] + shares * (values[:, j] - values[:, i]) for i, j in edges]
    worst = []
    for rough, exact in ((_interpolated_phases, _phase_margin), (_interpolated_factors, _gain_margin)):
        sizes = np.abs([rough(mean) for mean in means])
        edge, share = np.unravel_index(sizes.argmin(), sizes.shape)
        worst.append(_refined(loops, frequency, values, edges[int(edge)], float(SHARES[share]), exact))
    return worst[0], worst[1]


def _refined(
    loops: LoopGain, w: Array, values: Complex, edge: tuple[int, int], share: float, exact: Callable[..., tuple[float, float]]
) -> HullMargin:
    """Return the exact margin of the worst mean on an edge near a share; `values` (n, n_loop) are the loop gains on the grid."""

    def weights(at: float) -> Array:
        mean = np.zeros(values.shape[1])
        mean[edge[0]] += 1.0 - at
        mean[edge[1]] += at
        return mean

    def margin(at: float) -> tuple[float, float]:
        mean = weights(at)
        return exact(lambda x: np.asarray(loops(x) @ mean), w, values @ mean)

    def size(at: float) -> float:
        return min(abs(margin(at)[0]), 1e12)

    shares = [share]
    if edge[0] != edge[1] and math.isfinite(margin(share)[0]):
        shares.append(_lowest(size, max(share - float(SHARES[1]), 0.0), min(share + float(SHARES[1]), 1.0)))
    worst = min(shares, key=size)
    return HullMargin(*margin(worst), weights(worst))


def _lowest(function: Callable[[float], float], low: float, high: float) -> float:
    """Return where a function with one minimum is least between two places, to 1e-5."""
    while high - low > 1e-5:
        left, right = low + 0.45 * (high - low), low + 0.55 * (high - low)
        low, high = (low, right) if function(left) < function(right) else (left, high)
    return (low + high) / 2.0


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
