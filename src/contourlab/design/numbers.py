"""The numbers that a study moves, each between its bounds."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches
from fnmatch import fnmatchcase
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from contourlab.components.contract import Component
from contourlab.design.digits import with_digits
from contourlab.design.order import calibration_order
from contourlab.errors import ParameterError, UnitError
from contourlab.loop import Controller, Machine, parameter_names
from contourlab.scenario.quantities import read_number
from contourlab.units import from_si

Array = NDArray[np.float64]
WIDTH = 4.0
"""Bounds are this factor either side of the value where none are given."""
NEAR = 0.005
"""So close to a bound, in parts of the range, a value counts as standing on it."""
MOST_NAMES = 8
"""So many names are listed where one is wrong."""


@dataclass(frozen=True)
class Number:
    """One number of a machine or controller.

    Attributes
    ----------
    name : str
        Dotted, as `contourlab.loop.parameter_names` lists it.
    value : float [SI]
        What the scenario has.
    low, high : float [SI]
        Bounds, `low` < `high`.
    unit : str
        SI unit of these.
    display : str
        Unit in which people write it.
    logarithmic : bool
        Whether equal steps are equal factors.
    least, most : float [SI]
        Beyond which the component itself takes no value.
    """

    name: str
    value: float
    low: float
    high: float
    unit: str = ""
    display: str = ""
    logarithmic: bool = True
    least: float = -math.inf
    most: float = math.inf

    def __post_init__(self) -> None:
        if not (math.isfinite(self.low) and math.isfinite(self.high)):
            raise ParameterError(self.name, self.bounds, "finite")
        if not self.low < self.high:
            wanted = "two that differ: leave out a number that is to stay" if self.low == self.high else "in order, the lower one first"
            raise ParameterError(self.name, self.bounds, wanted)
        if self.logarithmic and self.low <= 0.0:
            raise ParameterError(self.name, self.bounds, "above 0 for equal factors")

    @property
    def short(self) -> str:
        """The name as people say it: axis, and the parameter with its slot where that is not the controller."""
        words = self.name.removeprefix("controller.").removeprefix("axes.").split(".")
        return ".".join(word for word in words if word != "controller")

    @property
    def bounds(self) -> str:
        """The bounds in words, in the unit that people write."""
        return f"bounds {self.shown(self.low):g} to {self.shown(self.high):g} {self.written_in}".rstrip()

    @property
    def nearest(self) -> float:
        """The value [SI], or the bound that is nearest to it where it lies beyond."""
        return min(max(self.value, self.low), self.high)

    @property
    def written_in(self) -> str:
        """The unit that people write."""
        return self.display or self.unit

    def shown(self, value: float) -> float:
        """Return a value in the unit that people write."""
        return from_si(value, self.written_in)

    def end(self, value: float) -> str:
        """Return in words on which end of the range a value [SI] stands, or within `NEAR` of it; empty for one between them."""
        place = float(self.place(value))
        if place < NEAR:
            return "lower end of its range" if self.low > self.least else "the least it may be"
        if place > 1.0 - NEAR:
            return "upper end of its range" if self.high < self.most else "the most it may be"
        return ""

    def cramped(self, value: float) -> bool:
        """Tell whether a value [SI] stands on an end of the range beyond which the component would take more."""
        return self.end(value).endswith("its range")

    def written(self, values: ArrayLike) -> Array:
        """Return values [SI] within the range as a file has them: six digits in the unit that people write, the bounds kept.

        What comes to the digits of the scenario's own value is that one as it is.
        """
        made = np.clip(with_digits(values, self.written_in, self.low, self.high), self.least, self.most)
        if not math.isfinite(self.value):
            return made
        return np.where(made == with_digits(self.value, self.written_in), self.value, made)

    def physical(self, place: ArrayLike) -> Array:
        """Return the values [SI] at places from 0 (lower bound) to 1 (upper bound)."""
        x = np.asarray(place, dtype=float)
        if self.logarithmic:
            return np.asarray(np.clip(self.low * (self.high / self.low) ** x, self.low, self.high))
        return np.asarray(np.clip(self.low + (self.high - self.low) * x, self.low, self.high))

    def place(self, value: ArrayLike) -> Array:
        """Return the places from 0 to 1 of values [SI]; those beyond a bound are put on it."""
        v = np.clip(np.asarray(value, dtype=float), self.low, self.high)
        if self.logarithmic:
            return np.asarray(np.log(v / self.low) / math.log(self.high / self.low))
        return np.asarray((v - self.low) / (self.high - self.low))


@dataclass(frozen=True)
class Space:
    """A box of numbers; points in it are rows of places from 0 to 1.

    Attributes
    ----------
    numbers : tuple of Number
    written : bool
        Whether the values of points are those that a file has, as of `Number.written`.
    """

    numbers: tuple[Number, ...]
    written: bool = False

    def __post_init__(self) -> None:
        names = self.names
        twice = sorted({name for name in names if names.count(name) > 1})
        if not names or twice:
            raise ParameterError("parameters", twice[0] if twice else "none", "at least one, each once")

    @property
    def names(self) -> tuple[str, ...]:
        """Dotted names, in order."""
        return tuple(number.name for number in self.numbers)

    @cached_property
    def start(self) -> Array:
        """Places of the scenario's own values (n_number,)."""
        return np.array([float(number.place(number.value)) for number in self.numbers])

    def columns(self, points: ArrayLike) -> dict[str, Array]:
        """Return values [SI] of points (n, n_number) as `contourlab.loop.simulate_batch` takes them: name -> (n,)."""
        rows = np.atleast_2d(np.asarray(points, dtype=float))
        found = {number: number.physical(rows[:, i]) for i, number in enumerate(self.numbers)}
        return {number.name: number.written(values) if self.written else values for number, values in found.items()}

    def values(self, point: ArrayLike) -> dict[str, float]:
        """Return the values [SI] of one point."""
        return {name: float(column[0]) for name, column in self.columns(point).items()}

    def points(self, values: Mapping[str, ArrayLike]) -> Array:
        """Return the places (n, n_number) of values [SI]; a name that is not given stays where the scenario has it."""
        given = [np.atleast_1d(number.place(values.get(number.name, number.value))) for number in self.numbers]
        return np.stack(np.broadcast_arrays(*given), axis=1)

    @staticmethod
    def chosen(
        machine: Machine,
        controller: Controller,
        texts: Sequence[str] = (),
        width: float = WIDTH,
        *,
        called: str = "parameter",
        machine_only: bool = False,
    ) -> Space:
        """Return the numbers that texts choose, each with its bounds.

        Parameters
        ----------
        machine, controller
            Whose numbers they are.
        texts : sequence of str
            ``NAME`` or ``NAME=LOW..HIGH`` with units, such as ``"3.observer.model_damping=5 1/s..50 1/s"``. A name may be the end of a
            dotted name, and may have ``*``: it then stands for all that fit. None for all of `calibration_order` that are not zero.
        width : float, > 1
            Factor either side of the value where no bounds are given.
        called : str
            What the texts are called in an error.
        machine_only : bool
            Whether the numbers of the controller are left out: a name then stands for those of the machine alone.

        Raises
        ------
        ParameterError
            If a name fits nothing, a bound has the wrong unit or is out of range, a number is given two pairs of bounds, or a value of zero
            is given none.
        """
        if not (width > 1.0 and math.isfinite(width)):
            raise ParameterError("width", f"{width:g}", "above 1 and finite: a factor either side of a value")
        known = parameter_names(machine, controller)
        if machine_only:
            known = {name: found for name, found in known.items() if name.startswith("axes.")}
        units = {axis.name: (axis.plant.command_unit, axis.plant.force_unit) for axis in machine.axes}
        if not texts:
            order = calibration_order(machine, controller)
            names = [name for name in order if _value(known[name]) not in (0.0, math.inf)]
            return Space(tuple(_number(name, known[name], units, "", width) for name in names))
        asked: dict[str, str] = {}
        for text in texts:
            wanted, _, bounds = (part.strip() for part in text.partition("="))
            for name in _fitting(wanted, known, called, "the machine" if machine_only else "the machine or its controller"):
                if bounds and asked.get(name, bounds) not in ("", bounds):
                    raise ParameterError(name, f"{asked[name]} and {bounds}", "given bounds once")
                asked[name] = bounds or asked.get(name, "")
        return Space(tuple(_number(name, known[name], units, bounds, width) for name, bounds in asked.items()))

    def only(self, names: Iterable[str]) -> Space:
        """Return the space of some of the numbers."""
        wanted = set(names)
        return replace(self, numbers=tuple(number for number in self.numbers if number.name in wanted))

    def around(self, values: Mapping[str, float]) -> Space:
        """Return the space with other values to start from, in the same bounds."""
        return replace(self, numbers=tuple(replace(one, value=float(values.get(one.name, one.value))) for one in self.numbers))


def _value(known: tuple[Component, str]) -> float:
    return float(getattr(*known))


def _fitting(wanted: str, known: Mapping[str, tuple[Component, str]], called: str, whose: str) -> list[str]:
    """Return the dotted names that a text stands for."""
    if wanted in known:
        return [wanted]
    found = [name for name in known if fnmatchcase(name, wanted) or fnmatchcase(name, f"*.{wanted}")]
    # "3.position_gain" for controller.axes.3.controller.position_gain: the slot of the controller goes without saying.
    found += [name for name in known if name not in found and fnmatchcase(name.replace(".controller.", "."), f"*.{wanted}")]
    if not wanted or not found:
        raise ParameterError(called, repr(wanted), f"a number of {whose}, such as {', '.join(_near(wanted, known))}")
    return found


def _near(wanted: str, known: Iterable[str]) -> list[str]:
    """Return the names nearest to one that there is not: those that end alike, or are spelt alike, or else a few of them."""
    names = sorted(known, key=lambda name: name.startswith("axes."))  # what people look for are gains
    ends = {name: name.rpartition(".")[2] for name in names}
    word = wanted.rpartition(".")[2]
    alike = get_close_matches(word, dict.fromkeys(ends.values()), n=3)
    found = [name for end in (word, *alike) for name in names if ends[name] == end]
    return list(dict.fromkeys(found))[:MOST_NAMES] or names[:MOST_NAMES]


def _number(name: str, known: tuple[Component, str], units: Mapping[str, tuple[str, str]], bounds: str, width: float) -> Number:
    """Return a number between the bounds of a text, or else a factor either side of its value."""
    part, word = known
    axis = next((axis for axis in units if f".axes.{axis}." in f".{name}"), next(iter(units)))
    parameter = replace(part.parameters[word].for_plant(*units[axis]), name=name)
    value = _value(known)
    if bounds:
        low, high = _bounds(name, bounds, parameter.unit, parameter.display)
        for bound in (low, high):
            parameter.check(bound)
    elif value == 0.0 or not math.isfinite(value):
        raise ParameterError(name, f"{value:g}", f"given with bounds, as {name}=LOW..HIGH: there is no factor around {value:g}")
    elif value < 0.0:
        low, high = width * value, value / width
    else:
        low, high = max(value / width, parameter.minimum), min(value * width, parameter.maximum)
    least, most = parameter.minimum, parameter.maximum
    return Number(name, value, low, high, parameter.unit, parameter.display, logarithmic=low > 0.0, least=least, most=most)


def _bounds(name: str, text: str, unit: str, display: str) -> tuple[float, float]:
    low, dots, high = text.partition("..")
    try:
        if dots:
            first, second = (read_number(side.strip() if unit else float(side), unit, display) for side in (low, high))
            return first, second
        said = "two of them are wanted"
    except (UnitError, ValueError) as error:
        said = str(error)
    shown = display or unit
    raise ParameterError(
        name, repr(text), f"bounds LOW..HIGH, each with its unit, as {f'1 {shown}..2 {shown}' if unit else '1..2'}: {said}"
    )
