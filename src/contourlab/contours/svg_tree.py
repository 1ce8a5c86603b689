"""What an SVG drawing says, made plain before it is handed on: lengths as numbers, what is hidden marked, symbols where they are used."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from pathlib import Path as File
from xml.etree.ElementTree import Element, SubElement

from contourlab.contours.svg_style import StyleSheet
from contourlab.errors import GeometryError

SIZES = {"": 1.0, "px": 1.0, "in": 96.0, "cm": 96.0 / 2.54, "mm": 96.0 / 25.4, "q": 96.0 / 101.6, "pt": 96.0 / 72.0, "pc": 16.0}
"""Pixels of 1/96 inch in the units of length."""
DATA, HIDDEN, VISIBLE, NUMBER = "contour-data", "contour-hidden", "contour-visible", "contour-number"
"""Attributes with which elements are marked; the last three are handed down to what is inside, also through a use."""
FOREIGN = ("foreignObject", "video", "audio", "iframe", "canvas")
DEEPEST = 200
"""Elements one inside the other; drawing programs nest a tenth of that."""
_LENGTH = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([a-zA-Z%]*)\s*\Z")
_ACROSS, _DOWN = ("x", "width", "cx", "x1", "x2", "rx"), ("y", "height", "cy", "y1", "y2", "ry")
_STYLED = ("x", "y", "cx", "cy", "r", "rx", "ry", "width", "height")
"""Lengths that a style can state as well."""
_UNDRAWN = ("clipPath", "mask", "marker", "pattern", "metadata", "linearGradient", "radialGradient", "filter")
_SHAPES = ("path", "rect", "circle", "ellipse", "line", "polyline", "polygon")
_PLACED = ("rect", "use", "svg", "image")
_HREFS = ("href", "{http://www.w3.org/1999/xlink}href")
Viewport = tuple[float | None, float | None]


def tag_of(element: Element) -> str:
    """Return the name of an element without its namespace."""
    return element.tag.rpartition("}")[2] if isinstance(element.tag, str) else ""


def length_match(text: str) -> re.Match[str] | None:
    """Match number and unit of a length."""
    return _LENGTH.match(text)


@dataclass
class Plain:
    """Makes a drawing plain, in place.

    Attributes
    ----------
    file : Path
    shapes : dict
        By their numbers, the names of shapes that are to come out again.
    foreign : list of str
        Tags of what other programs draw.
    notes : list of str
    """

    file: File
    shapes: dict[str, str] = field(default_factory=dict)
    foreign: list[str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    sheet: StyleSheet = field(default_factory=StyleSheet)
    by_id: dict[str, Element] = field(default_factory=dict)
    places: list[tuple[Element, Element]] = field(default_factory=list)
    count: int = 0

    def take(self, root: Element) -> None:
        """Go through a drawing whose root states its size in user units, if it is known.

        Raises
        ------
        GeometryError
            If elements are nested too deep, or a percentage is of a size that is not stated.
        """
        self._check_depth(root)
        self._name(root)
        self.sheet = StyleSheet("\n".join(e.text or "" for e in root.iter() if tag_of(e) == "style"))
        self.notes += self.sheet.notes
        sizes = [length_match(root.get(name, "")) for name in ("width", "height")]
        width, height = (float(met[1]) if met else None for met in sizes)
        for name in ("x", "y"):  # they say nothing on the root, and would be handed down
            root.attrib.pop(name, None)
        self._mark(root, self._style(root))
        self._inside(root, (width, height), drawn=True)
        defs = SubElement(root, root.tag.removesuffix("svg") + "defs")
        for place, symbol in self.places:  # at last, when symbols hold what they will
            place.extend(list(symbol))
            defs.append(place)

    def _check_depth(self, root: Element) -> None:
        level, depth = [root], 0
        while level:
            depth += 1
            if depth > DEEPEST:
                raise GeometryError(f"{self.file}: has elements nested more than {DEEPEST} deep: ungroup them")
            level = [child for element in level for child in element]

    def _name(self, element: Element) -> None:
        if "id" in element.attrib:
            self.by_id[element.attrib["id"]] = element
        for child in element:
            if tag_of(child) not in _UNDRAWN:
                self._name(child)

    def _inside(self, parent: Element, viewport: Viewport, drawn: bool) -> None:
        for child in list(parent):
            tag = tag_of(child)
            if tag in _UNDRAWN or not tag:
                parent.remove(child)
                continue
            if tag == "symbol":  # drawn where it is used, and nowhere else
                self._inside(child, self._own_viewport(child, viewport), drawn=False)
                defs = Element(child.tag.removesuffix(tag) + "defs")
                defs.append(child)
                parent[list(parent).index(child)] = defs
                continue
            if tag in FOREIGN and drawn:
                self.foreign.append(tag)
            style = self._style(child)
            self._mark(child, style)
            self._resolve(child, tag, style, viewport)
            if tag in _SHAPES:
                self._number(child, tag, drawn)
            elif tag == "use":
                self._used(child, viewport)
            inner = viewport
            if tag == "svg":
                inner = self._nested(child, viewport)
            self._inside(child, inner, drawn and tag != "defs")

    # --- style -----------------------------------------------------------------------------------------------------------------------

    def _style(self, element: Element) -> dict[str, str]:
        return self.sheet.of(tag_of(element), element.attrib)

    def _mark(self, element: Element, style: dict[str, str]) -> None:
        if style.get("display", "").lower() == "none":
            element.set(HIDDEN, "display")
        visibility = style.get("visibility", "").lower()
        if visibility in ("visible", "hidden", "collapse"):
            element.set(VISIBLE, visibility)
        # What is hidden is to be met, and counted: the parser would pass over it without a word.
        element.attrib.pop("display", None)
        element.set("style", element.get("style", "") + ";display:inline")

    # --- lengths ---------------------------------------------------------------------------------------------------------------------

    def _resolve(self, element: Element, tag: str, style: dict[str, str], viewport: Viewport) -> None:
        """Write lengths as numbers, exactly where the parser knows a millimetre to six digits."""
        if tag not in (*_SHAPES, "use", "svg", "image"):
            return
        for name in _STYLED:
            if name in style and (met := length_match(style[name])) and (met[2] == "%" or met[2].lower() in SIZES):
                element.set(name, style[name])
        for name in (*_ACROSS, *_DOWN, "r"):
            if name in element.attrib:
                element.set(name, self._number_of(element, tag, name, viewport))
                if name in style:
                    element.set("style", f"{element.get('style', '')};{name}:{element.get(name)}")
        if tag in _PLACED:  # else they would be taken from an element around
            for name in ("x", "y", *(("width", "height") if tag == "rect" else ())):
                element.attrib.setdefault(name, "0")

    def _number_of(self, element: Element, tag: str, name: str, viewport: Viewport) -> str:
        text = element.get(name, "")
        met = length_match(text)
        if not met or not met[2]:
            return text
        if met[2] == "%":
            whole = self._whole(name, viewport)
            if whole is None:
                own = element.get("id")
                what = f"{tag} {own!r}" if own else tag
                raise GeometryError(f'{self.file}: {what}: {name} = "{text}" of a size that the drawing does not state: write a number')
            return repr(0.01 * float(met[1]) * whole)
        return repr(float(met[1]) * SIZES[met[2].lower()]) if met[2].lower() in SIZES else text

    @staticmethod
    def _whole(name: str, viewport: Viewport) -> float | None:
        """Return what a percentage is of; SVG 2, section 8.9."""
        width, height = viewport
        if name in _ACROSS:
            return width
        if name in _DOWN:
            return height
        return None if width is None or height is None else math.sqrt(0.5 * (width**2 + height**2))

    # --- viewports and uses ----------------------------------------------------------------------------------------------------------

    def _own_viewport(self, element: Element, outer: Viewport) -> Viewport:
        box = self._box(element)
        if box is not None:
            return box[2], box[3]
        found = []
        for name, whole in zip(("width", "height"), outer, strict=True):
            met = length_match(self._number_of(element, tag_of(element), name, outer)) if name in element.attrib else None
            found.append(float(met[1]) if met else whole)
        return found[0], found[1]

    def _box(self, element: Element) -> tuple[float, ...] | None:
        try:
            box = tuple(float(word) for word in element.get("viewBox", "").replace(",", " ").split())
        except ValueError:
            return None
        return box if len(box) == 4 else None

    def _nested(self, element: Element, outer: Viewport) -> Viewport:
        """State size and viewBox of an svg inside another, without which the parser does not place it; return its viewport."""
        inner = self._own_viewport(element, outer)
        for name, whole in zip(("width", "height"), outer, strict=True):
            if name not in element.attrib and whole is not None:
                element.set(name, repr(whole))
        if self._box(element) is None:
            sizes = [length_match(element.get(name, "")) for name in ("width", "height")]
            width, height = (met[1] if met else "1" for met in sizes)
            element.attrib.update(width=width, height=height, viewBox=f"0 0 {width} {height}")
        return inner

    def _used(self, use: Element, viewport: Viewport) -> None:
        """Give a use of a symbol an svg of its own to refer to, which is what it stands for (SVG 2, section 5.6)."""
        href = next((use.attrib[name] for name in _HREFS if name in use.attrib), None)
        target = self.by_id.get(href[1:]) if href and href.startswith("#") else None
        if target is None:
            self.notes.append(f"use: {href!r} is not in the drawing: left out" if href else "use: refers to nothing: left out")
            return
        if tag_of(target) != "symbol":
            return
        self.count += 1
        place = Element(target.tag.removesuffix("symbol") + "svg", {**target.attrib, "id": f"contour-symbol-{self.count}"})
        self.places.append((place, target))
        self._mark(place, self.sheet.of("symbol", target.attrib) | {"display": "inline"})
        for name in ("width", "height"):
            if name in use.attrib:
                place.set(name, use.attrib.pop(name))
        self._resolve(place, "svg", {}, viewport)
        self._nested(place, viewport)
        for name in _HREFS:
            use.attrib.pop(name, None)
        use.set("href", f"#contour-symbol-{self.count}")

    # --- shapes ----------------------------------------------------------------------------------------------------------------------

    def _number(self, element: Element, tag: str, drawn: bool) -> None:
        self.count += 1
        element.set(NUMBER, str(self.count))
        if drawn:
            own = element.get("id")
            self.shapes[str(self.count)] = f"{tag} {own!r}" if own else tag
        if tag == "path":  # read by ourselves: `contours.svg_path`
            element.set(DATA, element.get("d", ""))
            element.set("d", "M0 0")
