"""Junctions of curves: exact stops, curvature jumps, small direction jumps, and the speed at which they may be passed."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from contourlab.arrays import Array, Flags
from contourlab.errors import FeedError
from contourlab.feed.limits import AxisLimits
from contourlab.feed.route import Route
from contourlab.geometry import Path
from contourlab.geometry.path import CORNER_ANGLE

NUDGE = 1e-7  # of a curve's length: evaluate the ends this far inside
MOST_KINK = 0.1
"""Largest direction jump [rad] that is passed without a stop."""
KINK_TIME = 1e-5
"""At a kink an axis velocity may jump by its acceleration limit times this time [s]."""
JUMP = 1e-6  # [1/m], and relative to the curvature: smaller jumps are rounding


class Junctions(NamedTuple):
    """Where curves meet; entry i is the end of curve i, the last one the end of the path.

    stop : ndarray (n_curve,) of bool
    jump : ndarray (n_curve, n_axis) [1/m]
        Step of d2r/ds2.
    kink : ndarray (n_curve, n_axis)
        Step of dr/ds; zero at stops.
    room : ndarray (n_curve,) [m]
        Length of the shorter of the two curves.
    """

    stop: Flags
    jump: Array
    kink: Array
    room: Array


def _steps(path: Path, order: int) -> tuple[Array, Array, Array]:
    """Return the step of a derivative (n_curve, n_axis) at the end of each curve, and its values before and after."""
    breaks = np.asarray(path.breaks)
    inside = np.diff(breaks) * NUDGE
    start, end = path.derivatives(breaks[:-1] + inside, order + 1), path.derivatives(breaks[1:] - inside, order + 1)
    # Extrapolate from just inside each curve to its ends.
    after = np.roll(start[order] - inside[:, None] * start[order + 1], -1, axis=0)
    before = end[order] + inside[:, None] * end[order + 1]
    step = after - before
    if not path.closed:
        step[-1] = 0.0
    return step, before, after


def curvature_jump(path: Path) -> Array:
    """Return the step of d2r/ds2 (n_curve, n_axis) [1/m] at the end of each curve; at the end of an open path 0."""
    jump, before, after = _steps(path, 2)
    scale = np.maximum(1.0, np.maximum(np.linalg.norm(after, axis=1), np.linalg.norm(before, axis=1)))
    jump[np.abs(jump) < JUMP * scale[:, None]] = 0.0
    return jump


def direction_jump(path: Path) -> Array:
    """Return the step of dr/ds (n_curve, n_axis) at the end of each curve; its size is the angle [rad] if that is small."""
    jump, _, _ = _steps(path, 1)
    jump[np.linalg.norm(jump, axis=1) <= CORNER_ANGLE] = 0.0
    return jump


def junctions(route: Route) -> Junctions:
    """Find exact stops, and the jumps of curvature and direction that are passed without a stop.

    Notes
    -----
    The motion stops at direction jumps above `MOST_KINK`, at dwells and requested stops, between rapid and feed moves, and at the end of an
    open path. Rounded coordinates cause smaller direction jumps. Like a control in exact path mode, the motion passes them at a speed where
    no axis velocity jumps by more than its acceleration limit times `KINK_TIME`, or times the time to the nearer junction if this is less.
    """
    turn = direction_jump(route.path)
    angle = np.linalg.norm(turn, axis=1)
    stop = (route.dwell > 0.0) | route.exact_stop | (route.rapid != np.roll(route.rapid, -1)) | (angle > MOST_KINK)
    stop[-1] |= not route.path.closed
    length = np.diff(np.asarray(route.path.breaks))
    return Junctions(stop, curvature_jump(route.path), np.where(stop[:, None], 0.0, turn), np.minimum(length, np.roll(length, -1)))


def junction_speed(at: Junctions, limits: AxisLimits, curvature_step: float) -> Array:
    """Return the speed ceiling (n_curve,) [m/s] of each junction from its steps of acceleration, |jump| v^2, and velocity, |kink| v."""
    if not curvature_step >= 0.0:
        raise FeedError(f"curvature_step = {curvature_step}: give a fraction of the acceleration limit, >= 0")
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        square = np.where(at.jump == 0.0, np.inf, curvature_step * limits.acceleration / np.abs(at.jump))
        step = min(curvature_step, 1.0) * limits.acceleration * KINK_TIME
        speed = np.where(at.kink == 0.0, np.inf, step / np.abs(at.kink)).min(axis=1)
        # Kinks in quick succession act like a curve: turning from one to the next takes acceleration.
        turning = np.where(at.kink == 0.0, np.inf, step / KINK_TIME / np.abs(at.kink)).min(axis=1) * at.room
    return np.asarray(np.minimum(np.sqrt(np.minimum(square.min(axis=1), turning)), speed))
