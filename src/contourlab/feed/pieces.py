"""Cuts a route into pieces along which one set of limits holds.

A line, an arc and a helix are one piece each; lines that follow one another in one direction at one feedrate are
joined. Other curves are sampled, more densely where they turn more, and cut where the permitted speed has changed by
the factor `GROUP`. Derivatives are evaluated in a few calls for the whole path, never curve by curve.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import FeedError
from contourlab.feed.bounds import SHARES, Bounds, Samples, piece_bounds, speed_limit
from contourlab.feed.junctions import KINK_TIME, NUDGE, Junctions, junctions
from contourlab.feed.limits import AxisLimits
from contourlab.feed.route import Route
from contourlab.geometry import Arc, Curve, Line
from contourlab.geometry.blend import Blend

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
Index = NDArray[np.intp]

GROUP = 1.15  # the permitted speed changes by at most this factor within a piece of a general curve
NODES_ARC = 128  # samples per turn of an arc: the worst direction is met within 0.03 %
NODES_BLEND = 17  # samples of a blend, which bends once
NODES_FIRST = 65  # samples of a general curve before refinement
TURN = 0.05  # [rad] the tangent turns less than this between samples of a general curve ...
STEP = 1.06  # ... and the permitted speed changes by less than this factor, ...
DEPTH = 14  # ... unless the interval was halved this many times
WORTH = 0.5  # of the feedrate: a kink that has to be passed more slowly is a stop
FLAT = 1e-6  # [1/m, 1/m^2] derivatives below this are rounding


@dataclass(frozen=True, eq=False)
class Pieces:
    """Pieces in the order of travel; arrays (n_piece,).

    Parameters
    ----------
    start, length : ndarray [m]
    bounds : Bounds
    stop : ndarray of bool
        Whether the motion stops at the end of the piece.
    junction_speed : ndarray [m/s]
        Ceiling of the speed at the end of the piece (inf: that of the neighbours).
    curve : ndarray of int
        The curve at which the piece ends.
    """

    start: Array
    length: Array
    bounds: Bounds
    stop: Flags
    junction_speed: Array
    curve: Index


class Nodes(NamedTuple):
    """Sampled places: curve, place within it (0 to 1), derivatives (n, n_axis)."""

    curve: Index
    place: Array
    tangent: Array
    second: Array
    third: Array


def look(route: Route, curve: Index, place: Array) -> Nodes:
    """Evaluate the path at places within curves."""
    begin, end = route.path.breaks[curve], route.path.breaks[curve + 1]
    inside = np.clip(place, NUDGE, 1.0 - NUDGE)
    derivatives = route.path.derivatives(begin + (end - begin) * inside, 3)
    return Nodes(curve, place, derivatives[1], derivatives[2], derivatives[3])


def _kind(curve: Curve) -> int:
    return 0 if isinstance(curve, Line) else 1 if isinstance(curve, Arc) else 3 if isinstance(curve, Blend) else 2


def _first_nodes(route: Route, kind: NDArray[np.int8], curves: Index) -> Nodes:
    """Sample curves before any refinement."""
    middle = look(route, curves, np.full(curves.size, 0.5))
    sweep = np.linalg.norm(middle.second, axis=1) * (route.path.breaks[curves + 1] - route.path.breaks[curves])
    of_arc = np.maximum(6, 2 + np.ceil(NODES_ARC * sweep / (2.0 * np.pi)))
    counts = [np.full_like(of_arc, 2), of_arc, np.full_like(of_arc, NODES_FIRST), np.full_like(of_arc, NODES_BLEND)]
    count = np.choose(kind[curves], counts).astype(np.intp)
    first = np.repeat(np.cumsum(count) - count, count)
    place = (np.arange(first.size) - first) / np.repeat(count - 1.0, count)
    return look(route, np.repeat(curves, count), place)


def _refined(route: Route, nodes: Nodes, kind: NDArray[np.int8], limits: AxisLimits) -> Nodes:
    """Halve the intervals of general curves until neighbours are alike."""
    for _ in range(DEPTH if np.any(kind[nodes.curve] == 2) else 0):
        permitted = speed_limit(_samples(route, nodes), limits, SHARES[0])
        high, low = np.maximum(permitted[1:], permitted[:-1]), np.minimum(permitted[1:], permitted[:-1])
        turn = np.linalg.norm(np.diff(nodes.tangent, axis=0), axis=1)
        general = (nodes.curve[1:] == nodes.curve[:-1]) & (kind[nodes.curve[1:]] == 2)
        coarse = general & ((high > STEP * low) | (turn > TURN))
        where = np.flatnonzero(coarse)
        if where.size == 0:
            break
        new = look(route, nodes.curve[where], 0.5 * (nodes.place[where] + nodes.place[where + 1]))
        nodes = Nodes(*(np.insert(old, where + 1, more, axis=0) for old, more in zip(nodes, new, strict=True)))
    return nodes


def nodes_of(route: Route, kind: NDArray[np.int8], limits: AxisLimits, curves: Index) -> Nodes:
    """Sample curves, each more densely where it turns more; what one curve gets does not depend on the others.

    Parameters
    ----------
    route : Route
    kind : ndarray (n_curve,)
        As in `Survey`.
    limits : AxisLimits
        For the path's number of axes.
    curves : ndarray of int
        Which curves, rising.

    Returns
    -------
    Nodes
        In the order of travel; both ends of every curve are among them.
    """
    return _refined(route, _first_nodes(route, kind, curves), kind, limits)


def _samples(route: Route, nodes: Nodes) -> Samples:
    second = nodes.second.copy()
    third = nodes.third.copy()
    # Rounding of the derivatives of straight lines must not look like a curve.
    second[np.abs(second) < FLAT] = 0.0
    third[np.abs(third) < FLAT] = 0.0
    return Samples(nodes.tangent, second, third, route.feedrate[nodes.curve])


def _cells(nodes: Nodes, kind: NDArray[np.int8], permitted: Array, smooth_line: Flags) -> Index:
    """Return the node at which each piece ends, walking once over the cells of the general curves."""
    end_of_curve = np.append(nodes.curve[1:] != nodes.curve[:-1], True)
    ends = end_of_curve & ~smooth_line[nodes.curve]
    if np.any(kind[nodes.curve] >= 2):
        ends = ends.copy()
        general = np.unique(nodes.curve[kind[nodes.curve] >= 2])
        firsts = np.searchsorted(nodes.curve, general)
        lasts = np.searchsorted(nodes.curve, general, side="right")
        for first, last in zip(firsts.tolist(), lasts.tolist(), strict=True):
            low = high = -1.0
            values = permitted[first:last].tolist()
            for offset in range(last - first - 1):
                a, b = values[offset], values[offset + 1]
                bottom, top = (a, b) if a < b else (b, a)
                if low < 0.0:
                    low, high = bottom, top
                elif max(high, top) > GROUP * min(low, bottom):
                    ends[first + offset] = True
                    low, high = bottom, top
                else:
                    low, high = min(low, bottom), max(high, top)
    return np.flatnonzero(ends)


def junction_speed(meet: Junctions, limits: AxisLimits, curvature_step: float) -> Array:
    """Return the ceiling of speed at each joint from the steps of acceleration, |jump| v^2, and of velocity, |kink| v."""
    if not curvature_step >= 0.0:
        raise FeedError(f"curvature_step = {curvature_step}: give a part of the acceleration limit, >= 0")
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        square = np.where(meet.jump == 0.0, np.inf, curvature_step * limits.acceleration / np.abs(meet.jump))
        step = min(curvature_step, 1.0) * limits.acceleration * KINK_TIME
        speed = np.where(meet.kink == 0.0, np.inf, step / np.abs(meet.kink)).min(axis=1)
        # Where kinks follow one another faster than that, they are a curve: turning from one to the next takes acceleration.
        turning = np.where(meet.kink == 0.0, np.inf, step / KINK_TIME / np.abs(meet.kink)).min(axis=1) * meet.room
    return np.asarray(np.minimum(np.sqrt(np.minimum(square.min(axis=1), turning)), speed))


class Survey(NamedTuple):
    """Properties of a route: its junctions, and for each curve its kind and the ceiling of speed at its end."""

    meet: Junctions
    kind: NDArray[np.int8]  # 0 line, 1 arc or helix, 2 any other, 3 blend of a corner
    junction_speed: Array

    @property
    def stop(self) -> Flags:
        """Whether the motion stops at the end of each curve (n_curve,); where a closed path closes, it does so after the last lap."""
        return np.asarray(self.meet.stop | (self.junction_speed == 0.0))


def survey(route: Route, limits: AxisLimits, curvature_step: float) -> Survey:
    """Find junctions, kinds of curves and ceilings of speed.

    Parameters
    ----------
    route : Route
    limits : AxisLimits
        For the path's number of axes.
    curvature_step : float, >= 0
        Largest step of an axis' acceleration where the curvature jumps, as a part of its limit.

    Returns
    -------
    Survey
    """
    meet = junctions(route)
    kind = np.array([_kind(curve) for curve in route.path.curves], dtype=np.int8)
    ceiling = junction_speed(meet, limits, curvature_step)
    # Slowing down for a kink without stopping gains nothing.
    slow = np.any(meet.kink != 0.0, axis=1) & (ceiling < WORTH * np.minimum(route.feedrate, np.roll(route.feedrate, -1)))
    meet = meet._replace(stop=meet.stop | slow, kink=np.where(slow[:, None], 0.0, meet.kink))
    return Survey(meet, kind, ceiling)


def cut(route: Route, seen: Survey, limits: AxisLimits, wanted: Flags) -> Pieces:
    """Cut curves of a route into pieces and find the limits of each.

    Parameters
    ----------
    route : Route
    seen : Survey
    limits : AxisLimits
        For the path's number of axes.
    wanted : ndarray (n_curve,) of bool
        Curves to be cut; all curves from one stop to the next, or none of them.

    Returns
    -------
    Pieces
    """
    meet, kind = seen.meet, seen.kind
    nodes = nodes_of(route, kind, limits, np.flatnonzero(wanted))
    samples = _samples(route, nodes)
    straight_on = kind == 0
    smooth_line = ~meet.stop & ~np.any(meet.kink != 0.0, axis=1) & straight_on & np.roll(straight_on, -1)
    smooth_line &= route.feedrate == np.roll(route.feedrate, -1)
    smooth_line[-1] = False
    last = _cells(nodes, kind, speed_limit(samples, limits, SHARES[0]), smooth_line)
    within = np.append(nodes.curve[1:] == nodes.curve[:-1], False)[last]  # the piece ends inside a curve
    first = np.concatenate([[0], np.where(within[:-1], last[:-1], last[:-1] + 1)])
    curve = nodes.curve[last]
    breaks = np.asarray(route.path.breaks)
    end = np.where(within, breaks[curve] + np.diff(breaks)[curve] * nodes.place[last], breaks[curve + 1])
    start = np.where(np.append(False, within[:-1]), np.append(0.0, end[:-1]), breaks[nodes.curve[first]])
    stop = meet.stop[curve] & ~within
    counts = last - first + 1
    begins = np.cumsum(counts) - counts
    rows = np.repeat(first - begins, counts) + np.arange(int(counts.sum()))
    stop_ends = np.stack([np.roll(stop, 1), stop], axis=1)
    stop_ends[0, 0] = stop_ends[-1, 1] = True
    length = end - start
    bounds = piece_bounds(Samples(*(part[rows] for part in samples)), begins, length, stop_ends, limits)
    ceiling = np.where(within, np.inf, seen.junction_speed[curve])
    return Pieces(start, length, bounds, stop, ceiling, curve)
