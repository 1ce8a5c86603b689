"""The axis file of a drive of two inertias, out of masses that move along the axis."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from contourlab.components.origin import Origin
from contourlab.features.identify.finding import Row, Tables, assumed
from contourlab.features.identify.limits import MotionLimits
from contourlab.features.identify.plant_tables import Forces, drive_table

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
    given : frozenset of str
        What was given of the parameters, not found.
    """

    lead: float
    given: frozenset[str] = frozenset()

    @property
    def arm(self) -> float:
        """Travel per radian [m]."""
        return self.lead / (2.0 * math.pi)

    @property
    def note(self) -> str:
        """What is to be said of where the numbers are from."""
        return "frequency response at the load, with the motor's inertia as given" if self.given else "frequency response"

    def numbers(self, x: Mapping[str, float]) -> dict[str, float]:
        """Return the numbers of the axis file by their names there, in SI, out of what was found and given."""
        return {f"plant.{name}": self.arm**2 * x[key] for name, (key, _) in PLANT.items()} | {"drive.delay": x["delay"]}

    def tables(self, x: Mapping[str, float], told: Mapping[str, Origin], forces: Forces, limits: MotionLimits) -> Tables:
        """Return the tables of plant, drive and limits.

        Parameters
        ----------
        x : mapping of str to float
            What was found and given.
        told : mapping of str to Origin
            Where each number is from, by its name in the axis file.
        forces : Forces
        limits : MotionLimits
        """
        values = self.numbers(x)
        given = {f"plant.{name}": assumed("as given") for name, (key, _) in PLANT.items() if key in self.given}
        origins = {**told, **given}
        plant: dict[str, Row] = {
            "kind": ("two-inertia", "", None),
            "lead": (self.lead, "m", assumed("as given")),
            **{name: (values[f"plant.{name}"], unit, origins[f"plant.{name}"]) for name, (_, unit) in PLANT.items()},
            "torque_gain": (1.0, "", assumed("the command is counted as torque, force times lead over 2 pi")),
        }
        drive = drive_table(forces, limits.command, limits.origin, x["delay"], lambda name, note="": origins[name], self.arm)
        return {"plant": plant, "drive": drive, "limits": limits.table}
