"""Learning by zero-phase filtering of the feedback."""

from __future__ import annotations

from contourlab.components.contract import param
from contourlab.components.learning.filters import advanced, moving_average
from contourlab.components.learning.law import Array, LearningLaw, LearningProblem, TrialRecord


class ZeroPhase(LearningLaw):
    """What the feedback had to give, averaged over 2 M + 1 samples, is given beforehand: u_ff <- u_ff + gamma H_M u_fb (eq 9).

    With ``target = "reference"`` it is the tracking error that is averaged. In either case, with T the closed loop from what is learned to
    what is averaged, a trial multiplies the deviation from the limit by 1 - gamma H_M T, with its lead: learning converges where the
    magnitude is below 1 at all frequencies. H_M is negative beyond its first zero, at 1/((2 M + 1) T_s): there a single average slowly
    amplifies wherever Re T > 0; ``passes = 2`` squares it. Choose M so that the first zero lies below the frequency at which the phase of
    T is -90 degrees, or give a `lead` for the delay of the loop.

    The command counts as far as the drive accepted it, so that the table of a saturating trial stays within reach of the drive. Beyond its
    ends the feedback goes on as its own mirror image. With a predictor the loop follows a position ahead of the measured one, and so does
    the table: take a law of the tracking error there.

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
    passes: float = param(default=1.0, minimum=1.0, maximum=2.0, whole=True, doc="how often the average is taken")
    lead: float = param(default=0.0, unit="s", minimum=0.0, display="ms", doc="by which the feedback is advanced, in whole servo periods")

    def revised(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        signal = trial.feedback_command if self.target == "command" else trial.tracking_error
        ahead = advanced(signal, round(self.lead / problem.servo_period))
        return table + self.gain * self.passed(ahead, problem.servo_period)

    def passed(self, signal: Array, servo_period: float) -> Array:
        return moving_average(signal, int(self.half_width), int(self.passes))
