"""Values in a part program: numbers, parameters, functions, and expressions in square brackets.

The rules are those of LinuxCNC 2.9. Blanks and case are ignored. Operations of equal rank are left-associative, including the power. A
sign binds to the value after it: [-2 ** 2] is 4. Angles are in degrees. Numbers that differ by less than 1e-4 are equal (EQ). Logical
results are 0 and 1; any number other than 0 is true. Unlike LinuxCNC, undefined values (5 MOD 0, 0 ** -1) are always refused.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from itertools import chain
from typing import TypeAlias

from contourlab.program.vocabulary import BlockError

LARGEST_PARAMETER = 5601
SELECTED_SYSTEM = 5220
LOCAL = range(1, 31)
"""Numbers local to each call of a subprogram."""
_POSITION = (5420, 5421, 5422)
_MACHINE_NAMES = ("_ini[", "_hal[")
"""Starts of the names of INI entries and HAL pins."""
_READ_ONLY = frozenset((*range(5400, 5414), *range(5420, 5429)))

Key: TypeAlias = int | str
"""Number of a parameter, or its name in lower case without blanks."""


class Parameters:
    """Parameters of a program.

    Until it is set, a numbered parameter is 0 and a named one does not exist. Only #5220, the work coordinate system, starts at 1 (G54).

    Parameters
    ----------
    position : callable
        Returns the programmed point in program units, for #5420 to #5422.
    own : mapping, optional
        Read-only parameters of the interpreter: name to function.

    Attributes
    ----------
    returned : float or None
        Value that the last subprogram returned.
    changes : int
        Count of assignments.
    defining : bool
        Whether a subprogram is being skipped at its definition: names without a value are then 0, as in LinuxCNC.
    """

    def __init__(
        self,
        position: Callable[[], tuple[float, float, float]] = lambda: (0.0, 0.0, 0.0),
        own: Mapping[str, Callable[[], float]] | None = None,
    ) -> None:
        self.position = position
        self.own = own or {}
        self._numbered: dict[int, float] = {SELECTED_SYSTEM: 1.0}
        self._global: dict[str, float] = {}
        self._local: dict[str, float] = {}
        self._callers: list[tuple[dict[str, float], dict[int, float] | None]] = []
        self.returned: float | None = None
        self.changes = 0
        self.defining = False

    @property
    def depth(self) -> int:
        """Depth of nested calls."""
        return len(self._callers)

    def read(self, key: Key, column: int) -> float:
        """Return a parameter's value.

        Raises
        ------
        BlockError
            If the number does not exist, or the name has no value.
        """
        if isinstance(key, str):
            if key in self.own:
                return self.own[key]()
            names = self._names(key)
            if key not in names:
                if self.defining:
                    return 0.0
                if key.startswith(_MACHINE_NAMES):
                    raise BlockError(f"CL837 #<{key}> is a value of the machine, unknown here: write the number itself", column)
                raise BlockError(f"CL837 #<{key}> has no value yet: write #<{key}> = ... on an earlier line", column)
            return names[key]
        _check_number(key, column)
        return self.number(key)

    def number(self, key: int) -> float:
        """Return the value of an existing numbered parameter."""
        if key in _POSITION:
            return self.position()[key - _POSITION[0]]
        return self._numbered.get(key, 0.0)

    def exists(self, name: str) -> bool:
        """Tell whether a named parameter has a value."""
        return name in self.own or name in self._names(name)

    def check(self, key: Key, column: int) -> None:
        """Refuse parameters that do not exist or belong to the interpreter."""
        if isinstance(key, str):
            if key in self.own or key.startswith(_MACHINE_NAMES):
                raise BlockError(f"CL838 #<{key}> is read-only, the control sets it: choose another name", column)
            return
        _check_number(key, column)
        if key in _READ_ONLY:
            raise BlockError(f"CL838 #{key} is read-only, the interpreter sets it (tool or position): choose another number", column)

    def give_back(self, value: float | None) -> None:
        """Store the value that a subprogram returns."""
        self.returned, self.changes = value, self.changes + 1

    def write(self, key: Key, value: float) -> None:
        """Set a parameter that passed `check`."""
        self.changes += 1
        if isinstance(key, str):
            self._names(key)[key] = value
        else:
            self._numbered[key] = value

    def outermost(self) -> dict[Key, float]:
        """Return all parameters that are set, as the main program sees them."""
        local, numbers = self._callers[0] if self._callers else (self._local, None)
        return dict[Key, float](chain(*(values.items() for values in (self._numbered, numbers or {}, self._global, local))))

    def point(self, first: int) -> tuple[float, float, float]:
        """Return the lengths [m] in three parameters in mm."""
        x, y, z = (self.number(first + axis) / 1000.0 for axis in range(3))
        return (x, y, z)

    def write_point(self, first: int, point: tuple[float, float, float]) -> None:
        """Set three parameters in mm to lengths [m]."""
        for axis in range(3):
            self.write(first + axis, point[axis] * 1000.0)

    def _names(self, key: str) -> dict[str, float]:
        return self._global if key.startswith("_") else self._local

    def enter(self, arguments: list[float] | None) -> None:
        """Enter a subprogram with its own names and #1 to #30, set to the arguments, then 0; None keeps #1 to #30 of the caller (M98)."""
        numbers = None
        if arguments is not None:
            numbers = {number: self._numbered.get(number, 0.0) for number in LOCAL}
            for number in LOCAL:
                self._numbered[number] = arguments[number - 1] if number <= len(arguments) else 0.0
        self._callers.append((self._local, numbers))
        self._local = {}

    def leave(self) -> None:
        """Restore the caller's parameters."""
        self._local, numbers = self._callers.pop()
        if numbers is not None:
            self._numbered |= numbers


def _check_number(number: int, column: int) -> None:
    if not 1 <= number <= LARGEST_PARAMETER:
        raise BlockError(f"CL839 there is no parameter #{number}: use #1 to #{LARGEST_PARAMETER}", column)


MOST_NESTED = 50
LARGEST_WHOLE = 1e9
_EQUAL = 1e-4
NUMBER = re.compile(r"[0-9]*\.?[0-9]*")
_OPERATION = re.compile(r"\*\*|[*/+-]|mod|and|xor|or|eq|ne|gt|ge|lt|le")
_FUNCTION = re.compile(r"abs|acos|asin|atan|cos|exists|exp|fix|fup|ln|round|sin|sqrt|tan")
_RANKS = (("**",), ("*", "/", "mod"), ("+", "-"), ("eq", "ne", "gt", "ge", "lt", "le"), ("and", "or", "xor"))
_RANK = {name: rank for rank, names in enumerate(_RANKS) for name in names}


class Cursor:
    """A position in a line without blanks and comments, in lower case.

    Parameters
    ----------
    columns : list of int
        Column (from 1) of each character of `text` in the line.
    """

    def __init__(self, text: str, columns: list[int]) -> None:
        self.text, self.columns, self.at, self.depth = text, columns, 0, 0

    @property
    def next(self) -> str:
        """The current character; empty at the end."""
        return self.text[self.at : self.at + 1]

    @property
    def column(self) -> int:
        """Column of the current or last character."""
        return self.columns[min(self.at, len(self.columns) - 1)] if self.columns else 1

    def take(self, pattern: re.Pattern[str]) -> str:
        """Return and skip the match at this position; empty if none."""
        match = pattern.match(self.text, self.at)
        self.at = match.end() if match else self.at
        return match[0] if match else ""

    def name(self, what: str) -> str:
        """Return and skip the name in <> at this position."""
        end = self.text.find(">", self.at)
        name = self.text[self.at + 1 : end]
        if end < 0 or not name:
            raise BlockError(f"CL839 the name of the {what} is empty or has no '>': write for example <depth>", self.column)
        self.at = end + 1
        return name

    def deeper(self) -> None:
        """Enter a level of brackets, functions or #; the caller leaves it."""
        self.depth += 1
        if self.depth > MOST_NESTED:
            raise BlockError(
                f"CL835 brackets are nested more than {MOST_NESTED} deep: store part of the expression in a parameter", self.column
            )

    def expect(self, character: str, what: str) -> None:
        """Skip a character; refuse any other."""
        if self.next != character:
            raise BlockError(f"CL835 '{character}' is missing {what}: write it here", self.column)
        self.at += 1


def read_value(cursor: Cursor, parameters: Parameters) -> float:
    """Read a number, parameter, function or expression, with signs before it."""
    start, sign = cursor.column, 1.0
    while cursor.next in ("+", "-"):
        sign = -sign if cursor.next == "-" else sign
        cursor.at += 1
    if cursor.next == "[":
        value = _expression(cursor, parameters)
    elif cursor.next == "#":
        cursor.at += 1
        value = parameters.read(_key(cursor, parameters), start)
    elif cursor.next.isalpha():
        value = _function(cursor, parameters)
    else:
        value = _number(cursor)
    if not math.isfinite(value):
        raise BlockError("CL805 the value that starts here is too large: make it smaller", start)
    return sign * value


def read_assignment(cursor: Cursor, parameters: Parameters) -> tuple[Key, float]:
    """Read ``#1 = 2`` or ``#<name> = 2`` after the #; the caller assigns it at the end of the line."""
    column = cursor.column
    key = _key(cursor, parameters)
    parameters.check(key, column)
    if isinstance(key, str) and not parameters.exists(key):
        parameters.write(key, 0.0)  # the name exists at once, as in LinuxCNC
    cursor.expect("=", "after the parameter to set")
    return key, read_value(cursor, parameters)


def _number(cursor: Cursor) -> float:
    column, digits = cursor.column, cursor.take(NUMBER)
    if digits in ("", "."):
        what = f"found '{cursor.next}'" if cursor.next else "the line ends here"
        raise BlockError(f"CL803 a number is missing: {what}; write for example 10.5, #1 or [1 + 2]", column)
    if len(digits) > 100:
        raise BlockError("CL805 the number has more than 100 digits: shorten it", column)
    return float(digits)


def _key(cursor: Cursor, parameters: Parameters) -> Key:
    """Read the key after a #: a name in <>, or any whole value."""
    column = cursor.column
    if cursor.next == "<":
        return cursor.name("parameter")
    cursor.deeper()
    value = read_value(cursor, parameters)
    cursor.depth -= 1
    if abs(value - round(value)) > _EQUAL or abs(value) > LARGEST_WHOLE:
        raise BlockError(f"CL839 #{value:g}: a parameter number must be whole, as in #1", column)
    return round(value)


def _expression(cursor: Cursor, parameters: Parameters) -> float:
    """Read [a op b op c ...]: stack operands and operations, and evaluate once no higher rank can follow."""
    cursor.expect("[", "before the expression")
    cursor.deeper()
    values = [read_value(cursor, parameters)]
    waiting: list[tuple[str, int]] = []
    while cursor.next != "]":
        column = cursor.column
        name = cursor.take(_OPERATION)
        if not name:
            what = f"'{cursor.next}'" if cursor.next else "the end of the line"
            raise BlockError(f"CL835 an operator or ']' is missing before {what}: write for example [1 + 2]", column)
        while waiting and _RANK[waiting[-1][0]] <= _RANK[name]:
            _join(values, waiting)
        waiting.append((name, column))
        values.append(read_value(cursor, parameters))
    while waiting:
        _join(values, waiting)
    cursor.depth -= 1
    cursor.at += 1
    return values[0]


def _join(values: list[float], waiting: list[tuple[str, int]]) -> None:
    name, column = waiting.pop()
    right, left = values.pop(), values.pop()
    values.append(_guarded(lambda: _OPERATIONS[name](left, right), f"{left:g} {name.upper()} {right:g}", column))


def _function(cursor: Cursor, parameters: Parameters) -> float:
    column, name = cursor.column, cursor.take(_FUNCTION)
    if not name:
        known = "ABS, ACOS, ASIN, ATAN, COS, EXISTS, EXP, FIX, FUP, LN, ROUND, SIN, SQRT or TAN"
        raise BlockError(f"CL835 '{cursor.next.upper()}' does not start a function name: use {known}, with the value in [ ]", column)
    if cursor.next != "[":
        raise BlockError(f"CL835 {name.upper()} has no value: write it in brackets, as in {name.upper()}[30]", cursor.column)
    if name == "exists":
        return _exists(cursor, parameters)
    value = _expression(cursor, parameters)
    if name == "atan":
        cursor.expect("/", "between the two values of ATAN[y]/[x]")
        return math.degrees(math.atan2(value, _expression(cursor, parameters)))
    return _guarded(lambda: _FUNCTIONS[name](value), f"{name.upper()}[{value:g}]", column)


def _exists(cursor: Cursor, parameters: Parameters) -> float:
    """Read EXISTS[#<name>]; numbered parameters always exist."""
    cursor.expect("[", "after EXISTS")
    cursor.expect("#", "in EXISTS[#<name>]")
    key = _key(cursor, parameters)
    cursor.expect("]", "after the parameter in EXISTS[#<name>]")
    return float(isinstance(key, int) or parameters.exists(key))


def _guarded(work: Callable[[], float], shown: str, column: int) -> float:
    try:
        value = work()
    except (ValueError, ZeroDivisionError, OverflowError):
        value = math.nan
    if isinstance(value, complex) or not math.isfinite(value):
        raise BlockError(f"CL836 {shown} is undefined or too large: correct it", column)
    return value


def _modulo(left: float, right: float) -> float:
    rest = math.fmod(left, right)
    return rest + abs(right) if rest < 0.0 else rest


_OPERATIONS: dict[str, Callable[[float, float], float]] = {
    "**": lambda a, b: a**b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / b,
    "mod": _modulo,
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "eq": lambda a, b: float(abs(a - b) < _EQUAL),
    "ne": lambda a, b: float(abs(a - b) >= _EQUAL),
    "gt": lambda a, b: float(a > b),
    "ge": lambda a, b: float(a >= b),
    "lt": lambda a, b: float(a < b),
    "le": lambda a, b: float(a <= b),
    "and": lambda a, b: float(a != 0.0 and b != 0.0),
    "or": lambda a, b: float(a != 0.0 or b != 0.0),
    "xor": lambda a, b: float((a != 0.0) != (b != 0.0)),
}
_FUNCTIONS: dict[str, Callable[[float], float]] = {
    "abs": abs,
    "acos": lambda x: math.degrees(math.acos(x)),
    "asin": lambda x: math.degrees(math.asin(x)),
    "cos": lambda x: math.cos(math.radians(x)),
    "exp": math.exp,
    "fix": math.floor,
    "fup": math.ceil,
    "ln": math.log,
    "round": lambda x: math.copysign(math.floor(abs(x) + 0.5), x),
    "sin": lambda x: math.sin(math.radians(x)),
    "sqrt": math.sqrt,
    "tan": lambda x: math.tan(math.radians(x)),
}
