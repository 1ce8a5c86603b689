"""What sensitivity, calibration and swapping share: the numbers that are moved, the runs that judge them, and a search among them."""

from contourlab.studies.space.evaluator import Evaluator
from contourlab.studies.space.numbers import Number, Space
from contourlab.studies.space.order import calibration_order
from contourlab.studies.space.search import Found, search

__all__ = ["Evaluator", "Found", "Number", "Space", "calibration_order", "search"]
