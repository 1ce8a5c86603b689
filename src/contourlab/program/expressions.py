"""Values in a part program: numbers, parameters, functions, and expressions in square brackets.

The rules are those of LinuxCNC 2.9. Blanks mean nothing and case does not matter. Binary operations of one rank go from left to right, the
power too; a sign belongs to the value behind it, so that [-2 ** 2] is 4. Angles are in degrees. Two numbers that differ by less than 1e-4
are EQ. Logical values are 0 and 1; any other number is true. Stricter than LinuxCNC: what has no value (5 MOD 0, 0 ** -1) is refused where
it stands, also where a comparison around it would hide it.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable

from contourlab.program.parameters import Key, Parameters
from contourlab.program.vocabulary import BlockError

MOST_NESTED = 50
LARGEST_WHOLE = 1e9
_EQUAL = 1e-4
_NUMBER = re.compile(r"[0-9]*\.?[0-9]*")
_OPERATION = re.compile(r"\*\*|[*/+-]|mod|and|xor|or|eq|ne|gt|ge|lt|le")
_FUNCTION = re.compile(r"abs|acos|asin|atan|cos|exists|exp|fix|fup|ln|round|sin|sqrt|tan")
_RANKS = (("**",), ("*", "/", "mod"), ("+", "-"), ("eq", "ne", "gt", "ge", "lt", "le"), ("and", "or", "xor"))
_RANK = {name: rank for rank, names in enumerate(_RANKS) for name in names}


class Cursor:
    """A line without blanks and comments, in small letters, and where one is in it.

    Parameters
    ----------
    text : str
    columns : list of int
        Column, from 1, at which each character of `text` stands in the line.
    """

    def __init__(self, text: str, columns: list[int]) -> None:
        self.text, self.columns, self.at, self.depth = text, columns, 0, 0

    @property
    def next(self) -> str:
        """The character here; empty at the end."""
        return self.text[self.at : self.at + 1]

    @property
    def column(self) -> int:
        """Column of the character here, or of the last one."""
        return self.columns[min(self.at, len(self.columns) - 1)] if self.columns else 1

    def take(self, pattern: re.Pattern[str]) -> str:
        """Return what matches here, and go behind it; empty if nothing does."""
        found = pattern.match(self.text, self.at)
        if found is None:
            return ""
        self.at = found.end()
        return found[0]

    def name(self, what: str) -> str:
        """Return the name in <> that stands here, and go behind it."""
        end = self.text.find(">", self.at)
        name = self.text[self.at + 1 : end]
        if end < 0 or not name:
            raise BlockError(f"the name of the {what} has no end: write for example <depth>", self.column)
        self.at = end + 1
        return name

    def deeper(self) -> None:
        """Count one more level of brackets, functions or #; the caller counts it down."""
        self.depth += 1
        if self.depth > MOST_NESTED:
            raise BlockError(f"brackets are nested more than {MOST_NESTED} deep: use a parameter for a part of it", self.column)

    def expect(self, character: str, what: str) -> None:
        """Go behind a character.

        Raises
        ------
        BlockError
            If another one stands here.
        """
        if self.next != character:
            raise BlockError(f"'{character}' is missing {what}: write it here", self.column)
        self.at += 1


def read_value(cursor: Cursor, parameters: Parameters) -> float:
    """Read a number, a parameter, a function or an expression, each with any signs before it.

    Raises
    ------
    BlockError
        If there is none, or it has no value.
    """
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
        raise BlockError("the value that starts here is not finite: correct it", start)
    return sign * value


def read_assignment(cursor: Cursor, parameters: Parameters) -> tuple[Key, float]:
    """Read ``#1 = 2`` or ``#<name> = 2`` behind its #; the caller sets it once the whole line is read.

    Raises
    ------
    BlockError
        If it is no assignment, or the parameter cannot be set.
    """
    column = cursor.column
    key = _key(cursor, parameters)
    parameters.check(key, column)
    if isinstance(key, str) and not parameters.exists(key):
        parameters.write(key, 0.0)  # the name is there from here on, as in LinuxCNC
    cursor.expect("=", "behind the parameter that is set")
    return key, read_value(cursor, parameters)


def _number(cursor: Cursor) -> float:
    column, digits = cursor.column, cursor.take(_NUMBER)
    if digits in ("", "."):
        what = f"'{cursor.next}' stands here" if cursor.next else "the line ends here"
        raise BlockError(f"a number is missing: {what}; write for example 10.5, #1 or [1 + 2]", column)
    if len(digits) > 100:
        raise BlockError("a number of more than 100 digits: shorten it", column)
    return float(digits)


def _key(cursor: Cursor, parameters: Parameters) -> Key:
    """Read what stands behind a #: a name in <>, or any value that is a whole number."""
    column = cursor.column
    if cursor.next == "<":
        return cursor.name("parameter")
    cursor.deeper()
    value = read_value(cursor, parameters)
    cursor.depth -= 1
    if abs(value - round(value)) > _EQUAL or abs(value) > LARGEST_WHOLE:
        raise BlockError(f"#{value:g}: the number of a parameter is whole", column)
    return round(value)


def _expression(cursor: Cursor, parameters: Parameters) -> float:
    """Read [a op b op c ...]: operands and operations are stacked, and joined as soon as no higher rank can follow."""
    cursor.expect("[", "before the expression")
    cursor.deeper()
    values = [read_value(cursor, parameters)]
    waiting: list[tuple[str, int]] = []
    while cursor.next != "]":
        column = cursor.column
        name = cursor.take(_OPERATION)
        if not name:
            what = f"'{cursor.next}'" if cursor.next else "the end of the line"
            raise BlockError(f"an operation or ']' is missing before {what}: write for example [1 + 2]", column)
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
        known = "ABS, ACOS, ASIN, ATAN, COS, EXISTS, EXP, FIX, FUP, LN, ROUND, SIN, SQRT and TAN"
        raise BlockError(f"'{cursor.next.upper()}' begins no function: there are {known}, each with its value in [ ]", column)
    if cursor.next != "[":
        raise BlockError(f"{name.upper()} has no value: write it in brackets, as in {name.upper()}[30]", cursor.column)
    if name == "exists":
        return _exists(cursor, parameters)
    value = _expression(cursor, parameters)
    if name == "atan":
        cursor.expect("/", "between the two values of ATAN[y]/[x]")
        other = _expression(cursor, parameters)
        return math.degrees(math.atan2(value, other))
    return _guarded(lambda: _FUNCTIONS[name](value), f"{name.upper()}[{value:g}]", column)


def _exists(cursor: Cursor, parameters: Parameters) -> float:
    """Read EXISTS[#<name>]; a numbered parameter is always there."""
    cursor.expect("[", "behind EXISTS")
    cursor.expect("#", "in EXISTS[#<name>]")
    key = _key(cursor, parameters)
    cursor.expect("]", "behind the parameter in EXISTS[#<name>]")
    return float(isinstance(key, int) or parameters.exists(key))


def _guarded(work: Callable[[], float], shown: str, column: int) -> float:
    try:
        value = work()
    except (ValueError, ZeroDivisionError, OverflowError):
        value = math.nan
    if isinstance(value, complex) or not math.isfinite(value):
        raise BlockError(f"{shown} has no value: correct it", column)
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
