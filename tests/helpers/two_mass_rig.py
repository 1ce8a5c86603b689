"""A drive of several masses alone on the engine, with all of its states recorded, and its energy."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.components.contract import Component
from contourlab.components.friction.laws import NoFriction
from contourlab.components.mechanics.core import MOTOR_FRICTION, friction_prefix, link
from contourlab.engine.runner import Group, make_group
from contourlab.engine.step import Node, Port, Schedule, Step

Array = NDArray[np.float64]
NONE = NoFriction()
DRIVE = {"motor_inertia": 5.2e-3, "load_inertia": 4.4e-3, "lead": 0.016, "stiffness": 950.0, "backlash_gap": 25e-6}
"""The x drive of Shahin, ElMaraghy & ElBeheiry, Table 1; its shaft rings at 100 Hz."""


@cache
def opened(step: Step) -> Step:
    """Return a step that also outputs its states, under their names with the suffix _x."""
    inner = step.function

    def function(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        following, out = inner(par, x, inp, clock)
        return following, out + following

    states = tuple(Port(f"{port.name}_x", port.size) for port in step.states)
    return replace(step, name=f"{step.name} opened", function=function, outputs=(*step.outputs, *states))


@dataclass(frozen=True)
class Drive:
    """A plant with its frictions, and how it is integrated."""

    plant: Any
    friction: Component = NONE
    motor_friction: Component = NONE
    period: float = 1e-3
    substeps: int = 1
    jit: bool = True

    def group(self, width: int = 1, initial: dict[str, Any] | None = None, **varied: Array) -> Group:
        step = opened(link(self.plant, self.friction, self.motor_friction))
        h = self.period / self.substeps
        values = self.plant.block(h, varied)
        values |= {f"{friction_prefix(self.plant)}{name}": value for name, value in self.friction.block(h).items()}
        values |= {f"{MOTOR_FRICTION}{name}": value for name, value in self.motor_friction.block(h).items()}
        rest = self.plant.at_rest(0.0)[0] | (initial or {})
        wires = {port.name: f"in.{port.name}" for port in step.inputs}
        node = Node("plant", step, wires, values, self.plant.table_values(), rest, repeat=self.substeps)
        return make_group(Schedule((node,), step.inputs, self.period, 1), width, slice(0, width), self.jit)

    def run(self, command: ArrayLike, load: ArrayLike = 0.0, group: Group | None = None, **initial: Any) -> dict[str, Array]:
        """Return all outputs and states after each tick (n_tick,), with a lane or an entry of a vector behind."""
        group = group or self.group(initial=initial)
        step = group.schedule.nodes[0].step
        fed = np.column_stack(np.broadcast_arrays(np.asarray(command, dtype=float), np.asarray(load, dtype=float)))
        rows = [group.schedule.row(f"plant.{port.name}") + i for port in step.outputs for i in range(port.rows)]
        log = group.run(fed, rows)
        found, first = {}, 0
        for port in step.outputs:
            part = log[:, first : first + port.rows]
            found[port.name] = np.squeeze(part if port.size else part[:, 0])
            first += port.rows
        return found


def half_gap(plant: Any, position: Array) -> Array:
    """Return half of the free travel at the load's position (n,) [m]."""
    places = plant.profile_start + plant.profile_step * np.arange(len(plant.gap_profile))
    return np.asarray(plant.constants().half_gap * np.interp(position, places, plant.gap_profile))


def energy(plant: Any, run: dict[str, Array]) -> Array:
    """Return the energy of both masses and the shaft [J], including the twist left in the gap."""
    d, side = plant.constants(), run["side_x"]
    twist = np.where(side == 0.0, run["twist_x"], run["motor_position"] - run["position"] - side * half_gap(plant, run["position"]))
    kinetic = run["motor_velocity"] ** 2 / d.motor_mobility + run["velocity"] ** 2 / d.load_mobility
    return np.asarray(0.5 * (kinetic + d.stiffness_value * twist**2))


def gains(plant: Any, run: dict[str, Array], command: Array) -> Array:
    """Return the energy rise in each tick but the first, minus the work of the held command [J]."""
    work = plant.constants().force_value * command[1:] * np.diff(run["motor_position"])
    return np.asarray(np.diff(energy(plant, run)) - work)


def random_command(rng: np.random.Generator, n: int, level: float) -> Array:
    """Return n samples, each held for 1 to 32 ticks, of sizes over three decades, some of them zero."""
    held = rng.integers(1, 33, n)
    size = level * 10.0 ** rng.uniform(-2.0, 1.0, n) * rng.normal(size=n) * (rng.random(n) > 0.1)
    return np.repeat(size, held)[:n]
