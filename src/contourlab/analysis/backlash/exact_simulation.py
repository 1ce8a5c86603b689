"""Exact simulation of a loop with a gap: matrix exponentials between mode changes, which are located to rounding."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.backlash.mode_flow import Flow
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


def lengthened_at(flow: Flow, motion: Sequence[Span], time: ArrayLike) -> tuple[Array, Index]:
    """Return the lengthened states (n_time, size) of a motion at times (n_time,) [s] within it, and the modes."""
    starts, modes = np.array([span.time for span in motion]), np.array([span.mode for span in motion], dtype=np.int64)
    t = np.atleast_1d(np.asarray(time, dtype=float))
    index = np.searchsorted(starts, t, side="right") - 1
    lengthened = np.empty((t.size, flow.size))
    for i in np.unique(index):
        at = np.flatnonzero(index == i)
        lengthened[at] = flow.exponentials(motion[i].mode, t[at] - motion[i].time) @ motion[i].start
    return lengthened, modes[index]
