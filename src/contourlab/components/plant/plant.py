"""Plants: what the servo loop asks of what a drive moves."""

from __future__ import annotations

from typing import Any, ClassVar

from contourlab.components.contract import Component


class Plant(Component):
    """What a drive moves: one mass, or several behind each other.

    Attributes
    ----------
    command_unit, force_unit : str
        Units of the command that drives it and of the forces on it.
    two_sided : bool
        Whether the motor can stand elsewhere than the load: then it has outputs ``motor_position`` and ``motor_velocity``.
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
