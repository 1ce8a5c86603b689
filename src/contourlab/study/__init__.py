"""One core for all studies: variables, evaluation of candidates, guards, search, executors and checkpoints."""

from contourlab.study.runner import Runner, Setting
from contourlab.study.search import Found, search
from contourlab.study.space import DesignVariable, Space, calibration_order

__all__ = ["DesignVariable", "Found", "Runner", "Setting", "Space", "calibration_order", "search"]
