"""Format SI values for people, in workshop units. Only this module decides digits and unit symbols."""

from __future__ import annotations

import math
from collections.abc import Hashable, Iterable
from typing import TypeVar

Key = TypeVar("Key", bound=Hashable)
Value = TypeVar("Value")

NONE = "-"
"""Text of an unknown value."""

FACTORS = {
    "um": 1e6, "mm": 1e3, "m": 1.0, "um s": 1e6, "mm/s": 1e3, "mm/min": 6e4, "m/s": 1.0, "mm/s^2": 1e3, "m/s^2": 1.0, "m/s^3": 1.0,
    "ns": 1e9, "us": 1e6, "ms": 1e3, "s": 1.0, "min": 1 / 60, "Hz": 1.0, "kHz": 1e-3, "1/s": 1.0, "rad/s": 1.0,
    "deg": 180 / math.pi, "mrad": 1e3, "um/m": 1e6, "%": 100.0, "kg": 1.0, "N": 1.0, "V": 1.0, "": 1.0,
}  # fmt: skip
"""Display units, and their factors from SI."""
_SHOWN = {"m": "mm", "m/s": "mm/min", "rad": "mrad"}


def figure(value: float, unit: str = "", digits: int = 3) -> str:
    """Write an SI value in a display unit, with significant digits.

    Parameters
    ----------
    value : float
        In SI. nan becomes ``-``, infinity ``inf``.
    unit : str
        Display unit: one of `FACTORS`.
    digits : int

    >>> figure(1.234e-5, "um"), figure(0.0301, "%"), figure(1500.0)
    ('12.3 um', '3.01 %', '1500')
    """
    text = number(value * FACTORS[unit], digits)
    return text if text == NONE else f"{text} {unit}".strip()


def number(value: float, digits: int = 3) -> str:
    """Write a number with significant digits and no needless exponent.

    >>> number(0.012345), number(1234.5, 6), number(-9.996)
    ('0.0123', '1234.5', '-10')
    """
    if math.isnan(value):
        return NONE
    text = f"{value:.{digits}g}"
    return f"{float(text):.0f}" if "e" in text and 1.0 <= abs(value) < 1e7 else text


def limit_to_propose(length: float) -> str:
    """Write a length [m] as a tolerance to propose: with one digit, and above the rounding of exact data.

    >>> limit_to_propose(2.4e-5), limit_to_propose(3e-18)
    ('20 um', '0.001 um')
    """
    return f"{float(f'{max(1e6 * length, 1e-3):.1g}'):g} um"


def shown_unit(unit: str) -> tuple[float, str]:
    """Return the factor and the display unit for values of an SI unit; an unknown unit stays as it is.

    >>> shown_unit("m/s")
    (60000.0, 'mm/min')
    """
    if unit == "full_scale":
        return 100.0, "% of full scale"
    shown = _SHOWN.get(unit, unit)
    return FACTORS.get(shown, 1.0) if shown != unit else 1.0, shown


def listing(names: tuple[str, ...] | list[str]) -> str:
    """Join names: ``x``, ``x and y``, ``x, y and z``; with semicolons where a name has a comma.

    >>> listing(["x", "y", "z"]), listing(["drive, one way", "drive, both ways"])
    ('x, y and z', 'drive, one way; drive, both ways')
    """
    if any("," in name for name in names):
        return "; ".join(names)
    return " and ".join(", ".join(names).rsplit(", ", 1)) if names else "none"


def grouped(pairs: Iterable[tuple[Key, Value]]) -> dict[Key, list[Value]]:
    """Return the values of pairs (key, value) by key, in the order of the first of each.

    >>> grouped([("x", 1), ("y", 2), ("x", 3)])
    {'x': [1, 3], 'y': [2]}
    """
    groups: dict[Key, list[Value]] = {}
    for key, value in pairs:
        groups.setdefault(key, []).append(value)
    return groups
