"""Signals that no machine tool has: units, columns or signs of a log are probably wrong."""

from __future__ import annotations

import numpy as np

from contourlab.arrays import Array
from contourlab.findings import Finding, finding

SHORT, SLOW = 1e-3, 1e-3
"""Travel [m] and top speed [m/s] of a whole run; a run of a machine exceeds at least one."""
LONG, FAST = 10.0, 5.0
"""Travel [m] and speed [m/s] that hardly any feed axis reaches: the fastest rapids are at 4 m/s."""
PERIODS = (1e-7, 0.1)
"""Sample periods [s] at which servo drives are logged."""
SPEED_INTERVAL = 2e-3
"""Shortest interval [s] for a speed; between single samples the resolution of the position would count."""
USUAL = 0.99
"""Quantile of the samples for the speed of a run: a glitch is no speed."""


def period_findings(period: float, place: str = "") -> list[Finding]:
    """Return what is implausible about a sample period [s]."""
    return [] if PERIODS[0] <= period <= PERIODS[1] else [finding("CL401", place, period=period)]


def motion_findings(position: Array, period: float, place: str = "") -> list[Finding]:
    """Return what is implausible about travel and speed of positions (n, n_axis) [m]; the farthest and the fastest axis count."""
    travel, top = float(np.ptp(position, axis=0).max()), fastest(position, period)
    if 0.0 < travel < SHORT and top < SLOW:
        return [finding("CL402", place, travel=travel, speed=top)]
    usual = fastest(position, period, USUAL)
    return [finding("CL403", place, travel=travel, speed=usual)] if travel > LONG or usual > FAST else []


def fastest(position: Array, period: float, quantile: float = 1.0) -> float:
    """Return the speed [m/s] of the fastest axis of positions (n, n_axis) [m], as a quantile over the samples."""
    stride = max(1, round(SPEED_INTERVAL / period))
    speed = np.abs(np.diff(position[::stride], axis=0)) / (stride * period)
    return float(np.quantile(speed, quantile, axis=0).max()) if speed.size else 0.0


def same_column_findings(axes: tuple[str, ...], reference: Array, position: Array, place: str = "") -> list[Finding]:
    """Return the axes that move and equal their reference (n, n_axis) in every sample."""
    equal = (np.ptp(reference, axis=0) > 0.0) & (reference == position).all(axis=0)
    same = tuple(axis for axis, is_equal in zip(axes, equal, strict=True) if is_equal)
    return [finding("CL404", place, axes=same)] if same else []
