"""Values with as many digits as a file has, rounded in the unit that people write, so that what is judged is what is read back."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.design.bounds import ROUNDING
from contourlab.units import from_si, in_si

Array = NDArray[np.float64]
DIGITS = 6
"""Of a value as it is written in a file."""


def with_digits(values: ArrayLike, unit: str, low: float = -np.inf, high: float = np.inf) -> Array:
    """Return values [SI] with six digits in a unit: bit by bit what their text is read as.

    Parameters
    ----------
    values : array_like [SI], low to high
    unit : str
        In which they are written.
    low, high : float [SI]
        A value that would be rounded beyond one of them is rounded the other way; where nothing of six digits lies between, it stays.

    >>> with_digits([0.0123456789, 0.99999996], "m", high=1.0).tolist()
    [0.0123457, 1.0]
    """
    v = np.asarray(values, dtype=float)
    whole, power = _split(np.asarray(from_si(v, unit)))
    under, over = low - ROUNDING * abs(low), high + ROUNDING * abs(high)
    made = in_si(_over(whole, -power), unit)
    inwards = np.where(made > over, -1.0, np.where(made < under, 1.0, 0.0))
    made = in_si(_over(whole + inwards, -power), unit)
    return np.where((made > over) | (made < under), v, made)


def _split(values: Array) -> tuple[Array, Array]:
    """Return values with so many digits as whole numbers, and the powers of ten that these count."""
    power = np.floor(np.log10(np.where(values == 0.0, 1.0, np.abs(values)))) - (DIGITS - 1)
    return np.rint(_over(values, power)), power


def _over(values: Array, power: Array) -> Array:
    """Return values over powers of ten, by one whole power of ten: of whole numbers this is rounded once, as their text is."""
    return np.where(power < 0.0, values * 10.0 ** np.maximum(-power, 0.0), values / 10.0 ** np.maximum(power, 0.0))
