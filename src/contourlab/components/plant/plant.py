"""Plants: what the servo loop asks of what a drive moves, and the plant of one mass."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from contourlab.components.contract import Component, LinearModel
from contourlab.engine.step import Port


class Plant(Component):
    """What a drive moves: one mass, or several behind each other.

    Attributes
    ----------
    command_unit, force_unit : str
        Units of the command that drives it and of the forces on it.
    two_sided : bool
        Whether motor and load can differ in position: then it has outputs ``motor_position`` and ``motor_velocity``.
    rest_depends : tuple of str
        Parameters that decide where its states are at rest.
    """

    family = "plant"
    command_unit: ClassVar[str] = "N"
    force_unit: ClassVar[str] = "N"
    two_sided: ClassVar[bool] = False
    rest_depends: ClassVar[tuple[str, ...]] = ()

    @staticmethod
    def moved_mass(par: Any) -> Any:
        """Return the mass that moves in a straight line [kg], without what only turns: numbers or arrays (n_variant,)."""
        return par.mass + par.carried_mass

    def rigid_model(self) -> tuple[float, float]:
        """Return gain a [m/s^2 per command] and damping b [1/s] of v' = a u - b v, as slow motions see the plant."""
        # What tells one plant from another.
        raise NotImplementedError

    @property
    def knows_mass(self) -> bool:
        """Whether it can be given more mass; else it is known by its response only."""
        return "carried_mass" in self.parameters

    def loaded(self, mass: float) -> Any:
        """Return the plant with more mass [kg] on it; one that is known by its response only stays as it is."""
        if not mass or not self.knows_mass:
            return self
        return self.replace(carried_mass=self.values()["carried_mass"] + mass)

    def fewest_substeps(self, dt: float) -> tuple[int, str]:
        """Return in how many sub-steps at least it is to be integrated over the time dt [s], and what for, in words."""
        return 1, ""

    def mobilities(self) -> tuple[float, ...]:
        """Return the acceleration per force [m/s^2 per force unit] where a friction acts: at the load, and at the motor if it has one."""
        # What tells one plant from another.
        raise NotImplementedError


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
