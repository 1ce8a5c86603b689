"""Laws that solve a least-squares problem over a whole trial, matrix-free."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from contourlab.arrays import Array
from contourlab.components.contract import param
from contourlab.components.learning.error_law import FilteredLaw
from contourlab.components.learning.law import InputModel, LearningLaw, LearningProblem, TrialRecord


class Equation(NamedTuple):
    """The equation (G' Q G + S + R) d = b and its preconditioner."""

    problem: LearningProblem
    model: InputModel
    tracking: float
    contour: float
    on_input: Array
    on_change: Array
    inverse: Array

    @classmethod
    def of(cls, problem: LearningProblem, tracking: float, contour: float, on_input: float, on_change: float) -> Equation:
        """Return the equation; the last two weights are relative to max |G|^2 of each axis."""
        model = problem.model
        square = np.abs(model.response) ** 2
        largest = square.max(axis=0)
        held = (on_input * largest, on_change * largest)
        # Mean part of each axis across the path, in place of its changing direction.
        across = 1.0 - (problem.tangent**2).mean(axis=0)
        return cls(problem, model, tracking, contour, *held, 1.0 / ((tracking + contour * across) * square + held[0] + held[1]))

    def weighted(self, error: Array) -> Array:
        """Return Q e. Gamma is a projection: Gamma' Gamma = Gamma."""
        return self.tracking * error + (self.contour * self.problem.across(error) if self.contour else 0.0)

    def __matmul__(self, change: Array) -> Array:
        return self.model.adjoint(self.weighted(self.model.forward(change))) + (self.on_input + self.on_change) * change

    def solved(self, right: Array, tolerance: float, iterations: int) -> Array:
        """Return d by preconditioned conjugate gradients, from zero, to a residual of `tolerance` times the right-hand side."""
        found, left = np.zeros_like(right), right.copy()
        enough = tolerance**2 * _dot(right, right)
        direction, product = np.zeros_like(right), 1.0
        for _ in range(iterations):
            if _dot(left, left) <= enough:
                break
            steep = self.model.through(left, self.inverse)
            product, before = _dot(left, steep), product
            direction = steep + (product / before) * direction
            image = self @ direction
            step = product / _dot(direction, image)
            found += step * direction
            left -= step * image
        return found


def _dot(one: Array, other: Array) -> float:
    # Not by a matrix library: these sums are short, and its threads cost more than they save.
    return float((one * other).sum())


class NormOptimal(LearningLaw):
    """The next table minimises a weighted sum of the predicted errors, the input and its change.

    J = |e|^2 q + |eps|^2 q_c + |u|^2 s + |u - u_before|^2 r, e = e_before - G (u - u_before), eps = Gamma e = e - t (t.e) across the path.
    The minimum solves (G' Q G + S + R) d = G' Q e - S u_before for the change d, Q = q + Gamma' q_c Gamma: with S = 0 the errors fall from
    trial to trial, to zero where G can cause them. A larger r slows learning and reduces the effect of noise.

    The weights have no unit: q and q_c for the errors, s and r relative to max |G|^2 of each axis. Conjugate gradients solve the equation,
    with G by FFT and the spectrum of each axis as preconditioner: memory and time grow with the number of samples, not with its square.

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
    without_effect = ("target",)  # the model contains the target
    reference = "Barton & Alleyne 2011"

    tracking_weight: float = param(default=1.0, minimum=0.0, maximum=1e6, doc="weight of each axis' tracking error, q")
    contour_weight: float = param(default=0.0, minimum=0.0, maximum=1e6, doc="weight of the error across the path, q_c")
    input_weight: float = param(default=0.0, minimum=0.0, maximum=1e6, doc="weight of the table over max |G|^2, s")
    change_weight: float = param(default=0.01, minimum=1e-9, maximum=1e6, doc="weight of its change over max |G|^2, r")
    tolerance: float = param(default=1e-6, minimum=1e-14, maximum=0.5, doc="residual over right-hand side at which the solver stops")
    iterations: float = param(default=200.0, minimum=1.0, maximum=1e5, whole=True, doc="most conjugate-gradient steps")

    def revised(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        equation = Equation.of(problem, *(self.tracking_weight, self.contour_weight, self.input_weight, self.change_weight))
        right = equation.model.adjoint(equation.weighted(trial.tracking_error)) - equation.on_input * table
        return table + equation.solved(right, self.tolerance, int(self.iterations))


TOLERANCE, ITERATIONS = 1e-6, 20
"""The first step is exact between the ends of a trial; the others correct the ends."""


class PlantInversion(FilteredLaw):
    """u <- Q (u + alpha (G' G + rho max |G|^2)^-1 G' e): the inverse of the model G, regularised where G is small.

    With the true plant G_0 a trial multiplies the deviation from the limit by Q (1 - alpha |G|^2/(|G|^2 + rho max |G|^2) G_0/G): with an
    exact model one trial leaves 1 - alpha of the deviation where G is large. It diverges where the model's phase is off by more than
    90 degrees: Q must be small there. G is the linear model of each axis alone, without coupling.

    The inverse is that over the finite trial. An inverse by frequency alone would increase the last samples with every trial, because their
    effect lies beyond the end.

    References
    ----------
    Bristow, Tharayil & Alleyne, "A survey of iterative learning control", IEEE Control Systems Magazine 26 (2006), "Plant inversion".
    """

    kind = "plant-inversion"
    example = {"gain": 0.7, "regularisation": 1e-4, "bandwidth": 200.0}
    without_effect = ("target",)  # the model contains the target
    reference = "Bristow, Tharayil & Alleyne 2006"

    gain: float = param(default=1.0, minimum=0.0, maximum=2.0, exclusive=True, doc="gain, alpha")
    regularisation: float = param(default=1e-6, minimum=0.0, maximum=1.0, exclusive=True, doc="rho, relative to max |G|^2")

    def revised(self, table: Array, trial: TrialRecord, problem: LearningProblem) -> Array:
        equation = Equation.of(problem, 1.0, 0.0, 0.0, self.regularisation)
        change = equation.solved(equation.model.adjoint(trial.tracking_error), TOLERANCE, ITERATIONS)
        return self.passed(table + self.gain * change, problem.servo_period)
