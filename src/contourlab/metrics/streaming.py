"""The judge of a batch: reduce the contour error to figures while the lanes run, without storing signals.

It is a step like those of components and runs in the same lanes. It reads true positions and the path; nothing in the loop reads it.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from contourlab.arrays import Array
from contourlab.engine.step import Port, Step
from contourlab.geometry import Path
from contourlab.geometry.view import PathView, newton_of
from contourlab.native.generated import generated
from contourlab.primitives import clip, copysign, dot, fabs, floor, lookup, maximum, select, sqrt, sub

SUMS = ("count", "sum_magnitude", "sum_square", "sum_signed", "largest", "largest_at", "sum_tracking", "largest_tracking", "unsure")
"""States of the judge after the foot point, in order."""

CORNER_PARAMETERS = ("corner_scale", "corner_last", "corner_lap", "corner_rate")
MOST_CELLS = 1 << 16
_ITERATIONS = 3


def corner_parts(path: Path) -> tuple[dict[str, float], dict[str, Array]]:
    """Return parameters and tables for finding the corner, or end of an open path, nearest to any place; empty if there is none.

    The path is cut into cells of equal length; each stores the corner nearest to its middle.
    """
    corners = np.unique(path.corners) if path.closed else np.unique(np.concatenate([[0.0], path.corners, [path.length]]))
    if not corners.size:
        return {}, {}
    if path.closed:
        corners = np.concatenate([corners[-1:] - path.length, corners, corners[:1] + path.length])
    cells = int(np.clip(np.ceil(4.0 * path.length / np.diff(corners).min(initial=path.length)), 1, MOST_CELLS))
    middle = (np.arange(cells) + 0.5) * (path.length / cells)
    right = np.clip(np.searchsorted(corners, middle), 1, len(corners) - 1)
    near = np.where(middle - corners[right - 1] <= corners[right] - middle, corners[right - 1], corners[right])
    lap = path.length if path.closed else 0.0
    parameters = {"corner_scale": cells / path.length, "corner_last": cells - 1.0, "corner_lap": lap, "corner_rate": 1.0 / path.length}
    return parameters, {"corner_near": near}


def judge_step(view: PathView, n_axis: int, corners: bool = False) -> Step:
    """Return the judge's step on a path.

    Parameters of the node: ``window`` [m] around the reference for the foot point, those of the view, and with `corners` those of
    `corner_parts`. The table ``counts`` has 1 for each tick that is judged, else 0.

    Notes
    -----
    Three Newton steps from the foot point of the previous tick, and three from the place of the reference; the nearer result is used. The
    distance is projected on the normal, so its error is quadratic in the remaining foot error. A corner or end that is nearer becomes the
    foot point. If the last Newton step was longer than 1e-9 of the window, or the foot point lies at the end of the window, the tick is in
    ``doubt`` and counted as ``unsure``; a caller judges it again, exactly.

    A controller's Newton estimator takes the same steps, but fewer; tests compare this judge with the exact foot point instead.
    """
    parameters = ("window", *view.parameters, *(CORNER_PARAMETERS if corners else ()))
    states = (Port("foot"), *(Port(name) for name in SUMS))
    inputs = (Port("position", n_axis), Port("reference", n_axis), Port("arc_length"))
    return Step(
        "judge",
        _make(view.evaluate, n_axis, corners),
        parameters,
        (*view.tables, "counts", *(("corner_near",) if corners else ())),
        "",
        states,
        inputs,
        (Port("contour_error"), Port("doubt")),
    )


@cache
def _make(evaluate: Any, n_axis: int, corners: bool) -> Any:
    planar = n_axis == 2
    improve, square_distance = newton_of(evaluate)

    def corner(par: Any, s: float) -> float:
        start = par.corner_lap * floor(s * par.corner_rate)
        return start + lookup(par.corner_near, clip(floor((s - start) * par.corner_scale), 0.0, par.corner_last))  # type: ignore[no-any-return]

    def seek(par: Any, s: float, position: Any, centre: float) -> Any:
        before = s
        for _ in range(_ITERATIONS):
            before = s
            s = improve(par, s, position, centre)
        return s, fabs(s - before)

    def step(par: Any, x: Any, inp: Any, clock: Any) -> Any:
        position, centre = inp.position, inp.arc_length
        s, moved = seek(par, x.foot, position, centre)
        other, other_moved = seek(par, centre, position, centre)
        swap = square_distance(par, other, position) < square_distance(par, s, position)
        s = select(swap, other, s)
        moved = select(swap, other_moved, moved)
        q, q1, _ = evaluate(par, s)
        gap = sub(q, position)
        square = dot(q1, q1)
        if planar:
            signed = (q1[1] * gap[0] - q1[0] * gap[1]) / sqrt(square)
        else:
            along = dot(q1, gap)
            signed = sqrt(maximum(dot(gap, gap) - along * along / square, 0.0))
        if corners:
            edge = corner(par, s)
            beside = square_distance(par, edge, position)
            at_edge = beside <= dot(gap, gap)
            signed = select(at_edge, copysign(sqrt(beside), signed) if planar else sqrt(beside), signed)
            s, moved = select(at_edge, edge, s), select(at_edge, 0.0, moved)
        counts = lookup(par.counts, clock.k)
        magnitude = counts * fabs(signed)
        behind = sub(inp.reference, position)
        tracking = counts * dot(behind, behind)
        record = magnitude > x.largest
        cut_off = fabs(s - centre) >= par.window
        doubt = select(moved > 1e-9 * par.window, 1.0, select(cut_off, 1.0, 0.0))
        return (
            s,
            x.count + counts,
            x.sum_magnitude + magnitude,
            x.sum_square + magnitude * magnitude,
            x.sum_signed + counts * signed,
            select(record, magnitude, x.largest),
            select(record, clock.k, x.largest_at),
            x.sum_tracking + tracking,
            maximum(x.largest_tracking, tracking),
            x.unsure + counts * doubt,
        ), (signed, doubt)

    return step


EFFORT_SUMS = ("count", "sum_square", "largest", "limited")
"""States of the step, in order."""

_AXIS = """
    command, accepted = inp.command[{i}] * par.rate_{i}, inp.accepted[{i}] * par.rate_{i}
    square = square + accepted * accepted
    largest = maximum(largest, fabs(command))
    limited = select(fabs(command - accepted) > 0.0, 1.0, limited)
"""


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
    body = "".join(_AXIS.format(i=i) for i in range(n_axis))
    source = (
        "def step(par, x, inp, clock):\n    square, largest, limited = 0.0, 0.0, 0.0" + body + "\n"
        "    counts = lookup(par.counts, clock.k)\n"
        "    return (x.count + counts, x.sum_square + counts * square, maximum(x.largest, counts * largest),\n"
        "            x.limited + counts * limited), ()\n"
    )
    scope: dict[str, Any] = {"__name__": __name__, "fabs": fabs, "lookup": lookup, "maximum": maximum, "select": select}
    step = generated(source, scope, "step")
    parameters = tuple(f"rate_{i}" for i in range(n_axis))
    inputs = (Port("command", n_axis), Port("accepted", n_axis))
    return Step("effort", step, parameters, ("counts",), "", tuple(Port(name) for name in EFFORT_SUMS), inputs, ())
