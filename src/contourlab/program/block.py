"""Read a line of a part program into words with columns, then into a block: codes by modal group, other words by letter.

RS274/NGC ignores case, and blanks and tabs outside comments, even inside a number.

Values are numbers, parameters, functions, and expressions in square brackets. Their rules are those of LinuxCNC 2.9. Operations of equal
rank are left-associative, including the power. A sign binds to the value after it: [-2 ** 2] is 4. Angles are in degrees. Numbers that
differ by less than 1e-4 are equal (EQ). Logical results are 0 and 1; any number other than 0 is true. Unlike LinuxCNC, undefined values
(5 MOD 0, 0 ** -1) are always refused.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from functools import lru_cache
from itertools import chain
from typing import NamedTuple, TypeAlias

from contourlab.errors import refuse
from contourlab.program.dialects import LINUXCNC, Rules
from contourlab.program.vocabulary import O_WORD_ALONE, BlockError, EndMarkError, g_name, refusal

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
        self.changes, self.defining = 0, False

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
        return self.position()[key - _POSITION[0]] if key in _POSITION else self._numbered.get(key, 0.0)

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
    else:
        value = _function(cursor, parameters) if cursor.next.isalpha() else _number(cursor)
    if not math.isfinite(value):
        raise BlockError("CL805 the value that starts here is too large: make it smaller", start)
    return sign * value


def read_assignment(cursor: Cursor, parameters: Parameters) -> tuple[Key, float]:
    """Read ``#1 = 2`` or ``#<name> = 2`` after the #; the caller assigns it at the end of the line."""
    column, key = cursor.column, _key(cursor, parameters)
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
    refuse(len(digits) > 100, BlockError, "CL805 the number has more than 100 digits: shorten it", column)
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
        column, name = cursor.column, cursor.take(_OPERATION)
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


LARGEST_NUMBER = 1e9
"""Larger numbers are mistakes in any unit."""

# Matches any line: words, comments in brackets or to the end, blanks, bad characters.
_TOKEN = re.compile(r"([A-Za-z@^])[ \t]*(?P<digits>[+-]?[0-9. \t]*)|\([^()]*\)|;.*|[ \t]+|(?P<bad>.)", re.DOTALL)
_LETTERS = frozenset("ABCDEFGHIJKLMNOPQRSTUVWXYZ@^")
_LONGEST_NUMBER = 100
_MORE_THAN_NUMBERS = re.compile(r"[#\[]|[+-][ \t]*[+-]")

_BAD = {
    "]": "']' has no matching '[': delete it, or write '[' where the expression starts",
    "=": "'=' has no parameter before it: write for example #1 = 2",
    "<": "'<' is only allowed in a named parameter and in O<name>: write # before it, as in #<depth>",
    ">": "'>' is only allowed in a named parameter and in O<name>: write #< before the name, as in #<depth>",
    "/": "'/' is block delete at the start of a line and division inside [ ]: move it or delete it",
    "%": "% is only allowed alone on the first and on the last line: delete it here",
    "*": "'*' has no meaning here: delete it; RS274/NGC has no checksums",
    ")": "')' has no matching '(': delete it, or write '(' where the comment starts",
    ",": "',' has no meaning here: write the decimal point as '.' and put a space between words",
}


class Word(NamedTuple):
    """A letter and its number.

    Parameters
    ----------
    letter : str
        One capital letter, or @ or ^.
    value : float
        Finite.
    column : int, >= 1
        Of the letter.
    """

    letter: str
    value: float
    column: int

    def whole(self, least: int, most: int, what: str, tolerance: float = 1e-4) -> int:
        """Return the value as a whole number; refuse other values, and numbers out of bounds."""
        number = round(self.value)
        if abs(self.value - number) > tolerance or not least <= number <= most:
            raise BlockError(f"CL806 {self.letter}{self.value:g}: {what} must be a whole number from {least} to {most}", self.column)
        return number


def read_words(line: str, parameters: Parameters | None = None) -> list[Word]:
    """Split a line into words, without comments, and assign its parameters.

    Parameters
    ----------
    line : str
        Without its line break.
    parameters : Parameters, optional
        Expressions use the values before the line; assignments take effect at its end.

    Raises
    ------
    BlockError
        If a character or number is not part of RS274/NGC, or not supported.

    >>> read_words("g1 x-1 0.5 (there)")
    [Word(letter='G', value=1.0, column=1), Word(letter='X', value=-10.5, column=4)]
    >>> read_words("x[2 * [3 + 4]]")
    [Word(letter='X', value=14.0, column=1)]
    """
    if _MORE_THAN_NUMBERS.search(line):
        return _words_and_values(line, parameters or Parameters())
    words = []
    for token in _TOKEN.finditer(line):
        letter = token[1]
        if letter is not None:
            words.append(Word(letter.upper(), _plain_number(token), token.start() + 1))
        elif token["bad"] is not None:
            raise _bad_character(line, token.start())
    return words


def _words_and_values(line: str, parameters: Parameters) -> list[Word]:
    """Read a line with parameters or expressions."""
    cursor = Cursor(*without_blanks(line))
    words: list[Word] = []
    settings: list[tuple[Key, float]] = []
    while cursor.next:
        letter, column = cursor.next.upper(), cursor.column
        if letter == "#":
            cursor.at += 1
            settings.append(read_assignment(cursor, parameters))
        elif letter in _LETTERS:
            cursor.at += 1
            refuse(letter == "O", BlockError, O_WORD_ALONE, column)
            if letter == "N" and not cursor.next.isdigit():
                raise BlockError("CL804 a line number must be digits only: write for example N10", column)
            value = read_value(cursor, parameters)
            if abs(value) > LARGEST_NUMBER:
                raise BlockError(f"CL805 {letter}{value:g} is too large: keep it below {LARGEST_NUMBER:.0e}", column)
            words.append(Word(letter, value, column))
        else:
            raise _bad_character(line, column - 1)
    for key, value in settings:
        parameters.write(key, value)
    return words


@lru_cache(1024)  # loops and subprograms read the same lines again and again
def without_blanks(line: str) -> tuple[str, list[int]]:
    """Return a line in lower case, without blanks and comments, and the column (from 1) of each character, as `Cursor` takes them."""
    kept: list[int] = []
    at = 0
    while at < len(line) and line[at] != ";":
        if line[at] == "(":
            end = line.find(")", at)
            if end < 0 or "(" in line[at + 1 : end]:
                raise _bad_character(line, at)
            at = end
        elif line[at] not in " \t":
            kept.append(at)
        at += 1
    return "".join(line[i] for i in kept).lower(), [i + 1 for i in kept]


def _plain_number(token: re.Match[str]) -> float:
    digits = token["digits"]
    try:
        value = float(digits)
    except ValueError:
        return _odd_number(token)
    return value if abs(value) <= LARGEST_NUMBER and len(digits) <= _LONGEST_NUMBER else _odd_number(token)


def _odd_number(token: re.Match[str]) -> float:
    """Return a number with blanks between its digits; refuse what is no number, or too large."""
    name, digits, column = token[1].upper(), "".join(token["digits"].split()), token.start() + 1
    short = digits if len(digits) <= 20 else digits[:20] + "..."
    try:
        value = float(digits)
    except ValueError:
        if not digits:
            raise BlockError(f"CL803 {name} has no number: write for example {name}10", column) from None
        hint = f"write for example {name}10.5 (one sign, one point, no exponent)"
        raise BlockError(f"CL803 {name}{short} is not a number: {hint}", column) from None
    if abs(value) > LARGEST_NUMBER or len(digits) > _LONGEST_NUMBER:
        raise BlockError(
            f"CL805 {name}{short} is too large or too long: keep it below {LARGEST_NUMBER:.0e}, in at most {_LONGEST_NUMBER} characters",
            column,
        )
    return value


def _bad_character(line: str, at: int) -> BlockError:
    """Return the error about the character at index `at`."""
    character = line[at]
    if character == "(":
        nested = line.find("(", at + 1)
        if nested >= 0 and line.find(")", at + 1) >= 0:
            return BlockError(
                "CL802 a comment cannot contain another one: use one pair of brackets, or ';' for the rest of the line", nested + 1
            )
        return BlockError("CL802 the comment that starts here has no end: write ')' on the same line", at + 1)
    if line.strip() == "%":
        return EndMarkError(
            "CL847 % closes the program, but the first line has no % to open it: write % there too, or delete this one", at + 1
        )
    return BlockError("CL801 " + _BAD.get(character, f"the character {character!r} has no meaning here: delete it"), at + 1)


_END_OF_MOTION = 800


class Code(NamedTuple):
    """A G-code (its number times ten) or an M-code (its number), and its column."""

    number: int
    column: int


class Block(NamedTuple):
    """The content of one line.

    Parameters
    ----------
    codes : dict
        Modal group -> its code.
    words : dict
        Letter -> its word, without G, M and N.
    """

    codes: dict[str, Code]
    words: dict[str, Word]

    @property
    def column(self) -> int:
        """Column of the motion code, else of the first word; 0 if there is neither."""
        first = self.codes.get("motion") or next(iter(self.words.values()), None)
        return first.column if first else 0


def read_block(line: str, parameters: Parameters | None = None, rules: Rules = LINUXCNC) -> Block:
    """Read a line, check it independently of the modal state, and assign its parameters.

    Raises
    ------
    BlockError
        If a word is unknown, not supported yet or repeated, or two codes share a modal group.
    """
    codes: dict[str, Code] = {}
    words: dict[str, Word] = {}
    for word in read_words(line, parameters):
        letter = word.letter
        if letter in rules.letters:
            if letter in words:
                raise BlockError(f"CL809 the block has two {letter} words: keep one of them", word.column)
            words[letter] = word
        elif letter == "G":
            _add_g(codes, word, rules)
        elif letter == "M":
            _add_m(codes, word, rules)
        elif letter == "N":
            # N must come first, even before a comment; its number has no meaning.
            if line[: word.column - 1].strip(" \t"):
                raise BlockError("CL804 the line number N must come first on its line: move it there, or delete it", word.column)
            if word.value < 0.0:
                raise BlockError("CL804 a line number cannot have a sign: write for example N10", word.column)
        else:
            raise BlockError(_refusal(letter, "word", rules), word.column)
    return Block(codes, words)


def _refusal(name: str, kind: str, rules: Rules) -> str:
    return refusal(name, kind, "" if rules is LINUXCNC else rules.title, rules.meanings)


def _add_g(codes: dict[str, Code], word: Word, rules: Rules) -> None:
    number = round(10.0 * word.value)
    if word.value < 0.0 or abs(10.0 * word.value - number) > 1e-9:
        raise BlockError(f"CL807 G{word.value:g} is not a known G-code: correct the number", word.column)
    group = rules.g.get(number)
    if group is None:
        raise BlockError(_refusal(g_name(number), "G-code", rules), word.column)
    if group in codes and group not in rules.last_counts:
        # G80 together with another motion has no effect.
        ends = group == "motion" and not rules.lone_g80
        if ends and number == _END_OF_MOTION:
            return
        if not ends or codes[group].number != _END_OF_MOTION:
            names = f"{g_name(codes[group].number)} and {g_name(number)}"
            raise BlockError(f"CL810 {names} cannot share a block: keep one of them", word.column)
    codes[group] = Code(number, word.column)


def _add_m(codes: dict[str, Code], word: Word, rules: Rules) -> None:
    number = round(word.value)
    if word.value != number or number < 0:
        raise BlockError(f"CL807 M{word.value:g} is not a known M-code: write a whole number, 0 or more", word.column)
    group = rules.m.get(number)
    if group is None:
        raise BlockError(_refusal(f"M{number}", "M-code", rules), word.column)
    if group in codes:
        raise BlockError(f"CL810 M{codes[group].number} and M{number} cannot share a block: keep one of them", word.column)
    codes[group] = Code(number, word.column)
