"""One line -> a block: its codes sorted by modal group, its other words by letter; nothing is executed yet."""

from __future__ import annotations

from typing import NamedTuple

from contourlab.program.fault import BlockError
from contourlab.program.lexer import Word, read_words
from contourlab.program.parameters import Parameters
from contourlab.program.vocabulary import (
    G_GROUPS,
    M_GROUPS,
    USED_LETTERS,
    g_name,
    refuse_g,
    refuse_letter,
    refuse_m,
)

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
        Modal group -> the one code of it.
    words : dict
        Letter -> the one word of it; G, M and N are not among them.
    """

    codes: dict[str, Code]
    words: dict[str, Word]


def read_block(line: str, parameters: Parameters | None = None) -> Block:
    """Read a line and check what can be checked without knowing the machine's state; set the parameters that it sets.

    Raises
    ------
    BlockError
        On words that are unknown, not supported yet, doubled, or two codes of one modal group.
    """
    codes: dict[str, Code] = {}
    words: dict[str, Word] = {}
    for word in read_words(line, parameters):
        letter = word.letter
        if letter in USED_LETTERS:
            if letter in words:
                raise BlockError(f"two {letter} words in one block: keep one of them", word.column)
            words[letter] = word
        elif letter == "G":
            _add_g(codes, word)
        elif letter == "M":
            _add_m(codes, word)
        elif letter == "N":
            _check_line_number(line, word)
        else:
            raise BlockError(refuse_letter(letter), word.column)
    return Block(codes, words)


def _add_g(codes: dict[str, Code], word: Word) -> None:
    number = round(10.0 * word.value)
    if word.value < 0.0 or abs(10.0 * word.value - number) > 1e-9:
        raise BlockError(f"G{word.value:g} is no G-code of RS274/NGC: correct the number", word.column)
    group = G_GROUPS.get(number)
    if group is None:
        raise BlockError(refuse_g(number), word.column)
    if group in codes and group == "motion" and _END_OF_MOTION in (number, codes[group].number):
        # G80 beside another motion has no effect.
        if number == _END_OF_MOTION:
            return
    elif group in codes:
        raise BlockError(
            f"{g_name(codes[group].number)} and {g_name(number)} exclude each other in one block: keep one of them",
            word.column,
        )
    codes[group] = Code(number, word.column)


def _add_m(codes: dict[str, Code], word: Word) -> None:
    number = round(word.value)
    if word.value != number or number < 0:
        raise BlockError(f"M{word.value:g} is no M-code of RS274/NGC: M takes a whole number from 0", word.column)
    group = M_GROUPS.get(number)
    if group is None:
        raise BlockError(refuse_m(number), word.column)
    if group in codes:
        raise BlockError(f"M{codes[group].number} and M{number} exclude each other in one block: keep one", word.column)
    codes[group] = Code(number, word.column)


def _check_line_number(line: str, word: Word) -> None:
    # N stands first, even before a comment; its number means nothing.
    if line[: word.column - 1].strip(" \t"):
        raise BlockError("the line number N must stand first on its line: move it there or delete it", word.column)
    if word.value < 0.0:
        raise BlockError("a line number has no sign: write for example N10", word.column)
