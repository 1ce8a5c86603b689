"""Findings on learning that an analysis predicts."""

from __future__ import annotations

import math
from collections.abc import Iterator

from contourlab.analysis.learning.learning_analysis import LearningAnalysis
from contourlab.analysis.linear.margins import doubling
from contourlab.components.learning.error_law import ZeroPhase
from contourlab.findings import Finding, finding

GROWTH = 1e-6
"""Tolerance above 1 for the rounding of a factor."""
RUNAWAY = 10.0
"""Learning runs away if an error doubles within this many trials."""


def learning_findings(analysis: LearningAnalysis) -> Iterator[Finding]:
    """Yield predicted faults, and better settings from the design rule."""
    frequency, factor = analysis.response.worst_radius
    grows = factor > 1.0 + GROWTH
    if grows:
        code = "CL315" if doubling(factor) <= RUNAWAY else "CL310"
        yield finding(code, frequency=_hertz(frequency), growth=factor - 1.0, doubling=doubling(factor))
    elif analysis.response.worst_norm[1] > 1.0 + GROWTH:
        at, size = analysis.response.worst_norm
        yield finding("CL311", frequency=_hertz(at), growth=size - 1.0)
    design = analysis.design
    if design is not None and design.worst_factor < factor:
        yield finding(
            "CL312", half_width=design.half_width, gain=design.gain, passes=design.passes, lead=design.lead,
            bandwidth=_hertz(design.bandwidth), growth=max(design.worst_factor - 1.0, 0.0),
        )  # fmt: skip
    elif design is None and grows and isinstance(analysis.law, ZeroPhase):
        yield finding("CL313")
    if analysis.lifted is not None and analysis.lifted.radius > 1.0 + 1e-4 and not grows:
        yield finding("CL314", growth=analysis.lifted.radius - 1.0, doubling=doubling(analysis.lifted.radius))


def _hertz(omega: float) -> float:
    return omega / (2.0 * math.pi)
