"""O-words: subprograms, conditions and loops; M98 and M99.

A loop or condition that is not executed is skipped up to the closing line with the same label: a number, a name in <>, or an expression
in []. Lines are kept only while a loop or call may return to them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from contourlab.errors import ProgramError
from contourlab.program.block import without_blanks
from contourlab.program.expressions import NUMBER, Cursor, Parameters, read_value
from contourlab.program.vocabulary import BlockError

KEYWORDS = (
    "elseif", "else", "endif", "endsub", "endwhile", "endrepeat", "sub", "call", "return", "do", "while", "if", "break", "continue",
    "repeat",
)  # fmt: skip
_KEYWORD = re.compile("|".join(KEYWORDS))
_O_LINE = re.compile(r"[ \t]*(?:/[ \t]*)?(?:[nN][ \t0-9.]*)?[oO]")
_COMMENT_INSIDE = re.compile(r"[^;(]*(?:\([^)]*\)[ \t]*)+[^;(\s]")
_DIGITS = re.compile(r"[0-9]+")
_CONDITIONS = ("if", "elseif", "while", "repeat")
_VALUES = ("return", "endsub")
MOST_ARGUMENTS = 30
LONGEST_LINE = 100_000
"""Most characters of a line."""
BATCH = 1024
"""Least number of lines to drop at once."""


class OWord(NamedTuple):
    """An O-word.

    Parameters
    ----------
    label : str
        Number without leading zeros, or name in lower case.
    keyword : str
        One of `KEYWORDS`; empty for ``O100`` alone, a subprogram of M98.
    values : tuple of float
        Arguments of a call; the condition, number of repeats, or returned value.
    """

    label: str
    keyword: str
    values: tuple[float, ...]
    column: int


def starts_o_word(line: str) -> bool:
    """Return whether a line holds an O-word."""
    return _O_LINE.match(line) is not None


def read_o_word(line: str, parameters: Parameters, *, skipping: bool = False) -> OWord:
    """Read a line with an O-word.

    Parameters
    ----------
    skipping : bool
        Whether to read only label and keyword, because conditions on skipped lines may be undefined.

    Raises
    ------
    BlockError
        If the line is no O-word, or an expression has no value.
    """
    cursor = without_blanks(line)
    if cursor.next == "/":
        cursor.at += 1
    if cursor.next == "n":
        cursor.at += 1
        cursor.take(NUMBER)
    column = cursor.column
    cursor.at += 1  # the O
    label = _label(cursor, parameters)
    keyword = cursor.take(_KEYWORD)
    if not keyword and cursor.next:
        raise BlockError(f"O{label} needs a keyword: write one of {', '.join(KEYWORDS)}", cursor.column)
    if skipping:
        return OWord(label, keyword, (), column)
    if _COMMENT_INSIDE.match(line):
        raise BlockError("a comment cannot stand inside an O-word: move it to the end of the line", line.index("(") + 1)
    values = []
    while cursor.next == "[":
        values.append(read_value(cursor, parameters))
    if cursor.next:
        raise BlockError(f"'{cursor.next}' cannot follow an O-word: write it on its own line", cursor.column)
    _check_values(keyword, len(values), column)
    return OWord(label, keyword, tuple(values), column)


def _check_values(keyword: str, count: int, column: int) -> None:
    if keyword in _CONDITIONS and count != 1:
        raise BlockError(f"{keyword} takes one expression: write it in brackets, as in [#1 LT 5]", column)
    if keyword in _VALUES and count > 1:
        raise BlockError(f"{keyword} takes at most one value in brackets: delete the others", column)
    if keyword == "call" and count > MOST_ARGUMENTS:
        raise BlockError(f"a call takes at most {MOST_ARGUMENTS} arguments: pass the rest in #31 and up", column)
    if keyword not in (*_CONDITIONS, *_VALUES, "call") and count:
        raise BlockError(f"{keyword or 'O'} takes no value: delete the brackets", column)


def _label(cursor: Cursor, parameters: Parameters) -> str:
    if cursor.next == "<":
        return cursor.name("O-word")
    column, digits = cursor.column, cursor.take(_DIGITS)
    if digits:
        if len(digits) > 9:
            raise BlockError("the number of an O-word has at most 9 digits: shorten it", column)
        return str(int(digits))
    value = read_value(cursor, parameters)
    if abs(value - round(value)) > 1e-4 or not 0 <= value <= 1e9:
        raise BlockError(f"the label of an O-word must be a whole number: correct {value:g}", column)
    return str(round(value))


class Tape:
    """The lines of a file, kept from the first line that a loop or call may return to.

    Parameters
    ----------
    name : str
        The file's name, for errors.
    """

    def __init__(self, lines: Iterator[str], name: str) -> None:
        self._lines, self.name = lines, name
        self._kept: list[str] = []
        self._first = 0
        self._pinned: int | None = None
        self.ended = False

    @classmethod
    def of(cls, lines: list[str], first: int, name: str) -> Tape:
        """Return a tape that keeps all its lines; the first line has the index `first`."""
        tape = cls(iter(()), name)
        tape._kept, tape._first, tape._pinned, tape.ended = lines, first, first, True
        return tape

    def line(self, index: int) -> str | None:
        """Return a line by its index from 0; None after the end; raise ProgramError for a line longer than `LONGEST_LINE`."""
        while index >= self._first + len(self._kept):
            following = None if self.ended else next(self._lines, None)
            if following is None:
                self.ended = True
                return None
            if len(following) > LONGEST_LINE:
                fault = f"the line has more than {LONGEST_LINE} characters: divide it"
                raise ProgramError(fault, file=self.name, line=self._first + len(self._kept) + 1, column=LONGEST_LINE + 1)
            self._kept.append(following)
        return self._kept[index - self._first]

    def pin(self, index: int) -> None:
        """Keep the lines from an index on permanently."""
        self._pinned = index if self._pinned is None else min(self._pinned, index)

    def forget(self, before: int) -> None:
        """Drop the lines before an index that are not pinned."""
        stop = before if self._pinned is None else min(before, self._pinned)
        # In batches, because dropping the first item of a list moves all others.
        if stop - self._first >= BATCH:
            del self._kept[: stop - self._first]
            self._first = stop

    def __len__(self) -> int:
        """Number of kept lines."""
        return len(self._kept)
