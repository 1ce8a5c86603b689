"""Limits and error map of an axis, and the division of its controller between base and axis."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import Component
from contourlab.components.ideal import IdealLink
from contourlab.components.origin import Origin
from contourlab.errors import ParameterError, refuse
from contourlab.feed.bounds import RANGES
from contourlab.units import setting


@dataclass(frozen=True)
class Limits:
    """Limits of an axis.

    Attributes
    ----------
    velocity : float [m/s], > 0
    acceleration : float [m/s^2], > 0
    jerk : float [m/s^3], > 0
    following_error : float [m], > 0
        A larger tracking error ends the run as diverged, as a drive would trip.
    travel : tuple of two floats, or float > 0 [m]
        Lowest and highest position of the axis, or the length alone: feed moves must then fit into it, wherever they lie.
    origins : mapping of str to Origin
        Source of each number, by name.
    file : str
        File that holds the limits; empty if there is none.

    Raises
    ------
    ParameterError
        If a limit is not positive, or the travel is empty.
    """

    velocity: float = field(default=math.inf, metadata=setting("m/s", "mm/min", *RANGES["velocity"]))
    acceleration: float = field(default=math.inf, metadata=setting("m/s^2", "", *RANGES["acceleration"]))
    jerk: float = field(default=math.inf, metadata=setting("m/s^3", "", *RANGES["jerk"]))
    following_error: float = field(default=0.05, metadata=setting("m", "mm", minimum=0.0, maximum=1.0, exclusive=True))
    travel: tuple[float, float] | float = field(default=(-math.inf, math.inf), metadata=setting("m", "mm"))
    origins: Mapping[str, Origin] = field(default_factory=dict, compare=False, repr=False)
    file: str = field(default="", compare=False, repr=False)

    def __post_init__(self) -> None:
        for name in ("velocity", "acceleration", "jerk", "following_error"):
            value = getattr(self, name)
            refuse(not value > 0.0, ParameterError, f"limits.{name}", f"{value:g}", "> 0")
        if not (self.ends[0] < self.ends[1] and self.extent > 0.0):
            raise ParameterError("limits.travel", f"{self.travel}", "two positions, the lower one first, or a length > 0", "m")

    @property
    def ends(self) -> tuple[float, float]:
        """Lowest and highest position; infinite where unknown."""
        return self.travel if isinstance(self.travel, tuple) else (-math.inf, math.inf)

    @property
    def extent(self) -> float:
        """Length of a travel whose ends are unknown; infinite otherwise."""
        return math.inf if isinstance(self.travel, tuple) else self.travel

    @property
    def bounded(self) -> bool:
        """Whether the travel is known, by its ends or by its length."""
        return any(map(math.isfinite, (*self.ends, self.extent)))


@dataclass(frozen=True)
class AxisError:
    """Error of the tool's position that the encoder of an axis cannot see.

    Attributes
    ----------
    position, lead_error : ndarray (n,) [m]
        Error of the tool's position over ascending axis positions, linear in between; empty for none.
    repeatability : float [m], >= 0
        Unidirectional repeatability by ISO 230-2 (4 s): each reversal draws a new offset of the tool, normal with s = a quarter of it.
    origins : mapping of str to Origin
        Source of each number, by name.

    Raises
    ------
    ParameterError
        If the table is not finite or not ascending, or the repeatability is negative.
    """

    position: Array = field(default_factory=lambda: np.zeros(0), metadata=setting("m", "mm"))
    lead_error: Array = field(default_factory=lambda: np.zeros(0), metadata=setting("m", "um"))
    repeatability: float = field(default=0.0, metadata=setting("m", "um", minimum=0.0))
    origins: Mapping[str, Origin] = field(default_factory=dict, compare=False, repr=False)

    def __post_init__(self) -> None:
        if self.position.shape != self.lead_error.shape or np.any(np.diff(self.position) <= 0.0):
            raise ParameterError("error.position", "a table", "as long as lead_error, with increasing positions", "m")
        if not (np.isfinite(self.position).all() and np.isfinite(self.lead_error).all()):
            raise ParameterError("error.lead_error", "a table", "finite", "m")
        refuse(not self.repeatability >= 0.0, ParameterError, "error.repeatability", f"{self.repeatability:g}", ">= 0", "m")


DIVISIONS = {
    "drive": "drive and sensors in the axis, everything else in the base, which sends commands",
    "observer": "drive, sensors and disturbance observer in the axis, which subtracts its own estimate from the commands of the base",
    "controller": "the whole controller in the axis; contour estimator and coupling in the base, which sends the reference",
}
"""Local parts, from the fewest to all, in words."""

_LOCAL = {"drive": ("velocity", "filters"), "observer": ("velocity", "observer", "filters")}
"""Slots in the axis; with "controller" all of them."""


@dataclass(frozen=True)
class Division:
    """An axis' controller divided into a base, the same for any axis, and a local part that moves with the axis.

    Each wire between the two goes through the link of its direction. Plant, filters, drive and sensors are always in the axis, and so is
    the velocity, unless a predictor in the base precedes it. Contour estimator, coupling, reference and learned tables are always in the
    base.

    Attributes
    ----------
    division : {"drive", "observer", "controller"}
        What is in the axis: see `DIVISIONS`.
    down : Component
        Link from the base to the axis.
    up : Component or None
        Link from the axis to the base. None if nothing comes back: the base sees no position, so the controller must be local. Use the
        ideal link if the base has its own wires to the sensors and messages go one way.

    Raises
    ------
    ParameterError
        If the division is unknown, or leaves the base without a position that it needs.

    References
    ----------
    Ghaffari & Ulsoy, Fig 1 and section IV; one way and both ways: Cakmakci & Ulsoy, IEEE/ASME Trans. Mechatronics 14 (2009), 307-316.
    """

    division: str = field(default="observer", metadata=setting(choices=DIVISIONS))
    down: Component = field(default_factory=IdealLink)
    up: Component | None = field(default_factory=IdealLink)

    def __post_init__(self) -> None:
        refuse(self.division not in DIVISIONS, ParameterError, "link.division", repr(self.division), "one of " + ", ".join(DIVISIONS))
        if self.up is None and self.division != "controller":
            bound = f'a link, because with division = "{self.division}" the base needs measurements; "ideal" if it has its own wires'
            raise ParameterError("link.up", '"none"', bound)

    def is_local(self, slot: str) -> bool:
        """Return whether a slot of an axis' controller is in the axis; ``others.NAME`` is where ``controller`` is."""
        return self.division == "controller" or slot in _LOCAL[self.division]
