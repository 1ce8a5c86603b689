"""Junctions of the curves of a path: exact stops, jumps of curvature, and small jumps of direction."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from contourlab.feed.route import Route
from contourlab.geometry import Path
from contourlab.geometry.path import CORNER_ANGLE

Array = NDArray[np.float64]

NUDGE = 1e-7  # of a curve's length: the ends are evaluated from inside the curve
MOST_KINK = 0.1
"""Larger jumps of direction [rad] are corners, and stops."""
KINK_TIME = 1e-5
"""At a smaller one, the velocity of an axis jumps by at most what its acceleration limit gives in this time [s]."""
JUMP = 1e-6  # [1/m], and as a part of the curvature: jumps below this are rounding


class Junctions(NamedTuple):
    """Where curves meet; arrays (n_curve,), entry i for the end of curve i (the last: the end of the path)."""

    stop: NDArray[np.bool_]  # exact stop
    jump: Array  # (n_curve, n_axis) [1/m] step of d2r/ds2
    kink: Array  # (n_curve, n_axis) step of dr/ds where the motion does not stop
    room: Array  # [m] the shorter of the two curves that meet


def _sides(path: Path, order: int) -> tuple[Array, Array]:
    """Return a derivative by arc length (n_curve, n_axis) at the end of each curve, and at the start of the next."""
    breaks = np.asarray(path.breaks)
    inside = np.diff(breaks) * NUDGE
    after, before = path.derivatives(breaks[:-1] + inside, order + 1), path.derivatives(breaks[1:] - inside, order + 1)
    # One Taylor term takes the values from just inside a curve to its ends.
    first = after[order] - inside[:, None] * after[order + 1]
    return before[order] + inside[:, None] * before[order + 1], np.roll(first, -1, axis=0)


def curvature_jump(path: Path) -> Array:
    """Return the step of d2r/ds2 at the end of each curve.

    Parameters
    ----------
    path : Path

    Returns
    -------
    ndarray (n_curve, n_axis) [1/m]
        From the end of a curve to the start of the next; the last row leads back to the first curve, and is zero on an open path.
    """
    last, following = _sides(path, 2)
    jump = following - last
    scale = np.maximum(1.0, np.maximum(np.linalg.norm(following, axis=1), np.linalg.norm(last, axis=1)))
    jump[np.abs(jump) < JUMP * scale[:, None]] = 0.0
    return _of_closed(path, jump)


def direction_jump(path: Path) -> Array:
    """Return the step of dr/ds (n_curve, n_axis) at the end of each curve, as `curvature_jump` does; zero where curves are tangent.

    Its length is the angle [rad] where that is small.
    """
    last, following = _sides(path, 1)
    jump = following - last
    jump[np.linalg.norm(jump, axis=1) <= CORNER_ANGLE] = 0.0
    return _of_closed(path, jump)


def _of_closed(path: Path, jump: Array) -> Array:
    if not path.closed:
        jump[-1] = 0.0
    return np.asarray(jump)


def junctions(route: Route) -> Junctions:
    """Find exact stops, and jumps of curvature and direction that are driven through.

    The motion stops where the direction jumps by more than `MOST_KINK`, at a dwell, where rapid and feed moves meet, where the route asks
    for it, and at the end of an open path.

    Parameters
    ----------
    route : Route

    Returns
    -------
    Junctions

    Notes
    -----
    Rounded coordinates leave small jumps of direction. As controls do in exact path mode, the motion passes them where the velocity of no
    axis jumps by more than its acceleration limit makes up for in `KINK_TIME`, or on the way to the next junction if that is shorter.
    """
    turn = direction_jump(route.path)
    angle = np.linalg.norm(turn, axis=1)
    stop = (route.dwell > 0.0) | route.exact_stop | (route.rapid != np.roll(route.rapid, -1)) | (angle > MOST_KINK)
    stop[-1] |= not route.path.closed
    length = np.diff(np.asarray(route.path.breaks))
    return Junctions(stop, curvature_jump(route.path), np.where(stop[:, None], 0.0, turn), np.minimum(length, np.roll(length, -1)))
