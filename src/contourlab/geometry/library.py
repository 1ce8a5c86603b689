"""Test contours by name, with their parameters; lengths in m."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable
from itertools import pairwise

import numpy as np

from contourlab.errors import GeometryError
from contourlab.geometry import butterfly as butterfly_data
from contourlab.geometry.arc import Arc
from contourlab.geometry.conics import Ellipse, Lemniscate, Star
from contourlab.geometry.line import Line
from contourlab.geometry.nurbs import Nurbs
from contourlab.geometry.path import Path

__all__ = ["contour", "contour_names", "contour_parameters"]


def circle(radius: float = 0.02, start_angle: float = 0.0, clockwise: float = 0.0) -> Path:
    """Circle around the origin; `clockwise` 1 turns its sense. The papers use 20 mm and 25 mm."""
    if not (radius > 0.0 and math.isfinite(radius)):
        raise GeometryError(f"radius = {radius!r}: must be > 0 m and finite")
    return Path([Arc((0.0, 0.0), radius, start_angle, -2.0 * math.pi if clockwise else 2.0 * math.pi)], closed=True)


def ellipse(a: float = 0.04, b: float = 0.02) -> Path:
    """Ellipse with semi-axes a and b around the origin."""
    return Path([Ellipse(a, b)], closed=True)


def lemniscate(a: float = 0.04) -> Path:
    """Figure of eight x = a sin u, y = a sin u cos u, which crosses itself at the origin."""
    return Path([Lemniscate(a)], closed=True)


def diamond(side: float = 0.04) -> Path:
    """Square on its corner around the origin: four lines at 45 degrees, four corners."""
    if not (side > 0.0 and math.isfinite(side)):
        raise GeometryError(f"side = {side!r}: must be > 0 m and finite")
    h = side / math.sqrt(2.0)
    corners = [(h, 0.0), (0.0, h), (-h, 0.0), (0.0, -h), (h, 0.0)]
    return Path([Line(a, b) for a, b in pairwise(corners)], closed=True)


def star(radius: float = 0.03, lobes: float = 5, depth: float = 0.3) -> Path:
    """Star r = R (1 + depth cos(lobes u))."""
    return Path([Star(radius, lobes, depth)], closed=True)


def butterfly(scale: float = 1.0) -> Path:
    """The butterfly NURBS of the literature, Hu et al. 2023, doi 10.1007/s00170-023-12427-5; 383 mm long at scale 1."""
    if not (scale > 0.0 and math.isfinite(scale)):
        raise GeometryError(f"scale = {scale!r}: must be > 0 and finite")
    points = 1e-3 * scale * np.array(butterfly_data.POINTS)
    return Path([Nurbs(butterfly_data.DEGREE, points, butterfly_data.KNOTS, butterfly_data.WEIGHTS)], closed=True)


def line_line_circle(scale: float = 1.0) -> Path:
    """Two lines and a full circle: (0, 0), (40, 30), (60, 30) mm, then counter-clockwise around (90, 30); UBC course MECH 467."""
    if not (scale > 0.0 and math.isfinite(scale)):
        raise GeometryError(f"scale = {scale!r}: must be > 0 and finite")
    m = 1e-3 * scale
    curves = [
        Line((0.0, 0.0), (40 * m, 30 * m)),
        Line((40 * m, 30 * m), (60 * m, 30 * m)),
        Arc((90 * m, 30 * m), 30 * m, math.pi, 2.0 * math.pi),
    ]
    return Path(curves)


_MAKERS: dict[str, Callable[..., Path]] = {
    "circle": circle,
    "ellipse": ellipse,
    "lemniscate": lemniscate,
    "diamond": diamond,
    "star": star,
    "butterfly": butterfly,
    "line-line-circle": line_line_circle,
}
_UNITS = {"radius": "m", "a": "m", "b": "m", "side": "m", "start_angle": "rad"}


def contour_names() -> tuple[str, ...]:
    """Return the names of the contours."""
    return tuple(_MAKERS)


def contour_parameters(name: str) -> dict[str, tuple[float, str]]:
    """Return the parameters of a contour: name -> (default, unit).

    Raises
    ------
    GeometryError
        If there is no such contour.
    """
    if name not in _MAKERS:
        raise GeometryError(f"no contour {name!r}; there are: {', '.join(_MAKERS)}")
    signature = inspect.signature(_MAKERS[name])
    return {p.name: (float(p.default), _UNITS.get(p.name, "")) for p in signature.parameters.values()}


def contour(name: str, **parameters: float) -> Path:
    """Return a test contour by name.

    Parameters
    ----------
    name : str
        One of `contour_names`.
    **parameters : float
        Those of `contour_parameters`, in m and rad; their defaults where not given.

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
            raise GeometryError(f"contour {name} has no parameter {given!r}; there are: {', '.join(known)}")
    return _MAKERS[name](**parameters)
