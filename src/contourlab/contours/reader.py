"""Read contours from files; the suffix selects the reader. That of points is here."""

from __future__ import annotations

import math
import numbers
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path as File
from typing import Any, Literal

import numpy as np

from contourlab.contours.drawing import unit_size
from contourlab.contours.dxf import read_dxf
from contourlab.contours.fit import PointFit, fit_points
from contourlab.contours.svg import read_svg
from contourlab.errors import GeometryError, UnitError, refuse
from contourlab.geometry import Path
from contourlab.units import setting

SUFFIXES = {
    ".dxf": ("unit", "tolerance", "layer", "chain", "scale", "axes", "ignore", "reverse"),
    ".svg": ("unit", "tolerance", "chain", "scale", "ignore", "reverse"),
    ".csv": ("unit", "tolerance", "scale", "corner_angle", "reverse"),
    ".txt": ("unit", "tolerance", "scale", "corner_angle", "reverse"),
}
"""Options for each suffix."""


@dataclass(frozen=True, eq=False)
class ContourReading:
    """A contour from a file, and notes on how it was read.

    Attributes
    ----------
    path : Path
    notes : tuple of str
        Omitted entities, and the accuracy of fitted curves.
    """

    path: Path
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class ContourOptions:
    """How to read a contour; see `read_contour`."""

    unit: str | None = field(default=None, metadata=setting(maximum=200))
    tolerance: float | None = field(default=None, metadata=setting("m", "um", minimum=0.0, maximum=1.0, exclusive=True))
    layer: str | None = field(default=None, metadata=setting(maximum=200))
    chain: int | None = field(default=None, metadata=setting(minimum=1))
    scale: float = field(default=1.0, metadata=setting(minimum=0.0, exclusive=True))
    axes: Literal[2, 3] | None = None
    ignore: tuple[str, ...] = field(default=(), metadata=setting(maximum=200))
    corner_angle: float | None = field(default=None, metadata=setting("rad", "deg", minimum=0.0, maximum=math.pi, exclusive=True))
    reverse: bool = False


def read_contour(
    file: str | File,
    *,
    unit: str | None = None,
    tolerance: float | None = None,
    layer: str | None = None,
    chain: int | None = None,
    scale: float = 1.0,
    axes: int | None = None,
    ignore: Sequence[str] = (),
    corner_angle: float | None = None,
    reverse: bool = False,
) -> Path:
    """Read a contour from a drawing (.dxf, .svg) or from points (.csv, .txt).

    Parameters
    ----------
    file : str or Path
    unit : str, optional
        Unit of the numbers in the file, such as ``"mm"`` or ``"inch"``; overrides the unit of a drawing.
    tolerance : float [m], optional
        Drawings: largest gap between ends that meet, 1 um by default. Points: largest distance from a smoothing spline; by default the
        curve passes through them.
    layer : str, optional
        Layer of a DXF drawing.
    chain : int, optional
        Number of the chain, if there are several, counted from 1 in the order of the file.
    scale : float, > 0
        Factor on all coordinates.
    axes : {2, 3}, optional
        DXF drawings: 3 for a contour in space.
    ignore : sequence of str
        Kinds of entities to omit, such as ``"TEXT"``.
    corner_angle : float [rad], optional
        Points: larger turns of their polygon are corners, 30 degrees by default.
    reverse : bool
        Whether to reverse the direction.

    Returns
    -------
    Path

    Raises
    ------
    GeometryError
        If the file cannot be read, or lacks the layer or chain; names file and place.
    UnitError
        If `unit` is not a unit of length.
    """
    return study_contour(
        file, unit=unit, tolerance=tolerance, layer=layer, chain=chain, scale=scale, axes=axes, ignore=ignore, corner_angle=corner_angle,
        reverse=reverse,
    ).path  # fmt: skip


def study_contour(file: str | File, **options: Any) -> ContourReading:
    """Read a contour like `read_contour`, and return it with notes."""
    path, given = File(file), ContourOptions(**options)
    suffix = _checked(path, given)
    shared: dict[str, Any] = {"unit": given.unit, "tolerance": given.tolerance, "scale": given.scale}
    if suffix in (".csv", ".txt"):
        angle = CORNER_ANGLE if given.corner_angle is None else given.corner_angle
        fit = read_points(path, **shared, corner_angle=angle, reverse=given.reverse)
        return ContourReading(fit.path, (fit.note,))
    drawing = read_dxf(path, **shared, layer=given.layer, axes=given.axes or 2) if suffix == ".dxf" else read_svg(path, **shared)
    drawing.refuse_left_out(given.ignore)
    contour = drawing.chosen(given.chain)
    left_out = dict.fromkeys(f"left out: {item.kind}" for item in drawing.left_out)
    try:
        return ContourReading((contour.backwards() if given.reverse else contour).path, (*left_out, *drawing.notes))
    except GeometryError as error:
        raise GeometryError(f"{path}: {error}") from error


def _checked(path: File, given: ContourOptions) -> str:
    """Return the suffix of a file that exists, and takes the options given."""
    typed: Any = given  # which nobody has checked
    chain, ignore, scale = typed.chain, typed.ignore, typed.scale
    if chain is not None and (isinstance(chain, bool) or not isinstance(chain, numbers.Integral)):
        raise GeometryError(f"chain = {chain!r}: write a whole number, counted from 1")
    refuse(isinstance(ignore, str), GeometryError, f'ignore = "{ignore}": write a list: ignore = ["{ignore}"]')
    if not isinstance(ignore, Iterable) or not all(isinstance(kind, str) for kind in ignore):
        raise GeometryError(f'ignore = {ignore!r}: write a list of kinds, such as ["TEXT"]')
    suffix = path.suffix.lower()
    refuse(suffix not in SUFFIXES, GeometryError, f"{path}: unknown suffix: use one of {', '.join(SUFFIXES)}")
    for name in ("layer", "chain", "axes", "ignore", "corner_angle"):
        if (ignore if name == "ignore" else getattr(given, name) is not None) and name not in SUFFIXES[suffix]:
            raise GeometryError(f"{path}: {name} does not apply to a {suffix} file: delete it")
    refuse(not (scale > 0.0 and math.isfinite(scale)), GeometryError, f"scale = {scale!r}: must be > 0 and finite")
    try:
        there = path.is_file()
    except (OSError, ValueError) as error:
        raise GeometryError(f"{str(path)!r} is not a file name: {error}") from error
    refuse(not there, GeometryError, f"no file {str(path)!r}")
    refuse(given.axes not in (None, 2, 3), GeometryError, f"axes = {given.axes!r}: write 2 or 3")
    return suffix


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
    refuse(len(points) < 2, GeometryError, f"{path}: needs at least two points, but has {len(points)}")
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
    refuse(not rows, GeometryError, f"{path}: contains no points: write one point on each line")
    line, cells = rows[0]
    heads = [_HEAD.match(cell) for cell in cells]
    if not any(head is not None and head[1].lower() not in ("nan", "inf", "infinity") for head in heads):
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
    refuse(len(set(names)) != len(names), GeometryError, f"{path}:{line}: an axis is named twice: rename one column")
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
