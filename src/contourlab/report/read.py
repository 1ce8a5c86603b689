"""How the report reads a result: signals by name, in print units, thinned for drawing."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import ResultError
from contourlab.report.data import ReportData

Array = NDArray[np.float64]


def has(result: Any, name: str) -> bool:
    """Tell whether a result holds a signal."""
    return name in result.signals


def signal(result: Any, name: str) -> Array:
    """Return a signal's data.

    Raises
    ------
    ResultError
        If it is not there.
    """
    if not has(result, name):
        held = ", ".join(result.signals) or "none"
        raise ResultError(f"scheme {result.scheme!r}: no signal {name!r} to report, judge it first; it holds {held}")
    return np.asarray(result[name], dtype=np.float64)


def axis_column(result: Any, name: str, axis: int) -> Array:
    """Return one axis of a signal as a contiguous vector (n_sample,)."""
    return np.ascontiguousarray(signal(result, name)[:, axis])


def error_signal(data: ReportData) -> str:
    """Return the signal that the tolerance is held against; without blending the two errors are one."""
    return "part_error" if data.is_blended else "contour_error"


def times(result: Any, samples: NDArray[np.int64]) -> Array:
    """Return the times of some samples [s]."""
    return np.asarray((samples + int(result.start)) * float(result.servo_period), dtype=np.float64)


def compact(values: Array) -> Array:
    """Return the finite values only."""
    return values[np.isfinite(values)]


def reach(values: Array) -> float:
    """Return the largest finite magnitude, 0 where there is none."""
    good = compact(values)
    return float(np.max(np.abs(good))) if good.size else 0.0
