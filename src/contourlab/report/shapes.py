"""What a report reads of a path, and the verdict that it prints."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from contourlab.findings import Finding

Array = NDArray[np.float64]


class DrawnPath(Protocol):
    """What the report asks of a path; `contourlab.geometry.Path` has it."""

    @property
    def n_axis(self) -> int:
        """Number of axes."""

    @property
    def length(self) -> float:
        """Length [m]."""

    @property
    def closed(self) -> bool:
        """Whether the end is the start."""

    @property
    def breaks(self) -> Any:
        """Arc lengths where one curve ends and the next begins (n_curve + 1,) [m]."""

    @property
    def corners(self) -> Any:
        """Arc lengths where the tangent jumps [m]."""

    def position(self, s: Array) -> Array:
        """Points (n, n_axis) [m] at arc lengths (n,) [m]."""

    def tangent(self, s: Array) -> Array:
        """Unit tangents (n, n_axis) at arc lengths (n,) [m]."""


@dataclass(frozen=True, slots=True)
class Cause:
    """One cause of the error at the worst place.

    Attributes
    ----------
    name : str
    contribution : float [m]
        Along the direction of the error; negative where it makes the error smaller.
    share : float, 0 to 1
        Of the sum of all contributions' magnitudes.
    """

    name: str
    contribution: float
    share: float


@dataclass(frozen=True, slots=True)
class Worst:
    """Where the part error is largest: value [m], sample, time [s], position [m], arc length [m], source line (0 for none) and its text."""

    value: float
    sample: int
    time: float
    position: tuple[float, ...]
    arc_length: float
    line: int
    text: str


@dataclass(frozen=True, slots=True)
class Verdict:
    """Pass or fail against a tolerance.

    Attributes
    ----------
    passed : bool
        Whether the largest part error is within the tolerance, and the tool traces the whole path: the longest piece it skips is within
        ten tolerances (at the end: two), or within three steps of the reference where these are longer.
    tolerance : float [m]
    worst : Worst
    causes : tuple of Cause
        Largest first.
    left_out : float [m]
        Longest piece of the path that the tool skips, where it is too long to pass; else 0.
    findings : tuple of Finding
        Skipped path, causes that could not be separated, the best single change.
    """

    passed: bool
    tolerance: float
    worst: Worst
    causes: tuple[Cause, ...] = ()
    left_out: float = 0.0
    findings: tuple[Finding, ...] = field(default=(), metadata={"json": False})
