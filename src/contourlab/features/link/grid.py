"""The values at which a link quantity is tested: a grid that depends only on the servo period, and the gaps in it."""

from __future__ import annotations

import math

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.errors import ParameterError

LOSSES = np.linspace(0.0, 0.98, 50)
EACH = 128
"""Every multiple of the servo period is tested up to this one."""
FARTHER = 64
"""Values per doubling above `EACH`."""
FEW = (4, 2, 1)
"""Values per doubling of a quick grid, and the multiple of the servo period up to which it has each one: the most that fit."""


def losses(few: int = 0) -> Array:
    """Return the shares of lost messages to test; `few` as in `times`, with half as many values."""
    return LOSSES[_multiples(max(few // 2, 1), max(few // 2, 1), len(LOSSES) - 1)] if few else LOSSES


def times(quantity: str, period: float, longest: float, few: int = 0) -> Array:
    """Return the times to test [s]: each multiple of the servo period up to `EACH`, then `FARTHER` values per doubling.

    Grids of different length agree where they overlap, so a limit does not depend on `longest`.

    Parameters
    ----------
    quantity : str
        ``message_period`` begins at one servo period, other times begin at 0.
    period, longest : float [s]
        Servo period, and the last value.
    few : int
        For a quick grid, one of `FEW`: it replaces both numbers. 0 for the whole grid.

    Raises
    ------
    ParameterError
        If the longest time is shorter than a servo period.
    """
    if not longest >= period:
        raise ParameterError("longest", f"{longest:g}", f">= the servo period, {period:g}", "s")
    ticks = _multiples(*((few, few) if few else (EACH, FARTHER)), math.floor(longest / period + 1e-9)).astype(float)
    return np.asarray(period * (ticks[1:] if quantity == "message_period" else ticks))


def _multiples(each: int, farther: int, last: int) -> Index:
    """Return 0 and each number up to `each`, then `farther` per doubling, and `last`."""
    parts, start = [np.arange(min(each, last) + 1)], each
    while start < last:
        parts.append(np.arange(start, min(2 * start, last) + 1, start // farther))
        start *= 2
    return np.unique(np.concatenate([*parts, [last]]))


def passed_over(values: Array, bad: Flags, unknown: Flags, period: float, most: int) -> Array:
    """Return multiples of the servo period, evenly spaced, between the last good value and the first bad one.

    Parameters
    ----------
    values : ndarray (n,) [s]
        Increasing.
    bad, unknown : ndarray (n,)
        An unknown value is neither good nor bad.
    period : float [s]
        Servo period.
    most : int
        Largest number of values.

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
