"""Geometry: curves, paths by arc length, the exact foot point, and the engine's table of a path."""

from contourlab.geometry.arc import Arc
from contourlab.geometry.conics import Ellipse, Lemniscate, Star
from contourlab.geometry.curve import Curve
from contourlab.geometry.foot import FootPoint
from contourlab.geometry.library import contour, contour_names, contour_parameters
from contourlab.geometry.line import Line
from contourlab.geometry.nurbs import BSpline, Nurbs
from contourlab.geometry.path import Path
from contourlab.geometry.table import PathTable

__all__ = [
    "Arc",
    "BSpline",
    "Curve",
    "Ellipse",
    "FootPoint",
    "Lemniscate",
    "Line",
    "Nurbs",
    "Path",
    "PathTable",
    "Star",
    "contour",
    "contour_names",
    "contour_parameters",
]
