"""Offset between the zeros of a part program and a log: programs count from the part, encoders from the machine."""

from __future__ import annotations

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ResultError
from contourlab.features.measure.measured_path import progress_along
from contourlab.geometry import Path

SAMPLES, ITERATIONS = 5000, 50
"""Samples used, evenly spaced along the tool's travel, and largest number of steps."""
SETTLED = 1e-9
"""Length [m] of the last step."""
STRAIGHT = 1e-6
"""Share of the normals in a direction below which the path does not determine the shift in it."""


def fitted_shift(path: Path, positions: Array) -> Array:
    """Fit the shift (n_axis,) [m] that brings a path closest to measured positions (least squares).

    Parameters
    ----------
    positions : ndarray (n, n_axis) [m]
        From the start of the path to its end, or to where the tool stopped.

    Raises
    ------
    ResultError
        If the path does not determine the shift, such as a straight line in its own direction, or the positions do not follow the path.

    Notes
    -----
    The fit starts twice: with the bounding boxes centred on each other, and with the first position on the start of the path. The closer
    result counts. Each step finds the foot points, then solves for the shift that removes the normal distances. Samples are spaced evenly
    along the travel, so a resting tool has no weight. A constant offset of the tool counts as shift and disappears from the error.
    """
    travel = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(positions, axis=0), axis=1)))
    tool = positions[np.unique(np.searchsorted(travel, np.linspace(0.0, travel[-1], SAMPLES)))]
    box = path.position(np.linspace(0.0, path.length, SAMPLES))
    centres = (tool.max(axis=0) + tool.min(axis=0) - box.max(axis=0) - box.min(axis=0)) / 2.0
    fits: list[tuple[float, Array]] = []
    errors = []
    for start in (centres, tool[0] - box[0]):
        try:
            fits.append(_fit_from(path, tool, np.asarray(start)))
        except ResultError as error:
            errors.append(error)
    if not fits:
        raise errors[-1]
    return min(fits, key=lambda fit: fit[0])[1]


def _fit_from(path: Path, tool: Array, shift: Array) -> tuple[float, Array]:
    """Iterate from one start; return the mean squared normal distance [m^2] and the shift [m]."""
    for _ in range(ITERATIONS):
        here = tool - shift
        along, _ = progress_along(path, here)
        window = 4.0 * float(np.linalg.norm(path.position(along) - here, axis=1).max()) + 1e-6
        foot = path.foot_point(here, along, min(window, 0.25 * path.length))
        tangent = path.tangent(foot.arc_length)
        normal = np.eye(path.n_axis) - np.einsum("ki,kj->ij", tangent, tangent) / len(tangent)
        if np.linalg.eigvalsh(normal)[0] < STRAIGHT:
            raise ResultError("a straight path does not determine the shift along itself: give the shift as lengths")
        # At corners and ends the distance to the foot point has a tangential part.
        off = here - foot.position
        off -= (off * tangent).sum(axis=1, keepdims=True) * tangent
        step = np.linalg.solve(normal, off.mean(axis=0))
        shift = shift + step
        if np.abs(step).max() < SETTLED:
            return float((off**2).sum(axis=1).mean()), shift
    raise ResultError(f"the shift between path and log has not converged after {ITERATIONS} steps: give it as lengths")
