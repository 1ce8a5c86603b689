"""The loop as one linear map from tick to tick, taken from the very steps that are simulated.

Every state is moved by one unit in turn and one tick is run in plain Python; for a loop of linear components this gives the exact matrix of
the sampled system, hold and delay included. Its eigenvalues are the poles of what runs, not of a continuous idealisation.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from contourlab.engine.runner import Group, make_group
from contourlab.engine.schedule import Schedule
from contourlab.engine.step import rows

__all__ = ["spectral_radius", "tick_matrix"]

Array = NDArray[np.float64]


def tick_matrix(schedule: Schedule) -> Array:
    """Return the matrix (n, n) that takes all states, rings and signals of a schedule to the next tick, inputs at zero.

    Parameters
    ----------
    schedule : Schedule
        Of linear steps, each run at every tick; constants that a step adds of its own are taken out.
    """
    group = make_group(schedule, 1, slice(0, 1), False)
    parts = [*group.state, *group.rings, group.signals]
    for part in parts:
        part[:] = 0.0
    zero = np.zeros((1, rows(schedule.externals)))
    at_rest = _after(group, parts, zero)
    size = at_rest.size
    matrix = np.empty((size, size))
    for column in range(size):
        _set(parts, np.eye(1, size, column)[0])
        matrix[:, column] = _after(group, parts, zero) - at_rest
    return matrix


def spectral_radius(schedule: Schedule) -> float:
    """Return the largest magnitude of the poles of the sampled loop: below 1 it is stable.

    States that only remember what they were given at the start (where an axis stood, what the watch has noted), and those that sum up
    what nothing reads (an integral without a gain), are no part of the loop.
    """
    matrix = tick_matrix(schedule)
    apart = matrix != np.eye(len(matrix))
    moves = apart.any(axis=1) & apart.any(axis=0)
    return float(np.abs(np.linalg.eigvals(matrix[np.ix_(moves, moves)])).max(initial=0.0))


def _after(group: Group, parts: list[Array], zero: Array) -> Array:
    group.tick = 0
    group.run(zero, [])
    # Rings are written round and round: turned back by one, they stand at the next tick as they stood at this one.
    for ring in group.rings:
        ring[:] = np.roll(ring, -1, axis=0)
    return np.concatenate([part.ravel() for part in parts])


def _set(parts: list[Array], values: Array) -> None:
    start = 0
    for part in parts:
        part[:] = values[start : start + part.size].reshape(part.shape)
        start += part.size
