"""P-type learning with a Q-filter."""

from __future__ import annotations

from contourlab.components.contract import param
from contourlab.components.learning.error_law import ErrorLaw
from contourlab.components.learning.law import Array, LearningProblem, TrialRecord


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
