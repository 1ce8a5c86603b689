"""Reversal spikes: what friction does to the contour where an axis turns round."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.feed import Reference
from contourlab.geometry import Arc, Curve
from contourlab.metrics.judge import reach
from contourlab.result import Result

Array = NDArray[np.float64]
_BEFORE = 5


@dataclass(frozen=True, slots=True)
class Spike:
    """One reversal of one axis.

    Attributes
    ----------
    axis : str
    time : float [s]
        Of the reversal of the reference.
    sample : int
    quadrant : int
        1 to 4 in the plane, entered at the reversal on a round path, whichever way it is run; 0 in space, or where the other axis stands.
    height : float [m]
        Largest distance of the contour error from its local baseline, signed: positive to the left of the path. In space, where the
        contour error has no side, the distance between two vectors, if the reference was given.
    peak_time : float [s]
    width : float [s]
        Time over which the distance stays above half the height.
    direction : int
        In which the axis goes on: 1 or -1.
    angle : float [rad]
        Of the place on an arc in a plane of the axes, from its first axis (XY, YZ, ZX): 0, pi/2, pi or 3 pi/2; NaN elsewhere, and where the
        reference was not given.
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
    """The spikes of one axis that turns in one direction, at one place of arcs or elsewhere.

    Attributes
    ----------
    axis : str
    direction : int
        In which the axis goes on: 1 or -1.
    angle : float [rad]
        On arcs: 0, pi/2, pi or 3 pi/2; NaN elsewhere.
    count : int
    mean, largest : float [m]
        Of the magnitude of their heights.
    largest_time : float [s]
        Of the reversal with the largest.
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
        Samples [start, stop) to look at.
    longest : float [s]
        How long after a reversal a spike is looked for.
    reference : Reference, optional
        Says where on an arc a reversal lies, and in space which way the error points; the result is then one of the judge, with all of
        its signals.

    Notes
    -----
    A spike is looked for from the reversal to half the way to the next one, at most `longest`. Its baseline is the straight line from
    the mean of the five samples before the reversal to that of the last five of this stretch.
    """
    start, stop = window or (0, result.n_sample)
    velocity = result["reference_velocity"]
    turns = sorted((k, j) for j in range(len(result.axes)) for k in _turns(velocity[:, j]) if start <= k < stop)
    moments = np.unique([k for k, _ in turns])
    following = np.append(moments, stop)[np.searchsorted(moments, [k for k, _ in turns], side="right")]
    arcs = None if reference is None else _Arcs(result, reference, [k for k, _ in turns])
    longest_away = int(longest / result.servo_period)
    ends = [min(k + max((int(following[i]) - k) // 2, 4 * _BEFORE), k + longest_away, result.n_sample) for i, (k, _) in enumerate(turns)]
    seen = [(i, k, end, j) for i, ((k, j), end) in enumerate(zip(turns, ends, strict=True)) if k >= _BEFORE and end - k > 2 * _BEFORE]
    errors = _Errors(result, reference, [(k - _BEFORE, end) for _, k, end, _ in seen])
    return tuple(
        _spike(result, errors, velocity[k], (k, end), j, math.nan if arcs is None else arcs.angle(i, j, velocity[k, j]))
        for i, k, end, j in seen
    )


class _Errors:
    """The contour error (n, 1) with its sign; in space, where it has none, the vector (n, n_axis) from the path, around some stretches."""

    def __init__(self, result: Result, reference: Reference | None, stretches: Sequence[tuple[int, int]]) -> None:
        self.samples: NDArray[np.int64] | None = None
        self.values = result["contour_error"][:, None]
        if reference is None or reference.path.is_planar or not stretches:
            return
        marked = np.zeros(result.n_sample, dtype=bool)
        for start, stop in stretches:
            marked[start:stop] = True
        self.samples = here = np.flatnonzero(marked)
        path, tool = reference.path, result["tool_position"][here]
        if reference.programmed is path:
            foot = path.position(result["foot_arc_length"][here])
        else:
            foot = path.foot_point(tool, result["arc_length"][here], reach(path, result["reference"][here] - tool)).position
        self.values = tool - foot

    def of(self, start: int, stop: int) -> Array:
        """Return the errors of samples [start, stop), which lie in one of the stretches."""
        first = start if self.samples is None else int(np.searchsorted(self.samples, start))
        return np.asarray(self.values[first : first + stop - start])


def reversal_figures(spikes: Sequence[Spike], *, places: bool = True) -> tuple[ReversalFigures, ...]:
    """Return the figures of spikes by axis, direction and, unless `places` is false, place on arcs; those on arcs come first.

    Without `places` the angle is that of all spikes of an axis and direction if they share one, else NaN.
    """
    groups: dict[tuple[str, int, float | None], list[Spike]] = {}
    for spike in spikes:
        angle = spike.angle if places and math.isfinite(spike.angle) else None
        groups.setdefault((spike.axis, spike.direction, angle), []).append(spike)
    found = [_figures_of(group) for group in groups.values()]
    return tuple(sorted(found, key=lambda f: (math.isnan(f.angle), np.nan_to_num(f.angle), f.axis, -f.direction)))


def _figures_of(group: Sequence[Spike]) -> ReversalFigures:
    first, heights = group[0], np.array([abs(spike.height) for spike in group])
    angle = first.angle if all(spike.angle == first.angle for spike in group) else math.nan
    worst, width = int(heights.argmax()), float(np.mean([spike.width for spike in group]))
    figures = (float(heights.mean()), float(heights[worst]), group[worst].time, width)
    return ReversalFigures(first.axis, first.direction, angle, len(group), *figures)


class _Arcs:
    """On which arc of the programmed path each of some samples lies."""

    def __init__(self, result: Result, reference: Reference, samples: Sequence[int]) -> None:
        self.path = reference.programmed
        here = np.asarray(samples, dtype=np.int64)
        ends = (reference.programmed_arc_length(result["arc_length"][np.maximum(here - back, 0)]) for back in (0, 1))
        self.here, self.before = (self.path.curve_index(along) for along in ends)

        self._planes: dict[tuple[int, int], tuple[int, ...]] = {}

    def angle(self, i: int, j: int, velocity: float) -> float:
        """Return the place at which axis j turns at sample i, to go on with a velocity; NaN where that is on no arc."""
        pair = int(self.before[i]), int(self.here[i])
        if pair not in self._planes:
            self._planes[pair] = _common_plane(self.path.curves[pair[0]], self.path.curves[pair[1]])
        plane = self._planes[pair]
        if j not in plane:
            return math.nan
        # An axis turns back where it is farthest out.
        return (0.0 if velocity < 0.0 else math.pi) + 0.5 * math.pi * plane.index(j)


def _common_plane(one: Curve, other: Curve) -> tuple[int, ...]:
    """Return the two axes in whose plane two curves are arcs of one circle; none where they are not."""
    if not (isinstance(one, Arc) and isinstance(other, Arc)):
        return ()
    same = abs(one.radius - other.radius) <= 1e-9 and np.allclose(one.centre, other.centre, rtol=0.0, atol=1e-9)
    return _plane(other) if same else ()


def _plane(arc: Arc) -> tuple[int, ...]:
    """Return the two axes in whose plane an arc turns, in the order XY, YZ, ZX; none where it is tilted."""
    if arc.n_axis == 2:
        return 0, 1
    moved = np.flatnonzero(np.abs(np.array([arc.u, arc.v])).max(axis=0) > 1e-9).tolist()
    return next((plane for plane in ((0, 1), (1, 2), (2, 0)) if sorted(plane) == moved), ())


def _turns(velocity: Array) -> list[int]:
    """Return the samples at which a velocity has changed its sign, standstill in between passed over."""
    moving = np.flatnonzero(velocity != 0.0)
    sign = np.sign(velocity[moving])
    return [int(k) for k in moving[1:][sign[1:] != sign[:-1]]]


def _spike(result: Result, errors: _Errors, velocity: Array, stretch: tuple[int, int], j: int, angle: float) -> Spike:
    k, end = stretch
    error = errors.of(k - _BEFORE, end)
    low, high = error[:_BEFORE].mean(axis=0), error[-_BEFORE:].mean(axis=0)
    away = error[_BEFORE:] - np.linspace(low, high, end - k)
    size = np.linalg.norm(away, axis=1)
    peak = int(np.argmax(size))
    above = size >= 0.5 * size[peak]
    left, right = peak, peak
    while left > 0 and above[left - 1]:
        left -= 1
    while right + 1 < len(above) and above[right + 1]:
        right += 1
    period = result.servo_period
    time = (k + result.start) * period
    height = float(away[peak, 0] if away.shape[1] == 1 else size[peak])
    spike = (height, time + peak * period, (right - left + 1) * period, int(np.sign(velocity[j])), angle)
    return Spike(result.axes[j], time, k + result.start, _quadrant(velocity, j), *spike)


def _quadrant(velocity: Array, j: int) -> int:
    """Return the quadrant of a round path in which it goes on with `velocity` after axis j has turned."""
    if velocity.size != 2 or not velocity.all():
        return 0
    x, y = (int(np.sign(v)) for v in velocity)
    counter_clockwise = {(1, 1): 4, (-1, 1): 1, (-1, -1): 2, (1, -1): 3}[x, y]
    # The velocity of a quarter is that of the opposite one run the other way; to the left means one sign of x y for each axis.
    left = (x * y > 0) == (j == 1)
    return counter_clockwise if left else (counter_clockwise + 1) % 4 + 1
