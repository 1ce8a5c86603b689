"""Learning from trial to trial: the run, its stopping rule, and the learned table."""

from contourlab.features.learn.run import LearningRun, Stopping, learn
from contourlab.features.learn.table import LearnedTable
from contourlab.features.learn.trial import TrialFigures, input_response, learning_problem

__all__ = ["LearnedTable", "LearningRun", "Stopping", "TrialFigures", "input_response", "learn", "learning_problem"]
