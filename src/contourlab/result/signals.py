"""One signal of a run with its unit, and how the run ended."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Array, ByValue
from contourlab.errors import ResultError

DIMENSIONS = (("sample",), ("sample", "axis"))
JUDGED = ("contour_error", "part_error", "planning_deviation", "foot_arc_length", "tracking_error")
"""Signals that the judge adds to those of a run."""


@dataclass(frozen=True, eq=False)
class Signal(ByValue):
    """One signal with its unit.

    Parameters
    ----------
    data : ndarray (n_sample,) or (n_sample, n_axis) [unit]
        Read-only afterwards.
    dims : ("sample",) or ("sample", "axis")
        Names of the dimensions.
    unit : str
        SI unit; empty for none.

    Raises
    ------
    ResultError
        If shape and dimensions do not fit.
    """

    data: Array
    dims: tuple[str, ...]
    unit: str

    def __post_init__(self) -> None:
        data = np.asarray(self.data, dtype=np.float64)
        if self.dims not in DIMENSIONS or data.ndim != len(self.dims):
            raise ResultError(f"a signal of shape {data.shape} with dimensions {self.dims}: give ('sample',) or ('sample', 'axis')")
        view = data.view()
        view.flags.writeable = False
        object.__setattr__(self, "data", view)


@dataclass(frozen=True)
class Status:
    """How a run ended.

    Parameters
    ----------
    ok : bool
        Whether it reached its end.
    sample : int
        Sample of the failure; -1 for none.
    axis, reason : str
        Axis and cause of the failure; empty for none.
    """

    ok: bool = True
    sample: int = -1
    axis: str = ""
    reason: str = ""

    def header(self) -> dict[str, str | int]:
        """Return the attributes for a file."""
        return {"status_ok": int(self.ok), "status_sample": self.sample, "status_axis": self.axis, "status_reason": self.reason}
