"""Read a line of a part program into words with columns, then into a block: codes by modal group, other words by letter.

RS274/NGC ignores case, and blanks and tabs outside comments, even inside a number.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from contourlab.program.expressions import Cursor, Key, Parameters, read_assignment, read_value
from contourlab.program.vocabulary import G_GROUPS, M_GROUPS, O_WORD_ALONE, USED_LETTERS, BlockError, EndMarkError, g_name, refusal

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
            words.append(Word(letter.upper(), _number(token), token.start() + 1))
        elif token["bad"] is not None:
            raise _bad_character(line, token.start())
    return words


def _words_and_values(line: str, parameters: Parameters) -> list[Word]:
    """Read a line with parameters or expressions."""
    cursor = without_blanks(line)
    words: list[Word] = []
    settings: list[tuple[Key, float]] = []
    while cursor.next:
        letter, column = cursor.next.upper(), cursor.column
        if letter == "#":
            cursor.at += 1
            settings.append(read_assignment(cursor, parameters))
        elif letter in _LETTERS:
            cursor.at += 1
            if letter == "O":
                raise BlockError(O_WORD_ALONE, column)
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


def without_blanks(line: str) -> Cursor:
    """Return a cursor over a line in lower case, without blanks and comments."""
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
    return Cursor("".join(line[i] for i in kept).lower(), [i + 1 for i in kept])


def _number(token: re.Match[str]) -> float:
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


def read_block(line: str, parameters: Parameters | None = None) -> Block:
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
        if letter in USED_LETTERS:
            if letter in words:
                raise BlockError(f"CL809 the block has two {letter} words: keep one of them", word.column)
            words[letter] = word
        elif letter == "G":
            _add_g(codes, word)
        elif letter == "M":
            _add_m(codes, word)
        elif letter == "N":
            # N must come first, even before a comment; its number has no meaning.
            if line[: word.column - 1].strip(" \t"):
                raise BlockError("CL804 the line number N must come first on its line: move it there, or delete it", word.column)
            if word.value < 0.0:
                raise BlockError("CL804 a line number cannot have a sign: write for example N10", word.column)
        else:
            raise BlockError(refusal(letter, "word"), word.column)
    return Block(codes, words)


def _add_g(codes: dict[str, Code], word: Word) -> None:
    number = round(10.0 * word.value)
    if word.value < 0.0 or abs(10.0 * word.value - number) > 1e-9:
        raise BlockError(f"CL807 G{word.value:g} is not a known G-code: correct the number", word.column)
    group = G_GROUPS.get(number)
    if group is None:
        raise BlockError(refusal(g_name(number), "G-code"), word.column)
    # G80 together with another motion has no effect.
    if group == "motion" and group in codes and number == _END_OF_MOTION:
        return
    if group in codes and (group != "motion" or codes[group].number != _END_OF_MOTION):
        raise BlockError(f"CL810 {g_name(codes[group].number)} and {g_name(number)} cannot share a block: keep one of them", word.column)
    codes[group] = Code(number, word.column)


def _add_m(codes: dict[str, Code], word: Word) -> None:
    number = round(word.value)
    if word.value != number or number < 0:
        raise BlockError(f"CL807 M{word.value:g} is not a known M-code: write a whole number, 0 or more", word.column)
    group = M_GROUPS.get(number)
    if group is None:
        raise BlockError(refusal(f"M{number}", "M-code"), word.column)
    if group in codes:
        raise BlockError(f"CL810 M{codes[group].number} and M{number} cannot share a block: keep one of them", word.column)
    codes[group] = Code(number, word.column)
