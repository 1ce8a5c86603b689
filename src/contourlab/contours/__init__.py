"""Contours from files: DXF and SVG drawings, and lists of points.

Readers: `dxf`, `svg`, and `reader` for points, which also picks one by the file's suffix. `drawing` makes the curves of
shapes, and joins those that meet. `fit` fits a path to points.
"""

from contourlab.contours.drawing import unit_size
from contourlab.contours.reader import SUFFIXES, ContourReading, read_contour, study_contour

__all__ = ["SUFFIXES", "ContourReading", "read_contour", "study_contour", "unit_size"]
