"""Cut a route into pieces, each with one set of limits, and into segments from one stop to the next, with samples along them.

A line, an arc and a helix are one piece each; successive lines in one direction at one feedrate are joined. Other curves are sampled, more
densely where they turn more, and cut where the permitted speed has changed by the factor `GROUP`. Derivatives are evaluated for the whole
path in a few calls.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from contourlab.arrays import Array, Flags, Index, across, ranges
from contourlab.feed.bounds import SHARES, AxisLimits, Bounds, Samples, piece_bounds, speed_limit
from contourlab.feed.route import NUDGE, Junctions, Route, junction_speed, junctions
from contourlab.geometry.blend import Blends
from contourlab.geometry.curve import CurveBatch
from contourlab.geometry.line_and_arc import Arcs, Lines
from contourlab.native.kernel import kernel

Kinds = NDArray[np.int8]

GROUP = 1.15  # largest factor between permitted speeds within a piece of a general curve
NODES_ARC = 128  # samples per turn of an arc: the worst direction is met within 0.03 %
NODES_BLEND = 17  # samples of a blend; the motion along it is checked between them
NODES_BOUNDS = 33  # of a blend that is planned by bounds, which nothing checks
NODES_FIRST = 65  # samples of a general curve before refinement
TURN = 0.05  # [rad] largest turn between samples of a general curve
STEP = 1.06  # largest factor between permitted speeds of neighbouring samples
DEPTH = 14  # most halvings of an interval
WORTH = 0.5  # of the feedrate: a kink that must be passed more slowly becomes a stop
FLAT = 1e-6  # [1/m, 1/m^2] smaller derivatives are rounding
LINE, ARC, GENERAL, BLEND = range(4)
KIND_OF: dict[type[CurveBatch], int] = {Lines: LINE, Arcs: ARC, Blends: BLEND}


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
    return Nodes(curve, place, *route.path.derivatives(begin + (end - begin) * np.clip(place, NUDGE, 1.0 - NUDGE), 3)[1:])


def _first_nodes(route: Route, kind: Kinds, curves: Index, of_blend: int) -> Nodes:
    """Sample curves before any refinement."""
    middle = evaluate_nodes(route, curves, np.full(curves.size, 0.5))
    sweep = np.linalg.norm(middle.second, axis=1) * (route.path.breaks[curves + 1] - route.path.breaks[curves])
    of_arc = np.maximum(6, 2 + np.ceil(NODES_ARC * sweep / (2.0 * np.pi)))
    count = np.choose(kind[curves], [2, of_arc, NODES_FIRST, of_blend]).astype(np.intp)
    return evaluate_nodes(route, np.repeat(curves, count), ranges(np.zeros_like(count), count) / np.repeat(count - 1.0, count))


def sample_nodes(route: Route, kind: Kinds, limits: AxisLimits, curves: Index, of_blend: int = NODES_BLEND) -> Nodes:
    """Sample curves (rising numbers), both ends included; general curves more densely where they turn more.

    The samples of a curve do not depend on the other curves.
    """
    nodes = _first_nodes(route, kind, curves, of_blend)
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
    _divide(np.array(end_of_curve | (kind[nodes.curve] < GENERAL), dtype=np.int64), permitted, ends)
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
    kind = np.select([route.path.of_kind(batch) for batch in KIND_OF], list(KIND_OF.values()), GENERAL).astype(np.int8)
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
    nodes = sample_nodes(route, kind, limits, np.flatnonzero(wanted), NODES_BOUNDS)
    samples, line = _samples(route, nodes), kind == LINE
    joined = ~junction.stop & ~np.any(junction.kink != 0.0, axis=1) & line & np.roll(line, -1)
    joined &= route.feedrate == np.roll(route.feedrate, -1)
    joined[-1] = False
    last = _piece_ends(nodes, kind, speed_limit(samples, limits, SHARES[0]), joined)
    within = np.append(nodes.curve[1:] == nodes.curve[:-1], False)[last]  # the piece ends inside a curve
    first = np.concatenate([[0], np.where(within[:-1], last[:-1], last[:-1] + 1)])
    curve, breaks = nodes.curve[last], np.asarray(route.path.breaks)
    end = np.where(within, breaks[curve] + np.diff(breaks)[curve] * nodes.place[last], breaks[curve + 1])
    start = np.where(np.append(False, within[:-1]), np.append(0.0, end[:-1]), breaks[nodes.curve[first]])
    stop = junction.stop[curve] & ~within
    counts = last - first + 1
    begins, rows = np.cumsum(counts) - counts, ranges(first, counts)
    stop_ends = np.stack([np.roll(stop, 1), stop], axis=1)
    stop_ends[0, 0] = stop_ends[-1, 1] = True
    length = end - start
    bounds = piece_bounds(Samples(*(part[rows] for part in samples)), begins, length, stop_ends, limits)
    return Pieces(start, length, bounds, stop, np.where(within, np.inf, surveyed.junction_speed[curve]), curve)


N_CURVE = 4  # least number of intervals of a curve
N_LONG = 96  # most intervals that length alone requires
N_RAMP = 12  # intervals over the distance to full speed
CHUNK = 32_768  # samples per pass
WINDOW = 1024  # curves sampled at once
REST = 1e-4  # [m] lower bound of the distance to full speed


class Segments(NamedTuple):
    """Runs of curves from stop to stop, in the order of travel; curve i of lap k has the number i + k n_curve.

    first, after : ndarray (n_segment,) of int
        The curves [first, after).
    straight : ndarray (n_segment,) of bool
        Whether all are lines in one direction.
    """

    first: Index
    after: Index
    straight: Flags


class SegmentSamples(NamedTuple):
    """Samples of several segments, in order; where two curves meet there are two samples at one place.

    arc_length : ndarray (n,) [m]
    tangent, second, third : ndarray (n, n_axis)
    ceiling : ndarray (n,) [m/s]
        Programmed speed, or the speed permitted at a curvature jump.
    begin : ndarray (n_segment + 1,) of int
        First sample of each segment.
    """

    arc_length: Array
    tangent: Array
    second: Array
    third: Array
    ceiling: Array
    begin: Index

    def speed_ceiling(self, limits: AxisLimits, *, steady: bool) -> Array:
        """Return the highest speed at each sample (n,) [m/s]; zero at the ends of segments.

        Parameters
        ----------
        limits : AxisLimits
            For the path's number of axes.
        steady : bool
            Whether turning alone must respect the limits at constant speed. A motion that will be averaged needs this.
        """
        ceiling = self.ceiling.copy()
        for start in range(0, ceiling.size, CHUNK):
            rows = slice(start, start + CHUNK)
            tangent, second, third = (np.abs(part[rows]) for part in (self.tangent, self.second, self.third))
            with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
                lowest = across(np.fmin, limits.velocity / tangent)
                # An axis at right angles to the path has no tangential acceleration: there turning limits the speed.
                turning = second if steady else np.where(tangent < 1e-6, second, 0.0)
                lowest = np.fmin(lowest, np.sqrt(across(np.fmin, limits.acceleration / turning)))
                if steady:
                    lowest = np.fmin(lowest, np.cbrt(across(np.fmin, limits.jerk / third)))
            ceiling[rows] = np.minimum(ceiling[rows], lowest)
        ceiling[self.begin[:-1]] = ceiling[self.begin[1:] - 1] = 0.0
        return ceiling


def split_at_stops(surveyed: Survey, laps: int) -> Segments:
    """Divide the laps of a route at its stops."""
    # The motion may pass the closing point between laps; the end of the last lap is a stop.
    stop = np.tile(surveyed.stop, laps)
    stop[-1] = True
    after = np.flatnonzero(stop) + 1
    first = np.append(0, after[:-1])
    turns = (surveyed.kind != LINE) | np.any(surveyed.junctions.kink != 0.0, axis=1)
    return Segments(first, after, np.add.reduceat(np.tile(turns, laps).astype(np.intp), first) == 0)


def _longest_intervals(route: Route, surveyed: Survey, limits: AxisLimits) -> Array:
    """Return the longest interval between samples of each curve [m].

    It depends on the distance to full speed. Next to a stop only the acceleration limit determines this distance, because time lost at low
    speed matters; elsewhere the jerk limit lengthens it.
    """
    lengths = np.diff(np.asarray(route.path.breaks))
    speed = np.minimum(route.feedrate, float(np.linalg.norm(limits.velocity)))
    a, j = float(np.min(limits.acceleration)), float(np.min(limits.jerk))
    by_acceleration = speed**2 / (2.0 * a)
    by_jerk = np.where(speed * j > a**2, by_acceleration + 0.5 * speed * a / j, speed * np.sqrt(speed / j))
    stop = surveyed.stop
    stop[-1] = True
    ramp = np.maximum(np.where(stop | np.roll(stop, 1), by_acceleration, by_jerk), REST)
    return np.asarray(np.minimum(lengths / N_CURVE, np.maximum(ramp / N_RAMP, lengths / N_LONG)))


def _lengths(route: Route, curve: Index) -> Array:
    """Return the lengths of some curves [m]."""
    breaks = np.asarray(route.path.breaks)
    return np.asarray(breaks[curve + 1] - breaks[curve])


def _refined(route: Route, nodes: Nodes, longest: Array) -> Nodes:
    """Divide the intervals that are longer than `longest` (one for each curve) [m]."""
    curve = nodes.curve[:-1]
    step = np.where(nodes.curve[1:] == curve, np.diff(nodes.place), 0.0)
    parts = np.maximum(np.ceil(step * _lengths(route, curve) / longest[curve]), 1.0).astype(np.intp)
    at = np.repeat(np.arange(parts.size), parts - 1)
    new = evaluate_nodes(route, curve[at], nodes.place[at] + step[at] * (ranges(np.ones_like(parts), parts - 1)) / parts[at])
    order = np.argsort(np.concatenate([np.arange(nodes.curve.size), at + 0.5]), kind="stable")
    return Nodes(*(np.concatenate([old, more])[order] for old, more in zip(nodes, new, strict=True)))


def _on_lines(route: Route, nodes: Nodes, longest: Array) -> Nodes:
    """Sample lines, given by their two ends, more densely towards the ends, where the speed changes."""
    curve = nodes.curve[::2]
    count = np.ceil(_lengths(route, curve) / longest[curve]).astype(np.intp) + 1
    rows = np.repeat(np.arange(curve.size), count)
    place = 0.5 - 0.5 * np.cos(np.pi * ranges(np.zeros_like(count), count) / (count[rows] - 1.0))
    zero = np.zeros((rows.size, nodes.tangent.shape[1]))
    return Nodes(curve[rows], place, nodes.tangent[::2][rows], zero, zero)


def sample_segments(route: Route, surveyed: Survey, limits: AxisLimits, segments: Segments, chosen: Index) -> SegmentSamples:
    """Sample some segments (rising numbers)."""
    n_curve, n_chosen = route.n_curve, segments.after[chosen] - segments.first[chosen]
    lap, curve = np.divmod(ranges(segments.first[chosen], n_chosen), n_curve)
    once, longest = np.unique(curve), _longest_intervals(route, surveyed, limits)
    windows = [_window(route, surveyed, limits, longest, once[i : i + WINDOW]) for i in range(0, once.size, WINDOW)]
    count_once, arc_length, ceiling, *derivatives = _joined(windows)
    of_curve = np.zeros(n_curve, dtype=np.intp)
    of_curve[once] = count_once
    count = of_curve[curve]
    if np.any(lap):
        # Repeat curves that are driven several times, in the order of travel.
        rows = ranges((np.cumsum(of_curve) - of_curve)[curve], count)
        arc_length = arc_length[rows] + np.repeat(lap, count) * float(route.path.length)
        ceiling, derivatives = ceiling[rows], [part[rows] for part in derivatives]
    first_curve = np.append(0, np.cumsum(n_chosen))
    begin = np.append(0, np.cumsum(count))[first_curve]
    # The speed is zero at both ends anyway; the check there compares with the programmed speed.
    ceiling[begin[:-1]] = route.feedrate[curve[first_curve[:-1]]]
    ceiling[begin[1:] - 1] = route.feedrate[curve[first_curve[1:] - 1]]
    tangent, second, third = derivatives
    return SegmentSamples(arc_length, tangent, second, third, ceiling, begin)


def _window(route: Route, surveyed: Survey, limits: AxisLimits, longest: Array, curves: Index) -> list[NDArray[Any]]:
    """Sample curves; return the number of samples of each curve, then arc length, ceiling and three derivatives of the samples."""
    first = sample_nodes(route, surveyed.kind, limits, curves)
    sets = []
    for line in (True, False):
        here = (surveyed.kind[first.curve] == LINE) == line
        if np.any(here):
            sets.append((_on_lines if line else _refined)(route, Nodes(*(part[here] for part in first)), longest))
    order = np.argsort(np.concatenate([part.curve for part in sets]), kind="stable")
    curve, place, tangent, second, third = (np.concatenate(part)[order] for part in zip(*sets, strict=True))
    ceiling = route.feedrate[curve]
    for end, junction in ((1.0, curve), (0.0, curve - 1)):
        passed = (place == end) & ~surveyed.junctions.stop[junction]
        ceiling = np.where(passed, np.minimum(ceiling, surveyed.junction_speed[junction]), ceiling)
    arc_length = np.asarray(route.path.breaks)[curve] + place * _lengths(route, curve)
    count = np.bincount(curve - curves[0])[curves - curves[0]]
    return [count, arc_length, ceiling, tangent, without_rounding(second), without_rounding(third)]


def _joined(windows: list[list[NDArray[Any]]]) -> list[NDArray[Any]]:
    """Concatenate windows column by column, and free each column when it is done."""
    columns = []
    for _ in range(len(windows[0])):
        parts = [window.pop(0) for window in windows]
        columns.append(np.concatenate(parts, out=np.empty((sum(map(len, parts)), *parts[0].shape[1:]), dtype=parts[0].dtype)))
    return columns
