"""Plants that are one mass on one axis: what they share."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from contourlab.components.contract import LinearModel
from contourlab.components.plant.plant import Plant
from contourlab.engine.step import Port


class SingleMass(Plant):
    """A mass with viscous damping, pushed by a drive: v' = mobility (drive force + load - friction) - decay v.

    A plant of this family derives ``mobility_value`` and ``decay_value``, or overrides `mobility` and `decay`, and gives `drive_force`; one
    that knows its masses has `mass` and `carried_mass`. `contourlab.components.mechanics.core` integrates it with a friction.
    """

    states: ClassVar[tuple[Port, ...]] = (Port("position"), Port("velocity"))
    inputs = (Port("command"), Port("load"))
    outputs = (Port("position"), Port("velocity"), Port("acceleration"))

    @staticmethod
    def mobility(par: Any) -> float:
        """Return the acceleration per force [m/s^2 per force unit]."""
        return par.mobility_value  # type: ignore[no-any-return]

    @staticmethod
    def decay(par: Any) -> float:
        """Return the rate at which a free motion decays [1/s]."""
        return par.decay_value  # type: ignore[no-any-return]

    @staticmethod
    def drive_force(par: Any, command: float) -> float:
        """Return the force of the drive."""
        raise NotImplementedError

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        return {"position": position}, {"position": position}

    def mobilities(self) -> tuple[float, ...]:
        return (float(type(self).mobility(self.constants())),)

    def rigid_model(self) -> tuple[float, float]:
        par = self.constants()
        kind = type(self)
        return float(kind.mobility(par) * kind.drive_force(par, 1.0)), float(kind.decay(par))

    def linearize(self) -> LinearModel:
        par = self.constants()
        mobility, decay = type(self).mobility(par), type(self).decay(par)
        a = np.array([[0.0, 1.0], [0.0, -decay]])
        b = np.array([[0.0, 0.0], [mobility * type(self).drive_force(par, 1.0), mobility]])
        return LinearModel(a, b, np.eye(2), np.zeros((2, 2)), ("command", "load"), ("position", "velocity"))
