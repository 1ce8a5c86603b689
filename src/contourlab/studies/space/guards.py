"""What a design has to hold besides a small error: margins of each axis, and drives that are not at their limits."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.loop_lanes import lane_loops, margin_factors, unstable_by
from contourlab.analysis.margins import Margins
from contourlab.analysis.sampled_loop import sampled_loop
from contourlab.errors import ComponentError, ParameterError
from contourlab.loop import Controller, Machine

__all__ = ["Guard", "Guards", "holds"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Guards:
    """What is asked of a design.

    Attributes
    ----------
    gain_margin : float, >= 1
        Factor on the command of every axis under which its loop still holds.
    phase_margin : float [rad], 0 to pi
        Angle, either way.
    limited_share : float, 0 to 1
        Part of the counted samples in which a drive may be at its limit.
    """

    gain_margin: float = 2.0
    phase_margin: float = math.pi / 6.0
    limited_share: float = 0.0

    def __post_init__(self) -> None:
        if not (self.gain_margin >= 1.0 and math.isfinite(self.gain_margin)):
            raise ParameterError("gain_margin", f"{self.gain_margin:g}", "a factor >= 1, that is 0 dB or more")
        if not 0.0 <= self.phase_margin < math.pi:
            raise ParameterError("phase_margin", f"{math.degrees(self.phase_margin):g} deg", "0 to 180 deg")
        if not 0.0 <= self.limited_share <= 1.0:
            raise ParameterError("limited_share", f"{self.limited_share:g}", "0 to 1")

    def met(self, margins: Margins) -> bool:
        """Tell whether exact margins are enough."""
        return margins.stable and margins.gain >= self.gain_margin and abs(margins.phase) >= self.phase_margin


@dataclass(eq=False)
class Guard:
    """The guards on one machine under one controller, for many numbers at once.

    Attributes
    ----------
    unknown : dict of str to str
        Axes without a linear model, and why: their margins are not looked at.
    """

    machine: Machine
    controller: Controller
    guards: Guards = field(default_factory=Guards)
    unknown: dict[str, str] = field(init=False, default_factory=dict)

    def __post_init__(self) -> None:
        for axis in self.machine.axes:
            try:
                self._loop(axis.name)
            except ComponentError as error:
                self.unknown[axis.name] = str(error)

    def _loop(self, name: str) -> object:
        machine = self.machine
        return sampled_loop(machine.axis(name), self.controller.axes[name], machine.servo_period, machine.carried_mass(name))

    def excess(self, columns: Mapping[str, Array], known: dict[tuple[object, ...], Array] | None = None) -> Array:
        """Return by how much each design (n,) breaks a margin: above 0 where it does.

        Parameters
        ----------
        columns : mapping of str to ndarray (n,)
            Values [SI] by dotted names.
        known : dict, optional
            What was worked out before for the same axes and numbers, of this machine or another one that shares them; is added to.
        """
        n = len(next(iter(columns.values())))
        worst = np.full(n, -math.inf)
        factors = margin_factors(self.guards.gain_margin, self.guards.phase_margin)
        for axis in self.machine.axes:
            head = f"controller.axes.{axis.name}."
            mine = {name: np.asarray(values, dtype=float) for name, values in columns.items() if name.startswith(head)}
            if axis.name in self.unknown:
                continue
            if not mine:
                mine = {f"{head}none": np.zeros(1)}
            carried = self.machine.carried_mass(axis.name)
            key = (id(axis), carried, *((name, values.tobytes()) for name, values in mine.items()))
            found = None if known is None else known.get(key)
            if found is None:
                loops = lane_loops(axis, self.controller.axes[axis.name], self.machine.servo_period, carried, mine)
                found = unstable_by(loops, factors)
                if known is not None:
                    known[key] = found
            worst = np.maximum(worst, found)
        return worst

    def limited(self, figures: Mapping[str, Array]) -> Array:
        """Return by how much each design (n,) has drives at their limits for longer than it may: above 0 where it does."""
        share = figures.get("limited_share")
        return np.asarray(share - self.guards.limited_share) if share is not None else np.zeros(1)


def holds(excess: Array, limited: Array) -> NDArray[np.bool_]:
    """Tell which designs keep all guards."""
    return np.asarray((excess < 0.0) & (limited <= 0.0))
