"""Base classes of plants and of single-mass plants."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np

from contourlab.components.contract import Component, LinearModel
from contourlab.engine.step import Port


class Plant(Component):
    """Base of plants: one mass, or several in series.

    Attributes
    ----------
    command_unit, force_unit : str
        Units of the command that drives it and of the forces on it.
    two_sided : bool
        Whether motor and load can differ in position: then it has outputs ``motor_position`` and ``motor_velocity``.
    rest_depends : tuple of str
        Parameters that determine the states at rest.
    """

    family = "plant"
    command_unit: ClassVar[str] = "N"
    force_unit: ClassVar[str] = "N"
    two_sided: ClassVar[bool] = False
    rest_depends: ClassVar[tuple[str, ...]] = ()

    @staticmethod
    def moved_mass(par: Any) -> Any:
        """Return the mass in linear motion [kg], without rotary inertia: numbers or arrays (n_variant,)."""
        return par.mass + par.carried_mass

    def rigid_model(self) -> tuple[float, float]:
        """Return gain a [m/s^2 per command] and damping b [1/s] of v' = a u - b v, the plant for slow motions."""
        raise NotImplementedError

    @property
    def knows_mass(self) -> bool:
        """Whether mass can be added; if not, only the response is known."""
        return "carried_mass" in self.parameters

    def loaded(self, mass: float) -> Any:
        """Return the plant with `mass` [kg] added; unchanged if only its response is known."""
        if not mass or not self.knows_mass:
            return self
        return self.replace(carried_mass=self.values()["carried_mass"] + mass)

    def fewest_substeps(self, dt: float) -> tuple[int, str]:
        """Return the least number of sub-steps over the time dt [s], and the reason as text; for all variants if parameters are arrays."""
        return 1, ""

    @property
    def force_per_command(self) -> float:
        """Force of the drive on the axis per command."""
        raise NotImplementedError

    def mobilities(self) -> tuple[float, ...]:
        """Return the acceleration per force [m/s^2 per force unit] where a friction acts: at the load, and at the motor if it has one."""
        raise NotImplementedError


class SingleMass(Plant):
    """A mass with viscous damping, pushed by a drive: v' = mobility (drive force + load - friction) - decay v.

    A subclass derives ``mobility_value`` and ``decay_value``, or overrides `mobility` and `decay`, and defines `drive_force`. If its mass
    is known it has `mass` and `carried_mass`. `contourlab.components.mechanics.core` integrates it with a friction.
    """

    states: ClassVar[tuple[Port, ...]] = (Port("position"), Port("velocity"))

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

    @property
    def force_per_command(self) -> float:
        return float(self.drive_force(self.constants(), 1.0))

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
