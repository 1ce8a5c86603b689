"""What of the path the tool never came to: small errors say nothing of a tool that stood still."""

from __future__ import annotations

import numpy as np

from contourlab.feed import Reference
from contourlab.result import Result


def left_out(result: Result, reference: Reference, window: tuple[int, int]) -> tuple[float, float]:
    """Return the longest piece [m] of the programmed path, as far as it was asked for, on which no foot point of the tool lies.

    Parameters
    ----------
    result : Result
        With the judge's ``foot_arc_length``.
    reference : Reference
    window : (int, int)
        Samples [start, stop) that count. On a whole lap what lies before its start counts for the end of the lap.

    Returns
    -------
    longest, at_end : float [m]
        The longest piece of all, and the one at the end of the motion; the latter is 0 on a whole lap.

    Notes
    -----
    A tool that follows leaves out no more than the path between two samples, what it cuts off at a corner, and how far it is from its
    reference at the ends of the motion.
    """
    cut = slice(*window)
    path = reference.programmed
    foot = result["foot_arc_length"][cut]
    asked = reference.programmed_arc_length(result["arc_length"][cut])
    if path.closed and np.ptp(asked) > (1.0 - 2.0 / len(asked)) * path.length:
        foot = np.sort(np.mod(foot, path.length))
        return float(max(np.diff(foot).max(initial=0.0), foot[0] + path.length - foot[-1])), 0.0
    low, high = asked.min(), asked.max()
    seen = np.concatenate([[low], np.sort(np.clip(foot, low, high)), [high]])
    return float(np.diff(seen).max()), float(high - seen[-2])
