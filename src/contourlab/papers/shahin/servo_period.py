"""Largest servo period at which a sampled loop is stable, in the gap and in contact.

A fast motor loop oscillates if its command is held too long: with derivative gain K and inertia J the period must stay below about 2 J/K.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.backlash.periodic_orbit import exponentials
from contourlab.arrays import Array
from contourlab.papers.shahin.two_inertia_loop import Feedback, TwoInertias

LONGEST = 0.1
"""Longest period tested [s]."""
PER_DECADE = 100
PER_TURN = 100
SAFE = 1e-9
"""Growth relative to the fastest rate up to which a mode counts as stable: rounding of an eigenvalue on the unit circle."""


def servo_period_limit(drive: TwoInertias, feedback: Feedback) -> tuple[float, float]:
    """Return the largest stable servo periods [s] in the gap and in contact: 0 if always unstable, inf if stable up to `LONGEST`.

    Each limit holds for a mode that lasts, not for switching between modes.
    """
    return _limit(drive.a, drive.command, feedback), _limit(drive.contact_a, drive.command, feedback)


def sampled_matrix(a: Array, command: Array, gain: Array, integral: Array, period: ArrayLike) -> Array:
    """Return the matrices (..., m, m) from one tick to the next: mechanics under a held command, and integrals.

    Parameters
    ----------
    a : ndarray (n, n), command : ndarray (n,)
        Mechanics in one mode.
    gain : ndarray (m,), integral : ndarray (m - n, m)
        Controller: u = -gain (x, z), z' = integral (x, z).
    period : array_like (...,) [s]
    """
    n, m, periods = len(a), len(gain), np.asarray(period, dtype=float)
    held = np.zeros((n + 1, n + 1))
    held[:n, :n], held[:n, n] = a, command
    step = exponentials(held, periods)
    matrix = np.zeros((*periods.shape, m, m))
    matrix[..., :n, :n] = step[..., :n, :n]
    # The integrals act on the next command.
    matrix[..., n:m, :m] = periods[..., None, None] * integral
    matrix[..., n:m, n:m] += np.eye(m - n)
    matrix[..., :n, :] += step[..., :n, n, None] * -gain
    return matrix


def _limit(a: Array, command: Array, feedback: Feedback) -> float:
    from scipy.optimize import brentq

    kept = _in_the_loop(a, command, feedback)
    inner, entering = a[np.ix_(kept, kept)], command[kept]
    columns = [*kept, *range(len(a), len(feedback.gain))]
    gain = np.array(feedback.gain)[columns]
    integral = np.array(feedback.integral).reshape(-1, len(feedback.gain))[:, columns]
    rate = max(float(np.abs(np.linalg.eigvals(_continuous(inner, entering, gain, integral))).max()), 1e-300)

    def growth(period: ArrayLike) -> Array:
        """Return the growth rate [1/s] of the fastest growing mode, above the limit for stability."""
        values = np.abs(np.linalg.eigvals(sampled_matrix(inner, entering, gain, integral, period)))
        return np.asarray(np.log(np.maximum(values.max(axis=-1), 1e-300)) / period) - SAFE * rate

    periods = _periods(rate, float(np.abs(np.linalg.eigvals(inner)).max()))
    unstable = np.flatnonzero(growth(periods) > 0.0)
    if not unstable.size:
        return math.inf
    first = int(unstable[0])
    if first == 0:
        return 0.0
    low, high = float(periods[first - 1]), float(periods[first])
    return float(brentq(lambda t: float(growth(t)), low, high, xtol=1e-14 * low, rtol=1e-13))


def _in_the_loop(a: Array, command: Array, feedback: Feedback) -> list[int]:
    """Return the mechanical states that are controllable from the command and observable by the controller."""
    n = len(a)
    moved, seen = command != 0.0, np.zeros(n, dtype=bool)
    for row in (feedback.gain, *feedback.integral):
        seen |= np.array(row[:n]) != 0.0
    for _ in range(n):
        moved = moved | ((a != 0.0) @ moved)
        seen = seen | ((a != 0.0).T @ seen)
    return [i for i in range(n) if moved[i] and seen[i]]


def _continuous(a: Array, command: Array, gain: Array, integral: Array) -> Array:
    """Return the matrix of the loop without sampling."""
    n, m = len(a), len(gain)
    matrix = np.zeros((m, m))
    matrix[:n, :n] = a
    matrix[:n] -= np.outer(command, gain)
    matrix[n:] = integral
    return matrix


def _periods(rate: float, oscillation: float) -> Array:
    """Return test periods: spaced geometrically from far below the fastest time constant, and densely over mechanical oscillations."""
    first = min(1e-3 / rate, 1e-3 * LONGEST)
    count = max(2, int(PER_DECADE * math.log10(LONGEST / first)))
    grids = [np.geomspace(first, LONGEST, count)]
    if oscillation > 0.0:
        grids.append(np.linspace(0.0, LONGEST, max(2, int(PER_TURN * LONGEST * oscillation / (2.0 * math.pi))))[1:])
    return np.unique(np.concatenate(grids))
