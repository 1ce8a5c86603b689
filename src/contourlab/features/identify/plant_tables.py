"""The plant and the drive of an axis file out of gain and damping: in newtons where the command is a force, else in parts of full scale."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from contourlab.components.origin import Origin
from contourlab.features.identify.finding import Row, assumed
from contourlab.features.identify.signals import AxisRecord

Told = Callable[..., Origin]
"""From the name of a number, such as "plant.mass", and a note to where it is from."""


@dataclass(frozen=True)
class Forces:
    """How forces are counted in an axis file.

    Attributes
    ----------
    unit : str
        ``"N"`` or ``"full_scale"``.
    one : float [unit of the command]
        What counts as one of them.
    largest : float [unit of the command]
        In the logs.
    constant : float [N/A]
        Force per command as it was given; a command of the log counts as so many amperes.
    source : str
        Name of the log.
    note : str
        What is assumed of full scale; empty where nothing is.
    """

    unit: str
    one: float
    largest: float
    constant: float
    source: str
    note: str


def forces_of(records: Sequence[AxisRecord]) -> Forces:
    """Return how forces are counted: as the command is, or in parts of its largest where that is neither a force nor in parts already.

    Raises
    ------
    ResultError
        If a log has no command.
    """
    unit, source = records[0].unit, records[0].source
    largest = max(record.largest() for record in records)
    if unit == "N":
        return Forces("N", 1.0, largest, abs(records[0].gain), source, "")
    if unit in ("", "full_scale"):
        return Forces("full_scale", 1.0, largest, 1.0, source, "")
    where = "log" if len(records) == 1 else "logs"
    note = f"full scale is assumed to be the largest command in the {where}, {largest:.4g} {unit}"
    return Forces("full_scale", largest, largest, 1.0, source, note)


def plant_numbers(forces: Forces, a: float, b: float) -> dict[str, float]:
    """Return the numbers of the plant v' = -b v + a u by their names in an axis file, in SI.

    Parameters
    ----------
    forces : Forces
    a : float [m/s^2 per command], > 0
    b : float [1/s]
    """
    if forces.unit == "N":
        return {"plant.mass": 1.0 / a, "plant.damping": b / a}
    return {"plant.gain": forces.one * a, "plant.damping": b}


def plant_table(forces: Forces, a: float, b: float, told: Told) -> dict[str, Row]:
    """Return the table of that plant, each number with where it is from."""
    x = plant_numbers(forces, a, b)
    if forces.unit == "N":
        return {
            "kind": ("mass-damper", "", None),
            "mass": (x["plant.mass"], "kg", told("plant.mass")),
            "damping": (x["plant.damping"], "N*s/m", told("plant.damping")),
            "force_constant": (forces.constant, "N/A", assumed("as given; a command counts as so many amperes")),
        }
    return {
        "kind": ("rigid-axis", "", None),
        "gain": (x["plant.gain"], "m/s^2/full_scale", told("plant.gain", forces.note)),
        "damping": (x["plant.damping"], "1/s", told("plant.damping")),
    }


def drive_table(forces: Forces, limit: float, origin: Origin, delay: float, told: Told, arm: float | None = None) -> dict[str, Row]:
    """Return the table of the drive: its limit, and its delay where there is one.

    Parameters
    ----------
    forces : Forces
    limit : float [command]
    origin : Origin
        Of the limit.
    delay : float [s]
    told : callable
    arm : float [m], optional
        Travel per radian, where the plant takes torques.
    """
    if arm is not None:
        top: Row = (limit * arm, "N*m", origin)
    elif forces.unit == "N":
        top = (limit / forces.constant, "A", origin)
    else:
        top = (limit / forces.one, "full_scale", origin)
    if delay <= 0.0:
        return {"kind": ("saturation", "", None), "limit": top}
    return {"kind": ("delayed-saturation", "", None), "limit": top, "delay": (delay, "s", told("drive.delay"))}
