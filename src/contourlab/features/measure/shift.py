"""Where the zero of a path lies in the coordinates of a log: part programs count from the part, encoders from the machine."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from contourlab.app.progress import progress_along
from contourlab.errors import ResultError
from contourlab.geometry import Path

Array = NDArray[np.float64]
MOST, ITERATIONS = 5000, 50
"""Samples that are looked at, evenly over the way of the tool, and steps at most."""
SETTLED = 1e-9
"""Metres by which the last step still moves it."""
STRAIGHT = 1e-6
"""Part of all normals that lies along an axis below which the path does not tell the shift along it."""


def fitted_shift(path: Path, positions: Array) -> Array:
    """Return the shift (n_axis,) [m] of a path with which measured positions are closest to it, in the sense of least squares.

    Parameters
    ----------
    path : Path
    positions : ndarray (n, n_axis) [m]
        From the start of the path to its end, or all of them from its start as far as the tool came.

    Raises
    ------
    ResultError
        If the path does not tell the shift, as a straight one does not along itself, or the positions are not those of the path.

    Notes
    -----
    It begins with the middles of both boxes laid on each other, and with the first position laid on the start of the path; of what both
    lead to the closer one is taken. Turn by turn each position is given its foot point on the path, and the shift that takes the normal
    distances away is solved for. Positions count by the way between them, so that a tool at rest weighs nothing. A constant offset of the
    tool is taken for a shift, so it is not in the errors that are worked out behind it: at most what the normals average to.
    """
    way = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(positions, axis=0), axis=1)))
    tool = positions[np.unique(np.searchsorted(way, np.linspace(0.0, way[-1], MOST)))]
    box = path.position(np.linspace(0.0, path.length, MOST))
    middles = (tool.max(axis=0) + tool.min(axis=0) - box.max(axis=0) - box.min(axis=0)) / 2.0
    found: list[tuple[float, Array]] = []
    faults = []
    for start in (middles, tool[0] - box[0]):
        try:
            found.append(_settled(path, tool, np.asarray(start)))
        except ResultError as error:
            faults.append(error)
    if not found:
        raise faults[-1]
    return min(found, key=lambda one: one[0])[1]


def _settled(path: Path, tool: Array, shift: Array) -> tuple[float, Array]:
    """Return the mean squared normal distance [m^2] and the shift [m] that turn by turn is led to from one to begin with."""
    for _ in range(ITERATIONS):
        here = tool - shift
        along, _ = progress_along(path, here)
        window = 4.0 * float(np.linalg.norm(path.position(along) - here, axis=1).max()) + 1e-6
        foot = path.foot_point(here, along, min(window, 0.25 * path.length))
        tangent = path.tangent(foot.arc_length)
        normal = np.eye(path.n_axis) - np.einsum("ki,kj->ij", tangent, tangent) / len(tangent)
        if np.linalg.eigvalsh(normal)[0] < STRAIGHT:
            raise ResultError("a straight path does not tell where along itself its zero lies: give the shift in numbers")
        # At corners and ends a foot point is not square to the path.
        off = here - foot.position
        off -= (off * tangent).sum(axis=1, keepdims=True) * tangent
        step = np.linalg.solve(normal, off.mean(axis=0))
        shift = shift + step
        if np.abs(step).max() < SETTLED:
            return float((off**2).sum(axis=1).mean()), shift
    raise ResultError(f"the shift between path and log is not settled after {ITERATIONS} steps: give it in numbers")
