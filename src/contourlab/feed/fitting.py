"""Fit one smooth curve to each run of short lines and arcs that chop a curve, within the tolerance of the programmed path.

A curve is short if an arc that turns like its ends would lie within the tolerance of it. Three or more short curves in succession are a
run. It begins and ends on its neighbours, where the fitted curve has their position, direction and curvature, or at a stop; so real corners
stay corners between lines.

Sites p along a run are smoothed (Whittaker and Henderson): x minimises the integral of |x - p|^2 + l^6 |x'''|^2 by arc length. Ripples
shorter than l vanish; arcs of a radius of some l stay. The length l begins large. It is lowered around each site that leaves half of the
tolerance, and, where it is as small as the chords, around each site that leaves the whole tolerance. Position and two derivatives at some
sites give quintic curves, so curvature does not jump.

Each quintic is compared with the programmed path at equal arc length, so neither cuts anything short. The difference on a line is a quintic
too: the control points of its Bezier form bound it.
"""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from contourlab.arrays import Array, Flags, Index, ranges
from contourlab.feed.route import Correspondence, Route
from contourlab.geometry import Path
from contourlab.geometry.blend import blends
from contourlab.geometry.curve import CurveBatch, Curves, angle_between
from contourlab.geometry.line_and_arc import Arcs, Lines
from contourlab.geometry.path import CORNER_ANGLE
from contourlab.native.kernel import kernel

_RATIO = 64.0
"""A curve more than this many times as long as a neighbour is not short."""
_FEWEST = 3
"""Least number of short curves in a run."""
_TAKE = 1000.0
"""Most of a neighbour that a run uses, in tolerances."""
_GRADE = 3.0
"""Largest ratio of the spacing of sites of neighbouring curves."""
_CHORD = 0.6
"""Smoothing length, in chords, that removes the ripple of chords: (2 pi 0.6)^-6 is 1/3000."""
_STIFF = 50.0
"""Largest smoothing length, in distances of sites; more would lose digits."""
_ROUNDS, _PATIENCE = 40, 12
"""Most rounds of a fit, and after how many it may use the whole tolerance anywhere."""
_AGAIN = 5
"""Most fits; after each, curves where the fit failed are kept."""
_SPACING = 2.5
"""Length of a quintic curve, in smoothing lengths."""
_SLOWEST = 0.1
"""Smallest speed of a quintic curve relative to the programmed path."""
_BEZIER = np.array([[math.comb(i, k) / math.comb(5, k) for k in range(6)] for i in range(6)])


# --- smoothing, compiled ---------------------------------------------------------------------------------------------------------------


def _smoothed(t, p, length, first, after, begin, end, band, y):
    """Fill y with x - p of the sites [first, after), 0 outside of [begin, end). `band` is working memory for the matrix."""
    n_axis = p.shape[1]
    for i in range(first, after):
        band[i, 0] = 0.5 * (t[i + 1] - t[i - 1]) if begin <= i < end else 1.0
        band[i, 1], band[i, 2], band[i, 3] = 0.0, 0.0, 0.0
        for j in range(n_axis):
            y[i, j] = 0.0
    for k in range(first, after - 3):
        a, b, c, d = t[k], t[k + 1], t[k + 2], t[k + 3]
        # Weights of the third derivative of the cubic through four sites.
        w0, w1 = 6.0 / ((a - b) * (a - c) * (a - d)), 6.0 / ((b - a) * (b - c) * (b - d))
        w2, w3 = 6.0 / ((c - a) * (c - b) * (c - d)), 6.0 / ((d - a) * (d - b) * (d - c))
        energy = (d - a) / 3.0 * min(min(length[k], length[k + 1]), min(length[k + 2], length[k + 3])) ** 6
        for u in range(4):
            i = k + u
            if not begin <= i < end:
                continue
            here = energy * (w0 if u == 0 else w1 if u == 1 else w2 if u == 2 else w3)
            for j in range(n_axis):
                third = w0 * (p[k, j] - p[k + 1, j]) + (w0 + w1) * (p[k + 1, j] - p[k + 2, j]) - w3 * (p[k + 2, j] - p[k + 3, j])
                y[i, j] -= here * third
            for v in range(u, 4):
                if k + v < end:
                    band[i, v - u] += here * (w0 if v == 0 else w1 if v == 1 else w2 if v == 2 else w3)
    for i in range(begin, end):
        for q in range(1, min(4, end - i)):
            part = band[i, q] / band[i, 0]
            for r in range(q, min(4, end - i)):
                band[i + q, r - q] -= part * band[i, r]
            for j in range(n_axis):
                y[i + q, j] -= part * y[i, j]
    for i in range(end - 1, begin - 1, -1):
        for j in range(n_axis):
            for q in range(1, min(4, end - i)):
                y[i, j] -= band[i, q] * y[i + q, j]
            y[i, j] /= band[i, 0]


def _eased(t, length, failed, width, first, after):
    """Lower smoothing lengths so that they change by at most a fifth of the arc length, and not within `width` lengths of marked sites."""
    for way in range(2):
        least, left, before = 0.0, -1.0, -1
        for count in range(after - first):
            i = first + count if way == 0 else after - 1 - count
            gap = abs(t[i] - t[before]) if count > 0 else 0.0
            left -= gap
            if failed[i] != 0 and (left < 0.0 or length[i] < least):
                least, left = length[i], width * length[i]
            length[i] = min(length[i], least) if left >= 0.0 else length[i]
            length[i] = min(length[i], length[before] + 0.2 * gap) if count > 0 else length[i]
            before = i


def _lowered(y, chord, tolerance, length, first, after, patient, failed):
    """Lower the smoothing length at the sites that are too far off, and mark them; return whether there are any."""
    far = False
    for i in range(first, after):
        square = 0.0
        for j in range(y.shape[1]):
            square += y[i, j] * y[i, j]
        most = (0.5 if patient and length[i] > _CHORD * chord[i] else 0.9) * tolerance
        failed[i] = 1 if square > most * most else 0
        if failed[i] != 0:
            length[i] *= min(max(math.sqrt(most) / square**0.25, 0.4), 0.8)
            far = True
    return far


def _slopes(t, p, y, i, first, after, found):
    """Write position and two derivatives at a site, of the quartic through five sites of [first, after), to `found` (site, 3, axis)."""
    begin = min(max(i - 2, first), after - 5)
    k, m = (begin if i > begin else begin + 4), (begin + 1 if i != begin + 1 else begin + 4)
    n, o = (begin + 2 if i != begin + 2 else begin + 4), (begin + 3 if i != begin + 3 else begin + 4)
    a, b, c, d = t[k] - t[i], t[m] - t[i], t[n] - t[i], t[o] - t[i]
    for j in range(p.shape[1]):
        here = p[i, j] + y[i, j]
        # Divided differences of the slopes from the site to its neighbours.
        f1, f2 = (p[k, j] - p[i, j] + y[k, j] - y[i, j]) / a, (p[m, j] - p[i, j] + y[m, j] - y[i, j]) / b
        f3, f4 = (p[n, j] - p[i, j] + y[n, j] - y[i, j]) / c, (p[o, j] - p[i, j] + y[o, j] - y[i, j]) / d
        g2, g3, g4 = (f2 - f1) / (b - a), (f3 - f2) / (c - b), (f4 - f3) / (d - c)
        h3, h4 = (g3 - g2) / (c - a), (g4 - g3) / (d - b)
        k4 = (h4 - h3) / (d - a)
        found[i, 0, j] = here
        found[i, 1, j] = f1 - a * g2 + a * b * h3 - a * b * c * k4
        found[i, 2, j] = 2.0 * (g2 - (a + b) * h3 + (a * b + a * c + b * c) * k4)


def _quintic(t, found, i, k, powers):
    """Write the quintic between two sites, in powers of its parameter 0 to 1, to row i of `powers` (site, 6, axis)."""
    h = t[k] - t[i]
    for j in range(found.shape[2]):
        slope, bend, end_slope, end_bend = h * found[i, 1, j], h * h * found[i, 2, j], h * found[k, 1, j], h * h * found[k, 2, j]
        rise = found[k, 0, j] - found[i, 0, j] - slope - 0.5 * bend
        turn, change = end_slope - slope - bend, end_bend - bend
        powers[i, 0, j], powers[i, 1, j], powers[i, 2, j] = found[i, 0, j], slope, 0.5 * bend
        powers[i, 3, j] = 10.0 * rise - 4.0 * turn + 0.5 * change
        powers[i, 4, j] = -15.0 * rise + 7.0 * turn - change
        powers[i, 5, j] = 6.0 * rise - 3.0 * turn + 0.5 * change


def _within(powers, i, low, high, p, row, most, rows, part):
    """Return whether a quintic between two parameters is within a distance of the line from point `row` to the next, and nowhere slow.

    `part` (4, 6) is working memory.
    """
    for c in range(6):
        part[2, c], part[3, c] = 0.0, 0.0
    size, chord = 0.0, 0.0
    for j in range(p.shape[1]):
        for k in range(6):
            part[0, k] = powers[i, k, j]
        for shift in range(5):  # Taylor's shift by Horner's scheme
            for k in range(4, shift - 1, -1):
                part[0, k] += low * part[0, k + 1]
        rise, scale = p[row + 1, j] - p[row, j], 1.0
        for k in range(6):
            part[0, k] *= scale
            scale *= high - low
        part[0, 0] -= p[row, j]
        part[0, 1] -= rise
        for c in range(6):  # the control points of the difference
            part[1, c] = 0.0
            for k in range(c + 1):
                part[1, c] += rows[c, k] * part[0, k]
            part[2, c] += part[1, c] * part[1, c]
        along = part[1, 5] - part[1, 0] + rise
        size, chord = size + rise * rise, chord + along * along
        for c in range(5):  # the control points of the rate, along the chord of the curve
            part[3, c] += (5.0 * (part[1, c + 1] - part[1, c]) + rise) * along
    good = chord >= _SLOWEST * _SLOWEST * size
    for c in range(6):
        good = good and part[2, c] <= most * most and (c == 5 or part[3, c] >= _SLOWEST * math.sqrt(size * chord))
    return good


def _knotted(t, length, fresh, first, last, knot):
    """Mark the sites at which the quintic curves of a run meet, ends included."""
    at, least = first, length[first]
    for i in range(first, last + 1):
        knot[i] = 1 if i in (first, last) else 0
    for i in range(first + 1, last):
        least = min(least, length[i])
        long = t[i] - t[at] >= _SPACING * least and t[last] - t[i] > 0.5 * (t[i] - t[at])
        if fresh[i] != 0 or long:
            knot[i], at, least = 1, i, length[i]


@kernel(
    "f8[:] f8[:,:] f8[:] i8[:] i8[:] f8[:] f8[:,:] f8[:] i8[:] i8[:,:] f8[:] f8[:,:,:,:] "  #
    "f8[:,:] f8[:] f8[:,:] f8[:,:] f8[:,:,:] f8[:,:,:] f8[:,:] i8[:] i8[:]"
)
def fit(
    t, p, chord, fresh, node, node_t, node_p, slack, begin, fixed, tolerance, ends, rows, length, band, y, found, powers, part, knot, failed
):  # fmt: skip
    """Fit each run.

    Parameters
    ----------
    t (n,) [m], p (n, n_axis) [m]
        Sites: arc length and position on the programmed path. Where three sites stay, two lie outside of the run.
    chord (n,) [m]
        Length of the shortest curve around.
    fresh (n,)
        Whether a curve must end here.
    node (n,); node_t (m,), node_p (m, n_axis), slack (m,) [m]
        Number of each site among all nodes; those, with how far the path leaves the line to the next.
    begin (n_run + 1,), fixed (n_run, 2)
        First site of each run; number of sites that stay at both ends: three where direction and curvature stay too, else one.
    tolerance (n_run,) [m], ends (n_run, 2, 3, n_axis)
        Tolerance; position and two derivatives by arc length at both ends.
    rows (6, 6)
        Bezier points by powers.
    length (n,) [m]
        Largest smoothing lengths; lowered.
    band (n, 4), y (n, n_axis), found (n, 3, n_axis), part (4, 6)
        Working memory.
    powers (n, 6, n_axis)
        Output: the quintic from each knot to the next.
    knot, failed (n,)
        Output: whether a site is a knot, and whether the curve around it is outside of the tolerance.
    """
    for run in range(begin.size - 1):
        first, after = begin[run], begin[run + 1]
        free, end = first + fixed[run, 0], after - fixed[run, 1]
        start, last = free - 1, end
        _eased(t, length, failed, 0.0, first, after)
        for turn in range(_ROUNDS if after - first >= 5 else 0):
            _smoothed(t, p, length, first, after, free, end, band, y)
            far = _lowered(y, chord, tolerance[run], length, first, after, turn < _PATIENCE, failed)
            if not far:
                for i in range(start, last + 1):
                    _slopes(t, p, y, i, first, after, found)
                for k in range(3):
                    for j in range(p.shape[1]):
                        found[start, k, j] = ends[run, 0, k, j] if fixed[run, 0] > 1 else found[start, k, j]
                        found[last, k, j] = ends[run, 1, k, j] if fixed[run, 1] > 1 else found[last, k, j]
                _knotted(t, length, fresh, start, last, knot)
                at = start
                for i in range(start + 1, last + 1):
                    if knot[i] == 0:
                        continue
                    _quintic(t, found, at, i, powers)
                    h, good = t[i] - t[at], True
                    for row in range(node[at], node[i]):
                        low, high = (node_t[row] - t[at]) / h, (node_t[row + 1] - t[at]) / h
                        good = good and _within(powers, at, low, high, node_p, row, tolerance[run] - slack[row], rows, part)
                    for k in range(at, i + 1 if not good else at):
                        failed[k], length[k], far = 1, 0.7 * length[k], True
                    at = i
            if not far:
                break
            # Where each change makes the next site fail, more and more of them change at once.
            _eased(t, length, failed, 2.0 ** min(turn - _PATIENCE, 6), first, after)


# --- runs and their sites --------------------------------------------------------------------------------------------------------------


class _Runs(NamedTuple):
    """Stretches of curves, in order: the run (n,), the curve (n,), and from where to where on it (n,) [m]."""

    run: Index
    curve: Index
    low: Array
    high: Array


def _bends(path: Path) -> tuple[Flags, Array]:
    """Return which curves are lines or arcs (n,), and the curvature of each (n,) [1/m]."""
    plain, bend = np.zeros((2, len(path.curves)))
    for batch, numbers in path.kinds:
        if isinstance(batch, Lines | Arcs):
            plain[numbers] = 1.0
        if isinstance(batch, Arcs):
            bend[numbers] = batch.radius * batch.rate**2
    return plain != 0.0, bend


def _runs(route: Route, tolerance: Array, linked: Flags, rest: Flags, bend: Array, turn: Array, kept: Flags) -> _Runs:
    """Return the runs of short curves, with the parts of their neighbours that they use; `kept` curves are not short."""
    span, before = np.diff(route.path.breaks), np.append(False, linked[:-1])

    def part(number: Index, inner: Index, stops: Flags, away: Array, others: Index) -> Array:
        """Return how much each run uses of its first or last curve, which is the neighbour of its short curve `inner`, or that itself."""
        # A neighbour keeps room for the blend at its other end, or for another run.
        room = np.where(away > CORNER_ANGLE, np.clip(8.0 * tolerance / np.maximum(away, CORNER_ANGLE) / span, 0.125, 0.75), 0.125)[number]
        much = np.minimum(np.where(np.isin(number, others), 0.45, 1.0 - room) * span[number], _TAKE * tolerance[number])
        return np.where(number == inner, np.where(stops[inner], 1.0, 0.875) * span[number], much)

    most = np.maximum(np.maximum(turn, np.append(0.0, turn[:-1])), bend * span)
    shortest = np.minimum(np.where(linked, np.roll(span, -1), np.inf), np.where(before, np.roll(span, 1), np.inf))
    short = (linked | before) & (span * most <= 8.0 * tolerance) & (span <= _RATIO * np.maximum(shortest, tolerance)) & ~kept
    joined = short & np.roll(short, -1) & linked
    first = np.flatnonzero(short & ~np.append(False, joined[:-1]))
    last = np.flatnonzero(short & ~joined)
    kinks = np.append(0, np.cumsum(turn > CORNER_ANGLE))
    # With fewer short curves, arcs and lines are a contour of its own. The joints at both ends count too.
    bent = (last - first >= _FEWEST - 1) & (kinks[last + 1] - kinks[first - before[first]] >= 2)
    first, last = first[bent], last[bent]
    begin, end = first - before[first], last + linked[last]
    run = np.repeat(np.arange(first.size), end - begin + 1)
    curve = ranges(begin, end - begin + 1)
    low, high = np.zeros(curve.size), span[curve]
    at = np.cumsum(end - begin + 1)
    low[at - (end - begin + 1)] = span[begin] - part(begin, first, np.roll(rest, 1), np.append(0.0, turn[:-1]), end)
    high[at - 1] = part(end, last, rest, turn, begin)
    return _Runs(run, curve, low, high)


class _Sites(NamedTuple):
    """Places along runs (n,), those before and after each included: run, curve, arc length on the curve [m]."""

    run: Index
    curve: Index
    along: Array


def _sites(path: Path, runs: _Runs, bulge: Array, tolerance: Array, fixed: Index) -> _Sites:
    """Lay sites along runs: on each curve about as many as an arc of its `bulge` (n,) [m] needs, and similar numbers on neighbours."""
    run, curve, low, high = runs
    span, lead, tail = high - low, np.zeros_like(run), np.zeros_like(run)
    lead[np.diff(run, prepend=-1) > 0], tail[np.diff(run, append=-1) != 0] = fixed[:, 0] - 1, fixed[:, 1]
    spacing = span / np.maximum(np.ceil(np.sqrt(8.0 * bulge / tolerance)), 1.0)
    # The spacing rises at most `_GRADE`-fold from curve to curve; other runs are far away.
    step = math.log(_GRADE) * (np.arange(run.size) + 100.0 * run)
    size = np.log(np.maximum(spacing, 0.5 * tolerance))
    size = np.minimum(np.minimum.accumulate(size - step) + step, np.minimum.accumulate((size + step)[::-1])[::-1] - step)
    count = np.maximum(np.ceil(span / np.exp(size) - 1e-9), 1.0).astype(np.int64)
    number = np.repeat(np.arange(run.size), count + lead + tail)
    k = ranges(-lead, count + lead + tail)
    step, behind = span / count, np.diff(path.breaks)[curve] - high
    before, after = np.minimum(k, 0) * np.minimum(step, low / 3.0)[number], np.minimum(step, behind / 3.0)[number]
    within = np.clip(k, 0, count[number])
    return _Sites(run[number], curve[number], low[number] + before + within * step[number] + (k - within - np.minimum(k, 0)) * after)


@kernel("f8[:] i8[:] i8[:,:] f8[:] i8[:]")
def _thinned(t, begin, fixed, least, keep):
    """Mark the places (n,) to keep: at least a distance apart, and the `fixed` ones at the ends of runs."""
    for run in range(begin.size - 1):
        at, last = begin[run], begin[run + 1] - fixed[run, 1]
        for i in range(begin[run], begin[run + 1]):
            inner = begin[run] + fixed[run, 0] <= i < last
            keep[i] = 0 if inner and (t[i] - t[at] < least[run] or t[last] - t[i] < least[run]) else 1
            at = i if keep[i] != 0 else at


def _fit(route: Route, runs: _Runs, bend: Array, turn: Array, tolerance: Array) -> tuple[_Sites, Array, Index, Index, Array]:
    """Fit runs; return sites, their places on the path [m], which are knots, which failed, and the quintic (n, 6, n_axis) from each."""
    path, span, lengths = route.path, runs.high - runs.low, np.diff(route.path.breaks)
    most, of_run = np.maximum(turn, np.append(0.0, turn[:-1]))[runs.curve], tolerance[runs.curve]
    first, last = np.diff(runs.run, prepend=-1) > 0, np.diff(runs.run, append=-1) != 0
    fixed = np.stack([np.where(runs.low[first] > 0.0, 3, 1), np.where((runs.high < lengths[runs.curve])[last], 3, 1)], axis=1)
    all_sites = _sites(path, runs, span * np.maximum(most, bend[runs.curve] * span) / 8.0, of_run, fixed)
    p = np.ascontiguousarray(path.at(all_sites.curve, all_sites.along, 0)[0])
    place = path.breaks[all_sites.curve] + all_sites.along
    begin = np.append(np.flatnonzero(np.diff(all_sites.run, prepend=-1)), place.size)
    keep, within = np.empty(place.size, dtype=np.int64), of_run[np.searchsorted(runs.run, np.arange(begin.size - 1))]
    t = place - place[begin[:-1]][all_sites.run]
    _thinned(t, begin, fixed, 0.5 * within, keep)
    node = np.flatnonzero(keep)
    slack = bend[all_sites.curve] * np.diff(t, append=0.0) ** 2 / 8.0
    sites = _Sites(all_sites.run[node], all_sites.curve[node], all_sites.along[node])
    begin = np.append(0, np.cumsum(keep))[begin]
    edges = np.stack([begin[:-1] + fixed[:, 0] - 1, begin[1:] - fixed[:, 1]])
    ends = path.at(sites.curve[edges].ravel(), sites.along[edges].ravel(), 2).reshape(3, 2, begin.size - 1, -1).transpose(2, 1, 0, 3).copy()
    n, n_axis, at, chord = node.size, path.n_axis, t[node], lengths[sites.curve]
    chord = np.where(sites.along == 0.0, np.minimum(chord, np.roll(chord, 1)), chord)
    gap = np.diff(at, append=0.0)
    length = np.minimum(_STIFF * np.where(gap > 0.0, gap, np.inf), (at[begin[1:] - 1] / 3.0)[sites.run])
    fresh = (route.feedrate[sites.curve] != np.roll(route.feedrate[sites.curve], 1)).astype(np.int64)
    powers, knot, failed = np.empty((n, 6, n_axis)), np.zeros(n, dtype=np.int64), np.ones(n, dtype=np.int64)
    memory = np.empty((n, 4)), np.empty((n, n_axis)), np.empty((n, 3, n_axis)), powers, np.empty((4, 6))
    fit(at, p[node], chord, fresh, node, t, p, slack, begin, fixed, within, ends, _BEZIER, length, *memory, knot, failed)
    return sites, place[node], knot, failed, powers


def fitted(route: Route) -> Route:
    """Fit curves to the runs of short lines and arcs of a route; return the route itself where there are none.

    The tolerance is that of corners, or of merging if this is less.
    """
    path, tolerance = route.path, np.minimum(route.corner_tolerance, route.merge_tolerance)
    if not tolerance.any():
        return route
    plain, bend = _bends(path)
    usable = plain & ~route.rapid & (tolerance > 0.0)
    rest = (route.dwell > 0.0) | route.exact_stop | (route.rapid != np.roll(route.rapid, -1))
    rest[-1] |= not path.closed
    linked = usable & np.roll(usable, -1) & ~rest & (tolerance == np.roll(tolerance, -1))
    linked[-1] = False
    turn = np.where(linked, angle_between(path.ends[1], np.roll(path.starts[1], -1, axis=0)), 0.0)
    kept = ~usable
    for _ in range(_AGAIN):
        runs = _runs(route, tolerance, linked, rest, bend, turn, kept)
        if not runs.run.size:
            return route
        sites, place, knot, failed, powers = _fit(route, runs, bend, turn, tolerance)
        lost = sites.curve[failed != 0]
        if not lost.size:
            break
        kept[lost] = kept[np.maximum(lost - 1, 0)] = True
    good = np.bincount(sites.run, failed) == 0
    at = np.flatnonzero((knot != 0) & good[sites.run])
    if not at.size:
        return route
    run, used = sites.run[at], np.flatnonzero(good[runs.run])
    here, first, last = np.flatnonzero(run[:-1] == run[1:]), np.diff(run, prepend=-1) > 0, np.diff(run, append=-1) != 0
    # What stays of each curve: nothing of those within runs, one end of those where a run begins or ends.
    span, head, tail = np.diff(path.breaks), at[first], at[last]
    low, high, start, end = np.zeros_like(span), span.copy(), path.starts[0].copy(), path.ends[0].copy()
    low[sites.curve[tail]], start[sites.curve[tail]] = sites.along[tail], path.at(sites.curve[tail], sites.along[tail], 0)[0]
    high[np.setdiff1d(runs.curve[used], sites.curve[tail])] = 0.0
    high[sites.curve[head]], end[sites.curve[head]] = sites.along[head], powers[head, 0]
    a, b = at[here], at[here + 1]
    # The last piece of a run without a neighbour ends in the stop of the last curve; the first curve has none.
    stops = sites.along[b] >= span[sites.curve[b]]
    pieces = Quintics(powers[a], place[a], place[b], sites.curve[a], sites.curve[np.where(stops, b, at[np.searchsorted(run, run[here])])])
    return replaced(route, pieces, low, high, start, end)


# --- quintic curves in place of parts of a route ---------------------------------------------------------------------------------------


class Quintics(NamedTuple):
    """Quintic curves (n,) in the order of travel, each in place of a stretch of a path.

    coefficients : ndarray (n, 6, n_axis) [m]
        Of the powers of the parameter, 0 to 1.
    begin, end : ndarray (n,) [m]
        The stretch.
    data, joint : ndarray (n,) of int
        The curve whose feedrate it has, and the one whose tolerances and stops.
    """

    coefficients: Array
    begin: Array
    end: Array
    data: Index
    joint: Index


def replaced(route: Route, quintics: Quintics, low: Array, high: Array, start: Array, end: Array) -> Route:
    """Return a route with quintic curves in place of the parts of its curves that do not stay.

    Parameters
    ----------
    low, high : ndarray (n_curve,) [m]
        From where to where each curve stays; nothing of it where they are equal.
    start, end : ndarray (n_curve, n_axis) [m]
        These places, as the quintic curves have them, so that rounding opens no gap.
    """
    made, piece = blends(quintics.coefficients)
    rounds = Curves.of(made).batches[0]
    # The parts of a divided quintic start in proportion to their lengths.
    done = np.cumsum(rounds.length) - rounds.length
    share = (done - done[np.searchsorted(piece, piece)]) / np.bincount(piece, weights=rounds.length)[piece]
    begin = quintics.begin[piece] + (quintics.end - quintics.begin)[piece] * share
    last = np.diff(piece, append=-1) != 0
    return spliced(route, [(rounds, begin)], (quintics.data[piece], quintics.joint[piece], last), (low, high, start, end))[0]


STAYS = 1e-9
"""Part of a curve that is nothing."""


def spliced(
    route: Route, rounds: Sequence[tuple[CurveBatch, Array]], of_each: tuple[Index, Index, Flags], stays: tuple[Array, Array, Array, Array]
) -> tuple[Route, Index]:
    """Return a route with curves in place of the parts of its own that do not stay.

    Parameters
    ----------
    rounds : sequence of tuples
        Batches of curves, and where on the path each of their curves begins (n,) [m].
    of_each : tuple
        Their `data` and `joint`, as of `Quintics`, and whether each is the last before that joint, all (n,).
    stays : tuple
        `low`, `high`, `start` and `end`, as for `replaced`.

    Returns
    -------
    route : Route
    source : ndarray (n_curve,) of int
        For each curve of the route its number among the old curves or, after these, among the `rounds`.
    """
    path, span, (low, high, start, end) = route.path, np.diff(route.path.breaks), stays
    stay = high - low > STAYS * span
    cut, kept, place = stay & ((low > 0.0) | (high < span)), np.flatnonzero(stay), path.breaks[:-1] + low
    parts = [*rounds, *path.curves.parts(np.where(stay & ~cut, place, -1.0))]
    for batch, numbers in path.kinds:
        some = np.flatnonzero(cut[numbers])
        i = numbers[some]
        if isinstance(batch, Lines):
            parts.append((Lines.between(start[i], np.where((high < span)[i, None], end[i], batch.end.T[some])), place[i]))
        elif some.size:
            parts.append((type(batch)([path.curves[k].part(low[k], high[k]) for k in i.tolist()]), place[i]))
    planned, places = Path(Curves(parts), path.closed), np.concatenate([place[kept], *(begin for _, begin in rounds)])
    order = np.argsort(places, kind="stable")
    places = places[order]
    between = Correspondence(planned.breaks, np.append(places, places[0] + path.length if path.closed else path.length))
    data, joint, ends = (np.concatenate([old, own])[order] for old, own in zip((kept, kept, kept >= 0), of_each, strict=True))
    changed = replace(
        route,
        path=planned,
        correspondence=between if route.correspondence is None else route.correspondence.after(between),
        **{name: getattr(route, name)[data] for name in ("feedrate", "rapid")},
        **{name: getattr(route, name)[joint] for name in ("corner_tolerance", "merge_tolerance")},
        **{name: getattr(route, name)[joint] * ends for name in ("dwell", "exact_stop")},
    )
    return changed, np.concatenate([kept, np.arange(span.size, span.size + data.size - kept.size)])[order]
