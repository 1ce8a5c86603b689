"""Text of a log, and numbers out of it, with the line named where it is wrong."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import LogError, UnitError
from contourlab.units import same_dimension

Array = NDArray[np.float64]
HEAD = 1 << 16
"""Bytes of a file that identify its format."""
UTF_16 = (b"\xff\xfe", b"\xfe\xff")
"""Marks that text in UTF-16 begins with."""
CUT = "the last line is cut short and left out"
"""Note on a file whose writing was interrupted."""
SHOWN = 40
"""Characters of a faulty cell that a message shows."""
_UNIT = re.compile(r"\s*(?P<name>.*?)\s*[\[(]\s*(?P<unit>[^\])]*?)\s*[\])]\s*\Z")
_NO_UNIT = re.compile(r".*,|\d+\s+[A-Za-z]|.*[A-Za-z]\s+\d+\Z|[XYZxyz]\Z")
"""Text in brackets that is no unit: ``(64 bit)``, ``[u1, 1]``, ``PosFbk (X)``."""
_EMPTY = frozenset(("", "nan", "-nan", "na", "n/a", "null", "none", "#n/a", "-"))
_BITS = {"true": 1.0, "false": 0.0}


def head_of(file: Path) -> bytes:
    """Return the first bytes of a file; those of UTF-16 with a mark in UTF-8.

    Raises
    ------
    LogError
        If it cannot be read, is no plain file, or is empty.
    """
    if file.exists() and not file.is_file():
        raise LogError("is no plain file, which can be read more than once: write it to one", file=file)
    try:
        with file.open("rb") as stream:
            head = stream.read(HEAD)
    except OSError as error:
        raise LogError(f"cannot be read: {error.strerror or error}", file=file) from error
    if not head.strip():
        raise LogError("is empty", file=file)
    return head.decode("utf-16", errors="ignore").encode() if head[:2] in UTF_16 else head


def text_of(file: Path) -> str:
    """Return the text of a file: UTF-8 with or without a mark, UTF-16 with one, else Latin-1 as older controls write it."""
    try:
        data = file.read_bytes()
    except OSError as error:
        raise LogError(f"cannot be read: {error.strerror or error}", file=file) from error
    if data[:2] in UTF_16:
        return data.decode("utf-16", errors="replace")
    if b"\0" in data[:HEAD]:
        raise LogError("is no text: say what it is with --format", file=file)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("latin-1")


def lines_of(file: Path) -> tuple[list[tuple[int, str]], tuple[str, ...]]:
    """Return the lines of text that a program wrote, each with its number, but for blank ones; and what there is to say of them.

    The program ends each line: a last one without an end is what was being written when the power or the disk was gone, and is left out.
    """
    text = text_of(file)
    lines = [(i, line) for i, line in enumerate(text.splitlines(), 1) if line.strip()]
    if not lines or text.endswith(("\n", "\r")):
        return lines, ()
    return lines[:-1], (CUT,)


def cells_of(line: str, mark: str) -> list[str]:
    """Return the cells of a line, without the quotes around them."""
    if '"' not in line:
        return line.split(mark)
    try:
        return next(csv.reader([line], delimiter=mark))
    except csv.Error:  # a quote that is never closed
        return line.split(mark)


def name_and_unit(text: str) -> tuple[str, str]:
    """Split ``"x [mm]"`` or ``"x (mm)"`` into name and unit; a name without one has the unit ``""``.

    >>> name_and_unit("Encoder X [mm]"), name_and_unit("Setpoint (64 bit)")
    (('Encoder X', 'mm'), ('Setpoint (64 bit)', ''))
    """
    found = _UNIT.match(text)
    return (found["name"], found["unit"]) if found and found["name"] and not _NO_UNIT.match(found["unit"]) else (text.strip(), "")


def is_unit(text: str) -> bool:
    """Tell whether a text is a unit that is known.

    >>> is_unit("mm/min"), is_unit("posn")
    (True, False)
    """
    try:
        return same_dimension(text, text)
    except UnitError:
        return False


def is_empty(cell: str) -> bool:
    """Tell whether a cell holds no value."""
    return _bare(cell) in _EMPTY


def _bare(cell: str) -> str:
    return cell.strip().strip('"').strip().casefold()


def number(text: str, comma: bool = False) -> float:
    """Return a number; 1 and 0 for true and false, NaN for no value. Raise ValueError for anything else."""
    word = _bare(text)
    if word in _EMPTY:
        return math.nan
    if word in _BITS:
        return _BITS[word]
    if "_" in word or (comma and word.rfind(".") > word.rfind(",") >= 0):
        raise ValueError(f"{word} is no number, or one with commas between thousands")
    return float(word.replace(".", "").replace(",", ".") if comma and "," in word else word)


def numbers(rows: Sequence[tuple[int, Sequence[str]]], names: Sequence[str], file: Path, comma: bool = False) -> Array:
    """Return the numbers (n_row, n_column) of rows of cells, each with the number of its line, under the names of their columns.

    Raises
    ------
    LogError
        If a row has another number of cells, or a cell is no number; names line and column.
    """
    width = len(names)
    found = np.empty((len(rows), width))
    for i, (line, cells) in enumerate(rows):
        if len(cells) != width:
            raise LogError(f"has {len(cells)} columns where {width} are wanted", file=file, line=line)
        try:
            found[i] = [float(cell.replace("_", "no digit")) for cell in cells]  # plain numbers, the quicker way
        except ValueError:
            found[i] = [cell_number(cell, name, file, line, comma) for cell, name in zip(cells, names, strict=True)]
    return found


def cell_number(cell: str, name: str, file: Path, line: int, comma: bool) -> float:
    """Return the number in a cell; raise LogError with column and line if it holds none."""
    try:
        return number(cell, comma)
    except ValueError:
        raise LogError(f"{shown(cell)} in {called(name)} is no number", file=file, line=line) from None


def called(name: str) -> str:
    """Return a column as it stands in a message: by its name, or its number where it has none.

    >>> called("x pos"), called("2")
    ("column 'x pos'", 'column 2')
    """
    return f"column {name}" if name.isdigit() else f"column {name!r}"


def shown(cell: str) -> str:
    """Return a cell as it stands in a message: in quotes, and not too long."""
    word = cell.strip()
    return repr(word if len(word) <= SHOWN else f"{word[:SHOWN]}...")
