"""Read contours from text files of points."""

from __future__ import annotations

import math
import re
from pathlib import Path as File

import numpy as np

from contourlab.contours.drawing import unit_size
from contourlab.contours.fit import PointFit, fit_points
from contourlab.errors import GeometryError, UnitError

CORNER_ANGLE = math.radians(30.0)
"""Default least turn at a corner."""
OUTERMOST = 1e6
"""Larger coordinates [m] are mistakes, or in the wrong unit."""
_HEAD = re.compile(r"\s*\"?\s*([A-Za-z_]\w*)\s*(?:[\[(]\s*([^\])]*?)\s*[\])])?\s*\"?\s*\Z")


def read_points(
    file: str | File,
    *,
    unit: str | None = None,
    tolerance: float | None = None,
    corner_angle: float = CORNER_ANGLE,
    scale: float = 1.0,
    reverse: bool = False,
) -> PointFit:
    """Read points and fit a curve through or near them.

    Parameters
    ----------
    file : str or Path
        One row per point, separated by commas, semicolons (then with decimal points or commas), tabs or blanks. The first row may name the
        axes, with units: ``x [mm],y [mm]``. Empty rows and comments after # are ignored.
    unit : str, optional
        Unit of columns without one in the file.
    tolerance, corner_angle
        See `contourlab.contours.fit.fit_points`.
    scale : float, > 0
        Factor on all coordinates.
    reverse : bool
        Reverse the order of the points.

    Raises
    ------
    GeometryError
        If a row is not a point or repeats the one before, or there are fewer than two; names file and line.
    UnitError
        If `unit` is not a unit of length.
    """
    path = File(file)
    rows = _rows(path)
    names, factors, rows = _head(rows, path, unit)
    values = [_numbers(cells, len(names), path, line) for line, cells in rows]
    points = np.array(values).reshape(len(rows), len(names)) * (scale * np.array(factors))
    far = np.flatnonzero((np.abs(points) > OUTERMOST).any(axis=1))
    if far.size:
        line, cells = rows[int(far[0])]
        i = int(np.argmax(np.abs(points[far[0]])))
        raise GeometryError(f"{path}:{line}: {cells[i]} is {points[far[0], i]:.3g} m, beyond {OUTERMOST:g} m: check the unit")
    again = np.flatnonzero((points[1:] == points[:-1]).all(axis=1))
    if again.size:
        i = int(again[0])
        raise GeometryError(f"{path}:{rows[i + 1][0]}: repeats the point of line {rows[i][0]}: delete one of them")
    if len(points) < 2:
        raise GeometryError(f"{path}: needs at least two points, but has {len(points)}")
    if set(names) <= {"x", "y", "z"}:  # else the columns keep their order
        points = points[:, np.argsort(names)]
    lines = [line for line, _ in rows]
    if reverse:
        points, lines = points[::-1], lines[::-1]
    try:
        return fit_points(points, tolerance, corner_angle, lambda i: f"line {lines[i]}")
    except GeometryError as error:
        raise GeometryError(f"{path}: {error}") from error


def _rows(path: File) -> list[tuple[int, list[str]]]:
    try:
        text = path.read_bytes().decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise GeometryError(f"{path}: is not UTF-8 text (byte {error.start}): save it as UTF-8") from error
    except OSError as error:
        raise GeometryError(f"{path}: cannot be read: {error.strerror or error}") from error
    lines = [(number, line.partition("#")[0].strip()) for number, line in enumerate(text.splitlines(), 1)]
    lines = [(number, line) for number, line in lines if line]
    first = lines[0][1] if lines else ""
    mark = next((mark for mark in (";", ",", "\t") if mark in first), None)
    rows = []
    for number, line in lines:
        cells = [cell.strip() for cell in (line.split(mark) if mark else line.split())]
        # A header separated by blanks: "x [mm] y [mm]".
        if mark is None and line is first and "[" in line:
            cells = re.findall(r"\w+\s*\[[^\]]*\]|\w+", line)
        cells = [cell[1:-1].strip() if len(cell) > 1 and cell[0] == cell[-1] == '"' else cell for cell in cells]
        rows.append((number, [cell.replace(",", ".") for cell in cells] if mark == ";" else cells))
    return rows


def _head(rows: list[tuple[int, list[str]]], path: File, unit: str | None) -> tuple[list[str], list[float], list[tuple[int, list[str]]]]:
    """Return names and units [m] of the columns, and the rows below the header."""
    if not rows:
        raise GeometryError(f"{path}: contains no points: write one point on each line")
    line, cells = rows[0]
    heads = [_HEAD.match(cell) for cell in cells]
    is_head = any(head is not None and head[1].lower() not in ("nan", "inf", "infinity") for head in heads)
    if not is_head:
        names = [str(i) for i in range(len(cells))]
        units: list[str | None] = [None] * len(cells)
    else:
        for cell, head in zip(cells, heads, strict=True):
            if head is None:
                raise GeometryError(f"{path}:{line}: {cell!r} does not name an axis: write for example x [mm],y [mm]")
        names = [head[1].lower() for head in heads if head]
        units = [head[2] for head in heads if head]
        rows = rows[1:]
    if len(names) < 2 or len(names) > 3:
        raise GeometryError(f"{path}:{line}: has {len(names)} columns: give two or three, one for each axis")
    if len(set(names)) != len(names):
        raise GeometryError(f"{path}:{line}: an axis is named twice: rename one column")
    return names, [_factor(name, own, unit, path, line) for name, own in zip(names, units, strict=True)], rows


def _factor(name: str, own: str | None, unit: str | None, path: File, line: int) -> float:
    stated = own or unit
    if own and unit and own != unit:
        raise GeometryError(f"{path}:{line}: the header says {own}, but unit = {unit!r} is given: delete one of them")
    if not stated:
        raise GeometryError(f'{path}:{line}: has no unit: write unit = "mm", or a header such as x [mm],y [mm]')
    try:
        return unit_size(stated)
    except UnitError as error:
        if own:
            cure = "write for example mm" if name in ("x", "y", "z") else "delete the column"
            raise GeometryError(f"{path}:{line}: column {name} is in {own}, which is not a unit of length: {cure}") from error
        raise


def _numbers(cells: list[str], n: int, path: File, line: int) -> list[float]:
    if len(cells) != n:
        raise GeometryError(f"{path}:{line}: has {len(cells)} columns, but {n} are expected")
    numbers = []
    for cell in cells:
        try:
            number = float(cell)
        except ValueError:
            raise GeometryError(f"{path}:{line}: {cell!r} is not a number") from None
        if not math.isfinite(number):
            raise GeometryError(f"{path}:{line}: {cell} is not finite")
        numbers.append(number)
    return numbers
