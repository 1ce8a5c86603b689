"""SVG path data, read up to the first error as the standard requires, and the CSS that decides visibility and size."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping

import numpy as np

from contourlab.arrays import Array
from contourlab.contours.shapes import ConicShape, LineShape, Shape, SplineShape

LARGEST = 1e12
"""Larger numbers [user units] are errors; their squares would overflow."""
_BLANKS = " \t\n\f\r"
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII)
_COUNT = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}
"""Number of arguments of each command."""


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
    at, first = _after_blanks(data, 0), True
    while at < len(data):
        command = data[at]
        if command.upper() not in _COUNT:
            raise _DataError(at, f"expected a command, not {command!r}")
        if first and command not in "Mm":
            raise _DataError(at, f"expected M or m before {command!r}")
        first = False
        at += 1
        if command in "Zz":
            yield command, []
            at = _after_blanks(data, at)
            continue
        again = False
        while True:
            numbers, at = _numbers(data, at, command.upper(), again)
            yield command, numbers
            # Further pairs of a move are lines.
            command, again = {"M": "L", "m": "l"}.get(command, command), True
            after = _after_blanks(data, at)
            if after == len(data) or data[after] not in "+-.,0123456789":
                at = after
                break


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
        origin = self.here if command.islower() else np.zeros(2)
        kind = command.upper()
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
            self._bezier(points)
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

    def _bezier(self, points: list[Array]) -> None:
        if any(np.any(point != self.here) for point in points):
            self.open.append(SplineShape.bezier(self.here, *points))
        self.control, self.here = points[-2], points[-1]

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
    last = math.atan2(-half[1] - centre[1], -half[0] - centre[0])
    angle = (last - first) % (2.0 * math.pi) or 2.0 * math.pi
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
