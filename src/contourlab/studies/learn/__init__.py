"""Learning from trial to trial: runs, the verdict on their course, and the table that comes of them."""

from contourlab.studies.learn.growth import Growth
from contourlab.studies.learn.model import input_response, learning_problem
from contourlab.studies.learn.run import LearningRun, learn
from contourlab.studies.learn.split import Split
from contourlab.studies.learn.stopping import Stopping
from contourlab.studies.learn.table import LearnedTable
from contourlab.studies.learn.trial import TrialFigures

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
