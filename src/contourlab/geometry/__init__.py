"""Geometry: curves, paths by arc length, the exact foot point, and the path table of the engine."""

from contourlab.geometry.curve import Curve
from contourlab.geometry.library import contour, contour_names, contour_parameters
from contourlab.geometry.line_and_arc import Arc, Line
from contourlab.geometry.nurbs import BSpline, Nurbs
from contourlab.geometry.parametric import EllipticalArc
from contourlab.geometry.path import Path
from contourlab.geometry.transform import backwards, with_ends

__all__ = [
    "Arc",
    "BSpline",
    "Curve",
    "EllipticalArc",
    "Line",
    "Nurbs",
    "Path",
    "backwards",
    "contour",
    "contour_names",
    "contour_parameters",
    "with_ends",
]
