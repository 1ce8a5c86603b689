"""Write the lines that loops and calls execute in their place, with numbers for parameters and expressions."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np

from contourlab.program import Reader
from contourlab.program.block import Block
from contourlab.program.expressions import Key
from contourlab.program.vocabulary import G_GROUPS

COMMENT = re.compile(r"\([^()]*\)|;.*")
_COMPUTED = re.compile(r"[#\[]|M\s*0*9[89](?!\d)", re.IGNORECASE)
_NUMBER = re.compile(r"^\s*N\s*[0-9.]+\s*", re.IGNORECASE)
_FIRST_OF_INTERPRETER = 5000
"""From here on, parameters hold what executed codes set: offsets, positions, tools."""


@dataclass(eq=False)
class Region:
    """An outermost loop or call, with what it executes.

    Attributes
    ----------
    first, last : int
        Its lines in the program, from 1.
    call : str
        The other words of its first line, such as M8 beside M98.
    text : list of str
        Executed lines, then the parameters that they changed.
    corrected : bool
        Whether a move inside could be corrected, if it stood in the program itself.
    """

    first: int
    last: int
    call: str = ""
    text: list[str] = field(default_factory=list)
    corrected: bool = False


class Regions:
    """The loops and calls of a program that is being read."""

    def __init__(self, reader: Reader) -> None:
        self.found: list[Region] = []
        self._reader, self._call, self._before = reader, "", dict[Key, float]()
        reader.on_block, reader.walker.on_region = self._read, self._turned

    def _read(self, line: str, block: Block) -> None:
        text = executed(line, block)
        if not self._reader.walker.repeating:
            self._call = text if "call" in block.codes else ""
        elif text:
            self.found[-1].text.append(text)

    def _turned(self, begins: bool, line: int) -> None:
        values = self._reader.parameters.outermost()
        if begins:
            self.found.append(Region(line, line, self._call))
            self._before = values
        else:
            self.found[-1].last = line
            changed = {key: value for key, value in values.items() if self._before.get(key) != value}
            self.found[-1].text += [
                f"#<{key}> = {_number(value)}" if isinstance(key, str) else f"#{key} = {_number(value)}"
                for key, value in changed.items()
                if isinstance(key, str) or key < _FIRST_OF_INTERPRETER
            ]
        self._call = ""


def executed(line: str, block: Block) -> str:
    """Return a line as it was executed: without line number, call, return and assignments, with numbers for its expressions.

    >>> from contourlab.program.block import read_block
    >>> line = "N5 g1 X[1/4] #3=2 F200 (edge)"
    >>> executed(line, read_block(line))
    'G1 X0.25 F200 (edge)'
    """
    if not _COMPUTED.search(COMMENT.sub("", line)):
        return _NUMBER.sub("", line).strip()
    calls, ends = "call" in block.codes, "stop" in block.codes and block.codes["stop"].number == 99
    words = [f"G{code.number / 10:g}" for group, code in block.codes.items() if G_GROUPS.get(code.number) == group]
    words += [f"{word.letter}{_number(word.value)}" for word in block.words.values() if not (calls and word.letter in "PL")]
    words += [
        f"M{code.number}"
        for group, code in block.codes.items()
        if G_GROUPS.get(code.number) != group and group != "call" and not (ends and group == "stop")
    ]
    skipped = ["/"] if words and line.lstrip().startswith("/") else []
    return " ".join([*skipped, *words, *(comment for comment in COMMENT.findall(line) if "#" not in comment)])


def _number(value: float) -> str:
    return np.format_float_positional(value, trim="-")


def unrolled(lines: list[str], regions: list[Region]) -> tuple[list[str], list[int]]:
    """Return a program with its corrected regions unrolled, and the original number of each line."""
    written, numbers, at = list[str](), list[int](), 1
    for region in [*(one for one in regions if one.corrected), Region(len(lines) + 1, len(lines) + 1)]:
        written += lines[at - 1 : region.first - 1]
        numbers += range(at, region.first)
        if region.corrected:
            head = COMMENT.sub("", lines[region.first - 1]).strip()
            text = [*([region.call] if region.call else []), f"({head}: unrolled)", *region.text, f"(end of {head})"]
            written += text
            numbers += [region.first] * len(text)
        at = region.last + 1
    return written, numbers
