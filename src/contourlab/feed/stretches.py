"""Stretches: what is driven from one stop to the next, and the samples along those that are not straight."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from contourlab.feed.limits import AxisLimits
from contourlab.feed.pieces import FLAT, Nodes, Survey, look
from contourlab.feed.route import Route

__all__ = ["Samples", "Stretches", "sampled", "stretches"]

Array = NDArray[np.float64]
Index = NDArray[np.intp]

N_CURVE = 4  # intervals of a curve at least ...
N_LONG = 96  # ... and for the sake of its length alone at most, ...
N_RAMP = 12  # ... so many to the way in which full speed is reached
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
    stop = np.tile(seen.meet.stop | (seen.joint_speed == 0.0), laps)
    stop[-1] = True
    after = np.flatnonzero(stop) + 1
    first = np.append(0, after[:-1])
    turns = (seen.kind != 0) | np.any(seen.meet.kink != 0.0, axis=1)
    bent = np.add.reduceat(np.tile(turns, laps).astype(np.intp), first)
    return Stretches(first, after, bent == 0)


def ranges(first: Index, count: Index) -> Index:
    """Return the numbers from each `first` on, `count` of them, one range after another."""
    return np.repeat(first - (np.cumsum(count) - count), count) + np.arange(int(count.sum()))


def _gaps(route: Route, limits: AxisLimits) -> Array:
    """Return the longest interval of samples in each curve [m]."""
    lengths = np.diff(np.asarray(route.path.breaks))
    speed = np.minimum(route.feedrate, float(np.linalg.norm(limits.velocity)))
    ramp = np.maximum(speed**2 / (2.0 * float(np.min(limits.acceleration))), REST)
    return np.asarray(np.minimum(lengths / N_CURVE, np.maximum(ramp / N_RAMP, lengths / N_LONG)))


def _denser(route: Route, nodes: Nodes, gap: Array) -> Nodes:
    """Divide intervals of the samples that are longer than `gap` (one for each curve) [m]."""
    lengths = np.diff(np.asarray(route.path.breaks))
    same = nodes.curve[1:] == nodes.curve[:-1]
    step = np.where(same, np.diff(nodes.place), 0.0)
    parts = np.maximum(np.ceil(step * lengths[nodes.curve[:-1]] / gap[nodes.curve[:-1]]), 1.0).astype(np.intp)
    at = np.repeat(np.arange(parts.size), parts - 1)
    new = look(route, nodes.curve[at], nodes.place[at] + step[at] * (ranges(np.ones_like(parts), parts - 1)) / parts[at])
    rows = np.concatenate([np.arange(nodes.curve.size), at + 0.5])
    order = np.argsort(rows, kind="stable")
    return Nodes(*(np.concatenate([old, more])[order] for old, more in zip(nodes, new, strict=True)))


def _on_lines(route: Route, nodes: Nodes, gap: Array) -> Nodes:
    """Sample lines, given by their two ends, more densely towards the ends, where speeds change."""
    curve = nodes.curve[::2]
    count = np.ceil(np.diff(np.asarray(route.path.breaks))[curve] / gap[curve]).astype(np.intp) + 1
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
    n_curve, lengths = route.n_curve, np.diff(np.asarray(route.path.breaks))
    curves = ranges(parts.first[chosen], parts.after[chosen] - parts.first[chosen])
    wanted = np.zeros(n_curve, dtype=bool)
    wanted[curves % n_curve] = True
    gap = _gaps(route, limits)
    found = []
    for line in (True, False):
        here = wanted[seen.nodes.curve] & ((seen.kind[seen.nodes.curve] == 0) == line)
        if np.any(here):
            found.append((_on_lines if line else _denser)(route, Nodes(*(part[here] for part in seen.nodes)), gap))
    order = np.argsort(np.concatenate([part.curve for part in found]), kind="stable")
    nodes = Nodes(*(np.concatenate(part)[order] for part in zip(*found, strict=True)))
    ends = np.where(seen.meet.stop, np.inf, seen.joint_speed)
    ceiling = route.feedrate[nodes.curve]
    ceiling = np.where(nodes.place == 1.0, np.minimum(ceiling, ends[nodes.curve]), ceiling)
    ceiling = np.where(nodes.place == 0.0, np.minimum(ceiling, ends[nodes.curve - 1]), ceiling)
    # The samples of each curve, in the order of travel.
    first = np.searchsorted(nodes.curve, curves % n_curve)
    count = np.searchsorted(nodes.curve, curves % n_curve, side="right") - first
    rows = ranges(first, count)
    lap = np.repeat(curves // n_curve, count) * float(route.path.length)
    arc_length = np.asarray(route.path.breaks)[nodes.curve[rows]] + nodes.place[rows] * lengths[nodes.curve[rows]] + lap
    of_stretch = np.append(0, np.cumsum(parts.after[chosen] - parts.first[chosen]))
    begin = np.append(0, np.cumsum(count))[of_stretch]
    ceiling = ceiling[rows]
    # The speed is zero at both ends by itself: the programmed one is what it is held against there.
    both = np.concatenate([begin[:-1], begin[1:] - 1])
    ceiling[both] = route.feedrate[nodes.curve[rows[both]]]
    second, third = nodes.second[rows], nodes.third[rows]
    second[np.abs(second) < FLAT] = 0.0
    third[np.abs(third) < FLAT] = 0.0
    return Samples(arc_length, nodes.tangent[rows], second, third, ceiling, begin)
