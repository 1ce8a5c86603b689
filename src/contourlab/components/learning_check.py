"""Check the contract of a learning law by its table updates; it has no step."""

from __future__ import annotations

from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import Parameter
from contourlab.components.learning.law import LearningLaw, LearningProblem, TrialRecord

PERIOD = 1e-3
SAMPLES = 400
AXES = (1, 2, 3)


def _problem(n_axis: int) -> LearningProblem:
    """Return a test problem: a curved path, and axes with different settling times of some tens of milliseconds."""
    angle = np.linspace(0.0, 4.0, SAMPLES)
    columns = np.column_stack([np.cos(angle + 1.3 * j) for j in range(n_axis)])
    tangent = columns / np.linalg.norm(columns, axis=1, keepdims=True)
    decay = np.array([0.9 + 0.02 * j for j in range(n_axis)])
    impulse = np.concatenate([np.zeros((1, n_axis)), (1.0 - decay) * decay ** np.arange(300)[:, None]])
    # Slow near zero: a friction function is neither zero nor a sign everywhere.
    velocity = _wave(n_axis, 2.2, 5e-3)
    return LearningProblem(PERIOD, tangent, lambda: impulse, lambda: (velocity, np.asarray(np.gradient(velocity, PERIOD, axis=0))))


def _wave(n_axis: int, phase: float, scale: float) -> Array:
    t = np.arange(SAMPLES)[:, None] * PERIOD
    j = np.arange(n_axis)[None, :]
    return np.asarray(scale * (np.sin((11.0 + 3.0 * j) * t + phase + j) + 0.3 * np.sin((90.0 + 17.0 * j) * t + 2.0 * phase)))


def _trial(n_axis: int, problem: LearningProblem, scale: float = 1.0) -> TrialRecord:
    error = _wave(n_axis, 0.4, 1e-3 * scale)
    excess = np.where(np.abs(_wave(n_axis, 2.0, 1.0)) > 1.1, _wave(n_axis, 2.0, 0.1 * scale), 0.0)
    return TrialRecord(error, _wave(n_axis, 1.1, 0.2 * scale), excess, problem.across(error) * 0.9)


def _next(law: LearningLaw, n_axis: int) -> Array:
    problem = _problem(n_axis)
    return law.update(_wave(n_axis, 0.7, 0.05), _trial(n_axis, problem), problem)


def learning_fault(law: Any, others: Any) -> str:
    """Return the first broken clause of the contract as text; empty if there is none.

    Checks with one, two and three axes: shape, finite numbers, determinism, unchanged arguments, a zero table after a zero table and a
    trial without errors, and no wind-up where the drive saturated. Every parameter must have an effect with at least one target.

    Parameters
    ----------
    law : LearningLaw
        With the parameters of its example.
    others : callable
        Returns other values of a parameter, given its declaration and its value.
    """
    for n_axis in AXES:
        fault = _fault(law, n_axis)
        if fault:
            return f"{fault}, with {n_axis} {'axis' if n_axis == 1 else 'axes'}"
    for name, parameter in law.parameters.items():
        if name not in law.without_effect and not _has_effect(law, name, parameter, others):
            return f"parameter {name} has no effect on the table in the example: change the example, or name it in `without_effect`"
    return ""


def _fault(law: LearningLaw, n_axis: int) -> str:
    problem = _problem(n_axis)
    table, trial, none = _wave(n_axis, 0.7, 0.05), _trial(n_axis, problem), np.zeros((SAMPLES, n_axis))
    kept = [array.copy() for array in (table, trial.tracking_error, trial.feedback_command, trial.excess)]
    found = law.update(table, trial, problem)
    rest = law.update(none, _trial(n_axis, problem, 0.0), problem)
    given = (table, trial.tracking_error, trial.feedback_command, trial.excess)
    if not isinstance(found, np.ndarray) or found.shape != table.shape or found.dtype != np.float64:
        return f"its table is not an array of numbers of shape {table.shape}"
    if not np.isfinite(found).all():
        return "its table is not finite"
    if any(not np.array_equal(before, now) for before, now in zip(kept, given, strict=True)) or found is table:
        return "it writes into its arguments: return a new array"
    if not np.array_equal(found, _next(law, n_axis)):
        return "two updates from the same trial differ"
    if rest.any():
        return "it learns something from a trial without errors"
    if (trial.excess * (found - table) > 0.0).any():
        return "it drives a saturated drive further into its limit"
    return ""


def _has_effect(law: LearningLaw, name: str, parameter: Parameter, others: Any) -> bool:
    for target in law.parameters["target"].choices:
        base = law.replace(target=target)
        before = _next(base, 2)
        for value in others(parameter, getattr(base, name)):
            try:
                changed = base.replace(**{name: value})
            except Exception:  # out of its range
                continue
            if not np.array_equal(_next(changed, 2), before):
                return True
    return False
