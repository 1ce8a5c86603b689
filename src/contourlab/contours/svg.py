"""Read contours from SVG drawings.

SVG's y axis points down, a machine's up: the drawing is flipped about the middle of its viewBox, so that the part looks like the drawing
and the viewBox keeps its place. Without viewBox and height, y becomes -y.

`svgelements` handles transforms, viewports and basic shapes. The tree, style sheets and path data (`svg_syntax`) are handled
here, because the library inherits attributes that SVG does not, drops hidden elements, and misreads some path data.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path as File
from typing import Any
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

import numpy as np

from contourlab.arrays import Array
from contourlab.contours.chains import Strand
from contourlab.contours.drawing import Drawing, LeftOut, drawing_of, strand_of, unit_size
from contourlab.contours.shapes import ConicShape, LineShape, Shape
from contourlab.contours.svg_syntax import StyleSheet, path_shapes
from contourlab.errors import GeometryError
from contourlab.extras import extra_module

Viewport = tuple[float | None, float | None]
PIXEL = 0.0254 / 96.0
"""Default user unit [m]; CSS Values 3, section 5.2."""
PIXELS = {"": 1.0, "px": 1.0, "in": 96.0, "cm": 96.0 / 2.54, "mm": 96.0 / 25.4, "q": 96.0 / 101.6, "pt": 96.0 / 72.0, "pc": 16.0}
"""Pixels of 1/96 inch in each unit of length."""
DEEPEST = 200
"""Largest depth of nesting; drawing programs need a tenth."""
LENGTH = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([a-zA-Z%]*)\s*\Z")
ACROSS, DOWN = ("x", "width", "cx", "x1", "x2", "rx"), ("y", "height", "cy", "y1", "y2", "ry")
STYLED = ("x", "y", "cx", "cy", "r", "rx", "ry", "width", "height")
"""Lengths that a style may set."""
SHAPES = {"path": "Path", "rect": "Rect", "circle": "Circle", "ellipse": "Ellipse", "line": "SimpleLine", "polyline": "Polyline",
          "polygon": "Polygon"}  # fmt: skip
"""Tags of shapes, and their classes in svgelements."""
OTHERS = {"text": "text", "tspan": "text", "image": "image"}
FOREIGN = ("foreignObject", "video", "audio", "iframe", "canvas")
UNNAMED = ("clipPath", "mask", "marker", "pattern", "metadata", "linearGradient", "radialGradient", "filter")
"""Elements that are never drawn, not even through a use."""
UNDRAWN = (*UNNAMED, "defs", "symbol", "style")
HREFS = ("href", "{http://www.w3.org/1999/xlink}href")


def read_svg(file: str | File, *, unit: str | None = None, tolerance: float | None = None, scale: float = 1.0) -> Drawing:
    """Read the contours of an SVG drawing.

    Parameters
    ----------
    unit : str, optional
        Size of the user unit; by default from width, height and viewBox, else 1/96 inch.
    tolerance : float [m], > 0
        Largest gap between ends that meet, 1 um by default.
    scale : float, > 0
        Factor on all coordinates.

    Returns
    -------
    Drawing
        Paths, rectangles, circles, ellipses, lines, polylines and polygons as analytic curves, with transforms applied. `left_out` holds
        texts, images and hidden elements. Path data are drawn up to their first error, as in the standard; `notes` gives its place.

    Raises
    ------
    GeometryError
        If the file cannot be read.
    UnitError
        If `unit` is not a unit of length.

    References
    ----------
    W3C, "Scalable Vector Graphics (SVG) 2", chapters 8 (coordinate systems) to 10 (basic shapes).
    """
    path = File(file)
    root = _parsed(path)
    stated = unit_size(unit) if unit is not None else None
    matrix, offset, viewport = _frame(root, path, stated, scale)
    painter = _Painter(root, path, matrix, offset)
    try:
        painter.draw_root(viewport)
    except GeometryError:
        raise
    except RecursionError as error:
        raise GeometryError(f"{path}: has a <use> element that refers to itself, or nests <use> too deep: delete or expand it") from error
    except Exception as error:  # svgelements may raise anything
        raise GeometryError(f"{path}: is not a readable SVG drawing: {error}") from error
    left_out = [*painter.hidden, *(LeftOut(tag) for tag in painter.foreign), *painter.left_out]
    return drawing_of(path, painter.strands, tolerance, left_out, painter.notes)


def _parsed(path: File) -> Element:
    try:
        root = ElementTree.fromstring(path.read_bytes())
    except OSError as error:
        raise GeometryError(f"{path}: cannot be read: {error.strerror or error}") from error
    except (ElementTree.ParseError, ValueError, LookupError) as error:
        raise GeometryError(f"{path}: is not an SVG drawing: {error}") from error
    tag = root.tag.rpartition("}")[2]
    if tag != "svg":
        raise GeometryError(f"{path}: is not an SVG drawing: its root is <{tag}>")
    level, depth = [root], 0
    while level:
        depth += 1
        if depth > DEEPEST:
            raise GeometryError(f"{path}: has elements nested more than {DEEPEST} deep: ungroup them")
        level = [child for element in level for child in element]
    return root


# --- size and place ------------------------------------------------------------------------------------------------------------------


def _pixels(root: Element, name: str, path: File) -> float | None:
    """Return a length of the root in pixels of 1/96 inch; None if it is missing or a percentage."""
    text = root.get(name, "auto")
    if text.strip() in ("", "auto"):
        return None
    match = LENGTH.match(text)
    if match and match[2] == "%":
        return None
    if not match or match[2].lower() not in PIXELS or not float(match[1]) > 0.0:
        raise GeometryError(f'{path}: {name} = "{text}" is not a size: write unit = "mm", or the unit of its coordinates')
    return float(match[1]) * PIXELS[match[2].lower()]


def _frame(root: Element, path: File, stated: float | None, scale: float) -> tuple[Array, Array, Viewport]:
    """Return the map from user units to metres, and the size of the root in user units."""
    width, height = (None if stated else _pixels(root, name, path) for name in ("width", "height"))
    box = _root_box(root, path)
    sx = sy = PIXEL
    centre = 0.5 * height if height is not None else 0.0
    if box is not None:
        centre = box[1] + 0.5 * box[3]
        ratios = [size / span for size, span in ((width, box[2]), (height, box[3])) if size is not None]
        if ratios:
            fit = root.get("preserveAspectRatio", "").split()
            both = ratios if len(ratios) == 2 else ratios * 2
            pair = both if "none" in fit else [max(both) if "slice" in fit else min(both)] * 2
            sx, sy = PIXEL * pair[0], PIXEL * pair[1]
    if stated is not None:
        sx = sy = stated
    return scale * np.diag([sx, -sy]), scale * np.array([0.0, 2.0 * centre * sy]), (width, height) if box is None else (box[2], box[3])


def _box(element: Element) -> list[float] | None:
    try:
        box = [float(word) for word in element.get("viewBox", "").replace(",", " ").split()]
    except ValueError:
        return None
    return box if len(box) == 4 else None


def _root_box(root: Element, path: File) -> list[float] | None:
    if root.get("viewBox") is None:
        return None
    box = _box(root)
    if box is None or not (math.isfinite(sum(box)) and box[2] > 0.0 and box[3] > 0.0):
        raise GeometryError(f'{path}: viewBox = "{root.get("viewBox")}" is not valid: write four numbers, width and height > 0')
    return box


# --- elements ------------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Context:
    """Properties that an element inherits."""

    viewport: Viewport
    transform: str = ""
    hidden: bool = False
    visible: bool = True


class _Painter:
    """Walks over a drawing and collects its strands."""

    def __init__(self, root: Element, file: File, matrix: Array, offset: Array) -> None:
        self.library, self.root, self.file, self.matrix, self.offset = extra_module("svgelements"), root, file, matrix, offset
        self.namespace = root.tag.removesuffix("svg")
        self.sheet = StyleSheet("\n".join(e.text or "" for e in root.iter() if self._tag(e) == "style"))
        self.strands: list[Strand] = []
        self.hidden: list[LeftOut] = []
        self.left_out: list[LeftOut] = []
        self.foreign: list[str] = []
        self.notes = list(self.sheet.notes)
        self.count = 0
        self.by_id: dict[str, Element] = {}
        self._index(root)

    def _index(self, element: Element) -> None:
        if "id" in element.attrib:
            self.by_id[element.attrib["id"]] = element
        for child in element:
            if self._tag(child) not in UNNAMED:
                self._index(child)

    def _tag(self, element: Element) -> str:
        """Return the tag of an element; "" outside the root's namespace."""
        return element.tag.removeprefix(self.namespace) if isinstance(element.tag, str) else ""

    def draw_root(self, viewport: Viewport) -> None:
        self._children(self.root, self._inside(self.root, self._style(self.root), _Context(viewport)))

    def _children(self, element: Element, context: _Context) -> None:
        for child in element:
            self._draw(child, context)

    def _draw(self, element: Element, around: _Context) -> None:
        tag = self._tag(element)
        if tag in UNDRAWN:
            return
        style = self._style(element)
        context = self._inside(element, style, around)
        values = self._lengths(element, style, context.viewport)
        if tag == "use":
            self._use(values, context)
        elif tag == "svg":
            self._nested(element, values, context)
        else:
            if tag in FOREIGN:
                self.foreign.append(tag)
            elif tag in OTHERS or tag in SHAPES:
                self._leaf(tag, values, context)
            self._children(element, context)

    def _style(self, element: Element) -> dict[str, str]:
        return self.sheet.of(self._tag(element), element.attrib)

    def _inside(self, element: Element, style: Mapping[str, str], around: _Context) -> _Context:
        """Return the context inside an element."""
        transform = style.get("transform") or element.get("transform", "")
        visibility = style.get("visibility", "").lower()
        return replace(
            around,
            transform=f"{around.transform} {transform}".strip(),
            hidden=around.hidden or style.get("display", "").lower() == "none",
            visible=visibility == "visible" if visibility in ("visible", "hidden", "collapse") else around.visible,
        )

    def _lengths(self, element: Element, style: Mapping[str, str], viewport: Viewport) -> dict[str, str]:
        """Return the attributes of an element, with lengths in user units."""
        values = dict(element.attrib)
        for name in STYLED:
            match = LENGTH.match(style.get(name, ""))
            if match and (match[2] == "%" or match[2].lower() in PIXELS):
                values[name] = style[name]
        for name in (*ACROSS, *DOWN, "r"):
            match = LENGTH.match(values.get(name, ""))
            if match and match[2] == "%":
                values[name] = repr(0.01 * float(match[1]) * self._whole(element, name, values[name], viewport))
            elif match and match[2].lower() in PIXELS and match[2]:
                values[name] = repr(float(match[1]) * PIXELS[match[2].lower()])
        return values

    def _whole(self, element: Element, name: str, text: str, viewport: Viewport) -> float:
        """Return the length for 100 %; SVG 2, section 8.9."""
        width, height = viewport
        diagonal = None if width is None or height is None else math.sqrt(0.5 * (width**2 + height**2))
        whole = width if name in ACROSS else height if name in DOWN else diagonal
        if whole is None:
            what = _name(self._tag(element), element.attrib)
            raise GeometryError(f'{self.file}: {what}: {name} = "{text}" of a size that the drawing does not give: write a length')
        return whole

    def _nested(self, element: Element, values: Mapping[str, str], context: _Context) -> None:
        """Draw a nested viewport, of an svg or a used symbol."""
        sizes = [_number(values, name, whole) for name, whole in zip(("width", "height"), context.viewport, strict=True)]
        filled = [1.0 if size is None else size for size in sizes]
        box = _box(element)
        x0, y0, across, down = box or (0.0, 0.0, *filled)
        if not all((*filled, across, down)):
            return
        fit = self.library.Viewbox.viewbox_transform(
            _number(values, "x", 0.0), _number(values, "y", 0.0), *filled, x0, y0, across, down, element.get("preserveAspectRatio")
        )
        inner = replace(context, transform=f"{context.transform} {fit}".strip(), viewport=tuple(sizes) if box is None else (across, down))
        self._children(element, inner)

    def _use(self, values: Mapping[str, str], context: _Context) -> None:
        href = next((values[name] for name in HREFS if name in values), None)
        target = self.by_id.get(href[1:]) if href and href.startswith("#") else None
        if target is None:
            why = f"{href!r} is not in the drawing" if href else "it refers to nothing"
            self.notes.append(f"use: left out, because {why}")
            return
        x, y = _number(values, "x", 0.0), _number(values, "y", 0.0)
        if x or y:
            context = replace(context, transform=f"{context.transform} translate({x}, {y})".strip())
        if self._tag(target) != "symbol":
            self._draw(target, context)
            return
        # A symbol acts as an svg with the size of its use; SVG 2, section 5.6.
        inside = self._inside(target, {**self._style(target), "display": "inline"}, context)
        sizes = {name: values[name] for name in ("width", "height") if name in values}
        self._nested(target, self._lengths(target, {}, context.viewport) | sizes, inside)

    def _leaf(self, tag: str, values: Mapping[str, str], context: _Context) -> None:
        """Record a shape, a text or an image."""
        shape = None
        if tag in SHAPES and tag != "path":
            shape = self._shape(tag, values)
            if shape is None:
                self.notes.append(f"{_name(tag, values)}: left out, because it has no size or cannot be read")
                return
        self.count += 1
        if context.hidden or not context.visible:
            self.hidden.append(LeftOut("hidden", why=OTHERS.get(tag, tag)))
        elif tag in OTHERS:
            self.left_out.append(LeftOut(OTHERS[tag]))
        else:
            what = _name(tag, values) if values.get("id") else f"{tag}, element {self.count}"
            parts, trouble = path_shapes(values.get("d", "")) if shape is None else (list(_subpaths(tag, shape)), None)
            if trouble or not parts:
                self.notes.append(f"{what}: {trouble or 'left out, because it has no length'}")
            self._keep(parts, what, context)

    def _keep(self, parts: list[list[Shape]], what: str, context: _Context) -> None:
        m = self.library.Matrix(context.transform)
        width, height = context.viewport
        m.render(ppi=96.0, width=width, height=height)
        matrix, shift = self.matrix @ np.array([[m.a, m.c], [m.b, m.d]]), self.matrix @ np.array([m.e, m.f]) + self.offset
        self.strands += [strand_of([shape.mapped(matrix, shift) for shape in shapes], self.file, what) for shapes in parts]

    def _shape(self, tag: str, values: Mapping[str, str]) -> Any:
        """Return a basic shape of svgelements; None if it is empty."""
        known = {"width": "0", "height": "0"} | {name: values[name] for name in (*ACROSS, *DOWN, "r", "points") if name in values}
        try:
            shape = getattr(self.library, SHAPES[tag])(known)
        except ValueError:
            return None
        return None if shape.is_degenerate() else shape


def _name(tag: str, values: Mapping[str, str]) -> str:
    return f"{tag} {values['id']!r}" if values.get("id") else tag


def _number(values: Mapping[str, str], name: str, default: Any) -> Any:
    match = LENGTH.match(values.get(name, ""))
    return float(match[1]) if match else default


def _subpaths(tag: str, shape: Any) -> Iterator[list[Shape]]:
    """Yield the shapes of each subpath of a basic shape, in its coordinates."""
    if tag in ("circle", "ellipse"):
        rx, ry = float(shape.rx), float(shape.ry)
        if rx > 0.0 and ry > 0.0:
            centre = np.array([float(shape.cx), float(shape.cy)])
            yield [ConicShape(centre, np.array([rx, 0.0]), np.array([0.0, ry]), 0.0, 2.0 * math.pi)]
        return
    drawn = [part for segment in shape.segments(transformed=False) if (part := _segment(segment)) is not None]
    if drawn:
        yield drawn


def _segment(segment: Any) -> Shape | None:
    if segment.start is None or segment.end is None or type(segment).__name__ == "Move":
        return None
    start, end = (np.array([float(p.x), float(p.y)]) for p in (segment.start, segment.end))
    if type(segment).__name__ == "Arc":
        centre, p, q = (np.array([float(p.x), float(p.y)]) for p in (segment.center, segment.prx, segment.pry))
        first, sweep = float(segment.get_start_t()), float(segment.sweep)
        if sweep and np.any(p != centre) and np.any(q != centre):
            return ConicShape(centre, p - centre, q - centre, first, first + sweep)
    return LineShape(start, end) if np.any(start != end) else None
