"""Contours from files: DXF and SVG drawings, and lists of points.

Readers: `dxf`, `svg`, and `reader` for points, which also picks one by the file's suffix. `drawing` makes the curves of
shapes, and joins those that meet. `fit` fits a path to points.
"""

from contourlab.contours.drawing import Drawing, unit_size
from contourlab.contours.dxf import read_dxf
from contourlab.contours.reader import SUFFIXES, ContourReading, read_contour, read_points, study_contour
from contourlab.contours.svg import read_svg

__all__ = ["SUFFIXES", "ContourReading", "Drawing", "read_contour", "read_dxf", "read_points", "read_svg", "study_contour", "unit_size"]
