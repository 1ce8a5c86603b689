"""PD-type learning with a Q-filter."""

from __future__ import annotations

import numpy as np

from contourlab.components.contract import param
from contourlab.components.learning.error_law import ErrorLaw
from contourlab.components.learning.law import Array, LearningProblem, TrialRecord


class PDType(ErrorLaw):
    """u <- Q (u + L_p e + L_d e'): the tracking error and its derivative, by central differences.

    The derivative turns the phase of the loop forwards, so that more of it can be learned than by P-type; in other respects as there.

    References
    ----------
    Bristow, Tharayil & Alleyne, "A survey of iterative learning control", IEEE Control Systems Magazine 26 (2006), section "PD-type".
    """

    kind = "pd-type"
    example = {"gain": 30.0, "derivative_gain": 0.5, "bandwidth": 120.0, "lead": 1e-3, "stiffness": 50.0}
    reference = "Bristow, Tharayil & Alleyne 2006"

    gain: float = param(unit="{command}/m", minimum=0.0, display="{command}/mm", doc="L_p: command for an error")
    derivative_gain: float = param(unit="{command}*s/m", minimum=0.0, display="{command}*s/mm", doc="L_d: command for an error's rate")

    def addition(self, trial: TrialRecord, problem: LearningProblem) -> Array:
        error = trial.tracking_error
        if len(error) < 2:
            return self.gain * error
        return self.gain * error + self.derivative_gain * np.asarray(np.gradient(error, problem.servo_period, axis=0))
