"""What a learning law may know of the machine: the path's direction, and the response of each axis to what is learned."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.sampled_loop import SampledLoop, sampled_loop
from contourlab.components.learning.law import LearningProblem
from contourlab.errors import ComponentError
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine

__all__ = ["input_response", "learning_problem"]

Array = NDArray[np.float64]

NEGLIGIBLE = 1e-13
"""Part of the largest value at which an impulse response has died away."""
LOOK = 512
"""Samples over which it has to be that small."""


def learning_problem(machine: Machine, controller: Controller, reference: Reference, target: str, arc_length: Array) -> LearningProblem:
    """Return what is known before the first trial.

    Parameters
    ----------
    machine, controller, reference
        What runs.
    target : {"command", "reference"}
        What is learned.
    arc_length : ndarray (n_sample,) [m]
        Place of the reference.
    """
    tangent = reference.path.derivatives(arc_length, order=1)[1]
    tangent = tangent / np.linalg.norm(tangent, axis=1, keepdims=True)
    return LearningProblem(machine.servo_period, tangent, lambda: input_response(machine, controller, target, len(arc_length)))


def input_response(machine: Machine, controller: Controller, target: str, n_sample: int) -> Array:
    """Return the impulse response of each axis' measured position to the learned input.

    Parameters
    ----------
    machine, controller
        What runs; taken axis by axis, without the coupling by the contour and without what is not linear.
    target : {"command", "reference"}
    n_sample : int
        Longest response that is of use.

    Returns
    -------
    ndarray (m, n_axis) [m per command unit, or m/m]
        m <= n_sample; what comes later is below 1e-13 of the largest value.

    Raises
    ------
    ComponentError
        If an axis has a component that is not linear, or its loop is not stable.
    """
    found = []
    for axis in machine.axes:
        # What is learned enters behind the feedforward, which so has no part in its effect.
        mine = replace(controller.axes[axis.name], feedforward=None)
        loop = sampled_loop(axis, mine, machine.servo_period, machine.carried_mass(axis.name))
        if not loop.stable:
            raise ComponentError(f"axis {axis.name}: its loop is not stable, so it has no response to learn with")
        found.append(_impulse(loop, target, n_sample))
    longest = max(len(response) for response in found)
    return np.column_stack([np.concatenate([response, np.zeros(longest - len(response))]) for response in found])


def _impulse(loop: SampledLoop, target: str, n_sample: int) -> Array:
    a, closed = loop.closed
    if target == "reference":
        enters = closed[:, 0]
    else:
        # The learned command is added to what the controller gives, at the tick at which it gives it.
        cut = loop.b[:, :2]
        enters = cut @ np.linalg.solve(np.eye(2) - loop.c @ cut, np.array([1.0, 0.0]))
    found = np.zeros(n_sample)
    state, largest = enters, 0.0
    row = loop.state[0]
    for k in range(1, n_sample):
        found[k] = row @ state
        state = a @ state
        if k % LOOK == 0:
            largest = max(largest, float(np.abs(found[k - LOOK : k + 1]).max()))
            if np.abs(found[k - LOOK : k + 1]).max() <= NEGLIGIBLE * largest:
                return found[: k + 1]
    return found
