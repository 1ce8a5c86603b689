"""The axis file of a drive of two inertias, out of a response at the motor, or at the load with the motor's inertia from elsewhere."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from contourlab.components.origin import Origin
from contourlab.errors import ParameterError
from contourlab.studies.identification.finding import Row, Tables, assumed
from contourlab.studies.identification.plant_tables import Forces, drive_table

__all__ = ["TwoInertias"]

PLANT = {
    "motor_inertia": ("motor_mass", "kg*m^2"),
    "load_inertia": ("load_mass", "kg*m^2"),
    "stiffness": ("stiffness", "N*m/rad"),
    "shaft_damping": ("shaft_damping", "N*m*s/rad"),
    "motor_damping": ("damping", "N*m*s/rad"),
}
"""Numbers of a plant of two inertias: what each is found as, and its unit."""


@dataclass(frozen=True)
class TwoInertias:
    """How what was found becomes inertias that turn.

    Attributes
    ----------
    lead : float [m]
        Travel per turn.
    motor_inertia : float or None [kg m^2]
        Of motor and screw, where the response at the load does not tell it.
    """

    lead: float
    motor_inertia: float | None = None

    @property
    def arm(self) -> float:
        """Travel per radian [m]."""
        return self.lead / (2.0 * math.pi)

    @property
    def note(self) -> str:
        """What is to be said of where the numbers are from."""
        return "" if self.motor_inertia is None else "frequency response at the load, with the motor's inertia as given"

    def check(self, x: Mapping[str, float]) -> None:
        """See that the motor's inertia leaves something to the load.

        Raises
        ------
        ParameterError
            If it does not.
        """
        if self.motor_inertia is None:
            return
        whole = x["mass"] * self.arm**2
        if self.motor_inertia >= whole:
            bound = f"below the whole inertia that the response tells, {whole:.4g}"
            raise ParameterError("motor_inertia", f"{self.motor_inertia:.4g}", bound, "kg*m^2")

    def numbers(self, x: Mapping[str, float]) -> dict[str, float]:
        """Return the numbers of the axis file by their names there, in SI, out of what was found."""
        parts = x if self.motor_inertia is None else self._shared(x, self.motor_inertia / self.arm**2)
        found = {f"plant.{name}": self.arm**2 * parts[key] for name, (key, _) in PLANT.items()}
        return found | {"drive.delay": x["delay"]}

    def _shared(self, x: Mapping[str, float], motor: float) -> dict[str, float]:
        """Return motor, load and shaft of a whole mass with a resonance."""
        load, w = x["mass"] - motor, 2.0 * math.pi * x["resonance"]
        reduced = motor * load / x["mass"]
        shaft = {"stiffness": reduced * w * w, "shaft_damping": 2.0 * x["damping_ratio"] * reduced * w}
        return {"motor_mass": motor, "load_mass": load, **shaft, "damping": x["damping"]}

    def tables(self, x: Mapping[str, float], told: Mapping[str, Origin], forces: Forces) -> Tables:
        """Return the tables of plant and drive.

        Parameters
        ----------
        x : mapping of str to float
            What was found.
        told : mapping of str to Origin
            Where each number is from, by its name in the axis file.
        forces : Forces
        """
        values = self.numbers(x)
        given = {} if self.motor_inertia is None else {"plant.motor_inertia": assumed("as given")}
        origins = {**told, **given}
        plant: dict[str, Row] = {
            "kind": ("two-inertia", "", None),
            "lead": (self.lead, "m", assumed("as given")),
            **{name: (values[f"plant.{name}"], unit, origins[f"plant.{name}"]) for name, (_, unit) in PLANT.items()},
            "torque_gain": (1.0, "", assumed("the command is counted as torque, force times lead over 2 pi")),
        }
        return {"plant": plant, "drive": drive_table(forces, x["delay"], lambda name, note="": origins[name], self.arm)}
