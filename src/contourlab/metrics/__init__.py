"""Metrics: figures of a run from positions and the path alone, without knowledge of the controller."""

from contourlab.metrics.circles import (
    Bidirectional,
    CircleBacklash,
    CircleFigures,
    backlash_from_circle,
    backlash_of_runs,
    bidirectional,
    circle_figures,
    circles_of,
)
from contourlab.metrics.figures import AxisFigures, ErrorFigures, Metrics, judged_part, summarise
from contourlab.metrics.judge import judge
from contourlab.metrics.lost_motion import LostMotion, lost_motion_from_pair
from contourlab.metrics.reversals import ReversalFigures, Spike, reversal_figures, reversal_spikes

__all__ = [
    "AxisFigures",
    "Bidirectional",
    "CircleBacklash",
    "CircleFigures",
    "ErrorFigures",
    "LostMotion",
    "Metrics",
    "ReversalFigures",
    "Spike",
    "backlash_from_circle",
    "backlash_of_runs",
    "bidirectional",
    "circle_figures",
    "circles_of",
    "judge",
    "judged_part",
    "lost_motion_from_pair",
    "reversal_figures",
    "reversal_spikes",
    "summarise",
]
