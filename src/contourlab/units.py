"""Conversion of quantities with units, such as ``"8000 mm/min"``, to bare SI numbers and back.

Inside contourlab every number is in SI base units. ``full_scale`` is the unit of a normalised drive's command (1 = the most the drive can
give). It is a dimension of its own, so that it never mixes with newton or volt.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Collection
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import TYPE_CHECKING, Any, TypeVar

from contourlab.errors import UnitError

if TYPE_CHECKING:
    import pint

    from contourlab.arrays import Array

Numbers = TypeVar("Numbers", float, "Array")

_CLOSE = re.compile(r"(?P<number>[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?)(?P<unit>[A-Za-zµμ°%Ω(].*)\Z")
"""A number and a unit without a space between them; digits after an e are the number's exponent."""

_SIGNS = str.maketrans({"·": "*", "⋅": "*", "∙": "*", "\u00b5": "u", "\u03bc": "u", "°": "deg", "\u2126": "ohm", "\u03a9": "ohm"})
_RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
_POWER = re.compile("[⁻⁰¹²³⁴-⁹]+")
_SQUARED = re.compile(r"(?<=[A-Za-z])(?=[23](?![0-9A-Za-z]))")
"""Where a power is written without a sign: m/s2."""
_JOINED = re.compile(
    r"(?<![A-Za-z_])(?:(?P<force>[kmMu]?N)(?P<arm>[mc]?m)?(?P<time>s)?|(?P<volt>[kmu]?V)s|(?P<mass>kg(?=[mc]?m)|g(?=[mc]m))(?P<length>[mc]?m))"
    r"(?![A-Za-z_])"
)
"""Units written without a sign between them: Nm, Ns, Nms, Vs, kgcm^2."""

_USUAL = {"m": "mm", "s": "ms", "m/s": "mm/s", "rad": "deg"}
"""Usual units where the SI unit is too large for most quantities of a machine."""

_NAMED = ("m", "m/s", "N", "N*m", "V", "A", "full_scale")
"""SI units preferred to their base units."""


@cache
def registry() -> pint.UnitRegistry[Any]:
    """Return the unit registry, made on first use (pint imports slowly)."""
    import pint

    units: pint.UnitRegistry[Any] = pint.UnitRegistry(cache_folder=None)
    units.define("full_scale = [full_scale]")
    units.define("count = [] = counts")
    return units


@cache
def plain(unit: str) -> str:
    """Return a unit as the registry reads it, from the forms of data sheets.

    >>> plain("N·m"), plain("mNm/A"), plain("kgcm²"), plain("s⁻¹"), plain("µm"), plain("m/s2")
    ('N*m', 'mN*m/A', 'kg*cm^2', 's^-1', 'um', 'm/s^2')
    """
    text = _POWER.sub(lambda power: "^" + power[0].translate(_RAISED), unit.translate(_SIGNS))
    text = _SQUARED.sub("^", text)
    return _JOINED.sub(lambda joined: "*".join(filter(None, [*joined.groups(), "s" * bool(joined["volt"])])), text)


Dimension = frozenset[tuple[str, float]]
"""Each base, as pint names it, with its power."""
_BASES = ("[length]", "[mass]", "[time]", "[current]", "[full_scale]")
_PREFIXES = {"": 0, "k": 3, "c": -2, "m": -3, "u": -6, "n": -9}
_COMMON = {
    prefix + name: (Fraction(10) ** (_PREFIXES[prefix] - 3 * (name == "g")), powers)
    for name, prefixes, powers in (
        *(("m", _PREFIXES, (1, 0, 0, 0, 0)), ("g", ("", "k"), (0, 1, 0, 0, 0)), ("s", ("", "m", "u"), (0, 0, 1, 0, 0))),
        *(("A", ("", "m"), (0, 0, 0, 1, 0)), ("N", ("", "k", "m"), (1, 1, -2, 0, 0)), ("V", ("", "m"), (2, 1, -3, -1, 0))),
        *(("Hz", ("", "k"), (0, 0, -1, 0, 0)), ("ohm", ("",), (2, 1, -3, -2, 0)), ("H", ("", "m"), (2, 1, -2, -2, 0))),
        *(("full_scale", ("",), (0, 0, 0, 0, 1)), ("rad", ("", "m", "u"), (0, 0, 0, 0, 0)), ("1", ("",), (0, 0, 0, 0, 0))),
    )
    for prefix in prefixes
} | {"min": (Fraction(60), (0, 0, 1, 0, 0)), "deg": (Fraction(math.radians(1.0)), (0,) * 5), "%": (Fraction(1, 100), (0,) * 5)}
"""Sizes and powers of common units: importing pint with its definitions takes longer than all else that reads a scenario."""
_PART = re.compile(r"([*/]?)([A-Za-z_]+|%|1)(?:\^(-?[1-9]))?")
_PRODUCT = re.compile(rf"(?![*/])(?:{_PART.pattern}(?=[*/]|\Z))+")


def _common(text: str) -> tuple[Dimension, float] | None:
    """Return dimension and size of products and powers of common units; None for any other text, which pint reads."""
    size, powers = Fraction(1), [0] * len(_BASES)
    for sign, name, exponent in _PART.findall(text) if _PRODUCT.fullmatch(text) else [("", "", "")]:
        if name not in _COMMON:
            return None
        power = int(exponent or 1) * (-1 if sign == "/" else 1)
        size *= _COMMON[name][0] ** power
        powers = [p + power * q for p, q in zip(powers, _COMMON[name][1], strict=True)]
    found = frozenset((base, power) for base, power in zip(_BASES, powers, strict=True) if power)
    return (found, float(size)) if 1e-30 < size < 1e30 else None


@cache
def _factor(unit: str) -> tuple[Dimension, float]:
    """Return the dimension of `unit` and its size in SI base units."""
    if (common := _common(plain(unit) or "1")) is not None:
        return common
    import pint

    units = registry()
    try:
        one = units.Quantity(1.0, units.parse_units(plain(unit))).to_base_units()
        size = float(one.magnitude)
        if not 1e-300 < size < 1e300:  # such as mm^200: no number in it would be finite and not 0
            raise OverflowError
    except pint.OffsetUnitCalculusError as error:
        raise UnitError(f"unit {unit!r} has an offset and cannot be used here") from error
    except Exception as error:  # pint's parser raises anything for text that is no unit: an AssertionError for "-"
        raise UnitError(f"unknown unit {unit!r}: write for example mm, mm/min, N/V, 1/s, um or full_scale") from error
    return frozenset(one.dimensionality.items()), size


def same_dimension(unit: str, other: str) -> bool:
    """Tell whether two units measure the same thing.

    >>> same_dimension("mm/min", "m/s")
    True
    """
    return bool(_factor(unit)[0] == _factor(other)[0])


def si_unit(unit: str) -> str:
    """Return the SI unit of values in `unit`, by its usual name.

    >>> si_unit("mV"), si_unit("N*cm"), si_unit("%")
    ('V', 'N*m', '')
    """
    dimension, size = _factor(unit)
    if size == 1.0:
        return plain(unit)
    base = registry().Quantity(1.0, plain(unit)).to_base_units().units
    return next((name for name in _NAMED if _factor(name)[0] == dimension), f"{base:~C}")


def split(text: str) -> tuple[float, str]:
    """Split ``"20 mm"`` or ``"20mm"`` into its number and its unit; a bare number has the unit ``""``.

    The space may be missing before a letter, except before an e: ``"2e"`` could be a truncated exponent or a unit.

    Raises
    ------
    UnitError
        If the text is not a number with or without a unit.

    >>> split("20 mm"), split("2.5e3mm/min"), split("7")
    ((20.0, 'mm'), (2500.0, 'mm/min'), (7.0, ''))
    """
    head, _, tail = text.strip().partition(" ")
    try:
        return float(head), tail.strip()
    except ValueError:
        close = _CLOSE.match(head)
    if close is None:
        decimals = " with a decimal point" if re.match(r"[+-]?\d+,\d", head) else ""
        raise UnitError(f'{text!r} is not a quantity: write a number{decimals}, a space and a unit, such as "20 mm"')
    if close["unit"][0] in "eE":
        raise UnitError(f'{text!r} may be an incomplete exponent or a unit: put a space before the unit, such as "20 eV"')
    return float(close["number"]), f"{close['unit']} {tail}".strip()


def to_si(value: str | float, unit: str) -> float:
    """Read a quantity into SI.

    Parameters
    ----------
    value : str or float
        ``"20 mm"`` or ``"20mm"``; or a bare number, which only a dimensionless `unit` accepts.
    unit : str
        The unit whose dimension is expected, for example ``"m/s"``; ``""`` for a bare number.

    Returns
    -------
    float
        The value in SI base units.

    Raises
    ------
    UnitError
        If the text is not a quantity, is not finite, or has another dimension.

    >>> to_si("6000 mm/min", "m/s")
    0.1
    """
    number, given = split(value) if isinstance(value, str) else (float(value), "")
    if not math.isfinite(number):
        raise UnitError(f"{value!r} is not a finite number")
    dimension, _ = _factor(given)
    wanted, _ = _factor(unit)
    if dimension != wanted:
        if not given:
            raise UnitError(f'{value!r} has no unit: write it with a unit such as "{number:g} {_USUAL.get(unit, unit)}"')
        cure = f"write for example {number:g} {_USUAL.get(unit, unit)}" if unit else "write a number without a unit"
        raise UnitError(f"{value!r} cannot be converted to {unit or 'a bare number'}: {cure}")
    return in_si(number, given)


@cache
def _size(unit: str) -> tuple[float, int]:
    """Return the size of `unit` in SI base units, and the number of its parts in one of them if that is whole, else 0."""
    # Dividing by the inverse keeps round decimal factors exact: 20 mm is 20 / 1000, not 20 * 0.001.
    size = _factor(unit)[1]
    inverse = 1.0 / size
    return size, round(inverse) if size < 1.0 and abs(inverse - round(inverse)) < 1e-9 * inverse else 0


def in_si(number: Numbers, unit: str) -> Numbers:
    """Convert numbers in `unit` to SI, with the same rounding as `to_si`.

    >>> in_si(20.0, "mm")
    0.02
    """
    size, parts = _size(unit)
    return number / parts if parts else number * size


def from_si(value: Numbers, unit: str) -> Numbers:
    """Express SI values in `unit`.

    >>> from_si(0.02, "mm")
    20.0
    """
    size, parts = _size(unit)
    return value * parts if parts else value / size


def show(value: float, unit: str, digits: int = 6) -> str:
    """Write an SI value in `unit` for people.

    >>> show(0.02, "mm")
    '20 mm'
    """
    return f"{from_si(value, unit):.{digits}g} {unit}".strip()


@dataclass(frozen=True)
class Setting:
    """What a key of a table in a file may be, besides its type.

    Attributes
    ----------
    unit, display : str
        SI unit, and the unit in which people write it.
    minimum, maximum : float [SI]
        Bounds of a number; of a text the most characters.
    exclusive : bool
        Whether the minimum itself is excluded.
    choices : collection of str
        Allowed words; empty for any.
    check : callable or None
        Returns a text that is valid, or raises ValueError with what to write.
    name : str
        The key, if it is not the name of the field.
    """

    unit: str = ""
    display: str = ""
    minimum: float = -math.inf
    maximum: float = math.inf
    exclusive: bool = False
    choices: Collection[str] = ()
    check: Callable[[str], str] | None = None
    name: str = ""


def setting(*about: Any, **more: Any) -> dict[str, Setting]:
    """Return the metadata of a field that is a key of a table in a file, see `Setting`; a bool or a Literal needs none."""
    return {"setting": Setting(*about, **more)}
