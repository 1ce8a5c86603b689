"""Exact runs of a loop with a gap: no tolerance to choose, mode changes exact to about 1e-13 of the fastest time constant."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.analysis.backlash.lure import BacklashLoop
from contourlab.analysis.backlash.periodic_orbit import ABOVE, BELOW, GAP, Flow, Span, lengthened_at, spans

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class ExactRun:
    """A motion, known at all times; `duration` [s] is shorter than requested if it ran away."""

    loop: BacklashLoop
    duration: float
    diverged: bool
    flow: Flow = field(repr=False)
    spans: tuple[Span, ...] = field(repr=False)

    @property
    def times(self) -> Array:
        return np.array([span.time for span in self.spans])

    @property
    def modes(self) -> NDArray[np.int64]:
        return np.array([span.mode for span in self.spans], dtype=np.int64)

    def _lengthened(self, time: ArrayLike) -> tuple[Array, NDArray[np.int64]]:
        return lengthened_at(self.flow, self.spans, np.clip(time, 0.0, self.duration))

    def state(self, time: ArrayLike) -> Array:
        return self._lengthened(time)[0][:, : self.loop.n]

    def difference(self, time: ArrayLike) -> Array:
        return np.asarray(self.state(time) @ self.loop.c)

    def twist(self, time: ArrayLike) -> Array:
        w, modes = self._lengthened(time)
        beyond = w[:, : self.loop.n] @ self.loop.c - modes * self.loop.half_gap
        inside = w[:, self.loop.n] if self.flow.twisted else np.zeros(len(w))
        return np.asarray(np.where(modes == GAP, inside, beyond))

    def torque(self, time: ArrayLike) -> Array:
        w, modes = self._lengthened(time)
        rows = {mode: self.flow.torque_row(mode) for mode in (BELOW, GAP, ABOVE)}
        return np.array([rows[int(mode)] @ each for mode, each in zip(modes, w, strict=True)])


def simulate_exact(
    loop: BacklashLoop, start: ArrayLike, duration: float, reference: float = 0.0, *, twist: float | None = None, most: int = 100_000
) -> ExactRun:
    """Simulate under a constant reference; `twist` is that of a damped shaft that starts in the gap."""
    flow = Flow(loop, reference)
    w, mode = flow.lengthened(np.asarray(start, dtype=float), twist)
    motion = tuple(spans(flow, w, mode, duration, most))
    end = motion[-1].time + motion[-1].duration
    return ExactRun(loop, end, end < duration * (1.0 - 1e-12), flow, motion)
