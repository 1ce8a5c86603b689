"""Where within a step something happens: the first zero of the cubic through values and slopes at both ends of the step."""

from __future__ import annotations

from contourlab.primitives import fabs, select, sqrt

NEVER = 2.0
"""Past the end of a step."""

ITERATIONS = 50
"""At most: of Newton's rule held inside a bracket, halved where it would leave it; it ends where it moves no more, mostly after five."""

SETTLED = 1e-15
"""Part of a step."""


def hermite(u: float, y0: float, y1: float, d0: float, d1: float) -> float:
    """Return the cubic at the part u of a step, from values and slopes (per step) at its ends."""
    c2, c3 = 3.0 * (y1 - y0) - 2.0 * d0 - d1, 2.0 * (y0 - y1) + d0 + d1
    return y0 + u * (d0 + u * (c2 + u * c3))


def first_zero(y0: float, y1: float, d0: float, d1: float) -> float:
    """Return where the cubic first falls through zero, as a part of the step; wanted is y1 < 0.

    Where it starts at zero or below, it counts as positive there: zero is returned only where it falls at once.
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
        inside = select(wanted >= low, select(wanted <= high, 1.0, 0.0), 0.0)
        following = select(value == 0.0, u, select(inside > 0.5, wanted, 0.5 * (low + high)))
        moved, u = fabs(following - u), following
        if moved <= SETTLED:
            break
    return u


def first_dip(y0: float, y1: float, d0: float, d1: float) -> float:
    """Return where the cubic falls through zero on its way from y0 > 0 to y1 >= 0, as a part of the step; `NEVER` where it does not.

    What dips below zero within a step and comes back is not seen at its ends.
    """
    if not (y0 > 0.0 and d0 < 0.0 and d1 > 0.0):
        return NEVER
    c2, c3 = 3.0 * (y1 - y0) - 2.0 * d0 - d1, 2.0 * (y0 - y1) + d0 + d1
    lowest = _lowest(d0, c2, c3)
    depth = y0 + lowest * (d0 + lowest * (c2 + lowest * c3))
    return lowest * first_zero(y0, depth, lowest * d0, 0.0) if depth < 0.0 else NEVER


def _lowest(d0: float, c2: float, c3: float) -> float:
    """Return where d0 u + c2 u^2 + c3 u^3 has its lowest point, or `NEVER` where it has none."""
    radicand = c2 * c2 - 3.0 * c3 * d0
    root = sqrt(fabs(radicand))
    # Of the two forms of the zero of the slope, the one without a difference of like numbers.
    ahead = c2 + root
    over = select(c2 > 0.0, ahead, 3.0 * c3)
    top = select(c2 > 0.0, -d0, root - c2)
    return select(radicand < 0.0, NEVER, select(over == 0.0, NEVER, top / select(over == 0.0, 1.0, over)))
