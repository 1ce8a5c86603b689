"""The exception tree: every error that contourlab raises on purpose.

::

    ContourlabError                     exit code 2 by default
    ├── ProgramError                    file, line, column of a part program
    │   └── ProgramEndError             a part program without its end
    ├── ScenarioError                   file and key of a scenario, machine or controller file
    ├── ParameterError                  name, value, bound and unit of a parameter
    ├── UnitError                       a quantity that cannot be read or has the wrong dimension
    ├── GeometryError                   a degenerate contour (zero length, coincident points ...)
    ├── FeedError                       a feed profile that cannot be planned
    ├── ComponentError                  a component that breaks the contract, or is unknown
    ├── EngineError                     a schedule that cannot be compiled or wired
    ├── LogError                        file and line of a measured log
    ├── MissingPackageError             a package of an extra that is not installed
    ├── ResultError                     a result file that cannot be read, or a signal that is not there
    ├── OutputError                     a file or folder that cannot be written
    └── DivergenceError                 sample, time, axis of a loop that ran away; exit code 3
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

__all__ = [
    "ComponentError",
    "ContourlabError",
    "DivergenceError",
    "EngineError",
    "FeedError",
    "GeometryError",
    "LogError",
    "MissingPackageError",
    "OutputError",
    "ParameterError",
    "ProgramEndError",
    "ProgramError",
    "ResultError",
    "ScenarioError",
    "UnitError",
]


def refuse(fault: object, error: Callable[..., Exception], *words: Any, **place: Any) -> None:
    """Raise an error, made of words and a place, if there is a fault.

    The words are computed in any case: where they cost time, or exist only with the fault, write an ``if``.
    """
    if fault:
        raise error(*words, **place)


def check_known(name: str, value: object, known: Collection[str]) -> None:
    """Raise ParameterError if the value of `name` is not one of those known."""
    if value not in known:
        raise ParameterError(name, repr(value), f"one of {', '.join(known)}")


def error_text(error: BaseException) -> str:
    """Return type and text of an error of third-party code on one line; the type alone if it has no readable text."""
    try:
        return ": ".join(filter(None, (type(error).__name__, " ".join(str(error).split()))))
    except KeyboardInterrupt:
        raise
    except BaseException:  # __str__ may raise anything
        return type(error).__name__


def hint(name: object, known: Iterable[str], other: Mapping[str, str] | None = None) -> str:
    """Suggest the known name of the same thing (by its `other` names), or the nearest one, or list all names.

    >>> hint("dampng", ["gain", "damping"]), hint("P-PI", ["pid", "cascade"], {"p-pi": "cascade"})
    ("did you mean 'damping'?", "did you mean 'cascade'?")
    """
    names, name = list(known), str(name)
    same = (other or {}).get(name.lower().replace("_", "-"))
    near = [same] if same in names else difflib.get_close_matches(name, names, n=1, cutoff=0.6)
    if near:
        return f"did you mean {near[0]!r}?"
    return "use one of " + ", ".join(names) if names else "none is allowed here"


@contextmanager
def refused(option: str, text: object, wanted: str) -> Iterator[None]:
    """Raise ParameterError, with the wanted form, for the text of an option that cannot be read as a quantity."""
    try:
        yield
    except (UnitError, ValueError) as error:
        raise ParameterError(option, repr(text), wanted) from error


class ContourlabError(Exception):
    """Base of all errors raised on purpose; its text is for the user. A fault of a program has a code, for ``contourlab explain``."""

    exit_code = 2
    code = ""


_CODED = re.compile(r"(CL\d{3}) ")


def _code_and_message(text: str) -> tuple[str, str]:
    coded = _CODED.match(text)
    return (coded[1], text[coded.end() :]) if coded else ("", text)


class ProgramError(ContourlabError):
    """A part program cannot be read; gives code, file, line and column (both from 1).

    The code says what kind of fault it is; ``contourlab explain CODE`` has its page. It stands before the message, as in
    ``"CL823 the arc has no radius: R must not be 0"``, and is not part of the text.
    """

    def __init__(self, message: str, *, file: str | Path = "<program>", line: int = 0, column: int = 0) -> None:
        self.code, self.message = _code_and_message(message)
        self.file, self.line, self.column = str(file), line, column
        place = self.file + (f":{line}" if line else "") + (f":{column}" if line and column else "")
        super().__init__(f"{place}: {self.message}")


class ProgramEndError(ProgramError):
    """A part program has no end."""


class ScenarioError(ContourlabError):
    """A scenario, machine or controller file is wrong; gives file and dotted key."""

    def __init__(self, message: str, *, file: str | Path = "<scenario>", key: str = "") -> None:
        self.message, self.file, self.key = message, str(file), key
        super().__init__(f"{self.file}: {key + ': ' if key else ''}{message}")


class ParameterError(ContourlabError):
    """A parameter is out of its range; gives name, value, bound and unit."""

    def __init__(self, name: str, value: object, bound: str, unit: str = "") -> None:
        self.name, self.value, self.bound, self.unit = name, value, bound, unit
        super().__init__(f"{name} = {_with_unit(str(value), unit)}: must be {_with_unit(bound, unit)}")


def _with_unit(text: str, unit: str) -> str:
    """Add a unit to a text that ends in a number or a list of numbers."""
    return f"{text} {unit}" if unit and re.search(r"(\d|inf|nan|[\])])\Z", text) else text


class UnitError(ContourlabError):
    """A quantity cannot be read, or has the wrong dimension."""


class GeometryError(ContourlabError):
    """A curve or path is degenerate or out of its range of validity."""


class FeedError(ContourlabError):
    """A feed profile cannot be planned within the limits given. It may have a code, as a `ProgramError`."""

    def __init__(self, message: str, name: str = "") -> None:
        self.code, text = _code_and_message(message)
        super().__init__(f"{name}: {text}" if name else text)


class ComponentError(ContourlabError):
    """A component is unknown, cannot be imported, or breaks the contract."""


class EngineError(ContourlabError):
    """A schedule cannot be compiled or wired; gives file and line (from 1) of a step that cannot be compiled."""

    def __init__(self, message: str, *, file: str = "", line: int = 0) -> None:
        self.message, self.file, self.line = message, file, line
        super().__init__(f"{file}:{line}: {message}" if file else message)


class LogError(ContourlabError):
    """A measured log cannot be read, or lacks required data; gives file and line (from 1)."""

    def __init__(self, message: str, *, file: str | Path = "<log>", line: int = 0) -> None:
        self.message, self.file, self.line = message, str(file), line
        super().__init__(f"{self.file}{f':{line}' if line else ''}: {message}")


class MissingPackageError(ContourlabError):
    """A package of an extra is not installed; gives the command to install it."""

    def __init__(self, package: str, extra: str) -> None:
        self.package, self.extra = package, extra
        super().__init__(f'the package {package} is missing: install it with  pip install "contourlab[{extra}]"')


class ResultError(ContourlabError):
    """A result cannot be read, or lacks a signal."""


class OutputError(ContourlabError):
    """A file or folder cannot be written; nothing was left half-written."""


class DivergenceError(ContourlabError):
    """The simulated loop ran away or became non-finite; gives sample, time and axis."""

    exit_code = 3

    def __init__(self, message: str, *, sample: int, time: float, axis: str) -> None:
        self.sample, self.time, self.axis = sample, time, axis
        super().__init__(f"{message} ({f'axis {axis}, ' if axis else ''}sample {sample}, t = {time:.6g} s)")
