"""Check the linear model of a component against its step, by frequency responses."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from contourlab.arrays import Array, Complex
from contourlab.components.contract import LinearModel
from contourlab.engine.step import Step, record
from contourlab.primitives import Clock

NUDGE = 1e-9
"""Perturbation of states and inputs: small enough for a step to be linear around rest."""

TICKS_PER_RADIAN = 1e5
TOLERANCE = 1e-3
"""Relative tolerance: a hundred times the sampling error at the highest frequency."""


def linear_fault(model: LinearModel, step: Step, block: Callable[[float], dict[str, Any]]) -> str:
    """Return where a model and a step differ, as text; empty if they agree.

    Parameters
    ----------
    model : LinearModel
        Continuous time.
    step : Step
        Perturbed around zero, at a period far below the model's time constants. Steps with vector ports are not compared.
    block : callable
        Returns the step's parameter values for a period.
    """
    inputs, outputs = ([port.name for port in ports] for ports in (step.inputs, step.outputs))
    for what, named, known in (("input", model.inputs, inputs), ("output", model.outputs, outputs)):
        for name in named:
            if name not in known:
                return f"it has no {what} {name!r}; the {what}s are: {', '.join(known)}"
    n, m, p = len(model.a), len(model.inputs), len(model.outputs)
    shapes = tuple(np.shape(matrix) for matrix in (model.a, model.b, model.c, model.d))
    if shapes != ((n, n), (n, m), (p, n), (p, m)):
        return f"its matrices have shapes {shapes}, which do not fit {m} inputs and {p} outputs"
    if any(port.size for port in (*step.states, *step.inputs, *step.outputs)):
        return ""
    rates = np.abs(np.linalg.eigvals(model.a))
    rates = rates[rates > 1e-9 * rates.max(initial=0.0)] if rates.any() else np.ones(1)
    period = 1.0 / (TICKS_PER_RADIAN * float(rates.max()))
    sampled = _sampled(step, block(period), period)
    rows, columns = [outputs.index(name) for name in model.outputs], [inputs.index(name) for name in model.inputs]
    for w in np.geomspace(0.1 * rates.min(), rates.max(), 7):
        expected = _response(model.a, model.b, model.c, model.d, 1j * w)
        actual = _response(*sampled, np.exp(1j * w * period))[np.ix_(rows, columns)]
        for i, j in np.argwhere(~(np.abs(actual - expected) <= TOLERANCE * np.abs(expected))):
            return f"from {model.inputs[j]} to {model.outputs[i]} at {w:.3g} rad/s {expected[i, j]:.4g}, but the step {actual[i, j]:.4g}"
    return ""


def _response(a: Array, b: Array, c: Array, d: Array, point: complex) -> Complex:
    return np.asarray(c @ np.linalg.solve(point * np.eye(len(a)) - a, b.astype(complex)) + d)


def _sampled(step: Step, values: dict[str, Any], period: float) -> tuple[Array, Array, Array, Array]:
    """Return the matrices of one tick, by finite differences at rest."""
    par = step.par_type(**values)
    state_type, input_type = (record(tuple(port.name for port in ports)) for ports in (step.states, step.inputs))
    n, size = len(step.states), len(step.states) + len(step.inputs)

    def tick(at: Array) -> Array:
        x_next, out = step.function(par, state_type(*at[:n].tolist()), input_type(*at[n:].tolist()), Clock(0.0, 0.0, period))
        return np.array([*x_next, *out], dtype=float)

    rest = tick(np.zeros(size))
    matrix = np.column_stack([(tick(NUDGE * row) - rest) / NUDGE for row in np.eye(size)])
    return matrix[:n, :n], matrix[:n, n:], matrix[n:, :n], matrix[n:, n:]
