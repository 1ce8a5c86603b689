"""Figures for people: an SI value in the unit of the workshop. The one place that decides digits and unit symbols."""

from __future__ import annotations

import math

# display unit -> factor from SI
_FACTORS = {
    "um": 1e6, "mm": 1e3, "m": 1.0, "um s": 1e6, "mm/s": 1e3, "mm/min": 6e4, "m/s": 1.0, "mm/s^2": 1e3, "m/s^2": 1.0, "m/s^3": 1.0,
    "us": 1e6, "ms": 1e3, "s": 1.0, "min": 1 / 60, "Hz": 1.0, "kHz": 1e-3, "1/s": 1.0, "rad/s": 1.0,
    "deg": 180 / math.pi, "mrad": 1e3, "um/m": 1e6, "%": 100.0, "kg": 1.0, "N": 1.0, "V": 1.0, "": 1.0,
}


def figure(value: float, unit: str = "", digits: int = 3) -> str:
    """Write an SI value in a display unit, with significant digits.

    Parameters
    ----------
    value : float
        In SI. nan becomes ``-``, infinity ``inf``.
    unit : str
        Display unit: one of `display_units`.
    digits : int

    >>> figure(1.234e-5, "um"), figure(0.0301, "%"), figure(1500.0)
    ('12.3 um', '3.01 %', '1500')
    """
    if math.isnan(value):
        return "-"
    shown = value * _FACTORS[unit]
    if math.isinf(shown):
        return "inf" if shown > 0 else "-inf"
    text = f"{shown:.{digits}g}"
    if "e" in text and 1.0 <= abs(shown) < 1e7:
        text = f"{float(text):.0f}"
    return f"{text} {unit}".strip()


def display_units() -> frozenset[str]:
    """Return the units that `figure` knows."""
    return frozenset(_FACTORS)


def listing(names: tuple[str, ...] | list[str]) -> str:
    """Join names: ``x``, ``x and y``, ``x, y and z``."""
    return " and ".join(", ".join(names).rsplit(", ", 1)) if names else "none"
