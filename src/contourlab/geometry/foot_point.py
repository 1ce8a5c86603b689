"""The exact foot point: the closest point of a path, searched independently for each sample.

In a window around the progress of a sample, each leaf in reach gives its closest point. A leaf is a line or a flat arc, with a closed form,
a blend, or a piece of the table of another curve: half the slope of the squared distance from these quintic curves is a polynomial, whose
zeros are isolated one by one, then found by Halley's steps; the curve itself ends the search on a piece. The foot point is the nearest of
these; ties go to the one nearest to the progress, which selects the right branch where a path crosses itself.

Distances to junctions alone find the leaves in reach. A part of the path with length L, whose ends lie d and e from the point, is nowhere
closer than (d + e - L) / 2. It is excluded if something is closer. The search halves parts until single leaves remain: a few out of
thousands, after some tens of distances.

Samples in succession share such a list. Each leaf of it, and all that is left out, is as far from a sample as it was from an earlier one,
less what the samples have travelled since. So most samples try one leaf. What they find does not depend on the samples before.
"""

# mypy: disable-error-code="no-untyped-def, no-untyped-call"
from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Index
from contourlab.errors import GeometryError, refuse
from contourlab.geometry.blend import Blends, by_length, series
from contourlab.geometry.curve import CurveSequence, interval
from contourlab.geometry.line_and_arc import Arcs, Lines
from contourlab.geometry.table import table_pieces
from contourlab.native.kernel import kernel
from contourlab.threads import in_threads

_LINE, _ARC, _BLEND, _OTHER = range(4)
_DEPTH = 128
_SLACK = 1e-9
"""Error of arc lengths and distances [m]."""
_TABLE_SLACK = 1e-8
"""More than the error of the table [m]."""
_AHEAD = 12.0
"""Steps from sample to sample that a list of leaves lasts, about."""
_MOST_STEPS = 60
_MOST_LISTED, _MOST_TRIED, _FARTHEST = 64, 32, 1e5
"""A list ends after the sample for which it has more leaves, or which tried more, and after more travel [m], whose rounding would count."""
_BERNSTEIN = tuple(1.0 / math.comb(9, power) for power in range(10))
_SQUARE = 1e-16
"""Square of the last Newton step, relative to the length of the piece [m]: what is left is about the square over the length."""


class _Leaves(NamedTuple):
    """The leaves of a path, in the order of the kernel's arguments.

    Attributes
    ----------
    closed, length, breaks
        Of the path.
    tangents : ndarray (n_curve, 2, n_axis)
        At both ends of each curve.
    start, along : ndarray (n + 1,) [m]
        Arc length of the starts of the leaves and of the end, and the same with the gaps between curves.
    corner : ndarray (n + 1, n_axis) [m]
        Where they are.
    leaf : ndarray (n, 3) of int
        Curve, kind, and number within the kind.
    lines, arcs, coefficients, borders, inverse, arc : ndarray
        What defines the curves of each kind.
    quintics : ndarray (n_quintic, n_axis, 6) [m]
        Powers of u, 0 to 1, of blends, then of the pieces of the table.
    rates : ndarray (n_quintic, 10) [m^2]
        Powers of u in r' (r - r(0)), half the rate at which the squared distance from the start grows.
    """

    closed: int
    length: float
    breaks: Array
    tangents: Array
    start: Array
    along: Array
    corner: Array
    leaf: Index
    lines: Array
    arcs: Array
    coefficients: Array
    borders: Array
    inverse: Array
    arc: Array
    quintics: Array
    rates: Array


def _leaves(path: CurveSequence) -> _Leaves:
    """Return the leaves of a path, which keeps them."""
    if "_leaves" in path.__dict__:
        return path.__dict__["_leaves"]  # type: ignore[no-any-return]
    m, axes = len(path.curves), path.n_axis
    kind, slot = np.full(m, _OTHER), np.zeros(m, dtype=np.int64)
    lines, arcs = np.zeros((1, 2, axes)), np.zeros((1, 4 + 3 * axes))
    shape: tuple[Array, ...] = (np.zeros((1, 6, axes)), np.zeros((1, 5)), np.zeros((1, 4, 1)), np.zeros((1, 4, 1)))
    for batch, numbers in path.kinds:
        slot[numbers] = np.arange(numbers.size)
        if isinstance(batch, Lines):
            kind[numbers], lines = _LINE, np.stack([batch.start.T, batch.direction.T], axis=1).copy()
        elif isinstance(batch, Arcs):
            kind[numbers[batch.direct]] = _ARC
            each = (batch.radius, batch.start_angle, batch.rate, batch.length, *batch.centre, *batch.u, *batch.v)
            arcs = np.column_stack(each)
        elif isinstance(batch, Blends):
            kind[numbers], shape = _BLEND, (*batch.shape, batch.arc)
    direct = kind <= _BLEND
    owner, start, corner, quintics = np.arange(m), path.breaks, path.junctions[0][:-1], shape[0].transpose(0, 2, 1).copy()
    if not direct.all():
        owner, begin, coefficients, _ = table_pieces(path, 1e-9 * min(path.length, 1.0))
        kept = np.flatnonzero(~direct[owner] | (np.diff(owner, prepend=-1) > 0))
        owner, start = owner[kept], np.append(begin[kept], path.length)
        corner = np.where(direct[owner, None], corner[owner], coefficients[kept, :, 0])
        pieces = coefficients[kept] * np.diff(start)[:, None, None] ** np.arange(6.0)
        quintics = np.concatenate([quintics, pieces])
    rates = np.zeros((10, len(quintics)))
    for c in quintics.transpose(1, 2, 0).copy():
        for a, b in np.ndindex(5, 5):
            rates[a + b + 1] += (a + 1) * c[a + 1] * c[b + 1]
    junctions, along = path.junctions
    number = np.where(direct[owner], slot[owner], np.arange(owner.size) + len(shape[0]))
    path.__dict__["_leaves"] = leaves = _Leaves(
        int(path.closed),
        path.length,
        path.breaks,
        np.stack([path.starts[1], path.ends[1]], axis=1).copy(),
        start,
        np.append(along[owner] + start[:-1] - path.breaks[owner], along[-1]),
        np.concatenate([corner, junctions[-1:]]),
        np.column_stack([owner, kind[owner], number]),
        *(lines, arcs, *shape, quintics, rates.T.copy()),
    )
    return leaves


def _number(start, length, closed, s, hint):
    """Return the leaf of an arc length, counted over laps; `hint` is one that may be near."""
    lap = math.floor(s / length) if closed else 0
    return interval(start, s - lap * length, hint) + lap * (start.size - 1)


def _away(corner, closed, points, i, k):
    """Return the distance of a point from the start of leaf k."""
    n = corner.shape[0] - 1
    at = k % n if closed else k
    square = 0.0
    for j in range(points.shape[1]):
        square += (points[i, j] - corner[at, j]) ** 2
    return math.sqrt(square)


def _up_to(along, closed, k):
    """Return the length of the path up to the start of leaf k, laps included."""
    n = along.size - 1
    return (k // n) * along[n] + along[k % n] if closed else along[k]


def _least(along, closed, a, b, from_a, from_b):
    """Return a lower bound of the distance of leaves a to b - 1 from a point, given its distances to their ends."""
    return 0.5 * (from_a + from_b - (_up_to(along, closed, b) - _up_to(along, closed, a)))


def _on_line(points, i, lines, k, low, high):
    """Return the arc length of the closest point of a line, and the squared distance."""
    s, square = 0.0, 0.0
    for j in range(points.shape[1]):
        s += (points[i, j] - lines[k, 0, j]) * lines[k, 1, j]
    s = min(max(s, low), high)
    for j in range(points.shape[1]):
        square += (points[i, j] - (lines[k, 0, j] + s * lines[k, 1, j])) ** 2
    return s, square


def _arc_at(arcs, k, s, spot, column):
    """Write the point and the tangent of a flat arc to a column of `spot`."""
    axes = spot.shape[1]
    angle = arcs[k, 1] + arcs[k, 2] * s
    c, d = arcs[k, 0] * math.cos(angle), arcs[k, 0] * math.sin(angle)
    for j in range(axes):
        u, v = arcs[k, 4 + axes + j], arcs[k, 4 + 2 * axes + j]
        spot[0, j, column], spot[1, j, column] = c * u + d * v + arcs[k, 4 + j], arcs[k, 2] * (c * v - d * u)


def _gap(points, i, spot, column):
    """Return the squared distance of a point from the place in a column of `spot`."""
    square = 0.0
    for j in range(points.shape[1]):
        square += (points[i, j] - spot[0, j, column]) ** 2
    return square


def _on_arc(points, i, arcs, k, low, high, middle, spot, column):
    """Find the closest point of a flat arc: on the spoke through the point, in the turn nearest to the progress, or else the nearer end."""
    x, y, axes = 0.0, 0.0, points.shape[1]
    for j in range(axes):
        out = points[i, j] - arcs[k, 4 + j]
        x, y = x + out * arcs[k, 4 + axes + j], y + out * arcs[k, 4 + 2 * axes + j]
    turn = 2.0 * math.pi / abs(arcs[k, 2])
    # All points of the arc are equally far from the centre.
    s = middle if math.hypot(x, y) <= 1e-13 * arcs[k, 0] else (math.atan2(y, x) - arcs[k, 1]) / arcs[k, 2]
    s += turn * np.rint((middle - s) / turn)
    # The turn nearest to the progress may lie outside while a neighbour lies inside.
    if s < low <= s + turn <= high:
        s += turn
    elif s > high >= s - turn >= low:
        s -= turn
    if not low <= s <= high:
        _arc_at(arcs, k, low, spot, column)
        square = _gap(points, i, spot, column)
        _arc_at(arcs, k, high, spot, column)
        s = low if square <= _gap(points, i, spot, column) else high
    _arc_at(arcs, k, s, spot, column)
    return s


def _compared(square, away, least, aside):
    """Return whether a place is as near as the nearest so far but for rounding, and whether it wins: nearer, or as near and less aside."""
    level = square <= least * (1.0 + 1e-12) + 1e-30 and least <= square * (1.0 + 1e-12) + 1e-30
    return level, away < aside if level else square < least


def _on_quintic(quintics, k, u, spot, column):
    """Write the point and the tangent of a quintic curve at a parameter to a column of `spot`."""
    axes, square = spot.shape[1], 0.0
    for j in range(axes):
        c1, c2, c3, c4, c5 = quintics[k, j, 1], quintics[k, j, 2], quintics[k, j, 3], quintics[k, j, 4], quintics[k, j, 5]
        spot[0, j, column] = quintics[k, j, 0] + u * (c1 + u * (c2 + u * (c3 + u * (c4 + u * c5))))
        spot[1, j, column] = c1 + u * (2.0 * c2 + u * (3.0 * c3 + u * (4.0 * c4 + u * 5.0 * c5)))
        square += spot[1, j, column] ** 2
    for j in range(axes):
        spot[1, j, column] /= math.sqrt(square)


def _zero(powers, form, a, b):
    """Return the zero between a and b of a polynomial of degree 9, of which `form` is Bernstein's form there; it rises through zero."""
    width, rise = b - a, form[9] - form[0]
    h = -form[0] / rise
    # Hermite's cubic through both ends, of the place over the value.
    h += h * (1.0 - h) * ((1.0 - h) * (rise / (9.0 * (form[1] - form[0])) - 1.0) - h * (rise / (9.0 * (form[9] - form[8])) - 1.0))
    h = min(max(a + width * h, a), b)
    for _ in range(_MOST_STEPS):
        value, bend, third = 0.0, 0.0, 0.0
        for power in range(9, -1, -1):
            value, bend, third = value * h + powers[power], bend * h + value, third * h + bend
        a, b, turn = h if value < 0.0 else a, h if value > 0.0 else b, value * third / bend
        # Halley's step, which about cubes the error; where its correction is large, Newton's.
        after = h - value / (bend - turn if abs(turn) < 0.5 * bend else bend) if bend > 0.0 else math.inf
        after = after if a <= after <= b else 0.5 * (a + b)
        moved, h = abs(after - h), after
        if moved * moved <= 1e-10:
            break
    return h


def _minima(points, i, quintics, rates, k, forms, found):
    """Write the parameters of a quintic curve at which a point is nearest to it, ends included; return how many there are.

    Half the slope of the squared distance is a polynomial. Bernstein's form of it has at least as many changes of sign as there are zeros,
    and just one where there is one zero. An interval with more is halved (Lane and Riesenfeld, Bounds on a polynomial, BIT 21, 1981).
    """
    for power in range(10):
        forms[0, power] = rates[k, power]
    for j in range(points.shape[1]):
        gap = quintics[k, j, 0] - points[i, j]
        for power in range(5):
            forms[0, power] += (power + 1.0) * quintics[k, j, power + 1] * gap
    for power in range(10):
        forms[1, power] = forms[0, power] * _BERNSTEIN[power]
    for shift in range(1, 10):
        for power in range(9, shift - 1, -1):
            forms[1, power] += forms[1, power - 1]
    count, top = 0, 2
    forms[1, 10], forms[1, 11] = 0.0, 1.0
    for end in range(2):
        if (forms[1, 0] >= 0.0) if end == 0 else (forms[1, 9] <= 0.0):
            found[count], count = end, count + 1
    while top > 1 and count < found.size:  # more can only be rounding, from the centre of a circle
        top, changes = top - 1, 0
        for power in range(9):
            changes += 1 if (forms[top, power] < 0.0) != (forms[top, power + 1] < 0.0) else 0
        a, b = forms[top, 10], forms[top, 11]
        if changes > 1 and b - a > 1e-6:
            for shift in range(10):  # de Casteljau's halves: the second stays in place
                forms[top + 1, shift] = forms[top, 0]
                for power in range(9 - shift):
                    forms[top, power] = 0.5 * (forms[top, power] + forms[top, power + 1])
            forms[top, 10], forms[top + 1, 10], forms[top + 1, 11] = 0.5 * (a + b), a, 0.5 * (a + b)
            top += 2
        elif forms[top, 0] < 0.0 <= forms[top, 9]:
            found[count], count = _zero(forms[0], forms[top], a, b), count + 1
    return count


def _on_leaf(
    points, i, kind, k, low, high, middle, span,
    lines, arcs, coefficients, borders, inverse, arc, quintics, rates, forms, minima, spot, column,
):  # fmt: skip
    """Find the closest point of a line, flat arc or blend; write it to a column of `spot`, except of a line.

    Return its arc length, the squared distance, and whether what the window hides may be nearer.
    """
    if kind == _LINE:
        s, square = _on_line(points, i, lines, k, low, high)
        return s, square, s <= low > 0.0 or s >= high < span
    if kind == _ARC:
        s = _on_arc(points, i, arcs, k, low, high, min(max(middle, low), high), spot, column)
        return s, _gap(points, i, spot, column), not low < s < high
    count, best, least, aside = _minima(points, i, quintics, rates, k, forms, minima), 0, math.inf, math.inf
    s, square, hides = 0.0, 0.0, False
    for turn in range(count + 1 if count > 1 else 1):  # in the end the nearest again
        u = minima[best if turn == count else turn]
        quarter = min(int(4.0 * u), 3)
        s = 0.0 if u <= 0.0 else span if u >= 1.0 else borders[k, quarter] + series(arc[k], quarter, 8.0 * u - 2.0 * quarter - 1.0)
        _on_quintic(quintics, k, u, spot, column)
        if not low <= s <= high:  # what the window hides stands for its end
            s, hides = min(max(s, low), high), True
            by_length(k, s, 1, coefficients, borders, inverse, spot, column)
        square = _gap(points, i, spot, column)
        if _compared(square, abs(s - middle), least, aside)[1]:
            best, aside = turn, abs(s - middle)
        least = min(least, square)
    return s, square, hides


_SIGNATURE = (
    "f8[:,:] f8[:] f8[:] i8 f8 f8[:] f8[:,:,:] f8[:] f8[:] f8[:,:] i8[:,:] f8[:,:,:] f8[:,:] f8[:,:,:] f8[:,:] f8[:,:,:] f8[:,:,:] "
    "f8[:,:,:] f8[:,:] f8[:] f8[:,:] f8[:] f8[:] i8[:,:] f8[:,:] i8[:] i8[:,:] f8[:,:] f8[:,:,:] i8[:,:] f8[:] f8[:,:] f8[:]"
)


@kernel(_SIGNATURE)
def search(
    points, around, window, closed, length, breaks, tangents, start, along, corner, leaf, lines, arcs, coefficients, borders, inverse, arc,
    quintics, rates, place, foot, distance, signed, pairs, guess, state, ends, depths, spot, near, close, forms, minima,
):  # fmt: skip
    """Find foot points from sample state[0] on: `place`, `foot`, `distance`, `signed`.

    Closest points of other curves than lines, flat arcs and blends go to `pairs` (sample, curve) and `guess` (lap, arc length, bracket,
    distance, length of the piece). `state` is set to the next sample, the number of pairs, and the number of leaves searched.
    """
    axes, n, count, i, hint = points.shape[1], leaf.shape[0], 0, state[0], 0
    listed, travel, beyond, low_end, high_end, bound, best_at, lead, column = 0, 0.0, 0.0, math.inf, -math.inf, math.inf, math.inf, 0, 0
    tried, others, on, won, won_at, c, kind, k, offset, span = 0, 0.0, 0, -1, 0.0, 0, 0, 0, 0.0, 0.0
    slack = min(_SLACK, 0.125 * length)  # a list has at most 2.25 laps
    while i < points.shape[0]:
        begun, least, aside, best, step = count, math.inf, math.inf, math.inf, 0.0
        first, last = around[i] - window[i], around[i] + window[i]
        if closed:  # half a lap on either side is the whole path
            first, last = max(first, around[i] - 0.5 * length), min(last, around[i] + 0.5 * length)
        else:
            first, last = min(max(first, 0.0), length), min(max(last, 0.0), length)
        for j in range(axes if i > state[0] else 0):
            step += (points[i, j] - points[i - 1, j]) ** 2
        step = math.sqrt(step)
        travel += step
        # The foot point of the sample before is not further away than this.
        bound = bound + step if first <= best_at <= last else math.inf
        inside = low_end <= first and last <= high_end and travel <= _FARTHEST
        alone = inside and bound - step < others - travel
        if alone:  # all but the leaf of the sample before may be further away
            state[2] += 1
            won_at, square, _ = _on_leaf(
                points, i, kind, k, min(max(first - offset, 0.0), span), min(max(last - offset, 0.0), span), around[i] - offset, span,
                lines, arcs, coefficients, borders, inverse, arc, quintics, rates, forms, minima, spot, column,
            )  # fmt: skip
            alone = math.sqrt(square) + _SLACK < others - travel
        if not alone:
            on, won = 0, -1
            if not (inside and bound <= beyond - travel and tried <= _MOST_TRIED):
                before = near[lead, 0] if listed else -1
                room = min(_AHEAD * step, window[i], 0.5 * length)
                if before < 0 or step >= start[before + 1] - start[before]:
                    room = 0.0  # so many leaves would be listed that a list for each sample takes less
                low_end, high_end = first - room - slack, last + room + slack
                if not closed:
                    low_end, high_end = max(low_end, 0.0), min(high_end, length)
                listed, travel, beyond, top, lead = 0, 0.0, math.inf, 1, 0
                ends[0, 0] = _number(start, length, closed, low_end, hint)
                hint = ends[0, 0] % n
                ends[0, 1] = _number(start, length, closed, high_end, hint) + 1
                depths[0, 0], depths[0, 1] = _away(corner, closed, points, i, ends[0, 0]), _away(corner, closed, points, i, ends[0, 1])
                depths[0, 2] = _least(along, closed, ends[0, 0], ends[0, 1], depths[0, 0], depths[0, 1])
                while top:
                    top -= 1
                    a, b = ends[top, 0], ends[top, 1]
                    from_a, from_b, lower = depths[top, 0], depths[top, 1], depths[top, 2]
                    if lower > bound + room:
                        beyond = min(beyond, lower)
                        continue
                    if b - a == 1:
                        lap = a // n if closed else 0
                        near[listed, 0], near[listed, 1], close[listed] = a - lap * n, lap, lower
                        listed += 1
                        room = 0.0 if listed >= _MOST_LISTED else room
                        continue
                    middle = (a + b) // 2
                    away = _away(corner, closed, points, i, middle)
                    lap = middle // n if closed else 0
                    if first <= lap * length + start[middle - lap * n] <= last:
                        # A junction in the window lies on the path: the closest point is not further away.
                        bound = min(bound, away + _SLACK)
                    ends[top, 0], ends[top, 1] = middle, b
                    depths[top, 0], depths[top, 1], depths[top, 2] = away, from_b, _least(along, closed, middle, b, away, from_b)
                    ends[top + 1, 0], ends[top + 1, 1] = a, middle
                    depths[top + 1, 0], depths[top + 1, 1], depths[top + 1, 2] = (
                        from_a,
                        away,
                        _least(along, closed, a, middle, from_a, away),
                    )
                    top += 2
                # The first were listed before the bound was known.
                kept, lead = 0, 0
                for e in range(listed):
                    if close[e] > bound + room:
                        beyond = min(beyond, close[e])
                        continue
                    near[kept, 0], near[kept, 1], close[kept] = near[e, 0], near[e, 1], close[e]
                    lead = kept if near[e, 0] == before else lead
                    kept += 1
                listed = kept
            tried = state[2]
            for again in range(2):
                ties = False
                for turn in range(listed):
                    # The leaf of the sample before comes first: most others are further away than its closest point.
                    e = turn if again else lead if turn == 0 else turn - 1 if turn <= lead else turn
                    at, lap = near[e, 0], near[e, 1]
                    behind = lap * length + start[at + 1] <= first and (closed or at < n - 1)
                    if close[e] - travel > bound or lap * length + start[at] > last or behind:
                        continue
                    state[2] += 1
                    c, kind, k = leaf[at, 0], leaf[at, 1], leaf[at, 2]
                    offset, span = lap * length + breaks[c], breaks[c + 1] - breaks[c]
                    low, high = min(max(first - offset, 0.0), span), min(max(last - offset, 0.0), span)
                    if kind != _OTHER:
                        s, square, hides = _on_leaf(
                            points, i, kind, k, low, high, around[i] - offset, span,
                            lines, arcs, coefficients, borders, inverse, arc, quintics, rates, forms, minima, spot, 1 - column,
                        )  # fmt: skip
                        away, clear = abs(offset + s - around[i]), math.sqrt(square)
                        level, wins = _compared(square, away, least, aside)
                        ties = ties or level
                        if wins:
                            aside, won, won_at, column, bound = away, e, s, 1 - column, min(bound, clear + _SLACK)
                        least = min(least, square)
                        close[e] = max(close[e], clear - (span - (high - low) if hides else 0.0) + travel)
                        continue
                    begin, size, clear, hides = start[at] - breaks[c], start[at + 1] - start[at], math.inf, False
                    low, high = max(low, begin), min(high, begin + size)
                    for number in range(_minima(points, i, quintics, rates, k, forms, minima)):
                        s = min(max(begin + size * minima[number], low), high)
                        hides = hides or s != begin + size * minima[number]
                        _on_quintic(quintics, k, (s - begin) / size, spot, 1 - column)
                        away = math.sqrt(_gap(points, i, spot, 1 - column))
                        clear, across = min(clear, away), 0.0
                        for j in range(axes if max(first - offset, 0.0) < s < min(last - offset, span) else 0):
                            across += spot[1, j, 1 - column] * (points[i, j] - spot[0, j, 1 - column])
                        # Two pieces may each see their common end just beyond the closest point: one candidate too many does no harm.
                        if away > bound + _TABLE_SLACK or abs(across) > 2e-9 * away + 1e-13:
                            continue
                        if count == pairs.shape[0]:
                            state[0], state[1] = i, begun
                            return
                        pairs[count, 0], pairs[count, 1] = i, c
                        guess[count, 0], guess[count, 1], guess[count, 4], guess[count, 5] = lap, s, away, size
                        # A closest point at the end of a piece may lie just beyond it.
                        guess[count, 2] = max(low - 1e-7 * length, first - offset, 0.0)
                        guess[count, 3] = min(high + 1e-7 * length, last - offset, span)
                        count += 1
                        if away + _TABLE_SLACK < best:
                            best, best_at, on, bound = away + _TABLE_SLACK, offset + s, e, min(bound, away + _TABLE_SLACK)
                    close[e] = max(close[e], clear - _TABLE_SLACK - (size - (high - low) if hides else 0.0) + travel)
                if again or not (ties or count > begun + 1):
                    break
                # Where several points are nearest, their order decides: it must not depend on the samples before.
                count, least, aside, won = begun, math.inf, math.inf, -1
            tried = state[2] - tried
            kept = begun
            for pair in range(begun, count):
                if guess[pair, 4] <= bound + _TABLE_SLACK:
                    pairs[kept, 1] = pairs[pair, 1]
                    pairs[kept, 0] = i
                    for j in range(6):
                        guess[kept, j] = guess[pair, j]
                    kept += 1
            count = kept
            others = beyond if won >= 0 else 0.0
            for e in range(listed):
                others = min(others, close[e] if e != won else math.inf)
            if won >= 0:
                at, lap = near[won, 0], near[won, 1]
                c, kind, k = leaf[at, 0], leaf[at, 1], leaf[at, 2]
                offset, span = lap * length + breaks[c], breaks[c + 1] - breaks[c]
        place[i], distance[i], signed[i] = math.inf, math.inf, math.nan
        if won >= 0:
            square = 0.0
            for j in range(axes):
                if kind == _LINE:
                    spot[0, j, column], spot[1, j, column] = lines[k, 0, j] + won_at * lines[k, 1, j], lines[k, 1, j]
                gap = points[i, j] - spot[0, j, column]
                foot[i, j], square = spot[0, j, column], square + gap * gap
            place[i], distance[i] = offset + won_at, math.sqrt(square)
            if axes == 2:
                m, t_0, t_1 = breaks.size - 1, spot[1, 0, column], spot[1, 1, column]
                # At a corner the bisector decides the side.
                if won_at >= span and (closed or c + 1 < m):
                    t_0, t_1 = t_0 + tangents[(c + 1) % m, 0, 0], t_1 + tangents[(c + 1) % m, 0, 1]
                if won_at <= 0.0 and (closed or c > 0):
                    t_0, t_1 = t_0 + tangents[(c - 1) % m, 1, 0], t_1 + tangents[(c - 1) % m, 1, 1]
                across = t_0 * (points[i, 1] - foot[i, 1]) - t_1 * (points[i, 0] - foot[i, 0])
                signed[i] = math.copysign(distance[i], across)
            if distance[i] + _SLACK < best:
                best, best_at, on = distance[i] + _SLACK, place[i], won
        bound, lead = best, on
        i += 1
    state[0], state[1] = i, count


@kernel("f8[:,:] f8[:] i8 f8 f8[:] f8[:] i8[:,:] f8[:,:,:] f8[:,:] f8[:,:,:] f8[:,:] f8[:,:,:] f8[:,:,:] f8[:,:,:] f8[:]")
def _gaps(points, along, closed, length, breaks, start, leaf, lines, arcs, coefficients, borders, inverse, quintics, spot, gap):
    """Write the distance of each point from the place of the path at an arc length; a table stands for curves without a closed form."""
    at = 0
    for i in range(along.size):
        s = along[i] - math.floor(along[i] / length) * length if closed else min(max(along[i], 0.0), length)
        at = interval(start, s, at)
        c, kind, k = leaf[at, 0], leaf[at, 1], leaf[at, 2]
        if kind == _LINE:
            _, square = _on_line(points, i, lines, k, s - breaks[c], s - breaks[c])
        else:
            if kind == _OTHER:
                _on_quintic(quintics, k, (s - start[at]) / (start[at + 1] - start[at]), spot, 0)
            elif kind == _ARC:
                _arc_at(arcs, k, s - breaks[c], spot, 0)
            else:
                by_length(k, s - breaks[c], 0, coefficients, borders, inverse, spot, 0)
            square = _gap(points, i, spot, 0)
        gap[i] = math.sqrt(square)


CHUNK = 1 << 15


class FootPoint(NamedTuple):
    """Closest points of a path.

    Attributes
    ----------
    arc_length : ndarray (n,) [m]
        In the lap of the given progress.
    position : ndarray (n, n_axis) [m]
    distance : ndarray (n,) [m]
    signed : ndarray (n,) [m]
        Positive to the left of the direction of travel; NaN unless the path is planar. At a corner the bisector decides the side.
    """

    arc_length: Array
    position: Array
    distance: Array
    signed: Array


def foot_point(path: CurveSequence, points: ArrayLike, around: ArrayLike, window: ArrayLike) -> FootPoint:
    """Return the closest point of the path to each point, within `window` of a given progress.

    Parameters
    ----------
    points : array_like (n, n_axis) [m]
    around : array_like (n,) [m]
        Progress along the path; on a closed path it may count laps.
    window : float or array_like (n,) [m], > 0
        Largest distance of the foot point from the progress.

    Returns
    -------
    FootPoint
        Arc lengths accurate to 1e-12 of the path's length.

    Raises
    ------
    GeometryError
        If shapes do not fit, the window is not positive, or a point is not finite.
    """
    p, s = np.atleast_2d(np.asarray(points, dtype=float)), np.atleast_1d(np.asarray(around, dtype=float))
    if p.shape != (s.size, path.n_axis):
        raise GeometryError(f"points of shape {p.shape} with {s.size} values of progress: must be ({s.size}, {path.n_axis})")
    reach = np.asarray(window, dtype=float)
    if reach.shape not in ((), s.shape) or not (reach > 0.0).all():
        raise GeometryError(f"window = {window!r}: must be > 0 m, one for all points or one for each")
    reach = np.broadcast_to(reach, s.shape)
    found = FootPoint(np.empty(s.size), np.empty(p.shape), np.empty(s.size), np.empty(s.size))
    chunks = [slice(i, i + CHUNK) for i in range(0, s.size, CHUNK)]
    _leaves(path)  # once, not in each thread
    in_threads(lambda some: searched(path, p[some], s[some], reach[some], FootPoint(*(part[some] for part in found))), chunks)
    assert np.isfinite(found.distance).all()  # a wrong search must not become a figure
    return found


def gaps(path: CurveSequence, points: Array, along: Array) -> Array:
    """Return the distances (n,) [m] of points (n, n_axis) from the places of a path at arc lengths (n,), within 1 nm."""
    own, gap = _leaves(path), np.empty(len(points))
    curves = own.closed, own.length, own.breaks, own.start, own.leaf, *own[-8:-3], own.quintics
    _gaps(np.ascontiguousarray(points), along, *curves, np.empty((3, path.n_axis, 1)), gap)
    return gap


def searched(path: CurveSequence, points: Array, around: Array, window: Array, found: FootPoint) -> int:
    """Fill `found` with foot points; return the number of leaves that were searched."""
    n, pairs, guesses = len(points), [np.zeros((0, 2), dtype=np.int64)], [np.zeros((0, 6))]
    given = tuple(map(np.ascontiguousarray, (points, around, window)))
    refuse(not (np.isfinite(given[0]).all() and np.isfinite(given[1]).all()), GeometryError, "points and progress must be finite")
    leaves, room, state = _leaves(path), 64, np.zeros(3, dtype=np.int64)
    most = 3 * len(leaves.leaf) + 4
    ends, near = np.empty((_DEPTH, 2), dtype=np.int64), np.empty((most, 2), dtype=np.int64)
    scratch = ends, np.empty((_DEPTH, 3)), np.empty((3, path.n_axis, 2)), near, np.empty(most), np.empty((24, 12)), np.empty(10)
    while state[0] < n:
        pair, guess = np.empty((room, 2), dtype=np.int64), np.empty((room, 6))
        search(*given, *leaves, *found, pair, guess, state, *scratch)
        pairs.append(pair[: state[1]])
        guesses.append(guess[: state[1]])
        room *= 4  # it stops where they are full: curves other than lines, arcs and blends have some for each sample
    if sum(map(len, pairs)):
        _end(path, given, np.concatenate(pairs), np.concatenate(guesses), found)
    return int(state[2])


def _end(path: CurveSequence, given: tuple[Array, ...], pairs: Index, guess: Array, found: FootPoint) -> None:
    """Find closest points that the table gave on the curves themselves; take the nearest, of those in `found` too."""
    points, around, _ = given
    (sample, curve), (lap, s, low, high, _, size) = pairs.T.copy(), guess.T
    s, feet, tangent = _newton(path, points[sample], curve, s.copy(), low, high, size)
    progress, square = lap * path.length + path.breaks[curve] + s, ((points[sample] - feet) ** 2).sum(axis=1)
    known = sample[np.flatnonzero(np.diff(sample, prepend=-1))]
    # Where nothing else is found, the distance is infinite.
    owner = np.concatenate([known, sample])
    every = np.concatenate([found.distance[known] ** 2, square])
    aside = np.abs(np.concatenate([found.arc_length[known], progress]) - around[owner])
    best = _nearest(owner, every, aside, around.size)[known] - known.size
    sample, best = known[best >= 0], best[best >= 0]
    feet, curve, s = feet[best], curve[best], s[best]
    found.arc_length[sample], found.position[sample], found.distance[sample] = progress[best], feet, np.sqrt(square[best])
    if path.is_planar:
        toward, m = tangent[best], len(path.curves)
        for at_end, shift, edge in ((s >= np.diff(path.breaks)[curve], 1, path.starts), (s <= 0.0, -1, path.ends)):
            usable = at_end & (path.closed | ((curve + shift >= 0) & (curve + shift < m)))
            toward = np.where(usable[:, None], toward + edge[1][np.mod(curve + shift, m)], toward)
        gap = points[sample] - feet
        found.signed[sample] = np.copysign(found.distance[sample], toward[:, 0] * gap[:, 1] - toward[:, 1] * gap[:, 0])


def _newton(path: CurveSequence, target: Array, curve: Index, s: Array, a: Array, b: Array, size: Array) -> tuple[Array, Array, Array]:
    """Refine closest points (n,), each within its bracket; return arc lengths along the curves, positions and tangents."""
    at, tangent, on = np.empty_like(target), np.empty_like(target), np.arange(s.size)
    for _ in range(_MOST_STEPS):
        r, first, second = path.at(curve[on], s[on], 2)
        gap = r - target[on]
        slope, bend = (first * gap).sum(axis=1), (first**2 + second * gap).sum(axis=1)
        a[on], b[on] = np.where(slope < 0.0, s[on], a[on]), np.where(slope > 0.0, s[on], b[on])
        after = s[on] - np.divide(slope, bend, out=np.full_like(slope, np.inf), where=bend > 0.0)
        moved = np.where((after >= a[on]) & (after <= b[on]), after, 0.5 * (a[on] + b[on])) - s[on]
        s[on] += moved
        at[on], tangent[on] = r + moved[:, None] * (first + 0.5 * moved[:, None] * second), first + moved[:, None] * second
        on = on[(moved**2 > _SQUARE * size[on]) | (bend <= 0.1)]
        if not on.size:
            break
    return s, at, tangent


def _nearest(sample: Index, square: Array, away: Array, n: int) -> Index:
    """Return the pair of least distance for each sample; ties (within 1e-12) go to the least `away`."""
    least = np.full(n, np.inf)
    np.minimum.at(least, sample, square)
    tied = square <= least[sample] * (1.0 + 1e-12) + 1e-30
    nearest = np.full(n, np.inf)
    np.minimum.at(nearest, sample[tied], away[tied])
    winner = np.flatnonzero(tied & (away <= nearest[sample]))
    pair = np.empty(n, dtype=np.int64)
    pair[sample[winner][::-1]] = winner[::-1]
    return pair
