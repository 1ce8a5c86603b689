"""The motion that controls without jerk limits command: lines from corner to corner, each a trapezoid of speed, as grbl plans them.

An arc becomes n = floor(|sweep| R / (2 sqrt(e (2 R - e)))) chords with the arc tolerance e (`mc_arc` in grbl's motion_control.c). The
command follows the chords exactly. A corner is not rounded: there the velocity jumps. With the directions u before and w after it,
s = sqrt((1 + u.w)/2), the junction deviation d, and the least acceleration A of the axes along w - u, its speed is at most

    v^2 = A d s / (1 - s)

and at most the feedrate of both lines; a reversal is a stop (`plan_buffer_line` in planner.c). A line has the feedrate and the acceleration
with which no axis exceeds its own. The control sees as many lines ahead as its buffer holds, and plans to rest at the end of the last.

Ends of lines are rounded to steps first: short lines turn more than programmed. Not modelled is a buffer that runs empty because lines come
too slowly.
"""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

from dataclasses import replace

import numpy as np

from contourlab.arrays import Array, ranges
from contourlab.errors import FeedError, refuse
from contourlab.feed.bounds import AxisLimits, Grbl
from contourlab.feed.route import Correspondence, Route
from contourlab.geometry import Path
from contourlab.geometry.curve import Curves
from contourlab.geometry.line_and_arc import Arcs, Lines
from contourlab.native.kernel import kernel

STRAIGHT = 0.999999
"""Cosine of an angle that grbl takes for none."""
SLOWEST = 1e-3 / 60.0
"""Lowest feedrate of grbl [m/s]."""


def commanded(route: Route, grbl: Grbl) -> Route:
    """Return the lines that grbl commands for a route: chords in place of arcs, ends rounded to steps, no lines of no step.

    A dwell or a stop stays at the end of the last chord, or of the line before.

    Raises
    ------
    FeedError
        If the route has curves other than lines, arcs and helices, or moves no step.
    """
    path, count, step = route.path, np.ones(route.n_curve, dtype=np.int64), np.array(grbl.steps)
    if not path.of_kind(Lines, Arcs).all():
        raise FeedError('grbl moves along lines and arcs only: write planner = "jerk", or lines in place of the other curves')
    if path.of_kind(Lines).all() and not step.any():
        return route
    for batch, numbers in path.kinds:
        if isinstance(batch, Arcs):
            radius, swept = batch.radius, 0.5 * np.abs(batch.rate) * batch.length * batch.radius
            room = grbl.arc_tolerance * (2.0 * radius - grbl.arc_tolerance)
            count[numbers] = np.where(room > 0.0, np.maximum(swept / np.sqrt(np.maximum(room, 1e-300)), 1.0), 1.0)
    curve, part = np.repeat(np.arange(route.n_curve), count), ranges(np.zeros_like(count), count)
    along = np.diff(path.breaks)[curve] * part / count[curve]
    points = np.vstack([path.at(curve, along, 0)[0], path.starts[0][:1] if path.closed else path.ends[0][-1:]])
    if step.any():
        whole = np.where(step > 0.0, step, 1.0)
        points = np.where(step > 0.0, np.round(points / whole) * whole, points)
    moves = np.any(points[1:] != points[:-1], axis=1)
    refuse(not moves.any(), FeedError, "the motion is shorter than a step of the control")
    first, line = int(np.argmax(moves)), np.maximum(np.cumsum(moves) - 1, 0)
    dwell, stop = (part == count[curve] - 1) * route.dwell[curve], (part == count[curve] - 1) & route.exact_stop[curve]
    lines = Path(Curves([(Lines.between(points[:-1][moves], points[1:][moves]), np.arange(line[-1] + 1))]), path.closed)
    places = (path.breaks[curve] + along)[moves]
    map_ = Correspondence(lines.breaks, np.concatenate([[0.0], places[1:], [path.length]]))
    return replace(
        route,
        path=lines,
        correspondence=map_ if route.correspondence is None else route.correspondence.after(map_),
        dwell=np.bincount(line[first:], dwell[first:]).astype(float),
        dwell_before=route.dwell_before + float(dwell[:first].sum()),
        exact_stop=np.bincount(line[first:], stop[first:]) > 0.0,
        **{name: getattr(route, name)[curve[moves]] for name in ("feedrate", "rapid", "corner_tolerance", "merge_tolerance")},
    )


def _along(limit: Array, direction: Array) -> Array:
    """Return the limit along each direction (n, n_axis) at which no axis exceeds its own (n_axis,)."""
    with np.errstate(divide="ignore"):
        return np.asarray((limit / np.abs(direction)).min(axis=1))


def _nominal(route: Route, limits: AxisLimits) -> Array:
    """Return the speed of each line without its neighbours (n_curve,) [m/s]."""
    return np.maximum(np.minimum(route.feedrate, _along(limits.velocity, route.path.starts[1])), SLOWEST)


def corner_speed(route: Route, limits: AxisLimits, grbl: Grbl) -> Array:
    """Return the largest speed (n_curve,) [m/s] at the end of each line, 0 at stops."""
    before, nominal = route.path.starts[1], _nominal(route, limits)
    turn = np.roll(before, -1, axis=0) - before
    size = np.linalg.norm(turn, axis=1)
    cosine = 1.0 - 0.5 * size**2  # of the turning angle
    half = np.sqrt(0.5 * (1.0 + cosine))
    with np.errstate(divide="ignore", invalid="ignore"):
        square = _along(limits.acceleration, turn / size[:, None]) * grbl.junction_deviation * half / (1.0 - half)
    speed = np.select([cosine > STRAIGHT, cosine < -STRAIGHT], [np.inf, 0.0], np.sqrt(square))
    speed[(route.dwell > 0.0) | route.exact_stop] = 0.0
    if not route.path.closed:
        speed[-1] = 0.0
    return np.asarray(np.minimum(speed, np.minimum(nominal, np.roll(nominal, -1))))


def trapezoids(route: Route, limits: AxisLimits, grbl: Grbl, laps: int) -> Array:
    """Return the spans (n, 5) of a route of lines as rows (duration, s0, v0, a0, j = 0).

    Raises
    ------
    FeedError
        If the route has other curves.
    """
    refuse(not route.path.of_kind(Lines).all(), FeedError, "grbl moves along lines: plan the route that blended(route, limits) returns")
    once = (np.diff(route.path.breaks), _nominal(route, limits), _along(limits.acceleration, route.path.starts[1]))
    length, nominal, steep, ceiling, dwell = (np.tile(part, laps) for part in (*once, corner_speed(route, limits, grbl) ** 2, route.dwell))
    square = np.empty(length.size + 1)
    _squares(2.0 * steep * length, ceiling, grbl.planner_blocks - 2, square)
    enter, leave = square[:-1], square[1:]
    top = np.minimum(nominal**2, 0.5 * (enter + leave) + steep * length)
    peak, v0, v1 = np.sqrt(top), np.sqrt(enter), np.sqrt(leave)
    up, down = (top - enter) / (2.0 * steep), (top - leave) / (2.0 * steep)
    end = np.cumsum(length)
    zero = np.zeros_like(end)
    spans = [
        ((peak - v0) / steep, end - length, v0, steep, zero),
        (np.maximum(length - up - down, 0.0) / peak, end - length + up, peak, zero, zero),
        ((peak - v1) / steep, end - down, peak, -steep, zero),
        (dwell, end, zero, zero, zero),
    ]
    return np.array(spans).transpose(2, 0, 1).reshape(-1, 5)


@kernel("f8[:] f8[:] i8 f8[:]")
def _squares(gain, ceiling, window, square):
    """Fill the squared speeds (n + 1,) at the ends of n lines; `gain` 2 a l, `ceiling` of the squared speed at the end of each.

    While a line runs, its control plans to rest at the end of the line that is `window` lines after it.
    """
    n = gain.size
    square[0] = square[n] = 0.0
    for i in range(1, n):
        permitted = 0.0
        for k in range(min(i + window, n) - 1, i - 1, -1):
            permitted = min(ceiling[k - 1], permitted + gain[k])
        square[i] = min(permitted, square[i - 1] + gain[i - 1])
