"""Segments from one stop to the next, and samples along those that are not straight."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from contourlab.arrays import Array, Flags, Index, across
from contourlab.feed.limits import AxisLimits
from contourlab.feed.pieces import LINE, Nodes, Survey, evaluate_nodes, sample_nodes, without_rounding
from contourlab.feed.route import Route

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
    bent = np.add.reduceat(np.tile(turns, laps).astype(np.intp), first)
    return Segments(first, after, bent == 0)


def ranges(first: Index, count: Index) -> Index:
    """Return `count` successive numbers from each `first`, one range after another."""
    return np.repeat(first - (np.cumsum(count) - count), count) + np.arange(int(count.sum()))


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
    once = np.unique(curve)
    longest = _longest_intervals(route, surveyed, limits)
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
