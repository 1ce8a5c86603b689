"""Cuts that begin while the axes still settle from the move before: which they are, and the dwell that each needs."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Array, true_spans
from contourlab.features.measure.measured_path import moving
from contourlab.features.precompensate.law import Run
from contourlab.features.precompensate.reading import Contour
from contourlab.features.precompensate.runs import Measured

LONGEST = 1.0
"""Longest dwell that is tried [s]."""
UNKNOWN = 0.2
"""First dwell where no rest of a log shows how long the axes settle [s]."""
STEP = 0.01
"""Dwells are multiples of it [s]."""
SETTLED = 0.1
"""Distance of command and position over that at the begin of a rest at which they have settled, where none falls to the level itself."""
SOON = 5e-3
"""Time after the start of a cut in which its error is not yet that of the cut itself [s]."""
BEFORE = 0.5
"""Share of it that is there before the cut begins; with less it is the cut's own."""


@dataclass(frozen=True)
class Start:
    """A cut that begins off the path.

    Attributes
    ----------
    block : int
        Number of the block before which the axes may settle.
    line : int
    begin : int
        Its first sample.
    rest : float [s]
        For which the command stood still before.
    error : float [m]
        At its first samples.
    """

    block: int
    line: int
    begin: int
    rest: float
    error: float

    def dwell(self, settles: float | None) -> float:
        """Return the dwell [s] to add, if the axes settle in a time [s]; 0 where the rest is as long as any dwell."""
        needed = settles if settles is not None and settles > self.rest else max(2.0 * self.rest, UNKNOWN)
        return math.ceil(max(min(needed, LONGEST) - self.rest, 0.0) / STEP - 1e-6) * STEP


def lag_of(measured: Measured) -> Array:
    """Return the distance (n,) [m] of position and command."""
    return np.asarray(np.linalg.norm(measured.command - measured.load, axis=1))


def starts_of(contour: Contour, run: Run, measured: Measured, level: float) -> list[Start]:
    """Return the cuts after rapids that begin off the path by more than a level [m], because position and command differed before."""
    size, lag = np.where(run.moves, np.linalg.norm(run.error, axis=1), 0.0), lag_of(measured)[moving(measured.command)[0] :]
    soon, starts = max(round(SOON / run.period), 2), list[Start]()
    for curve, block in contour.starts:
        begin = int(np.searchsorted(run.place, contour.path.breaks[curve], side="right"))
        if not 1 < begin < len(run.place):
            continue
        end = begin - int(run.speed[begin - 1] > 0.0)  # the first step of the cut may be within rounding of its start
        moved = np.flatnonzero(run.speed[:end] > 0.0)
        error = float(size[begin : begin + soon].max())
        if error > level and lag[end - 1] > BEFORE * error:
            line = contour.source.numbers[contour.source.blocks[contour.route.source_line[curve] - 1].lines[0] - 1]
            starts.append(Start(block, line, begin, (end - 1 - int(moved[-1]) if moved.size else end) * run.period, error))
    return starts


def settling_time(measured: Measured, level: float) -> float | None:
    """Return the longest time [s] in which the axes settled, of all rests of a run; None if none shows it.

    Parameters
    ----------
    measured : Measured
    level : float [m]
        At which they have settled.
    """
    lag, still = lag_of(measured), (np.diff(measured.command, axis=0, prepend=measured.command[:1]) == 0.0).all(axis=1)
    for share in (0.0, SETTLED):
        times = []
        for begin, end in true_spans(still):
            late = np.flatnonzero(lag[begin:end] > max(level, share * lag[begin]))
            if late.size and late[-1] + 1 < end - begin:
                times.append((int(late[-1]) + 1) * measured.period)
        if times:
            return max(times)
    return None


def without(run: Run, starts: list[Start], time: float) -> tuple[float, float]:
    """Return rms and largest error [m] of a run without a time [s] after each of some starts."""
    kept = run.moves.copy()
    for start in starts:
        kept[start.begin : start.begin + math.ceil(time / run.period)] = False
    square = (run.error[kept] ** 2).sum(axis=1)
    return (math.sqrt(square.mean()), math.sqrt(square.max())) if square.size else (0.0, 0.0)
