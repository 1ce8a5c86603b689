"""Read values with units, such as ``"20 mm"``, into SI, and write them."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from typing import Any

from contourlab.components.contract import Parameter
from contourlab.errors import UnitError, refuse
from contourlab.units import Setting, from_si, plain, split, to_si

_UNIT = re.compile(r"[A-Za-z%0-9_ */^().+-]{0,60}\Z")
_TURNS = re.compile(r"\b(rad|radians?|deg|degrees?|rev|revolutions?|turns?|rpm|cycles?|[mu]rad)\b")
_HERTZ = re.compile(r"\b[kMGm]?(Hz|hertz)\b")


def _check_turns(text: str, given: str, wanted: str) -> None:
    """Refuse to mix turns and radians: units treat both as bare numbers, a factor of 2 pi apart."""
    if _HERTZ.search(given) and wanted in ("rad/s", "1/s"):
        number = 2.0 * math.pi * to_si(text, "Hz")
        raise UnitError(f'{text!r} is a frequency, but the unit must be {wanted}: for turns per second, write "{number:.6g} {wanted}"')
    if wanted == "Hz" and _TURNS.search(given):
        raise UnitError(f"{text!r} is an angular velocity: divide by the angle of a full turn and write it in Hz")


def read_number(value: Any, unit: str, display: str = "") -> float:
    """Read one value into SI.

    Parameters
    ----------
    value : object
        Text with a unit, or a bare number if `unit` is empty.
    unit : str
        SI unit of the result; empty for a bare number.
    display : str
        Unit of the example in messages.

    Returns
    -------
    float
        Finite.

    Raises
    ------
    UnitError
        If it is not a finite number, or has no or the wrong unit.

    >>> read_number("6 m/min", "m/s")
    0.1
    """
    shown = display or unit
    if isinstance(value, bool) or not isinstance(value, str | int | float):
        raise UnitError(f"{value!r} is not a number: write " + (f'a quantity such as "20 {shown}"' if unit else "a number"))
    if not isinstance(value, str):
        return _bare(value, unit, shown)
    given = plain(split(value)[1]) if len(value) <= 120 else "?"
    if not _UNIT.match(given):
        example = f', such as "20 {shown}"' if unit else ""
        raise UnitError(f"{value[:60]!r} is not a quantity: write a number, a space and a unit{example}")
    if unit and not given:
        raise UnitError(f'{value!r} has no unit: write "{value.strip()} {shown}", or the same value in another unit')
    _check_turns(value, given, unit)
    number = to_si(value, unit)
    refuse(not math.isfinite(number), UnitError, f"{value!r} is not a finite number")
    return number


def _bare(value: float, unit: str, shown: str) -> float:
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise UnitError(f"{value if isinstance(value, float) else 'the number'} is not a finite number")
    refuse(unit, UnitError, f'{value!r} has no unit: write "{value!r} {shown}", or the same value in another unit')
    return number


def read_list(value: Any, unit: str, display: str = "") -> tuple[float, ...]:
    """Read several values into SI: a list of values, or a table ``{unit = "mm", values = [0, 50, 100]}``.

    Raises
    ------
    UnitError
        As `read_number`, with the item.

    >>> read_list({"unit": "mm", "values": [0, 250]}, "m")
    (0.0, 0.25)
    """
    if isinstance(value, dict):
        if set(value) != {"unit", "values"} or not isinstance(value["unit"], str):
            raise UnitError('a table of values needs the keys unit and values: {unit = "mm", values = [0, 50, 100]}')
        numbers, shared = value["values"], value["unit"]
        if not isinstance(numbers, Sequence) or isinstance(numbers, str):
            raise UnitError('values must be a list of numbers: {unit = "mm", values = [0, 50, 100]}')
        for number in numbers:
            if isinstance(number, bool) or not isinstance(number, int | float):
                raise UnitError(f"{number!r} in values is not a number: write the unit once, under unit")
        value = [f"{_bare(number, '', '')!r} {shared}".strip() for number in numbers]
    if not isinstance(value, Sequence) or isinstance(value, str):
        example = f'"20 {display or unit}"' if unit else "1, 2"
        raise UnitError(f"{value!r} is not a list: write [{example}, ...]")
    result = []
    for i, item in enumerate(value):
        try:
            result.append(read_number(item, unit, display))
        except UnitError as error:
            raise UnitError(f"item {i + 1}: {error}") from error
    return tuple(result)


def in_range(number: float, about: Setting | Parameter, shown: str) -> float:
    """Return a number in SI, called `shown` in messages.

    Raises
    ------
    UnitError
        If it is out of its range, or not whole where it must be.
    """
    whole = isinstance(about, Parameter) and about.whole
    low = number <= about.minimum if about.exclusive else number < about.minimum
    if low or number > about.maximum or (whole and number != round(number)):
        bound = show_bound(about.minimum, about.maximum, about.exclusive, about.display or about.unit)
        if whole:
            bound = "a whole number" if bound == "finite" else f"a whole number, {bound}"
        raise UnitError(f"{shown} is out of range: must be {bound}")
    return number


def show_bound(minimum: float, maximum: float, exclusive: bool, display: str) -> str:
    """Describe a range in the unit of `display`.

    >>> show_bound(0.0, 0.05, True, "mm")
    '> 0 and <= 50 mm'
    """
    bounds = []
    if minimum > -math.inf:
        bounds.append(f"{'>' if exclusive else '>='} {from_si(minimum, display):g}")
    if maximum < math.inf:
        bounds.append(f"<= {from_si(maximum, display):g}")
    return (" and ".join(bounds) + f" {display}").strip() if bounds else "finite"


def quantity(value: float, unit: str, display: str = "") -> str | float:
    """Write an SI value in its display unit if that reads back exactly, else in SI.

    >>> quantity(0.02, "m", "mm")
    '20 mm'
    """
    if not unit:
        return value
    for shown in dict.fromkeys((display or unit, unit)):
        number = from_si(value, shown)
        for digits in (6, 9, 12, 15, 17):
            text = f"{number:.{digits}g} {shown}"
            if to_si(text, unit) == value:
                return text
    return f"{value!r} {unit}"
