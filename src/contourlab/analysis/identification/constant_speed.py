"""Stretches of a record at constant speed, and the mean command of each.

At constant speed the mean force is friction; over whole turns ripple averages out.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from contourlab.analysis.identification.filtered_motion import require_finite
from contourlab.arrays import Array, Index, true_spans

BATCHES = 8
"""Parts of a stretch; the scatter of their means gives the deviation of the mean, ripple included."""
TURN = 0.08
"""Share at the end of a straight line that may belong to the following turn."""
CHANGED, OUTLYING = 0.003, 6.0
"""A part at an end is left out if its speed differs from the median by this share of the speed, and by this multiple of the median
difference: for normal scatter, four standard deviations."""
FEWEST = 40
"""Smallest number of samples of a stretch."""
DROPPED = 0.25
"""Share of a stretch at its start, dropped because the axis settles."""
TOLERANCE = 0.15
"""Largest difference of speed between the halves of the remaining stretch, as a share of the speed."""
SHORTEST = 0.2
"""Shortest remaining stretch [s]."""
STRAIGHTNESS = 0.02
"""Without a reference: largest distance of the position from straight lines, as a share of the whole travel."""
LEAST_TRAVEL = 4.0 * STRAIGHTNESS
"""Shortest travel of a stretch found from the position alone, as a share of the whole travel."""


@dataclass(frozen=True)
class Stretch:
    """A stretch of constant speed.

    Attributes
    ----------
    start, stop : int
        Samples.
    speed : float [m/s]
        Signed, end to end.
    command : float
        Mean.
    scatter : float
        Standard deviation of the command: ripple, oscillation and noise.
    deviation : float
        Standard deviation of the mean, from the means of parts.
    unevenness : float
        Standard deviation of the speeds of parts, over their mean.
    count : int
        Samples.
    """

    start: int
    stop: int
    speed: float
    command: float
    scatter: float
    deviation: float
    unevenness: float
    count: int
    source: str = ""


def constant_speed_stretches(
    period: float, position: Array, command: Array, reference: Array | None = None, source: str = ""
) -> list[Stretch]:
    """Return the stretches of constant speed of a record.

    Parameters
    ----------
    period : float [s]
    position : ndarray (n,) [m]
    command : ndarray (n,)
    reference : ndarray (n,) [m], optional
        If given, a stretch is a span of one reference speed, less the time to settle; otherwise it follows from the position.

    Raises
    ------
    ParameterError
        If the record is not finite.
    """
    for name, values in (("position", position), ("command", command), ("reference", position if reference is None else reference)):
        require_finite(name, values)
    shortest = max(round(SHORTEST / period), FEWEST)
    spans = _spans_of_position(position) if reference is None else _spans_of_reference(reference, shortest)
    stretches = []
    for start, stop in spans:
        settled = start + math.ceil(DROPPED * (stop - start))
        if reference is None:
            settled, stop = _without_turns(position, settled, stop)
        if stop - settled >= shortest and _is_even(position[settled:stop]):
            stretches.append(_stretch(period, position, command, settled, stop, source))
    return stretches


def _spans_of_reference(reference: Array, shortest: int) -> list[tuple[int, int]]:
    """Return the spans in which the slope of the reference over a few samples stays the same."""
    step = max(1, shortest // 8)
    slope = (reference[step:] - reference[:-step]) / step
    n = slope.size - step
    if n <= 0:
        return []
    ahead, behind = slope[step:], slope[:n]
    fastest = float(np.abs(slope).max())
    steady = (np.abs(ahead - behind) <= 1e-2 * np.abs(behind)) & (np.abs(behind) > 1e-3 * fastest)
    return [(start, stop + 2 * step - 1) for start, stop in true_spans(steady) if stop - start + 2 * step > shortest]


def _spans_of_position(position: Array) -> list[tuple[int, int]]:
    """Return the spans in which the position is a straight line over time: sides of a polygon within a tolerance of it."""
    stride = max(1, position.size // 4000)
    places = position[::stride]
    whole = float(np.ptp(places))
    if whole == 0.0:
        return []
    spans, waiting = [], [(0, places.size - 1)]
    while waiting:
        first, last = waiting.pop()
        line = np.linspace(places[first], places[last], last - first + 1)
        apart = np.abs(places[first : last + 1] - line)
        worst = int(np.argmax(apart))
        if apart[worst] > STRAIGHTNESS * whole:
            waiting += [(first + worst, last), (first, first + worst)]
        elif abs(places[last] - places[first]) > LEAST_TRAVEL * whole:
            # A corner of the polygon may lie on either side of its turn.
            spans.append((first * stride, last * stride - round(TURN * (last - first) * stride)))
    return spans


def _without_turns(position: Array, start: int, stop: int) -> tuple[int, int]:
    """Return the span without the eighths at its ends whose speed lies outside the scatter of the others.

    If an axis slows down without stopping, the corner of the polygon lies within the change of speed, and comparing halves hardly shows it.
    """
    if stop - 1 - start < BATCHES:
        return start, stop
    edges, speeds = _part_speeds(position, start, stop)
    middle = float(np.median(speeds))
    apart = np.abs(speeds - middle)
    even = np.flatnonzero(apart <= max(CHANGED * abs(middle), OUTLYING * float(np.median(apart))))
    first = int(even[0]) + (even[0] > 0)  # after a change the axis settles
    return int(edges[first]), int(edges[even[-1] + 1]) + 1


def _part_speeds(position: Array, start: int, stop: int) -> tuple[Index, Array]:
    """Return the samples at the edges of the parts of a span, and the speeds of the parts [m per sample]."""
    edges = np.linspace(start, stop - 1, BATCHES + 1).astype(np.int64)
    return edges, np.diff(position[edges]) / np.diff(edges)


def _is_even(position: Array) -> bool:
    """Return whether both halves have the same speed, other than zero."""
    half = position.size // 2
    first, second = position[half] - position[0], position[2 * half - 1] - position[half - 1]
    return bool(first * second > 0.0 and abs(second - first) <= TOLERANCE * abs(first + second) / 2.0)


def _stretch(period: float, position: Array, command: Array, start: int, stop: int, source: str) -> Stretch:
    given = command[start:stop]
    parts = np.array([part.mean() for part in np.array_split(given, BATCHES)])
    speed = float(position[stop - 1] - position[start]) / (period * (stop - 1 - start))
    unevenness = float(np.std(_part_speeds(position, start, stop)[1])) / (period * abs(speed))
    deviation = float(parts.std(ddof=1)) / math.sqrt(BATCHES)
    return Stretch(start, stop, speed, float(given.mean()), float(given.std()), deviation, unevenness, stop - start, source)
