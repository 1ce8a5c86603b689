"""Linear analysis of the loop: frequency responses, margins and poles, sampled as it runs or in continuous time."""

from contourlab.analysis.axis_response import axis_response, transfer
from contourlab.analysis.margins import Margins, margins
from contourlab.analysis.response import AxisResponse
from contourlab.analysis.sampled_loop import SampledLoop, sampled_loop

__all__ = ["AxisResponse", "Margins", "SampledLoop", "axis_response", "margins", "sampled_loop", "transfer"]
