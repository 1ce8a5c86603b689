"""Forces of friction and of a shaft with backlash between two masses, and guards that fall to zero where the contact changes.

`side` is 1 or -1 if the shaft presses on the forward or backward flank, 0 in the gap, `UNKNOWN` if each evaluation looks it up.
A state is a tuple (motor position, motor velocity, load position, load velocity), all at the load.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from contourlab.primitives import clip, exp, fabs, select

UNKNOWN = 2.0


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
def shaft_of(gap: Any) -> Callable[..., Any]:
    """Return ``shaft(par, side, y)``: the force on the motor, and that on the load.

    ``gap(par, position)`` is half of the free travel at the load's position, and its slope. A gap that narrows pushes the load, so that the
    shaft stays conservative.
    """

    def shaft(par: Any, side: float, y: Any) -> tuple[float, float]:
        half, slope = gap(par, y[2])
        theta = y[0] - y[2]
        known = fabs(side) < 1.5
        flank = select(known, side, select(theta > half, 1.0, select(theta < -half, -1.0, 0.0)))
        twist = theta - select(known, side * half, clip(theta, -half, half))
        rate = y[1] - y[3] * (1.0 + flank * slope)
        force = par.stiffness_value * twist + select(known, par.damper_value * rate, 0.0)
        force = select(flank == 0.0, 0.0, force)
        return force, force * (1.0 + flank * slope)

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
