"""Contours out of SVG drawings.

The y axis of SVG points down, that of a machine up: the drawing is turned over about the middle of its viewBox, so that the part is what
one sees, not its mirror image, and a viewBox keeps its place. Where a drawing has neither viewBox nor height, y becomes -y.
"""

from __future__ import annotations

import io
import math
from collections.abc import Iterator
from pathlib import Path as File
from typing import Any
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray

from contourlab.contours.chains import Strand
from contourlab.contours.drawing import Drawing, LeftOut, drawing_of, strand_of, unit_size
from contourlab.contours.shapes import ConicShape, LineShape, Shape
from contourlab.contours.svg_path import path_shapes
from contourlab.contours.svg_tree import DATA, HIDDEN, NUMBER, SIZES, VISIBLE, Plain, length_match, tag_of
from contourlab.errors import GeometryError

Array = NDArray[np.float64]
PIXEL = 0.0254 / 96.0
"""A user unit [m] where nothing else is said; CSS Values 3, section 5.2."""


def read_svg(file: str | File, *, unit: str | None = None, tolerance: float | None = None, scale: float = 1.0) -> Drawing:
    """Read the contours of an SVG drawing.

    Parameters
    ----------
    file : str or Path
    unit : str, optional
        Of its user units; by default width, height and viewBox say it, and where they do not, 1/96 inch.
    tolerance : float [m], > 0
        Largest gap between ends that meet, 1 um by default.
    scale : float, > 0
        Factor on all coordinates.

    Returns
    -------
    Drawing
        Paths, rectangles, circles, ellipses, lines, polylines and polygons as analytic curves, transforms applied; texts, images and what
        is hidden in `left_out`. Path data are drawn up to their first error, as the standard wants it, and `notes` says where that is.

    Raises
    ------
    GeometryError
        If the file cannot be read, or svgelements is not installed.
    UnitError
        If `unit` is no unit of length.

    References
    ----------
    W3C, "Scalable Vector Graphics (SVG) 2", chapters 8 (coordinate systems) to 10 (basic shapes).
    """
    path = File(file)
    root = _parsed(path)
    matrix, offset = _frame(root, path, unit, scale)
    plain = Plain(path)
    plain.take(root)
    strands: list[Strand] = []
    hidden, left_out, notes = list[LeftOut](), [LeftOut(tag) for tag in plain.foreign], plain.notes
    unmet = dict(plain.shapes)
    for number, element in enumerate(_elements(root, path), 1):
        kind = type(element).__name__
        unmet.pop(element.values.get(NUMBER), None)
        if HIDDEN in element.values or element.values.get(VISIBLE, "visible") != "visible":
            hidden.append(LeftOut("hidden", why="line" if kind == "SimpleLine" else kind.lower()))
        elif kind in ("Text", "Image"):
            left_out.append(LeftOut(kind.lower()))
        else:
            own = element.values.get("id")
            what = f"{kind} {own!r}" if own else f"{kind}, element {number}"
            parts, trouble = _parts(element, kind)
            notes += [f"{what}: {trouble}"] if trouble else []
            m = element.transform
            inner, shift = matrix @ np.array([[m.a, m.c], [m.b, m.d]]), matrix @ np.array([m.e, m.f]) + offset
            strands += [strand_of([shape.mapped(inner, shift) for shape in shapes], path, what) for shapes in parts]
    notes += [f"{name}: has no size, or cannot be read: left out" for name in unmet.values()]
    return drawing_of(path, strands, tolerance, [*hidden, *left_out], notes)


def _parsed(path: File) -> ElementTree.Element:
    try:
        root = ElementTree.fromstring(path.read_bytes())
    except OSError as error:
        raise GeometryError(f"{path}: cannot be read: {error.strerror or error}") from error
    except (ElementTree.ParseError, ValueError, LookupError) as error:
        raise GeometryError(f"{path}: is no SVG drawing: {error}") from error
    if tag_of(root) != "svg":
        raise GeometryError(f"{path}: is no SVG drawing: its root is <{tag_of(root)}>")
    return root


# --- size and place ------------------------------------------------------------------------------------------------------------------


def _pixels(text: str | None, path: File, what: str) -> float | None:
    """Return a length of the root in pixels of 1/96 inch; None where there is none, or a percentage of the unknown."""
    if text is None or text.strip() in ("", "auto"):
        return None
    met = length_match(text)
    if met and met[2] == "%":
        return None
    if not met or met[2].lower() not in SIZES or not float(met[1]) > 0.0:
        raise GeometryError(f'{path}: {what} = "{text}" is no size: write unit = "mm", or what its user units are')
    return float(met[1]) * SIZES[met[2].lower()]


def _frame(root: ElementTree.Element, path: File, unit: str | None, scale: float) -> tuple[Array, Array]:
    """Return the map from user units to metres, and take from the root what would scale the drawing once more."""
    stated = unit_size(unit) if unit is not None else None
    width, height = (None if stated else _pixels(root.get(name), path, name) for name in ("width", "height"))
    box = _view_box(root, path)
    sx = sy = PIXEL
    if box is not None:
        ratios = [size / span for size, span in ((width, box[2]), (height, box[3])) if size is not None]
        if ratios:
            fit = root.get("preserveAspectRatio", "").split()
            both = ratios if len(ratios) == 2 else ratios * 2
            pair = both if "none" in fit else [max(both) if "slice" in fit else min(both)] * 2
            sx, sy = PIXEL * pair[0], PIXEL * pair[1]
        centre = box[1] + 0.5 * box[3]
    else:
        centre = 0.5 * height if height is not None else 0.0
    if stated is not None:
        sx = sy = stated
    for name in ("width", "height", "viewBox", "preserveAspectRatio"):
        root.attrib.pop(name, None)
    size = (box[2], box[3]) if box is not None else (width, height)
    for name, value in zip(("width", "height"), size, strict=True):
        if value is not None:
            root.set(name, repr(value))  # what percentages are of
    return scale * np.diag([sx, -sy]), scale * np.array([0.0, 2.0 * centre * sy])


def _view_box(root: ElementTree.Element, path: File) -> tuple[float, float, float, float] | None:
    text = root.get("viewBox")
    if text is None:
        return None
    try:
        x, y, w, h = (float(word) for word in text.replace(",", " ").split())
    except ValueError:
        x = y = w = h = math.nan
    if not (math.isfinite(x + y + w + h) and w > 0.0 and h > 0.0):
        raise GeometryError(f'{path}: viewBox = "{text}": four numbers are wanted, width and height > 0')
    return x, y, w, h


# --- elements ------------------------------------------------------------------------------------------------------------------------


def _elements(root: ElementTree.Element, path: File) -> Iterator[Any]:
    try:
        import svgelements  # type: ignore[import-untyped]
    except ModuleNotFoundError as error:
        raise GeometryError(f'{path}: reading SVG wants svgelements: pip install "contourlab[svg]"') from error
    try:
        document = svgelements.SVG.parse(io.BytesIO(ElementTree.tostring(root)), reify=False)
    except RecursionError as error:
        raise GeometryError(f"{path}: has a use that draws itself, or uses nested too deep") from error
    except Exception as error:  # a parser of text by hand, which passes on whatever its arithmetic raises
        raise GeometryError(f"{path}: is no readable SVG drawing: {error}") from error
    for element in document.elements():
        if isinstance(element, svgelements.Shape | svgelements.Text | svgelements.Image):
            yield element


def _point(p: Any) -> Array:
    return np.array([float(p.x), float(p.y)])


def _parts(element: Any, kind: str) -> tuple[list[list[Shape]], str | None]:
    """Return the shapes of each part of an element, in its own coordinates, and what there is to note."""
    parts, trouble = path_shapes(element.values[DATA]) if kind == "Path" else (list(_subpaths(element)), None)
    return parts, trouble or (None if parts else "has no length")


def _subpaths(element: Any) -> Iterator[list[Shape]]:
    """Yield the shapes of each part of an element, in its own coordinates."""
    kind = type(element).__name__
    if kind in ("Circle", "Ellipse"):
        rx, ry = float(element.rx), float(element.ry)
        if rx > 0.0 and ry > 0.0:
            yield [
                ConicShape(np.array([float(element.cx), float(element.cy)]), np.array([rx, 0.0]), np.array([0.0, ry]), 0.0, 2.0 * math.pi)
            ]
        return
    found: list[Shape] = []
    for segment in element.segments(transformed=False):
        if type(segment).__name__ == "Move":
            if found:
                yield found
            found = []
            continue
        shape = _shape(segment)
        if shape is not None:
            found.append(shape)
    if found:
        yield found


def _shape(segment: Any) -> Shape | None:
    kind = type(segment).__name__
    if segment.start is None or segment.end is None:
        return None
    start, end = _point(segment.start), _point(segment.end)
    if kind == "Arc":
        centre = _point(segment.center)
        p, q = _point(segment.prx) - centre, _point(segment.pry) - centre
        first, sweep = float(segment.get_start_t()), float(segment.sweep)
        if sweep and np.any(p != 0.0) and np.any(q != 0.0):
            return ConicShape(centre, p, q, first, first + sweep)
        return LineShape(start, end) if np.any(start != end) else None  # as the standard wants it where a radius is 0
    return LineShape(start, end) if np.any(start != end) else None
