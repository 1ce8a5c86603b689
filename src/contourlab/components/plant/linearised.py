"""The linear model of a plant that has a step of its own, from differences of that step about rest.

Each state and input is moved by `NUDGE` and by half of it, both ways, and the differences are extrapolated: a linear step gives its matrix
to rounding, a smooth one to the fourth power of `NUDGE` over the distance on which it bends. The nudges are powers of two, so that scaling
adds no error. A step that jumps or has a kink at rest is refused.
"""

from __future__ import annotations

from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import LinearModel
from contourlab.components.mechanics.matrix_step import matrix_step
from contourlab.engine.step import Port, pack, record, rows, unpack
from contourlab.errors import ComponentError
from contourlab.primitives import Clock, Table

NUDGE = 2.0**-20
"""Change of a state or an input [its unit]."""

BRIEF = 2.0**-24
"""Period [s] of the steps whose matrix gives the model in continuous time; far below every time constant."""

UNEVEN, BENT, ABSENT = 1e-3, 0.1, 1e-6
"""Largest relative rise of a slope over half the nudge, and turn at rest; below this part of the largest of its row none counts."""


def tick_matrix(plant: Any, par: Any, dt: float) -> Array:
    """Return the derivatives (n_state + n_output, n_state + n_input) of a plant's step at rest.

    Parameters
    ----------
    par : object
        Its constants for the period dt [s].

    Raises
    ------
    ComponentError
        If the step jumps or has a kink there.
    """
    step = plant.make_step()
    seen = step.par_type(*(getattr(par, name) for name in step.parameters), *map(Table, plant.table_values().values()))
    resting, n = plant.at_rest(0.0)[0], rows(step.states)
    at = np.array([*pack(step.states, [resting.get(p.name, (0.0,) * p.size or 0.0) for p in step.states]), *[0.0] * rows(step.inputs)])

    def tick(state: Array) -> Array:
        x, inp = (_record(ports, part.tolist()) for ports, part in ((step.states, state[:n]), (step.inputs, state[n:])))
        after, out = step.function(seen, x, inp, Clock(0.0, 0.0, dt))
        return np.array([*pack(step.states, after), *pack(step.outputs, out)], dtype=float)

    rest, ends = tick(at), (-1.0, -0.5, 0.5, 1.0)
    moved = np.array([[tick(at + NUDGE * end * unit) for end in ends] for unit in np.eye(at.size)]) - rest
    coarse, fine = (moved[:, 3] - moved[:, 0]).T / (2.0 * NUDGE), (moved[:, 2] - moved[:, 1]).T / NUDGE
    floor = ABSENT * np.abs(fine).max(axis=1, keepdims=True)
    bent, half_bent = np.abs(moved[:, 3] + moved[:, 0]).T / NUDGE, np.abs(moved[:, 2] + moved[:, 1]).T / (0.5 * NUDGE)
    # Over half the distance the slope over a jump doubles, and that of a kink turns as much; what is smooth turns half as much.
    jumps = np.abs(fine) - np.abs(coarse) > UNEVEN * np.abs(fine) + floor
    if (jumps | ((half_bent > 0.75 * bent) & (bent > BENT * np.abs(fine) + floor))).any():
        raise ComponentError(f"a {plant.kind} is not smooth at rest, so it has no linear model: write its `linear`")
    whole = np.asarray(fine + (fine - coarse) / 3.0)
    places = [port.name for port in (*step.states, *step.outputs) for _ in range(port.rows)]
    for place, name in enumerate(places[:n]):
        begin = np.eye(at.size)[place]
        if name in places[n:] and (whole[places.index(name, n)] == begin).all() and (whole[place] != begin).any():
            raise ComponentError(f"the output {name} of a {plant.kind} is that at the begin of the step: give the one at its end")
    return whole


def _record(ports: tuple[Port, ...], values: list[float]) -> Any:
    return record(tuple(port.name for port in ports))(*unpack(ports, values)) if ports else ()


def continuous_model(plant: Any) -> LinearModel | None:
    """Return the model in continuous time from which the step, with command and load held, follows.

    None if a state counts in ticks, as one that keeps the last command: it fades over the shortest step.
    """
    par = SimpleNamespace(**plant.block(BRIEF))
    step, whole = plant.make_step(), tick_matrix(plant, par, BRIEF)
    n, m = rows(step.states), rows(step.inputs)
    if np.abs(np.linalg.eigvals(whole[:n, :n]) - 1.0).max(initial=0.0) > 0.1:
        return None
    held = np.eye(n + m)
    held[:n] = whole[:n]
    # The series of log(1 + x): unlike `logm` it keeps the digits of each entry, however small.
    one, model = np.eye(n + m), np.zeros((n + m, n + m))
    for k in range(16, 0, -1):
        model = (held - one) @ (one / k - model)
    model = model[:n] / BRIEF
    # Outputs are those at the end of the step.
    told = [port.name for port in step.outputs if port.name.endswith(("position", "velocity")) or port.name == plant.measured]
    names = [port.name for port in step.outputs for _ in range(port.rows)]
    c = whole[n:, :n] @ np.linalg.inv(whole[:n, :n])
    d = whole[n:, n:] - c @ whole[:n, n:]
    kept = [names.index(name) for name in told]
    return LinearModel(model[:, :n], model[:, n:], c[kept], d[kept], tuple(port.name for port in step.inputs), tuple(told))


def linearised(plant: Any) -> Any:
    """Return a plant with the same parameters and ports, whose step is linear: the matrix of the plant's step about rest."""
    kind: Any = type(plant)
    return _linear_kind(kind, plant.states, plant.inputs, plant.outputs)(**plant.values())


@cache
def _linear_kind(kind: Any, states: tuple[Port, ...], inputs: tuple[Port, ...], outputs: tuple[Port, ...]) -> Any:
    height, width = rows(states) + rows(outputs), rows(states) + rows(inputs)
    names = tuple(f"slope_{i}_{j}" for i in range(height) for j in range(width))

    def derive(self: Any, par: Any, dt: float) -> tuple[Any, ...]:
        plant = kind(**self.values())
        own = kind.derive(self, par, dt)
        lanes = np.broadcast_arrays(*(np.atleast_1d(getattr(par, name)) for name in kind.numeric()), np.zeros(1))
        numbers = [dict(zip(kind.numeric(), row, strict=False)) for row in np.column_stack(lanes).tolist()]
        slopes = np.array([tick_matrix(plant, SimpleNamespace(**plant.block(dt, one)), dt).ravel() for one in numbers])
        return (*own, *(slopes.T if len(slopes) > 1 else slopes[0].tolist()))

    step = staticmethod(matrix_step(states, inputs, outputs, len(kind.numeric()) + len(kind.derived)))
    names = (*kind.derived, *names)
    return type(kind)(f"Linear{kind.__name__}", (kind,), {"derived": names, "derive": derive, "step": step, "linear": lambda self: self})
