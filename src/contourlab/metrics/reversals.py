"""Reversal spikes: the contour error that friction causes where an axis reverses."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby

import numpy as np

from contourlab.arrays import BLOCK, Array, ranges
from contourlab.feed import Reference
from contourlab.geometry import Arc, Curve
from contourlab.metrics.judge import furthest, reach
from contourlab.result import Result

_BEFORE = 5


@dataclass(frozen=True, slots=True)
class Spike:
    """One reversal of one axis.

    Attributes
    ----------
    axis : str
    time : float [s]
        Time at which the reference reverses.
    sample : int
    quadrant : int
        1 to 4: quadrant of a round path in the plane that starts at the reversal; 0 in space, or if the other axis is at rest.
    height : float [m]
        Largest difference between contour error and local baseline, positive to the left of the path. In space the distance between the
        two vectors, if the reference was given.
    peak_time : float [s]
    width : float [s]
        Time over which the difference stays above half the height.
    direction : int
        Direction of the axis after the reversal: 1 or -1.
    angle : float [rad]
        Place on an arc in a plane of the axes, from the first axis (XY, YZ, ZX): 0, pi/2, pi or 3 pi/2; NaN elsewhere, or without a
        reference.
    """

    axis: str
    time: float
    sample: int
    quadrant: int
    height: float
    peak_time: float
    width: float
    direction: int = 0
    angle: float = math.nan


@dataclass(frozen=True, slots=True)
class ReversalFigures:
    """The spikes of one axis that reverses to one direction, at one place of arcs or elsewhere.

    Attributes
    ----------
    direction : int
        Direction after the reversal: 1 or -1.
    angle : float [rad]
        On arcs: 0, pi/2, pi or 3 pi/2; NaN elsewhere.
    mean, largest : float [m]
        Mean and largest magnitude of the heights.
    largest_time : float [s]
        Time of the reversal with the largest spike.
    duration : float [s]
        Mean width.
    """

    axis: str
    direction: int
    angle: float
    count: int
    mean: float
    largest: float
    largest_time: float
    duration: float


def reversal_spikes(
    result: Result, window: tuple[int, int] | None = None, longest: float = 0.25, reference: Reference | None = None
) -> tuple[Spike, ...]:
    """Return the spikes of the contour error at the reversals of each axis, in order of time.

    Parameters
    ----------
    result : Result
        With ``contour_error`` and ``reference_velocity``.
    window : (int, int), optional
        Samples [start, stop) to search.
    longest : float [s]
        Longest time from a reversal to its spike.
    reference : Reference, optional
        Gives the place of a reversal on an arc, and in space the direction of the error; needs all signals of the judge.

    Returns
    -------
    tuple of Spike

    Notes
    -----
    The search runs from the reversal halfway to the next one, at most `longest`. The baseline is the line from the mean of the five samples
    before the reversal to the mean of the last five samples of the search.
    """
    start, stop = window or (0, result.n_sample)
    turns = sorted((k, j) for j in range(len(result.axes)) for k in _turns(result, j) if start <= k < stop)
    samples = [k for k, _ in turns]
    distinct = np.unique(samples)
    following = np.append(distinct, stop)[np.searchsorted(distinct, samples, side="right")].tolist()
    most = int(longest / result.servo_period)
    ends = [min(k + max((next_ - k) // 2, 4 * _BEFORE), k + most, result.n_sample) for k, next_ in zip(samples, following, strict=True)]
    searches = [(k, end, j) for (k, j), end in zip(turns, ends, strict=True) if k >= _BEFORE and end - k > 2 * _BEFORE]
    errors = _errors(result, reference, [(k - _BEFORE, end) for k, end, _ in searches])
    angles, velocity = [math.nan] * len(searches), result.at("reference_velocity", np.array([k for k, _, _ in searches], dtype=np.int64))
    if reference is not None:
        angles = _angles(result, reference, [(k, j, float(after[j])) for (k, _, j), after in zip(searches, velocity, strict=True)])
    found = zip(searches, errors, velocity, angles, strict=True)
    return tuple(_spike(result, error, after, k, j, angle) for (k, _, j), error, after, angle in found)


def _errors(result: Result, reference: Reference | None, spans: Sequence[tuple[int, int]]) -> Iterator[Array]:
    """Yield the signed contour error (n, 1) in spans of samples in order; in space the vector (n, n_axis) from the path to the tool."""
    if reference is None or reference.path.is_planar:
        yield from (result["contour_error"][start:stop, None] for start, stop in spans)
        return
    path, window = reference.path, math.inf
    if reference.programmed is not path:
        window = reach(path, max(furthest(part["reference"] - part["tool_position"]) for part in result.blocks()))
    for _, group in groupby(spans, key=lambda span: span[0] // BLOCK):
        first, count = np.array([(start, stop - start) for start, stop in group]).T
        here = ranges(first, count)
        tool = result["tool_position"][here]
        if reference.programmed is path:
            foot = path.position(result["foot_arc_length"][here])
        else:
            foot = path.foot_point(tool, result["arc_length"][here], window).position
        yield from np.split(tool - foot, np.cumsum(count)[:-1])


def reversal_figures(spikes: Sequence[Spike], *, places: bool = True) -> tuple[ReversalFigures, ...]:
    """Return the figures of spikes by axis, direction and, with `places`, place on arcs; those on arcs come first.

    Without `places` the angle is NaN unless all spikes of an axis and direction have the same.
    """
    groups: dict[tuple[str, int, float | None], list[Spike]] = {}
    for spike in spikes:
        angle = spike.angle if places and math.isfinite(spike.angle) else None
        groups.setdefault((spike.axis, spike.direction, angle), []).append(spike)
    figures = []
    for (axis, direction, _), group in groups.items():
        heights, angle = np.array([abs(spike.height) for spike in group]), group[0].angle
        worst, width = int(heights.argmax()), float(np.mean([spike.width for spike in group]))
        of_group = (float(heights.mean()), float(heights[worst]), group[worst].time, width)
        same = all(spike.angle == angle for spike in group)
        figures.append(ReversalFigures(axis, direction, angle if same else math.nan, len(group), *of_group))
    return tuple(sorted(figures, key=lambda f: (math.isnan(f.angle), np.nan_to_num(f.angle), f.axis, -f.direction)))


def _angles(result: Result, reference: Reference, turns: Sequence[tuple[int, int, float]]) -> list[float]:
    """Return the place on an arc of each turn (sample, axis, velocity afterwards), NaN for a turn that is not on an arc."""
    path = reference.programmed
    samples = np.array([k for k, _, _ in turns], dtype=np.int64)
    ends = (reference.programmed_arc_length(result.at("arc_length", np.maximum(samples - back, 0))) for back in (1, 0))
    pairs = list(zip(*(path.curve_index(along).tolist() for along in ends), strict=True))
    planes = {pair: _common_plane(path.curves[pair[0]], path.curves[pair[1]]) for pair in set(pairs)}
    # An axis turns back where it is farthest out.
    return [
        (0.0 if velocity < 0.0 else math.pi) + 0.5 * math.pi * planes[pair].index(j) if j in planes[pair] else math.nan
        for (_, j, velocity), pair in zip(turns, pairs, strict=True)
    ]


def _common_plane(one: Curve, other: Curve) -> tuple[int, ...]:
    """Return the two axes in whose plane two curves are arcs of one circle, in the order XY, YZ, ZX; empty if they are not, or tilted."""
    if not (isinstance(one, Arc) and isinstance(other, Arc)):
        return ()
    if abs(one.radius - other.radius) > 1e-9 or not np.allclose(one.centre, other.centre, rtol=0.0, atol=1e-9):
        return ()
    if other.n_axis == 2:
        return 0, 1
    moved = np.flatnonzero(np.abs(np.array([other.u, other.v])).max(axis=0) > 1e-9).tolist()
    return next((plane for plane in ((0, 1), (1, 2), (2, 0)) if sorted(plane) == moved), ())


def _turns(result: Result, j: int) -> list[int]:
    """Return the samples at which the reference of axis j has changed its direction, ignoring standstill."""
    turns, last = list[int](), 0.0
    for part in result.blocks():
        velocity = part["reference_velocity"][:, j]
        moving = np.flatnonzero(velocity)
        sign = np.sign(velocity[moving])
        before = np.append(last, sign)[:-1]
        turns += (part.start - result.start + moving[(sign != before) & (before != 0.0)]).tolist()
        last = sign[-1] if sign.size else last
    return turns


def _spike(result: Result, error: Array, velocity: Array, k: int, j: int, angle: float) -> Spike:
    """Return the spike of axis j that reverses at sample k, from the errors since `_BEFORE` samples earlier."""
    low, high = error[:_BEFORE].mean(axis=0), error[-_BEFORE:].mean(axis=0)
    away = error[_BEFORE:] - np.linspace(low, high, len(error) - _BEFORE)
    size = np.linalg.norm(away, axis=1)
    peak = int(np.argmax(size))
    below = np.flatnonzero(~(size >= 0.5 * size[peak]))
    left, right = below[below < peak].max(initial=-1), below[below > peak].min(initial=len(size))
    period = result.servo_period
    time = (k + result.start) * period
    height = float(away[peak, 0] if away.shape[1] == 1 else size[peak])
    spike = (height, time + peak * period, int(right - left - 1) * period, int(np.sign(velocity[j])), angle)
    return Spike(result.axes[j], time, k + result.start, _quadrant(velocity, j), *spike)


def _quadrant(velocity: Array, j: int) -> int:
    """Return the quadrant of a round path that starts where axis j reverses, with the velocity afterwards."""
    if velocity.size != 2 or not velocity.all():
        return 0
    x, y = (int(np.sign(v)) for v in velocity)
    counter_clockwise = {(1, 1): 4, (-1, 1): 1, (-1, -1): 2, (1, -1): 3}[x, y]
    # A clockwise run has the same velocity in the opposite quadrant; the sign of x y and the axis give the sense.
    return counter_clockwise if (x * y > 0) == (j == 1) else (counter_clockwise + 1) % 4 + 1
