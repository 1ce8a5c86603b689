"""What sensitivity, calibration and swapping share: the numbers that are moved, the runs that judge them, and a search among them."""

from contourlab.design.evaluator import Evaluator
from contourlab.design.numbers import Number, Space
from contourlab.design.order import calibration_order
from contourlab.design.search import Found, search

__all__ = ["Evaluator", "Found", "Number", "Space", "calibration_order", "search"]
