"""Cut a route into pieces, each with one set of limits.

A line, an arc and a helix are one piece each; successive lines in one direction at one feedrate are joined. Other curves are sampled, more
densely where they turn more, and cut where the permitted speed has changed by the factor `GROUP`. Derivatives are evaluated for the whole
path in a few calls.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from contourlab.arrays import Array, Flags, Index
from contourlab.feed.bounds import SHARES, Bounds, Samples, piece_bounds, speed_limit
from contourlab.feed.junctions import NUDGE, Junctions, junction_speed, junctions
from contourlab.feed.limits import AxisLimits
from contourlab.feed.route import Route
from contourlab.geometry import Arc, Curve, Line
from contourlab.geometry.blend import Blend
from contourlab.native.kernel import kernel

Kinds = NDArray[np.int8]

GROUP = 1.15  # largest factor between permitted speeds within a piece of a general curve
NODES_ARC = 128  # samples per turn of an arc: the worst direction is met within 0.03 %
NODES_BLEND = 17  # samples of a blend, which bends once
NODES_FIRST = 65  # samples of a general curve before refinement
TURN = 0.05  # [rad] largest turn between samples of a general curve
STEP = 1.06  # largest factor between permitted speeds of neighbouring samples
DEPTH = 14  # most halvings of an interval
WORTH = 0.5  # of the feedrate: a kink that must be passed more slowly becomes a stop
FLAT = 1e-6  # [1/m, 1/m^2] smaller derivatives are rounding
LINE, ARC, GENERAL, BLEND = range(4)  # kinds of curves


class Pieces(NamedTuple):
    """Pieces in the order of travel; arrays (n_piece,).

    start, length : ndarray [m]
    bounds : Bounds
    stop : ndarray of bool
        Whether the motion stops at the end of the piece.
    junction_speed : ndarray [m/s]
        Speed ceiling at the end of the piece, inf inside a curve.
    curve : ndarray of int
        Curve at which the piece ends.
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


class Survey(NamedTuple):
    """Junctions of a route, and for each curve its kind and the speed ceiling at its end."""

    junctions: Junctions
    kind: Kinds
    junction_speed: Array

    @property
    def stop(self) -> Flags:
        """Whether the motion stops at the end of each curve (n_curve,); the final stop on a closed path is not included."""
        return np.asarray(self.junctions.stop | (self.junction_speed == 0.0))


def without_rounding(derivative: Array) -> Array:
    """Set derivatives that are only rounding to 0, so that straight parts do not look curved."""
    return np.where(np.abs(derivative) < FLAT, 0.0, derivative)


def evaluate_nodes(route: Route, curve: Index, place: Array) -> Nodes:
    """Evaluate the path at places within curves."""
    begin, end = route.path.breaks[curve], route.path.breaks[curve + 1]
    inside = np.clip(place, NUDGE, 1.0 - NUDGE)
    return Nodes(curve, place, *route.path.derivatives(begin + (end - begin) * inside, 3)[1:])


def _kind(curve: Curve) -> int:
    return LINE if isinstance(curve, Line) else ARC if isinstance(curve, Arc) else BLEND if isinstance(curve, Blend) else GENERAL


def _first_nodes(route: Route, kind: Kinds, curves: Index) -> Nodes:
    """Sample curves before any refinement."""
    middle = evaluate_nodes(route, curves, np.full(curves.size, 0.5))
    sweep = np.linalg.norm(middle.second, axis=1) * (route.path.breaks[curves + 1] - route.path.breaks[curves])
    of_arc = np.maximum(6, 2 + np.ceil(NODES_ARC * sweep / (2.0 * np.pi)))
    count = np.choose(kind[curves], [2, of_arc, NODES_FIRST, NODES_BLEND]).astype(np.intp)
    first = np.repeat(np.cumsum(count) - count, count)
    place = (np.arange(first.size) - first) / np.repeat(count - 1.0, count)
    return evaluate_nodes(route, np.repeat(curves, count), place)


def sample_nodes(route: Route, kind: Kinds, limits: AxisLimits, curves: Index) -> Nodes:
    """Sample curves (rising numbers), both ends included; general curves more densely where they turn more.

    The samples of a curve do not depend on the other curves.
    """
    nodes = _first_nodes(route, kind, curves)
    for _ in range(DEPTH if np.any(kind[nodes.curve] == GENERAL) else 0):
        permitted = speed_limit(_samples(route, nodes), limits, SHARES[0])
        high, low = np.maximum(permitted[1:], permitted[:-1]), np.minimum(permitted[1:], permitted[:-1])
        turn = np.linalg.norm(np.diff(nodes.tangent, axis=0), axis=1)
        general = (nodes.curve[1:] == nodes.curve[:-1]) & (kind[nodes.curve[1:]] == GENERAL)
        coarse = np.flatnonzero(general & ((high > STEP * low) | (turn > TURN)))
        if coarse.size == 0:
            break
        new = evaluate_nodes(route, nodes.curve[coarse], 0.5 * (nodes.place[coarse] + nodes.place[coarse + 1]))
        nodes = Nodes(*(np.insert(old, coarse + 1, more, axis=0) for old, more in zip(nodes, new, strict=True)))
    return nodes


def _samples(route: Route, nodes: Nodes) -> Samples:
    return Samples(nodes.tangent, without_rounding(nodes.second), without_rounding(nodes.third), route.feedrate[nodes.curve])


def _piece_ends(nodes: Nodes, kind: Kinds, permitted: Array, joined: Flags) -> Index:
    """Return the node at which each piece ends; `joined` lines share a piece with the next curve."""
    end_of_curve = np.append(nodes.curve[1:] != nodes.curve[:-1], True)
    ends = np.array(end_of_curve & ~joined[nodes.curve], dtype=np.int64)
    undivided = np.array(end_of_curve | (kind[nodes.curve] < GENERAL), dtype=np.int64)
    _divide(undivided, permitted, ends)
    return np.flatnonzero(ends)


@kernel("i8[:] f8[:] i8[:]")
def _divide(undivided, permitted, ends):  # type: ignore[no-untyped-def]
    """Mark the nodes up to which the permitted speed has changed by `GROUP`; no piece ends inside an `undivided` interval after a node."""
    low, high = math.inf, 0.0
    for i in range(undivided.size - 1):
        if undivided[i] != 0:
            low, high = math.inf, 0.0
            continue
        bottom, top = min(permitted[i], permitted[i + 1]), max(permitted[i], permitted[i + 1])
        if low < math.inf and max(high, top) > GROUP * min(low, bottom):
            ends[i] = 1
            low, high = bottom, top
        else:
            low, high = min(low, bottom), max(high, top)


def survey(route: Route, limits: AxisLimits, curvature_step: float) -> Survey:
    """Find junctions, kinds of curves and speed ceilings.

    Parameters
    ----------
    limits : AxisLimits
        For the path's number of axes.
    curvature_step : float, >= 0
        Largest step of an axis acceleration where the curvature jumps, as a fraction of its limit.
    """
    junction = junctions(route)
    kind = np.array([_kind(curve) for curve in route.path.curves], dtype=np.int8)
    ceiling = junction_speed(junction, limits, curvature_step)
    # Slowing down for a kink without stopping gains nothing.
    slow = np.any(junction.kink != 0.0, axis=1) & (ceiling < WORTH * np.minimum(route.feedrate, np.roll(route.feedrate, -1)))
    junction = junction._replace(stop=junction.stop | slow, kink=np.where(slow[:, None], 0.0, junction.kink))
    return Survey(junction, kind, ceiling)


def cut(route: Route, surveyed: Survey, limits: AxisLimits, wanted: Flags) -> Pieces:
    """Cut curves of a route into pieces and find the limits of each.

    Parameters
    ----------
    limits : AxisLimits
        For the path's number of axes.
    wanted : ndarray (n_curve,) of bool
        Curves to cut; between two stops either all curves or none.
    """
    junction, kind = surveyed.junctions, surveyed.kind
    nodes = sample_nodes(route, kind, limits, np.flatnonzero(wanted))
    samples = _samples(route, nodes)
    line = kind == LINE
    joined = ~junction.stop & ~np.any(junction.kink != 0.0, axis=1) & line & np.roll(line, -1)
    joined &= route.feedrate == np.roll(route.feedrate, -1)
    joined[-1] = False
    last = _piece_ends(nodes, kind, speed_limit(samples, limits, SHARES[0]), joined)
    within = np.append(nodes.curve[1:] == nodes.curve[:-1], False)[last]  # the piece ends inside a curve
    first = np.concatenate([[0], np.where(within[:-1], last[:-1], last[:-1] + 1)])
    curve = nodes.curve[last]
    breaks = np.asarray(route.path.breaks)
    end = np.where(within, breaks[curve] + np.diff(breaks)[curve] * nodes.place[last], breaks[curve + 1])
    start = np.where(np.append(False, within[:-1]), np.append(0.0, end[:-1]), breaks[nodes.curve[first]])
    stop = junction.stop[curve] & ~within
    counts = last - first + 1
    begins = np.cumsum(counts) - counts
    rows = np.repeat(first - begins, counts) + np.arange(int(counts.sum()))
    stop_ends = np.stack([np.roll(stop, 1), stop], axis=1)
    stop_ends[0, 0] = stop_ends[-1, 1] = True
    length = end - start
    bounds = piece_bounds(Samples(*(part[rows] for part in samples)), begins, length, stop_ends, limits)
    return Pieces(start, length, bounds, stop, np.where(within, np.inf, surveyed.junction_speed[curve]), curve)
