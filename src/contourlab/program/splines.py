"""Splines: G5 (cubic), G5.1 (quadratic) and G5.2 with G5.3 (NURBS), in the XY plane, kept as curves.

I and J lead from the start, P and Q from the end, to the control points in between. A cubic without I and J goes on from the cubic
before it. The NURBS of G5.2 begins where the tool is; its knots are evenly spaced and clamped, its order (degree + 1) is L, 3 where L is
missing. G5 and G5.1 hold for their own block, as LinuxCNC 2.9 has it.
"""

from __future__ import annotations

from contourlab.program.block import Block
from contourlab.program.fault import BlockError
from contourlab.program.moves import Move, Point, Spline
from contourlab.program.state import Curve, ModalState

MOST_POINTS = 100_000
LARGEST_ORDER = 10


def bezier(block: Block, state: ModalState, line: int) -> list[Move]:
    """Make a cubic (G5) or quadratic (G5.1) spline of one segment.

    Raises
    ------
    BlockError
        If words are missing.
    """
    words, cubic, column = block.words, state.motion == 50, _column(block)
    name = "G5" if cubic else "G5.1"
    feedrate = state.path_feedrate(column, name)
    _check_plane(block, state, name)
    given = [letter in words for letter in "IJ"]
    if any(given) != all(given):
        cure = "write both" + (", or neither to go on from the G5 before" if cubic else "")
        raise BlockError(f"{name} takes both I and J: {cure}", column)
    away = (state.length(words["I"].value), state.length(words["J"].value)) if all(given) else state.tangent if cubic else None
    if away is None:
        raise BlockError(f"{name} has no I and J: the first of a row needs them", column)
    start, end = state.position, state.target(words)
    points = [start, (start[0] + away[0], start[1] + away[1], start[2])]
    state.tangent = None
    if cubic:
        if "P" not in words or "Q" not in words:
            raise BlockError("G5 takes both P and Q: they lead from the end to the second control point", column)
        p, q = state.length(words["P"].value), state.length(words["Q"].value)
        points.append((end[0] + p, end[1] + q, end[2]))
        state.tangent = (-p, -q)
    points.append(end)
    return _made(state, points, [1.0] * len(points), len(points) - 1, feedrate, line, column)


def _check_plane(block: Block, state: ModalState, name: str) -> None:
    if state.plane != "XY":
        raise BlockError(f"{name} lies in the XY plane: write G17 before it", _column(block))
    if "Z" in block.words:
        raise BlockError(f"{name} stays in the XY plane: delete Z", block.words["Z"].column)


def _column(block: Block) -> int:
    return block.codes["motion"].column if "motion" in block.codes else next(iter(block.words.values())).column


def add_control_point(block: Block, state: ModalState) -> None:
    """Take in a block of G5.2.

    Raises
    ------
    BlockError
        If a coordinate or a weight is missing.
    """
    words, curve, column = block.words, state.curve, _column(block)
    state.path_feedrate(column, "G5.2")
    _check_plane(block, state, "G5.2")
    if ("X" in words) != ("Y" in words):
        raise BlockError("a control point of G5.2 has both X and Y: write the other, too", column)
    weight, fresh, point = words["P"].value if "P" in words else None, not curve.points, "X" in words
    if not (fresh or point):
        raise BlockError("a control point of G5.2 has X and Y: write them", column)
    if (weight is None and point) or (weight is not None and weight <= 0.0):
        raise BlockError("each control point of G5.2 has a weight P greater than 0: write for example P1", column)
    if fresh:
        # The first one is where the tool is; a P without X and Y is its weight.
        curve.order = 3
        curve.points.append(state.position[:2])
        curve.weights.append(1.0 if point or weight is None else weight)
    if "L" in words:
        order = round(words["L"].value)
        if order != words["L"].value or not 2 <= order <= LARGEST_ORDER:
            raise BlockError(f"L{words['L'].value:g}: the order of a NURBS is a whole number from 3 to {LARGEST_ORDER}", words["L"].column)
        curve.order = max(order, 3)
    if point and weight is not None:
        curve.points.append(state.target(words)[:2])
        curve.weights.append(weight)
    if len(curve.points) > MOST_POINTS:
        raise BlockError(f"a NURBS of more than {MOST_POINTS} control points: close it with G5.3", column)


def close_curve(block: Block, state: ModalState, line: int) -> list[Move]:
    """Make the NURBS of the G5.2 blocks before (G5.3).

    Raises
    ------
    BlockError
        If there are none, or too few for the order.
    """
    curve, column = state.curve, block.codes["other"].column
    if not curve.points:
        raise BlockError("G5.3 closes a NURBS that no G5.2 has begun: write the control points before it", column)
    if len(curve.points) < curve.order:
        raise BlockError(
            f"a NURBS of order {curve.order} takes at least {curve.order} control points, here are {len(curve.points)}: "
            "write more of them before G5.3, or a smaller L",
            column,
        )
    points: list[Point] = [(u, v, state.position[2]) for u, v in curve.points]
    state.curve, state.motion = Curve(), None
    return _made(state, points, curve.weights, curve.order - 1, state.path_feedrate(column, "G5.3"), line, column)


def _made(state: ModalState, points: list[Point], weights: list[float], degree: int, feedrate: float, line: int, column: int) -> list[Move]:
    if all(point == points[0] for point in points):
        raise BlockError("all control points of the spline are the same: there is no curve", column)
    axes = [state.frame.axes(point) for point in points]
    axes[0] = state.reached
    state.position, state.reached = points[-1], axes[-1]
    inner = len(points) - degree - 1
    knots = [0.0] * (degree + 1) + [float(i + 1) for i in range(inner)] + [float(inner + 1)] * (degree + 1)
    state.made += 1
    return [Spline(degree, tuple(axes), tuple(weights), tuple(knots), feedrate, line, state.mode)]
