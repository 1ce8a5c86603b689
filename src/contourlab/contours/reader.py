"""Read contours from files; the suffix selects the reader."""

from __future__ import annotations

import math
import numbers
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path as File

from contourlab.contours.dxf import read_dxf
from contourlab.contours.points import CORNER_ANGLE, read_points
from contourlab.contours.svg import read_svg
from contourlab.errors import GeometryError
from contourlab.geometry import Path

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


def study_contour(
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
) -> ContourReading:
    """Read a contour like `read_contour`, and return it with notes."""
    path = File(file)
    given = {"layer": layer, "chain": chain, "axes": axes, "ignore": ignore, "corner_angle": corner_angle}
    suffix = _checked(path, given, scale)
    if suffix in (".csv", ".txt"):
        angle = CORNER_ANGLE if corner_angle is None else corner_angle
        fit = read_points(path, unit=unit, tolerance=tolerance, corner_angle=angle, scale=scale, reverse=reverse)
        return ContourReading(fit.path, (fit.note,))
    if suffix == ".dxf":
        drawing = read_dxf(path, unit=unit, tolerance=tolerance, layer=layer, scale=scale, axes=axes or 2)
    else:
        drawing = read_svg(path, unit=unit, tolerance=tolerance, scale=scale)
    drawing.refuse_left_out(ignore)
    contour = drawing.chosen(chain)
    left_out = dict.fromkeys(f"left out: {item.kind}" for item in drawing.left_out)
    try:
        return ContourReading((contour.backwards() if reverse else contour).path, (*left_out, *drawing.notes))
    except GeometryError as error:
        raise GeometryError(f"{path}: {error}") from error


def _checked(path: File, given: Mapping[str, object], scale: float) -> str:
    """Return the suffix of a file that exists, and takes the options given."""
    chain, ignore = given["chain"], given["ignore"]
    if chain is not None and (isinstance(chain, bool) or not isinstance(chain, numbers.Integral)):
        raise GeometryError(f"chain = {chain!r}: write a whole number, counted from 1")
    if isinstance(ignore, str):
        raise GeometryError(f'ignore = "{ignore}": write a list: ignore = ["{ignore}"]')
    if not isinstance(ignore, Iterable) or not all(isinstance(kind, str) for kind in ignore):
        raise GeometryError(f'ignore = {ignore!r}: write a list of kinds, such as ["TEXT"]')
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise GeometryError(f"{path}: unknown suffix: use one of {', '.join(SUFFIXES)}")
    for name, value in given.items():
        if value is not None and (name != "ignore" or value) and name not in SUFFIXES[suffix]:
            raise GeometryError(f"{path}: {name} does not apply to a {suffix} file: delete it")
    if not (scale > 0.0 and math.isfinite(scale)):
        raise GeometryError(f"scale = {scale!r}: must be > 0 and finite")
    try:
        there = path.is_file()
    except (OSError, ValueError) as error:
        raise GeometryError(f"{str(path)!r} is not a file name: {error}") from error
    if not there:
        raise GeometryError(f"no file {str(path)!r}")
    if given["axes"] not in (None, 2, 3):
        raise GeometryError(f"axes = {given['axes']!r}: write 2 or 3")
    return suffix
