"""Laws that learn from the tracking error: gains, a lead, and the Q-filter."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from contourlab.components.contract import param
from contourlab.components.learning.filters import advanced, q_filter
from contourlab.components.learning.law import Array, LearningLaw, LearningProblem, TrialRecord
from contourlab.errors import ParameterError


class FilteredLaw(LearningLaw):
    """u <- Q (u + what the law adds), Q a Butterworth low-pass run forwards and backwards."""

    bandwidth: float = param(default=math.inf, unit="rad/s", minimum=0.0, exclusive=True, doc="w_q of the Q-filter; inf: no filter")
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
        doc='divides the gains with target = "reference": command per metre of reference',
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


class PType(ErrorLaw):
    """u <- Q (u + L e(k + lead)): the tracking error times a gain.

    With G from what is learned to the position, a trial multiplies the deviation from the limit by Q (1 - L G): it converges steadily if
    the magnitude of this is below 1 at all frequencies. Without Q there is a frequency beyond which |1 - L G| > 1, where the phase of G
    passes -90 degrees; the Q-filter is to lie below it.

    References
    ----------
    Bristow, Tharayil & Alleyne, "A survey of iterative learning control", IEEE Control Systems Magazine 26 (2006), eqs (6) and (17).
    """

    kind = "p-type"
    example = {"gain": 30.0, "bandwidth": 120.0, "lead": 2e-3, "stiffness": 50.0}
    reference = "Bristow, Tharayil & Alleyne 2006"

    gain: float = param(unit="{command}/m", minimum=0.0, exclusive=True, display="{command}/mm", doc="L: command for an error")

    def addition(self, trial: TrialRecord, problem: LearningProblem) -> Array:
        return self.gain * trial.tracking_error


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


class CrossCoupledLearning(ErrorLaw):
    """u <- Q (u + L e + L_c eps): the tracking error e and the contour error eps, the vector from the tool to the path.

    In the plane eps = (-C_x, C_y) eps with the coupling gains of the contour, u_x <- Q (u_x + L_x e_x - C_x L_c eps) and
    u_y <- Q (u_y + L_y e_y + C_y L_c eps); as a vector it is the same in any number of axes. Across the path both gains act, along it only
    L: with matched axes the deviation across the path shrinks by Q (1 - (L + L_c) G) from trial to trial.

    References
    ----------
    Barton & Alleyne, "A cross-coupled iterative learning control design for precision motion control", IEEE Trans. Control Systems
    Technology 16 (2008).
    """

    kind = "cross-coupled"
    example = {"gain": 20.0, "contour_gain": 30.0, "bandwidth": 120.0, "lead": 1e-3, "stiffness": 50.0}
    reference = "Barton & Alleyne 2008"

    gain: float = param(unit="{command}/m", minimum=0.0, display="{command}/mm", doc="L: command for a tracking error")
    contour_gain: float = param(unit="{command}/m", minimum=0.0, display="{command}/mm", doc="L_c: command for a contour error")

    @property
    def needs_contour_error(self) -> bool:
        return True

    def addition(self, trial: TrialRecord, problem: LearningProblem) -> Array:
        contour = trial.contour_error
        assert contour is not None  # asked for above
        return self.gain * trial.tracking_error + self.contour_gain * contour
