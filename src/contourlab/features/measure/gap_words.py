"""Whether the largest contour error of a log stands where its samples are missing, and is none of the machine's."""

from __future__ import annotations

import numpy as np

from contourlab.features.measure.study import Measured
from contourlab.logs import Log
from contourlab.logs.clock import EVEN


def gap_words(log: Log, found: Measured, *, of_samples: bool) -> list[str]:
    """Return what is to be said of the place of the largest contour error, where samples are missing there; nothing elsewhere.

    Parameters
    ----------
    log : Log
    found : Measured
        The log, judged.
    of_samples : bool
        Whether the path is that of the log's own reference, which a gap cuts short by a chord.

    Notes
    -----
    An error is of a gap where its sample lies in one of a position, or where its foot point lies on what bridges a gap of a reference: the
    tool may be late, and come to that piece behind the gap, or be ahead of it at the last sample before.
    """
    worst = found.metrics.contour_error.worst.time
    place = f"the largest contour error, at t = {worst:.4g} s, is"
    if inside := log.gaps_at(worst):
        return [f"{place} in a gap of {', '.join(inside)}: it is interpolated, not measured"]
    bridged = _bridged_at(log, found, worst) if of_samples else []
    return [f"{place} beside a gap of {', '.join(bridged)}: the path it is held against is a chord there"] if bridged else []


def _bridged_at(log: Log, found: Measured, time: float) -> list[str]:
    """Return the channels of references with a gap that the foot point at a time [s] lies on the bridge of."""
    result, period = found.result, found.result.servo_period
    along, foot = result["arc_length"], result["foot_arc_length"][round(time / period)]
    named = []
    for name, start, stop in log.gaps("reference"):
        edges = np.array([np.floor(start / period + EVEN), np.ceil(stop / period - EVEN)], dtype=np.int64)
        before, behind = along[np.clip(edges, 0, len(along) - 1)]
        if before <= foot <= behind:
            named.append(name)
    return list(dict.fromkeys(named))
