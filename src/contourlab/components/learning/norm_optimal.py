"""Norm-optimal learning, cross-coupled where the contour error has a weight, without a matrix."""

from __future__ import annotations

from contourlab.components.contract import param
from contourlab.components.learning.law import Array, LearningLaw, LearningProblem, TrialRecord
from contourlab.components.learning.least_squares import Equation


class NormOptimal(LearningLaw):
    """The next table is the one that makes the weighted sum of the next trial's errors, of the input and of its change least.

    J = |e|^2 q + |eps|^2 q_c + |u|^2 s + |u - u_before|^2 r, e = e_before - G (u - u_before), eps = Gamma e = e - t (t.e) across the path.
    The minimum solves (G' Q G + S + R) d = G' Q e - S u_before for the change d, Q = q + Gamma' q_c Gamma: with S = 0 the errors fall
    from trial to trial, and where G can cause them they fall to zero; the larger r, the more slowly, and the less does noise enter.

    The weights are bare numbers: q and q_c for the errors, s and r in parts of max |G|^2 of each axis. The equation is solved by conjugate
    gradients, G by FFT, with the spectrum of each axis as preconditioner: memory and time grow with the number of samples, not with its
    square.

    References
    ----------
    Barton & Alleyne, "A norm optimal approach to time-varying ILC with application to a multi-axis robotic testbed", IEEE Trans. Control
    Systems Technology 19 (2011); Amann, Owens & Rogers, "Iterative learning control using optimal feedback and feedforward actions" (1996).
    """

    kind = "norm-optimal"
    example = {
        "tracking_weight": 1.0,
        "contour_weight": 2.0,
        "input_weight": 0.01,
        "change_weight": 0.2,
        "tolerance": 1e-4,
        "iterations": 7,
    }
    without_effect = ("target",)  # which the model takes care of
    reference = "Barton & Alleyne 2011"

    tracking_weight: float = param(default=1.0, minimum=0.0, maximum=1e6, doc="q, of the tracking error of each axis")
    contour_weight: float = param(default=0.0, minimum=0.0, maximum=1e6, doc="q_c, of the error across the path")
    input_weight: float = param(default=0.0, minimum=0.0, maximum=1e6, doc="s, of the table, over max |G|^2")
    change_weight: float = param(default=0.01, minimum=1e-9, maximum=1e6, doc="r, of its change in a trial, over max |G|^2")
    tolerance: float = param(default=1e-6, minimum=1e-14, maximum=0.5, doc="residual over right-hand side at which the equation is solved")
    iterations: float = param(default=200.0, minimum=1.0, maximum=1e5, whole=True, doc="most steps of the conjugate gradients")

    def revised(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        weights = (self.tracking_weight, self.contour_weight, self.input_weight, self.change_weight)
        equation = Equation.of(problem, *weights)
        right = equation.model.adjoint(equation.weighted(trial.tracking_error)) - equation.on_input * table
        return table + equation.solved(right, self.tolerance, int(self.iterations))
