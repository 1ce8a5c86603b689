"""Reversal spikes: what friction does to the contour where an axis turns round."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from contourlab.result import Result

__all__ = ["Spike", "reversal_spikes"]

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
        Largest distance of the contour error from its local baseline, signed: positive to the left of the path.
    peak_time : float [s]
    width : float [s]
        Time over which the distance stays above half the height.
    """

    axis: str
    time: float
    sample: int
    quadrant: int
    height: float
    peak_time: float
    width: float


def reversal_spikes(result: Result, window: tuple[int, int] | None = None, longest: float = 0.25) -> tuple[Spike, ...]:
    """Return the spikes of the contour error at the reversals of each axis, in order of time.

    Parameters
    ----------
    result : Result
        With ``contour_error`` and ``reference_velocity``.
    window : (int, int), optional
        Samples [start, stop) to look at.
    longest : float [s]
        How long after a reversal a spike is looked for.

    Notes
    -----
    A spike is looked for from the reversal to half the way to the next one, at most `longest`. Its baseline is the straight line from
    the mean of the five samples before the reversal to that of the last five of this stretch.
    """
    start, stop = window or (0, result.n_sample)
    velocity, error = result["reference_velocity"], result["contour_error"]
    turns = sorted((k, j) for j in range(len(result.axes)) for k in _turns(velocity[:, j]) if start <= k < stop)
    moments = [k for k, _ in turns] + [stop]
    found = []
    for i, (k, j) in enumerate(turns):
        following = next((m for m in moments[i + 1 :] if m > k), stop)
        end = min(k + max((following - k) // 2, 4 * _BEFORE), k + int(longest / result.servo_period), result.n_sample)
        if k >= _BEFORE and end - k > 2 * _BEFORE:
            found.append(_spike(result, error, velocity, k, end, j))
    return tuple(found)


def _turns(velocity: Array) -> list[int]:
    """Return the samples at which a velocity has changed its sign, standstill in between passed over."""
    moving = np.flatnonzero(velocity != 0.0)
    sign = np.sign(velocity[moving])
    return [int(k) for k in moving[1:][sign[1:] != sign[:-1]]]


def _spike(result: Result, error: Array, velocity: Array, k: int, end: int, j: int) -> Spike:
    low, high = error[k - _BEFORE : k].mean(), error[end - _BEFORE : end].mean()
    away = error[k:end] - np.linspace(low, high, end - k)
    peak = int(np.argmax(np.abs(away)))
    above = np.abs(away) >= 0.5 * np.abs(away[peak])
    left, right = peak, peak
    while left > 0 and above[left - 1]:
        left -= 1
    while right + 1 < len(above) and above[right + 1]:
        right += 1
    period = result.servo_period
    time = (k + result.start) * period
    return Spike(
        result.axes[j],
        time,
        k + result.start,
        _quadrant(velocity[k], j),
        float(away[peak]),
        time + peak * period,
        (right - left + 1) * period,
    )


def _quadrant(velocity: Array, j: int) -> int:
    """Return the quadrant of a round path in which it goes on with `velocity` after axis j has turned."""
    if velocity.size != 2 or not velocity.all():
        return 0
    x, y = (int(np.sign(v)) for v in velocity)
    counter_clockwise = {(1, 1): 4, (-1, 1): 1, (-1, -1): 2, (1, -1): 3}[x, y]
    # The velocity of a quarter is that of the opposite one run the other way; to the left means one sign of x y for each axis.
    left = (x * y > 0) == (j == 1)
    return counter_clockwise if left else (counter_clockwise + 1) % 4 + 1
