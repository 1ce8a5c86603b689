"""How likely each value of a number is."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase

import numpy as np

from contourlab.design import DesignVariable, Space
from contourlab.errors import ParameterError, UnitError
from contourlab.features.sensitivity.runs import Array
from contourlab.scenario.quantities import read_number

UNIFORM, LOG_UNIFORM, NORMAL = KINDS = ("uniform", "log-uniform", "normal")


@dataclass(frozen=True)
class Distribution:
    """The distribution of one number, within its bounds.

    Attributes
    ----------
    number : DesignVariable
    kind : str
        Of `KINDS`: ``"normal"`` is around the number's own value, and cut off at its bounds.
    deviation : float [SI], > 0
        Of a normal one, before it is cut off.
    """

    number: DesignVariable
    kind: str = UNIFORM
    deviation: float = 0.0

    def __post_init__(self) -> None:
        number = self.number
        if self.kind not in KINDS:
            raise ParameterError("--distribution", repr(self.kind), f"one of {', '.join(KINDS)}")
        if self.kind == LOG_UNIFORM and number.low <= 0.0:
            raise ParameterError(number.name, f"bounds {number.low:g} to {number.high:g}", "above 0 for a log-uniform distribution")
        if self.kind == NORMAL and not 0.0 < self.deviation < math.inf:
            given = f"{self.deviation:g}" if self.deviation else "no deviation"
            raise ParameterError(number.name, given, f'a normal distribution with --deviation "{number.short}=5 %"')
        if self.kind == NORMAL and not number.low <= number.value <= number.high:
            raise ParameterError(number.name, f"{number.value:g}", "between its bounds for a normal distribution around it", number.unit)

    def values(self, places: Array) -> Array:
        """Return the values [SI] at places from 0 to 1 of the cumulative distribution."""
        number = self.number
        if self.kind == UNIFORM:
            found = number.low + (number.high - number.low) * places
        elif self.kind == LOG_UNIFORM:
            found = number.low * (number.high / number.low) ** places
        else:
            from scipy.special import ndtr, ndtri

            low, high = ndtr((np.array([number.low, number.high]) - number.value) / self.deviation)
            found = number.value + self.deviation * ndtri(low + (high - low) * places)
        return np.asarray(np.clip(found, number.low, number.high))


def distributions(space: Space, kind: str = UNIFORM, deviations: Sequence[str] = ()) -> tuple[Distribution, ...]:
    """Return a distribution for each number of a space.

    Parameters
    ----------
    space : Space
    kind : str
        Of those that no deviation is given for.
    deviations : sequence of str
        ``NAME=DEVIATION`` with ``%`` of the value, or the number's unit; a deviation alone is for all numbers. These are normal.

    Raises
    ------
    ParameterError
        If a name is none of the space's, or a deviation cannot be read.
    """
    found: dict[str, float] = {}
    for text in deviations:
        name, equals, wanted = (part.strip() for part in text.rpartition("="))
        chosen = [number for number in space.numbers if not equals or _called(number, name)]
        if not chosen:
            known = ", ".join(number.short for number in space.numbers[:4])
            raise ParameterError("--deviation", repr(text), f"NAME=DEVIATION with one of the numbers that are moved, such as {known}")
        found |= {number.name: _deviation(number, wanted) for number in chosen}
    return tuple(
        Distribution(number, NORMAL, found[number.name]) if number.name in found else Distribution(number, kind) for number in space.numbers
    )


def _called(number: DesignVariable, name: str) -> bool:
    return any(fnmatchcase(known, pattern) for known in (number.name, number.short) for pattern in (name, f"*.{name}"))


def _deviation(number: DesignVariable, text: str) -> float:
    shown = number.display_unit
    wanted = f"a deviation of {number.short} above 0, as 5 %{f' or 2 {shown}' if shown else ''}"
    try:
        if text.endswith("%"):
            found = abs(number.value) * float(text[:-1]) / 100.0
        else:
            found = float(read_number(text if number.unit else float(text), number.unit, number.display))
    except (UnitError, ValueError) as error:
        raise ParameterError("--deviation", repr(text), wanted) from error
    if not 0.0 < found < math.inf:
        raise ParameterError("--deviation", repr(text), wanted)
    return found
