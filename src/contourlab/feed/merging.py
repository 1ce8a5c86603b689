"""Merge short lines within a tolerance (G64 Q), like LinuxCNC's naive CAM detector.

A run of lines becomes one line if all points between its ends lie within the tolerance of that line, and in order along it. Seen from the
start of the run, each point permits a cone of directions; one cone within their intersection is stored. In the plane this cone is the
intersection itself. In space it is a little smaller, so a run may end early but never leaves the tolerance. The cost is linear in the
points.

Merging and rounding share the tolerance of a corner: with Q up to P, a point lies at most P/2 off its line, and the blends next to it use
the rest of P. The deviation from the programmed path is at most P, or Q + P/2 where Q is greater than P.
"""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.feed.correspondence import Correspondence
from contourlab.feed.route import Route
from contourlab.geometry import Line, Path
from contourlab.native.kernel import kernel

_FORWARD = math.radians(89.0)
"""Largest angle between a line and its run: points then follow one another along the merged line."""


def merged(route: Route) -> Route:
    """Merge successive feed lines within their `merge_tolerance`; return the route itself where nothing is merged.

    Lines are merged where feedrate, tolerances and mode are equal, none is rapid, and there is no dwell or exact stop between them. A
    merged line has exactly the ends of its run, and the program line of the first line.
    """
    linked = _linked(route)
    if not linked.any():
        return route
    path = route.path
    last_curve = path.curves[-1]
    points = np.concatenate([path.starts[0], last_curve.end[None] if isinstance(last_curve, Line) else path.ends[0][-1:]])
    first = run_starts(points, _reach(route), linked)
    last = np.append(first[1:], route.n_curve) - 1
    many = last > first
    if not many.any():
        return route
    made = iter(Line.many(points[first[many]], points[last[many] + 1]))
    curves = [next(made) if joined else path.curves[i] for i, joined in zip(first.tolist(), many.tolist(), strict=True)]
    planned = Path(curves, path.closed)
    run = np.repeat(np.arange(first.size), last - first + 1)
    along, aside = _feet(planned, points, first[run], run)
    most = np.maximum.reduceat(np.where(many[run], aside, 0.0), first)
    corner = route.corner_tolerance[first]
    unused = np.clip(corner - np.maximum(most, np.roll(most, -1)), 0.5 * corner, corner)
    between = Correspondence(np.append(planned.breaks[run] + np.where(many[run], along, 0.0), planned.length), path.breaks)
    return replace(
        route,
        path=planned,
        programmed=route.programmed,
        correspondence=between if route.correspondence is None else route.correspondence.after(between),
        dwell=route.dwell[last],
        exact_stop=route.exact_stop[last],
        corner_tolerance=unused,
        **{name: getattr(route, name)[first] for name in ("feedrate", "rapid", "source_line", "merge_tolerance")},
    )


def _reach(route: Route) -> Array:
    """Return the largest distance of a point from its merged line [m]: Q if Q > P, else Q but at most P/2."""
    corner, merge = route.corner_tolerance, route.merge_tolerance
    return np.asarray(np.where(merge <= corner, np.minimum(merge, 0.5 * corner), merge))


def _linked(route: Route) -> Flags:
    """Return which curves may be merged with the next."""
    straight = np.array([type(curve) is Line for curve in route.path.curves], dtype=bool)
    usable = straight & ~route.rapid & (route.merge_tolerance > 0.0)
    linked = usable & np.roll(usable, -1) & (route.dwell == 0.0) & ~route.exact_stop
    for name in ("feedrate", "merge_tolerance", "corner_tolerance"):
        values = getattr(route, name)
        linked &= values == np.roll(values, -1)
    linked[-1] = False
    return np.asarray(linked)


def run_starts(points: Array, tolerance: Array, linked: Flags) -> Index:
    """Return the number of the first line of each run.

    Parameters
    ----------
    points : ndarray (n + 1, n_axis) [m]
        Ends of n successive lines.
    tolerance : ndarray (n,) [m]
    linked : ndarray (n,) of bool
        Which lines may be merged with the next.
    """
    begins = np.zeros(len(points) - 1, dtype=np.int64)
    given = (np.ascontiguousarray(part, dtype=float) for part in (points, tolerance, linked))
    _mark_starts(*given, np.empty((3, points.shape[1])), begins)
    return np.flatnonzero(begins)


@kernel("f8[:,:] f8[:] f8[:] f8[:,:] i8[:]")
def _mark_starts(points, tolerance, linked, memory, begins):
    """Mark the first line of each run; `memory` (3, n_axis) holds directions: the axis of the cone, of the run so far, of a line."""
    cone, chord, line = memory[0], memory[1], memory[2]
    start, half = 0, -1.0
    for i in range(begins.size):
        _direction(points, i, i + 1, line)
        far = _direction(points, start, i, chord)
        if i > 0 and linked[i - 1] != 0.0 and far > 0.0:
            # The merged line must pass the former end point within the tolerance, and no line may run backwards.
            sine = tolerance[i] * (1.0 - 1e-9) / far
            half = _narrowed(cone, half, chord, math.asin(sine) if sine < 1.0 else math.pi)
            half = _narrowed(cone, half, line, _FORWARD)
            if half >= 0.0 and _direction(points, start, i + 1, chord) > 0.0 and _angle(cone, chord) <= half:
                continue
        begins[i], start, half = 1, i, _FORWARD
        for j in range(line.size):
            cone[j] = line[j]


def _direction(points, first, last, found):
    """Fill the unit vector from one point to another; return their distance, 0 for the same place."""
    square = 0.0
    for j in range(found.size):
        found[j] = points[last, j] - points[first, j]
        square += found[j] * found[j]
    size = math.sqrt(square)
    for j in range(found.size if size > 0.0 else 0):
        found[j] /= size
    return size


def _angle(a, b):
    """Return the angle between unit vectors, accurate for small and large angles."""
    apart, along = 0.0, 0.0
    for j in range(a.size):
        apart += (b[j] - a[j]) ** 2
        along += (a[j] + b[j]) ** 2
    return 2.0 * math.atan2(math.sqrt(apart), math.sqrt(along))


def _narrowed(cone, half, other, also):
    """Turn the axis of a cone to the largest cone within it and a second one; return its half angle, negative if there is none.

    >>> axis = np.array([1.0, 0.0])
    >>> half = _narrowed(axis, 0.2, np.array([np.cos(0.3), np.sin(0.3)]), 0.2)
    >>> round(math.atan2(axis[1], axis[0]), 12), round(half, 12)
    (0.15, 0.05)
    """
    apart = _angle(cone, other)
    if apart + half <= also:
        return half
    new = also if apart + also <= half else 0.5 * (half + also - apart)
    turn, swing = half - new if new < also else apart, math.sin(apart)
    if swing > 0.0:  # from the first axis towards the second, along the great circle
        keep, take = math.sin(apart - turn) / swing, math.sin(turn) / swing
        for j in range(cone.size):
            cone[j] = keep * cone[j] + take * other[j]
    return new


def _feet(planned: Path, points: Array, first: Index, run: Index) -> tuple[Array, Array]:
    """Return the position along, and the distance from, the new line of its run for the start of each old line [m]."""
    direction, away = planned.starts[1][run], points[:-1] - points[first]
    foot = np.einsum("ij,ij->i", away, direction)
    return foot, np.asarray(np.linalg.norm(away - foot[:, None] * direction, axis=1))
