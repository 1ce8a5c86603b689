"""Where the curves of a path meet: exact stops, and jumps of curvature."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from contourlab.feed.route import Route
from contourlab.geometry import Path

__all__ = ["NUDGE", "Joints", "curvature_jump", "joints"]

Array = NDArray[np.float64]

NUDGE = 1e-7  # of a curve's length: the ends are looked at from inside the curve
JUMP = 1e-6  # [1/m], and as a part of the curvature: jumps below this are rounding


class Joints(NamedTuple):
    """Where curves meet; arrays (n_curve,), entry i for the end of curve i (the last: the end of the path)."""

    stop: NDArray[np.bool_]  # exact stop
    jump: Array  # (n_curve, n_axis) [1/m] step of d2r/ds2


def curvature_jump(path: Path) -> Array:
    """Return the step of d2r/ds2 at the end of each curve.

    Parameters
    ----------
    path : Path

    Returns
    -------
    ndarray (n_curve, n_axis) [1/m]
        From the end of a curve to the start of the next; the last row leads back to the first curve, and is zero on
        an open path.
    """
    breaks = np.asarray(path.breaks)
    inside = np.diff(breaks) * NUDGE
    after, before = path.derivatives(breaks[:-1] + inside, 3), path.derivatives(breaks[1:] - inside, 3)
    # One Taylor term takes the values from just inside a curve to its ends.
    first = after[2] - inside[:, None] * after[3]
    last = before[2] + inside[:, None] * before[3]
    following = np.roll(first, -1, axis=0)
    jump = following - last
    scale = np.maximum(1.0, np.maximum(np.linalg.norm(following, axis=1), np.linalg.norm(last, axis=1)))
    jump[np.abs(jump) < JUMP * scale[:, None]] = 0.0
    if not path.closed:
        jump[-1] = 0.0
    return np.asarray(jump)


def joints(route: Route) -> Joints:
    """Find exact stops and jumps of curvature.

    The motion stops where the tangent jumps, at a dwell, where rapid and feed moves meet, where the route asks for it, and at the end of
    an open path.

    Parameters
    ----------
    route : Route

    Returns
    -------
    Joints
    """
    breaks = np.asarray(route.path.breaks)
    stop = (route.dwell > 0.0) | route.exact_stop | (route.rapid != np.roll(route.rapid, -1))
    corners = np.asarray(route.path.corners, dtype=np.float64)
    # A corner lies at a break, to rounding; one at 0 is the closing point, the end of the last curve.
    nearest = np.searchsorted(0.5 * (breaks[1:] + breaks[:-1]), corners)
    stop[nearest - 1] = True
    stop[-1] |= not route.path.closed
    return Joints(stop, curvature_jump(route.path))
