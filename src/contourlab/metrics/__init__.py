"""Metrics: the judge of a run, from positions and the path alone; it knows no controller."""

from contourlab.metrics.circles import (
    Bidirectional,
    CircleFigures,
    bidirectional,
    circle_figures,
    circles_of,
    minimum_zone,
)
from contourlab.metrics.figures import AxisFigures, ErrorFigures, Metrics, Place, evaluation_window, summarise
from contourlab.metrics.judge import judge
from contourlab.metrics.reversals import Spike, reversal_spikes

__all__ = [
    "AxisFigures",
    "Bidirectional",
    "CircleFigures",
    "ErrorFigures",
    "Metrics",
    "Place",
    "Spike",
    "bidirectional",
    "circle_figures",
    "circles_of",
    "evaluation_window",
    "judge",
    "minimum_zone",
    "reversal_spikes",
    "summarise",
]
