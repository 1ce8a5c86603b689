"""Tables of numbers in text: a row for each sample, with or without a line of names and units."""

from __future__ import annotations

import io
import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import LogError
from contourlab.logs.reading import CUT, called, cells_of, is_empty, is_unit, name_and_unit, number, numbers, shown, text_of
from contourlab.logs.record import Channel, Record
from contourlab.logs.timestamps import EXAMPLE, is_timestamp, timestamp_channel

Array = NDArray[np.float64]
MARKS = (";", "\t", ",")
ENDINGS = (".csv", ".tsv", ".txt", ".dat", ".log")
NO_UNIT = ("", "-", "1")
"""Cells of a line of units for columns without one."""
LOOKED_AT = 1000
"""Lines searched for the one most like a row of numbers."""
_NUMBER = re.compile(r"[-+]?(\d+([.,]\d*)?|[.,]\d+)([eE][-+]?\d+)?\Z")


def matches(file: Path, head: bytes) -> bool:
    """Tell whether a file may be a table of numbers: text, one of whose first lines holds nothing else."""
    if b"\0" in head or file.suffix.lower() == ".xml":
        return False
    lines = [line for line in head.decode("utf-8-sig", errors="replace").splitlines()[:50] if _bare(line)]
    rows = [_cells(line, _mark(line)) for line in lines]
    if any(_is_row(cells) for cells in rows):
        return True
    # A faulty table: all lines are separated, and there are few or some hold numbers.
    if file.suffix.lower() not in ENDINGS or not rows or not all(_mark(line) for line in lines):
        return False
    return len(rows) <= 2 or any(_NUMBER.match(cell.strip(' "')) for cells in rows for cell in cells)


def read(file: Path) -> Record:
    """Read a table of numbers.

    Lines that begin with # or % are skipped. The last line before the first row of numbers names the columns, with units in brackets;
    a line of units may follow. Semicolons, tabs, commas or blanks separate the cells; with semicolons and tabs a decimal comma is read.
    Empty cells are gaps; true and false are 1 and 0. Columns of timestamps become seconds from the first one.

    Raises
    ------
    LogError
        If there is no row of numbers, or one is faulty; says the line.
    """
    text = text_of(file)
    lines = [(i, line) for i, line in enumerate(text.splitlines(), 1) if _bare(line)]
    if not lines:
        raise LogError("holds no samples", file=file)
    first, mark = _first_row(lines, file)
    heads, rows = lines[:first], lines[first:]
    cut = len(rows) > 1 and not text.endswith(("\n", "\r"))
    if _is_closed(heads, rows[:-1] if cut else rows, mark):
        heads, rows = ([(i, line.rstrip(" ").removesuffix(mark or "")) for i, line in part] for part in (heads, rows))
    width = len(_cells(rows[0][1], mark))
    names, units = _heads([_cells(line, mark) for _, line in heads], width)
    notes: tuple[str, ...] = ()
    if cut and len(_cells(rows[-1][1], mark)) != width:
        rows, notes = rows[:-1], (CUT,)
    timestamps, rows = _timestamps(rows, names, mark, file)
    values = _values(rows, names, mark, file, {line for _, line in heads})
    channels = [timestamps.get(j) or Channel(names[j], column, units[j]) for j, column in enumerate(values.T)]
    return Record(file, "csv", tuple(channels), notes=notes)


def _timestamps(
    rows: list[tuple[int, str]], names: list[str], mark: str | None, file: Path
) -> tuple[dict[int, Channel], list[tuple[int, str]]]:
    """Return the columns of timestamps, and the rows with 0 in their place."""
    columns = _columns_of_timestamps(rows, len(names), mark)
    if not columns:
        return {}, rows
    lines = [i for i, _ in rows]
    table = [_cells(line, mark) for _, line in rows]
    for i, cells in zip(lines, table, strict=True):
        if len(cells) != len(names):
            raise LogError(f"has {len(cells)} columns where {len(names)} are wanted", file=file, line=i)
    channels = {j: timestamp_channel(names[j], [cells[j] for cells in table], lines, file) for j in columns}
    kept = [["0" if j in channels else f'"{cell}"' if (mark or " ") in cell else cell for j, cell in enumerate(cells)] for cells in table]
    return channels, [(i, (mark or " ").join(cells)) for i, cells in zip(lines, kept, strict=True)]


def _columns_of_timestamps(rows: list[tuple[int, str]], width: int, mark: str | None) -> list[int]:
    """Return the columns whose first cell that is not empty looks like a timestamp."""
    found, empty = [], set(range(width))
    for _, line in rows:
        for j, cell in enumerate(_cells(line, mark)[:width]):
            if j in empty and not is_empty(cell):
                empty.remove(j)
                found += [j] if is_timestamp(cell.strip('" ')) else []
        if not empty:
            break
    return sorted(found)


def _first_row(lines: list[tuple[int, str]], file: Path) -> tuple[int, str | None]:
    """Return which line is the first of the table, and what parts its cells: a row of numbers with another as wide below it."""
    alone = None
    for k, (_, line) in enumerate(lines):
        mark = _mark(line)
        cells = _cells(line, mark)
        if not _is_row(cells):
            continue
        below = _cells(lines[k + 1][1], mark) if k + 1 < len(lines) else []
        if len(below) == len(cells) and _is_row(below):
            return k, mark
        alone = alone or (k, mark)
    if alone is None:
        raise _no_row(lines, file)
    return alone


def _no_row(lines: list[tuple[int, str]], file: Path) -> LogError:
    """Return the error if no line is a row of numbers; it names the bad cell of the best line."""
    if len(lines) <= 2:
        return LogError("has no rows: there are names of columns and no numbers below them", file=file, line=lines[0][0])
    parted = [_cells(line, _mark(line)) for _, line in lines[:LOOKED_AT]]
    right = [[_is_value(cell.strip().strip('"')) for cell in cells] for cells in parted]
    k = max(range(len(right)), key=lambda k: sum(right[k]))
    if not any(right[k]) or all(right[k]):
        return LogError("holds no row of numbers", file=file, line=lines[0][0])
    j = right[k].index(False)
    name = parted[0][j].strip(' "') if k and len(parted[0]) == len(parted[k]) else str(j + 1)
    words = f"{shown(parted[k][j])} in {called(name_and_unit(name)[0])} is neither a number nor a date and time such as {EXAMPLE}"
    return LogError(f"holds no row of numbers: {words}", file=file, line=lines[k][0])


def _is_closed(heads: list[tuple[int, str]], rows: list[tuple[int, str]], mark: str | None) -> bool:
    """Tell whether the mark at the end of every line closes the last cell, and opens no empty one."""
    if mark is None or not all(line.rstrip(" ").endswith(mark) for _, line in rows):
        return False
    above = heads[-1][1] if heads else ""
    return not above or above.rstrip(" ").endswith(mark) or len(_cells(above, mark)) < len(_cells(rows[0][1], mark))


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
    return cells_of(line, mark)


def _is_row(cells: list[str]) -> bool:
    found = [cell.strip().strip('"') for cell in cells]
    return any(_NUMBER.match(cell) or is_timestamp(cell) for cell in found) and all(_is_value(cell) for cell in found)


def _is_value(cell: str) -> bool:
    """Tell whether a cell is a number, a timestamp, or a word that stands for a value or for none."""
    try:
        return _NUMBER.match(cell) is not None or is_timestamp(cell) or not np.isinf(number(cell))
    except ValueError:
        return False


def _heads(lines: list[list[str]], width: int) -> tuple[list[str], list[str]]:
    """Return names and units of the columns: from the last line as wide as the table, and a line of units below it."""
    wide = [cells if width > 1 else [" ".join(cells)] for cells in lines if len(cells) == width or width == 1]
    if not wide:
        return [str(j + 1) for j in range(width)], [""] * width
    below = [cell.strip().strip('"').strip("[]() ") for cell in wide[-1]]
    if len(wide) > 1 and all(re.fullmatch(r"[^\d\s]?[^\s]{0,7}", cell) for cell in below):
        above = [cell.strip().strip('"').strip() for cell in wide[-2]]
        if _bracketed(wide[-1]):
            return above, below
        if _bare_units(above, below):
            return above, ["" if cell in NO_UNIT else cell for cell in below]
    pairs = [name_and_unit(cell.strip().strip('"')) for cell in wide[-1]]
    return [name or str(j + 1) for j, (name, _) in enumerate(pairs)], [unit for _, unit in pairs]


def _bracketed(cells: list[str]) -> bool:
    """Tell whether a line is one of units alone: each in brackets, or empty."""
    return all(re.fullmatch(r'"?\s*([\[(].*[\])])?\s*"?', cell) for cell in cells)


def _bare_units(names: list[str], cells: list[str]) -> bool:
    """Tell whether cells below names are units without brackets: each that holds something is one that is known, and has a name."""
    units = [(name, cell) for name, cell in zip(names, cells, strict=True) if cell not in NO_UNIT]
    return bool(units) and all(name and name != cell and is_unit(cell) for name, cell in units)


def _values(lines: list[tuple[int, str]], names: list[str], mark: str | None, file: Path, heads: set[str]) -> Array:
    text = "\n".join(line for _, line in lines)
    comma = mark != "," and "," in text
    plain = text if not comma else text.replace(",", ".") if "." not in text else ""
    try:
        found = np.loadtxt(io.StringIO(plain), delimiter=mark, ndmin=2, comments=None) if plain else np.empty(0)
        if found.shape == (len(lines), len(names)):
            return np.asarray(found, dtype=np.float64)
    except ValueError:
        pass  # empty cells, words and faults: read cell by cell
    again = next((i for i, line in lines if line in heads), 0)
    if again:
        raise LogError("the head stands here again: two records are in one file", file=file, line=again)
    return numbers([(i, _cells(line, mark)) for i, line in lines], names, file, comma)
