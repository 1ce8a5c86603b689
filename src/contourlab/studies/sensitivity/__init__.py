"""Which numbers of a machine and its controller the contour error depends on: one at a time, a little, and over all at once."""

from contourlab.studies.sensitivity.curves import Curve, Minimum, Stretch, curves
from contourlab.studies.sensitivity.distribution import KINDS, Distribution, distributions
from contourlab.studies.sensitivity.figure import FIGURES, Figure, failure_level, figure_called
from contourlab.studies.sensitivity.indices import (
    MorrisIndices,
    SobolIndices,
    morris_indices,
    morris_points,
    saltelli_points,
    sobol_indices,
)
from contourlab.studies.sensitivity.local import Local, Slope, local
from contourlab.studies.sensitivity.outcome import Outcome, outcome
from contourlab.studies.sensitivity.runs import Kept, Runs
from contourlab.studies.sensitivity.study import PARTS, Plan, Study, holds, sensitivity_study
from contourlab.studies.sensitivity.verdict import Ranking, ranking, verdict

__all__ = [
    "FIGURES",
    "KINDS",
    "PARTS",
    "Curve",
    "Distribution",
    "Figure",
    "Kept",
    "Local",
    "Minimum",
    "MorrisIndices",
    "Outcome",
    "Plan",
    "Ranking",
    "Runs",
    "Slope",
    "SobolIndices",
    "Stretch",
    "Study",
    "curves",
    "distributions",
    "failure_level",
    "figure_called",
    "holds",
    "local",
    "morris_indices",
    "morris_points",
    "outcome",
    "ranking",
    "saltelli_points",
    "sensitivity_study",
    "sobol_indices",
    "verdict",
]
