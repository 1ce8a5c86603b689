"""How long an error that grows by a constant factor takes to double."""

from __future__ import annotations

import math


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
