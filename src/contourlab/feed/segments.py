"""Segments from one stop to the next, and the samples along those that are not straight."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from contourlab.feed.limits import AxisLimits
from contourlab.feed.pieces import FLAT, Nodes, Survey, look, nodes_of
from contourlab.feed.route import Route

Array = NDArray[np.float64]
Index = NDArray[np.intp]

N_CURVE = 4  # intervals of a curve at least ...
N_LONG = 96  # ... and for the sake of its length alone at most, ...
N_RAMP = 12  # ... so many to the way in which full speed is reached
CHUNK = 32_768  # samples per pass
WINDOW = 1024  # curves sampled at once
REST = 1e-4  # [m] least length that such a ramp counts with


class Stretches(NamedTuple):
    """Runs of curves from stop to stop, in the order of travel; curve i of lap k has the number i + k n_curve.

    first, after : ndarray (n_stretch,) of int
        The curves [first, after).
    straight : ndarray (n_stretch,) of bool
        Whether all of them are lines in one direction.
    """

    first: Index
    after: Index
    straight: NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Samples:
    """Samples of several stretches, one stretch after another; n in all.

    Where two curves meet there are two samples at one place. `begin` (n_stretch + 1,) holds the first sample of each stretch.

    Parameters
    ----------
    arc_length : ndarray (n,) [m]
    tangent, second, third : ndarray (n, n_axis)
    ceiling : ndarray (n,) [m/s]
        Programmed speed, and that at jumps of curvature.
    begin : ndarray (n_stretch + 1,) of int
    """

    arc_length: Array
    tangent: Array
    second: Array
    third: Array
    ceiling: Array
    begin: Index

    @property
    def ends(self) -> Index:
        """First and last sample of every stretch, where the motion is at rest."""
        return np.concatenate([self.begin[:-1], self.begin[1:] - 1])

    def speed_ceiling(self, limits: AxisLimits, *, held: bool) -> Array:
        """Return the highest speed at each sample (n,) [m/s]; zero where the stretches end.

        Parameters
        ----------
        limits : AxisLimits
            For the path's number of axes.
        held : bool
            Whether the speed must be one that can be held: without acceleration, turning alone is within the limits. So must that of a
            motion that is to be averaged.
        """
        ceiling = self.ceiling.copy()
        for start in range(0, ceiling.size, CHUNK):
            rows = slice(start, start + CHUNK)
            tangent, second, third = (np.abs(part[rows]) for part in (self.tangent, self.second, self.third))
            with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
                lowest = np.fmin.reduce(limits.velocity / tangent, axis=1)
                if held:
                    lowest = np.fmin(lowest, np.sqrt(np.fmin.reduce(limits.acceleration / second, axis=1)))
                    lowest = np.fmin(lowest, np.cbrt(np.fmin.reduce(limits.jerk / third, axis=1)))
                else:
                    # An axis that does not move along the path has no acceleration along it: its share of turning is a limit of speed.
                    still = np.where(tangent < 1e-6, second, 0.0)
                    lowest = np.fmin(lowest, np.sqrt(np.fmin.reduce(limits.acceleration / still, axis=1)))
            ceiling[rows] = np.minimum(ceiling[rows], lowest)
        ceiling[self.ends] = 0.0
        return ceiling


def stretches(seen: Survey, laps: int) -> Stretches:
    """Divide a route at its stops.

    Parameters
    ----------
    seen : Survey
    laps : int

    Returns
    -------
    Stretches
    """
    # The closing point of a lap may be driven through, the end of the last may not.
    stop = np.tile(seen.stop, laps)
    stop[-1] = True
    after = np.flatnonzero(stop) + 1
    first = np.append(0, after[:-1])
    turns = (seen.kind != 0) | np.any(seen.meet.kink != 0.0, axis=1)
    bent = np.add.reduceat(np.tile(turns, laps).astype(np.intp), first)
    return Stretches(first, after, bent == 0)


def ranges(first: Index, count: Index) -> Index:
    """Return the numbers from each `first` on, `count` of them, one range after another."""
    return np.repeat(first - (np.cumsum(count) - count), count) + np.arange(int(count.sum()))


def _gaps(route: Route, seen: Survey, limits: AxisLimits) -> Array:
    """Return the longest interval of samples in each curve [m].

    Next to a stop the speed is low, and what is lost there counts: the way in which the acceleration alone permits full speed is taken for
    the ramp. Elsewhere it is the way that the jerk permits as well, which is longer.
    """
    lengths = np.diff(np.asarray(route.path.breaks))
    speed = np.minimum(route.feedrate, float(np.linalg.norm(limits.velocity)))
    a, j = float(np.min(limits.acceleration)), float(np.min(limits.jerk))
    quick = speed**2 / (2.0 * a)
    eased = np.where(speed * j > a**2, quick + 0.5 * speed * a / j, speed * np.sqrt(speed / j))
    stop = seen.stop
    stop[-1] = True
    ramp = np.maximum(np.where(stop | np.roll(stop, 1), quick, eased), REST)
    return np.asarray(np.minimum(lengths / N_CURVE, np.maximum(ramp / N_RAMP, lengths / N_LONG)))


def _lengths(route: Route, curve: Index) -> Array:
    """Return the lengths of some curves [m]."""
    breaks = np.asarray(route.path.breaks)
    return np.asarray(breaks[curve + 1] - breaks[curve])


def _denser(route: Route, nodes: Nodes, gap: Array) -> Nodes:
    """Divide intervals of the samples that are longer than `gap` (one for each curve) [m]."""
    length = _lengths(route, nodes.curve[:-1])
    same = nodes.curve[1:] == nodes.curve[:-1]
    step = np.where(same, np.diff(nodes.place), 0.0)
    parts = np.maximum(np.ceil(step * length / gap[nodes.curve[:-1]]), 1.0).astype(np.intp)
    at = np.repeat(np.arange(parts.size), parts - 1)
    new = look(route, nodes.curve[at], nodes.place[at] + step[at] * (ranges(np.ones_like(parts), parts - 1)) / parts[at])
    rows = np.concatenate([np.arange(nodes.curve.size), at + 0.5])
    order = np.argsort(rows, kind="stable")
    return Nodes(*(np.concatenate([old, more])[order] for old, more in zip(nodes, new, strict=True)))


def _on_lines(route: Route, nodes: Nodes, gap: Array) -> Nodes:
    """Sample lines, given by their two ends, more densely towards the ends, where speeds change."""
    curve = nodes.curve[::2]
    count = np.ceil(_lengths(route, curve) / gap[curve]).astype(np.intp) + 1
    rows = np.repeat(np.arange(curve.size), count)
    place = 0.5 - 0.5 * np.cos(np.pi * ranges(np.zeros_like(count), count) / (count[rows] - 1.0))
    none = np.zeros((rows.size, nodes.tangent.shape[1]))
    return Nodes(curve[rows], place, nodes.tangent[::2][rows], none, none)


def sampled(route: Route, seen: Survey, limits: AxisLimits, parts: Stretches, chosen: Index) -> Samples:
    """Sample some of the stretches.

    Parameters
    ----------
    route : Route
    seen : Survey
    limits : AxisLimits
    parts : Stretches
    chosen : ndarray of int
        Which of the stretches, rising.

    Returns
    -------
    Samples
    """
    n_curve = route.n_curve
    curves = ranges(parts.first[chosen], parts.after[chosen] - parts.first[chosen])
    lap, own = np.divmod(curves, n_curve)
    once = np.unique(own)
    gap = _gaps(route, seen, limits)
    windows = [_window(route, seen, limits, gap, once[i : i + WINDOW]) for i in range(0, once.size, WINDOW)]
    count_once, arc_length, ceiling, *derivatives = _joined(windows)
    of_curve = np.zeros(n_curve, dtype=np.intp)
    of_curve[once] = count_once
    count = of_curve[own]
    if np.any(lap):
        # Curves that are driven several times, in the order of travel.
        rows = ranges((np.cumsum(of_curve) - of_curve)[own], count)
        arc_length = arc_length[rows] + np.repeat(lap, count) * float(route.path.length)
        ceiling, derivatives = ceiling[rows], [part[rows] for part in derivatives]
    of_stretch = np.append(0, np.cumsum(parts.after[chosen] - parts.first[chosen]))
    begin = np.append(0, np.cumsum(count))[of_stretch]
    # The speed is zero at both ends by itself: the programmed one is what it is held against there.
    ceiling[begin[:-1]] = route.feedrate[own[of_stretch[:-1]]]
    ceiling[begin[1:] - 1] = route.feedrate[own[of_stretch[1:] - 1]]
    return Samples(arc_length, derivatives[0], derivatives[1], derivatives[2], ceiling, begin)


def _window(route: Route, seen: Survey, limits: AxisLimits, gap: Array, curves: Index) -> list[NDArray[Any]]:
    """Return, of some curves: the number of samples of each, then of the samples arc length, ceiling, and three derivatives."""
    first = nodes_of(route, seen.kind, limits, curves)
    found = []
    for line in (True, False):
        here = (seen.kind[first.curve] == 0) == line
        if np.any(here):
            found.append((_on_lines if line else _denser)(route, Nodes(*(part[here] for part in first)), gap))
    order = np.argsort(np.concatenate([part.curve for part in found]), kind="stable")
    curve, place, tangent, second, third = (np.concatenate(part)[order] for part in zip(*found, strict=True))
    ceiling = route.feedrate[curve]
    for end, joint in ((1.0, curve), (0.0, curve - 1)):
        held = (place == end) & ~seen.meet.stop[joint]
        ceiling = np.where(held, np.minimum(ceiling, seen.junction_speed[joint]), ceiling)
    second[np.abs(second) < FLAT] = 0.0
    third[np.abs(third) < FLAT] = 0.0
    arc_length = np.asarray(route.path.breaks)[curve] + place * _lengths(route, curve)
    return [np.bincount(curve - curves[0])[curves - curves[0]], arc_length, ceiling, tangent, second, third]


def _joined(windows: list[list[NDArray[Any]]]) -> list[NDArray[Any]]:
    """Concatenate windows column by column, and free each column when it is done."""
    columns = []
    for _ in range(len(windows[0])):
        parts = [window.pop(0) for window in windows]
        columns.append(np.concatenate(parts, out=np.empty((sum(map(len, parts)), *parts[0].shape[1:]), dtype=parts[0].dtype)))
    return columns
