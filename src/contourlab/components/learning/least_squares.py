"""The least-squares problem of a whole trial, solved without a matrix."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from contourlab.components.learning.law import Array, InputModel, LearningProblem


class Equation(NamedTuple):
    """(G' Q G + S + R) d = b and what its solution takes."""

    problem: LearningProblem
    model: InputModel
    tracking: float
    contour: float
    on_input: Array
    on_change: Array
    inverse: Array

    @classmethod
    def of(cls, problem: LearningProblem, tracking: float, contour: float, on_input: float, on_change: float) -> Equation:
        """Return the equation; the last two weights are in parts of max |G|^2 of each axis."""
        model = problem.model
        square = np.abs(model.response) ** 2
        largest = square.max(axis=0)
        held = (on_input * largest, on_change * largest)
        # As if the path went its own way on the average: the part of each axis that lies across it.
        across = 1.0 - (problem.tangent**2).mean(axis=0)
        inverse = 1.0 / ((tracking + contour * across) * square + held[0] + held[1])
        return cls(problem, model, tracking, contour, *held, inverse)

    def weighted(self, error: Array) -> Array:
        """Return Q e. Gamma is a projection: Gamma' Gamma = Gamma."""
        return self.tracking * error + (self.contour * self.problem.across(error) if self.contour else 0.0)

    def __matmul__(self, change: Array) -> Array:
        through = self.model.adjoint(self.weighted(self.model.forward(change)))
        return through + (self.on_input + self.on_change) * change

    def solved(self, right: Array, tolerance: float, iterations: int) -> Array:
        """Return d by preconditioned conjugate gradients, from zero, up to a residual of `tolerance` times the right-hand side."""
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
    # Not by the threads of a matrix library: these sums are short, and waiting for a second thread costs more than both do alone.
    return float((one * other).sum())
