"""Contours out of files: DXF and SVG drawings, and points.

Inside: `shapes` (lines, conics and splines under affine maps), `splines` (splines as files have them), `dxf`, `svg` and `points` (the
readers), `svg_tree`, `svg_style` and `svg_path` (what an SVG drawing says: sizes and uses, what is seen, path data), `fit` (splines along
points), `chains` (what lies end to end), `drawing` (what a drawing holds, and the choice of a chain), `reader` (the door).
"""

from contourlab.contours.chains import Chain
from contourlab.contours.drawing import Drawing, LeftOut, unit_size
from contourlab.contours.dxf import read_dxf
from contourlab.contours.fit import PointFit
from contourlab.contours.points import read_points
from contourlab.contours.reader import SUFFIXES, ContourReading, read_contour, study_contour
from contourlab.contours.svg import read_svg

__all__ = [
    "SUFFIXES",
    "Chain",
    "ContourReading",
    "Drawing",
    "LeftOut",
    "PointFit",
    "read_contour",
    "read_dxf",
    "read_points",
    "read_svg",
    "study_contour",
    "unit_size",
]
