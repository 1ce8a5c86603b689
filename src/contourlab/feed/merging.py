"""Dust merged (G64 Q): successive lines that are one line within a tolerance become it, as in LinuxCNC's naive CAM detector.

A line is drawn from the start of the first to the end of the last, as long as every point between is within the tolerance of it and they
follow one another along it. From the start of a run, each point permits a cone of directions; what all of them permit is held as one cone
that lies within their intersection. In the plane that is the intersection itself; in space it is a little less, so that a run may end early
but never leaves the tolerance. The cost is that of the points: runs end at every 2048th line at the latest, and all of these blocks are
walked through side by side.

Merging and rounding share the tolerance of a corner: with Q up to P a point lies at most P/2 off its line, and the blends next to it get
what is left of P. So the path leaves the programmed one by no more than P, or by Q + P/2 where Q is the larger.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from contourlab.feed.correspondence import Correspondence
from contourlab.feed.route import Route
from contourlab.geometry import Line, Path
from contourlab.geometry.curve import angle_between

Array = NDArray[np.float64]
Index = NDArray[np.int64]
Flags = NDArray[np.bool_]

LONGEST_RUN = 2048
"""At most so many lines become one."""
_FORWARD = np.radians(89.0)
"""A line of a run keeps at least this far from turning back: points then follow one another along the merged line."""


def merged(route: Route) -> Route:
    """Return the route with successive feed lines merged within their `merge_tolerance`.

    Parameters
    ----------
    route : Route
        Lines are merged where feedrate, tolerances and mode are equal, none is rapid, and there is no dwell or exact stop between them.

    Returns
    -------
    Route
        The route itself where nothing is merged. A merged line has exactly the ends of its run and the line of the program of its first.
    """
    linked = _linked(route)
    if not linked.any():
        return route
    path = route.path
    last_curve = path.curves[-1]
    points = np.concatenate([path.starts[0], last_curve.end[None] if isinstance(last_curve, Line) else path.ends[0][-1:]])
    first = run_starts(points, _reach(route), linked)
    n = route.n_curve
    last = np.append(first[1:], n) - 1
    many = last > first
    if not many.any():
        return route
    made = Line.many(points[first[many]], points[last[many] + 1])
    fresh = iter(made)
    curves = [next(fresh) if joined else path.curves[i] for i, joined in zip(first.tolist(), many.tolist(), strict=True)]
    planned = Path(curves, path.closed)
    along, aside = _feet(planned, points, first)
    most = np.maximum.reduceat(np.where(np.repeat(many, last - first + 1), aside, 0.0), first)
    corner = route.corner_tolerance[first]
    # What merging has used up next to a corner is not there for the blend.
    left = np.clip(corner - np.maximum(most, np.roll(most, -1)), 0.5 * corner, corner)
    return replace(
        route,
        path=planned,
        programmed=route.programmed,
        correspondence=_places(route, planned, along, first, many),
        dwell=route.dwell[last],
        exact_stop=route.exact_stop[last],
        corner_tolerance=left,
        **{name: getattr(route, name)[first] for name in ("feedrate", "rapid", "source_line", "merge_tolerance")},
    )


def _reach(route: Route) -> Array:
    """Return how far a point may lie off its merged line [m]: half of the corner's tolerance at most, unless Q asks for more than that."""
    corner, merge = route.corner_tolerance, route.merge_tolerance
    return np.asarray(np.where(merge <= corner, np.minimum(merge, 0.5 * corner), merge))


def _linked(route: Route) -> Flags:
    """Return which curves may be one with the next."""
    straight = np.array([type(curve) is Line for curve in route.path.curves], dtype=bool)
    usable = straight & ~route.rapid & (route.merge_tolerance > 0.0)
    linked = usable & np.roll(usable, -1) & (route.dwell == 0.0) & ~route.exact_stop
    for name in ("feedrate", "merge_tolerance", "corner_tolerance"):
        values = getattr(route, name)
        linked &= values == np.roll(values, -1)
    linked[-1] = False
    return np.asarray(linked)


def run_starts(points: Array, tolerance: Array, linked: Flags) -> Index:
    """Return the first line of each run that becomes one line.

    Parameters
    ----------
    points : ndarray (n + 1, n_axis) [m]
        Ends of n lines, one after another.
    tolerance : ndarray (n,) [m]
    linked : ndarray (n,) of bool
        Which lines may be one with the next.
    """
    n = len(points) - 1
    longest = min(LONGEST_RUN, n)
    blocks = -(-n // longest)
    pad = blocks * longest - n
    # Row by row a step of all blocks; what is added at the end stands by itself.
    step = np.pad(np.diff(points, axis=0), ((0, pad), (0, 0)), constant_values=1.0).reshape(blocks, longest, -1).transpose(1, 0, 2)
    reach = np.pad(tolerance, (0, pad)).reshape(blocks, -1).T
    joins = np.pad(np.append(False, linked[:-1]), (0, pad)).reshape(blocks, -1).T
    size = np.linalg.norm(step, axis=2)
    with np.errstate(divide="ignore", invalid="ignore"):
        heading = step / size[:, :, None]
    begins = np.ones((longest, blocks), dtype=bool)
    chord, axis, open_by = step[0].copy(), heading[0].copy(), np.full(blocks, _FORWARD)
    for k in range(1, longest):
        chord, axis, open_by, begins[k] = _one_more(chord, axis, open_by, step[k], heading[k], reach[k], joins[k])
    return np.flatnonzero(begins.T.ravel()[:n])


def _one_more(
    chord: Array, axis: Array, open_by: Array, step: Array, heading: Array, reach: Array, joins: Flags
) -> tuple[Array, Array, Array, Flags]:
    """Take one line more into each run, or begin a new run with it: chord of the run, cone of directions (axis, half angle), new runs."""
    away = np.linalg.norm(chord, axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        # The last point becomes one between: the merged line must pass it within the tolerance.
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
    """Return the largest cone within two cones, about unit vectors (n, n_axis) with half angles (n,); a negative angle where there is none.

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


def _feet(planned: Path, points: Array, first: Index) -> tuple[Array, Array]:
    """Return where the start of each old line falls along the new one of its run, and how far beside it [m]."""
    run = np.searchsorted(first, np.arange(len(points) - 1), side="right") - 1
    direction, away = planned.starts[1][run], points[:-1] - points[first][run]
    foot = np.einsum("ij,ij->i", away, direction)
    return foot, np.asarray(np.linalg.norm(away - foot[:, None] * direction, axis=1))


def _places(route: Route, planned: Path, foot: Array, first: Index, many: Flags) -> Correspondence:
    """Return the map: points between go to their feet on the merged line."""
    n = route.n_curve
    run = np.searchsorted(first, np.arange(n), side="right") - 1
    along = np.append(planned.breaks[run] + np.where(many[run], foot, 0.0), planned.length)
    here = Correspondence(along, route.path.breaks)
    return here if route.correspondence is None else route.correspondence.after(here)
