"""Read contours from SVG drawings.

SVG's y axis points down, a machine's up: the drawing is flipped about the middle of its viewBox, so that the part looks like the drawing
and the viewBox keeps its place. Without viewBox and height, y becomes -y.

`svgelements` handles transforms, viewports and basic shapes. The tree, style sheets and path data are handled
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
from contourlab.contours.drawing import (
    ConicShape,
    Drawing,
    LeftOut,
    LineShape,
    Shape,
    SplineShape,
    Strand,
    drawing_of,
    strand_of,
    unit_size,
)
from contourlab.errors import GeometryError, refuse
from contourlab.extras import extra_module

LARGEST = 1e12
"""Larger numbers [user units] are errors; their squares would overflow."""
_BLANKS = " \t\n\f\r"
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII)
_COUNT = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}
"""Number of arguments of each command."""
_MORE = frozenset("+-.,0123456789")
"""Characters with which further arguments begin."""


class _DataError(Exception):
    """Place and cause of an error in path data."""

    def __init__(self, at: int, why: str) -> None:
        super().__init__(f"invalid at character {at + 1}: {why}; the rest is ignored")


def path_shapes(data: str) -> tuple[list[list[Shape]], str | None]:
    """Return the shapes of each subpath in user units, and the first error.

    Parameters
    ----------
    data : str
        The attribute ``d`` of a path.

    Returns
    -------
    list of list of Shape
        Subpaths with a length, up to the first error.
    str or None
        ``stops at character 14: expected a number``, counted from 1; None without an error.

    References
    ----------
    W3C, "Scalable Vector Graphics (SVG) 2", sections 9.3 (path data), 9.5 (error handling) and B.2 (elliptical arcs).
    """
    pen = _Pen()
    try:
        for command, numbers in _segments(data):
            pen.draw(command, numbers)
    except _DataError as error:
        return pen.subpaths(), str(error)
    return pen.subpaths(), None


# --- grammar -------------------------------------------------------------------------------------------------------------------------


def _segments(data: str) -> Iterator[tuple[str, list[float]]]:
    """Yield each command with its numbers, once per repetition."""
    first = at = _after_blanks(data, 0)
    while at < len(data):
        command, again = data[at], False
        if command.upper() not in _COUNT:
            raise _DataError(at, f"expected a command, not {command!r}")
        if at == first and command not in "Mm":
            raise _DataError(at, f"expected M or m before {command!r}")
        at += 1
        while not again or (command not in "Zz" and data[at : at + 1] in _MORE):
            numbers, at = _numbers(data, at, command.upper(), again)
            yield command, numbers
            # Further pairs of a move are lines.
            command, again, at = {"M": "L", "m": "l"}.get(command, command), True, _after_blanks(data, at)


def _numbers(data: str, at: int, command: str, again: bool) -> tuple[list[float], int]:
    numbers: list[float] = []
    for i in range(_COUNT[command]):
        at = _after_blanks(data, at)
        if (i or again) and data[at : at + 1] == ",":
            at = _after_blanks(data, at + 1)
        if command == "A" and i in (3, 4):
            if data[at : at + 1] not in ("0", "1"):
                raise _DataError(at, "expected a flag, 0 or 1")
            numbers.append(float(data[at]))
            at += 1
            continue
        match = _NUMBER.match(data, at)
        if match is None:
            raise _DataError(at, "expected a number")
        numbers.append(float(match[0]))
        if abs(numbers[-1]) > LARGEST:
            raise _DataError(at, f"{match[0]} is too large")
        at = match.end()
    return numbers, at


def _after_blanks(data: str, at: int) -> int:
    while at < len(data) and data[at] in _BLANKS:
        at += 1
    return at


# --- drawing -------------------------------------------------------------------------------------------------------------------------


class _Pen:
    """Draws commands."""

    def __init__(self) -> None:
        self.here = self.start = np.zeros(2)
        self.control = np.zeros(2)  # point of the last curve
        self.family = ""  # of the last command: C, Q or none
        self.done: list[list[Shape]] = []
        self.open: list[Shape] = []

    def subpaths(self) -> list[list[Shape]]:
        return [shapes for shapes in (*self.done, self.open) if shapes]

    def draw(self, command: str, numbers: list[float]) -> None:
        origin, kind = self.here if command.islower() else np.zeros(2), command.upper()
        family, self.family = self.family, {"S": "C", "T": "Q"}.get(kind, kind) if kind in "CSQT" else ""
        if kind == "H":
            self._line_to(np.array([origin[0] + numbers[0], self.here[1]]))
        elif kind == "V":
            self._line_to(np.array([self.here[0], origin[1] + numbers[0]]))
        elif kind == "L":
            self._line_to(origin + np.array(numbers))
        elif kind == "A":
            self._arc(origin + np.array(numbers[5:]), *numbers[:5])
        elif kind in "CSQT":
            points = [origin + pair for pair in np.array(numbers).reshape(-1, 2)]
            if kind in "ST":
                # The control point is reflected only after a command of the same family.
                points.insert(0, 2.0 * self.here - self.control if family == self.family else self.here)
            if any(np.any(point != self.here) for point in points):
                self.open.append(SplineShape.bezier(self.here, *points))
            self.control, self.here = points[-2], points[-1]
        else:
            if kind == "Z":
                self._line_to(self.start)
            self.done.append(self.open)
            self.open = []
            if kind == "M":
                self.here = self.start = origin + np.array(numbers)

    def _line_to(self, end: Array) -> None:
        if np.any(end != self.here):
            self.open.append(LineShape(self.here, end))
        self.here = end

    def _arc(self, end: Array, rx: float, ry: float, turn: float, large: float, sweep: float) -> None:
        rx, ry = abs(rx), abs(ry)
        # A chord below the rounding of the radii does not determine a centre.
        if rx == 0.0 or ry == 0.0 or float(np.abs(end - self.here).max()) <= 1e-14 * max(rx, ry):
            self._line_to(end)
            return
        self.open.append(_arc_shape(self.here, end, (rx, ry), math.radians(turn % 360.0), bool(large), bool(sweep)))
        self.here = end


def _arc_shape(start: Array, end: Array, radii: tuple[float, float], turn: float, large: bool, sweep: bool) -> ConicShape:
    """Return the arc between two points; radii that are too small are scaled up (B.2.5)."""
    c, s = math.cos(turn), math.sin(turn)
    axes = np.array([[c, s], [-s, c]])
    half = axes @ (0.5 * (start - end)) / np.array(radii)  # mapped to the unit circle
    reach = float(np.hypot(*half))
    if reach > 1.0:
        radii, half, reach = (radii[0] * reach, radii[1] * reach), half / reach, 1.0
    # The centre lies on the perpendicular bisector of the chord, on the side given by the flags.
    height = math.sqrt(max(0.0, 1.0 - reach**2)) / reach * (1.0 if large != sweep else -1.0)
    centre = height * np.array([half[1], -half[0]])
    first = math.atan2(half[1] - centre[1], half[0] - centre[0])
    angle = (math.atan2(-half[1] - centre[1], -half[0] - centre[0]) - first) % (2.0 * math.pi) or 2.0 * math.pi
    if not sweep:
        angle = angle - 2.0 * math.pi if angle < 2.0 * math.pi else -angle
    p, q = radii[0] * axes[0], radii[1] * axes[1]
    return ConicShape(0.5 * (start + end) + centre[0] * p + centre[1] * q, p, q, first, first + angle)


_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
_AT_RULE = re.compile(r"@[^{};]*(?:;|\{(?:[^{}]|\{[^{}]*\})*\})")
_RULE = re.compile(r"([^{}]+)\{([^{}]*)\}")
_SELECTOR = re.compile(r"(\*|[\w-]+)?((?:[#.][\w-]+)*)\Z")
_SEEN = ("display", "visibility")


class StyleSheet:
    """Rules whose selectors are names, ids and classes, alone or together: ``path``, ``#a``, ``g.cut``.

    Attributes
    ----------
    notes : list of str
        Ignored rules on visibility, with other selectors.
    """

    def __init__(self, text: str = "") -> None:
        self.notes: list[str] = []
        self._rules: list[tuple[tuple[int, int, int], str, tuple[str, ...], dict[str, str]]] = []
        text = _COMMENT.sub("", text).replace("<!--", "").replace("-->", "")
        for rule in _AT_RULE.finditer(text):
            if any(word in rule[0] for word in _SEEN):
                self.notes.append(f"style sheet: {rule[0].split('{')[0].strip()!r} is ignored")
        for rule in _RULE.finditer(_AT_RULE.sub("", text)):
            self._add(rule[1], _declarations(rule[2]))

    def _add(self, selectors: str, declared: dict[str, str]) -> None:
        for selector in (word.strip() for word in selectors.split(",")):
            match = _SELECTOR.match(selector)
            if not match or not selector:
                self.notes += [f"style sheet: {name} of {selector!r} is ignored" for name in _SEEN if name in declared]
                continue
            parts = tuple(re.findall(r"[#.][\w-]+", match[2]))
            ids = sum(part.startswith("#") for part in parts)
            name = match[1] or "*"
            self._rules.append(((ids, len(parts) - ids, int(name != "*")), name, parts, declared))

    def of(self, tag: str, attributes: Mapping[str, str]) -> dict[str, str]:
        """Return the declarations for an element: its attributes, overridden by rules in order of specificity, then by its style."""
        declarations = {name: attributes[name].strip() for name in _SEEN if name in attributes}
        selectors = {f".{word}" for word in attributes.get("class", "").split()} | {f"#{attributes.get('id', '')}"}
        matching = [rule for rule in self._rules if rule[1] in ("*", tag) and selectors.issuperset(rule[2])]
        layers = [rule[3] for rule in sorted(matching, key=lambda rule: rule[0])] + [_declarations(attributes.get("style", ""))]
        for wanted in (False, True):  # !important last
            for declared in layers:
                declarations.update({k: v.partition("!")[0].strip() for k, v in declared.items() if ("!" in v) is wanted})
        return declarations


def _declarations(text: str) -> dict[str, str]:
    pairs = (part.partition(":") for part in _COMMENT.sub("", text).split(";"))
    return {name.strip().lower(): value.strip() for name, mark, value in pairs if mark}


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
    matrix, offset, viewport = _frame(root, path, unit_size(unit) if unit is not None else None, scale)
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
    refuse(tag != "svg", GeometryError, f"{path}: is not an SVG drawing: its root is <{tag}>")
    level = [root]
    for _ in range(DEEPEST):
        level = [child for element in level for child in element]
    refuse(level, GeometryError, f"{path}: has elements nested more than {DEEPEST} deep: ungroup them")
    return root


# --- size and place ------------------------------------------------------------------------------------------------------------------


def _pixels(root: Element, name: str, path: File) -> float | None:
    """Return a length of the root in pixels of 1/96 inch; None if it is missing or a percentage."""
    text = root.get(name, "auto")
    match = LENGTH.match(text)
    if text.strip() in ("", "auto") or (match and match[2] == "%"):
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
        tag, style = self._tag(element), self._style(element)
        if tag in UNDRAWN:
            return
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
            self.notes.append(f"use: left out, because {f'{href!r} is not in the drawing' if href else 'it refers to nothing'}")
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
