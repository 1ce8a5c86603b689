"""One signal of a run with its unit, and how the run ended."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Array
from contourlab.errors import ResultError

DIMENSIONS = (("sample",), ("sample", "axis"))


@dataclass(frozen=True)
class Signal:
    """One signal of a run, read-only.

    Parameters
    ----------
    data : ndarray (n_sample,) or (n_sample, n_axis)
    dims : ("sample",) or ("sample", "axis")
    unit : str
        SI unit.
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
        Whether it came to its end.
    sample : int
        Where it failed; -1 if it did not.
    axis, reason : str
        Which axis failed, and why.
    """

    ok: bool = True
    sample: int = -1
    axis: str = ""
    reason: str = ""

    def header(self) -> dict[str, str | int]:
        """Return the attributes for a file."""
        return {"status_ok": int(self.ok), "status_sample": self.sample, "status_axis": self.axis, "status_reason": self.reason}
