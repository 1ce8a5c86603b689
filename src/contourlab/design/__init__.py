"""Shared tools of calibration, sensitivity and swapping: design variables, evaluation of candidates, guards, and a search."""

from contourlab.design.evaluator import Evaluator
from contourlab.design.search import Found, search
from contourlab.design.values import calibration_order
from contourlab.design.variables import DesignVariable, Space

__all__ = ["DesignVariable", "Evaluator", "Found", "Space", "calibration_order", "search"]
