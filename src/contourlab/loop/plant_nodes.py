"""The plants of a machine in the servo loop: their loads, carried modules and frictions."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.components.mechanics.core import MOTOR_FRICTION, friction_prefix, link
from contourlab.components.plant.plant import Plant
from contourlab.engine.schedule import Late, Node
from contourlab.engine.step import Port, Step
from contourlab.loop.builder import Builder
from contourlab.loop.machine import Axis
from contourlab.native.generated import generated


def add_plants(builder: Builder) -> None:
    """Add the loads on the axes, and their plants with linked frictions."""
    for axis, at, speed in zip(builder.machine.axes, builder.start, builder.speed, strict=True):
        name, prefix = axis.name, f"axes.{axis.name}"
        load: Any = 0.0
        if axis.disturbance is not None:
            wires = {"position": Late(f"{name}.plant.position")}
            builder.add(f"{name}.disturbance", axis.disturbance, f"{prefix}.disturbance", wires)
            load = f"{name}.disturbance.force"
        # Two modules that move along each other exchange the inertia force of the mass that the upper one moves.
        partners = {a.name: a.alignment * _moved_mass(builder, a) for a in builder.machine.axes if a.mounted_on == name and a.alignment}
        if axis.mounted_on and axis.alignment:
            partners[axis.mounted_on] = axis.alignment * _moved_mass(builder, axis)
        if partners:
            load = _reaction(builder, name, load, partners)
        rubbing = axis.friction.block(builder.period, builder.changed(f"{prefix}.friction"))
        values = _carrying(builder, axis) | {f"{friction_prefix(axis.plant)}{row}": value for row, value in rubbing.items()}
        on_motor = axis.motor_friction.block(builder.period, builder.changed(f"{prefix}.motor_friction"))
        values |= {f"{MOTOR_FRICTION}{row}": value for row, value in on_motor.items()}
        initial, start = _resting(axis.plant, float(at), builder.changed(f"{prefix}.plant"))
        initial = {**initial, **_speeds(axis.plant.states, float(speed))}
        start = {**start, **_speeds(axis.plant.outputs, float(speed))}
        pushed: dict[str, Any] = {"command": f"{name}.drive.applied", "load": load}
        step, tables = link(axis.plant, axis.friction, axis.motor_friction), axis.plant.table_values()
        builder.nodes.append(Node(f"{name}.plant", step, pushed, values, tables, initial, start, repeat=axis.substeps))


def _resting(plant: Plant, at: float, changed: Mapping[str, Array]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return states and outputs of a plant at rest, for each variant if they depend on a varied parameter."""
    which = [name for name in changed if name in plant.rest_depends]
    if not which:
        return plant.at_rest(at)
    rows = np.column_stack([changed[name] for name in which]).tolist()
    resting = [plant.replace(**dict(zip(which, row, strict=True))).at_rest(at) for row in rows]
    together = [{name: _side_by_side([rest[part][name] for rest in resting]) for name in resting[0][part]} for part in (0, 1)]
    return together[0], together[1]


def _side_by_side(values: list[Any]) -> Any:
    """Return the values of all variants as an array; for a vector, a tuple of arrays."""
    return tuple(np.array(column) for column in zip(*values, strict=True)) if isinstance(values[0], tuple) else np.array(values)


def _speeds(ports: tuple[Port, ...], speed: float) -> dict[str, Any]:
    """Return the values of the velocity ports, with all masses of the axis at one speed."""
    moving = [port for port in ports if port.name in ("velocity", "motor_velocity", "inner_velocities")]
    return {port.name: (speed,) * port.size if port.size else speed for port in moving}


def _carrying(builder: Builder, axis: Axis) -> dict[str, Any]:
    """Return the parameters of an axis' plant, with the modules mounted on it."""
    changed, carried = builder.changed(f"axes.{axis.name}.plant"), builder.machine.carried_mass(axis.name)
    if carried:
        own = np.asarray(axis.plant.values()["carried_mass"])
        changed["carried_mass"] = changed.get("carried_mass", own) + carried
    return axis.plant.block(builder.period / axis.substeps, changed)


def _moved_mass(builder: Builder, axis: Axis) -> Any:
    """Return the mass [kg] in linear motion of an axis: a number, or an array (n_variant,)."""
    return type(axis.plant).moved_mass(SimpleNamespace(**_carrying(builder, axis)))


def _reaction(builder: Builder, name: str, load: Any, partners: Mapping[str, Any]) -> str:
    """Add the node that sums the loads on an axis: its disturbance, and the inertia of axes that move along it."""
    step = _reaction_step(tuple(partners))
    forces: dict[str, Any] = {f"acceleration_{other}": Late(f"{other}.plant.acceleration") for other in partners}
    builder.nodes.append(Node(f"{name}.load", step, {"load": load, **forces}, {f"mass_{other}": mass for other, mass in partners.items()}))
    return f"{name}.load.force"


@cache
def _reaction_step(partners: tuple[str, ...]) -> Step:
    ports = (Port("load"), *(Port(f"acceleration_{name}") for name in partners))
    terms = "".join(f" - par.mass_{name} * inp.acceleration_{name}" for name in partners)
    scope: dict[str, Any] = {"__name__": __name__}
    step = generated(f"def step(par, x, inp, clock):\n    return (), (inp.load{terms},)\n", scope, "step")
    return Step("load", step, tuple(f"mass_{name}" for name in partners), (), "", (), ports, (Port("force"),))
