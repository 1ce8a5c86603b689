"""The signals of some axes of a log, and those that no machine tool has: units, columns or signs of the log are probably wrong."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ResultError
from contourlab.findings import Finding, finding
from contourlab.logs.reading import LONGEST
from contourlab.result import Result

SHORT, SLOW = 1e-3, 1e-3
"""Travel [m] and top speed [m/s] of a run; a machine's run exceeds at least one."""
FAST = 5.0
"""Speed [m/s] that hardly any feed axis reaches; the fastest rapids run at 4 m/s."""
PERIODS = (1e-7, 0.1)
"""Range of sample periods [s] for logs of servo drives."""
SPEED_INTERVAL = 2e-3
"""Shortest interval [s] for a speed; between single samples the position resolution would dominate."""
USUAL = 0.99
"""Quantile of the samples for the speed of a run; it excludes glitches."""


def columns_of(result: Result, axes: Sequence[str]) -> list[int]:
    """Return the columns of some axes; raise ResultError if one is missing."""
    if missing := [axis for axis in axes if axis not in result.axes]:
        raise ResultError(f"no axis {missing[0]} in {result.source}; there are {', '.join(result.axes)}")
    return [result.axes.index(axis) for axis in axes]


def known_signal(result: Result, axes: Sequence[str], names: Sequence[str]) -> tuple[str, Array] | None:
    """Return the first of some signals that some axes have at all samples, by name and values (n, n_axis); None if there is none."""
    columns = columns_of(result, axes)
    known = (name for name in names if name in result and np.isfinite(result[name][:, columns]).all())
    return next(((name, np.asarray(result[name][:, columns])) for name in known), None)


def period_findings(period: float, place: str = "") -> list[Finding]:
    """Return a finding if a sample period [s] is implausible."""
    return [] if PERIODS[0] <= period <= PERIODS[1] else [finding("CL401", place, period=period)]


def motion_findings(position: Array, period: float, place: str = "") -> list[Finding]:
    """Return a finding if travel or speed of positions (n, n_axis) [m] is implausible; the axis with the largest value counts."""
    travel, top = float(np.ptp(position, axis=0).max()), fastest(position, period)
    if 0.0 < travel < SHORT and top < SLOW:
        return [finding("CL402", place, travel=travel, speed=top)]
    usual = fastest(position, period, USUAL)
    return [finding("CL403", place, travel=travel, speed=usual)] if travel > LONGEST or usual > FAST else []


def fastest(position: Array, period: float, quantile: float = 1.0) -> float:
    """Return the speed [m/s] of the fastest axis of positions (n, n_axis) [m], as a quantile over the samples."""
    stride = max(1, round(SPEED_INTERVAL / period))
    speed = np.abs(np.diff(position[::stride], axis=0)) / (stride * period)
    return float(np.quantile(speed, quantile, axis=0).max()) if speed.size else 0.0


def same_column_findings(axes: tuple[str, ...], reference: Array, position: Array, place: str = "") -> list[Finding]:
    """Return a finding on axes that move and equal their reference (n, n_axis) at every sample."""
    equal = (np.ptp(reference, axis=0) > 0.0) & (reference == position).all(axis=0)
    same = tuple(axis for axis, is_equal in zip(axes, equal, strict=True) if is_equal)
    return [finding("CL404", place, axes=same)] if same else []
