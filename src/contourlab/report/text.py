"""Numbers for people: an SI value in the unit of the workshop, with its unit."""

from __future__ import annotations

import math

NONE = "–"

# unit of a signal in SI -> (factor, unit in print); factors, because a report converts whole arrays.
_SHOWN = {
    "m": (1e3, "mm"),
    "m/s": (6e4, "mm/min"),
    "m/s^2": (1.0, "m/s²"),
    "m/s^3": (1.0, "m/s³"),
    "rad": (1e3, "mrad"),
    "um": (1.0, "µm"),
    "full_scale": (100.0, "% of full scale"),
}


def shown_unit(unit: str) -> tuple[float, str]:
    """Return the factor and the unit in which a value of SI unit `unit` is shown; an unknown unit is kept.

    >>> shown_unit("m/s")
    (60000.0, 'mm/min')
    """
    return _SHOWN.get(unit, (1.0, unit))


def plain_unit(unit: str) -> str:
    """Write a unit in plain ASCII, for terminals.

    >>> plain_unit("µm·s")
    'um s'
    """
    return unit.replace("µ", "u").replace("·", " ").replace("²", "^2").replace("³", "^3")


def number(value: float, digits: int = 3) -> str:
    """Write a number with `digits` significant digits and no needless exponent.

    >>> number(0.012345), number(1234.5), number(float("nan"))
    ('0.0123', '1234', '–')
    """
    if math.isnan(value):
        return NONE
    if math.isinf(value):
        return "∞" if value > 0 else "−∞"
    if value == 0.0:
        return "0"
    power = math.floor(math.log10(abs(value)))
    if power >= 7 or power < -5:
        text = f"{value:.{digits - 1}e}"
    else:
        # Rounding may carry into the next decade (9.996 -> 10.0): the count of decimals follows the rounded value.
        power = math.floor(math.log10(abs(float(f"{value:.{digits - 1}e}"))))
        text = f"{value:.{max(digits - 1 - power, 0)}f}"
    return text.replace("-", "−")


def quantity(value: float, unit: str, factor: float = 1.0, digits: int = 3) -> str:
    """Write ``value * factor`` with its unit.

    >>> quantity(1.234e-5, "µm", 1e6)
    '12.3 µm'
    """
    text = number(value * factor, digits)
    return text if text == NONE else f"{text} {unit}".strip()


def nominal(value: float, unit: str, factor: float = 1.0) -> str:
    """Write a given value, such as a limit or a tolerance: up to six digits, without trailing zeros.

    >>> nominal(5e-6, "µm", 1e6), nominal(0.1, "mm/min", 6e4)
    ('5 µm', '6000 mm/min')
    """
    return f"{value * factor:.6g} {unit}".strip().replace("-", "−")


def round_down(value: float) -> float:
    """Return the largest of 1, 2, 5 times a power of ten that is not above `value` (> 0).

    >>> round_down(780.0), round_down(0.04)
    (500.0, 0.02)
    """
    power = 10.0 ** math.floor(math.log10(value))
    # A hair of slack, so that 0.05 / 0.01 = 5.000000000000001 or 4.999999999999999 count as 5.
    return max((step for step in (1.0, 2.0, 5.0) if step <= value / power * (1 + 1e-12)), default=1.0) * power


def magnification(extent: float, largest: float, part: float = 0.1) -> float:
    """Return by how much to magnify errors so that the largest covers about `part` of a drawing `extent` wide.

    Parameters
    ----------
    extent, largest : float [m], >= 0
    part : float, > 0

    Returns
    -------
    float
        1, 2 or 5 times a power of ten, at least 1.

    >>> magnification(0.1, 12e-6)
    500.0
    """
    if not (largest > 0.0 and math.isfinite(largest) and extent > 0.0):
        return 1.0
    return max(1.0, round_down(part * extent / largest))
