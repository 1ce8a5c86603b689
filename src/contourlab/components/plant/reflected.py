"""Mass and inertia reflected through a screw or a pinion."""

from __future__ import annotations

import math

from contourlab.errors import ParameterError


def reflected_inertia(mass: float, lead: float) -> float:
    """Return the inertia of a mass reflected to a shaft, m (l/2 pi)^2.

    Parameters
    ----------
    mass : float [kg], >= 0
    lead : float [m], > 0
        Travel per turn of the shaft; for a rack, the circumference of its pinion.

    Returns
    -------
    float [kg*m^2]

    Raises
    ------
    ParameterError
        If a number is out of range.

    >>> f"{reflected_inertia(100.0, 0.01):.4g}"  # 100 kg on a screw of 10 mm
    '0.0002533'
    """
    _check("mass", mass, "kg", mass >= 0.0)
    _check("lead", lead, "m", lead > 0.0)
    return mass * (lead / (2.0 * math.pi)) ** 2


def reflected_mass(inertia: float, lead: float) -> float:
    """Return the mass of an inertia reflected to the table, J (2 pi/l)^2.

    Parameters
    ----------
    inertia : float [kg*m^2], >= 0
    lead : float [m], > 0
        Travel per turn of the shaft.

    Returns
    -------
    float [kg]

    Raises
    ------
    ParameterError
        If a number is out of range.

    >>> round(reflected_mass(reflected_inertia(100.0, 0.01), 0.01), 9)
    100.0
    """
    _check("inertia", inertia, "kg*m^2", inertia >= 0.0)
    _check("lead", lead, "m", lead > 0.0)
    return inertia * (2.0 * math.pi / lead) ** 2


def _check(name: str, value: float, unit: str, within: bool) -> None:
    if not (within and math.isfinite(value)):
        raise ParameterError(name, f"{value:g}", "finite and > 0" if name == "lead" else "finite and >= 0", unit)
