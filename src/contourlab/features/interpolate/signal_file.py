"""Measured signals out of text files of numbers: columns by name, units from the header, faults with their line."""

from __future__ import annotations

import io
import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from contourlab.errors import ResultError, UnitError
from contourlab.units import to_si

Array = NDArray[np.float64]
_HEAD = re.compile(r"\s*([^\[(]*?)\s*(?:[\[(]\s*([^\])]*?)\s*[\])])?\s*\Z")


@dataclass(frozen=True)
class Column:
    """A column of a file: its place from 0, its name, and its unit, empty where the file says none."""

    index: int
    name: str
    unit: str

    def factor(self, unit: str, file: Path) -> float:
        """Return the size of its unit in SI.

        Raises
        ------
        ResultError
            If it has none, or one of another dimension than `unit`.
        """
        if not self.unit:
            raise ResultError(f"{file}: column {self.name} says no unit: write it in the header, such as {self.name} [{unit}]")
        try:
            return to_si(f"1 {self.unit.replace('µ', 'u').replace('μ', 'u')}", unit)
        except UnitError as error:
            raise ResultError(f"{file}: column {self.name}: {error}") from error


@dataclass(frozen=True)
class SignalFile:
    """A text file of numbers whose header has been read.

    Parameters
    ----------
    file : Path
    columns : tuple of Column
        Named by their numbers, from 1, where there is no header.
    """

    file: Path
    columns: tuple[Column, ...]
    _text: str
    _first: int
    _mark: str | None

    def find(self, name: str) -> Column:
        """Return the column of a name, in any case of letters, or of a number from 1.

        Raises
        ------
        ResultError
            If there is none.
        """
        wanted = name.strip().lower()
        for column in self.columns:
            if column.name.lower() == wanted:
                return column
        if wanted.isdecimal() and 1 <= int(wanted) <= len(self.columns):
            return self.columns[int(wanted) - 1]
        raise ResultError(f"{self.file}: no column {name!r}; there are: {', '.join(column.name for column in self.columns)}")

    def read(self, columns: tuple[Column, ...]) -> Array:
        """Return the numbers (n_sample, n_column) as they stand.

        Raises
        ------
        ResultError
            With the line, if a cell is no finite number or missing, or there are no rows.
        """
        text = io.StringIO(self._text)
        for _ in range(self._first):
            text.readline()
        wanted = [column.index for column in columns]
        if not any(True for _ in self._lines()):
            raise ResultError(f"{self.file}: holds no samples")
        try:
            found = np.loadtxt(text, delimiter=self._mark, usecols=wanted, ndmin=2, comments="#", quotechar='"')
        except ValueError as error:
            self._point_out(columns)
            raise ResultError(f"{self.file}: cannot be read: {error}") from error
        if not np.isfinite(found).all():
            self._point_out(columns)
        return np.asarray(found, dtype=np.float64)

    def line_of(self, sample: int) -> int:
        """Return the line, from 1, of a sample, from 0."""
        return next(line for i, (line, _) in enumerate(self._lines()) if i == sample)

    def _lines(self) -> Iterator[tuple[int, list[str]]]:
        """Yield line number and cells of each sample."""
        for number, line in enumerate(io.StringIO(self._text), 1):
            cells = _cells(line, self._mark)
            if number > self._first and cells:
                yield number, cells

    def _point_out(self, columns: tuple[Column, ...]) -> None:
        """Raise an error that names the first cell that is no finite number."""
        for line, cells in self._lines():
            for column in columns:
                if column.index >= len(cells) or not cells[column.index]:
                    raise ResultError(f"{self.file}:{line}: column {column.name} is missing: {len(self.columns)} columns are wanted")
                try:
                    good = math.isfinite(float(cells[column.index]))
                except ValueError:
                    raise ResultError(f"{self.file}:{line}: {cells[column.index]!r} in column {column.name} is no number") from None
                if not good:
                    raise ResultError(f"{self.file}:{line}: {cells[column.index]} in column {column.name} is not finite")


def open_signals(file: str | Path) -> SignalFile:
    """Read a text file and its header.

    Parameters
    ----------
    file : str or Path
        A row for each sample, its numbers parted by commas, semicolons, tabs or blanks; beside semicolons a decimal comma is read. The
        first row may name the columns, with units: ``t [s],u1 [V],u2 [V]``. Empty rows and what follows a # are passed over.

    Raises
    ------
    ResultError
        If it cannot be read, is empty, or names a column twice.
    """
    path = Path(file)
    try:
        text = path.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise ResultError(f"{path}: is not UTF-8 text (byte {error.start})") from error
    except OSError as error:
        raise ResultError(f"{path}: cannot be read: {error.strerror or error}") from error
    lines = ((i, line.partition("#")[0].strip()) for i, line in enumerate(io.StringIO(text), 1))
    number, bare = next(((i, line) for i, line in lines if line), (0, ""))
    if not bare:
        raise ResultError(f"{path}: holds no samples")
    mark = next((mark for mark in (";", ",", "\t") if mark in bare), None)
    text = text.replace(",", ".") if mark == ";" else text
    cells = _cells(bare, mark)
    if all(_is_number(cell) for cell in cells):
        columns = tuple(Column(i, str(i + 1), "") for i in range(len(cells)))
        return SignalFile(path, columns, text, number - 1, mark)
    heads = [_HEAD.match(cell) for cell in (re.findall(r"[^\s\[]+\s*\[[^\]]*\]|\S+", bare) if mark is None else cells)]
    columns = tuple(Column(i, head[1] or str(i + 1), head[2] or "") if head else Column(i, str(i + 1), "") for i, head in enumerate(heads))
    names = [column.name.lower() for column in columns]
    twice = next((name for name in names if names.count(name) > 1), "")
    if twice:
        raise ResultError(f"{path}:{number}: names column {twice!r} twice")
    return SignalFile(path, columns, text, number, mark)


def _cells(line: str, mark: str | None) -> list[str]:
    bare = line.partition("#")[0].strip()
    cells = [cell.strip() for cell in (bare.split(mark) if mark else bare.split())] if bare else []
    return [cell[1:-1].strip() if len(cell) > 1 and cell[0] == cell[-1] == '"' else cell for cell in cells]


def _is_number(cell: str) -> bool:
    try:
        float(cell)
    except ValueError:
        return False
    return True
