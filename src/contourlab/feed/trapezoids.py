"""The motion that controls without jerk limits command: each move a trapezoid of speed, as grbl and LinuxCNC plan it.

grbl: an arc becomes n = floor(|sweep| R / (2 sqrt(e (2 R - e)))) chords with the arc tolerance e (`mc_arc` in grbl's motion_control.c). The
command follows the chords exactly. A corner is not rounded: there the velocity jumps. With the directions u before and w after it,
s = sqrt((1 + u.w)/2), the junction deviation d, and the least acceleration A of the axes along w - u, its speed is at most

    v^2 = A d s / (1 - s)

and at most the feedrate of both lines; a reversal is a stop (`plan_buffer_line` in planner.c). A line has the feedrate and the acceleration
with which no axis exceeds its own. The control sees as many lines ahead as its buffer holds, and plans to rest at the end of the last.

Ends of lines are rounded to steps first: short lines turn more than programmed. Not modelled is a buffer that runs empty because lines come
too slowly.

LinuxCNC: `contourlab.feed.linuxcnc`. From stop to stop a motion takes whole cycles.
"""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

from dataclasses import replace

import numpy as np

from contourlab.arrays import Array, ranges
from contourlab.errors import FeedError, refuse
from contourlab.feed.bounds import AxisLimits, Grbl, LinuxCNC
from contourlab.feed.linuxcnc import least_along, rounded
from contourlab.feed.route import Correspondence, Course, Route, controlled
from contourlab.geometry import Path
from contourlab.geometry.curve import Curves
from contourlab.geometry.line_and_arc import Arcs, Lines
from contourlab.native.kernel import kernel

STRAIGHT = 0.999999
"""Cosine of an angle that grbl takes for none."""
SLOWEST = 1e-3 / 60.0
"""Lowest feedrate of grbl [m/s]."""


def commanded(route: Route, limits: AxisLimits) -> Route:
    """Return the curves that the control of the limits commands for a route.

    LinuxCNC: those of the route, with its blends. grbl: chords in place of arcs, ends rounded to steps, no lines of no step.

    A dwell or a stop stays at the end of the last chord, or of the line before.

    Raises
    ------
    FeedError
        If the route has curves other than lines, arcs and helices, or moves no step.
    """
    if not route.path.of_kind(Lines, Arcs).all():
        raise FeedError('this planner drives lines and arcs only: use --planner jerk, or planner = "jerk" under [feed], for splines')
    planner = limits.planner
    if isinstance(planner, LinuxCNC):
        return rounded(route, limits.for_axes(route.path.n_axis)) if route.course is None else route
    assert planner is not None
    path, count, step = route.path, np.ones(route.n_curve, dtype=np.int64), np.array(planner.steps)
    if path.of_kind(Lines).all() and not step.any():
        return route
    for batch, numbers in path.kinds:
        if isinstance(batch, Arcs):
            radius, swept = batch.radius, 0.5 * np.abs(batch.rate) * batch.length * batch.radius
            room = planner.arc_tolerance * (2.0 * radius - planner.arc_tolerance)
            count[numbers] = np.where(room > 0.0, np.maximum(swept / np.sqrt(np.maximum(room, 1e-300)), 1.0), 1.0)
    curve, part = np.repeat(np.arange(route.n_curve), count), ranges(np.zeros_like(count), count)
    along = np.diff(path.breaks)[curve] * part / count[curve]
    points = np.vstack([path.at(curve, along, 0)[0], path.starts[0][:1] if path.closed else path.ends[0][-1:]])
    if step.any():
        whole = np.where(step > 0.0, step, 1.0)
        points = np.where(step > 0.0, np.trunc(points / whole + np.copysign(0.5, points)) * whole, points)
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


def course(route: Route, limits: AxisLimits) -> Course:
    """Return how the planner of the limits runs along the curves of a route that it commands."""
    planner = limits.planner
    if isinstance(planner, LinuxCNC):
        own = route.course or rounded(controlled(route, "exact_path", 0.0), limits).course
        assert own is not None
        nominal, top, steep, corner, counts = own
    else:
        assert planner is not None
        (nominal, steep, corner), counts = _as_grbl(route, limits, planner), np.ones(route.n_curve)
        top = nominal
    corner = np.minimum(corner, np.minimum(top, np.roll(top, -1)))
    corner[(route.dwell > 0.0) | route.exact_stop] = 0.0
    if not route.path.closed:
        corner[-1] = 0.0
    return Course(nominal, top, steep, corner, counts)


def _as_grbl(route: Route, limits: AxisLimits, grbl: Grbl) -> tuple[Array, Array, Array]:
    refuse(not route.path.of_kind(Lines).all(), FeedError, "grbl moves along lines: plan the route that blended(route, limits) returns")
    before = route.path.starts[1]
    turn = np.roll(before, -1, axis=0) - before
    size = np.linalg.norm(turn, axis=1)
    cosine = 1.0 - 0.5 * size**2  # of the turning angle
    half = np.sqrt(0.5 * (1.0 + cosine))
    with np.errstate(divide="ignore", invalid="ignore"):
        square = least_along(limits.acceleration, turn / size[:, None]) * grbl.junction_deviation * half / (1.0 - half)
    corner = np.select([cosine > STRAIGHT, cosine < -STRAIGHT], [np.inf, 0.0], np.sqrt(square))
    nominal = np.maximum(np.minimum(route.feedrate, least_along(limits.velocity, before)), SLOWEST)
    return nominal, least_along(limits.acceleration, before), corner


def trapezoids(route: Route, limits: AxisLimits, laps: int) -> Array:
    """Return the spans (n, 5) of a route that the planner of the limits commands, as rows (duration, s0, v0, a0, j = 0).

    Raises
    ------
    FeedError
        If the route has curves that the control does not command.
    """
    assert limits.planner is not None
    once = course(route, limits)
    length, dwell, nominal, _, steep, corner, counts = (np.tile(part, laps) for part in (np.diff(route.path.breaks), route.dwell, *once))
    square, gain = np.empty(length.size + 1), 2.0 * steep * length
    if isinstance(limits.planner, LinuxCNC):
        # The last move that it knows may lose a half to a blend: where another joins it without one, it plans to rest in its middle.
        waits = (dwell > 0.0) | np.tile(route.exact_stop, laps)
        waits[-1] = True
        gain[waits & (np.roll(counts, 1) > 0.0)] *= 0.5
    place = np.cumsum(counts)
    _squares(
        gain,
        corner**2,
        np.minimum(nominal, np.roll(nominal, -1)) ** 2,
        np.searchsorted(place, place + limits.planner.planner_blocks - 2),
        square,
    )
    enter, leave = square[:-1], square[1:]
    top = np.maximum(np.minimum(nominal**2, 0.5 * (enter + leave) + steep * length), leave)
    peak, v0, v1 = np.sqrt(top), np.sqrt(enter), np.sqrt(leave)
    first = np.where(top < enter, -steep, steep)
    up, down = (top - enter) / (2.0 * first), (top - leave) / (2.0 * steep)
    end = np.cumsum(length)
    zero, rise, cruise, fall = np.zeros_like(end), (peak - v0) / first, np.maximum(length - up - down, 0.0) / peak, (peak - v1) / steep
    if isinstance(limits.planner, LinuxCNC):  # from stop to stop in whole cycles
        stops = np.flatnonzero(leave == 0.0)
        cycles = np.diff(np.cumsum(rise + cruise + fall)[stops], prepend=0.0) / limits.planner.cycle
        dwell[stops] += (np.ceil(cycles - 1e-6) - cycles) * limits.planner.cycle
    spans = [
        (rise, end - length, v0, first, zero),
        (cruise, end - length + up, peak, zero, zero),
        (fall, end - down, peak, -steep, zero),
        (np.maximum(dwell, 0.0), end, zero, zero, zero),
    ]
    return np.array(spans).transpose(2, 0, 1).reshape(-1, 5)


@kernel("f8[:] f8[:] f8[:] i8[:] f8[:]")
def _squares(gain, ceiling, asked, known, square):
    """Fill the squared speeds (n + 1,) at the ends of n lines; `gain` 2 a l, `ceiling` of the squared speed at the end of each.

    Within the ceilings a line brakes to the square that is `asked` at its end as far as it can.

    While line i runs, its control knows the lines before `known` (n,)[i], and plans to rest at the end of the last.
    """
    n = gain.size
    square[0] = square[n] = 0.0
    for i in range(1, n):
        permitted = 0.0
        for k in range(known[i] - 1, i - 1, -1):
            permitted = min(ceiling[k - 1], permitted + gain[k])
        square[i] = max(min(permitted, asked[i - 1], square[i - 1] + gain[i - 1]), square[i - 1] - gain[i - 1])
