"""Internal stability of coupled axes: with every direction of the path at rest, and along a closed path as it turns."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from contourlab.analysis.learning.trial_map import TrialMap
from contourlab.analysis.linear.contour_transfer import LEFT_STANDING, ContourMargins, ContourTransfer
from contourlab.analysis.linear.coupled_loop import coupled_loop
from contourlab.analysis.linear.tick_map import poles_of
from contourlab.feed import Reference
from contourlab.loop.machine import Controller, Machine


@dataclass(frozen=True)
class InternalStability:
    """Whether coupled axes are stable inside, in three steps, each of which needs the one before.

    Attributes
    ----------
    axes : dict of str to bool
        Each axis alone under its own controller.
    directions : ContourMargins or None
        The coupling with the direction of the path at rest, over all directions; None without a coupling.
    lap : float
        Largest multiplier of a small error once round a closed path, its normal turning: below 1 it dies; nan where there is no closed
        path. States that only stand still are left out.
    """

    axes: dict[str, bool]
    directions: ContourMargins | None
    lap: float

    @property
    def stable(self) -> bool:
        """Whether nothing that was looked at is unstable."""
        frozen = self.directions is None or self.directions.stable
        return all(self.axes.values()) and frozen and not self.lap >= 1.0

    @property
    def verdict(self) -> str:
        """What was found, in words."""
        bad = [name for name, stable in self.axes.items() if not stable]
        if bad:
            return f"axis {', '.join(bad)} is unstable under its own controller: no coupling is to be added before that is mended"
        if self.directions is None:
            return "every axis is stable, and nothing couples them"
        if not self.directions.stable:
            worst = ", ".join(f"{name} {part:.2f}" for name, part in zip(self.axes, self.directions.modulus_direction, strict=True))
            return f"the coupling is unstable where the path stands at ({worst}), near {self._hertz:.3g} Hz: lower its gain"
        said = f"stable in every direction at rest, never nearer to -1 than {self.directions.modulus:.2f}, at {self._hertz:.3g} Hz"
        if math.isnan(self.lap):
            return f"{said}; a path that turns fast may differ"
        if self.lap >= 1.0:
            return f"{said}, and yet unstable on this path: an error grows by {self.lap:.3g} in a lap, since the path turns too fast"
        return f"{said}, and along this path: a lap leaves {self.lap:.2g} of an error"

    @property
    def _hertz(self) -> float:
        return (self.directions.modulus_frequency if self.directions is not None else math.nan) / (2.0 * math.pi)


def internal_stability(machine: Machine, controller: Controller, reference: Reference | None = None) -> InternalStability:
    """Return whether coupled axes are stable inside.

    By the theorem of Yeh and Hsu the machine is internally stable if each axis is, and (C_cc, P_e) is for every normal. That holds for
    normals that stand still: for normals that turn the product of the ticks of a lap is looked at.

    Parameters
    ----------
    machine, controller
        Linear but for limits, friction and quantisation, which are left out.
    reference : Reference, optional
        Of a closed path with whole laps; the last one is taken.

    Raises
    ------
    ComponentError
        If a component is not linear.

    References
    ----------
    Yeh & Hsu, "Theory and applications of the robust cross-coupled control design", Proc. American Control Conference (1997); Gecer Ulu,
    Ulu & Cakmakci, section 4.
    """
    loop = coupled_loop(machine, controller)
    axes = {name: axis.loop.stable for name, axis in zip(loop.names, loop.axes, strict=True)}
    margins = None if controller.coupling is None else ContourTransfer(loop).margins()
    lap = math.nan
    if reference is not None and reference.laps and all(axes.values()):
        start, stop = reference.laps[-1]
        tangents = reference.path.tangent(reference.block(start, stop).arc_length)
        multipliers = poles_of(TrialMap(loop, tangents).monodromy())
        moving = multipliers[np.abs(multipliers - 1.0) > LEFT_STANDING]
        lap = float(np.abs(moving).max(initial=0.0))
    return InternalStability(axes, margins, lap)
