"""Options of questions: each is one field of a settings class, with its type, default, bounds and line of help.

The command line, the public function and its documentation are made from the fields. Nothing heavy is imported here: the help of a command
needs these classes only.
"""

from __future__ import annotations

import dataclasses
import inspect
import math
import operator
import os
import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field, fields
from pathlib import Path
from types import NoneType
from typing import Any, ClassVar, TypeVar, dataclass_transform, get_args, get_origin, get_type_hints

from contourlab.errors import ParameterError, refuse, refused

REQUIRED: Any = dataclasses.MISSING
"""Default of an option without one."""
Kind = TypeVar("Kind")


@dataclass(frozen=True)
class Option:
    """What an option says of itself, besides its name and its type.

    Attributes
    ----------
    help : str
        One line.
    least, most, above : float, optional
        Bounds; `above` is excluded.
    choices : tuple of str
        All words that it may be; empty for any.
    unit : str
        Unit of a number; or SI unit of a quantity that is given as text, as ``"25 um"``, which must be > 0.
    metavar : str
        What stands for the value in the help; marks an argument if `argument` is set.
    argument : bool
        Whether the command line takes it by its place.
    listed : bool
        Whether several values may be one text with commas.
    objects : str
        Class of which an object may stand in Python in place of the text.
    advanced : bool
        Whether it is for experts.
    name : str
        Name on the command line, if it is not that of the field.
    """

    help: str = ""
    least: float | None = None
    most: float | None = None
    above: float | None = None
    choices: tuple[str, ...] = ()
    unit: str = ""
    metavar: str = ""
    argument: bool = False
    listed: bool = False
    objects: str = ""
    advanced: bool = False
    name: str = ""

    @property
    def bound(self) -> str:
        """The bounds, as text."""
        if self.least is self.above is self.most is None:
            return ""
        if self.above is not None:
            return f"> {self.above:g}" + ("" if self.most is None else f" and <= {self.most:g}")
        return f"{self.least:g} or more" if self.most is None else f"{self.least:.12g} to {self.most:.12g}"


def option(default: Any, help: str = "", **more: Any) -> Any:  # noqa: A002
    """Return the field of an option; see `Option`."""
    return field(default=default, kw_only=True, metadata={"option": Option(help, **more)})


def argument(metavar: str, help: str, default: Any = REQUIRED, **more: Any) -> Any:  # noqa: A002
    """Return the field of an argument of the command line."""
    return option(default, help, metavar=metavar, argument=True, **more)


def _flag(value: object) -> bool:
    if not isinstance(value, bool):
        raise TypeError
    return value


def _file(value: Any) -> os.PathLike[str]:
    return value if isinstance(value, os.PathLike) else Path(value)  # a log that is read already stays what it is


KINDS: dict[type, tuple[Callable[[Any], Any], str]] = {
    str: (os.fspath, "a text"),
    int: (operator.index, "a whole number"),
    float: (float, "a number"),
    bool: (_flag, "True or False"),
    Path: (_file, "a file"),
}
"""Types of values: how each is read, and what it is."""


QUANTITIES = {"m": "a length", "s": "a time", "m/s": "a speed", "Hz": "a frequency", "kg*m^2": "an inertia"}
"""Quantities by their SI unit."""


@dataclass(frozen=True)
class Part:
    """An option with its name and type: `kind` is the type of a value, or of each of `many` values."""

    name: str
    kind: type
    many: bool
    default: Any
    option: Option

    @property
    def typed(self) -> str:
        """The option as typed."""
        return self.option.name or f"--{self.name.rstrip('_').replace('_', '-')}"

    @property
    def wanted(self) -> str:
        """What a quantity must be, with the example in its help, or its default."""
        quoted = re.search(r'e\.g\. "([^"]+)"', self.option.help)
        example = quoted[1] if quoted else re.sub(r"(?<=\d)(?=[a-zA-Z])", " ", str(self.default))
        return f'{QUANTITIES[self.option.unit]} with its unit, such as "{example}"'

    @property
    def negative(self) -> str:
        """The option that turns off what is on by default, or undecided; else an empty text."""
        return f"--no-{self.typed[2:]}" if self.kind is bool and self.default is not False else ""

    def checked(self, value: Any) -> Any:
        """Return a value of the type of the option.

        Raises
        ------
        ParameterError
            If the value has another type, or is out of bounds.
        """
        if value is None:
            return None if self.default is REQUIRED else self.default
        if self.many:
            values = tuple(value) if isinstance(value, Iterable) and not isinstance(value, str | os.PathLike) else (value,)
            if self.option.listed:
                values = tuple(name for text in values for name in (map(str.strip, text.split(",")) if isinstance(text, str) else [text]))
            return tuple(self._one(item) for item in values)
        return self._one(value)

    def is_object(self, value: Any) -> bool:
        """Return whether a value is an object in place of a text."""
        return type(value).__name__ == self.option.objects

    def _one(self, value: Any) -> Any:
        limits, (read, wanted) = self.option, KINDS[self.kind]
        if self.is_object(value):
            return value
        try:
            value = read(value)
        except (TypeError, ValueError):
            raise ParameterError(self.name, repr(value), wanted) from None
        if limits.choices and value not in limits.choices:
            raise ParameterError(self.name, repr(value), f"one of {', '.join(limits.choices)}")
        least, most, above = (math.nan if x is None else x for x in (limits.least, limits.most, limits.above))
        if limits.bound and self.kind in (int, float) and (value < least or value > most or value <= above or value != value):
            raise ParameterError(self.name, f"{value:g}" if self.kind is float else f"{value}", limits.bound, limits.unit)
        return value

    def words(self, value: Any) -> Iterator[str]:
        """Yield the words that give a value, nothing for the default."""
        if value == self.default or value is None or (self.is_object(value) and not isinstance(value, os.PathLike)):
            return  # a log that is read has its name
        if self.option.argument:
            yield from map(str, value) if self.many else (str(value),)
        elif self.kind is bool:
            yield self.typed if value else self.negative
        elif self.many and self.option.listed:
            yield from (self.typed, ",".join(value))
        else:
            for item in value if self.many else (value,):
                yield from (self.typed, str(item))


@dataclass_transform(kw_only_default=True, frozen_default=True)
def options(kind: type[Kind]) -> type[Kind]:
    """Make a class of options: a frozen dataclass of keywords, which knows its parts."""
    made: Any = dataclass(frozen=True, kw_only=True)(kind)
    hints = get_type_hints(made)
    found = {part.name: _part(part, hints[part.name]) for part in fields(made) if "option" in part.metadata}
    depth = {name: i for i, base in reversed([*enumerate(made.__mro__)]) for name in inspect.get_annotations(base)}
    # Arguments by their place, then its own options before those of its bases.
    made.PARTS = dict(sorted(found.items(), key=lambda item: -1 if item[1].option.argument else depth[item[0]]))
    return made  # type: ignore[no-any-return]


def _part(part: dataclasses.Field[Any], hint: Any) -> Part:
    """Read one field; its type is one of `KINDS`, such a type or None, or a tuple of them."""
    kinds = [kind for kind in get_args(hint) if kind not in (NoneType, ...)] or [hint]
    return Part(part.name, kinds[0], get_origin(hint) is tuple, part.default, part.metadata["option"])


@options
class Options:
    """Options; each value is checked, and turned into the type of its field.

    Attributes
    ----------
    PARTS : dict of str to Part
        The options by the names of their fields.
    """

    PARTS: ClassVar[dict[str, Part]] = {}

    def __post_init__(self) -> None:
        for name, part in self.PARTS.items():
            object.__setattr__(self, name, part.checked(getattr(self, name)))
        for name, part in self.PARTS.items():
            if part.option.unit and part.kind is str:
                self.si(name)

    def si(self, name: str) -> Any:
        """Return a quantity that is given as text, in SI; None if it is not given.

        Raises
        ------
        ParameterError
            If it is no quantity of its unit, or not positive.
        """
        part, text = self.PARTS[name], getattr(self, name)
        return None if text is None else positive(name, text, part.option.unit, part.wanted)

    @property
    def is_typed(self) -> bool:
        """Whether `words` says all: no machine, for example, is given as an object."""
        objects = [getattr(self, name) for name, part in self.PARTS.items() if part.is_object(getattr(self, name))]
        return all(isinstance(each, os.PathLike) for each in objects)

    def words_of(self, kind: type[Options]) -> list[str]:
        """Return the words of a command that has the options of a base."""
        return [word for name, part in kind.PARTS.items() for word in part.words(getattr(self, name))]

    def words(self, *but: str) -> list[str]:
        """Return the words of a command that give these options, except those of the fields in `but`."""
        return [word for name, part in self.PARTS.items() if name not in but for word in part.words(getattr(self, name))]


def positive(option: str, text: str, unit: str, wanted: str, *, zero: bool = False) -> float:
    """Read the value of an option, > 0, in SI; one without a unit may be a bare number.

    Parameters
    ----------
    unit : str
        SI unit of the expected dimension.
    wanted : str
        Expected form, for the message.
    zero : bool
        Whether 0 is allowed, too.

    Raises
    ------
    ParameterError
        If the text is not such a quantity, or not positive.
    """
    from contourlab.units import to_si  # the help does without

    with refused(option, text, wanted):
        value = to_si(float(text) if not unit and re.fullmatch(r"[\d.eE+-]+", text.strip()) else text, unit)
    refuse(not value > 0.0 and (value != 0.0 or not zero), ParameterError, option, text, f">{'=' * zero} 0")
    return value
