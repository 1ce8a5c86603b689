"""One line of a part program -> words with their columns.

RS274/NGC ignores blanks and tabs anywhere outside comments, even inside a number, and does not care for case.
The lexer knows no meaning: what a word does is the business of the block parser and the interpreter.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from contourlab.program.expressions import Cursor, read_assignment, read_value
from contourlab.program.fault import BlockError
from contourlab.program.parameters import Key, Parameters
from contourlab.program.vocabulary import O_WORD_ALONE

LARGEST_NUMBER = 1e9
"""No word of a part program means anything beyond this, in any unit: such a number is a slip."""

# The alternatives tile every line: a word, a comment in brackets, a comment to the end, blanks, or a bad character.
_TOKEN = re.compile(r"([A-Za-z@^])[ \t]*(?P<digits>[+-]?[0-9. \t]*)|\([^()]*\)|;.*|[ \t]+|(?P<bad>.)", re.DOTALL)
_LETTERS = frozenset("ABCDEFGHIJKLMNOPQRSTUVWXYZ@^")
_LONGEST_NUMBER = 100
_MORE_THAN_NUMBERS = re.compile(r"[#\[]|[+-][ \t]*[+-]")

_BAD = {
    "]": "']' closes no expression: delete it, or write '[' where the expression starts",
    "=": "'=' has no parameter before it: write #1 = 2, at the start of a line or between words",
    "<": "'<' belongs to a named parameter or to O<name> at the start of a line: write # before it, as in #<depth>",
    ">": "'>' belongs to a named parameter or to O<name> at the start of a line: write #< before the name, as in #<depth>",
    "/": "/ (block delete) stands first on its line, or divides within [ ]: move or delete it",
    "%": "% may only stand alone on the first line and on the last: delete it here",
    "*": "* has no meaning here: checksums of printers are not part of RS274/NGC, delete it",
    ")": "')' closes no comment: delete it, or write '(' where the comment starts",
    ",": "',' has no meaning here: write the decimal point as '.' and leave a blank between words",
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
        Where the letter stands in its line.
    """

    letter: str
    value: float
    column: int


def read_words(line: str, parameters: Parameters | None = None) -> list[Word]:
    """Split a line into its words, comments left out; set the parameters that it sets.

    Parameters
    ----------
    line : str
        Without its line break.
    parameters : Parameters, optional
        What expressions see. A line sees them as they were before it: what it sets, it sets at its end.

    Raises
    ------
    BlockError
        On a character or number that RS274/NGC does not know, or that is not supported yet.

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
            words.append(Word(letter.upper(), _number(line, token), token.start() + 1))
        elif token["bad"] is not None:
            raise _bad_character(line, token.start())
    return words


def _words_and_values(line: str, parameters: Parameters) -> list[Word]:
    """Read a line that holds more than plain numbers."""
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
                raise BlockError("a line number is written in digits: write for example N10", column)
            value = read_value(cursor, parameters)
            if abs(value) > LARGEST_NUMBER:
                raise BlockError(f"{letter}{value:g} is no sensible number: keep it below {LARGEST_NUMBER:.0e}", column)
            words.append(Word(letter, value, column))
        else:
            raise _bad_character(line, column - 1)
    for key, value in settings:
        parameters.write(key, value)
    return words


def without_blanks(line: str) -> Cursor:
    """Return a cursor over a line in small letters, without blanks and comments.

    Raises
    ------
    BlockError
        If a comment has no end, or stands in another.
    """
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


def _number(line: str, token: re.Match[str]) -> float:
    """Read the number of a word, which may have blanks anywhere."""
    name, digits, column = token[1].upper(), token["digits"], token.start() + 1
    try:
        value = float(digits)
    except ValueError:
        digits = digits.replace(" ", "").replace("\t", "")
        try:
            value = float(digits)
        except ValueError:
            raise _bad_number(line, token, digits) from None
    if abs(value) > LARGEST_NUMBER or len(digits) > _LONGEST_NUMBER:
        raise BlockError(f"{name}{_short(digits)} is no sensible number: keep it below {LARGEST_NUMBER:.0e}", column)
    return value


def _bad_number(line: str, token: re.Match[str], digits: str) -> BlockError:
    """Say why a word has no number."""
    name = token[1].upper()
    if digits:
        hint = f"write for example {name}10.5 (one sign, one point, no exponent)"
        return BlockError(f"{name}{_short(digits)} holds no number: {hint}", token.start() + 1)
    return BlockError(f"{name} has no number behind it: write for example {name}10", token.start() + 1)


def _short(digits: str) -> str:
    """Cut an endless number for a message."""
    compact = "".join(digits.split())
    return compact if len(compact) <= 20 else compact[:20] + "..."


def _bad_character(line: str, at: int) -> BlockError:
    """Say what is wrong with the character at index `at`."""
    character = line[at]
    if character == "(":
        nested = line.find("(", at + 1)
        if nested >= 0 and line.find(")", at + 1) >= 0:
            return BlockError("a comment inside a comment: use one pair of brackets, or only ';'", nested + 1)
        return BlockError("the comment that starts here has no end: write ')' on the same line", at + 1)
    if line.strip() == "%":
        return BlockError("a % that closes has none that opens: write % on the first line too, or delete it", at + 1)
    return BlockError(_BAD.get(character, f"the character {character!r} has no meaning here: delete it"), at + 1)
