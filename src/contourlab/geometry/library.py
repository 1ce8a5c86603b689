"""Test contours by name, with their parameters; lengths in m."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable
from functools import lru_cache
from itertools import pairwise

import numpy as np

from contourlab.errors import GeometryError, hint, refuse
from contourlab.geometry.curve import Curve, positive
from contourlab.geometry.line_and_arc import Arc, Line
from contourlab.geometry.nurbs import Nurbs
from contourlab.geometry.parametric import Ellipse, Lemniscate, Lissajous, Spiral, Star
from contourlab.geometry.path import Path

# fmt: off
# Hu et al. 2023, doi 10.1007/s00170-023-12427-5, in mm. One source ends at 54.492 instead of 54.493, which would leave the contour open.
# The smallest radius is 0.023 mm, at the tail.
_BUTTERFLY_POINTS = (
    (54.493, 52.139), (55.507, 52.139), (56.082, 49.615), (56.78, 44.971), (69.575, 51.358), (77.786, 58.573), (90.526, 67.081),
    (105.973, 63.801), (100.4, 47.326), (94.567, 39.913), (92.369, 30.485), (83.44, 33.757), (91.892, 28.509), (89.444, 20.393),
    (83.218, 15.446), (87.621, 4.83), (80.945, 9.267), (79.834, 14.535), (76.074, 8.522), (70.183, 12.55), (64.171, 16.865),
    (59.993, 22.122), (55.68, 36.359), (56.925, 24.995), (59.765, 19.828), (54.493, 14.94), (49.22, 19.828), (52.06, 24.994),
    (53.305, 36.359), (48.992, 22.122), (44.814, 16.865), (38.802, 12.551), (32.911, 8.521), (29.152, 14.535), (28.04, 9.267),
    (21.364, 4.83), (25.768, 15.447), (19.539, 20.391), (17.097, 28.512), (25.537, 33.75), (16.602, 30.496), (14.199, 39.803),
    (8.668, 47.408), (3, 63.794), (18.465, 67.084), (31.197, 58.572), (39.411, 51.358), (52.204, 44.971), (52.904, 49.614),
    (53.478, 52.139), (54.493, 52.139),
)
_BUTTERFLY_KNOTS = (
    0.0, 0.0, 0.0, 0.0, 0.0083, 0.015, 0.0361, 0.0855, 0.1293, 0.1509, 0.1931, 0.2273, 0.2435, 0.2561, 0.2692,
    0.2889, 0.317, 0.3316, 0.3482, 0.3553, 0.3649, 0.3837, 0.4005, 0.4269, 0.451, 0.466, 0.4891, 0.5, 0.5109, 0.534,
    0.5489, 0.5731, 0.5994, 0.6163, 0.6351, 0.6447, 0.6518, 0.6683, 0.683, 0.7111, 0.7307, 0.7439, 0.7565, 0.7729, 0.8069,
    0.8491, 0.8707, 0.9145, 0.9639, 0.985, 0.9917, 1.0, 1.0, 1.0, 1.0,
)
_BUTTERFLY_WEIGHTS = (
    1.0, 1.0, 1.0, 1.2, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 2.0, 1.0, 1.0, 5.0, 3.0, 1.0, 1.1, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0,
    1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.1, 1.0, 3.0, 5.0, 1.0, 1.0, 2.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.2, 1.0, 1.0, 1.0,
)
# fmt: on


def circle(radius: float = 0.02, start_angle: float = 0.0, clockwise: float = 0.0) -> Path:
    """Circle around the origin; `clockwise` 1 reverses it. The papers use 20 mm and 25 mm."""
    positive(radius=radius)
    return Path([Arc((0.0, 0.0), radius, start_angle, -2.0 * math.pi if clockwise else 2.0 * math.pi)], closed=True)


def ellipse(a: float = 0.04, b: float = 0.02) -> Path:
    """Ellipse with semi-axes a and b around the origin."""
    return Path([Ellipse(a, b)], closed=True)


def lemniscate(a: float = 0.04) -> Path:
    """Figure of eight x = a sin u, y = a sin u cos u, which crosses itself at the origin."""
    return Path([Lemniscate(a)], closed=True)


def diamond(side: float = 0.04) -> Path:
    """Square on its corner around the origin: four lines at 45 degrees, four corners."""
    positive(side=side)
    h = side / math.sqrt(2.0)
    return _closed_polygon([(h, 0.0), (0.0, h), (-h, 0.0), (0.0, -h)])


def star(radius: float = 0.03, lobes: float = 5, depth: float = 0.3) -> Path:
    """Star r = R (1 + depth cos(lobes u))."""
    return Path([Star(radius, lobes, depth)], closed=True)


def butterfly(scale: float = 1.0) -> Path:
    """Butterfly NURBS of Hu et al. 2023, doi 10.1007/s00170-023-12427-5; 383 mm long at scale 1."""
    positive(scale=scale)
    return Path([Nurbs(3, 1e-3 * scale * np.array(_BUTTERFLY_POINTS), _BUTTERFLY_KNOTS, _BUTTERFLY_WEIGHTS)], closed=True)


def line_line_circle(scale: float = 1.0) -> Path:
    """Two lines and a full circle: (0, 0), (40, 30), (60, 30) mm, then counter-clockwise around (90, 30); UBC course MECH 467."""
    positive(scale=scale)
    m = 1e-3 * scale
    a, b = (40 * m, 30 * m), (60 * m, 30 * m)
    return Path([Line((0.0, 0.0), a), Line(a, b), Arc((90 * m, 30 * m), 30 * m, math.pi, 2.0 * math.pi)])


def _closed_polygon(corners: list[tuple[float, float]]) -> Path:
    return Path([Line(a, b) for a, b in pairwise([*corners, corners[0]])], closed=True)


def square(side: float = 0.04) -> Path:
    """Square around the origin, sides along the axes, counter-clockwise from its lower left corner: four lines, four corners."""
    positive(side=side)
    h = 0.5 * side
    return _closed_polygon([(-h, -h), (h, -h), (h, h), (-h, h)])


def rectangle(width: float = 0.06, height: float = 0.04, corner_radius: float = 0.0) -> Path:
    """Rectangle around the origin, corners rounded by `corner_radius`, counter-clockwise from the lower left end of its lower side."""
    positive(width=width, height=height)
    if not 0.0 <= corner_radius < 0.5 * min(width, height):
        raise GeometryError(
            f"corner_radius = {corner_radius!r} m: must be >= 0 and below half of the shorter side; use a racetrack for round ends"
        )
    w, h, r = 0.5 * width, 0.5 * height, corner_radius
    if r == 0.0:
        return _closed_polygon([(-w, -h), (w, -h), (w, h), (-w, h)])
    curves: list[Curve] = []
    start = (-w + r, -h)
    for k, (sx, sy) in enumerate([(1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0)]):
        centre = (sx * (w - r), sy * (h - r))
        ends = [(centre[0], sy * h), (sx * w, centre[1])]
        before, after = ends if k % 2 == 0 else ends[::-1]
        curves += [Line(start, before), Arc.through(before, after, centre, 0.5 * math.pi)]
        start = after
    return Path(curves, closed=True)


def racetrack(length: float = 0.04, radius: float = 0.02) -> Path:
    """Two straights of `length` and two half circles around the origin, counter-clockwise from the left end of the lower straight."""
    positive(length=length, radius=radius)
    h, quarter = 0.5 * length, 0.5 * math.pi
    curves = [
        Line((-h, -radius), (h, -radius)),
        Arc((h, 0.0), radius, -quarter, math.pi),
        Line((h, radius), (-h, radius)),
        Arc((-h, 0.0), radius, quarter, math.pi),
    ]
    return Path(curves, closed=True)


def polygon(sides: float = 6, radius: float = 0.02) -> Path:
    """Regular polygon in a circle of `radius` around the origin, counter-clockwise from the corner at (radius, 0)."""
    positive(radius=radius)
    if not (float(sides).is_integer() and 3 <= sides <= 100_000):
        raise GeometryError(f"sides = {sides!r}: must be a whole number from 3 to 100000")
    n = int(sides)
    return _closed_polygon([(radius * math.cos(2.0 * math.pi * k / n), radius * math.sin(2.0 * math.pi * k / n)) for k in range(n)])


def spiral(inner_radius: float = 0.005, pitch: float = 0.005, turns: float = 3) -> Path:
    """Archimedean spiral around the origin, outwards and counter-clockwise from (inner_radius, 0), `pitch` per turn."""
    return Path([Spiral(inner_radius, pitch, turns)])


def helix(radius: float = 0.02, pitch: float = 0.005, turns: float = 3) -> Path:
    """Helix around the z axis from (radius, 0, 0), counter-clockwise and up by `pitch` per turn: a contour of three axes."""
    positive(radius=radius, turns=turns)
    refuse(not math.isfinite(pitch), GeometryError, f"pitch = {pitch!r} m: must be finite")
    return Path([Arc((0.0, 0.0, 0.0), radius, 0.0, 2.0 * math.pi * turns, rise=(0.0, 0.0, pitch * turns))])


def lissajous(axes: float = 3, amplitude: float = 0.02, lowest: float = 1, phase: float = math.pi / 3.0) -> Path:
    """Lissajous figure of 2 to 9 axes: axis j = 0, 1, ... is A sin((lowest + j) u + j phase); 60 degrees suit any `lowest`."""
    return Path([Lissajous(axes, amplitude, lowest, phase)], closed=True)


_CONTOURS = (circle, ellipse, lemniscate, diamond, star, butterfly, line_line_circle, square, rectangle, racetrack, polygon, spiral, helix,
             lissajous)  # fmt: skip
# A path keeps what it finds of itself, such as its parameter over arc length: studies ask for the same ones again.
_MAKERS: dict[str, Callable[..., Path]] = {maker.__name__.replace("_", "-"): lru_cache(8, typed=True)(maker) for maker in _CONTOURS}
_LENGTHS = ("radius", "a", "b", "side", "width", "height", "corner_radius", "length", "inner_radius", "pitch", "amplitude")
_UNITS = {**dict.fromkeys(_LENGTHS, "m"), "start_angle": "rad", "phase": "rad"}


def contour_names() -> tuple[str, ...]:
    """Return the names of the contours.

    Returns
    -------
    tuple of str
        Such as ``"circle"``.
    """
    return tuple(_MAKERS)


def contour_parameters(name: str) -> dict[str, tuple[float, str]]:
    """Return the parameters of a contour: name -> (default, unit).

    Raises
    ------
    GeometryError
        If there is no such contour.
    """
    if name not in _MAKERS:
        raise GeometryError(f"no contour {name!r}: {hint(name, _MAKERS)}")
    return {p.name: (float(p.default), _UNITS.get(p.name, "")) for p in inspect.signature(_MAKERS[name]).parameters.values()}


def contour(name: str, **parameters: float) -> Path:
    """Return a test contour by name.

    Parameters
    ----------
    name : str
        One of `contour_names`.
    **parameters : float [m or rad]
        Dimensions of the contour; `contourlab.geometry.contour_parameters` lists names and defaults.

    Returns
    -------
    Path

    Raises
    ------
    GeometryError
        If the name or a parameter is unknown, or a value is out of range.

    >>> round(contour("circle", radius=0.01).length, 6)
    0.062832
    """
    known = contour_parameters(name)
    for given in parameters:
        if given not in known:
            raise GeometryError(f"contour {name} has no parameter {given!r}: {hint(given, known)}")
    # An array of one number cannot be looked up.
    return _MAKERS[name](**{key: np.asarray(value).item() for key, value in parameters.items()})
