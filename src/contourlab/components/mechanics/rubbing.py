"""Friction on a plant that has a step of its own: the force that agrees with the velocity it leaves at the end of the step.

The step runs without friction, and with a unit of force more: the difference tells how much a force that lasts over the step changes the
velocity at its end, exactly if the plant is linear in its load. The friction follows from both, and the step runs once more with it. This
is backward Euler: of first order in the sub-step, without chatter, and a friction that sticks holds the axis.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from contourlab.components.mechanics.laws import ITERATIONS, SETTLED, friction_of
from contourlab.engine.step import record
from contourlab.primitives import fabs, select, sqrt


@cache
def rubbed(base: Any, friction: Any, states: tuple[str, ...], inputs: tuple[str, ...], velocity: int) -> Callable[..., Any]:
    """Return the step of plant and friction.

    Parameters
    ----------
    base : callable
        The plant's step.
    friction : friction class
    states, inputs : tuple of str
        Of the plant.
    velocity : int
        Place of the velocity in its outputs.
    """
    own, pushed, load, meets = record(states), record(inputs), inputs.index("load"), _bristles if friction.states else _resists
    meeting = meets(friction)

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        state = own(*x[: len(states)])
        free = base(par, state, inp, clock)[1][velocity]
        more = base(par, state, pushed(*inp[:load], inp.load + 1.0, *inp[load + 1 :]), clock)[1][velocity]
        # A load that does not push the velocity forward ends the run.
        gain = select(more > free, more - free, sqrt(-1.0))
        force, kept = meeting(par, x, free, gain, clock.dt)
        after, out = base(par, state, pushed(*inp[:load], inp.load - force, *inp[load + 1 :]), clock)
        return (*after, *kept), (*out[:velocity], out[velocity] + 0.0 * force, *out[velocity + 1 :])

    return step


def _resists(friction: Any) -> Callable[..., Any]:
    """Return ``meeting(par, x, free, gain, h)``: the mean force, from the velocity without it and its fall per force; no new states."""
    resistance, held, sticks = friction_of(friction)

    def meeting(par: Any, x: Any, free: float, gain: float, h: float) -> Any:
        most, way = fabs(free), select(free < 0.0, -1.0, 1.0)
        low, high, speed, side = 0.0, most, most, 0.0
        below, above = gain * way * resistance(par, 0.0, way) - most, gain * way * resistance(par, way * most, way)
        if sticks and most <= gain * held(par):
            speed = 0.0
        else:
            # Illinois: regula falsi, with the value of an end halved that stays twice.
            for _ in range(ITERATIONS):
                gap = above - below
                speed = select(gap > 0.0, high - above * (high - low) / select(gap > 0.0, gap, 1.0), high)
                value = speed + gain * way * resistance(par, way * speed, way) - most
                over = value > 0.0
                below = select(over, select(side > 0.0, 0.5 * below, below), value)
                above = select(over, value, select(side < 0.0, 0.5 * above, above))
                low, high, side = select(over, low, speed), select(over, speed, high), select(over, 1.0, -1.0)
                if fabs(value) <= SETTLED * most:
                    break
        return (free - way * speed) / gain, ()

    return meeting


def _bristles(friction: Any) -> Callable[..., Any]:
    """Return the same for bristles, with their deflection at the end of the step."""
    level = friction.level

    def once(par: Any, z: float, v: float, free: float, gain: float, h: float) -> Any:
        keep = 1.0 / (1.0 + h * par.stiffness * fabs(v) / level(par, v))
        fixed = par.stiffness * keep * z + par.bristle_damping * (keep - 1.0) * z / h
        per_velocity = keep * (par.stiffness * h + par.bristle_damping) + par.viscous
        left = (free - gain * fixed) / (1.0 + gain * per_velocity)
        return left, fixed + per_velocity * left, keep * (z + h * left)

    def meeting(par: Any, x: Any, free: float, gain: float, h: float) -> Any:
        left, _, _ = once(par, x.bristle, free, free, gain, h)
        _, force, z = once(par, x.bristle, left, free, gain, h)
        return force, (z,)

    return meeting
