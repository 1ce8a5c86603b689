"""Largest velocity, acceleration and jerk in a log of positions, without the jerk that counts and noise would invent.

Differences are taken over a stride h, a whole number of samples:

    v = D1 / h, a = D2 / h^2, j = D3 / h^3, with Dk the k-th difference of positions h apart.

Dk / h^k is the mean of the k-th derivative under a B-spline, which is nowhere negative, over k h. So the true peak is at least as large,
but for the error of the positions. Positions off by at most e/2 add at most 2^(k-1) e / h^k: the resolution of the figure. The stride is
the least with which that is below `RESOLVED` of the limit, or of the figure itself without one. A peak shorter than k h is averaged.

References
----------
de Boor, "A Practical Guide to Splines", 1978, chapter IX: a divided difference is the integral of the derivative with a B-spline.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from contourlab.arrays import Array, Flags, Index
from contourlab.feed.verify import Worst

RESOLVED = 0.05
"""Largest share of the limit that the error of the positions may add."""
SIGMAS = 6.0
"""Standard deviations between the extremes of noise."""
LARGEST_PART = 20
"""Length of a log over the longest stride."""
SLOWEST = 0.01
"""Longest period of a control [s]."""
KINDS = ("velocity", "acceleration", "jerk")


@dataclass(frozen=True)
class AxisPeak:
    """Largest value of one axis.

    Attributes
    ----------
    axis : str
    kind : str
        velocity, acceleration or jerk; of a planned program also "curvature step" (of the acceleration) and "kink" (of the velocity).
    value : float [m/s, m/s^2 or m/s^3]
    resolution : float [m/s, m/s^2 or m/s^3]
        What the error of the positions may add to the value.
    window : float [s]
        Time over which it is a mean.
    limit : float or None
    time : float [s]
    """

    json_form: ClassVar = {
        "axis": "axis", "kind": "kind", "value": "worst.value", "resolution": "worst.allowance", "window": "window", "limit": "worst.limit",
        "use": "use", "time": "worst.time", "line": "line",
    }  # fmt: skip

    axis: str
    kind: str
    worst: Worst
    window: float

    @property
    def use(self) -> float | None:
        """(value - resolution) / limit; above 1 the limit is exceeded; None without a limit."""
        return self.worst.ratio if math.isfinite(self.worst.limit) else None

    @property
    def line(self) -> int | None:
        """Line of the program."""
        return self.worst.source_line or None


@dataclass(frozen=True, eq=False)
class Course:
    """A derivative of one axis over the samples: magnitude (n,), nan at the ends, resolution, stride."""

    magnitude: Array
    resolution: float
    stride: int


def position_error(position: Array) -> float:
    """Return the largest distance between two errors of positions (n,): a count, or the extremes of noise [m].

    Notes
    -----
    The count is the least difference between values. The noise is estimated from eighth differences, to which a smooth motion adds
    little: their median magnitude over that of white noise of deviation 1, 0.6745 sqrt(12870).
    """
    values = np.unique(position)
    steps = np.diff(values)
    steps = steps[steps > 1e-12 * max(float(np.abs(values).max()), 1e-6)]
    count = float(steps.min()) if steps.size else 0.0
    noise = float(np.median(np.abs(np.diff(position, 8)))) / (0.6745 * math.sqrt(12870.0)) if len(position) > 9 else 0.0
    # A log in floating point has no count: the least difference says nothing then.
    is_counted = count > 0.0 and bool(np.all(np.abs(steps / count - np.rint(steps / count)) < 0.05))
    return max(count if is_counted else 0.0, SIGMAS * noise)


def control_samples(position: Array, period: float) -> tuple[Index, float]:
    """Return the first sample of each period of the control, and that period [s].

    In a log that is faster than the control, each position is held over several samples. Their number may vary by a quarter, where log and
    control have clocks of their own. Longer holds are rests. Fewer than 20 changes, and steps slower than `SLOWEST`, were commanded so.

    Parameters
    ----------
    position : ndarray (n, n_axis) [m]
    period : float [s]
        Of the log.
    """
    changes = np.flatnonzero(np.diff(position, axis=0).any(axis=1)) + 1
    if len(changes) >= 20:
        between = np.diff(changes)
        between = between[between <= SLOWEST / period]
        held = float(between[between < 1.5 * np.quantile(between, 0.1)].mean()) if between.size else 0.0
        if held > 1.0 and (np.abs(between - held * np.rint(between / held)) <= 0.25 * held).all():
            edges = np.concatenate([[0], changes, [len(position)]])
            return np.repeat(edges[:-1], np.maximum(np.rint(np.diff(edges) / held), 1).astype(np.int64)), held * period
    return np.arange(len(position)), period


def course(position: Array, period: float, order: int, limit: float) -> Course:
    """Return a derivative of positions (n,) [m], over the least stride that resolves it.

    Parameters
    ----------
    position : ndarray (n,) [m]
    period : float [s]
    order : int
        1, 2 or 3.
    limit : float
        inf for none.
    """
    error = position_error(position)
    longest = max(len(position) // LARGEST_PART, 1)
    stride = 1
    while True:
        magnitude = _differences(position, period, order, stride)
        added = 2.0 ** (order - 1) * error / (stride * period) ** order
        wanted = limit if math.isfinite(limit) else float(np.nanmax(magnitude, initial=0.0))
        if added <= RESOLVED * wanted or stride >= longest:
            return Course(magnitude, added, stride)
        stride = min(max(stride + 1, int(1.25 * stride)), longest)


def _differences(position: Array, period: float, order: int, stride: int) -> Array:
    """Return the magnitude (n,) of a derivative, each at the sample in the middle of its stride."""
    values = position
    for _ in range(order):
        values = values[stride:] - values[:-stride] if len(values) > stride else values[:0]
    magnitude = np.full(len(position), np.nan)
    first = order * stride // 2
    magnitude[first : first + len(values)] = np.abs(values) / (stride * period) ** order
    return magnitude


def moving_part(position: Array) -> Flags:
    """Return which samples (n,) are between the first and the last motion of any axis, beyond counts and noise."""
    error = np.array([2.0 * position_error(column) + 1e-12 for column in position.T])
    first, last = (np.flatnonzero((np.abs(position - end) > error).any(axis=1)) for end in (position[0], position[-1]))
    moves = np.zeros(len(position), dtype=bool)
    if first.size and last.size:
        moves[max(int(first[0]) - 1, 0) : int(last[-1]) + 2] = True
    return moves
