"""Samples of those stretches, from one stop to the next, that hold a general curve."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from contourlab.feed.pieces import Nodes, Survey, look
from contourlab.feed.route import Route
from contourlab.feed.smooth import Stretch

__all__ = ["general_stretches"]

Array = NDArray[np.float64]

N_MIN = 400  # intervals of a stretch at least
N_CURVE = 8  # intervals of a curve at least


def _denser(route: Route, nodes: Nodes, gap: Array) -> Nodes:
    """Divide intervals of the samples that are longer than `gap` (one for each curve) [m]."""
    lengths = np.diff(np.asarray(route.path.breaks))
    same = nodes.curve[1:] == nodes.curve[:-1]
    step = np.where(same, np.diff(nodes.place), 0.0)
    parts = np.maximum(np.ceil(step * lengths[nodes.curve[:-1]] / gap[nodes.curve[:-1]]), 1.0).astype(np.intp)
    extra = parts - 1
    at = np.repeat(np.arange(parts.size), extra)
    order = np.arange(at.size) - np.repeat(np.cumsum(extra) - extra, extra) + 1
    new = look(route, nodes.curve[at], nodes.place[at] + step[at] * order / parts[at])
    return Nodes(*(np.insert(old, at + 1, more, axis=0) for old, more in zip(nodes, new, strict=True)))


def _stretch(route: Route, seen: Survey, curves: NDArray[np.intp]) -> Stretch:
    """Return the samples of consecutive curves, which may run over several laps."""
    breaks = np.asarray(route.path.breaks)
    lengths = np.diff(breaks)
    n_curve, lap_length = lengths.size, float(route.path.length)
    gap = np.minimum(float(lengths[curves % n_curve].sum()) / N_MIN, lengths / N_CURVE)
    lap_curves = np.unique(curves % n_curve)
    here = np.isin(seen.nodes.curve, lap_curves)
    curve, *others = seen.nodes
    nodes = _denser(route, Nodes(curve[here], *(part[here] for part in others)), gap)
    ends = np.minimum(seen.joint_speed, np.where(seen.meet.stop, 0.0, np.inf))
    ceiling = route.feedrate[nodes.curve]
    ceiling = np.where(nodes.place == 1.0, np.minimum(ceiling, ends[nodes.curve]), ceiling)
    ceiling = np.where(nodes.place == 0.0, np.minimum(ceiling, ends[nodes.curve - 1]), ceiling)
    # The samples of each curve, in the order of travel.
    first = np.searchsorted(nodes.curve, curves % n_curve)
    count = np.searchsorted(nodes.curve, curves % n_curve, side="right") - first
    rows = np.repeat(first - (np.cumsum(count) - count), count) + np.arange(int(count.sum()))
    lap = np.repeat(curves // n_curve, count)
    arc_length = breaks[nodes.curve[rows]] + nodes.place[rows] * lengths[nodes.curve[rows]] + lap * lap_length
    ceiling = ceiling[rows]
    ceiling[[0, -1]] = route.feedrate[curves[[0, -1]] % n_curve]
    return Stretch(arc_length, nodes.tangent[rows], nodes.second[rows], nodes.third[rows], ceiling)


def general_stretches(route: Route, seen: Survey, laps: int) -> Iterator[Stretch]:
    """Yield the stretches with general curves in the order of travel.

    Parameters
    ----------
    route : Route
    seen : Survey
    laps : int

    Yields
    ------
    Stretch
    """
    if not np.any(seen.kind == 2):
        return
    stop = np.tile(seen.meet.stop | (seen.joint_speed == 0.0), laps)
    stop[-1] = True
    general = np.tile(seen.kind == 2, laps)
    ends = np.flatnonzero(stop) + 1
    starts = np.append(0, ends[:-1])
    holds = np.add.reduceat(general.astype(np.intp), starts) > 0
    for start, end in zip(starts[holds].tolist(), ends[holds].tolist(), strict=True):
        yield _stretch(route, seen, np.arange(start, end))
