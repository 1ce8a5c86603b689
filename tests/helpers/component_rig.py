"""One component alone on the engine, fed with known signals."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.components.contract import Component
from contourlab.components.friction.laws import NoFriction
from contourlab.components.mechanics.core import link
from contourlab.components.registry import component
from contourlab.engine.runner import make_group
from contourlab.engine.step import Late, Node, Port, Schedule

Array = NDArray[np.float64]
PERIOD = 1e-3


def make(family: str, kind: str, **parameters: Any) -> Any:
    """Return a component by its name."""
    return component(family, kind)(**parameters)


def run_alone(
    part: Component,
    fed: dict[str, Any],
    *,
    period: float = PERIOD,
    friction: Component | None = None,
    initial: dict[str, float] | None = None,
    jit: bool = False,
    substeps: int = 1,
) -> dict[str, Array]:
    """Run a component over its inputs, (n_tick,) or (n_tick, n_axis) each; return its outputs by name, a plant's after each tick.

    A port of one row per axis takes as many axes as its signal has columns; inputs that are not given are zero.
    """
    columns = {name: np.atleast_2d(np.asarray(values, dtype=float).T).T for name, values in fed.items()}
    n_tick, n_axis = next(iter(columns.values())).shape[0], max(c.shape[1] for c in columns.values())
    resting = friction or NoFriction()
    step = link(part, resting) if part.family == "plant" else part.make_step(n_axis)
    values = part.block(period / substeps) | (resting.block(period) if part.family == "plant" else {})
    at, start = part.at_rest(0.0)
    node = Node(
        "part",
        step,
        {port.name: f"in.{port.name}" for port in step.inputs},
        values,
        part.table_values(),
        {**at, **(initial or {})},
        start,
        part.ring_length(period),
        repeat=substeps,
    )
    schedule = Schedule((node,), step.inputs, period, 1)
    external = np.concatenate([columns.get(port.name, np.zeros((n_tick, port.rows))) for port in step.inputs], axis=1)
    rows = [schedule.row(f"part.{port.name}") + i for port in step.outputs for i in range(port.rows)]
    log = make_group(schedule, 1, slice(0, 1), jit).run(external, rows)[:, :, 0]
    found, first = {}, 0
    for port in step.outputs:
        found[port.name] = log[:, first] if not port.size else log[:, first : first + port.size]
        first += port.rows
    return found


def behind_a_drive(part: Component, error: Array, limit: float) -> Array:
    """Return the commands (n_tick,) of a controller with a limited drive, for a given error."""
    drive = make("drive", "saturation", limit=limit)
    wires: dict[str, Any] = {port.name: 0.0 for port in part.inputs}
    wires |= {"reference": "in.error", "accepted": Late("drive.applied")}
    nodes = (
        Node("controller", part.make_step(), wires, part.block(PERIOD)),
        Node("drive", drive.make_step(), {"command": "controller.command"}, drive.block(PERIOD)),
    )
    schedule = Schedule(nodes, (Port("error"),), PERIOD, 2)
    return make_group(schedule, 1, slice(0, 1), False).run(error[:, None], [schedule.row("controller.command")])[:, 0, 0]
