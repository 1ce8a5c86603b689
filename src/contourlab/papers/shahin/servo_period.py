"""The largest servo period at which a scheme stays stable in each of its modes, sampled and held as it runs.

A command that is held for too long lets a motor whose loop is fast swing: with derivative gain K and inertia J the period has to stay below
about 2 J/K, whatever the resonance does. The growth of the sampled loop is followed over the period, and every change of its sign found.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.analysis.linear.small_exponential import exponentials
from contourlab.errors import ParameterError
from contourlab.papers.shahin.two_inertia_loop import Feedback, TwoInertias

Array = NDArray[np.float64]

PER_DECADE = 100
PER_TURN = 100
SAFE = 1e-9
"""Growth, over the fastest rate, up to which a mode is called stable: an eigenvalue on the circle is one but for rounding."""


@dataclass(frozen=True)
class ServoPeriodLimit:
    """Servo periods at which one mode is stable.

    Attributes
    ----------
    mode : "gap" or "contact"
    largest : float [s]
        Stable at every period below it; 0 if it is stable at none, inf if at all that were looked at.
    windows : tuple of (float, float) [s]
        All ranges of stable periods between 0 and `searched`.
    searched : float [s]
        Longest period looked at.
    free : tuple of complex [1/s]
        Rates of what the command cannot move or the controller does not see, such as a free load: they are set apart.
    """

    mode: str
    largest: float
    windows: tuple[tuple[float, float], ...]
    searched: float
    free: tuple[complex, ...]

    def __str__(self) -> str:
        if not self.windows:
            return f"{self.mode}: stable at no servo period"
        if math.isinf(self.largest):
            return f"{self.mode}: stable at every servo period up to {self.searched:.4g} s"
        more = "".join(f", and from {low:.4g} to {high:.4g} s" for low, high in self.windows if low > 0.0)
        return f"{self.mode}: stable below {self.largest:.4g} s{more}"


def servo_period_limit(
    drive: TwoInertias, gap: Feedback, contact: Feedback | None = None, *, longest: float = 0.1, delay: int = 0
) -> tuple[ServoPeriodLimit, ServoPeriodLimit]:
    """Return the servo periods at which a scheme is stable in the gap and in contact.

    Parameters
    ----------
    drive : TwoInertias
    gap : Feedback
        Controller in the gap; and in contact, if nothing else is given.
    contact : Feedback, optional
    longest : float [s]
        Longest period to look at.
    delay : int
        Whole periods between measuring and the command's arrival; 0 if it acts at once.

    Returns
    -------
    (ServoPeriodLimit, ServoPeriodLimit)
        For the gap and for contact. Each says what its mode would do for ever; switching between them is not covered.

    Raises
    ------
    ParameterError
        For a longest period that is not positive, or a negative delay.
    """
    if not 0.0 < longest < math.inf:
        raise ParameterError("longest", longest, "above 0", "s")
    if delay < 0:
        raise ParameterError("delay", delay, "0 or more periods")
    modes = (("gap", drive.a, gap), ("contact", drive.contact_a, contact or gap))
    in_gap, in_contact = (_limit(name, a, drive.command, feedback, longest, delay) for name, a, feedback in modes)
    return in_gap, in_contact


def sampled_matrix(a: Array, command: Array, gain: Array, integral: Array, period: ArrayLike, delay: int = 0) -> Array:
    """Return the matrices (..., m, m) from one tick to the next: mechanics under a held command, integrals, commands on their way.

    Parameters
    ----------
    a : ndarray (n, n), command : ndarray (n,)
        Mechanics in one mode.
    gain : ndarray (m,), integral : ndarray (m - n, m)
        Controller: u = -gain (x, z), z' = integral (x, z).
    period : array_like (...,) [s]
    delay : int
    """
    n, m, periods = len(a), len(gain), np.asarray(period, dtype=float)
    held = np.zeros((n + 1, n + 1))
    held[:n, :n], held[:n, n] = a, command
    step = exponentials(held, periods)
    matrix = np.zeros((*periods.shape, m + delay, m + delay))
    matrix[..., :n, :n] = step[..., :n, :n]
    law = np.zeros(m + delay)
    law[:m] = -gain
    # The sum includes this tick's value only in the next command, as a controller with a state does it.
    matrix[..., n:m, :m] = periods[..., None, None] * integral
    matrix[..., n:m, n:m] += np.eye(m - n)
    if delay == 0:
        matrix[..., :n, :] += step[..., :n, n, None] * law
        return matrix
    matrix[..., :n, m] = step[..., :n, n]
    matrix[..., m : m + delay - 1, m + 1 :] = np.eye(delay - 1)
    matrix[..., m + delay - 1, :] = law
    return matrix


def _limit(mode: str, a: Array, command: Array, feedback: Feedback, longest: float, delay: int) -> ServoPeriodLimit:
    kept = _in_the_loop(a, command, feedback)
    apart = [i for i in range(len(a)) if i not in kept]
    free = tuple(complex(value) for value in np.linalg.eigvals(a[np.ix_(apart, apart)])) if apart else ()
    inner, entering = a[np.ix_(kept, kept)], command[kept]
    columns = [*kept, *range(len(a), len(feedback.gain))]
    gain = np.array(feedback.gain)[columns]
    integral = np.array(feedback.integral).reshape(-1, len(feedback.gain))[:, columns]

    def growth(period: ArrayLike) -> Array:
        """Rate of the fastest growing mode, 1/s."""
        values = np.abs(np.linalg.eigvals(sampled_matrix(inner, entering, gain, integral, period, delay)))
        return np.asarray(np.log(np.maximum(values.max(axis=-1), 1e-300)) / period)

    rate = max(float(np.abs(np.linalg.eigvals(_continuous(inner, entering, gain, integral))).max()), 1e-300)
    swings = float(np.abs(np.linalg.eigvals(inner)).max())
    periods = _periods(rate, swings, longest)
    windows = _windows(growth, periods, SAFE * rate)
    first = next((high for low, high in windows if low == 0.0), 0.0)
    return ServoPeriodLimit(mode, math.inf if first >= longest else first, windows, longest, free)


def _in_the_loop(a: Array, command: Array, feedback: Feedback) -> list[int]:
    """Return the mechanical states that the command moves and the controller sees, by the pattern of what acts on what."""
    n = len(a)
    moved, seen = command != 0.0, np.zeros(n, dtype=bool)
    for row in (feedback.gain, *feedback.integral):
        seen |= np.array(row[:n]) != 0.0
    for _ in range(n):
        moved = moved | ((a != 0.0) @ moved)
        seen = seen | ((a != 0.0).T @ seen)
    return [i for i in range(n) if moved[i] and seen[i]]


def _continuous(a: Array, command: Array, gain: Array, integral: Array) -> Array:
    """Return the loop as it would be without sampling."""
    n, m = len(a), len(gain)
    matrix = np.zeros((m, m))
    matrix[:n, :n] = a
    matrix[:n] -= np.outer(command, gain)
    matrix[n:] = integral
    return matrix


def _periods(rate: float, swings: float, longest: float) -> Array:
    """Return periods dense in ratio, from well below the fastest loop's time, and dense in each turn of the mechanics."""
    first = min(1e-3 / rate, 1e-3 * longest)
    count = max(2, int(PER_DECADE * math.log10(longest / first)))
    grids = [np.geomspace(first, longest, count)]
    if swings > 0.0:
        grids.append(np.linspace(0.0, longest, max(2, int(PER_TURN * longest * swings / (2.0 * math.pi))))[1:])
    return np.unique(np.concatenate(grids))


def _windows(growth: Callable[[ArrayLike], Array], periods: Array, safe: float) -> tuple[tuple[float, float], ...]:
    """Return the ranges in which the growth is not above `safe`, each end found to rounding."""
    from scipy.optimize import brentq, minimize_scalar

    values = (growth(periods) - safe).tolist()
    places = [float(t) for t in periods]
    for i in _near_misses(values):
        # Between neighbours a peak may pass 0, or a dip, that the grid steps over.
        sign = 1.0 if values[i] > 0.0 else -1.0
        bounds = (float(periods[i - 1]), float(periods[i + 1]))
        found = minimize_scalar(
            lambda t, sign=sign: sign * float(growth(t)), bounds=bounds, method="bounded", options={"xatol": 1e-9 * bounds[1]}
        )
        places.append(float(found.x))
        values.append(float(growth(float(found.x))) - safe)
    order = np.argsort(places)
    at, value = np.array(places)[order], np.array(values)[order]
    changes = np.flatnonzero((value[1:] > 0.0) != (value[:-1] > 0.0))
    edges = [float(brentq(lambda t: float(growth(t)) - safe, at[i], at[i + 1], xtol=1e-14 * at[i], rtol=1e-13)) for i in changes]
    marks = [0.0, *edges, float(at[-1])]
    stable = bool(value[0] <= 0.0)
    return tuple((low, high) for k, (low, high) in enumerate(pairwise(marks)) if stable == (k % 2 == 0))


def _near_misses(values: Sequence[float]) -> list[int]:
    """Return where the growth turns back before it changes its sign."""
    v = np.array(values)
    inner, left, right = v[1:-1], v[:-2], v[2:]
    peaks = (inner <= 0.0) & (inner >= left) & (inner >= right)
    dips = (inner > 0.0) & (inner <= left) & (inner <= right)
    return [int(i) + 1 for i in np.flatnonzero(peaks | dips)]
