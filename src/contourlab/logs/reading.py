"""Text of a log, and numbers out of it, with the line named where it is wrong."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import LogError

__all__ = ["head_of", "name_and_unit", "number", "numbers", "text_of"]

Array = NDArray[np.float64]
HEAD = 1 << 16
"""Bytes of a file that its format is told from."""
_UNIT = re.compile(r"\s*(?P<name>.*?)\s*[\[(]\s*(?P<unit>[^\])]*?)\s*[\])]\s*\Z")
_EMPTY = frozenset(("", "nan", "-nan", "na", "n/a", "null", "none", "#n/a", "-"))


def head_of(file: Path) -> bytes:
    """Return the first bytes of a file.

    Raises
    ------
    LogError
        If it cannot be read, or is empty.
    """
    try:
        with file.open("rb") as stream:
            head = stream.read(HEAD)
    except OSError as error:
        raise LogError(f"cannot be read: {error.strerror or error}", file=file) from error
    if not head.strip():
        raise LogError("is empty", file=file)
    return head


def text_of(file: Path) -> str:
    """Return the text of a file: UTF-8 with or without a mark, UTF-16 with one, else Latin-1 as older controls write it."""
    try:
        data = file.read_bytes()
    except OSError as error:
        raise LogError(f"cannot be read: {error.strerror or error}", file=file) from error
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return data.decode("utf-16", errors="replace")
    if b"\0" in data[:HEAD]:
        raise LogError("is no text: say what it is with --format", file=file)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("latin-1")


def name_and_unit(text: str) -> tuple[str, str]:
    """Split ``"x [mm]"`` or ``"x (mm)"`` into name and unit; a name without one has the unit ``""``.

    >>> name_and_unit("Encoder X [mm]")
    ('Encoder X', 'mm')
    """
    found = _UNIT.match(text)
    return (found["name"], found["unit"]) if found and found["name"] else (text.strip(), "")


def number(text: str, comma: bool = False) -> float:
    """Return a number; not a number for what stands where there is no value. Raises ValueError for anything else."""
    word = text.strip().strip('"').strip()
    if word.casefold() in _EMPTY:
        return math.nan
    return float(word.replace(".", "").replace(",", ".") if comma and "," in word else word)


def numbers(rows: Sequence[tuple[int, Sequence[str]]], width: int, file: Path, comma: bool = False) -> Array:
    """Return the numbers (n_row, width) of rows of cells, each with the number of its line.

    Raises
    ------
    LogError
        If a row has another number of cells, or a cell is no number; names line and column.
    """
    found = np.empty((len(rows), width))
    for i, (line, cells) in enumerate(rows):
        if len(cells) != width:
            raise LogError(f"has {len(cells)} columns where {width} are wanted", file=file, line=line)
        try:
            found[i] = [number(cell, comma) for cell in cells]
        except ValueError:
            j = next(j for j, cell in enumerate(cells) if not _is_number(cell, comma))
            raise LogError(f"{cells[j].strip()!r} in column {j + 1} is no number", file=file, line=line) from None
    return found


def _is_number(cell: str, comma: bool) -> bool:
    try:
        number(cell, comma)
    except ValueError:
        return False
    return True
