"""How LinuxCNC 2.9 joins moves: chains of short lines, nearly tangent corners, blend arcs, parabolas (emccanon.cc, tp.c, blendmath.c).

Under G64 Q successive lines become one while all points between lie within Q of it; small arcs become two lines first. A corner from the
direction u to w is passed as it is if the share

    max over the axes of |w - u| (v / cycle + a) / A        (twice that at an arc)

of the axes' acceleration A is less than `kink_ratio`; v is the lower speed of both moves, a the acceleration of the second. Both lose this
share of theirs. In exact path mode other corners are stops, and still take `kink_ratio` of both. Under G64 the fastest of three is taken:

tangent
    At v `kink_ratio` / share; both moves lose `kink_ratio`.
arc
    Between lines and arcs of one plane, within P and a quarter of both moves, and of at most half of them; its radius is the least with
    which it is as fast as one of that size, but not much shorter than a parabola. Half of the acceleration is along it. A line of which
    less than four cycles are left is driven like its arc.
parabola
    The first move brakes to a stop while the second begins, and the velocities add; both have half of their acceleration.

Without P the quarter is the only bound. On an arc turning takes at most root(3/4) of the acceleration; along it is what is left, or a half.
Rapids stop before and after a cut.
"""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.feed.bounds import AxisLimits, LinuxCNC
from contourlab.feed.fitting import STAYS, spliced
from contourlab.feed.route import Course, Route
from contourlab.geometry import Arc
from contourlab.geometry.blend import blends, halves, quintic_bezier
from contourlab.geometry.curve import CurveBatch, Curves, angle_between
from contourlab.geometry.line_and_arc import Arcs, Lines
from contourlab.native.kernel import kernel

NORMAL, TANGENTIAL = math.sqrt(0.75), 0.5
"""Shares of the acceleration for turning, and along a curve that turns as fast."""
SEGMENT, REVERSAL = 1.02, math.radians(2.0)
"""Fewest cycles of a move; largest sum of two directions that are a reversal."""
CHAIN = 100
"""Most points within a line of a chain."""
LEAST_ARC, LEAST_TURN, FLAT, ACUTE = 1e-9, 1e-3, 1e-6, math.pi / 12.0
"""Shortest blend arc [m]; smallest turn of a parabola [rad] that a tolerance bounds; of planes that are one; between two arcs."""
UNROUNDED: dict[str, Any] = {"corner_tolerance": 0.0, "merge_tolerance": 0.0}
HALVINGS = 3
"""Of a parabola: the speed is exact at the ends of its parts."""


@kernel("f8[:,:] f8[:] f8[:] f8[:,:] i8[:]")
def mark_chains(points, tolerance, linked, memory, begins):
    """Mark the first line of each chain, whose points all lie within the tolerance of the line between its ends."""
    way, start = memory[0], 0
    for i in range(begins.size):
        square = 0.0
        for j in range(way.size):
            way[j] = points[i + 1, j] - points[start, j]
            square += way[j] ** 2
        joins = i > 0 and linked[i - 1] != 0.0 and i - start <= CHAIN and square > 0.0
        for k in range(start + 1, i + 1 if joins else start):
            along, off = 0.0, 0.0
            for j in range(way.size):
                along += (points[k, j] - points[start, j]) * way[j]
            along = min(max(along / square, 0.0), 1.0)
            for j in range(way.size):
                off += (points[k, j] - points[start, j] - along * way[j]) ** 2
            joins = joins and off <= tolerance[i] ** 2
        if not joins:
            begins[i], start = 1, i


def chorded(route: Route) -> Route:
    """Return a route with two lines in place of each arc in the first two axes whose chord lies within the `merge_tolerance`."""
    path, small = route.path, np.zeros(0, dtype=np.int64)
    for batch, numbers in path.kinds:
        if isinstance(batch, Arcs):
            flat = (np.abs(batch.u[2:]) + np.abs(batch.v[2:]) < 1e-9).all(axis=0)
            off = batch.radius * (1.0 - np.cos(np.minimum(0.5 * np.abs(batch.rate) * batch.length, np.pi)))
            small = numbers[flat & (off < route.merge_tolerance[numbers])]
    if not small.size:
        return route
    span, begin, (low, high) = np.diff(path.breaks), path.breaks[small], (np.zeros(route.n_curve), np.diff(path.breaks))
    middle, high[small] = path.at(small, 0.5 * span[small], 0)[0], 0.0
    lines = Lines.between(np.vstack([path.starts[0][small], middle]), np.vstack([middle, path.ends[0][small]]))
    which, last = np.tile(small, 2), np.repeat([False, True], small.size)
    rounds = [(lines, np.append(begin, begin + 0.5 * span[small]))]
    return spliced(route, rounds, (which, which, last), (low, high, path.starts[0], path.ends[0]))[0]


def least_along(limit: Array, direction: Array) -> Array:
    """Return the limit along each direction (n, n_axis) at which no axis exceeds its own (n_axis,)."""
    with np.errstate(divide="ignore"):
        return np.asarray((limit / np.abs(direction)).min(axis=1))


def _space(vectors: Array) -> Array:
    """Return vectors (n, n_axis) of up to three axes with three coordinates."""
    return np.pad(vectors, ((0, 0), (0, 3 - vectors.shape[1])))


def _dot(a: Array, b: Array) -> Array:
    return np.asarray(np.einsum("ij,ij->i", a, b))


def _unit(vectors: Array) -> Array:
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(vectors / np.sqrt(_dot(vectors, vectors))[:, None])


class _Moves(NamedTuple):
    """The moves of a route (n,) as the canonical interface sends them; `normal`, `centre`, `radius` of arcs."""

    length: Array
    speed: Array
    steep: Array
    bent: Flags
    radius: Array
    normal: Array
    centre: Array
    bend: Array
    """Radius of the curvature, with the whole rise of a helix."""


def _moves(route: Route, limits: AxisLimits, cycle: float) -> _Moves:
    path, length = route.path, np.diff(route.path.breaks)
    n = length.size
    speed, steep = least_along(limits.velocity, path.starts[1]), least_along(limits.acceleration, path.starts[1])
    bent, radius, bend, normal, centre = np.zeros(n, dtype=bool), np.ones(n), np.ones(n), np.zeros((n, 3)), np.zeros((n, 3))
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
            bent[numbers], radius[numbers] = True, batch.radius
            bend[numbers] = batch.radius + (batch.rise**2).sum(axis=0) / batch.radius
            normal[numbers] = np.cross(_space(batch.u.T), _space(batch.v.T)) * np.sign(batch.rate)[:, None]
            centre[numbers] = _space(batch.centre.T)
    return _Moves(length, np.minimum(speed, length / cycle), steep, bent, radius, normal, centre, bend)


class _Blends(NamedTuple):
    """Blend arcs of corners (m,): length of each move that they use (2, m), centre, speed, 0 where none is possible, acceleration."""

    reach: Array
    centre: Array
    speed: Array
    steep: Array
    alone: Flags
    """Whether what is left of the line before is driven like the arc."""


def _inscribed(normal: Array, limit: Array) -> Array:
    """Return the least limit within planes (m,), of the axes' projections."""
    limit = np.pad(limit, (0, 3 - limit.size), constant_values=np.inf)
    return np.asarray((limit / np.sqrt(np.maximum(1.0 - normal**2, 1e-24))).min(axis=1))


def _arcs(
    route: Route, moves: _Moves, i: Index, j: Index, pace: Array, taken: Array, limits: AxisLimits, planner: LinuxCNC, parabola: Flags
) -> _Blends:
    """Return the blend arcs at the corners from the moves i to the moves j.

    `pace` (n,) is the speed of each move at the highest feed override, `taken` (n,) what blends before use of each; at `parabola` they are
    parabolas.
    """
    path, tolerance = route.path, route.corner_tolerance
    u, w, corner = _space(path.ends[1][i]), _space(path.starts[1][j]), _space(path.ends[0][i])
    n, inner = _unit(np.cross(u, w)), _unit(w - u)
    half, span = 0.5 * (np.pi - angle_between(u, w)), (moves.length[i] - taken[i], moves.length[j])
    bent, radius, centres = [moves.bent[k] for k in (i, j)], [moves.radius[k] for k in (i, j)], [moves.centre[k] for k in (i, j)]
    convex = bent[0] & (_dot(corner - centres[0], w) < 0.0), bent[1] & (_dot(corner - centres[1], u) >= 0.0)
    used = [np.minimum(span[k] * (2 - k) / 3.0 / radius[k], np.where(convex[k], half, 0.5 * np.pi)) for k in (0, 1)]
    theta = half - 0.25 * np.maximum(convex[0] * used[0], convex[1] * used[1])
    whole, chord = [moves.length[k] for k in (i, j)], [np.where(convex[k], np.sin(0.25 * used[k]), used[k]) * radius[k] for k in (0, 1)]
    room = [np.where(bent[k], chord[k], 0.5 * whole[k]) for k in (0, 1)]
    bound = np.minimum(*(np.minimum(0.25 * whole[k], np.where(tolerance[of] > 0.0, tolerance[of], np.inf)) for k, of in enumerate((i, j))))
    d = np.minimum(np.minimum(*room), bound * np.cos(theta) / (2.0 * np.sin(0.5 * (0.5 * np.pi - theta)) ** 2))
    largest, turn = np.tan(theta) * d, np.pi - 2.0 * theta
    steep, planar = _inscribed(n, limits.acceleration), _inscribed(n, limits.velocity)
    # Between lines, the height of the triangle of both velocities bounds the speed as well.
    v, lean = [moves.speed[k] for k in (i, j)], np.cos(np.minimum(turn, 0.49 * np.pi))
    fast = np.minimum(v[0], v[1] / lean), np.minimum(v[1], v[0] / lean)
    base = fast[1][:, None] * w - fast[0][:, None] * u
    height = np.where(bent[0] | bent[1], 0.0, fast[0] * fast[1] * np.sin(turn) / np.sqrt(_dot(base, base)))
    goal = np.minimum(np.maximum(pace[i], pace[j]), np.maximum(height, planar))
    speed = np.minimum(np.sqrt(NORMAL * steep * largest), goal)
    stretch = np.minimum(np.sqrt(steep * d), speed) / (TANGENTIAL * steep) * speed
    size = np.maximum(speed**2 / (NORMAL * steep), np.minimum(stretch / turn, largest))
    possible = size * turn >= LEAST_ARC
    # Its centre between two lines; then where one of them, or both, is an arc.
    reach, centre = np.stack([size / np.tan(theta)] * 2), corner + inner * (size / np.sin(theta))[:, None]
    grown = [radius[k] + np.where(convex[k], -size, size) for k in (0, 1)]
    for first, one, two in ((False, bent[1] & ~bent[0], 1), (True, bent[0] & ~bent[1], 0)):
        q, side = (w, np.cross(n, w)) if first else (-u, np.cross(n, u))
        way, aside = _dot(centres[two] - corner, q), _dot(centres[two] - corner, side)
        square = grown[two] ** 2 - (size - aside) ** 2
        on = np.abs(np.abs(way) - np.sqrt(np.maximum(square, 0.0)))
        centre = np.where(one[:, None], corner + q * on[:, None] + side * size[:, None], centre)
        reach[1 - two] = np.where(one, on, reach[1 - two])
        possible &= ~one | (square >= 0.0)
    both = bent[0] & bent[1]
    between = centres[1] - centres[0]
    apart = np.where(both, np.sqrt(_dot(between, between)), 1.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        way = (grown[0] ** 2 - grown[1] ** 2 + apart**2) / (2.0 * apart)
        square, axis = grown[0] ** 2 - way**2, between / apart[:, None]
        aside, foot = np.cross(n, axis) * np.sqrt(np.maximum(square, 0.0))[:, None], centres[0] + axis * way[:, None]
        choices = np.stack([foot + aside, foot - aside])
        nearer = np.argmin(((choices - corner) ** 2).sum(axis=2), axis=0)
    centre = np.where(both[:, None], choices[nearer, np.arange(i.size)], centre)
    possible &= ~both | ((square >= 0.0) & (theta >= ACUTE))
    for k in (0, 1):
        trim = angle_between(_unit(corner - centres[k]), _unit(centre - centres[k]))
        reach[k] = np.where(bent[k], trim * radius[k], reach[k])
        slant = np.cross(n, moves.normal[(i, j)[k]])
        possible &= (reach[k] <= span[k] * (1.0 + 1e-9)) & (~bent[k] | ((trim <= used[k]) & (_dot(slant, slant) < FLAT**2)))
    possible &= ~(bent[0] | bent[1]) | (np.sqrt(((centre - corner) ** 2).sum(axis=1)) - size <= bound)
    reach = np.minimum(reach, np.stack(span))
    left = span[0] - reach[0]
    alone = ~bent[0] & (left < planner.gap_cycles * planner.cycle * speed) & ~parabola
    speed = np.minimum(speed, (size * turn + alone * left) / planner.cycle)
    return _Blends(reach, centre, np.where(possible, speed, 0.0), steep, alone)


def _parabola(
    route: Route, moves: _Moves, i: Index, j: Index, overall: Array, steep: Sequence[Array], top: Sequence[Array], left: Sequence[Array]
):
    """Return the speeds of both moves between which they are added, and the speed along the corner; arrays (m,).

    `steep` and `top` are acceleration and speed of the moves, `left` their lengths; a shorter one is reached at most half way. `overall` is
    the acceleration of the second for turning as well.
    """
    # Of an arc the direction in its plane counts, at its start the one of its acceleration.
    ends, bent = (route.path.ends, route.path.starts), [moves.bent[k][:, None] for k in (i, j)]
    spokes = [_unit(_space(ends[k][0][of]) - moves.centre[of]) for k, of in enumerate((i, j))]
    u, w = (np.where(bent[k], _unit(np.cross(moves.normal[of], spokes[k])), _space(ends[k][1][of])) for k, of in enumerate((i, j)))
    pull = (0.25 * np.minimum(route.feedrate, moves.speed)[j] ** 2 / moves.radius[j] / overall)[:, None]
    theta = 0.5 * (np.pi - angle_between(u, np.where(bent[1], _unit(w - pull * spokes[1]), w)))
    time = np.minimum(left[0] / top[0], left[1] / top[1])
    time = np.minimum(time, np.maximum(top[0] / steep[0], top[1] / steep[1]))
    tolerance = np.where(route.corner_tolerance[i] > 0.0, route.corner_tolerance[i], np.inf)
    with np.errstate(divide="ignore"):
        within = np.where(np.cos(theta) > LEAST_TURN, 2.0 * np.sqrt(steep[0] * tolerance / np.cos(theta)), np.inf)
    speeds = [np.minimum(np.minimum(top[k], time * steep[k]), within) for k in (0, 1)]
    return speeds[0], speeds[1], 0.5 * np.sin(theta) * (speeds[0] + speeds[1])


def rounded(route: Route, limits: AxisLimits) -> Route:
    """Return a route of lines and arcs as LinuxCNC drives it: with its blends, and the `Course` along each curve."""
    planner = limits.planner
    assert isinstance(planner, LinuxCNC)
    path, n, cycle, kink = route.path, route.n_curve, planner.cycle, planner.kink_ratio
    moves = _moves(route, limits, cycle)
    before, after = path.ends[1], np.roll(path.starts[1], -1, axis=0)
    asked = np.minimum(route.feedrate, moves.speed)
    pace = np.minimum(planner.largest_override * route.feedrate, moves.speed)
    low = np.minimum(pace, np.roll(pace, -1))
    jump = np.abs(after - before) * (low / cycle + np.roll(moves.steep, -1))[:, None]
    share = (jump / limits.acceleration).max(axis=1) * np.where(moves.bent | np.roll(moves.bent, -1), 2.0, 1.0)
    stops = route.exact_stop | (route.dwell > 0.0) | (route.rapid != np.roll(route.rapid, -1))
    stops |= np.linalg.norm(after + before, axis=1) < REVERSAL
    stops[-1] |= not path.closed
    # The last move before the control waits still expects a blend.
    waits = (route.exact_stop & (route.corner_tolerance > 0.0)) | (route.dwell > 0.0)
    waits[-1] |= not path.closed
    i = np.flatnonzero(~stops & (share >= kink) & (route.corner_tolerance > 0.0))
    j, taken = (i + 1) % n, np.zeros(n)
    parabola, by_kink = np.zeros(i.size, dtype=bool), low[i] * kink / share[i]
    for _ in range(n):  # what a corner takes of a move changes the next: from the first corner to the last
        added = np.zeros(n, dtype=bool)
        added[j] = parabola
        arcs = _arcs(route, moves, i, j, pace, taken, limits, planner, added[i])
        half = [moves.steep[k] * 0.5 * (1.0 - kink) * np.where(moves.bent[k], TANGENTIAL, 1.0) for k in (i, j)]
        left = moves.length[i] - taken[i], moves.length[j]
        quick = [np.minimum(np.sqrt(0.5 * half[k] * left[k]), pace[of]) for k, of in enumerate((i, j))]
        added_speed = 0.5 * _parabola(route, moves, i, j, 0.5 * (1.0 - kink) * moves.steep[j], half, quick, left)[2]
        best = np.argmax([added_speed, by_kink, arcs.speed], axis=0)
        parabola, arc, old = best == 0, best == 2, taken
        reach, taken = arcs.reach * arc, np.zeros(n)
        taken[j] = reach[1]
        if np.allclose(taken, old, rtol=0.0, atol=1e-12):
            break
    # What is left of each move, and its acceleration.
    low_end, high_end, counts = taken.copy(), moves.length.copy(), np.ones(n)
    high_end[i] -= reach[0]
    lost = np.where(stops, 0.0, np.minimum(share, kink))
    lost[i[parabola | arc]] = 0.0
    added = waits & (route.corner_tolerance > 0.0)
    added[i[parabola]] = added[j[parabola]] = True
    steep = moves.steep * (1.0 - np.maximum(lost, np.roll(lost, 1))) * np.where(added, 0.5, 1.0)
    length = np.maximum(high_end - low_end, 1e-12)
    speed = np.minimum(moves.speed, length / cycle)
    overall, turning = steep.copy(), np.where(waits, 0.0, speed**2 / moves.bend / steep)
    speed = np.where(moves.bent & (turning > NORMAL), np.sqrt(NORMAL * steep * moves.bend), speed)
    steep *= np.where(moves.bent, np.where(waits | (turning > NORMAL), TANGENTIAL, np.sqrt(1.0 - np.minimum(turning, 1.0) ** 2)), 1.0)
    top = np.minimum(speed, length / (SEGMENT * cycle))
    nominal, top = np.minimum(route.feedrate, top), np.where(waits, np.minimum(pace, top), top)
    corner = np.where(share < kink, low, 0.0)
    corner[i] = by_kink
    corner[stops] = 0.0
    if not (arc | parabola).any():
        return replace(route, **UNROUNDED, course=Course(nominal, top, steep, corner, counts))
    sole = np.flatnonzero(arc & arcs.alone)
    wanted = np.minimum(np.maximum(asked[i], asked[j]), arcs.speed)
    nominal[i[sole]], top[i[sole]], steep[i[sole]] = wanted[sole], arcs.speed[sole], TANGENTIAL * arcs.steep[sole]
    corner[i[arc]] = np.inf
    counts[i[sole]] = 0.0
    on = np.flatnonzero(parabola)
    known = length * np.where(waits, 0.5, 1.0)
    parts, (reach[:, on], corner[i[on]], leave) = _added(route, moves, i[on], j[on], overall, nominal, steep, length, known)
    low_end[j[on]], high_end[i[on]] = low_end[j[on]] + reach[1, on], high_end[i[on]] - reach[0, on]
    arcs = arcs._replace(reach=reach)
    course = Course(nominal, top, steep, corner, counts)
    return _assembled(route, (i, j), (low_end, high_end), (arcs, wanted, parts, leave), (np.flatnonzero(arc), on), course)


def _added(route: Route, moves: _Moves, i: Index, j: Index, overall: Array, nominal: Array, steep: Array, length: Array, known: Array):
    """Return parabolas: of parts (k,) the powers (k, 6, n_axis) of the share of their time, corner and time; reaches (2, m) and speeds."""
    path = route.path
    left, a = (length[i], length[j]), (steep[i], steep[j])
    top = [np.minimum(np.sqrt(a[k] * known[of]), nominal[of]) for k, of in enumerate((i, j))]
    v = _parabola(route, moves, i, j, overall[j], a, top, left)[0]
    # The first move brakes; the second speeds up, may reach its speed, and may brake to its end: three pieces, some of them empty.
    peak, stop = np.minimum(nominal[j], np.sqrt(a[1] * left[1])), v / a[0]
    edges = np.minimum(stop, [np.zeros(i.size), peak / a[1], left[1] / peak, stop])
    edges = np.where(edges > 0.999 * stop, stop, edges)
    owner, piece = np.nonzero((np.diff(edges, axis=0) > 1e-3 * stop).T)
    last, end = np.diff(owner, append=-1) != 0, edges[piece + 1, owner]
    end[last] = stop
    (rise, brake), times = edges[1:3, owner], (np.where(np.roll(last, 1), 0.0, np.roll(end, 1)), end)
    v, up, i, j = v[owner], a[1][owner], i[owner], j[owner]
    took, gone, corner, duration = a[0][owner], moves.length[i], path.ends[0][i], times[1] - times[0]
    points, pull = np.empty((i.size, 6, path.n_axis)), up * (1 - piece)
    for k, time in enumerate(times):  # position and two derivatives by the share of the duration: those of both moves added
        climb, fall = np.minimum(time, rise), np.maximum(time - brake, 0.0)
        speeds, ahead = (v - took * time, up * (climb - fall)), up * (climb * (time - 0.5 * climb) - 0.5 * fall**2)
        at = (i, gone - 0.5 * speeds[0] ** 2 / took), (j, ahead)
        one, two = (path.at(*place, 2) for place in at)
        speed, change = one[1] * speeds[0][:, None] + two[1] * speeds[1][:, None], two[1] * pull[:, None] - one[1] * took[:, None]
        change += one[2] * speeds[0][:, None] ** 2 + two[2] * speeds[1][:, None] ** 2
        step = speed * (duration * (1 - 2 * k))[:, None] / 5.0
        points[:, 5 * k], points[:, 1 + 3 * k] = (place := one[0] + two[0] - corner), place + step
        points[:, 2 + k] = place + 2.0 * step + change * duration[:, None] ** 2 / 20.0
    reach, leave, powers = np.stack([0.5 * v * v / took, ahead])[:, last], speeds[1][last], quintic_bezier(points)
    for _ in range(HALVINGS):
        powers, owner, duration = halves(powers), np.repeat(owner, 2), 0.5 * np.repeat(duration, 2)
    return (powers, owner, duration), (reach, v[last], leave)


def _assembled(
    route: Route, moves: Sequence[Index], stays: Sequence[Array], blended: tuple[Any, ...], at: Sequence[Index], course: Course
) -> Route:
    """Return the route with its blend arcs and parabolas, each `at` some of the corners between the `moves`."""
    (i, j), (arcs, quick, (powers, owner, duration), leave), (arc, parabola), path = moves, blended, at, route.path
    start, end, span = path.starts[0].copy(), path.ends[0].copy(), np.diff(path.breaks)
    (first, u), (second, w) = path.at(i, span[i] - arcs.reach[0], 1), path.at(j, arcs.reach[1], 1)
    end[i], start[j], begin, turn = first, second, path.breaks[i] + span[i] - arcs.reach[0], angle_between(u, w)
    inner, rounds = _unit(_dot(u, w)[:, None] * u - w), list[tuple[CurveBatch, Array]]()
    if arc.size:
        size = np.linalg.norm(first - (centre := arcs.centre[:, : path.n_axis]), axis=1)
        rounds.append((Arcs([Arc(centre[k], size[k], 0.0, turn[k], inner[k], u[k]) for k in arc.tolist()]), begin[arc]))
    part = np.zeros(0, dtype=np.int64)
    own = np.array([quick[arc], arcs.speed[arc], TANGENTIAL * arcs.steep[arc], np.full(arc.size, np.inf), np.ones(arc.size)])
    if parabola.size:
        curves, piece = blends(powers)
        batch: Any = Curves.of(curves).batches[0]
        part = owner[piece]
        # A part of a divided piece takes the time in which its acceleration, almost constant, gives its second derivative.
        time = np.sqrt(np.linalg.norm(batch.coefficients[:, 2], axis=1))
        time *= (duration / np.bincount(piece, weights=time))[piece]
        speed = np.linalg.norm(batch.coefficients[:, 1], axis=1) / time
        leave = np.where(np.diff(part, append=-1) != 0, leave[part], np.roll(speed, -1))
        steep = np.maximum(np.abs(leave**2 - speed**2) / (2.0 * batch.length), 1e-6) * (1.0 + 1e-9)
        own = np.append(own, [*[np.maximum(speed, leave)] * 2, steep, leave, np.zeros(part.size)], axis=1)
        done = np.cumsum(batch.length) - batch.length
        share = (done - done[np.searchsorted(part, part)]) / np.bincount(part, weights=batch.length)[part]
        rounds.append((batch, begin[parabola][part] + share * arcs.reach.sum(axis=0)[parabola][part]))
    which, last = np.append(arc, parabola[part]), np.append(arc >= 0, np.diff(part, append=-1) != 0)
    data = np.where(route.feedrate[i] >= route.feedrate[j], i, j)[which]
    whole = stays[1][j] - stays[0][j] <= STAYS * span[j]  # a blend that takes all of the second move stops where that would
    joint = np.where(whole, j, i)[which]
    changed, source = spliced(route, rounds, (data, joint, last), (stays[0], stays[1], start, end))
    return replace(changed, **UNROUNDED, course=Course(*np.append(np.array(course), own, axis=1)[:, source]))
