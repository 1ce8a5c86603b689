"""Linear analysis of the loop: responses, margins and poles, sampled as it runs or in continuous time; identification of an axis."""

from contourlab.analysis.axis_response import axis_response, transfer
from contourlab.analysis.contour_transfer import (
    ContourMargins,
    ContourTransfer,
    contour_error_transfer,
    contour_margins,
    contour_transfer,
)
from contourlab.analysis.identification import Estimate, SecondOrderFit, identify_delay, identify_gain, identify_second_order
from contourlab.analysis.internal_stability import InternalStability, internal_stability
from contourlab.analysis.learning_analysis import LearningAnalysis, learning_analysis
from contourlab.analysis.learning_rules import LearningDesign, design_zero_phase
from contourlab.analysis.margins import Margins, margins
from contourlab.analysis.response import AxisResponse
from contourlab.analysis.sampled_loop import SampledLoop, sampled_loop
from contourlab.analysis.zpetc import ZeroPhaseDesign, zpetc_design, zpetc_from_polynomials

__all__ = [
    "AxisResponse",
    "ContourMargins",
    "ContourTransfer",
    "Estimate",
    "InternalStability",
    "LearningAnalysis",
    "LearningDesign",
    "Margins",
    "SampledLoop",
    "SecondOrderFit",
    "ZeroPhaseDesign",
    "axis_response",
    "contour_error_transfer",
    "contour_margins",
    "contour_transfer",
    "design_zero_phase",
    "identify_delay",
    "identify_gain",
    "identify_second_order",
    "internal_stability",
    "learning_analysis",
    "margins",
    "sampled_loop",
    "transfer",
    "zpetc_design",
    "zpetc_from_polynomials",
]
