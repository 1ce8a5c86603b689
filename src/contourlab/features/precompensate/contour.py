"""The programmed contour with the places at which it is corrected."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.features.precompensate.blocks import Source
from contourlab.feed import Route, route_from_program
from contourlab.geometry import Path
from contourlab.program import Arc, Dwell, Feed, Move, Spline
from contourlab.program.moves import PLANE_AXES

FINEST = 5e-6
"""Smallest distance between two nodes [m]."""


@dataclass(frozen=True, eq=False)
class Contour:
    """The path of a program in the axes of a log, and its nodes.

    Attributes
    ----------
    source : Source
    axes : tuple of str
    route : Route
        Its `source_line` is the number of the block, from 1.
    period : float [s]
        Time between nodes at the programmed feed.
    """

    source: Source
    axes: tuple[str, ...]
    route: Route
    period: float

    @property
    def path(self) -> Path:
        """The programmed path."""
        return self.route.path

    @cached_property
    def corrected(self) -> Flags:
        """Whether each curve (n_curve,) can be corrected."""
        return np.array([not self.source.blocks[k - 1].reason for k in self.route.source_line.tolist()])

    @cached_property
    def nodes(self) -> Array:
        """Rising arc lengths (n_node,) [m] that hold the correction; every end of a curve is one."""
        parts = [np.zeros(1)]
        breaks = self.path.breaks
        for k, corrected in enumerate(self.corrected.tolist()):
            step = max(FINEST, float(self.route.feedrate[k]) * self.period) if corrected else np.inf
            n = max(1, int(np.ceil((breaks[k + 1] - breaks[k]) / step)))
            parts.append(np.linspace(breaks[k], breaks[k + 1], n + 1)[1:])
        return np.concatenate(parts)

    @cached_property
    def positions(self) -> Array:
        """Position of each node (n_node, n_axis) [m]."""
        return np.asarray(self.path.position(self.nodes))

    def is_corrected(self, arc_length: Array) -> Flags:
        """Return whether places (n,) [m] lie on curves that can be corrected."""
        return np.asarray(self.corrected[self.path.curve_index(arc_length)])


def contour_of(source: Source, axes: Sequence[str], period: float) -> Contour:
    """Return the contour of a program in some of its axes.

    Parameters
    ----------
    source : Source
    axes : sequence of str
        Some of x, y, z; motion of the others is left out.
    period : float [s]

    Raises
    ------
    FeedError
        If nothing moves these axes.
    """
    columns = ["xyz".index(axis) for axis in axes]
    moves = tuple(_flat(replace(block.move, source_line=k + 1), columns) for k, block in enumerate(source.blocks))
    route = route_from_program(replace(source.program, moves=moves), tuple(axes))
    return Contour(source, tuple(axes), route, period)


def _flat(move: Move, columns: Sequence[int]) -> Move:
    """Return a move without motion of other axes than some; an arc that leaves their plane becomes a line, which is not corrected."""
    if len(columns) == 3 or isinstance(move, Dwell):
        return move
    start, end = (tuple(value if k in columns else 0.0 for k, value in enumerate(point)) for point in (move.start, move.end))
    if isinstance(move, Arc):
        if not set(PLANE_AXES[move.plane][:2]) <= set(columns):
            return Feed(start, end, move.feedrate, move.source_line, move.mode)  # type: ignore[arg-type]
        centre = tuple(value if k in columns else 0.0 for k, value in enumerate(move.centre))
        return replace(move, start=start, end=end, centre=centre)  # type: ignore[arg-type]
    if isinstance(move, Spline):
        points = tuple(tuple(value if k in columns else 0.0 for k, value in enumerate(point)) for point in move.points)
        return replace(move, points=points)  # type: ignore[arg-type]
    return replace(move, start=start, end=end)  # type: ignore[arg-type]


def chunks(contour: Contour) -> list[tuple[int, int]]:
    """Return the ranges of curves [start, stop) that are corrected without a break between."""
    blocks, lines = contour.source.blocks, contour.route.source_line
    ranges: list[tuple[int, int]] = []
    for k, corrected in enumerate(contour.corrected.tolist()):
        if not corrected:
            continue
        between = blocks[lines[k - 1] : lines[k] - 1] if k else ()
        if ranges and ranges[-1][1] == k and not between:
            ranges[-1] = (ranges[-1][0], k + 1)
        else:
            ranges.append((k, k + 1))
    return ranges


def room(contour: Contour) -> Array:
    """Return the distance (n_node,) [m] along the path of each node from the nearer end of its corrected part; 0 outside."""
    distance = np.zeros(len(contour.nodes))
    for first, last in chunks(contour):
        index = node_range(contour, first, last - 1)
        places = contour.nodes[index]
        distance[index] = np.minimum(places - places[0], places[-1] - places)
    return distance


def node_range(contour: Contour, first: int, last: int) -> Index:
    """Return the numbers of the nodes from the start of one curve to the end of another, both included."""
    breaks, nodes = contour.path.breaks, contour.nodes
    return np.arange(np.searchsorted(nodes, breaks[first]), np.searchsorted(nodes, breaks[last + 1]) + 1)
