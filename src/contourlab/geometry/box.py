"""The bounding box of a path and of each of its curves."""

from __future__ import annotations

import numpy as np

from contourlab.arrays import Array
from contourlab.geometry.arc import Arc
from contourlab.geometry.curve import Curve
from contourlab.geometry.line import Line
from contourlab.geometry.path import Path

_SAMPLES = 513
_HALVINGS = 45


def box(path: Path) -> tuple[Array, Array]:
    """Return the lowest and the highest coordinates of a path (n_axis,), (n_axis,) [m]."""
    low, high = boxes(path)
    return low.min(axis=0), high.max(axis=0)


def boxes(path: Path) -> tuple[Array, Array]:
    """Return the lowest and the highest coordinates of each curve of a path (n_curve, n_axis), (n_curve, n_axis) [m].

    Lines, arcs and helices have a closed form; bisection between samples finds the extremes of other curves.
    """
    low, high = np.minimum(path.starts[0], path.ends[0]), np.maximum(path.starts[0], path.ends[0])
    for i, curve in enumerate(path.curves):
        if isinstance(curve, Line):
            continue
        points = _arc_extremes(curve) if isinstance(curve, Arc) else _turning_points(curve)
        low[i], high[i] = np.minimum(low[i], points.min(axis=0)), np.maximum(high[i], points.max(axis=0))
    return low, high


def _arc_extremes(arc: Arc) -> Array:
    """Return the points (n, n_axis) of an arc or helix where a coordinate may be extreme, ends included."""
    slope = arc.rise / arc.length / (arc.radius * arc.rate)
    # Each coordinate, radius (u cos + v sin) + pitch * angle, is extreme where v cos - u sin = -slope.
    size = np.hypot(arc.u, arc.v)
    with np.errstate(divide="ignore", invalid="ignore"):
        lean = np.arccos(np.clip(-slope / size, -1.0, 1.0))
    base = np.arctan2(-arc.u, arc.v)
    places = [0.0, arc.length]
    for angle in np.concatenate([base + lean, base - lean])[np.tile(size > 0.0, 2)]:
        turn = 2.0 * np.pi * np.sign(arc.rate)
        first = (angle - arc.start_angle) % turn
        # The first and last turns of a helix hold the extremes.
        last = first + turn * np.floor((arc.rate * arc.length - first) / turn)
        places += [value / arc.rate for value in (first, last)]
    inside = np.array([s for s in places if 0.0 <= s <= arc.length])
    return arc.position(inside)


def _turning_points(curve: Curve) -> Array:
    """Return the points (n, n_axis) of a curve where a coordinate is extreme, ends included."""
    samples = np.linspace(0.0, curve.length, _SAMPLES)
    tangent = curve.derivatives(samples, 1)[1]
    points = [curve.position([0.0, curve.length])]
    for axis in range(curve.n_axis):
        t = tangent[:, axis]
        at = np.flatnonzero(np.sign(t[1:]) != np.sign(t[:-1]))
        low, high, rising = samples[at], samples[at + 1], t[at + 1] > t[at]
        for _ in range(_HALVINGS):
            middle = 0.5 * (low + high)
            above = (curve.derivatives(middle, 1)[1][:, axis] > 0.0) == rising
            low, high = np.where(above, low, middle), np.where(above, middle, high)
        points.append(curve.position(0.5 * (low + high)))
    return np.vstack(points)
