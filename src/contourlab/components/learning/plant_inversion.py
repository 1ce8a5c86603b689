"""Learning through the inverse of the model."""

from __future__ import annotations

from contourlab.components.contract import param
from contourlab.components.learning.error_law import FilteredLaw
from contourlab.components.learning.law import Array, LearningProblem, TrialRecord
from contourlab.components.learning.least_squares import Equation

TOLERANCE, ITERATIONS = 1e-6, 20
"""Between the ends of a trial the first step is exact; the others see to the ends."""


class PlantInversion(FilteredLaw):
    """u <- Q (u + alpha (G' G + rho max |G|^2)^-1 G' e): the inverse of the model G, held back where G is small.

    With the true plant G_0 a trial multiplies the deviation from the limit by Q (1 - alpha |G|^2/(|G|^2 + rho max |G|^2) G_0/G): with an
    exact model one trial takes away all but 1 - alpha where G is large. It diverges where the model's phase is off by more than 90 degrees:
    there Q has to be small. G is that of each axis alone, without coupling and without what is not linear.

    It is the inverse on the trial, which ends: the inverse by frequencies alone would take the last samples, whose effect is not seen any
    more, further with every trial.

    References
    ----------
    Bristow, Tharayil & Alleyne, "A survey of iterative learning control", IEEE Control Systems Magazine 26 (2006), "Plant inversion".
    """

    kind = "plant-inversion"
    example = {"gain": 0.7, "regularisation": 1e-4, "bandwidth": 200.0}
    without_effect = ("target",)  # which the model takes care of
    reference = "Bristow, Tharayil & Alleyne 2006"

    gain: float = param(default=1.0, minimum=0.0, maximum=2.0, exclusive=True, doc="alpha")
    regularisation: float = param(
        default=1e-6, minimum=0.0, maximum=1.0, exclusive=True, doc="rho: |G|^2 over its largest value below which the inverse is held back"
    )

    def revised(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        equation = Equation.of(problem, 1.0, 0.0, 0.0, self.regularisation)
        change = equation.solved(equation.model.adjoint(trial.tracking_error), TOLERANCE, ITERATIONS)
        return self.passed(table + self.gain * change, problem.servo_period)
