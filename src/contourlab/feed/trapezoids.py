"""The motion that controls without jerk limits command: each move a trapezoid of speed, as grbl plans it, or LinuxCNC in exact path mode.

grbl: an arc becomes n = floor(|sweep| R / (2 sqrt(e (2 R - e)))) chords with the arc tolerance e (`mc_arc` in grbl's motion_control.c). The
command follows the chords exactly. A corner is not rounded: there the velocity jumps. With the directions u before and w after it,
s = sqrt((1 + u.w)/2), the junction deviation d, and the least acceleration A of the axes along w - u, its speed is at most

    v^2 = A d s / (1 - s)

and at most the feedrate of both lines; a reversal is a stop (`plan_buffer_line` in planner.c). A line has the feedrate and the acceleration
with which no axis exceeds its own. The control sees as many lines ahead as its buffer holds, and plans to rest at the end of the last.

Ends of lines are rounded to steps first: short lines turn more than programmed. Not modelled is a buffer that runs empty because lines come
too slowly.

LinuxCNC 2.9 (tp.c, blendmath.c, emccanon.cc): arcs stay. A corner from the direction u to w is passed if the share

    max over the axes of |w - u| (v / cycle + a) / A        (twice that at an arc)

of the axes' acceleration A is less than `kink_ratio`; v is the lower speed of both moves, a the acceleration of the second. Both lose this
share of theirs, at other corners `kink_ratio`. On an arc turning takes at most root(3/4) of it; what is left, or a half, is
along it. From stop to stop a motion takes whole cycles. Rapids stop before and after a cut.
"""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from contourlab.arrays import Array, ranges
from contourlab.errors import FeedError, refuse
from contourlab.feed.bounds import AxisLimits, Grbl, LinuxCNC
from contourlab.feed.route import Correspondence, Route
from contourlab.geometry import Path
from contourlab.geometry.curve import Curves
from contourlab.geometry.line_and_arc import Arcs, Lines
from contourlab.native.kernel import kernel

STRAIGHT = 0.999999
"""Cosine of an angle that grbl takes for none."""
NORMAL, SEGMENT, REVERSAL = math.sqrt(0.75), 1.02, math.radians(2.0)
"""Of LinuxCNC: share of the acceleration for turning, fewest cycles of a move, largest sum of two directions that are a reversal."""
SLOWEST = 1e-3 / 60.0
"""Lowest feedrate of grbl [m/s]."""


def commanded(route: Route, planner: Grbl | LinuxCNC) -> Route:
    """Return the curves that a control commands for a route.

    LinuxCNC: those of the route. grbl: chords in place of arcs, ends rounded to steps, no lines of no step.

    A dwell or a stop stays at the end of the last chord, or of the line before.

    Raises
    ------
    FeedError
        If the route has curves other than lines, arcs and helices, or moves no step.
    """
    if not route.path.of_kind(Lines, Arcs).all():
        raise FeedError('the control moves along lines and arcs only: write planner = "jerk", or lines in place of the other curves')
    if isinstance(planner, LinuxCNC):
        refuse(bool(route.corner_tolerance.any()), FeedError, 'G64 is not planned as LinuxCNC does: write path_control = "exact_path"')
        return route
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


class Course(NamedTuple):
    """What the planner of a control makes of each curve of a route (n_curve,).

    nominal : ndarray [m/s]
        Speed without the neighbours.
    steep : ndarray [m/s^2]
        Acceleration along the curve.
    corner : ndarray [m/s]
        Largest speed at the end of the curve, 0 at stops.
    """

    nominal: Array
    steep: Array
    corner: Array


def course(route: Route, limits: AxisLimits) -> Course:
    """Return how the planner of the limits runs along the curves of a route that it commands."""
    planner = limits.planner
    assert planner is not None
    nominal, steep, corner = _as_grbl(route, limits, planner) if isinstance(planner, Grbl) else _as_linuxcnc(route, limits, planner)
    corner = np.minimum(corner, np.minimum(nominal, np.roll(nominal, -1)))
    corner[(route.dwell > 0.0) | route.exact_stop] = 0.0
    if not route.path.closed:
        corner[-1] = 0.0
    return Course(nominal, steep, corner)


def _as_grbl(route: Route, limits: AxisLimits, grbl: Grbl) -> tuple[Array, Array, Array]:
    refuse(not route.path.of_kind(Lines).all(), FeedError, "grbl moves along lines: plan the route that blended(route, limits) returns")
    before = route.path.starts[1]
    turn = np.roll(before, -1, axis=0) - before
    size = np.linalg.norm(turn, axis=1)
    cosine = 1.0 - 0.5 * size**2  # of the turning angle
    half = np.sqrt(0.5 * (1.0 + cosine))
    with np.errstate(divide="ignore", invalid="ignore"):
        square = _along(limits.acceleration, turn / size[:, None]) * grbl.junction_deviation * half / (1.0 - half)
    corner = np.select([cosine > STRAIGHT, cosine < -STRAIGHT], [np.inf, 0.0], np.sqrt(square))
    nominal = np.maximum(np.minimum(route.feedrate, _along(limits.velocity, before)), SLOWEST)
    return nominal, _along(limits.acceleration, before), corner


def _as_linuxcnc(route: Route, limits: AxisLimits, linuxcnc: LinuxCNC) -> tuple[Array, Array, Array]:
    path, length = route.path, np.diff(route.path.breaks)
    before, after = path.ends[1], np.roll(path.starts[1], -1, axis=0)
    speed, steep = _along(limits.velocity, path.starts[1]), _along(limits.acceleration, path.starts[1])
    bent, radius = np.zeros(length.size, dtype=bool), np.ones(length.size)
    for batch, numbers in path.kinds:
        if isinstance(batch, Arcs):
            # The limits of its plane, those of the straight move between its ends, and the normal acceleration.
            flat = np.abs(batch.rate) * batch.length * batch.radius
            moves = (np.abs(batch.u) + np.abs(batch.v) > 1e-9).T
            v, a = (np.where(moves, limit, np.inf).min(axis=1) for limit in (limits.velocity, limits.acceleration))
            straight = np.abs(path.ends[0] - path.starts[0])[numbers]
            v = np.minimum(v, np.sqrt(a * NORMAL * batch.radius))
            speed[numbers] = batch.length / np.maximum((straight / limits.velocity).max(axis=1), flat / v)
            steep[numbers] = batch.length / np.maximum((straight / limits.acceleration).max(axis=1), flat / a)
            bent[numbers], radius[numbers] = True, batch.radius + (batch.rise**2).sum(axis=0) / batch.radius  # the whole rise, as there
    speed = np.minimum(speed, length / linuxcnc.cycle)
    asked = np.minimum(route.feedrate, speed)
    # Nearly tangent: the velocity may jump by a share of what the axes' acceleration gives in a cycle. Both curves lose that share.
    pace = np.minimum(asked, np.roll(asked, -1))
    jump = np.abs(after - before) * (pace / linuxcnc.cycle + np.roll(steep, -1))[:, None]
    share = (jump / limits.acceleration).max(axis=1) * np.where(bent | np.roll(bent, -1), 2.0, 1.0)
    tangent = share < linuxcnc.kink_ratio
    stops = route.exact_stop | (route.rapid != np.roll(route.rapid, -1)) | (np.linalg.norm(after + before, axis=1) < REVERSAL)
    stops[-1] |= not path.closed
    lost = np.where(stops, 0.0, np.minimum(share, linuxcnc.kink_ratio))
    steep *= 1.0 - np.maximum(lost, np.roll(lost, 1))
    # An arc leaves half of the acceleration to the tangent, or what turning does not take.
    turning = speed**2 / radius / steep
    speed = np.where(bent & (turning > NORMAL), np.sqrt(NORMAL * steep * radius), speed)
    steep *= np.where(bent, np.where(turning > NORMAL, 0.5, np.sqrt(1.0 - np.minimum(turning, 1.0) ** 2)), 1.0)
    speed = np.minimum(speed, length / (SEGMENT * linuxcnc.cycle))
    return np.minimum(route.feedrate, speed), steep, np.where(tangent & ~stops, pace, 0.0)


def trapezoids(route: Route, limits: AxisLimits, laps: int) -> Array:
    """Return the spans (n, 5) of a route that the planner of the limits commands, as rows (duration, s0, v0, a0, j = 0).

    Raises
    ------
    FeedError
        If the route has curves that the control does not command.
    """
    assert limits.planner is not None
    once = course(route, limits)
    length, dwell, nominal, steep, corner = (np.tile(part, laps) for part in (np.diff(route.path.breaks), route.dwell, *once))
    square, gain = np.empty(length.size + 1), 2.0 * steep * length
    if isinstance(limits.planner, LinuxCNC):  # the last move that it knows may lose a half to a blend: it plans to rest in its middle
        gain[np.append(dwell[:-1] > 0.0, True)] *= 0.5
    _squares(gain, corner**2, limits.planner.planner_blocks - 2, square)
    enter, leave = square[:-1], square[1:]
    top = np.minimum(nominal**2, 0.5 * (enter + leave) + steep * length)
    peak, v0, v1 = np.sqrt(top), np.sqrt(enter), np.sqrt(leave)
    up, down = (top - enter) / (2.0 * steep), (top - leave) / (2.0 * steep)
    end = np.cumsum(length)
    zero, rise, cruise, fall = np.zeros_like(end), (peak - v0) / steep, np.maximum(length - up - down, 0.0) / peak, (peak - v1) / steep
    if isinstance(limits.planner, LinuxCNC):  # from stop to stop in whole cycles
        stops = np.flatnonzero(leave == 0.0)
        cycles = np.diff(np.cumsum(rise + cruise + fall)[stops], prepend=0.0) / limits.planner.cycle
        dwell[stops] += (np.ceil(cycles - 1e-6) - cycles) * limits.planner.cycle
    spans = [
        (rise, end - length, v0, steep, zero),
        (cruise, end - length + up, peak, zero, zero),
        (fall, end - down, peak, -steep, zero),
        (np.maximum(dwell, 0.0), end, zero, zero, zero),
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
