"""The component contract: parameters, ports and step.

A component is one frozen class in one file::

    class Viscous(Component):
        \"\"\"Force proportional to velocity.\"\"\"

        family = "friction"
        kind = "viscous"
        viscous: float = param(default=0.0, unit="N*s/m", minimum=0.0, doc="viscous coefficient")
        ...

Parameters are validated, constant and in SI. `step` is a pure function over tuples of floats, written with the functions of
`contourlab.primitives`: the engine compiles it, and plain Python runs it unchanged.
"""

from __future__ import annotations

import inspect
import math
import sys
import traceback
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cache, lru_cache, update_wrapper
from types import FunctionType, SimpleNamespace
from typing import Any, ClassVar, dataclass_transform

import numpy as np
from numpy.typing import ArrayLike

from contourlab.arrays import Array, ByValue, Complex
from contourlab.components.families import FAMILIES as FAMILIES
from contourlab.components.families import FAMILY, size_of
from contourlab.components.origin import Origin
from contourlab.engine.step import Port, Step, ports, record
from contourlab.engine.translate.outer import TYPED
from contourlab.errors import ComponentError, ParameterError, error_text, hint


def file_of_class(kind: type) -> str:
    """Return the file of a class; that of a plug-in as the user typed it."""
    module = sys.modules.get(kind.__module__)
    return str(getattr(module, TYPED, None) or getattr(module, "__file__", None) or kind.__module__)


def line_in(file: str, error: BaseException) -> int:
    """Return the line of a file at which an error was raised, 0 if none; `file` as from `file_of_class`."""
    frames = traceback.walk_tb(error.__traceback__)
    lines = [line for frame, line in frames if file in (frame.f_globals.get(TYPED), frame.f_code.co_filename)]
    return lines[-1] if lines else 0


def raised_in_plugin(error: BaseException) -> str:
    """Return place and text of an error raised by the code of a plug-in; empty for all others."""
    for frame, line in reversed([*traceback.walk_tb(error.__traceback__)]):
        file = frame.f_globals.get(TYPED)
        if file is not None:
            return f"{file}:{line}: {frame.f_code.co_qualname}: {error_text(error)}"
    return ""


def fault(kind: type, message: str, function: Any = None, line: int = 0) -> ComponentError:
    """Return the error about a class: file, line (of a function in that file, or else of the class), name, message."""
    file, code = file_of_class(kind), getattr(function, "__code__", None)
    if not line and code is not None and file in (function.__globals__.get(TYPED), code.co_filename):
        line = code.co_firstlineno
    if not line:
        try:
            line = inspect.getsourcelines(kind)[1]
        except (OSError, TypeError):  # a class without a source, made by type()
            line = 0
    return ComponentError(f"{file}{f':{line}' if line else ''}: {kind.__name__}: {message}")


REFERENCE = ports("reference", "reference_velocity", "reference_acceleration")
"""Input ports with the reference of an axis."""

BOTH_SIDES = ports("motor_position", "motor_velocity", "load_position", "load_velocity")
"""Input ports with position and velocity of motor and load."""


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
        unit, display = (_filled(text, command_unit, force_unit) for text in (self.unit, self.display))
        return self if (unit, display) == (self.unit, self.display) else replace(self, unit=unit, display=display)

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
            if isinstance(value, str) or not hasattr(value, "__len__") or (len(value) == 0 and self.default != ()):
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


@lru_cache(1024)
def _filled(text: str, command: str, force: str) -> str:
    for word, unit in (("command", command), ("force", force)):
        # A product in a denominator needs brackets.
        text = text.replace(f"/{{{word}}}", f"/({unit})" if "*" in unit else f"/{unit}")
    return text.format(command=command, force=force)


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


@dataclass(frozen=True, eq=False)
class LinearModel(ByValue):
    """A linear model x' = A x + B u, y = C x + D u with named inputs and outputs, in continuous time.

    Attributes
    ----------
    a, b, c, d : ndarray (n_state, n_state), (n_state, n_input), (n_output, n_state), (n_output, n_input)
        Each in the units of its ports [SI].
    inputs, outputs : tuple of str
        Names of ports.
    """

    a: Array
    b: Array
    c: Array
    d: Array
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]


def response_of(a: Array, b: Array, c: Array, d: Array | float, points: ArrayLike) -> Complex:
    """Return C (s I - A)^-1 B + D for each complex point s (n,): (n, n_output, n_input)."""
    s = np.atleast_1d(np.asarray(points, dtype=complex))
    inner = np.linalg.solve(s[:, None, None] * np.eye(len(a)) - a, np.broadcast_to(b.astype(complex), (s.size, *b.shape)))
    return np.asarray(c @ inner + d)


@dataclass_transform(field_specifiers=(param, text_param), kw_only_default=True, frozen_default=True)
class Component:
    """Base of all components; the module docstring has an example.

    A component sets these attributes of its class. Its parameters, declared with `param`, are keyword arguments.

    Attributes
    ----------
    family, kind : str
        Its slot, and its name in files.
    states, inputs, outputs : tuple of Port
        The family fixes which inputs and outputs are possible; where it leaves no choice, they are its own by default.
    derived : tuple of str
        Constants from `derive`, in `par` after the parameters.
    tables : tuple of str
        Read-only tables from `table_values`.
    ring : str
        Input port whose past values are kept.
    reference : str
        Paper and equation.
    example : dict
        Values for `check_component` and the documentation; every parameter must have an effect.
    unbounded : tuple of str
        Parameters that may be any finite number.
    without_effect : tuple of str
        Parameters without an effect on the step in the example.
    calibrated : tuple of str
        Gains to calibrate in the closed loop, innermost loop first.
    calibrated_ahead : tuple of str
        Feedforward parameters, calibrated after all loops.
    wishes : dict of str to Parameter
        Arguments of `designed`, which computes gains: ``gains = {...}`` in files.
    command_unit : str
        Unit of the commands of a plant; "m" if its command is a position. Of another part: the only unit that it can have, empty for any.

    Raises
    ------
    ComponentError
        If the family of a new class is unknown.
    ParameterError
        If a parameter is unknown, missing or out of range.
    """

    family: ClassVar[str] = ""
    kind: ClassVar[str] = ""
    states: ClassVar[tuple[Port, ...]] = ()
    inputs: ClassVar[tuple[Port, ...]] = ()
    outputs: ClassVar[tuple[Port, ...]] = ()
    derived: ClassVar[tuple[str, ...]] = ()
    tables: ClassVar[tuple[str, ...]] = ()
    ring: ClassVar[str] = ""
    reference: ClassVar[str] = ""
    example: ClassVar[dict[str, Any]] = {}
    unbounded: ClassVar[tuple[str, ...]] = ()
    without_effect: ClassVar[tuple[str, ...]] = ()
    calibrated: ClassVar[tuple[str, ...]] = ()
    calibrated_ahead: ClassVar[tuple[str, ...]] = ()
    wishes: ClassVar[dict[str, Any]] = {}
    command_unit: ClassVar[str] = ""
    parameters: ClassVar[dict[str, Parameter]] = {}
    _origins: Mapping[str, Origin] = {}

    def __init_subclass__(cls, **kwargs: Any) -> None:
        super().__init_subclass__(**kwargs)
        found = dict(cls.parameters)
        for name, value in list(vars(cls).items()):
            if isinstance(value, Parameter):
                found[name] = replace(value, name=name)
                delattr(cls, name)
        cls.parameters = found
        if cls.family in FAMILY:
            family = FAMILY[cls.family]
            for what, names, fixed in (("inputs", family.inputs, not family.chooses), ("outputs", family.outputs, not family.either)):
                if fixed and not any(what in vars(base) for base in cls.__mro__ if base is not Component):
                    setattr(cls, what, tuple(Port(name, size_of(cls.family, name)) for name in names))
        elif cls.kind:
            raise ComponentError(f"{cls.__name__}: family {cls.family!r} is not one of {', '.join(FAMILIES)}")

    def __init__(self, **values: Any) -> None:
        self._refuse_unknown(values)
        for name, parameter in self.parameters.items():
            value = values.get(name, parameter.default)
            if value is None:
                raise ParameterError(f"{self.kind}.{name}", "not given", parameter.needed)
            object.__setattr__(self, name, parameter.check(value))
        self.check_values()

    def _refuse_unknown(self, names: Iterable[str]) -> None:
        for name in sorted(set(names) - set(self.parameters)):
            raise ComponentError(f"{self.kind}: no parameter {name!r}: {hint(name, self.parameters)}")

    def check_values(self) -> None:
        """Raise ParameterError if values, each within its own bounds, do not fit together.

        A batch calls those of contourlab itself once with arrays of all variants: compare them within ``np.any``.
        """

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"{type(self).__name__} is frozen: make a new one with .replace({name}=...)")

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self.values() == other.values()

    def __hash__(self) -> int:
        return hash((type(self), tuple(sorted(self.values().items()))))

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{k}={v!r}' for k, v in self.values().items())})"

    def values(self) -> dict[str, Any]:
        """Return every parameter with its value in SI."""
        return {name: getattr(self, name) for name in self.parameters}

    @property
    def origins(self) -> Mapping[str, Origin]:
        """Origins of parameter values, where stated; components that differ only in origins are equal."""
        return self._origins

    def replace(self, **changes: Any) -> Any:
        """Return a copy with changed parameters; a changed value loses its origin."""
        kind: Any = type(self)
        return kind(**{**self.values(), **changes}).traced({k: v for k, v in self._origins.items() if k not in changes})

    def traced(self, origins: Mapping[str, Origin]) -> Any:
        """Return a copy with these origins.

        Raises
        ------
        ComponentError
            If a name is not a parameter.
        """
        self._refuse_unknown(origins)
        if not origins and not self._origins:
            return self
        kind: Any = type(self)
        copy = kind(**self.values())
        object.__setattr__(copy, "_origins", dict(origins))
        return copy

    def takes(self, port: str) -> bool:
        """Tell whether it has this input."""
        return any(known.name == port for known in self.inputs)

    def gives(self, port: str) -> bool:
        """Tell whether it has this output."""
        return any(known.name == port for known in self.outputs)

    @classmethod
    @cache
    def numeric(cls) -> tuple[str, ...]:
        """Return the names of the parameters that are rows of numbers in compiled code."""
        return tuple(name for name, p in cls.parameters.items() if not p.choices and not p.structural)

    def step_function(self) -> Callable[..., Any]:
        """Return the step, with its keyword-only arguments bound to the attributes of the same names."""
        step: Any = type(self).step
        code = step.__code__
        named = code.co_varnames[code.co_argcount : code.co_argcount + code.co_kwonlyargcount]
        return _bound(step, tuple((name, getattr(self, name)) for name in named if name not in (step.__kwdefaults__ or ())))

    @staticmethod
    def step(par: Any, x: Any, inp: Any, clock: Any, *args: Any, **structure: Any) -> tuple[tuple[Any, ...], tuple[Any, ...]]:
        """Advance one tick: ``(x_next, out)``, tuples in the order of `states` and `outputs`.

        A parameter that changes the structure of the step is a keyword-only argument: ``step(par, x, inp, clock, *, shape)``. All others
        differ between variants and come from `par`.
        """
        # A base class without a step never runs.
        raise NotImplementedError

    def derive(self, par: Any, dt: float) -> tuple[Any, ...]:
        """Return the derived constants from the numeric parameters and the period of the step.

        The parameters are numbers or arrays (n_variant,): use numpy functions.
        """
        return ()

    def table_values(self) -> dict[str, Array]:
        """Return the read-only tables (n, ...) by name."""
        return {}

    def ring_length(self, dt: float) -> int:
        """Return how many past ticks of the ring port to keep."""
        return 1

    def ahead(self, dt: float) -> int:
        """Return how many ticks the port ``reference_ahead`` leads the reference."""
        return 0

    @staticmethod
    def designed(wishes: Mapping[str, float], model_gain: float, model_damping: float) -> dict[str, float]:
        """Return the parameters that meet `wishes` on the axis v' = model_gain u - model_damping v, all in SI."""
        # Called only for kinds with `wishes`.
        raise NotImplementedError

    def at_rest(self, position: float) -> tuple[dict[str, float], dict[str, float]]:
        """Return states, and outputs before the first tick, of an axis at rest at `position` [m]; missing values are zero."""
        return {}, {}

    def linear(self) -> Any:
        """Return the component without its nonlinear parts, for the analysis of the loop."""
        return self

    def linearize(self) -> LinearModel | None:
        """Return the linear model around rest, or None if there is none."""
        return None

    @classmethod
    def ports(cls, n_axis: int) -> tuple[tuple[Port, ...], tuple[Port, ...], tuple[Port, ...]]:
        """Return states, inputs and outputs for a machine of `n_axis` axes: a port of size -1 takes one row per axis."""

        def sized(ports: tuple[Port, ...]) -> tuple[Port, ...]:
            return tuple(Port(p.name, n_axis) if p.size < 0 else p for p in ports)

        return sized(cls.states), sized(cls.inputs), sized(cls.outputs)

    def make_step(self, n_axis: int = 1) -> Step:
        """Return the step for the engine."""
        kind: Any = type(self)
        return _step_of(kind, self.step_function(), n_axis)

    def constants(self) -> Any:
        """Return the parameters as a step sees them, derived ones included."""
        block = self.block(1.0)
        return record(tuple(block))(*block.values())

    def block(self, dt: float, overrides: Mapping[str, Array] | None = None) -> dict[str, Any]:
        """Return the value of every parameter row, derived ones included; overrides are arrays (n_variant,)."""
        rows: dict[str, Any] = {**{name: getattr(self, name) for name in self.numeric()}, **(overrides or {})}
        derived = self.derive(SimpleNamespace(**rows), dt)
        if not isinstance(derived, tuple) or len(derived) != len(self.derived):
            found = f"{len(derived)} numbers" if isinstance(derived, tuple) else repr(derived)
            wanted = f"a tuple of {len(self.derived)}: {', '.join(self.derived) or 'none'}"
            raise fault(type(self), f"derive returns {found}, but derived names {wanted}", type(self).derive)
        return {**rows, **dict(zip(self.derived, derived, strict=True))}


@lru_cache(256)
def _bound(step: FunctionType, named: tuple[tuple[str, Any], ...]) -> Callable[..., Any]:
    """Return a function with some keyword-only arguments fixed; a plain function, which the engine can read."""
    if not named:
        return step
    bound = FunctionType(step.__code__, step.__globals__, step.__name__, step.__defaults__, step.__closure__)
    bound.__kwdefaults__ = {**(step.__kwdefaults__ or {}), **dict(named)}
    return update_wrapper(bound, step)


@lru_cache(256)
def _step_of(kind: type[Component], function: Callable[..., Any], n_axis: int) -> Step:
    states, inputs, outputs = kind.ports(n_axis)
    return Step(f"{kind.family}/{kind.kind}", function, (*kind.numeric(), *kind.derived), kind.tables, kind.ring, states, inputs, outputs)
