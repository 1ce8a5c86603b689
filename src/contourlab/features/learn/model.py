"""What a learning law may know of the machine: the path's direction, and the response of each axis to what is learned."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.linear.coupled_loop import axis_link, impulse_responses
from contourlab.components.learning.law import LearningProblem
from contourlab.errors import ComponentError
from contourlab.feed import Reference
from contourlab.loop import Controller, Machine

Array = NDArray[np.float64]


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
    # What is learned enters behind the feedforward, which so has no part in its effect.
    axes = [axis_link(machine, controller, name) for name in machine.axis_names]
    for name, axis in zip(machine.axis_names, axes, strict=True):
        if not axis.loop.stable:
            raise ComponentError(f"axis {name}: its loop is not stable, so it has no response to learn with")
    return impulse_responses(axes, n_sample, target)
