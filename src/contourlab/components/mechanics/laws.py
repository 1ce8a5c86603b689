"""Forces of friction and of a shaft with backlash between two masses, and the location of events within a step.

`side` is 1 or -1 if the shaft presses on the forward or backward flank, 0 in the gap.
A state is a tuple (motor position, motor velocity, load position, load velocity), all at the load. A guard falls to zero where the contact
changes: at the first zero of the cubic through its values and slopes at both ends of a step.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from contourlab.primitives import exp, fabs, select, sqrt

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
    over = select(c2 > 0.0, c2 + root, 3.0 * c3)
    top = select(c2 > 0.0, -d0, root - c2)
    return select(radicand < 0.0, NEVER, select(over == 0.0, NEVER, top / select(over == 0.0, 1.0, over)))


@cache
def friction_of(friction: Any) -> tuple[Callable[..., Any], Callable[..., Any], bool]:
    """Return the resistance ``(par, v, way)``, the force held at rest ``(par)``, and whether a body can be held at all."""
    if friction.law == "sticking":
        sliding = friction.sliding

        def sliding_one_way(par: Any, v: float, way: float) -> float:
            # A stage past the reversal sees the friction continued smoothly, which keeps the order.
            return way * sliding(par, way * v)  # type: ignore[no-any-return]

        return sliding_one_way, friction.held, True
    force = friction.force

    def either_way(par: Any, v: float, way: float) -> float:
        return force(par, v)  # type: ignore[no-any-return]

    def nothing(par: Any) -> float:
        return 0.0

    return either_way, nothing, False


@cache
def shaft_of(gap: Any, known: bool = True) -> Callable[..., Any]:
    """Return ``shaft(par, side, y)``: the force on the motor, and that on the load.

    ``gap(par, position)`` is half of the free travel at the load's position, and its slope. A gap that narrows pushes the load, so that the
    shaft stays conservative. Unless `side` is `known`, each evaluation looks it up, and leaves the damping out.
    """

    def shaft(par: Any, side: float, y: Any) -> tuple[float, float]:
        half, slope = gap(par, y[2])
        theta = y[0] - y[2]
        if not known:
            side = select(theta > half, 1.0, select(theta < -half, -1.0, 0.0))
        turned = 1.0 if slope == 0.0 else 1.0 + side * slope
        force = par.stiffness_value * (theta - side * half)
        if known:
            force = force + par.damper_value * (y[1] - y[3] * turned)
        force = select(side == 0.0, 0.0, force)
        return force, force * turned

    return shaft


@cache
def contact_guard_of(gap: Any, physical: bool) -> tuple[Callable[..., Any], Callable[..., Any]]:
    """Return the guard that falls to zero where a flank is left, or `flank` is reached, and its slope.

    They take ``(par, side, flank, y, twist)``, the slope the accelerations of both masses after y; `twist` is the twist that the shaft
    kept when it left a flank.
    """

    def guard(par: Any, side: float, flank: float, y: Any, twist: float) -> float:
        half, slope = gap(par, y[2])
        theta = y[0] - y[2]
        pressed = side * theta - half
        if physical:
            rate = y[1] - y[3] - side * slope * y[3]
            pressed = par.stiffness_value * pressed + side * par.damper_value * rate
        return select(side == 0.0, half - flank * (theta - twist), pressed)

    def falling(par: Any, side: float, flank: float, y: Any, a: Any, twist: float) -> float:
        slope, rate = gap(par, y[2])[1], y[1] - y[3]
        pressing = side * rate - slope * y[3]
        if physical:
            pressing = par.stiffness_value * pressing + side * par.damper_value * (a[0] - a[1])
        return select(side == 0.0, slope * y[3] - flank * (rate + par.unwinding * twist), pressing)

    return guard, falling


def body_guard(way: float, v: float, push: float, toward: float, held: float) -> float:
    """Return a guard that falls to zero where a body stops or, while held, breaks loose `toward` one direction.

    `push` is the sum of all forces but friction. For the slope pass acceleration, the push's slope, and 0 for `held`.
    """
    return select(way == 0.0, held - toward * push, way * v)


def unwound(par: Any, twist: float, h: float) -> float:
    """Return the twist in the gap after h."""
    return twist * exp(-par.unwinding * h) if twist != 0.0 else 0.0
