"""Linear models of the loop, from the components' own numbers: frequency responses, margins, poles."""

from contourlab.analysis.axis_response import AxisResponse, Margins, axis_response, margins, transfer

__all__ = ["AxisResponse", "Margins", "axis_response", "margins", "transfer"]
