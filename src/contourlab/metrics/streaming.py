"""The judge of a batch: reduce the contour error to figures while the lanes run, without storing signals.

It is a step like those of components and runs in the same lanes. It reads true positions and the path; nothing in the loop reads it.
"""

from __future__ import annotations

from functools import cache
from typing import Any

from contourlab.engine.step import Port, Step, ports
from contourlab.geometry.clearance import CORNER_ROW, PARAMETERS, TABLES
from contourlab.geometry.view import PathView, newton_of
from contourlab.metrics.judge import MARGIN
from contourlab.primitives import clip, copysign, dot, fabs, floor, lookup, maximum, select, sqrt, sub

_OF_JUDGED = ("count", "sum_magnitude", "sum_square", "sum_signed", "largest", "largest_at", "sum_tracking", "largest_tracking")
SUMS = (*_OF_JUDGED, "unsure", "reach")
"""States of the judge after the foot point, in order."""

_ITERATIONS = 3
_BESIDE = 1e-12
"""How far [m] from a corner a search on one side of it stays."""


def judge_step(view: PathView, n_axis: int, corners: bool = False) -> Step:
    """Return the judge's step on a path.

    Parameters of the node: ``error`` [m], the largest tracking error that is expected; ``planning`` [m], the largest planning deviation;
    ``window`` [m], how far from the reference foot points are; ``doubtful``, 1 to sum ticks in doubt too, else 0; those of the view and of
    `contourlab.geometry.clearance`. The table ``counts`` has 1 for each tick that is judged, else 0. `corners` says whether the path has
    corners or ends.

    Notes
    -----
    Three Newton steps from the foot point of the previous tick, and three on the other side of the corner beside it, or from the place of
    the reference where there is no corner. The nearest of both and the corner is the foot point. The distance is projected on the normal,
    so its error is quadratic in the remaining foot error.

    A tick is in ``doubt`` unless the foot point is proved to be that of the exact judge: both searches converged, the distance is less
    than the clearance of the path, and the foot point lies in the smallest window that the exact judge may have. A tick in doubt is left
    out of the sums and counted as ``unsure``; a caller judges it exactly, unless ``doubtful`` is 1. ``reach`` is the
    largest squared tracking error of all ticks. ``foot`` is the arc length of the foot point, also of one in doubt.

    A controller's Newton estimator takes the same steps, but fewer; tests compare this judge with the exact foot point instead.
    """
    states = ports("foot", *SUMS)
    inputs = (*ports("position", "reference", size=n_axis), Port("arc_length"))
    parameters = ("error", "planning", "window", "doubtful", *view.parameters, *PARAMETERS)
    tables, outputs = (*view.tables, "counts", *TABLES), ports("contour_error", "doubt", "foot")
    return Step("judge", _make(view.evaluate, n_axis, corners), parameters, tables, "", states, inputs, outputs)


@cache
def _make(evaluate: Any, n_axis: int, corners: bool) -> Any:
    planar = n_axis == 2
    improve, _ = newton_of(evaluate)
    stride = CORNER_ROW + 3.0 * n_axis

    def cell(par: Any, s: float) -> Any:
        along = s - par.cell_lap * floor(s * par.cell_rate)
        return clip(floor(along * par.cell_scale), 0.0, par.cell_last)

    def vector(par: Any, first: float) -> Any:
        return tuple(lookup(par.corner_row, first + float(j)) for j in range(n_axis))

    def seek(par: Any, s: float, position: Any, centre: float, low: float, high: float) -> Any:
        before = s
        for _ in range(_ITERATIONS):
            before = s
            s = clip(improve(par, s, position, centre), low, high)
        q, q1, _ = evaluate(par, s)
        gap = sub(q, position)
        return s, fabs(s - before), dot(gap, gap), gap, q1

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        position, centre = inp.position, inp.arc_length
        behind = sub(inp.reference, position)
        apart = dot(behind, behind)
        reach = maximum(x.reach, apart)
        if lookup(par.counts, clock.k) < 0.5:
            return (centre, *x[1:-1], reach), (0.0, 0.0, centre)
        low, high, start = centre - par.window, centre + par.window, centre
        s, moved, square, gap, q1 = seek(par, x.foot, position, centre, low, high)
        number, edge, back, on, away = 0.0, 0.0, 1.0, 1.0, gap
        if corners:
            number = lookup(par.cell_corner, cell(par, s))
            row = stride * number
            edge = lookup(par.corner_row, row)
            edge = edge + par.cell_lap * floor((s - edge) * par.cell_rate + 0.5)
            away = sub(position, vector(par, row + CORNER_ROW))
            came, goes = vector(par, row + CORNER_ROW + n_axis), vector(par, row + CORNER_ROW + 2.0 * n_axis)
            back, on = -dot(came, away), dot(goes, away)
            left, there = s < edge, number > 0.5
            low = select(there, select(left, edge + _BESIDE, edge - lookup(par.corner_row, row + 1.0)), low)
            high = select(there, select(left, edge + lookup(par.corner_row, row + 2.0), edge - _BESIDE), high)
            start = select(there, clip(select(left, edge + on, edge - back), low, high), start)
        other, other_moved, other_square, other_gap, other_q1 = seek(par, start, position, centre, low, high)
        # Of two at the same distance, the exact judge takes the one nearer to the reference.
        tied = fabs(other_square - square) <= 1e-12 * square + 1e-30
        swap = select(tied, fabs(other - centre), other_square) < select(tied, fabs(s - centre), square)
        # The other search may go on where it can no longer win.
        lost = other_square > 2.0 * square + 8.0 * other_moved * other_moved
        moved = maximum(moved, select(lost, 0.0, other_moved))
        s, square = select(swap, other, s), select(swap, other_square, square)
        gap = tuple(select(swap, b, a) for a, b in zip(gap, other_gap, strict=True))
        q1 = tuple(select(swap, b, a) for a, b in zip(q1, other_q1, strict=True))
        along, slip = dot(q1, q1), dot(q1, gap)
        signed = (q1[1] * gap[0] - q1[0] * gap[1]) / sqrt(along) if planar else sqrt(maximum(square - slip * slip / along, 0.0))
        at = cell(par, s)
        clear, sure = lookup(par.cell_clearance, at), select(maximum(moved, fabs(slip)) <= 1e-9 * par.window, 1.0, 0.0)
        if corners:
            sure = select(lookup(par.cell_corner, at) == number, sure, 0.0)
            corner_square = dot(away, away)
            at_edge = maximum(maximum(back, on), corner_square - square) <= 0.0
            distance = sqrt(corner_square)
            if planar:
                # The bisector decides the side.
                distance = copysign(distance, (came[0] + goes[0]) * away[1] - (came[1] + goes[1]) * away[0])
            signed, square = select(at_edge, distance, signed), select(at_edge, corner_square, square)
            s, sure = select(at_edge, edge, s), select(at_edge, 1.0, sure)
            clear = select(at_edge, lookup(par.corner_row, row + 3.0), clear)
        further = maximum(fabs(s - centre) - (MARGIN + par.planning), 0.0)
        sure = select(further * further <= 9.0 * reach, select(fabs(s - centre) <= par.window, sure, 0.0), 0.0)
        doubt = select(square < clear, select(apart <= par.error * par.error, 1.0 - sure, 1.0), 1.0)
        sure = maximum(1.0 - doubt, par.doubtful)
        magnitude = sure * fabs(signed)
        record = magnitude > x.largest
        return (
            select(doubt > 0.5, centre, s),
            x.count + 1.0,
            x.sum_magnitude + magnitude,
            x.sum_square + magnitude * magnitude,
            x.sum_signed + sure * signed,
            select(record, magnitude, x.largest),
            select(record, clock.k, x.largest_at),
            x.sum_tracking + apart,
            maximum(x.largest_tracking, apart),
            x.unsure + doubt,
            reach,
        ), (signed, doubt, s)

    return step


EFFORT_SUMS = ("count", "sum_square", "largest", "limited")
"""States of the step, in order."""


def _effort(par: Any, x: Any, inp: Any, clock: Any) -> Any:
    square, largest, limited = 0.0, 0.0, 0.0
    for i in range(len(inp.command)):
        command, accepted = inp.command[i] * par[i], inp.accepted[i] * par[i]
        square = square + accepted * accepted
        largest = maximum(largest, fabs(command))
        limited = select(fabs(command - accepted) > 0.0, 1.0, limited)
    counts = lookup(par.counts, clock.k)
    sums = (x.count + counts, x.sum_square + counts * square, maximum(x.largest, counts * largest), x.limited + counts * limited)
    return sums, ()


@cache
def effort_step(n_axis: int) -> Step:
    """Return the step that sums up commands.

    Parameters of the node: ``rate_0``, ``rate_1`` ..., a factor on the command of each axis (one over the limit of its drive, or 1). The
    table ``counts`` is that of the judge.

    Notes
    -----
    ``sum_square`` adds the squares of the commands that the drives accepted, ``largest`` is the largest command to any drive, ``limited``
    counts the ticks at which any drive was saturated.
    """
    parameters = tuple(f"rate_{i}" for i in range(n_axis))
    inputs = ports("command", "accepted", size=n_axis)
    return Step("effort", _effort, parameters, ("counts",), "", ports(*EFFORT_SUMS), inputs, ())
