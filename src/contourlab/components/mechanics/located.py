"""Location of an event within a step: the first zero of the cubic through values and slopes at both ends."""

from __future__ import annotations

from contourlab.primitives import fabs, select, sqrt

NEVER = 2.0
"""Past the end of a step."""

ITERATIONS = 50
"""Most iterations of Newton's method in a bracket, with bisection; it usually converges in five."""

SETTLED = 1e-15
"""Tolerance, as a part of the step."""


def hermite(u: float, y0: float, y1: float, d0: float, d1: float) -> float:
    """Return the cubic at the part u of a step, from values and slopes (per step) at its ends."""
    c2, c3 = 3.0 * (y1 - y0) - 2.0 * d0 - d1, 2.0 * (y0 - y1) + d0 + d1
    return y0 + u * (d0 + u * (c2 + u * c3))


def first_zero(y0: float, y1: float, d0: float, d1: float) -> float:
    """Return where the cubic first falls through zero, as a part of the step; requires y1 < 0.

    A start at or below zero counts as positive: the result is zero only if the cubic falls at once.
    """
    c2, c3 = 3.0 * (y1 - y0) - 2.0 * d0 - d1, 2.0 * (y0 - y1) + d0 + d1
    low, high = 0.0, 1.0
    if d0 < 0.0 or c3 < 0.0:
        # Of three zeros the first lies ahead of the lowest point.
        lowest = _lowest(d0, c2, c3)
        if 0.0 < lowest < 1.0 and y0 + lowest * (d0 + lowest * (c2 + lowest * c3)) < 0.0:
            high = lowest
    u = high
    for _ in range(ITERATIONS):
        value = y0 + u * (d0 + u * (c2 + u * c3))
        slope = d0 + u * (2.0 * c2 + 3.0 * u * c3)
        low, high = select(value > 0.0, u, low), select(value > 0.0, high, u)
        wanted = u - value / select(slope == 0.0, 1.0, slope)
        # A step from one bound to the other would come back, and so forever.
        inside = wanted >= low and wanted <= high and fabs(wanted - u) < high - low
        following = select(value == 0.0, u, select(inside, wanted, 0.5 * (low + high)))
        moved, u = fabs(following - u), following
        if moved <= SETTLED:
            break
    return u


def first_dip(y0: float, y1: float, d0: float, d1: float) -> float:
    """Return where the cubic falls through zero between y0 > 0 and y1 >= 0, as a part of the step; `NEVER` if it does not.

    The ends of the step do not show such a dip.
    """
    if not (y0 > 0.0 and d0 < 0.0 and d1 > 0.0):
        return NEVER
    c2, c3 = 3.0 * (y1 - y0) - 2.0 * d0 - d1, 2.0 * (y0 - y1) + d0 + d1
    lowest = _lowest(d0, c2, c3)
    depth = y0 + lowest * (d0 + lowest * (c2 + lowest * c3))
    return lowest * first_zero(y0, depth, lowest * d0, 0.0) if depth < 0.0 else NEVER


def _lowest(d0: float, c2: float, c3: float) -> float:
    """Return the minimum of d0 u + c2 u^2 + c3 u^3, or `NEVER` if it has none."""
    radicand = c2 * c2 - 3.0 * c3 * d0
    root = sqrt(fabs(radicand))
    # The form of the root that avoids cancellation.
    ahead = c2 + root
    over = select(c2 > 0.0, ahead, 3.0 * c3)
    top = select(c2 > 0.0, -d0, root - c2)
    return select(radicand < 0.0, NEVER, select(over == 0.0, NEVER, top / select(over == 0.0, 1.0, over)))
