"""Geometry: curves, paths by arc length, the exact foot point, and the path table of the engine."""

from contourlab.geometry.blend import Blend
from contourlab.geometry.curve import Curve
from contourlab.geometry.library import contour, contour_names, contour_parameters
from contourlab.geometry.line_and_arc import Arc, Line
from contourlab.geometry.nurbs import BSpline, Nurbs
from contourlab.geometry.parametric import Ellipse, EllipticalArc, Lemniscate, Spiral, Star
from contourlab.geometry.path import Path
from contourlab.geometry.table import PathTable
from contourlab.geometry.transform import backwards, with_ends

__all__ = [
    "Arc",
    "BSpline",
    "Blend",
    "Curve",
    "Ellipse",
    "EllipticalArc",
    "Lemniscate",
    "Line",
    "Nurbs",
    "Path",
    "PathTable",
    "Spiral",
    "Star",
    "backwards",
    "contour",
    "contour_names",
    "contour_parameters",
    "with_ends",
]
