"""Which numbers of a machine and its controller the contour error depends on: one at a time, a little, and over all at once."""

from contourlab.features.sensitivity.curves import Curve, Minimum, Stretch, curves
from contourlab.features.sensitivity.distribution import KINDS, Distribution, distributions
from contourlab.features.sensitivity.figure import FIGURES, Figure, failure_level, figure_called
from contourlab.features.sensitivity.indices import (
    MorrisIndices,
    SobolIndices,
    morris_indices,
    morris_points,
    saltelli_points,
    sobol_indices,
)
from contourlab.features.sensitivity.local import Local, Slope, local
from contourlab.features.sensitivity.outcome import Outcome, outcome
from contourlab.features.sensitivity.runs import Kept, Runs
from contourlab.features.sensitivity.study import PARTS, Plan, Study, holds, sensitivity_study
from contourlab.features.sensitivity.verdict import Ranking, ranking, verdict

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
