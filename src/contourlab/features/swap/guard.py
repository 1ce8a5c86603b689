"""What a design has to hold besides a small error: margins of each axis, and drives that are not at their limits."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from contourlab.analysis.linear.loop_lanes import lane_loops, margin_factors, unstable_by
from contourlab.design.guards import Bounds, without_model
from contourlab.loop import Controller, Machine

Array = NDArray[np.float64]


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
    bounds: Bounds = field(default_factory=Bounds)
    unknown: dict[str, str] = field(init=False, default_factory=dict)

    def __post_init__(self) -> None:
        self.unknown.update(without_model(self.machine, self.controller))

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
        factors = margin_factors(10.0 ** (self.bounds.gain_margin / 20.0), math.radians(self.bounds.phase_margin))
        for axis in self.machine.axes:
            head = f"controller.axes.{axis.name}."
            mine = {name: np.asarray(values, dtype=float) for name, values in columns.items() if name.startswith(head)}
            if axis.name in self.unknown:
                continue
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
        return np.asarray(share - self.bounds.limited) if share is not None else np.zeros(1)


def holds(excess: Array, limited: Array) -> NDArray[np.bool_]:
    """Tell which designs keep all guards."""
    return np.asarray((excess < 0.0) & (limited <= 0.0))
