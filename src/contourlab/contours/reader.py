"""Read contours from files; the suffix selects the reader."""

from __future__ import annotations

import math
import numbers
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path as File
from typing import Any, Literal

from contourlab.contours.dxf import read_dxf
from contourlab.contours.points import CORNER_ANGLE, read_points
from contourlab.contours.svg import read_svg
from contourlab.errors import GeometryError
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
    chosen = {name: getattr(given, name) for name in ("layer", "chain", "axes", "ignore", "corner_angle")}
    suffix = _checked(path, chosen, given.scale)
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
