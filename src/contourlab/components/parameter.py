"""Parameters of components: declaration, bounds and units."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from contourlab.errors import ParameterError


@dataclass(frozen=True, slots=True)
class Parameter:
    """Declaration of one parameter.

    Attributes
    ----------
    name : str
        Name in Python and in files.
    unit : str
        SI unit; empty for a plain number. ``{command}`` and ``{force}`` become the units of the plant.
    default : float, str, tuple of float or None
        None if a value is required.
    minimum, maximum : float [SI]
        Bounds.
    exclusive : bool
        Whether the minimum itself is excluded.
    choices : tuple of str
        Allowed words, for a text parameter.
    whole : bool
        Whether only whole numbers are allowed.
    structural : bool
        Whether it changes the structure of the step; then it cannot differ between lanes.
    vector : bool
        Whether it is a list of numbers, each in range; then it is structural.
    display : str
        Display unit.
    doc, source : str
        Meaning, and where the value comes from.

    Raises
    ------
    ParameterError
        If a bound is no number, the minimum is above the maximum, or a unit has other words in braces.
    """

    name: str
    unit: str
    default: float | str | tuple[float, ...] | None
    minimum: float
    maximum: float
    exclusive: bool
    choices: tuple[str, ...]
    whole: bool
    structural: bool
    vector: bool = field(metadata={"json": "list"})
    display: str = field(metadata={"json": "display_unit"})
    doc: str
    source: str

    def __post_init__(self) -> None:
        for name in ("minimum", "maximum"):
            if isinstance(getattr(self, name), bool) or not isinstance(getattr(self, name), float | int):
                raise ParameterError(name, repr(getattr(self, name)), "a number")
        if not self.minimum <= self.maximum:
            raise ParameterError("minimum", f"{self.minimum:g}", f"at most the maximum, {self.maximum:g}")
        for unit in (self.unit, self.display):
            try:
                unit.format(command="", force="")
            except (KeyError, ValueError, IndexError, AttributeError) as error:
                raise ParameterError("unit", repr(unit), "a unit, with braces only as {command} or {force}") from error

    def for_plant(self, command_unit: str, force_unit: str) -> Parameter:
        """Return the parameter with ``{command}`` and ``{force}`` in its units replaced by those of a plant."""
        units = {"command": command_unit, "force": force_unit}

        def filled(text: str) -> str:
            for word, unit in units.items():
                # A product in a denominator needs brackets.
                text = text.replace(f"/{{{word}}}", f"/({unit})" if "*" in unit else f"/{unit}")
            return text.format(**units)

        return replace(self, unit=filled(self.unit), display=filled(self.display))

    def check(self, value: Any) -> Any:
        """Return the value if it is in range: a float, a word, or a tuple of floats for a vector.

        Infinity is allowed only if it is the default; it means no limit.

        Raises
        ------
        ParameterError
            With name, value, bound and unit.
        """
        if self.choices:
            if value not in self.choices:
                raise ParameterError(self.name, repr(value), "one of " + ", ".join(self.choices))
            return str(value)
        if self.vector:
            if isinstance(value, str) or not hasattr(value, "__len__") or len(value) == 0:
                raise ParameterError(self.name, repr(value), "a list of numbers" + self._in_unit, self._unit_in_words)
            scalar = replace(self, vector=False)
            return tuple(scalar.check(item) for item in value)
        if isinstance(value, bool | str) or not isinstance(value, float | int | np.floating | np.integer):
            raise ParameterError(self.name, repr(value), "a number" + self._in_unit, self._unit_in_words)
        try:
            number = float(value)
        except OverflowError:  # an int beyond any float
            number = math.inf if value > 0 else -math.inf
        if not math.isfinite(number) and number != self.default:
            raise ParameterError(self.name, f"{number:g}", " and ".join(filter(None, ("finite", self.bound))), self._unit_in_words)
        low = number <= self.minimum if self.exclusive else number < self.minimum
        if low or number > self.maximum or (self.whole and number != round(number)):
            raise ParameterError(self.name, f"{number:g}", self.bound, self._unit_in_words)
        return number

    @property
    def _unit_in_words(self) -> str:
        """Unit with plain words for the units of the plant."""
        return self.unit.format(command="command", force="force")

    @property
    def _in_unit(self) -> str:
        return f" in {self._unit_in_words}" if self._unit_in_words else ""

    @property
    def needed(self) -> str:
        """Bound in the message about a missing value."""
        return f"given{', ' if self.bound else ''}{self.bound}{' ' if self._unit_in_words else ''}{self._unit_in_words}"

    @property
    def bound(self) -> str:
        """Range as text."""
        if self.choices:
            return "one of " + ", ".join(self.choices)
        limits = [f"{'>' if self.exclusive else '>='} {self.minimum:g}"] if self.minimum > -math.inf else []
        limits += [f"<= {self.maximum:g}"] if self.maximum < math.inf else []
        if self.whole:
            return "a whole number" + (" that is " if limits else "") + " and ".join(limits)
        return " and ".join(limits)


def param(
    default: float | tuple[float, ...] | None = None,
    *,
    unit: str = "",
    minimum: float = -math.inf,
    maximum: float = math.inf,
    exclusive: bool = False,
    whole: bool = False,
    structural: bool = False,
    vector: bool = False,
    display: str = "",
    doc: str,
    source: str = "",
) -> Any:
    """Declare a parameter of a component: a number or a list of numbers.

    Parameters
    ----------
    default : float or tuple of float [unit], optional
        Without it a value is required.
    unit : str
        SI unit; empty for a plain number. ``{command}`` and ``{force}`` become the units of the plant.
    minimum, maximum : float [unit]
        Bounds.
    exclusive : bool
        Whether the minimum itself is excluded.
    whole : bool
        Whether only whole numbers are allowed.
    structural : bool
        Whether it changes the structure of the step; then it cannot differ between variants.
    vector : bool
        Whether it is a list of numbers, each within the bounds; then it is structural.
    display : str
        Unit in which people read it; by default `unit`.
    doc, source : str
        Meaning, and where the value comes from.

    Returns
    -------
    Parameter
    """
    return Parameter("", unit, default, minimum, maximum, exclusive, (), whole, structural or vector, vector, display or unit, doc, source)


def text_param(default: str | None, choices: tuple[str, ...], *, doc: str, source: str = "") -> Any:
    """Declare a parameter of a component that is a choice of words; it is structural.

    Parameters
    ----------
    default : str or None
        None if a value is required.
    choices : tuple of str
    doc, source : str
        Meaning, and where the value comes from.

    Returns
    -------
    Parameter
    """
    return Parameter("", "", default, -math.inf, math.inf, False, choices, False, True, False, "", doc, source)


NOISE_STREAM: Any = param(default=0.0, minimum=0.0, maximum=2.0**53, whole=True, doc="number of the noise, besides seed, trial and slot")
"""The parameter ``stream`` of a component that makes noise. In a run its step gets the number of a stream of its own instead."""


def require_positive(**values: float) -> None:
    """Raise ParameterError unless all values are positive and finite."""
    for name, value in values.items():
        if not (value > 0.0 and math.isfinite(value)):
            raise ParameterError(name, f"{value:g}", "> 0 and finite")
