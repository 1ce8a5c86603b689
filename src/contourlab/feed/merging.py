"""Merge short lines within a tolerance (G64 Q), like LinuxCNC's naive CAM detector.

A run of lines becomes one line if all points between its ends lie within the tolerance of that line, and in order along it. Seen from the
start of the run, each point permits a cone of directions; one cone within their intersection is stored. In the plane this cone is the
intersection itself. In space it is a little smaller, so a run may end early but never leaves the tolerance. The cost is linear in the
points: blocks of 2048 lines are processed in parallel, and runs end with their block.

Merging and rounding share the tolerance of a corner: with Q up to P, a point lies at most P/2 off its line, and the blends next to it use
the rest of P. The deviation from the programmed path is at most P, or Q + P/2 where Q is greater than P.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.feed.correspondence import Correspondence
from contourlab.feed.route import Route
from contourlab.geometry import Line, Path
from contourlab.geometry.curve import angle_between

LONGEST_RUN = 2048
"""Most lines in a run."""
_FORWARD = np.radians(89.0)
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
    n = len(points) - 1
    longest = min(LONGEST_RUN, n)
    blocks = -(-n // longest)
    pad = blocks * longest - n
    # Each row is one step of all blocks; the padding is linked to nothing.
    step = np.pad(np.diff(points, axis=0), ((0, pad), (0, 0)), constant_values=1.0).reshape(blocks, longest, -1).transpose(1, 0, 2)
    reach = np.pad(tolerance, (0, pad)).reshape(blocks, -1).T
    joins = np.pad(np.append(False, linked[:-1]), (0, pad)).reshape(blocks, -1).T
    size = np.linalg.norm(step, axis=2)
    with np.errstate(divide="ignore", invalid="ignore"):
        heading = step / size[:, :, None]
    begins = np.ones((longest, blocks), dtype=bool)
    chord, axis, open_by = step[0].copy(), heading[0].copy(), np.full(blocks, _FORWARD)
    for k in range(1, longest):
        chord, axis, open_by, begins[k] = _extend(chord, axis, open_by, step[k], heading[k], reach[k], joins[k])
    return np.flatnonzero(begins.T.ravel()[:n])


def _extend(
    chord: Array, axis: Array, open_by: Array, step: Array, heading: Array, reach: Array, joins: Flags
) -> tuple[Array, Array, Array, Flags]:
    """Add one line to each run, or start a new run with it; return chord, cone of directions (axis, half angle), and which runs are new."""
    away = np.linalg.norm(chord, axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        # The merged line must pass the former end point within the tolerance.
        sine = reach * (1.0 - 1e-9) / away
        near = np.where(sine < 1.0, np.arcsin(np.minimum(sine, 1.0)), np.pi)
        axis, open_by = _within(axis, open_by, chord / away[:, None], near)
        axis, open_by = _within(axis, open_by, heading, np.full_like(near, _FORWARD))
        total = chord + step
        size = np.linalg.norm(total, axis=1)
        fits = joins & (open_by >= 0.0) & (size > 0.0) & (angle_between(axis, total / size[:, None]) <= open_by)
    fresh = ~fits
    chord = np.where(fresh[:, None], step, total)
    axis = np.where(fresh[:, None], heading, axis)
    return chord, axis, np.where(fresh, _FORWARD, open_by), fresh


def _within(axis: Array, wide: Array, other: Array, also: Array) -> tuple[Array, Array]:
    """Return the largest cone within two cones around unit vectors (n, n_axis) with half angles (n,); a negative angle if there is none.

    >>> axis, wide = _within(np.array([[1.0, 0.0]]), np.array([0.2]), np.array([[np.cos(0.3), np.sin(0.3)]]), np.array([0.2]))
    >>> np.round(np.arctan2(axis[:, 1], axis[:, 0]), 12).tolist(), np.round(wide, 12).tolist()
    ([0.15], [0.05])
    """
    apart = angle_between(axis, other)
    inner, outer = apart + wide <= also, apart + also <= wide
    half = np.where(inner, wide, np.where(outer, also, 0.5 * (wide + also - apart)))
    # From the first axis towards the second, along the great circle.
    part = np.where(inner, 0.0, np.where(outer, apart, wide - half))
    swing = np.sin(apart)
    keep, take = np.sin(apart - part), np.sin(part)
    stay = ~(swing > 0.0) | (part == 0.0)
    turned = (keep[:, None] * axis + take[:, None] * other) / np.where(stay, 1.0, swing)[:, None]
    return np.where(stay[:, None], axis, turned), half


def _feet(planned: Path, points: Array, first: Index, run: Index) -> tuple[Array, Array]:
    """Return the position along, and the distance from, the new line of its run for the start of each old line [m]."""
    direction, away = planned.starts[1][run], points[:-1] - points[first]
    foot = np.einsum("ij,ij->i", away, direction)
    return foot, np.asarray(np.linalg.norm(away - foot[:, None] * direction, axis=1))
