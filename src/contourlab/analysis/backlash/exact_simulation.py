"""Exact simulation of a loop with a gap: matrix exponentials between mode changes, which are located to rounding.

There is no tolerance to choose: use it to check integrators.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.backlash.lure import BacklashLoop
from contourlab.analysis.backlash.mode_flow import ABOVE, BELOW, GAP, Flow
from contourlab.arrays import Array, Index
from contourlab.errors import ParameterError

RUNAWAY = 1e9
"""Largest state, over its start or the gap; beyond it a run has diverged."""


@dataclass(frozen=True, eq=False)
class Span:
    """A span of time in one mode: w' = M w from `start`, for `duration`."""

    time: float
    duration: float
    mode: int
    start: Array
    end: Array
    following: int | None
    """The next mode; None if the span ends without a mode change."""


def spans(flow: Flow, w: Array, mode: int, duration: float, most: int) -> Iterator[Span]:
    """Yield the spans of a motion that starts at `w` in `mode`.

    Raises
    ------
    ParameterError
        If the mode changes more than `most` times.
    """
    time, begun, origin, level = 0.0, 0.0, w, 0
    limit = RUNAWAY * max(float(np.abs(w).max()), flow.loop.half_gap)
    for _ in range(most):
        while True:
            step, w, following, level = flow.advance(w, mode, duration - time, level)
            time += step
            # The sum of the steps equals the duration up to rounding.
            done = duration - time <= 1e-15 * duration
            if following is not None or done or not np.abs(w).max() < limit:
                break
        yield Span(begun, time - begun, mode, origin, w, following)
        if done or following is None:
            return
        w, mode, begun = flow.reset(mode, following) @ w, following, time
        origin = w
    raise ParameterError("changes of mode", most, f"fewer within {duration:g} s: shorten the time or allow more")


@dataclass(frozen=True, eq=False)
class ExactRun:
    """A motion, known at all times.

    Attributes
    ----------
    duration : float [s]
        Shorter than requested if the motion ran away.
    times, modes : ndarray (n_span,)
        Start time and mode of each span; the mode is -1, 0 (gap) or 1.
    """

    loop: BacklashLoop
    duration: float
    times: Array
    modes: Index
    diverged: bool
    flow: Flow = field(repr=False)
    spans: tuple[Span, ...] = field(repr=False)

    def _lengthened(self, time: ArrayLike) -> tuple[Array, Index]:
        t = np.clip(np.atleast_1d(np.asarray(time, dtype=float)), 0.0, self.duration)
        index = np.searchsorted(self.times, t, side="right") - 1
        lengthened = np.empty((t.size, self.flow.size))
        for i in np.unique(index):
            at = np.flatnonzero(index == i)
            here = self.spans[i]
            lengthened[at] = self.flow.exponentials(here.mode, t[at] - here.time) @ here.start
        return lengthened, self.modes[index]

    def state(self, time: ArrayLike) -> Array:
        """Return the states (n_time, n) at times (n_time,) [s]."""
        return self._lengthened(time)[0][:, : self.loop.n]

    def difference(self, time: ArrayLike) -> Array:
        """Return the motor-load difference (n_time,) at times (n_time,) [s]."""
        return np.asarray(self.state(time) @ self.loop.c)

    def twist(self, time: ArrayLike) -> Array:
        """Return the twist of the shaft (n_time,) at times (n_time,) [s]."""
        w, modes = self._lengthened(time)
        beyond = w[:, : self.loop.n] @ self.loop.c - modes * self.loop.half_gap
        inside = w[:, self.loop.n] if self.flow.twisted else np.zeros(len(w))
        return np.asarray(np.where(modes == GAP, inside, beyond))

    def torque(self, time: ArrayLike) -> Array:
        """Return the transmitted torque (n_time,) at times (n_time,) [s]."""
        w, modes = self._lengthened(time)
        rows = {mode: self.flow.torque_row(mode) for mode in (BELOW, GAP, ABOVE)}
        return np.array([rows[int(mode)] @ each for mode, each in zip(modes, w, strict=True)])


def simulate_exact(
    loop: BacklashLoop, start: ArrayLike, duration: float, reference: float = 0.0, *, twist: float | None = None, most: int = 100_000
) -> ExactRun:
    """Simulate a loop exactly.

    Parameters
    ----------
    start : array_like (n,)
        State at 0.
    duration : float, > 0 [s]
    reference : float
        Constant.
    twist : float, optional
        Of a damped shaft that starts in the gap; relaxed by default.
    most : int
        Largest number of mode changes.

    Returns
    -------
    ExactRun
        Mode changes are exact to about 1e-13 of the fastest time constant.

    Raises
    ------
    ParameterError
        If the mode changes more than `most` times.
    """
    x = np.asarray(start, dtype=float)
    flow = Flow(loop, reference)
    w, mode = flow.lengthened(x, twist)
    spans_run = tuple(spans(flow, w, mode, duration, most))
    end = spans_run[-1].time + spans_run[-1].duration
    times, modes = np.array([span.time for span in spans_run]), np.array([span.mode for span in spans_run], dtype=np.int64)
    return ExactRun(loop, end, times, modes, end < duration * (1.0 - 1e-12), flow, spans_run)
