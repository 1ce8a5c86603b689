"""Which parts of an axis' controller stand in the axis and which in the base, and the messages between the two."""

from __future__ import annotations

from dataclasses import dataclass, field

from contourlab.components.contract import Component
from contourlab.components.ideal import IdealLink
from contourlab.errors import ParameterError

DIVISIONS = {
    "drive": "drive and sensors in the axis, all else in the base: commands go down",
    "observer": "the disturbance observer in the axis with them: commands go down, and the axis takes its own estimate off",
    "controller": "the whole controller in the axis, contour estimator and coupling in the base: the reference goes down",
}
"""What is local, from the least to the most, in words."""

_LOCAL = {"drive": ("velocity",), "observer": ("velocity", "observer")}
"""Slots in the axis; under "controller" it is all of them."""


@dataclass(frozen=True)
class Division:
    """One axis' controller in two: the base, the same whatever axis it drives, and the local one, which comes and goes with the axis.

    Each wire from one side to the other goes through the link of its direction; wires within a side do not. Plant, drive and sensors are in
    the axis always, and what makes a velocity of the sensors' counts, unless a predictor in the base comes before it; contour estimator,
    coupling, reference and what was learned are in the base always.

    Attributes
    ----------
    division : {"drive", "observer", "controller"}
        What is in the axis: see `DIVISIONS`.
    down : Component
        Link from the base to the axis.
    up : Component or None
        Link from the axis to the base. None where nothing comes back: the base sees no position, which only a local controller can do
        without. Where the base has wires of its own to the sensors, and messages go one way, it is the ideal one.

    References
    ----------
    Ghaffari & Ulsoy, Fig 1 and section IV; one way and both ways: Cakmakci & Ulsoy, IEEE/ASME Trans. Mechatronics 14 (2009), 307-316.
    """

    division: str = "observer"
    down: Component = field(default_factory=IdealLink)
    up: Component | None = field(default_factory=IdealLink)

    def __post_init__(self) -> None:
        if self.division not in DIVISIONS:
            raise ParameterError("link.division", repr(self.division), "one of " + ", ".join(DIVISIONS))
        if self.up is None and self.division != "controller":
            bound = f'a link, as the base needs measurements in the division "{self.division}"; "ideal" if it has wires of its own'
            raise ParameterError("link.up", '"none"', bound)

    def is_local(self, slot: str) -> bool:
        """Tell whether a slot of an axis' controller stands in the axis; ``others.NAME`` stands where ``controller`` does."""
        return self.division == "controller" or slot in _LOCAL[self.division]
