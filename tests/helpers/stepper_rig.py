"""A stepper alone, its step in plain Python, and an independent solution of its motion with friction that sticks."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from contourlab.components.contract import Component
from contourlab.components.friction.laws import NoFriction
from contourlab.components.mechanics.core import link
from contourlab.components.plant.stepper import Stepper
from contourlab.engine.step import record
from contourlab.primitives import Clock

Array = NDArray[np.float64]
PERIOD = 1e-3
INPUTS = record(("command", "load"))
SCREW: dict[str, Any] = {"mass": 8.0, "inertia": 6e-5, "lead": 5e-3, "holding_torque": 1.9, "efficiency": 0.9, "microsteps": 0.0}
"""An axis of a router: 96 kg with its rotor, 2.1 kN, 190 Hz."""


def stepper(**changes: Any) -> Stepper:
    return Stepper(**{**SCREW, **changes})


def march(
    plant: Any,
    commands: Any,
    load: float = 0.0,
    friction: Component | None = None,
    substeps: int = 8,
    period: float = PERIOD,
    start: Any = (),
) -> Array:
    """Return position and velocity (n + 1, 2) at the ends of servo periods; a plant starts at rest at 0 unless `start` says how."""
    rubbing = friction or NoFriction()
    step = link(plant, rubbing, None, substeps)
    par = step.par_type(**plant.block(period), **rubbing.block(period))
    names = record(tuple(port.name for port in step.states))
    x = names(*(start or (0.0,) * len(step.states)))
    seen = [x[:2]]
    for k, command in enumerate(np.asarray(commands, dtype=float).tolist()):
        x = names(*step.function(par, x, INPUTS(command, load), Clock(float(k), k * period, period))[0])
        seen.append(x[:2])
    return np.array(seen)


def force_of(plant: Stepper, off: float, rate: float, velocity: float = 0.0) -> float:
    """Return the force of a motor whose count is `off` [m] ahead and moves at a rate [m/s], from its data sheet."""
    turn = 2.0 * math.pi / plant.lead
    most = plant.holding_torque * plant.efficiency * turn
    lead = 2.0 * plant.damping_ratio * math.sqrt(mass_of(plant) / (most * 50.0 * turn))
    return most / math.hypot(1.0, rate / plant.corner_speed) * math.sin(50.0 * turn * (off + lead * (rate - velocity)))


def mass_of(plant: Stepper) -> float:
    return plant.mass + plant.carried_mass + plant.inertia * (2.0 * math.pi / plant.lead) ** 2


def solved(plant: Stepper, count: Callable[[float], tuple[float, float]], coulomb: float, times: Array) -> Array:
    """Return position and velocity (n, 2) of an axis with Coulomb friction from rest at 0, by an independent solver.

    `count` gives the count and its speed; each stretch of sliding or sticking ends at an event.
    """
    mass, y, t, way = mass_of(plant), np.zeros(2), 0.0, 0.0

    def push(t: float, y: Array) -> float:
        c, rate = count(t)
        return force_of(plant, c - y[0], rate, y[1])

    out = np.empty((times.size, 2))
    for _ in range(1000):
        if way:

            def slide(t: float, y: Array, way: float = way) -> list[float]:
                return [y[1], (push(t, y) - plant.damping * y[1] - way * coulomb) / mass]

            def stop(t: float, y: Array, way: float = way) -> float:
                return way * y[1] + (1e-30 if t == 0.0 else 0.0)

            right, event = slide, stop
            stop.direction = -1.0  # type: ignore[attr-defined]
        else:

            def held(t: float, y: Array) -> list[float]:
                return [0.0, 0.0]

            def loose(t: float, y: Array) -> float:
                return abs(push(t, y)) - coulomb

            right, event = held, loose
            loose.direction = 1.0  # type: ignore[attr-defined]
        event.terminal = True  # type: ignore[attr-defined]
        end = float(times[-1])
        run = solve_ivp(right, (t, end), y, "DOP853", rtol=1e-11, atol=1e-14, events=event, max_step=2e-4, dense_output=True)
        inside = (times >= t) & (times <= run.t[-1])
        out[inside] = run.sol(times[inside]).T
        t, y = float(run.t[-1]), run.y[:, -1]
        if run.status == 0:
            return out
        y = np.array([y[0], 0.0])
        force = push(t, y)
        way = math.copysign(1.0, force) if not way or abs(force) > coulomb else 0.0
    raise AssertionError("too many events")
