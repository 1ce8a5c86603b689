"""What a calibration must not cross: stability, gain and phase margin of every axis, stability of the coupling, limits of the drives."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.linear.contour_transfer import internal_stability
from contourlab.analysis.linear.loop_lanes import rough_margins, sampled_loops
from contourlab.analysis.linear.margins import Margins
from contourlab.analysis.linear.sampled_loop import SampledLoop, sampled_loop
from contourlab.design.axes_of import axes_of
from contourlab.design.bounds import ROUNDING, SLACK, Bounds, without_model
from contourlab.design.values import with_values
from contourlab.errors import ComponentError
from contourlab.loop import Controller, Machine

Array = NDArray[np.float64]


@dataclass(eq=False)
class Guards:
    """Bounds on one or more machines under controllers that have the same numbers.

    Attributes
    ----------
    cases : sequence of (Machine, Controller)
    bounds : Bounds
    unknown : dict of str to str
        Axes whose loop has no linear model, and why: of these only the runs themselves are looked at.
    checks : int
        How many loops were looked at.
    """

    cases: Sequence[tuple[Machine, Controller]]
    bounds: Bounds
    unknown: dict[str, str] = field(default_factory=dict)
    checks: int = 0

    def __post_init__(self) -> None:
        for case in self.cases:
            self.unknown.update(without_model(*case))

    @property
    def axes(self) -> tuple[str, ...]:
        """Names of all axes."""
        return tuple(dict.fromkeys(name for machine, _ in self.cases for name in machine.axis_names))

    def concerned(self, name: str) -> tuple[str, ...]:
        """Return the axes whose loop a number is part of."""
        return tuple(dict.fromkeys(axis for machine, _ in self.cases for axis in axes_of(name, machine)))

    def loops(self, columns: Mapping[str, Array], axes: Sequence[str]) -> list[list[SampledLoop]]:
        """Return for each set of values the loops of some axes, of all machines."""
        n = len(next(iter(columns.values())))
        found: list[list[SampledLoop]] = [[] for _ in range(n)]
        for machine, controller in self.cases:
            for axis in machine.axes:
                if axis.name in axes and axis.name not in self.unknown:
                    carried = machine.carried_mass(axis.name)
                    made = sampled_loops(axis, controller.axes[axis.name], machine.servo_period, columns, carried)
                    for mine, loop in zip(found, made, strict=True):
                        mine.append(loop)
        return found

    def missing(self, loops: Sequence[SampledLoop]) -> tuple[float, float]:
        """Return how much margins fall short, and the smallest distance of a loop from -1, read off a grid."""
        short, nearest = 0.0, math.inf
        for loop in loops:
            self.checks += 1
            found = rough_margins(loop)
            short = max(short, self.bounds.missing(found, SLACK))
            nearest = min(nearest, found.modulus if found.stable else 0.0)
            if math.isinf(short):
                break
        return short, nearest

    def exact(self, values: Mapping[str, float]) -> dict[str, Margins]:
        """Return the margins of every axis with values [SI], exactly; of several machines the worst."""
        found: dict[str, Margins] = {}
        for case in self.cases:
            machine, controller = with_values(*case, values)
            for axis in machine.axes:
                if axis.name not in self.unknown:
                    carried = machine.carried_mass(axis.name)
                    margins = sampled_loop(axis, controller.axes[axis.name], machine.servo_period, carried).margins()
                    found[axis.name] = max(found.get(axis.name, margins), margins, key=self._worse)
        return found

    def _worse(self, margins: Margins) -> tuple[float, float]:
        """Return what is larger for worse margins: how far they fall short, and where none do, how near the loop comes to -1."""
        return self.bounds.missing(margins), -margins.modulus if margins.stable else 0.0

    def uncoupled(self, values: Mapping[str, float]) -> str:
        """Return in words that the coupling of the axes is unstable with values [SI]; empty where it is not, or where there is none."""
        for case in self.cases:
            machine, controller = with_values(*case, values)
            if controller.coupling is None or self.unknown:
                continue
            try:
                found = internal_stability(machine, controller)
            except ComponentError:
                continue
            if not found.stable:
                return str(found.verdict)
        return ""

    def broken(
        self, values: Mapping[str, float], limited: float, largest: float, exact: Mapping[str, Margins] | None = None
    ) -> tuple[str, ...]:
        """Return in words all that is not kept with values [SI], by the exact analysis; `exact` are the margins where they are known."""
        margins = self.exact(values) if exact is None else exact
        found = [f"axis {axis}: {words}" for axis, one in margins.items() if (words := self.bounds.broken(one))]
        coupled = self.uncoupled(values)
        found += [f"coupling: {coupled}"] if coupled else []
        if limited > self.bounds.limited + ROUNDING:
            found.append(f"at a limit of a drive for {100.0 * limited:.3g} % of the time")
        if largest > self.bounds.command * (1.0 + ROUNDING):
            found.append(f"a command of {100.0 * largest:.3g} % of the drive")
        return tuple(found)
