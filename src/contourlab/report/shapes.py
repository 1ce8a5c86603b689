"""What a report reads of things that other rooms make: any object of this shape will do."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

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


class Cause(Protocol):
    """One reason for the worst error."""

    @property
    def name(self) -> str:
        """What it is, for people."""

    @property
    def contribution(self) -> float:
        """How much of the worst error it accounts for [m]; negative where it happens to help."""

    @property
    def share(self) -> float:
        """Its magnitude as a part of the magnitudes of all causes, 0 to 1."""


class Worst(Protocol):
    """The place of the worst error."""

    @property
    def value(self) -> float:
        """Error [m]."""

    @property
    def line(self) -> int:
        """Line of the part program from 1; 0 where there is none."""

    @property
    def text(self) -> str:
        """That line."""

    @property
    def position(self) -> Sequence[float]:
        """Where (n_axis,) [m]."""

    @property
    def time(self) -> float:
        """When [s]."""

    @property
    def sample(self) -> int:
        """Which sample, from 0."""


class Verdict(Protocol):
    """Whether the part is good, why not, and what to do about it."""

    @property
    def passed(self) -> bool:
        """Whether the worst error is within the tolerance."""

    @property
    def tolerance(self) -> float:
        """Largest error allowed [m]."""

    @property
    def worst(self) -> Worst:
        """The worst place."""

    @property
    def causes(self) -> Sequence[Cause]:
        """Reasons, the largest first."""

    @property
    def advice(self) -> str:
        """One sentence."""

    @property
    def untold(self) -> Sequence[str]:
        """Names of causes that could not be told apart."""

    @property
    def left_out(self) -> float:
        """Longest piece of the path that the tool never came to [m], where that is why it failed; else 0."""
