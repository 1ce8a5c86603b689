"""The linear maps of many variants of one opened loop: the ticks that show them are run in lanes, a variant in each.

`contourlab.analysis.linear.tick_map` does the same for one loop in plain Python; here 32 share the work.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.linear.sampled_loop import bare_axis, opened_schedule
from contourlab.engine.runner import make_group
from contourlab.engine.schedule import Schedule
from contourlab.engine.step import rows
from contourlab.errors import ComponentError
from contourlab.loop.batch import LANES
from contourlab.loop.machine import Axis, AxisController, Controller, Machine, parameter_names
from contourlab.loop.simulate import jit_enabled

Array = NDArray[np.float64]


def opened_lanes(
    axis: Axis, controller: AxisController, servo_period: float, columns: Mapping[str, Array], carried_mass: float = 0.0
) -> tuple[Machine, Controller, Schedule, Array, Array]:
    """Return the bare axis, its controller, its opened schedule, and x(k + 1) = A x(k) + B u(k) of each variant.

    Parameters
    ----------
    axis, controller, servo_period, carried_mass
        As of `contourlab.analysis.linear.sampled_loop.sampled_loop`.
    columns : mapping of str to ndarray (n_variant,)
        Values [SI] by dotted names; a single variant where there are none. Those that have no part in the loop of this axis are passed
        over.

    Returns
    -------
    Machine, Controller, Schedule
    ndarray (n_variant, n, n)
    ndarray (n_variant, n, n_external)

    Raises
    ------
    ComponentError
        If a step is not linear, or a delay is longer than its analysis takes.
    """
    n = len(next(iter(columns.values()), (0.0,)))
    machine, made = bare_axis(axis, controller, servo_period, carried_mass)
    known = parameter_names(machine, made)
    # The estimator of a coupling sees all axes; the loop of one axis has none.
    mine = {name: np.asarray(values, dtype=float) for name, values in columns.items() if name in known}
    schedule = opened_schedule(machine, made, mine)
    parts = [_probed(schedule, first) for first in range(0, n if mine else 1, LANES)]
    a, b = (np.concatenate([part[i] for part in parts]) for i in (0, 1))
    if not mine:
        return machine, made, schedule, np.repeat(a[:1], n, axis=0), np.repeat(b[:1], n, axis=0)
    return machine, made, schedule, a[:n], b[:n]


def _probed(schedule: Schedule, first: int) -> tuple[Array, Array]:
    """Return A (lane, n, n) and B (lane, n, n_external) of a group of variants, by one tick from each unit."""
    group = make_group(schedule, LANES, slice(first, first + LANES), jit_enabled())
    parts = [*group.state, *group.rings, group.signals]
    n_input, size = rows(schedule.externals), sum(len(part) for part in parts)

    def after(state: Array, inputs: Array) -> Array:
        start = 0
        for part in parts:
            part[:] = state[start : start + len(part), None]
            start += len(part)
        group.tick = 0
        group.run(inputs[None, :], [])
        for ring in group.rings:
            ring[:] = np.roll(ring, -1, axis=0)
        return np.concatenate(parts)

    at_rest = after(np.zeros(size), np.zeros(n_input))

    def probe(state: Array, inputs: Array) -> Array:
        return after(state, inputs) - at_rest

    none, nothing = np.zeros(n_input), np.zeros(size)
    # What is fed is written afresh at every tick: those rows leave nothing behind.
    fed = range(size - len(group.signals), size - len(group.signals) + n_input)
    empty = np.zeros_like(at_rest)
    units = np.eye(size)
    a = np.stack([empty if i in fed else probe(units[i], none) for i in range(size)], axis=1)
    entered = np.eye(n_input)
    b = np.stack([probe(nothing, entered[i]) for i in range(n_input)], axis=1)
    _check_linear(probe, a, b)
    return np.moveaxis(a, 2, 0), np.moveaxis(b, 2, 0)


def _check_linear(probe: Callable[[Array, Array], Array], a: Array, b: Array) -> None:
    rng = np.random.default_rng(1)
    x, u = rng.normal(size=(a.shape[1],)), rng.normal(size=(b.shape[1],))
    told = np.einsum("ijl,j->il", a, x) + np.einsum("ijl,j->il", b, u)
    scale = np.einsum("ijl,j->il", np.abs(a), np.abs(x)) + np.einsum("ijl,j->il", np.abs(b), np.abs(u))
    if not (np.abs(probe(x, u) - told) <= 1e-9 * scale).all():
        raise ComponentError("a part of the loop is not linear, so it has no frequency response")
