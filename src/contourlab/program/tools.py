"""The tools of a program: their lengths, from a LinuxCNC tool table, from G10, or zero."""

from __future__ import annotations

import re
from pathlib import Path

from contourlab.errors import ProgramError
from contourlab.program.fault import BlockError
from contourlab.program.moves import Point

LARGEST_TOOL = 99_999
_ENTRY = re.compile(r"([A-Za-z])\s*([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+))")
_LENGTHS = "XYZ"
_LETTERS = frozenset("TPDXYZABCUVWIJQ")


class Tools:
    """Offsets of the tools by their numbers; a tool that nobody has described has none.

    Parameters
    ----------
    offsets : dict of int to (x, y, z) [m], optional
    diameters : dict of int to float [m], optional

    Attributes
    ----------
    current, selected : int
        The tool in the spindle, and the one that the next change brings; 0 for none.
    complete : bool
        Whether a table says which tools there are.
    """

    def __init__(self, offsets: dict[int, Point] | None = None, diameters: dict[int, float] | None = None) -> None:
        self.offsets, self.diameters = dict(offsets or {}), dict(diameters or {})
        self.current, self.selected = 0, 0
        self.complete = False

    def check(self, number: int, column: int) -> None:
        """Refuse a tool that a table was to describe and does not; 0 is no tool.

        Raises
        ------
        BlockError
            If it is not there.
        """
        if self.complete and number and number not in self.offsets:
            raise BlockError(f"tool {number} is not in the tool table: add it, or correct the number", column)

    def offset(self, number: int) -> Point:
        """Return the offset of a tool [m]."""
        return self.offsets.get(number, (0.0, 0.0, 0.0))


def read_tools(file: str | Path) -> Tools:
    """Read a LinuxCNC tool table: one tool on a line, as in ``T1 P1 D3.0 Z+25.4 ; end mill``; lengths in mm.

    Raises
    ------
    ProgramError
        If the file cannot be read, or a line is no tool.
    """
    try:
        text = Path(file).read_text(encoding="utf-8-sig", errors="replace")
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise ProgramError(f"the tool table cannot be read: {reason}", file=file) from error
    tools = Tools()
    tools.complete = True
    for number, line in enumerate(text.splitlines(), start=1):
        entry = line.split(";")[0].strip()
        if entry:
            _add(tools, entry, file, number)
    return tools


def _add(tools: Tools, entry: str, file: str | Path, line: int) -> None:
    if _ENTRY.sub("", entry).strip():
        cure = "write words such as T1 P1 D3.0 Z+25.4, and comments behind ';'"
        raise ProgramError(f"this is no line of a tool table: {cure}", file=file, line=line)
    words = {letter.upper(): float(value) for letter, value in _ENTRY.findall(entry)}
    unknown = words.keys() - _LETTERS
    if unknown:
        raise ProgramError(f"{min(unknown)} is no word of a tool table: there are {', '.join(sorted(_LETTERS))}", file=file, line=line)
    tool = words.get("T", 0.0)
    if tool != round(tool) or not 1 <= tool <= LARGEST_TOOL:
        raise ProgramError(f"a tool has a whole number from 1 to {LARGEST_TOOL}: write for example T1", file=file, line=line)
    if int(tool) in tools.offsets:
        raise ProgramError(f"tool {int(tool)} stands there twice: delete one of the lines", file=file, line=line)
    x, y, z = (words.get(letter, 0.0) / 1000.0 for letter in _LENGTHS)
    tools.offsets[int(tool)] = (x, y, z)
    tools.diameters[int(tool)] = words.get("D", 0.0) / 1000.0
