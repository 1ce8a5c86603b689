"""Laws that learn from the tracking error or the feedback command."""

from __future__ import annotations

import math

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import param
from contourlab.components.learning.law import LearningLaw, LearningProblem, TrialRecord, advanced, moving_average, q_filter
from contourlab.errors import ParameterError


class FilteredLaw(LearningLaw):
    """Base of laws with a Q-filter: u <- Q (u + addition), Q a Butterworth low-pass run forwards and backwards."""

    bandwidth: float = param(default=math.inf, unit="rad/s", minimum=0.0, exclusive=True, doc="w_q of the Q-filter; inf: no filter")
    order: float = param(default=2.0, minimum=1.0, maximum=8.0, whole=True, doc="of the Butterworth filter")

    def passed(self, signal: Array, servo_period: float) -> Array:
        return q_filter(signal, self.bandwidth, int(self.order), servo_period)


class ErrorLaw(FilteredLaw):
    """Base of laws that add gains times the errors `lead` later."""

    lead: float = param(default=0.0, unit="s", minimum=0.0, display="ms", doc="advance of the errors, in whole servo periods")
    stiffness: float = param(
        default=math.inf,
        unit="{command}/m",
        minimum=0.0,
        exclusive=True,
        display="{command}/mm",
        doc='divides the gains with target = "reference": command per metre of reference',
    )

    def check_values(self) -> None:
        if self.target == "reference" and math.isinf(self.stiffness):
            raise ParameterError("stiffness", "not given", 'given with target = "reference", because the gains are divided by it')

    def addition(self, trial: TrialRecord, problem: LearningProblem) -> Array:
        """Return the addition from a trial (n_sample, n_axis) [command unit], before lead and filter."""
        raise NotImplementedError

    def revised(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        added = advanced(self.addition(trial, problem), round(self.lead / problem.servo_period))
        return self.passed(table + (1.0 if self.target == "command" else 1.0 / self.stiffness) * added, problem.servo_period)


class PType(ErrorLaw):
    """u <- Q (u + L e(k + lead)): the tracking error times a gain.

    With G from the learned table to the position, a trial multiplies the deviation from the limit by Q (1 - L G): convergence is monotonic
    if its magnitude is below 1 at all frequencies. Without Q, |1 - L G| > 1 beyond the frequency where the phase of G passes -90 degrees;
    set the Q-filter below it.

    References
    ----------
    Bristow, Tharayil & Alleyne, "A survey of iterative learning control", IEEE Control Systems Magazine 26 (2006), eqs (6) and (17).
    """

    kind = "p-type"
    example = {"gain": 30.0, "bandwidth": 120.0, "lead": 2e-3, "stiffness": 50.0}
    reference = "Bristow, Tharayil & Alleyne 2006"

    gain: float = param(unit="{command}/m", minimum=0.0, exclusive=True, display="{command}/mm", doc="command per error, L")

    def addition(self, trial: TrialRecord, problem: LearningProblem) -> Array:
        return self.gain * trial.tracking_error


class PDType(ErrorLaw):
    """u <- Q (u + L_p e + L_d e'): the tracking error and its derivative, by central differences.

    The derivative adds phase lead, so that it can learn up to higher frequencies than P-type. The rest is as for P-type.

    References
    ----------
    Bristow, Tharayil & Alleyne, "A survey of iterative learning control", IEEE Control Systems Magazine 26 (2006), section "PD-type".
    """

    kind = "pd-type"
    example = {"gain": 30.0, "derivative_gain": 0.5, "bandwidth": 120.0, "lead": 1e-3, "stiffness": 50.0}
    reference = "Bristow, Tharayil & Alleyne 2006"

    gain: float = param(unit="{command}/m", minimum=0.0, display="{command}/mm", doc="command per error, L_p")
    derivative_gain: float = param(unit="{command}*s/m", minimum=0.0, display="{command}*s/mm", doc="command per error rate, L_d")

    def addition(self, trial: TrialRecord, problem: LearningProblem) -> Array:
        error = trial.tracking_error
        if len(error) < 2:
            return self.gain * error
        return self.gain * error + self.derivative_gain * np.asarray(np.gradient(error, problem.servo_period, axis=0))


class CrossCoupledLearning(ErrorLaw):
    """u <- Q (u + L e + L_c eps): the tracking error e and the contour error eps, the vector from the tool to the path.

    In the plane eps = (-C_x, C_y) eps with the coupling gains of the contour, u_x <- Q (u_x + L_x e_x - C_x L_c eps) and u_y <- Q
    (u_y + L_y e_y + C_y L_c eps); the vector form holds for any number of axes. Across the path both gains act, along it only L: with
    matched axes each trial multiplies the deviation across the path by Q (1 - (L + L_c) G).

    References
    ----------
    Barton & Alleyne, "A cross-coupled iterative learning control design for precision motion control", IEEE Trans. Control Systems
    Technology 16 (2008).
    """

    kind = "cross-coupled"
    example = {"gain": 20.0, "contour_gain": 30.0, "bandwidth": 120.0, "lead": 1e-3, "stiffness": 50.0}
    reference = "Barton & Alleyne 2008"

    gain: float = param(unit="{command}/m", minimum=0.0, display="{command}/mm", doc="command per tracking error, L")
    contour_gain: float = param(unit="{command}/m", minimum=0.0, display="{command}/mm", doc="command per contour error, L_c")

    @property
    def needs_contour_error(self) -> bool:
        return True

    def addition(self, trial: TrialRecord, problem: LearningProblem) -> Array:
        contour = trial.contour_error
        assert contour is not None  # see needs_contour_error
        return self.gain * trial.tracking_error + self.contour_gain * contour


class ZeroPhase(LearningLaw):
    """Add the feedback command, averaged over 2 M + 1 samples, to the feedforward: u_ff <- u_ff + gamma H_M u_fb (eq 9).

    With ``target = "reference"`` the tracking error is averaged instead. Let T be the closed loop from the learned table to the averaged
    signal, advanced by `lead`. A trial multiplies the deviation from the limit by 1 - gamma H_M T: learning converges if its magnitude is
    below 1 at all frequencies. H_M is negative beyond its first zero, at 1/((2 M + 1) T_s): there a single average slowly amplifies where
    Re T > 0; ``passes = 2`` squares it. Choose M so that the first zero lies below the frequency at which the phase of T is -90 degrees, or
    give a `lead` for the delay of the loop.

    Only the command that the drive accepted counts, so that the table of a saturating trial stays within reach of the drive. At its ends
    the feedback is continued by its mirror image. With a predictor the loop follows a position ahead of the measured one, and so does the
    table: use a law of the tracking error there.

    References
    ----------
    Gecer Ulu, Ulu & Cakmakci, "Design and analysis of a modular learning based cross-coupled control algorithm for multi-axis precision
    positioning systems", eq (9), gamma = 0.2 and M = 11; Tan, Dou, Chen & Lee, IEEE Trans. Control Systems Technology 9 (2001).
    """

    kind = "zero-phase"
    example = {"gain": 0.2, "half_width": 11, "passes": 1, "lead": 2e-3}
    reference = "Gecer Ulu et al., eq 9"

    gain: float = param(default=0.2, minimum=0.0, maximum=2.0, exclusive=True, doc="gamma", source="Gecer Ulu et al., section 3.1")
    half_width: float = param(
        default=11.0, minimum=0.0, maximum=1e6, whole=True, doc="M: mean over 2 M + 1 samples", source="Gecer Ulu et al., section 3.1"
    )
    passes: float = param(default=1.0, minimum=1.0, maximum=2.0, whole=True, doc="number of averagings")
    lead: float = param(default=0.0, unit="s", minimum=0.0, display="ms", doc="advance of the feedback, in whole servo periods")

    def revised(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        signal = trial.feedback_command if self.target == "command" else trial.tracking_error
        return table + self.gain * self.passed(advanced(signal, round(self.lead / problem.servo_period)), problem.servo_period)

    def passed(self, signal: Array, servo_period: float) -> Array:
        return moving_average(signal, int(self.half_width), int(self.passes))
