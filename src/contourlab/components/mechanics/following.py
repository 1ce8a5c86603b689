"""A plant that a step count pulls along: count, axis and friction integrated together.

A step generator spreads its pulses evenly over a servo period, so the count runs from the last command to the new one on a straight line,
rounded to whole steps. A sub-step takes the mean of the count over it, the axis where it is at the middle by its present speed (Verlet),
and the speed there by the acceleration before: second order, and a spring gains and loses no energy. Pull and load are then constant, so
friction acts as on every other plant.

Without the mean, pulses between two sub-steps would shift to their ends: a beat that shakes the axis where it meets a resonance.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from contourlab.engine.step import record
from contourlab.primitives import Clock, rint, select

_Pushed = record(("command", "load"))


def mean_count(step: float, first: float, last: float) -> float:
    """Return the mean of a count that runs from one position to another, rounded to whole steps; without a step it is not rounded."""
    pulse = select(step > 0.0, step, 1.0)
    a, b = first / pulse, last / pulse
    start = rint(a)
    steps = rint(b - start)
    # The integral of rint from 0 to u is n u - n^2/2, n = rint(u).
    risen = select(steps == 0.0, 0.0, (steps * (b - start) - 0.5 * steps * steps) / select(steps == 0.0, 1.0, b - a))
    return select(step > 0.0, pulse * (start + risen), 0.5 * (first + last))


@cache
def following(plant: Any, friction: Any, law: Callable[..., Any], substeps: int) -> Callable[..., Any]:
    """Return the step over a servo period.

    Parameters
    ----------
    plant : type
        With ``pull(par, count, rate, position, velocity)``, ``step_value`` in `par`, and the pull as drive force.
    friction : type
    law : callable
        Returns the step of plant and friction under a constant force.
    substeps : int
    """
    pull, advance = plant.pull, law(plant, friction)
    motion = record(("position", "velocity", *(port.name for port in friction.states)))

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        h, rate = clock.dt / float(substeps), (inp.command - x.count) / clock.dt
        state, change = motion(x.position, x.velocity, *x[4:]), x.change
        for i in range(substeps):
            count = mean_count(par.step_value, x.count + float(i) * h * rate, x.count + float(i + 1) * h * rate)
            push = pull(par, count, rate, state.position + 0.5 * h * state.velocity, state.velocity + 0.5 * h * change)
            moved, out = advance(par, state, _Pushed(push, inp.load), Clock(clock.k, clock.t, h))
            state, change = motion(*moved), out[2]
        mean = (state.velocity - x.velocity) / clock.dt
        return (state.position, state.velocity, inp.command, change, *state[2:]), (state.position, state.velocity, mean)

    return step
