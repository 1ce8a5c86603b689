"""Which values of a quantity of the links are looked at: a grid that hangs on nothing but the servo clock, and what it passes over."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import ParameterError

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
LOSSES = np.linspace(0.0, 0.98, 50)
EACH = 128
"""Servo periods of which each is looked at."""
FARTHER = 64
"""Values to each doubling beyond them."""


def times(quantity: str, period: float, longest: float) -> Array:
    """Return the values of a time that are looked at [s]: each servo period up to `EACH`, then `FARTHER` of them to each doubling.

    Up to where two grids reach they are the same, so that a limit does not hang on how far one looks.

    Parameters
    ----------
    quantity : str
        A message period, which begins at one servo period, or another time, which begins at 0.
    period, longest : float [s]
        Servo period, and the end, which is looked at itself.

    Raises
    ------
    ParameterError
        If the longest time is below a servo period.
    """
    if not longest >= period:
        raise ParameterError("longest", f"{longest:g}", f">= the servo period, {period:g}", "s")
    last = math.floor(longest / period + 1e-9)
    parts = [np.arange(min(EACH, last) + 1)]
    start = EACH
    while start < last:
        parts.append(np.arange(start, min(2 * start, last) + 1, start // FARTHER))
        start *= 2
    ticks = np.unique(np.concatenate([*parts, [last]])).astype(float)
    return np.asarray(period * (ticks[1:] if quantity == "message_period" else ticks))


def passed_over(values: Array, bad: Mask, unknown: Mask, period: float, most: int) -> Array:
    """Return whole servo periods between the last value that is good ahead of the first bad one and that one, evenly, so many at most.

    Parameters
    ----------
    values : ndarray (n,) [s]
        Rising.
    bad, unknown : ndarray (n,)
        A value of which nothing is known is neither good nor bad.
    period : float [s]
        Servo period.
    most : int

    Examples
    --------
    >>> import numpy as np
    >>> values, no = np.array([0.0, 8.0, 16.0, 24.0]), np.zeros(4, dtype=bool)
    >>> passed_over(values, np.array([False, False, True, False]), no, 1.0, 3).tolist()
    [10.0, 12.0, 14.0]
    """
    if not bad.any():
        return np.zeros(0)
    first = int(np.argmax(bad))
    good = np.flatnonzero(~unknown[:first])
    if not good.size:
        return np.zeros(0)
    low, high = (round(value / period) for value in (values[good[-1]], values[first]))
    step = max(1, math.ceil((high - low) / (most + 1)))
    return period * np.arange(low + step, high, step, dtype=float)
