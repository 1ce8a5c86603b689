"""What the laws that learn from the tracking error have in common: gains, a lead, and the Q-filter."""

from __future__ import annotations

import math
from typing import Any

from contourlab.components.contract import param
from contourlab.components.learning.filters import advanced, q_filter
from contourlab.components.learning.law import Array, LearningLaw, LearningProblem, TrialRecord
from contourlab.errors import ParameterError


class FilteredLaw(LearningLaw):
    """u <- Q (u + what the law adds), Q a Butterworth low-pass run forwards and backwards."""

    bandwidth: float = param(
        default=math.inf, unit="rad/s", minimum=0.0, exclusive=True, doc="w_q of the Q-filter, 1/(1 + (w/w_q)^(2 order)); infinite for none"
    )
    order: float = param(default=2.0, minimum=1.0, maximum=8.0, whole=True, doc="of the Butterworth filter that is run both ways")

    def passed(self, signal: Array, servo_period: float) -> Array:
        return q_filter(signal, self.bandwidth, int(self.order), servo_period)


class ErrorLaw(FilteredLaw):
    """A law that adds gains times errors of `lead` later."""

    lead: float = param(default=0.0, unit="s", minimum=0.0, display="ms", doc="by which the errors are advanced, in whole servo periods")
    stiffness: float = param(
        default=math.inf,
        unit="{command}/m",
        minimum=0.0,
        exclusive=True,
        display="{command}/mm",
        doc='wanted with target = "reference": the command that a metre of reference stands for; the gains are divided by it',
    )

    def __init__(self, **values: Any) -> None:
        super().__init__(**values)
        if self.target == "reference" and math.isinf(self.stiffness):
            raise ParameterError("stiffness", "not given", 'given with target = "reference": the gains, commands for an error, are over it')

    def addition(self, trial: TrialRecord, problem: LearningProblem) -> Array:
        """Return what is learned from a trial (n_sample, n_axis) [command unit], lead and filter left out."""
        # What tells one law from another.
        raise NotImplementedError

    def revised(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        added = advanced(self.addition(trial, problem), round(self.lead / problem.servo_period))
        scale = 1.0 if self.target == "command" else 1.0 / self.stiffness
        return self.passed(table + scale * added, problem.servo_period)
