"""Learning over a whole trial, with the turning normal: the operator that maps a table's deviation from its limit to the next trial's.

Its largest singular value bounds the growth of the error in one trial; its spectral radius decides convergence. Both are computed without
a matrix, by applying the trial and its transpose to tables.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from contourlab.analysis.learning.learning_frequency import LawKernels, law_kernels, law_model, lifted_problem
from contourlab.analysis.linear.coupled_loop import CoupledLoop
from contourlab.analysis.linear.trial_map import TrialMap
from contourlab.arrays import Array
from contourlab.components.learning.law import LearningLaw, TrialRecord
from contourlab.errors import ComponentError

WIDEST = 400
"""Longest kernel of a law [samples] that is exact at the ends of a trial; with a longer one the law sees zeros beyond the ends."""
TOLERANCE = 1e-4
TRIALS = 40
LONG = 4000
"""Entries of a table above which repeated trials give the radius better than Arnoldi's method."""


SHORT = 1000
"""Entries of a table up to which the whole matrix is formed for its singular values."""


@dataclass(frozen=True, eq=False)
class LiftedLearning:
    """Growth of the error from trial to trial on one path.

    Attributes
    ----------
    radius : float
        Spectral radius: below 1 learning converges.
    norm : float
        Largest singular value: below 1 every trial reduces any error; nan for a law that learns through a model, whose transpose is
        unknown.
    singular_values : ndarray (n,) or None
        In falling order; None for a table of more than `SHORT` entries.
    """

    radius: float
    norm: float
    singular_values: Array | None = None


class TrialOperator:
    """Map of a table's deviation u (n_sample, n_axis) from its limit to the deviation one trial later.

    Parameters
    ----------
    tangents : array_like (n_sample, n_axis)
        Direction of the path at each sample.
    """

    def __init__(self, loop: CoupledLoop, law: LearningLaw, tangents: ArrayLike) -> None:
        t = np.asarray(tangents, dtype=float)
        self.map, self.law, self.loop = TrialMap(loop, t, law.target), law, loop
        self.problem = lifted_problem(law, loop, t)
        self.shape = t.shape

    def __call__(self, u: Array) -> Array:
        """Return the deviation after a trial (n_sample, n_axis)."""
        error, feedback = self.map.forward(u)
        if self._reach is not None:
            return self._reach.forward(u, error, self.problem.across(error), feedback)
        record = TrialRecord(error, feedback, np.zeros(self.shape), self.problem.across(error))
        return np.asarray(self.law.update(u, record, self.problem))

    def transposed(self, v: Array) -> Array:
        """Return the transpose on v (n_sample, n_axis).

        Raises
        ------
        ComponentError
            If the law learns through a model.
        """
        if self._reach is None:
            raise ComponentError(f"learning {self.law.kind} learns through a model: its transpose is unknown")
        table, error, contour, feedback = self._reach.transposed(v)
        return table + self.map.transposed(error + self.problem.across(contour), feedback)

    @cached_property
    def _reach(self) -> _Banded | _Wide | None:
        if law_model(self.law, self.loop) is not None:
            return None
        kernels = law_kernels(self.law, self.loop)
        wide = max(-kernels.support[0], kernels.support[1]) > WIDEST
        return _Wide(kernels, self.shape[0]) if wide else _Banded(self.law, self.problem, kernels)

    def matrix(self) -> Array:
        """Return the operator as a matrix (n, n), n = n_sample n_axis: for short trials."""
        n = self.shape[0] * self.shape[1]
        return np.column_stack([self(unit.reshape(self.shape)).ravel() for unit in np.eye(n)])

    def norm(self, steps: int = 20) -> float:
        """Return the largest singular value by Golub and Kahan's bidiagonalisation: a close lower bound after some tens of steps."""
        u = np.random.default_rng(1).normal(size=self.shape)
        u = u / np.linalg.norm(u)
        # Orthogonalised against all earlier vectors, or the largest value repeats.
        lefts: list[Array] = []
        rights: list[Array] = [u]
        columns: list[tuple[float, float]] = []
        for _ in range(min(steps, u.size)):
            left = _apart(self(rights[-1]), lefts)
            alpha = float(np.linalg.norm(left))
            if alpha < 1e-14:
                break
            lefts.append(left / alpha)
            right = _apart(self.transposed(lefts[-1]), rights)
            beta = float(np.linalg.norm(right))
            columns.append((alpha, beta))
            if beta < 1e-14:
                break
            rights.append(right / beta)
        if not columns:
            return 0.0
        bidiagonal = np.diag([a for a, _ in columns]) + np.diag([b for _, b in columns[:-1]], 1)
        return float(np.linalg.norm(bidiagonal, 2))

    def radius(self) -> float:
        """Return the spectral radius: by Arnoldi's method for short trials, by repeated trials of a random table for long ones."""
        from scipy.sparse.linalg import ArpackNoConvergence, LinearOperator, eigs

        n = self.shape[0] * self.shape[1]
        start = np.random.default_rng(1).normal(size=n)
        if n > LONG:
            return self.growth(start.reshape(self.shape))
        operator = LinearOperator((n, n), matvec=self._flat(self), dtype=float)
        try:
            eigenvalues = eigs(operator, k=1, which="LM", v0=start, ncv=min(24, n), maxiter=12, tol=TOLERANCE, return_eigenvectors=False)
            return float(np.abs(eigenvalues).max())
        except ArpackNoConvergence:
            return self.growth(start.reshape(self.shape))

    def growth(self, start: Array, trials: int = TRIALS) -> float:
        """Return the mean growth factor per trial over the last third of `trials`."""
        u, sizes = start, []
        for _ in range(trials):
            u = self(u)
            sizes.append(float(np.linalg.norm(u)))
            if sizes[-1] == 0.0:
                return 0.0
            u = u / sizes[-1]
        return float(np.exp(np.mean(np.log(sizes[-trials // 3 :]))))

    def _flat(self, function: Callable[[Array], Array]) -> Callable[[Array], Array]:
        return lambda x: np.asarray(function(np.asarray(x, dtype=float).reshape(self.shape))).ravel()


def _apart(vector: Array, others: list[Array]) -> Array:
    """Return the part of a vector that is orthogonal to unit vectors."""
    for other in others:
        vector = vector - float(np.vdot(other, vector)) * other
    return vector


class _Banded:
    """A law as sparse matrices over the samples, exact at the ends; axes do not mix."""

    def __init__(self, law: LearningLaw, problem: Any, kernels: LawKernels) -> None:
        self.heard = [_band(law, problem, kernels, name) for name in kernels.kernels]

    def forward(self, *signals: Array) -> Array:
        return np.asarray(sum(matrix @ signal for matrix, signal in zip(self.heard, signals, strict=True) if matrix is not None))

    def transposed(self, v: Array) -> list[Array]:
        return [np.zeros_like(v) if matrix is None else np.asarray(matrix.T @ v) for matrix in self.heard]


def _band(law: LearningLaw, problem: Any, kernels: LawKernels, name: str) -> Any:
    """Return the matrix of one input of a law, from combs of impulses whose responses do not overlap; None for zero."""
    from scipy.sparse import coo_matrix

    if not kernels.kernels[name].any():
        return None
    n_sample, n_axis = problem.tangent.shape
    step = kernels.support[1] - kernels.support[0] + 1
    rows, columns, values = [], [], []
    for first in range(min(step, n_sample)):
        given = {heard: np.zeros((n_sample, n_axis)) for heard in kernels.kernels}
        given[name][first::step] = 1.0
        record = TrialRecord(given["tracking_error"], given["feedback_command"], np.zeros((n_sample, n_axis)), given["contour_error"])
        answer = law.update(given["table"], record, problem)[:, 0]
        row = np.arange(n_sample)
        # The impulse that reaches a sample lies within the support about it.
        column = first + step * np.ceil((row - kernels.support[1] - first) / step).astype(int)
        live = (answer != 0.0) & (column >= 0) & (column < n_sample)
        rows.append(row[live])
        columns.append(column[live])
        values.append(answer[live])
    return coo_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), shape=(n_sample, n_sample)).tocsr()


class _Wide:
    """A law with long kernels as convolutions, with zeros beyond the ends of a trial."""

    def __init__(self, kernels: LawKernels, n_sample: int) -> None:
        from scipy.fft import next_fast_len, rfft

        first, last = kernels.support
        self.n_sample, self.length = n_sample, int(next_fast_len(n_sample + last - first + 1, real=True))
        self.heard = []
        for kernel in kernels.kernels.values():
            ring = np.zeros(self.length)
            sample = np.arange(max(first, -n_sample), min(last, n_sample) + 1)
            ring[sample] = kernel[sample + kernels.centre, 0, 0]
            self.heard.append(rfft(ring) if ring.any() else None)

    def _through(self, signal: Array, response: Any) -> Array:
        from scipy.fft import irfft, rfft

        return np.asarray(irfft(rfft(signal, self.length, axis=0) * response[:, None], self.length, axis=0)[: self.n_sample])

    def forward(self, *signals: Array) -> Array:
        return np.asarray(sum(self._through(x, response) for response, x in zip(self.heard, signals, strict=True) if response is not None))

    def transposed(self, v: Array) -> list[Array]:
        return [np.zeros_like(v) if response is None else self._through(v, response.conj()) for response in self.heard]


def lifted_learning(loop: CoupledLoop, law: LearningLaw, tangents: ArrayLike) -> LiftedLearning:
    """Return the growth of errors from trial to trial on a path, with its turning normal.

    Parameters
    ----------
    tangents : array_like (n_sample, n_axis)
        Direction of the path at each sample; 30 000 samples take seconds.
    """
    operator = TrialOperator(loop, law, tangents)
    norm = math.nan if law_model(law, loop) is not None else operator.norm()
    short = operator.shape[0] * operator.shape[1] <= SHORT
    values = np.asarray(np.linalg.svd(operator.matrix(), compute_uv=False), dtype=float) if short else None
    return LiftedLearning(operator.radius(), norm, values)
