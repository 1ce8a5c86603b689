"""A motion along a path: spans of constant jerk."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from contourlab.arrays import Array, Index


class Motion(NamedTuple):
    """Progress along the path and its time derivatives.

    Attributes
    ----------
    arc_length : ndarray (n,) [m]
    speed : ndarray (n,) [m/s]
    acceleration : ndarray (n,) [m/s^2]
    jerk : ndarray (n,) [m/s^3]
    """

    arc_length: Array
    speed: Array
    acceleration: Array
    jerk: Array


@dataclass(frozen=True, eq=False)
class Profile:
    """Spans of constant jerk, from t = 0.

    Span i applies for ``t0[i] <= t < t0[i + 1]``, the last one until `duration`::

        s = s0 + v0 dt + a0 dt^2 / 2 + j dt^3 / 6,     dt = t - t0

    Parameters
    ----------
    t0, s0, v0, a0, j : ndarray (n_span,) [s, m, m/s, m/s^2, m/s^3]
        Time, progress, speed and tangential acceleration at the start of each span, and its jerk.
    duration : float [s]
    length : float [m]
        Progress at the end.
    """

    t0: Array
    s0: Array
    v0: Array
    a0: Array
    j: Array
    duration: float
    length: float

    def __post_init__(self) -> None:
        for part in (self.t0, self.s0, self.v0, self.a0, self.j):
            part.flags.writeable = False

    @cached_property
    def ends(self) -> Array:
        """Progress at the end of each span (n_span,) [m]."""
        return np.append(self.s0[1:], self.length)

    @property
    def n_span(self) -> int:
        """Number of spans."""
        return int(self.t0.size)

    def motion(self, time: Array) -> Motion:
        """Evaluate at times (n,) [s]; before the start and after the end the motion is at rest."""
        clamped = np.minimum(np.maximum(time, 0.0), self.duration)
        # Broadcast a single span; gathering it is slower.
        span = np.searchsorted(self.t0, clamped, side="right") - 1 if self.n_span > 1 else np.zeros(1, dtype=np.int64)
        dt = clamped - self.t0[span]
        start_speed, start_acceleration, jerk = self.v0[span], self.a0[span], self.j[span]
        progress = dt * (start_speed + dt * (start_acceleration / 2.0 + dt * jerk / 6.0))
        # Rounding must not pass the end of the span, which is known exactly.
        arc_length = np.minimum(self.s0[span] + progress, self.ends[span])
        speed = np.maximum(start_speed + dt * (start_acceleration + dt * jerk / 2.0), 0.0)
        acceleration, jerk = start_acceleration + dt * jerk, np.broadcast_to(jerk, dt.shape).copy()
        still = (time < 0.0) | (time >= self.duration)
        if np.any(still):
            arc_length[time >= self.duration] = self.length
            for part in (speed, acceleration, jerk):
                part[still] = 0.0
        return Motion(arc_length, speed, acceleration, jerk)

    def reached(self, arc_length: Array) -> tuple[Index, Array]:
        """Return in which span each place (n,) [m] is reached, and the time since the start of that span (n,) [s]."""
        span = np.clip(np.searchsorted(self.s0, arc_length, side="right") - 1, 0, self.n_span - 1)
        s0, v0, a0, j = self.s0[span], self.v0[span], self.a0[span], self.j[span]
        low, high = np.zeros_like(arc_length), np.diff(np.append(self.t0, self.duration))[span]
        for _ in range(60):
            middle = 0.5 * (low + high)
            early = s0 + middle * (v0 + middle * (a0 / 2.0 + middle * j / 6.0)) < arc_length
            low, high = np.where(early, middle, low), np.where(early, high, middle)
        return span, high
