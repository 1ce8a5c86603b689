"""Tables of numbers in text: a row for each sample, with or without a line of names and units."""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import LogError
from contourlab.logs.reading import name_and_unit, number, numbers, text_of
from contourlab.logs.record import Channel, Record

__all__ = ["matches", "read"]

Array = NDArray[np.float64]
MARKS = (";", "\t", ",")
_NUMBER = re.compile(r"[-+]?(\d+([.,]\d*)?|[.,]\d+)([eE][-+]?\d+)?\Z")


def matches(file: Path, head: bytes) -> bool:
    """Tell whether a file may be a table of numbers: text, one of whose first lines holds nothing else."""
    if b"\0" in head or file.suffix.lower() == ".xml":
        return False
    lines = head.decode("utf-8-sig", errors="replace").splitlines()[:50]
    return any(_is_row(_cells(line, _mark(line))) for line in lines if _bare(line))


def read(file: Path) -> Record:
    """Read a table of numbers.

    Lines that begin with # or % are passed over. The last line before the first row of numbers names the columns, with units in brackets;
    a line of units may stand below it. Cells are parted by semicolons, tabs, commas or blanks; beside semicolons and tabs a decimal comma
    is read. Empty cells are gaps.

    Raises
    ------
    LogError
        If there is no row of numbers, or one is faulty; says the line.
    """
    lines = [(i, line) for i, line in enumerate(text_of(file).splitlines(), 1) if _bare(line)]
    if not lines:
        raise LogError("holds no samples", file=file)
    mark = _mark(lines[min(len(lines) - 1, 5)][1])
    first = next((k for k, (_, line) in enumerate(lines) if _is_row(_cells(line, mark))), None)
    if first is None:
        raise LogError("holds no row of numbers", file=file, line=lines[0][0])
    width = len(_cells(lines[first][1], mark))
    names, units = _heads([_cells(line, mark) for _, line in lines[:first]], width)
    values = _values(lines[first:], width, mark, file)
    channels = tuple(Channel(name, column, unit) for name, unit, column in zip(names, units, values.T, strict=True))
    return Record(file, "csv", channels)


def _bare(line: str) -> str:
    text = line.strip()
    return "" if text.startswith(("#", "%")) else text


def _mark(line: str) -> str | None:
    """Return what parts the cells of a line; None for blanks."""
    # A comma in numbers that semicolons, tabs or blanks part is a decimal one.
    marks = [mark for mark in MARKS if mark in line]
    if marks == [","] and re.search(r"\d,\d+\s+-?\d", line) and "," not in re.sub(r"\d,\d", "", line):
        return None
    return marks[0] if marks else None


def _cells(line: str, mark: str | None) -> list[str]:
    if mark is None:
        return re.findall(r"[^\s\[(]+\s*(?:[\[(][^\])]*[\])])?", line.strip()) if "[" in line or "(" in line else line.split()
    cells = next(csv.reader([line], delimiter=mark))
    # A mark at the end of every line closes the last cell.
    return cells[:-1] if len(cells) > 1 and not cells[-1].strip() else cells


def _is_row(cells: list[str]) -> bool:
    found = [cell.strip().strip('"') for cell in cells]
    return any(_NUMBER.match(cell) for cell in found) and all(_NUMBER.match(cell) or _empty(cell) for cell in found)


def _empty(cell: str) -> bool:
    try:
        return bool(np.isnan(number(cell)))
    except ValueError:
        return False


def _heads(lines: list[list[str]], width: int) -> tuple[list[str], list[str]]:
    """Return names and units of the columns: from the last line as wide as the table, and a line of units below it."""
    wide = [cells if width > 1 else [" ".join(cells)] for cells in lines if len(cells) == width or width == 1]
    if not wide:
        return [str(j + 1) for j in range(width)], [""] * width
    below = [cell.strip().strip('"').strip("[]() ") for cell in wide[-1]]
    if len(wide) > 1 and all(re.fullmatch(r"[^\d\s]?[^\s]{0,7}", cell) for cell in below) and _bracketed(wide[-1]):
        return [cell.strip().strip('"') for cell in wide[-2]], below
    pairs = [name_and_unit(cell.strip().strip('"')) for cell in wide[-1]]
    return [name or str(j + 1) for j, (name, _) in enumerate(pairs)], [unit for _, unit in pairs]


def _bracketed(cells: list[str]) -> bool:
    """Tell whether a line is one of units alone: each in brackets, or empty."""
    return all(re.fullmatch(r'"?\s*([\[(].*[\])])?\s*"?', cell) for cell in cells)


def _values(lines: list[tuple[int, str]], width: int, mark: str | None, file: Path) -> Array:
    comma = mark != "," and any("," in line for _, line in lines[:100])
    if not comma:
        try:
            text = io.StringIO("\n".join(line for _, line in lines))
            found = np.loadtxt(text, delimiter=mark, ndmin=2, comments=None)
            if found.shape == (len(lines), width):
                return np.asarray(found, dtype=np.float64)
        except ValueError:
            pass  # the slow way says which line it is, and knows gaps
    return numbers([(i, _cells(line, mark)) for i, line in lines], width, file, comma)
