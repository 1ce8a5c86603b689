"""Design variables: the parameters that a study varies, each between its bounds."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, Index
from contourlab.components.contract import Component
from contourlab.errors import ParameterError, UnitError
from contourlab.loop import Controller, Machine, parameters_of
from contourlab.loop.machine import require_loops
from contourlab.loop.parameters import declared, matching
from contourlab.scenario.quantities import read_number
from contourlab.units import from_si, in_si

WIDTH = 4.0
"""Default bounds are the value divided and multiplied by this."""
TAILS = (2.0**-60, 1.0 - 2.0**-53)
"""Places nearest to 0 and 1 that a drawn design or a distribution without ends takes."""
NEAR = 0.005
"""Largest distance to a bound, as a share of the range, that counts as on it."""
DIGITS = 6
"""Digits of a value in a file."""
ROUNDING = 1e-9
"""Share of a bound by which a value may exceed it."""


@dataclass(frozen=True)
class DesignVariable:
    """A parameter of a machine or controller, to be varied between bounds.

    Attributes
    ----------
    name : str
        Dotted name, as in `contourlab.loop.parameter_names`.
    value : float [SI]
        Value in the scenario.
    low, high : float [SI]
        Bounds, `low` < `high`.
    unit : str
        SI unit.
    display : str
        Display unit.
    logarithmic : bool
        Whether equal steps are equal factors.
    least, most : float [SI]
        Limits of the component's parameter.
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
        """The short name: axis, slot (unless it is the controller) and parameter."""
        words = self.name.removeprefix("controller.").removeprefix("axes.").split(".")
        return ".".join(word for word in words if word != "controller")

    @property
    def bounds(self) -> str:
        """The bounds in the display unit."""
        return f"bounds {self.display_value(self.low):g} to {self.display_value(self.high):g} {self.display_unit}".rstrip()

    @property
    def nearest(self) -> float:
        """The value [SI], or the nearest bound if the value lies outside."""
        return min(max(self.value, self.low), self.high)

    @property
    def display_unit(self) -> str:
        """The unit in which the value is written."""
        return self.display or self.unit

    def display_value(self, value: float) -> float:
        """Convert a value [SI] to the display unit."""
        return from_si(value, self.display_unit)

    def end(self, value: float) -> str:
        """Return the name of the bound within `NEAR` of a value [SI]; empty if neither bound is."""
        place = float(self.normalise(value))
        if place < NEAR:
            return "lower end of its range" if self.low > self.least else "the least it may be"
        if place > 1.0 - NEAR:
            return "upper end of its range" if self.high < self.most else "the most it may be"
        return ""

    def cramped(self, value: float) -> bool:
        """Return whether a value [SI] lies on a bound that could be wider."""
        return self.end(value).endswith("its range")

    def written(self, values: ArrayLike) -> Array:
        """Round values [SI] to the digits of a file, within the bounds.

        A value that rounds to the scenario's value becomes that value, unrounded.
        """
        made = np.clip(with_digits(values, self.display_unit, self.low, self.high), self.least, self.most)
        if not math.isfinite(self.value):
            return made
        return np.where(made == self._own_written, self.value, made)

    @cached_property
    def _own_written(self) -> Array:
        return with_digits(self.value, self.display_unit)

    def physical(self, place: ArrayLike) -> Array:
        """Return the values [SI] at positions from 0 (lower bound) to 1 (upper bound)."""
        kind = "log-uniform" if self.logarithmic else "uniform"
        return Distribution(kind, (self.low, self.high), self.low, self.high).values(np.asarray(place, dtype=float))

    def normalise(self, value: ArrayLike) -> Array:
        """Return the positions from 0 to 1 of values [SI]; values outside are clipped to the bounds."""
        v = np.clip(np.asarray(value, dtype=float), self.low, self.high)
        if self.logarithmic:
            return np.asarray(np.log(v / self.low) / math.log(self.high / self.low))
        return np.asarray((v - self.low) / (self.high - self.low))


@dataclass(frozen=True)
class Space:
    """A box of design variables; its points are rows of positions from 0 to 1.

    Attributes
    ----------
    written : bool
        Whether values of points are rounded as in a file, see `DesignVariable.written`.
    """

    numbers: tuple[DesignVariable, ...]
    written: bool = False

    def __post_init__(self) -> None:
        names = self.names
        twice = sorted({name for name in names if names.count(name) > 1})
        if not names or twice:
            raise ParameterError("parameters", twice[0] if twice else "none", "at least one, each once")

    @property
    def names(self) -> tuple[str, ...]:
        """Dotted names, in order."""
        return tuple(variable.name for variable in self.numbers)

    @cached_property
    def start(self) -> Array:
        """Positions of the scenario's values (n_variable,)."""
        return np.array([float(variable.normalise(variable.value)) for variable in self.numbers])

    def columns(self, points: ArrayLike) -> dict[str, Array]:
        """Return the values [SI] of points (n, n_variable) by name, each (n,), as `contourlab.loop.simulate_batch` takes them."""
        rows = np.atleast_2d(np.asarray(points, dtype=float))
        pairs = [(variable, variable.physical(rows[:, i])) for i, variable in enumerate(self.numbers)]
        return {variable.name: variable.written(values) if self.written else values for variable, values in pairs}

    def values(self, point: ArrayLike) -> dict[str, float]:
        """Return the values [SI] of one point."""
        return {name: float(column[0]) for name, column in self.columns(point).items()}

    def points(self, values: Mapping[str, ArrayLike]) -> Array:
        """Return the positions (n, n_variable) of values [SI]; missing names have the scenario's values."""
        given = [np.atleast_1d(variable.normalise(values.get(variable.name, variable.value))) for variable in self.numbers]
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
        """Choose variables by text, each with its bounds.

        Parameters
        ----------
        machine, controller
            Owners of the parameters.
        texts : sequence of str
            ``NAME`` or ``NAME=LOW..HIGH`` with units, such as ``"3.observer.model_damping=5 1/s..50 1/s"``. A name may be the end of a
            dotted name and may contain ``*``; it selects all matches. By default all parameters of `calibration_order` with a finite
            value other than zero.
        width : float, > 1
            Default bounds are the value divided and multiplied by this.
        called : str
            Name of a text in an error message.
        machine_only : bool
            Whether only parameters of the machine may be chosen.

        Raises
        ------
        ParameterError
            If a name matches nothing, a bound has the wrong unit or is out of range, a variable has two pairs of bounds, or a value that is
            zero or not finite has none.
        """
        if not (width > 1.0 and math.isfinite(width)):
            raise ParameterError("width", f"{width:g}", "above 1 and finite: a factor either side of a value")
        known = parameters_of(machine, controller)
        if machine_only:
            known = {name: found for name, found in known.items() if name.startswith("axes.")}
        if not texts:
            require_loops(machine)
            names = [name for name in calibration_order(machine, controller) if getattr(*known[name]) not in (0.0, math.inf)]
            return Space(tuple(_variable(name, known[name], machine, "", width) for name in names))
        asked: dict[str, str] = {}
        for text in texts:
            wanted, _, bounds = (part.strip() for part in text.partition("="))
            for name in matching(wanted, known, called, "the machine" if machine_only else "the machine or its controller"):
                if bounds and asked.get(name, bounds) not in ("", bounds):
                    raise ParameterError(name, f"{asked[name]} and {bounds}", "given bounds once")
                asked[name] = bounds or asked.get(name, "")
        return Space(tuple(_variable(name, known[name], machine, bounds, width) for name, bounds in asked.items()))

    def only(self, names: Iterable[str]) -> Space:
        """Return the space of some of the variables."""
        wanted = set(names)
        return replace(self, numbers=tuple(variable for variable in self.numbers if variable.name in wanted))


# --- parameters by dotted name: the axes they affect, and their order ---


def axes_of(name: str, machine: Machine) -> tuple[str, ...]:
    """Return the axes that a parameter affects: its own axis, or all axes for a parameter of the coupling."""
    words = name.split(".")
    return (words[words.index("axes") + 1],) if "axes" in words[:-1] else machine.axis_names


def calibration_order(machine: Machine, controller: Controller) -> tuple[str, ...]:
    """Return the dotted names of all parameters to calibrate, from the innermost loop to the outermost, feedforward last.

    Notes
    -----
    First the disturbance observers, then the position controllers, then a coupling that corrects commands, then feedforward; in each group
    the last axis comes first. For the paper's stage this is the paper's order (section IV): b_hat_3, a_hat_3, b_hat_2, a_hat_2, K_V3, K_P3,
    K_I3, K_V2, K_P2, K_I2, b'_3, a'_3, b'_2, a'_2. Its lambda, a choice between contour and tracking error, is not calibrated.

    A component names its parameters to calibrate in `calibrated` and `calibrated_ahead`.
    """
    axes = [(name, controller.axes[name]) for name in reversed(machine.axis_names)]
    names: list[str] = []

    def collect(prefix: str, part: Component | None, ahead: bool) -> None:
        if part is not None:
            names.extend(f"{prefix}.{name}" for name in (part.calibrated_ahead if ahead else part.calibrated))

    for slot in ("observer", "controller"):
        for name, axis in axes:
            collect(f"controller.axes.{name}.{slot}", getattr(axis, slot), False)
    if controller.coupling is not None and any(port.name == "correction" for port in controller.coupling.outputs):
        collect("controller.coupling", controller.coupling, False)
    for name, axis in axes:
        for slot in ("controller", "feedforward"):
            collect(f"controller.axes.{name}.{slot}", getattr(axis, slot), True)
    return tuple(names)


# --- distributions ---


@dataclass(frozen=True)
class Distribution:
    """The distribution of one parameter.

    Attributes
    ----------
    kind : str
        ``"normal"``, ``"lognormal"``, ``"uniform"``, ``"log-uniform"``, ``"triangular"`` or ``"values"``.
    numbers : tuple of float [SI]
        Mean and standard deviation; median and standard deviation of the logarithm; lowest and highest value; these with the likeliest
        between them; or values.
    low, high : float [SI]
        Ends, inclusive.
    weights : tuple of float
        Relative probabilities of values; empty for equal ones.
    """

    kind: str
    numbers: tuple[float, ...]
    low: float = -math.inf
    high: float = math.inf
    weights: tuple[float, ...] = ()

    @property
    def beyond(self) -> float:
        """Share of the distribution beyond its ends; the rest is scaled up to 1."""
        if self.kind not in ("normal", "lognormal"):
            return 0.0
        first, last = self._ends()
        return float(first + 1.0 - last)

    def values(self, places: Array) -> Array:
        """Return the values [SI] at cumulative probabilities from 0 to 1.

        >>> Distribution("normal", (80.0, 4.0), low=0.0).values(np.array([0.5])).tolist()
        [80.0]
        """
        if self.kind == "values":
            return np.asarray(np.asarray(self.numbers)[chosen(places, len(self.numbers), self.weights)])
        # Without an end the inverse at 0 or 1 is infinite.
        ends = TAILS[0] if math.isinf(self.low) else 0.0, TAILS[1] if math.isinf(self.high) else 1.0
        return np.asarray(np.clip(self._inverse(np.clip(np.asarray(places, dtype=float), *ends)), self.low, self.high))

    def _inverse(self, p: Array) -> Array:
        if self.kind in ("normal", "lognormal"):
            from scipy.special import ndtri

            first, last = self._ends()
            z = ndtri(first + (last - first) * p)
            centre, spread = self.numbers
            return np.asarray(centre + spread * z if self.kind == "normal" else centre * np.exp(spread * z))
        low, high = self.numbers[0], self.numbers[-1]
        if self.kind == "uniform":
            return low + (high - low) * p
        if self.kind == "log-uniform":
            return np.asarray(low * (high / low) ** p)
        peak = self.numbers[1]
        rising = low + np.sqrt(p * (high - low) * (peak - low))
        falling = high - np.sqrt((1.0 - p) * (high - low) * (high - peak))
        return np.where(p * (high - low) < peak - low, rising, falling)

    def _ends(self) -> tuple[float, float]:
        """Return the cumulative probabilities of the ends."""
        from scipy.special import ndtr

        centre, spread = self.numbers
        ends = np.array([self.low, self.high])
        if self.kind == "lognormal":
            with np.errstate(divide="ignore"):
                ends, centre = np.log(np.maximum(ends, 0.0)), math.log(centre)
        first, last = ndtr((ends - centre) / spread)
        return float(first), float(last)


def chosen(places: Array, count: int, weights: Sequence[float] = ()) -> Index:
    """Return the numbers of choices, from 0, at cumulative probabilities from 0 to 1."""
    if not weights:
        return np.minimum((np.asarray(places) * count).astype(np.int64), count - 1)
    ends = np.cumsum(weights) / np.sum(weights)
    return np.minimum(np.searchsorted(ends, places, side="right"), int(np.flatnonzero(weights)[-1])).astype(np.int64)


# --- values as in a file ----------------------------------------------------------------------------------------------------------------


def with_digits(values: ArrayLike, unit: str, low: float = -np.inf, high: float = np.inf) -> Array:
    """Round values [SI] to six digits in a display unit: reading their text gives the result bit for bit.

    Parameters
    ----------
    values : array_like [SI], low to high
    unit : str
        The display unit.
    low, high : float [SI]
        A value that rounds beyond one of them is rounded inwards; it is left unchanged if the bounds contain no value of six digits.

    >>> with_digits([0.0123456789, 0.99999996], "m", high=1.0).tolist()
    [0.0123457, 1.0]
    """
    v = np.asarray(values, dtype=float)
    whole, power = _split(np.asarray(from_si(v, unit)))
    under, over = low - ROUNDING * abs(low), high + ROUNDING * abs(high)
    made = in_si(_over(whole, -power), unit)
    inwards = np.where(made > over, -1.0, np.where(made < under, 1.0, 0.0))
    made = in_si(_over(whole + inwards, -power), unit)
    return np.where((made > over) | (made < under), v, made)


def _split(values: Array) -> tuple[Array, Array]:
    """Return values as whole numbers of `DIGITS` digits, and the powers of ten that multiply them."""
    power = np.floor(np.log10(np.where(values == 0.0, 1.0, np.abs(values)))) - (DIGITS - 1)
    return np.rint(_over(values, power)), power


def _over(values: Array, power: Array) -> Array:
    """Divide values by powers of ten with a single rounding, as in reading text."""
    return np.where(power < 0.0, values * 10.0 ** np.maximum(-power, 0.0), values / 10.0 ** np.maximum(power, 0.0))


# --- from text ---------------------------------------------------------------------------------------------------------------------------


def _variable(name: str, known: tuple[Component, str], machine: Machine, bounds: str, width: float) -> DesignVariable:
    """Return a variable with the bounds of a text, by default its value divided and multiplied by `width`."""
    parameter = replace(declared(machine, name, *known), name=name)
    value = float(getattr(*known))
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
    return DesignVariable(name, value, low, high, parameter.unit, parameter.display, logarithmic=low > 0.0, least=least, most=most)


def _bounds(name: str, text: str, unit: str, display: str) -> tuple[float, float]:
    low, dots, high = text.partition("..")
    shown, fault = display or unit, "two of them are needed"
    try:
        if dots:
            first, second = (read_number(side.strip() if unit else float(side), unit, display) for side in (low, high))
            return first, second
    except (UnitError, ValueError) as error:
        fault = str(error)
    example = f"1 {shown}..2 {shown}" if unit else "1..2"
    raise ParameterError(name, repr(text), f"bounds LOW..HIGH, each with its unit, as {example}: {fault}")
