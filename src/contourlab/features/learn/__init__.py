"""Learning from trial to trial: runs, the verdict on their course, and the table that comes of them."""

from contourlab.features.learn.growth import Growth
from contourlab.features.learn.model import input_response, learning_problem
from contourlab.features.learn.run import LearningRun, learn
from contourlab.features.learn.split import Split
from contourlab.features.learn.stopping import Stopping
from contourlab.features.learn.table import LearnedTable
from contourlab.features.learn.trial import TrialFigures

__all__ = [
    "Growth",
    "LearnedTable",
    "LearningRun",
    "Split",
    "Stopping",
    "TrialFigures",
    "input_response",
    "learn",
    "learning_problem",
]
